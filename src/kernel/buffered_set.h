#pragma once
#include <array>
#include <cstdint>

#include "balise/balise.h"
#include "base/inplace_vector.h"
#include "base/units.h"
#include "modes/acceptance.h"
#include "position/position.h"

namespace evc::kernel {

/// One set of information in the transition buffer (4.8.5): the bits as received, and the packets that are buffered.
struct BufferedSet {
  Medium medium = Medium::balise;
  GroupId group;
  Place reference{};
  Anchor anchor{};      // what the reference hangs on
  Relocation widening;  // of what was unlinked, up to now
  Direction orientation = Direction::unknown;
  Place min_safe_front{};  // at reception: a conditional emergency stop is judged with it (4.8.5.7)
  Duration received{};
  std::uint64_t waiting = 0;                      // bit n: the n-th packet
  std::uint64_t of_authority = 0;                 // likewise: authority, linking or track description
  bool message_waits = false;                     // the information of the radio message itself
  bool accepting = false;                         // by the accepting RBC: it waits for the change of RBC (4.8.2.1)
  std::uint8_t M_VERSION = 0;                     // of the session, for a message
  InplaceVector<std::uint16_t, 8> telegram_bits;  // of each telegram, in order of reading
  std::array<std::uint8_t, 1024> bytes{};         // consecutive telegrams, or one message
  std::uint16_t size = 0;
};
/// 4.8.5.1: three sets of information for a change of level, and three for a change of RBC.
inline constexpr std::size_t kBufferedSetsOfOneCause = 3;
inline constexpr std::size_t kBufferedSets = 2 * kBufferedSetsOfOneCause;

}  // namespace evc::kernel
