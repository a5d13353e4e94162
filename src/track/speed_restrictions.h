#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/units.h"
#include "track/profile.h"

// Static speed restrictions and gradient (3.11, 3.11.12). The speeds of all train categories are stored: the MRSP
// selects the one that applies.
namespace evc::track {

/// A speed of the language in steps of 5 km/h.
using SpeedCode = std::uint8_t;
inline constexpr SpeedCode kNoSpeed = 255;  ///< no value given
inline constexpr SpeedCode kEndOfProfile = 127;
constexpr Speed speed_of(SpeedCode code) { return {static_cast<double>(code * 5) / 3.6}; }

/// The train data for the choice of speeds and for the route (3.18.3.2).
struct TrainCategory {
  std::uint8_t NC_CDTRAIN = 0;  ///< index of the cant deficiency, 0..10: 80 100 130 150 165 180 210 225 245 275 300 mm
  std::uint16_t NC_TRAIN = 0;   ///< bit k: other international category k (0 freight P, 1 freight G, 2 passenger)
  std::uint8_t M_AXLELOADCAT = 0;  ///< 0 A, HS17, B1, B2, C2, C3, C4, D2, D3, D4, D4XL, E4, 12 E5
  /// X = 3 is operated: a restriction for lower axle loads does not hold for this one (3.11.4.3, 6.6.4.1.3).
  bool own_axle_load_only = false;
  friend constexpr bool operator==(const TrainCategory&, const TrainCategory&) = default;
};

/// One element of the static speed profile (packet 27).
struct StaticSpeed {
  SpeedCode V_STATIC = kEndOfProfile;
  bool Q_FRONT = false;          ///< true: no train length delay at the end of this element (3.11.3.1.3)
  std::uint8_t replaces_cd = 0;  ///< bit k: other category k replaces the cant deficiency speed (Q_DIFF = 1)
  /// The other categories replace it for trains whose cant deficiency category is below this one: the profile of X = 1
  /// has none for them (6.6.3.2.3 [3]).
  std::uint8_t replaces_below = 0;
  std::array<SpeedCode, 11> cd{kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed,
                               kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed};
  std::array<SpeedCode, 3> other{kNoSpeed, kNoSpeed, kNoSpeed};

  static constexpr StaticSpeed unknown() { return {}; }
  constexpr bool known() const { return V_STATIC != kEndOfProfile; }
  /// The element's speed for one train (3.11.3.2.3, 3.11.3.2.6).
  SpeedCode speed_for(const TrainCategory& train) const;
  friend constexpr bool operator==(const StaticSpeed&, const StaticSpeed&) = default;
};
using StaticSpeedProfile = Profile<StaticSpeed, 64>;
using NewStaticSpeedProfile = Profile<StaticSpeed, 32>;

/// One element of the gradient profile (packet 21), per mille, positive uphill.
struct Gradient {
  std::int16_t permille = kUnknown;
  static constexpr std::int16_t kUnknown = 32767;
  static constexpr Gradient unknown() { return {}; }
  constexpr bool known() const { return permille != kUnknown; }
  friend constexpr bool operator==(const Gradient&, const Gradient&) = default;
};
using GradientProfile = Profile<Gradient, 96>;
using NewGradientProfile = Profile<Gradient, 32>;

/// One element of the axle load speed profile (packet 51).
struct AxleLoadRestriction {
  Place from{}, to{};
  bool Q_FRONT = false;
  std::array<SpeedCode, 13> V_AXLELOAD{kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed,
                                       kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed, kNoSpeed};
  /// The lowest speed of the categories up to that of the train; absent when none applies. So in every edition: the
  /// own category alone counts with version 3 operated (3.11.4.3 of 4.0.0; with 1 and 2 6.6.2.1.4, 6.6.4.1.3).
  SpeedCode speed_for(const TrainCategory& train) const;
  Anchor anchor{};
  friend constexpr bool operator==(const AxleLoadRestriction&, const AxleLoadRestriction&) = default;
};

/// A temporary speed restriction (packet 65). Identity 255 cannot be revoked (3.11.5).
struct TemporarySpeedRestriction {
  Place from{}, to{};
  std::uint8_t NID_TSR = 255;
  bool Q_FRONT = false;
  SpeedCode V_TSR = 0;
  bool from_rbc = false;
  Anchor anchor{};
  friend constexpr bool operator==(const TemporarySpeedRestriction&, const TemporarySpeedRestriction&) = default;
};

/// If there is no room for one more: `kept` is extended to cover both at the lower speed, never less restrictive; it
/// can no longer be revoked.
void cover(TemporarySpeedRestriction& kept, const TemporarySpeedRestriction& more);

/// One element of the permitted braking distance profile (packet 52); its speed is computed in sdm.
struct PermittedBrakingDistance {
  Place from{}, to{};
  Distance D_PBD{};
  std::int16_t gradient_permille = 0;
  bool service_brake = false;  ///< Q_PBDSR: false emergency brake, true service brake
  Anchor anchor{};
  friend constexpr bool operator==(const PermittedBrakingDistance&, const PermittedBrakingDistance&) = default;
};

/// A level crossing (packet 88).
struct LevelCrossing {
  Place from{}, to{};
  std::uint8_t NID_LX = 0;
  bool unprotected = false;  ///< Q_LXSTATUS
  SpeedCode V_LX = 0;
  bool stop_required = false;  ///< Q_STOPLX
  Distance L_STOPLX{};         ///< stopping area in rear of the crossing
  bool substituted = false;    ///< V_LX applies instead of the stop (5.16), from `V_LX_from`
  bool informed = false;       ///< the driver was informed that it is not protected (5.16.1.4)
  Place V_LX_from{};
  Anchor anchor{};
  friend constexpr bool operator==(const LevelCrossing&, const LevelCrossing&) = default;
};

/// Signalling related speed restriction (3.11.6), level 1 only.
struct SignallingSpeed {
  Place from{};
  SpeedCode V_MAIN = 0;
  std::optional<Place> to;  ///< place where it was shortened (A.3.4)
  friend constexpr bool operator==(const SignallingSpeed&, const SignallingSpeed&) = default;
};

}  // namespace evc::track
