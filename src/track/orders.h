#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/units.h"
#include "track/speed_restrictions.h"

namespace evc::track {

/// A list of balise groups that may be passed in SH (packet 49) or SR (packet 63). With an empty list none may be
/// passed.
using GroupList = InplaceVector<GroupId, 32>;

/// RBC transition order (packet 131).
struct RbcTransition {
  Place at{};
  std::uint16_t NID_C = 0, NID_RBC = 0;
  std::uint64_t NID_RADIO = 0;
  bool sleeping_too = false;  ///< Q_SLEEPSESSION
  Anchor anchor{};
  friend constexpr bool operator==(const RbcTransition&, const RbcTransition&) = default;
};

struct RadioInfillArea {
  Place at{};  ///< place of establishing or terminating
  bool establish = false;
  std::uint16_t NID_C = 0, NID_RIU = 0;
  std::uint64_t NID_RADIO = 0;
  GroupId next_main_signal{};
  Anchor anchor{};
  friend constexpr bool operator==(const RadioInfillArea&, const RadioInfillArea&) = default;
};

/// Reversing area (packet 138) and the distance and speed in it (packet 139); 3.15.4.
struct ReversingArea {
  Place from{}, to{};
  Anchor anchor{};
  friend constexpr bool operator==(const ReversingArea&, const ReversingArea&) = default;
};
struct ReversingSupervision {
  std::optional<Distance> D_REVERSE;  ///< backwards from the end of the area; absent: unlimited
  SpeedCode V_REVERSE = 0;
  friend constexpr bool operator==(const ReversingSupervision&, const ReversingSupervision&) = default;
};

/// One reference of the geographical position (packet 79; 3.6.6).
struct GeoReference {
  GroupId group{};
  Distance D_POSOFF{};
  bool counts_up = true;                    ///< Q_MPOSITION, in the nominal direction of the group
  std::optional<std::uint32_t> M_POSITION;  ///< metres; absent: the geographical position ends
  std::optional<Place> applies_from;        ///< known once the group was passed
  bool counts_up_ahead = true;              ///< then: in the train's orientation
  bool applicable = false;                  ///< D_POSOFF was travelled (3.6.6.4.2)
  Anchor anchor{};
  friend constexpr bool operator==(const GeoReference&, const GeoReference&) = default;
};

}  // namespace evc::track
