#include "lang/packet_codec.h"

#include <array>

#include "lang/packets.h"

namespace evc::lang {

FaultAt verdict(const codec::Source& from, const PacketView& view) {
  const std::int32_t packet = view.NID_PACKET;
  const std::size_t end = view.bit + view.L_PACKET;
  if (from.in.faulty()) [[unlikely]]
    return {end > view.bytes.size() * 8 ? Fault::truncated : Fault::length_mismatch, from.in.position(), packet,
            from.in.failed_on(), view.L_PACKET};
  if (from.in.position() != end) [[unlikely]]
    return {Fault::length_mismatch, from.in.position(), packet, "L_PACKET", view.L_PACKET};
  return {Fault::spare_value, from.spare_bit, packet, from.spare_variable, from.spare_value};
}
bool is_let_through(const FaultAt& fault, SystemVersion sv) {
  return fault.fault == Fault::spare_value && is_later(sv) && fault.variable != var::Q_SCALE::name &&
         fault.variable != var::Q_DIR::name;
}

namespace {

#define EVC_ROW(P) &codec_of<P>,
constexpr std::array to_train{EVC_PACKETS_TO_TRAIN(EVC_ROW)};
constexpr std::array to_track{EVC_PACKETS_TO_TRACK(EVC_ROW)};
#undef EVC_ROW

/// One more than the index of every packet number in the lists above; 0: no such packet.
using Index = std::array<std::uint8_t, 256>;
template <std::size_t N>
consteval std::array<Index, kVersions> index_all(const std::array<const PacketCodec*, N>& list) {
  std::array<Index, kVersions> index{};
  for (unsigned v = 0; v < kVersions; ++v)
    for (std::size_t i = 0; i < N; ++i)
      if ((list[i]->info->versions & (1u << v)) != 0) {
        if (index[v][list[i]->info->NID_PACKET] != 0) __builtin_trap();  // two layouts in one version
        index[v][list[i]->info->NID_PACKET] = static_cast<std::uint8_t>(i + 1);
      }
  return index;
}
constexpr auto index_to_train = index_all(to_train);
constexpr auto index_to_track = index_all(to_track);

}  // namespace

const PacketCodec* find_packet_codec(Direction direction, Versions version, std::uint8_t nid) {
  if (version == 0) return nullptr;
  const unsigned v = index_of(version);
  if (direction == Direction::to_train) {
    const std::uint8_t i = index_to_train[v][nid];
    return i == 0 ? nullptr : to_train[i - 1u];
  }
  const std::uint8_t i = index_to_track[v][nid];
  return i == 0 ? nullptr : to_track[i - 1u];
}

}  // namespace evc::lang
