#include "kernel/curves.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"
#include "kernel/basis.h"
#include "sdm/locations.h"

// What of the stored data goes into the curves (3.13.2 to 3.13.9).
namespace evc::kernel {
namespace {

using evc::test::at;
using evc::test::kmh;

/// A unit in FS at standstill with its front end at 1000 m, with an authority, a speed profile and a gradient.
class CurveInputs : public ::testing::Test {
 protected:
  CurveInputs() {
    state.mode = Mode::FS;
    state.level.level = Level::L2;
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {}));
    here.est_front = at(1000.0);
    here.min_safe_front = at(990.0);
    here.max_safe_front = at(1010.0);
    here.min_safe_rear = at(790.0);
    basis.number = 7;
    basis.min_safe_rear = at(790.0);
    basis.authority.EOA = at(3000.0);
    basis.authority.SvL = at(3050.0);
  }
  const sdm::Inputs& inputs() {
    build(*curves, state, train, basis);
    return curves->inputs;
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  std::unique_ptr<Derived::Curves> curves = std::make_unique<Derived::Curves>();
  TrainSignals train;
  track::Here here;
  SupervisionBasis basis;
};

TEST_F(CurveInputs, AreThoseOfTheUnit) {
  state.srs = SrsVersion::v4_0_0;
  state.train.L_TRAIN = {321.0};
  state.national_values.V_NVREL = kmh(25.0);
  const sdm::Inputs& in = inputs();
  EXPECT_EQ(in.revision, 7u);
  EXPECT_EQ(in.srs, SrsVersion::v4_0_0);
  EXPECT_EQ(in.train, state.train);
  EXPECT_EQ(in.national_values, state.national_values);
}

TEST_F(CurveInputs, HaveEachSpecialBrakeByItself) {  // 3.13.2.2.6
  using T = TrainSignals;
  using B = train::BrakeStatus;
  const std::pair<bool T::*, bool B::*> brakes[] = {{&T::regenerative_brake_active, &B::regenerative},
                                                    {&T::eddy_current_brake_active, &B::eddy_current},
                                                    {&T::magnetic_shoe_brake_active, &B::magnetic_shoe},
                                                    {&T::ep_brake_active, &B::electro_pneumatic},
                                                    {&T::additional_brake_active, &B::adhesion_independent}};
  for (const auto& one : brakes) {
    for (const auto& each : brakes) train.*each.first = each.first == one.first;
    const B got = inputs().brakes;
    for (const auto& each : brakes) EXPECT_EQ(got.*each.second, each.first == one.first);
  }
}

TEST_F(CurveInputs, HaveTheEarliestInhibitionOfEachBrake) {  // 3.13.5.1, 3.12.1.3
  using Kind = TrackConditionKind;
  using Off = std::optional<Place> sdm::TrackConditions::*;
  using C = sdm::TrackConditions;
  const std::pair<Kind, Off> kinds[] = {
      {Kind::switch_off_regenerative_brake, &C::regenerative_off},
      {Kind::switch_off_eddy_current_emergency_brake, &C::eddy_current_emergency_off},
      {Kind::switch_off_eddy_current_service_brake, &C::eddy_current_service_off},
      {Kind::switch_off_magnetic_shoe_brake, &C::magnetic_shoe_off},
      {Kind::powerless_lower_pantograph, &C::powerless},
      {Kind::powerless_main_switch_off, &C::powerless},
      {Kind::non_stopping_area, nullptr},
  };
  for (const auto& [kind, off] : kinds) {
    state.track.conditions.clear();
    // The whole train has passed the first one; the order of the others does not matter.
    ASSERT_TRUE(state.track.conditions.push_back({at(100.0), at(789.0), kind}));
    ASSERT_TRUE(state.track.conditions.push_back({at(2000.0), at(2100.0), kind}));
    ASSERT_TRUE(state.track.conditions.push_back({at(1500.0), at(1600.0), kind}));
    ASSERT_TRUE(state.track.conditions.push_back({at(1800.0), at(1900.0), kind}));
    const C c = inputs().conditions;
    for (const Off each : {&C::regenerative_off, &C::eddy_current_emergency_off, &C::eddy_current_service_off,
                           &C::magnetic_shoe_off, &C::powerless}) {
      if (each == off)
        EXPECT_EQ(c.*each, at(1500.0)) << static_cast<int>(kind);
      else
        EXPECT_EQ(c.*each, std::nullopt) << static_cast<int>(kind);
    }
  }
}

TEST_F(CurveInputs, AConditionCountsUntilTheRearHasPassedIt) {  // 3.12.1.1
  ASSERT_TRUE(state.track.conditions.push_back({at(100.0), at(790.0), TrackConditionKind::powerless_main_switch_off}));
  EXPECT_EQ(inputs().conditions.powerless, at(100.0));
}

TEST_F(CurveInputs, HaveTheSlipperyAreas) {  // 3.13.5.3, 3.18.4.6
  ASSERT_TRUE(state.track.adhesion.push_back({at(1100.0), at(1200.0), true}));
  ASSERT_TRUE(state.track.adhesion.push_back({at(1300.0), at(1400.0), false}));
  const sdm::TrackConditions c = inputs().conditions;
  ASSERT_EQ(c.reduced_adhesion.size(), 1u);
  EXPECT_EQ(c.reduced_adhesion[0], (sdm::Zone{at(1100.0), at(1200.0)}));
  EXPECT_FALSE(c.slippery_rail);
  state.slippery_rail = true;
  EXPECT_TRUE(inputs().conditions.slippery_rail);
}

TEST_F(CurveInputs, HaveTheEndOfAuthority) {  // 3.13.1.5, 3.13.9.4
  basis.authority.release = {ReleaseSpeedChoice::value, kmh(30.0)};
  basis.reference = at(950.0);
  basis.Q_LOCACC = {12.0};
  basis.confidence_interval = {20.0};
  basis.V_ura = {1.5};
  basis.key.level_1_at_EOA = true;
  const sdm::Authority a = inputs().authority;
  EXPECT_EQ(a.kind, sdm::Authority::Kind::EOA_SvL);
  EXPECT_EQ(a.EOA, at(3000.0));
  EXPECT_EQ(a.SvL, at(3050.0));
  EXPECT_EQ(a.release_speed, ReleaseSpeedChoice::value);
  EXPECT_EQ(a.V_release, kmh(30.0));
  EXPECT_EQ(a.reference, at(950.0));
  EXPECT_EQ(a.Q_LOCACC_reference, Distance{12.0});
  EXPECT_EQ(a.confidence_interval, Distance{20.0});
  EXPECT_EQ(a.V_ura, Speed{1.5});
  EXPECT_TRUE(a.level_1_at_EOA);
  basis.key.level_1_at_EOA = false;
  EXPECT_FALSE(inputs().authority.level_1_at_EOA);
}

TEST_F(CurveInputs, HaveTheReleaseSpeedOfItsKind) {  // 3.13.9.4.3
  using enum ReleaseSpeedChoice;
  for (const ReleaseSpeedChoice kind : {none, value, national, on_board}) {
    basis.authority.release = {kind, kmh(30.0)};
    EXPECT_EQ(inputs().authority.release_speed, kind);
  }
}

TEST_F(CurveInputs, WithoutASupervisedLocationTheEndOfAuthorityIsIt) {  // 3.8.4.5
  basis.authority.SvL.reset();
  EXPECT_EQ(inputs().authority.SvL, at(3000.0));
}

TEST_F(CurveInputs, HaveTheLimitOfAuthority) {  // 3.13.1.5
  basis.authority = {};
  EXPECT_EQ(inputs().authority.kind, sdm::Authority::Kind::none);
  basis.authority.LOA = at(2500.0);
  basis.authority.V_LOA = kmh(60.0);
  const sdm::Authority a = inputs().authority;
  EXPECT_EQ(a.kind, sdm::Authority::Kind::LOA);
  EXPECT_EQ(a.EOA, at(2500.0));
  EXPECT_EQ(a.V_LOA, kmh(60.0));
}

TEST_F(CurveInputs, HaveAnAuthorityOnlyInFullSupervision) {  // 4.5.2
  state.staff_responsible.end = at(1200.0);
  for (const Mode mode : {Mode::FS, Mode::OS, Mode::LS, Mode::SR, Mode::SH, Mode::UN}) {
    state.mode = mode;
    const sdm::Inputs& in = inputs();
    const bool full = mode == Mode::FS || mode == Mode::OS || mode == Mode::LS;
    EXPECT_EQ(in.authority.kind == sdm::Authority::Kind::EOA_SvL, full);
    EXPECT_EQ(in.SR_end.has_value(), mode == Mode::SR);
    EXPECT_EQ(in.supervise_targets, mode != Mode::SH);
  }
}

TEST_F(CurveInputs, HaveTheGradientFromTheRearEndOn) {  // 3.13.4.1
  state.track.default_gradient = -7;
  ASSERT_TRUE(state.track.gradient.append(at(900.0), {5}));
  ASSERT_TRUE(state.track.gradient.append(at(1500.0), {-3}));
  ASSERT_TRUE(state.track.gradient.append(at(2000.0), track::Gradient::unknown()));
  const sdm::GradientProfile g = inputs().gradient;
  EXPECT_EQ(g.known_from, at(900.0));
  EXPECT_EQ(g.known_to, at(2000.0));
  EXPECT_EQ(g.default_for_TSR, -7.0);
  EXPECT_EQ(g.permille.at(at(1000.0)), 5.0);
  EXPECT_EQ(g.permille.at(at(1600.0)), -3.0);
}

TEST_F(CurveInputs, HaveAGradientKnownFromBehindTheTrain) {  // 3.13.4.1.2
  ASSERT_TRUE(state.track.gradient.append(at(100.0), track::Gradient::unknown()));
  ASSERT_TRUE(state.track.gradient.append(at(790.0), {5}));
  const sdm::GradientProfile g = inputs().gradient;
  EXPECT_EQ(g.known_from, std::nullopt);
  EXPECT_EQ(g.known_to, std::nullopt);
  EXPECT_EQ(g.permille.at(at(1000.0)), 5.0);
}

TEST_F(CurveInputs, HaveNoGradientWhereNoneIsKnown) {  // 3.13.4.1.2
  ASSERT_TRUE(state.track.gradient.append(at(700.0), {5}));
  ASSERT_FALSE(inputs().gradient.permille.empty());
  state.track.gradient = {};
  ASSERT_TRUE(state.track.gradient.append(at(700.0), track::Gradient::unknown()));
  EXPECT_TRUE(inputs().gradient.permille.empty());
  EXPECT_EQ(inputs().gradient.default_for_TSR, std::nullopt);
}

TEST_F(CurveInputs, MarkTheStepsOfATemporaryRestriction) {  // 3.13.4.1.3, 3.11.5.4
  for (const bool Q_FRONT : {true, false}) {
    state.track.tsr.clear();
    ASSERT_TRUE(state.track.tsr.push_back({.from = at(1500.0), .to = at(1600.0), .Q_FRONT = Q_FRONT, .V_TSR = 8}));
    const sdm::Inputs& in = inputs();
    std::size_t marked = 0;
    for (std::size_t i = 0; i < in.mrsp.steps.size(); ++i) {
      const bool of_TSR = in.mrsp.steps[i].value == kmh(40.0);
      EXPECT_EQ(in.mrsp_due_to_TSR[i], of_TSR);
      marked += of_TSR ? 1u : 0u;
    }
    EXPECT_EQ(marked, 1u);
  }
}

TEST_F(CurveInputs, HaveTheSpeedsOfTrainModeAndOverride) {  // 3.11.7, 3.11.8, 5.8.3.1
  state.track.ssp = {};
  state.train.V_MAXTRAIN = kmh(155.0);
  state.national_values.V_NVSUPOVTRP = kmh(25.0);
  EXPECT_EQ(inputs().mrsp.at(at(1000.0)), kmh(155.0));
  state.mode = Mode::SR;
  EXPECT_EQ(inputs().mrsp.at(at(1000.0)), kmh(155.0));
  basis.key.mode_limit = kmh(40.0);
  EXPECT_EQ(inputs().mrsp.at(at(1000.0)), kmh(40.0));
  state.override_.active = true;
  EXPECT_EQ(inputs().mrsp.at(at(1000.0)), kmh(25.0));
}

TEST_F(CurveInputs, HaveTheAxleLoadProfileInItsModesOnly) {  // 4.5.2
  state.track.ssp = {};
  state.train.V_MAXTRAIN = kmh(155.0);
  track::AxleLoadRestriction restriction;
  restriction.from = at(0.0);
  restriction.to = at(3000.0);
  restriction.V_AXLELOAD.fill(10);
  ASSERT_TRUE(state.track.asp.push_back(restriction));
  for (const Mode mode : {Mode::FS, Mode::LS, Mode::OS, Mode::SR, Mode::UN}) {
    state.mode = mode;
    const bool counts = mode != Mode::SR && mode != Mode::UN;
    EXPECT_EQ(inputs().mrsp.at(at(1000.0)), counts ? kmh(50.0) : kmh(155.0)) << static_cast<int>(mode);
  }
}

TEST_F(CurveInputs, HaveTheMovement) {  // 3.13.10.2
  state.position.now.V_est = {10.0};
  state.position.now.V_min = {9.0};
  state.position.now.V_max = {12.0};
  state.position.now.A_est = {-0.25};
  state.now = {55.0};
  here.standstill = true;
  train.brake_pressure_kpa = 350.0;
  sdm::Motion m = motion_of(state, here, train);
  EXPECT_EQ(m.est_front, at(1000.0));
  EXPECT_EQ(m.min_safe_front, at(990.0));
  EXPECT_EQ(m.max_safe_front, at(1010.0));
  EXPECT_EQ(m.V_est, Speed{10.0});
  EXPECT_EQ(m.V_ura, Speed{2.0});
  EXPECT_EQ(m.A_est, Acceleration{-0.25});
  EXPECT_TRUE(m.standstill);
  EXPECT_EQ(m.now, Duration{55.0});
  EXPECT_EQ(m.brake_pressure_kpa, 350.0);
  EXPECT_EQ(m.T_MAR, std::nullopt);
  state.radio.ma_request.emplace().T_MAR = Duration{20.0};
  m = motion_of(state, here, train);
  EXPECT_EQ(m.T_MAR, Duration{20.0});
}

TEST_F(CurveInputs, MarkTheStepsOfTheRestrictionsInForce) {  // 3.13.4.1.3
  track::TemporarySpeedRestriction t;
  t.from = at(790.0);  // from the first step on
  t.to = at(1200.0);
  t.V_TSR = 8;
  t.Q_FRONT = true;
  ASSERT_TRUE(state.track.tsr.push_back(t));
  state.track.ssp = {};
  ASSERT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 20}));
  ASSERT_TRUE(state.track.ssp.append(at(2000.0), {.V_STATIC = 8}));
  ASSERT_EQ(inputs().mrsp.steps.size(), 3u);
  EXPECT_TRUE(curves->inputs.mrsp_due_to_TSR[0]);
  EXPECT_FALSE(curves->inputs.mrsp_due_to_TSR[1]);
  EXPECT_FALSE(curves->inputs.mrsp_due_to_TSR[2]) << "the same speed, by the SSP";
  state.track.tsr.clear();
  EXPECT_FALSE(inputs().mrsp_due_to_TSR[0]) << "revoked";
  // Where two end, the SSP of the speed of one begins.
  for (const track::SpeedCode V : {track::SpeedCode{8}, track::SpeedCode{4}}) {
    t.from = at(1500.0);
    t.to = at(1600.0);
    t.V_TSR = V;
    ASSERT_TRUE(state.track.tsr.push_back(t));
  }
  state.track.ssp = {};
  ASSERT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 20}));
  ASSERT_TRUE(state.track.ssp.append(at(1600.0), {.V_STATIC = 8}));
  ASSERT_EQ(inputs().mrsp.steps.size(), 3u);
  EXPECT_TRUE(curves->inputs.mrsp_due_to_TSR[1]);
  EXPECT_FALSE(curves->inputs.mrsp_due_to_TSR[2]);
}

TEST_F(CurveInputs, HaveTheSpeedOfAPermittedBrakingDistance) {  // 3.11.11
  ASSERT_TRUE(state.track.gradient.append(at(0.0), {0}));
  ASSERT_TRUE(state.track.pbd.push_back({.D_PBD = Distance{500.0}}));
  inputs();
  ASSERT_EQ(curves->pbd_speeds.size(), 1u);
  const Speed v = sdm::permitted_braking_distance_speed(curves->inputs, Distance{500.0}, 0.0, true, curves->sdm);
  EXPECT_GT(v, Speed{});
  EXPECT_EQ(track::speed_of(curves->pbd_speeds[0]), v);
  inputs();
  EXPECT_EQ(curves->pbd_speeds.size(), 1u) << "built again";
}

TEST_F(CurveInputs, BeginAtTheRearEndAndGoOnWithTheTrainLength) {  // 3.11.3.1.3, 3.13.4.1.2
  state.train.L_TRAIN = {300.0};
  state.track.ssp = {};
  ASSERT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 10}));
  ASSERT_TRUE(state.track.ssp.append(at(1500.0), {.V_STATIC = 20}));
  const auto& steps = inputs().mrsp.steps;
  ASSERT_GE(steps.size(), 2u);
  EXPECT_EQ(steps[0].from, at(790.0));
  EXPECT_EQ(steps[1].from, at(1800.0));
}

TEST_F(CurveInputs, TheGradientIsKnownAnewWithEachProfile) {  // 3.13.4.1.2
  ASSERT_TRUE(state.track.gradient.append(at(1500.0), {0}));
  EXPECT_EQ(inputs().gradient.known_from, at(1500.0));
  state.track.gradient = {};
  ASSERT_TRUE(state.track.gradient.append(at(0.0), {0}));
  EXPECT_EQ(inputs().gradient.known_from, std::nullopt);
}

}  // namespace
}  // namespace evc::kernel
