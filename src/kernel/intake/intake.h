#pragma once
#include "kernel/intake/received.h"
#include "kernel/log.h"
#include "kernel/state.h"
#include "radio/messages.h"

// First stage: everything that comes in, in the order in which it counts, up to the level in which it is judged.
namespace evc::kernel {

/// The odometer, the driver, telegrams and messages of this cycle, timers of stored data, and the level transition with
/// the release of the transition buffer. What is stored goes into `state`, answers to the RBC into `outbox`; of
/// `scratch` nothing is kept.
Received intake(State& state, Derived::Scratch& scratch, const Inputs& inputs, radio::Outbox& outbox, Log log);

}  // namespace evc::kernel
