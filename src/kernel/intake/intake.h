#pragma once
#include "kernel/intake/received.h"
#include "kernel/log.h"
#include "kernel/state.h"
#include "radio/messages.h"

// First stage: all inputs, in the order in which they take effect, and the level in which they are evaluated.
namespace evc::kernel {

/// The odometer, the driver, telegrams and messages of this cycle, timers of stored data, and the level transition with
/// the release of the transition buffer. Data are stored in `state`, answers to the RBC in `outbox`; nothing is kept in
/// `scratch`. `forwarded`: data of packet 44.
Received intake(State& state, Derived::Scratch& scratch, const Inputs& inputs, radio::Outbox& outbox, Log log,
                Forwarded* forwarded = nullptr);

}  // namespace evc::kernel
