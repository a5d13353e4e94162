#include "kernel/intake/filter.h"

#include <gtest/gtest.h>

#include "kernel/intake/test_message.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_13.h"
#include "lang/packets/packet_131.h"
#include "lang/packets/packet_132.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_15.h"
#include "lang/packets/packet_180.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_46.h"
#include "lang/packets/packet_49.h"
#include "lang/packets/packet_5.h"
#include "lang/packets/packet_58.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_76.h"
#include "lang/packets/packet_79.h"
#include "lang/packets/packet_80.h"

// The facts that the unit gives to the filters of level and mode (4.8), and the order in which a message is evaluated.
namespace evc::kernel {
namespace {

using test::at;

class Filter : public test::OneMessage {
 protected:
  void take_SR_authorisation() {
    set_message(lang::Message2{});
    evaluate_now();
  }
};

constexpr std::uint16_t kNow = 32767;  // D_LEVELTR: at once

TEST_F(Filter, RefusesTrackDataUntilTheTrainDataAreAcknowledged) {  // 4.8.3 [3]
  add(lang::Packet21{});
  evaluate_now();
  expect(21, What::packet_accepted);
  state.radio.supervising.train_data_stamp = 17;
  evaluate_now();
  expect(21, What::packet_refused, "4.8.3 [3]"_srs);
}

TEST_F(Filter, RefusesAnAuthorityDuringAnEmergencyStop) {  // 4.8.3 [5]
  lang::Packet15 p;
  p.L_ENDSECTION.raw = 500;
  add(p);
  ASSERT_TRUE(state.emergency_stops.pending.push_back({1, true, at(3000.0)}));
  ASSERT_TRUE(state.track.gradient.append(at(0.0), {0}));
  ASSERT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 20}));
  evaluate_now();
  expect(15, What::packet_refused, "4.8.3 [5]"_srs);
}

TEST_F(Filter, RefusesARevocableRestrictionOfABaliseWhileTheRbcInhibitsThem) {  // 4.8.3 [8]
  const auto refuses = [this](Medium medium, std::uint8_t NID_TSR) {
    information.packets.clear();
    information.medium = medium;
    lang::Packet65 p;
    p.NID_TSR.raw = NID_TSR;
    p.L_TSR.raw = 100;
    p.V_TSR.raw = 8;
    add(p);
    evaluate_now();
    return told(65).what == What::packet_refused && told(65).clause == "4.8.3 [8]"_srs;
  };
  EXPECT_FALSE(refuses(Medium::balise, 7));
  state.track.revocable_tsr_inhibited = true;
  EXPECT_TRUE(refuses(Medium::balise, 7));
  EXPECT_FALSE(refuses(Medium::balise, 255)) << "it cannot be revoked";
  EXPECT_FALSE(refuses(Medium::rbc, 7));
}

TEST_F(Filter, RefusesATextOfTheRbcWithTheIdentityOfOneThatIsNotAcknowledged) {  // 4.8.3 [12]
  const auto refuses = [this](std::uint8_t NID_TEXTMESSAGE, std::uint8_t Q_TEXTREPORT) {
    information.packets.clear();
    lang::Packet76 p;
    p.Q_TEXTCONFIRM.raw = 1;
    p.Q_TEXTREPORT.raw = Q_TEXTREPORT;
    p.NID_TEXTMESSAGE.raw = NID_TEXTMESSAGE;
    add(p);
    evaluate_now();
    return told(76).what == What::packet_refused && told(76).clause == "4.8.3 [12]"_srs;
  };
  track::Text waiting;
  waiting.report = true;
  waiting.NID_TEXTMESSAGE = 9;
  ASSERT_TRUE(state.track.texts.push_back(waiting));
  EXPECT_TRUE(refuses(9, 1));
  EXPECT_FALSE(refuses(10, 1));
  EXPECT_FALSE(refuses(9, 0)) << "no report is asked for";
  state.track.texts[0].acknowledged = true;
  EXPECT_FALSE(refuses(9, 1));
}

TEST_F(Filter, RefusesTheDistanceOfALoopDuringAnOverride) {  // 4.8.4 [6]
  state.mode = Mode::SR;
  state.level.level = Level::L1;
  information.medium = Medium::loop;
  add(lang::Packet13{});
  evaluate_now();
  expect(13, What::packet_accepted);
  state.override_.active = true;
  evaluate_now();
  expect(13, What::packet_refused, "4.8.4 [6]"_srs);
}

TEST_F(Filter, JudgesByTheEditionOfTheUnit) {  // 4.8.3: message 38 is not in 3.6.0
  lang::MessageToTrainView view;
  view.NID_MESSAGE = 38;
  information.message = &view;
  evaluate_now();
  const auto refused = [&] {
    for (const Event& e : out.events)
      if (e.what == What::message_refused && e.id == 38) return true;
    return false;
  };
  EXPECT_TRUE(refused());
  state.srs = SrsVersion::v3_4_0;
  evaluate_now();
  EXPECT_FALSE(refused());
}

TEST_F(Filter, BuffersForAnAnnouncedLevel) {  // 4.8.3 [2]
  state.level.level = Level::L1;
  add(lang::Packet21{});
  EXPECT_FALSE(evaluate_now().any());
  expect(21, What::packet_refused);
  state.level_transition.pending.emplace().to.level = Level::L2;
  EXPECT_TRUE(evaluate_now().any());
  expect(21, What::packet_buffered, "4.8.3 [2]"_srs);
}

TEST_F(Filter, BuffersForALevelOrderedInAnEarlierMessageOfTheCycle) {  // 4.8.1.3.1
  state.level.level = Level::L1;
  information.medium = Medium::balise;
  add(order_to(3, kNow));
  evaluate_now();
  expect(41, What::packet_accepted);
  information.packets.clear();
  information.medium = Medium::rbc;
  add(lang::Packet21{});
  evaluate_now();
  expect(21, What::packet_buffered, "4.8.3 [2]"_srs);
}

TEST_F(Filter, BuffersForALevelOrderedInTheMessageItself) {  // 4.8.1.3.1
  for (const std::uint16_t D_LEVELTR : {kNow, std::uint16_t{500}}) {
    reception.order.reset();
    information.packets.clear();
    information.medium = Medium::balise;
    add(lang::Packet21{});
    add(order_to(2, D_LEVELTR));
    evaluate_now();
    expect(41, What::packet_accepted);
    expect(21, What::packet_buffered, "4.8.3 [1]"_srs);
  }
}

TEST_F(Filter, NoLongerBuffersForALevelThatIsNoLongerOrdered) {  // 4.8.3 [1], 5.10.1.6
  state.level_transition.pending.emplace().to.level = Level::L1;
  information.medium = Medium::balise;
  add(lang::Packet21{});
  evaluate_now();
  expect(21, What::packet_buffered);
  information.packets.clear();
  add(order_to(3, 500));
  add(lang::Packet21{});
  evaluate_now();
  expect(41, What::packet_accepted);
  expect(21, What::packet_refused, "4.8.3"_srs);
}

TEST_F(Filter, RefusesAConditionalOrderBesideAnother) {  // 4.8.3 [11]
  information.medium = Medium::balise;
  lang::Packet46 conditional;
  conditional.M_LEVELTR.raw = 2;
  add(conditional);
  add(lang::Packet21{});
  evaluate_now();
  EXPECT_NE(told(46).what, What::packet_refused);
  reception.order.reset();
  add(order_to(2, 500));
  evaluate_now();
  expect(46, What::packet_refused, "4.8.3 [11]"_srs);
  expect(41, What::packet_accepted);
  information.packets.clear();
  add(conditional);
  reception.order.reset();
  state.level_transition.pending.emplace().to.level = Level::L1;
  evaluate_now();
  expect(46, What::packet_refused, "4.8.3 [11]"_srs);
}

TEST_F(Filter, KnowsTheKindOfAnOrderInSH) {  // 4.8.4 [7]
  state.mode = Mode::SH;
  information.medium = Medium::balise;
  add(order_to(2, 500));
  evaluate_now();
  expect(41, What::packet_refused, "4.8.4 [7]"_srs);
  information.packets.clear();
  add(order_to(2, kNow));
  evaluate_now();
  expect(41, What::packet_kept, "4.8.4 [7]"_srs);
}

TEST_F(Filter, TakesDangerForShuntingInLevel0OnlyWithAnOrderToLevel1To3) {  // 4.8.3 [13]
  state.mode = Mode::SH;
  const auto judged_with = [&](std::optional<lang::Packet41> order, Level level) {
    state.level.level = level;
    information.medium = Medium::balise;
    information.packets.clear();
    reception.order.reset();
    add(lang::Packet132{});
    if (order) add(*order);
    evaluate_now();
    return told(132);
  };
  EXPECT_EQ(judged_with({}, Level::L0).clause, "4.8.3 [13]"_srs);
  EXPECT_EQ(judged_with({}, Level::L1).what, What::packet_accepted);
  state.mode = Mode::UN;
  EXPECT_EQ(judged_with(order_to(2, 500), Level::L0).clause, "4.8.3 [13]"_srs) << "not at once";
  EXPECT_NE(judged_with(order_to(2, kNow), Level::L0).clause, "4.8.3 [13]"_srs);
  EXPECT_EQ(judged_with(order_to(1, kNow), Level::L0).clause, "4.8.3 [13]"_srs) << "to level NTC";
}

TEST_F(Filter, StoresOnlyTheContactOfAnOrderForASessionInSH) {  // 4.8.4 [3]
  state.mode = Mode::SH;
  lang::Packet42 p;
  p.Q_RBC.raw = 1;
  add(p);
  evaluate_now();
  expect(42, What::packet_contact_stored, "4.8.4 [3]"_srs);
  p.Q_RBC.raw = 0;
  information.packets.clear();
  add(p);
  evaluate_now();
  expect(42, What::packet_accepted);
}

TEST_F(Filter, OtherPacketsDoNotSayWhetherASessionIsOrdered) {  // 4.8.4 [3]
  state.mode = Mode::SH;
  lang::Packet42 p;
  p.Q_RBC.raw = 1;
  add(p);
  add(lang::Packet58{});
  add(p);
  evaluate_now();
  EXPECT_EQ(told(42).times, 2);
  EXPECT_EQ(told(42).what, What::packet_contact_stored);
}

TEST_F(Filter, JudgesEachPacketOnce) {  // 4.8.1
  information.medium = Medium::balise;
  state.level.level = Level::L1;
  add(order_to(2, kNow));
  add(lang::Packet5{});
  add(lang::Packet21{});
  add(lang::Packet27{});
  evaluate_now();
  for (const int packet : {41, 5, 21, 27}) EXPECT_EQ(told(packet).times, 1) << packet;
}

TEST_F(Filter, JudgesOnlyThePacketsThatWait) {  // 4.8.5
  information.medium = Medium::balise;
  state.level.level = Level::L1;
  add(order_to(2, kNow));
  add(lang::Packet5{});
  add(lang::Packet21{});
  for (std::uint64_t wanted = 0; wanted < 8; ++wanted) {
    information.judge_packets = wanted;
    evaluate_now();
    EXPECT_EQ(told(41).times, (wanted & 1u) != 0 ? 1 : 0);
    EXPECT_EQ(told(5).times, (wanted & 2u) != 0 ? 1 : 0);
    EXPECT_EQ(told(21).times, (wanted & 4u) != 0 ? 1 : 0);
  }
}

TEST_F(Filter, StoresNoLinkingThatIsRefused) {  // 4.8.3 [3]
  lang::Packet5 p;
  p.Q_SCALE.raw = 1;
  p.D_LINK.raw = 500;
  p.NID_BG.raw = 101;
  add(p);
  state.radio.supervising.train_data_stamp = 17;
  evaluate_now();
  EXPECT_TRUE(state.balise.linking.links.empty());
  state.radio.supervising.train_data_stamp.reset();
  evaluate_now();
  ASSERT_EQ(state.balise.linking.links.size(), 1u);
  EXPECT_EQ(state.balise.linking.links[0].place, at(1450.0));
  EXPECT_EQ(state.balise.linking.links[0].id, (GroupId{1, 101}));
}

TEST_F(Filter, MeasuresFromTheLRBGThatTheListHolds) {  // 3.6.4.3
  // The message refers to group 99 at 700 m; its list holds the LRBG, 250 m on, which lies at 960 m.
  information.group = {1, 99};
  information.reference = at(700.0);
  position::Reference lrbg;
  lrbg.id = {1, 100};
  lrbg.place = at(960.0);
  ASSERT_TRUE(state.position.references.push_back(lrbg));
  lang::Packet5 p;
  p.Q_SCALE.raw = 1;
  p.D_LINK.raw = 250;
  p.NID_BG.raw = 100;
  lang::Packet5_links next;
  next.D_LINK.raw = 500;
  next.NID_BG.raw = 101;
  ASSERT_TRUE(p.links.push_back(next));
  add(p);
  lang::Packet21 gradient;
  gradient.Q_SCALE.raw = 1;
  gradient.D_GRADIENT.raw = 400;
  add(gradient);
  evaluate_now();
  ASSERT_FALSE(state.track.gradient.empty());
  EXPECT_EQ(state.track.gradient.steps[0].from, at(710.0 + 400.0));
}

TEST_F(Filter, TheReferenceAnnouncedAgainIsAnotherPassage) {  // 3.4.4.3: a loop of track
  position::Reference lrbg;
  lrbg.id = {1, 100};
  lrbg.place = at(950.0);
  ASSERT_TRUE(state.position.references.push_back(lrbg));
  lang::Packet5 p;
  p.Q_SCALE.raw = 1;
  p.D_LINK.raw = 90;
  p.NID_BG.raw = 100;
  add(p);
  evaluate_now();
  ASSERT_EQ(state.balise.linking.links.size(), 1u);
  EXPECT_EQ(state.balise.linking.links[0].place, at(1040.0));
}

TEST_F(Filter, AMessageThatIsRefusedHasNoEffect) {  // 4.8.4
  take_SR_authorisation();
  EXPECT_TRUE(happened(What::message_refused)) << "not in FS";
  EXPECT_FALSE(received.SR_authorised);
  state.mode = Mode::SB;
  state.data.train_data_status = DataStatus::valid;
  take_SR_authorisation();
  EXPECT_TRUE(happened(What::message_accepted));
  EXPECT_TRUE(received.SR_authorised);
  // It was executed before; only its packets wait.
  received.SR_authorised = false;
  information.judge_message = false;
  take_SR_authorisation();
  EXPECT_FALSE(received.SR_authorised);
}

TEST_F(Filter, BuffersAnEmergencyStopForLevel2) {  // 4.8.3 [2]
  state.level.level = Level::L1;
  state.level_transition.pending.emplace().to.level = Level::L2;
  lang::Message16 m;
  m.NID_EM.raw = 3;
  set_message(m);
  EXPECT_TRUE(evaluate_now().message);
  EXPECT_TRUE(happened(What::message_buffered));
  EXPECT_FALSE(state.emergency_stops.any());
}

TEST_F(Filter, TellsOfAMessageWhetherAllOfItWasAccepted) {  // 4.8.3, 4.8.4
  set_message(lang::Message24{});
  add(lang::Packet21{});
  add(lang::Packet58{});
  evaluate_now();
  EXPECT_TRUE(happened(What::message_accepted));
  EXPECT_FALSE(happened(What::message_refused));
  state.radio.supervising.train_data_stamp = 17;
  evaluate_now();
  EXPECT_TRUE(happened(What::message_refused));
  EXPECT_FALSE(happened(What::message_accepted));
}

TEST_F(Filter, FindsTheOrderAlongInAnyPlace) {  // 4.8.3 [11]
  information.medium = Medium::balise;
  add(order_to(2, 500));
  lang::Packet46 conditional;
  conditional.M_LEVELTR.raw = 2;
  add(conditional);
  evaluate_now();
  expect(46, What::packet_refused, "4.8.3 [11]"_srs);
}

TEST_F(Filter, LinkingWithoutAnOrientationIsOfNone) {  // 3.4.4.4
  lang::Packet5 p;
  p.Q_SCALE.raw = 1;
  p.D_LINK.raw = 500;
  p.NID_BG.raw = 101;
  p.Q_LINKORIENTATION.raw = 1;
  add(p);
  evaluate_now();
  ASSERT_EQ(state.balise.linking.links.size(), 1u);
  EXPECT_TRUE(state.balise.linking.links[0].gives_orientation);
  information.orientation = Direction::unknown;
  evaluate_now();
  ASSERT_EQ(state.balise.linking.links.size(), 1u);
  EXPECT_FALSE(state.balise.linking.links[0].gives_orientation);
}

TEST_F(Filter, OfTheRBCOfATransitionABaliseOrdersNoSession) {  // 4.8.3 [14]
  information.medium = Medium::balise;
  const auto refused = [&](std::uint16_t NID_C, std::uint16_t NID_RBC, bool along, std::uint8_t Q_RBC = 1) {
    lang::Packet42 p;
    p.Q_RBC.raw = Q_RBC;
    p.NID_C.raw = NID_C;
    p.NID_RBC.raw = NID_RBC;
    lang::Packet131 order;
    order.NID_C.raw = 1;
    order.NID_RBC.raw = 77;
    order.D_RBCTR.raw = 500;
    information.packets.clear();
    add(p);
    if (along) add(order);
    state.track.rbc_transition.reset();
    if (!along) state.track.rbc_transition = track::RbcTransition{at(1500.0), 1, 77, 0, false, {}};
    state.radio = {};
    evaluate_now();
    EXPECT_EQ(told(42).times, 1);
    return told(42).what == What::packet_refused && told(42).clause == "4.8.3 [14]"_srs;
  };
  for (const bool along : {true, false}) {
    EXPECT_TRUE(refused(1, 77, along));
    EXPECT_FALSE(refused(1, 78, along));
    EXPECT_FALSE(refused(2, 77, along));
    EXPECT_FALSE(refused(1, 77, along, 0)) << "an order to end one";
  }
}

TEST_F(Filter, AnOrderToShowTheLSSMAComesWithItsArea) {  // 4.8.4, 4.4.19.1.4.2
  state.level.level = Level::L1;
  information.medium = Medium::balise;
  state.mode = Mode::FS;
  const auto taken = [&](std::uint16_t D_MAMODE, std::uint8_t M_MAMODE, double front) {
    lang::Packet80 profile;
    profile.Q_SCALE.raw = 1;
    profile.D_MAMODE.raw = D_MAMODE;
    profile.M_MAMODE.raw = M_MAMODE;
    profile.L_MAMODE.raw = 500;
    lang::Packet180 order;
    order.Q_LSSMA.raw = 1;
    information.packets.clear();
    add(profile);
    add(order);
    received.here.max_safe_front = at(front);
    evaluate_now();
    return told(180).what == What::packet_accepted;
  };
  constexpr std::uint8_t kOS = 0, kLS = 2;
  EXPECT_TRUE(taken(0, kLS, 1000.0));  // from 950 m to 1450 m
  EXPECT_TRUE(taken(0, kLS, 950.0));
  EXPECT_TRUE(taken(0, kLS, 1450.0));
  EXPECT_FALSE(taken(0, kLS, 1450.1));
  EXPECT_FALSE(taken(60, kLS, 1000.0));
  EXPECT_FALSE(taken(0, kOS, 1000.0));
  ASSERT_TRUE(taken(0, kLS, 1000.0));
  information.packets.erase(0);
  evaluate_now();
  EXPECT_EQ(told(180).what, What::packet_refused) << "the profile of an earlier message";
}

/// An announced group 101 at 1450 m, and packets behind packet 136 that count from there.
class InfillPart : public Filter {
 protected:
  InfillPart() {
    state.level.level = Level::L1;
    information.medium = Medium::balise;
    EXPECT_TRUE(state.track.gradient.append(at(0.0), {0}));
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 20}));
    balise::Link link;
    link.id = {1, 101};
    link.place = at(1450.0);
    EXPECT_TRUE(state.balise.linking.links.push_back(link));
  }
  void receive_infill(lang::Packet136 reference) {
    information.packets.clear();
    add(lang::Packet58{});
    add(reference);
    lang::Packet5 linking;
    linking.Q_SCALE.raw = 1;
    linking.D_LINK.raw = 1000;
    linking.NID_BG.raw = 102;
    add(linking);
    evaluate_now();
  }
};

TEST_F(InfillPart, CountsFromTheAnnouncedGroupAndKeepsWhatIsInRearOfIt) {  // 3.6.2.3.1, 3.7.3.1 n
  lang::Packet136 p;
  p.NID_BG.raw = 101;
  receive_infill(p);
  expect(5, What::packet_accepted);
  ASSERT_EQ(state.balise.linking.links.size(), 2u);
  EXPECT_EQ(state.balise.linking.links[0].id, (GroupId{1, 101}));
  EXPECT_EQ(state.balise.linking.links[1].place, at(2450.0));
}

TEST_F(InfillPart, OfAnotherCountryIsOfThatCountry) {  // 7.4.2.32
  lang::Packet136 p;
  p.Q_NEWCOUNTRY.raw = 1;
  p.NID_C.raw = 9;
  p.NID_BG.raw = 101;
  receive_infill(p);
  EXPECT_TRUE(happened(What::infill_refused));
  expect(5, What::packet_refused, "3.6.2.3.1"_srs);
  state.balise.linking.links[0].id = {9, 101};
  receive_infill(p);
  EXPECT_FALSE(happened(What::infill_refused));
  expect(5, What::packet_accepted);
}

TEST_F(InfillPart, GroupsOfTheSendersCountry) {  // 7.5.1.121
  track::MovementAuthority& ma = state.track.ma.emplace();
  ASSERT_TRUE(ma.sections.push_back({at(0.0), at(1450.0)}));
  state.balise.linking.links[0].id = {9, 101};
  lang::Packet136 reference;
  reference.Q_NEWCOUNTRY.raw = 1;
  reference.NID_C.raw = 9;
  reference.NID_BG.raw = 101;
  add(reference);
  lang::Packet12 authority;
  authority.Q_SCALE.raw = 1;
  authority.V_MAIN.raw = 32;
  authority.L_ENDSECTION.raw = 1000;
  add(authority);
  lang::Packet49 groups;
  lang::Packet49_groups group;
  group.NID_BG.raw = 500;
  ASSERT_TRUE(groups.groups.push_back(group));
  add(groups);
  lang::Packet80 shunting;
  shunting.Q_SCALE.raw = 1;
  shunting.M_MAMODE.raw = 1;
  add(shunting);
  evaluate_now();
  ASSERT_TRUE(happened(What::authority_accepted));
  ASSERT_TRUE(state.track.sh_list.has_value());
  EXPECT_EQ((*state.track.sh_list)[0], (GroupId{1, 500}));
}

TEST_F(InfillPart, LeavesTheBorderOfTheMessageWhereItIs) {  // 4.8.1.5, 4.8.1.6
  add(order_to(3, 700));
  lang::Packet136 reference;
  reference.NID_BG.raw = 101;
  add(reference);
  add(lang::Packet5{});
  evaluate_now();
  ASSERT_TRUE(reception.order.has_value());
  EXPECT_EQ(reception.order->order.border, at(1650.0));
}

TEST_F(InfillPart, AGeographicalPositionIsThatOfTheAnnouncedGroup) {  // 7.4.2.25, 7.4.2.32
  lang::Packet136 reference;
  reference.NID_BG.raw = 101;
  add(reference);
  lang::Packet79 p;
  p.Q_SCALE.raw = 1;
  p.NID_BG.raw = 101;
  p.D_POSOFF.raw = 20;
  add(p);
  evaluate_now();
  ASSERT_EQ(state.track.geo.size(), 1u);
  EXPECT_EQ(state.track.geo[0].applies_from, at(1470.0));
  EXPECT_EQ(state.track.geo[0].anchor, Anchor::lrbg) << "linking knows the group";
}

TEST_F(InfillPart, OfTwoTelegramsIsOne) {  // 4.8.1.5: the profile is that of the authority
  ASSERT_TRUE(state.track.ma.emplace().sections.push_back({at(0.0), at(2000.0)}));
  lang::Packet136 reference;
  reference.NID_BG.raw = 101;
  lang::Packet12 authority;
  authority.Q_SCALE.raw = 1;
  authority.V_MAIN.raw = 32;
  authority.L_ENDSECTION.raw = 2000;
  lang::Packet80 profile;
  profile.Q_SCALE.raw = 1;
  profile.D_MAMODE.raw = 500;
  profile.L_MAMODE.raw = 500;
  add(reference);
  add(authority);
  add(reference);
  add(profile);
  const auto second = packet_bytes;
  for (std::size_t i = 2; i < 4; ++i) information.packets[i].bytes = second;
  evaluate_now();
  EXPECT_EQ(state.track.ma->end(), at(3450.0));
  ASSERT_EQ(state.track.mode_profile.size(), 1u);
  EXPECT_EQ(state.track.mode_profile[0].from, at(1950.0));
}

TEST_F(InfillPart, WithMoreLinkingThanFindsRoomIsLogged) {  // 3.4.4.1
  lang::Packet136 p;
  p.NID_BG.raw = 101;
  receive_infill(p);
  EXPECT_FALSE(happened(What::linking_capacity));
  balise::Link near = state.balise.linking.links[0];
  state.balise.linking.links.clear();
  near.id = {1, 77};
  for (std::size_t i = 0; i + 1 < balise::kLinks; ++i) {
    near.place = at(1100.0 + static_cast<double>(i));
    ASSERT_TRUE(state.balise.linking.links.push_back(near));
  }
  near.id = {1, 101};
  near.place = at(1450.0);
  ASSERT_TRUE(state.balise.linking.links.push_back(near));
  receive_infill(p);
  EXPECT_TRUE(happened(What::linking_capacity));
}

TEST_F(InfillPart, IsRefusedInOtherModesThanFSAndLS) {  // 4.8.4
  lang::Packet136 p;
  p.NID_BG.raw = 101;
  state.mode = Mode::OS;
  receive_infill(p);
  expect(5, What::packet_refused, "4.8.4 infill"_srs);
  expect(58, What::packet_refused);
  state.mode = Mode::LS;
  receive_infill(p);
  expect(5, What::packet_accepted);
}

}  // namespace
}  // namespace evc::kernel
