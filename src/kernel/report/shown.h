#pragma once
#include "kernel/state.h"
#include "kernel/supervise/supervised.h"

namespace evc::kernel {

/// What the driver interface shows of the outputs of this cycle (4.7.2), from all others.
void show_by_mode(const State& state, bool desk_open, const Supervised& supervised, Outputs& out);

}  // namespace evc::kernel
