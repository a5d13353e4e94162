#pragma once
#include "kernel/intake/reception.h"

namespace evc::kernel {

/// The radio messages of this cycle (3.16.3).
void receive_radio(Reception& r);

}  // namespace evc::kernel
