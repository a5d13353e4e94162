#include "kernel/intake/loops.h"

#include "kernel/here.h"
#include "kernel/intake/buffer.h"
#include "kernel/intake/filter.h"
#include "kernel/intake/national_values.h"
#include "lang/decode.h"
#include "lang/packets/packet_13.h"
#include "lang/packets/packet_134.h"
#include "lang/si.h"
#include "terms/packet_numbers.h"

namespace evc::kernel {
namespace {

/// Of the train against the group, in SL, PS and SH too, where packets count by the crossing (3.6.3.1.3.1).
Direction orientation_against(const position::State& position, GroupId group) {
  if (const position::Reference* linked = position::find(position, group)) return linked->orientation;
  const std::optional<position::Reference>& unlinked = position.unlinked;
  return unlinked && unlinked->id == group ? unlinked->orientation : Direction::unknown;
}

/// The distance of packet 13 from one of its groups.
struct FromGroup {
  bool found = false;
  std::optional<Distance> D_SR;  // absent: infinite
};
/// A group without a country has that of the one before (7.5.1.121); `country`: of the first one.
FromGroup distance_from(const lang::Packet13& p, std::uint16_t country, GroupId group) {
  const auto named = [&](const lang::Packet13_groups& entry) {
    if (entry.Q_NEWCOUNTRY.raw == 1) country = entry.NID_C.raw;
    return group == GroupId{country, entry.NID_BG.raw};
  };
  if (named(p.first_groups())) return {true, lang::metres(p.Q_SCALE, p.D_SR)};
  for (const lang::Packet13_groups& entry : p.groups)
    if (named(entry)) return {true, lang::metres(p.Q_SCALE, entry.D_SR)};
  return {};
}

void refuse_SR_distance(Evaluation& e, Clause clause) {
  e.r.log.note({.what = What::packet_refused, .id = packet::sr_distance_from_loop, .clause = clause});
  refuse(e, clause);
}

/// 3.4.5.1.6 of 4.0.0. Up to 3.6.0 the distances of packet 134 are for diagnosis and limit nothing.
void leave_area_of_loop(Reception& r) {
  State& s = r.state;
  if (s.srs != SrsVersion::v4_0_0 || !s.loop) return;
  AnnouncedLoop& loop = *s.loop;
  const PlaceInterval antenna = position::antenna(s.position, L_antenna(s));
  loop.entered = loop.entered || !loop.from || antenna.min >= *loop.from;
  const bool backward = position::last_motion(s.position) == position::Motion::backward;
  const bool outside = backward ? loop.from && antenna.max < *loop.from : loop.to && antenna.min > *loop.to;
  if (!loop.entered || !outside) return;
  r.log.note({.what = What::loop_left, .id = loop.NID_LOOP, .clause = "3.4.5.1.6"_srs});
  s.loop.reset();
}

/// Why a message is ignored as a whole; none where it is not.
Clause refusal(const State& s, const lang::LoopMessageView& view) {
  if (view.fault == lang::Fault::unknown_version) return "3.17.3.6"_srs;  // no reaction
  if (view.fault != lang::Fault::none) return "3.16.1.1"_srs;
  const bool announced =
      s.loop && valid(s.loop->status) && s.loop->NID_C == view.NID_C.raw && s.loop->NID_LOOP == view.NID_LOOP.raw;
  return announced ? Clause{} : "3.4.5.2.1"_srs;
}

void receive_loop(Reception& r, std::span<const std::uint8_t> bytes) {
  State& s = r.state;
  const lang::LoopMessageView view =
      lang::scan_loop_message(bytes, bytes.size() * 8, lang::Check::all, lang::newest_version(s.srs));
  if (const Clause clause = refusal(s, view)) {
    r.log.note({.what = What::loop_refused, .id = view.NID_LOOP.raw, .clause = clause});
    return;
  }
  r.log.note({.what = What::loop_accepted, .id = view.NID_LOOP.raw, .clause = "3.4.5.2.2"_srs});
  Information information;
  information.medium = Medium::loop;
  information.group.NID_C = view.NID_C.raw;
  information.located = false;  // only what follows packet 136 has a reference (3.6.2.3.1)
  information.orientation = s.loop->orientation;
  information.min_safe_front = r.out.here.min_safe_front;
  information.time = s.now;  // 3.8.4.6.5 b
  information.version = SenderVersion{view.sv.x, in_another_country(s, view.NID_C.raw)};
  (void)gather(information, view.packets, &r.log);  // all packets of a message fit
  drop_superseded(information, &r.log);
  const Waiting waiting = evaluate(r, information);
  if (waiting.any()) add_bits(keep(r, information, waiting), bytes);
}

}  // namespace

void take_announcement(Evaluation& e, const lang::PacketView& view, modes::Verdict) {
  State& s = e.r.state;
  lang::Packet134 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  const Information& group = e.information;
  AnnouncedLoop loop;
  loop.NID_C = group.group.NID_C;
  loop.NID_LOOP = p.NID_LOOP.raw;
  const Direction train = orientation_against(s.position, group.group);
  loop.orientation = p.Q_LOOPDIR.raw == 1 ? train : opposite(train);
  loop.anchor = group.anchor;
  loop.from = group.reference;
  const std::optional<Distance> D_LOOP = lang::metres(p.Q_SCALE, p.D_LOOP);
  const std::optional<Distance> L_LOOP = lang::metres(p.Q_SCALE, p.L_LOOP);
  if (D_LOOP && L_LOOP) loop.to = group.reference + *D_LOOP + *L_LOOP;
  // 4.4.11.1.6.7 names the loop, not its announcement.
  if (s.mode == Mode::SR && s.loop && s.loop->NID_C == loop.NID_C && s.loop->NID_LOOP == loop.NID_LOOP) {
    loop.signal = s.loop->signal;
    loop.signal_passed = s.loop->signal_passed;
  }
  s.loop = loop;
}

void take_SR_distance(Evaluation& e, const lang::PacketView& view, modes::Verdict) {
  State& s = e.r.state;
  lang::Packet13 p;
  if (!s.loop || lang::decode(view, p) != lang::Fault::none) return;
  if (s.loop->signal_passed) return refuse_SR_distance(e, "4.4.11.1.6.7"_srs);
  GroupId signal{e.information.group.NID_C, p.NID_BG_MAIN.raw};
  if (p.Q_NEWCOUNTRY_MAIN.raw == 1) signal.NID_C = p.NID_C_MAIN.raw;
  const position::Reference* lrbg = position::lrbg(s.position);
  const FromGroup from = lrbg != nullptr ? distance_from(p, signal.NID_C, lrbg->id) : FromGroup{};
  if (!from.found) return refuse_SR_distance(e, "4.4.11.1.3.1 c"_srs);
  s.loop->signal = signal;
  set_SR_end(s, from.D_SR ? std::optional(lrbg->place + *from.D_SR) : std::nullopt);
  ++s.revision;
}

void note_signal_of_loop(State& state, GroupId group) {
  if (state.mode == Mode::SR && state.loop && state.loop->signal == group) state.loop->signal_passed = true;
}

void receive_loops(Reception& r) {
  leave_area_of_loop(r);
  for (const LoopMessage& m : r.in.loop_messages) receive_loop(r, m.bytes);
}

}  // namespace evc::kernel
