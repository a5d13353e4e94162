#include "kernel/radio_infill.h"

namespace evc::kernel {
namespace {

using radio::Peer;
using radio::Phase;

void end_session(State& s, Peer peer, radio::Outbox& outbox) {
  const radio::Addressed to(outbox, peer);
  radio::abort_set_up(s.radio.session(peer), s.now, outbox);
  radio::terminate(s.radio.session(peer), s.now, outbox);
}

/// The session with this unit, or its set-up, ends.
void end_session(State& s, const radio::Rbc& unit, radio::Outbox& outbox, Log log) {
  s.radio_infill.to_call.erase_if([&](const radio::Rbc& called) { return called.same_id(unit); });
  const std::optional<Peer> peer = radio::infill_unit(s.radio, unit);
  if (!peer) return;
  end_session(s, *peer, outbox);
  log.note({.what = What::session_termination_ordered, .clause = "3.9.3.16"_srs});
}

/// All but one with `kept`.
void end_others(State& s, const radio::Rbc& kept, radio::Outbox& outbox) {
  s.radio_infill.to_call.erase_if([&](const radio::Rbc& unit) { return !unit.same_id(kept); });
  for (const Peer peer : radio::kInfillUnits)
    if (!s.radio.session(peer).rbc.same_id(kept)) end_session(s, peer, outbox);
}

void end_all(State& s, radio::Outbox& outbox) {
  const bool nothing = !s.radio_infill.area && s.radio_infill.to_call.empty();
  if (nothing && !s.radio.session(Peer::infill_1).active() && !s.radio.session(Peer::infill_2).active()) return;
  s.radio_infill = {};
  end_infill_sessions(s, outbox);
}

/// The unit is called now, or when another session has ended.
void order_session(State& s, const radio::Rbc& unit, Log log) {
  if (!s.network.registered) return log.note({.what = What::network_missing, .clause = "3.5.6.8"_srs});
  for (const radio::Rbc& waiting : s.radio_infill.to_call)
    if (waiting.same_id(unit)) return;
  (void)s.radio_infill.to_call.push_back(unit);  // the present area and its neighbour
  log.note({.what = What::session_ordered, .clause = "3.9.3.5"_srs});
}

/// A session that ends is established again when it has ended (3.5.3.4.2); one that is there stays (3.5.3.4.1).
bool call(State& s, const radio::Rbc& unit, radio::Outbox& outbox) {
  std::optional<Peer> peer = radio::infill_unit(s.radio, unit);
  if (!peer && radio::sessions(s.radio) >= s.terminals) return false;
  for (const Peer free : radio::kInfillUnits)
    if (!peer && !s.radio.session(free).active()) peer = free;
  if (!peer) return false;
  const radio::Addressed to(outbox, *peer);
  radio::establish(s.radio.session(*peer), unit, radio::Cause::trackside_order, s.now, outbox);
  return true;
}

/// 3.9.3.5. An order to establish outside level 1 has no session to serve (3.9.3.1).
void execute(State& s, const track::RadioInfillArea& order, radio::Outbox& outbox, Log log) {
  const radio::Rbc unit{order.NID_C, order.NID_RIU, order.NID_RADIO, true};
  if (!order.establish) return end_session(s, unit, outbox, log);
  if (s.level.level != Level::L1) return;
  end_others(s, unit, outbox);
  s.radio_infill.area = RadioInfill::Area{unit, order.next_main_signal, true, false, false};
  order_session(s, unit, log);
}

/// 3.9.3.10. What is due while the connection is lost counts as sent (3.5.4.5); a unit that was not reached before the
/// end of the area is not informed.
void inform(State& s, radio::Outbox& outbox) {
  if (!s.radio_infill.area) return;
  RadioInfill::Area& area = *s.radio_infill.area;
  const std::optional<Peer> peer = radio::infill_unit(s.radio, area.unit);
  const bool established = peer && s.radio.session(*peer).established();
  const bool passed = area.signal_passed && !area.over;
  area.over = area.over || passed;
  if (area.over && area.entry_due) {
    area.entry_due = false;
    return;
  }
  if (!established) return;
  if (area.entry_due) radio::inform_infill_unit(*peer, area.signal, false, outbox);
  if (passed) radio::inform_infill_unit(*peer, area.signal, true, outbox);
  area.entry_due = false;
}

/// RBCs come first where there are fewer mobile terminals than sessions: the neighbour's ends, then that of the area.
void make_way_for_rbc(State& s, radio::Outbox& outbox) {
  std::size_t busy = radio::sessions(s.radio);
  for (const Peer peer : radio::kInfillUnits) busy -= s.radio.session(peer).phase == Phase::terminating ? 1u : 0u;
  if (busy <= s.terminals) return;
  for (const bool of_area : {false, true})
    for (const Peer peer : radio::kInfillUnits) {
      const radio::Session& session = s.radio.session(peer);
      const bool is_of_area = &session == session_of_infill_area(s);
      if (is_of_area != of_area || !session.active() || session.phase == Phase::terminating) continue;
      return end_session(s, peer, outbox);
    }
}

}  // namespace

void end_infill_sessions(State& s, radio::Outbox& outbox) {
  s.radio_infill.to_call.clear();
  for (const Peer peer : radio::kInfillUnits) end_session(s, peer, outbox);
}

void order_neighbour(State& s, const radio::Rbc& unit, bool establish, radio::Outbox& outbox, Log log) {
  if (!establish) return end_session(s, unit, outbox, log);
  if (s.terminals < 2) return;                          // 3.9.3.6.1
  if (radio::infill_unit(s.radio, unit).has_value()) {  // 3.5.3.4.1, .2
    if (!call(s, unit, outbox)) return;
    return log.note({.what = What::session_ordered, .clause = "3.9.3.6"_srs});
  }
  const radio::Session& first = s.radio.session(Peer::infill_1);
  const radio::Session& second = s.radio.session(Peer::infill_2);
  if (first.active() && second.active()) {  // b: that of the present area stays
    const bool keeps_second = session_of_infill_area(s) == &second;
    end_others(s, keeps_second ? second.rbc : first.rbc, outbox);
  }
  order_session(s, unit, log);
}

void note_signal_of_radio_infill(State& s, GroupId group) {
  if (s.radio_infill.area && s.radio_infill.area->signal == group) s.radio_infill.area->signal_passed = true;
}

void run_radio_infill(State& s, const track::Here& here, bool mission_ended, radio::Outbox& outbox, Log log) {
  const bool all_end = s.level.level != Level::L1 || mission_ended;  // 3.9.3.16, 3.5.3.8 b, h
  if (!all_end) inform(s, outbox);                                   // of the end of an area before the next one begins
  if (std::optional<track::RadioInfillArea>& order = s.track.radio_infill; order && here.est_front >= order->at) {
    execute(s, *order, outbox, log);
    order.reset();
  }
  if (all_end) return end_all(s, outbox);
  make_way_for_rbc(s, outbox);
  if (s.network.registered)  // 3.5.6.8
    s.radio_infill.to_call.erase_if([&](const radio::Rbc& unit) { return call(s, unit, outbox); });
  inform(s, outbox);
}

const radio::Session* session_of_infill_area(const State& s) {
  if (!s.radio_infill.area || s.radio_infill.area->over) return nullptr;
  const std::optional<Peer> peer = radio::infill_unit(s.radio, s.radio_infill.area->unit);
  return peer ? &s.radio.session(*peer) : nullptr;
}

}  // namespace evc::kernel
