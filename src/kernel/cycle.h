#pragma once
#include <cstdint>
#include <optional>

#include "kernel/state.h"
#include "procedures/observe.h"
#include "radio/messages.h"
#include "track/services.h"
#include "track/withdraw.h"

// What the parts of one cycle hand to each other. Nothing of it outlives the cycle.
namespace evc::kernel {

/// One cycle: the state it works on, and the facts, wishes and messages it gathers.
struct Cycle {
  Cycle(State& s, Derived& d, const Inputs& i, Outputs& o) : state(s), derived(d), in(i), out(o) {}
  State& state;
  Derived& derived;
  const Inputs& in;
  Outputs& out;

  DriverActions driver;         // of the selections those that are enabled (4.7.2)
  track::Here here;             // the train in the track frame, after relocation
  procedures::Facts facts;      // for the conditions of 4.6.3
  procedures::Effects effects;  // what the procedures want
  brakes::CauseSet asked;       // brakes asked for
  radio::Outbox outbox;
  position::ReportEvents report_events;
  std::uint8_t ma_request_reasons = 0;

  std::optional<procedures::level_transition::Order> order;  // the last level transition order accepted
  std::optional<Level> switching_to;                         // it will be executed in this cycle
  // Events of this cycle for the procedures.
  bool SR_authorised = false;
  bool position_confirmed = false, train_accepted = false, train_rejected = false;
  bool train_data_acknowledged = false;
  bool exit_from_trip = false;
  bool SH_authorised = false, SH_refused = false;
  bool termination_ordered = false;
  bool balise_proceed = false, ma_from_rbc = false;
  bool new_radio_message = false;
  bool train_data_entered = false;
  bool level_changed_by_driver = false;
  std::optional<Mode> profile_at_front;  // of the area in which the max safe front end is
  std::optional<std::uint32_t> NID_LTRBG;
  bool reversing_possible = false;
  bool taf_granted = false;  // message 149 is due
  track::TextDisplay texts;
  bool MA_request_before_perturbation = false;
};

/// Adds an event; when there is no room the last one says so.
void note(Cycle& cycle, const Event& event);

/// The train in the track frame now.
track::Here here(const State& state);

/// How fast the train runs, whichever way. `V_ura`: by how much it may be faster (3.13.9.3.2.1). `A` grows the speed.
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

}  // namespace evc::kernel
