#pragma once
#include "kernel/port.h"
#include "kernel/state.h"
#include "track/services.h"

namespace evc::kernel {

/// Track conditions for the driver (5.18), while a desk is open, and for the train (5.20), in the modes of 4.7.2 and
/// 4.5.2. Those for the driver get their numbers (track::Progress::shown_as).
void show_track_conditions(State& state, bool desk_open, const track::Here& here, Outputs& out);

}  // namespace evc::kernel
