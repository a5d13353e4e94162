#include "radio/session.h"

namespace evc::radio {
namespace {

/// Whether this unit supports the version X (SUBSET-026-6).
bool supported(std::uint8_t M_VERSION) {
  const unsigned X = M_VERSION >> 4;
  return X == 1 || X == 2;
}

void enter(Session& s, Phase phase, Duration now) {
  s.phase = phase;
  s.since = now;
}

void request(Session& s, Duration now, Outbox& out) {
  out.connect = s.rbc;
  s.request_connection = true;
  if (s.tries < 255) ++s.tries;
  // The indication timer starts with the first request of a set-up, but not in start of mission (3.5.7.3).
  if (!s.status_timer && s.cause != Cause::start_of_mission) s.status_timer = now;
}

void connect_to(Session& s, const Rbc& rbc, Cause cause, Duration now, Outbox& out) {
  s.rbc = rbc;
  s.cause = cause;
  s.tries = 0;
  s.M_VERSION = 0;
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
  s.indication = Indication::none;
  if (!s.remembered) return;
  const Rbc next = *s.remembered;
  s.remembered.reset();
  connect_to(s, next, s.remembered_cause, now, out);
}

void release(Session& s, Duration now, Outbox& out) {
  out.disconnect = s.rbc;
  go_idle(s, now, out);
}

void connected(Session& s, Duration now, Outbox& out) {
  s.request_connection = false;
  s.status_timer.reset();
  s.indication = Indication::up;
  if (s.phase == Phase::lost) return enter(s, Phase::up, now);  // the session was kept: no new 155 (3.5.4.2)
  enter(s, Phase::waiting_version, now);
  out.send(message::session_initiated);
}

void attempt_failed(Session& s, bool in_radio_hole, Duration now, Outbox& out) {
  s.request_connection = false;
  if (s.phase == Phase::connecting && s.cause == Cause::start_of_mission && s.tries >= kConnectionTries) {
    go_idle(s, now, out);
    if (s.phase == Phase::idle) s.indication = Indication::failed;
    return;
  }
  if (!in_radio_hole) request(s, now, out);
}

void link_lost(Session& s, bool in_radio_hole, Duration now, Outbox& out) {
  switch (s.phase) {
    case Phase::up:
      enter(s, Phase::lost, now);
      s.tries = 0;
      if (in_radio_hole)
        s.indication = Indication::none;
      else
        request(s, now, out);
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
      out.disconnect = s.rbc;
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
      s.repetitions = 0;
      s.request_connection = false;
      s.status_timer.reset();
      out.send(message::session_terminated);
      return;
  }
}

bool maintain(Session& s, RadioLink link, bool in_radio_hole, Duration now, Outbox& out) {
  if (link == RadioLink::connected && (s.phase == Phase::connecting || s.phase == Phase::lost)) connected(s, now, out);
  if (link == RadioLink::lost || link == RadioLink::refused) link_lost(s, in_radio_hole, now, out);

  if (s.status_timer && now - *s.status_timer > kConnectionStatus) {
    s.indication = Indication::failed;
    s.status_timer.reset();
  }
  switch (s.phase) {
    case Phase::waiting_version:
      if (now - s.since < kVersionWait) break;
      out.disconnect = s.rbc;
      connect_to(s, s.rbc, s.cause, now, out);
      break;
    case Phase::connecting:
      // A request that the bearer has not answered yet continues; after a radio hole a new one starts (3.5.4.4).
      if (!s.request_connection && !in_radio_hole) request(s, now, out);
      break;
    case Phase::lost:
      if (now - s.since > kSessionKept) {
        release(s, now, out);
        s.after_hole = in_radio_hole && s.phase == Phase::idle;
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
      break;
  }
  return false;
}

bool check_version(Session& s, std::uint8_t M_VERSION, Duration now, Outbox& out) {
  if (s.phase != Phase::waiting_version && s.phase != Phase::up) return false;
  s.M_VERSION = M_VERSION;
  if (!supported(M_VERSION)) {
    out.send(message::no_compatible_version);
    out.inform_no_version = true;
    s.phase = Phase::up;  // so that message 156 terminates it
    terminate(s, now, out);
    return false;
  }
  const bool fresh = s.phase == Phase::waiting_version;
  if (fresh) enter(s, Phase::up, now);
  out.send(message::session_established);
  return fresh;
}

void end(Session& s, Duration now, Outbox& out) {
  if (s.phase == Phase::terminating) release(s, now, out);
}

void reconnect(Session& s, Duration now, Outbox& out) {
  if (s.phase != Phase::up) return;
  out.disconnect = s.rbc;
  enter(s, Phase::lost, now);
  s.indication = Indication::none;
  s.tries = 0;
  out.connect = s.rbc;
  s.request_connection = true;
}

}  // namespace evc::radio
