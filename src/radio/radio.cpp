#include "radio/radio.h"

namespace evc::radio {
namespace {

void supervise_contact(State& s, const Inputs& in, Outbox& out, Result& result) {
  if (s.was_in_hole && !in.in_radio_hole) s.contact_reference = in.now;
  s.was_in_hole = in.in_radio_hole;
  if (in.level_2_or_3 && !s.was_level_2_or_3 && !s.session.established()) s.contact_reference = in.now;
  s.was_level_2_or_3 = in.level_2_or_3;

  if (!in.contact_supervised || in.in_radio_hole || !in.contact.T_NVCONTACT || !s.contact_reference) return;
  const Duration silent = in.now - *s.contact_reference;
  if (!(silent > *in.contact.T_NVCONTACT)) return;
  if (!s.contact_lost) {
    s.contact_lost = true;
    s.contact_brake_released = false;
    report_error(s, 5);
  }
  if (in.contact.M_NVCONTACT == Reaction::trip) result.trip = true;
  if (in.contact.M_NVCONTACT == Reaction::service_brake && !s.contact_brake_released) {
    result.service_brake = !in.standstill;
    result.shorten = in.standstill;
    s.contact_brake_released = in.standstill;
  }
  if (silent > *in.contact.T_NVCONTACT + kContactExtra && !s.reconnected) {
    s.reconnected = true;
    reconnect(s.session, in.now, out);
  }
}

void send_report(State& s, const Inputs& in, Outbox& out) {
  Intent intent;
  intent.NID_MESSAGE = in.start_of_mission ? 157 : 136;
  intent.Q_STATUS = in.Q_STATUS;
  intent.running_number = s.established_now;
  if (!s.errors.empty()) {
    intent.M_ERROR = s.errors.front();
    s.errors.erase(0);
  }
  out.send(intent);
}

void send_ma_request(State& s, const Inputs& in, Outbox& out) {
  std::uint8_t reasons = in.reasons;
  // Without parameters these two criteria do not exist (3.8.2.3 b, c).
  if (!s.ma_request || !s.ma_request->T_MAR) reasons = static_cast<std::uint8_t>(reasons & ~kBeforePerturbation);
  if (!s.ma_request || !s.ma_request->T_TIMEOUTRQST) reasons = static_cast<std::uint8_t>(reasons & ~kBeforeTimeout);
  s.reasons = static_cast<std::uint8_t>(s.reasons & reasons);
  if (s.session.phase != Phase::up) return;  // a reason that waits counts as new when the session is established
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

/// Every message has its own stamp, even two within one 10 ms tick (3.16.3.3.2).
void stamp(State& s, Duration now, Outbox& out) {
  // While there is no connection, messages that are due count as sent (3.5.4.5).
  if (s.session.phase == Phase::lost || s.session.phase == Phase::connecting) out.messages.clear();
  if (s.session.phase == Phase::idle && !out.disconnect) out.messages.clear();
  for (Intent& intent : out.messages) {
    std::uint32_t T_TRAIN = T_TRAIN_of(now);
    if (s.last_sent && !later(T_TRAIN, *s.last_sent)) T_TRAIN = *s.last_sent + 1;
    if (T_TRAIN == kUnknownTime) T_TRAIN = 0;
    intent.T_TRAIN = T_TRAIN;
    s.last_sent = T_TRAIN;
    if (intent.NID_MESSAGE == message::validated_train_data) s.train_data_stamp = T_TRAIN;
    if (intent.NID_MESSAGE == message::request_for_shunting) s.shunting_request_stamp = T_TRAIN;
  }
}

}  // namespace

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

Rejected receive(State& s, const Header& header, Duration now, Outbox& out) {
  if (s.session.phase == Phase::idle || s.session.phase == Phase::connecting) return Rejected::no_session;
  if (s.session.phase == Phase::terminating && header.NID_MESSAGE != message::session_termination_acknowledged)
    return Rejected::terminating;
  if (s.session.phase == Phase::waiting_version && header.NID_MESSAGE != message::trackside_system_version)
    return Rejected::no_session;
  if (header.T_TRAIN == kUnknownTime || (s.session.last_T_TRAIN && !later(header.T_TRAIN, *s.session.last_T_TRAIN))) {
    report_error(s, 4);
    return Rejected::time_stamp;
  }
  s.session.last_T_TRAIN = header.T_TRAIN;
  if (header.NID_MESSAGE == message::session_termination_acknowledged) {
    end(s.session, now, out);
    return Rejected::no;
  }
  s.contact_reference = time_of(header.T_TRAIN, now);
  s.contact_lost = false;
  s.contact_brake_released = false;
  s.reconnected = false;
  if (header.M_ACK) {
    Intent intent;
    intent.NID_MESSAGE = message::acknowledgement;
    intent.T_TRAIN_REF = header.T_TRAIN;
    out.send(intent);
  }
  return Rejected::no;
}

void receive_inconsistent(State& s) { report_error(s, 3); }

void receive_version(State& s, std::uint8_t M_VERSION, Duration now, Outbox& out) {
  if (!check_version(s.session, M_VERSION, now, out)) return;
  s.established_now = true;
  s.train_data_pending = true;
  s.train_data_acknowledged = false;
  s.train_data_stamp.reset();
  s.contact = s.session.rbc;
  s.reasons = 0;
}

void receive_train_data_ack(State& s, std::uint32_t T_TRAIN_REF) {
  // Only the acknowledgement of the latest message 129 counts (4.8.3 [3]).
  if (!s.train_data_stamp || *s.train_data_stamp != T_TRAIN_REF) return;
  s.train_data_stamp.reset();
  s.train_data_acknowledged = true;
}

void report_error(State& s, std::uint8_t M_ERROR) {
  for (const std::uint8_t error : s.errors)
    if (error == M_ERROR) return;
  if (s.errors.full()) s.errors.erase(0);
  (void)s.errors.push_back(M_ERROR);  // there is room now
}

bool order(State& s, const SessionOrder& o, bool sleeping, bool store_only, Duration now, Outbox& out) {
  if (sleeping && !o.sleeping_too) return false;
  Rbc rbc = o.rbc;
  if (rbc.NID_RBC == kLastKnownRbc) {
    if (!s.contact) return false;
    rbc = *s.contact;
  }
  if (!o.establish) {
    const bool idle = s.session.phase == Phase::idle && !s.session.after_hole;
    if (idle || !s.session.rbc.same_id(rbc)) return false;
    terminate(s.session, now, out);
    return true;
  }
  s.contact = rbc;
  if (!store_only) establish(s.session, rbc, o.cause, now, out);
  return true;
}

Result supervise(State& s, const Inputs& in, Outbox& out) {
  Result result;
  const bool was_lost = s.session.phase == Phase::lost;
  const Rbc former = s.session.rbc;
  if (maintain(s.session, in.link, in.in_radio_hole, in.now, out)) {
    result.session_lost = true;
    if (!in.in_radio_hole) establish(s.session, former, Cause::after_loss, in.now, out);
  }
  // In a kept session train data that were not acknowledged are sent again (3.18.3.4.2).
  if (was_lost && s.session.phase == Phase::up && s.train_data_stamp) s.train_data_pending = true;
  supervise_contact(s, in, out, result);
  const bool up = s.session.phase == Phase::up;
  if (up) {
    result.session_established = s.established_now;
    if (s.established_now || in.report_due || !s.errors.empty()) send_report(s, in, out);
    if (s.train_data_pending && in.train_data_valid) {
      s.train_data_pending = false;
      out.send(message::validated_train_data);
    }
  }
  send_ma_request(s, in, out);
  stamp(s, in.now, out);
  if (up) s.established_now = false;
  return result;
}

void send_train_data(State& s) { s.train_data_pending = true; }

}  // namespace evc::radio
