#pragma once
#include <gtest/gtest.h>

#include "kernel/evc.h"

// What survives power-off, for the tests of the kernel and of its file.
namespace evc::kernel {

/// Other than a default in every member.
inline Retained everything_retained() {
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
  EXPECT_TRUE(r.covers.push_back({1, 63, 86400_s, 1, 1'795'000'000}));
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
  r.position->cab_B = true;
  r.position->ahead = Distance{-12.25};
  r.position->over = 20_m;
  r.position->under = Distance{1.0 / 3.0 + 12.0};
  r.position->Q_LOCACC = 12_m;
  return r;
}

}  // namespace evc::kernel
