#pragma once
#include "kernel/intake/evaluation.h"

namespace evc::kernel {

/// The movement authority of the part is judged last: only then is it known whether SSP and gradient cover it (4.8.3
/// [4]).
void evaluate_authority(Evaluation& e);
/// Stores accepted data in the track description (3.7), with the consequences.
void store_contents(Evaluation& e);

}  // namespace evc::kernel
