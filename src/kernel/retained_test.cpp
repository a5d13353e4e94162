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

}  // namespace
}  // namespace evc::kernel
