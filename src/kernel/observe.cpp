#include "kernel/observe.h"

#include "driver/driver.h"
#include "kernel/enter.h"
#include "kernel/orders.h"
#include "kernel/receive.h"
#include "kernel/supervise.h"
#include "modes/active_functions.h"
#include "modes/srs_4_6_2.h"
#include "procedures/reversing.h"
#include "procedures/staff_responsible.h"
#include "sdm/supervision.h"
#include "track/services.h"
#include "track/store.h"
#include "train/brake_model.h"

namespace evc::kernel {
namespace {

bool valid(DataStatus status) { return status == DataStatus::valid; }

procedures::start_of_mission::Session session_of(const State& s) {
  using procedures::start_of_mission::Session;
  if (s.radio.session.established()) return Session::open;
  return s.radio.session.phase == radio::Phase::connecting || s.radio.session.phase == radio::Phase::waiting_version
             ? Session::establishing
             : Session::none;
}

DataStatus position_status(const State& s) {
  return s.position.status == DataStatus::valid     ? DataStatus::valid
         : s.position.status == DataStatus::invalid ? DataStatus::invalid
                                                    : DataStatus::unknown;
}

Set<Ack> acknowledged(const DriverActions& driver) { return Set<Ack>::of_bits(driver.acknowledged); }

/// What decides which inputs of the driver are enabled now (4.7.2).
driver::ActionContext action_context(const Cycle& cycle) {
  const State& s = cycle.state;
  driver::ActionContext c;
  c.mode = s.mode;
  if (valid(s.data.level_status)) c.level = s.level.level;
  c.desk_open = cycle.in.train.desk_open;
  c.standstill = cycle.here.standstill;
  c.driver_id_valid = valid(s.data.driver_id_status);
  c.train_data_valid = valid(s.data.train_data_status);
  c.train_running_number_valid = valid(s.data.train_running_number_status);
  c.session_open = s.radio.session.established();
  c.train_data_acknowledged = s.radio.train_data_acknowledged;
  c.emergency_stop_pending = s.emergency_stops.any();
  c.exit_from_trip_recognised = procedures::train_trip::exit_recognised(s.train_trip);
  c.non_leading_signal = cycle.in.train.non_leading;
  c.passive_shunting_signal = cycle.in.train.passive_shunting;
  c.slow_enough_for_override = run_of(s.position.now).V <= s.national_values.V_NVALLOWOVTRP;
  c.driver_may_change_adhesion = s.national_values.Q_NVDRIVER_ADHES;
  c.driver_id_while_running = s.national_values.M_NVDERUN;
  c.track_ahead_free_asked = s.track_ahead_free.asking;
  c.offers = s.offers;
  // What start of mission asks for is offered too (S12).
  c.offers.add(Offer::train_data, s.entries.has(Entry::train_data));
  c.requests = s.requested;
  return c;
}

/// Whether the driver may do it now; an action that is not enabled has no effect, and the event says so.
bool may(Cycle& cycle, driver::Input input, const Event& otherwise) {
  if (driver::enabled(action_context(cycle)).has(input)) return true;
  note(cycle, otherwise);
  return false;
}
bool may_enter(Cycle& cycle, driver::Input input, Entered entered) {
  return may(cycle, input,
             {.what = What::entry_not_enabled, .id = static_cast<std::int32_t>(entered), .clause = "4.7.2"_srs});
}

/// Selections that are enabled; the others are dropped.
DriverActions enabled_selections(Cycle& cycle) {
  struct Row {
    Select select;
    driver::Input input;
  };
  constexpr std::array<Row, 9> rows{{
      {Select::start, driver::Input::start},
      {Select::override_, driver::Input::override_},
      {Select::shunting, driver::Input::shunting},
      {Select::exit_shunting, driver::Input::exit_shunting},
      {Select::non_leading, driver::Input::non_leading},
      {Select::maintain_shunting, driver::Input::continue_shunting},
      {Select::slippery_rail, driver::Input::adhesion},
      {Select::adhesion_normal, driver::Input::adhesion},
      {Select::track_ahead_free, driver::Input::track_ahead_free},
  }};
  DriverActions actions = cycle.in.driver;
  for (const Row& row : rows)
    if (actions.has(row.select) &&
        !may(cycle, row.input,
             {.what = What::selection_not_enabled, .id = static_cast<std::int32_t>(row.select), .clause = "4.7.2"_srs}))
      actions.selected &= ~(1u << static_cast<unsigned>(row.select));
  return actions;
}

/// 3.18.3.7: the authority was given for another train.
void forget_authority_of_old_train(Cycle& cycle) {
  State& s = cycle.state;
  if (s.track.ma) {
    if (track::shorten(s.track, track::Situation::j_train_data_changed, cycle.here.max_safe_front, cycle.here))
      s.track_description_deleted = true;
    cut_other(s, cycle.here.max_safe_front);
    note(cycle, {.what = What::track_description_shortened, .clause = "3.18.3.7"_srs});
  }
  clear_buffer(s);
}

/// Whether the data were taken.
bool enter_train_data(Cycle& cycle, const train::TrainData& data) {
  State& s = cycle.state;
  if (const train::Fault fault = train::check(data); fault != train::Fault::none) {
    note(cycle,
         {.what = What::train_data_refused, .id = static_cast<std::int32_t>(fault), .clause = train::clause(fault)});
    return false;
  }
  const bool route_matters = s.train.cant_deficiency_mm != data.cant_deficiency_mm ||
                             s.train.other_categories != data.other_categories || s.train.axle_load != data.axle_load ||
                             s.train.loading_gauge != data.loading_gauge ||
                             !(s.train.traction_systems == data.traction_systems);
  if (route_matters && s.data.train_data_status == DataStatus::valid) forget_authority_of_old_train(cycle);
  s.train = data;
  s.data.train_data_status = DataStatus::valid;
  ++s.revision;
  radio::send_train_data(s.radio);
  note(cycle, {.what = What::train_data_valid, .clause = "3.18.3"_srs});
  return true;
}

/// Entry of SR speed and distance (4.4.11.1.5): only in SR, the distance from the front end at the entry.
void enter_SR_data(Cycle& cycle) {
  State& s = cycle.state;
  if (!cycle.in.driver.V_sr && !cycle.in.driver.D_sr) return;
  if (s.mode == Mode::SR && !cycle.here.standstill) cycle.asked.add(brakes::Cause::movement_while_entering_SR_data);
  if (!may_enter(cycle, driver::Input::sr_speed_distance, Entered::SR_speed_distance)) return;
  // A speed up to 600 km/h, a distance up to the greatest that packets give.
  const auto in_range = [](double v, double limit) { return v >= 0.0 && v <= limit; };
  if ((cycle.in.driver.V_sr && !in_range(cycle.in.driver.V_sr->si, 600.0 / 3.6)) ||
      (cycle.in.driver.D_sr && !in_range(cycle.in.driver.D_sr->si, 327670.0)))
    return note(cycle, {.what = What::SR_data_out_of_range, .clause = "4.4.11"_srs});
  if (cycle.in.driver.V_sr) s.staff_responsible.V = cycle.in.driver.V_sr;
  if (cycle.in.driver.D_sr) s.staff_responsible.end = cycle.here.est_front + *cycle.in.driver.D_sr;
  ++s.revision;
}

std::span<const procedures::mode_profile::Area> areas_of(const State& s,
                                                         InplaceVector<procedures::mode_profile::Area, 32>& areas) {
  for (const track::ModeArea& a : s.track.mode_profile) {
    procedures::mode_profile::Area area;
    area.mode = a.mode;
    area.start = a.from;
    if (a.mode != Mode::SH) area.end = a.to;
    const Speed national = area.mode == Mode::OS   ? s.national_values.V_NVONSIGHT
                           : area.mode == Mode::LS ? s.national_values.V_NVLIMSUPERV
                                                   : s.national_values.V_NVSHUNT;
    area.V = a.V_MAMODE == track::kNoSpeed ? national : track::speed_of(a.V_MAMODE);
    area.L_ack = a.from - a.ack_from;
    (void)areas.push_back(area);  // both hold 32
  }
  return {areas.begin(), areas.size()};
}

std::optional<modes::OrderedLevel> driver_level(Cycle& cycle) {
  const State& s = cycle.state;
  if (!cycle.in.driver.level || !may_enter(cycle, driver::Input::level, Entered::level)) return {};
  modes::OrderedLevel level;
  level.level = *cycle.in.driver.level;
  if (level.level == Level::NTC) level.nid_ntc = cycle.in.driver.nid_ntc;
  const modes::LevelTable* table = s.level_table ? &*s.level_table : nullptr;
  if (!modes::driver_may_select(level, table, available_levels(cycle))) return {};
  return level;
}

void run_level_transition(Cycle& cycle) {
  State& s = cycle.state;
  procedures::level_transition::Inputs in;
  in.now = s.now;
  in.mode = s.mode;
  in.current = s.level;
  in.est_front = cycle.here.est_front;
  in.max_safe_front = cycle.here.max_safe_front;
  in.order = cycle.order ? &*cycle.order : nullptr;
  in.driver_level = driver_level(cycle);
  in.available = available_levels(cycle);
  in.acknowledged = cycle.facts.acknowledged.has(Ack::level);
  in.srs = s.srs;
  if (in.driver_level) s.data.level_status = DataStatus::valid;
  const auto result = procedures::level_transition::step(s.level_transition, in);
  cycle.effects |= result.effects;
  if (result.overdue)
    cycle.asked.add(*result.overdue == Level::NTC ? brakes::Cause::level_NTC_unacknowledged
                                                  : brakes::Cause::level_0_unacknowledged);
  if (result.cancelled) clear_buffer(s);
  if (!result.switch_to) return;
  const modes::OrderedLevel from = s.level;
  enter_level(cycle, *result.switch_to, result.by_driver);
  cycle.facts.level_switched_to = s.level.level;
  cycle.facts.level_order_changed_national_system_only = from.level == Level::NTC && s.level.level == Level::NTC;
  if (level_2_or_3(from.level) && !level_2_or_3(s.level.level))
    s.reports.rear_border = result.by_driver ? std::optional<Place>{} : cycle.here.est_front;
  release_buffer(cycle);
}

void run_mode_profile(Cycle& cycle) {
  State& s = cycle.state;
  InplaceVector<procedures::mode_profile::Area, 32> areas;
  procedures::mode_profile::Inputs in;
  in.now = s.now;
  in.mode = s.mode;
  in.level = s.level.level;
  in.areas = areas_of(s, areas);
  in.min_safe_front = cycle.here.min_safe_front;
  in.est_front = cycle.here.est_front;
  in.max_safe_front = cycle.here.max_safe_front;
  in.V_est = run_of(s.position.now).V;
  in.acknowledged = cycle.facts.acknowledged;
  in.srs = s.srs;
  const auto r = procedures::mode_profile::step(s.mode_profile, in);
  cycle.effects |= r.effects;
  cycle.facts.profile_demands_OS = r.demands_OS;
  cycle.facts.profile_demands_LS = r.demands_LS;
  cycle.facts.profile_demands_SH = r.demands_SH;
  cycle.facts.profile_in_force = r.in_force;
  cycle.facts.front_in_OS_ack_area = r.front_in_OS_ack_area;
  cycle.facts.front_in_LS_ack_area = r.front_in_LS_ack_area;
  cycle.profile_at_front = r.at_front;
  if (r.overdue)
    cycle.asked.add(*r.overdue == Mode::OS   ? brakes::Cause::OS_unacknowledged
                    : *r.overdue == Mode::LS ? brakes::Cause::LS_unacknowledged
                                             : brakes::Cause::SH_unacknowledged);
}

Duration request_cycle(const State& s) {
  return s.radio.ma_request && s.radio.ma_request->T_CYCRQST ? *s.radio.ma_request->T_CYCRQST : Duration{60.0};
}

/// 5.4.3.3: what start of mission makes of the status of data.
void change_statuses(Cycle& cycle, Set<procedures::Status> status) {
  State& s = cycle.state;
  using procedures::Status;
  if (status.has(Status::position_unknown))
    position::forget(s.position);
  else if (status.has(Status::position_valid))
    position::validate(s.position);
  if (status.has(Status::level_invalid) && valid(s.data.level_status)) s.data.level_status = DataStatus::invalid;
  if (status.has(Status::level_valid)) s.data.level_status = DataStatus::valid;
  if (status.has(Status::rbc_contact_invalid) && valid(s.contact_status)) s.contact_status = DataStatus::invalid;
  if (status.has(Status::rbc_contact_valid)) s.contact_status = DataStatus::valid;
  cycle.here = here(s);
}

void run_start_of_mission(Cycle& cycle) {
  State& s = cycle.state;
  const DriverActions& driver = cycle.driver;
  procedures::start_of_mission::Inputs in;
  in.now = s.now;
  in.mode = s.mode;
  in.level = s.level.level;
  in.desk_open = cycle.in.train.desk_open;
  in.session = session_of(s);
  in.mobile_terminal_registered = s.fitted_levels[static_cast<std::size_t>(Level::L2)];
  in.T_CYCRQST = request_cycle(s);
  in.driver_id = s.data.driver_id_status;
  in.train_running_number = s.data.train_running_number_status;
  in.position = position_status(s);
  in.level_status = s.data.level_status;
  in.train_data = s.data.train_data_status;
  in.enters_level = driver.level.has_value() && valid(s.data.level_status);
  in.enters_rbc_contact = driver.rbc_contact.has_value();
  in.enters_train_data = cycle.train_data_entered;
  in.selects_start = driver.has(Select::start);
  in.train_data_acknowledged = s.radio.train_data_acknowledged;
  in.position_confirmed = cycle.position_confirmed;
  in.train_accepted = cycle.train_accepted;
  in.train_rejected = cycle.train_rejected;
  in.SR_authorised = cycle.SR_authorised;
  if (cycle.facts.ma_ssp_gradient_stored) in.profile_at_front = cycle.profile_at_front;
  const bool was_running = s.start_of_mission.step != procedures::start_of_mission::Step::S0;
  const procedures::Effects effects = procedures::start_of_mission::step(s.start_of_mission, in);
  cycle.effects |= effects;
  change_statuses(cycle, effects.status);
  if (was_running && s.mode == Mode::SB && !cycle.in.train.desk_open) close_desk_in_start_of_mission(cycle);
  if (s.start_of_mission.step == procedures::start_of_mission::Step::S21)
    cycle.ma_request_reasons |= radio::kStartSelected;
}

void run_override(Cycle& cycle) {
  State& s = cycle.state;
  procedures::override_::Inputs in;
  in.now = s.now;
  in.odometer = s.position.now.counter.nominal;
  in.V_est = run_of(s.position.now).V;
  in.mode = s.mode;
  in.level = s.level.level;
  in.selected = cycle.driver.has(Select::override_);
  in.train_data_valid = valid(s.data.train_data_status);
  in.V_NVALLOWOVTRP = s.national_values.V_NVALLOWOVTRP;
  in.T_NVOVTRP = s.national_values.T_NVOVTRP;
  in.D_NVOVTRP = s.national_values.D_NVOVTRP;
  in.est_front = cycle.here.est_front;
  in.min_safe_antenna = cycle.here.min_safe_antenna;
  const track::Authority& a = cycle.state.basis.authority;
  in.eoa_or_loa = a.EOA ? a.EOA : a.LOA;
  if (s.mode == Mode::SR) in.sr_distance_end = s.staff_responsible.end;
  in.stop_if_in_SR = cycle.facts.stop_if_in_SR;
  in.stop_if_in_SH = cycle.facts.stop_if_in_SH;
  in.balise_proceed = cycle.balise_proceed;
  in.ma_from_rbc = cycle.ma_from_rbc;
  in.group_not_in_list = cycle.facts.group_passed_not_in_SR_list || cycle.facts.group_passed_not_in_SH_list;
  const bool before = s.override_.active;
  const auto r = procedures::override_::step(s.override_, in);
  cycle.facts.selects_override = r.selected;
  cycle.facts.override_active = r.active;
  cycle.facts.former_eoa_passed = r.former_eoa_passed;
  if (r.started) {
    s.staff_responsible = {};
    if (s.national_values.D_NVSTFF) s.staff_responsible.end = cycle.here.est_front + *s.national_values.D_NVSTFF;
    note(cycle, {.what = What::override_active, .clause = "5.8.3"_srs});
  }
  if (r.ended_by) note(cycle, {.what = What::override_ended, .clause = r.ended_by});
  if (before != s.override_.active || r.started) ++s.revision;
}

void run_shunting(Cycle& cycle) {
  State& s = cycle.state;
  procedures::shunting::Inputs in;
  in.now = s.now;
  in.mode = s.mode;
  in.level = s.level.level;
  in.standstill = cycle.here.standstill;
  in.session_open = s.radio.session.established();
  in.selects_SH = cycle.driver.has(Select::shunting);
  in.selects_continue = cycle.driver.has(Select::maintain_shunting);
  in.authorised = cycle.SH_authorised;
  in.refused = cycle.SH_refused;
  const auto r = procedures::shunting::step(s.shunting, in);
  cycle.effects |= r.effects;
  cycle.facts.SH_granted = r.granted;
  cycle.facts.selects_SH = r.selects_SH;
  cycle.facts.continue_shunting = s.shunting.continues;
}

void run_reversing(Cycle& cycle) {
  const State& s = cycle.state;
  procedures::reversing::Inputs in;
  in.mode = s.mode;
  in.standstill = cycle.here.standstill;
  in.controller_backward = cycle.in.train.direction_controller == DirectionController::backward;
  in.est_front = cycle.here.est_front;
  if (s.track.reversing_area && s.track.reversing_supervision && s.track.reversing_reference) {
    procedures::reversing::Reversing r;
    r.start = s.track.reversing_area->from;
    r.end = s.track.reversing_area->to;
    r.reference = *s.track.reversing_reference;
    r.D_REVERSE = s.track.reversing_supervision->D_REVERSE;
    r.V_REVERSE = track::speed_of(s.track.reversing_supervision->V_REVERSE);
    in.stored = r;
  }
  const auto r = procedures::reversing::step(in);
  cycle.effects |= r.effects;
  cycle.reversing_possible = r.possible;
}

/// Facts that are read off the train interface, the position and the track description.
void observe_state(Cycle& cycle) {
  State& s = cycle.state;
  procedures::Facts& f = cycle.facts;
  const TrainSignals& train = cycle.in.train;
  f.isolated = train.isolated || cycle.in.driver.has(Select::isolate);
  f.powered = train.powered;
  f.desk_open = train.desk_open;
  f.standstill = cycle.here.standstill;
  f.sleeping = train.sleeping;
  f.non_leading = train.non_leading;
  f.passive_shunting = train.passive_shunting;
  f.safety_fault = f.safety_fault || cycle.in.safety_fault;
  f.level = s.level.level;
  f.requested = s.requested;
  f.selects_exit_SH = cycle.driver.has(Select::exit_shunting);
  f.selects_NL = cycle.driver.has(Select::non_leading);
  f.train_data_valid = valid(s.data.train_data_status);
  f.ma_ssp_gradient_stored = s.track.ma.has_value() && track::complete(s.track, cycle.here);
  f.ma_accepted = f.ma_accepted || s.track.ma.has_value();
  f.ma_with_trip_order = s.ma_with_trip_order;
  f.mode_is_OS = s.mode == Mode::OS;
  f.mode_is_LS = s.mode == Mode::LS;
  f.ues_received = f.ues_received || s.emergency_stops.unconditional_pending();
  f.T_NVCONTACT_trip = s.contact_trip;
  f.stop_shunting_stored = s.track.stop_shunting_on_desk_opening;
  f.national_trip = cycle.in.national_system.trip_active;
  f.SR_distance_passed = s.mode == Mode::SR &&
                         procedures::staff_responsible::distance_passed(s.staff_responsible.end, cycle.here.est_front);
}

/// [12], [16], [69]: with the authority that is in force after everything this cycle received.
void observe_authority(Cycle& cycle) {
  const State& s = cycle.state;
  const track::Authority& a = cycle.state.basis.authority;
  cycle.facts.min_safe_antenna_beyond_eoa = protection::passes_end_level_1(a, cycle.here);
  cycle.facts.min_safe_front_beyond_eoa = protection::passes_end_level_2(a, cycle.here);
  cycle.facts.front_in_rear_of_track_description = track::before_track_description(s.track, cycle.here);
}

}  // namespace

void take_driver_actions(Cycle& cycle) {
  State& s = cycle.state;
  cycle.driver = cycle.in.driver;
  if (cycle.driver.selected != 0) cycle.driver = enabled_selections(cycle);
  const DriverActions& driver = cycle.driver;
  cycle.facts.acknowledged = acknowledged(driver);
  if (driver.driver_id && may_enter(cycle, driver::Input::driver_id, Entered::driver_id)) {
    s.data.driver_id = *driver.driver_id;
    s.data.driver_id_status = DataStatus::valid;
  }
  if (driver.train_running_number &&
      may_enter(cycle, driver::Input::train_running_number, Entered::train_running_number)) {
    s.data.train_running_number = *driver.train_running_number;
    s.data.train_running_number_status = DataStatus::valid;
  }
  if (driver.train_data != nullptr) {
    if (may_enter(cycle, driver::Input::train_data, Entered::train_data))
      cycle.train_data_entered = enter_train_data(cycle, *driver.train_data);
  } else if (driver.has(Ack::train_data) && s.data.train_data_status != DataStatus::unknown &&
             may_enter(cycle, driver::Input::train_data, Entered::train_data)) {
    s.data.train_data_status = DataStatus::valid;
    radio::send_train_data(s.radio);
    cycle.train_data_entered = true;
  }
  if (driver.rbc_contact && may_enter(cycle, driver::Input::rbc_contact, Entered::rbc_contact))
    s.radio.contact = radio::Rbc{driver.rbc_contact->NID_C, driver.rbc_contact->NID_RBC, driver.rbc_contact->NID_RADIO};
  if (driver.has(Select::slippery_rail) && !s.slippery_rail) {
    s.slippery_rail = true;
    ++s.revision;
  }
  if (driver.has(Select::adhesion_normal) && s.slippery_rail) {
    s.slippery_rail = false;
    ++s.revision;
  }
  enter_SR_data(cycle);
}

void run_procedures(Cycle& cycle) {
  run_level_transition(cycle);
  advance_national_values(cycle);
  observe_state(cycle);
  run_mode_profile(cycle);
  run_start_of_mission(cycle);
  refresh(cycle);
  run_override(cycle);
  run_shunting(cycle);
  run_reversing(cycle);
}

void change_mode(Cycle& cycle) {
  State& s = cycle.state;
  observe_authority(cycle);
  s.previous_mode = s.mode;
  const auto transition = modes::next_mode(s.mode, procedures::observe(cycle.facts));
  if (!transition) return;
  enter_mode(cycle, transition->to, transition->number);
  refresh(cycle);
}

void run_procedures_after(Cycle& cycle) {
  State& s = cycle.state;
  procedures::train_trip::Inputs trip;
  trip.now = s.now;
  trip.mode = s.mode;
  trip.level = s.level.level;
  trip.desk_open = cycle.in.train.desk_open;
  trip.standstill = cycle.here.standstill;
  trip.session_open = s.radio.session.established();
  trip.train_data_valid = valid(s.data.train_data_status);
  trip.exit_recognised = cycle.exit_from_trip;
  trip.emergency_stop_pending = s.emergency_stops.any();
  trip.selects_start = cycle.driver.has(Select::start);
  trip.SR_authorised = cycle.SR_authorised;
  trip.T_CYCRQST = request_cycle(s);
  if (cycle.facts.ma_ssp_gradient_stored) trip.profile_at_front = cycle.profile_at_front;
  cycle.effects |= procedures::train_trip::step(s.train_trip, trip);
  if (s.train_trip.step == procedures::train_trip::Step::S150) cycle.ma_request_reasons |= radio::kStartSelected;

  procedures::end_of_mission::Inputs end;
  end.now = s.now;
  end.mode = s.mode;
  end.previous_mode = s.previous_mode;
  end.session_open = s.radio.session.established();
  end.termination_ordered = cycle.termination_ordered;
  end.level_2_or_3 = level_2_or_3(s.level.level);
  cycle.effects |= procedures::end_of_mission::step(s.end_of_mission, end);
}

}  // namespace evc::kernel
