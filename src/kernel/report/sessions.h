#pragma once
#include "kernel/decide/decided.h"
#include "kernel/intake/received.h"
#include "kernel/state.h"

// When the unit itself establishes and ends sessions (3.5.3.4, 3.5.3.8, 3.5.5.1 b); the orders of the trackside are
// executed when they are received.
namespace evc::kernel {

/// Whether a change of mode in this cycle is reported to the RBC (3.6.5.1.4 b, 4.5.2).
bool reports_mode(const State& state, const Decided& decided);

/// Whether errors are reported in this mode: by 4.5.2 of 3.6.0 in 3.4.0 too; in SF the one of the odometer that led to
/// it (3.16.4.2 of 4.0.0).
bool reports_errors(const State& state);

/// The sessions that the procedures, a change of mode or level or the driver require, and set-ups that end (3.5.3.8).
/// Adds to `effects` the request to the driver for the contact of an RBC.
void order_sessions(State& state, const Received& received, const Decided& decided, procedures::Effects& effects,
                    radio::Outbox& outbox);

/// 3.18.4.3.4, 5.4.3.3: with the session established its RBC is the stored contact, and valid.
void note_contact(State& state);

/// 4.4.4: without power there is no session, and nothing is sent.
void end_without_power(State& state, radio::Outbox& outbox);

}  // namespace evc::kernel
