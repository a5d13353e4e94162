#pragma once
#include "kernel/evc.h"
#include "procedures/observe.h"

namespace evc::kernel {

/// One cycle as `step`, and the facts of 4.6.3 that it decided on: to explain a journey afterwards. They are not part
/// of State because no cycle needs those of another.
procedures::Facts examine(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs) noexcept;

}  // namespace evc::kernel
