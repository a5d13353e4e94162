#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// Reaction of the unit when linking or radio contact fails.
enum class Reaction : std::uint8_t { trip, service_brake, none };

/// Code: Q_LINKREACTION (7.5.1.117) and M_NVCONTACT (7.5.1.74).
inline constexpr auto kReactionRows = std::to_array<terms::WireRow<Reaction>>({
    {Reaction::trip, 0, "train trip"},
    {Reaction::service_brake, 1, "service brake"},
    {Reaction::none, 2, "no reaction"},
});
static_assert(terms::in_order(kReactionRows));

/// The reaction of a code; none for the spare code 3.
constexpr std::optional<Reaction> reaction_of(std::uint64_t code) {
  return terms::of_code<Reaction, kReactionRows>(code);
}

/// Whether `a` stops the train sooner than `b`.
constexpr bool stronger(Reaction a, Reaction b) { return a < b; }

}  // namespace evc
