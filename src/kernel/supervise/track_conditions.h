#pragma once
#include "kernel/state.h"
#include "track/services.h"

namespace evc::kernel {

/// How far the track conditions have come (5.18), in the cycles in which one of them can begin or is shown. Curves are
/// traced in the scratch memory of `derived`.
void advance_track_conditions(State& state, Derived& derived, const track::Here& here);

}  // namespace evc::kernel
