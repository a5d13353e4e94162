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
#include "modes/active_functions.h"
#include "radio/compose.h"
#include "track/indication.h"
#include "track/services.h"

namespace evc::kernel {
namespace {

using modes::Function;

radio::TrainDataReport train_report(const State& s, const train::TrainData& t, const NationalSystem& national) {
  radio::TrainDataReport r;
  const track::TrainCategory category = category_of(t);
  r.NC_CDTRAIN = category.NC_CDTRAIN;
  r.NC_TRAIN = category.NC_TRAIN;
  // The reported length and speed must not be too small: rounded up.
  const auto whole = static_cast<std::uint16_t>(t.L_TRAIN.si);
  r.L_TRAIN = static_cast<double>(whole) < t.L_TRAIN.si ? static_cast<std::uint16_t>(whole + 1) : whole;
  const double steps = t.V_MAXTRAIN.si * 3.6 / 5.0;
  r.V_MAXTRAIN = static_cast<std::uint8_t>(steps + 0.999999);
  r.M_LOADINGGAUGE = static_cast<std::uint8_t>(t.loading_gauge);
  r.M_AXLELOADCAT = category.M_AXLELOADCAT;
  r.M_AIRTIGHT = t.airtight ? 1 : 0;
  for (const train::TractionSystem& system : t.traction_systems)
    (void)r.tractions.push_back({system.M_VOLTAGE, system.NID_CTRACTION});  // both hold eight
  for (std::uint8_t NID_NTC = 0; NID_NTC < 64; ++NID_NTC)
    if ((national.available >> NID_NTC & 1u) != 0) (void)r.NID_NTC.push_back(NID_NTC);  // the first eight
  if (t.axles) r.N_AXLE = *t.axles;
  if (valid(s.data.train_running_number_status)) r.NID_OPERATIONAL = s.data.train_running_number;
  return r;
}

/// 6.6.3.4.5 [1b], 6.6.5.3.7 of 4.0.0: level 2 is reported as it was ordered, if the table has an order for level 3
/// before one for level 2.
std::uint8_t M_LEVEL_of(const State& s) {
  if (s.level.level == Level::L2 && s.level_table)
    for (const modes::OrderedLevel& entry : *s.level_table)
      if (entry.level == Level::L2) return M_LEVEL(entry.ordered_as_level_3 ? Level::L3 : Level::L2);
  return M_LEVEL(s.level.level);
}

radio::PositionReport position_report(const State& s, const position::Report& p) {
  radio::PositionReport r;
  r.Q_SCALE = p.Q_SCALE;
  r.NID_LRBG = p.NID_LRBG;
  r.NID_PRVLRBG = p.NID_PRVLRBG;
  r.D_LRBG = p.D_LRBG;
  r.Q_DIRLRBG = p.Q_DIRLRBG;
  r.Q_DLRBG = p.Q_DLRBG;
  r.L_DOUBTOVER = p.L_DOUBTOVER;
  r.L_DOUBTUNDER = p.L_DOUBTUNDER;
  r.Q_LENGTH = p.Q_LENGTH;
  if (p.L_TRAININT) r.L_TRAININT = *p.L_TRAININT;
  r.V_TRAIN = p.V_TRAIN;
  r.Q_DIRTRAIN = p.Q_DIRTRAIN;
  r.standstill = position::at_standstill(s.position);
  r.mode = s.mode;
  r.M_LEVEL = M_LEVEL_of(s);
  r.NID_NTC = s.level.nid_ntc;
  return r;
}

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
  facts.device = received.integrity;
  facts.driver_confirms = received.selected.has(Select::integrity_confirmed);
  facts.train_data_valid = valid(s.data.train_data_status);
  facts.length_acknowledged = s.radio.supervising.train_data_acknowledged && !s.train_data_change.pending;
  facts.validated_since = s.radio.supervising.train_data_validated_since;
  facts.session_established = s.radio.supervising.established_now;
  facts.consist_known = !facts.train_data_valid && s.manoeuvre.available;
  facts.consist_acknowledged = !s.radio.supervising.consist_stamp && !s.radio.supervising.consist_due;
  facts.turned = received.train_turned;
  facts.L_TRAIN = consist_of_train(s) ? length_of(s) : s.train.L_TRAIN;
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
  in.train_data_valid = valid(s.data.train_data_status) && s.mode != Mode::SL && s.mode != Mode::NL;
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

/// 5.21.2.2 A045: the front end with the consist; the default train data, if the mode is not SM.
std::size_t compose_manoeuvre_request(const State& s, const NationalSystem& national, radio::Intent intent,
                                      const radio::OnBoard& unit, std::span<std::uint8_t> bytes) {
  const position::Report report = position::report(s.position, s.integrity, ahead_in_request(s));
  radio::TrainDataReport t = train_report(s, s.manoeuvre.train, national);
  t.consist = s.manoeuvre.consist;
  intent.default_train_data = s.mode != Mode::SM;
  return radio::compose(intent, position_report(s, report), t, unit, s.radio.session(intent.to).M_VERSION, bytes);
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

void compose_messages(State& s, const NationalSystem& national, const radio::Outbox& outbox, Log log, Outputs& out) {
  static_assert(decltype(Outputs::radio_out)::capacity() == radio::Outbox::kMessages);
  if (outbox.messages.empty()) return;
  if (outbox.lost) log.note({.what = What::message_not_sent});
  const position::Report report = position::report(s.position, s.integrity);
  const radio::PositionReport p = position_report(s, report);
  radio::TrainDataReport t = train_report(s, s.train, national);
  if (s.manoeuvre.available) t.consist = s.manoeuvre.consist;
  const radio::OnBoard unit{s.identity.NID_ENGINE,
                            {s.identity.telephone_numbers.begin(), s.identity.telephone_numbers.size()},
                            s.radio.newest};
  bool position_sent = false;
  for (const radio::Intent& intent : outbox.messages) {
    std::array<std::uint8_t, 192> bytes{};
    const radio::Session& session = s.radio.session(intent.to);
    const bool asks_manoeuvre = intent.NID_MESSAGE == message::request_for_sm;
    const std::size_t n = asks_manoeuvre ? compose_manoeuvre_request(s, national, intent, unit, bytes)
                                         : radio::compose(intent, p, t, unit, session.M_VERSION, bytes);
    OutgoingMessage message;
    message.infill_unit = session.rbc.infill_unit;
    if (intent.to != radio::Peer::supervising) message.to = RbcIdentity{session.rbc.NID_C, session.rbc.NID_RBC};
    for (std::size_t i = 0; i < n; ++i) (void)message.bytes.push_back(bytes[i]);  // 192 as well
    if (n == 0) continue;
    (void)out.radio_out.push_back(message);  // as many as fit in the outbox
    const bool to_rbc = !radio::is_infill_unit(intent.to);
    position_sent = position_sent || (to_rbc && radio::reports_position(intent.NID_MESSAGE));
  }
  if (!position_sent) return;
  position::note_reported(s.position, report);
  position::note_reported(s.integrity);
}

}  // namespace evc::kernel
