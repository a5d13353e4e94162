#pragma once
/// The library of braking curves and supervision limits in one header: speed and distance monitoring of
/// SUBSET-026 3.13 for one train approaching one target, with every intermediate value.
///
///     evc::sdm::Inputs in;                       // train, national values, track, target
///     auto derived = std::make_unique<evc::sdm::Derived>();
///     evc::sdm::rebuild(*derived, in);           // curves
///     auto row = evc::sdm::explain(*derived, in, derived->targets.back(), V, V_ura, A_est);
///
/// Units are SI; places are metres along the line in running direction.
#include <optional>

#include "openevc/sdm/braking_curve.h"
#include "openevc/sdm/deceleration.h"
#include "openevc/sdm/inputs.h"
#include "openevc/sdm/limits.h"
#include "openevc/sdm/locations.h"
#include "openevc/sdm/rules.h"
#include "openevc/sdm/supervision.h"

namespace evc::sdm {

/// All limits of one target for one speed, with the values they were computed from. `EBD` is valid
/// for every kind of target (for EOA_SvL: of the SvL); `SBD` only for EOA_SvL.
struct Explanation {
  Approach approach{};
  train::BuildUpTimes build_up{};  // before reduction
  Times times{};
  /// 4.0.0: where the train is whose build-up times are reduced (A.3.12).
  Place est_front{}, min_safe_front{};
  Limits EBD{};
  std::optional<Limits> SBD;
  // The curves' places at the speed.
  Place d_EBD{};
  std::optional<Place> d_SBD, d_GUI;
  // Decelerations at that speed, at the place where the curve has it.
  Acceleration A_safe{}, A_brake_safe{}, A_brake_emergency{};
  Acceleration A_expected{}, A_brake_service{};
  Acceleration A_gradient_EBD{}, A_gradient_SBD{};
  /// Special brakes that count there (3.13.2.2.6, 3.13.5.1).
  train::BrakeSet in_use_emergency{}, in_use_service{};
  /// The more restrictive (nearer) limits of both curves: the FLOI of 3.3.0, and the limits that
  /// are drawn.
  Place d_FLOI{}, d_W{}, d_P{}, d_I{};
};
/// The state of the service brake feedback (A.3.10): pressures in kPa.
struct BrakePressure {
  double p0 = 500.0;     // before braking
  double p = 500.0;      // now
  bool started = false;  // the count of a falling pressure has begun
  bool locked = false;   // T_bs1 = 0, T_bs2 = 2 s
  friend constexpr bool operator==(const BrakePressure&, const BrakePressure&) = default;
};
/// What limits may be asked for beside a given V_ura and A_est.
struct Assumed {
  bool V_ura_of_041 = false;  // f41 of the speed (SUBSET-041 5.3.1.2) instead of the given V_ura
  std::optional<BrakePressure> brake_pressure;
};
/// T_bs1 and T_bs2 towards a target by the assumed pressure; none without a pressure and where the feedback is not
/// available.
std::optional<FeedbackTimes> assumed_feedback(const Derived& derived, const Target& target, const Assumed& assumed);

/// Limits at speed `V`. The reduced build-up times of 4.0.0 depend on the train's front end, given by `motion`; without
/// it, the times are those of a train about to reach its first limit.
Explanation explain(const Derived& derived, const Inputs& in, const Target& target, Speed V, Speed V_ura,
                    Acceleration A_est, const Motion* motion = nullptr, const Assumed& assumed = {});

/// Speeds of one target's curves and limits at a place (3.13.9.3.3.7 ff., not iterated: the supervision
/// limits invert to these only when V_est equals them): the speed V whose limit location is `x`, found by
/// bisection to 1e-9 m/s. The train's estimated front is at `x`, its min safe front end `under_reading` in rear of it:
/// the build-up times of 4.0.0 are reduced from there (A.3.12). Its max safe front end is `over_reading` in advance of
/// it: the limits of the EBD count for that one (3.13.10.2.2). EBD and SBD are the curves at `x`.
struct PositionRow {
  Speed EBD, SBD, EBI, SBI, W, P, I;
};
PositionRow speeds_at(const Derived& derived, const Inputs& in, const Target& target, Place x, Speed V_ura,
                      Acceleration A_est, Distance under_reading = {}, Distance over_reading = {},
                      const Assumed& assumed = {});

/// The MRSP at a place, beyond a limit of authority not above its speed (3.13.9.2.7).
Speed ceiling_at(const Derived& derived, Place x);
/// The same with the ceilings of the MRSP (3.13.9.2) and the floors of the target, as the on-board supervises and shows
/// them: never below V_target with its margins (3.13.9.3.3.7, 3.13.9.3.5.7), none for a target speed of 0; up to the
/// SvL never below the release speed (3.13.10.4.4).
PositionRow supervised_speeds_at(const Derived& derived, const Inputs& in, const Target& target, Place x, Speed V_ura,
                                 Acceleration A_est, Distance under_reading = {}, Distance over_reading = {},
                                 const Assumed& assumed = {});

}  // namespace evc::sdm
