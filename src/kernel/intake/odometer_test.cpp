#include <gtest/gtest.h>

#include <memory>

#include "kernel/evc.h"
#include "kernel/state.h"

// Time stamps of the odometer and of telegrams (4.4.5).
namespace evc::kernel {
namespace {

class OdometerTime : public ::testing::Test {
 protected:
  OdometerTime() {
    power_up(*state, *derived, Config{});
    give(0.0, 0.0);
    for (int i = 0; i < 3; ++i) cycle(0.1 * i);
  }
  /// A reading of 20 m/s +- 1 m/s.
  void give(double counter, double measured, double v = 20.0) {
    in.odometry = {{{counter}}, {{counter - 1}}, {{counter + 2}}, {v}, {v > 0 ? v - 1 : 0}, {v > 0 ? v + 1 : 0}, {}};
    in.odometry.measured = Duration{measured};
  }
  void cycle(double now) {
    in.now = {now};
    step(*state, *derived, in, out);
  }
  bool tells(What what) const {
    for (const Event& e : out.events)
      if (e.what == what) return true;
    return false;
  }

  std::unique_ptr<State> state = std::make_unique<State>();
  std::unique_ptr<Derived> derived = std::make_unique<Derived>();
  Inputs in;
  Outputs out;
};

TEST_F(OdometerTime, AllThreeCountersAreExtrapolatedToTheCycle) {
  give(100.0, 1.0);
  cycle(1.5);
  EXPECT_EQ(out.est_front.from_origin.si, 110.0);
  EXPECT_EQ(state->position.now.counter.min.from_origin.si, 99.0 + 9.5);
  EXPECT_EQ(state->position.now.counter.max.from_origin.si, 102.0 + 10.5);
  cycle(1.75);  // the same reading
  EXPECT_EQ(out.est_front.from_origin.si, 115.0);
  EXPECT_NE(out.mode, Mode::SF);
}

TEST_F(OdometerTime, AReadingThatIsTooOldIsAFault) {
  give(100.0, 1.0);
  cycle(2.0);
  EXPECT_NE(out.mode, Mode::SF);
  cycle(2.01);
  EXPECT_TRUE(tells(What::odometry_not_sound));
  EXPECT_EQ(out.mode, Mode::SF);
  EXPECT_TRUE(out.eb);
}

TEST_F(OdometerTime, AStandstillHoldsUntilTheNextReading) {
  give(100.0, 1.0, 0.0);
  cycle(1.0);
  cycle(3600.0);
  EXPECT_NE(out.mode, Mode::SF);
  EXPECT_EQ(out.est_front.from_origin.si, 100.0);
  EXPECT_TRUE(position::at_standstill(state->position));
}

TEST_F(OdometerTime, AReadingOfTheFutureIsAFault) {
  give(100.0, 1.1);
  cycle(1.0);
  EXPECT_EQ(out.mode, Mode::SF);
}

TEST_F(OdometerTime, AnExtrapolatedReadingTellsNeitherStandstillNorATurn) {
  give(100.0, 1.0);
  cycle(1.0);
  cycle(1.9);
  EXPECT_FALSE(position::at_standstill(state->position));
  EXPECT_EQ(out.est_front.from_origin.si, 118.0);
  give(112.0, 2.0, 10.0);  // the train braked: less than was expected
  cycle(2.0);
  EXPECT_EQ(position::motion(state->position), position::Motion::forward);
  EXPECT_EQ(out.est_front.from_origin.si, 112.0);
}

TEST_F(OdometerTime, ATelegramIsPlacedByItsTime) {
  give(100.0, 1.0);
  cycle(1.0);
  give(104.0, 1.2);
  cycle(1.2);
  EXPECT_EQ(position::counter_at(state->position, Duration{1.1}).from_origin.si, 102.0);
  EXPECT_EQ(position::counter_at(state->position, Duration{0.9}).from_origin.si, 98.0);
}

TEST_F(OdometerTime, ATelegramOfTheFutureIsAFault) {
  const std::uint8_t bytes[] = {0x90, 0x02};
  const BaliseTelegram telegram{bytes, 13, {}, Duration{1.5}};
  in.balise_telegrams = {&telegram, 1};
  give(100.0, 1.0, 0.0);
  cycle(1.0);
  EXPECT_EQ(out.mode, Mode::SF);
}

TEST_F(OdometerTime, ATelegramOfNowOrOfPowerUpIsNone) {
  const std::uint8_t bytes[] = {0x90, 0x02};
  for (const double passed : {1.0, 0.5, 0.0}) {
    const BaliseTelegram telegram{bytes, 13, {}, Duration{passed}};
    in.balise_telegrams = {&telegram, 1};
    give(100.0, 1.0, 0.0);
    cycle(1.0);
    EXPECT_NE(out.mode, Mode::SF) << passed;
  }
}

}  // namespace
}  // namespace evc::kernel
