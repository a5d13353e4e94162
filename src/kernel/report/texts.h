#pragma once
#include "kernel/decide/decided.h"
#include "kernel/intake/received.h"
#include "kernel/port.h"
#include "kernel/state.h"

namespace evc::kernel {

/// The texts of the trackside, the status texts and the trip reason. `inform`: what happened in this cycle. The causes
/// of the brake commands are in `out` already.
void show_texts(State& state, bool desk_open, const Received& received, const Decided& decided, Set<Inform> inform,
                Outputs& out);

/// Inputs and levels that are enabled, geographical position, reversing distance, sessions. What the procedures offer
/// is in the state already.
void show_enabled(const State& state, const Inputs& inputs, const track::Here& here, Outputs& out);

}  // namespace evc::kernel
