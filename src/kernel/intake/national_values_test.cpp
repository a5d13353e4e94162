#include "kernel/intake/national_values.h"

#include <gtest/gtest.h>

#include <array>

#include "kernel/intake/test_message.h"
#include "lang/packets/packet_203.h"
#include "lang/packets/packet_3.h"

namespace evc::kernel {
namespace {

/// A packet 3 with seven steps of Kr_int, of which five find room.
lang::Packet3 with_seven_steps(std::uint8_t lowest_at) {
  lang::Packet3 p;
  p.Q_NVKINT.raw = 1;
  p.M_NVKRINT.raw = 20;
  for (std::uint8_t i = 1; i < 7; ++i) {
    lang::Packet3_kr_steps step;
    step.L_NVKRINT.raw = i;
    step.M_NVKRINT.raw = i == lowest_at ? 10 : static_cast<std::uint8_t>(18 - i);  // equal ones would join
    EXPECT_TRUE(p.kr_steps.push_back(step));
  }
  return p;
}

TEST(NationalValues, MoreStepsThanThereIsRoomForGiveTheLowestEverywhere) {  // 3.13.2.3.7.11
  for (const std::uint8_t lowest_at : {std::uint8_t{1}, std::uint8_t{6}}) {
    const train::NationalValues nv = read(with_seven_steps(lowest_at), 2).set.values;
    ASSERT_EQ(nv.Kr_int.size(), 1u);
    EXPECT_DOUBLE_EQ(nv.Kr_int.steps.front().value, 0.5);
    EXPECT_EQ(nv.Kr_int.steps.front().from, Distance{});
  }
}

/// Packet 3 with every value other than the default and than every other one.
lang::Packet3 with_all_values() {
  lang::Packet3 p;
  p.Q_SCALE.raw = 1;
  p.D_VALIDNV.raw = 500;
  p.NID_C.raw = 11;
  EXPECT_TRUE(p.areas.push_back({lang::var::NID_C{12}}));
  EXPECT_TRUE(p.areas.push_back({lang::var::NID_C{13}}));
  p.V_NVSHUNT.raw = 1;
  p.V_NVSTFF.raw = 2;
  p.V_NVONSIGHT.raw = 3;
  p.V_NVLIMSUPERV.raw = 4;
  p.V_NVUNFIT.raw = 5;
  p.V_NVREL.raw = 6;
  p.V_NVALLOWOVTRP.raw = 7;
  p.V_NVSUPOVTRP.raw = 8;
  p.D_NVROLL.raw = 21;
  p.D_NVOVTRP.raw = 22;
  p.D_NVPOTRP.raw = 23;
  p.D_NVSTFF.raw = 24;
  p.T_NVOVTRP.raw = 31;
  p.T_NVCONTACT.raw = 32;
  p.Q_NVLOCACC.raw = 33;
  p.M_NVCONTACT.raw = 1;
  p.A_NVMAXREDADH1.raw = 10;
  p.A_NVMAXREDADH2.raw = 11;
  p.A_NVMAXREDADH3.raw = 12;
  p.M_NVAVADH.raw = 13;
  p.M_NVEBCL.raw = 4;
  return p;
}

TEST(NationalValues, AreTheValuesOfThePacket) {  // 7.4.2.1, 7.5.1
  const ReceivedNationalValues r = read(with_all_values(), 2);
  const train::NationalValues& nv = r.set.values;
  const auto kmh = [](double v) { return Speed{v / 3.6}; };
  EXPECT_EQ(nv.V_NVSHUNT, kmh(5.0));
  EXPECT_EQ(nv.V_NVSTFF, kmh(10.0));
  EXPECT_EQ(nv.V_NVONSIGHT, kmh(15.0));
  EXPECT_EQ(nv.V_NVLIMSUPERV, kmh(20.0));
  EXPECT_EQ(nv.V_NVUNFIT, kmh(25.0));
  EXPECT_EQ(nv.V_NVREL, kmh(30.0));
  EXPECT_EQ(nv.V_NVALLOWOVTRP, kmh(35.0));
  EXPECT_EQ(nv.V_NVSUPOVTRP, kmh(40.0));
  EXPECT_EQ(nv.D_NVROLL, Distance{21.0});
  EXPECT_EQ(nv.D_NVOVTRP, Distance{22.0});
  EXPECT_EQ(nv.D_NVPOTRP, Distance{23.0});
  EXPECT_EQ(nv.D_NVSTFF, Distance{24.0});
  EXPECT_EQ(nv.T_NVOVTRP, Duration{31.0});
  EXPECT_EQ(nv.T_NVCONTACT, Duration{32.0});
  EXPECT_EQ(nv.Q_NVLOCACC, Distance{33.0});
  EXPECT_EQ(nv.M_NVCONTACT, Reaction::service_brake);
  EXPECT_EQ(nv.A_NVMAXREDADH1, train::MaxReducedAdhesion::at_most({0.5}));
  EXPECT_EQ(nv.A_NVMAXREDADH2, train::MaxReducedAdhesion::at_most({0.55}));
  EXPECT_EQ(nv.A_NVMAXREDADH3, train::MaxReducedAdhesion::at_most({0.6}));
  EXPECT_DOUBLE_EQ(nv.M_NVAVADH, 0.65);
  EXPECT_EQ(nv.M_NVEBCL, 4);
  EXPECT_EQ(r.D_VALIDNV, Distance{500.0});
  ASSERT_EQ(r.set.areas.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(r.set.areas[i], 11 + i);
}

TEST(NationalValues, InfiniteDistancesAndTimes) {  // 7.5.1.17, 7.5.1.18, 7.5.1.29, 7.5.1.147
  lang::Packet3 p = with_all_values();
  p.D_VALIDNV.raw = 32767;
  p.D_NVROLL.raw = 32767;
  p.D_NVSTFF.raw = 32767;
  p.T_NVCONTACT.raw = 255;
  const ReceivedNationalValues r = read(p, 2);
  EXPECT_EQ(r.D_VALIDNV, std::nullopt);
  EXPECT_GE(r.set.values.D_NVROLL, Distance{1e9});
  EXPECT_EQ(r.set.values.D_NVSTFF, std::nullopt);
  EXPECT_EQ(r.set.values.T_NVCONTACT, std::nullopt);
}

TEST(NationalValues, InVersionOneEveryStartOfValidityIsADistance) {  // 6.5.1.5.26
  lang::Packet3 p = with_all_values();
  for (const std::uint16_t code : std::array<std::uint16_t, 3>{0, 500, 32767}) {
    p.D_VALIDNV.raw = code;
    EXPECT_EQ(read(p, 1).D_VALIDNV, Distance{static_cast<double>(code)});
    p.Q_SCALE.raw = 2;
    EXPECT_EQ(start_of_validity(p, 1), Distance{10.0 * code});
    p.Q_SCALE.raw = 1;
  }
}

TEST(NationalValues, EachPermissionIsItsOwnBit) {  // 7.5.1
  lang::Packet3 off = with_all_values();
  using NV = train::NationalValues;
  using P = lang::Packet3;
  const auto check = [&](auto variable, bool NV::*value) {
    P on = off;
    (on.*variable).raw = 1;
    for (bool NV::*each : {&NV::M_NVDERUN, &NV::Q_NVDRIVER_ADHES, &NV::Q_NVSBTSMPERM, &NV::Q_NVEMRRLS, &NV::Q_NVGUIPERM,
                           &NV::Q_NVSBFBPERM, &NV::Q_NVINHSMICPERM}) {
      EXPECT_FALSE(read(off, 2).set.values.*each);
      EXPECT_EQ(read(on, 2).set.values.*each, each == value);
    }
  };
  check(&P::M_NVDERUN, &NV::M_NVDERUN);
  check(&P::Q_NVDRIVER_ADHES, &NV::Q_NVDRIVER_ADHES);
  check(&P::Q_NVSBTSMPERM, &NV::Q_NVSBTSMPERM);
  check(&P::Q_NVEMRRLS, &NV::Q_NVEMRRLS);
  check(&P::Q_NVGUIPERM, &NV::Q_NVGUIPERM);
  check(&P::Q_NVSBFBPERM, &NV::Q_NVSBFBPERM);
  check(&P::Q_NVINHSMICPERM, &NV::Q_NVINHSMICPERM);
}

TEST(NationalValues, MaximumDecelerationsThatAreNone) {  // 7.5.1.2
  using train::MaxReducedAdhesion;
  lang::Packet3 p;
  p.A_NVMAXREDADH1.raw = 61;
  p.A_NVMAXREDADH2.raw = 62;
  p.A_NVMAXREDADH3.raw = 63;
  const train::NationalValues nv = read(p, 2).set.values;
  EXPECT_EQ(nv.A_NVMAXREDADH1, MaxReducedAdhesion::without_maximum(MaxReducedAdhesion::Display::target_information));
  EXPECT_EQ(nv.A_NVMAXREDADH2, MaxReducedAdhesion::without_maximum(MaxReducedAdhesion::Display::time_to_indication));
  EXPECT_EQ(nv.A_NVMAXREDADH3, MaxReducedAdhesion::without_maximum(MaxReducedAdhesion::Display::none));
  p.A_NVMAXREDADH1.raw = 60;
  EXPECT_EQ(read(p, 2).set.values.A_NVMAXREDADH1, MaxReducedAdhesion::at_most({3.0}));
}

TEST(NationalValues, CorrectionFactorsOfBothSets) {  // 3.13.2.3.7, A.3.7, 7.5.1.50, 7.5.1.75
  lang::Packet3 p;
  p.Q_NVKINT.raw = 1;
  p.Q_NVKVINTSET.raw = 1;  // conventional passenger trains
  p.A_NVP12.raw = 10;
  p.A_NVP23.raw = 20;
  p.M_NVKVINT_A.raw = 40;
  p.M_NVKVINT_B.raw = 35;
  lang::Packet3_kv_steps step;
  step.V_NVKVINT.raw = 20;
  step.M_NVKVINT_A.raw = 30;
  step.M_NVKVINT_B.raw = 25;
  ASSERT_TRUE(p.kv_steps.push_back(step));
  lang::Packet3_kv_sets freight;
  freight.Q_NVKVINTSET.raw = 0;
  freight.A_NVP12.raw = 1;
  freight.A_NVP23.raw = 2;
  freight.M_NVKVINT_A.raw = 45;
  step.V_NVKVINT.raw = 16;
  step.M_NVKVINT_A.raw = 20;
  ASSERT_TRUE(freight.kv_steps.push_back(step));
  ASSERT_TRUE(p.kv_sets.push_back(freight));
  p.M_NVKRINT.raw = 18;
  p.M_NVKTINT.raw = 24;
  const train::NationalValues nv = read(p, 2).set.values;
  EXPECT_EQ(nv.A_NVP12, Acceleration{0.5});
  EXPECT_EQ(nv.A_NVP23, Acceleration{1.0});
  ASSERT_EQ(nv.Kv_int_passenger.size(), 2u);
  EXPECT_EQ(nv.Kv_int_passenger.steps[0].from, Speed{});
  EXPECT_EQ(nv.Kv_int_passenger.steps[0].value, (train::KvPair{0.8, 0.7}));
  EXPECT_EQ(nv.Kv_int_passenger.steps[1].from, Speed{100.0 / 3.6});
  EXPECT_EQ(nv.Kv_int_passenger.steps[1].value, (train::KvPair{0.6, 0.5}));
  ASSERT_EQ(nv.Kv_int_freight.size(), 2u);
  EXPECT_DOUBLE_EQ(nv.Kv_int_freight.steps[0].value, 0.9);
  EXPECT_EQ(nv.Kv_int_freight.steps[1].from, Speed{80.0 / 3.6});
  EXPECT_DOUBLE_EQ(nv.Kv_int_freight.steps[1].value, 0.4);
  EXPECT_DOUBLE_EQ(nv.Kr_int.at({}), 0.9);
  EXPECT_DOUBLE_EQ(nv.Kt_int, 1.2);
}

/// A packet 203 with the values of a packet 3 that both have.
lang::Packet203 in_packet_203(const lang::Packet3& p) {
  lang::Packet203 q;
  q.Q_NVGUIPERM = p.Q_NVGUIPERM;
  q.Q_NVSBFBPERM = p.Q_NVSBFBPERM;
  q.Q_NVINHSMICPERM = p.Q_NVINHSMICPERM;
  q.A_NVMAXREDADH1 = p.A_NVMAXREDADH1;
  q.A_NVMAXREDADH2 = p.A_NVMAXREDADH2;
  q.A_NVMAXREDADH3 = p.A_NVMAXREDADH3;
  q.M_NVAVADH = p.M_NVAVADH;
  q.M_NVEBCL = p.M_NVEBCL;
  q.Q_NVKINT = p.Q_NVKINT;
  q.Q_NVKVINTSET = p.Q_NVKVINTSET;
  q.A_NVP12 = p.A_NVP12;
  q.A_NVP23 = p.A_NVP23;
  q.V_NVKVINT = p.V_NVKVINT;
  q.M_NVKVINT_A = p.M_NVKVINT_A;
  q.M_NVKVINT_B = p.M_NVKVINT_B;
  q.kv_steps = p.kv_steps;
  q.kv_sets = p.kv_sets;
  q.L_NVKRINT = p.L_NVKRINT;
  q.M_NVKRINT = p.M_NVKRINT;
  q.kr_steps = p.kr_steps;
  q.M_NVKTINT = p.M_NVKTINT;
  return q;
}

class BrakingCurves : public test::OneMessage {};

TEST_F(BrakingCurves, OfPacket203ReadAsThoseOfPacket3) {  // 6.6.3.2.3 [2], [16]
  lang::Packet3 p = with_all_values();
  p.Q_NVGUIPERM.raw = p.Q_NVINHSMICPERM.raw = 1;
  p.Q_NVKINT.raw = p.Q_NVKVINTSET.raw = 1;
  p.A_NVP12.raw = 10;
  p.A_NVP23.raw = 20;
  p.M_NVKVINT_A.raw = 40;
  p.M_NVKVINT_B.raw = 35;
  lang::Packet3_kv_sets freight;
  freight.M_NVKVINT_A.raw = 45;
  ASSERT_TRUE(p.kv_sets.push_back(freight));
  p.L_NVKRINT.raw = 0;
  p.M_NVKRINT.raw = 18;
  lang::Packet3_kr_steps step;
  step.L_NVKRINT.raw = 3;
  step.M_NVKRINT.raw = 15;
  ASSERT_TRUE(p.kr_steps.push_back(step));
  p.M_NVKTINT.raw = 24;
  train::NationalValues values;
  EXPECT_FALSE(join_braking_curves(information, values));
  EXPECT_EQ(values, train::NationalValues{});
  add(in_packet_203(p));
  information.packets[0].sv = {1, 1};
  ASSERT_TRUE(join_braking_curves(information, values));
  const train::NationalValues same = read(p, 2).set.values;
  EXPECT_EQ(values.Q_NVGUIPERM, same.Q_NVGUIPERM);
  EXPECT_EQ(values.Q_NVSBFBPERM, same.Q_NVSBFBPERM);
  EXPECT_EQ(values.Q_NVINHSMICPERM, same.Q_NVINHSMICPERM);
  EXPECT_EQ(values.A_NVMAXREDADH1, same.A_NVMAXREDADH1);
  EXPECT_EQ(values.A_NVMAXREDADH2, same.A_NVMAXREDADH2);
  EXPECT_EQ(values.A_NVMAXREDADH3, same.A_NVMAXREDADH3);
  EXPECT_EQ(values.M_NVAVADH, same.M_NVAVADH);
  EXPECT_EQ(values.M_NVEBCL, same.M_NVEBCL);
  EXPECT_EQ(values.Kv_int_passenger, same.Kv_int_passenger);
  EXPECT_EQ(values.Kv_int_freight, same.Kv_int_freight);
  EXPECT_EQ(values.A_NVP12, same.A_NVP12);
  EXPECT_EQ(values.A_NVP23, same.A_NVP23);
  EXPECT_EQ(values.Kr_int, same.Kr_int);
  EXPECT_EQ(values.Kr_int.at(Distance{100.0}), 0.75);
  EXPECT_EQ(values.Kt_int, 1.2);
}

TEST(NationalValues, CorrectionFactorsStayTheDefaultsWhereThePacketHasNone) {  // A.3.2
  lang::Packet3 p = with_all_values();
  p.Q_NVKVINTSET.raw = 1;
  p.M_NVKVINT_A.raw = 40;
  p.M_NVKRINT.raw = 10;
  const train::NationalValues nv = read(p, 2).set.values;
  const train::NationalValues defaults;
  EXPECT_EQ(nv.Kv_int_passenger, defaults.Kv_int_passenger);
  EXPECT_EQ(nv.Kr_int, defaults.Kr_int);
  EXPECT_EQ(nv.Kt_int, defaults.Kt_int);
}

TEST(NationalValues, StepsThatFindRoomStayAsTheyAre) {
  lang::Packet3 p = with_seven_steps(2);
  while (p.kr_steps.size() > 4) p.kr_steps.pop_back();
  const train::NationalValues nv = read(p, 2).set.values;
  ASSERT_EQ(nv.Kr_int.size(), 5u);
  EXPECT_DOUBLE_EQ(nv.Kr_int.steps[0].value, 1.0);
  EXPECT_DOUBLE_EQ(nv.Kr_int.steps[2].value, 0.5);
}

/// Values in force that differ from the defaults, received for country 1.
NationalSet of_country_1() {
  NationalSet set;
  train::NationalValues& nv = set.values;
  nv.Q_NVGUIPERM = !nv.Q_NVGUIPERM;
  nv.Q_NVSBFBPERM = !nv.Q_NVSBFBPERM;
  nv.Q_NVINHSMICPERM = !nv.Q_NVINHSMICPERM;
  nv.M_NVAVADH = 0.35;
  nv.A_NVMAXREDADH1 = train::MaxReducedAdhesion::at_most({0.1});
  nv.A_NVMAXREDADH2 = train::MaxReducedAdhesion::at_most({0.2});
  nv.A_NVMAXREDADH3 = train::MaxReducedAdhesion::at_most({0.3});
  nv.Kv_int_freight = {};
  EXPECT_TRUE(nv.Kv_int_freight.append({}, 0.5));
  nv.Kv_int_passenger = {};
  EXPECT_TRUE(nv.Kv_int_passenger.append({}, {0.6, 0.7}));
  nv.A_NVP12 = {0.8};
  nv.A_NVP23 = {0.9};
  nv.Kr_int = {};
  EXPECT_TRUE(nv.Kr_int.append({}, 0.4));
  set.values.V_NVSTFF = Speed{7.0};
  set.values.V_NVLIMSUPERV = Speed{8.0};
  set.values.Q_NVLOCACC = Distance{9.0};
  set.values.M_NVEBCL = 3;
  set.values.Kt_int = 1.5;
  EXPECT_TRUE(set.areas.push_back(1));
  return set;
}

class NationalValuesInForce : public test::OneMessage {};

TEST_F(NationalValuesInForce, WhatASetDoesNotContainStays) {  // 6.6.3.2.3 [1b], [2]
  use_national_values(state, of_country_1());
  NationalSet set;
  EXPECT_TRUE(set.areas.push_back(2));
  set.of_X_2 = set.braking = false;
  use_national_values(state, set);
  EXPECT_EQ(state.national_values.V_NVSTFF, train::NationalValues{}.V_NVSTFF);
  EXPECT_EQ(state.national_values.V_NVLIMSUPERV, Speed{8.0});
  EXPECT_EQ(state.national_values.Q_NVLOCACC, Distance{9.0});
  EXPECT_EQ(state.national_values.M_NVEBCL, 3);
  EXPECT_EQ(state.national_values.Kt_int, 1.5);
  train::NationalValues expected = of_country_1().values;
  expected.V_NVSTFF = train::NationalValues{}.V_NVSTFF;
  EXPECT_EQ(state.national_values, expected);
  EXPECT_TRUE(in_another_country(state, 1));
  EXPECT_FALSE(in_another_country(state, 2));
}

TEST_F(NationalValuesInForce, EachPartIsDeletedOutsideItsOwnCountry) {  // 3.18.2.5, 3.18.2.6
  const train::NationalValues defaults;
  for (const std::uint16_t NID_C : {std::uint16_t{1}, std::uint16_t{2}}) {
    use_national_values(state, of_country_1());
    NationalSet set;
    set.values.V_NVSTFF = Speed{6.0};
    EXPECT_TRUE(set.areas.push_back(2));
    set.of_X_2 = set.braking = false;
    use_national_values(state, set);
    leave_area(reception, NID_C);
    EXPECT_EQ(state.national_values.V_NVSTFF, NID_C == 2 ? Speed{6.0} : defaults.V_NVSTFF);
    EXPECT_EQ(state.national_values.Q_NVLOCACC, NID_C == 1 ? Distance{9.0} : defaults.Q_NVLOCACC);
    EXPECT_EQ(state.national_values.V_NVLIMSUPERV, NID_C == 1 ? Speed{8.0} : defaults.V_NVLIMSUPERV);
    EXPECT_EQ(state.national_values.M_NVEBCL, NID_C == 1 ? 3 : defaults.M_NVEBCL);
    EXPECT_EQ(state.national_values.Kt_int, NID_C == 1 ? 1.5 : defaults.Kt_int);
  }
}

TEST_F(NationalValuesInForce, WhereAPartIsDeletedItsAreasAreToo) {  // 3.18.2.5
  use_national_values(state, of_country_1());
  leave_area(reception, 2);
  EXPECT_TRUE(happened(What::national_values_default));
  EXPECT_TRUE(state.national_areas.empty());
  EXPECT_TRUE(state.national_areas_of_X_2.empty());
  EXPECT_TRUE(state.national_areas_of_braking.empty());
  use_national_values(state, of_country_1());
  NationalSet set;
  EXPECT_TRUE(set.areas.push_back(2));
  set.of_X_2 = set.braking = false;
  use_national_values(state, set);
  leave_area(reception, 1);
  EXPECT_TRUE(state.national_areas.empty());
  EXPECT_FALSE(state.national_areas_of_X_2.empty());
  EXPECT_FALSE(state.national_areas_of_braking.empty());
  out = {};
  leave_area(reception, 1);
  EXPECT_FALSE(happened(What::national_values_default)) << "once";
}

class NationalValuesAhead : public test::OneMessage {};

TEST_F(NationalValuesAhead, AreInForceFromTheirPlaceOn) {  // 3.18.2.9
  PendingNationalValues& pending = state.pending_national_values.emplace();
  pending.set.values.V_NVSTFF = Speed{7.0};
  pending.from = test::at(1000.5);
  const std::uint32_t revision = state.revision;
  advance_national_values(reception);
  EXPECT_FALSE(happened(What::national_values_in_force));
  EXPECT_EQ(state.revision, revision);
  pending.from = received.here.est_front;
  advance_national_values(reception);
  EXPECT_TRUE(happened(What::national_values_in_force));
  EXPECT_EQ(state.national_values.V_NVSTFF, Speed{7.0});
  EXPECT_NE(state.revision, revision) << "the curves are built again";
  EXPECT_FALSE(state.pending_national_values.has_value());
}

}  // namespace
}  // namespace evc::kernel
