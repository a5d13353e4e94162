// Every formula of 3.13.6-3.13.9, 3.11.11 and A.3.12 compared with values computed by hand. The
// train is `simple_train()`: A_safe 1.0, A_expected 0.8 m/s2, T_be 8 s, T_bs 3 s,
// T_traction_cut_off 10 s.
#include "sdm/limits.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "sdm/evaluate.h"
#include "sdm/reduced_build_up.h"
#include "sdm/test_cases.h"

namespace {

using namespace evc;
using namespace evc::sdm;
using namespace evc::sdm::test;

TEST(CeilingLimits, Margins) {
  const train::FixedValues f;
  EXPECT_NEAR(dV_ebi(kmh(100), f).si * 3.6, 7.5, 1e-12);
  EXPECT_NEAR(dV_ebi(kmh(110), f).si * 3.6, 7.5, 1e-12);
  EXPECT_NEAR(dV_ebi(kmh(160), f).si * 3.6, 11.25, 1e-12);
  EXPECT_NEAR(dV_ebi(kmh(250), f).si * 3.6, 15.0, 1e-12);
  EXPECT_NEAR(dV_sbi(kmh(110), f).si * 3.6, 5.5, 1e-12);
  EXPECT_NEAR(dV_sbi(kmh(160), f).si * 3.6, 7.75, 1e-12);
  EXPECT_NEAR(dV_sbi(kmh(300), f).si * 3.6, 10.0, 1e-12);
  EXPECT_NEAR(dV_warning(kmh(110), f).si * 3.6, 4.0, 1e-12);
  EXPECT_NEAR(dV_warning(kmh(125), f).si * 3.6, 4.5, 1e-12);
  EXPECT_NEAR(dV_warning(kmh(200), f).si * 3.6, 5.0, 1e-12);
}

TEST(TimesOfLimits, WithServiceBrakeAndTractionCutOff) {
  const train::BuildUpTimes b{{8.0}, {2.0}, {3.0}, {1.0}};
  const TimeConfig c{{10.0}, true, true, false};
  const train::FixedValues f;
  Times t = times(c, b, std::nullopt, rules_of(SrsVersion::v3_6_0), f);
  EXPECT_EQ(t.T_bs1.si, 3.0);
  EXPECT_EQ(t.T_bs2.si, 3.0);
  EXPECT_EQ(t.T_traction.si, 5.0);  // 10 - (2 + 3)
  EXPECT_EQ(t.T_berem.si, 3.0);     // 8 - 5
  EXPECT_EQ(t.T_indication.si, 9.0);
  EXPECT_EQ(times(c, b, std::nullopt, rules_of(SrsVersion::v3_4_0), f).T_indication.si, 5.0);
  // Without the service brake.
  t = times({{10.0}, true, false, false}, b, std::nullopt, rules_of(SrsVersion::v3_6_0), f);
  EXPECT_EQ(t.T_bs1.si, 0.0);
  EXPECT_EQ(t.T_bs2.si, 0.0);
  EXPECT_EQ(t.T_traction.si, 8.0);
  EXPECT_EQ(t.T_berem.si, 0.0);
  // Without the interface.
  t = times({{10.0}, false, true, false}, b, std::nullopt, rules_of(SrsVersion::v3_6_0), f);
  EXPECT_EQ(t.T_traction.si, 10.0);
  EXPECT_EQ(t.T_berem.si, 0.0);
  // A short cut-off time is over before the emergency brake is commanded.
  t = times({{4.0}, true, true, false}, b, std::nullopt, rules_of(SrsVersion::v3_6_0), f);
  EXPECT_EQ(t.T_traction.si, 0.0);
  EXPECT_EQ(t.T_berem.si, 8.0);
  // 0.8 T_bs applies from 6.25 s on; with feedback it is 5 s.
  const train::BuildUpTimes slow{{8.0}, {2.0}, {10.0}, {1.0}};
  EXPECT_EQ(times(c, slow, std::nullopt, rules_of(SrsVersion::v3_4_0), f).T_indication.si, 8.0);
  EXPECT_EQ(times({{10.0}, true, true, true}, slow, std::nullopt, rules_of(SrsVersion::v3_4_0), f).T_indication.si,
            5.0);
  // With feedback T_bs2 is at least 2 s.
  const train::BuildUpTimes quick{{8.0}, {2.0}, {1.0}, {0.5}};
  t = times({{10.0}, true, true, true}, quick, FeedbackTimes{{0.0}, {0.0}}, rules_of(SrsVersion::v3_6_0), f);
  EXPECT_EQ(t.T_bs1.si, 0.0);
  EXPECT_EQ(t.T_bs2.si, 2.0);
}

TEST(EBI, SpeedAndDistanceBeforeTheFullEffort) {
  const Times t{{8.0}, {3.0}, {3.0}, {3.0}, {5.0}, {3.0}, {9.0}};
  const Approach a = approach({30.0}, {1.0}, {0.6}, train::FixedValues{});
  EXPECT_EQ(a.A_est1.si, 0.6);
  EXPECT_EQ(a.A_est2.si, 0.4);
  BuildUpLoss l = before_emergency_effort(a, t, {0.0});
  EXPECT_NEAR(l.V_delta1.si, 3.0, 1e-12);
  EXPECT_NEAR(l.V_delta2.si, 1.2, 1e-12);
  EXPECT_NEAR(l.V_bec.si, 35.2, 1e-12);
  EXPECT_NEAR(l.D_bec.si, 32.5 * 5 + 34.6 * 3, 1e-12);
  EXPECT_NEAR(D_be_display(a, t).si, 266.3, 1e-12);
  // Below the target speed: the target speed is used instead.
  l = before_emergency_effort(approach({10.0}, {1.0}, {0.6}, train::FixedValues{}), t, {20.0});
  EXPECT_NEAR(l.V_bec.si, 21.2, 1e-12);
  EXPECT_NEAR(l.D_bec.si, 20.0 * 5 + 20.6 * 3, 1e-12);
  // A braking train's acceleration counts as 0.
  EXPECT_EQ(approach({10.0}, {}, {-0.5}, train::FixedValues{}).A_est1.si, 0.0);
}

TEST(Limits, OfEOAAndSvL) {
  Inputs in = simple_inputs();
  set_EOA(in, 4900.0, 5000.0);
  const auto d = built(in);
  ASSERT_EQ(d->targets.size(), 1u);
  const TargetLimits l = limits_of(*d, d->targets[0], approach({30.0}, {1.0}, {0.6}, d->fixed), {});
  EXPECT_NEAR(m(l.EBD.d_curve), 5000 - 35.2 * 35.2 / 2, 1e-9);
  EXPECT_NEAR(m(*l.EBD.d_EBI), 4114.18, 1e-9);
  EXPECT_NEAR(m(l.EBD.d_SBI), 4024.18, 1e-9);
  EXPECT_NEAR(m(l.EBD.d_W), 3964.18, 1e-9);
  EXPECT_NEAR(m(l.EBD.d_P), 3904.18, 1e-9);
  EXPECT_NEAR(m(l.EBD.d_I), 3634.18, 1e-9);
  ASSERT_TRUE(l.SBD.has_value());
  EXPECT_NEAR(m(l.SBD->d_curve), 4337.5, 1e-9);
  EXPECT_NEAR(m(l.SBD->d_SBI), 4247.5, 1e-9);
  EXPECT_NEAR(m(l.SBD->d_W), 4187.5, 1e-9);
  EXPECT_NEAR(m(l.SBD->d_P), 4127.5, 1e-9);
  EXPECT_NEAR(m(l.SBD->d_I), 3857.5, 1e-9);
  EXPECT_FALSE(l.SBD->d_EBI.has_value());
}

TEST(Limits, SpeedsAtAPlace) {
  Inputs in = simple_inputs();
  set_EOA(in, 4900.0, 5000.0);
  const auto d = built(in);
  const Target& t = d->targets[0];
  const Approach a = approach({30.0}, {1.0}, {0.6}, d->fixed);
  const Times times = times_of(*d, t, a, {}).EBD;
  // x = 3800 + V (T_driver + T_bs2) + D_be = 4276.3.
  LimitSpeeds s = speeds_of_EBD(d->view(t.EBD), {}, a, times, {}, {{3800.0}}, d->fixed);
  EXPECT_NEAR(s.V_P.si, std::sqrt(2 * (5000 - 4276.3)) - 5.2, 1e-9);
  EXPECT_NEAR(s.V_W.si, std::sqrt(2 * (5000 - 4216.3)) - 5.2, 1e-9);
  EXPECT_NEAR(s.V_SBI.si, std::sqrt(2 * (5000 - 4156.3)) - 5.2, 1e-9);
  EXPECT_NEAR(s.V_EBI.si, std::sqrt(2 * (5000 - 4066.3)) - 5.2, 1e-9);
  // Beyond the foot the target speed with its margins.
  s = speeds_of_EBD(d->view(t.EBD), {}, a, times, {}, {{4999.0}}, d->fixed);
  EXPECT_EQ(s.V_P.si, 0.0);
  EXPECT_NEAR(s.V_SBI.si * 3.6, 5.5, 1e-12);
  EXPECT_NEAR(s.V_EBI.si * 3.6, 7.5, 1e-12);
  EXPECT_NEAR(s.V_W.si * 3.6, 4.0, 1e-12);
  s = speeds_of_SBD(d->view(t.SBD), {}, a, times, {{4900.0}}, {{4000.0}}, d->fixed);
  EXPECT_NEAR(s.V_SBI.si, std::sqrt(1.6 * (4900 - 4090)), 1e-9);
  EXPECT_NEAR(s.V_P.si, std::sqrt(1.6 * (4900 - 4210)), 1e-9);
  EXPECT_NEAR(s.V_W.si, std::sqrt(1.6 * (4900 - 4150)), 1e-9);
  EXPECT_EQ(speeds_of_SBD(d->view(t.SBD), {}, a, times, {{4900.0}}, {{4850.0}}, d->fixed).V_P.si, 0.0);
}

TEST(Limits, OfAnMRSPTarget) {
  Inputs in = simple_inputs();
  ASSERT_TRUE(in.mrsp.append({{4000.0}}, {20.0}));  // 72 km/h
  const auto d = built(in);
  ASSERT_EQ(d->targets.size(), 1u);
  const Target& t = d->targets[0];
  // The EBD passes 4000 at 20 m/s + 7.5 km/h and ends where it has 20 m/s.
  const double v = 20.0 + 7.5 / 3.6;
  EXPECT_NEAR(d->view(t.EBD).speed_at({{4000.0}}).si, v, 1e-12);
  EXPECT_NEAR(m(t.foot), 4000 + (v * v - 400) / 2, 1e-9);
  // d_P(V_target) = d_EBD(20) - 20 (T_berem + T_traction) - 20 (T_driver + T_bs2).
  EXPECT_NEAR(m(t.d_P_target), m(t.foot) - 20 * 8 - 20 * 7, 1e-9);
  EXPECT_FALSE(t.zero);
  // 4.0.0: reaction times, T_traction_max = 10 - (2 + 1); not beyond the target.
  in.srs = SrsVersion::v4_0_0;
  in.revision = 2;
  EXPECT_NEAR(m(built(in)->targets[0].d_P_target), m(t.foot) - 20 * 7 - 20 * 5, 1e-9);
  in.train.T_traction_cut_off = {0.0};
  in.train.T_emergency[0].T_brake_react = {0.0};
  in.fixed.T_driver = {0.0};
  in.train.service_brake_interface = false;
  EXPECT_NEAR(m(built(in)->targets[0].d_P_target), 4000.0, 1e-9);
}

TEST(Curves, BandsAndGradientAreExactArcs) {
  Inputs in = simple_inputs();
  ASSERT_TRUE(in.train.emergency[0].steps.append({20.0}, [] {
    train::EmergencyStep s;
    s.A_brake_emergency = {0.8};
    s.Kdry_rst.fill(train::Factor::of(1.0));
    return s;
  }()));
  in.gradient.permille = {};
  ASSERT_TRUE(in.gradient.permille.append({{0.0}}, 0.0));
  ASSERT_TRUE(in.gradient.permille.append({{4000.0}}, -10.0));
  ASSERT_TRUE(in.gradient.permille.append({{4500.0}}, 0.0));
  set_EOA(in, 5000.0, 5000.0);
  const auto d = built(in);
  const CurveView EBD = d->view(d->targets[0].EBD);
  const double A_down = 0.8 - 9.81 * 10 / 1020;
  EXPECT_NEAR(m(EBD.place_at({20.0})), 4800.0, 1e-9);
  EXPECT_NEAR(EBD.speed_squared_at({{4600.0}}).si, 720.0, 1e-9);  // the fall holds to 4500 + 100
  EXPECT_NEAR(EBD.speed_squared_at({{4000.0}}).si, 720.0 + 2 * A_down * 600, 1e-9);
  EXPECT_NEAR(EBD.speed_squared_at({{3900.0}}).si, 720.0 + 2 * A_down * 600 + 160, 1e-9);
  EXPECT_EQ(d->decelerations.at(CurveKind::EBD, {20.0}, {{4700.0}}).si, 1.0);
  EXPECT_EQ(d->decelerations.at(CurveKind::EBD, {20.1}, {{4700.0}}).si, 0.8);
  EXPECT_NEAR(d->decelerations.at(CurveKind::EBD, {30.0}, {{4550.0}}).si, A_down, 1e-12);
}

TEST(Curves, ReducedAdhesionFromItsStartToItsEndPlusTheTrain) {
  Inputs in = simple_inputs();
  set_EOA(in, 5000.0, 5000.0);
  ASSERT_TRUE(in.conditions.reduced_adhesion.push_back({{{4000.0}}, {{4200.0}}}));
  auto d = built(in);
  const auto A = [&](double x) { return d->decelerations.at(CurveKind::EBD, {10.0}, {{x}}).si; };
  EXPECT_EQ(A(3999.0), 1.0);
  EXPECT_EQ(A(4000.0), 0.7);
  EXPECT_EQ(A(4299.0), 0.7);
  EXPECT_EQ(A(4301.0), 1.0);
  // The service brake is not affected.
  EXPECT_EQ(d->decelerations.at(CurveKind::SBD, {10.0}, {{4100.0}}).si, 0.8);
  in.conditions.slippery_rail = true;
  ++in.revision;
  d = built(in);
  EXPECT_EQ(A(3000.0), 0.7);
  in.national_values.A_NVMAXREDADH2 =
      train::MaxReducedAdhesion::without_maximum(train::MaxReducedAdhesion::Display::none);
  ++in.revision;
  d = built(in);
  EXPECT_EQ(A(3000.0), 1.0);
}

TEST(Curves, AnInhibitedBrakeIsMissingToTheFoot) {
  Inputs in = simple_inputs();
  set_EOA(in, 5000.0, 5000.0);
  in.train.regenerative = train::SpecialBrakeInterface::both;
  in.train.eddy_current = train::SpecialBrakeInterface::both;
  train::EmergencyModel e = in.train.emergency[0];
  e.with = train::kRegenerative | train::kEddyCurrent;
  e.steps.steps[0].value.A_brake_emergency = {1.4};
  ASSERT_TRUE(in.train.emergency.push_back(e));
  e.with = train::kEddyCurrent;
  e.steps.steps[0].value.A_brake_emergency = {1.2};
  ASSERT_TRUE(in.train.emergency.push_back(e));
  in.conditions.regenerative_off = Place{{3000.0}};
  in.conditions.eddy_current_emergency_off = Place{{4000.0}};
  auto d = built(in);
  const auto A = [&](double x) { return d->decelerations.at(CurveKind::EBD, {10.0}, {{x}}).si; };
  EXPECT_EQ(A(2999.0), 1.4);
  EXPECT_EQ(A(3500.0), 1.2);
  EXPECT_EQ(A(4500.0), 1.0);
  EXPECT_EQ(A(9000.0), 1.0);  // for any end of the profile
  // `explain` names the brakes that count where the curve has the speed.
  EXPECT_EQ(explain(*d, in, d->targets[0], {10.0}, {}, {}).A_brake_emergency.si, 1.0);
  EXPECT_EQ(explain(*d, in, d->targets[0], {60.0}, {}, {}).A_brake_emergency.si, 1.2);
  EXPECT_EQ(explain(*d, in, d->targets[0], {80.0}, {}, {}).A_brake_emergency.si, 1.4);
  // A powerless section removes a regenerative brake that needs the line voltage, and no other.
  in.conditions.regenerative_off.reset();
  in.conditions.powerless = Place{{3500.0}};
  ++in.revision;
  d = built(in);
  EXPECT_EQ(A(3499.0), 1.4);
  EXPECT_EQ(A(3501.0), 1.2);
  in.train.regenerative_needs_line_voltage = false;
  ++in.revision;
  d = built(in);
  EXPECT_EQ(A(3501.0), 1.4);
  // This service brake model has no special brakes; with one, the service brake has its own zone.
  train::ServiceModel s = in.train.service[0];
  s.with = train::kEddyCurrent;
  s.A_brake_service.steps[0].value = {0.9};
  ASSERT_TRUE(in.train.service.push_back(s));
  in.conditions.eddy_current_service_off = Place{{2000.0}};
  ++in.revision;
  d = built(in);
  EXPECT_EQ(d->decelerations.at(CurveKind::SBD, {10.0}, {{1999.0}}).si, 0.9);
  EXPECT_EQ(d->decelerations.at(CurveKind::SBD, {10.0}, {{2001.0}}).si, 0.8);
  in.conditions = {};
  in.conditions.eddy_current_service_off = Place{{2000.0}};
  ++in.revision;
  d = built(in);
  EXPECT_EQ(d->decelerations.at(CurveKind::SBD, {10.0}, {{2001.0}}).si, 0.8);
  EXPECT_EQ(A(2001.0), 1.4);
}

TEST(Gradient, LowestUnderTheTrain) {
  GradientProfile p;
  ASSERT_TRUE(p.permille.append({{0.0}}, 5.0));
  ASSERT_TRUE(p.permille.append({{1000.0}}, -8.0));
  ASSERT_TRUE(p.permille.append({{1100.0}}, 3.0));
  ASSERT_TRUE(p.permille.append({{1150.0}}, -2.0));
  ASSERT_TRUE(p.permille.append({{2000.0}}, 10.0));
  const CompensatedGradient c = compensated_gradient(p, {200.0}, false);
  const auto at = [&](double x) { return c.permille.at({{x}}); };
  EXPECT_EQ(at(-1.0), 0.0);   // unknown gradient
  EXPECT_EQ(at(100.0), 0.0);  // the rear is not on known track yet
  EXPECT_EQ(at(201.0), 5.0);
  EXPECT_EQ(at(1001.0), -8.0);
  EXPECT_EQ(at(1299.0), -8.0);  // until the rear has left it
  EXPECT_EQ(at(1301.0), -2.0);
  EXPECT_EQ(at(2199.0), -2.0);
  EXPECT_EQ(at(2201.0), 10.0);
}

TEST(Gradient, NothingCountsBeyondTheEndOfTheProfile) {
  GradientProfile p;
  ASSERT_TRUE(p.permille.append({{0.0}}, 4.0));
  ASSERT_TRUE(p.permille.append({{1500.0}}, -9.0));
  ASSERT_TRUE(p.permille.append({{2000.0}}, 3.0));
  p.known_from = Place{{500.0}};
  p.known_to = Place{{1000.0}};
  const CompensatedGradient c = compensated_gradient(p, {100.0}, false);
  EXPECT_EQ(c.permille.at({{450.0}}), 0.0);
  EXPECT_EQ(c.permille.at({{700.0}}), 4.0);
  EXPECT_EQ(c.permille.at({{1050.0}}), 0.0);
  EXPECT_EQ(c.permille.at({{1600.0}}), 0.0);
  EXPECT_EQ(c.permille.at({{2200.0}}), 0.0);
}

TEST(Gradient, DefaultForTargetsOfATSRWhereNothingIsKnown) {
  GradientProfile p;
  ASSERT_TRUE(p.permille.append({{0.0}}, 4.0));
  p.known_to = Place{{1000.0}};
  p.default_for_TSR = -15.0;
  const CompensatedGradient c = compensated_gradient(p, {200.0}, true);
  EXPECT_EQ(c.permille.at({{-5.0}}), -15.0);
  EXPECT_EQ(c.permille.at({{100.0}}), -15.0);  // under the rear
  EXPECT_EQ(c.permille.at({{200.0}}), 4.0);
  EXPECT_EQ(c.permille.at({{500.0}}), 4.0);
  EXPECT_EQ(c.permille.at({{1001.0}}), -15.0);
  EXPECT_EQ(c.permille.at({{5000.0}}), -15.0);
  const CompensatedGradient other = compensated_gradient(p, {200.0}, false);
  EXPECT_EQ(other.permille.at({{1001.0}}), 0.0);
  // An uphill default does not hide the known fall under the rear.
  p.permille = {};
  ASSERT_TRUE(p.permille.append({{0.0}}, -20.0));
  p.default_for_TSR = 6.0;
  const CompensatedGradient up = compensated_gradient(p, {200.0}, true);
  EXPECT_EQ(up.permille.at({{1100.0}}), -20.0);
  EXPECT_EQ(up.permille.at({{1201.0}}), 6.0);
  EXPECT_EQ(up.permille.at({{-1.0}}), 6.0);
  EXPECT_EQ(up.permille.at({{100.0}}), -20.0);
  // It applies to targets due to a TSR.
  Inputs in = simple_inputs();
  in.gradient.permille = {};
  ASSERT_TRUE(in.gradient.permille.append({{-10000.0}}, 0.0));
  in.gradient.known_to = Place{{3000.0}};
  in.gradient.default_for_TSR = -10.0;
  ASSERT_TRUE(in.mrsp.append({{4000.0}}, {20.0}));
  const auto plain = built(in);
  in.mrsp_due_to_TSR[1] = true;
  ++in.revision;
  const auto tsr = built(in);
  EXPECT_LT(tsr->view(tsr->targets[0].EBD).place_at({30.0}), plain->view(plain->targets[0].EBD).place_at({30.0}));
}

TEST(Curves, WhereTheTrainCannotBrakeTheCurveFalls) {
  Inputs in = simple_inputs();
  // 120 per mille down between 3000 and 3400: 1.0 - 1.154 = -0.154 m/s2, to 3500 for the train's length.
  in.gradient.permille = {};
  ASSERT_TRUE(in.gradient.permille.append({{-10000.0}}, 0.0));
  ASSERT_TRUE(in.gradient.permille.append({{3000.0}}, -120.0));
  ASSERT_TRUE(in.gradient.permille.append({{3400.0}}, 0.0));
  set_EOA(in, 3700.0, 3700.0);
  auto d = built(in);
  const CurveView EBD = d->view(d->targets[0].EBD);
  EXPECT_TRUE(d->targets[0].warnings.no_deceleration);
  EXPECT_TRUE(d->no_deceleration);
  // w at 3500 is 400; at 3000 it has fallen to 400 - 2 * 0.1541 * 500; from there it rises with 1.0.
  const double A = 9.81 * 120 / 1020 - 1.0;
  const double w = 400 - 2 * A * 500;
  EXPECT_NEAR(EBD.speed_squared_at({{3000.0}}).si, w, 1e-9);
  EXPECT_NEAR(EBD.speed_squared_at({{2900.0}}).si, w + 200, 1e-9);
  // In the fall, and until the curve is lower: the level that the fall allows.
  EXPECT_NEAR(EBD.speed_squared_at({{3300.0}}).si, w, 1e-9);
  EXPECT_NEAR(EBD.speed_squared_at({{3700 - w / 2 + 1}}).si, w - 2, 1e-9);
  // Too steep for the brakes: the train has to stop before.
  in.gradient.permille.steps[1].value = -200.0;
  ++in.revision;
  d = built(in);
  EXPECT_NEAR(d->view(d->targets[0].EBD).speed_squared_at({{3000.0}}).si, 0.0, 1e-9);
  EXPECT_NEAR(d->view(d->targets[0].EBD).speed_squared_at({{2900.0}}).si, 200.0, 1e-9);
  // The train cannot brake anywhere: no speed is allowed at any place.
  in.gradient.permille.steps[0] = {{{-1e9}}, -200.0};
  ++in.revision;
  d = built(in);
  EXPECT_LE(m(d->view(d->targets[0].EBD).place_at({5.0})), -1e8);
}

TEST(Curves, AFootThatCannotBeReachedIsTheTarget) {
  Inputs in = simple_inputs();
  in.gradient.permille = {};
  ASSERT_TRUE(in.gradient.permille.append({{-10000.0}}, 0.0));
  ASSERT_TRUE(in.gradient.permille.append({{4000.0}}, -150.0));
  ASSERT_TRUE(in.mrsp.append({{4000.0}}, {20.0}));
  const auto d = built(in);
  EXPECT_NEAR(m(d->targets[0].foot), 4000.0, 1e-9);
  EXPECT_NEAR(d->view(d->targets[0].EBD).speed_at({{4000.0}}).si, 20.0, 1e-12);
  EXPECT_TRUE(d->targets[0].warnings.no_deceleration);
}

Inputs with_guidance() {
  Inputs in = simple_inputs();
  in.national_values.Q_NVGUIPERM = true;
  in.train.normal_service.A_SB12 = {0.1};
  for (auto& model : in.train.normal_service.A_brake_normal_service) {
    EXPECT_TRUE(model.append({0.0}, {0.4}));
    EXPECT_TRUE(model.append({15.0}, {0.3}));
  }
  EXPECT_TRUE(in.train.Kn_plus.append({0.0}, {2.0}));
  EXPECT_TRUE(in.train.Kn_minus.append({0.0}, {3.0}));
  return in;
}

TEST(Guidance, NormalServiceDecelerationAndPermittedSpeed) {
  Inputs in = with_guidance();
  set_EOA(in, 4900.0, 5000.0);
  auto d = built(in);
  const Target& t = d->targets[0];
  EXPECT_NEAR(d->decelerations.at(CurveKind::GUI, {10.0}, {{0.0}}).si, 0.4, 1e-12);
  EXPECT_NEAR(d->decelerations.at(CurveKind::GUI, {16.0}, {{0.0}}).si, 0.3, 1e-12);
  const TargetLimits l = limits_of(*d, t, approach({10.0}, {}, {}, d->fixed), {});
  // d_GUI(10) = 4900 - 100 / 0.8; SBD: 4900 - 62.5 - 30 - 40.
  EXPECT_NEAR(m(*l.SBD->d_GUI), 4775.0, 1e-9);
  EXPECT_NEAR(m(l.SBD->d_P), 4767.5, 1e-9);
  EXPECT_NEAR(m(*l.EBD.d_GUI), 4875.0, 1e-9);
  // 30 m/s: the guidance curve is the more restrictive one.
  const double d_GUI = 4900 - (225.0 / 0.8 + (900.0 - 225.0) / 0.6);
  EXPECT_NEAR(m(limits_of(*d, t, approach({30.0}, {}, {}, d->fixed), {}).SBD->d_P), d_GUI, 1e-9);
  const LimitSpeeds s = speeds_of_SBD(d->view(t.SBD), d->view(t.GUI_EOA), approach({10.0}, {}, {}, d->fixed),
                                      times_of(*d, t, {}, {}).SBD, {{4900.0}}, {{4800.0}}, d->fixed);
  EXPECT_NEAR(s.V_P.si, std::sqrt(1.6 * 30), 1e-9);  // the SBD at 4870 against the guidance curve at 4800
  // Kn: uphill 2.0 per unit, downhill 3.0 per unit of gradient.
  in.gradient.permille.steps[0].value = 10.0;
  ++in.revision;
  d = built(in);
  EXPECT_NEAR(d->decelerations.at(CurveKind::GUI, {10.0}, {{0.0}}).si, 0.4 + 9.81 * 10 / 1150 - 2.0 * 0.01, 1e-12);
  in.gradient.permille.steps[0].value = -10.0;
  ++in.revision;
  d = built(in);
  EXPECT_NEAR(d->decelerations.at(CurveKind::GUI, {10.0}, {{0.0}}).si, 0.4 - 9.81 * 10 / 1020 + 3.0 * 0.01, 1e-12);
}

TEST(Guidance, DistancesWithKnByHand) {
  // Downhill 10 per mille to 4600, level beyond; the train of 100 m has the fall under it to 4700. A_gradient = -98.1 /
  // 1020 without a known rotating mass, Kn- = 3.0: A = A_brake_normal_service - 98.1 / 1020 + 0.03 on the slope.
  Inputs in = with_guidance();
  in.gradient.permille = {};
  ASSERT_TRUE(in.gradient.permille.append({{-10000.0}}, -10.0));
  ASSERT_TRUE(in.gradient.permille.append({{4600.0}}, 0.0));
  set_EOA(in, 4900.0, 4900.0);
  const auto d = built(in);
  const CurveView GUI = d->view(d->targets[0].GUI_EOA);
  // 0.4 m/s2 up to 15 m/s, 0.3 above. The level 200 m: v^2 = 0.8 * 200 = 160; then to 225 on the slope, then to 400.
  const double slope = -98.1 / 1020 + 0.03;
  EXPECT_NEAR(GUI.speed_at({{4700.0}}).si, std::sqrt(160.0), 1e-9);
  const double d_15 = 4700 - (225 - 160) / (2 * (0.4 + slope));
  EXPECT_NEAR(m(GUI.place_at({15.0})), d_15, 1e-9);
  const double d_20 = d_15 - (400 - 225) / (2 * (0.3 + slope));
  EXPECT_NEAR(m(GUI.place_at({20.0})), d_20, 1e-9);
  EXPECT_NEAR(d_20, 4228.429, 1e-3);
}

TEST(Guidance, FootOfAnMRSPTargetIsItsPermittedSpeedLocation) {
  Inputs in = with_guidance();
  ASSERT_TRUE(in.mrsp.append({{4000.0}}, {20.0}));
  const auto d = built(in);
  const Target& t = d->targets[0];
  EXPECT_EQ(m(d->view(t.GUI).foot()), m(t.d_P_target));
  EXPECT_EQ(d->view(t.GUI).speed_at(d->view(t.GUI).foot()).si, 20.0);
  const LimitSpeeds s = speeds_of_EBD(d->view(t.EBD), d->view(t.GUI), approach({25.0}, {}, {}, d->fixed),
                                      times_of(*d, t, {}, {}).EBD, {20.0}, t.d_P_target, d->fixed);
  EXPECT_EQ(s.V_P.si, 20.0);
}

TEST(ReleaseSpeed, GivenAndNational) {
  Inputs in = simple_inputs();
  set_EOA(in, 4900.0, 5000.0);
  in.authority.release_speed = ReleaseSpeedChoice::value;
  in.authority.V_release = {5.0};
  auto d = built(in);
  ASSERT_TRUE(d->release_speed.exists);
  EXPECT_EQ(d->release_speed.V_release.si, 5.0);
  // d_SBI1 = 4900 - 25 / 1.6 - 15; d_SBI2 = 5000 - 12.5 - 5 * 8 - 15.
  EXPECT_NEAR(m(d->release_speed.d_SBI1), 4869.375, 1e-9);
  EXPECT_NEAR(m(d->release_speed.d_SBI2), 4932.5, 1e-9);
  in.authority.release_speed = ReleaseSpeedChoice::national;
  ++in.revision;
  d = built(in);
  EXPECT_NEAR(d->release_speed.V_release.si * 3.6, 40.0, 1e-12);
  in.authority.temporary = true;
  ++in.revision;
  EXPECT_FALSE(built(in)->release_speed.exists);
  in.authority.temporary = false;
  in.authority.release_speed = ReleaseSpeedChoice::none;
  ++in.revision;
  EXPECT_FALSE(built(in)->release_speed.exists);
}

TEST(ReleaseSpeed, NotAboveTheMRSPNearTheEnd) {
  Inputs in = simple_inputs();
  set_EOA(in, 4900.0, 5000.0);
  in.authority.release_speed = ReleaseSpeedChoice::value;
  in.authority.V_release = {10.0};
  ASSERT_TRUE(in.mrsp.append({{4880.0}}, {6.0}));
  const auto d = built(in);
  EXPECT_EQ(d->release_speed.V_release.si, 6.0);
  EXPECT_NEAR(m(d->release_speed.d_SBI1), 4900 - 36 / 1.6 - 18, 1e-9);
}

TEST(ReleaseSpeed, CalculatedOnBoard) {
  Inputs in = simple_inputs();
  set_EOA(in, 4900.0, 5200.0);
  Authority& a = in.authority;
  a.release_speed = ReleaseSpeedChoice::on_board;
  a.Q_LOCACC_reference = {5.0};
  a.reference = {{4000.0}};
  a.confidence_interval = {50.0};
  auto d = built(in);
  // d_trip = 4900 + max(2 * 5 + 10 + 90, 50) = 5010; T = 8 s: the lowest V with V >= V_EBD - 1 km/h:
  // (V + e)^2 = 2 (190 - 8 V), e = 1/3.6.
  const double e = 1 / 3.6;
  const auto lowest = [e](double room, double T) {
    const double b = e + T;
    return -b + std::sqrt(b * b - e * e + 2 * room);
  };
  EXPECT_NEAR(m(d->release_speed.d_trip), 5010.0, 1e-9);
  EXPECT_NEAR(d->release_speed.V_release.si, lowest(190, 8), 1e-6);
  // Level 1: the antenna counts too.
  a.level_1_at_EOA = true;
  ++in.revision;
  d = built(in);
  EXPECT_NEAR(m(d->release_speed.d_trip), 5015.0, 1e-9);
  EXPECT_NEAR(d->release_speed.V_release.si, lowest(185, 8), 1e-6);
  // 4.0.0: traction cut-off as not implemented (T_traction 10 s >= T_be), and 1 s of delay in level 1.
  in.srs = SrsVersion::v4_0_0;
  ++in.revision;
  EXPECT_NEAR(built(in)->release_speed.V_release.si, lowest(185, 11), 1e-6);
  a.level_1_at_EOA = false;
  ++in.revision;
  EXPECT_NEAR(built(in)->release_speed.V_release.si, lowest(190, 10), 1e-6);
  // A larger confidence interval moves the trip location.
  in.srs = SrsVersion::v3_6_0;
  a.confidence_interval = {150.0};
  ++in.revision;
  EXPECT_NEAR(built(in)->release_speed.V_release.si, lowest(150, 8), 1e-6);
  // A speed restriction between trip location and SvL counts as well.
  a.confidence_interval = {50.0};
  ASSERT_TRUE(in.mrsp.append({{5050.0}}, {2.0}));
  ++in.revision;
  d = built(in);
  EXPECT_LT(d->release_speed.V_release.si, lowest(190, 8) - 1.0);
  // With the speed error: the larger of f41 (2 km/h up to 30 km/h) and V_ura is added.
  in.mrsp = {};
  ASSERT_TRUE(in.mrsp.append({{-1000.0}}, {30.0}));
  a.SvL = {{5100.0}};
  in.national_values.Q_NVINHSMICPERM = false;
  ++in.revision;
  EXPECT_NEAR(built(in)->release_speed.V_release.si, lowest(90, 8) - 2 / 3.6, 1e-6);
  a.V_ura = {1.0};
  ++in.revision;
  EXPECT_NEAR(built(in)->release_speed.V_release.si, lowest(90, 8) - 1.0, 1e-6);
  // No distance left: 0, no release speed.
  a.SvL = {{4950.0}};
  ++in.revision;
  EXPECT_FALSE(built(in)->release_speed.exists);
}

TEST(ReleaseSpeed, EveryTargetHasItsOwnTimesWithFeedback) {
  // Towards the restriction the service brake time is that of cmt, not that of cm0 as towards the SvL.
  Inputs in = simple_inputs();
  ASSERT_TRUE(in.mrsp.append({{5010.0}}, {2.0}));
  set_EOA(in, 5000.0, 5400.0);
  const auto d = built(in);
  ASSERT_EQ(d->targets[0].kind, TargetKind::MRSP);
  const Target& end = d->targets[1];
  const Feedback same{FeedbackTimes{{1.0}, {2.0}}, FeedbackTimes{{1.0}, {2.0}}};
  const Feedback longer{FeedbackTimes{{1.0}, {2.0}}, FeedbackTimes{{1.0}, {2.5}}};
  TimeConfig config = d->time_config;
  config.feedback_available = true;
  auto with = built(in);
  with->time_config = config;
  // 5 m/s: T_traction = 10 - (2 + T_bs2), T_traction + T_berem = 8 s in both: 0.5 s more of T_bs2 are 2.5 m.
  const Place a = rsm_start(*with, end, {5.0}, {{5000.0}}, true, same).d_SBI2;
  const Place b = rsm_start(*with, end, {5.0}, {{5000.0}}, true, longer).d_SBI2;
  EXPECT_NEAR((a - b).si, 2.5, 1e-9);
  EXPECT_EQ(rsm_start(*with, end, {5.0}, {{5000.0}}, false, same).d_SBI2,
            rsm_start(*with, end, {5.0}, {{5000.0}}, false, longer).d_SBI2);
}

TEST(ReleaseSpeed, ATargetSpeedAboveItDoesNotBeginItsMonitoringEarlier) {
  // 3.13.9.4.7: the limits of the targets between trip location and SvL at the release speed, here below 20 m/s.
  Inputs in = simple_inputs();
  set_EOA(in, 4900.0, 5200.0);
  in.authority.release_speed = ReleaseSpeedChoice::on_board;
  in.authority.Q_LOCACC_reference = {5.0};
  in.authority.reference = {{4000.0}};
  in.authority.confidence_interval = {50.0};
  const ReleaseSpeed without = built(in)->release_speed;
  ASSERT_TRUE(without.exists);
  ASSERT_LT(without.V_release.si, 20.0);
  ASSERT_TRUE(in.mrsp.append({{5100.0}}, {20.0}));
  ++in.revision;
  const auto d = built(in);
  ASSERT_EQ(d->targets[0].kind, TargetKind::MRSP);
  ASSERT_LT(d->release_speed.d_trip, d->targets[0].d_target);
  EXPECT_EQ(d->release_speed.V_release, without.V_release);
  EXPECT_EQ(d->release_speed.d_SBI2, without.d_SBI2);
}

TEST(Perturbation, WhereTheIndicationLimitCutsTheMRSP) {
  Inputs in = simple_inputs();
  set_EOA(in, 4900.0, 5000.0);
  auto d = built(in);
  // 30 m/s: d_EBI = 5000 - 450 - 240; SBI2 - 90; P - 120; I - 270. SBD as in OfEOAAndSvL.
  ASSERT_TRUE(d->perturbation.from_EBD.has_value());
  EXPECT_NEAR(m(*d->perturbation.from_EBD), 3830.0, 1e-9);
  EXPECT_NEAR(m(*d->perturbation.from_SBD), 3857.5, 1e-9);
  EXPECT_FALSE(d->perturbation.passed_at_once);
  // A speed increase where the train already has to brake: its place counts.
  in.mrsp = {};
  ASSERT_TRUE(in.mrsp.append({{-1000.0}}, {10.0}));
  ASSERT_TRUE(in.mrsp.append({{4000.0}}, {30.0}));
  ++in.revision;
  d = built(in);
  EXPECT_NEAR(m(*d->perturbation.from_EBD), 4000.0, 1e-9);
  // Too short an authority: passed at once.
  set_EOA(in, -960.0, -850.0);
  ++in.revision;
  EXPECT_TRUE(built(in)->perturbation.passed_at_once);
}

TEST(Perturbation, OfALimitOfAuthority) {
  Inputs in = simple_inputs();
  in.authority.kind = Authority::Kind::LOA;
  in.authority.EOA = {{5000.0}};
  in.authority.V_LOA = {20.0};
  auto d = built(in);
  const double v = 20.0 + 7.5 / 3.6;
  EXPECT_NEAR(m(*d->perturbation.from_EBD), 5000 - (900 - v * v) / 2 - 240 - 90 - 120 - 270, 1e-9);
  in.authority.V_LOA = {40.0};  // faster than every element: at the LOA
  ++in.revision;
  EXPECT_NEAR(m(*built(in)->perturbation.from_EBD), 5000.0, 1e-9);
}

TEST(PreIndication, SevenSecondsBefore) {
  Inputs in = simple_inputs(SrsVersion::v3_4_0);
  set_EOA(in, 4900.0, 5000.0);
  const auto d = built(in);
  // T_indication is 5 s: I at 4100 - 150 and 4127.5 - 150, less 7 s at 30 m/s.
  EXPECT_NEAR(m(*d->targets[0].d_preindication_EBD), 3740.0, 1e-9);
  EXPECT_NEAR(m(*d->targets[0].d_preindication_SBD), 3767.5, 1e-9);
  EXPECT_FALSE(d->targets[0].preindication_passed_at_once);
  in.authority.EOA = in.authority.SvL = {{200.0}};
  ++in.revision;
  EXPECT_TRUE(built(in)->targets[0].preindication_passed_at_once);
  // By the EOA alone, with a weak service brake.
  set_EOA(in, 4900.0, 5000.0);
  in.train.service[0].A_brake_service.steps[0].value = {0.08};
  ++in.revision;
  EXPECT_TRUE(built(in)->targets[0].preindication_passed_at_once);
}

TEST(PreIndication, OfALimitOfAuthority) {
  Inputs in = simple_inputs(SrsVersion::v3_4_0);
  in.authority.kind = Authority::Kind::LOA;
  in.authority.EOA = {{5000.0}};
  in.authority.V_LOA = {20.0};
  const double v = 20.0 + 7.5 / 3.6;
  EXPECT_NEAR(m(*built(in)->targets[0].d_preindication_EBD), 5000 - (900 - v * v) / 2 - 240 - 90 - 120 - 150 - 210,
              1e-9);
  // Faster than every element before it: no reason to brake.
  in.authority.V_LOA = {40.0};
  ++in.revision;
  const auto d = built(in);
  EXPECT_FALSE(d->targets[0].d_preindication_EBD.has_value());
  EXPECT_FALSE(d->targets[0].preindication_passed_at_once);
}

TEST(Curves, TargetsThatBecomeOneTakeTheWorseGradient) {
  // More decreases than fit; one of those merged into one target is due to a TSR.
  Inputs in = simple_inputs();
  for (int i = 0; i < 90; ++i) ASSERT_TRUE(in.mrsp.append({{1000.0 + 20.0 * i}}, {29.0 - 0.3 * i}));
  in.mrsp_due_to_TSR[85] = true;
  in.gradient.default_for_TSR = -20.0;
  auto d = built(in);
  ASSERT_TRUE(d->truncated);
  EXPECT_NEAR(d->targets.back().V_target.si, 29.0 - 0.3 * 89, 1e-9);
  EXPECT_TRUE(d->targets.back().due_to_TSR);
  in.gradient.default_for_TSR = 0.5;
  EXPECT_FALSE(built(in)->targets.back().due_to_TSR);
  // All of them are.
  in.mrsp_due_to_TSR.fill(true);
  EXPECT_TRUE(built(in)->targets.back().due_to_TSR);
}

TEST(PermittedBrakingDistance, KnowsNoServiceBrakeFeedback) {
  // 3.11.11: as if feedback were not implemented, even where T_bs is shorter than the minimum of 2 s with feedback.
  Inputs in = simple_inputs();
  in.train.T_service = {};
  ASSERT_TRUE(in.train.T_service.push_back({{1.0}, {0.5}, 0}));
  in.national_values.Q_NVSBTSMPERM = true;
  Inputs with = in;
  with.train.service_brake_feedback = true;
  with.national_values.Q_NVSBFBPERM = true;
  for (double D = 50.0; D < 1000.0; D += 5.0)
    ASSERT_EQ(permitted_braking_distance_speed(with, {D}, 0.0, false),
              permitted_braking_distance_speed(in, {D}, 0.0, false))
        << D;
}

TEST(Curves, WhatIsNotSaid) {
  // Defaults that callers rely on.
  EXPECT_EQ(Authority{}.release_speed, ReleaseSpeedChoice::none);
  Inputs in = simple_inputs();
  in.revision = 0;
  Derived d;
  EXPECT_TRUE(rebuild(d, in)) << "nothing was built yet, whatever the number of the inputs";
  EXPECT_FALSE(d.release_speed.on_board);
  in.gradient.default_for_TSR = -20.0;
  in.gradient.known_to = Place{{500.0}};
  const auto b = built(in);
  EXPECT_EQ(b->decelerations.at(CurveKind::EBD, {10.0}, {{2000.0}}).si, 1.0) << "no TSR's";
  EXPECT_LT(b->decelerations.at(CurveKind::EBD, {10.0}, {{2000.0}}, true).si, 1.0);
}

TEST(Curves, WithoutRoomTheRestIsLevel) {
  Inputs in = simple_inputs();
  in.gradient.permille = {};
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(in.gradient.permille.append({{i * 100.0}}, i % 2 == 0 ? 5.0 : 0.0));
  in.train.L_TRAIN = {10.0};
  set_EOA(in, 2000.0, 2000.0);
  const auto d = built(in);
  std::array<Knot, 5> room{};
  std::size_t used = 0;
  const CurveWarnings w = trace(room, used, d->decelerations, CurveKind::EBD, false, {{2000.0}}, {}, {}, {100.0});
  EXPECT_TRUE(w.truncated);
  ASSERT_EQ(used, 5u);
  const CurveView curve{room};
  const Speed last{std::sqrt(room[4].w.si)};
  EXPECT_EQ(curve.speed_at({{0.0}}), last);               // the speed does not rise further upstream
  EXPECT_LE(m(curve.place_at(last + Speed{0.1})), -1e8);  // a higher one nowhere
}

TEST(Gradient, TheLargestInputsFit) {
  Inputs in = simple_inputs();
  in.gradient.permille = {};
  for (std::size_t i = 0; i < kGradientSteps; ++i)
    ASSERT_TRUE(
        in.gradient.permille.append({{static_cast<double>(i) * 37.0}}, static_cast<double>((i * 29) % 31) - 15));
  in.gradient.known_to = Place{{static_cast<double>(kGradientSteps) * 37.0}};
  in.gradient.default_for_TSR = -3.0;
  for (std::size_t i = 0; i < kZones; ++i)
    ASSERT_TRUE(in.conditions.reduced_adhesion.push_back(
        {{{static_cast<double>(i) * 201.0 + 3.0}}, {{static_cast<double>(i) * 201.0 + 55.0}}}));
  in.conditions.regenerative_off = Place{{10.5}};
  in.conditions.magnetic_shoe_off = Place{{20.5}};
  in.conditions.eddy_current_emergency_off = Place{{30.5}};
  in.conditions.eddy_current_service_off = Place{{40.5}};
  in.conditions.powerless = Place{{50.5}};
  in.train.L_TRAIN = {20.0};
  set_EOA(in, 3500.0, 3500.0);
  ASSERT_TRUE(in.mrsp.append({{3000.0}}, {10.0}));
  in.mrsp_due_to_TSR[1] = true;
  const auto d = built(in);
  EXPECT_GT(d->decelerations.segments.size(), 100u);
  EXPECT_GT(d->decelerations.segments_for_TSR.size(), 100u);
  EXPECT_FALSE(d->truncated);
}

TEST(LevelCrossing, WhereItsSpeedTakesOver) {
  Inputs in = simple_inputs();
  auto d = built(in);
  Motion motion = at(2700.0, 20.0);
  LxSubstitution lx = lx_substitution(in, *d, {{3000.0}}, {10.0}, motion);
  // SBI2: 3000 - 50 - 80 - 30; SBI1: 3000 - 62.5 - 30: the EBD decides, 4 s before it.
  EXPECT_NEAR(m(lx.EBD.d_SBI), 2840.0, 1e-9);
  EXPECT_NEAR(m(lx.SBD.d_SBI), 2907.5, 1e-9);
  EXPECT_FALSE(lx.from_SBD);
  EXPECT_NEAR(m(lx.d_P), 2800.0, 1e-9);
  EXPECT_FALSE(lx.passed);
  motion.max_safe_front = {{2801.0}};
  EXPECT_TRUE(lx_substitution(in, *d, {{3000.0}}, {10.0}, motion).passed);
  // 4.0.0 uses the current acceleration and speed error.
  in.srs = SrsVersion::v4_0_0;
  ++in.revision;
  d = built(in);
  motion.A_est = {0.3};
  lx = lx_substitution(in, *d, {{3000.0}}, {10.0}, motion);
  const double V_bec = 10 + 0.3 * 5 + 0.3 * 3;
  const double D_bec = (10 + 0.75) * 5 + (11.5 + 0.45) * 3;
  EXPECT_NEAR(m(lx.EBD.d_SBI), 3000 - V_bec * V_bec / 2 - D_bec - 30, 1e-9);
  // Both build-up times reduced (A.3.12) for V_LX = 1 m/s: T_bs 3 s, 1 s of it reaction, so incr = 4 s; A_SB = 0.8:
  // x = sqrt(2 * 4 * 1 / 0.8) = sqrt(10); T_bs_reduced = (1 + 1 + x) / 2, more than the distance asks for:
  // (1 + x) - 0.8 x^3 / 24 - 1 / 1.6 = 2.483. T_be 8 s, 2 s of it reaction, incr = 12 s, A_EB = 1: x = sqrt(24),
  // D = 2 + x - x^3 / 72 = 2 + 2 x / 3, T_be_reduced = D - 1 / 2, more than (2 + 2 + x) / 2 = 4.449.
  in.train.T_traction_cut_off = {0.0};
  ++in.revision;
  d = built(in);
  motion = at(2700.0, 20.0);
  lx = lx_substitution(in, *d, {{3000.0}}, {1.0}, motion);
  const double T_bs_reduced = 1 + std::sqrt(10.0) / 2;
  const double T_be_reduced = 1.5 + 2 * std::sqrt(24.0) / 3;
  EXPECT_NEAR(m(lx.SBD.d_SBI), 3000 - 1 / 1.6 - T_bs_reduced, 1e-9);
  EXPECT_NEAR(m(lx.EBD.d_SBI), 3000 - 0.5 - T_be_reduced - T_bs_reduced, 1e-9);
  EXPECT_NEAR(m(lx.d_P), 3000 - 0.5 - T_be_reduced - T_bs_reduced - 4, 1e-9);
  // A weak service brake decides by the SBD.
  in.train.T_traction_cut_off = {10.0};
  motion.A_est = {0.3};
  in.train.service[0].A_brake_service.steps[0].value = {0.1};
  ++in.revision;
  d = built(in);
  EXPECT_TRUE(lx_substitution(in, *d, {{3000.0}}, {10.0}, motion).from_SBD);
}

TEST(PermittedBrakingDistance, RoundedDownTo5KmH) {
  Inputs in = simple_inputs();
  in.train.L_antenna_front = {5.0};
  // EB: T_traction 10 s (cut-off as not implemented) >= T_be; v = V + dV: v^2 = 2 (995 - 11 v) gives
  // 34.95 m/s = 125.8 km/h, 1 km/h less is still a solution: V = 117 km/h + dV_ebi 8.0.
  EXPECT_NEAR(permitted_braking_distance_speed(in, {1000.0}, 0.0, true).si * 3.6, 115.0, 1e-9);
  // SB: T_bs2 3 s more against the EBD: v^2 = 2 (995 - 14 v): 32.77 m/s = 118 km/h less 5.8 and 1;
  // against the SBD: v^2 = 1.6 (995 - 4 v): 36.8 m/s.
  EXPECT_NEAR(permitted_braking_distance_speed(in, {1000.0}, 0.0, false).si * 3.6, 110.0, 1e-9);
  // A fall needs a longer distance.
  EXPECT_LT(permitted_braking_distance_speed(in, {1000.0}, -20.0, true).si * 3.6, 114.0);
  // No speed fits.
  EXPECT_EQ(permitted_braking_distance_speed(in, {10.0}, 0.0, true).si, 0.0);
  EXPECT_EQ(permitted_braking_distance_speed(in, {30.0}, 0.0, false).si, 0.0);
  EXPECT_EQ(permitted_braking_distance_speed(in, {30.1}, 0.0, true).si, 0.0);  // 0 km/h itself is a solution
  // The whole range of speeds fits.
  EXPECT_GT(permitted_braking_distance_speed(in, {90000.0}, 0.0, true).si * 3.6, 200.0);
  // Slippery rail selected by the driver counts.
  in.conditions.slippery_rail = true;
  EXPECT_LT(permitted_braking_distance_speed(in, {1000.0}, 0.0, true).si * 3.6, 114.0);
}

// ---- A.3.12 ------------------------------------------------------------------------------------------

/// The ramp model by small steps: time and distance until the target speed is reached.
struct RampRun {
  double t, s;
};
RampRun run_ramp(const Ramp& r) {
  const double incr = 2 * (r.T.si - r.T_react.si);
  double v = r.v0.si;
  double s = 0.0;
  double t = 0.0;
  constexpr double dt = 1e-5;
  const auto accel = [&](double at) {
    const double a = at < r.T_traction_max.si ? r.A_est1.si : r.A_est2.si;
    return a - (at > r.T_react.si ? r.A.A_brake_min.si * (at - r.T_react.si) / incr : 0.0);
  };
  while (t < r.T_react.si || v > r.V_target.si) {
    const double a = accel(t + dt / 2);
    s += v * dt + a * dt * dt / 2;
    v += a * dt;
    t += dt;
  }
  return {t, s};
}
/// Time of the step model for the same distance.
double step_time(const Ramp& r, double s) {
  double low = 0.0;
  double high = r.T.si;
  for (int i = 0; i < 60; ++i) {
    const double t = (low + high) / 2;
    const double tt = std::min(t, r.T_traction_min.si);
    const double v1 = r.v0.si + r.A_est1.si * tt;
    const double v = v1 + r.A_est2.si * (t - tt);
    const double run = (r.v0.si + v1) / 2 * tt + (v1 + v) / 2 * (t - tt);
    (run + (v * v - r.V_target.si * r.V_target.si) / (2 * r.A.A_max.si) < s ? low : high) = t;
  }
  return low;
}

TEST(ReducedBuildUp, ByHand) {
  Ramp r{.T = {4.0}, .T_react = {1.0}, .v0 = {2.0}, .V_target = {}, .stop = true};
  r.A = {{1.0}, {1.0}};
  // x = 6 sqrt(4 / 6); (1 + 1 + x) / 2.
  EXPECT_NEAR(reduced_build_up_time(r).si, (2 + 6 * std::sqrt(4.0 / 6)) / 2, 1e-12);
  r.v0 = {5.0};  // still moving at the end of the ramp: not reduced
  EXPECT_EQ(reduced_build_up_time(r).si, 4.0);
  r.v0 = {0.0};
  EXPECT_EQ(reduced_build_up_time(r).si, 1.0);
  r.stop = false;
  r.V_target = {6.0};
  r.v0 = {5.0};  // not above the target when the ramp begins
  EXPECT_EQ(reduced_build_up_time(r).si, 1.0);
  r.v0 = {10.0};  // still above the target at its end
  EXPECT_EQ(reduced_build_up_time(r).si, 4.0);
  r.v0 = {7.0};
  r.A = {{-0.1}, {1.0}};
  EXPECT_EQ(reduced_build_up_time(r).si, 4.0);
  r.T_react = {4.0};
  EXPECT_EQ(reduced_build_up_time(r).si, 4.0);
}

TEST(ReducedBuildUp, OfTheServiceBrakeByHand) {
  // T_bs 6 s, 2 s of it reaction: t2 = 10 s, incr = 8 s. From 6 to 5 m/s with A_SB = 0.5: V_t2 = 6 - 0.5 * 8 / 2 = 4.
  // x = sqrt(2 * 8 * 1 / 0.5) = sqrt(32), t_e = 2 + x; D = 6 t_e - 0.5 x^3 / 48 = 12 + 6 x - x / 3.
  Ramp r{.T = {6.0}, .T_react = {2.0}, .v0 = {6.0}, .V_target = {5.0}, .A = {{0.5}, {0.6}}};
  const double D = 12 + 17 * std::sqrt(32.0) / 3;
  // A_expected_max = 0.6: t_d = (D + 25 / 1.2) / 6 - 6 / 1.2 = 5.815 s, above (2 + t_e) / 2 = 4.828 s.
  EXPECT_NEAR(reduced_build_up_time(r).si, (D + 25 / 1.2) / 6 - 5, 1e-12);
  EXPECT_NEAR(reduced_build_up_time(r).si, 5.8148, 1e-4);
  r.A.A_max = {0.8};  // t_d = 6.197 s: not more than T_bs
  EXPECT_EQ(reduced_build_up_time(r).si, 6.0);
}

TEST(ReducedBuildUp, OfTheEmergencyBrakeWithTractionByHand) {
  // T_be 4 s, 1 s of it reaction: t2 = 7 s, incr = 6 s. A_est 0.5, from T_traction on 0.4; A_EB = 2, A_safe_max = 1.6.
  Ramp r{.T = {4.0}, .T_react = {1.0}, .v0 = {10.0}, .V_target = {9.34}, .A_est1 = {0.5}, .A_est2 = {0.4}};
  r.T_traction_max = {2.0};
  r.T_traction_min = {1.0};
  r.A = {{2.0}, {1.6}};
  // B = 0.66 + 0.5 * 2 + 0.4 * (1 - 2) = 1.26; x = 3 (0.4 + sqrt(0.16 + 4 * 1.26 / 6)) = 4.2, t_e = 5.2;
  // D = 52 + 1 + 1 * 3.2 + 0.2 * 3.2^2 - 2 * 4.2^3 / 36 = 54.132.
  // Step model: V1 = 10.5, D0 = 10.25; q = 26.25^2 - (10.5^2 - 9.34^2 + 3.2 (10.25 - 54.132)) / (0.4 * 2) = 835.8225;
  // t_d = -(10 + 0.1) / 0.4 + sqrt(q), above (1 + t_e) / 2 = 3.1.
  EXPECT_NEAR(reduced_build_up_time(r).si, -25.25 + std::sqrt(835.8225), 1e-9);
  EXPECT_NEAR(reduced_build_up_time(r).si, 3.6606, 1e-4);
}

TEST(ReducedBuildUp, AgreesWithTheRampAndStepModelsInSmallSteps) {
  int reduced = 0;
  for (int i = 0; i < 60; ++i) {
    Dice dice(static_cast<std::uint64_t>(i));
    Ramp r{.T = {dice.real(3.0, 8.0)}, .T_react = {dice.real(0.5, 2.0)}};
    r.stop = dice.chance(0.5);
    r.V_target = {r.stop ? 0.0 : dice.real(5.0, 30.0)};
    const double over = dice.real(0.1, 2.0);
    r.v0 = r.V_target + Speed{over};
    const bool accelerating = dice.chance(0.5);
    r.A_est1 = {accelerating ? dice.real(0.05, 0.3) : 0.0};
    r.A_est2 = r.A_est1;
    r.T_traction_min = {dice.real(0.0, 0.4)};
    r.T_traction_max = {r.T_traction_min.si + dice.real(0.0, 0.1)};
    const double A = dice.real(0.8, 1.2);
    r.A = {{A}, {A * dice.real(1.0, 1.4)}};
    const double T = reduced_build_up_time(r).si;
    ASSERT_LE(T, r.T.si);
    if (T >= r.T.si) continue;
    ++reduced;
    const RampRun run = run_ramp(r);
    const double expected = std::max((r.T_react.si + run.t) / 2, step_time(r, run.s));
    ASSERT_NEAR(T, std::min(expected, r.T.si), 2e-3) << i;
  }
  EXPECT_GT(reduced, 20);
}

/// A result found without the track equals the result with the track, for every brake that is not stronger.
TEST(ReducedBuildUp, WhatIsSettledEarlyIsWhatTheTrackSays) {
  int settled = 0;
  int open = 0;
  for (int i = 0; i < 2000; ++i) {
    Dice dice(static_cast<std::uint64_t>(i));
    Ramp r{.T = {dice.real(0.5, 8.0)}, .T_react = {dice.real(0.1, 2.0)}, .v0 = {dice.real(0.0, 40.0)}};
    r.stop = dice.chance(0.3);
    r.V_target = {dice.real(0.0, 40.0)};
    r.A_est1 = {dice.real(0.0, 0.9)};
    r.A_est2 = {std::min(r.A_est1.si, 0.4)};
    r.T_traction_min = {dice.real(0.0, 3.0)};
    r.T_traction_max = {r.T_traction_min.si + dice.real(0.0, 1.0)};
    const double highest = dice.real(0.2, 1.3);
    const std::optional<Duration> early = build_up_time_settled(r, {highest});
    (early.has_value() ? settled : open) += 1;
    if (!early.has_value()) continue;
    for (const double weaker : {1.0, 0.7, 0.1, 0.0}) {
      r.A = {{highest * weaker}, {highest}};
      ASSERT_EQ(reduced_build_up_time(r), *early) << i;
    }
  }
  EXPECT_GT(settled, 1000);
  EXPECT_GT(open, 10);
}

TEST(ReducedBuildUp, TheServiceBrakeTowardsTheEOAKnowsNothingOfTheWayToTheSvL) {
  Inputs in = simple_inputs(SrsVersion::v4_0_0);
  ASSERT_TRUE(in.gradient.permille.append({{4900.0}}, 30.0));  // under the whole train from 5000 on
  set_EOA(in, 4900.0, 5200.0);
  const auto apart = built(in);
  set_EOA(in, 4900.0, 4900.0);
  const auto together = built(in);
  const Approach a = approach({1.0}, {}, {}, apart->fixed);
  const TimesAsked asked{std::nullopt, Fronts{{{4880.0}}, {{4880.0}}}};
  const TargetTimes t = times_of(*apart, apart->targets[0], a, asked);
  EXPECT_EQ(t.SBD.T_bs1, times_of(*together, together->targets[0], a, asked).SBD.T_bs1);
  EXPECT_LT(t.SBD.T_bs1, t.EBD.T_bs1);
}

/// Every segment and every band evaluated separately.
DecelerationRange range_by_cells(const Decelerations& d, CurveKind kind, Place from, Place to, Place reduced_from,
                                 Speed low, Speed high) {
  DecelerationRange range{{1e9}, {-1e9}};
  const Segments& s = d.segments;
  const auto meets = [&](std::size_t i, Place a, Place b) {
    return (i + 1 == s.size() || s[i + 1].from > a) && (i == 0 || s[i].from <= b);
  };
  bool reduced = false;
  for (std::size_t i = 0; i < s.size(); ++i)
    reduced = reduced || (s[i].reduced_adhesion && meets(i, std::min(from, reduced_from), to));
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (!meets(i, from, to)) continue;
    double w_from = -1.0;
    for (const Band& b : d.bands(kind, s[i])) {
      if (b.w_upto.si >= low.si * low.si && w_from < high.si * high.si) {
        range.A_brake_min = std::min(range.A_brake_min, b.A[reduced ? 1 : 0]);
        range.A_max = std::max(range.A_max, deceleration(b, s[i]));
      }
      w_from = b.w_upto.si;
    }
  }
  return range;
}
TEST(ReducedBuildUp, RangeOfDecelerationsOverPlacesAndSpeeds) {
  for (int i = 0; i < 1000; ++i) {
    RandomCase c = random_case(static_cast<std::uint64_t>(i), SrsVersion::v4_0_0);
    Dice dice(static_cast<std::uint64_t>(i) + 900);
    c.in.conditions.regenerative_off = Place{{dice.real(0.0, 3000.0)}};
    const auto d = built(c.in);
    for (int n = 0; n < 10; ++n) {
      const Place from{{dice.real(-3000.0, 6000.0)}};
      const Place to = from + Distance{dice.real(0.0, 4000.0)};
      const Place reduced_from = from - Distance{dice.real(-100.0, 300.0)};
      const Speed low{dice.real(0.0, 40.0)};
      const Speed high = low + Speed{dice.real(0.0, 30.0)};
      for (const CurveKind kind : {CurveKind::EBD, CurveKind::SBD}) {
        const DecelerationRange r =
            deceleration_range(d->decelerations, kind, false, from, to, reduced_from, low, high);
        const DecelerationRange expected = range_by_cells(d->decelerations, kind, from, to, reduced_from, low, high);
        ASSERT_EQ(r.A_brake_min, expected.A_brake_min) << i;
        ASSERT_EQ(r.A_max, expected.A_max) << i;
      }
    }
  }
}

TEST(Decelerations, TheHighestOfAllBands) {
  const auto d = built(simple_inputs());
  EXPECT_EQ(d->decelerations.highest_safe.si, 1.0);
  EXPECT_EQ(d->decelerations.highest_expected.si, 0.8);
}

TEST(ReducedBuildUp, LimitsOf400) {
  Inputs in = simple_inputs(SrsVersion::v4_0_0);
  set_EOA(in, 4900.0, 5000.0);
  const auto d = built(in);
  const Target& t = d->targets[0];
  TimesAsked asked;
  asked.reduced_from = Fronts{{{4800.0}}, {{4790.0}}};
  // Slow: both times are reduced; fast: none.
  const TargetTimes slow = times_of(*d, t, approach({1.0}, {}, {}, d->fixed), asked);
  EXPECT_TRUE(slow.reduced_be);
  EXPECT_TRUE(slow.reduced_bs);
  EXPECT_LT(slow.EBD.T_be.si, 8.0);
  EXPECT_LT(slow.SBD.T_bs1.si, 3.0);
  const TargetTimes fast = times_of(*d, t, approach({30.0}, {}, {}, d->fixed), asked);
  EXPECT_FALSE(fast.reduced_be);
  EXPECT_EQ(fast.EBD, times_of(*d, t, approach({30.0}, {}, {}, d->fixed), {}).EBD);
  // At standstill the reaction times apply.
  const TargetTimes standing = times_of(*d, t, approach({0.0}, {}, {}, d->fixed), asked);
  EXPECT_EQ(standing.EBD.T_bs2.si, 1.0);
  EXPECT_EQ(standing.EBD.T_be.si, 2.0);
}

TEST(ReducedBuildUp, PermittedLocationAtTheTargetSpeedIsFullyReduced) {
  // 3.13.9.3.5.10 for 20 m/s: d_EBD = 4000 + (dV_ebi: (20 + 7.5 / 3.6)^2 - 20^2) / 2; T_be_react 2 s.
  Inputs in = simple_inputs(SrsVersion::v4_0_0);
  ASSERT_TRUE(in.mrsp.append({{4000.0}}, {20.0}));
  const double foot = 4000 + (std::pow(20 + 7.5 / 3.6, 2) - 400) / 2;
  // T_traction_max = 10 - (2 + T_bs_react 1) = 7; T_bs_foot = 1.
  EXPECT_NEAR(m(built(in)->targets[0].d_P_target), foot - 20 * 7 - 20 * (4 + 1), 1e-9);
  // With feedback the same T_traction_max (A.3.12.2.7), and T_bs_foot = T_bs2 = 3.
  in.national_values.Q_NVSBFBPERM = true;
  in.train.service_brake_feedback = true;
  ++in.revision;
  EXPECT_NEAR(m(built(in)->targets[0].d_P_target), foot - 20 * 7 - 20 * (4 + 3), 1e-9);
  // Without a service brake command T_bs2 = 0 everywhere.
  in.train.service_brake_interface = false;
  ++in.revision;
  EXPECT_NEAR(m(built(in)->targets[0].d_P_target), foot - 20 * 8 - 20 * 4, 1e-9);
}

TEST(ReducedBuildUp, TheStartOfReleaseSpeedMonitoringSeesTheTrackInFrontOfIt) {
  // Without service brake; T_be 14 s, 2 s of it reaction: V_t2 = 10 - A_EB * 24 / 2 at 10 m/s.
  Inputs in = simple_inputs(SrsVersion::v4_0_0);
  in.train.service_brake_interface = false;
  in.train.T_traction_cut_off = {0.0};
  in.train.T_emergency[0].T_brake = {14.0};
  set_EOA(in, 5000.0, 5000.0);
  in.authority.release_speed = ReleaseSpeedChoice::value;
  in.authority.V_release = {10.0};
  // A_EB = 1: x = sqrt(2 * 24 * 10); (2 + 2 + x) / 2 = 12.95 s, more than the distance asks for (11.61 s).
  const double T_be_reduced = 2 + std::sqrt(480.0) / 2;
  EXPECT_NEAR(m(built(in)->release_speed.d_SBI2), 5000 - 50 - 10 * T_be_reduced, 1e-9);
  // Reduced adhesion (0.7) from 4600 to 4740 and the train's 100 m, in rear of the last 50 m of the EBD, but in front
  // of a train that starts to brake 190 m before the end: V_t2 = 1.6 m/s, nothing is reduced.
  ASSERT_TRUE(in.conditions.reduced_adhesion.push_back({{{4600.0}}, {{4740.0}}}));
  ++in.revision;
  EXPECT_NEAR(m(built(in)->release_speed.d_SBI2), 5000 - 50 - 10 * 14, 1e-9);
}

TEST(ReducedBuildUp, RangesOfDeceleration) {
  Inputs in = simple_inputs(SrsVersion::v4_0_0);
  in.gradient.permille = {};
  ASSERT_TRUE(in.gradient.permille.append({{-10000.0}}, 0.0));
  ASSERT_TRUE(in.gradient.permille.append({{2000.0}}, 10.0));
  ASSERT_TRUE(in.conditions.reduced_adhesion.push_back({{{3000.0}}, {{3100.0}}}));
  set_EOA(in, 4900.0, 5000.0);
  const auto d = built(in);
  const auto range = [&](double from, double to, double min_safe) {
    return deceleration_range(d->decelerations, CurveKind::EBD, false, {{from}}, {{to}}, {{min_safe}}, {}, {20.0});
  };
  const double uphill = 9.81 * 10 / 1150;
  DecelerationRange r = range(1000, 1500, 1000);
  EXPECT_EQ(r.A_brake_min.si, 1.0);
  EXPECT_EQ(r.A_max.si, 1.0);
  r = range(1000, 2500, 1000);
  EXPECT_EQ(r.A_brake_min.si, 1.0);
  EXPECT_NEAR(r.A_max.si, 1.0 + uphill, 1e-12);
  r = range(2500, 4000, 2500);
  EXPECT_EQ(r.A_brake_min.si, 0.7);
  EXPECT_NEAR(r.A_max.si, 1.0 + uphill, 1e-12);
  r = range(3500, 4000, 3150);  // the min safe front end is still in the area
  EXPECT_EQ(r.A_brake_min.si, 0.7);
  r = range(3500, 4000, 3300);
  EXPECT_EQ(r.A_brake_min.si, 1.0);
}

TEST(Explain, CarriesTheValuesOfTheComputation) {
  Inputs in = simple_inputs();
  set_EOA(in, 4900.0, 5000.0);
  const auto d = built(in);
  const Explanation e = explain(*d, in, d->targets[0], {30.0}, {1.0}, {0.6});
  EXPECT_EQ(e.approach.V_delta0.si, 0.0);  // inhibited
  EXPECT_EQ(e.times.T_traction.si, 5.0);
  EXPECT_EQ(e.A_safe.si, 1.0);
  EXPECT_EQ(e.A_brake_emergency.si, 1.0);
  EXPECT_EQ(e.A_expected.si, 0.8);
  EXPECT_EQ(e.A_brake_service.si, 0.8);
  EXPECT_NEAR(m(e.d_EBD), 4550.0, 1e-9);
  EXPECT_NEAR(m(*e.d_SBD), 4337.5, 1e-9);
  EXPECT_EQ(e.d_FLOI, std::min(e.EBD.d_SBI, e.SBD->d_SBI));
  // The speed at the place of a limit is the speed of the limit.
  const PositionRow row = speeds_at(*d, in, d->targets[0], e.d_P, {1.0}, {0.6});
  EXPECT_NEAR(row.P.si, 30.0, 1e-9);
  EXPECT_LT(row.I, row.P);
  EXPECT_LT(row.P, row.W);
  EXPECT_LT(row.W, row.SBI);
  EXPECT_LT(row.SBI, row.EBI);
  EXPECT_LT(row.EBI, row.EBD);
  EXPECT_NEAR(row.SBD.si, std::sqrt(1.6 * (4900.0 - m(e.d_P))), 1e-9);
  EXPECT_EQ(speeds_at(*d, in, d->targets[0], {{5001.0}}, {}, {}).P.si, 0.0);
  EXPECT_EQ(speeds_at(*d, in, d->targets[0], {{-90000.0}}, {}, {}).P, d->V_relevant);
}

TEST(Explain, WithoutAPlaceTheTrainIsAboutToReachItsFirstLimit) {
  // T_be 14 s, 2 s of it reaction, no service brake: at 10 m/s (2 + 2 + sqrt(480)) / 2, see release speed monitoring.
  Inputs in = simple_inputs(SrsVersion::v4_0_0);
  in.train.service_brake_interface = false;
  in.train.T_traction_cut_off = {0.0};
  in.train.T_emergency[0].T_brake = {14.0};
  set_EOA(in, 5000.0, 5000.0);
  auto d = built(in);
  Explanation e = explain(*d, in, d->targets[0], {10.0}, {}, {});
  EXPECT_NEAR(e.times.T_be.si, 2 + std::sqrt(480.0) / 2, 1e-9);
  // d_I with 14 s: 5000 - 50 - 140 - 40 - 9 * 10. Reduced adhesion begins beyond it.
  EXPECT_NEAR(m(e.est_front), 4680.0, 1e-9);
  ASSERT_TRUE(in.conditions.reduced_adhesion.push_back({{{4690.0}}, {{4740.0}}}));
  ++in.revision;
  d = built(in);
  EXPECT_EQ(explain(*d, in, d->targets[0], {10.0}, {}, {}).times.T_be.si, 14.0);
  // A train further on has passed it.
  Motion beyond = at(4900.0, 10.0);
  EXPECT_NEAR(explain(*d, in, d->targets[0], {10.0}, {}, {}, &beyond).times.T_be.si, 2 + std::sqrt(480.0) / 2, 1e-9);
}

TEST(Explain, TheGuidanceCurveOfTheEOAAndOfTheSvL) {
  Inputs in = with_guidance();
  set_EOA(in, 4900.0, 5000.0);
  const auto d = built(in);
  // d_GUI(10) = 4900 - 100 / 0.8 towards the EOA, 100 m further towards the SvL.
  EXPECT_NEAR(m(*explain(*d, in, d->targets[0], {10.0}, {}, {}).d_GUI), 4775.0, 1e-9);
}

TEST(Explain, GradientsOfBothCurves) {
  Inputs in = simple_inputs();
  in.gradient.permille.steps[0].value = -10.0;
  set_EOA(in, 4900.0, 5000.0);
  const auto d = built(in);
  const Explanation e = explain(*d, in, d->targets[0], {30.0}, {}, {});
  const double A = -9.81 * 10.0 / (1000.0 + 10.0 * 2.0);
  EXPECT_NEAR(e.A_gradient_EBD.si, A, 1e-12);
  EXPECT_NEAR(e.A_gradient_SBD.si, A, 1e-12);
  EXPECT_NEAR(e.A_expected.si, 0.8 + A, 1e-12);
}

TEST(Explain, SpeedsAtAPlaceAreThoseOfATrainThere) {
  // 4.0.0 reduces build-up times from the train's front end: a train at the place of a limit has exactly that limit.
  for (int i = 0; i < 300; ++i) {
    const RandomCase c = random_case(static_cast<std::uint64_t>(i), SrsVersion::v4_0_0);
    const auto d = built(c.in);
    const Target& t = d->targets.back();
    const Motion& m = c.motion;
    const Distance under_reading = m.est_front - m.min_safe_front;
    const PositionRow row = speeds_at(*d, c.in, t, m.est_front, m.V_ura, m.A_est, under_reading);
    const auto place = [&](Speed V) { return explain(*d, c.in, t, V, m.V_ura, m.A_est, &m).d_P; };
    if (row.P.si <= t.V_target.si + 1.0 || row.P >= kmh(499.0)) continue;
    // Just below the speed the train is in rear of P for it, just above it is not.
    EXPECT_GE(place(row.P - Speed{1e-6}), m.est_front) << i;
    EXPECT_LE(place(row.P + Speed{1e-6}), m.est_front) << i;
  }
}

TEST(Rebuild, OnlyWhenSomethingChanged) {
  Inputs in = simple_inputs();
  set_EOA(in, 4900.0, 5000.0);
  auto d = std::make_unique<Derived>();
  EXPECT_TRUE(rebuild(*d, in));
  EXPECT_FALSE(d->no_deceleration);
  EXPECT_FALSE(d->truncated);
  EXPECT_FALSE(rebuild(*d, in));
  ++in.revision;
  EXPECT_TRUE(rebuild(*d, in));
}

TEST(Rebuild, TargetsOfTheVersions) {
  Inputs in = simple_inputs();
  ASSERT_TRUE(in.mrsp.append({{2000.0}}, {15.0}));
  ASSERT_TRUE(in.mrsp.append({{3000.0}}, {20.0}));  // lower than 30, but no decrease
  ASSERT_TRUE(in.mrsp.append({{4000.0}}, {10.0}));
  EXPECT_EQ(built(in)->targets.size(), 2u);
  in.srs = SrsVersion::v4_0_0;
  EXPECT_EQ(built(in)->targets.size(), 3u);
  in.supervise_targets = false;
  in.SR_end = Place{{5000.0}};
  const auto d = built(in);
  ASSERT_EQ(d->targets.size(), 1u);
  EXPECT_EQ(d->targets[0].kind, TargetKind::SR_end);
}

TEST(Rebuild, TooManyTargetsAreOneStricterTarget) {
  Inputs in = simple_inputs();
  in.mrsp = {};
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(in.mrsp.append({{i * 100.0}}, {50.0 - 0.4 * i}));
  set_EOA(in, 20000.0, 20000.0);
  const auto d = built(in);
  EXPECT_TRUE(d->truncated);
  EXPECT_EQ(d->targets.back().kind, TargetKind::EOA_SvL);
  const Target& last = d->targets[d->targets.size() - 2];
  EXPECT_NEAR(last.V_target.si, 50.0 - 0.4 * 99, 1e-9);
  EXPECT_LT(m(last.d_target), 9900.0);
}

}  // namespace
