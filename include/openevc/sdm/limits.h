#pragma once
#include <optional>

#include "openevc/base/units.h"
#include "openevc/sdm/braking_curve.h"
#include "openevc/sdm/rules.h"
#include "openevc/train/brake_model.h"
#include "openevc/train/fixed_values.h"

// The braking to target supervision limits of 3.13.9.3. Every structure keeps the intermediate values
// with the standard's symbols: `evc curves --explain` prints the values that were computed.
namespace evc::sdm {

/// dV_ebi, dV_sbi, dV_warning of 3.13.9.2 for a ceiling speed.
Speed dV_ebi(Speed V, const train::FixedValues& fixed);
Speed dV_sbi(Speed V, const train::FixedValues& fixed);
Speed dV_warning(Speed V, const train::FixedValues& fixed);

/// The times of 3.13.9.3.2-6 that hold for one class of targets.
struct Times {
  Duration T_be, T_bs;    // build-up times in use (4.0.0: reduced)
  Duration T_bs1, T_bs2;  // 3.13.9.3.3
  Duration T_traction;    // 3.13.9.3.2.3
  Duration T_berem;       // 3.13.9.3.2.6
  Duration T_indication;  // 3.13.9.3.6
  friend constexpr bool operator==(const Times&, const Times&) = default;
};

/// The train data and national values on which the times depend.
struct TimeConfig {
  Duration T_traction_cut_off{};
  bool traction_cut_off_interface = false;
  bool service_brake_available = false;
  bool feedback_available = false;
  friend constexpr bool operator==(const TimeConfig&, const TimeConfig&) = default;
};
TimeConfig time_config(const train::TrainData& train, const train::NationalValues& values);

/// `T_bs1`, `T_bs2` by the service brake feedback, where it is available (A.3.10).
struct FeedbackTimes {
  Duration T_bs1, T_bs2;
};
/// T_traction of 3.13.9.3.2.3: where a cut-off is fitted, traction is cut off already at the Warning limit.
Duration T_traction(const TimeConfig& config, Duration T_bs2, const train::FixedValues& fixed);
Times times(const TimeConfig& config, const train::BuildUpTimes& build_up, const std::optional<FeedbackTimes>& feedback,
            const Rules& rules, const train::FixedValues& fixed);

/// The speed for which the limits are valid, with its compensations.
struct Approach {
  Speed V{};         // V_est, or the speed that a clause uses instead
  Speed V_delta0{};  // 3.13.9.3.2.1; 0 where Q_NVINHSMICPERM
  Acceleration A_est1{}, A_est2{};
};
/// A_est1 = max(A_est, 0), A_est2 = that, at most 0.4 m/s2 (3.13.9.3.2.8-9).
Approach approach(Speed V, Speed V_delta0, Acceleration A_est, const train::FixedValues& fixed);

/// Speed and distance between the intervention and the full effort (3.13.9.3.2.10).
struct BuildUpLoss {
  Speed V_delta1, V_delta2, V_bec;
  Distance D_bec;
};
BuildUpLoss before_emergency_effort(const Approach& a, const Times& t, Speed V_target);
/// The same for display: without V_target (3.13.9.3.3.8).
Distance D_be_display(const Approach& a, const Times& t);

/// Limits of one curve, as places: of an EBD (d_EBI, d_SBI2 against the max safe front end) or of an
/// SBD (d_SBI1 against the estimated front end; d_EBI absent).
struct Limits {
  BuildUpLoss loss{};  // EBD only
  Place d_curve{};     // d_EBD(V_bec) or d_SBD(V)
  std::optional<Place> d_EBI;
  Place d_SBI{};
  Place d_W{};
  Place d_P{};
  Place d_I{};
  std::optional<Place> d_GUI;  // d_GUI(V) where guidance is in use
};
/// `d_target`: given where d_P may not be beyond it (4.0.0, EBD without guidance).
Limits limits_of_EBD(CurveView EBD, CurveView GUI, const Approach& a, const Times& t, Speed V_target,
                     const std::optional<Place>& d_target, const train::FixedValues& fixed);
Limits limits_of_SBD(CurveView SBD, CurveView GUI, const Approach& a, const Times& t, const train::FixedValues& fixed);

/// Speeds at the train's place (3.13.9.3.3.7-8, 3.13.9.3.5.5-8), for display; V_I by T_indication more (3.13.9.3.6).
struct LimitSpeeds {
  Speed V_EBI, V_SBI, V_W, V_P, V_I;
};
LimitSpeeds speeds_of_EBD(CurveView EBD, CurveView GUI, const Approach& a, const Times& t, Speed V_target,
                          Place d_maxsafefront, const train::FixedValues& fixed);
/// V_EBI is 0: there is no EBI for an EOA.
LimitSpeeds speeds_of_SBD(CurveView SBD, CurveView GUI, const Approach& a, const Times& t, Place d_EOA,
                          Place d_estfront, const train::FixedValues& fixed);

/// d_P(V_target) of 3.13.9.3.5.9-10: from which the displayed target distance counts.
Place d_P_at_target_speed(CurveView EBD, Speed V_target, Place d_target, const Times& t,
                          const train::BuildUpTimes& build_up, const TimeConfig& config, Speed V_delta0t,
                          const Rules& rules, const train::FixedValues& fixed);

}  // namespace evc::sdm
