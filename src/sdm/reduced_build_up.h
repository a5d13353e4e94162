#pragma once
#include <optional>

#include "base/units.h"
#include "sdm/deceleration.h"
#include "sdm/limits.h"

// A.3.12 of 4.0.0: the equivalent build-up time is shorter if the train reaches the target speed before the brake is
// fully built up. Formulas A.3.12.5-8 are re-derived from the informative annex.
namespace evc::sdm {

/// Lowest brake deceleration (no gradient) and highest deceleration (with it) in a rectangle of place
/// and speed.
struct DecelerationRange {
  Acceleration A_brake_min{};  // A_EB, A_SB
  Acceleration A_max{};        // A_safe_max, A_expected_max
};
/// `from` <= `to`, `V_low` <= `V_high`. With `reduced_from`: adhesion also counts from there (the min
/// safe front end; A.3.12.2.2).
DecelerationRange deceleration_range(const Decelerations& d, CurveKind kind, bool due_to_TSR, Place from, Place to,
                                     Place reduced_from, Speed V_low, Speed V_high);

/// The inputs of the ramp model for one target and one brake.
struct Ramp {
  Duration T{}, T_react{};  // T_be, T_be_react or T_bs, T_bs_react
  Speed v0{};               // V_est + V_delta0, V_est for the service brake
  Speed V_target{};         // 0 with `stop`
  bool stop = false;        // EOA, SvL, SR end
  Acceleration A_est1{}, A_est2{};
  Duration T_traction_max{}, T_traction_min{};
  DecelerationRange A{};
};
/// The same, if A.3.12.3 and .4 already give the result for the strongest deceleration of the brake on any track: then
/// the track between train and target need not be evaluated.
std::optional<Duration> build_up_time_settled(const Ramp& r, Acceleration A_highest);

/// Towards target speeds below this one, and for a stop, the reduced time is T.
Speed full_build_up_below(const Ramp& r, Acceleration A_highest);

/// T_be_reduced or T_bs_reduced; never more than T.
Duration reduced_build_up_time(const Ramp& r);

}  // namespace evc::sdm
