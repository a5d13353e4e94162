#include "train/brake_model.h"

namespace evc::train {
namespace {

struct FaultRow {
  Fault fault;
  Clause clause;
};
constexpr FaultRow kClauses[] = {
    {Fault::none, {}},
    {Fault::brake_percentage, "3.13.3.2.1 b"_srs},
    {Fault::train_length_lambda, "3.13.3.2.1 c"_srs},
    {Fault::maximum_speed_lambda, "3.13.3.2.1 a"_srs},
    {Fault::train_length, "A.3.11"_srs},
    {Fault::maximum_speed, "A.3.11"_srs},
    {Fault::traction_cut_off_time, "3.13.2.2.2"_srs},
    {Fault::antenna, "3.6.4.2"_srs},
    {Fault::rotating_mass, "3.13.2.2.10"_srs},
    {Fault::no_emergency_model, "3.13.2.2.3.1"_srs},
    {Fault::no_service_model, "3.13.2.2.3.1"_srs},
    {Fault::no_emergency_time, "3.13.2.2.3.2"_srs},
    {Fault::no_service_time, "3.13.2.2.3.2"_srs},
    {Fault::deceleration, "3.13.2.2.3.1"_srs},
    {Fault::correction_factor, "3.13.2.2.9.1"_srs},
    {Fault::build_up_time, "3.13.2.2.3.2"_srs},
    {Fault::Kn, "3.13.2.2.9.2.1"_srs},
    {Fault::guidance_without_model, "3.13.8.5.2"_srs},
    {Fault::special_brake_interface, "3.13.2.2.6"_srs},
    {Fault::Kv_int, "3.13.2.3.7.11"_srs},
    {Fault::Kr_int, "3.13.2.3.7.12"_srs},
    {Fault::Kt_int, "3.13.2.3.7.14"_srs},
    {Fault::A_NVP, "3.13.2.3.7.11.5"_srs},
    {Fault::M_NVAVADH, "3.13.2.3.7.6"_srs},
    {Fault::M_NVEBCL, "3.13.2.3.7.5"_srs},
    {Fault::A_NVMAXREDADH, "3.13.2.3.7.7"_srs},
};
static_assert(
    [] {
      for (unsigned i = 0; i < sizeof(kClauses) / sizeof(kClauses[0]); ++i)
        if (static_cast<unsigned>(kClauses[i].fault) != i) return false;
      return sizeof(kClauses) / sizeof(kClauses[0]) == static_cast<unsigned>(Fault::count);
    }(),
    "one row for each fault, in order");

constexpr bool within(double v, double low, double high) { return v >= low && v <= high; }  // false for NaN

template <class Steps>
bool valid_deceleration(const Steps& steps) {
  if (steps.empty() || steps.steps[0].from.si != 0.0) return false;
  for (const auto& s : steps.steps)
    if (!within(s.value.si, 0.0, 10.0)) return false;
  return true;
}
template <class Models>
bool has_model_without_special_brakes(const Models& models) {
  for (const auto& m : models)
    if (m.with == 0) return true;
  return false;
}
bool valid_time(const BuildUpTime& t) {
  return within(t.T_brake.si, 0.0, 1000.0) && within(t.T_brake_react.si, 0.0, t.T_brake.si);
}
bool valid_Kn(const KnSteps& k) { return k.empty() || valid_deceleration(k); }

Fault check_lambda(const TrainData& t) {
  if (!within(t.brake_percentage, 30.0, 250.0)) return Fault::brake_percentage;
  if (t.V_MAXTRAIN.si * 3.6 > 200.0 + 1e-9) return Fault::maximum_speed_lambda;
  if (!conversion_model_applies(t)) return Fault::train_length_lambda;
  return Fault::none;
}

Fault check_gamma(const TrainData& t) {
  if (!has_model_without_special_brakes(t.emergency)) return Fault::no_emergency_model;
  if (!has_model_without_special_brakes(t.service)) return Fault::no_service_model;
  if (!has_model_without_special_brakes(t.T_emergency)) return Fault::no_emergency_time;
  if (!has_model_without_special_brakes(t.T_service)) return Fault::no_service_time;
  for (const EmergencyModel& m : t.emergency) {
    if (m.steps.empty() || m.steps.steps[0].from.si != 0.0) return Fault::deceleration;
    for (const auto& s : m.steps.steps) {
      if (!within(s.value.A_brake_emergency.si, 0.0, 10.0)) return Fault::deceleration;
      if (s.value.Kwet_rst.value() > 1.0) return Fault::correction_factor;
      for (const Factor k : s.value.Kdry_rst)
        if (k.value() > 1.0) return Fault::correction_factor;
    }
  }
  for (const ServiceModel& m : t.service)
    if (!valid_deceleration(m.A_brake_service)) return Fault::deceleration;
  for (const BuildUpTime& time : t.T_emergency)
    if (!valid_time(time)) return Fault::build_up_time;
  return Fault::none;
}

bool allowed(SpecialBrakeInterface i, bool emergency_only, bool service_only) {
  if (i == SpecialBrakeInterface::emergency_only) return emergency_only;
  return i != SpecialBrakeInterface::service_only || service_only;
}

/// Three models or none.
Fault check_normal_service(const NormalServiceModels& set) {
  bool any = false;
  bool all = true;
  for (const DecelerationSteps& model : set.A_brake_normal_service) {
    if (!model.empty() && !valid_deceleration(model)) return Fault::deceleration;
    any = any || !model.empty();
    all = all && !model.empty();
  }
  return any && !all ? Fault::guidance_without_model : Fault::none;
}

bool valid(const MaxReducedAdhesion& a) { return a.no_maximum || within(a.A.si, 0.0, 3.15 + 1e-12); }

}  // namespace

Clause clause(Fault fault) { return kClauses[static_cast<unsigned>(fault)].clause; }

Fault check(const TrainData& t) {
  if (!within(t.L_TRAIN.si, 1e-9, 4095.0)) return Fault::train_length;
  if (!within(t.V_MAXTRAIN.si, 1e-9, 600.0 / 3.6 + 1e-9)) return Fault::maximum_speed;
  if (!within(t.T_traction_cut_off.si, 0.0, 1000.0)) return Fault::traction_cut_off_time;
  if (!within(t.L_antenna_front.si, 0.0, t.L_TRAIN.si)) return Fault::antenna;
  if (t.M_rotating_nom.has_value() && !within(*t.M_rotating_nom, 0.0, 100.0)) return Fault::rotating_mass;
  // 3.13.2.2.6: the magnetic shoe cannot affect the service brake, Ep not the emergency brake alone.
  if (!allowed(t.magnetic_shoe, true, false) || t.magnetic_shoe == SpecialBrakeInterface::both ||
      !allowed(t.electro_pneumatic, false, true))
    return Fault::special_brake_interface;
  if (!valid_Kn(t.Kn_plus) || !valid_Kn(t.Kn_minus)) return Fault::Kn;
  for (const BuildUpTime& time : t.T_service)
    if (!valid_time(time)) return Fault::build_up_time;
  if (const Fault fault = check_normal_service(t.normal_service); fault != Fault::none) return fault;
  if (t.normal_service_G)
    if (const Fault fault = check_normal_service(*t.normal_service_G); fault != Fault::none) return fault;
  return t.brake_model == BrakeModel::lambda ? check_lambda(t) : check_gamma(t);
}

Fault check(const NationalValues& v) {
  if (v.Kv_int_freight.empty() || v.Kv_int_passenger.empty()) return Fault::Kv_int;
  for (const auto& s : v.Kv_int_freight.steps)
    if (!within(s.value, 0.0, 2.54)) return Fault::Kv_int;
  for (const auto& s : v.Kv_int_passenger.steps)
    if (!within(s.value.a, 0.0, 2.54) || !within(s.value.b, 0.0, 2.54)) return Fault::Kv_int;
  if (v.Kr_int.empty()) return Fault::Kr_int;
  for (const auto& s : v.Kr_int.steps)
    if (!within(s.value, 0.0, 1.55)) return Fault::Kr_int;
  if (!within(v.Kt_int, 0.0, 1.55)) return Fault::Kt_int;
  if (!(v.A_NVP12 <= v.A_NVP23)) return Fault::A_NVP;
  if (!within(v.M_NVAVADH, 0.0, 1.0)) return Fault::M_NVAVADH;
  if (v.M_NVEBCL >= kConfidenceLevels) return Fault::M_NVEBCL;
  if (!valid(v.A_NVMAXREDADH1) || !valid(v.A_NVMAXREDADH2) || !valid(v.A_NVMAXREDADH3)) return Fault::A_NVMAXREDADH;
  return Fault::none;
}

}  // namespace evc::train
