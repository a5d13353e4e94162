#pragma once
#include "port/config.h"
#include "port/event.h"
#include "port/inputs.h"
#include "port/outputs.h"

// The whole outside of the kernel. Nothing else goes in or out: no clock, no file, no thread, no
// random number.
namespace evc::kernel {

using port::BaliseTelegram;
using port::Config;
using port::DirectionController;
using port::DriverActions;
using port::Entered;
using port::Event;
using port::Inputs;
using port::LoopMessage;
using port::NationalSystem;
using port::NidLrbg;
using port::Odometry;
using port::OutgoingMessage;
using port::Outputs;
using port::RadioMessage;
using port::RbcAddress;
using port::Select;
using port::ShownText;
using port::TrainSignals;

struct State;
struct Derived;

/// Puts the unit into its state after power-up: mode SB is entered from NP in the first cycle (4.6.3 [4]). With train
/// data or national values that `train::check` refuses it goes to SF then ([13]).
void power_up(State& state, Derived& derived, const Config& config) noexcept;

/// One cycle. Total, deterministic, allocation-free; equal (state, inputs) give equal results. Times, places and speeds
/// that are not numbers, out of all range (10^9 s or m, 1000 m/s), not between their bounds or before the last cycle's
/// lead to SF (4.4.5).
void step(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs) noexcept;

}  // namespace evc::kernel
