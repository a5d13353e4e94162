#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/units.h"
#include "track/speed_restrictions.h"

namespace evc::track {

/// A list of balise groups that may be passed in SH (packet 49) or SR (packet 63). An empty list lets none pass.
using GroupList = InplaceVector<GroupId, 32>;

/// M_LEVELTR of one level of an order's table, in order of priority.
struct OrderedLevel {
  std::uint8_t M_LEVELTR = 0;  ///< 0 level 0, 1 NTC, 2 level 1, 3 level 2, 4 level 3
  std::uint8_t NID_NTC = 0;
  Distance L_ACKLEVELTR{};  ///< length of the acknowledgement window in rear of the place
  friend constexpr bool operator==(const OrderedLevel&, const OrderedLevel&) = default;
};
/// A level transition order (packet 41) or a conditional one (packet 46, at once).
struct LevelOrder {
  InplaceVector<OrderedLevel, 32> levels;
  Place at{};
  bool immediate = false;    ///< D_LEVELTR = "now", or conditional
  bool conditional = false;  ///< packet 46
  friend constexpr bool operator==(const LevelOrder&, const LevelOrder&) = default;
};

/// RBC transition order (packet 131).
struct RbcTransition {
  Place at{};
  std::uint16_t NID_C = 0, NID_RBC = 0;
  std::uint64_t NID_RADIO = 0;
  bool sleeping_too = false;  ///< Q_SLEEPSESSION
  friend constexpr bool operator==(const RbcTransition&, const RbcTransition&) = default;
};

struct RadioInfillArea {
  Place at{};  ///< where to establish or terminate
  bool establish = false;
  std::uint16_t NID_C = 0, NID_RIU = 0;
  std::uint64_t NID_RADIO = 0;
  GroupId next_main_signal{};
  friend constexpr bool operator==(const RadioInfillArea&, const RadioInfillArea&) = default;
};

/// Reversing area (packet 138) and the distance and speed in it (packet 139); 3.15.4.
struct ReversingArea {
  Place from{}, to{};
  friend constexpr bool operator==(const ReversingArea&, const ReversingArea&) = default;
};
struct ReversingSupervision {
  std::optional<Distance> D_REVERSE;  ///< from the end of the area backwards; absent: endless
  SpeedCode V_REVERSE = 0;
  friend constexpr bool operator==(const ReversingSupervision&, const ReversingSupervision&) = default;
};

/// A virtual balise cover (packet 6; 3.15.9).
struct VirtualBaliseCover {
  std::uint8_t NID_VBCMK = 0;
  std::uint16_t NID_C = 0;
  Duration until{};
  friend constexpr bool operator==(const VirtualBaliseCover&, const VirtualBaliseCover&) = default;
};

/// One reference of the geographical position (packet 79; 3.6.6).
struct GeoReference {
  GroupId group{};
  Distance D_POSOFF{};
  bool counts_up = true;                    ///< Q_MPOSITION
  std::optional<std::uint32_t> M_POSITION;  ///< metres; absent: no more geographical position
  std::optional<Place> applies_from;        ///< known once the group was passed
  friend constexpr bool operator==(const GeoReference&, const GeoReference&) = default;
};

}  // namespace evc::track
