#pragma once
#include "kernel/intake/evaluation.h"
#include "lang/telegram.h"

namespace evc::kernel {

/// Carries out the information of a radio message itself (not its packets). The clause when it is refused, none when it
/// is not.
Clause take_message(Evaluation& e, const lang::MessageToTrainView& message);

}  // namespace evc::kernel
