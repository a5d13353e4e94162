#pragma once
#include <cstdint>
#include <optional>

#include "kernel/state.h"

// Date and time (3.18.5): seconds since 1970 (UTC).
namespace evc::kernel {

/// Years that have four digits.
constexpr bool is_date(std::int64_t utc) { return utc >= 0 && utc < 253402300800; }

/// The reading of this cycle; one that is no date is none. With the first one since power-up the time without power
/// counts for the virtual balise covers that were kept (3.15.9.5).
void read_clock(State& state, const std::optional<std::int64_t>& reading);

/// The date of now: the last reading and the time since then. None before the first one.
std::optional<std::int64_t> date(const State& state);

/// As of when the rest of the validity period of this cover is known: now, or, as long as the time without power is not
/// counted, the time of power off and what the unit itself counted since power-up.
std::optional<std::int64_t> date_of(const State& state, const balise::Cover& cover);

}  // namespace evc::kernel
