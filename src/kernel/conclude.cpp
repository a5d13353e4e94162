#include "kernel/conclude.h"

#include "driver/driver.h"
#include "kernel/orders.h"
#include "kernel/supervise.h"
#include "modes/active_functions.h"
#include "radio/compose.h"
#include "track/services.h"
#include "track/withdraw.h"

namespace evc::kernel {
namespace {

using modes::Function;

bool valid(DataStatus status) { return status == DataStatus::valid; }

radio::TrainDataReport train_report(const State& s) {
  const train::TrainData& t = s.train;
  radio::TrainDataReport r;
  const track::TrainCategory category = category_of(t);
  r.NC_CDTRAIN = category.NC_CDTRAIN;
  r.NC_TRAIN = category.NC_TRAIN;
  // The RBC must not believe the train shorter or slower than it is: rounded up.
  const auto whole = static_cast<std::uint16_t>(t.L_TRAIN.si);
  r.L_TRAIN = static_cast<double>(whole) < t.L_TRAIN.si ? static_cast<std::uint16_t>(whole + 1) : whole;
  const double steps = t.V_MAXTRAIN.si * 3.6 / 5.0;
  r.V_MAXTRAIN = static_cast<std::uint8_t>(steps + 0.999999);
  r.M_LOADINGGAUGE = static_cast<std::uint8_t>(t.loading_gauge);
  r.M_AXLELOADCAT = category.M_AXLELOADCAT;
  r.M_AIRTIGHT = t.airtight ? 1 : 0;
  for (const train::TractionSystem& system : t.traction_systems)
    (void)r.tractions.push_back({system.M_VOLTAGE, system.NID_CTRACTION});  // both hold eight
  if (valid(s.data.train_running_number_status)) r.NID_OPERATIONAL = s.data.train_running_number;
  return r;
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
  r.M_MODE = M_MODE(s.mode);
  r.M_LEVEL = M_LEVEL(s.level.level);
  r.NID_NTC = s.level.nid_ntc;
  return r;
}

void compose_messages(Cycle& cycle) {
  State& s = cycle.state;
  static_assert(decltype(Outputs::radio_out)::capacity() == radio::Outbox::kMessages);
  if (cycle.outbox.messages.empty()) return;
  if (cycle.outbox.lost) note(cycle, {.what = What::message_not_sent});
  const position::Report report = position::report(s.position, {});
  const radio::PositionReport p = position_report(s, report);
  const radio::TrainDataReport t = train_report(s);
  const radio::OnBoard unit{};
  bool position_sent = false;
  for (const radio::Intent& intent : cycle.outbox.messages) {
    std::array<std::uint8_t, 192> bytes{};
    const std::size_t n = radio::compose(intent, p, t, unit, s.radio.session.M_VERSION, bytes);
    OutgoingMessage message;
    for (std::size_t i = 0; i < n; ++i) (void)message.bytes.push_back(bytes[i]);  // 192 as well
    if (n == 0) continue;
    (void)cycle.out.radio_out.push_back(message);  // as many as the outbox holds
    position_sent = position_sent || radio::reports_position(intent.NID_MESSAGE);
  }
  if (position_sent) position::note_reported(s.position, report);
}

bool in_radio_hole(const Cycle& cycle) {
  for (const track::TrackCondition& t : cycle.state.track.conditions)
    if (t.kind == TrackConditionKind::radio_hole && cycle.here.max_safe_front >= t.from && cycle.here.est_front <= t.to)
      return true;
  return false;
}

/// What the procedures ask to send; MA requests and reports go with the conditions of the radio room.
void send_wishes(Cycle& cycle) {
  State& s = cycle.state;
  using procedures::Send;
  const auto& wishes = cycle.effects.send;
  if (wishes.has(Send::open_session) && s.radio.contact) {
    radio::SessionOrder order;
    order.establish = true;
    order.rbc = *s.radio.contact;
    order.cause = radio::Cause::start_of_mission;
    (void)radio::order(s.radio, order, false, false, s.now, cycle.outbox);
  }
  if (wishes.has(Send::terminate_session)) radio::terminate(s.radio.session, s.now, cycle.outbox);
  if (wishes.has(Send::train_data)) radio::send_train_data(s.radio);
  if (wishes.has(Send::shunting_request)) cycle.outbox.send(message::request_for_shunting);
  if (wishes.has(Send::end_of_mission)) cycle.outbox.send(message::end_of_mission);
  if (cycle.taf_granted) cycle.outbox.send(message::track_ahead_free_granted);
}

position::ReportEvents filtered_events(const Cycle& cycle) {
  const State& s = cycle.state;
  position::ReportEvents e = cycle.report_events;
  const auto in_mode = [&s](Function f) { return modes::active(f, s.mode); };
  e.mode_change = e.mode_change && level_2_or_3(s.level.level) && in_mode(Function::report_mode_change);
  e.level_change = e.level_change && in_mode(cycle.level_changed_by_driver ? Function::report_level_change_driver
                                                                           : Function::report_level_change_trackside);
  e.session_established = s.radio.established_now && in_mode(Function::report_session_established);
  e.error_to_report = !s.radio.errors.empty() && in_mode(Function::report_data_consistency_error);
  e.parameters_active = in_mode(Function::report_rbc_requested) || in_mode(Function::report_every_bg);
  e.standstill_active = in_mode(Function::report_standstill);
  e.borders_active = in_mode(Function::report_level_border_rear);
  return e;
}

/// The report that the rear left the RBC's area is repeated until the RBC ends the session (3.5.5.1 e).
void leave_rbc(Cycle& cycle, bool exit_reported) {
  State& s = cycle.state;
  procedures::leaving_rbc::Inputs in;
  in.now = s.now;
  in.exit_reported = exit_reported;
  in.level_2_or_3 = level_2_or_3(s.level.level);
  in.session_open = s.radio.session.established();
  in.termination_ordered = cycle.termination_ordered;
  const procedures::Effects effects = procedures::leaving_rbc::step(s.leaving_rbc, in);
  cycle.effects |= effects;
  if (effects.send.has(procedures::Send::terminate_session)) radio::terminate(s.radio.session, s.now, cycle.outbox);
}

std::uint8_t request_reasons(Cycle& cycle) {
  State& s = cycle.state;
  std::uint8_t reasons = cycle.ma_request_reasons;
  if (modes::active(Function::ma_request_cyclic, s.mode) && level_2_or_3(s.level.level) && s.radio.ma_request) {
    if (cycle.MA_request_before_perturbation && s.radio.ma_request->T_MAR) reasons |= radio::kBeforePerturbation;
    const auto left = track::time_to_timeout(s.track, s.now);
    if (left && s.radio.ma_request->T_TIMEOUTRQST && *left <= *s.radio.ma_request->T_TIMEOUTRQST)
      reasons |= radio::kBeforeTimeout;
  }
  if (s.track_description_deleted && modes::active(Function::ma_request_td_deleted, s.mode) &&
      level_2_or_3(s.level.level))
    reasons |= radio::kTrackDescriptionDeleted;
  return reasons;
}

RbcAddress address(const radio::Rbc& rbc) { return {rbc.NID_C, rbc.NID_RBC, rbc.NID_RADIO}; }

driver::ShowContext show_context(const Cycle& cycle) {
  const State& s = cycle.state;
  driver::ShowContext c;
  c.mode = s.mode;
  c.desk_open = cycle.in.train.desk_open;
  if (valid(s.data.level_status)) c.level = s.level.level;
  if (s.level_transition.pending && !s.level_transition.pending->to.same_level(s.level))
    c.announced = s.level_transition.pending->to.level;
  c.requests = cycle.effects.requests;
  c.override_active = s.override_.active;
  c.brake_commanded = cycle.out.sb || cycle.out.eb;
  c.radio = s.radio.session.indication == radio::Indication::up       ? driver::RadioStatus::up
            : s.radio.session.indication == radio::Indication::failed ? driver::RadioStatus::lost
                                                                      : driver::RadioStatus::none;
  c.slippery_rail = s.slippery_rail || track::slippery(s.track, cycle.here.est_front, s.train.L_TRAIN);
  c.reversing_possible = cycle.reversing_possible;
  c.track_ahead_free_asked = s.track_ahead_free.asking;
  for (const track::TrackCondition& t : s.track.conditions)
    if (t.kind == TrackConditionKind::tunnel_stopping_area && cycle.here.est_front >= t.from &&
        cycle.here.est_front <= t.to)
      c.tunnel_stopping_area = true;
  for (const track::LevelCrossing& lx : s.track.lx)
    if (lx.unprotected && cycle.here.est_front <= lx.to) c.lx_not_protected = true;
  return c;
}

void show_texts(Cycle& cycle) {
  for (const std::uint8_t id : cycle.texts.shown) {
    const track::Text* text = nullptr;
    for (const track::Text& t : cycle.state.track.texts)
      if (t.id == id) text = &t;
    if (text == nullptr) continue;
    ShownText shown;
    shown.id = id;
    shown.Q_TEXT = text->Q_TEXT;
    shown.length = text->length;
    shown.characters = text->characters;
    (void)cycle.out.texts.push_back(shown);  // six at the most
  }
}

}  // namespace

namespace {

template <class T>
void reset(T& field) {
  field = T{};
}
/// What the elements hold is not read before they are written: 7 KB need not be touched each cycle.
template <class T, std::size_t N>
void reset(InplaceVector<T, N>& list) {
  list.clear();
}
template <class... Fields>
void reset_all(Fields&... fields) {
  (reset(fields), ...);
}

}  // namespace

void begin(Outputs& out) {
  // All members by name: one that is added and not named here does not compile.
  auto& [now, mode, level, nid_ntc, lrbg, est_front, min_safe_front, max_safe_front, v, monitoring, status, V_P, V_W,
         V_SBI, V_EBI, V_MRSP, V_target, V_release, d_target, EOA, SvL, tco, sb, eb, brake_reasons, requests, entries,
         start_offered, texts, symbols, radio_out, radio_connect, radio_disconnect, events] = out;
  reset_all(now, mode, level, nid_ntc, lrbg, est_front, min_safe_front, max_safe_front, v, monitoring, status, V_P, V_W,
            V_SBI, V_EBI, V_MRSP, V_target, V_release, d_target, EOA, SvL, tco, sb, eb, brake_reasons, requests,
            entries, start_offered, texts, symbols, radio_out, radio_connect, radio_disconnect, events);
}

void run_radio(Cycle& cycle) {
  State& s = cycle.state;
  send_wishes(cycle);
  radio::Inputs in;
  in.now = s.now;
  in.link = cycle.in.radio_link;
  in.in_radio_hole = in_radio_hole(cycle);
  in.level_2_or_3 = level_2_or_3(s.level.level);
  in.contact_supervised = in.level_2_or_3 && modes::active(Function::safe_radio_supervision, s.mode);
  in.standstill = cycle.here.standstill;
  in.train_data_valid = valid(s.data.train_data_status) && s.mode != Mode::SL && s.mode != Mode::NL;
  in.contact.T_NVCONTACT = s.national_values.T_NVCONTACT;
  in.contact.M_NVCONTACT = s.national_values.M_NVCONTACT;
  const std::uint16_t due = position::due(s.reports, s.position, filtered_events(cycle), s.train.L_TRAIN);
  leave_rbc(cycle, (due & static_cast<std::uint16_t>(position::Due::border)) != 0);
  in.report_due = due != 0 || cycle.effects.send.has(procedures::Send::position_report);
  in.start_of_mission = cycle.effects.send.has(procedures::Send::start_of_mission_report);
  in.Q_STATUS = Q_STATUS(s.position.status);
  in.reasons = request_reasons(cycle);
  in.NID_LTRBG = cycle.NID_LTRBG;
  const radio::Result r = radio::supervise(s.radio, in, cycle.outbox);
  s.contact_trip = r.trip;
  if (r.session_established) note(cycle, {.what = What::session_established, .clause = "3.5.3.7"_srs});
  if (r.session_lost) note(cycle, {.what = What::session_lost, .clause = "3.5.4"_srs});
  cycle.asked.add(brakes::Cause::T_NVCONTACT, r.service_brake);
  if (r.shorten) {
    if (track::shorten(s.track, track::Situation::i_radio_contact_lost, cycle.here.max_safe_front, cycle.here))
      s.track_description_deleted = true;
    cut_other(s, cycle.here.max_safe_front);
    note(cycle, {.what = What::track_description_shortened, .clause = "3.16.3.4.5"_srs});
  }
  compose_messages(cycle);
  if (cycle.outbox.connect) cycle.out.radio_connect = address(*cycle.outbox.connect);
  if (cycle.outbox.disconnect) cycle.out.radio_disconnect = address(*cycle.outbox.disconnect);
}

void command_brakes(Cycle& cycle) {
  State& s = cycle.state;
  cycle.asked.add(brakes::Cause::trip, s.mode == Mode::TR);
  cycle.asked.add(brakes::Cause::no_power_or_failure,
                  s.mode == Mode::NP || s.mode == Mode::SF || cycle.facts.safety_fault);
  brakes::Context context;
  context.standstill = cycle.here.standstill;
  context.driver_acknowledges = cycle.facts.acknowledged.has(Ack::brake);
  context.new_consistent_message = cycle.new_radio_message;
  context.service_brake_fitted = s.train.service_brake_interface;
  context.traction_cut_off_fitted = s.train.traction_cut_off_interface;
  brakes::Command command = brakes::command(s.brakes, cycle.asked, context);
  if (s.mode == Mode::IS) command = {};  // 4.4.3: isolated from the brakes
  cycle.out.tco = command.tco;
  cycle.out.sb = command.sb;
  cycle.out.eb = command.eb;
  cycle.out.brake_reasons = command.reasons;
  cycle.effects.requests.add(Ack::brake, command.acknowledgement_wanted);
}

void show(Cycle& cycle) {
  State& s = cycle.state;
  Outputs& out = cycle.out;
  out.now = s.now;
  out.mode = s.mode;
  out.level = s.level.level;
  out.nid_ntc = s.level.nid_ntc;
  if (const position::Reference* lrbg = position::lrbg(s.position)) out.lrbg = NidLrbg{lrbg->id.NID_C, lrbg->id.NID_BG};
  out.est_front = position::counter_of(s.position, cycle.here.est_front);
  out.min_safe_front = position::counter_of(s.position, cycle.here.min_safe_front);
  out.max_safe_front = position::counter_of(s.position, cycle.here.max_safe_front);
  out.v = s.position.now.V_est;
  const track::Authority& a = cycle.state.basis.authority;
  if (a.EOA) out.EOA = position::counter_of(s.position, *a.EOA);
  if (a.LOA) out.EOA = position::counter_of(s.position, *a.LOA);
  if (a.SvL) out.SvL = position::counter_of(s.position, *a.SvL);
  const driver::Show shown = driver::show(show_context(cycle));
  out.symbols = shown.symbols;
  out.requests = cycle.effects.requests;
  out.entries = cycle.effects.entries;
  out.start_offered = cycle.effects.offers.has(Offer::start);
  show_texts(cycle);
  s.requested = cycle.effects.requests;
  s.offers = cycle.effects.offers;
  s.entries = cycle.effects.entries;
}

}  // namespace evc::kernel
