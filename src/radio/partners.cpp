#include <utility>

#include "radio/radio.h"

// The sessions with the two RBCs of a handover: which of them an order or an input concerns (3.5.3.5, 3.15.1).
namespace evc::radio {

std::optional<Peer> infill_unit(const State& s, const Rbc& unit) {
  for (const Peer peer : kInfillUnits)
    if (s.session(peer).active() && s.session(peer).rbc.same_id(unit)) return peer;
  return std::nullopt;
}

std::size_t sessions(const State& s) {
  std::size_t n = 0;
  for (const Peer peer : kPeers) n += s.session(peer).active() ? 1u : 0u;
  return n;
}

std::optional<Peer> peer_of(const State& s, const std::optional<Rbc>& named, bool infill) {
  if (infill) return named ? infill_unit(s, *named) : s.infill_called_last;
  if (!named) return s.other_called_last && s.other.session.active() ? Peer::other : Peer::supervising;
  if (s.supervising.session.rbc.same_id(*named)) return Peer::supervising;
  if (s.other.session.rbc.same_id(*named)) return Peer::other;
  // The one that answers the short number.
  const Session& called = s.supervising.session;
  if (called.active() && called.rbc == kUnknownRbc) return Peer::supervising;
  return std::nullopt;
}

void identify(Session& session, const Rbc& answered) {
  if (session.rbc == kUnknownRbc) session.rbc = {answered.NID_C, answered.NID_RBC, kStoredNumber};
}

void call_short_number(State& s, Cause cause, Duration now, Outbox& out) {
  establish(s.supervising.session, kUnknownRbc, cause, now, out);
  const Addressed to_other(out, Peer::other);
  terminate(s.other.session, now, out);
}

SessionRole role_of(const State& s, Peer peer) {
  if (peer == Peer::supervising) return SessionRole::supervising;
  return s.other_accepts ? SessionRole::accepting : SessionRole::handing_over;
}

namespace {

/// The session that was to follow one that is being terminated is not ordered any more. Whether there was one.
bool forget_remembered(State& s, const Rbc& rbc) {
  bool dropped = false;
  for (const Peer peer : kRbcs) {
    std::optional<Rbc>& next = s.partner(peer).session.remembered;
    if (!next || !next->same_id(rbc)) continue;
    next.reset();
    dropped = true;
  }
  return dropped;
}

}  // namespace

bool order(State& s, const SessionOrder& o, bool sleeping, bool store_only, Duration now, Outbox& out) {
  if (sleeping && !o.sleeping_too) return false;
  Rbc rbc = o.rbc;
  if (rbc.NID_RBC == kLastKnownRbc) {
    if (!s.contact) return false;
    rbc = *s.contact;
  }
  const bool with_other = s.other.session.active() && s.other.session.rbc.same_id(rbc);
  const Peer peer = with_other ? Peer::other : Peer::supervising;
  Session& session = s.partner(peer).session;
  const Addressed to(out, peer);
  if (!o.establish) {
    const bool dropped = forget_remembered(s, rbc);
    if (!session.active() || !session.rbc.same_id(rbc)) return dropped;
    terminate(session, now, out);
    return true;
  }
  if (with_other) {  // 3.5.3.5.2.1
    if (!store_only) establish(session, rbc, o.cause, now, out);
    return true;
  }
  s.contact = rbc;
  if (store_only) return true;
  const bool new_rbc = !session.active() || !session.rbc.same_id(rbc);
  establish(session, rbc, o.cause, now, out);
  if (!new_rbc) return true;
  const Addressed to_other(out, Peer::other);
  terminate(s.other.session, now, out);
  return true;
}

void call_accepting(State& s, const Rbc& accepting, Duration now, Outbox& out) {
  const Addressed to(out, Peer::other);
  // 3.15.1.3.2.3: the former RBC, that is to supervise again, has a new session for it.
  if (!s.other_accepts && s.other.session.rbc.same_id(accepting)) terminate(s.other.session, now, out);
  s.other_accepts = true;
  establish(s.other.session, accepting, Cause::trackside_order, now, out);
}

void exchange(State& s, Duration now) {
  std::swap(s.supervising, s.other);
  s.exchange_due = false;
  s.other_accepts = false;
  s.other_called_last = !s.other_called_last;
  const std::optional<std::uint32_t> last = s.supervising.session.last_T_TRAIN;
  s.contact_reference = last ? time_of(*last, now) : now;
  s.contact_lost = s.contact_brake_released = s.reconnected = s.contact_with_any = false;
  s.shunting_request_stamp.reset();
  s.reasons = 0;
}

void supervise_contact_with_any(State& s, Duration now) {
  s.contact_with_any = true;
  const std::optional<std::uint32_t> last = s.other.session.last_T_TRAIN;
  if (last && (!s.contact_reference || time_of(*last, now) > *s.contact_reference))
    s.contact_reference = time_of(*last, now);
}

void terminate_all(State& s, Duration now, Outbox& out) {
  for (const Peer peer : kRbcs) {
    const Addressed to(out, peer);
    terminate(s.partner(peer).session, now, out);
  }
}

void abort_set_ups(State& s, Duration now, Outbox& out) {
  for (const Peer peer : kRbcs) abort_set_up(s.partner(peer).session, now, out);
}

namespace {

/// Whether the session ends in this cycle: what was due before its message 156 is still sent.
bool ends_now(const Session& session, Peer peer, const Outbox& out) {
  if (session.repetitions != 0) return false;
  for (const Intent& intent : out.messages)
    if (intent.to == peer && intent.NID_MESSAGE == message::session_terminated) return true;
  return false;
}

/// While there is no connection, messages that are due count as sent (3.5.4.5). Before the session is established only
/// its initiation is sent (3.5.3.7), after message 156 nothing but its repetitions (3.5.5.3). `terminated`: 156 was
/// sent.
bool reaches(const Session& session, std::uint8_t NID_MESSAGE, bool& terminated) {
  switch (session.phase) {
    case Phase::up:
      return true;
    case Phase::waiting_version:
      return NID_MESSAGE == message::session_initiated;
    case Phase::lost:
    case Phase::connecting:
      return false;
    case Phase::idle:
    case Phase::terminating:
      break;
  }
  const bool ends = NID_MESSAGE == message::session_terminated;
  const bool sent = ends || !terminated;
  terminated = terminated || ends;
  return sent;
}

}  // namespace

void drop_unsent(const State& s, Outbox& out) {
  if (out.messages.empty()) return;
  std::array<bool, kPeers.size()> terminated{};
  for (const Peer peer : kPeers) terminated[static_cast<std::size_t>(peer)] = !ends_now(s.session(peer), peer, out);
  out.messages.erase_if([&](const Intent& intent) {
    return !reaches(s.session(intent.to), intent.NID_MESSAGE, terminated[static_cast<std::size_t>(intent.to)]);
  });
}

}  // namespace evc::radio
