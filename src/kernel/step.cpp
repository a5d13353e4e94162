#include "kernel/conclude.h"
#include "kernel/evc.h"
#include "kernel/observe.h"
#include "kernel/orders.h"
#include "kernel/receive.h"
#include "kernel/supervise.h"
#include "track/services.h"
#include "track/withdraw.h"
#include "train/brake_model.h"

namespace evc::kernel {
namespace {

position::Odometry odometry_of(const Odometry& in) {
  return {{in.nominal, in.min, in.max}, in.V_est, in.V_min, in.V_max, in.A_est};
}

/// Beyond these no train is: 30 years, a million kilometres, 1000 m/s. Not a number is never within.
constexpr double kLongest = 1e9;
constexpr double kFastest = 1e3;
bool within(double v, double limit) { return v >= -limit && v <= limit; }

/// Whether the cycle's time and places can be worked with: within bounds, in order, no way back in time.
bool sound(const State& s, const Inputs& in) {
  const Odometry& o = in.odometry;
  for (const BaliseTelegram& t : in.balise_telegrams)
    if (!within(t.at.from_origin.si, kLongest)) return false;
  return in.now >= s.now && within(in.now.si, kLongest) && within(o.min.from_origin.si, kLongest) &&
         within(o.max.from_origin.si, kLongest) && o.min <= o.nominal && o.nominal <= o.max &&
         within(o.V_min.si, kFastest) && within(o.V_max.si, kFastest) && o.V_min <= o.V_est && o.V_est <= o.V_max &&
         within(o.A_est.si, kFastest);
}

/// Timers of the authority, data whose function is over, and what a reaction shortens once the train stands
/// (3.8.4, A.3.4, A.3.6).
void advance_track(Cycle& cycle) {
  State& s = cycle.state;
  const track::Elapsed elapsed = track::advance(s.track, cycle.here);
  if (elapsed.any()) {
    note(cycle, {.what = What::authority_timer_elapsed, .clause = "3.8.4"_srs});
    const bool authority = s.track.ma && !s.track.ma->sections.empty();
    cut_other(s, authority ? s.track.ma->far_end() : cycle.here.max_safe_front);
  }
  if (elapsed.track_description_deleted) s.track_description_deleted = true;
  if (s.shorten_at_standstill && cycle.here.standstill) {
    s.shorten_at_standstill = false;
    if (track::shorten(s.track, track::Situation::h_linking_reaction, cycle.here.max_safe_front, cycle.here))
      s.track_description_deleted = true;
    cut_other(s, cycle.here.max_safe_front);
    note(cycle, {.what = What::track_description_shortened, .clause = "A.3.4"_srs});
  }
  if (cycle.facts.ma_accepted) s.track_description_deleted = false;
}

void run_texts(Cycle& cycle) {
  State& s = cycle.state;
  std::uint8_t acknowledged = 0;
  if (cycle.facts.acknowledged.has(Ack::text) && !s.texts_to_acknowledge.empty())
    acknowledged = s.texts_to_acknowledge[0];
  InplaceVector<std::uint8_t, 6> reports;
  cycle.texts = track::show_texts(s.track, cycle.here, s.mode, s.level.level, s.level.nid_ntc, acknowledged, reports);
  s.texts_to_acknowledge = cycle.texts.to_acknowledge;
  cycle.effects.requests.add(Ack::text, !cycle.texts.to_acknowledge.empty());
  cycle.asked.add(brakes::Cause::text_service, cycle.texts.service_brake);
  cycle.asked.add(brakes::Cause::text_emergency, cycle.texts.emergency_brake);
  for (const std::uint8_t id : reports) radio::report_text_acknowledged(id, cycle.outbox);
}

void ask_track_ahead_free(Cycle& cycle) {
  State& s = cycle.state;
  const bool confirmed = cycle.driver.has(Select::track_ahead_free);
  cycle.taf_granted = protection::ask(s.track_ahead_free, cycle.here.est_front, confirmed).granted;
}

}  // namespace

void power_up(State& state, Derived& derived, const Config& config) noexcept {
  state = State{};
  derived.built = 0;
  state.cycle = config.cycle;
  state.srs = config.srs;
  state.fitted_levels = config.levels;
  state.train = config.train;
  state.national_values = config.national_values;
  state.configuration_refused =
      train::check(config.train) != train::Fault::none || train::check(config.national_values) != train::Fault::none;
}

/// One cycle: the picture of docs/architecture.md, from top to bottom.
void step(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs) noexcept {
  begin(outputs);
  Cycle cycle(state, derived, inputs, outputs);
  // 4.4.5: without a sound odometer or configuration nothing can be supervised. The last place stays.
  const bool can_go_on = sound(state, inputs);
  if (!can_go_on) note(cycle, {.what = What::odometry_not_sound, .clause = "4.4.5"_srs});
  cycle.facts.safety_fault = !can_go_on || state.configuration_refused;
  if (can_go_on) {
    state.now = inputs.now;
    position::update(state.position, odometry_of(inputs.odometry), inputs.now);
  }
  cycle.here = here(state);
  take_driver_actions(cycle);

  receive_balises(cycle);
  receive_loops(cycle);
  receive_radio(cycle);
  cycle.here = here(state);
  advance_track(cycle);

  run_procedures(cycle);
  change_mode(cycle);
  run_procedures_after(cycle);

  refresh(cycle);
  supervise_speed(cycle);
  guard_movement(cycle);
  run_texts(cycle);
  ask_track_ahead_free(cycle);

  run_radio(cycle);
  command_brakes(cycle);
  show(cycle);
}

}  // namespace evc::kernel
