#pragma once
#include "kernel/evc.h"
#include "kernel/state.h"
#include "procedures/observe.h"

namespace evc::kernel {

/// What a cycle decided on. Not part of State because no cycle needs that of another.
struct Examined {
  procedures::Facts facts;  ///< of 4.6.3
  State deciding;           ///< with the inputs of the cycle, before the mode changed: a change deletes what led to it
};

/// One cycle as `step`, and what it decided on: to explain a journey afterwards.
void examine(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs, Examined& seen) noexcept;

}  // namespace evc::kernel
