#pragma once
#include <cstdint>
#include <optional>

#include "openevc/base/step_function.h"
#include "openevc/base/units.h"
#include "openevc/terms/clause.h"
#include "openevc/terms/srs_version.h"
#include "openevc/train/fixed_values.h"
#include "openevc/train/national_values.h"
#include "openevc/train/train_data.h"

// From train data and national values to the decelerations and times of 3.13.6. All step functions here
// are read with `value_below` (a step includes its upper limit).
namespace evc::train {

/// Which special brakes are active now (3.13.2.2.6), from the train interface. A brake without an
/// interface is not counted at all.
struct BrakeStatus {
  bool regenerative = true, eddy_current = true, magnetic_shoe = true, electro_pneumatic = true;
  bool adhesion_independent = false;
  friend constexpr bool operator==(const BrakeStatus&, const BrakeStatus&) = default;
};

/// Why train data or national values cannot be used. `clause()` names the paragraph.
enum class Fault : std::uint8_t {
  none,
  brake_percentage,         // lambda outside 30..250 %
  train_length_lambda,      // longer than the conversion model covers
  maximum_speed_lambda,     // faster than 200 km/h with the conversion model
  train_length,             // 0 < L <= 4095 m
  maximum_speed,            // 0 < V <= 600 km/h
  traction_cut_off_time,    // < 0
  antenna,                  // < 0
  rotating_mass,            // outside M_rotating_min..max
  no_emergency_model,       // gamma without A_brake_emergency for the case without special brakes
  no_service_model,         // the same for A_brake_service
  no_emergency_time,        // the same for T_brake_emergency
  no_service_time,          // the same for T_brake_service
  deceleration,             // negative, or the first step is not 0
  correction_factor,        // Kdry_rst, Kwet_rst outside 0..1
  build_up_time,            // negative, or shorter than the reaction time
  Kn,                       // outside 0..10 m/s2
  guidance_without_model,   // Q_NVGUIPERM is set but no normal service model is given
  special_brake_interface,  // a combination that 3.13.2.2.6 does not allow
  Kv_int,                   // empty, or outside 0..2.54
  Kr_int,                   // empty, or outside 0..1.55
  Kt_int,                   // outside 0..1.55
  A_NVP,                    // A_NVP12 > A_NVP23
  M_NVAVADH,                // outside 0..1
  M_NVEBCL,                 // above 9
  A_NVMAXREDADH,            // outside 0..3.15 m/s2
  count
};
/// The paragraph that the fault violates; none for `none`.
Clause clause(Fault fault);

/// The first fault found, `Fault::none` when everything is in range.
Fault check(const TrainData& train);
Fault check(const NationalValues& values);

/// 3.13.3.2: speed, percentage and length within the validity limits of the conversion model.
bool conversion_model_applies(const TrainData& train);

/// The basic deceleration A_basic(V) of A.3.7 for a brake percentage (already limited to 135 for service).
DecelerationSteps A_basic(double lambda0);
/// V_lim of A.3.7, m/s.
Speed V_lim(double lambda0);
/// AD_n of A.3.7.5-6, n = 1..5: a3 lambda0^3 + a2 lambda0^2 + a1 lambda0 + a0, up to a speed (the last one to any).
struct BasicDecelerationStep {
  double a3, a2, a1, a0, upto_kmh;
  constexpr double at(double lambda0) const { return ((a3 * lambda0 + a2) * lambda0 + a1) * lambda0 + a0; }
};
inline constexpr BasicDecelerationStep kAD[] = {
    {-6.30e-7, 6.10e-5, 4.72e-3, 0.0663, 100.0}, {2.73e-7, -4.54e-6, 5.14e-3, 0.1300, 120.0},
    {5.58e-8, -6.76e-6, 5.81e-3, 0.0479, 150.0}, {3.00e-8, -3.85e-6, 5.52e-3, 0.0480, 180.0},
    {3.23e-9, 1.66e-6, 5.06e-3, 0.0559, 1e9},
};
/// AD_0 of A.3.7.4, from standstill to V_lim.
constexpr double AD_0(double lambda0) { return 0.0075 * lambda0 + 0.076; }

/// T_brake_basic = a + b (L/100) + c (L/100)^2 of A.3.8.1-3 and A.3.9.1-3.
struct BasicBuildUpTime {
  double a, b, c;
  bool at_least_400_m;  // L = max(400 m, L_TRAIN)
  constexpr double length(Distance L_TRAIN) const { return at_least_400_m && L_TRAIN.si < 400.0 ? 400.0 : L_TRAIN.si; }
  constexpr Duration at(Distance L_TRAIN) const {
    const double l = length(L_TRAIN) / 100.0;
    return {a + b * l + c * (l * l)};
  }
};
BasicBuildUpTime basic_emergency_time(BrakePosition position, Distance L_TRAIN);
BasicBuildUpTime basic_service_time(BrakePosition position, Distance L_TRAIN);
/// kto of A.3.8.5, for targets with V_target > 0.
constexpr double kto(BrakePosition position) { return position == BrakePosition::FreightG ? 1.16 : 1.20; }

/// Special brakes that count for the emergency brake, service brake: fitted with an interface that
/// affects it, active, and not in `inhibited`.
BrakeSet in_use_emergency(const TrainData& train, const BrakeStatus& status, BrakeSet inhibited);
BrakeSet in_use_service(const TrainData& train, const BrakeStatus& status, BrakeSet inhibited);

inline constexpr std::size_t kMergedSteps = 16;
using MergedSteps = StepFunction<Speed, Acceleration, kMergedSteps>;

/// The emergency brake model for the special brakes `in_use` (gamma): the model for exactly these, else the one with
/// the most of them; null when there is none.
const EmergencyModel* emergency_model(const TrainData& train, BrakeSet in_use);
/// A_brake_emergency(V) with the special brakes `in_use` (gamma), or of the conversion model.
DecelerationSteps A_brake_emergency(const TrainData& train, BrakeSet in_use);
/// A_brake_service(V), the same.
DecelerationSteps A_brake_service(const TrainData& train, BrakeSet in_use);
/// A_brake_safe(V) of 3.13.6.2.1.4: with Kdry_rst, Kwet_rst, M_NVEBCL, M_NVAVADH (gamma) or Kv_int, Kr_int.
MergedSteps A_brake_safe(const TrainData& train, const NationalValues& values, BrakeSet in_use);
/// A_brake_normal_service(V) of the set of the brake position, selected by A_brake_service(V = 0) (3.13.2.2.3.1.9,
/// .10); empty when not given.
DecelerationSteps A_brake_normal_service(const TrainData& train, Acceleration A_brake_service_0);
/// Kv_int(V) for this train (3.13.6.2.1.8).
NationalValues::KvFreight Kv_int(const TrainData& train, const NationalValues& values);
/// The maximum deceleration under reduced adhesion that applies to this train (3.13.6.2.1.6).
MaxReducedAdhesion A_MAXREDADH(const TrainData& train, const NationalValues& values, const BrakeStatus& status);

/// Build-up and reaction times of 3.13.6.2.2 and 3.13.6.3.2.
struct BuildUpTimes {
  Duration T_be, T_be_react, T_bs, T_bs_react;
  friend constexpr bool operator==(const BuildUpTimes&, const BuildUpTimes&) = default;
};
/// `target_is_zero`: V_target = 0 (cm0), else the times of the conversion model are multiplied by kto.
BuildUpTimes build_up_times(const TrainData& train, const NationalValues& values, const BrakeStatus& status,
                            bool target_is_zero);

/// SB command and feedback available (3.13.10.4.9, 3.13.2.2.7).
constexpr bool service_brake_available(const TrainData& t, const NationalValues& v) {
  return t.service_brake_interface && v.Q_NVSBTSMPERM;
}
constexpr bool service_brake_feedback_available(const TrainData& t, const NationalValues& v) {
  return t.service_brake_feedback && v.Q_NVSBFBPERM;
}

/// A_gradient of 3.13.4.3.2 for a gradient in per mille (uphill positive).
Acceleration A_gradient(double grad, const TrainData& train, const FixedValues& fixed);

/// The speed measurement accuracy that SUBSET-041 5.3.1.2 requires: f41(V), 2 km/h up to 30 km/h,
/// then linear to 12 km/h at 500 km/h.
Speed f41(Speed V);

}  // namespace evc::train
