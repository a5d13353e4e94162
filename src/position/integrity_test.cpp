#include "position/integrity.h"

#include <gtest/gtest.h>

namespace evc::position {
namespace {

Odometry at_counter(double x, double v = 10.0) {
  const OdometerPlace place{Distance{x}};
  return {{place, place, place}, Speed{v}, Speed{v}, Speed{v}, Acceleration{}};
}

/// Table 2b and 2c of 4.0.0 (3.6.5.2.5).
class TrainIntegrityStatus : public ::testing::Test {
 protected:
  TrainIntegrityStatus() {
    facts.train_data_valid = facts.length_acknowledged = true;
    facts.L_TRAIN = 200_m;
    run_to(0);
    Passage p;
    p.id = {1, 7};
    p.counter = state.now.counter;
    p.Q_LOCACC = 5_m;
    p.counter_against_group = Direction::nominal;
    (void)relocate(state, p);
    run_to(1000);
  }
  void run_to(double x) { update(state, at_counter(x), Duration{time += 1.0}); }
  IntegrityEvents cycle() { return supervise(status, state, facts); }
  void by_device() {
    facts.device = TrainIntegrity::confirmed;
    (void)cycle();
    ASSERT_EQ(status.integrity, Integrity::by_device);
    facts.device = TrainIntegrity::unknown;
  }

  double time = 0;
  State state;
  IntegrityStatus status;
  IntegrityFacts facts;
};

TEST_F(TrainIntegrityStatus, NothingIsConfirmedByItself) {
  EXPECT_FALSE(cycle().lost);
  EXPECT_EQ(status.integrity, Integrity::none);
}

TEST_F(TrainIntegrityStatus, ByTheDriverUntilItIsReported) {
  facts.driver_confirms = true;
  EXPECT_TRUE(cycle().confirmed_by_driver);
  EXPECT_EQ(status.integrity, Integrity::by_driver);
  EXPECT_EQ(status.min_safe_rear.from_origin.si, 1000 - 5 - 200);
  facts.driver_confirms = false;
  run_to(1010);
  EXPECT_FALSE(cycle().confirmed_by_driver);
  EXPECT_EQ(status.integrity, Integrity::by_driver);
  note_reported(status);  // 5
  EXPECT_EQ(status.integrity, Integrity::none);
}

TEST_F(TrainIntegrityStatus, ByTheDriverAndNotReportedUntilTheTrainRunsBackOrIsAnotherOne) {
  const auto by_driver = [&] {
    facts.driver_confirms = true;
    EXPECT_TRUE(cycle().confirmed_by_driver);
    facts.driver_confirms = false;
  };
  by_driver();
  run_to(1100);
  by_driver();
  EXPECT_EQ(status.min_safe_rear.from_origin.si, 1100 - 5 - 200) << "the last time counts";
  run_to(1090);  // 8
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
  run_to(1100);
  by_driver();
  facts.L_TRAIN = 201_m;  // 7
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
}

TEST_F(TrainIntegrityStatus, ByADeviceTheLastTimeCounts) {
  facts.device = TrainIntegrity::confirmed;
  EXPECT_FALSE(cycle().confirmed_by_driver);
  run_to(1100);
  (void)cycle();
  EXPECT_EQ(status.min_safe_rear.from_origin.si, 1100 - 5 - 200);
  facts.device = TrainIntegrity::unknown;
  run_to(1150);
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::by_device);
  EXPECT_EQ(status.min_safe_rear.from_origin.si, 1100 - 5 - 200);
  note_reported(status);
  EXPECT_EQ(status.integrity, Integrity::none);
}

TEST_F(TrainIntegrityStatus, TheDriverConfirmsAfterTheDevice) {
  by_device();
  facts.driver_confirms = true;
  EXPECT_TRUE(cycle().confirmed_by_driver);
  EXPECT_EQ(status.integrity, Integrity::by_driver);
}

TEST_F(TrainIntegrityStatus, LostIsReportedOnceAndStays) {
  by_device();
  facts.device = TrainIntegrity::lost;
  EXPECT_TRUE(cycle().lost);
  EXPECT_FALSE(cycle().lost);
  note_reported(status);
  EXPECT_EQ(status.integrity, Integrity::lost);
  facts.device = TrainIntegrity::unknown;  // 6
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
  facts.device = TrainIntegrity::lost;
  EXPECT_TRUE(cycle().lost);
  facts.train_data_valid = false;  // 1
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
  EXPECT_FALSE(cycle().lost) << "4 needs valid train data";
}

TEST_F(TrainIntegrityStatus, AfterALossItIsConfirmedAgain) {
  facts.device = TrainIntegrity::lost;
  (void)cycle();
  facts.device = TrainIntegrity::confirmed;
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::by_device);
  facts.device = TrainIntegrity::lost;
  (void)cycle();
  facts.driver_confirms = true;
  EXPECT_TRUE(cycle().confirmed_by_driver);
  EXPECT_EQ(status.integrity, Integrity::by_driver);
}

TEST_F(TrainIntegrityStatus, WhatMakesAConfirmationOutdated) {
  by_device();
  facts.L_TRAIN = 201_m;  // 7
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
  by_device();
  facts.length_acknowledged = false;  // 7
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
  facts.length_acknowledged = true;
  by_device();
  facts.train_data_valid = false;
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
  facts.train_data_valid = true;
  by_device();
  run_to(1000 + 32762 - 206);
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::by_device);
  run_to(1000 + 32762 - 205 + 1);  // 9
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
  by_device();
  run_to(state.now.counter.nominal.from_origin.si - 1);  // 8
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
}

TEST_F(TrainIntegrityStatus, WhatCannotBeConfirmed) {
  const auto confirmed = [this](auto without) {
    IntegrityStatus fresh;
    State s = state;
    IntegrityFacts f = facts;
    f.device = TrainIntegrity::confirmed;
    f.driver_confirms = true;
    without(s, f);
    (void)supervise(fresh, s, f);
    return fresh.integrity;
  };
  EXPECT_EQ(confirmed([](State&, IntegrityFacts&) {}), Integrity::by_driver);
  EXPECT_EQ(confirmed([](State&, IntegrityFacts& f) { f.train_data_valid = false; }), Integrity::none);
  EXPECT_EQ(confirmed([](State&, IntegrityFacts& f) { f.length_acknowledged = false; }), Integrity::none);
  EXPECT_EQ(confirmed([](State&, IntegrityFacts& f) { f.validated_since = true; }), Integrity::none);
  EXPECT_EQ(confirmed([](State& s, IntegrityFacts&) { invalidate(s); }), Integrity::none);
  EXPECT_EQ(confirmed([](State& s, IntegrityFacts&) { forget(s); }), Integrity::none);
  // 8: only the source is not believed while the train moves backward.
  EXPECT_EQ(confirmed([](State& s, IntegrityFacts& f) {
              f.driver_confirms = false;
              update(s, at_counter(990, -10), Duration{100.0});
            }),
            Integrity::none);
}

TEST_F(TrainIntegrityStatus, ADeviceConfirmsNoLongerTrain) {
  facts.device_length = 200_m;
  by_device();
  facts.device = TrainIntegrity::lost;
  (void)cycle();
  facts.device = TrainIntegrity::confirmed;
  facts.device_length = 201_m;
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::lost) << "and says of this one neither that it is complete nor unknown";
  facts.device_length.reset();
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::by_device);
}

/// Without valid train data.
class ConsistIntegrityStatus : public TrainIntegrityStatus {
 protected:
  ConsistIntegrityStatus() {
    facts.train_data_valid = facts.length_acknowledged = false;
    facts.consist_known = facts.consist_acknowledged = facts.consist_captured = true;
  }
};

TEST_F(ConsistIntegrityStatus, AnotherConsistOfTheSameLengthIsNotTheOneConfirmed) {
  by_device();
  facts.consist_changed = true;  // 7
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
  facts.device = TrainIntegrity::confirmed;
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none) << "and the RBC has not acknowledged it";
}

TEST_F(ConsistIntegrityStatus, WithoutItsLengthItIsNotConfirmed) {
  by_device();
  facts.consist_known = false;  // 7
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
  facts.device = TrainIntegrity::confirmed;
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
}

TEST_F(ConsistIntegrityStatus, ALossStaysWithoutItsLength) {
  facts.device = TrainIntegrity::lost;
  EXPECT_TRUE(cycle().lost);
  facts.consist_known = false;
  EXPECT_FALSE(cycle().lost);
  EXPECT_EQ(status.integrity, Integrity::lost);
  facts.device = TrainIntegrity::unknown;  // 6
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
  facts.device = TrainIntegrity::lost;  // 4
  EXPECT_TRUE(cycle().lost);
  facts.consist_captured = false;
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
}

TEST_F(TrainIntegrityStatus, ANewSessionStartsWithoutInformation) {
  facts.driver_confirms = true;
  (void)cycle();
  facts.driver_confirms = false;
  facts.session_established = true;
  (void)cycle();
  EXPECT_EQ(status.integrity, Integrity::none);
}

}  // namespace
}  // namespace evc::position
