#pragma once
#include "kernel/port.h"

// The kernel as its own rooms see it; for hosts State and Derived are hidden in a Unit (openevc/evc.h).
namespace evc::kernel {

struct State;
struct Derived;

/// Puts the unit into its state after power-up: mode SB is entered from NP in the first cycle (4.6.3 [4]). With train
/// data or national values that `train::check` refuses it goes to SF then ([13]).
void power_up(State& state, Derived& derived, const Config& config) noexcept;

/// One cycle. Total, deterministic, allocation-free; equal (state, inputs) give equal results. Times, places and speeds
/// that are not numbers, out of all range (10^9 s or m, 1000 m/s), not between their bounds or before the last cycle's
/// lead to SF (4.4.5).
void step(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs) noexcept;

}  // namespace evc::kernel
