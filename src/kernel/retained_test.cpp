#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "kernel/evc.h"
#include "kernel/state.h"
#include "kernel/test_retained.h"

namespace evc::kernel {
namespace {

/// What is kept of a unit that started with it is the same, but for the level that it is not fitted for.
TEST(Retention, AUnitTakesWhatIsRead) {
  const auto state = std::make_unique<State>();
  const auto derived = std::make_unique<Derived>();
  Retained r = everything_retained();
  ASSERT_TRUE(power_up(*state, *derived, {}, r));
  EXPECT_TRUE(retained(*state) == r);
  Config config;
  config.levels.fill(false);
  ASSERT_TRUE(power_up(*state, *derived, config, r));
  r.level.reset();
  EXPECT_TRUE(retained(*state) == r);
}

TEST(Retention, TheFrontEndIsThatOfTheEngineAtItsCab) {  // 3.6.1.3.4, 3.6.1.5.1 of 4.0.0
  const auto state = std::make_unique<State>();
  const auto derived = std::make_unique<Derived>();
  Config config;
  config.srs = SrsVersion::v4_0_0;
  for (const bool cab_B : {false, true}) {
    Retained r = everything_retained();
    r.position->cab_B = cab_B;
    ASSERT_TRUE(power_up(*state, *derived, config, r));
    const Retained before = retained(*state);
    state->position.ahead = {{100.0}, {90.0}, {110.0}};
    EXPECT_TRUE(retained(*state) == before) << "vehicles in front of it";
    state->manoeuvre.opposite = true;
    position::turn(state->position);
    EXPECT_TRUE(retained(*state) == before) << "in a manoeuvre the other way";
  }
}

TEST(Retention, ALevelOrderThatWaitsIsKeptBy4_0_0Only) {  // 4.10
  const auto state = std::make_unique<State>();
  const auto derived = std::make_unique<Derived>();
  Retained r = everything_retained();
  r.level_order.emplace();
  ASSERT_TRUE(r.level_order->table.push_back({Level::L3, 0}) && r.level_order->table.push_back({Level::L0, 0}));
  for (const bool conditional : {false, true}) {
    r.level_order->conditional = conditional;
    Config config;
    config.srs = SrsVersion::v4_0_0;
    ASSERT_TRUE(power_up(*state, *derived, config, r));
    EXPECT_TRUE(retained(*state) == r);
    EXPECT_EQ(state->level_transition.kept_order.table[0].level, Level::L2);
  }
  ASSERT_TRUE(power_up(*state, *derived, {}, r));
  EXPECT_FALSE(retained(*state).level_order.has_value());
}

TEST(Retention, AUnitRefusesWhatNoUnitKeeps) {
  const auto state = std::make_unique<State>();
  const auto derived = std::make_unique<Derived>();
  const auto refused = [&](auto change) {
    Retained r = everything_retained();
    change(r);
    const bool taken = power_up(*state, *derived, {}, r);
    return !taken && retained(*state) == Retained{};
  };
  EXPECT_TRUE(refused([](auto& r) { r.operated_X = 3; }));
  EXPECT_TRUE(refused([](auto& r) { r.operated_X = 0; }));
  EXPECT_TRUE(refused([](auto& r) { r.network = port::kDefaultNetwork; }));
  EXPECT_TRUE(refused([](auto& r) { r.national_values.M_NVAVADH = 2.0; }));
  EXPECT_TRUE(refused([](auto& r) { r.covers[0].left = Duration{-1.0}; }));
  EXPECT_TRUE(refused([](auto& r) { r.covers[0].left = Duration{std::numeric_limits<double>::quiet_NaN()}; }));
  EXPECT_TRUE(refused([](auto& r) { r.covers[0].utc = -1; }));
  EXPECT_TRUE(refused([](auto& r) { r.level->level = static_cast<Level>(5); }));
  EXPECT_TRUE(refused([](auto& r) { r.level_table[1].level = static_cast<Level>(5); }));
  EXPECT_TRUE(refused([](auto& r) { r.level_order.emplace(); }));
  EXPECT_TRUE(refused([](auto& r) {
    r.level_order.emplace();
    EXPECT_TRUE(r.level_order->table.push_back({static_cast<Level>(5), 0}));
  }));
  EXPECT_TRUE(refused([](auto& r) { r.position->orientation = 3; }));
  EXPECT_TRUE(refused([](auto& r) { r.position->pair_orientation = 3; }));
  EXPECT_TRUE(refused([](auto& r) { r.position->ahead = Distance{1e8}; }));
  EXPECT_TRUE(refused([](auto& r) { r.position->over = Distance{11.0}; }));
  EXPECT_TRUE(refused([](auto& r) { r.position->under = Distance{11.0}; }));
  EXPECT_TRUE(refused([](auto& r) { r.position->Q_LOCACC = Distance{-1.0}; }));
}

/// 3.15.9.5: what a cover has left after power-up at 0 s and a cycle at `t_s`, in which the clock may be read.
class CoversWithoutPower : public ::testing::Test {
 protected:
  void power_up_with(const Retained& kept) { ASSERT_TRUE(power_up(*state_, *derived_, {}, kept)); }
  Retained step_at(double t_s, std::optional<std::int64_t> utc) {
    Inputs in;
    in.now = Duration{t_s};
    in.train.powered = true;
    in.utc = utc;
    step(*state_, *derived_, in, *outputs_);
    return retained(*state_);
  }
  /// One cover of a day, as of this date.
  static Retained day_at(std::optional<std::int64_t> utc) {
    Retained r = everything_retained();
    r.covers[0].utc = utc;
    return r;
  }
  static constexpr std::int64_t kOff = 1'795'000'000;

 private:
  std::unique_ptr<State> state_ = std::make_unique<State>();
  std::unique_ptr<Derived> derived_ = std::make_unique<Derived>();
  std::unique_ptr<Outputs> outputs_ = std::make_unique<Outputs>();
};

TEST_F(CoversWithoutPower, TheFirstReadingOfTheClockTakesTheTimeOff) {
  power_up_with(day_at(kOff));
  EXPECT_EQ(step_at(10.0, std::nullopt).covers[0].left, Duration{86390.0});
  const Retained read = step_at(50.0, kOff + 3600);
  EXPECT_EQ(read.covers[0].left, Duration{86400.0 - 3600.0});
  EXPECT_EQ(read.covers[0].utc, kOff + 3600);
  // From then on the unit counts: a clock that is set right says nothing of the time without power.
  EXPECT_EQ(step_at(60.0, kOff + 80000).covers[0].left, Duration{86400.0 - 3610.0});
}

TEST_F(CoversWithoutPower, TimesWithoutPowerAddUpUntilTheClockIsRead) {
  power_up_with(day_at(kOff));
  Retained kept = step_at(100.0, std::nullopt);
  EXPECT_EQ(kept.covers[0].utc, kOff + 100);
  power_up_with(kept);
  kept = step_at(50.0, kOff + 7200);
  EXPECT_EQ(kept.covers[0].left, Duration{86400.0 - 7200.0});
}

TEST_F(CoversWithoutPower, ThatOfBeforeItWasSetDoesNotCount) {
  power_up_with(day_at(kOff));
  Retained kept = step_at(100.0, std::nullopt);
  ASSERT_TRUE(kept.covers.push_back({1, 5, Duration{86400.0}, 1, std::nullopt}));  // set without a clock
  power_up_with(kept);
  kept = step_at(50.0, kOff + 7200);
  EXPECT_EQ(kept.covers[0].left, Duration{86400.0 - 7200.0});
  EXPECT_EQ(kept.covers[1].left, Duration{86400.0 - 50.0});
  EXPECT_EQ(kept.covers[1].utc, kOff + 7200);
}

TEST_F(CoversWithoutPower, AClockThatWasSetBackTakesNothingOff) {
  power_up_with(day_at(kOff));
  const Retained kept = step_at(10.0, kOff - 1'000'000);
  EXPECT_EQ(kept.covers[0].left, Duration{86390.0});
  EXPECT_EQ(kept.covers[0].utc, kOff - 1'000'000);
}

TEST_F(CoversWithoutPower, WhatEndedThereIsRemoved) {
  power_up_with(day_at(kOff));
  EXPECT_EQ(step_at(0.0, kOff + 86400).covers.size(), 1u);
  power_up_with(day_at(kOff));
  EXPECT_EQ(step_at(0.0, kOff + 86401).covers.size(), 0u);
}

TEST_F(CoversWithoutPower, AReadingThatIsNoDateIsNone) {
  power_up_with(day_at(kOff));
  EXPECT_EQ(step_at(10.0, -1).covers[0].utc, kOff + 10);
  EXPECT_EQ(step_at(20.0, 253402300800).covers[0].left, Duration{86380.0});
}

}  // namespace
}  // namespace evc::kernel
