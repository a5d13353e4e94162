#pragma once
#include "kernel/log.h"
#include "kernel/state.h"
#include "track/services.h"

namespace evc::kernel {

/// Enters `to` because of condition `number` of 4.6.3: deletes and invalidates data by 4.10, calls the procedures.
void enter_mode(State& state, Mode to, int number, const track::Here& here, Log log);

/// The desk is closed in start of mission: deletes, resets and invalidates data by A.3.4 k.
void end_start_of_mission(State& state, const track::Here& here);

}  // namespace evc::kernel
