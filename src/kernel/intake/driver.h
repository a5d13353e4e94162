#pragma once
#include <optional>

#include "driver/driver.h"
#include "kernel/intake/reception.h"
#include "modes/levels.h"

namespace evc::kernel {

/// Entries, acknowledgements and selections of the driver in this cycle (4.7, 5.4). An action that is not enabled is
/// logged and has no effect.
void receive_driver(Reception& r);
/// Whether the driver may enter it now; an entry that is not enabled has no effect and is logged.
bool may_enter(Reception& r, driver::Input input, Entered entered);
/// What the driver sets on the display in this cycle: what is toggled on, the set speed, the language.
void set_display(Reception& r);
/// Train data changed by another source than the driver in this cycle: they wait for the procedure of 5.17. Data out of
/// their ranges are logged and never used: the driver has to enter others.
void receive_external_train_data(Reception& r);
/// The level selected by the driver in this cycle, if it may be selected (5.10.1.7).
std::optional<modes::OrderedLevel> driver_level(Reception& r);

}  // namespace evc::kernel
