#pragma once
#include <cstdint>
#include <optional>

#include "kernel/state.h"

namespace evc::kernel {

/// 3.5.6: the network with which the free mobile terminals have to register now: at power-up, for another network of
/// trackside or driver, and when the connection of a terminal ends that was in use then (3.5.6.6). After the sessions
/// of the cycle.
std::optional<std::uint32_t> register_terminals(State& state, bool powered_up);

/// 3.5.6.6, 3.15.1.3.2: the call of this cycle waits if the only terminal for it has to register first; `ordered`: in
/// this cycle.
void await_registration(State& state, bool ordered, radio::Outbox& outbox);

}  // namespace evc::kernel
