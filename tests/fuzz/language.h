#pragma once
#include <array>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <type_traits>

#include "io/telegram_explain.h"
#include "io/telegram_json.h"
#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/layouts.h"
#include "lang/packets.h"
#include "lang/translate.h"
#include "lang/walk.h"
#include "terms/packet_numbers.h"

// Properties of every reader of the language for any bits: no crash, reading and writing give the same bits, the fast
// reader and the bit-by-bit one agree.
namespace evc::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

/// Reading is checked for every input. The JSON form and the page of --explain take fifty times as long: one input in
/// 16, selected by a hash of its bytes so that the same input is always checked in the same way.
inline bool is_selected(std::span<const std::uint8_t> bytes) {
  std::uint32_t hash = 2166136261;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 16777619;
  return hash >> 28 == 0;
}

/// The verdict of the bit-by-bit reader on the contents of a packet.
struct SpareFinder {
  bool spare = false;
  void field(const lang::Step& step, std::uint64_t code, std::size_t) {
    spare = spare || (step.is_spare != nullptr && step.is_spare(code));
  }
  void begin_group(const lang::Step&, std::uint64_t, std::size_t) {}
  void begin_element(std::uint64_t) {}
  void end_element() {}
  void end_group() {}
  void rest(const lang::Step&, std::size_t, std::size_t) {}
};

inline std::uint64_t nid_of(const lang::PacketView& view) {
  return BitReader(view.bytes, view.bytes.size() * 8, view.bit).read_bit_by_bit(8);
}
template <class P>
std::uint8_t packet_direction(const P& packet) {
  if constexpr (requires { packet.Q_DIR; }) return packet.Q_DIR.raw;
  return 2;
}

/// What was translated has values without a code: Q_DIFF of a packet 27 by the train (6.6.3.2.3 [3]), written as 2, and
/// the country of a packet 3 that names none, written as 0.
template <class P>
void give_codes(P& packet) {
  if constexpr (std::is_same_v<P, lang::Packet27>) {
    const auto give = [](auto& diffs) {
      for (auto& diff : diffs)
        if (diff.Q_DIFF.raw == lang::kQ_DIFF_by_train) diff.Q_DIFF.raw = 2;
    };
    give(packet.diffs);
    for (auto& step : packet.steps) give(step.diffs);
  }
  // Text conditions of 2.2 and later for AD and SM: 2.1 has none.
  if constexpr (std::is_same_v<P, lang::Packet72> || std::is_same_v<P, lang::Packet76>)
    for (auto* mode : {&packet.M_MODETEXTDISPLAY_START, &packet.M_MODETEXTDISPLAY_END})
      if (mode->raw == 3 || mode->raw == 5) mode->raw = 0;
  if constexpr (std::is_same_v<P, lang::Packet3>)
    if (packet.NID_C.raw == lang::kNoCountry) packet.NID_C.raw = 0;
}

template <class P>
[[gnu::noinline]] void read_and_write(const lang::PacketView& view) {
  P packet;
  const lang::Fault fault = lang::decode(view, packet);
  const bool own = P::info.NID_PACKET == nid_of(view) && (P::info.versions & lang::known_version(view.sv)) != 0;
  require((fault == lang::Fault::not_a_packet_of_this_kind) <= !own);
  if (fault != lang::Fault::none) return;
  if (!own) give_codes(packet);
  std::array<std::uint8_t, 1100> room{};
  BitWriter out(room);
  lang::encode(out, packet);
  if (!own) {  // translated from an older layout: it is the same in the newest one
    if (out.faulty()) return require(nid_of(view) == 44);  // the longest packet 44 cannot be expressed in X = 2
    constexpr bool of_2_1 = (P::info.versions & lang::v2_1) != 0;
    constexpr lang::SystemVersion own_version = of_2_1 ? lang::kNewest_of_baseline_3 : lang::kNewest;
    const lang::PacketView newest{P::info.NID_PACKET,
                                  static_cast<std::uint16_t>(out.position()),
                                  0,
                                  packet_direction(packet),
                                  own_version,
                                  view.direction,
                                  true,
                                  room};
    P again;
    return require(lang::decode(newest, again) == lang::Fault::none && again == packet);
  }
  require(!out.faulty() && out.position() == view.L_PACKET);
  BitReader a(view.bytes, view.bit + view.L_PACKET, view.bit);
  BitReader b(room, view.L_PACKET);
  while (a.left() > 0) {
    const auto bits = static_cast<unsigned>(a.left() < 64 ? a.left() : 64);
    require(a.read_bit_by_bit(bits) == b.read(bits));
  }
}

template <class P>
void refuse(const lang::PacketView& view) {
  P packet;
  require(lang::decode(view, packet) == lang::Fault::not_a_packet_of_this_kind);
}

/// 6.6.3.1.1.1: a train ignores the contents of a fixed text of X = 1.
inline bool is_ignored(const lang::PacketView& view) {
  return view.NID_PACKET == packet::fixed_text && view.sv.x == 1 && view.direction == lang::Direction::to_train;
}

/// A packet whose number is known; `sound`: its contents are consistent.
inline void check_contents(const lang::PacketView& view, bool sound) {
  BitReader in(view.bytes, view.bit + view.L_PACKET, view.bit);
  const auto nid = static_cast<std::uint8_t>(in.read_bit_by_bit(8));
  const lang::PacketLayout* layout = lang::find_packet_layout(view.direction, lang::known_version(view.sv), nid);
  SpareFinder finder;
  if (layout->has_direction) finder.spare = in.read_bit_by_bit(2) == 3;
  if (layout->has_length) require(in.read_bit_by_bit(13) == view.L_PACKET);
  lang::walk<lang::read_slowly>(in, layout->steps, finder, nullptr, layout->has_direction ? 1 : 0);
  const bool right_length = !in.faulty() && in.position() == view.bit + view.L_PACKET;
  if (sound) require(right_length && !finder.spare);
  if (nid == 255) return;
#define EVC_EACH(P)                                                                       \
  if ((lang::P::info.NID_PACKET == nid || lang::P::info.NID_PACKET == view.NID_PACKET) && \
      lang::P::info.direction == view.direction)                                          \
    read_and_write<lang::P>(view);
  EVC_PACKETS_TO_TRAIN(EVC_EACH)
  EVC_PACKETS_TO_TRACK(EVC_EACH)
#undef EVC_EACH
  if (view.direction == lang::Direction::to_track || nid != 3) refuse<lang::Packet3>(view);
  if (view.direction == lang::Direction::to_train || nid != 3) refuse<lang::TrainPacket3>(view);
}

/// A packet found at its place; `sound`: by a reader that looks at the contents, and they are consistent.
inline void check_view(const lang::PacketView& view, bool sound) {
  const auto nid = static_cast<std::uint8_t>(nid_of(view));
  const bool known = lang::find_packet_layout(view.direction, lang::known_version(view.sv), nid) != nullptr;
  require((known && !(sound && is_ignored(view))) == view.known);
  if (view.known) check_contents(view, sound);
}

/// One packet at bit 0.
inline void check_alone(std::span<const std::uint8_t> bytes, lang::Direction direction, lang::SystemVersion sv) {
  const std::size_t bits = bytes.size() * 8;
  const lang::FaultAt fast = lang::check_packet(bytes, bits, direction, sv);
  const bool selected = is_selected(bytes);
  std::string json;
  const bool taken =
      selected && io::append_packet_json(json, bytes, bits, direction, sv, io::Spare::accept).has_value();
  if (selected) io::explain_packet(bytes, bits, direction, sv);
  BitReader in(bytes, bits);
  const auto nid = static_cast<std::uint8_t>(in.read_bit_by_bit(8));
  const lang::PacketLayout* layout = lang::find_packet_layout(direction, lang::known_version(sv), nid);
  if (!in.faulty() && layout != nullptr) {
    SpareFinder finder;
    std::size_t end = nid == 255 ? 8 : 14;
    bool headed = true;
    if (layout->has_direction) finder.spare = in.read_bit_by_bit(2) == 3;
    if (layout->has_length) {
      end = in.read_bit_by_bit(13);
      headed = !in.faulty() && end >= in.position();
    }
    if (headed && end <= bits) {
      BitReader inside(bytes, end, in.position());
      lang::walk<lang::read_slowly>(inside, layout->steps, finder, nullptr, layout->has_direction ? 1 : 0);
      const bool right_length = !inside.faulty() && inside.position() == end;
      require((fast.fault == lang::Fault::none) == (right_length && !finder.spare));
      require((fast.fault == lang::Fault::length_mismatch) == !right_length);
      lang::PacketView view{nid, static_cast<std::uint16_t>(end), 0, 2, sv, direction, true, bytes};
      if (layout->has_direction) view.Q_DIR = static_cast<std::uint8_t>(BitReader(bytes, bits, 8).read(2));
      check_contents(view, fast.fault == lang::Fault::none);
    } else {
      require(fast.fault != lang::Fault::none && !taken);
    }
  }
  if (!taken) return;
  const auto encoded = io::encode_packet_json(nlohmann::json::parse(json), {direction, sv});
  require(encoded.has_value());
  std::string again;
  require(io::append_packet_json(again, encoded->bytes, encoded->bits, direction, sv, io::Spare::accept).has_value());
  require(again == json);
}

}  // namespace evc::fuzz
