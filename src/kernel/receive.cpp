#include "kernel/receive.h"

#include "kernel/information.h"
#include "kernel/orders.h"
#include "lang/decode.h"
#include "lang/instances.h"
#include "lang/messages.h"
#include "lang/si.h"
#include "modes/active_functions.h"
#include "protection/authority.h"
#include "track/services.h"

namespace evc::kernel {
namespace {

bool judged_by_crossing(Mode mode) { return mode == Mode::SL || mode == Mode::PS || mode == Mode::SH; }

/// Modes in which an inconsistent message does not brake (4.4.6.1.12, 4.4.14.1.9, 4.4.15.1.10, 4.4.18.1.10,
/// 4.4.20.1.15).
bool brakes_on_message_error(Mode mode) {
  return modes::active(modes::Function::bg_msg_consistency_unlinked, mode) && mode != Mode::SL && mode != Mode::PT &&
         mode != Mode::NL && mode != Mode::RV && mode != Mode::PS;
}

/// 3.14.3.6: what is read during a movement that reverse movement protection forbids is ignored. In PT and RV the
/// permitted direction is backward.
bool moves_against_permission(const State& s) {
  if (!modes::active(modes::Function::reverse_movement, s.mode)) return false;
  const bool backward_permitted = s.mode == Mode::PT || s.mode == Mode::RV;
  return position::motion(s.position) == (backward_permitted ? position::Motion::forward : position::Motion::backward);
}

balise::Situation situation_of(const Cycle& cycle) {
  const State& s = cycle.state;
  balise::Situation now;
  now.now = s.now;
  now.linking_checked = modes::active(modes::Function::link_consistency, s.mode);
  now.braking_on_message_error = brakes_on_message_error(s.mode);
  now.against_permitted_movement = moves_against_permission(s);
  now.counter_rises = position::counter_rises(s.position);
  now.level_1_2_3 = level_1_2_3(s.level.level);
  return now;
}

void react(Cycle& cycle, const balise::Outcome& outcome) {
  State& s = cycle.state;
  bool linking = false;
  bool two_missed = false;
  for (const balise::Event& e : outcome.events) {
    // The contents of the group are logged where they are evaluated.
    if (e.what == What::group_accepted) continue;
    note(cycle, {.what = e.what, .id = e.id.NID_BG, .clause = e.clause});
    if (e.report != balise::ErrorReport::none && level_2_or_3(s.level.level))
      radio::report_error(s.radio, static_cast<std::uint8_t>(e.report));
    linking = linking || e.what == What::linking_error_early || e.what == What::linking_error_missed ||
              e.what == What::linking_error_later;
    two_missed = two_missed || e.what == What::double_linking_error;
  }
  if (outcome.reaction == Reaction::trip) cycle.facts.linking_reaction_trip = true;
  if (outcome.reaction == Reaction::service_brake) {
    cycle.asked.add(two_missed ? brakes::Cause::two_groups_missed
                    : linking  ? brakes::Cause::linking
                               : brakes::Cause::balise_group_consistency);
    s.shorten_at_standstill = s.shorten_at_standstill || outcome.shorten_at_standstill;
  }
  if (outcome.wrong_direction) cycle.facts.linked_group_wrong_direction = true;
  if (outcome.version_too_high) cycle.facts.telegram_version_too_high = true;
}

/// The group becomes the LRBG, or at least the reference of its own information.
const position::Reference* locate(Cycle& cycle, const balise::Group& group) {
  State& s = cycle.state;
  position::Passage passage;
  passage.id = group.id;
  passage.counter = group.counter;
  passage.L_antenna = s.train.L_antenna_front;
  passage.link_place = group.link_place;
  passage.Q_LOCACC = group.Q_LOCACC ? *group.Q_LOCACC : s.national_values.Q_NVLOCACC;
  passage.counter_against_group = group.counter_against_group;
  passage.single = group.single;
  if (group.lrbg_compliant) {
    (void)position::relocate(s.position, passage);
    // The release speed calculated on board counts with the accuracy of the LRBG (3.13.9.4.8.2).
    if (s.basis.authority.release.kind == track::Release::Kind::on_board) ++s.revision;
    cycle.report_events.new_lrbg = true;
    return position::lrbg(s.position);
  }
  (void)position::refer_to_unlinked(s.position, passage);
  return s.position.unlinked ? &*s.position.unlinked : nullptr;
}

void check_lists(Cycle& cycle, GroupId id) {
  State& s = cycle.state;
  const auto named = [id](const track::GroupList& list) {
    for (const GroupId& g : list)
      if (g == id) return true;
    return false;
  };
  if (s.mode == Mode::SR && s.track.sr_list) {
    if (named(*s.track.sr_list))
      cycle.facts.group_passed_in_SR_list = true;
    else
      cycle.facts.group_passed_not_in_SR_list = true;
  }
  if (s.mode == Mode::SH && s.track.sh_list && !named(*s.track.sh_list)) cycle.facts.group_passed_not_in_SH_list = true;
}

void keep(State& state, const BufferedSet& set) {
  // 4.8.5.3: the newest set takes the place of the oldest.
  if (state.buffer.full()) state.buffer.erase(0);
  (void)state.buffer.push_back(set);
}

/// Packets of a released set that are buffered again are queued last.
void keep_again(State& state, const BufferedSet& set, const Waiting& waiting) {
  if (!waiting.any()) return;
  BufferedSet again = set;
  again.waiting = waiting.packets;
  again.message_waits = waiting.message;
  keep(state, again);
}

BufferedSet set_of(const Information& information, const Waiting& waiting, const State& state) {
  BufferedSet set;
  set.medium = information.medium;
  set.group = information.group;
  set.reference = information.reference;
  set.orientation = information.orientation;
  set.min_safe_front = information.min_safe_front;
  set.received = information.time;
  set.waiting = waiting.packets;
  set.message_waits = waiting.message;
  set.M_VERSION = state.radio.session.M_VERSION;
  return set;
}

/// The packets that count for the train's direction, in the order of reading; the bytes behind them must outlive them.
/// False when there are more than there is room for.
bool gather(Information& information, const lang::PacketViews& packets) {
  for (const lang::PacketView& p : packets)
    if (track::valid_direction(p.Q_DIR, information.orientation) && !information.packets.push_back(p)) return false;
  return true;
}

/// Packets of version 1.0 that others of the same message stand in for are ignored (6.6.3.2.3 [9], [11], [13]).
void drop_superseded(Information& information) {
  const lang::Superseding newer = lang::superseding_in({information.packets.begin(), information.packets.size()});
  information.packets.erase_if([&](const lang::PacketView& p) { return newer.drops(p); });
}

/// A group whose telegrams hold more packets together than the unit takes is treated as one whose message is not
/// consistent (3.16.2.4.4): nothing of it is used.
void refuse_group(Cycle& cycle, GroupId id) {
  State& s = cycle.state;
  note(cycle, {.what = What::group_too_many_packets, .id = id.NID_BG, .clause = "3.16.2.4.4"_srs});
  if (!brakes_on_message_error(s.mode)) return;
  cycle.asked.add(brakes::Cause::balise_group_consistency);
  s.shorten_at_standstill = true;
}

/// The trip by a balise group in release speed monitoring (3.13.10.2.6 b of 4.0.0).
void check_group_at_EOA(Cycle& cycle, const balise::Group& group) {
  const State& s = cycle.state;
  const bool in_RSM = s.supervision.active && s.supervision.monitoring == Monitoring::RSM;
  if (s.srs != SrsVersion::v4_0_0 || !in_RSM || !level_2_or_3(s.level.level)) return;
  if (!group.announced || !group.link_place || !group.Q_LOCACC) return;
  if (protection::group_trips(s.basis.authority, *group.link_place - *group.Q_LOCACC, s.train.L_antenna_front))
    cycle.facts.group_at_eoa_in_RSM = true;
}

void receive_group(Cycle& cycle, const balise::Group& group) {
  State& s = cycle.state;
  check_group_at_EOA(cycle, group);
  if (!group.accepted) return;
  // Before the group is located: its default accuracy is that of its own country (3.18.2.5).
  leave_area(cycle, group.id.NID_C);
  const position::Reference* reference = locate(cycle, group);
  if (reference == nullptr) return;
  cycle.here = here(s);
  balise::keep_covers_of(s.balise, group.id.NID_C);
  track::note_group(s.track, group.id, reference->place);
  check_lists(cycle, group.id);
  note(cycle, {.what = What::group_accepted, .id = group.id.NID_BG});

  Information information;
  information.medium = Medium::balise;
  information.group = group.id;
  information.reference = reference->place;
  information.orientation = judged_by_crossing(s.mode) ? group.crossing : reference->orientation;
  information.min_safe_front = cycle.here.min_safe_front;
  information.time = s.now;
  for (const balise::Telegram& t : group.telegrams) {
    if (!t.used) continue;
    const lang::TelegramView view = lang::scan_telegram(t.span(), t.bits, lang::Check::structure);
    information.sv = view.sv;
    if (!gather(information, view.packets)) return refuse_group(cycle, group.id);
  }
  drop_superseded(information);
  const Waiting waiting = evaluate(cycle, information);
  if (!waiting.any()) return;
  BufferedSet set = set_of(information, waiting, s);
  for (const balise::Telegram& t : group.telegrams) {
    if (!t.used) continue;
    const auto bytes = t.span();
    for (std::size_t i = 0; i < bytes.size(); ++i) set.bytes[set.size + i] = bytes[i];
    set.size = static_cast<std::uint16_t>(set.size + bytes.size());
    (void)set.telegram_bits.push_back(t.bits);  // at most eight
  }
  keep(s, set);
}

void take(Cycle& cycle, const balise::Outcome& outcome) {
  react(cycle, outcome);
  for (const balise::Group& group : outcome.groups) receive_group(cycle, group);
}

lang::SystemVersion session_version(const State& state) {
  const std::uint8_t M_VERSION = state.radio.session.M_VERSION;
  return M_VERSION == 0 ? lang::SystemVersion{2, 1} : lang::system_version(M_VERSION);
}

/// Reference and orientation of a radio message: its NID_LRBG among those remembered (3.6.2.2.2 c).
bool refer(Information& information, const State& state, const lang::MessageToTrainView& view) {
  const auto id = lang::group(view.NID_LRBG);
  if (!id) {
    // LRBG unknown (3.6.2.2.2.3): only what needs no place can be used; distances count from the front end.
    information.reference = position::front(state.position).est;
    information.orientation = Direction::unknown;
    return true;
  }
  information.group = {id->NID_C, id->NID_BG};
  const position::Reference* reference = position::find(state.position, information.group);
  if (reference == nullptr) return false;
  information.reference = reference->place;
  information.orientation = reference->orientation;
  return true;
}

/// Message 33 counts from a point D_REF away from the LRBG (3.6.3.2.5).
void shift_reference(Information& information, const lang::MessageToTrainView& view) {
  if (view.NID_MESSAGE != message::movement_authority_shifted) return;
  lang::Message33 m;
  if (lang::decode(view, m) != lang::Fault::none) return;
  const Distance d = lang::metres(m.Q_SCALE, m.D_REF);
  information.reference =
      information.orientation == Direction::reverse ? information.reference - d : information.reference + d;
}

void evaluate_radio(Cycle& cycle, const lang::MessageToTrainView& view, std::span<const std::uint8_t> bytes) {
  State& s = cycle.state;
  Information information;
  information.medium = Medium::rbc;
  information.sv = view.sv;
  information.message = &view;
  information.min_safe_front = cycle.here.min_safe_front;
  information.time = s.now;
  // 3.8.4.2.1: timers count from the time stamp of the message.
  if (lang::seconds(view.T_TRAIN)) information.time = radio::time_of(view.T_TRAIN.raw, s.now);
  if (!refer(information, s, view)) {
    note(cycle, {.what = What::message_refused, .id = view.NID_MESSAGE, .clause = "3.6.2.2.2"_srs});
    return;
  }
  shift_reference(information, view);
  (void)gather(information, view.packets);  // a message has no more than there is room for
  drop_superseded(information);
  const Waiting waiting = evaluate(cycle, information);
  if (!waiting.any()) return;
  BufferedSet set = set_of(information, waiting, s);
  for (std::size_t i = 0; i < bytes.size() && i < set.bytes.size(); ++i) set.bytes[i] = bytes[i];
  set.size = static_cast<std::uint16_t>(bytes.size());
  keep(s, set);
}

void receive_message(Cycle& cycle, std::span<const std::uint8_t> bytes) {
  State& s = cycle.state;
  const lang::MessageToTrainView view = lang::scan_message_to_train(bytes, session_version(s));
  if (view.fault == lang::Fault::unknown_message && lang::is_later(view.sv)) {
    note(cycle, {.what = What::message_unknown, .id = view.NID_MESSAGE, .clause = "3.17.3.11"_srs});
    return;
  }
  if (view.fault != lang::Fault::none || bytes.size() > 1024) {
    radio::receive_inconsistent(s.radio);
    note(cycle, {.what = What::message_rejected, .id = view.NID_MESSAGE, .clause = "3.16.3.1.1"_srs});
    return;
  }
  radio::Header header{view.NID_MESSAGE, view.T_TRAIN.raw, view.M_ACK.raw == 1, view.NID_LRBG.raw};
  // 40 and 41 of an old RBC may carry any LRBG (6.6.3.3.2).
  if (view.sv.x == 1 && (view.NID_MESSAGE == message::train_rejected || view.NID_MESSAGE == message::train_accepted))
    header.NID_LRBG = radio::kUnknownLrbg;
  const radio::Rejected rejected = radio::receive(s.radio, header, s.now, cycle.outbox);
  if (rejected != radio::Rejected::no) {
    note(cycle, {.what = What::message_rejected, .id = view.NID_MESSAGE, .clause = radio::clause(rejected)});
    return;
  }
  cycle.new_radio_message = true;
  if (view.NID_MESSAGE == message::trackside_system_version) {
    lang::Message32 m;
    if (lang::decode(view, m) == lang::Fault::none)
      radio::receive_version(s.radio, static_cast<std::uint8_t>(m.M_VERSION.raw), s.now, cycle.outbox);
  }
  evaluate_radio(cycle, view, bytes);
}

}  // namespace

void receive_balises(Cycle& cycle) {
  State& s = cycle.state;
  balise::Outcome outcome;
  for (const BaliseTelegram& t : cycle.in.balise_telegrams) {
    balise::Reading reading;
    reading.bytes = t.bytes;
    reading.bits = t.bits;
    reading.counter = position::reading_at(s.position, t.at);
    reading.antenna = position::antenna_at(s.position, reading.counter, s.train.L_antenna_front);
    balise::read(s.balise, reading, situation_of(cycle), outcome);
    take(cycle, outcome);
  }
  balise::close_overdue(s.balise, s.position.now.counter, situation_of(cycle), outcome);
  take(cycle, outcome);
  balise::expect(s.balise, position::antenna(s.position, s.train.L_antenna_front), situation_of(cycle), outcome);
  take(cycle, outcome);
}

void receive_loops(Cycle& cycle) {
  for (std::size_t i = 0; i < cycle.in.loop_messages.size(); ++i) note(cycle, {.what = What::loop_message_not_used});
}

void receive_radio(Cycle& cycle) {
  for (const RadioMessage& m : cycle.in.radio_messages) receive_message(cycle, m.bytes);
}

void clear_buffer(State& state) { state.buffer.clear(); }

void release_buffer(Cycle& cycle) {
  State& s = cycle.state;
  // Taken out first: a set that has to wait again waits behind.
  const InplaceVector<BufferedSet, kBufferedSets> sets = s.buffer;
  s.buffer.clear();
  for (const BufferedSet& set : sets) {
    Information information;
    information.medium = set.medium;
    information.group = set.group;
    information.reference = set.reference;
    information.orientation = set.orientation;
    information.min_safe_front = set.min_safe_front;
    information.time = set.received;
    information.judge_packets = set.waiting;
    information.judge_message = set.message_waits;
    information.released = true;
    if (set.medium == Medium::rbc) {
      const std::span<const std::uint8_t> bytes{set.bytes.data(), set.size};
      const lang::MessageToTrainView view = lang::scan_message_to_train(
          bytes, set.M_VERSION == 0 ? lang::SystemVersion{2, 1} : lang::system_version(set.M_VERSION),
          lang::Check::structure);
      information.sv = view.sv;
      information.message = &view;
      (void)gather(information, view.packets);  // as many as when it was received
      drop_superseded(information);
      keep_again(s, set, evaluate(cycle, information));
      continue;
    }
    std::size_t at = 0;
    for (const std::uint16_t bits : set.telegram_bits) {
      const std::size_t length = (bits + 7u) / 8u;
      const lang::TelegramView view =
          lang::scan_telegram({set.bytes.data() + at, length}, bits, lang::Check::structure);
      information.sv = view.sv;
      (void)gather(information, view.packets);
      at += length;
    }
    drop_superseded(information);
    keep_again(s, set, evaluate(cycle, information));
  }
}

}  // namespace evc::kernel
