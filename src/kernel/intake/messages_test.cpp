#include "kernel/intake/messages.h"

#include <gtest/gtest.h>

#include "kernel/intake/test_message.h"
#include "lang/packets/packet_58.h"
#include "lang/packets/packet_63.h"

// What each radio message does (8.4.4): the answers to the RBC, and the facts for the procedures.
namespace evc::kernel::test {
namespace {

class RadioMessage : public test::OneMessage {
 protected:
  RadioMessage() {
    information.min_safe_front = at(1000.0);
    state.data.train_data_status = DataStatus::valid;  // 4.8.4 [4]
  }
  template <class M>
  void take(M m, lang::SystemVersion sv = {2, 1}) {
    set_message(m, sv);
    outbox.messages.clear();
    evaluate_now();
  }
  bool accepted() const { return happened(What::message_accepted); }
  Clause refused_because() const {
    for (const Event& e : out.events)
      if (e.what == What::message_refused) return e.clause;
    return {};
  }
  /// Q_EMERGENCYSTOP of the answer 147; 255: none was sent.
  int answer(std::uint8_t NID_EM) const {
    for (const radio::Intent& m : outbox.messages)
      if (m.NID_MESSAGE == 147 && m.NID_EM == NID_EM) return m.Q_EMERGENCYSTOP;
    return 255;
  }
  static lang::Message15 conditional(std::uint16_t D_EMERGENCYSTOP) {
    lang::Message15 m;
    m.NID_EM.raw = 4;
    m.Q_SCALE.raw = 1;
    m.Q_DIR.raw = 1;
    m.D_EMERGENCYSTOP.raw = D_EMERGENCYSTOP;
    return m;
  }
  static lang::Message16 unconditional() {
    lang::Message16 m;
    m.NID_EM.raw = 5;
    return m;
  }
  void authority_to(double end) {
    track::MovementAuthority ma;
    EXPECT_TRUE(ma.sections.push_back({at(0.0), at(end)}));
    state.track.ma = ma;
  }
};

TEST_F(RadioMessage, AConditionalStopDeletesWhatIsBeyond) {  // 3.10.2.2, A.3.4
  authority_to(4000.0);
  for (const double place : {2000.0, 3000.0}) {
    balise::Link link;
    link.place = at(place);
    ASSERT_TRUE(state.balise.linking.links.push_back(link));
  }
  take(conditional(1550));  // at 2500 m
  EXPECT_TRUE(accepted());
  EXPECT_EQ(answer(4), 0);
  EXPECT_EQ(state.balise.linking.links.size(), 1u);
}

TEST_F(RadioMessage, AConditionalStopInRearChangesNothing) {  // 3.10.2.2
  authority_to(4000.0);
  balise::Link link;
  link.place = at(2000.0);
  ASSERT_TRUE(state.balise.linking.links.push_back(link));
  take(conditional(10));
  EXPECT_FALSE(accepted());
  EXPECT_EQ(answer(4), 3);
  EXPECT_EQ(state.balise.linking.links.size(), 1u);
  EXPECT_FALSE(state.emergency_stops.any());
}

TEST_F(RadioMessage, AStopWithoutAnOrientationIsRefused) {  // 3.6.3.1.4
  authority_to(4000.0);
  information.orientation = Direction::unknown;
  take(conditional(1550));
  EXPECT_EQ(refused_because(), "3.6.3.1.4"_srs);
  EXPECT_FALSE(state.emergency_stops.any());
}

TEST_F(RadioMessage, StopsAreAnsweredInTheCodesOfTheVersion) {  // 7.5.1.107, 6.6.3.4
  authority_to(4000.0);
  take(unconditional());
  EXPECT_TRUE(received.ues_accepted);
  EXPECT_TRUE(received.ues_received);
  EXPECT_EQ(answer(5), 2);
  take(conditional(10));
  EXPECT_EQ(answer(4), 3);
  take(unconditional(), {1, 1});
  EXPECT_EQ(answer(5), 2);
  take(conditional(10), {1, 1});
  EXPECT_EQ(answer(4), 1) << "not considered, the place is passed";
}

TEST_F(RadioMessage, AnAuthorisationForSRBeginsAnew) {  // 4.4.11.1.3.2
  state.mode = Mode::SB;
  state.staff_responsible.end = at(1100.0);
  state.track.sr_list.emplace();
  const std::uint32_t revision = state.revision;
  lang::Message2 m;
  m.Q_SCALE.raw = 1;
  m.D_SR.raw = 500;
  take(m);
  EXPECT_TRUE(received.SR_authorised);
  EXPECT_EQ(state.staff_responsible.end, at(1500.0));
  EXPECT_TRUE(state.staff_responsible.by_rbc);
  EXPECT_FALSE(state.track.sr_list.has_value());
  EXPECT_NE(state.revision, revision);
  m.D_SR.raw = 32767;
  take(m);
  EXPECT_EQ(state.staff_responsible.end, std::nullopt) << "infinite";
  EXPECT_TRUE(state.staff_responsible.by_rbc);
}

TEST_F(RadioMessage, AnAuthorisationForSRHasTheListOfItsPacket63) {  // 4.4.11.1.3.3
  state.mode = Mode::SB;
  lang::Packet63 p;
  lang::Packet63_groups group;
  group.NID_BG.raw = 77;
  ASSERT_TRUE(p.groups.push_back(group));
  add(lang::Packet58{});
  add(p);
  add(lang::Packet58{});
  lang::Message2 m;
  m.D_SR.raw = 32767;
  take(m);
  ASSERT_TRUE(state.track.sr_list.has_value());
  ASSERT_EQ(state.track.sr_list->size(), 1u);
  EXPECT_EQ((*state.track.sr_list)[0].NID_BG, 77);
}

TEST_F(RadioMessage, TrackAheadFreeIsAskedInItsStretch) {  // 3.15.5
  state.mode = Mode::SB;
  lang::Message34 m;
  m.Q_SCALE.raw = 1;
  m.Q_DIR.raw = 1;
  m.D_REF.raw = 20;
  m.D_TAFDISPLAY.raw = 30;
  m.L_TAFDISPLAY.raw = 200;
  take(m);
  EXPECT_TRUE(accepted());
  EXPECT_EQ(state.track_ahead_free.from, at(1000.0));
  EXPECT_EQ(state.track_ahead_free.to, at(1200.0));
}

TEST_F(RadioMessage, TrackAheadFreeNeedsTheTrainsDirection) {  // 3.6.3.1.3, 3.6.3.1.4
  state.mode = Mode::SB;
  lang::Message34 m;
  m.Q_DIR.raw = 0;
  take(m);
  EXPECT_EQ(refused_because(), "3.6.3.1.3"_srs);
  EXPECT_FALSE(state.track_ahead_free.from.has_value());
  information.orientation = Direction::unknown;
  m.Q_DIR.raw = 2;
  take(m);
  EXPECT_EQ(refused_because(), "3.6.3.1.4"_srs);
  EXPECT_FALSE(state.track_ahead_free.from.has_value());
}

TEST_F(RadioMessage, TheExitFromTripIsRecognised) {  // 4.8.4 [1]
  state.mode = Mode::PT;
  lang::Message6 m;
  take(m);
  EXPECT_TRUE(received.exit_from_trip);
}

TEST_F(RadioMessage, AnEmergencyStopIsRevokedByItsNumber) {  // 3.10.3.3
  take(unconditional());
  ASSERT_TRUE(state.emergency_stops.any());
  lang::Message18 m;
  m.NID_EM.raw = 6;
  take(m);
  EXPECT_EQ(refused_because(), "3.10.3.3"_srs);
  EXPECT_TRUE(state.emergency_stops.any());
  m.NID_EM.raw = 5;
  take(m);
  EXPECT_TRUE(happened(What::emergency_stop_revoked));
  EXPECT_FALSE(state.emergency_stops.any());
}

TEST_F(RadioMessage, ACoordinateSystemNeedsItsGroup) {  // 3.4.2.3.3.8
  state.mode = Mode::SB;
  take(lang::Message45{});
  EXPECT_EQ(refused_because(), "3.4.2.3.3.8"_srs);
}

TEST_F(RadioMessage, OnlyTheAnswerToTheLastRequestForShuntingCounts) {  // 4.6.3 [6]
  state.mode = Mode::SB;
  received.here.standstill = true;
  for (const std::uint32_t stamp : {4711u, 4712u}) {
    state.shunting.waits_for_answer = true;
    state.radio.shunting_request_stamp = 4711;
    received.SH_refused = received.SH_authorised = false;
    lang::Message27 refused;
    refused.T_TRAIN_REF.raw = stamp;
    take(refused);
    EXPECT_EQ(received.SH_refused, stamp == 4711u);
    EXPECT_EQ(refused_because(), stamp == 4711u ? Clause{} : "4.6.3"_srs);
    lang::Message28 authorised;
    authorised.T_TRAIN_REF.raw = stamp;
    take(authorised);
    EXPECT_EQ(received.SH_authorised, stamp == 4711u);
    EXPECT_EQ(refused_because(), stamp == 4711u ? Clause{} : "4.6.3"_srs);
  }
}

TEST_F(RadioMessage, AnAuthorisationForSHWithoutAListEndsTheListStored) {  // 5.6.2.2 E090
  state.mode = Mode::SB;
  received.here.standstill = true;
  state.shunting.waits_for_answer = true;
  state.radio.shunting_request_stamp = 4711;
  state.track.sh_list.emplace();
  scratch->proposal.sh_list.emplace();  // of an earlier message
  lang::Message28 m;
  m.T_TRAIN_REF.raw = 4711;
  take(m);
  EXPECT_TRUE(received.SH_authorised);
  EXPECT_FALSE(state.track.sh_list.has_value());
}

TEST_F(RadioMessage, BitsThatCannotBeReadAreRefused) {  // 3.16.3.1.1
  authority_to(4000.0);
  const auto refuses = [&](auto m, Mode mode) {
    state.mode = mode;
    set_message(m);
    message.bytes = message.bytes.first(6);
    evaluate_now();
    EXPECT_EQ(refused_because(), "3.16.3.1.1"_srs) << int{message.NID_MESSAGE};
  };
  refuses(conditional(1550), Mode::FS);
  refuses(unconditional(), Mode::FS);
  refuses(lang::Message18{}, Mode::FS);
  refuses(lang::Message2{}, Mode::SB);
  refuses(lang::Message34{}, Mode::SB);
  refuses(lang::Message8{}, Mode::SB);
  refuses(lang::Message45{}, Mode::SB);
  refuses(lang::Message27{}, Mode::SB);
  refuses(lang::Message28{}, Mode::SB);
  EXPECT_FALSE(state.emergency_stops.any());
  EXPECT_FALSE(received.SR_authorised);
  EXPECT_FALSE(state.track_ahead_free.from.has_value());
}

}  // namespace
}  // namespace evc::kernel::test
