#include "sim/networks.h"

namespace evc::sim {
namespace {

constexpr std::int64_t kRegistration_ms = 4000;  // from the order on; 40 s are allowed (SUBSET-026-3 A.3.1 of 4.0.0)

}  // namespace

void Terminals::hear(const port::Outputs& outputs, std::int64_t t_ms) {
  if (!outputs.radio_register) return;
  // The terminals' own default finds the network that is there.
  const bool there = *outputs.radio_register == port::kDefaultNetwork || outputs.radio_register == along_line_;
  since_ms_.reset();
  if (there) since_ms_ = t_ms + kRegistration_ms;
}

}  // namespace evc::sim
