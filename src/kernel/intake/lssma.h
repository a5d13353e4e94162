#pragma once
#include "kernel/intake/evaluation.h"

namespace evc::kernel {

/// Whether the train is in an LS area of the mode profile that comes along (4.8.4 [9], [10]): up to 3.6.0 the max safe
/// front end.
bool front_in_LS_area(Evaluation& e);

}  // namespace evc::kernel
