#pragma once
#include "kernel/decide/decided.h"
#include "kernel/intake/received.h"
#include "kernel/log.h"
#include "kernel/state.h"

// Second stage: the procedures of chapter 5 and the mode transition (4.6) with its consequences (4.10).
namespace evc::kernel {

Decided decide(State& state, const Inputs& inputs, const Received& received, Log log);

}  // namespace evc::kernel
