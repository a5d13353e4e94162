#include "track/indication.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "track/testing.h"
#include "track/withdraw.h"

// When track conditions are shown: points C, D, E and G of 5.18.
namespace evc::track {
namespace {

using namespace testing;
using enum TrackConditionKind;
using enum ConditionPhase;

constexpr Speed kTenMetresASecond{10.0};

class Indication : public ::testing::Test {
 protected:
  Indication() : memory(std::make_unique<Description>()), d(*memory) {}
  void store_area(TrackConditionKind kind, double from, double to) {
    Contents c;
    c.conditions = Fresh<TrackCondition>{at(from), false, {}};
    ASSERT_TRUE(c.conditions->elements.push_back({at(from), at(to), kind}));
    (void)store(d, c, here);
  }
  /// The train of 200 m with these ends, one second later.
  void move(double est, double doubt = 10.0) {
    const Duration now = here.now + Duration{1.0};
    here = front_at(est, doubt);
    here.now = now;
    advance_conditions(d, here, kTenMetresASecond);
  }
  ConditionPhase phase_at(double est, double doubt = 10.0) {
    move(est, doubt);
    return d.conditions.front().progress.phase;
  }

  std::unique_ptr<Description> memory;
  Description& d;
  Here here = front_at(0.0);
};

/// Announced 15 s before the max safe front end reaches the start.
void expect_announcement(Description& d, const std::function<ConditionPhase(double)>& phase_at) {
  EXPECT_EQ(phase_at(839.0), ahead);
  EXPECT_EQ(phase_at(840.0), announced) << "150 m at 10 m/s, max safe front end 10 m ahead";
  EXPECT_EQ(phase_at(989.0), announced);
  EXPECT_EQ(phase_at(990.0), active) << "max safe front end (point D)";
  EXPECT_TRUE(d.watch.shown);
}

TEST_F(Indication, PowerlessSectionsEndWithTheMinSafeFrontEnd) {  // 5.18.2, 5.18.3, 3.12.1.2.1.3
  for (const TrackConditionKind kind : {powerless_lower_pantograph, powerless_main_switch_off}) {
    d = Description{};
    store_area(kind, 1000.0, 1300.0);
    expect_announcement(d, [&](double est) { return phase_at(est); });
    EXPECT_EQ(phase_at(1309.0), active);
    EXPECT_EQ(phase_at(1310.0), ending) << "min safe front end (point E)";
    EXPECT_EQ(phase_at(1509.0), ending);
    EXPECT_EQ(phase_at(1510.0), ending) << "min safe rear end";
    for (int second = 1; second < 5; ++second) EXPECT_EQ(phase_at(1510.0 + 10.0 * second), ending) << second;
    EXPECT_EQ(phase_at(1560.0), over) << "5 s later (point G)";
    EXPECT_FALSE(d.watch.shown);
  }
}

TEST_F(Indication, AirTightnessEndsWithTheMinSafeRearEnd) {  // 5.18.6
  store_area(air_tightness, 1000.0, 1300.0);
  expect_announcement(d, [&](double est) { return phase_at(est); });
  EXPECT_EQ(phase_at(1509.0), active);
  EXPECT_EQ(phase_at(1510.0), ending);
  for (int second = 1; second < 5; ++second) EXPECT_EQ(phase_at(1510.0 + 10.0 * second), ending) << second;
  EXPECT_EQ(phase_at(1560.0), over);
}

TEST_F(Indication, InhibitedBrakesEndWithTheMinSafeRearEnd) {  // 5.18.7
  for (const TrackConditionKind kind : {switch_off_regenerative_brake, switch_off_eddy_current_service_brake,
                                        switch_off_magnetic_shoe_brake, switch_off_eddy_current_emergency_brake}) {
    d = Description{};
    store_area(kind, 1000.0, 1300.0);
    expect_announcement(d, [&](double est) { return phase_at(est); });
    EXPECT_EQ(phase_at(1509.0), active);
    EXPECT_EQ(phase_at(1510.0), over);
  }
}

TEST_F(Indication, TheHornIsAskedForFourSecondsAheadOfTheEstimatedFront) {  // 5.18.9, A.3.1, 3.12.1.2.1.4
  store_area(sound_horn, 1000.0, 1300.0);
  EXPECT_EQ(phase_at(959.0, 30.0), ahead);
  EXPECT_EQ(phase_at(960.0, 30.0), active);
  EXPECT_EQ(phase_at(1299.0, 30.0), active);
  EXPECT_EQ(phase_at(1300.0, 30.0), over);
}

TEST_F(Indication, ARadioHoleIsNotAnnounced) {  // 5.18.5
  store_area(radio_hole, 1000.0, 1300.0);
  EXPECT_EQ(phase_at(989.0), ahead);
  EXPECT_FALSE(in_radio_hole(d));
  EXPECT_EQ(phase_at(990.0), active);
  EXPECT_TRUE(in_radio_hole(d));
  EXPECT_EQ(phase_at(1300.0), over);
  EXPECT_FALSE(in_radio_hole(d));
}

TEST_F(Indication, AChangeOfTractionSystemIsShownUntilFiveSecondsAfterTheRear) {  // 5.18.10
  Contents c;
  c.traction = TractionChange{at(1000.0), 1, 7};
  (void)store(d, c, here);
  const auto phase = [&](double est) {
    move(est);
    return d.traction->progress.phase;
  };
  expect_announcement(d, phase);
  EXPECT_EQ(phase(1210.0), active) << "the min safe rear end";
  EXPECT_TRUE(d.traction->progress.rear_left.has_value());
  for (int second = 1; second < 5; ++second) EXPECT_EQ(phase(1210.0 + 10.0 * second), active) << second;
  EXPECT_EQ(phase(1260.0), over);
}

TEST_F(Indication, PlatformsAndCurrentAreOutputUntilTheRearEndHasPassed) {  // 5.20.7, 5.20.8
  Contents c;
  c.platforms = Fresh<Platform>{at(1000.0), false, {}};
  ASSERT_TRUE(c.platforms->elements.push_back({at(1000.0), at(1300.0), 3, 2}));
  c.current = CurrentChange{at(1000.0), 600};
  (void)store(d, c, here);
  expect_announcement(d, [&](double est) {
    move(est);
    EXPECT_EQ(d.current->progress.phase, d.platforms.front().progress.phase);
    return d.platforms.front().progress.phase;
  });
  move(1209.0);
  EXPECT_EQ(d.current->progress.phase, active);
  move(1210.0);
  EXPECT_EQ(d.current->progress.phase, over);
  EXPECT_EQ(d.platforms.front().progress.phase, active);
  move(1510.0);
  EXPECT_EQ(d.platforms.front().progress.phase, over);
}

TEST_F(Indication, NothingIsTakenBack) {  // A.3.5.1
  store_area(air_tightness, 1000.0, 1300.0);
  EXPECT_EQ(phase_at(850.0), announced);
  EXPECT_EQ(phase_at(700.0), announced);
  store_area(air_tightness, 1005.0, 1300.0);
  EXPECT_EQ(phase_at(700.0), announced) << "the same one, sent again";
  store_area(sound_horn, 900.0, 1300.0);
  EXPECT_EQ(phase_at(700.0), ahead) << "another one in its place";
}

TEST_F(Indication, AnAreaSentAgainInItRemainsOne) {  // 3.7.3.1 g
  store_area(powerless_lower_pantograph, 1000.0, 1300.0);
  EXPECT_EQ(phase_at(1100.0), active);
  store_area(powerless_lower_pantograph, 1110.0, 1400.0);
  ASSERT_EQ(d.conditions.size(), 1u);
  EXPECT_EQ(d.conditions.front().from, at(1000.0));
  EXPECT_EQ(d.conditions.front().to, at(1400.0));
  EXPECT_EQ(phase_at(1320.0), active);
  EXPECT_EQ(phase_at(1410.0), ending);
}

TEST_F(Indication, WhatTheTrainHasLeftIsNotShown) {
  move(2000.0);
  store_area(air_tightness, 1000.0, 1300.0);
  EXPECT_EQ(phase_at(2000.0), over);
}

TEST_F(Indication, ADeletedAreaEnds) {  // 3.7.3.2, A.3.4
  store_area(air_tightness, 1000.0, 1300.0);
  move(900.0);
  EXPECT_TRUE(d.watch.shown);
  (void)shorten(d, Situation::b_shortened_ma, at(950.0), here);
  EXPECT_TRUE(d.watch.changed);
  move(901.0);
  EXPECT_FALSE(d.watch.shown);
  EXPECT_FALSE(d.watch.changed);
}

TEST_F(Indication, IsQuietUntilAnAreaCanBegin) {
  store_area(sound_horn, 5000.0, 5100.0);
  move(100.0);
  EXPECT_FALSE(d.watch.shown);
  EXPECT_LE(d.watch.quiet_to, at(5000.0 - 600.0 / 3.6 * 4.0)) << "at the highest speed of the language";
  EXPECT_GT(d.watch.quiet_to, at(4000.0));
  EXPECT_FALSE(d.watch.stopping);
  store_area(non_stopping_area, 6000.0, 7000.0);
  EXPECT_TRUE(d.watch.changed);
  move(101.0);
  EXPECT_TRUE(d.watch.stopping);
}

TEST_F(Indication, IsKeptBeyond300MetresWhileItIsShown) {  // 5.18.2.6, A.3.6
  store_area(air_tightness, 1000.0, 1300.0);
  move(1000.0);
  move(1900.0);
  ASSERT_EQ(d.conditions.front().progress.phase, ending);
  (void)advance(d, here);
  EXPECT_EQ(d.conditions.size(), 1u);
  for (int i = 0; i < 5; ++i) move(1900.0);
  (void)advance(d, here);
  EXPECT_TRUE(d.conditions.empty());
}

}  // namespace
}  // namespace evc::track
