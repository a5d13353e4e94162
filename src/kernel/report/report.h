#pragma once
#include "kernel/decide/decided.h"
#include "kernel/intake/received.h"
#include "kernel/log.h"
#include "kernel/state.h"
#include "kernel/supervise/supervised.h"
#include "radio/messages.h"

// Last stage: what leaves the unit: messages, brake commands, what the driver is shown.
namespace evc::kernel {

/// The outputs of a cycle before anything happened in it, whatever they held.
void reset(Outputs& out);

/// The radio with its own supervision (3.5, 3.6.5, 3.8.2, 3.16.3.4), all causes of this cycle into brake commands
/// (3.14.1), and the display (4.7). `outbox` holds the answers to the messages of this cycle.
void report(State& state, const Inputs& inputs, const Received& received, const Decided& decided,
            const Supervised& supervised, radio::Outbox& outbox, Log log, Outputs& out);

}  // namespace evc::kernel
