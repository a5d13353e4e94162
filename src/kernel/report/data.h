#pragma once
#include "kernel/state.h"
#include "track/services.h"

namespace evc::kernel {

/// The data view (3.18.6): what the unit has stored, each with its status.
void show_data(const State& state, const track::Here& here, Outputs& out);

/// Date and time since the last reading of the clock, which this cycle may bring (3.18.5).
void show_clock(State& state, const std::optional<std::int64_t>& reading, Outputs& out);

}  // namespace evc::kernel
