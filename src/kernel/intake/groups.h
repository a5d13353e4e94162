#pragma once
#include "kernel/intake/reception.h"

namespace evc::kernel {

/// The balise telegrams of this cycle into groups, linking and position, and the information of the groups that are
/// complete (3.4, 3.16.2).
void receive_balises(Reception& r);
/// Loop messages: the unit takes none of their information yet, and says so.
void receive_loops(Reception& r);

}  // namespace evc::kernel
