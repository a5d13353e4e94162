#pragma once
#include "kernel/port.h"
#include "kernel/state.h"

namespace evc::kernel {

/// The acknowledgements that the driver is asked for, in the order of their arrival (015560 5.4): `requests` of this
/// cycle, a text by its id. The texts are in `out` already.
void queue_acknowledgements(State& state, Set<Ack> requests, const Outputs& out);

}  // namespace evc::kernel
