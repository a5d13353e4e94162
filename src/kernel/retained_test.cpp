#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "kernel/evc.h"
#include "kernel/state.h"

namespace evc::kernel {
namespace {

/// Other than a default in every member.
Retained everything() {
  Retained r;
  train::NationalValues& nv = r.national_values;
  nv.V_NVSTFF = Speed{35.0 / 3.6};
  nv.D_NVROLL = train::kUnlimited;
  nv.D_NVOVTRP = 327670_m;
  nv.D_NVSTFF = 1500_m;
  nv.T_NVCONTACT = 30_s;
  nv.M_NVCONTACT = Reaction::service_brake;
  nv.A_NVMAXREDADH1 =
      train::MaxReducedAdhesion::without_maximum(train::MaxReducedAdhesion::Display::time_to_indication);
  nv.A_NVMAXREDADH2 =
      train::MaxReducedAdhesion::without_maximum(train::MaxReducedAdhesion::Display::target_information);
  nv.A_NVMAXREDADH3 = train::MaxReducedAdhesion::without_maximum(train::MaxReducedAdhesion::Display::none);
  nv.Kv_int_passenger.steps.clear();
  EXPECT_TRUE(nv.Kv_int_passenger.append({}, {0.6, 0.65}));
  EXPECT_TRUE(nv.Kv_int_passenger.append(Speed{100.0 / 3.6}, {0.5, 0.55}));
  EXPECT_TRUE(r.national_areas.push_back(1) && r.national_areas.push_back(1023));
  EXPECT_TRUE(r.national_areas_of_X_2.push_back(2) && r.national_areas_of_braking.push_back(3));
  r.operated_X = 1;
  r.generic_ls_marker = true;
  EXPECT_TRUE(r.covers.push_back({1, 63, 86400_s}));
  r.network = 0x26210F;
  r.level = Retained::StoredLevel{Level::NTC, 7};
  EXPECT_TRUE(r.level_table.push_back({Level::L2, 0}) && r.level_table.push_back({Level::NTC, 7}));
  r.contact = RbcAddress{1, 16383, 0x0123456789FFFFFF};
  r.position.emplace();
  r.position->lrbg = {1, 16383};
  r.position->orientation = 0;
  r.position->single = true;
  r.position->previous = NidLrbg{1, 99};
  r.position->pair_orientation = 1;
  r.position->counter_rising = false;
  r.position->ahead = Distance{-12.25};
  r.position->over = 20_m;
  r.position->under = Distance{1.0 / 3.0 + 12.0};
  r.position->Q_LOCACC = 12_m;
  return r;
}

/// What is kept of a unit that started with it is the same, but for the level that it is not fitted for.
TEST(Retention, AUnitTakesWhatIsRead) {
  const auto state = std::make_unique<State>();
  const auto derived = std::make_unique<Derived>();
  Retained r = everything();
  ASSERT_TRUE(power_up(*state, *derived, {}, r));
  EXPECT_TRUE(retained(*state) == r);
  Config config;
  config.levels.fill(false);
  ASSERT_TRUE(power_up(*state, *derived, config, r));
  r.level.reset();
  EXPECT_TRUE(retained(*state) == r);
}

TEST(Retention, AUnitRefusesWhatNoUnitKeeps) {
  const auto state = std::make_unique<State>();
  const auto derived = std::make_unique<Derived>();
  const auto refused = [&](auto change) {
    Retained r = everything();
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
  EXPECT_TRUE(refused([](auto& r) { r.position->orientation = 3; }));
  EXPECT_TRUE(refused([](auto& r) { r.position->pair_orientation = 3; }));
  EXPECT_TRUE(refused([](auto& r) { r.position->ahead = Distance{1e8}; }));
  EXPECT_TRUE(refused([](auto& r) { r.position->over = Distance{11.0}; }));
  EXPECT_TRUE(refused([](auto& r) { r.position->under = Distance{11.0}; }));
  EXPECT_TRUE(refused([](auto& r) { r.position->Q_LOCACC = Distance{-1.0}; }));
}

}  // namespace
}  // namespace evc::kernel
