#include "kernel/report/radio.h"

#include "kernel/here.h"
#include "kernel/manoeuvre.h"
#include "kernel/radio_address.h"
#include "kernel/radio_infill.h"
#include "kernel/report/handover.h"
#include "kernel/report/network.h"
#include "kernel/report/sessions.h"
#include "kernel/stored.h"
#include "kernel/train_category.h"
#include "kernel/train_data.h"
#include "modes/active_functions.h"
#include "track/indication.h"
#include "track/services.h"

namespace evc::kernel {
namespace {

using modes::Function;

/// Messages that the procedures require; MA requests and reports follow the conditions of the room `radio`.
void send_wishes(State& s, const Decided& decided, bool desk_open, radio::Outbox& outbox) {
  using procedures::Send;
  for (const track::TextReport& text : decided.texts_to_report)
    for (const radio::Peer peer : radio::kRbcs) {  // 3.12.3.5.2: of a handover the former RBC too
      if (!s.radio.session(peer).rbc.same_id({text.NID_C, text.NID_RBC})) continue;
      const radio::Addressed to(outbox, peer);
      radio::report_text_acknowledged(text.NID_TEXTMESSAGE, outbox);
    }
  const auto& wishes = decided.effects.send;
  if (wishes.has(Send::train_data)) radio::send_train_data(s.radio);
  if (wishes.has(Send::shunting_request)) outbox.send(message::request_for_shunting);
  if (wishes.has(Send::manoeuvre_request)) outbox.send(message::request_for_sm);
  if (wishes.has(Send::end_of_mission)) {  // 3.15.1.3.4.1: to both RBCs
    radio::Intent end;
    end.NID_MESSAGE = message::end_of_mission;
    end.desk_open = desk_open;
    outbox.send(end);
    if (s.radio.other.session.established()) {
      const radio::Addressed to(outbox, radio::Peer::other);
      outbox.send(end);
    }
  }
  if (decided.track_ahead_free_granted) outbox.send(message::track_ahead_free_granted);
}

position::IntegrityEvents supervise_integrity(State& s, const Received& received) {
  if (s.mode == Mode::NL && s.srs == SrsVersion::v4_0_0) {  // 4.4.15.1.3: nothing is reported, whatever is known
    s.integrity = {};
    return {};
  }
  position::IntegrityFacts facts;
  const std::optional<Distance> length = length_to_confirm(s);
  facts.device = received.integrity;
  facts.device_length = received.length_confirmed;
  facts.driver_confirms = received.selected.has(Select::integrity_confirmed);
  facts.train_data_valid = valid(s.data.train_data_status) && !s.manoeuvre.active;  // 3.18.3.9
  facts.length_acknowledged = s.radio.supervising.train_data_acknowledged && !s.train_data_change.pending;
  facts.validated_since = s.radio.supervising.train_data_validated_since;
  facts.session_established = s.radio.supervising.established_now;
  facts.consist_known = !facts.train_data_valid && length.has_value();
  facts.consist_captured = reports_loss_of_consist(s);
  facts.consist_acknowledged = !s.radio.supervising.consist_stamp && !s.radio.supervising.consist_due;
  facts.consist_changed = received.consist_changed;
  facts.turned = received.train_turned;
  facts.L_TRAIN = length.value_or(Distance{});
  return position::supervise(s.integrity, s.position, facts);
}

/// The events of this cycle that are reported in the current mode (4.5.2).
position::ReportEvents events_to_report(const State& s, const Received& received, const Decided& decided,
                                        const position::IntegrityEvents& integrity) {
  position::ReportEvents e;
  const auto in_mode = [&s](Function f) { return modes::activity(f, s.mode, s.srs) == modes::Activity::active; };
  e.mode_change = reports_mode(s, decided);
  e.integrity_confirmed = integrity.confirmed_by_driver && in_mode(Function::report_integrity_confirmed);
  e.integrity_lost = integrity.lost && in_mode(Function::report_integrity_lost);
  e.new_lrbg = received.new_lrbg;
  e.level_change =
      received.level_switched_to && in_mode(received.level_changed_by_driver ? Function::report_level_change_driver
                                                                             : Function::report_level_change_trackside);
  e.session_established = (s.radio.supervising.established_now || s.radio.other.established_now) &&
                          in_mode(Function::report_session_established);
  e.error_to_report = !s.radio.errors.empty() && reports_errors(s);
  e.parameters_active = in_mode(Function::report_rbc_requested);
  e.groups_active = in_mode(Function::report_every_bg);
  e.standstill_active = in_mode(Function::report_standstill);
  e.leaving_active = e.standstill_active && s.srs == SrsVersion::v4_0_0;
  e.borders_active = in_mode(Function::report_level_border_rear);
  return e;
}

/// The report that the rear left the RBC's area is repeated until the RBC ends the session (3.5.5.1 e).
void leave_rbc(State& s, bool exit_reported, bool termination_ordered, procedures::Effects& effects,
               radio::Outbox& outbox) {
  procedures::leaving_rbc::Inputs in;
  in.now = s.now;
  in.exit_reported = exit_reported;
  in.level_2_or_3 = level_2_or_3(s.level.level);
  in.session_open = s.radio.supervising.session.established();
  in.termination_ordered = termination_ordered;
  const procedures::Effects own = procedures::leaving_rbc::step(s.leaving_rbc, in);
  effects |= own;
  if (own.send.has(procedures::Send::terminate_session)) radio::terminate(s.radio.supervising.session, s.now, outbox);
}

std::uint8_t request_reasons(const State& s, const Received& received, const Decided& decided,
                             bool before_perturbation) {
  std::uint8_t reasons = 0;
  if (received.NID_LTRBG) reasons |= radio::kTrackAheadFree;
  if (decided.start_selected) reasons |= radio::kStartSelected;
  if (modes::active(Function::ma_request_cyclic, s.mode) && level_2_or_3(s.level.level) && s.radio.ma_request) {
    if (before_perturbation && s.radio.ma_request->T_MAR) reasons |= radio::kBeforePerturbation;
    const auto left = track::time_to_timeout(s.track, s.now);
    if (left && s.radio.ma_request->T_TIMEOUTRQST && *left <= *s.radio.ma_request->T_TIMEOUTRQST)
      reasons |= radio::kBeforeTimeout;
  }
  if (s.track_description_deleted && modes::active(Function::ma_request_td_deleted, s.mode) &&
      level_2_or_3(s.level.level))
    reasons |= radio::kTrackDescriptionDeleted;
  return reasons;
}

/// The train data that are sent, and whether they are.
void take_train_data(const State& s, radio::Inputs& in) {
  in.train_data_valid = sends_train_data(s);
  in.route_data = route_data(s.train);
}

/// The report of the bearer in this cycle.
void take_link(State& s, const Inputs& inputs, radio::Inputs& in) {
  const bool of_infill_unit = inputs.radio_link_of_infill_unit;
  const auto named = named_rbc(inputs.radio_link_with, of_infill_unit);
  const auto peer = radio::peer_of(s.radio, named, of_infill_unit);
  if (!peer) return;
  // Of the short number only the one that answers or refuses has a name; another one that ends was called before.
  const radio::Session& session = s.radio.session(*peer);
  const bool answered = inputs.radio_link != RadioLink::lost || session.phase != radio::Phase::connecting;
  if (named && !session.rbc.same_id(*named) && !answered) return;
  in.link = inputs.radio_link;
  in.link_of = *peer;
  if (named && !of_infill_unit && in.link == RadioLink::connected) radio::identify(s.radio.session(*peer), *named);
}

/// 3.16.3.4.5 b: a reaction that has begun goes on to standstill where the supervision stops meanwhile, as in a radio
/// hole.
void shorten_for_contact(State& s, bool due, const track::Here& here, Log log) {
  const bool stopped = here.standstill && s.radio.contact_lost && s.brakes.active.has(brakes::Cause::T_NVCONTACT);
  if ((due || stopped) && shorten(s, track::Situation::i_radio_contact_lost, here.max_safe_front, here))
    log.note({.what = What::track_description_shortened, .clause = "3.16.3.4.5"_srs});
}

}  // namespace

RadioResult run_radio(State& s, const Inputs& inputs, const Received& received, const Decided& decided,
                      bool request_before_perturbation, radio::Outbox& outbox, Log log) {
  RadioResult out;
  const Sessions sessions = sessions_of(s);
  out.effects = decided.effects;
  const track::Here& here = decided.here;
  if (s.mode == Mode::NP) {
    end_without_power(s, outbox);
    s.contact_trip = false;
    return out;
  }
  order_sessions(s, received, decided, out.effects, outbox);
  send_wishes(s, decided, inputs.train.desk_open, outbox);
  radio::Inputs in;
  in.now = s.now;
  take_link(s, inputs, in);
  in.in_radio_hole = track::in_radio_hole(s.track);
  in.level_2_or_3 = level_2_or_3(s.level.level);
  in.contact_supervised = in.level_2_or_3 && modes::active(Function::safe_radio_supervision, s.mode);
  in.standstill = here.standstill;
  take_train_data(s, in);
  in.contact.T_NVCONTACT = s.national_values.T_NVCONTACT;
  in.contact.M_NVCONTACT = s.national_values.M_NVCONTACT;
  const position::IntegrityEvents integrity = supervise_integrity(s, received);
  const std::uint16_t due =
      position::due(s.reports, s.position, events_to_report(s, received, decided, integrity), length_of(s));
  const bool rear_left = (due & static_cast<std::uint16_t>(position::Due::border)) != 0;
  const bool left_by_driver = s.srs == SrsVersion::v4_0_0 && received.level_2_or_3_left_by_driver;  // 5.10.3.15.4
  leave_rbc(s, rear_left || left_by_driver, received.termination_ordered, out.effects, outbox);
  if (rear_left && s.srs == SrsVersion::v4_0_0 && !in.level_2_or_3)  // 3.5.3.8 d
    radio::abort_set_ups(s.radio, s.now, outbox);
  const bool border = run_handover(s, here, outbox, log);
  run_radio_infill(s, here, decided.mission_ended, outbox, log);
  in.report_due = due != 0 || border || out.effects.send.has(procedures::Send::position_report);
  in.errors_reported = reports_errors(s);
  in.start_of_mission = out.effects.send.has(procedures::Send::start_of_mission_report);
  in.Q_STATUS = Q_STATUS(position::lrbg(s.position) ? s.position.status : DataStatus::unknown);  // 5.4.3.2 A34
  in.running_number_valid = valid(s.data.train_running_number_status);
  in.running_number_entered = received.entered.has(Entered::train_running_number);
  in.running_number_from = named_rbc(s.data.train_running_number_from);
  in.consist_known = s.manoeuvre.consist.has_value();
  in.consist_due = received.consist_changed && informs_of_consist(s);
  in.in_manoeuvre = s.manoeuvre.active;
  in.reasons = request_reasons(s, received, decided, request_before_perturbation);
  in.NID_LTRBG = received.NID_LTRBG;
  note_contact(s);
  const radio::Result r = radio::supervise(s.radio, in, outbox);
  const bool powered_up = decided.mode_changed && s.previous_mode == Mode::NP;
  out.network = register_terminals(s, powered_up);
  await_registration(s, out.network.has_value() && !powered_up, outbox);
  if (outbox.connect) radio::note_called(s.radio, *outbox.connect);
  s.contact_trip = r.trip;
  complete_handover(s, r, log);
  delete_with_sessions(s, sessions);
  if (r.session_established) log.note({.what = What::session_established, .clause = "3.5.3.7"_srs});
  if (r.session_lost) log.note({.what = What::session_lost, .clause = "3.5.4"_srs});
  out.asked.add(brakes::Cause::T_NVCONTACT, r.service_brake);
  shorten_for_contact(s, r.shorten, here, log);
  return out;
}

}  // namespace evc::kernel
