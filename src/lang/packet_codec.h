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
  /// Reads the packet and forgets it.
  FaultAt (*check)(const PacketView& view);
};
/// The layout of packet `nid` in the known version `version` (one bit); null if there is none.
const PacketCodec* find_packet_codec(Direction direction, Versions version, std::uint8_t nid);

/// What became of reading `view`: spare codes of a later Y are no fault, except of Q_SCALE and Q_DIR,
/// without which nothing can be made of the packet.
FaultAt verdict(const codec::Source& from, const PacketView& view);

/// Reads the packet in exactly the layout of P.
template <class P>
[[gnu::noinline]] FaultAt read_packet(const PacketView& view, P& packet) {
  codec::Source from{BitReader(view.bytes, view.bit + view.L_PACKET, view.bit + 8)};
  if constexpr (codec::has_direction<P>) {
    codec::get(from, packet.Q_DIR);
    from.in.advance(13);  // L_PACKET: the view has it, and it is at least this long
    codec::read_structure<1>(from, codec::Scope<P, void>{packet, nullptr});
  } else {
    if constexpr (codec::has_length<P>) from.in.advance(13);
    codec::read_structure<0>(from, codec::Scope<P, void>{packet, nullptr});
  }
  return verdict(from, view);
}

/// Reads the packet and forgets it; made in packet_codec_*.cpp.
template <class P>
FaultAt check_packet(const PacketView& view);

template <class P>
inline constexpr PacketCodec codec_of{&P::info, codec::has_length<P>, &check_packet<P>};

}  // namespace evc::lang
