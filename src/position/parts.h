#pragma once
#include <cstddef>
#include <optional>

#include "position/position.h"

// What the files of this room share.
namespace evc::position {

constexpr Distance magnitude(Distance d) { return d.si < 0 ? -d : d; }
constexpr Distance at_least_zero(Distance d) { return d.si > 0 ? d : Distance{0}; }

/// The place of the counter in the track frame.
inline Place in_track(const State& state, OdometerPlace counter) {
  return Place{state.sense * counter.from_origin + state.offset};
}
/// What the position refers to now: the LRBG, without one the last unlinked group, without one the moment of power-up.
Reference reference_of(const State& state);
/// The counters of a restored position begin at the first reading.
void count_from(State& state, const OdometerReading& first);
/// The front end when the counters stood at `counter`, with the interval of `reference`.
PlaceInterval interval(const State& state, const Reference& reference, const OdometerReading& counter);
/// The remembered LRBG of that identity.
std::optional<std::size_t> index_of(const State& state, GroupId id);

}  // namespace evc::position
