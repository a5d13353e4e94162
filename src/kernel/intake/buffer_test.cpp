#include "kernel/intake/buffer.h"

#include <gtest/gtest.h>

#include <vector>

#include "kernel/intake/test_message.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_239.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_5.h"
#include "lang/packets/packet_65.h"

// The transition buffer: what waits for a level is judged again as it was received (4.8.5).
namespace evc::kernel {
namespace {

using test::at;

class Buffer : public test::OneMessage {
 protected:
  Buffer() {
    state.level.level = Level::L1;
    state.now = {100.0};
    information.medium = Medium::balise;
    information.reference = at(900.0);
    information.min_safe_front = at(880.0);
    information.time = {90.0};
  }
  /// The bits of a telegram of group 100; `bits` 210 or 830.
  template <class... P>
  std::vector<std::uint8_t> telegram(std::size_t bits, const P&... contents) {
    std::vector<std::uint8_t> bytes(104);
    BitWriter writer(bytes);
    lang::TelegramHeader header;
    header.NID_C.raw = 1;
    header.NID_BG.raw = 100;
    lang::begin_telegram(writer, header);
    (lang::encode(writer, contents), ...);
    lang::end_telegram(writer, bits);
    EXPECT_FALSE(writer.faulty());
    bytes.resize((bits + 7) / 8);
    return bytes;
  }
  BufferedSet& keep_packets(std::uint64_t waiting) { return keep(reception, information, {waiting, false}); }
  template <class M>
  void keep_message(M m, bool message_waits = true) {
    m.NID_LRBG.raw = (1u << 14) | 100u;
    std::array<std::uint8_t, 64> bytes{};
    BitWriter writer(bytes);
    lang::encode_message(writer, m);
    information.medium = Medium::rbc;
    add_bits(keep(reception, information, {0, message_waits}), {bytes.data(), writer.position() / 8});
  }
  void release() {
    out = {};
    release_buffer(reception);
  }
};

/// An authority with its track in two telegrams of different length; all but the profile of the second one wait.
TEST_F(Buffer, AGroupIsJudgedAsItWasRead) {  // 4.8.5.2, 4.8.5.7, 3.8.4.2.1 b
  lang::Packet12 authority;
  authority.Q_SCALE.raw = 1;
  authority.V_MAIN.raw = 32;
  authority.L_ENDSECTION.raw = 1000;
  authority.Q_SECTIONTIMER.raw = 1;
  authority.T_SECTIONTIMER.raw = 500;
  authority.D_SECTIONTIMERSTOPLOC.raw = 1000;
  lang::Packet21 gradient;
  lang::Packet27 speeds, ignored;
  speeds.V_STATIC.raw = 20;
  ignored.V_STATIC.raw = 10;
  lang::Packet3 other_direction;
  other_direction.Q_DIR.raw = 1;
  information.orientation = Direction::reverse;  // Q_DIR 0 counts
  BufferedSet& set = keep_packets(7);
  add_telegram(set, telegram(210, gradient, speeds), 210);
  add_telegram(set, telegram(830, other_direction, authority, ignored), 830);
  EXPECT_EQ(set.size, 27 + 104);
  release();
  EXPECT_TRUE(state.buffer.empty());
  ASSERT_TRUE(state.track.ma.has_value());
  EXPECT_EQ(state.track.ma->end(), at(1900.0)) << "from the reference as it was";
  EXPECT_EQ(state.track.ma->sections[0].timer.started, Duration{90.0});
  EXPECT_EQ(told(3).times, 0) << "for the other direction";
  EXPECT_EQ(told(27).times, 1) << "the second one did not wait";
  EXPECT_TRUE(received.balise_proceed) << "it is no authority of an RBC";
}

TEST_F(Buffer, AMessageIsJudgedWithItsPlaceOfReception) {  // 4.8.5.7
  state.level.level = Level::L2;
  track::MovementAuthority& ma = state.track.ma.emplace();
  ASSERT_TRUE(ma.sections.push_back({at(0.0), at(3000.0)}));
  lang::Message15 stop;
  stop.NID_EM.raw = 4;
  stop.Q_SCALE.raw = 1;
  stop.Q_DIR.raw = 1;
  stop.D_EMERGENCYSTOP.raw = 50;  // at 950 m; the front end was at 880 m and is at 1000 m
  keep_message(stop);
  release();
  EXPECT_TRUE(state.emergency_stops.any());
}

TEST_F(Buffer, AStopThatWasPassedAtReceptionStaysSo) {  // 4.8.5.7
  state.level.level = Level::L2;
  received.here.est_front = received.here.min_safe_front = received.here.max_safe_front = at(940.0);
  information.min_safe_front = at(980.0);
  lang::Message15 stop;
  stop.NID_EM.raw = 4;
  stop.Q_SCALE.raw = 1;
  stop.Q_DIR.raw = 1;
  stop.D_EMERGENCYSTOP.raw = 50;  // at 950 m
  keep_message(stop);
  release();
  EXPECT_FALSE(state.emergency_stops.any());
}

TEST_F(Buffer, GroupsAreOfTheCountryOfTheSender) {  // 7.5.1.121
  information.group = {3, 100};
  lang::Packet5 linking;
  linking.Q_DIR.raw = 1;
  linking.Q_SCALE.raw = 1;
  linking.D_LINK.raw = 500;
  linking.NID_BG.raw = 101;
  add_telegram(keep_packets(1), telegram(210, linking), 210);
  release();
  ASSERT_EQ(state.balise.linking.links.size(), 1u);
  EXPECT_EQ(state.balise.linking.links[0].id, (GroupId{3, 101}));
}

TEST_F(Buffer, OfAMessageOnlyWhatWaitsIsJudged) {  // 4.8.5.2
  state.level.level = Level::L2;
  keep_message(lang::Message16{}, false);
  release();
  EXPECT_FALSE(state.emergency_stops.any());
  keep_message(lang::Message16{});
  release();
  EXPECT_TRUE(state.emergency_stops.any());
}

TEST_F(Buffer, AMessageHasTheVersionOfItsSession) {  // 6.6.3.4
  state.level.level = Level::L2;
  track::MovementAuthority& ma = state.track.ma.emplace();
  ASSERT_TRUE(ma.sections.push_back({at(0.0), at(3000.0)}));
  lang::Message15_v1_0 stop;
  stop.NID_EM.raw = 4;
  stop.Q_SCALE.raw = 1;
  stop.Q_DIR.raw = 1;
  stop.D_EMERGENCYSTOP.raw = 500;
  information.M_VERSION = 17;
  keep_message(stop);
  release();
  ASSERT_EQ(state.emergency_stops.pending.size(), 1u);
  EXPECT_EQ(state.emergency_stops.pending[0].at, at(1400.0));
}

TEST_F(Buffer, WhatStillWaitsIsKept) {  // 4.8.5.2
  state.level.level = Level::L1;
  state.level_transition.pending.emplace().to.level = Level::L2;
  keep_message(lang::Message16{});
  const BufferedSet before = state.buffer[0];
  release();
  ASSERT_EQ(state.buffer.size(), 1u);
  EXPECT_TRUE(state.buffer[0].message_waits);
  EXPECT_EQ(state.buffer[0].waiting, 0u);
  EXPECT_EQ(state.buffer[0].size, before.size);
  EXPECT_FALSE(state.emergency_stops.any());
}

TEST_F(Buffer, OfASetThatWaitsAgainOnlyWhatIsThere) {  // 4.8.5.2
  state.level.level = Level::L2;
  state.level_transition.pending.emplace().to.level = Level::L1;
  lang::Packet21 gradient;
  gradient.Q_DIR.raw = 1;
  add_telegram(keep_packets(3), telegram(210, gradient), 210);
  release();
  ASSERT_EQ(state.buffer.size(), 1u);
  EXPECT_EQ(state.buffer[0].waiting, 1u);
}

TEST_F(Buffer, AMessageThatIsExecutedNoLongerWaits) {  // 4.8.5.2
  state.level_transition.pending.emplace().to.level = Level::L2;
  lang::Packet21 gradient;
  gradient.Q_DIR.raw = 1;
  lang::Message8 m;
  m.NID_LRBG.raw = (1u << 14) | 100u;
  std::array<std::uint8_t, 64> bytes{};
  BitWriter writer(bytes);
  lang::encode_message(writer, m, gradient);
  information.medium = Medium::rbc;
  add_bits(keep(reception, information, {1, true}), {bytes.data(), writer.position() / 8});
  release();
  ASSERT_EQ(state.buffer.size(), 1u);
  EXPECT_FALSE(state.buffer[0].message_waits);
  EXPECT_EQ(state.buffer[0].waiting, 1u);
}

TEST_F(Buffer, ANewerFormTakesThePlaceOfTheOlderOne) {  // 6.6.3.2.3 [13]
  const lang::Packet39_v1_0 older{{1}, {1}, {100}, {1}};
  lang::Packet239 newer;
  newer.Q_DIR.raw = 1;
  newer.Q_SCALE.raw = 1;
  newer.M_VOLTAGE.raw = 1;
  newer.NID_CTRACTION.raw = 7;
  const auto taken = [&] {
    const auto NID_CTRACTION = state.track.traction ? state.track.traction->NID_CTRACTION : 0;
    state.track.traction.reset();
    return NID_CTRACTION;
  };
  std::vector<std::uint8_t> bytes = telegram(830, older, newer);
  bytes[0] = static_cast<std::uint8_t>((bytes[0] & 0x80) | 17);  // M_VERSION
  add_telegram(keep_packets(1), bytes, 830);
  release();
  EXPECT_EQ(taken(), 7);
  lang::Message24 m;
  m.NID_LRBG.raw = (1u << 14) | 100u;
  bytes.assign(64, 0);
  BitWriter writer(bytes);
  lang::encode_message(writer, m, older, newer);
  information.medium = Medium::rbc;
  state.level.level = Level::L2;
  information.M_VERSION = 17;
  add_bits(keep_packets(1), {bytes.data(), writer.position() / 8});
  release();
  EXPECT_EQ(taken(), 7);
}

TEST_F(Buffer, HoldsTheNewestThreeSets) {  // 4.8.5.1, 4.8.5.3
  for (std::uint64_t n = 1; n <= 3; ++n) keep_packets(n);
  EXPECT_FALSE(happened(What::buffer_full));
  keep_packets(4);
  EXPECT_TRUE(happened(What::buffer_full));
  ASSERT_EQ(state.buffer.size(), 3u);
  EXPECT_EQ(state.buffer[0].waiting, 2u);
  EXPECT_EQ(state.buffer[2].waiting, 4u);
}

TEST_F(Buffer, HoldsTheNewestThreeSetsOfEachCause) {  // 4.8.5.1, 4.8.5.3
  const auto keep_of = [&](bool accepting, std::uint64_t waiting) {
    information.sender = accepting ? SessionRole::accepting : SessionRole::supervising;
    keep_packets(waiting);
  };
  keep_of(false, 1);
  for (std::uint64_t n = 2; n <= 4; ++n) keep_of(true, n);
  keep_of(false, 5);
  EXPECT_FALSE(happened(What::buffer_full));
  keep_of(true, 6);
  EXPECT_TRUE(happened(What::buffer_full));
  ASSERT_EQ(state.buffer.size(), 5u);
  const std::uint64_t left[] = {1, 3, 4, 5, 6};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(state.buffer[i].waiting, left[i]);
}

TEST_F(Buffer, ASetOfTheAcceptingRBCWaitsForTheChangeOfRBC) {  // 4.8.2.1
  state.level.level = Level::L2;
  lang::Packet21 gradient;
  gradient.Q_DIR.raw = 1;
  lang::Message8 m;
  m.NID_LRBG.raw = (1u << 14) | 100u;
  std::array<std::uint8_t, 64> bytes{};
  BitWriter writer(bytes);
  lang::encode_message(writer, m, gradient);
  information.medium = Medium::rbc;
  information.sender = SessionRole::accepting;
  add_bits(keep(reception, information, {1, false}), {bytes.data(), writer.position() / 8});
  release();  // by a change of level meanwhile
  ASSERT_EQ(state.buffer.size(), 1u);
  EXPECT_TRUE(state.track.gradient.empty());
  state.buffer[0].accepting = false;  // it supervises now
  release();
  EXPECT_TRUE(state.buffer.empty());
  EXPECT_FALSE(state.track.gradient.empty());
}

TEST_F(Buffer, OfAnUnlinkedGroupHangsOnIt) {  // 3.6.4.7, 3.6.4.2.4 of 4.0.0
  information.anchor = Anchor::unlinked;
  information.widening = {{}, {10.0}, {20.0}};
  lang::Packet65 restriction;
  restriction.Q_DIR.raw = 1;
  restriction.Q_SCALE.raw = 1;
  restriction.D_TSR.raw = 500;
  restriction.L_TSR.raw = 100;
  restriction.V_TSR.raw = 8;
  BufferedSet& set = keep_packets(1);
  EXPECT_EQ(set.anchor, Anchor::unlinked);
  EXPECT_EQ(set.widening, information.widening);
  add_telegram(set, telegram(210, restriction), 210);
  release();
  ASSERT_EQ(state.track.tsr.size(), 1u);
  EXPECT_EQ(state.track.tsr[0].from, at(1390.0));
  EXPECT_EQ(state.track.tsr[0].to, at(1520.0));
  EXPECT_EQ(state.track.tsr[0].anchor, Anchor::unlinked);
}

TEST_F(Buffer, ASetHoldsWhatIsGivenToIt) {  // 4.8.5.1
  information.orientation = Direction::reverse;
  information.M_VERSION = 17;
  BufferedSet& set = keep(reception, information, {5, true});
  EXPECT_EQ(set.medium, Medium::balise);
  EXPECT_EQ(set.group, (GroupId{1, 100}));
  EXPECT_EQ(set.reference, at(900.0));
  EXPECT_EQ(set.orientation, Direction::reverse);
  EXPECT_EQ(set.min_safe_front, at(880.0));
  EXPECT_EQ(set.received, Duration{90.0});
  EXPECT_EQ(set.waiting, 5u);
  EXPECT_TRUE(set.message_waits);
  EXPECT_EQ(set.M_VERSION, 17);
  EXPECT_EQ(set.size, 0);
  std::vector<std::uint8_t> bytes(set.bytes.size() + 1, 0xA5);
  add_telegram(set, bytes, 830);
  EXPECT_EQ(set.size, set.bytes.size()) << "no more than fits";
  EXPECT_EQ(set.bytes.back(), 0xA5);
  // The next one in the same place begins empty.
  state.buffer.clear();
  BufferedSet& next = keep(reception, information, {1, false});
  EXPECT_EQ(next.size, 0);
  EXPECT_TRUE(next.telegram_bits.empty());
  EXPECT_FALSE(next.message_waits);
}

}  // namespace
}  // namespace evc::kernel
