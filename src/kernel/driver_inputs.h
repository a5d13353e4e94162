#pragma once
#include "driver/buttons.h"
#include "kernel/state.h"
#include "modes/levels.h"
#include "track/services.h"

namespace evc::kernel {

/// What decides which inputs of the driver are enabled now (4.7.2).
driver::ActionContext action_context(const State& state, const Inputs& inputs, const track::Here& here);

/// What decides on the buttons after the cycle in which `enabled` was put out. That an acknowledgement is asked for is
/// left to the display, on which it may not have arrived yet (015560 5.4); automatic driving has no button.
driver::ButtonContext button_context(const State& state, Set<DriverInput> enabled, const track::Here& here);

/// The levels that this unit can run in now (5.10.2.4).
modes::AvailableLevels available_levels(const State& state, const NationalSystem& national_system);

}  // namespace evc::kernel
