#pragma once
#include "kernel/log.h"
#include "kernel/state.h"
#include "radio/messages.h"

namespace evc::kernel {

/// The messages of the outbox as bits.
void compose_messages(State& state, const NationalSystem& national, const radio::Outbox& outbox, Log log, Outputs& out);

}  // namespace evc::kernel
