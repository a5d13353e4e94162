// 3.13.10: types of monitoring, statuses, commands, displayed values, cycle by cycle.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "openevc/curves.h"
#include "sdm/evaluate.h"
#include "sdm/test_cases.h"

namespace {

using namespace evc;
using namespace evc::sdm;
using namespace evc::sdm::test;

/// Inputs, curves and state of one unit.
struct Unit {
  Inputs in;
  std::unique_ptr<Derived> d = std::make_unique<Derived>();
  Supervision s;
  Result r;

  explicit Unit(SrsVersion srs = SrsVersion::v3_6_0) : in(simple_inputs(srs)) {}
  Unit& build() {
    ++in.revision;
    rebuild(*d, in);
    return *this;
  }
  const Result& cycle(const Motion& m) { return r = supervise(s, *d, m); }
  const Result& cycle(double x, double V) { return cycle(at(x, V)); }
};

Unit approaching_EOA(SrsVersion srs = SrsVersion::v3_6_0) {
  Unit u(srs);
  set_EOA(u.in, 4900.0, 5000.0);
  u.build();
  return u;
}

// Ceiling: 30 m/s = 108 km/h; +4, +5.5, +7.5 km/h.
constexpr double kM = 30.0, kW = 30.0 + 4 / 3.6, kSBI = 30.0 + 5.5 / 3.6, kEBI = 30.0 + 7.5 / 3.6;

TEST(CSM, StatusesAndCommandsBySpeed) {
  Unit u;
  u.build();
  EXPECT_EQ(u.cycle(0, kM).status, Status::Normal);
  EXPECT_EQ(u.r.monitoring, Monitoring::CSM);
  EXPECT_EQ(u.cycle(0, kM + 0.01).status, Status::Overspeed);
  EXPECT_EQ(u.cycle(0, kW).status, Status::Overspeed);
  EXPECT_EQ(u.cycle(0, kW + 0.01).status, Status::Warning);
  EXPECT_FALSE(u.r.tco);  // only target speed monitoring commands TCO
  EXPECT_EQ(u.cycle(0, kSBI).status, Status::Warning);
  EXPECT_EQ(u.cycle(0, kSBI + 0.01).status, Status::Intervention);
  EXPECT_TRUE(u.r.sb);
  EXPECT_FALSE(u.r.eb);
  EXPECT_EQ(u.r.highest.condition, 4);
  u.cycle(0, kEBI + 0.01);
  EXPECT_TRUE(u.r.sb);
  EXPECT_TRUE(u.r.eb);
  EXPECT_EQ(u.r.highest.condition, 5);
  EXPECT_TRUE(u.r.show_SBI);
  EXPECT_NEAR(u.r.V_SBI.si, kSBI, 1e-12);
  EXPECT_NEAR(u.r.V_EBI.si, kEBI, 1e-12);
  EXPECT_NEAR(u.r.V_W.si, kW, 1e-12);
  EXPECT_NEAR(u.r.V_P.si, kM, 1e-12);
  // Below the SBI nothing is revoked yet; below the ceiling the service brake is.
  u.cycle(0, kM + 0.01);
  EXPECT_TRUE(u.r.sb && u.r.eb);
  u.cycle(0, kM);
  EXPECT_FALSE(u.r.sb);
  EXPECT_TRUE(u.r.eb);  // only at standstill
  EXPECT_EQ(u.r.status, Status::Intervention);
  u.cycle(0, 0.0);
  EXPECT_FALSE(u.r.eb);
  EXPECT_EQ(u.r.status, Status::Normal);
}

TEST(CSM, OverspeedAndWarningLastUntilTheCeiling) {
  Unit u;
  u.build();
  u.cycle(0, kW + 0.1);
  EXPECT_EQ(u.r.status, Status::Warning);
  EXPECT_EQ(u.cycle(0, kM + 0.1).status, Status::Warning);
  EXPECT_EQ(u.cycle(0, kM).status, Status::Normal);
}

TEST(CSM, EmergencyBrakeReleasedByNationalValue) {
  Unit u;
  u.in.national_values.Q_NVEMRRLS = true;
  u.build();
  u.cycle(0, kEBI + 0.1);
  EXPECT_TRUE(u.r.eb);
  u.cycle(0, kM);
  EXPECT_FALSE(u.r.eb);
  EXPECT_EQ(u.r.status, Status::Normal);
}

TEST(CSM, WithoutServiceBrakeInterfaceTheEmergencyBrakeTakesItsPlace) {
  Unit u;
  u.in.train.service_brake_interface = false;
  u.build();
  u.cycle(0, kSBI + 0.1);
  EXPECT_TRUE(u.r.eb);
  EXPECT_FALSE(u.r.sb);
  u.cycle(0, kM);  // revoked as the service brake would be
  EXPECT_FALSE(u.r.eb);
  // If the EBI is exceeded as well, its own rule applies.
  u.cycle(0, kEBI + 0.1);
  u.cycle(0, kM);
  EXPECT_TRUE(u.r.eb);
}

TEST(CSM, SeesTheLowestSpeedUnderTheConfidenceInterval) {
  Unit u;
  ASSERT_TRUE(u.in.mrsp.append({{1000.0}}, {20.0}));
  ASSERT_TRUE(u.in.mrsp.append({{1500.0}}, {30.0}));
  u.build();
  Motion m = at(995.0, 10.0);
  EXPECT_EQ(u.cycle(m).V_MRSP.si, 30.0);
  m.max_safe_front = {{1000.0}};
  EXPECT_EQ(u.cycle(m).V_MRSP.si, 20.0);
  m = at(1505.0, 10.0);
  m.min_safe_front = {{1499.0}};
  EXPECT_EQ(u.cycle(m).V_MRSP.si, 20.0);
  EXPECT_EQ(V_MRSP(Mrsp{}, {}, {}).si, 0.0);
}

TEST(TSM, ATrainThatDoesNotBrake) {
  // 30 m/s, no acceleration: EBD limits I 3830, P 4100, W 4160, SBI2 4220, EBI 4310 (SvL 5000); SBD
  // limits I 3857.5, P 4127.5, W 4187.5, SBI1 4247.5 (EOA 4900).
  Unit u = approaching_EOA();
  EXPECT_EQ(u.cycle(3700, kM).V_I, Speed{kM}) << "at most V_MRSP";
  EXPECT_EQ(u.cycle(3830, kM).monitoring, Monitoring::CSM);  // at the limit it is not passed
  EXPECT_NEAR(u.r.V_I->si, kM, 1e-9);
  EXPECT_EQ(u.cycle(3830.1, kM).monitoring, Monitoring::TSM);
  EXPECT_LT(u.r.V_I->si, kM);
  EXPECT_TRUE(u.r.monitoring_changed);
  EXPECT_EQ(u.r.status, Status::Indication);
  EXPECT_TRUE(u.r.MRDT_changed);
  EXPECT_EQ(*u.r.V_target, Speed{0.0});
  EXPECT_NEAR(u.r.d_target->si, 4900 - 3830.1, 1e-9);
  EXPECT_EQ(u.cycle(4100, kM).status, Status::Indication);
  EXPECT_FALSE(u.r.MRDT_changed);
  EXPECT_EQ(u.cycle(4100.1, kM).status, Status::Overspeed);
  EXPECT_EQ(u.r.highest.condition, 4);
  EXPECT_FALSE(u.r.tco);
  EXPECT_EQ(u.cycle(4160.1, kM).status, Status::Warning);
  EXPECT_TRUE(u.r.tco);
  EXPECT_FALSE(u.r.sb);
  EXPECT_EQ(u.cycle(4220.1, kM).status, Status::Intervention);
  EXPECT_TRUE(u.r.sb);
  EXPECT_FALSE(u.r.eb);
  u.cycle(4310.1, kM);
  EXPECT_TRUE(u.r.eb);
  EXPECT_EQ(u.r.highest.condition, 13);
  // Slower than P: service brake and traction cut-off are revoked, the emergency brake stays until
  // standstill.
  u.cycle(4320, 10.0);
  EXPECT_FALSE(u.r.tco || u.r.sb);
  EXPECT_TRUE(u.r.eb);
  EXPECT_EQ(u.r.status, Status::Intervention);
  u.cycle(4325, 0.0);
  EXPECT_FALSE(u.r.eb);
  EXPECT_EQ(u.r.status, Status::Indication);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
}

TEST(TSM, CommandsAreTakenBackBelowThePermittedSpeedOnly) {
  Unit u = approaching_EOA();
  u.cycle(4170, kM);
  EXPECT_TRUE(u.r.tco);
  // Find a speed between P and W at this place: W(V) is 2 s, P(V) 4 s in rear of the SBI.
  const auto limits = [&](double V) { return explain(*u.d, u.in, u.d->targets[0], {V}, {}, {}); };
  double V = kM;
  while (limits(V).d_W.from_origin.si < 4170.0) V -= 0.01;
  EXPECT_LT(limits(V).d_P.from_origin.si, 4170.0);
  u.cycle(4170, V);
  EXPECT_TRUE(u.r.tco);
  EXPECT_EQ(u.r.status, Status::Warning);
  while (limits(V).d_P.from_origin.si < 4170.0) V -= 0.01;
  u.cycle(4170, V);
  EXPECT_FALSE(u.r.tco);
  EXPECT_EQ(u.r.status, Status::Indication);
}

TEST(TSM, ServiceBrakeNotPermittedInTSM) {
  Unit u;
  u.in.national_values.Q_NVSBTSMPERM = false;
  set_EOA(u.in, 4900.0, 5000.0);
  u.build();
  // T_bs1 = T_bs2 = 0, T_traction = 8 s: SBI1 = 4337.5, SBI2 = EBI = 5000 - 450 - 240.
  u.cycle(4200, kM);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
  u.cycle(4310.1, kM);
  EXPECT_TRUE(u.r.eb);
  EXPECT_FALSE(u.r.sb);
  // In CSM only the interface counts: a service brake commanded there continues in TSM.
  Unit v;
  v.in.national_values.Q_NVSBTSMPERM = false;
  set_EOA(v.in, 4900.0, 5000.0);
  v.build();
  v.cycle(0, kSBI + 0.1);
  EXPECT_TRUE(v.r.sb);
  v.cycle(4000, kM + 0.1);
  EXPECT_EQ(v.r.monitoring, Monitoring::TSM);
  EXPECT_TRUE(v.r.sb);
}

TEST(TSM, WithoutTractionCutOffInterfaceNoneIsCommanded) {
  Unit u;
  u.in.train.traction_cut_off_interface = false;
  set_EOA(u.in, 4900.0, 5000.0);
  u.build();
  u.cycle(4200, kM);
  EXPECT_GE(u.r.status, Status::Warning);
  EXPECT_FALSE(u.r.tco);
}

TEST(TSM, AnMRSPTargetAndItsCeilings) {
  Unit u;
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
  u.build();
  const Explanation e = explain(*u.d, u.in, u.d->targets[0], {kM}, {}, {});
  u.cycle(e.d_I.from_origin.si + 0.1, kM);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(*u.r.V_target, Speed{20.0});
  EXPECT_NEAR(u.r.d_target->si, (u.d->targets[0].d_P_target - Place{{e.d_I.from_origin.si + 0.1}}).si, 1e-9);
  EXPECT_FALSE(u.r.V_release.has_value());
  // Above the ceiling while the curves still allow the speed: overspeed (t6), warning (t9), brakes (t12, t15).
  const double x = e.d_I.from_origin.si + 50;
  EXPECT_EQ(u.cycle(x, kM + 0.1).status, Status::Overspeed);
  EXPECT_EQ(u.r.highest.condition, 6);
  EXPECT_EQ(u.cycle(x, kW + 0.1).status, Status::Warning);
  EXPECT_EQ(u.r.highest.condition, 9);
  EXPECT_TRUE(u.r.tco);
  u.cycle(x, kSBI + 0.1);
  EXPECT_EQ(u.r.highest.condition, 12);
  EXPECT_TRUE(u.r.sb);
  u.cycle(x, kEBI + 0.1);
  EXPECT_EQ(u.r.highest.condition, 15);
  EXPECT_TRUE(u.r.eb);
  // At or below the target speed everything except the emergency brake is revoked.
  u.cycle(x, 20.0);
  EXPECT_FALSE(u.r.tco || u.r.sb);
  EXPECT_TRUE(u.r.eb);
  u.in.national_values.Q_NVEMRRLS = true;
  u.build();
  u.cycle(x, 20.0);
  EXPECT_FALSE(u.r.eb);
}

TEST(TSM, APassedTargetEndsIt) {
  Unit u;
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
  u.build();
  u.cycle(3900, 22.0);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(u.cycle(3999.9, 20.0).monitoring, Monitoring::TSM);
  EXPECT_EQ(u.cycle(4000.1, 20.0).monitoring, Monitoring::CSM);
  EXPECT_EQ(u.r.status, Status::Normal);
  EXPECT_EQ(u.r.V_MRSP.si, 20.0);
  EXPECT_FALSE(u.r.V_target.has_value());
}

TEST(TSM, ALongerAuthorityEndsItAndFreesTheTraction) {
  Unit u = approaching_EOA();
  u.cycle(4170, kM);
  EXPECT_TRUE(u.r.tco);
  set_EOA(u.in, 9000.0, 9000.0);
  u.build();
  u.cycle(4173, kM);
  EXPECT_EQ(u.r.monitoring, Monitoring::CSM);
  EXPECT_FALSE(u.r.tco);
  EXPECT_EQ(u.r.status, Status::Normal);
}

TEST(TSM, EndsWhenTheMRSPFallsToTheTargetSpeed) {
  Unit u;
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
  u.build();
  u.cycle(3500, 25.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  // A ceiling of 20 m/s everywhere (a mode, say): the list is the same, its target no longer below.
  u.in.mrsp.steps[0].value = {20.0};
  ++u.in.revision;
  u.in.mrsp = {};
  ASSERT_TRUE(u.in.mrsp.append({{-1000.0}}, {20.0}));
  u.build();
  EXPECT_EQ(u.cycle(3510, 19.0).monitoring, Monitoring::CSM);
}

TEST(RSM, FromItsStartToStandstill) {
  Unit u;
  set_EOA(u.in, 4900.0, 5000.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {5.0};
  u.build();
  // Start: SBI1 at 4869.375.
  u.cycle(4700, 6.0);
  EXPECT_EQ(u.r.monitoring, Monitoring::CSM);
  u.cycle(4850, 4.9);
  EXPECT_EQ(u.cycle(4869.3, 4.9).monitoring, Monitoring::CSM);
  EXPECT_EQ(u.cycle(4869.4, 4.9).monitoring, Monitoring::RSM);
  EXPECT_EQ(u.r.status, Status::Indication);
  EXPECT_EQ(*u.r.V_release, Speed{5.0});
  EXPECT_NEAR(u.r.d_target->si, 4900 - 4869.4, 1e-9);
  EXPECT_EQ(u.r.V_EBI.si, 5.0);
  EXPECT_LT(u.r.V_P.si, 5.0);
  u.cycle(4875, 5.01);
  EXPECT_TRUE(u.r.eb);
  EXPECT_EQ(u.r.status, Status::Intervention);
  EXPECT_EQ(u.r.highest.condition, 2);
  u.cycle(4876, 4.0);
  EXPECT_TRUE(u.r.eb);
  u.cycle(4877, 0.0);
  EXPECT_FALSE(u.r.eb);
  EXPECT_EQ(u.r.status, Status::Indication);
}

TEST(RSM, TheServiceBrakeGoesWhenItIsEntered) {
  Unit u;
  set_EOA(u.in, 4900.0, 5000.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {5.0};
  u.build();
  u.cycle(4800, 13.5);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  ASSERT_TRUE(u.r.sb);
  ASSERT_TRUE(u.r.tco);
  EXPECT_FALSE(u.r.eb);
  u.cycle(4870, 5.0);
  EXPECT_EQ(u.r.monitoring, Monitoring::RSM);
  EXPECT_FALSE(u.r.sb || u.r.tco || u.r.eb);
  EXPECT_EQ(u.r.status, Status::Intervention);  // by the table: until standstill
  // A new authority without release speed: the same end is supervised by its curves.
  u.in.authority.release_speed = ReleaseSpeedChoice::none;
  u.build();
  EXPECT_EQ(u.cycle(4871, 1.0).monitoring, Monitoring::TSM);
  set_EOA(u.in, 9900.0, 9900.0);
  u.build();
  EXPECT_EQ(u.cycle(4872, 1.0).monitoring, Monitoring::CSM);
}

TEST(RSM, FirstMonitoringOfAnActivation) {
  Unit u;
  set_EOA(u.in, 4900.0, 5000.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {5.0};
  u.build();
  EXPECT_EQ(u.cycle(4880, 0.0).monitoring, Monitoring::RSM);
  EXPECT_EQ(u.r.status, Status::Indication);
  u.s = {};
  EXPECT_EQ(u.cycle(4500, 20.0).monitoring, Monitoring::TSM);
  u.s = {};
  EXPECT_EQ(u.cycle(0, 20.0).monitoring, Monitoring::CSM);
}

TEST(ReleaseSpeedInTSM, BelowItNothingIsTriggered) {
  Unit u;
  set_EOA(u.in, 4900.0, 5000.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {5.0};
  u.build();
  u.cycle(4500, 20.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  // Not yet in RSM, beyond P for this speed but not above the release speed.
  u.cycle(4865, 5.0);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(u.r.status, Status::Indication);
  EXPECT_FALSE(u.r.tco || u.r.sb || u.r.eb);
  EXPECT_EQ(*u.r.V_release, Speed{5.0});
  // 4.0.0 has t0-t2 for exactly the release speed.
  Unit v(SrsVersion::v4_0_0);
  v.in.authority = u.in.authority;
  v.build();
  v.cycle(4500, 20.0);
  v.cycle(4865, 5.0);
  EXPECT_EQ(v.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(v.r.status, Status::Warning);
  EXPECT_EQ(v.r.highest.condition, 2);
  // r1 holds there too, and does not end the status: neither Warning nor, in rear of W, Overspeed.
  for (int n = 0; n < 2; ++n) {
    v.cycle(4865, 5.0);
    EXPECT_EQ(v.r.status, Status::Warning);
    EXPECT_TRUE(v.r.tco);
  }
  Unit w(SrsVersion::v4_0_0);
  w.in.authority = u.in.authority;
  w.build();
  w.cycle(4500, 20.0);
  double x = 4500.0;
  while (x < 4870.0 && w.cycle(x, 5.0).highest.condition != 1) x += 1.0;
  ASSERT_EQ(w.r.highest.condition, 1);
  EXPECT_EQ(w.r.status, Status::Overspeed);
  for (int n = 0; n < 2; ++n) EXPECT_EQ(w.cycle(x, 5.0).status, Status::Overspeed);
}

/// t0, t1 and t2 of 4.0.0, one after the other, at a very low release speed.
TEST(ReleaseSpeedInTSM, At400EveryReleaseSpeedCounts) {
  Unit u(SrsVersion::v4_0_0);
  set_EOA(u.in, 4900.0, 5000.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {0.5};
  u.build();
  u.cycle(4500, 20.0);
  std::string conditions;
  for (double x = 4880.0; u.cycle(x, 0.5).monitoring == Monitoring::TSM; x += 0.125) {
    const char condition = static_cast<char>('0' + u.r.highest.condition);
    if (u.r.status >= Status::Indication && (conditions.empty() || conditions.back() != condition))
      conditions += condition;
  }
  EXPECT_EQ(u.r.monitoring, Monitoring::RSM);
  EXPECT_EQ(conditions, "012");
}

/// 3.13.10.3.8, Table 16 [1]: only targets between trip location and SvL are left out below the release speed.
TEST(ReleaseSpeedInTSM, ATargetBeyondTheSvLCountsBelowIt) {
  for (const SrsVersion srs : {SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    for (const double place : {4920.0, 4925.0}) {
      Unit u(srs);
      set_EOA(u.in, 4900.0, 4920.0);
      u.in.authority.release_speed = ReleaseSpeedChoice::value;
      u.in.authority.V_release = {5.0};
      u.in.authority.reference = u.in.authority.EOA;
      ASSERT_TRUE(u.in.mrsp.append({{place}}, {1.0}));
      u.build();
      const ReleaseSpeed& r = u.d->release_speed;
      ASSERT_EQ(r.V_release, Speed{5.0});
      const Motion m = at(4500, 4.9);
      u.cycle(m);
      ASSERT_EQ(u.r.monitoring, Monitoring::CSM);
      TimesAsked q;
      if (srs == SrsVersion::v4_0_0) q.reduced_from = Fronts{m.est_front, m.min_safe_front};
      const Limits l = limits_of(*u.d, u.d->targets[0], approach({4.9}, {}, {}, u.d->fixed), q).EBD;
      const Distance to_start = std::min(r.d_SBI1 - m.est_front, r.d_SBI2 - m.max_safe_front);
      ASSERT_LT(l.d_I - m.max_safe_front, to_start);
      EXPECT_EQ(*u.r.first_indication, place > 4920.0 ? l.d_I - m.max_safe_front : to_start);
    }
  }
}

TEST(TSM340, NormalStatusBetweenPreIndicationAndIndication) {
  // Pre-indication 3740 (EBD), 3767.5 (SBD); Indication 3950, 3977.5; P 4100.
  Unit u = approaching_EOA(SrsVersion::v3_4_0);
  EXPECT_EQ(u.cycle(3740, kM).monitoring, Monitoring::CSM);
  EXPECT_EQ(u.cycle(3741, kM).monitoring, Monitoring::TSM);
  EXPECT_EQ(u.r.status, Status::Normal);
  EXPECT_EQ(u.cycle(3951, kM).status, Status::Indication);
  // Slower, in rear of I: Indication stays while the displayed target stays (r2).
  EXPECT_EQ(u.cycle(3952, 10.0).status, Status::Indication);
  EXPECT_EQ(u.cycle(4101, kM).status, Status::Overspeed);
  // From Overspeed r2 leads to Normal.
  EXPECT_EQ(u.cycle(4102, 10.0).status, Status::Normal);
  // Ceiling before the Indication limit at the MRSP speed: t5, t8, t11, t14.
  Unit v = approaching_EOA(SrsVersion::v3_4_0);
  v.cycle(3745, kM);
  EXPECT_EQ(v.cycle(3745, kM + 0.1).highest.condition, 5);
  EXPECT_EQ(v.cycle(3745, kW + 0.1).highest.condition, 8);
  EXPECT_TRUE(v.r.tco);
  EXPECT_EQ(v.cycle(3745, kSBI + 0.1).highest.condition, 11);
  EXPECT_EQ(v.cycle(3745, kEBI + 0.1).highest.condition, 14);
  EXPECT_EQ(v.cycle(3960, kEBI + 0.1).highest.condition, 15);
  // The list changes and no target is near: ceiling speed monitoring.
  set_EOA(v.in, 9000.0, 9000.0);
  v.build();
  EXPECT_EQ(v.cycle(3961, kM).monitoring, Monitoring::CSM);
}

TEST(TSM340, IndicationEndsAtTheTargetSpeed) {
  Unit u(SrsVersion::v3_4_0);
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
  u.build();
  u.cycle(3500, 29.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  ASSERT_GE(u.r.status, Status::Indication);
  EXPECT_EQ(u.cycle(3600, 20.0).status, Status::Normal);  // r1
}

TEST(TSM340, IndicationStatusEndsByR1WhateverIsDisplayed) {
  Unit u(SrsVersion::v3_4_0);
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
  u.build();
  const Explanation e = explain(*u.d, u.in, u.d->targets[0], {25.0}, {}, {});
  const double x = 0.5 * (e.EBD.d_I.from_origin.si + e.EBD.d_P.from_origin.si);
  u.cycle(x, 25.0);
  ASSERT_EQ(u.cycle(x + 1.0, 25.0).status, Status::Indication);
  EXPECT_EQ(u.cycle(x + 2.0, 20.0).status, Status::Normal);
  EXPECT_FALSE(u.r.MRDT_changed);
}

TEST(TSM, TheSameTargetIsNewAgainAfterCeilingSpeedMonitoring) {
  for (const SrsVersion srs : {SrsVersion::v3_4_0, SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Unit u = approaching_EOA(srs);
    u.cycle(4000, kM);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    set_EOA(u.in, 9000.0, 9000.0);
    u.build();
    u.cycle(4001, kM);
    ASSERT_EQ(u.r.monitoring, Monitoring::CSM);
    EXPECT_FALSE(u.s.has_MRDT);
    set_EOA(u.in, 4900.0, 5000.0);
    u.build();
    u.cycle(4002, kM);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    EXPECT_TRUE(u.r.MRDT_changed);
  }
}

TEST(TSM340, ReleaseSpeedMonitoringAtItsStart) {
  Unit u(SrsVersion::v3_4_0);
  set_EOA(u.in, 4900.0, 5000.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {5.0};
  u.build();
  u.cycle(4800, 5.0);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(u.cycle(4870, 4.0).monitoring, Monitoring::RSM);
}

TEST(LOA, ASpeedNotAStop) {
  Unit u;
  u.in.authority.kind = Authority::Kind::LOA;
  u.in.authority.EOA = {{4000.0}};
  u.in.authority.V_LOA = {20.0};
  u.build();
  u.cycle(3700, 26.0);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(u.r.MRDT->kind, TargetKind::LOA);
  EXPECT_EQ(*u.r.V_target, Speed{20.0});
  // Beyond the LOA its speed is a ceiling.
  EXPECT_EQ(u.cycle(3999.9, 19.0).V_MRSP.si, 30.0);
  EXPECT_EQ(u.cycle(4000, 19.0).V_MRSP.si, 20.0);
  EXPECT_EQ(u.cycle(4001, 19.0).V_MRSP.si, 20.0);
  EXPECT_EQ(u.cycle(4001, 20.0 + 7.6 / 3.6).eb, true);
}

TEST(SR, EndOfTheDistance) {
  Unit u;
  u.in.supervise_targets = true;
  u.in.SR_end = Place{{5000.0}};
  u.build();
  // EBD only: P 4100, EBI 4310.
  u.cycle(4000, kM);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(u.cycle(4101, kM).status, Status::Overspeed);
  EXPECT_TRUE(u.cycle(4311, kM).eb);
  EXPECT_EQ(u.r.MRDT->kind, TargetKind::SR_end);
  EXPECT_NEAR(u.r.d_target->si, 5000 - 4311, 1e-9);  // d_P(0) = d_EBD(0)
}

TEST(Display, PermittedSpeedFollowsTheLowestTarget) {
  Unit u = approaching_EOA();
  u.cycle(4200, 25.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  // x = 4200 + 25 * 7 + 25 * 8 (EBD), 4200 + 25 * 7 (SBD).
  const double P_EBD = std::sqrt(2 * (5000 - 4575.0));
  const double P_SBD = std::sqrt(1.6 * (4900 - 4375.0));
  EXPECT_NEAR(u.r.V_P.si, std::min({P_EBD, P_SBD, kM}), 1e-9);
  u.cycle(4400, 10.0);
  EXPECT_NEAR(u.r.V_P.si, std::min(std::sqrt(2 * (5000 - 4550.0)), std::sqrt(1.6 * (4900 - 4470.0))), 1e-9);
  EXPECT_LT(u.r.V_P, u.r.V_W);
  EXPECT_LT(u.r.V_W, u.r.V_SBI);
}

TEST(Display, TheReleaseSpeedIsAFloorForEOAAndSvLOnly) {
  Unit u;
  set_EOA(u.in, 4900.0, 5000.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {8.0};
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {3.0}));
  ASSERT_TRUE(u.in.mrsp.append({{4100.0}}, {20.0}));
  u.build();
  u.cycle(3950, 7.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_LT(u.r.V_SBI.si, 8.0);
  EXPECT_LT(u.r.V_EBI.si, 9.0);
}

TEST(Display, NothingIsNearInCSM) {
  Unit u = approaching_EOA();
  u.cycle(0, 25.0);
  EXPECT_EQ(u.r.V_P.si, kM);
  EXPECT_FALSE(u.r.V_target.has_value());
  // The first Indication location is output for any A_NVMAXREDADH.
  const Explanation e = explain(*u.d, u.in, u.d->targets[0], {25.0}, {}, {});
  ASSERT_TRUE(u.r.first_indication.has_value());
  EXPECT_NEAR(u.r.first_indication->si, e.d_I.from_origin.si, 1e-9);
  EXPECT_FALSE(u.r.TTI.has_value());
}

TEST(Display, TimeToIndicationWhenAskedFor) {
  using Display = train::MaxReducedAdhesion::Display;
  Unit u;
  set_EOA(u.in, 4900.0, 5000.0);
  u.in.national_values.A_NVMAXREDADH2 = train::MaxReducedAdhesion::without_maximum(Display::time_to_indication);
  u.build();
  u.cycle(3830 - 30 * 15.0, kM);
  EXPECT_FALSE(u.r.TTI.has_value());  // 15 s
  u.cycle(3830 - 30 * 13.0, kM);
  ASSERT_TRUE(u.r.TTI.has_value());
  EXPECT_NEAR(u.r.TTI->si, 13.0, 1e-9);
  EXPECT_FALSE(u.r.V_target.has_value());
  u.in.national_values.A_NVMAXREDADH2 = train::MaxReducedAdhesion::without_maximum(Display::target_information);
  u.build();
  u.cycle(3500, kM);
  EXPECT_EQ(u.r.monitoring, Monitoring::CSM);
  EXPECT_EQ(*u.r.V_target, Speed{0.0});
  EXPECT_FALSE(u.r.TTI.has_value());
  // 3.4.0 has none of this.
  Unit v = approaching_EOA(SrsVersion::v3_4_0);
  EXPECT_FALSE(v.cycle(3000, kM).first_indication.has_value());
}

TEST(Display, FirstIndicationBelowTheReleaseSpeed) {
  Unit u;
  set_EOA(u.in, 4900.0, 5000.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {5.0};
  u.build();
  u.cycle(1000, 4.0);
  // To the start of release speed monitoring.
  EXPECT_NEAR(u.r.first_indication->si, 4869.375 - 1000, 1e-9);
  u.cycle(1000, 5.0);
  const Explanation e = explain(*u.d, u.in, u.d->targets[0], {5.0}, {}, {});
  EXPECT_NEAR(u.r.first_indication->si, e.d_I.from_origin.si - 1000, 1e-9);
}

TEST(MRDT, AMaskedTargetIsShown) {
  // Two restrictions close to each other: the first one's P is the lowest, but the second one's
  // Indication limit at the first one's speed is before the first one's P.
  Unit u;
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
  ASSERT_TRUE(u.in.mrsp.append({{4150.0}}, {10.0}));
  u.build();
  u.cycle(3500, 28.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(u.r.V_target->si, 10.0);
  // Far apart: the first one.
  Unit v;
  ASSERT_TRUE(v.in.mrsp.append({{4000.0}}, {20.0}));
  ASSERT_TRUE(v.in.mrsp.append({{7000.0}}, {10.0}));
  v.build();
  v.cycle(3500, 28.0);
  EXPECT_EQ(v.r.V_target->si, 20.0);
}

TEST(MRDT, MaskingCountsFromTheFixedPermittedSpeedLocation) {
  // 3.13.9.3.5.9: d_P(V_target) has no acceleration and fully reduced build-up times, d_I has the train's acceleration.
  // 72 km/h at 4000 m: d_EBD(20) = 4000 + (22.0833^2 - 20^2) / 2 = 4043.837; T_traction_max = 10 - (2 + 1) = 7 s,
  // T_berem_min = 0: d_P(20) = 4043.837 - 20 * 7 - 20 * (4 + 1) = 3803.837.
  // 36 km/h at x, A_est 0.4, V 20: nothing is reduced, T_traction 5, T_berem 3, V_bec 23.2, D_bec = 21 * 5 + 22.6 * 3,
  // d_I = x - (23.2^2 - 12.0833^2) / 2 - 172.8 - 20 * (3 + 4 + 9) = x - 688.916: masked up to x = 4492.75.
  for (const double x : {4450.0, 4492.7, 4492.8}) {
    Unit u(SrsVersion::v4_0_0);
    ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
    ASSERT_TRUE(u.in.mrsp.append({{x}}, {10.0}));
    u.build();
    EXPECT_NEAR(u.d->targets[0].d_P_target.from_origin.si, 3803.837, 1e-3);
    Motion m = at(3420, 28.0);
    m.A_est = {0.4};
    u.cycle(m);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    EXPECT_EQ(u.r.V_target->si, x < 4492.75 ? 10.0 : 20.0) << x;
  }
}

/// 3.13.10.4.2: masked if d_I < d_P, not if they are exactly equal.
TEST(MRDT, ATargetWhoseIndicationLimitLiesOnThePermittedOneIsNotMasked) {
  Unit u;
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {4.0}));
  set_EOA(u.in, 4200.0, 4300.0);
  u.build();
  const auto gap = [&] {
    const TargetLimits l = limits_of(*u.d, u.d->targets[1], approach({4.0}, {}, {}, u.d->fixed), {});
    return u.d->targets[0].d_P_target - std::min(l.EBD.d_I, l.SBD->d_I);
  };
  for (const double masked_by : {0.0, 0.25}) {
    for (int n = 0; n < 4; ++n) {
      u.in.authority.EOA = u.in.authority.EOA + (gap() - Distance{masked_by});
      u.in.authority.SvL = u.in.authority.EOA + Distance{100.0};
      u.build();
    }
    ASSERT_EQ(gap().si, masked_by);
    // At 5 m/s just beyond both Indication limits; the Permitted speed of the restriction is the lower one.
    const TargetLimits l = limits_of(*u.d, u.d->targets[1], approach({5.0}, {}, {}, u.d->fixed), {});
    u.s = {};
    u.cycle((std::min(l.EBD.d_I, l.SBD->d_I) + Distance{0.5}).from_origin.si, 5.0);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    EXPECT_EQ(*u.r.V_target, Speed{masked_by > 0.0 ? 0.0 : 4.0});
  }
}

TEST(MRDT, NoneWhereTheOldOneIsPassedAndNoOtherOneIsConcerned) {
  // The restriction to 2 m/s is passed; below the release speed of 10 m/s the one to 4 m/s keeps target speed
  // monitoring active, but it is not below V_MRSP.
  Unit u;
  ASSERT_TRUE(u.in.mrsp.append({{4500.0}}, {2.0}));
  ASSERT_TRUE(u.in.mrsp.append({{4510.0}}, {30.0}));
  ASSERT_TRUE(u.in.mrsp.append({{4560.0}}, {4.0}));
  ASSERT_TRUE(u.in.mrsp.append({{4570.0}}, {30.0}));
  set_EOA(u.in, 9000.0, 9000.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {10.0};
  u.in.authority.reference = u.in.authority.EOA;
  u.build();
  u.cycle(4499, 5.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  ASSERT_TRUE(u.s.has_MRDT);
  const TargetId first = u.s.MRDT;
  EXPECT_EQ(first.V_target, Speed{2.0});
  u.cycle(4501, 5.0);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_FALSE(u.s.has_MRDT);
  EXPECT_FALSE(u.r.MRDT.has_value());
  // Relocated in rear of it: it is displayed again.
  u.cycle(4499, 5.0);
  EXPECT_EQ(u.r.MRDT, first);
  EXPECT_TRUE(u.r.MRDT_changed);
}

TEST(MRDT, StaysUntilALowerOneIsSelected) {
  Unit u;
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
  u.build();
  u.cycle(3500, 28.0);
  ASSERT_EQ(u.r.V_target->si, 20.0);
  // Slower than the target: no longer among the concerned targets, but it stays the MRDT.
  u.cycle(3550, 19.0);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(u.r.V_target->si, 20.0);
  EXPECT_FALSE(u.r.MRDT_changed);
  // A stop before it replaces it.
  set_EOA(u.in, 3900.0, 3900.0);
  u.build();
  u.cycle(3551, 19.0);
  EXPECT_EQ(u.r.V_target->si, 0.0);
  EXPECT_TRUE(u.r.MRDT_changed);
}

TEST(MRDT, ALowerTargetStaysWhenAHigherOneIsSelectedLater) {
  // Fast, both Indication limits are exceeded and the second restriction is masked by the first one;
  // slower, only the first one's is.
  Unit u;
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
  ASSERT_TRUE(u.in.mrsp.append({{4330.0}}, {10.0}));
  u.build();
  u.cycle(3640, 26.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  ASSERT_EQ(u.r.V_target->si, 10.0);
  u.cycle(3660, 20.5);
  EXPECT_EQ(u.r.V_target->si, 10.0);
  EXPECT_FALSE(u.r.MRDT_changed);
  u.s = {};
  u.cycle(3660, 20.5);
  EXPECT_EQ(u.r.V_target->si, 20.0);  // a unit without the state
}

TEST(MRDT, In340TheTargetWithTheLowestPermittedSpeed) {
  Unit u(SrsVersion::v3_4_0);
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {10.0}));
  ASSERT_TRUE(u.in.mrsp.append({{4001.0}}, {30.0}));
  ASSERT_TRUE(u.in.mrsp.append({{4200.0}}, {20.0}));
  u.build();
  u.cycle(3600, 25.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(u.r.V_target->si, 10.0);
  EXPECT_NEAR(u.r.V_P.si, u.d->view(u.d->targets[0].EBD).speed_at({{3600 + 25.0 * 7 + 25.0 * 8}}).si, 1e-9);
}

TEST(TSM, AtStandstillBeyondTheEndNothingIsCommanded) {
  for (const SrsVersion srs : {SrsVersion::v3_4_0, SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Unit u = approaching_EOA(srs);
    u.cycle(4895, 1.0);
    u.cycle(4905, 0.0);
    u.cycle(4905, 0.0);
    EXPECT_FALSE(u.r.tco || u.r.sb || u.r.eb);
    EXPECT_LE(u.r.status, Status::Indication);
  }
}

TEST(MARequest, BeforeThePerturbationLocation) {
  Unit u = approaching_EOA();
  Motion m = at(0, kM);
  EXPECT_FALSE(u.cycle(m).MA_request);  // no parameters from the RBC
  m.T_MAR = Duration{10.0};
  EXPECT_FALSE(u.cycle(m).MA_request);
  // 3830 - (30 + 4/3.6) * 10.
  m = at(3830 - 311.2, kM);
  m.T_MAR = Duration{10.0};
  EXPECT_FALSE(u.cycle(m).MA_request);
  m = at(3830 - 311.0, kM);
  m.T_MAR = Duration{10.0};
  EXPECT_TRUE(u.cycle(m).MA_request);
  Unit none;
  none.build();
  EXPECT_FALSE(none.cycle(m).MA_request);
  // A weak service brake: the estimated front end passes the one of the EOA first.
  Unit weak;
  weak.in.train.service[0].A_brake_service.steps[0].value = {0.4};
  set_EOA(weak.in, 4900.0, 5000.0);
  weak.build();
  m = at(weak.d->perturbation.from_SBD->from_origin.si - 311.0, kM);
  ASSERT_LT(*weak.d->perturbation.from_SBD, *weak.d->perturbation.from_EBD);
  m.T_MAR = Duration{10.0};
  EXPECT_TRUE(weak.cycle(m).MA_request);
  set_EOA(u.in, -960.0, -850.0);
  u.build();
  m = at(-990, 1.0);
  m.T_MAR = Duration{10.0};
  EXPECT_TRUE(u.cycle(m).MA_request);
  Unit loa;
  loa.in.authority.kind = Authority::Kind::LOA;
  loa.in.authority.EOA = {{5000.0}};
  loa.in.authority.V_LOA = {20.0};
  loa.build();
  m = at(100, kM);
  m.T_MAR = Duration{10.0};
  EXPECT_FALSE(loa.cycle(m).MA_request);
  m = at(4999, 20.0);
  m.T_MAR = Duration{10.0};
  EXPECT_TRUE(loa.cycle(m).MA_request);
}

TEST(Memo, SixStatuses) {
  Unit u = approaching_EOA();
  const auto status = [&](double x, double V) {
    u.s = {};
    u.cycle(x, V);
    return memo_status(u.r, {V}, false);
  };
  EXPECT_EQ(status(0, kM), MemoStatus::Null);  // the equality belongs to Null
  EXPECT_EQ(status(0, kM + 0.1), MemoStatus::P);
  EXPECT_EQ(status(4101, kM), MemoStatus::P);
  EXPECT_EQ(status(4161, kM), MemoStatus::W);
  EXPECT_EQ(status(4221, kM), MemoStatus::SB);
  EXPECT_EQ(status(4311, kM), MemoStatus::EB);
  EXPECT_EQ(memo_status(u.r, {kM}, true), MemoStatus::Trip);
  // Each limit belongs to the status below it.
  Result r;
  r.V_P = {20.0};
  r.V_W = {21.0};
  r.V_SBI = {22.0};
  r.V_EBI = {23.0};
  EXPECT_EQ(memo_status(r, {20.0}, false), MemoStatus::Null);
  EXPECT_EQ(memo_status(r, {21.0}, false), MemoStatus::P);
  EXPECT_EQ(memo_status(r, {22.0}, false), MemoStatus::W);
  EXPECT_EQ(memo_status(r, {23.0}, false), MemoStatus::SB);
  EXPECT_EQ(memo_status(r, {23.1}, false), MemoStatus::EB);
  // A status that continues counts like a speed above its limit.
  r.status = Status::Overspeed;
  EXPECT_EQ(memo_status(r, {10.0}, false), MemoStatus::P);
  r.status = Status::Warning;
  EXPECT_EQ(memo_status(r, {10.0}, false), MemoStatus::W);
  r.sb = true;
  EXPECT_EQ(memo_status(r, {10.0}, false), MemoStatus::SB);
  r.eb = true;
  EXPECT_EQ(memo_status(r, {10.0}, false), MemoStatus::EB);
}

// ---- Service brake feedback, A.3.10 ----------------------------------------------------------------

TEST(Supervision, BeginsWithNothing) {
  const Supervision s;
  EXPECT_FALSE(s.active);
  EXPECT_EQ(s.monitoring, Monitoring::CSM);
  EXPECT_EQ(s.status, Status::Normal);
  EXPECT_FALSE(s.tco || s.sb || s.eb || s.eb_for_sb);
  EXPECT_EQ(s.list_revision, 0u);
  EXPECT_EQ(s.list_passed, 0u);
  EXPECT_FALSE(s.has_MRDT);
  EXPECT_FALSE(s.hold_P || s.hold_SBI || s.hold_target_distance);
  EXPECT_FALSE(s.feedback.p0_known || s.feedback.started || s.feedback.locked || s.feedback.approaching);
}

TEST(Feedback, FirstStablePressureAndItsDrift) {
  FeedbackState s;
  follow_pressure(s, 300.0, {0.0});  // too low at first
  follow_pressure(s, 480.0, {1.0});
  follow_pressure(s, 510.0, {2.0});  // changed by more than 20 kPa: starts again
  follow_pressure(s, 500.0, {3.0});
  EXPECT_FALSE(s.p0_known);
  follow_pressure(s, 505.0, {5.0});
  ASSERT_TRUE(s.p0_known);
  EXPECT_EQ(s.p0, 505.0);
  follow_pressure(s, 520.0, {6.0});
  EXPECT_EQ(s.p0, 506.5);
  follow_pressure(s, 490.0, {7.5});
  EXPECT_EQ(s.p0, 506.0);
  follow_pressure(s, 400.0, {8.5});  // braking: unchanged
  EXPECT_EQ(s.p0, 506.0);
  follow_pressure(s, 700.0, {60.0});
  EXPECT_EQ(s.p0, 550.0);
  FeedbackState none;
  follow_pressure(none, std::nullopt, {0.0});
  EXPECT_FALSE(none.searching);
}

TEST(Feedback, AGapOfAnyLengthIsOneCycle) {
  FeedbackState s;
  s.p0_known = true;
  s.p0 = 400.0;
  s.last = {5.0};
  follow_pressure(s, 549.0, {1e12});
  EXPECT_EQ(s.p0, 549.0) << "100 steps of 1.5 kPa up, 2 of 0.5 kPa down";
  EXPECT_NEAR(s.last.si, 1e12, 1.0);
  follow_pressure(s, 520.0, {1e12 + 250.0});
  EXPECT_EQ(s.p0, 520.0) << "58 steps down";
}

TEST(Feedback, TimesShrinkWithThePressureAndLock) {
  const train::FixedValues f;
  FeedbackState s;
  s.p0_known = true;
  s.p0 = 500.0;
  FeedbackTimes t = feedback_times(s, 480.0, {6.0}, f);
  EXPECT_EQ(t.T_bs1.si, 6.0);
  t = feedback_times(s, 470.0, {6.0}, f);  // p1: 6 * (470 - 350) / 150
  EXPECT_NEAR(t.T_bs1.si, 4.8, 1e-12);
  EXPECT_NEAR(t.T_bs2.si, 4.8, 1e-12);
  t = feedback_times(s, 490.0, {6.0}, f);  // started: it continues above p1
  EXPECT_NEAR(t.T_bs1.si, 5.6, 1e-12);
  t = feedback_times(s, 445.0, {6.0}, f);
  EXPECT_NEAR(t.T_bs1.si, 6.0 * 95 / 150, 1e-12);
  t = feedback_times(s, 440.0, {6.0}, f);  // p2: locked
  EXPECT_EQ(t.T_bs1.si, 0.0);
  EXPECT_EQ(t.T_bs2.si, 2.0);
  EXPECT_EQ(feedback_times(s, 500.0, {6.0}, f).T_bs1.si, 0.0);
  reset_feedback(s, {6.0});
  EXPECT_EQ(feedback_times(s, 500.0, {6.0}, f).T_bs1.si, 6.0);
  // T_bs2 is never below 2 s, nor is it without a pressure.
  EXPECT_EQ(feedback_times(s, 500.0, {1.0}, f).T_bs2.si, 2.0);
  EXPECT_EQ(feedback_times(s, std::nullopt, {6.0}, f).T_bs1.si, 6.0);
}

Unit with_feedback(SrsVersion srs) {
  Unit u(srs);
  u.in.national_values.Q_NVSBFBPERM = true;
  u.in.train.service_brake_feedback = true;
  set_EOA(u.in, 4900.0, 5000.0);
  u.build();
  return u;
}

/// A.3.10 for a pressure that is given: T_bs falls with it, and with it the distance of the service brake intervention.
TEST(Feedback, OfAnAssumedPressureTheLimitsAreNearer) {
  for (const SrsVersion srs : {SrsVersion::v3_4_0, SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Unit u = with_feedback(srs);
    const Target& target = u.d->targets[0];
    const auto limits = [&](const Assumed& assumed) {
      return explain(*u.d, u.in, target, Speed{25.0}, Speed{0.0}, Acceleration{0.0}, nullptr, assumed).d_W;
    };
    const Assumed released{false, BrakePressure{}};
    const Assumed braking{false, BrakePressure{500.0, 470.0, true, false}};
    const Assumed locked{false, BrakePressure{500.0, 350.0, true, true}};
    EXPECT_FALSE(assumed_feedback(*u.d, target, {}).has_value());
    EXPECT_EQ(limits(released), limits({}));
    EXPECT_GT(limits(braking), limits(released));
    EXPECT_GT(limits(locked), limits(braking));
    EXPECT_EQ(assumed_feedback(*u.d, target, locked)->T_bs1, Duration{0.0});
    u.in.train.service_brake_feedback = false;
    u.build();
    EXPECT_FALSE(assumed_feedback(*u.d, u.d->targets[0], locked).has_value());
  }
}

TEST(Feedback, MovesTheLimitsButNotTheShownSpeedUp) {
  for (const SrsVersion srs : {SrsVersion::v3_4_0, SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Unit u = with_feedback(srs);
    const auto cycle = [&](double x, double V, double p, double now) {
      Motion m = at(x, V);
      m.brake_pressure_kpa = p;
      m.now = {now};
      return u.cycle(m);
    };
    cycle(0, 25.0, 500.0, 0.0);
    cycle(100, 25.0, 500.0, 4.0);
    ASSERT_TRUE(u.s.feedback.p0_known);
    cycle(4190, 25.0, 500.0, 5.0);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    const Speed before = u.r.V_P;
    EXPECT_FALSE(u.s.feedback.started);
    // The driver brakes: T_bs1 and T_bs2 fall to 0 and 2 s; the displayed Permitted speed does not rise.
    cycle(4192, 24.9, 460.0, 5.1);
    cycle(4194, 24.8, 430.0, 5.2);
    EXPECT_TRUE(u.s.feedback.locked);
    EXPECT_LE(u.r.V_P, before);
    const Speed held = u.r.V_P;
    cycle(4196, 24.7, 430.0, 5.3);
    EXPECT_LE(u.r.V_P, held);
    // Leaving target speed monitoring resets the feedback.
    set_EOA(u.in, 9900.0, 9900.0);
    u.build();
    cycle(4200, 20.0, 430.0, 5.4);
    cycle(4202, 20.0, 430.0, 5.5);
    EXPECT_EQ(u.r.monitoring, Monitoring::CSM);
    EXPECT_FALSE(u.s.feedback.locked);
  }
}

/// A.3.10.4: the driver brakes already when target speed monitoring is entered. Nothing was shown of the target before,
/// so nothing can stay: the values shown are those with the feedback, and they fall as the train runs on.
TEST(Feedback, OnEntryTheFirstValuesShownAreThoseWithTheFeedback) {
  for (const SrsVersion srs : {SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Unit u = with_feedback(srs);
    u.in.authority = {};
    u.in.mrsp = {};
    ASSERT_TRUE(u.in.mrsp.append({{-1000.0}}, {40.0}));
    ASSERT_TRUE(u.in.mrsp.append({{5000.0}}, {15.0}));
    u.build();
    u.s.feedback.p0_known = true;
    u.s.feedback.p0 = 500.0;
    const auto cycle = [&](double x) {
      Motion m = at(x, 30.0);
      m.brake_pressure_kpa = 430.0;
      return u.cycle(m);
    };
    double x = 1000.0;
    for (; u.r.monitoring != Monitoring::TSM && x < 5000.0; x += 1.0) cycle(x);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM) << "at " << x;
    ASSERT_TRUE(u.r.d_target.has_value());
    EXPECT_TRUE(u.s.feedback.locked);
    const double first = u.r.d_target->si;
    const Speed P = u.r.V_P;
    cycle(x);
    EXPECT_NEAR(u.r.d_target->si, first - 1.0, 1e-9) << "a value of T_bs was held";
    EXPECT_LE(u.r.V_P, P);
    cycle(x + 9.0);
    EXPECT_NEAR(u.r.d_target->si, first - 10.0, 1e-9);
  }
}

TEST(Feedback, HeldValuesAreFreeAgainOnceTheyFall) {
  for (const SrsVersion srs : {SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Unit u = with_feedback(srs);
    u.s.feedback.p0_known = true;
    u.s.feedback.p0 = 500.0;
    const auto cycle = [&](double x, double p) {
      Motion m = at(x, 25.0);
      m.brake_pressure_kpa = p;
      u.cycle(m);
    };
    cycle(4350, 500.0);
    cycle(4350, 500.0);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    const Speed P = u.r.V_P;
    const Speed SBI = u.r.V_SBI;
    cycle(4350, 430.0);  // T_bs1 = 0: both would rise
    ASSERT_TRUE(u.s.feedback.locked);
    EXPECT_EQ(u.r.V_P, P);
    if (srs == SrsVersion::v4_0_0) {
      EXPECT_EQ(u.r.V_SBI, SBI);
    } else {
      EXPECT_GT(u.r.V_SBI, SBI);
    }
    cycle(4400, 430.0);
    EXPECT_LT(u.r.V_P, P);
    cycle(4350, 430.0);  // relocated; no time gets shorter now
    EXPECT_GT(u.r.V_P, P);
    EXPECT_GT(u.r.V_SBI, SBI);
  }
}

TEST(Feedback, MovesTheStartOfReleaseSpeedMonitoring) {
  // SBI1 at the release speed of 5 m/s: 4869.375 with T_bs1 = 3 s, 4884.375 with 0 s.
  Unit u = with_feedback(SrsVersion::v3_6_0);
  set_EOA(u.in, 4900.0, 5000.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {5.0};
  u.build();
  u.s.feedback.p0_known = true;
  u.s.feedback.p0 = 500.0;
  const auto cycle = [&](double x, double p) {
    Motion m = at(x, 8.0);
    m.brake_pressure_kpa = p;
    return u.cycle(m).monitoring;
  };
  cycle(4860, 500.0);
  ASSERT_EQ(cycle(4861, 430.0), Monitoring::TSM);
  EXPECT_EQ(cycle(4884, 430.0), Monitoring::TSM);
  EXPECT_EQ(cycle(4884.5, 430.0), Monitoring::RSM);
}

TEST(Feedback, BeginsWith340BeyondTheIndicationLimitOnly) {
  // I at 25 m/s lies at 4187.5 (SvL), pre-indication at 3740.
  for (const SrsVersion srs : {SrsVersion::v3_4_0, SrsVersion::v4_0_0}) {
    Unit u = with_feedback(srs);
    u.s.feedback.p0_known = true;
    u.s.feedback.p0 = 500.0;
    const auto cycle = [&](double x, double V, double p) {
      Motion m = at(x, V);
      m.brake_pressure_kpa = p;
      u.cycle(m);
    };
    if (srs == SrsVersion::v3_4_0) {
      cycle(3800, 25.0, 500.0);
      cycle(3801, 25.0, 430.0);
      cycle(3802, 25.0, 430.0);
      ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
      EXPECT_FALSE(u.s.feedback.locked);
    }
    cycle(4190, 25.0, 500.0);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    cycle(4191, 25.0, 430.0);
    EXPECT_TRUE(u.s.feedback.locked);
    cycle(4192, 10.0, 500.0);  // slower, no limit is exceeded any more: the started feedback continues
    cycle(4193, 10.0, 500.0);
    EXPECT_TRUE(u.s.feedback.locked);
  }
}

TEST(Feedback, In340IsForgottenWhenTheTargetIsPassed) {
  for (const SrsVersion srs : {SrsVersion::v3_4_0, SrsVersion::v4_0_0}) {
    Unit u(srs);
    u.in.national_values.Q_NVSBFBPERM = true;
    u.in.train.service_brake_feedback = true;
    u.in.authority = {};
    ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
    ASSERT_TRUE(u.in.mrsp.append({{4300.0}}, {10.0}));
    u.build();
    u.s.feedback.p0_known = true;
    u.s.feedback.p0 = 500.0;
    const auto cycle = [&](double x, double V, double p) {
      Motion m = at(x, V);
      m.brake_pressure_kpa = p;
      u.cycle(m);
    };
    cycle(3650, 25.0, 500.0);
    cycle(3651, 25.0, 500.0);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    cycle(3652, 25.0, 430.0);
    ASSERT_TRUE(u.s.feedback.locked);
    cycle(3999, 19.0, 500.0);
    ASSERT_TRUE(u.s.feedback.locked);
    // At the target it is not passed, even with a new list of targets.
    cycle(4000, 19.0, 500.0);
    ASSERT_TRUE(u.s.feedback.locked);
    u.build();
    cycle(4000, 19.0, 500.0);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    ASSERT_TRUE(u.s.feedback.locked);
    cycle(4001, 19.0, 500.0);
    cycle(4002, 19.0, 500.0);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    EXPECT_EQ(u.s.feedback.locked, srs == SrsVersion::v4_0_0);
    // Passed in the cycle of a new list: reset too.
    cycle(4002, 19.0, 430.0);
    ASSERT_TRUE(u.s.feedback.locked);
    ASSERT_EQ(u.s.MRDT.d_target, Place{{4300.0}});
    ASSERT_TRUE(u.in.mrsp.append({{4310.0}}, {5.0}));
    u.build();
    cycle(4301, 19.0, 500.0);
    cycle(4302, 19.0, 500.0);
    ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
    EXPECT_EQ(u.s.feedback.locked, srs == SrsVersion::v4_0_0);
  }
}

TEST(Feedback, In400BeginsAnewWhenTargetSpeedMonitoringFollowsReleaseSpeedMonitoring) {
  Unit u = with_feedback(SrsVersion::v4_0_0);
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {5.0};
  u.build();
  u.s.feedback.p0_known = true;
  u.s.feedback.p0 = 500.0;
  const auto cycle = [&](double x, double V, double p) {
    Motion m = at(x, V);
    m.brake_pressure_kpa = p;
    return u.cycle(m).monitoring;
  };
  cycle(4840, 6.0, 500.0);
  ASSERT_EQ(cycle(4841, 6.0, 430.0), Monitoring::TSM);
  ASSERT_EQ(cycle(4890, 4.0, 500.0), Monitoring::RSM);
  ASSERT_TRUE(u.s.feedback.locked);
  // A longer authority without a release speed.
  set_EOA(u.in, 4930.0, 4930.0);
  u.in.authority.release_speed = ReleaseSpeedChoice::none;
  u.build();
  ASSERT_EQ(cycle(4891, 4.0, 500.0), Monitoring::TSM);
  EXPECT_FALSE(u.s.feedback.locked);
  EXPECT_FALSE(u.s.hold_P);
}

TEST(Feedback, TheIndicationLimitOf400IgnoresIt) {
  Unit u = with_feedback(SrsVersion::v4_0_0);
  const Target& t = u.d->targets[0];
  const Approach a = approach({20.0}, {}, {}, u.d->fixed);
  TimesAsked none;
  TimesAsked locked;
  locked.feedback = FeedbackTimes{{0.0}, {2.0}};
  const TargetLimits full = limits_of(*u.d, t, a, none);
  const TargetLimits moved = limits_of(*u.d, t, a, locked);
  EXPECT_GT(moved.SBD->d_P, full.SBD->d_P);
  EXPECT_EQ(moved.SBD->d_I, full.SBD->d_I);
  EXPECT_EQ(moved.EBD.d_I, full.EBD.d_I);
  // 3.4.0 and 3.6.0 have no such clause.
  Unit v = with_feedback(SrsVersion::v3_6_0);
  EXPECT_GT(limits_of(*v.d, v.d->targets[0], a, locked).SBD->d_I, limits_of(*v.d, v.d->targets[0], a, none).SBD->d_I);
}

TEST(Feedback, TheTargetDistanceUsesTheTimesOfTheMoment) {
  Unit u(SrsVersion::v3_6_0);
  u.in.national_values.Q_NVSBFBPERM = true;
  u.in.train.service_brake_feedback = true;
  u.in.authority = {};
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {10.0}));
  u.in.authority.kind = Authority::Kind::EOA_SvL;
  u.in.authority.EOA = u.in.authority.SvL = {{8000.0}};
  u.in.authority.release_speed = ReleaseSpeedChoice::value;
  u.in.authority.V_release = {5.0};
  u.build();
  u.s.feedback.p0_known = true;
  u.s.feedback.p0 = 500.0;
  Motion m = at(3500, 25.0);
  m.brake_pressure_kpa = 500.0;
  u.cycle(m);
  u.cycle(m);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_NEAR(u.r.d_target->si, (u.d->targets[0].d_P_target - m.max_safe_front).si, 1e-9);
}

TEST(ReducedBuildUp, ShownSpeedIsHeldIn400) {
  Unit u = approaching_EOA(SrsVersion::v4_0_0);
  u.cycle(4550, 15.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  u.cycle(4880, 1.5);
  const Speed shown = u.r.V_P;
  const Speed shown_SBI = u.r.V_SBI;
  // Slower: the build-up times are even shorter, and 1.0 m/s would allow more. The displayed value
  // is held.
  u.cycle(4880, 1.0);
  EXPECT_EQ(u.r.V_P, shown);
  EXPECT_EQ(u.r.V_SBI, shown_SBI);
  Unit other = approaching_EOA(SrsVersion::v3_6_0);
  other.cycle(4550, 15.0);
  other.cycle(4880, 1.5);
  const Speed before = other.r.V_P;
  EXPECT_GT(other.cycle(4880, 1.0).V_P, before);
}

TEST(ReducedBuildUp, AnElementNotBelowVMRSPHoldsNothingIn400) {
  // 10 m/s from 1000, 20 m/s from 1500, 3 m/s from 1600: at 10 m/s only the build-up towards 20 m/s would be reduced,
  // which is no target (3.13.8.2.1 a): the permitted speed may rise when the train stops accelerating.
  Unit u(SrsVersion::v4_0_0);
  ASSERT_TRUE(u.in.mrsp.append({{1000.0}}, {10.0}));
  ASSERT_TRUE(u.in.mrsp.append({{1500.0}}, {20.0}));
  ASSERT_TRUE(u.in.mrsp.append({{1600.0}}, {3.0}));
  u.build();
  Motion m = at(1440, 10.0);
  u.cycle(m);
  m.A_est = {0.3};
  const Speed accelerating = u.cycle(m).V_P;
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  ASSERT_LT(accelerating.si, 10.0);
  m.A_est = {0.0};
  EXPECT_GT(u.cycle(m).V_P, accelerating);
}

TEST(Display, TargetsBehindTheTripLocationDoNotIndicateBelowTheReleaseSpeed) {
  Unit u;
  set_EOA(u.in, 4900.0, 5300.0);
  u.in.authority.reference = {{4800.0}};
  u.in.authority.release_speed = ReleaseSpeedChoice::on_board;
  ASSERT_TRUE(u.in.mrsp.append({{5100.0}}, {2.0}));
  u.build();
  ASSERT_TRUE(u.d->release_speed.exists);
  const double V = u.d->release_speed.V_release.si - 0.1;
  ASSERT_GT(V, 2.0);
  u.cycle(1000, V);
  const double start = std::min(u.d->release_speed.d_SBI1, u.d->release_speed.d_SBI2).from_origin.si;
  EXPECT_NEAR(u.r.first_indication->si, start - 1000, 1e-9);
}

TEST(Safety, TSM360SupervisesTheCeilingInRearOfAllIndicationLimits) {
  Unit u;
  ASSERT_TRUE(u.in.mrsp.append({{4000.0}}, {20.0}));
  u.build();
  u.cycle(3400, 28.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  // The train is set back in the frame (relocation): no Indication limit is exceeded, and it is too fast.
  u.cycle(500, kM + 0.1);
  EXPECT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(u.r.status, Status::Overspeed);
  u.cycle(500, kEBI + 0.1);
  EXPECT_TRUE(u.r.eb);
}

TEST(Safety, TSM340SupervisesTheCeilingBeyondTheLimitsOfAFasterTarget) {
  // An LOA with 25 m/s at 3000, 20 m/s from 2000 on: V = 22 m/s is not above the target speed, and beyond SBI2.
  Unit u(SrsVersion::v3_4_0);
  ASSERT_TRUE(u.in.mrsp.append({{2000.0}}, {20.0}));
  u.in.authority.kind = Authority::Kind::LOA;
  u.in.authority.EOA = {{3000.0}};
  u.in.authority.V_LOA = {25.0};
  u.build();
  u.cycle(2960, 21.0);
  ASSERT_EQ(u.r.monitoring, Monitoring::TSM);
  EXPECT_EQ(u.r.status, Status::Overspeed);
  u.cycle(2961, 21.3);  // dV_warning 4 km/h = 1.11 m/s
  EXPECT_EQ(u.r.status, Status::Warning);
  u.cycle(2962, 21.6);  // dV_sbi 5.5 km/h = 1.53 m/s
  EXPECT_TRUE(u.r.sb);
  u.cycle(2963, 22.1);  // dV_ebi 7.5 km/h = 2.08 m/s
  EXPECT_TRUE(u.r.eb);
}

TEST(Safety, ReportsWhatTheCurvesMet) {
  Unit u;
  u.in.gradient.permille.steps[0].value = -200.0;
  set_EOA(u.in, 4900.0, 5000.0);
  u.build();
  u.cycle(0, 1.0);
  EXPECT_TRUE(u.r.no_deceleration);
  EXPECT_TRUE(u.r.eb);
  EXPECT_FALSE(u.r.truncated);
  // More targets than fit: this is reported.
  Unit v;
  for (int n = 0; n < 127; ++n) ASSERT_TRUE(v.in.mrsp.append({{10.0 * n}}, {n % 2 == 0 ? 20.0 : 10.0}));
  v.build();
  EXPECT_TRUE(v.cycle(0, 1.0).truncated);
  EXPECT_FALSE(v.r.no_deceleration);
}

}  // namespace
