#pragma once
#include "kernel/intake/reception.h"

namespace evc::kernel {

/// Processes the balise telegrams of this cycle to groups, linking and position, and the information of complete groups
/// (3.4, 3.16.2).
void receive_balises(Reception& r);

}  // namespace evc::kernel
