#pragma once
#include "kernel/log.h"
#include "kernel/state.h"
#include "track/services.h"

// The handover between two RBCs (3.15.1, 5.15): from the stored order to sessions and reports.
namespace evc::kernel {

/// Before the reports of the cycle: a new order, the border. Returns whether a position report is due.
bool run_handover(State& state, const track::Here& here, radio::Outbox& outbox, Log log);

/// After them: the accepting RBC supervises from the next cycle on if it got a report from beyond the border.
void complete_handover(State& state, const radio::Result& radio, Log log);

/// The session whose connection is indicated to the driver (3.5.7.6).
const radio::Session& indicated_session(const State& state);

}  // namespace evc::kernel
