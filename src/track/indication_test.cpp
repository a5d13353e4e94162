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

template <class T>
T area(double from, double to) {
  T area;
  area.from = at(from);
  area.to = at(to);
  return area;
}

/// Announced already, and not yet.
const Progress kTold{announced, 0, {}}, kNew{};

TEST(SentAgain, AnAnnouncementIsNotTakenBackButMadeAnew) {  // A.3.5.1
  EXPECT_EQ(sent_again(Progress{}), kNew);
  for (const ConditionPhase phase : {announced, active, ending, over})
    EXPECT_EQ(sent_again({phase, 0, Duration{3}}), kTold) << "it has to be judged at its new place";
  EXPECT_EQ(sent_again({active, 7, {}}).shown_as, 7) << "for the driver it is the same";
}

template <class T>
void expect_the_same_where_they_touch() {
  const T stored = area<T>(1000.0, 1300.0);
  EXPECT_TRUE(same(stored, area<T>(1299.0, 1500.0)));
  EXPECT_TRUE(same(stored, area<T>(900.0, 1001.0)));
  EXPECT_TRUE(same(stored, area<T>(1100.0, 1200.0)));
  EXPECT_FALSE(same(stored, area<T>(1301.0, 1500.0))) << "in advance of it";
  EXPECT_FALSE(same(stored, area<T>(800.0, 999.0))) << "in rear of it";
  EXPECT_TRUE(same(area<T>(1000.0, 1000.0), area<T>(1000.0, 1000.0))) << "L_TRACKCOND = 0";
}

TEST(SentAgain, AnAreaIsTheSameWhereItTouchesTheStoredOne) {
  expect_the_same_where_they_touch<TrackCondition>();
  expect_the_same_where_they_touch<Platform>();
  TrackCondition other = area<TrackCondition>(1000.0, 1300.0);
  other.kind = air_tightness;
  EXPECT_FALSE(same(area<TrackCondition>(1000.0, 1300.0), other)) << "another kind";
}

TEST_F(Indication, WhatIsSentAgainFromInRearOfItIsStillAnnounced) {  // A.3.5.1, 3.7.3.1 g
  Contents c;
  c.conditions = Fresh<TrackCondition>{at(995.0), false, {}};
  ASSERT_TRUE(c.conditions->elements.push_back({at(995.0), at(1300.0), air_tightness}));
  ASSERT_TRUE(c.conditions->elements.push_back({at(1000.0), at(1400.0), powerless_lower_pantograph}));
  c.platforms = Fresh<Platform>{at(995.0), false, {}};
  ASSERT_TRUE(c.platforms->elements.push_back({at(995.0), at(1300.0), 3, 2}));
  (void)store(d, c, here);
  move(850.0);
  for (const double start : {990.0, 985.0}) {
    c.conditions->from = c.platforms->from = at(start);
    (void)store(d, c, here);
    move(700.0);
    ASSERT_EQ(d.conditions.size(), 2u);
    EXPECT_EQ(d.conditions[0].progress, kTold);
    EXPECT_EQ(d.conditions[1].progress, kTold);
    EXPECT_EQ(d.platforms.front().progress, kTold);
  }
  c.conditions->elements[0].kind = air_tightness;
  c.conditions->elements[1].from = at(2000.0);
  c.conditions->elements[1].to = at(2400.0);
  c.platforms->elements[0] = {at(2000.0), at(2400.0), 3, 2};
  (void)store(d, c, here);
  EXPECT_EQ(d.conditions[0].progress, kTold);
  EXPECT_EQ(d.conditions[1].progress, kNew) << "at another place it is another one";
  EXPECT_EQ(d.platforms.front().progress, kNew);
}

TEST_F(Indication, AChangeSentAgainIsAnnouncedStillUnlessItIsAnother) {  // A.3.5.1, 3.7.3.1 e, p
  struct Case {
    const char* what;
    TractionChange traction;
    CurrentChange current;
    Progress told_traction, told_current;
  };
  const Case cases[] = {
      {"the same, 5 m farther", {at(1005.0), 1, 7}, {at(1005.0), 600}, kTold, kTold},
      {"another voltage and current", {at(1000.0), 2, 7}, {at(1000.0), 700}, kNew, kNew},
      {"another country's system, no limit", {at(1000.0), 1, 8}, {at(1000.0), {}}, kNew, kNew},
      {"another of both", {at(1000.0), 2, 8}, {at(1000.0), 0}, kNew, kNew},
  };
  for (const Case& sent : cases) {
    d = Description{};
    Contents c;
    c.traction = TractionChange{at(1000.0), 1, 7};
    c.current = CurrentChange{at(1000.0), 600};
    (void)store(d, c, here);
    EXPECT_EQ(d.traction->progress, kNew);
    EXPECT_EQ(d.current->progress, kNew);
    move(850.0);
    ASSERT_EQ(d.traction->progress, kTold);
    ASSERT_EQ(d.current->progress, kTold);
    c.traction = sent.traction;
    c.current = sent.current;
    (void)store(d, c, here);
    EXPECT_EQ(d.traction->progress, sent.told_traction) << sent.what;
    EXPECT_EQ(d.current->progress, sent.told_current) << sent.what;
  }
}

TEST_F(Indication, WhatFindsNoRoomLeavesTheProgressOfOthersAlone) {
  while (d.platforms.size() + 1 < d.platforms.capacity())
    ASSERT_TRUE(d.platforms.push_back(area<Platform>(-2000.0, -1900.0)));
  ASSERT_TRUE(d.platforms.push_back(area<Platform>(0.0, 100.0)));
  move(50.0);
  const Progress before = d.platforms.back().progress;
  ASSERT_EQ(before.phase, active);
  Contents c;
  c.platforms = Fresh<Platform>{at(500.0), false, {}};
  ASSERT_TRUE(c.platforms->elements.push_back(area<Platform>(500.0, 600.0)));
  (void)store(d, c, here);
  ASSERT_EQ(d.platforms.back().from, at(0.0));
  EXPECT_EQ(d.platforms.back().progress, before);
}

TEST_F(Indication, AnAreaThatGoesOnWhereItEndedIsActiveAgain) {  // 3.7.3.1 g
  store_area(powerless_lower_pantograph, 1000.0, 1300.0);
  EXPECT_EQ(phase_at(1310.0), ending) << "min safe front end (point E)";
  store_area(powerless_lower_pantograph, 1300.0, 1500.0);
  ASSERT_EQ(d.conditions.size(), 1u);
  EXPECT_EQ(phase_at(1310.0), active) << "in front of it the pantograph must not be raised yet";
  EXPECT_EQ(phase_at(1510.0), ending);
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
  // Nor is it again, when it was left and is sent anew.
  d = Description{};
  store_area(air_tightness, 1000.0, 1300.0);
  EXPECT_EQ(phase_at(1510.0), ending);
  for (int second = 0; second < 5; ++second) move(1520.0);
  EXPECT_EQ(phase_at(1520.0), over);
  store_area(air_tightness, 995.0, 1300.0);
  ASSERT_EQ(d.conditions.front().progress, kTold);
  EXPECT_EQ(phase_at(1520.0), over);
}

TEST_F(Indication, TheTrainHasLeftWhenItsMinSafeRearEndIsBeyondTheEnd) {
  for (const double rear : {1300.0, 1300.1}) {
    d = Description{};
    store_area(air_tightness, 1000.0, 1300.0);
    EXPECT_EQ(phase_at(rear + 210.0), rear > 1300.0 ? over : ending) << rear;
  }
}

TEST_F(Indication, OnlyARadioHoleInWhichTheTrainIsIsOne) {  // 3.12.1.3
  Contents c;
  c.conditions = Fresh<TrackCondition>{at(1000.0), false, {}};
  ASSERT_TRUE(c.conditions->elements.push_back({at(1000.0), at(1300.0), air_tightness}));
  ASSERT_TRUE(c.conditions->elements.push_back({at(1200.0), at(1300.0), radio_hole}));
  (void)store(d, c, here);
  move(1100.0);
  ASSERT_TRUE(d.watch.shown);
  ASSERT_EQ(d.conditions[0].progress.phase, active);
  ASSERT_EQ(d.conditions[1].progress.phase, ahead);
  EXPECT_FALSE(in_radio_hole(d)) << "it lies ahead";
  move(1200.0);
  EXPECT_TRUE(in_radio_hole(d));
  move(1300.0);
  ASSERT_TRUE(d.watch.shown);
  EXPECT_FALSE(in_radio_hole(d)) << "it was left, another condition is shown still";
}

TEST_F(Indication, WhatIsDeletedWholeHasToBeLookedAtAndIsNotShown) {  // 4.10.1.3, A.3.4 k
  const auto shown = [&] {
    d = Description{};
    store_area(air_tightness, 1000.0, 1300.0);
    move(1100.0);
    EXPECT_TRUE(d.watch.shown && !d.watch.changed);
  };
  shown();
  (void)shorten(d, Situation::k_desk_closed_during_start, at(0.0), here);
  EXPECT_TRUE(d.watch.changed);
  EXPECT_FALSE(d.watch.shown);
  shown();
  EXPECT_TRUE(forget(d, evc::Stored::track_conditions_general));
  EXPECT_TRUE(d.watch.changed);
  move(1100.0);
  EXPECT_FALSE(d.watch.shown);
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
  EXPECT_EQ(d.watch.quiet_to, at(5000.0) - Speed{600.0 / 3.6} * Duration{4.0}) << "the highest speed of the language";
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
