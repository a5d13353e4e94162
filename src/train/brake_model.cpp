#include "train/brake_model.h"

#include <algorithm>

namespace evc::train {
namespace {

constexpr double kmh(Speed v) { return v.si * 3.6; }

/// x^0.428 with correctly rounded operations only (no libm): the exponent in binary, each bit a
/// repeated square root. 0.428 = sum of bits / 2^k, 52 bits. x > 0.
double to_the_0_428(double x) {
  double exponent = 0.428;
  double root = x;
  double product = 1.0;
  for (int k = 0; k < 52; ++k) {
    root = __builtin_sqrt(root);
    exponent = exponent * 2.0;
    if (exponent >= 1.0) {
      exponent = exponent - 1.0;
      product = product * root;
    }
  }
  return product;
}

template <class Function, class Axis, class Value>
void append(Function& f, Axis from, Value value) {
  const bool room = f.append(from, value);
  EVC_REQUIRE(room);
}

int members(BrakeSet set) {
  int n = 0;
  for (unsigned bits = set; bits != 0; bits &= bits - 1) ++n;
  return n;
}

/// The model for exactly the brakes in use, else the one with the most of them; a model never
/// counts a brake that is not in use. nullptr only when there is no model for the empty set either.
template <class Models>
const typename Models::value_type* choose(const Models& models, BrakeSet in_use) {
  const typename Models::value_type* best = nullptr;
  for (const auto& model : models) {
    if ((model.with & static_cast<BrakeSet>(~in_use)) != 0) continue;
    if (best == nullptr || members(model.with) > members(best->with)) best = &model;
  }
  return best;
}

constexpr Distance kShort{900.0};

/// Reaction times of 4.0.0, A.3.8.6 and A.3.9.8: {emergency, service}.
struct Reaction {
  double emergency, service;
};
constexpr Reaction reaction(BrakePosition position) {
  switch (position) {
    case BrakePosition::FreightP:
      return {2.99, 2.07};
    case BrakePosition::FreightG:
      return {9.30, 5.70};
    case BrakePosition::PassengerP:
      break;
  }
  return {1.42, 1.06};
}

constexpr bool affects_emergency(SpecialBrakeInterface i) {
  return i == SpecialBrakeInterface::emergency_only || i == SpecialBrakeInterface::both;
}
constexpr bool affects_service(SpecialBrakeInterface i) {
  return i == SpecialBrakeInterface::service_only || i == SpecialBrakeInterface::both;
}
constexpr BrakeSet with(bool counted, BrakeSet brake) { return counted ? brake : BrakeSet{0}; }

}  // namespace

bool conversion_model_applies(const TrainData& train) {
  const double longest = train.brake_position == BrakePosition::PassengerP ? 900.0 : 1500.0;
  return kmh(train.V_MAXTRAIN) <= 200.0 + 1e-9 && train.brake_percentage >= 30.0 && train.brake_percentage <= 250.0 &&
         train.L_TRAIN.si <= longest;
}

BasicBuildUpTime basic_emergency_time(BrakePosition position, Distance L) {
  if (position == BrakePosition::FreightG)
    return L <= kShort ? BasicBuildUpTime{12.00, 0.0, 0.05, false} : BasicBuildUpTime{-0.40, 1.60, 0.03, false};
  if (position == BrakePosition::FreightP && L > kShort) return {-0.40, 1.60, 0.03, true};
  return {2.30, 0.0, 0.17, true};
}
BasicBuildUpTime basic_service_time(BrakePosition position, Distance L) {
  if (position == BrakePosition::PassengerP) return {3.00, 1.50, 0.10, false};
  const bool at_least_400_m = position == BrakePosition::FreightG;
  return L <= kShort ? BasicBuildUpTime{3.00, 2.77, 0.0, at_least_400_m}
                     : BasicBuildUpTime{10.50, 0.32, 0.18, at_least_400_m};
}

Speed V_lim(double lambda0) { return {16.85 * to_the_0_428(lambda0) / 3.6}; }

DecelerationSteps A_basic(double lambda0) {
  DecelerationSteps steps;
  append(steps, Speed{0.0}, Acceleration{AD_0(lambda0)});
  Speed from = V_lim(lambda0);
  for (const BasicDecelerationStep& p : kAD) {
    const Speed limit{p.upto_kmh / 3.6};
    if (from >= limit) continue;
    append(steps, from, Acceleration{p.at(lambda0)});
    from = limit;
  }
  return steps;
}

BrakeSet in_use_emergency(const TrainData& t, const BrakeStatus& s, BrakeSet inhibited) {
  const unsigned set = with(affects_emergency(t.regenerative) && s.regenerative, kRegenerative) |
                       with(affects_emergency(t.eddy_current) && s.eddy_current, kEddyCurrent) |
                       with(affects_emergency(t.magnetic_shoe) && s.magnetic_shoe, kMagneticShoe) |
                       with(affects_emergency(t.electro_pneumatic) && s.electro_pneumatic, kElectroPneumatic);
  return static_cast<BrakeSet>(set & ~static_cast<unsigned>(inhibited));
}
BrakeSet in_use_service(const TrainData& t, const BrakeStatus& s, BrakeSet inhibited) {
  const unsigned set = with(affects_service(t.regenerative) && s.regenerative, kRegenerative) |
                       with(affects_service(t.eddy_current) && s.eddy_current, kEddyCurrent) |
                       with(affects_service(t.electro_pneumatic) && s.electro_pneumatic, kElectroPneumatic);
  return static_cast<BrakeSet>(set & ~static_cast<unsigned>(inhibited));
}

const EmergencyModel* emergency_model(const TrainData& train, BrakeSet in_use) {
  return choose(train.emergency, in_use);
}

DecelerationSteps A_brake_emergency(const TrainData& train, BrakeSet in_use) {
  if (train.brake_model == BrakeModel::lambda) return A_basic(train.brake_percentage);
  DecelerationSteps steps;
  const EmergencyModel* model = emergency_model(train, in_use);
  if (model == nullptr) {
    append(steps, Speed{0.0}, Acceleration{0.0});
    return steps;
  }
  for (const auto& step : model->steps.steps) append(steps, step.from, step.value.A_brake_emergency);
  return steps;
}

DecelerationSteps A_brake_service(const TrainData& train, BrakeSet in_use) {
  if (train.brake_model == BrakeModel::lambda) return A_basic(std::min(train.brake_percentage, 135.0));
  const ServiceModel* model = choose(train.service, in_use);
  if (model != nullptr) return model->A_brake_service;
  DecelerationSteps none;
  append(none, Speed{0.0}, Acceleration{0.0});
  return none;
}

NationalValues::KvFreight Kv_int(const TrainData& train, const NationalValues& values) {
  if (train.brake_position != BrakePosition::PassengerP) return values.Kv_int_freight;
  // 3.13.6.2.1.8.2: the maximum between 0 and the maximum speed of the train.
  const DecelerationSteps A = A_brake_emergency(train, 0);
  double A_ebmax = A.steps.front().value.si;
  for (const auto& step : A.steps)
    if (step.from < train.V_MAXTRAIN) A_ebmax = std::max(A_ebmax, step.value.si);
  NationalValues::KvFreight kv;
  for (const auto& step : values.Kv_int_passenger.steps) {
    const KvPair k = step.value;
    double v = k.a;
    if (A_ebmax > values.A_NVP12.si) {
      v = k.b;
      if (A_ebmax < values.A_NVP23.si)
        v = k.a + (A_ebmax - values.A_NVP12.si) / (values.A_NVP23.si - values.A_NVP12.si) * (k.b - k.a);
    }
    append(kv, step.from, v);
  }
  return kv;
}

MergedSteps A_brake_safe(const TrainData& train, const NationalValues& values, BrakeSet in_use) {
  MergedSteps safe;
  if (train.brake_model == BrakeModel::gamma) {
    const EmergencyModel* model = emergency_model(train, in_use);
    if (model == nullptr) {
      append(safe, Speed{0.0}, Acceleration{0.0});
      return safe;
    }
    const std::size_t level = std::min<std::size_t>(values.M_NVEBCL, kConfidenceLevels - 1);
    for (const auto& step : model->steps.steps) {
      const double Kdry = step.value.Kdry_rst[level].value();
      const double Kwet = step.value.Kwet_rst.value();
      const double K = Kdry * (Kwet + values.M_NVAVADH * (1.0 - Kwet));
      append(safe, step.from, Acceleration{K * step.value.A_brake_emergency.si});
    }
    return safe;
  }
  const DecelerationSteps A = A_basic(train.brake_percentage);
  const NationalValues::KvFreight kv = Kv_int(train, values);
  const double Kr = value_below(values.Kr_int, train.L_TRAIN);
  std::size_t a = 0;
  std::size_t k = 0;
  Speed from{0.0};
  for (;;) {
    append(safe, from, Acceleration{kv.steps[k].value * Kr * A.steps[a].value.si});
    const bool more_a = a + 1 < A.size();
    const bool more_k = k + 1 < kv.size();
    if (!more_a && !more_k) return safe;
    const bool take_a = more_a && (!more_k || A.steps[a + 1].from <= kv.steps[k + 1].from);
    const bool take_k = more_k && (!more_a || kv.steps[k + 1].from <= A.steps[a + 1].from);
    if (take_a) from = A.steps[++a].from;
    if (take_k) from = kv.steps[++k].from;
  }
}

DecelerationSteps A_brake_normal_service(const TrainData& train, Acceleration a0) {
  const bool in_G = train.brake_position == BrakePosition::FreightG && train.normal_service_G;
  const NormalServiceModels& m = in_G ? *train.normal_service_G : train.normal_service;
  if (a0 <= m.A_SB01) return m.A_brake_normal_service[0];
  if (a0 <= m.A_SB12) return m.A_brake_normal_service[1];
  return m.A_brake_normal_service[2];
}

MaxReducedAdhesion A_MAXREDADH(const TrainData& train, const NationalValues& v, const BrakeStatus& status) {
  if (train.brake_position != BrakePosition::PassengerP) return v.A_NVMAXREDADH3;
  return train.adhesion_independent_brake && status.adhesion_independent ? v.A_NVMAXREDADH1 : v.A_NVMAXREDADH2;
}

BuildUpTimes build_up_times(const TrainData& train, const NationalValues& values, const BrakeStatus& status,
                            bool target_is_zero) {
  const BuildUpTime* service = choose(train.T_service, in_use_service(train, status, 0));
  if (train.brake_model == BrakeModel::gamma) {
    const BuildUpTime* emergency = choose(train.T_emergency, in_use_emergency(train, status, 0));
    BuildUpTimes t{};
    if (emergency != nullptr) {
      t.T_be = emergency->T_brake;
      t.T_be_react = emergency->T_brake_react;
    }
    if (service != nullptr) {
      t.T_bs = service->T_brake;
      t.T_bs_react = service->T_brake_react;
    }
    return t;
  }
  const double factor = target_is_zero ? 1.0 : kto(train.brake_position);
  const double T_brake_emergency_cm =
      factor * basic_emergency_time(train.brake_position, train.L_TRAIN).at(train.L_TRAIN).si;
  const double T_brake_service_cm =
      factor * basic_service_time(train.brake_position, train.L_TRAIN).at(train.L_TRAIN).si;
  const Reaction react = reaction(train.brake_position);
  BuildUpTimes t{};
  t.T_be = {values.Kt_int * T_brake_emergency_cm};
  t.T_be_react = {values.Kt_int * react.emergency};
  t.T_bs = {T_brake_service_cm};
  t.T_bs_react = {react.service};
  // A.3.9: the model gives the longest time; a shorter configured one is used.
  if (service != nullptr) {
    t.T_bs = std::min(t.T_bs, service->T_brake);
    t.T_bs_react = std::min(t.T_bs_react, service->T_brake_react);
  }
  return t;
}

Acceleration A_gradient(double grad, const TrainData& train, const FixedValues& fixed) {
  double m = grad > 0.0 ? fixed.M_rotating_max : fixed.M_rotating_min;
  if (train.M_rotating_nom.has_value()) m = *train.M_rotating_nom;
  return {fixed.g.si * grad / (1000.0 + 10.0 * m)};
}

Speed f41(Speed V) {
  const double v = kmh(V);
  return {(v <= 30.0 ? 2.0 : 2.0 + (v - 30.0) * 10.0 / 470.0) / 3.6};
}

}  // namespace evc::train
