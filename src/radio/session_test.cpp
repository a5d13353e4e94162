#include "radio/session.h"

#include "lang/packets/packet_131.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_57.h"
#include "radio/from_packets.h"
#include "radio/testing.h"

namespace evc::radio {
namespace {

using namespace testing;

TEST(Session, SetUp) {  // 3.5.3.7
  Unit u;
  u.order_session();
  EXPECT_EQ(u.out.connect, kRbc);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::connecting);
  u.cycle();
  u.fresh();
  u.cycle(RadioLink::connected);
  EXPECT_EQ(u.messages(), Ids{155});
  EXPECT_EQ(u.s.supervising.session.phase, Phase::waiting_version);
  EXPECT_EQ(u.message(3), Rejected::no_session) << "only the version is taken now";
  u.fresh();
  u.version(0x10);
  EXPECT_TRUE(u.s.supervising.session.established());
  EXPECT_TRUE(u.cycle().session_established);
  EXPECT_EQ(u.messages(), (Ids{159, 136, 129}));
  EXPECT_FALSE(u.cycle().session_established);
  EXPECT_EQ(u.s.supervising.session.M_VERSION, 0x10);
  EXPECT_EQ(u.s.supervising.session.indication, RadioIndication::up);
}

TEST(Session, StartOfMissionReports157) {
  Unit u;
  u.in.start_of_mission = true;
  u.in.Q_STATUS = 2;
  u.in.running_number_valid = true;
  u.in.train_data_valid = false;
  u.order_session();
  u.cycle(RadioLink::connected);
  u.fresh();
  u.version();
  u.cycle();
  EXPECT_EQ(u.messages(), (Ids{159, 157}));
  EXPECT_EQ(u.out.messages[1].Q_STATUS, 2);
  EXPECT_TRUE(u.out.messages[1].running_number);
}

TEST(Session, ThreeTriesInStartOfMission) {  // N_CONN_TRIES
  Unit u;
  ASSERT_TRUE(order(u.s, {true, kRbc, false, Cause::start_of_mission}, false, false, Duration{0}, u.out));
  for (int i = 0; i < 2; ++i) {
    u.fresh();
    u.cycle(RadioLink::refused);
    EXPECT_EQ(u.out.connect, kRbc);
    EXPECT_NE(u.s.supervising.session.indication, RadioIndication::failed);
  }
  u.fresh();
  u.cycle(RadioLink::refused);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::idle);
  EXPECT_EQ(u.s.supervising.session.indication, RadioIndication::failed);
}

TEST(Session, OutsideStartOfMissionItGoesOnTrying) {
  Unit u;
  u.order_session();
  for (int i = 0; i < 400; ++i) {
    u.fresh();
    u.cycle(RadioLink::refused);
    ASSERT_EQ(u.out.connect, kRbc);
  }
  EXPECT_EQ(u.s.supervising.session.phase, Phase::connecting);
  u.run(6);
  EXPECT_EQ(u.s.supervising.session.indication, RadioIndication::failed) << "after 45 s";
}

TEST(Session, NoVersionIn15Seconds) {
  Unit u;
  u.order_session();
  u.cycle(RadioLink::connected);
  u.run(14.8);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::waiting_version);
  u.run(0.4);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::connecting);
}

TEST(Session, LinkLostBeforeTheVersionIsATry) {
  Unit u;
  u.order_session();
  u.cycle(RadioLink::connected);
  u.fresh();
  u.cycle(RadioLink::lost);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::connecting);
  EXPECT_EQ(u.out.connect, kRbc);
}

TEST(Session, UnknownVersion) {  // 3.5.3.8
  Unit u;
  u.order_session();
  u.cycle(RadioLink::connected);
  u.fresh();
  u.version(0x30);
  EXPECT_EQ(u.messages(), (Ids{154, 156}));
  EXPECT_TRUE(u.out.inform_no_version);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::terminating);
  EXPECT_FALSE(u.cycle().session_established);
}

TEST(Session, TheVersionAgainIsAnsweredAgain) {
  Unit u;
  u.up();
  u.version();
  EXPECT_EQ(u.messages(), Ids{159});
  EXPECT_FALSE(u.cycle().session_established);
}

TEST(Session, Termination) {  // 3.5.5
  Unit u;
  u.up();
  u.order_session(kRbc, false);
  EXPECT_EQ(u.messages(), Ids{156});
  EXPECT_EQ(u.message(3), Rejected::terminating);
  EXPECT_EQ(u.message(39), Rejected::no);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::idle);
  EXPECT_EQ(u.out.disconnect, kRbc);
}

TEST(Session, ItsLastMessagesAreSentWhereItEndsInTheSameCycle) {  // 3.16.3.5, 3.5.5.3.3
  Unit u;
  u.up();
  EXPECT_EQ(u.message(24, true), Rejected::no);
  u.order_session(kRbc, false);
  u.now += 0.01;
  EXPECT_EQ(u.message(39), Rejected::no);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::idle);
  EXPECT_EQ(u.out.disconnect, kRbc);
  u.cycle();
  EXPECT_EQ(u.messages(), (Ids{146, 156}));
  u.fresh();
  u.out.send(136);
  u.cycle();
  EXPECT_TRUE(u.messages().empty()) << "without a session nothing is sent";
}

TEST(Session, TerminationIsRepeatedThreeTimes) {  // 3.5.5.3.1-2
  Unit u;
  u.up();
  u.order_session(kRbc, false);
  u.fresh();
  EXPECT_EQ(u.run(59.5), (Ids{156, 156, 156}));
  EXPECT_EQ(u.s.supervising.session.phase, Phase::terminating);
  u.run(1.0);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::idle);
}

TEST(Session, TerminationWhileConnecting) {
  Unit u;
  u.order_session();
  u.order_session(kRbc, false);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::idle);
  EXPECT_EQ(u.out.disconnect, kRbc);
  EXPECT_FALSE(order(u.s, {false, kRbc, false, {}}, false, false, Duration{0}, u.out));
}

TEST(Session, AnotherRbcEndsTheFirstOne) {  // 3.5.3.5.2, 3.5.3.4.2
  Unit u;
  u.up();
  u.order_session(kRbc);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::up) << "already there";
  u.order_session(kOther);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::terminating);
  u.order_session(kOther);
  u.cycle();
  EXPECT_EQ(u.message(39), Rejected::no);
  EXPECT_EQ(u.out.disconnect, kRbc);
  EXPECT_EQ(u.out.connect, kOther);
  EXPECT_EQ(u.s.supervising.session.rbc, kOther);
  u.fresh();
  u.order_session(kOther);
  EXPECT_FALSE(u.out.connect) << "being set up already";
  u.order_session(kRbc);
  EXPECT_EQ(u.out.disconnect, kOther);
  EXPECT_EQ(u.out.connect, kRbc);
}

TEST(Session, LostIsKeptForFiveMinutes) {  // 3.5.4
  Unit u;
  u.up();
  u.fresh();
  u.cycle(RadioLink::lost);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::lost);
  EXPECT_EQ(u.out.connect, kRbc);
  u.in.report_due = true;
  EXPECT_TRUE(u.run(20).empty()) << "what is due meanwhile counts as sent";
  u.in.report_due = false;
  u.fresh();
  u.cycle(RadioLink::refused);
  EXPECT_EQ(u.out.connect, kRbc);
  u.run(40);
  EXPECT_EQ(u.s.supervising.session.indication, RadioIndication::failed);
  u.cycle(RadioLink::connected);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::up);
  EXPECT_EQ(u.s.supervising.session.indication, RadioIndication::up);
  u.cycle(RadioLink::lost);
  u.run(299);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::lost);
  bool lost = false;
  for (int i = 0; i < 20; ++i) {
    u.fresh();
    if (u.cycle().session_lost) {
      lost = true;
      EXPECT_EQ(u.out.connect, kRbc) << "cause f: at once again";
    }
  }
  EXPECT_TRUE(lost);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::connecting);
}

TEST(Session, NoAttemptsInARadioHole) {  // 3.5.4.4
  Unit u;
  u.up();
  u.in.in_radio_hole = true;
  u.fresh();
  u.cycle(RadioLink::lost);
  EXPECT_FALSE(u.out.connect);
  EXPECT_EQ(u.s.supervising.session.indication, RadioIndication::none);
  u.run(10);
  EXPECT_FALSE(u.s.supervising.session.request_connection);
  u.in.in_radio_hole = false;
  u.fresh();
  u.cycle();
  EXPECT_EQ(u.out.connect, kRbc);
  u.in.in_radio_hole = true;
  u.cycle(RadioLink::refused);
  u.run(301);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::idle) << "died inside the hole: no new one there";
}

TEST(Session, ConnectingStopsInAHoleAndGoesOnAfterIt) {
  Unit u;
  u.order_session();
  u.in.in_radio_hole = true;
  u.fresh();
  u.cycle(RadioLink::refused);
  EXPECT_FALSE(u.out.connect);
  u.in.in_radio_hole = false;
  u.cycle();
  EXPECT_EQ(u.out.connect, kRbc);
}

TEST(Order, FromPackets) {
  lang::Packet42 p;
  p.Q_RBC.raw = 1;
  p.NID_C.raw = 426;
  p.NID_RBC.raw = 1;
  p.NID_RADIO.raw = kRbc.NID_RADIO;
  EXPECT_TRUE(session_order_of(p).establish);
  EXPECT_EQ(session_order_of(p).rbc, kRbc);
  p.Q_RBC.raw = 0;
  p.Q_SLEEPSESSION.raw = 1;
  EXPECT_FALSE(session_order_of(p).establish);
  EXPECT_TRUE(session_order_of(p).sleeping_too);
  lang::Packet131 transition;
  transition.NID_RBC.raw = 9;
  EXPECT_TRUE(session_order_of(transition).establish);
  EXPECT_EQ(session_order_of(transition).rbc.NID_RBC, 9);
  lang::Packet57 request;
  request.T_MAR.raw = 255;
  request.T_TIMEOUTRQST.raw = 1023;
  request.T_CYCRQST.raw = 20;
  EXPECT_EQ(ma_request_of(request), (MaRequestParameters{std::nullopt, std::nullopt, Duration{20}}));
}

TEST(Order, KnowsTheLastRbcAndSleeping) {
  Unit u;
  const Rbc last{0, kLastKnownRbc, kStoredNumber};
  EXPECT_FALSE(order(u.s, {true, last, false, {}}, false, false, Duration{0}, u.out)) << "nothing is stored";
  EXPECT_FALSE(order(u.s, {true, kRbc, false, {}}, true, false, Duration{0}, u.out)) << "not for sleeping units";
  EXPECT_TRUE(order(u.s, {true, kRbc, true, {}}, true, true, Duration{0}, u.out));
  EXPECT_FALSE(u.out.connect) << "SH and PS only store it";
  EXPECT_TRUE(order(u.s, {true, last, false, {}}, false, false, Duration{0}, u.out));
  EXPECT_EQ(u.out.connect, kRbc);
  EXPECT_FALSE(order(u.s, {false, kOther, false, {}}, false, false, Duration{0}, u.out));
}

TEST(Session, WhatTheBearerSaysWithoutASessionIsNothing) {
  Unit u;
  u.cycle(RadioLink::lost);
  u.cycle(RadioLink::connected);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::idle);
  terminate(u.s.supervising.session, Duration{0}, u.out);
  end(u.s.supervising.session, Duration{0}, u.out);
  reconnect(u.s.supervising.session, Duration{0}, u.out);
  EXPECT_TRUE(u.out.messages.empty());
  EXPECT_FALSE(u.out.connect || u.out.disconnect);
  u.up();
  u.order_session(kRbc, false);
  u.cycle(RadioLink::lost);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::terminating) << "its repetitions run out by themselves";
}

// --- 3.5.3.7.4 of 4.0.0: the session is acknowledged

Unit of_4_0_0() {
  Unit u;
  u.s.newest = lang::kNewest;
  return u;
}

TEST(Session, AwaitsItsAcknowledgementOnceMore) {
  Unit u = of_4_0_0();
  u.up(0x23);
  EXPECT_EQ(u.run(14.0), Ids{});
  EXPECT_EQ(u.run(2.0), Ids{159}) << "15 s without it";
  EXPECT_EQ(u.run(12.0), Ids{});
  EXPECT_EQ(u.message(message::session_establishment_acknowledged), Rejected::no);
  EXPECT_EQ(u.run(60.0), Ids{});
  EXPECT_TRUE(u.s.supervising.session.established());
}

TEST(Session, BeginsAnewWithoutItsAcknowledgement) {
  Unit u = of_4_0_0();
  u.up(0x30);
  EXPECT_EQ(u.run(16.0), Ids{159});
  EXPECT_EQ(u.run(15.0), Ids{156}) << "3.5.3.7.4.1";
  EXPECT_EQ(u.s.supervising.session.phase, Phase::terminating);
  u.fresh();
  EXPECT_EQ(u.message(39), Rejected::no);
  EXPECT_EQ(u.out.connect, kRbc);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::connecting);
}

TEST(Session, TheRepeatedVersionIsAnsweredAndAwaitedAnew) {  // 3.5.4.7
  Unit u = of_4_0_0();
  u.up(0x30);
  EXPECT_EQ(u.run(10.0), Ids{});
  u.version(0x30);
  u.fresh();
  EXPECT_EQ(u.run(14.0), Ids{});
  EXPECT_EQ(u.run(2.0), Ids{159});
}

TEST(Session, AwaitsNoAcknowledgementOfOlderVersions) {  // 6.6.5.2, 6.6.5.4.2, 6.6.5.5.2
  for (const std::uint8_t M_VERSION : {std::uint8_t{0x11}, std::uint8_t{0x21}, std::uint8_t{0x22}}) {
    Unit u = of_4_0_0();
    u.up(M_VERSION);
    EXPECT_EQ(u.run(40.0), Ids{}) << unsigned{M_VERSION};
  }
  Unit of_baseline_3;
  of_baseline_3.up(0x23);
  EXPECT_EQ(of_baseline_3.run(40.0), Ids{}) << "its highest version is 2.1";
}

TEST(Session, VersionsOfAUnit) {
  const auto established = [](Unit u, std::uint8_t M_VERSION) {
    u.order_session();
    u.cycle();
    u.fresh();
    u.cycle(RadioLink::connected);
    u.version(M_VERSION);
    return u.s.supervising.session.established();
  };
  EXPECT_TRUE(established(of_4_0_0(), 0x30));
  EXPECT_FALSE(established(of_4_0_0(), 0x40));
  EXPECT_FALSE(established(Unit{}, 0x30));
  EXPECT_TRUE(established(Unit{}, 0x23));
}

TEST(Session, CommonVersion) {
  Unit u = of_4_0_0();
  EXPECT_EQ(common_version(u.s, u.s.supervising.session), (lang::SystemVersion{2, 1})) << "not agreed yet";
  u.s.supervising.session.M_VERSION = 0x22;
  EXPECT_EQ(common_version(u.s, u.s.supervising.session), (lang::SystemVersion{2, 2}));
  u.s.newest = lang::kNewest_of_baseline_3;
  EXPECT_EQ(common_version(u.s, u.s.supervising.session), (lang::SystemVersion{2, 1}));
}

// 5.4.3.2 A33: from 2.2 on train data are part of the report, before they follow it (6.6.3.4.3.1).
TEST(Session, StartOfMissionReportsTrainDataFrom2_2On) {
  for (const std::uint8_t M_VERSION : {std::uint8_t{0x21}, std::uint8_t{0x22}, std::uint8_t{0x30}}) {
    Unit u = of_4_0_0();
    u.order_session();
    u.cycle();
    u.fresh();
    u.cycle(RadioLink::connected);
    u.version(M_VERSION);
    u.fresh();
    u.in.start_of_mission = true;
    u.cycle();
    const bool within = M_VERSION >= 0x22;
    EXPECT_EQ(u.messages(), within ? Ids{157} : (Ids{157, 129})) << unsigned{M_VERSION};
    EXPECT_EQ(u.out.messages[0].train_data, within);
    EXPECT_TRUE(u.s.supervising.train_data_stamp) << "message 8 names it";
  }
}

}  // namespace
}  // namespace evc::radio
