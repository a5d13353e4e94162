#pragma once
#include "kernel/intake/evaluation.h"

namespace evc::kernel {

/// The movement authority of the part is judged last: whether SSP and gradient cover it shows only then (4.8.3 [4]).
void evaluate_authority(Evaluation& e);
/// Stores what was accepted with the track description (3.7), with what follows from it.
void store_contents(Evaluation& e);

}  // namespace evc::kernel
