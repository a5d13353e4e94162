#pragma once
#include "kernel/state.h"
#include "track/services.h"

namespace evc::kernel {

/// The data view (3.18.6): what the unit has stored, each with its status.
void show_data(const State& state, const track::Here& here, Outputs& out);

/// Date and time by the last reading of the clock (3.18.5).
void show_clock(const State& state, Outputs& out);

}  // namespace evc::kernel
