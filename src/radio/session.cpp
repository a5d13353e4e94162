#include "radio/session.h"

namespace evc::radio {
namespace {

/// Whether a unit with this highest version supports X (SUBSET-026-6).
bool supported(std::uint8_t M_VERSION, lang::SystemVersion newest) {
  const unsigned X = M_VERSION >> 4;
  return X >= 1 && X <= newest.x;
}

/// Message 159 is acknowledged (38) between a unit and a trackside that both know 2.3 (3.5.3.7.4,
/// 6.6.3.4.1.2).
void report_established(Session& s, lang::SystemVersion newest, Duration now, Outbox& out) {
  constexpr lang::SystemVersion kSince{2, 3};
  out.send(message::session_established);
  s.established_repeated = false;
  s.established_report.reset();
  if (newest >= kSince && lang::system_version(s.M_VERSION) >= kSince) s.established_report = now;
}

/// 3.5.3.7.4, 3.5.3.7.4.1: a second report, then a new session.
void await_acknowledgement(Session& s, Duration now, Outbox& out) {
  if (!s.established_report || now - *s.established_report < kAcknowledgementWait) return;
  if (!s.established_repeated) {
    s.established_repeated = true;
    s.established_report = now;
    out.send(message::session_established);
    return;
  }
  s.remembered = s.rbc;
  s.remembered_cause = s.cause;
  terminate(s, now, out);
}

void enter(Session& s, Phase phase, Duration now) {
  s.phase = phase;
  s.since = now;
}

/// Whether the timer of the indication starts with the first request (3.5.7.3): for causes b to e of 3.5.3.4, and when
/// the connection of a session was lost, however that session came about.
bool times_the_indication(const Session& s) {
  if (s.phase == Phase::lost) return true;
  switch (s.cause) {
    case Cause::trackside_order:
    case Cause::mode_report:
    case Cause::driver_level:
    case Cause::radio_hole_end:
      return true;
    case Cause::start_of_mission:
    case Cause::after_loss:
    case Cause::start_without_session:
      break;
  }
  return false;
}

/// Whether the number of requests is limited (3.5.3.7 a). For the report of a mode only 4.0.0 has the limit; without it
/// a start of mission, which waits for the end of the set-up, could not begin out of reach of the RBC.
bool limits_requests(Cause cause) { return cause == Cause::start_of_mission || cause == Cause::mode_report; }

void request(Session& s, Duration now, Outbox& out) {
  s.request_connection = false;
  if (out.connect) return;  // the bearer takes one request in a cycle; this one is made in the next
  out.connect = s.rbc;
  s.request_connection = true;
  if (s.tries < 255) ++s.tries;
  if (!s.status_timer && times_the_indication(s)) s.status_timer = now;
}

void connect_to(Session& s, const Rbc& rbc, Cause cause, Duration now, Outbox& out) {
  s.rbc = rbc;
  s.cause = cause;
  ++s.connections;
  s.tries = 0;
  s.M_VERSION = 0;
  s.established_report.reset();
  s.last_T_TRAIN.reset();
  s.after_hole = false;
  enter(s, Phase::connecting, now);
  request(s, now, out);
}

/// The session is terminated; an order received meanwhile is executed now (3.5.3.4.2).
void go_idle(Session& s, Duration now, Outbox& out) {
  enter(s, Phase::idle, now);
  s.request_connection = false;
  s.status_timer.reset();
  s.last_T_TRAIN.reset();
  s.indication = RadioIndication::none;
  if (!s.remembered) return;
  const Rbc next = *s.remembered;
  s.remembered.reset();
  connect_to(s, next, s.remembered_cause, now, out);
}

void release(Session& s, Duration now, Outbox& out) {
  out.release(s.rbc);
  go_idle(s, now, out);
}

void connected(Session& s, Duration now, Outbox& out) {
  s.request_connection = false;
  s.status_timer.reset();
  s.indication = RadioIndication::up;
  if (s.phase == Phase::lost) return enter(s, Phase::up, now);  // the session was kept: no new 155 (3.5.4.2)
  enter(s, Phase::waiting_version, now);
  out.send(message::session_initiated);
}

void attempt_failed(Session& s, bool in_radio_hole, Duration now, Outbox& out) {
  s.request_connection = false;
  if (s.phase == Phase::connecting && limits_requests(s.cause) && s.tries >= kConnectionTries) {
    const bool shown = s.cause == Cause::start_of_mission;  // condition [1] of 3.5.7.5
    go_idle(s, now, out);
    if (shown && s.phase == Phase::idle) s.indication = RadioIndication::failed;
    return;
  }
  if (!in_radio_hole) request(s, now, out);
}

void link_lost(Session& s, bool in_radio_hole, Duration now, Outbox& out) {
  switch (s.phase) {
    case Phase::up:
      enter(s, Phase::lost, now);
      s.tries = 0;
      if (!in_radio_hole) request(s, now, out);
      return;
    case Phase::waiting_version:  // there is no session yet to keep
      enter(s, Phase::connecting, now);
      return attempt_failed(s, in_radio_hole, now, out);
    case Phase::connecting:
    case Phase::lost:
      return attempt_failed(s, in_radio_hole, now, out);
    case Phase::idle:
    case Phase::terminating:  // the repetitions end by their number
      return;
  }
}

/// 3.5.3.8 g: the set-up ends where a radio hole begins; one begins again at its end (3.5.3.4 e).
void stop_in_hole(Session& s, Duration now, Outbox& out) {
  const bool start_of_mission = s.cause == Cause::start_of_mission;
  release(s, now, out);
  s.after_hole = !start_of_mission && s.phase == Phase::idle;
}

/// The session is terminated by the loss (3.5.4.2.1). The requests go on for a new one (3.5.3.4 f), and with them the
/// indication; in a radio hole they wait for its end.
void lose(Session& s, bool in_radio_hole, Duration now, Outbox& out) {
  const RadioIndication shown = s.indication;
  release(s, now, out);
  if (s.phase != Phase::idle) return;
  s.after_hole = in_radio_hole;
  if (in_radio_hole) return;
  connect_to(s, s.rbc, Cause::after_loss, now, out);
  s.indication = shown;
}

void repeat_termination(Session& s, Duration now, Outbox& out) {
  if (now - s.since < kRepeatAfter) return;
  if (s.repetitions >= kRepetitions) return release(s, now, out);
  ++s.repetitions;
  s.since = now;
  out.send(message::session_terminated);
}

}  // namespace

void establish(Session& s, const Rbc& rbc, Cause cause, Duration now, Outbox& out) {
  switch (s.phase) {
    case Phase::idle:
      return connect_to(s, rbc, cause, now, out);
    case Phase::connecting:
    case Phase::waiting_version:
      if (s.rbc.same_id(rbc)) return;
      out.release(s.rbc);
      return connect_to(s, rbc, cause, now, out);
    case Phase::up:
    case Phase::lost:
      if (s.rbc.same_id(rbc)) return;
      s.remembered = rbc;
      s.remembered_cause = cause;
      return terminate(s, now, out);
    case Phase::terminating:
      s.remembered = rbc;
      s.remembered_cause = cause;
      return;
  }
}

void abort_set_up(Session& s, Duration now, Outbox& out) {
  s.after_hole = false;
  s.remembered.reset();
  if (s.phase == Phase::connecting || s.phase == Phase::waiting_version) release(s, now, out);
}

void terminate(Session& s, Duration now, Outbox& out) {
  s.after_hole = false;
  switch (s.phase) {
    case Phase::idle:
    case Phase::terminating:
      return;
    case Phase::connecting:
    case Phase::waiting_version:
      return release(s, now, out);
    case Phase::up:
    case Phase::lost:
      enter(s, Phase::terminating, now);
      s.established_report.reset();
      s.repetitions = 0;
      s.request_connection = false;
      s.status_timer.reset();
      out.send(message::session_terminated);
      return;
  }
}

bool maintain(Session& s, RadioLink link, bool in_radio_hole, Duration now, Outbox& out) {
  if (in_radio_hole && (s.phase == Phase::connecting || s.phase == Phase::waiting_version)) stop_in_hole(s, now, out);
  if (link == RadioLink::connected && (s.phase == Phase::connecting || s.phase == Phase::lost)) connected(s, now, out);
  if (link == RadioLink::lost || link == RadioLink::refused) link_lost(s, in_radio_hole, now, out);

  if (in_radio_hole && s.phase == Phase::lost) {  // no requests, conditions [3] and [7] of 3.5.7.5
    s.status_timer.reset();
    s.indication = RadioIndication::none;
  }
  if (s.status_timer && now - *s.status_timer > kConnectionStatus) {
    s.indication = RadioIndication::failed;
    s.status_timer.reset();
  }
  switch (s.phase) {
    case Phase::waiting_version:
      if (now - s.since < kVersionWait) break;
      out.release(s.rbc);
      connect_to(s, s.rbc, s.cause, now, out);
      break;
    case Phase::connecting:
      // A request that the bearer has not answered yet continues.
      if (!s.request_connection) request(s, now, out);
      break;
    case Phase::lost:
      if (now - s.since > kSessionKept) {
        lose(s, in_radio_hole, now, out);
        return true;
      }
      if (!s.request_connection && !in_radio_hole) request(s, now, out);
      break;
    case Phase::terminating:
      repeat_termination(s, now, out);
      break;
    case Phase::idle:
      if (s.after_hole && !in_radio_hole) connect_to(s, s.rbc, Cause::radio_hole_end, now, out);
      break;
    case Phase::up:
      await_acknowledgement(s, now, out);
      break;
  }
  return false;
}

bool check_version(Session& s, std::uint8_t M_VERSION, lang::SystemVersion newest, Duration now, Outbox& out) {
  if (s.phase != Phase::waiting_version && s.phase != Phase::up) return false;
  s.M_VERSION = M_VERSION;
  if (!supported(M_VERSION, newest)) {
    out.send(message::no_compatible_version);
    out.inform_no_version = true;
    s.phase = Phase::up;  // so that message 156 terminates it
    terminate(s, now, out);
    return false;
  }
  const bool fresh = s.phase == Phase::waiting_version;
  if (fresh) enter(s, Phase::up, now);
  report_established(s, newest, now, out);
  return fresh;
}

void note_acknowledged(Session& s) { s.established_report.reset(); }

void withdraw_request(Session& s) {
  s.request_connection = false;
  if (s.tries > 0) --s.tries;
  if (s.tries == 0) s.status_timer.reset();  // 3.5.7.3: it runs from the first request
}

void end(Session& s, Duration now, Outbox& out) {
  if (s.phase == Phase::terminating) release(s, now, out);
}

void reconnect(Session& s, Duration now, Outbox& out) {
  if (s.phase != Phase::up) return;
  out.release(s.rbc);
  enter(s, Phase::lost, now);
  s.indication = RadioIndication::none;
  s.tries = 0;
  s.request_connection = false;
  if (out.connect) return;
  out.connect = s.rbc;
  s.request_connection = true;
}

}  // namespace evc::radio
