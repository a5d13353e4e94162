#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/step_function.h"
#include "openevc/base/units.h"
#include "openevc/terms/axle_load.h"
#include "openevc/train/speed_steps.h"

namespace evc::train {

/// How the train's brakes are described (3.13.2.2.1): `lambda` by brake percentage and the conversion model, `gamma` by
/// step functions of deceleration.
enum class BrakeModel : std::uint8_t { lambda, gamma };
enum class BrakePosition : std::uint8_t { PassengerP, FreightP, FreightG };

/// What the status of a special brake changes, from its interface (3.13.2.2.6).
enum class SpecialBrakeInterface : std::uint8_t { none, emergency_only, service_only, both };

/// A set of special brakes as bits; a brake model is given per set in use.
using BrakeSet = std::uint8_t;
inline constexpr BrakeSet kRegenerative = 1;
inline constexpr BrakeSet kEddyCurrent = 2;
inline constexpr BrakeSet kMagneticShoe = 4;
inline constexpr BrakeSet kElectroPneumatic = 8;

inline constexpr std::size_t kSpeedSteps = 7;  // 3.13.2.2.3.1.6
inline constexpr std::size_t kConfidenceLevels = 10;

using DecelerationSteps = StepFunction<Speed, Acceleration, kSpeedSteps>;
using KnSteps = StepFunction<Speed, Acceleration, 5>;

/// One speed step of an emergency brake model with its correction factors (3.13.2.2.9.2: they have the
/// same steps).
struct EmergencyStep {
  Acceleration A_brake_emergency{};
  Factor Kwet_rst = Factor::of(1.0);
  std::array<Factor, kConfidenceLevels> Kdry_rst{};  // by M_NVEBCL
  friend constexpr bool operator==(const EmergencyStep&, const EmergencyStep&) = default;
};
using EmergencySteps = StepFunction<Speed, EmergencyStep, kSpeedSteps>;

/// The emergency brake with exactly the special brakes `with` (of regenerative, eddy current,
/// magnetic shoe) contributing.
struct EmergencyModel {
  EmergencySteps steps;
  BrakeSet with = 0;
  friend constexpr bool operator==(const EmergencyModel&, const EmergencyModel&) = default;
};
/// The full service brake with exactly the special brakes `with` (of regenerative, eddy current).
struct ServiceModel {
  DecelerationSteps A_brake_service;
  BrakeSet with = 0;
  friend constexpr bool operator==(const ServiceModel&, const ServiceModel&) = default;
};
/// Build-up time, 3.13.2.2.3.2, and (4.0.0) reaction time (T_brake: is not reduced), with the special brakes `with`.
struct BuildUpTime {
  Duration T_brake{};
  Duration T_brake_react{};
  BrakeSet with = 0;
  friend constexpr bool operator==(const BuildUpTime&, const BuildUpTime&) = default;
};
/// A set of A_brake_normal_service: model 0, 1 or 2 by the full service deceleration at standstill a0: a0 <= A_SB01,
/// a0 <= A_SB12, else (3.13.2.2.3.1.10).
struct NormalServiceModels {
  std::array<DecelerationSteps, 3> A_brake_normal_service{};  // an empty one: not given
  Acceleration A_SB01{};
  Acceleration A_SB12{};
  friend constexpr bool operator==(const NormalServiceModels&, const NormalServiceModels&) = default;
};

/// Values of NC_TRAIN as bits ("other international" categories, 3.11.3.2.2).
inline constexpr std::uint16_t kFreightP = 1;
inline constexpr std::uint16_t kFreightG = 2;
inline constexpr std::uint16_t kPassenger = 4;

using evc::AxleLoad;
using evc::LoadingGauge;
/// One traction system the train accepts: M_VOLTAGE, and NID_CTRACTION with a voltage other than 0.
struct TractionSystem {
  std::uint16_t NID_CTRACTION = 0;
  std::uint8_t M_VOLTAGE = 0;
  friend constexpr bool operator==(const TractionSystem&, const TractionSystem&) = default;
};

/// The train data of 3.18.3 and the fixed train configuration of 3.13.2.2. A default-constructed one
/// is the standard train: a passenger train of 200 m, 160 km/h, 135 % in P.
struct TrainData {
  // Brakes, lambda (3.13.2.2.5).
  BrakeModel brake_model = BrakeModel::lambda;
  BrakePosition brake_position = BrakePosition::PassengerP;
  double brake_percentage = 135.0;
  // Brakes, gamma (3.13.2.2.3, 3.13.2.2.9). A set in use without a model of its own uses the strongest model whose
  // brakes are all in use: to count fewer brakes is the safe side.
  InplaceVector<EmergencyModel, 4> emergency;
  InplaceVector<ServiceModel, 4> service;
  // Times. gamma: required. lambda: optional; a configured service time is used if it is shorter
  // than that of the conversion model (A.3.9); emergency times are not read.
  InplaceVector<BuildUpTime, 4> T_emergency;
  InplaceVector<BuildUpTime, 4> T_service;
  // 3.13.2.2.3.1.9: the set of "Freight train in G", if there is one, and that of the other brake positions.
  NormalServiceModels normal_service;
  std::optional<NormalServiceModels> normal_service_G;
  KnSteps Kn_plus;   // m/s2 per unit of gradient (Kn * grad / 1000), uphill
  KnSteps Kn_minus;  // the same, downhill
  // Special brakes.
  SpecialBrakeInterface regenerative = SpecialBrakeInterface::none;
  SpecialBrakeInterface eddy_current = SpecialBrakeInterface::none;
  SpecialBrakeInterface magnetic_shoe = SpecialBrakeInterface::none;
  SpecialBrakeInterface electro_pneumatic = SpecialBrakeInterface::none;
  bool regenerative_needs_line_voltage = true;  // lost in powerless sections (3.12.1.3.3)
  bool adhesion_independent_brake = false;      // additional brakes count under reduced adhesion (3.13.6.2.1.8)
  // Traction (3.13.2.2.2).
  Duration T_traction_cut_off{2.0};
  bool traction_cut_off_interface = true;
  bool service_brake_interface = true;
  bool service_brake_feedback = false;
  // Dimensions.
  Distance L_TRAIN{200.0};
  Speed V_MAXTRAIN{160.0 / 3.6};
  Distance L_antenna_front{5.0};
  std::optional<double> M_rotating_nom;  // % of the train's weight
  // Category (3.11.3, 3.12.2).
  std::uint16_t cant_deficiency_mm = 130;
  std::uint16_t other_categories = 0;  // bits kFreightP, kFreightG, kPassenger
  AxleLoad axle_load = AxleLoad::A;
  LoadingGauge loading_gauge = LoadingGauge::G1;
  bool airtight = false;
  InplaceVector<TractionSystem, 8> traction_systems;
  std::optional<std::uint16_t> axles;  // their number, at most 1022; absent: not known (N_AXLE 1023)

  friend constexpr bool operator==(const TrainData&, const TrainData&) = default;
};
static_assert(std::is_trivially_copyable_v<TrainData>);
static_assert(sizeof(TrainData) <= 3712);

}  // namespace evc::train
