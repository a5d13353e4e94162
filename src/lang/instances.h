#pragma once
#include <cstdint>
#include <initializer_list>
#include <span>

#include "lang/telegram.h"

// What stands in one message together: which packets may come again (8.4.1.4, 8.4.1.5), and which of version 1.1 stand
// in for those of 1.0 (6.6.3.2.3). A message is a radio message, a loop message, or all telegrams of a balise group
// that are used for it (3.16.2.1.2, 8.4.1.6).
namespace evc::lang {

/// Numbers of 0 to 255.
struct NumberSet {
  std::uint64_t words[4]{};
  constexpr bool has(std::uint8_t n) const { return ((words[n / 64] >> (n % 64)) & 1u) != 0; }
  constexpr void add(std::uint8_t n) { words[n / 64] |= std::uint64_t{1} << (n % 64); }
};

/// NID_PACKET as it stands in the bits; PacketView::NID_PACKET is that of version 2.1.
std::uint8_t wire_number(const PacketView& packet);

/// The packets that a message has so far.
class Instances {
 public:
  /// A further telegram of the message begins.
  void begin_telegram() {
    infill_ = false;
    infill_for_ = 0;
  }
  /// Adds a packet; unknown ones do not count. True: with it the message has one instance too many for a direction.
  ///
  /// Packets 44, 254, 145, 0 and 200 may come again; 65, 66, 88 and 6 with another identity (NID_TSR, the one of
  /// restrictions that cannot be revoked apart; NID_TSR; NID_LX; NID_VBCMK with NID_C); 136 once in a telegram, and in
  /// every telegram with the same content. Identities are held against each other for one direction, as the rule that
  /// they are the exception of is. What follows packet 136 is about another group and counts by itself.
  bool add(const PacketView& packet);

 private:
  struct ByDirection {
    NumberSet numbers[2];
    bool add(std::uint8_t Q_DIR, std::uint8_t number);
  };
  bool add_location(const PacketView& packet);
  bool add_cover(const PacketView& packet);

  ByDirection packets_[2];  // before and after packet 136
  ByDirection restrictions_, revocations_, crossings_;
  InplaceVector<std::uint32_t, 64> covers_;  // Q_DIR, NID_VBCMK, NID_C
  std::uint64_t location_[2]{};              // what packet 136 says for each direction, 0: none
  std::uint8_t infill_for_ = 0;              // directions of the packets 136 of this telegram, a bit each
  bool infill_ = false;
};

/// Packets 206, 207 and 239 in a message of X = 1: with them the packets 68, 70 and 39 of X = 1 are for units of
/// version 1.0 only and ignored (6.6.3.2.3, exceptions 9, 11 to 13).
struct Superseding {
  bool p206 = false, p207 = false, p239 = false;
  bool drops(const PacketView& packet) const;
};
/// What of the packets of one message stands in for others. Called with the packets that are valid for the train's
/// direction: one for the other direction takes nothing away here, which keeps the more.
Superseding superseding_in(std::span<const PacketView> message);

}  // namespace evc::lang
