#pragma once
#include "kernel/decide/decided.h"
#include "kernel/intake/received.h"
#include "kernel/log.h"
#include "kernel/state.h"
#include "kernel/supervise/supervised.h"
#include "radio/messages.h"

// Last stage: the outputs of the unit: messages, brake commands, the display.
namespace evc::kernel {

/// Resets the outputs at the start of a cycle, with any previous content.
void reset(Outputs& out);

/// Radio with its supervision (3.5, 3.6.5, 3.8.2, 3.16.3.4), brake commands from all causes of this cycle (3.14.1), and
/// the display (4.7). `outbox` holds the answers to the messages of this cycle. Written in `state` are: the radio with
/// its reports, its contact and the wish for one, handover and the procedure of leaving an RBC, brakes, status texts,
/// what the driver may answer next; with the border of a handover the RBC transition, the buffered information and the
/// inhibition of revocable restrictions (3.15.1), and with the loss of radio contact the track description (A.3.4 i).
void report(State& state, const Inputs& inputs, const Received& received, const Decided& decided,
            const Supervised& supervised, radio::Outbox& outbox, Log log, Outputs& out);

}  // namespace evc::kernel
