#include "kernel/intake/buffer.h"

#include "kernel/intake/filter.h"
#include "kernel/intake/routes.h"
#include "lang/messages.h"

namespace evc::kernel {
namespace {

/// 4.8.5.3: the newest set takes the place of the oldest one that waits for the same kind of change.
void make_room(State& state, bool accepting, const Log& log) {
  std::size_t sets = 0, oldest = 0;
  for (std::size_t i = state.buffer.size(); i-- > 0;) {
    if (state.buffer[i].accepting != accepting) continue;
    ++sets;
    oldest = i;
  }
  if (sets < kBufferedSetsOfOneCause) return;
  state.buffer.erase(oldest);
  log.note({.what = What::buffer_full, .clause = "4.8.5.3"_srs});
}

Information information_of(const BufferedSet& set) {
  Information information;
  information.medium = set.medium;
  if (set.accepting) information.sender = SessionRole::accepting;
  information.group = set.group;
  information.reference = set.reference;
  information.located = set.medium != Medium::loop;
  information.anchor = set.anchor;
  information.widening = set.widening;
  information.orientation = set.orientation;
  information.min_safe_front = set.min_safe_front;
  information.time = set.received;
  information.judge_packets = set.waiting;
  information.judge_message = set.message_waits;
  return information;
}

/// Whether the packet is part of an authority, its linking or its track description (3.7.1.1).
bool of_authority(const lang::PacketView& view) {
  using enum evc::Information;
  constexpr Set<evc::Information> kOfAuthority{movement_authority,
                                               linking,
                                               gradient,
                                               ssp,
                                               asp,
                                               permitted_braking_distance,
                                               route_suitability,
                                               adhesion,
                                               track_conditions_general,
                                               track_conditions_horn_stopping,
                                               reversing_area,
                                               reversing_supervision};
  const PacketRoute& route = route_of(view);
  if (route.turn == Turn::with_authority) return true;
  for (const evc::Information row : rows_of(route, view))
    if (kOfAuthority.has(row)) return true;
  return false;
}

Waiting evaluate_message(Reception& r, const BufferedSet& set) {
  Information information = information_of(set);
  const lang::MessageToTrainView view = lang::scan_message_to_train(
      {set.bytes.data(), set.size}, session_version(set.M_VERSION, r.state.srs), lang::Check::structure);
  information.message = &view;
  (void)gather(information, view.packets, nullptr);  // as many as when it was received
  drop_superseded(information, nullptr);
  return evaluate(r, information);
}

void gather_telegrams(Information& information, const BufferedSet& set, SrsVersion srs) {
  std::size_t at = 0;
  for (const std::uint16_t bits : set.telegram_bits) {
    const std::size_t length = (bits + 7u) / 8u;
    const lang::TelegramView view =
        lang::scan_telegram({set.bytes.data() + at, length}, bits, lang::Check::structure, lang::newest_version(srs));
    (void)gather(information, view.packets, nullptr);
    at += length;
  }
  drop_superseded(information, nullptr);
}

Waiting evaluate_loop(Reception& r, const BufferedSet& set) {
  Information information = information_of(set);
  const lang::LoopMessageView view = lang::scan_loop_message({set.bytes.data(), set.size}, set.size * std::size_t{8},
                                                             lang::Check::structure, lang::newest_version(r.state.srs));
  (void)gather(information, view.packets, nullptr);
  drop_superseded(information, nullptr);
  return evaluate(r, information);
}

Waiting evaluate_group(Reception& r, const BufferedSet& set) {
  Information information = information_of(set);
  gather_telegrams(information, set, r.state.srs);
  return evaluate(r, information);
}

Waiting evaluate_set(Reception& r, const BufferedSet& set) {
  switch (set.medium) {
    case Medium::balise:
      return evaluate_group(r, set);
    case Medium::loop:
      return evaluate_loop(r, set);
    case Medium::riu:
    case Medium::rbc:
      break;
  }
  return evaluate_message(r, set);
}

}  // namespace

BufferedSet& keep(Reception& r, const Information& information, const Waiting& waiting) {
  State& state = r.state;
  const bool accepting = information.sender == SessionRole::accepting;
  make_room(state, accepting, r.log);
  BufferedSet& set = *state.buffer.grow();  // there is room now
  set.medium = information.medium;
  set.group = information.group;
  set.reference = information.reference;
  set.anchor = information.anchor;
  set.widening = information.widening;
  set.orientation = information.orientation;
  set.min_safe_front = information.min_safe_front;
  set.received = information.time;
  set.waiting = waiting.packets;
  set.of_authority = 0;
  for (std::size_t i = 0; i < information.packets.size(); ++i)
    if (of_authority(information.packets[i])) set.of_authority |= std::uint64_t{1} << i;
  set.message_waits = waiting.message;
  set.accepting = accepting;
  set.M_VERSION = information.M_VERSION;
  set.telegram_bits.clear();
  set.size = 0;
  return set;
}

void add_bits(BufferedSet& set, std::span<const std::uint8_t> bytes) {
  for (std::size_t i = 0; i < bytes.size() && set.size < set.bytes.size(); ++i) set.bytes[set.size++] = bytes[i];
}

void add_telegram(BufferedSet& set, std::span<const std::uint8_t> bytes, std::uint16_t bits) {
  add_bits(set, bytes);
  (void)set.telegram_bits.push_back(bits);  // at most eight
}

void release_buffer(Reception& r) {
  State& s = r.state;
  // The sets are removed first: a set that is buffered again is queued last.
  InplaceVector<BufferedSet, kBufferedSets>& sets = r.scratch.released;
  sets = s.buffer;
  s.buffer.clear();
  for (const BufferedSet& set : sets) {
    const Waiting waiting = evaluate_set(r, set);
    if (!waiting.any()) continue;
    make_room(s, set.accepting, r.log);
    (void)s.buffer.push_back(set);  // there is room now
    s.buffer.back().waiting = waiting.packets;
    s.buffer.back().message_waits = waiting.message;
  }
}

}  // namespace evc::kernel
