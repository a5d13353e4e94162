#pragma once
#include "kernel/cycle.h"
#include "modes/stored_information.h"

// Entry to modes and levels (4.9, 4.10).
namespace evc::kernel {

/// Enters `to` because of condition `number` of 4.6.3: deletes and invalidates what 4.10 says, calls the procedures.
void enter_mode(Cycle& cycle, Mode to, int number);
/// The level changes: 4.9 and the release of the transition buffer are the caller's next steps.
void enter_level(Cycle& cycle, const modes::OrderedLevel& to, bool by_driver);
/// The desk is closed while start of mission goes on (A.3.4 k).
void close_desk_in_start_of_mission(Cycle& cycle);

}  // namespace evc::kernel
