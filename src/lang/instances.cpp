#include "lang/instances.h"

#include "base/bit_cursor.h"
#include "terms/packet_numbers.h"

namespace evc::lang {
namespace {

/// `bits` bits of a packet, starting at its bit `from`.
std::uint64_t bits_of(const PacketView& packet, unsigned from, unsigned bits) {
  const std::size_t end = packet.bit + packet.L_PACKET;
  return BitReader(packet.bytes, end, packet.bit + from).read(bits);
}
constexpr unsigned packet_header = 8 + 2 + 13;  // NID_PACKET, Q_DIR, L_PACKET

std::uint32_t identity(const PacketView& packet, unsigned from, unsigned bits) {
  return static_cast<std::uint32_t>(bits_of(packet, from, bits));
}
constexpr std::uint32_t not_revocable = 255;  // NID_TSR

}  // namespace

std::uint8_t wire_number(const PacketView& packet) {
  return static_cast<std::uint8_t>(BitReader(packet.bytes, packet.bytes.size() * 8, packet.bit).read(8));
}

/// 8.4.1.4.4.
bool Instances::add_location(const PacketView& packet) {
  bool wrong = false;
  const unsigned length = packet.L_PACKET - packet_header;  // 15 or 25 bits: Q_NEWCOUNTRY, NID_C if it is 1, NID_BG
  const std::uint64_t content = bits_of(packet, packet_header, length) | std::uint64_t{1} << length;
  for (unsigned direction = 0; direction < 2; ++direction) {
    if (packet.Q_DIR != 2 && packet.Q_DIR != direction) continue;
    wrong = wrong || ((infill_for_ >> direction) & 1u) != 0;
    wrong = wrong || (location_[direction] != 0 && location_[direction] != content);
    location_[direction] = content;
    infill_for_ = static_cast<std::uint8_t>(infill_for_ | 1u << direction);
  }
  infill_ = true;
  return wrong;
}

/// 8.4.1.4.2, .3, .5 and .9. More than fit count as one too many.
bool Instances::add_identity(const PacketView& packet, std::uint32_t nid, std::uint32_t identity) {
  const std::uint32_t which = nid << 16 | identity;
  for (std::size_t i = 0; i < count_; ++i) {
    const std::uint32_t Q_DIR = identities_[i] >> 24;
    if ((identities_[i] & 0xFFFFFFu) == which && (Q_DIR == packet.Q_DIR || Q_DIR == 2 || packet.Q_DIR == 2))
      return true;
  }
  if (count_ == identities_.size()) return true;
  identities_[count_++] = std::uint32_t{packet.Q_DIR} << 24 | which;
  return false;
}

bool Instances::add_special(const PacketView& packet, std::uint8_t nid) {
  if (packet.direction == Direction::to_track)
    return nid != packet::external_application_data && packets_[0].add(2, nid);  // 8.4.1.5
  switch (nid) {
    case packet::temporary_speed_restriction: {
      const std::uint32_t NID_TSR = identity(packet, packet_header + 2, 8);  // behind Q_SCALE
      return NID_TSR != not_revocable && add_identity(packet, packet::temporary_speed_restriction, NID_TSR);
    }
    case packet::tsr_revocation:
      return add_identity(packet, packet::tsr_revocation, identity(packet, packet_header, 8));
    case packet::level_crossing:
      return add_identity(packet, packet::level_crossing, identity(packet, packet_header + 2, 8));
    case packet::virtual_balise_cover_order:
      return add_identity(packet, packet::virtual_balise_cover_order,
                          identity(packet, packet_header + 1, 6 + 10));  // NID_VBCMK, NID_C behind Q_VBCO
    case packet::infill_location_reference:
      return add_location(packet);
    case packet::external_application_data:
      return false;  // 8.4.1.4.1
    default:         // 8.4.1.4.6 to .8: of a group; 200 is packet 0 of version 1.1
      return composed_ != Composed::by_group && packets_[infill_ ? 1 : 0].add(packet.Q_DIR, nid);
  }
}

bool Superseding::drops(const PacketView& packet) const {
  if (packet.sv.x != 1) return false;
  const std::uint8_t nid = wire_number(packet);
  return (nid == packet::track_condition && p206) || (nid == packet::route_suitability && p207) ||
         (nid == packet::traction_system_change && p239);
}

Superseding superseding_in(std::span<const PacketView> message) {
  Superseding found;
  for (const PacketView& packet : message) {
    if (known_version(packet.sv) != v1_1) continue;
    const std::uint8_t nid = wire_number(packet);
    found.p206 = found.p206 || nid == packet::track_condition_v1;
    found.p207 = found.p207 || nid == packet::route_suitability_v1;
    found.p239 = found.p239 || nid == packet::traction_system_change_v1;
  }
  return found;
}

}  // namespace evc::lang
