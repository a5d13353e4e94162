#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/units.h"

// Track conditions (3.12.1), route suitability (3.12.2), adhesion (3.18.4.6).
namespace evc::track {

/// M_TRACKCOND.
enum class Condition : std::uint8_t {
  non_stopping_area,
  tunnel_stopping_area,
  sound_horn,
  powerless_lower_pantograph,
  radio_hole,
  air_tightness,
  switch_off_regenerative_brake,
  switch_off_eddy_current_service_brake,
  switch_off_magnetic_shoe_brake,
  powerless_main_switch_off,
  switch_off_eddy_current_emergency_brake,
};
struct TrackCondition {
  Place from{}, to{};
  Condition kind = Condition::non_stopping_area;
  friend constexpr bool operator==(const TrackCondition&, const TrackCondition&) = default;
};
struct BigMetalMass {
  Place from{}, to{};
  friend constexpr bool operator==(const BigMetalMass&, const BigMetalMass&) = default;
};
struct Platform {
  Place from{}, to{};
  std::uint8_t M_PLATFORM = 0, Q_PLATFORM = 0;
  friend constexpr bool operator==(const Platform&, const Platform&) = default;
};
struct TractionChange {
  Place at{};
  std::uint8_t M_VOLTAGE = 0;
  std::uint16_t NID_CTRACTION = 0;
  friend constexpr bool operator==(const TractionChange&, const TractionChange&) = default;
};
struct CurrentChange {
  Place at{};
  std::optional<std::uint16_t> amperes;  ///< absent: no restriction
  friend constexpr bool operator==(const CurrentChange&, const CurrentChange&) = default;
};

enum class Suitability : std::uint8_t { gauge = 0, axle_load = 1, traction = 2 };  ///< Q_SUITABILITY
struct RouteSuitability {
  Place at{};
  Suitability kind = Suitability::gauge;
  std::uint8_t M_LINEGAUGE = 0;  ///< bits G1 = 1, GA = 2, GB = 4, GC = 8
  std::uint8_t M_AXLELOADCAT = 0;
  std::uint8_t M_VOLTAGE = 0;
  std::uint16_t NID_CTRACTION = 0;
  friend constexpr bool operator==(const RouteSuitability&, const RouteSuitability&) = default;
};

/// What the train can run on.
struct TrainInterfaces {
  std::uint8_t M_LOADINGGAUGE = 0;  ///< 0 none of the interoperable profiles, 1 G1, 2 GA, 3 GB, 4 GC
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
  friend constexpr bool operator==(const AdhesionArea&, const AdhesionArea&) = default;
};

}  // namespace evc::track
