#pragma once
#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/packet_codec.h"
#include "lang/packets.h"
#include "lang/translate.h"

// The bodies of decode() and encode() of packets, for the packet_codec_*.cpp that instantiate them.
namespace evc::lang {

template <class P, class... Older>
FaultAt read_older([[maybe_unused]] const PacketView& view, [[maybe_unused]] std::uint8_t nid,
                   [[maybe_unused]] Versions version, [[maybe_unused]] P& packet, Forms<Older...>) {
  FaultAt at{Fault::not_a_packet_of_this_kind, view.bit, view.NID_PACKET, "NID_PACKET", nid};
  (
      [&] {
        if (Older::info.NID_PACKET != nid || (Older::info.versions & version) == 0) return;
        Older older;
        at = {};
        if (read_packet(view, older, at) && !translate(older, packet))
          at = {Fault::not_applicable, view.bit, nid, nullptr, 0};
      }(),
      ...);
  return at;
}

template <class P>
Fault decode(const PacketView& view, P& packet) {
  const auto nid = static_cast<std::uint8_t>(BitReader(view.bytes, view.bytes.size() * 8, view.bit).read(8));
  if (nid == P::info.NID_PACKET && view.direction == P::info.direction &&
      (P::info.versions & known_version(view.sv)) != 0) [[likely]] {
    FaultAt at;
    return read_packet(view, packet, at) || is_let_through(at, view.sv) ? Fault::none : at.fault;
  }
  return decode_at(view, packet).fault;
}
template <class P>
FaultAt decode_at(const PacketView& view, P& packet) {
  const auto nid = static_cast<std::uint8_t>(BitReader(view.bytes, view.bytes.size() * 8, view.bit).read(8));
  const Versions version = known_version(view.sv);
  if (nid == P::info.NID_PACKET && view.direction == P::info.direction && (P::info.versions & version) != 0)
      [[likely]] {
    FaultAt at;
    return read_packet(view, packet, at) || is_let_through(at, view.sv) ? FaultAt{} : at;
  }
  if (view.direction != P::info.direction)
    return {Fault::not_a_packet_of_this_kind, view.bit, view.NID_PACKET, "NID_PACKET", nid};
  return read_older(view, nid, version, packet, typename OlderForms<P>::type{});
}

template <class P>
void encode(BitWriter& out, const P& packet) {
  const std::size_t start = out.position();
  std::size_t length = 0;
  out.write(P::info.NID_PACKET, 8);
  if constexpr (codec::has_direction<P>) out.write(packet.Q_DIR.raw, 2);
  if constexpr (codec::has_length<P>) {
    length = out.position();
    out.write(0, 13);
  }
  codec::write_structure<codec::has_direction<P> ? 1 : 0>(out, codec::Scope<const P, void>{packet, nullptr});
  if constexpr (codec::has_length<P>) out.patch(length, out.position() - start, 13);
}

template <class P>
bool check_packet(const PacketView& view, FaultAt& at) {
  // Reading assigns every member it uses, so the memory need not be zero before.
  alignas(P) std::byte room[sizeof(P)];
  return read_packet(view, *std::launder(reinterpret_cast<P*>(room)), at);
}

#define EVC_INSTANTIATE(P)                              \
  template FaultAt decode_at<P>(const PacketView&, P&); \
  template Fault decode<P>(const PacketView&, P&);      \
  template void encode<P>(BitWriter&, const P&);        \
  template bool check_packet<P>(const PacketView&, FaultAt&);

}  // namespace evc::lang
