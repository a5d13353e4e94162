#pragma once
#include <optional>

#include "kernel/intake/received.h"
#include "kernel/log.h"
#include "kernel/state.h"
#include "procedures/level_transition.h"
#include "radio/messages.h"

namespace evc::kernel {

/// The data of the first stage; valid only during the stage.
struct Reception {
  State& state;
  Derived::Scratch& scratch;
  const Inputs& in;
  radio::Outbox& outbox;  ///< answers to the RBC
  Log log;
  Received& out;
  /// The last level transition order accepted, as it was judged (5.10.1.6).
  std::optional<procedures::level_transition::JudgedOrder> order;
  /// An announcement after an order that is executed: it counts from the level that this one leads to.
  std::optional<procedures::level_transition::Order> announcement = {};
  Forwarded* forwarded = nullptr;  ///< data of packet 44; none: nobody takes them
};

}  // namespace evc::kernel
