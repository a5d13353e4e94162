#include "kernel/report/network.h"

#include <algorithm>

namespace evc::kernel {
namespace {

/// The terminals that are in use register later. Whether another one is free.
bool leave_busy_ones(State& s) {
  std::uint8_t busy = 0;
  for (const radio::Peer peer : radio::kPeers) {
    radio::Session& session = s.radio.session(peer);
    const bool called_now = session.phase == radio::Phase::connecting && session.since == s.now;
    if (!session.active() || called_now) continue;  // that call waits for the registration
    session.registers_after = session.connections;
    ++busy;
  }
  return busy < s.terminals;
}

/// Whether a terminal is free that was in use when the network changed; a connection requested since then is another
/// one.
bool one_is_free(State& s) {
  bool is_free = false;
  for (const radio::Peer peer : radio::kPeers) {
    radio::Session& session = s.radio.session(peer);
    if (!session.registers_after) continue;
    if (session.active() && session.connections == *session.registers_after) continue;
    session.registers_after.reset();
    is_free = true;
  }
  return is_free;
}

bool a_session_ends(const radio::State& radio) {
  return std::any_of(radio::kPeers.begin(), radio::kPeers.end(),
                     [&](radio::Peer peer) { return radio.session(peer).phase == radio::Phase::terminating; });
}

}  // namespace

std::optional<std::uint32_t> register_terminals(State& s, bool powered_up) {
  bool ordered = one_is_free(s) || powered_up;
  if (s.network.changed) ordered = leave_busy_ones(s) || ordered;
  if (!ordered) return std::nullopt;
  s.network.ordered = s.now;
  if (s.network.NID_MN) return s.network.NID_MN;
  return s.network.offered.empty() ? port::kDefaultNetwork : s.network.offered[0];  // 3.5.6.3
}

void await_registration(State& s, bool ordered, radio::Outbox& outbox) {
  RadioNetwork& network = s.network;
  const bool was_awaited = network.awaited;
  network.awaited = ordered || (network.awaited && !network.registered);
  // Nothing is left to wait for: the terminal is registered, or the sessions before the list of networks have ended.
  if (!network.awaited && (was_awaited || !a_session_ends(s.radio))) network.by_driver = false;
  if (!network.awaited || !outbox.connect || radio::sessions(s.radio) < s.terminals) return;
  for (const radio::Peer peer : radio::kPeers) {
    radio::Session& session = s.radio.session(peer);
    if (session.phase != radio::Phase::connecting || session.rbc != *outbox.connect) continue;
    radio::withdraw_request(session);
    outbox.connect.reset();
    return;
  }
}

}  // namespace evc::kernel
