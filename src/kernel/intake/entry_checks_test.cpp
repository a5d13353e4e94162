#include "kernel/intake/entry_checks.h"

#include <gtest/gtest.h>

#include <limits>

namespace evc::kernel {
namespace {

Speed entered_speed(double value) { return Speed{value / 3.6}; }

/// Every whole number of km/h, in tenths too: those of 5 km/h alone are speeds that can be entered (A.3.11).
TEST(EntryChecks, SpeedsAreMultiplesOf5) {
  for (int tenths = -100; tenths <= 6200; ++tenths) {
    const bool expected = tenths >= 0 && tenths <= 6000 && tenths % 50 == 0;
    EXPECT_EQ(is_SR_entry(entered_speed(tenths / 10.0), std::nullopt), expected) << tenths;
  }
}

TEST(EntryChecks, DistancesAreWholeMetresUpTo100Kilometres) {
  for (int metres = 0; metres <= 100'000; metres += 7) {
    EXPECT_TRUE(is_SR_entry(std::nullopt, Distance{double(metres)})) << metres;
    EXPECT_FALSE(is_SR_entry(std::nullopt, Distance{metres + 0.25})) << metres;
  }
  EXPECT_TRUE(is_SR_entry(std::nullopt, Distance{100'000.0}));
  EXPECT_FALSE(is_SR_entry(std::nullopt, Distance{100'001.0}));
  EXPECT_FALSE(is_SR_entry(std::nullopt, Distance{-1.0}));
}

TEST(EntryChecks, WhatIsNoNumberIsRefused) {
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300}) {
    EXPECT_FALSE(is_SR_entry(Speed{odd}, std::nullopt));
    EXPECT_FALSE(is_SR_entry(std::nullopt, Distance{odd}));
  }
  EXPECT_TRUE(is_SR_entry(std::nullopt, std::nullopt));
  EXPECT_FALSE(is_SR_entry(entered_speed(40.0), Distance{0.5})) << "each of both";
  EXPECT_FALSE(is_SR_entry(entered_speed(41.0), Distance{500.0})) << "each of both";
}

/// A value of train data counts only where it is another one than that of before.
TEST(EntryChecks, TrainDataBetweenTheStepsAreThoseOfBefore) {
  train::TrainData before;
  before.L_TRAIN = Distance{201.5};
  before.V_MAXTRAIN = entered_speed(157.0);
  before.brake_percentage = 120.5;
  EXPECT_EQ(off_resolution(before, before), train::Fault::none);
  train::TrainData entered = before;
  entered.L_TRAIN = Distance{202.5};
  EXPECT_EQ(off_resolution(entered, before), train::Fault::train_length);
  entered.L_TRAIN = Distance{202.0};
  EXPECT_EQ(off_resolution(entered, before), train::Fault::none);
  entered.V_MAXTRAIN = entered_speed(158.0);
  EXPECT_EQ(off_resolution(entered, before), train::Fault::maximum_speed);
  entered.V_MAXTRAIN = entered_speed(160.0);
  EXPECT_EQ(off_resolution(entered, before), train::Fault::none);
  entered.brake_percentage = 121.5;
  EXPECT_EQ(off_resolution(entered, before), train::Fault::brake_percentage);
  entered.brake_percentage = 121.0;
  EXPECT_EQ(off_resolution(entered, before), train::Fault::none);
  entered.brake_percentage = 121.5;
  entered.brake_model = train::BrakeModel::gamma;  // which has none
  EXPECT_EQ(off_resolution(entered, before), train::Fault::none);
}

}  // namespace
}  // namespace evc::kernel
