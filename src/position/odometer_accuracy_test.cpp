#include "position/odometer_accuracy.h"

#include <gtest/gtest.h>

namespace evc::position {
namespace {

/// An odometer that runs in steps of 10 m; its bounds are wrong by these shares of the distance.
struct Journey {
  OdometerAccuracy accuracy;
  double nominal = 0.0, min = 0.0, max = 0.0;
  void step(double moved, double under, double over) {
    nominal += moved;
    max += moved + (moved < 0.0 ? -moved * over : moved * under);
    min += moved - (moved < 0.0 ? -moved * under : moved * over);
    accumulate(accuracy, {{{nominal}}, {{min}}, {{max}}});
  }
  void drive(double distance, double under, double over) {
    for (double d = 0.0; d < (distance < 0.0 ? -distance : distance); d += 10.0)
      step(distance < 0.0 ? -10.0 : 10.0, under, over);
  }
  bool beyond() const { return accuracy.beyond_safety_threshold; }
};

TEST(OdometerAccuracy, ThirtyPercentOfTheTotalDistanceIsTheThreshold) {  // 3.6.8.7, A.3.1
  for (const auto& [under, over] : {std::pair{0.31, 0.0}, {0.0, 0.31}}) {
    Journey run;
    run.step(0.0, under, over);
    run.drive(4700.0, under, over);
    EXPECT_FALSE(run.beyond());
    run.drive(300.0, under, over);
    EXPECT_TRUE(run.beyond());
  }
  Journey run;
  run.step(0.0, 0.29, 0.29);
  run.drive(20000.0, 0.29, 0.29);
  EXPECT_FALSE(run.beyond());
}

TEST(OdometerAccuracy, TheWholeDistanceNeedNotBeTravelled) {  // 3.6.8.8
  Journey run;
  run.step(0.0, 1.0, 0.0);
  run.drive(1500.0, 1.0, 0.0);
  EXPECT_FALSE(run.beyond()) << "exactly the threshold";
  run.drive(90.0, 1.0, 0.0);
  EXPECT_FALSE(run.beyond()) << "checked at the end of an interval (3.6.8.4)";
  run.drive(10.0, 1.0, 0.0);
  EXPECT_TRUE(run.beyond());
}

TEST(OdometerAccuracy, OnlyTheLastDistanceCounts) {  // 3.6.8.2
  Journey run;
  run.step(0.0, 0.4, 0.0);
  run.drive(4000.0, 0.4, 0.0);
  EXPECT_TRUE(run.beyond());
  run.drive(1300.0, 0.0, 0.0);
  EXPECT_FALSE(run.beyond());
}

TEST(OdometerAccuracy, IsImpairedBeyond250Metres) {  // 3.6.8.5, A.3.1
  for (const auto& [under, over] : {std::pair{0.06, 0.0}, {0.0, 0.06}}) {
    Journey run;
    run.step(0.0, under, over);
    run.drive(4100.0, under, over);
    EXPECT_FALSE(run.accuracy.impaired);
    run.drive(100.0, under, over);
    EXPECT_TRUE(run.accuracy.impaired);
  }
  Journey run;
  run.step(0.0, 0.0495, 0.0495);
  run.drive(20000.0, 0.0495, 0.0495);
  EXPECT_FALSE(run.accuracy.impaired);
}

TEST(OdometerAccuracy, IsImpairedUntilTheTotalDistanceWasWithinTheRequiredAccuracy) {  // 3.6.8.6
  Journey run;
  run.step(0.0, 0.06, 0.0);
  run.drive(4200.0, 0.06, 0.0);
  ASSERT_TRUE(run.accuracy.impaired);
  // The last 5000 m hold the 252 m for 800 m more; the distance is counted from there.
  run.drive(5700.0, 0.0, 0.0);
  EXPECT_TRUE(run.accuracy.impaired);
  run.drive(100.0, 0.0, 0.0);
  EXPECT_FALSE(run.accuracy.impaired);
}

TEST(OdometerAccuracy, RecoversAnewAfterAStretchThatIsTooInaccurate) {  // 3.6.8.6
  for (const auto& [under, over] : {std::pair{0.75, 0.0}, {0.0, 0.75}}) {
    Journey run;
    run.step(0.0, 0.06, 0.0);
    run.drive(4200.0, 0.06, 0.0);
    run.drive(2000.0, 0.0, 0.0);
    run.drive(100.0, under, over);  // 75 m, where 5 m + 5 % of 1300 m are required
    run.drive(4900.0, 0.0, 0.0);
    EXPECT_TRUE(run.accuracy.impaired);
    run.drive(100.0, 0.0, 0.0);
    EXPECT_FALSE(run.accuracy.impaired);
  }
}

TEST(OdometerAccuracy, BothDirectionsCountByTheirAmount) {  // 3.6.8.1.1
  Journey run;
  run.step(0.0, 0.4, 0.0);
  run.drive(2000.0, 0.4, 0.0);
  run.drive(-1800.0, 0.4, 0.0);
  EXPECT_TRUE(run.beyond());
  Journey apart;
  apart.step(0.0, 0.4, 0.0);
  apart.drive(2000.0, 0.4, 0.0);
  apart.drive(-1800.0, 0.0, 0.4);
  EXPECT_FALSE(apart.beyond()) << "under- and overestimation are not added";
}

}  // namespace
}  // namespace evc::position
