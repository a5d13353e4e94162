#pragma once
#include <cstddef>
#include <cstdint>
#include <new>

#include "lang/codec.h"
#include "lang/telegram.h"

// The reader and checker of every packet, by number and version. Internal to this folder.
namespace evc::lang {

/// One layout of a packet in the tables of scan_...().
struct PacketCodec {
  const PacketInfo* info;
  bool has_length;  ///< false: packets 0 and 255
  /// Reads the packet only to check it. False: not consistent, with the reason in `at`.
  bool (*check)(const PacketView& view, FaultAt& at);
};
/// The layout of packet `nid` in the known version `version` (one bit); null if there is none.
const PacketCodec* find_packet_codec(Direction direction, Versions version, std::uint8_t nid);

/// The fault after reading `view`, if there is one.
FaultAt verdict(const codec::Source& from, const PacketView& view);
/// Check::reading: a spare code of a later Y, except of Q_SCALE and Q_DIR.
bool is_let_through(const FaultAt& fault, SystemVersion sv);

/// Reads the packet in exactly the layout of P. False: not consistent, with the reason in `at`.
template <class P>
[[gnu::noinline]] bool read_packet(const PacketView& view, P& packet, FaultAt& at) {
  const std::size_t end = view.bit + view.L_PACKET;
  codec::Source from{BitReader(view.bytes, end, view.bit + 8)};
  if constexpr (codec::has_direction<P>) {
    codec::get(from, packet.Q_DIR);
    from.in.advance(13);  // L_PACKET: stored in the view, and the packet is at least this long
    codec::read_structure<1>(from, codec::Scope<P, void>{packet, nullptr});
  } else {
    if constexpr (codec::has_length<P>) from.in.advance(13);
    codec::read_structure<0>(from, codec::Scope<P, void>{packet, nullptr});
  }
  if (!from.in.faulty() && from.in.position() == end && from.spare_variable == nullptr) [[likely]]
    return true;
  at = verdict(from, view);
  return false;
}

/// Reads the packet only to check it; instantiated in packet_codec_*.cpp.
template <class P>
bool check_packet(const PacketView& view, FaultAt& at);

template <class P>
inline constexpr PacketCodec codec_of{&P::info, codec::has_length<P>, &check_packet<P>};

}  // namespace evc::lang
