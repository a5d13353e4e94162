#include "kernel/supervise/supervise.h"

#include "kernel/basis.h"
#include "kernel/curves.h"
#include "kernel/here.h"
#include "kernel/supervise/track_conditions.h"
#include "sdm/locations.h"
#include "track/services.h"

namespace evc::kernel {
namespace {

/// Builds the curves in force again if their basis has changed.
void refresh(State& s, Derived& d, const TrainSignals& train, const track::Here& here, bool renewed, Log log) {
  if (renew_basis(s, train, here)) renewed = true;
  if (d.built == s.basis.number || !supervises_speed(s.mode)) return;
  d.built = s.basis.number;
  s.track.watch.changed = true;  // stopping areas depend on the curves
  build(d.in_force, s, train, s.basis);
  if (!renewed) return;  // logged when it was built first
  if (d.in_force.sdm.truncated) log.note({.what = What::targets_lost});
  if (d.in_force.sdm.no_deceleration) log.note({.what = What::no_deceleration, .clause = "3.13.6.2"_srs});
}

protection::Way way_of(DirectionController controller) {
  return controller == DirectionController::forward    ? protection::Way::forward
         : controller == DirectionController::backward ? protection::Way::backward
                                                       : protection::Way::none;
}

/// 5.16.2: the stop in rear of an unprotected level crossing is replaced by the LX speed: with an order to stop, when
/// the train is at standstill in the stopping area; otherwise when it has passed the place defined in 3.13.9.3.5.11.
void pass_level_crossings(State& s, Derived& d, const track::Here& here, const sdm::Motion& motion, Log log) {
  for (const track::LevelCrossing& lx : s.track.lx) {
    if (!lx.unprotected || lx.substituted || here.est_front > lx.from) continue;
    const bool over = lx.stop_required ? here.standstill && here.est_front >= lx.from - lx.L_STOPLX
                                       : sdm::lx_substitution(d.in_force.inputs, d.in_force.sdm, lx.from,
                                                              track::speed_of(lx.V_LX), motion, d.scratch.curves.sdm)
                                             .passed;
    if (!over) continue;
    track::substitute_level_crossing(s.track, lx.NID_LX, here.est_front);
    log.note({.what = What::level_crossing_speed, .id = lx.NID_LX, .clause = "5.16.2"_srs});
    return;  // the others are evaluated with the new curves
  }
}

/// 5.16.1.4: the driver is informed of a crossing that is not protected when it is the most relevant displayed target,
/// or when its speed takes the place of the stop.
void inform_of_level_crossings(State& s, const std::optional<sdm::TargetId>& MRDT) {
  for (track::LevelCrossing& lx : s.track.lx)
    if (lx.unprotected && !lx.informed &&
        (lx.substituted || (MRDT && MRDT->kind == sdm::TargetKind::EOA_SvL && s.basis.authority.EOA == lx.from)))
      lx.informed = s.level_crossing_shown = true;
}

/// The delay of an order is over (4.4.19.1.4.3).
void toggle_LSSMA(LssmaDisplay& display, Duration now) {
  if (!display.waiting || !(now - display.waiting->since > display.waiting->delay)) return;
  display.waiting.reset();
  display.on = true;
}

/// 4.4.19.1.4: the lowest of the MRSP up to the end of the authority and of the target speed there. With a generic LS
/// marker it is shown on the order of trackside, without one when the end is slower than the mode and it is below the
/// speed of the train (4.4.19.1.4.7).
std::optional<Speed> LSSMA(const State& s, const sdm::Derived& in_force, const track::Here& here) {
  const track::Authority& a = s.basis.authority;
  const std::optional<Place> end = a.EOA_or_LOA();
  if (s.mode != Mode::LS || !end) return std::nullopt;
  const bool ordered = s.track.generic_ls_marker;
  if (ordered && !s.lssma.on) return std::nullopt;
  const Speed at_end = a.ends_with_LOA() ? a.V_LOA : Speed{};
  if (!ordered && s.basis.key.mode_limit && at_end >= *s.basis.key.mode_limit) return std::nullopt;
  const Speed lowest = sdm::V_MRSP(in_force.mrsp, here.min_safe_front, *end);
  const Speed LSSMA = lowest < at_end ? lowest : at_end;
  if (!ordered && LSSMA >= s.train.V_MAXTRAIN) return std::nullopt;
  return LSSMA;
}

/// One cycle of 3.13.10.
void supervise_speed(State& s, Derived& d, const TrainSignals& train, const track::Here& here, Supervised& out,
                     Log log) {
  s.level_crossing_shown = false;
  if (!supervises_speed(s.mode)) {
    s.supervision = {};
    return;
  }
  const sdm::Motion motion = motion_of(s, here, train);
  pass_level_crossings(s, d, here, motion, log);
  const sdm::Result& r = out.limits.emplace(sdm::supervise(s.supervision, d.in_force.sdm, motion));
  inform_of_level_crossings(s, r.MRDT);
  toggle_LSSMA(s.lssma, s.now);
  out.LSSMA = LSSMA(s, d.in_force.sdm, here);
  out.asked.add(brakes::Cause::overspeed_traction, r.tco);
  const bool reversing = s.mode == Mode::RV;  // 4.4.18.1.6: the emergency brake instead of the service brake
  out.asked.add(brakes::Cause::overspeed_service, r.sb && !reversing);
  out.asked.add(brakes::Cause::overspeed_emergency, r.eb || (r.sb && reversing));
}

/// Roll away, reverse movement, standstill, post trip and reversing distance (3.14.2-4, 4.4.14, 3.15.4).
void guard_movement(State& s, const TrainSignals& train, const track::Here& here, bool acknowledged, Supervised& out) {
  protection::Movement m;
  m.nominal = position::forward_counter(s.position);
  m.standstill = here.standstill;
  m.controller = way_of(train.direction_controller);
  if (s.manoeuvre.opposite)  // 4.4.21.1.9
    m.controller = m.controller == protection::Way::forward    ? protection::Way::backward
                   : m.controller == protection::Way::backward ? protection::Way::forward
                                                               : protection::Way::none;
  m.permitted = s.mode == Mode::PT || s.mode == Mode::RV ? protection::Way::backward : protection::Way::forward;
  m.D_NVROLL = s.national_values.D_NVROLL;
  m.D_NVPOTRP = s.national_values.D_NVPOTRP;
  if (s.mode == Mode::RV) m.reversing_left = track::reversing_left(s.track, here);
  // One acknowledgement is for the commands of one clause (3.14.1.10): the others last, and what asks for them as well.
  if (acknowledged) m.acknowledged = brakes::acknowledged_causes(s.brakes, s.srs);
  const protection::Commands c = protection::guard(s.guards, protection::guards_of(s.mode), m);
  out.asked.add(brakes::Cause::roll_away, c.roll_away);
  out.asked.add(brakes::Cause::reverse_movement, c.reverse_movement);
  out.asked.add(brakes::Cause::standstill, c.standstill);
  out.asked.add(brakes::Cause::post_trip_distance, c.post_trip);
  out.asked.add(brakes::Cause::reversing_distance, c.reversing);
}

/// The alarm of the balise antenna (3.15.7).
void guard_antenna(State& s, bool alarm, const track::Here& here, Supervised& out) {
  protection::AntennaSituation now;
  now.alarm = alarm;
  now.mode = s.mode;
  now.level = s.level.level;
  now.srs = s.srs;
  now.counter = s.position.now.counter;
  now.min_safe_antenna = here.min_safe_antenna;
  now.max_safe_antenna = here.max_safe_antenna;
  const bool reacts = protection::asks_for_brake(s.antenna_alarm, now, s.track);
  if (memorises_faults(s))
    s.safety_fault_memorised = s.safety_fault_memorised || reacts;
  else
    out.asked.add(brakes::Cause::balise_antenna, reacts);
}

}  // namespace

Supervised supervise(State& state, Derived& derived, const TrainSignals& train, const track::Here& here,
                     bool basis_renewed, bool brake_acknowledged, Log log) {
  Supervised out;
  refresh(state, derived, train, here, basis_renewed, log);
  supervise_speed(state, derived, train, here, out, log);
  guard_movement(state, train, here, brake_acknowledged, out);
  guard_antenna(state, train.antenna_alarm, here, out);
  advance_track_conditions(state, derived, here);
  return out;
}

}  // namespace evc::kernel
