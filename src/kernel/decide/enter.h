#pragma once
#include "kernel/log.h"
#include "kernel/state.h"
#include "track/services.h"

namespace evc::kernel {

/// Enters `to` because of condition `number` of 4.6.3: deletes and invalidates data by 4.10, calls the procedures.
void enter_mode(State& state, Mode to, int number, const track::Here& here, Log log);

}  // namespace evc::kernel
