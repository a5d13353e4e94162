#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "base/test_units.h"
#include "kernel/basis.h"
#include "kernel/curves.h"
#include "kernel/here.h"
#include "kernel/state.h"

// The advance display (3.15.10); what it shows is in tests/scenarios/planning.scenario.
namespace evc::kernel {
namespace {

using evc::test::at;
using evc::test::kmh;

/// A unit in FS with its front end at 1000 m, between 990 m and 1010 m, and an authority to 3000 m.
class Plan : public ::testing::Test {
 protected:
  Plan() {
    state.mode = Mode::FS;
    state.train.L_TRAIN = 100_m;
    state.train.V_MAXTRAIN = kmh(140.0);
    state.position.now.counter = {{{1000.0}}, {{990.0}}, {{1010.0}}};
    state.basis.number = 1;
    state.basis.min_safe_rear = at(890.0);
    state.basis.authority.EOA = state.basis.authority.SvL = at(3000.0);
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 28}));
    EXPECT_TRUE(state.track.gradient.append(at(0.0), {0}));
  }
  /// False where there is none.
  bool planned() {
    build(derived->in_force, state, {}, state.basis);
    derived->built = state.basis.number;
    return plan(state, *derived, *planning);
  }
  void restrict(double from, double to, track::SpeedCode V) {
    ASSERT_TRUE(state.track.tsr.push_back({.from = at(from), .to = at(to), .Q_FRONT = true, .V_TSR = V}));
  }
  struct Speeds {
    double at, kmh;
    friend bool operator==(const Speeds&, const Speeds&) = default;
  };
  std::vector<Speeds> speeds() {
    EXPECT_TRUE(planned());
    std::vector<Speeds> all;
    for (const PlannedSpeed& s : planning->speeds)
      all.push_back({s.at.si, static_cast<double>(static_cast<int>(s.V.si * 3.6 + 0.5))});
    return all;
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  std::unique_ptr<Derived> derived = std::make_unique<Derived>();
  std::unique_ptr<Planning> planning = std::make_unique<Planning>();
};

TEST_F(Plan, TheFrontEndIsBetweenItsSafePlaces) {
  const track::Here train = here(state);
  EXPECT_EQ(train.est_front, at(1000.0));
  EXPECT_EQ(train.min_safe_front, at(990.0));
  EXPECT_EQ(train.max_safe_front, at(1010.0));
}

TEST_F(Plan, ThereIsOneInFullSupervisionAndOnSightWithAnAuthority) {
  for (const Mode mode : {Mode::FS, Mode::OS}) {
    state.mode = mode;
    EXPECT_TRUE(planned()) << static_cast<int>(mode);
  }
  for (const Mode mode : {Mode::SB, Mode::LS, Mode::SR, Mode::SH, Mode::UN, Mode::TR, Mode::PT, Mode::RV}) {
    state.mode = mode;
    EXPECT_FALSE(planned()) << static_cast<int>(mode);
  }
  state.mode = Mode::OS;
  state.srs = SrsVersion::v3_4_0;
  EXPECT_FALSE(planned()) << "4.5.2 of 3.4.0";
  state.mode = Mode::FS;
  EXPECT_TRUE(planned());
  state.basis.authority = {};
  EXPECT_FALSE(planned());
}

TEST_F(Plan, ThereIsNoneWithoutTheCurvesOfTheLastStep) {
  EXPECT_FALSE(plan(state, *derived, *planning)) << "after a restored snapshot";
  EXPECT_TRUE(planned());
  ++state.basis.number;
  EXPECT_FALSE(plan(state, *derived, *planning));
}

TEST_F(Plan, ARestrictionThatTheWholeIntervalIsNeverInIsOneStep) {
  restrict(1500.0, 1505.0, 8);
  EXPECT_EQ(speeds(), (std::vector<Speeds>{{0.0, 140.0}, {490.0, 40.0}, {515.0, 140.0}}));
  EXPECT_EQ(planning->speeds[1].sources, Set<MrspSource>{MrspSource::TSR});
  EXPECT_EQ(planning->speeds[2].sources, (Set<MrspSource>{MrspSource::SSP, MrspSource::train}));
}

TEST_F(Plan, AHigherSpeedThatIsShorterThanTheIntervalNeverCounts) {
  restrict(1500.0, 1600.0, 8);
  restrict(1615.0, 1700.0, 8);
  EXPECT_EQ(speeds(), (std::vector<Speeds>{{0.0, 140.0}, {490.0, 40.0}, {710.0, 140.0}}));
}

TEST_F(Plan, ARestrictionBetweenTheSafeFrontEndsIsInForce) {
  restrict(1005.0, 1100.0, 8);
  EXPECT_EQ(speeds(), (std::vector<Speeds>{{0.0, 40.0}, {110.0, 140.0}}));
  state.track.tsr.clear();
  restrict(900.0, 995.0, 8);
  EXPECT_EQ(speeds(), (std::vector<Speeds>{{0.0, 40.0}, {5.0, 140.0}}));
}

TEST_F(Plan, ASpeedOfZeroAtTheFrontEndIsAll) {
  restrict(1005.0, 1100.0, 0);
  EXPECT_EQ(speeds(), (std::vector<Speeds>{{0.0, 0.0}}));
  EXPECT_FALSE(planning->EOA.has_value());
  ASSERT_EQ(planning->gradients.size(), 1u);
  EXPECT_EQ(planning->gradients[0].to, 10_m);
}

TEST_F(Plan, AnEndThatIsPassedIsAtTheFrontEnd) {
  state.basis.authority.EOA = at(998.0);
  ASSERT_TRUE(planned());
  EXPECT_EQ(planning->EOA, Distance{});
  EXPECT_TRUE(planning->gradients.empty());
}

TEST_F(Plan, AnUnknownGradientIsAGap) {
  state.track.gradient.steps.clear();
  EXPECT_TRUE(state.track.gradient.append(at(1100.0), {5}));
  EXPECT_TRUE(state.track.gradient.append(at(1200.0), track::Gradient::unknown()));
  EXPECT_TRUE(state.track.gradient.append(at(1300.0), {-7}));
  ASSERT_TRUE(planned());
  ASSERT_EQ(planning->gradients.size(), 2u);
  EXPECT_EQ(planning->gradients[0].from, 100_m);
  EXPECT_EQ(planning->gradients[0].to, 200_m);
  EXPECT_EQ(planning->gradients[1].permille, -7);
  EXPECT_EQ(planning->gradients[1].to, 2000_m);
}

TEST_F(Plan, OrdersAreInTheOrderOfTheirDistances) {
  using enum TrackConditionKind;
  ASSERT_TRUE(state.track.conditions.push_back({at(2000.0), at(2500.0), powerless_main_switch_off}));
  ASSERT_TRUE(state.track.conditions.push_back({at(1200.0), at(1300.0), radio_hole}));
  ASSERT_TRUE(state.track.conditions.push_back({at(2100.0), at(3100.0), non_stopping_area}));
  ASSERT_TRUE(state.track.conditions.push_back({at(3000.0), at(3100.0), sound_horn}));
  ASSERT_TRUE(planned());
  std::vector<Symbol> symbols;
  for (const PlannedCondition& c : planning->conditions) symbols.push_back(c.symbol);
  EXPECT_EQ(symbols, (std::vector<Symbol>{Symbol::PL10, Symbol::PL06, Symbol::PL09, Symbol::PL08}));
  EXPECT_EQ(planning->conditions[1].at, 990_m);
  EXPECT_EQ(planning->conditions[3].at, 1510_m);
}

}  // namespace
}  // namespace evc::kernel
