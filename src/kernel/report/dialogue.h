#pragma once
#include <optional>

#include "kernel/port.h"
#include "terms/requests.h"

namespace evc::kernel {

struct State;

/// What a procedure of chapter 5 waits for with an open desk; `asked`: the acknowledgements that the driver is asked
/// for.
std::optional<ShownDialogue> dialogue_of(const State& s, bool desk_open, Set<Ack> asked);

}  // namespace evc::kernel
