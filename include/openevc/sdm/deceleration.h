#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/step_function.h"
#include "openevc/base/units.h"
#include "openevc/sdm/braking_curve.h"
#include "openevc/train/brake_model.h"

// A_safe, A_expected and A_normal_service of 3.13.6 as functions of speed and place: bands of speed,
// segments of track, and the curve traced through them.
namespace evc::sdm {

inline constexpr std::size_t kGradientSteps = 96;
inline constexpr std::size_t kZones = 16;
/// Change points of the gradient and of its default, starts and ends of adhesion zones, starts of brake inhibitions.
inline constexpr std::size_t kSegments = kGradientSteps + 9 + 2 * kZones + 5;

/// Per mille, positive uphill.
using GradientFunction = StepFunction<Place, double, kGradientSteps>;

/// The gradient profile as received, not compensated. Where it is not known (before its first step,
/// or before `known_from`; from `known_to` on) the gradient is 0, and for targets due to a TSR the
/// default gradient (3.13.4.1.3).
struct GradientProfile {
  GradientFunction permille;
  std::optional<Place> known_from, known_to;
  std::optional<double> default_for_TSR;
};
/// Where the gradient is known, up to (not including) `to`; both 1e9 m when it is known nowhere.
struct KnownPart {
  Place from{}, to{};
};
KnownPart known_part(const GradientProfile& profile);

struct Zone {
  Place from{}, to{};
  friend constexpr bool operator==(const Zone&, const Zone&) = default;
};

/// Where special brakes do not count and where adhesion is reduced (3.13.5). A brake inhibition applies from the start
/// of its profile to the foot of every curve, wherever it ends: only the earliest start of a profile in use is stored.
struct TrackConditions {
  InplaceVector<Zone, kZones> reduced_adhesion;  // as received; the train length is added in this room
  bool slippery_rail = false;                    // selected by the driver: everywhere
  std::optional<Place> regenerative_off, eddy_current_emergency_off, eddy_current_service_off, magnetic_shoe_off,
      powerless;
};

/// Special brakes of a gamma train that do not count from `x` on (3.13.5.1), for the emergency or the service brake.
train::BrakeSet brakes_off(const TrackConditions& conditions, const train::TrainData& train, Place x, bool service);

/// Lowest gradient under a train whose front is at x, as a step function of x (3.13.4.2). For a part of the train on
/// track with unknown gradient, 0 is used (safe side). Each step of the input is the lowest one at most once, so the
/// capacity always suffices.
struct CompensatedGradient {
  StepFunction<Place, double, kGradientSteps + 8> permille;
};
CompensatedGradient compensated_gradient(const GradientProfile& profile, Distance L_TRAIN, bool target_due_to_TSR);

/// Stretch of track with constant gradient, brakes and adhesion, from `from` to the next one.
struct Segment {
  Place from{};
  Acceleration A_gradient{};
  double grad = 0.0;           // per mille, compensated
  std::uint8_t emergency = 0;  // index of the stage of brakes, see Decelerations
  std::uint8_t service = 0;
  bool reduced_adhesion = false;
  friend constexpr bool operator==(const Segment&, const Segment&) = default;
};
using Segments = InplaceVector<Segment, kSegments>;
/// The segment that gives a curve its deceleration just upstream of `x`: `x` lies in it or is its end.
std::size_t segment_upstream_of(const Segments& segments, Place x);

/// Speed band: decelerations of the brakes for v^2 <= `w_upto` and above the band before; infinite for the last one.
struct Band {
  SpeedSquared w_upto{};
  std::array<Acceleration, 2> A{};  // normal adhesion, reduced adhesion
  Acceleration Kn_plus{}, Kn_minus{};
  friend constexpr bool operator==(const Band&, const Band&) = default;
};
using Bands = InplaceVector<Band, train::kMergedSteps>;
/// The band that includes the speed; its upper limit belongs to it.
std::size_t band_below(const Bands& bands, SpeedSquared w);

enum class CurveKind : std::uint8_t { EBD, SBD, GUI };

/// Everything that the deceleration depends on. A stage is the set of brakes that count from a
/// place on; along the track brakes can only be lost, so there are at most four stages.
struct Decelerations {
  static constexpr std::size_t kStages = 4;
  std::array<Bands, kStages> safe, expected, normal_service;  // empty normal_service: no GUI
  Segments segments;                                          // never empty; the first one also holds before its start
  Segments segments_for_TSR;                                  // with the default gradient; empty: the same
  Acceleration highest_safe{}, highest_expected{};            // of all bands, without gradient

  const Bands& bands(CurveKind kind, const Segment& s) const;
  const Segments& segments_of(bool due_to_TSR) const {
    return due_to_TSR && !segments_for_TSR.empty() ? segments_for_TSR : segments;
  }
  /// Deceleration at a speed and place (a speed on a step belongs to the lower band, a place on a
  /// border to the segment that begins there).
  Acceleration at(CurveKind kind, Speed V, Place x, bool due_to_TSR = false) const;
};

/// Deceleration in one band and segment.
constexpr Acceleration deceleration(const Band& b, const Segment& s) {
  const Acceleration A = b.A[s.reduced_adhesion ? 1 : 0] + s.A_gradient;
  if (s.grad > 0.0) return A - (s.grad / 1000.0) * b.Kn_plus;
  if (s.grad < 0.0) return A - (s.grad / 1000.0) * b.Kn_minus;
  return A;
}

void determine(Decelerations& out, const train::TrainData& train, const train::NationalValues& values,
               const train::FixedValues& fixed, const train::BrakeStatus& status, const GradientProfile& gradient,
               const TrackConditions& conditions);

/// The same with one gradient everywhere, per mille.
void determine(Decelerations& out, const train::TrainData& train, const train::NationalValues& values,
               const train::FixedValues& fixed, const train::BrakeStatus& status, double permille,
               const TrackConditions& conditions);

/// Traces the curve of `kind` that has speed `V_anchor` at `anchor`: downstream to its foot at `V_foot`
/// (<= V_anchor), upstream to `V_top` (3.13.8.3-5). Where A <= 0 the curve falls upstream; the stored curve is the
/// monotonic one below it. Appends to `out` at most `room` knots.
CurveWarnings trace(std::span<Knot> room, std::size_t& used, const Decelerations& d, CurveKind kind, bool due_to_TSR,
                    Place anchor, Speed V_anchor, Speed V_foot, Speed V_top);

/// The same into a curve of its own.
BrakingCurve trace(const Decelerations& d, CurveKind kind, bool due_to_TSR, Place anchor, Speed V_anchor, Speed V_foot,
                   Speed V_top);

}  // namespace evc::sdm
