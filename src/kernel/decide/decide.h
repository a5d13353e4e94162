#pragma once
#include "kernel/decide/decided.h"
#include "kernel/intake/received.h"
#include "kernel/log.h"
#include "kernel/state.h"

// Second stage: the procedures of chapter 5 and the mode transition (4.6) with its consequences (4.10).
namespace evc::kernel {

struct Examined;

/// The procedures and the mode transition. Written in `state` are: the procedures of chapter 5 with the mission and the
/// override, mode and level, and what 4.9, 4.10 and 4.11 make of stored information on their change.
/// `seen`: what decided the transition, for an explanation; null: nobody asks.
Decided decide(State& state, const Inputs& inputs, const Received& received, Log log, Examined* seen = nullptr);

}  // namespace evc::kernel
