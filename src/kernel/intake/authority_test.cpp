#include "kernel/intake/authority.h"

#include <gtest/gtest.h>

#include "kernel/intake/test_message.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_132.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_137.h"
#include "lang/packets/packet_15.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_79.h"
#include "lang/packets/packet_80.h"
#include "lang/packets/packet_88.h"
#include "lang/packets/packet_90.h"

// What an authority needs, brings and ends (3.8, 4.8.3 [4]).
namespace evc::kernel {
namespace {

using test::at;

class Authority : public test::OneMessage {
 protected:
  template <class P>
  static P authority(std::uint16_t length) {
    P p;
    p.Q_SCALE.raw = 1;
    p.L_ENDSECTION.raw = length;
    return p;
  }
  static lang::Packet12 level_1(std::uint8_t V_MAIN = 32) {
    lang::Packet12 p = authority<lang::Packet12>(2000);
    p.V_MAIN.raw = V_MAIN;
    return p;
  }
  void describe_track() {
    EXPECT_TRUE(state.track.gradient.append(at(0.0), {0}));
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 20}));
  }
  void by_balise(Level level = Level::L1) {
    state.level.level = level;
    information.medium = Medium::balise;
  }
};

TEST_F(Authority, NeedsSpeedProfileAndGradientOverItsWholeLength) {  // 4.8.3 [4], 3.7.2.3
  add(authority<lang::Packet15>(2000));
  evaluate_now();
  expect(15, What::packet_refused, "4.8.3 [4]"_srs);
  EXPECT_FALSE(state.track.ma.has_value());
  describe_track();
  evaluate_now();
  expect(15, What::packet_accepted);
  EXPECT_TRUE(happened(What::authority_accepted));
  ASSERT_TRUE(state.track.ma.has_value());
  EXPECT_EQ(state.track.ma->end(), at(2950.0));
}

TEST_F(Authority, OfTheRBCIsNoProceedByBalises) {  // 5.8.4.1
  describe_track();
  add(authority<lang::Packet15>(2000));
  evaluate_now();
  EXPECT_TRUE(received.ma_from_rbc);
  EXPECT_FALSE(received.balise_proceed);
  EXPECT_FALSE(received.trip_order);
}

TEST_F(Authority, OfABaliseIsAProceed) {  // 5.8.4.1
  describe_track();
  by_balise();
  add(level_1());
  evaluate_now();
  EXPECT_FALSE(received.ma_from_rbc);
  EXPECT_TRUE(received.balise_proceed);
  EXPECT_FALSE(received.trip_order);
  EXPECT_FALSE(state.ma_with_trip_order);
}

TEST_F(Authority, WithSignallingSpeed0IsATripOrder) {  // 3.11.6.4
  describe_track();
  by_balise();
  add(level_1(0));
  evaluate_now();
  EXPECT_TRUE(happened(What::trip_ordered));
  EXPECT_TRUE(received.trip_order);
  EXPECT_FALSE(received.balise_proceed);
  EXPECT_EQ(state.ma_with_trip_order, state.track.ma.has_value());
}

TEST_F(Authority, TripsEvenWhereTheAuthorityIsRefused) {  // 3.11.6.4: the speed has a row of its own
  by_balise();
  add(level_1(0));
  evaluate_now();
  EXPECT_FALSE(state.track.ma.has_value());
  EXPECT_TRUE(received.trip_order);
}

TEST_F(Authority, DoesNotTripWhereTheSpeedIsRefused) {  // 4.8.3: signalling speed in level 2
  describe_track();
  by_balise(Level::L2);
  add(level_1(0));
  evaluate_now();
  EXPECT_FALSE(happened(What::trip_ordered));
  EXPECT_FALSE(received.trip_order);
}

TEST_F(Authority, IsBufferedWithWhatBelongsToIt) {  // 4.8.5, 4.8.3 [1]
  describe_track();
  by_balise(Level::L2);
  state.level_transition.pending.emplace().to.level = Level::L1;
  add(lang::Packet21{});
  add(level_1());
  add(lang::Packet80{});
  const Waiting waiting = evaluate_now();
  EXPECT_EQ(waiting.packets, 7u);
  EXPECT_FALSE(state.track.ma.has_value());
}

TEST_F(Authority, OnlyWhatWaitsIsBufferedAgain) {  // 4.8.5
  describe_track();
  by_balise(Level::L2);
  state.level_transition.pending.emplace().to.level = Level::L1;
  add(lang::Packet80{});
  add(level_1());
  add(lang::Packet80{});
  information.judge_packets = 6;
  EXPECT_EQ(evaluate_now().packets, 6u);
  information.judge_packets = 3;
  EXPECT_EQ(evaluate_now().packets, 3u);
}

TEST_F(Authority, ThatCannotBeReadIsRefusedWithWhatBelongsToIt) {  // 3.16.1.1: gather() lets none of them through
  describe_track();
  add(authority<lang::Packet15>(2000));
  add(lang::Packet80{});
  information.packets[0].Q_DIR = 0;
  evaluate_now();
  expect(15, What::packet_refused, "3.16.1.1"_srs);
  expect(80, What::packet_refused, "3.16.1.1"_srs);
  EXPECT_FALSE(state.track.ma.has_value());
}

TEST_F(Authority, EndsTheReasonOfARequest) {  // 3.8.2.7.3
  describe_track();
  state.track_description_deleted = true;
  add(authority<lang::Packet15>(2000));
  evaluate_now();
  EXPECT_FALSE(state.track_description_deleted);
}

TEST_F(Authority, ThatEndsEarlierDeletesWhatIsBeyond) {  // 3.8.5.1.3, A.3.4
  describe_track();
  add(authority<lang::Packet15>(3000));
  evaluate_now();
  ASSERT_TRUE(happened(What::authority_accepted));
  balise::Link near, far;
  near.place = at(1500.0);
  far.place = at(3500.0);
  ASSERT_TRUE(state.balise.linking.links.push_back(near));
  ASSERT_TRUE(state.balise.linking.links.push_back(far));
  state.pending_national_values.emplace().from = at(3500.0);
  information.packets.clear();
  add(authority<lang::Packet15>(1000));
  evaluate_now();
  ASSERT_TRUE(happened(What::authority_accepted));
  EXPECT_EQ(state.balise.linking.links.size(), 1u);
  EXPECT_FALSE(state.pending_national_values.has_value());
  EXPECT_TRUE(happened(What::packet_shortened));
}

TEST_F(Authority, StopsOfShuntingAndStaffResponsible) {  // 4.4.8, 4.4.11
  by_balise();
  lang::Packet137 sr;
  lang::Packet132 sh;
  const auto received_with = [&](std::uint8_t Q_SRSTOP, std::uint8_t Q_ASPECT) {
    received.stop_if_in_SR = received.stop_if_in_SH = false;
    information.packets.clear();
    sr.Q_SRSTOP.raw = Q_SRSTOP;
    sh.Q_ASPECT.raw = Q_ASPECT;
    state.mode = Mode::SR;
    add(sr);
    evaluate_now();
    information.packets.clear();
    state.mode = Mode::SH;
    add(sh);
    evaluate_now();
    return std::pair(received.stop_if_in_SR, received.stop_if_in_SH);
  };
  EXPECT_EQ(received_with(0, 0), std::pair(true, true));
  EXPECT_EQ(received_with(1, 0), std::pair(false, true));
  EXPECT_EQ(received_with(0, 1), std::pair(true, false));
  EXPECT_EQ(received_with(1, 1), std::pair(false, false));
}

TEST_F(Authority, NamesTheBorderUpToWhichTheTrackIsFree) {  // 7.4.2.20, 3.8.2.3
  by_balise();
  state.level_transition.pending.emplace().to.level = Level::L2;
  lang::Packet90 p;
  p.NID_BG.raw = 77;
  add(p);
  evaluate_now();
  EXPECT_EQ(received.NID_LTRBG, (1u << 14) | 77u);
}

TEST_F(Authority, HasTheModeProfileOfItsMessageInAnyPlace) {  // 3.12.4, 8.4.1.3
  describe_track();
  lang::Packet80 profile;
  profile.Q_SCALE.raw = 1;
  profile.D_MAMODE.raw = 500;
  profile.L_MAMODE.raw = 300;
  add(profile);
  add(authority<lang::Packet15>(2000));
  evaluate_now();
  ASSERT_TRUE(happened(What::authority_accepted));
  ASSERT_EQ(state.track.mode_profile.size(), 1u);
  EXPECT_EQ(state.track.mode_profile[0].from, at(1450.0));
}

TEST_F(Authority, WithTheSpeed0IsNoOrderBeyondAnInfillReference) {  // 3.11.6.4
  describe_track();
  by_balise();
  balise::Link link;
  link.id = {1, 101};
  link.place = at(1450.0);
  ASSERT_TRUE(state.balise.linking.links.push_back(link));
  lang::Packet136 reference;
  reference.NID_BG.raw = 101;
  add(reference);
  add(level_1(0));
  evaluate_now();
  EXPECT_FALSE(happened(What::infill_refused));
  EXPECT_FALSE(happened(What::trip_ordered));
  EXPECT_FALSE(received.trip_order);
}

TEST_F(Authority, ThatIsNoShorteningDeletesNothingBeyond) {  // 3.8.5.1
  describe_track();
  balise::Link far;
  far.place = at(3500.0);
  ASSERT_TRUE(state.balise.linking.links.push_back(far));
  add(authority<lang::Packet15>(1000));
  evaluate_now();
  ASSERT_TRUE(happened(What::authority_accepted));
  EXPECT_FALSE(happened(What::packet_shortened));
  EXPECT_EQ(state.balise.linking.links.size(), 1u);
  expect(15, What::packet_accepted);
}

TEST_F(Authority, HasTheSignallingSpeedOfItsPacketOnly) {  // 3.11.6.4
  describe_track();
  by_balise();
  add(level_1());
  evaluate_now();
  EXPECT_EQ(state.track.signalling.size(), 1u);
  information.packets.clear();
  add(level_1(0));
  evaluate_now();
  EXPECT_TRUE(received.trip_order);
  received.trip_order = false;
  state.level.level = Level::L2;
  information.medium = Medium::rbc;
  information.packets.clear();
  add(authority<lang::Packet15>(2000));
  evaluate_now();
  EXPECT_TRUE(happened(What::authority_accepted));
  EXPECT_FALSE(received.trip_order);
}

TEST_F(Authority, AMessageOfWhichNothingWasRefusedIsAccepted) {  // 3.8.5.1.3: a shortening is no refusal
  describe_track();
  set_message(lang::Message3{});
  add(authority<lang::Packet15>(3000));
  evaluate_now();
  EXPECT_TRUE(happened(What::message_accepted));
  information.packets.clear();
  add(authority<lang::Packet15>(1000));
  evaluate_now();
  EXPECT_TRUE(happened(What::packet_shortened));
  EXPECT_TRUE(happened(What::message_accepted));
  EXPECT_FALSE(happened(What::authority_refused));
}

/// An infill authority for group 101, which lies at 1450 m.
class InfillAuthority : public Authority {
 protected:
  InfillAuthority() {
    describe_track();
    by_balise();
    balise::Link link;
    link.id = {1, 101};
    link.place = at(1450.0);
    EXPECT_TRUE(state.balise.linking.links.push_back(link));
    set_message(lang::Message37{});
  }
  void receive_infill() {
    lang::Packet136 reference;
    reference.NID_BG.raw = 101;
    add(reference);
    add(level_1());
    evaluate_now();
  }
};

TEST_F(InfillAuthority, IsRefusedWithoutAnAuthority) {  // 3.8.5.1 b
  receive_infill();
  EXPECT_TRUE(happened(What::authority_refused));
  EXPECT_TRUE(happened(What::packet_refused));
  EXPECT_TRUE(happened(What::message_refused));
  EXPECT_FALSE(state.track.ma.has_value());
}

TEST_F(InfillAuthority, IsRefusedWithoutRoomForItsSections) {  // 3.8.5.1 b: the old one stays
  track::MovementAuthority& ma = state.track.ma.emplace();
  for (double x = 0.0; !ma.sections.full(); x += 10.0) ASSERT_TRUE(ma.sections.push_back({at(x), at(x + 10.0)}));
  ma.sections.back().end = at(10000.0);  // beyond the infill reference
  const Place end = ma.end();
  receive_infill();
  EXPECT_TRUE(happened(What::packet_refused_no_room));
  EXPECT_TRUE(happened(What::message_refused_no_room));
  EXPECT_FALSE(happened(What::message_refused));
  EXPECT_EQ(state.track.ma->end(), end);
}

TEST_F(Authority, WithoutOneNoneIsRefused) {  // 3.7.2.3
  add(lang::Packet21{});
  evaluate_now();
  EXPECT_FALSE(happened(What::authority_refused));
  EXPECT_FALSE(happened(What::authority_accepted));
}

TEST_F(Authority, WhatLiesBeyondARestrictionThatFoundNoRoomIsDeleted) {  // 3.7.2.3, A.3.4
  describe_track();
  for (std::uint8_t i = 0; !state.track.lx.full(); ++i) {
    track::LevelCrossing lx;
    lx.NID_LX = i;
    lx.from = at(1200.0);
    ASSERT_TRUE(state.track.lx.push_back(lx));
  }
  for (const double place : {1500.0, 2500.0}) {
    balise::Link link;
    link.place = at(place);
    ASSERT_TRUE(state.balise.linking.links.push_back(link));
  }
  lang::Packet88 crossing;
  crossing.Q_SCALE.raw = 1;
  crossing.NID_LX.raw = 99;
  crossing.D_LX.raw = 1000;  // at 1950 m
  crossing.Q_LXSTATUS.raw = 1;
  add(crossing);
  evaluate_now();
  EXPECT_TRUE(happened(What::track_description_ended));
  ASSERT_EQ(state.balise.linking.links.size(), 1u);
  EXPECT_EQ(state.balise.linking.links[0].place, at(1500.0));
}

TEST_F(Authority, TheLogNamesWhatFoundNoRoom) {  // 3.7.3.1
  describe_track();
  lang::Packet65 restriction;
  restriction.L_TSR.raw = 10;
  for (std::uint8_t i = 0; i < lang::kPacketsMax; ++i) {
    restriction.NID_TSR.raw = i;
    add(restriction);
  }
  evaluate_now();
  EXPECT_TRUE(happened(What::packet_no_room));
}

TEST_F(Authority, AGeographicalPositionCountsFromTheGroupReportedLast) {  // 3.6.6.4.1
  for (const std::uint16_t NID_BG : {std::uint16_t{102}, std::uint16_t{100}, std::uint16_t{101}}) {
    position::Reference group;
    group.id = {1, NID_BG};
    group.place = at(700.0 + NID_BG);
    group.orientation = Direction::nominal;
    group.reported = NID_BG != 101;
    ASSERT_TRUE(state.position.references.push_back(group));
  }
  lang::Packet79 p;
  p.Q_SCALE.raw = 1;
  p.Q_NEWCOUNTRY.raw = 1;
  p.NID_C.raw = 1;
  p.NID_BG.raw = 100;
  p.D_POSOFF.raw = 20;
  for (const std::uint16_t NID_BG : {std::uint16_t{101}, std::uint16_t{102}}) {
    lang::Packet79_references more;
    more.NID_BG.raw = NID_BG;
    more.D_POSOFF.raw = 20;
    ASSERT_TRUE(p.references.push_back(more));
  }
  add(p);
  evaluate_now();
  ASSERT_EQ(state.track.geo.size(), 3u);
  EXPECT_EQ(state.track.geo[0].applies_from, at(820.0));
  EXPECT_EQ(state.track.geo[1].applies_from, std::nullopt) << "it was not reported";
  EXPECT_EQ(state.track.geo[2].applies_from, std::nullopt) << "it was reported before";
}

TEST_F(Authority, ThatShortensKeepsWhatItsMessageBringsItself) {  // 3.8.5.1.3, 3.8.5.1.5 of 4.0.0
  for (const bool brings : {true, false}) {
    state.track = {};
    describe_track();
    by_balise();
    ASSERT_TRUE(state.track.ma.emplace().sections.push_back({at(0.0), at(9000.0)}));
    state.pending_national_values.emplace().from = at(4000.0);
    information.packets.clear();
    add(level_1());
    lang::Packet3 values;
    values.Q_SCALE.raw = 1;
    values.D_VALIDNV.raw = 4000;
    if (brings) add(values);
    evaluate_now();
    EXPECT_EQ(state.track.ma->end(), at(2950.0));
    EXPECT_EQ(state.pending_national_values.has_value(), brings);
  }
}

}  // namespace
}  // namespace evc::kernel
