#include "radio/radio.h"

#include <algorithm>

namespace evc::radio {
namespace {

void supervise_contact(State& s, const Inputs& in, Outbox& out, Result& result) {
  if (s.was_in_hole && !in.in_radio_hole) s.contact_reference = in.now;
  s.was_in_hole = in.in_radio_hole;
  if (in.level_2_or_3 && !s.was_level_2_or_3 && !s.supervising.session.established()) s.contact_reference = in.now;
  s.was_level_2_or_3 = in.level_2_or_3;
  // A reaction that is over does not count for the supervision that begins anew, in level 2 again or behind a radio
  // hole.
  if (!in.contact_supervised || in.in_radio_hole) s.contact_brake_released = false;

  if (!in.contact_supervised || in.in_radio_hole || !in.contact.T_NVCONTACT || !s.contact_reference) return;
  const Duration silent = in.now - *s.contact_reference;
  if (!(silent > *in.contact.T_NVCONTACT)) return;
  if (!s.contact_lost) {
    s.contact_lost = true;
    s.contact_brake_released = false;
    report_error(s, ErrorReport::radio_connection);
  }
  if (in.contact.M_NVCONTACT == Reaction::trip) result.trip = true;
  if (in.contact.M_NVCONTACT == Reaction::service_brake && !s.contact_brake_released) {
    result.service_brake = !in.standstill;
    result.shorten = in.standstill;
    s.contact_brake_released = in.standstill;
  }
  if (silent > *in.contact.T_NVCONTACT + kContactExtra && !s.reconnected) {
    s.reconnected = true;
    reconnect(s.supervising.session, in.now, out);
  }
}

/// A message that counts for the contact (3.16.3.4.1, 3.16.3.4.1.2): one of another RBC can be older than the latest.
void note_contact(State& s, Duration sent) {
  if (s.contact_with_any && s.contact_reference && sent < *s.contact_reference) return;
  s.contact_reference = sent;
  s.contact_lost = false;
  s.contact_brake_released = false;
  s.reconnected = false;
}

/// 3.18.4.5.4: after its entry and after the establishment of the session, but not to the RBC that gave it.
bool number_due(const Partner& p, const Inputs& in) {
  const bool own = !in.running_number_from || !in.running_number_from->same_id(p.session.rbc);
  return p.session.phase == Phase::up && p.running_number_due && in.running_number_valid && own;
}

/// X = 1 has no packet 5: a new number is sent with the train data (6.6.3.4.2). Returns whether a report has to be sent
/// for it.
bool note_running_number(State& s, const Inputs& in) {
  bool report = false;
  for (Partner* p : {&s.supervising, &s.other}) {
    const bool version_1 = p->session.M_VERSION >> 4 == 1;
    if (in.running_number_entered) {
      p->running_number_due = !version_1;
      p->train_data_pending = p->train_data_pending || version_1;
    }
    report = report || (in.running_number_entered && number_due(*p, in));
  }
  return report;
}

/// Train data that are due are part of message 157 from 2.2 on (5.4.3.2 A33, A34; before: 6.6.3.4.3.1).
bool reports_with_train_data(const State& s, Partner& p, const Inputs& in) {
  constexpr lang::SystemVersion kSince{2, 2};
  const bool due = in.start_of_mission && p.train_data_pending && in.train_data_valid;
  if (!due || common_version(s, p.session) < kSince) return false;
  p.train_data_pending = false;
  return true;
}

/// To both RBCs while the unit is connected to both (3.15.1.3.4). Returns whether it went to the other one; while its
/// connection is lost none is due to it.
bool send_report(State& s, const Inputs& in, Outbox& out) {
  Intent intent;
  intent.NID_MESSAGE = in.start_of_mission ? 157 : 136;
  intent.Q_STATUS = in.Q_STATUS;
  const bool supervising = s.supervising.session.phase == Phase::up;
  const bool other = s.other.session.phase == Phase::up;
  if (in.errors_reported && !s.errors.empty() && (supervising || other)) {
    intent.M_ERROR = s.errors.front();
    s.errors.erase(0);
  }
  for (const Peer peer : kRbcs) {
    Partner& p = s.partner(peer);
    if (p.session.phase != Phase::up) continue;
    const Addressed to(out, peer);
    intent.running_number = number_due(p, in);
    p.running_number_due = p.running_number_due && !intent.running_number;
    intent.train_data = reports_with_train_data(s, p, in);
    intent.consist_length = in.start_of_mission && in.consist_known;
    out.send(intent);
  }
  return other;
}

/// A session in this cycle. True when it is lost for good.
bool keep_session(State& s, Peer peer, const Inputs& in, Outbox& out) {
  const Addressed to(out, peer);
  const RadioLink link = in.link_of == peer ? in.link : RadioLink::unchanged;
  return maintain(s.session(peer), link, in.in_radio_hole, in.now, out);
}

/// The session with one RBC, and the train data it awaits.
bool keep(State& s, Peer peer, const Inputs& in, Outbox& out) {
  Partner& p = s.partner(peer);
  const bool was_lost = p.session.phase == Phase::lost;
  const bool lost = keep_session(s, peer, in, out);
  // In a kept session train data that were not acknowledged are sent again (3.18.3.4.2).
  if (was_lost && p.session.phase == Phase::up && p.train_data_stamp) p.train_data_pending = true;
  if (was_lost && p.session.phase == Phase::up && p.consist_stamp) p.consist_due = true;  // 3.18.3.10.2
  return lost;
}

void send_train_data_to(Partner& p, Peer peer, const Inputs& in, Outbox& out) {
  if (p.session.phase != Phase::up || !p.train_data_pending || !in.train_data_valid) return;
  p.train_data_pending = false;
  const Addressed to(out, peer);
  out.send(message::validated_train_data);
}

/// In a manoeuvre it takes the place of train data (3.15.1.3.3, 3.18.3.9): both RBCs are informed.
void send_consist_length(Partner& p, Peer peer, bool due, Outbox& out) {
  p.consist_due = p.consist_due || (due && p.session.established());
  if (!p.consist_due || p.session.phase != Phase::up || !knows_manoeuvres(p.session)) return;
  p.consist_due = false;
  const Addressed to(out, peer);
  out.send(message::safe_consist_length);
}

void send_ma_request(State& s, const Inputs& in, Outbox& out) {
  std::uint8_t reasons = in.reasons;
  // Without parameters these two criteria do not exist (3.8.2.3 b, c).
  if (!s.ma_request || !s.ma_request->T_MAR) reasons = static_cast<std::uint8_t>(reasons & ~kBeforePerturbation);
  if (!s.ma_request || !s.ma_request->T_TIMEOUTRQST) reasons = static_cast<std::uint8_t>(reasons & ~kBeforeTimeout);
  s.reasons = static_cast<std::uint8_t>(s.reasons & reasons);
  // A reason that waits for a session counts as new then; while the connection is lost a request counts as sent
  // (3.5.4.5).
  if (!s.supervising.session.established()) return;
  const bool fresh = (reasons & ~s.reasons) != 0;
  const bool repeatable = (reasons & ~kTrackAheadFree) != 0;
  std::optional<Duration> cycle = kDefaultRequestCycle;
  if (s.ma_request) cycle = s.ma_request->T_CYCRQST;
  const bool again = repeatable && cycle && s.requested_at && in.now - *s.requested_at >= *cycle;
  if (!fresh && !again) return;
  Intent intent;
  intent.NID_MESSAGE = message::ma_request;
  intent.Q_MARQSTREASON = reasons;
  if ((reasons & kTrackAheadFree) != 0 && (s.reasons & kTrackAheadFree) == 0) intent.NID_LTRBG = in.NID_LTRBG;
  out.send(intent);
  s.reasons = reasons;
  s.requested_at = in.now;
}

/// Of more than fit the oldest is forgotten: the RBC, which answers in order, has left it without an answer.
void remember_sent(Partner& p, std::uint32_t T_TRAIN, const RouteData& data) {
  p.train_data_stamp = T_TRAIN;
  if (p.train_data_sent.full()) p.train_data_sent.erase(0);
  (void)p.train_data_sent.push_back({T_TRAIN, data});  // there is room now
}

/// Every message has its own stamp, even two within one 10 ms tick (3.16.3.3.2).
void stamp(State& s, const Inputs& in, Outbox& out) {
  // What answers an earlier request for shunting does not answer the new one, even if this does not leave.
  for (const Intent& intent : out.messages) {
    if (intent.NID_MESSAGE == message::request_for_shunting) s.shunting_request_stamp.reset();
    if (intent.NID_MESSAGE == message::request_for_sm) s.manoeuvre_request_stamp.reset();
  }
  drop_unsent(s, out);
  for (Intent& intent : out.messages) {
    std::uint32_t T_TRAIN = T_TRAIN_of(in.now);
    if (s.last_sent && !later(T_TRAIN, *s.last_sent)) T_TRAIN = *s.last_sent + 1;
    if (T_TRAIN == kUnknownTime) T_TRAIN = 0;
    intent.T_TRAIN = T_TRAIN;
    s.last_sent = T_TRAIN;
    if (intent.NID_MESSAGE == message::validated_train_data || intent.train_data)
      remember_sent(s.partner(intent.to), T_TRAIN, in.route_data);
    if (intent.NID_MESSAGE == message::request_for_shunting) s.shunting_request_stamp = T_TRAIN;
    if (intent.NID_MESSAGE == message::request_for_sm) s.manoeuvre_request_stamp = T_TRAIN;
    if (intent.NID_MESSAGE == message::safe_consist_length) s.partner(intent.to).consist_stamp = T_TRAIN;
  }
}

/// One order to release a connection in a cycle.
void order_bearer(State& s, Outbox& out) {
  for (const Rbc& rbc : out.also_disconnect) (void)s.disconnect_later.push_back(rbc);  // four sessions: there is room
  if (!out.disconnect && !s.disconnect_later.empty()) {
    out.disconnect = s.disconnect_later.front();
    s.disconnect_later.erase(0);
  }
}

}  // namespace

void note_called(State& s, const Rbc& called) {
  if (!called.infill_unit) {
    s.other_called_last = s.other.session.active() && called == s.other.session.rbc;
  } else if (const std::optional<Peer> peer = infill_unit(s, called)) {
    s.infill_called_last = *peer;
  }
}

Clause clause(Rejected rejected) {
  switch (rejected) {
    case Rejected::no:
      return {};
    case Rejected::no_session:
      return "3.5.2.1"_srs;
    case Rejected::terminating:
      return "3.5.5.6"_srs;
    case Rejected::time_stamp:
      return "3.16.3.3.3"_srs;
  }
  return {};
}

Rejected receive(State& s, const Header& header, Duration now, Outbox& out, Peer from) {
  Session& session = s.session(from);
  const Addressed to(out, from);
  if (session.phase == Phase::idle || session.phase == Phase::connecting) return Rejected::no_session;
  if (session.phase == Phase::terminating && header.NID_MESSAGE != message::session_termination_acknowledged)
    return Rejected::terminating;
  if (session.phase == Phase::waiting_version && header.NID_MESSAGE != message::trackside_system_version)
    return Rejected::no_session;
  if (header.T_TRAIN == kUnknownTime || (session.last_T_TRAIN && !later(header.T_TRAIN, *session.last_T_TRAIN))) {
    if (!is_infill_unit(from)) report_error(s, ErrorReport::radio_sequence);
    return Rejected::time_stamp;
  }
  session.last_T_TRAIN = header.T_TRAIN;
  const bool terminated = header.NID_MESSAGE == message::session_termination_acknowledged;
  if (s.contact_with_any ? !is_infill_unit(from) : from == Peer::supervising && !terminated)
    note_contact(s, time_of(header.T_TRAIN, now));
  if (terminated) {
    end(session, now, out);
    return Rejected::no;
  }
  if (header.NID_MESSAGE == message::session_establishment_acknowledged) note_acknowledged(session);
  if (header.M_ACK) {
    Intent intent;
    intent.NID_MESSAGE = message::acknowledgement;
    intent.T_TRAIN_REF = header.T_TRAIN;
    out.send(intent);
  }
  return Rejected::no;
}

void receive_inconsistent(State& s, Peer from) {
  if (s.partner(from).session.established()) report_error(s, ErrorReport::radio_message);
}

lang::SystemVersion common_version(const State& s, const Session& session) {
  if (session.M_VERSION == 0) return lang::kNewest_of_baseline_3;
  return std::min(lang::system_version(session.M_VERSION), s.newest);
}

bool receive_version(State& s, std::uint8_t M_VERSION, Duration now, Outbox& out, Peer from) {
  const Addressed to(out, from);
  if (!check_version(s.session(from), M_VERSION, s.newest, now, out)) return false;
  if (is_infill_unit(from)) return true;
  Partner& p = s.partner(from);
  p.established_now = true;
  p.running_number_due = true;
  p.train_data_pending = true;
  p.train_data_acknowledged = p.train_data_validated_since = false;
  p.train_data_stamp.reset();
  p.train_data_sent.clear();
  p.route_data_acknowledged.reset();
  p.consist_stamp.reset();
  p.consist_due = false;
  if (from == Peer::other) return true;
  if (p.session.rbc != kUnknownRbc) s.contact = p.session.rbc;  // 3.18.4.3.4: of the short number the one that answered
  s.reasons = 0;
  return true;
}

void receive_train_data_ack(Partner& from, std::uint32_t T_TRAIN_REF) {
  for (std::size_t i = 0; i < from.train_data_sent.size(); ++i) {
    if (from.train_data_sent[i].T_TRAIN != T_TRAIN_REF) continue;
    from.route_data_acknowledged = from.train_data_sent[i].data;
    for (std::size_t answered = 0; answered <= i; ++answered) from.train_data_sent.erase(0);
    break;
  }
  // Only the acknowledgement of the latest message 129 counts (4.8.3 [3]).
  if (!from.train_data_stamp || *from.train_data_stamp != T_TRAIN_REF) return;
  from.train_data_stamp.reset();
  from.train_data_acknowledged = true;
  from.train_data_validated_since = from.train_data_validated_since && from.train_data_pending;
}

bool awaits_train_data_acknowledgement(const Partner& p) {
  for (const SentTrainData& sent : p.train_data_sent)
    if (!p.route_data_acknowledged || !(sent.data == *p.route_data_acknowledged)) return true;
  return false;
}

void receive_consist_length_ack(Partner& from, std::uint32_t T_TRAIN_REF) {
  // Only the acknowledgement of the latest message 133 counts (4.8.3 [17]).
  if (from.consist_stamp == T_TRAIN_REF) from.consist_stamp.reset();
}

void report_error(State& s, ErrorReport error) {
  for (const ErrorReport known : s.errors)
    if (known == error) return;
  if (s.errors.full()) s.errors.erase(0);
  (void)s.errors.push_back(error);  // there is room now
}

Result supervise(State& s, const Inputs& in, Outbox& out) {
  Result result;
  for (const Peer peer : kRbcs) result.session_lost = keep(s, peer, in, out) || result.session_lost;
  for (const Peer peer : kInfillUnits)
    if (s.session(peer).active()) result.session_lost = keep_session(s, peer, in, out) || result.session_lost;
  supervise_contact(s, in, out, result);
  const bool new_number = note_running_number(s, in);
  // A session begins with the report, a mission too (6.6.3.4.3.1); later train data are sent before the report of the
  // same cycle, which the RBC then reads with them.
  const bool report = in.report_due || in.start_of_mission || new_number;
  const bool report_first = in.start_of_mission || s.supervising.established_now || s.other.established_now;
  if (report && report_first) result.reported_to_other = send_report(s, in, out);
  for (const Peer peer : kRbcs) send_train_data_to(s.partner(peer), peer, in, out);
  if (report && !report_first) result.reported_to_other = send_report(s, in, out);
  for (const Peer peer : kRbcs) {
    Partner& p = s.partner(peer);
    const bool established_now = p.session.phase == Phase::up && p.established_now;
    const bool accepting = peer == Peer::other && s.other_accepts;
    send_consist_length(p, peer, in.consist_due || (established_now && accepting && in.in_manoeuvre), out);
    result.session_established = result.session_established || established_now;
    p.established_now = p.established_now && !established_now;
  }
  send_ma_request(s, in, out);
  stamp(s, in, out);
  order_bearer(s, out);
  return result;
}

void send_train_data(State& s) { s.supervising.train_data_pending = s.other.train_data_pending = true; }

void note_validated_train_data(State& s) {
  s.supervising.train_data_validated_since = s.other.train_data_validated_since = true;
  send_train_data(s);
}

}  // namespace evc::radio
