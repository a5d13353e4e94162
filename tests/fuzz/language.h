#pragma once
#include <array>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "io/telegram_explain.h"
#include "io/telegram_json.h"
#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/layouts.h"
#include "lang/packets.h"
#include "lang/walk.h"

// What every reader of the language must hold for any bits: no crash, reading and writing come back to
// the same, the fast reader and the bit-by-bit one agree.
namespace evc::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

/// What the bit-by-bit reader has to say of a packet's inside.
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

template <class P>
void read_and_write(const lang::PacketView& view) {
  if (view.direction != P::info.direction) return;
  P packet;
  const lang::Fault fault = lang::decode(view, packet);
  const BitReader nid(view.bytes, view.bytes.size() * 8, view.bit);
  const bool own =
      BitReader(nid).read(8) == P::info.NID_PACKET && (P::info.versions & lang::known_version(view.sv)) != 0;
  require((fault == lang::Fault::not_a_packet_of_this_kind) <= !own);
  if (!own || fault != lang::Fault::none) return;
  std::array<std::uint8_t, 1100> room{};
  BitWriter out(room);
  lang::encode(out, packet);
  require(!out.faulty() && out.position() == view.L_PACKET);
  BitReader a(view.bytes, view.bit + view.L_PACKET, view.bit);
  BitReader b(room, view.L_PACKET);
  while (a.left() > 0) {
    const auto bits = static_cast<unsigned>(a.left() < 64 ? a.left() : 64);
    require(a.read_bit_by_bit(bits) == b.read(bits));
  }
}

/// A packet that was found at its place; `sound`: its inside was found right.
inline void check_view(const lang::PacketView& view, bool sound) {
  BitReader in(view.bytes, view.bit + view.L_PACKET, view.bit);
  const auto nid = static_cast<std::uint8_t>(in.read_bit_by_bit(8));
  const lang::PacketLayout* layout = lang::find_packet_layout(view.direction, lang::known_version(view.sv), nid);
  require((layout != nullptr) == view.known);
  if (layout == nullptr) return;
  SpareFinder finder;
  if (layout->has_direction) finder.spare = in.read_bit_by_bit(2) == 3;
  if (layout->has_length) require(in.read_bit_by_bit(13) == view.L_PACKET);
  lang::walk<lang::read_slowly>(in, layout->steps, finder, nullptr, layout->has_direction ? 1 : 0);
  const bool right_length = !in.faulty() && in.position() == view.bit + view.L_PACKET;
  const bool later = view.sv.y > 1;
  if (sound) require(right_length && (later || !finder.spare));
#define EVC_EACH(P) read_and_write<lang::P>(view);
  EVC_PACKETS_TO_TRAIN(EVC_EACH)
  EVC_PACKETS_TO_TRACK(EVC_EACH)
#undef EVC_EACH
}

/// One packet at bit 0.
inline void check_alone(std::span<const std::uint8_t> bytes, lang::Direction direction, lang::SystemVersion sv) {
  const std::size_t bits = bytes.size() * 8;
  const lang::FaultAt fast = lang::check_packet(bytes, bits, direction, sv);
  std::string json;
  const bool taken = io::append_packet_json(json, bytes, bits, direction, sv, io::Spare::accept).has_value();
  io::explain_packet(bytes, bits, direction, sv);
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
