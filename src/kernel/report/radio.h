#pragma once
#include "kernel/decide/decided.h"
#include "kernel/intake/received.h"
#include "kernel/log.h"
#include "kernel/state.h"
#include "radio/messages.h"

namespace evc::kernel {

/// The results of radio for brakes and driver in this cycle.
struct RadioResult {
  procedures::Effects effects;
  brakes::CauseSet asked;
  std::optional<std::uint32_t> network;  ///< with which terminals have to register (3.5.6)
};

/// Sessions, handover, MA requests and position reports (3.5, 3.15.1, 3.6.5, 3.8.2, 3.16.3.4). Of the inputs only the
/// report of the bearer is used. `request_before_perturbation`: the
/// perturbation location minus T_MAR is passed (3.13.11.8).
RadioResult run_radio(State& state, const Inputs& inputs, const Received& received, const Decided& decided,
                      bool request_before_perturbation, radio::Outbox& outbox, Log log);

}  // namespace evc::kernel
