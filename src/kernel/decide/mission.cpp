#include "kernel/decide/mission.h"

#include "kernel/decide/enter.h"
#include "kernel/here.h"
#include "kernel/stored.h"
#include "kernel/train_data.h"
#include "procedures/reversing.h"
#include "track/services.h"

namespace evc::kernel {
namespace {

/// The session that start of mission waits for or has; one of a handover that is left over counts as well (5.4.3.2 S0).
procedures::start_of_mission::Session session_of(const State& s) {
  using procedures::start_of_mission::Session;
  const bool left_over = s.radio.supervising.session.phase == radio::Phase::idle;
  const radio::Session& session = (left_over ? s.radio.other : s.radio.supervising).session;
  switch (session.phase) {
    case radio::Phase::connecting:
    case radio::Phase::waiting_version:
      return Session::establishing;
    case radio::Phase::up:
    case radio::Phase::lost:
      return Session::open;
    case radio::Phase::terminating:  // D31 waits for the session that follows with another RBC (3.5.3.5.2)
      return session.remembered ? Session::establishing : Session::terminating;
    case radio::Phase::idle:
      break;
  }
  return Session::none;
}

procedures::mode_profile::Result run_areas(State& s, procedures::mode_profile::Inputs in) {
  InplaceVector<procedures::mode_profile::Area, 32> areas;
  for (track::ModeArea& a : s.track.mode_profile) {
    // In its mode it is entered without an acknowledgement (5.9.2.7). Its window is over then, and the entry not undone
    // by a correction of the position or rolling back (A.3.5.1): the area of this mode reaches back to the train.
    const bool front_within = in.max_safe_front >= a.from && (!a.to || in.max_safe_front < *a.to);
    a.accepted = a.accepted || (front_within && a.mode == s.mode);
    const bool in_its_mode = a.accepted && a.mode == s.mode;
    if (in_its_mode && in.max_safe_front >= a.from) a.ack_from = a.from;
    const bool entered = in_its_mode && a.ack_from >= a.from;
    procedures::mode_profile::Area area;
    area.mode = a.mode;
    area.start = entered && in.max_safe_front < a.from ? in.max_safe_front : a.from;
    area.end = a.to;
    const Speed national = area.mode == Mode::OS   ? s.national_values.V_NVONSIGHT
                           : area.mode == Mode::LS ? s.national_values.V_NVLIMSUPERV
                                                   : s.national_values.V_NVSHUNT;
    area.V = a.V_MAMODE == track::kNoSpeed ? national : track::speed_of(a.V_MAMODE);
    area.L_ack = a.from - a.ack_from;
    area.asked = a.asked;
    (void)areas.push_back(area);  // both hold 32
  }
  in.areas = {areas.begin(), areas.size()};
  const procedures::mode_profile::Result out = procedures::mode_profile::step(s.mode_profile, in);
  if (out.asks_for) s.track.mode_profile[*out.asks_for].asked = true;
  return out;
}

/// 5.4.3.3: the status of data set by start of mission.
void change_statuses(State& s, Set<procedures::Status> status) {
  using procedures::Status;
  if (status.has(Status::position_unknown))
    position::forget(s.position);
  else if (status.has(Status::position_valid))
    position::validate(s.position);
  if (status.has(Status::level_invalid)) invalidate(s.data.level_status);
  if (status.has(Status::level_valid)) s.data.level_status = DataStatus::valid;
  if (status.has(Status::rbc_contact_invalid)) invalidate(s.contact_status);
  if (status.has(Status::rbc_contact_valid) && s.radio.contact) s.contact_status = DataStatus::valid;
}

/// 4.4.11.1.6.2: an authorisation for SR that came before Start was selected does not answer it; in level 1 or without
/// a session SR is then entered without one, and without its list of groups.
void forget_SR_authorisation_at_start(State& s, const Received& received) {
  const bool starts = (s.mode == Mode::SB || s.mode == Mode::PT) && received.selected.has(Select::start);
  if (!starts || received.SR_authorised) return;
  s.staff_responsible = {};
  s.track.sr_list.reset();
}

}  // namespace

std::optional<Mode> run_mode_profile(State& s, const Received& received, procedures::Facts& facts, Decided& out) {
  procedures::mode_profile::Inputs in;
  in.now = s.now;
  in.mode = s.mode;
  in.min_safe_front = out.here.min_safe_front;
  in.est_front = out.here.est_front;
  in.max_safe_front = out.here.max_safe_front;
  in.V_est = run_of(s.position.now).V;
  in.acknowledged = received.acknowledged;
  in.srs = s.srs;
  const auto r = s.track.mode_profile.empty() ? procedures::mode_profile::step(s.mode_profile, in) : run_areas(s, in);
  out.effects |= r.effects;
  facts.profile_demands_OS = r.demands_OS;
  facts.profile_demands_LS = r.demands_LS;
  facts.profile_demands_SH = r.demands_SH;
  facts.profile_in_force = r.in_force;
  facts.front_in_OS_ack_area = r.front_in_OS_ack_area;
  facts.front_in_LS_ack_area = r.front_in_LS_ack_area;
  if (r.overdue)
    out.asked.add(*r.overdue == Mode::OS   ? brakes::Cause::OS_unacknowledged
                  : *r.overdue == Mode::LS ? brakes::Cause::LS_unacknowledged
                                           : brakes::Cause::SH_unacknowledged);
  return r.at_front;
}

void run_start_of_mission(State& s, bool desk_open, const Received& received, std::optional<Mode> profile_at_front,
                          Decided& out) {
  forget_SR_authorisation_at_start(s, received);
  procedures::start_of_mission::Inputs som;
  som.mode = s.mode;
  som.level = s.level.level;
  som.desk_open = desk_open;
  som.session = session_of(s);
  som.mobile_terminal_registered = s.fitted_levels[static_cast<std::size_t>(Level::L2)] && s.network.registered;
  som.registration_failed = registration_failed(s.network, s.now);
  som.position_refers_to_LRBG = position::lrbg(s.position) != nullptr;
  som.network_offered = !s.network.offered.empty();
  som.driver_id = s.data.driver_id_status;
  som.train_running_number = s.data.train_running_number_status;
  som.position = s.position.status;
  som.level_status = s.data.level_status;
  som.train_data = s.data.train_data_status;
  som.enters_level = received.entered.has(Entered::level);
  som.enters_rbc_contact = received.entered.has(Entered::rbc_contact);
  som.selects_short_number = received.selected.has(Select::short_number);
  som.enters_train_data = received.entered.has(Entered::train_data);
  som.entry_of_train_data_open = received.entry_of_train_data_open;
  som.selects_start = received.selected.has(Select::start);
  som.train_data_acknowledged = s.radio.supervising.knows_train_data();
  som.position_confirmed = received.position_confirmed;
  som.train_accepted = received.train_accepted;
  som.train_rejected = received.train_rejected;
  som.SR_authorised = received.SR_authorised;
  som.profile_at_front = profile_at_front;
  som.srs = s.srs;
  const bool was_running = s.start_of_mission.step != procedures::start_of_mission::Step::S0;
  const procedures::Effects effects = procedures::start_of_mission::step(s.start_of_mission, som);
  out.effects |= effects;
  if (!effects.status.empty()) {
    change_statuses(s, effects.status);
    out.here = here(s);
  }
  if (was_running && s.mode == Mode::SB && !desk_open) end_start_of_mission(s, out.here);
  if (s.start_of_mission.step == procedures::start_of_mission::Step::S21) out.start_selected = true;
}

void run_override(State& s, const Received& received, const track::Here& here, procedures::Facts& facts, Log log) {
  procedures::override_::Inputs in;
  in.now = s.now;
  in.odometer = position::forward_counter(s.position);
  in.mode = s.mode;
  in.level = s.level.level;
  in.selected = received.selected.has(Select::override_);
  in.T_NVOVTRP = s.national_values.T_NVOVTRP;
  in.D_NVOVTRP = s.national_values.D_NVOVTRP;
  if (s.position.status != DataStatus::valid) in.counter = virtual_front(s);  // 3.6.7.1 f
  in.est_front = here.est_front;
  in.min_safe_antenna = here.min_safe_antenna;
  in.eoa_or_loa = s.basis.authority.EOA_or_LOA();
  if (s.mode == Mode::SR) in.sr_distance_end = s.staff_responsible.end;
  in.stop_if_in_SR = received.stop_if_in_SR;
  in.stop_if_in_SH = received.stop_if_in_SH;
  in.balise_proceed = received.balise_proceed;
  in.ma_from_rbc = received.ma_from_rbc;
  in.group_not_in_list = received.group_passed_not_in_SR_list || received.group_passed_not_in_SH_list;
  const bool before = s.override_.active;
  const auto r = procedures::override_::step(s.override_, in);
  facts.selects_override = r.selected;
  facts.override_active = r.active;
  facts.former_eoa_passed = r.former_eoa_passed;
  if (r.started) {
    s.staff_responsible = {};
    limit_SR_distance(s, here);
    log.note({.what = What::override_active, .clause = "5.8.3"_srs});
  }
  if (r.ended_by) log.note({.what = What::override_ended, .clause = r.ended_by});
  if (before != s.override_.active || r.started) ++s.revision;
}

void run_shunting(State& s, const Received& received, const track::Here& here, procedures::Facts& facts,
                  procedures::Effects& effects) {
  procedures::shunting::Inputs in;
  in.now = s.now;
  in.mode = s.mode;
  in.level = s.level.level;
  in.standstill = here.standstill;
  in.session_open = s.radio.supervising.session.established();
  in.selects_SH = received.selected.has(Select::shunting);
  in.selects_continue = received.selected.has(Select::maintain_shunting);
  in.authorised = received.SH_authorised;
  in.refused = received.SH_refused;
  const auto r = procedures::shunting::step(s.shunting, in);
  effects |= r.effects;
  facts.SH_granted = r.granted;
  facts.selects_SH = r.selects_SH;
  facts.continue_shunting = s.shunting.continues;
}

void run_reversing(const State& s, DirectionController controller, Decided& out) {
  procedures::reversing::Inputs in;
  in.mode = s.mode;
  in.standstill = out.here.standstill;
  in.controller_backward = controller == DirectionController::backward;
  in.est_front = out.here.est_front;
  if (s.track.reversing_area && s.track.reversing_supervision && s.track.reversing_reference)
    in.stored = procedures::reversing::Area{s.track.reversing_area->from, s.track.reversing_area->to};
  const auto r = procedures::reversing::step(in);
  out.effects |= r.effects;
  out.reversing_possible = r.possible;
}

void run_train_trip(State& s, bool desk_open, const Received& received, std::optional<Mode> profile_at_front,
                    Decided& out) {
  procedures::train_trip::Inputs trip;
  trip.now = s.now;
  trip.mode = s.mode;
  trip.level = s.level.level;
  trip.desk_open = desk_open;
  trip.standstill = out.here.standstill;
  trip.session_open = s.radio.supervising.session.established();
  trip.train_data_valid = valid(s.data.train_data_status);
  trip.exit_recognised = received.exit_from_trip;
  trip.emergency_stop_pending = s.emergency_stops.any();
  trip.selects_start = received.selected.has(Select::start);
  trip.SR_authorised = received.SR_authorised;
  trip.profile_at_front = profile_at_front;
  out.effects |= procedures::train_trip::step(s.train_trip, trip);
  if (s.train_trip.step == procedures::train_trip::Step::S150) out.start_selected = true;
}

void run_train_data_change(State& s, const Received& received, Decided& out, Log log) {
  TrainDataChange& change = s.train_data_change;
  if (!change.pending) return;
  procedures::train_data_change::Inputs in;
  in.mode = s.mode;
  in.pending = true;
  in.driver_validates = change.driver_validates;
  in.route_matters = route_matters(s.train, *change.pending);
  in.train_data_valid = valid(s.data.train_data_status);
  in.standstill = out.here.standstill;
  // Of what waits, authority and track description count (D5).
  for (const BufferedSet& set : s.buffer)
    in.authority_waits = in.authority_waits || (set.medium == Medium::rbc && (set.waiting & set.of_authority) != 0);
  in.brake_commanded = s.brakes.active.has(brakes::Cause::train_data_changed);
  in.driver_validated = received.entered.has(Entered::train_data);
  const auto r = procedures::train_data_change::step(change.procedure, in);
  out.effects |= r.effects;
  out.asked.add(brakes::Cause::train_data_changed, r.brake);
  using procedures::train_data_change::Fate;
  switch (r.data) {
    case Fate::kept:
      return;
    case Fate::in_force:
      change_train_data(s, *change.pending, out.here, log);
      break;
    case Fate::to_validate:
      if (train::check(*change.pending) == train::Fault::none) s.train = *change.pending;
      s.data.train_data_status = DataStatus::invalid;
      ++s.revision;
      log.note({.what = What::train_data_to_be_validated, .clause = "5.17.2.2"_srs});
      break;
    case Fate::by_the_driver:
      break;
  }
  change.pending.reset();
  change.procedure = {};
}

void run_start_in_SR(State& s, const Received& received, Decided& out) {
  const bool possible = s.mode == Mode::SR && level_2_or_3(s.level.level) && s.radio.supervising.session.established();
  if (received.selected.has(Select::start)) s.start_in_SR = true;
  if (!possible || received.ma_from_rbc || received.SR_authorised) s.start_in_SR = false;
  if (s.start_in_SR) out.start_selected = true;
}

void run_end_of_mission(State& s, bool desk_open, const Received& received, Decided& out) {
  out.mission_ended =
      out.mode_changed && procedures::end_of_mission::ends_mission(s.previous_mode, s.mode, s.end_of_mission.mission);
  procedures::end_of_mission::Inputs end;
  end.now = s.now;
  end.mode = s.mode;
  end.previous_mode = s.previous_mode;
  // With both RBCs of a handover (3.15.1.3.4.1): one that orders its session to end has ended it; the other goes on.
  const bool other = s.radio.other.session.established();
  end.session_open = s.radio.supervising.session.established() || other;
  end.termination_ordered = received.termination_ordered && !other;
  end.level_2_or_3 = level_2_or_3(s.level.level);
  // Up to 2.2 the end of the session is awaited, with the desk closed as well (6.6.4.3.2).
  end.report_ends_it =
      !desk_open && radio::common_version(s.radio, s.radio.supervising.session) >= lang::SystemVersion{2, 3};
  out.effects |= procedures::end_of_mission::step(s.end_of_mission, end);
}

}  // namespace evc::kernel
