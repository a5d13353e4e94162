#pragma once
#include "kernel/cycle.h"
#include "modes/mode_table.h"

// From the state of all rooms to the conditions of 4.6.3, and into the next mode.
namespace evc::kernel {

/// What the driver entered, acknowledged and selected in this cycle (4.7, 5.4).
void take_driver_actions(Cycle& cycle);
/// The procedures of chapter 5 that run before the mode transition; level transitions with the release of the
/// transition buffer.
void run_procedures(Cycle& cycle);
/// All facts of 4.6.3, then the mode transition if any with everything that 4.10 asks for.
void change_mode(Cycle& cycle);
/// The procedures that run after it: train trip, end of mission.
void run_procedures_after(Cycle& cycle);

}  // namespace evc::kernel
