// Any description of brake units is rejected with its place, or gives units whose variables have values.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "deceleration/spec.h"

namespace {

/// Values of it at both ends, without and with a tilt, are in its range.
void require_values(const evc::deceleration::Distribution& variable) {
  const auto [from, to] = variable.range();
  for (const double theta : {-50.0, 0.0, 50.0}) {
    if (!std::isfinite(variable.log_transform(theta))) continue;
    const auto tilted = variable.tilted(theta);
    for (const double share : {1e-16, 0.25, 0.5, 1.0 - 1e-16}) {
      const double value = tilted.at(share);
      if (!std::isfinite(value) || value < from || value > to) std::abort();
    }
  }
  if (!std::isfinite(variable.mean())) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto spec = evc::deceleration::read_spec(text, "fuzz.json");
  if (!spec && spec.error().text().find("fuzz.json") == std::string::npos) std::abort();
  if (!spec) return 0;
  if (spec->units() == 0 || spec->units() > evc::deceleration::kMostUnits || spec->speeds_kmh.front() != 0.0)
    std::abort();
  for (const auto& group : spec->groups) {
    require_values(group.friction);
    require_values(group.pressure);
    if (group.response_s) require_values(*group.response_s);
  }
  require_values(spec->all_units);
  return 0;
}
