#pragma once
#include "kernel/intake/evaluation.h"
#include "lang/telegram.h"

namespace evc::kernel {

/// Executes the information of a radio message itself (not its packets). Returns the clause of a refusal, none
/// otherwise.
Clause take_message(Evaluation& e, const lang::MessageToTrainView& message);

}  // namespace evc::kernel
