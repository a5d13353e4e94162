#pragma once
#include "kernel/port.h"

// The kernel for use inside the project; for hosts State and Derived are hidden in a Unit (openevc/evc.h).
namespace evc::kernel {

struct State;
struct Derived;

/// Puts the unit into its state after power-up: mode SB is entered from NP in the first cycle (4.6.3 [4]). If
/// `train::check` rejects the train data or national values, it enters SF instead ([13]).
void power_up(State& state, Derived& derived, const Config& config) noexcept;

/// The same with what the unit kept without power: it replaces the national values of the configuration, and `moved` of
/// the inputs decides on position, level and RBC contact (4.11). False: no unit gives such data; they are not used, as
/// after their loss (3.18.2.5).
[[nodiscard]] bool power_up(State& state, Derived& derived, const Config& config, const Retained& retained) noexcept;
/// What is kept when the power goes off now, or went off before.
Retained retained(const State& state) noexcept;

/// One cycle. Total, deterministic, allocation-free; equal (state, inputs) give equal results. Times, places and speeds
/// that are not numbers, beyond 10^9 s, 10^9 m or 1000 m/s, outside their bounds, or earlier than in the last cycle
/// lead to SF (4.4.5).
void step(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs) noexcept;

/// The advance display (3.15.10) after the last step. False where there is none.
[[nodiscard]] bool plan(const State& state, const Derived& derived, Planning& planning) noexcept;

/// The record of the display (015560) after the last step, whose outputs are `outputs`: what the mode shows (4.7.2),
/// whether the driver has toggled it on or not. With a closed desk nothing is shown but the system failure and the
/// isolation: the record then is of mode NP. Of `display.config` the edition, the dial, the names of national systems,
/// the radio systems and T_dispTTI are written; the rest is the host's.
void show(const State& state, const Derived& derived, const Outputs& outputs, Display& display) noexcept;

}  // namespace evc::kernel
