#include "kernel/supervise/supervise.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"
#include "kernel/basis.h"

// Supervision with what the unit knows: the movement that is guarded, the antenna, level crossings, the LSSMA.
namespace evc::kernel {
namespace {

using brakes::Cause;

using evc::test::at;
using evc::test::kmh;

/// A unit at standstill with its front end at 1000 m and the counter at 1000 m, an authority to 3000 m, 140 km/h.
class Supervision : public ::testing::Test {
 protected:
  Supervision() { restart(Mode::FS); }
  void restart(Mode mode) {
    state = State{};
    *derived = Derived{};
    outputs->events.clear();
    train = {};
    state.mode = mode;
    state.level.level = Level::L1;
    state.now = {100.0};
    track::MovementAuthority& ma = state.track.ma.emplace();
    EXPECT_TRUE(ma.sections.push_back({at(0.0), at(3000.0)}));
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 28}));
    EXPECT_TRUE(state.track.gradient.append(at(0.0), {0}));
    here = {};
    here.est_front = here.min_safe_front = here.max_safe_front = at(1000.0);
    here.min_safe_rear = at(800.0);
    here.min_safe_antenna = at(995.0);
    here.standstill = true;
    counter(1000.0);
  }
  void counter(double x) { state.position.now.counter = {{{x}}, {{x}}, {{x}}}; }
  void runs(double v) {
    state.position.now.V_est = state.position.now.V_min = state.position.now.V_max = {v};
    here.standstill = v == 0.0;
  }
  Supervised run() {
    outputs->events.clear();
    return supervise(state, *derived, train, here, false, acknowledged, Log{outputs->events});
  }
  bool happened(What what) const {
    for (const Event& e : outputs->events)
      if (e.what == what) return true;
    return false;
  }
  /// The brake asked for after a movement of the counter.
  bool brakes_after(double moved, Cause cause) {
    (void)run();
    counter(1000.0 + moved);
    return run().asked.has(cause);
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  std::unique_ptr<Derived> derived = std::make_unique<Derived>();
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
  TrainSignals train;
  track::Here here;
  bool acknowledged = false;
};

TEST_F(Supervision, TellsWhereThereAreMoreTargetsThanItHolds) {  // 3.13.8.2: 64, the further ones are merged
  EXPECT_TRUE(run().limits.has_value());
  EXPECT_FALSE(happened(What::targets_lost));
  state.track.ma->sections[0].end = at(200000.0);
  for (int i = 0; i < 47; ++i) {
    track::TemporarySpeedRestriction tsr;
    tsr.from = at(2000.0 + 2000.0 * i);
    tsr.to = at(2100.0 + 2000.0 * i);
    tsr.V_TSR = 20;
    ASSERT_TRUE(state.track.tsr.push_back(tsr));
  }
  for (int i = 1; i <= 20; ++i)
    ASSERT_TRUE(state.track.ssp.append(at(100000.0 + 2000.0 * i), {.V_STATIC = static_cast<track::SpeedCode>(28 - i)}));
  ++state.track.revision;
  (void)run();
  EXPECT_TRUE(happened(What::targets_lost));
}

// --- 3.14, 4.4.14, 3.15.4

TEST_F(Supervision, GuardsAgainstRollingAwayByTheDirectionController) {  // 3.14.2
  const auto brakes = [&](DirectionController controller, double moved) {
    restart(Mode::SH);
    state.national_values.D_NVROLL = Distance{3.0};
    train.direction_controller = controller;
    return brakes_after(moved, Cause::roll_away);
  };
  EXPECT_FALSE(brakes(DirectionController::forward, 3.1));
  EXPECT_TRUE(brakes(DirectionController::forward, -3.1));
  EXPECT_FALSE(brakes(DirectionController::forward, -2.9)) << "D_NVROLL";
  EXPECT_TRUE(brakes(DirectionController::backward, 3.1));
  EXPECT_FALSE(brakes(DirectionController::backward, -3.1));
  EXPECT_TRUE(brakes(DirectionController::neutral, 3.1));
  EXPECT_TRUE(brakes(DirectionController::neutral, -3.1));
}

TEST_F(Supervision, GuardsAgainstTheOtherDirectionThanThatOfTheMode) {  // 3.14.3, 4.4.14, 4.4.18
  for (const Mode mode : {Mode::FS, Mode::LS, Mode::OS, Mode::SR, Mode::PT, Mode::RV}) {
    const bool backward = mode == Mode::PT || mode == Mode::RV;
    restart(mode);
    state.national_values.D_NVROLL = Distance{3.0};
    EXPECT_EQ(brakes_after(-3.1, Cause::reverse_movement), !backward) << static_cast<int>(mode);
    restart(mode);
    state.national_values.D_NVROLL = Distance{3.0};
    EXPECT_EQ(brakes_after(3.1, Cause::reverse_movement), backward) << static_cast<int>(mode);
  }
}

TEST_F(Supervision, TheDriverReleasesTheBrakeAtStandstill) {  // 3.14.1.3
  restart(Mode::SB);
  state.national_values.D_NVROLL = Distance{3.0};
  EXPECT_TRUE(brakes_after(3.1, Cause::standstill));
  state.brakes.active = {Cause::standstill, Cause::train_data_changed};
  acknowledged = true;
  runs(1.0);
  EXPECT_TRUE(run().asked.has(Cause::standstill));
  state.brakes.active = {Cause::train_data_changed};
  runs(0.0);
  EXPECT_TRUE(run().asked.has(Cause::standstill)) << "the acknowledgement is for another clause";
  state.brakes.active = {Cause::standstill, Cause::train_data_changed};
  EXPECT_FALSE(run().asked.has(Cause::standstill));
}

TEST_F(Supervision, GuardsTheDistanceOfPostTrip) {  // 4.4.14.1.3
  const auto brakes = [&](double moved) {
    restart(Mode::PT);
    state.national_values.D_NVPOTRP = Distance{50.0};
    return brakes_after(moved, Cause::post_trip_distance);
  };
  EXPECT_FALSE(brakes(-49.9));
  EXPECT_TRUE(brakes(-50.1));
}

TEST_F(Supervision, GuardsTheDistanceOfReversing) {  // 3.15.4.8
  const auto brakes = [&](Mode mode, double front) {
    restart(mode);
    state.track.reversing_reference = at(1000.0);
    state.track.reversing_supervision.emplace().D_REVERSE = Distance{200.0};
    here.est_front = at(front);
    return run().asked.has(Cause::reversing_distance);
  };
  EXPECT_FALSE(brakes(Mode::RV, 800.1));
  EXPECT_TRUE(brakes(Mode::RV, 799.9));
  EXPECT_FALSE(brakes(Mode::FS, 799.9));
}

// --- 3.15.7

TEST_F(Supervision, TheAlarmOfTheAntennaBrakes) {  // 3.15.7.6
  const auto brakes = [&](Mode mode, Level level, SrsVersion srs = SrsVersion::v3_6_0) {
    restart(mode);
    state.level.level = level;
    state.srs = srs;
    EXPECT_FALSE(run().asked.has(Cause::balise_antenna)) << "without an alarm";
    train.antenna_alarm = true;
    return run().asked.has(Cause::balise_antenna);
  };
  EXPECT_TRUE(brakes(Mode::FS, Level::L1));
  EXPECT_FALSE(brakes(Mode::RV, Level::L1));
  EXPECT_FALSE(brakes(Mode::UN, Level::L0));
  counter(1300.1);
  EXPECT_TRUE(run().asked.has(Cause::balise_antenna)) << "after 300 m";
  EXPECT_TRUE(brakes(Mode::SB, Level::L1));
  EXPECT_FALSE(brakes(Mode::SB, Level::L1, SrsVersion::v4_0_0));
}

TEST_F(Supervision, TheAlarmOfTheAntennaIsHiddenByMetalUnderIt) {  // 3.15.7.5
  const auto brakes = [&](double from, double to) {
    restart(Mode::FS);
    state.train.L_antenna_front = {5.0};
    here.max_safe_antenna = at(1015.0);  // the min safe one: at 995 m
    track::BigMetalMass mass;
    mass.from = at(from);
    mass.to = at(to);
    EXPECT_TRUE(state.track.big_metal.push_back(mass));
    train.antenna_alarm = true;
    return run().asked.has(Cause::balise_antenna);
  };
  EXPECT_FALSE(brakes(1015.0, 1100.0));
  EXPECT_TRUE(brakes(1015.1, 1100.0));
  EXPECT_FALSE(brakes(900.0, 995.0));
  EXPECT_TRUE(brakes(900.0, 994.9));
}

// --- 3.13

TEST_F(Supervision, CommandsByTheSpeedOfTheTrain) {  // 3.13.10.3
  state.track.ssp = {};
  ASSERT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 10}));  // 50 km/h
  runs(45.0 / 3.6);
  Supervised s = run();
  ASSERT_TRUE(s.limits.has_value());
  EXPECT_TRUE(s.asked.empty());
  runs(80.0 / 3.6);
  s = run();
  EXPECT_EQ(s.asked.has(Cause::overspeed_traction), s.limits->tco);
  EXPECT_EQ(s.asked.has(Cause::overspeed_service), s.limits->sb);
  EXPECT_TRUE(s.asked.has(Cause::overspeed_emergency));
}

TEST_F(Supervision, OfOneModeIsForgottenWithoutSupervision) {  // 4.5.2
  runs(200.0 / 3.6);
  ASSERT_TRUE(run().asked.has(Cause::overspeed_emergency));
  state.mode = Mode::NL;
  const Supervised s = run();
  EXPECT_FALSE(s.limits.has_value());
  EXPECT_FALSE(s.asked.has(Cause::overspeed_emergency));
  EXPECT_FALSE(state.supervision.eb);
}

TEST_F(Supervision, CurvesAreBuiltAgainForAnotherBasis) {  // 3.13.2
  (void)run();
  const std::uint32_t built = derived->built;
  EXPECT_NE(built, 0u);
  EXPECT_EQ(built, state.basis.number);
  (void)run();
  EXPECT_EQ(derived->built, built);
  ++state.revision;
  (void)run();
  EXPECT_NE(derived->built, built);
}

TEST_F(Supervision, ABrakeThatDoesNotDecelerateIsLoggedWithItsBasis) {  // 3.13.6.2
  (void)run();
  EXPECT_FALSE(happened(What::no_deceleration));
  state.track.gradient = {};
  ASSERT_TRUE(state.track.gradient.append(at(0.0), {-250}));
  ++state.track.revision;
  (void)run();
  EXPECT_TRUE(happened(What::no_deceleration));
  (void)run();
  EXPECT_FALSE(happened(What::no_deceleration)) << "once";
  *derived = Derived{};
  (void)run();
  EXPECT_FALSE(happened(What::no_deceleration)) << "the curves of a restored unit are those of before";
  *derived = Derived{};
  outputs->events.clear();
  (void)supervise(state, *derived, train, here, true, acknowledged, Log{outputs->events});
  EXPECT_TRUE(happened(What::no_deceleration)) << "the basis was renewed in this cycle";
}

// --- 5.16

/// An unprotected crossing at 1500 m.
class Crossing : public Supervision {
 protected:
  Crossing() { crossing(true); }
  void crossing(bool stop_required) {
    restart(Mode::FS);
    track::LevelCrossing lx;
    lx.NID_LX = 7;
    lx.from = at(1500.0);
    lx.to = at(1510.0);
    lx.unprotected = true;
    lx.stop_required = stop_required;
    lx.L_STOPLX = Distance{60.0};
    lx.V_LX = 4;
    EXPECT_TRUE(state.track.lx.push_back(lx));
  }
  bool lifted(double front, double v) {
    here.est_front = here.min_safe_front = here.max_safe_front = at(front);
    runs(v);
    (void)run();
    EXPECT_EQ(happened(What::level_crossing_speed), state.track.lx[0].substituted);
    return state.track.lx[0].substituted;
  }
};

TEST_F(Crossing, AStopInItsAreaLiftsTheStop) {  // 5.16.2
  EXPECT_FALSE(lifted(1439.9, 0.0));
  EXPECT_FALSE(lifted(1450.0, 1.0)) << "the train runs";
  EXPECT_TRUE(lifted(1440.0, 0.0));
  crossing(true);
  EXPECT_TRUE(lifted(1500.0, 0.0)) << "at the crossing";
  crossing(true);
  EXPECT_FALSE(lifted(1500.1, 0.0)) << "in the crossing";
}

TEST_F(Crossing, ThatIsProtectedChangesNothing) {  // 5.16.2
  state.track.lx[0].unprotected = false;
  EXPECT_FALSE(lifted(1450.0, 0.0));
}

TEST_F(Crossing, IsLiftedOnce) {  // 5.16.2
  ASSERT_TRUE(lifted(1450.0, 0.0));
  const Place from = state.track.lx[0].V_LX_from;
  here.est_front = at(1460.0);
  (void)run();
  EXPECT_FALSE(happened(What::level_crossing_speed));
  EXPECT_EQ(state.track.lx[0].V_LX_from, from);
}

TEST_F(Crossing, WithoutAStopIsPassedAtItsSpeed) {  // 5.16.2, 3.13.9.3.5.11
  crossing(false);
  EXPECT_FALSE(lifted(1050.0, 5.0));
  EXPECT_TRUE(lifted(1498.0, 5.0));
}

TEST_F(Crossing, IsShownWhereItIsTheMostRelevantTarget) {  // 5.16.1.4
  runs(20.0);
  here.est_front = here.min_safe_front = here.max_safe_front = at(1400.0);
  const Supervised nearest = run();
  ASSERT_TRUE(nearest.limits && nearest.limits->MRDT);
  ASSERT_EQ(nearest.limits->MRDT->kind, sdm::TargetKind::EOA_SvL);
  EXPECT_TRUE(state.track.lx[0].informed);
  crossing(true);
  runs(20.0);
  ASSERT_TRUE(state.track.ssp.append(at(1010.0), {.V_STATIC = 1}));
  const Supervised other = run();
  ASSERT_TRUE(other.limits && other.limits->MRDT);
  ASSERT_EQ(other.limits->MRDT->kind, sdm::TargetKind::MRSP);
  EXPECT_FALSE(state.track.lx[0].informed) << "a restriction is nearer";
}

// --- 4.4.19.1.4

/// In LS up to 100 km/h, the track allows 90 km/h at its slowest place, the train 160 km/h.
class Lssma : public Supervision {
 protected:
  Lssma() {
    restart(Mode::LS);
    state.national_values.V_NVLIMSUPERV = kmh(100.0);
    state.track.ssp = {};
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 28}));
    EXPECT_TRUE(state.track.ssp.append(at(2000.0), {.V_STATIC = 18}));
  }
  void ends_with(double V_LOA) {
    state.track.ma->V_LOA = kmh(V_LOA);
    ++state.track.revision;
  }
};

TEST_F(Lssma, IsTheLowestSpeedUpToTheEnd) {  // 4.4.19.1.4.1
  EXPECT_EQ(run().LSSMA, Speed{}) << "that of an EOA is 0";
  ends_with(40.0);
  EXPECT_EQ(run().LSSMA, kmh(40.0));
  ends_with(95.0);
  EXPECT_EQ(run().LSSMA, kmh(90.0)) << "that of the track";
}

TEST_F(Lssma, IsShownInLSOnly) {  // 4.4.19.1.4
  for (const Mode mode : {Mode::FS, Mode::OS}) {
    state.mode = mode;
    EXPECT_EQ(run().LSSMA, std::nullopt);
  }
}

TEST_F(Lssma, IsNotShownWhereTheEndIsAsFastAsTheMode) {  // 4.4.19.1.4.7
  ends_with(100.0);
  EXPECT_EQ(run().LSSMA, std::nullopt);
}

TEST_F(Lssma, IsNotShownAtTheSpeedOfTheTrain) {  // 4.4.19.1.4.7
  state.train.V_MAXTRAIN = kmh(80.0);
  ++state.revision;
  ends_with(80.0);
  EXPECT_EQ(run().LSSMA, std::nullopt);
  ends_with(75.0);
  EXPECT_EQ(run().LSSMA, kmh(75.0));
}

TEST_F(Lssma, IsNotShownWithAMarkerOrWithoutAnEnd) {  // 4.4.19.1.4
  state.track.generic_ls_marker = true;
  EXPECT_EQ(run().LSSMA, std::nullopt);
  state.track.generic_ls_marker = false;
  ASSERT_EQ(run().LSSMA, Speed{});
  state.track.ma.reset();
  ++state.track.revision;
  EXPECT_EQ(run().LSSMA, std::nullopt);
}

TEST_F(Lssma, AnOrderCountsOnce) {  // 4.4.19.1.4.3, 4.4.19.1.4.6
  state.track.generic_ls_marker = true;
  state.lssma.waiting = {Duration{90.0}, Duration{11.0}};
  EXPECT_EQ(run().LSSMA, std::nullopt);
  state.now = {101.1};
  EXPECT_EQ(run().LSSMA, Speed{});
  state.lssma.on = false;  // with the entry to LS
  EXPECT_EQ(run().LSSMA, std::nullopt);
}

}  // namespace
}  // namespace evc::kernel
