#include "kernel/driver_inputs.h"

#include "kernel/here.h"
#include "kernel/manoeuvre.h"

namespace evc::kernel {

namespace {

/// The longest train that a position report can give: L_TRAININT, 15 bits, m (7.5.1.55).
constexpr Distance kLongestTold{32767.0};

/// 3.18.3.10.1: nothing that was sent waits for its acknowledgement.
bool consist_acknowledged(const State& s) {
  return s.manoeuvre.available && !s.radio.supervising.consist_due && !s.radio.supervising.consist_stamp;
}

bool RBC_transition_ordered(const State& s) {
  return s.track.rbc_transition.has_value() || s.handover.order.has_value();
}

/// 5.21.2.2 S0 and 015560 11.2.1, what the mode and standstill say apart.
bool manoeuvre_possible(const State& s) {
  const radio::Session& session = s.radio.supervising.session;
  if (s.srs != SrsVersion::v4_0_0 || !s.manoeuvre.available || s.level.level != Level::L2) return false;
  if (!valid(s.data.level_status) || !session.established() || !radio::knows_manoeuvres(session)) return false;
  if (s.position.status != DataStatus::valid || position::lrbg(s.position) == nullptr) return false;
  if (s.mode == Mode::SB && !valid(s.data.driver_id_status)) return false;
  if (s.mode == Mode::PT && s.emergency_stops.any()) return false;
  return s.mode == Mode::SM || !(RBC_transition_ordered(s) || s.radio.other.session.established());
}

/// What the memory of the unit says.
driver::ActionContext context_of_state(const State& s, const track::Here& here) {
  driver::ActionContext c;
  c.srs = s.srs;
  c.mode = s.mode;
  if (valid(s.data.level_status)) c.level = s.level.level;
  c.standstill = here.standstill;
  c.driver_id_valid = valid(s.data.driver_id_status);
  c.train_data_valid = valid(s.data.train_data_status);
  c.train_running_number_valid = valid(s.data.train_running_number_status);
  c.session_open = s.radio.supervising.session.established();
  c.train_data_acknowledged = s.radio.supervising.knows_train_data();
  c.slow_enough_for_override = run_of(s.position.now).V <= s.national_values.V_NVALLOWOVTRP;
  c.driver_may_change_adhesion = s.national_values.Q_NVDRIVER_ADHES;
  c.driver_id_while_running = s.national_values.M_NVDERUN;
  c.network_offered = !s.network.offered.empty();
  c.track_ahead_free_asked = s.track_ahead_free.asking;
  c.alarm_may_be_inhibited = s.srs == SrsVersion::v4_0_0 && c.level && level_1_2_3(*c.level);
  c.alarm_inhibited = s.antenna_alarm.inhibited.has_value();
  c.consist_in_front = consist_in_front(s);
  c.consist_acknowledged = consist_acknowledged(s);
  c.manoeuvre_possible = manoeuvre_possible(s);
  c.offers = s.offers;
  // What start of mission asks for is offered too (S1, S2, S3, S12, S13).
  const auto asked = [&](Offer offer, Entry entry) { c.offers.add(offer, s.entries.has(entry)); };
  asked(Offer::driver_id, Entry::driver_id);
  asked(Offer::level, Entry::level);
  asked(Offer::rbc_contact, Entry::rbc_contact);
  asked(Offer::train_data, Entry::train_data);
  asked(Offer::train_running_number, Entry::train_running_number);
  c.requests = s.requested;
  c.start_up = s.mode == Mode::SB && s.start_of_mission.step < procedures::start_of_mission::Step::S10;
  return c;
}

}  // namespace

driver::ActionContext action_context(const State& s, const Inputs& in, const track::Here& here) {
  driver::ActionContext c = context_of_state(s, here);
  c.desk_open = in.train.desk_open;
  c.non_leading_signal = in.train.non_leading;
  c.passive_shunting_signal = in.train.passive_shunting;
  // With the selector in position "On" only (4.4.16.1.2).
  c.automatic_driving_asked =
      s.srs == SrsVersion::v4_0_0 && in.automatic_operation.requests_AD && in.automatic_operation.active;
  return c;
}

driver::ButtonContext button_context(const State& s, Set<DriverInput> enabled, const track::Here& here) {
  const radio::Session& session = s.radio.supervising.session;
  driver::ButtonContext c;
  c.action = context_of_state(s, here);
  c.action.desk_open = s.desk_was_open;
  c.action.non_leading_signal = s.NL_was_permitted;
  c.action.passive_shunting_signal = s.displayed.passive_shunting;
  c.action.requests = {};
  c.inputs = s.requested.empty() ? enabled : driver::enabled(c.action);
  c.emergency_stop_pending = s.emergency_stops.any();
  c.position_valid = s.position.status == DataStatus::valid && position::lrbg(s.position) != nullptr;
  c.length_in_range = here.est_front - here.min_safe_rear <= kLongestTold;
  c.cover_stored = !s.balise.covers.empty();
  c.covers_full = s.balise.covers.full();
  c.contact_known = s.radio.contact && s.contact_status != DataStatus::unknown;
  c.network_type = driver::NetworkType::gsmr;
  c.gsmr = {.fitted = true, .registered = s.network.registered};
  c.consist_known = s.manoeuvre.available;
  c.consist_in_front = c.action.consist_in_front;
  c.consist_acknowledged = c.action.consist_acknowledged;
  c.session_above_2_2 = radio::knows_manoeuvres(session);
  c.second_session = s.radio.other.session.established();
  c.RBC_transition_ordered = RBC_transition_ordered(s);
  return c;
}

modes::AvailableLevels available_levels(const State& state, const NationalSystem& national_system) {
  modes::AvailableLevels available;
  available.fitted = state.fitted_levels;
  available.national_systems[0] = national_system.available;
  return available;
}

}  // namespace evc::kernel
