#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "lang/telegram.h"

// The packets of one message together: which may occur again (8.4.1.4, 8.4.1.5), and which of version 1.1 replace those
// of 1.0 (6.6.3.2.3). A message is a radio message, a loop message, or all telegrams of a balise group that are used
// for it (3.16.2.1.2, 8.4.1.6).
namespace evc::lang {

/// Numbers of 0 to 255.
struct NumberSet {
  std::uint64_t words[4]{};
  constexpr bool has(std::uint8_t n) const { return ((words[n / 64] >> (n % 64)) & 1u) != 0; }
  constexpr void add(std::uint8_t n) { words[n / 64] |= std::uint64_t{1} << (n % 64); }
};

constexpr NumberSet set_of(std::initializer_list<std::uint8_t> numbers) {
  NumberSet s;
  for (const std::uint8_t n : numbers) s.add(n);
  return s;
}

/// NID_PACKET as in the bits; PacketView::NID_PACKET is that of version 2.1.
std::uint8_t wire_number(const PacketView& packet);

/// What a message of the track comes from (8.4.1.4.4, .6 to .9: some exceptions are for balise groups alone).
enum class Composed : std::uint8_t { by_group, by_loop_or_radio };

/// The packets read so far of a message.
class Instances {
 public:
  explicit Instances(Composed composed = Composed::by_group) : composed_(composed) {}
  /// A further telegram of the message begins.
  void begin_telegram() {
    infill_ = false;
    infill_for_ = 0;
  }
  /// Adds a packet; unknown ones do not count. True: with it the message has one instance too many for a direction.
  ///
  /// Packet 44 may occur again, of a balise group 254, 145, 0 and 200 too; 65, 66, 88 and 6 with another identity
  /// (NID_TSR, except that of restrictions that cannot be revoked; NID_TSR; NID_LX; NID_VBCMK with NID_C); 136 once in
  /// a telegram, with the same content in every telegram. Identities are compared within one direction, because the
  /// rule itself is per direction. Packets after packet 136 concern another group and count separately.
  bool add(const PacketView& packet) { return packet.known && add(packet, wire_number(packet)); }
  /// The same for a known packet with its wire_number().
  bool add(const PacketView& packet, std::uint8_t nid) {
    if (special.has(nid) || packet.direction == Direction::to_track) [[unlikely]]
      return add_special(packet, nid);
    return packets_[infill_ ? 1 : 0].add(packet.Q_DIR, nid);
  }

 private:
  struct ByDirection {
    NumberSet nominal, reverse;
    bool add(std::uint8_t Q_DIR, std::uint8_t number) {
      const std::uint64_t one = std::uint64_t{1} << (number % 64);
      const std::uint64_t for_nominal = Q_DIR != 0 ? one : 0, for_reverse = Q_DIR != 1 ? one : 0;
      std::uint64_t &n = nominal.words[number / 64], &r = reverse.words[number / 64];
      const bool again = ((n & for_nominal) | (r & for_reverse)) != 0;
      n |= for_nominal;
      r |= for_reverse;
      return again;
    }
  };
  /// Those of 8.4.1.4.1 to .9: a message may contain several.
  static constexpr NumberSet special = set_of({44, 65, 66, 136, 88, 254, 145, 0, 200, 6});
  bool add_special(const PacketView& packet, std::uint8_t nid);
  bool add_location(const PacketView& packet);
  bool add_identity(const PacketView& packet, std::uint32_t nid, std::uint32_t identity);

  ByDirection packets_[2];  // before and after packet 136
  // NID_PACKET, Q_DIR and identity of packets 65, 66, 88 and 6. The shortest of them has 31 bits: a telegram has not
  // more than 26 (8.4.2.1), a message of eight telegrams not more than 208.
  std::array<std::uint32_t, 208> identities_;  // NOLINT(cppcoreguidelines-pro-type-member-init): up to count_
  std::size_t count_ = 0;
  std::uint64_t location_[2]{};  // the contents of packet 136 for each direction, 0: none
  std::uint8_t infill_for_ = 0;  // directions of the packets 136 of this telegram, a bit each
  bool infill_ = false;
  Composed composed_;
};

/// Packets 206, 207 and 239 in a message of X = 1: with them the packets 68, 70 and 39 of X = 1 are for units of
/// version 1.0 only and ignored (6.6.3.2.3, exceptions 9, 11 to 13).
struct Superseding {
  bool p206 = false, p207 = false, p239 = false;
  bool drops(const PacketView& packet) const;
};
/// The packets of one message that replace others. Called with the packets valid for the train's direction: a packet
/// for the other direction supersedes nothing, which keeps more information.
Superseding superseding_in(std::span<const PacketView> message);

}  // namespace evc::lang
