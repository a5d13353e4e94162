#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/units.h"
#include "terms/track_condition.h"

// Track conditions (3.12.1), route suitability (3.12.2), adhesion (3.18.4.6).
namespace evc::track {

/// How far a condition has come for driver and train (indication.h).
struct Progress {
  ConditionPhase phase = ConditionPhase::ahead;
  std::uint16_t shown_as = 0;         ///< its number on the driver interface while it is shown there; 0: it is not
  std::optional<Duration> rear_left;  ///< since then the min safe rear end has left the area or the place
  friend constexpr bool operator==(const Progress&, const Progress&) = default;
};

struct TrackCondition {
  Place from{}, to{};
  TrackConditionKind kind = TrackConditionKind::non_stopping_area;
  Progress progress{};
  Anchor anchor{};
  friend constexpr bool operator==(const TrackCondition&, const TrackCondition&) = default;
};
struct BigMetalMass {
  Place from{}, to{};
  Anchor anchor{};
  friend constexpr bool operator==(const BigMetalMass&, const BigMetalMass&) = default;
};
struct Platform {
  Place from{}, to{};
  std::uint8_t M_PLATFORM = 0, Q_PLATFORM = 0;
  Progress progress{};
  Anchor anchor{};
  friend constexpr bool operator==(const Platform&, const Platform&) = default;
};
struct TractionChange {
  Place at{};
  std::uint8_t M_VOLTAGE = 0;
  std::uint16_t NID_CTRACTION = 0;
  Progress progress{};
  Anchor anchor{};
  friend constexpr bool operator==(const TractionChange&, const TractionChange&) = default;
};
struct CurrentChange {
  Place at{};
  std::optional<std::uint16_t> amperes;  ///< absent: no restriction
  Progress progress{};
  Anchor anchor{};
  friend constexpr bool operator==(const CurrentChange&, const CurrentChange&) = default;
};

struct RouteSuitability {
  Place at{};
  Suitability kind = Suitability::gauge;
  std::uint8_t M_LINEGAUGE = 0;         ///< bits G1 = 1, GA = 2, GB = 4, GC = 8
  std::uint16_t M_LINEAXLELOADCAT = 0;  ///< the categories allowed, bits A = 1, HS17 = 2, ... E5 = 4096
  std::uint8_t M_VOLTAGE = 0;
  std::uint16_t NID_CTRACTION = 0;
  Anchor anchor{};
  friend constexpr bool operator==(const RouteSuitability&, const RouteSuitability&) = default;
};

/// When the conditions have to be looked at next, so that not every cycle does.
struct ConditionWatch {
  bool changed = true;    ///< what is stored or the braking curves are others
  bool shown = false;     ///< one is between its first and its last indication
  bool stopping = false;  ///< there are areas in which stopping is not permitted or advised
  Place quiet_to{};       ///< with none shown: nothing begins while the max safe front end is in rear of it
};

/// The train's data for route suitability.
struct TrainInterfaces {
  std::uint8_t M_LOADINGGAUGE = 0;  ///< 0 no interoperable profile, 1 G1, 2 GA, 3 GB, 4 GC
  std::uint8_t M_AXLELOADCAT = 0;
  struct Traction {
    std::uint8_t M_VOLTAGE = 0;
    std::uint16_t NID_CTRACTION = 0;
    friend constexpr bool operator==(const Traction&, const Traction&) = default;
  };
  InplaceVector<Traction, 8> tractions;
};
/// Whether the route is closed to the train from `item.at` on (3.12.2.4-6).
bool unsuitable(const RouteSuitability& item, const TrainInterfaces& train);

struct AdhesionArea {
  Place from{}, to{};
  bool slippery = false;  ///< M_ADHESION = 0
  Anchor anchor{};
  friend constexpr bool operator==(const AdhesionArea&, const AdhesionArea&) = default;
};

}  // namespace evc::track
