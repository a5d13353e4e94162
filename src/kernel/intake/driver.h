#pragma once
#include <optional>

#include "kernel/intake/reception.h"
#include "modes/levels.h"

namespace evc::kernel {

/// What the driver entered, acknowledged and selected in this cycle (4.7, 5.4). What is not enabled is logged and has
/// no effect.
void receive_driver(Reception& r);
/// The level that the driver chose in this cycle, where it may be chosen (5.10.1.7).
std::optional<modes::OrderedLevel> driver_level(Reception& r);

}  // namespace evc::kernel
