#pragma once
#include "kernel/state.h"
#include "track/services.h"

// The position and speed of the train, for the stages.
namespace evc::kernel {

/// The length behind the front end: that of the engine where no train data count, in SH, SL, NL, PS and before their
/// entry (4.4.6.1.4, 4.4.7.1.6, 4.4.8.1.3, 4.4.15.1.3, 4.4.20.1.4).
Distance length_of(const State& state);
/// From the front end of the active cab back to the antenna: the train data count from cab A, from cab B it is the rest
/// of the engine. Below 0 in a supervised manoeuvre whose train orientation is opposite to the cab: the antenna is
/// ahead of that end.
inline Distance L_antenna(const State& state) {
  const Distance from_A = state.train.L_antenna_front;
  const Distance from_B = from_A < state.L_engine ? state.L_engine - from_A : Distance{};
  const Distance from_cab = state.cab == Cab::A ? from_A : from_B;
  return state.manoeuvre.opposite ? -from_cab : from_cab;
}
/// From the front end of the train back to the antenna.
inline Distance L_antenna_of_train(const State& state) { return state.position.ahead.est + L_antenna(state); }
/// The train in the track frame now.
track::Here here(const State& state);

/// The speed of the train in either direction. `V_ura`: speed under-reading amount (3.13.9.3.2.1). A positive `A`
/// increases the speed.
struct Run {
  Speed V{}, V_ura{};
  Acceleration A{};
};
constexpr Run run_of(const position::Odometry& now) {
  const bool backward = now.V_est < Speed{};
  const Speed V = backward ? -now.V_est : now.V_est;
  const Speed most = -now.V_min > now.V_max ? -now.V_min : now.V_max;
  return {V, most - V, backward ? -now.A_est : now.A_est};
}

constexpr bool valid(DataStatus status) { return status == DataStatus::valid; }
/// What was valid is to be validated again; what was unknown stays so.
constexpr void invalidate(DataStatus& status) {
  if (valid(status)) status = DataStatus::invalid;
}

}  // namespace evc::kernel
