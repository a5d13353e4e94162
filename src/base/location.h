#pragma once
#include <cstdint>

#include "base/units.h"

namespace evc {

/// The identity of a balise group: country or region and number (24 bits on the wire).
struct GroupId {
  std::uint16_t NID_C = 0;
  std::uint16_t NID_BG = 0;
  friend constexpr bool operator==(const GroupId&, const GroupId&) = default;
};

/// The odometer's three absolute counters at one moment; min <= nominal <= max. The distance the train really ran
/// between two readings lies between the increments of `min` and of `max`.
struct OdometerReading {
  OdometerPlace nominal, min, max;
  friend constexpr bool operator==(const OdometerReading&, const OdometerReading&) = default;
};

/// Place of a part of the train in the track frame: min <= est <= max. "max" is the far end in the train's orientation.
struct PlaceInterval {
  Place min, est, max;
  friend constexpr bool operator==(const PlaceInterval&, const PlaceInterval&) = default;
  friend constexpr PlaceInterval operator-(PlaceInterval a, Distance d) { return {a.min - d, a.est - d, a.max - d}; }
};

/// What a stored place hangs on: how it moves when the position is related to another group (3.6.4.2.5 of 4.0.0).
enum class Anchor : std::uint8_t {
  lrbg,      ///< linking or the RBC: fixed in the track frame
  received,  ///< an unlinked group, while its message is stored
  unlinked,  ///< an unlinked group, until the next LRBG
  travelled  ///< an LRBG, by the distance travelled to it from an unlinked group, until linking leads to another one
};

/// How stored places move in the track frame: all by `shift`; to keep the safe side, what restricts begins `nearer` and
/// ends `farther` besides, neither below 0.
struct Relocation {
  Distance shift{}, nearer{}, farther{};
  constexpr bool any() const { return shift.si != 0.0 || nearer.si > 0.0 || farther.si > 0.0; }
  friend constexpr bool operator==(const Relocation&, const Relocation&) = default;
};

/// A direction relative to the co-ordinate system of a balise group; the codes are those of
/// Q_DIRLRBG, Q_DLRBG and Q_DIRTRAIN.
enum class Direction : std::uint8_t { reverse = 0, nominal = 1, unknown = 2 };

/// The other direction; unknown stays unknown.
constexpr Direction opposite(Direction d) {
  if (d == Direction::unknown) return d;
  return d == Direction::nominal ? Direction::reverse : Direction::nominal;
}

}  // namespace evc
