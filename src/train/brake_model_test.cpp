#include "train/brake_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "base/test_units.h"

namespace {

using namespace evc;
using namespace evc::train;

using evc::test::kmh;

TEST(Factor, KeepsDecimalsOfEightPlaces) {
  for (int i = 0; i <= 100000; ++i) {
    const double v = i / 100000.0;
    ASSERT_EQ(Factor::of(v).value(), v) << v;
  }
  EXPECT_EQ(Factor::of(-1.0).value(), 0.0);
  EXPECT_EQ(Factor::of(100.0).value(), 42.0);
  EXPECT_LE(Factor::of(1.0 / 3.0).value(), 1.0 / 3.0);
}

TEST(SpeedSteps, AStepIncludesItsUpperLimit) {
  DecelerationSteps f;
  ASSERT_TRUE(f.append(kmh(0), {1.0}));
  ASSERT_TRUE(f.append(kmh(100), {0.8}));
  EXPECT_EQ(value_below(f, kmh(0)).si, 1.0);
  EXPECT_EQ(value_below(f, kmh(100)).si, 1.0);
  EXPECT_EQ(value_below(f, kmh(100.001)).si, 0.8);
}

TEST(ConversionModel, BasicDecelerationOf100Percent) {
  // By hand: 0.75 + 0.076 up to V_lim = 16.85 * 100^0.428, then AD_3 and on (V_lim is above 120).
  const DecelerationSteps A = A_basic(100.0);
  ASSERT_EQ(A.size(), 4u);
  EXPECT_NEAR(A.steps[0].value.si, 0.826, 1e-12);
  EXPECT_NEAR(A.steps[1].from.si * 3.6, 120.948338079, 1e-8);
  EXPECT_NEAR(A.steps[1].value.si, 5.58e-2 - 6.76e-2 + 0.581 + 0.0479, 1e-12);
  EXPECT_NEAR(A.steps[2].from.si * 3.6, 150.0, 1e-9);
  EXPECT_NEAR(A.steps[2].value.si, 3.00e-2 - 3.85e-2 + 0.552 + 0.0480, 1e-12);
  EXPECT_NEAR(A.steps[3].value.si, 3.23e-3 + 1.66e-2 + 0.506 + 0.0559, 1e-12);
}

TEST(ConversionModel, AllFiveStepsForALowPercentage) {
  // 30 %: V_lim = 72.2 km/h, so AD_1 holds from there.
  const DecelerationSteps A = A_basic(30.0);
  ASSERT_EQ(A.size(), 6u);
  EXPECT_NEAR(A.steps[0].value.si, 0.301, 1e-12);
  EXPECT_NEAR(A.steps[1].from.si * 3.6, 16.85 * std::pow(30.0, 0.428), 1e-9);
  EXPECT_NEAR(A.steps[1].value.si, -6.30e-7 * 27000 + 6.10e-5 * 900 + 4.72e-3 * 30 + 0.0663, 1e-12);
  EXPECT_NEAR(A.steps[2].value.si, 2.73e-7 * 27000 - 4.54e-6 * 900 + 5.14e-3 * 30 + 0.13, 1e-12);
}

TEST(ConversionModel, PowerWithoutALibrary) {
  for (double l = 30.0; l <= 250.0; l += 0.5)
    ASSERT_NEAR(V_lim(l).si * 3.6, 16.85 * std::pow(l, 0.428), 1e-11 * 180.0) << l;
}

TEST(ConversionModel, LimitsOfValidity) {
  TrainData t;
  EXPECT_TRUE(conversion_model_applies(t));
  t.V_MAXTRAIN = kmh(200);
  EXPECT_TRUE(conversion_model_applies(t));
  t.V_MAXTRAIN = kmh(205);
  EXPECT_FALSE(conversion_model_applies(t));
  t = {};
  t.brake_percentage = 29.9;
  EXPECT_FALSE(conversion_model_applies(t));
  t.brake_percentage = 250.1;
  EXPECT_FALSE(conversion_model_applies(t));
  t = {};
  t.L_TRAIN = {900.0};
  EXPECT_TRUE(conversion_model_applies(t));
  t.L_TRAIN = {901.0};
  EXPECT_FALSE(conversion_model_applies(t));
  t.brake_position = BrakePosition::FreightG;
  t.L_TRAIN = {1500.0};
  EXPECT_TRUE(conversion_model_applies(t));
  t.L_TRAIN = {1501.0};
  EXPECT_FALSE(conversion_model_applies(t));
}

struct TimeCase {
  BrakePosition position;
  double L, emergency, service;
};

TEST(ConversionModel, BuildUpTimes) {
  // a + b l + c l^2 by hand, l in hundreds of metres (A.3.8.2, A.3.9.2).
  const TimeCase cases[] = {
      {BrakePosition::PassengerP, 200, 2.3 + 0.17 * 16, 3.0 + 1.5 * 2 + 0.1 * 4},
      {BrakePosition::PassengerP, 600, 2.3 + 0.17 * 36, 3.0 + 1.5 * 6 + 0.1 * 36},
      {BrakePosition::FreightP, 100, 2.3 + 0.17 * 16, 3.0 + 2.77},
      {BrakePosition::FreightP, 900, 2.3 + 0.17 * 81, 3.0 + 2.77 * 9},
      {BrakePosition::FreightP, 1000, -0.4 + 16.0 + 3.0, 10.5 + 3.2 + 18.0},
      {BrakePosition::FreightG, 100, 12.05, 3.0 + 2.77 * 4},
      {BrakePosition::FreightG, 600, 12.0 + 0.05 * 36, 3.0 + 2.77 * 6},
      {BrakePosition::FreightG, 1000, -0.4 + 16.0 + 3.0, 10.5 + 3.2 + 18.0},
  };
  NationalValues v;
  v.Kt_int = 1.0;
  for (const TimeCase& c : cases) {
    TrainData t;
    t.brake_position = c.position;
    t.L_TRAIN = {c.L};
    const BuildUpTimes cm0 = build_up_times(t, v, {}, true);
    EXPECT_NEAR(cm0.T_be.si, c.emergency, 1e-12) << c.L;
    EXPECT_NEAR(cm0.T_bs.si, c.service, 1e-12) << c.L;
    const double kto = c.position == BrakePosition::FreightG ? 1.16 : 1.20;
    const BuildUpTimes cmt = build_up_times(t, v, {}, false);
    EXPECT_NEAR(cmt.T_be.si, kto * c.emergency, 1e-12);
    EXPECT_NEAR(cmt.T_bs.si, kto * c.service, 1e-12);
    // kto does not apply to the reaction times.
    EXPECT_EQ(cm0.T_be_react, cmt.T_be_react);
    EXPECT_EQ(cm0.T_bs_react, cmt.T_bs_react);
  }
}

TEST(ConversionModel, KtAndReactionTimes) {
  NationalValues v;  // Kt_int 1.1
  TrainData t;
  BuildUpTimes b = build_up_times(t, v, {}, true);
  EXPECT_NEAR(b.T_be.si, 1.1 * 5.02, 1e-12);
  EXPECT_NEAR(b.T_bs.si, 6.4, 1e-12);  // no Kt
  EXPECT_NEAR(b.T_be_react.si, 1.1 * 1.42, 1e-12);
  EXPECT_NEAR(b.T_bs_react.si, 1.06, 1e-12);
  t.brake_position = BrakePosition::FreightP;
  b = build_up_times(t, v, {}, true);
  EXPECT_NEAR(b.T_be_react.si, 1.1 * 2.99, 1e-12);
  EXPECT_NEAR(b.T_bs_react.si, 2.07, 1e-12);
  t.brake_position = BrakePosition::FreightG;
  b = build_up_times(t, v, {}, true);
  EXPECT_NEAR(b.T_be_react.si, 1.1 * 9.30, 1e-12);
  EXPECT_NEAR(b.T_bs_react.si, 5.70, 1e-12);
  // A configured service time is used where it is shorter (A.3.9).
  ASSERT_TRUE(t.T_service.push_back({{4.0}, {1.0}, 0}));
  b = build_up_times(t, v, {}, true);
  EXPECT_EQ(b.T_bs.si, 4.0);
  EXPECT_EQ(b.T_bs_react.si, 1.0);
  t.T_service[0].T_brake = {100.0};
  EXPECT_NEAR(build_up_times(t, v, {}, true).T_bs.si, 14.08, 1e-12);
}

TEST(ConversionModel, ServicePercentageIsLimitedTo135) {
  TrainData t;
  t.brake_percentage = 200.0;
  EXPECT_EQ(A_brake_service(t, 0), A_basic(135.0));
  EXPECT_EQ(A_brake_emergency(t, 0), A_basic(200.0));
}

TEST(IntegratedCorrection, SafeDecelerationOfALambdaTrain) {
  TrainData t;  // 135 % in P, 200 m
  NationalValues v;
  // Default: Kv 0.7, Kr 0.9.
  const MergedSteps A = A_brake_safe(t, v, 0);
  EXPECT_NEAR(A.steps[0].value.si, 0.7 * 0.9 * (0.0075 * 135 + 0.076), 1e-12);
}

TEST(IntegratedCorrection, KvIsInterpolatedForPassengerTrains) {
  TrainData t;
  t.brake_percentage = 100.0;  // A_ebmax 0.826
  NationalValues v;
  v.Kv_int_passenger = {};
  ASSERT_TRUE(v.Kv_int_passenger.append(kmh(0), KvPair{0.9, 0.7}));
  ASSERT_TRUE(v.Kv_int_passenger.append(kmh(60), KvPair{0.8, 0.5}));
  v.A_NVP12 = {0.726};
  v.A_NVP23 = {0.926};
  auto kv = Kv_int(t, v);  // half way
  EXPECT_NEAR(kv.steps[0].value, 0.8, 1e-12);
  EXPECT_NEAR(kv.steps[1].value, 0.65, 1e-12);
  v.A_NVP12 = {0.83};
  v.A_NVP23 = {0.93};
  EXPECT_NEAR(Kv_int(t, v).steps[0].value, 0.9, 1e-12);  // subset a
  v.A_NVP12 = {0.5};
  v.A_NVP23 = {0.6};
  EXPECT_NEAR(Kv_int(t, v).steps[0].value, 0.7, 1e-12);  // subset b
  t.brake_position = BrakePosition::FreightP;
  EXPECT_NEAR(Kv_int(t, v).steps[0].value, 0.7, 1e-12);  // the freight set
  EXPECT_EQ(Kv_int(t, v).size(), 1u);
}

TEST(IntegratedCorrection, StepsOfKvAndOfTheBrakeAreMerged) {
  TrainData t;
  t.brake_percentage = 100.0;
  NationalValues v;
  v.Kr_int = {};
  ASSERT_TRUE(v.Kr_int.append({0.0}, 1.0));
  ASSERT_TRUE(v.Kr_int.append({200.0}, 0.5));  // a step includes its upper limit: 200 m still has 1.0
  v.Kv_int_passenger = {};
  ASSERT_TRUE(v.Kv_int_passenger.append(kmh(0), KvPair{1.0, 1.0}));
  ASSERT_TRUE(v.Kv_int_passenger.append(kmh(130), KvPair{0.9, 0.9}));
  ASSERT_TRUE(v.Kv_int_passenger.append(kmh(150), KvPair{0.8, 0.8}));
  const MergedSteps A = A_brake_safe(t, v, 0);
  ASSERT_EQ(A.size(), 5u);
  EXPECT_NEAR(A.steps[0].value.si, 0.826, 1e-12);
  EXPECT_NEAR(A.steps[1].value.si, 0.6171, 1e-12);
  EXPECT_NEAR(A.steps[2].from.si, 130 / 3.6, 1e-12);
  EXPECT_NEAR(A.steps[2].value.si, 0.9 * 0.6171, 1e-12);
  EXPECT_NEAR(A.steps[3].value.si, 0.8 * 0.5915, 1e-12);
  EXPECT_NEAR(A.steps[4].value.si, 0.8 * 0.58173, 1e-12);
  t.L_TRAIN = {201.0};
  EXPECT_NEAR(A_brake_safe(t, v, 0).steps[0].value.si, 0.5 * 0.826, 1e-12);
}

TrainData gamma() {
  TrainData t;
  t.brake_model = BrakeModel::gamma;
  const auto model = [](BrakeSet with, double A) {
    EmergencyModel m;
    m.with = with;
    EmergencyStep s;
    s.A_brake_emergency = {A};
    s.Kwet_rst = Factor::of(0.9);
    for (std::size_t i = 0; i < kConfidenceLevels; ++i)
      s.Kdry_rst[i] = Factor::of(0.98 - 0.02 * static_cast<double>(i));
    EXPECT_TRUE(m.steps.append(kmh(0), s));
    return m;
  };
  EXPECT_TRUE(t.emergency.push_back(model(0, 0.8)));
  EXPECT_TRUE(t.emergency.push_back(model(kRegenerative, 1.0)));
  EXPECT_TRUE(t.emergency.push_back(model(kRegenerative | kMagneticShoe, 1.2)));
  ServiceModel s;
  EXPECT_TRUE(s.A_brake_service.append(kmh(0), {0.6}));
  EXPECT_TRUE(t.service.push_back(s));
  s.with = kRegenerative;
  s.A_brake_service.steps[0].value = {0.75};
  EXPECT_TRUE(t.service.push_back(s));
  EXPECT_TRUE(t.T_emergency.push_back({{3.0}, {1.0}, 0}));
  EXPECT_TRUE(t.T_emergency.push_back({{2.5}, {0.9}, kElectroPneumatic}));
  EXPECT_TRUE(t.T_service.push_back({{4.0}, {1.5}, 0}));
  EXPECT_TRUE(t.T_service.push_back({{2.0}, {0.8}, kElectroPneumatic}));
  return t;
}

TEST(Gamma, SafeDeceleration) {
  const TrainData t = gamma();
  NationalValues v;
  v.M_NVEBCL = 4;  // Kdry 0.9
  v.M_NVAVADH = 0.5;
  EXPECT_NEAR(A_brake_safe(t, v, 0).steps[0].value.si, 0.9 * (0.9 + 0.5 * 0.1) * 0.8, 1e-12);
  v.M_NVEBCL = 9;
  v.M_NVAVADH = 0.0;
  EXPECT_NEAR(A_brake_safe(t, v, 0).steps[0].value.si, 0.8 * 0.9 * 0.8, 1e-12);
}

TEST(Gamma, TheModelOfTheBrakesInUse) {
  TrainData t = gamma();
  t.regenerative = SpecialBrakeInterface::both;
  t.magnetic_shoe = SpecialBrakeInterface::emergency_only;
  t.electro_pneumatic = SpecialBrakeInterface::both;
  BrakeStatus s;
  const auto A = [&](BrakeSet off) { return A_brake_emergency(t, in_use_emergency(t, s, off)).steps[0].value.si; };
  EXPECT_EQ(A(0), 1.2);
  EXPECT_EQ(A(kMagneticShoe), 1.0);
  // There is no model for the magnetic shoe without the regenerative brake: the weaker model is
  // used.
  EXPECT_EQ(A(kRegenerative), 0.8);
  EXPECT_EQ(A_brake_service(t, in_use_service(t, s, 0)).steps[0].value.si, 0.75);
  EXPECT_EQ(A_brake_service(t, in_use_service(t, s, kRegenerative)).steps[0].value.si, 0.6);
  s.regenerative = false;
  EXPECT_EQ(A(0), 0.8);
  EXPECT_EQ(build_up_times(t, {}, s, true).T_be.si, 2.5);
  EXPECT_EQ(build_up_times(t, {}, s, false).T_be.si, 2.5);  // kto belongs to the conversion model
  EXPECT_EQ(build_up_times(t, {}, s, true).T_bs.si, 2.0);
  EXPECT_EQ(build_up_times(t, {}, s, true).T_be_react.si, 0.9);
  s.electro_pneumatic = false;
  EXPECT_EQ(build_up_times(t, {}, s, true).T_be.si, 3.0);
  EXPECT_EQ(build_up_times(t, {}, s, true).T_bs_react.si, 1.5);
  // A brake without interface is never counted.
  EXPECT_EQ(in_use_service(TrainData{}, {}, 0), 0);
  EXPECT_EQ(in_use_emergency(TrainData{}, {}, 0), 0);
  t.regenerative = SpecialBrakeInterface::none;
  EXPECT_EQ(in_use_emergency(t, {}, 0), kMagneticShoe | kElectroPneumatic);
  t.regenerative = SpecialBrakeInterface::emergency_only;
  t.eddy_current = SpecialBrakeInterface::service_only;
  EXPECT_EQ(in_use_service(t, {}, 0), kEddyCurrent | kElectroPneumatic);
}

TEST(Gamma, WithoutModelsNothingBrakes) {
  TrainData t;
  t.brake_model = BrakeModel::gamma;
  EXPECT_EQ(A_brake_emergency(t, 0).steps[0].value.si, 0.0);
  EXPECT_EQ(A_brake_safe(t, {}, 0).steps[0].value.si, 0.0);
  EXPECT_EQ(A_brake_service(t, 0).steps[0].value.si, 0.0);
  EXPECT_EQ(build_up_times(t, {}, {}, true).T_be.si, 0.0);
}

TEST(NormalService, SelectedByTheServiceBrakeAtStandstill) {
  TrainData t;
  t.normal_service.A_SB01 = {0.5};
  t.normal_service.A_SB12 = {0.8};
  for (std::size_t i = 0; i < 3; ++i)
    ASSERT_TRUE(t.normal_service.A_brake_normal_service[i].append(kmh(0), {0.3 + 0.1 * static_cast<double>(i)}));
  EXPECT_NEAR(A_brake_normal_service(t, {0.5}).steps[0].value.si, 0.3, 1e-12);
  EXPECT_NEAR(A_brake_normal_service(t, {0.51}).steps[0].value.si, 0.4, 1e-12);
  EXPECT_NEAR(A_brake_normal_service(t, {0.8}).steps[0].value.si, 0.4, 1e-12);
  EXPECT_NEAR(A_brake_normal_service(t, {0.81}).steps[0].value.si, 0.5, 1e-12);
}

/// 3.13.2.2.3.1.9: one set for "Freight train in G", one for the other positions; a single set counts in all three.
TEST(NormalService, TheSetOfTheBrakePosition) {
  TrainData t;
  for (auto& model : t.normal_service.A_brake_normal_service) ASSERT_TRUE(model.append(kmh(0), {0.6}));
  const auto in_position = [&t](BrakePosition position) {
    t.brake_position = position;
    return A_brake_normal_service(t, {0.5}).steps[0].value.si;
  };
  EXPECT_EQ(in_position(BrakePosition::FreightG), 0.6);
  t.normal_service_G.emplace();
  t.normal_service_G->A_SB01 = {0.4};
  t.normal_service_G->A_SB12 = {0.7};
  for (std::size_t i = 0; i < 3; ++i)
    ASSERT_TRUE(t.normal_service_G->A_brake_normal_service[i].append(kmh(0), {0.1 + 0.1 * static_cast<double>(i)}));
  EXPECT_EQ(in_position(BrakePosition::FreightG), 0.2);  // by the limits of its own set
  EXPECT_EQ(in_position(BrakePosition::FreightP), 0.6);
  EXPECT_EQ(in_position(BrakePosition::PassengerP), 0.6);
}

TEST(ReducedAdhesion, WhichNationalValue) {
  TrainData t;
  NationalValues v;
  BrakeStatus s;
  EXPECT_EQ(A_MAXREDADH(t, v, s), v.A_NVMAXREDADH2);
  t.adhesion_independent_brake = true;
  EXPECT_EQ(A_MAXREDADH(t, v, s), v.A_NVMAXREDADH2);  // allowed, not active
  s.adhesion_independent = true;
  EXPECT_EQ(A_MAXREDADH(t, v, s), v.A_NVMAXREDADH1);
  t.brake_position = BrakePosition::FreightG;
  v.A_NVMAXREDADH3 = MaxReducedAdhesion::at_most({0.4});
  EXPECT_EQ(A_MAXREDADH(t, v, s).A.si, 0.4);
}

TEST(Gradient, RotatingMass) {
  TrainData t;
  const FixedValues f;
  EXPECT_NEAR(A_gradient(10.0, t, f).si, 9.81 * 10 / 1150, 1e-15);
  EXPECT_NEAR(A_gradient(-10.0, t, f).si, -9.81 * 10 / 1020, 1e-15);
  EXPECT_EQ(A_gradient(0.0, t, f).si, 0.0);
  t.M_rotating_nom = 5.0;
  EXPECT_NEAR(A_gradient(10.0, t, f).si, 9.81 * 10 / 1050, 1e-15);
  EXPECT_NEAR(A_gradient(-10.0, t, f).si, -9.81 * 10 / 1050, 1e-15);
}

TEST(SpeedAccuracy, F41) {
  EXPECT_NEAR(f41(kmh(0)).si * 3.6, 2.0, 1e-12);
  EXPECT_NEAR(f41(kmh(30)).si * 3.6, 2.0, 1e-12);
  EXPECT_NEAR(f41(kmh(265)).si * 3.6, 7.0, 1e-12);
  EXPECT_NEAR(f41(kmh(500)).si * 3.6, 12.0, 1e-12);
}

TEST(Defaults, StandardTrainAndNationalValues) {
  EXPECT_EQ(check(TrainData{}), Fault::none);
  EXPECT_EQ(check(NationalValues{}), Fault::none);
  const NationalValues v;
  EXPECT_EQ(v.V_NVREL.si, 40.0 / 3.6);
  EXPECT_EQ(v.D_NVROLL.si, 2.0);
  EXPECT_FALSE(v.D_NVSTFF.has_value());
  EXPECT_FALSE(v.T_NVCONTACT.has_value());
  EXPECT_EQ(v.M_NVCONTACT, Reaction::none);
  EXPECT_EQ(v.M_NVEBCL, 9);
}

template <class Data, class Change>
Fault after(Data data, Change change) {
  change(data);
  return check(data);
}

TEST(Check, EveryFaultOfTrainData) {
  const auto lambda = [](auto change) { return after(TrainData{}, change); };
  const auto g = [](auto change) { return after(gamma(), change); };
  EXPECT_EQ(g([](TrainData&) {}), Fault::none);
  EXPECT_EQ(lambda([](TrainData& t) { t.brake_percentage = 29; }), Fault::brake_percentage);
  EXPECT_EQ(lambda([](TrainData& t) { t.brake_percentage = std::numeric_limits<double>::quiet_NaN(); }),
            Fault::brake_percentage);
  EXPECT_EQ(lambda([](TrainData& t) { t.L_TRAIN = {950.0}; }), Fault::train_length_lambda);
  EXPECT_EQ(lambda([](TrainData& t) { t.V_MAXTRAIN = kmh(250); }), Fault::maximum_speed_lambda);
  EXPECT_EQ(lambda([](TrainData& t) { t.L_TRAIN = {0.0}; }), Fault::train_length);
  EXPECT_EQ(lambda([](TrainData& t) { t.L_TRAIN = {4096.0}; }), Fault::train_length);
  EXPECT_EQ(lambda([](TrainData& t) { t.V_MAXTRAIN = kmh(605); }), Fault::maximum_speed);
  EXPECT_EQ(lambda([](TrainData& t) { t.T_traction_cut_off = {-1.0}; }), Fault::traction_cut_off_time);
  EXPECT_EQ(lambda([](TrainData& t) { t.L_antenna_front = {-1.0}; }), Fault::antenna);
  EXPECT_EQ(lambda([](TrainData& t) { t.M_rotating_nom = -1.0; }), Fault::rotating_mass);
  EXPECT_EQ(g([](TrainData& t) { t.emergency.clear(); }), Fault::no_emergency_model);
  EXPECT_EQ(g([](TrainData& t) { t.emergency[0].with = kEddyCurrent; }), Fault::no_emergency_model);
  EXPECT_EQ(g([](TrainData& t) { t.service.clear(); }), Fault::no_service_model);
  EXPECT_EQ(g([](TrainData& t) { t.T_emergency.clear(); }), Fault::no_emergency_time);
  EXPECT_EQ(g([](TrainData& t) { t.T_service.clear(); }), Fault::no_service_time);
  EXPECT_EQ(g([](TrainData& t) { t.emergency[0].steps.steps[0].value.A_brake_emergency = {-0.1}; }),
            Fault::deceleration);
  EXPECT_EQ(g([](TrainData& t) { t.emergency[0].steps.steps[0].from = kmh(5); }), Fault::deceleration);
  EXPECT_EQ(g([](TrainData& t) { t.service[0].A_brake_service.steps[0].from = kmh(5); }), Fault::deceleration);
  EXPECT_EQ(g([](TrainData& t) { t.service[0].A_brake_service.steps[0].value = {-1.0}; }), Fault::deceleration);
  EXPECT_EQ(g([](TrainData& t) { t.emergency[0].steps.steps[0].value.Kwet_rst = Factor::of(1.1); }),
            Fault::correction_factor);
  EXPECT_EQ(g([](TrainData& t) { t.emergency[0].steps.steps[0].value.Kdry_rst[3] = Factor::of(1.1); }),
            Fault::correction_factor);
  EXPECT_EQ(g([](TrainData& t) { t.T_emergency[0].T_brake_react = {4.0}; }), Fault::build_up_time);
  EXPECT_EQ(g([](TrainData& t) { t.T_service[0].T_brake = {-1.0}; }), Fault::build_up_time);
  EXPECT_EQ(lambda([](TrainData& t) { EXPECT_TRUE(t.Kn_plus.append(kmh(0), {11.0})); }), Fault::Kn);
  EXPECT_EQ(lambda([](TrainData& t) { EXPECT_TRUE(t.normal_service.A_brake_normal_service[0].append(kmh(0), {0.5})); }),
            Fault::guidance_without_model);
  EXPECT_EQ(lambda([](TrainData& t) {
              for (auto& m : t.normal_service.A_brake_normal_service) EXPECT_TRUE(m.append(kmh(10), {0.5}));
            }),
            Fault::deceleration);
  EXPECT_EQ(lambda([](TrainData& t) {
              EXPECT_TRUE(t.normal_service_G.emplace().A_brake_normal_service[2].append(kmh(0), {0.5}));
            }),
            Fault::guidance_without_model);
  EXPECT_EQ(lambda([](TrainData& t) {
              for (auto& m : t.normal_service_G.emplace().A_brake_normal_service) EXPECT_TRUE(m.append(kmh(0), {-0.5}));
            }),
            Fault::deceleration);
  EXPECT_EQ(lambda([](TrainData& t) { t.magnetic_shoe = SpecialBrakeInterface::service_only; }),
            Fault::special_brake_interface);
  EXPECT_EQ(lambda([](TrainData& t) { t.magnetic_shoe = SpecialBrakeInterface::both; }),
            Fault::special_brake_interface);
  EXPECT_EQ(lambda([](TrainData& t) { t.electro_pneumatic = SpecialBrakeInterface::emergency_only; }),
            Fault::special_brake_interface);
}

TEST(Check, EveryFaultOfNationalValues) {
  const auto n = [](auto change) { return after(NationalValues{}, change); };
  EXPECT_EQ(n([](NationalValues& v) { v.Kv_int_freight = {}; }), Fault::Kv_int);
  EXPECT_EQ(n([](NationalValues& v) { v.Kv_int_freight.steps[0].value = 3.0; }), Fault::Kv_int);
  EXPECT_EQ(n([](NationalValues& v) { v.Kv_int_passenger.steps[0].value.b = -0.1; }), Fault::Kv_int);
  EXPECT_EQ(n([](NationalValues& v) { v.Kr_int = {}; }), Fault::Kr_int);
  EXPECT_EQ(n([](NationalValues& v) { v.Kr_int.steps[0].value = 1.6; }), Fault::Kr_int);
  EXPECT_EQ(n([](NationalValues& v) { v.Kt_int = 1.6; }), Fault::Kt_int);
  EXPECT_EQ(n([](NationalValues& v) { v.A_NVP12 = {1.0}; }), Fault::A_NVP);
  EXPECT_EQ(n([](NationalValues& v) { v.M_NVAVADH = 1.05; }), Fault::M_NVAVADH);
  EXPECT_EQ(n([](NationalValues& v) { v.M_NVEBCL = 10; }), Fault::M_NVEBCL);
  EXPECT_EQ(n([](NationalValues& v) { v.A_NVMAXREDADH3 = MaxReducedAdhesion::at_most({3.2}); }), Fault::A_NVMAXREDADH);
  EXPECT_EQ(n([](NationalValues& v) {
              v.A_NVMAXREDADH3 = MaxReducedAdhesion::without_maximum(MaxReducedAdhesion::Display::none);
            }),
            Fault::none);
}

TEST(Check, EveryFaultHasAClause) {
  for (unsigned i = 0; i < static_cast<unsigned>(Fault::count); ++i) {
    const auto fault = static_cast<Fault>(i);
    EXPECT_EQ(static_cast<bool>(clause(fault)), fault != Fault::none) << i;
  }
}

}  // namespace
