#include "kernel/intake/radio_messages.h"

#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "kernel/intake/test_message.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_15.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_239.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_39.h"
#include "lang/testing.h"

// A radio message before its contents are judged: consistency, sequence, reference and time stamp (3.16.3, 3.6.2).
namespace evc::kernel {
namespace {

using lang::testing::M_VERSION_1_1;
using lang::testing::M_VERSION_2_1;
using lang::testing::M_VERSION_2_2;
using test::at;

class RadioReception : public test::OneMessage {
 protected:
  RadioReception() {
    state.now = {100.0};
    state.radio.supervising.session.phase = radio::Phase::up;
    state.radio.supervising.session.M_VERSION = M_VERSION_2_1;
    state.data.train_data_status = DataStatus::valid;
    remember(Direction::nominal);
  }
  /// Group 100 at 950 m.
  void remember(Direction orientation) {
    position::Reference lrbg;
    lrbg.id = {1, 100};
    lrbg.place = at(950.0);
    lrbg.orientation = orientation;
    state.position.references.clear();
    ASSERT_TRUE(state.position.references.push_back(lrbg));
  }
  template <class M, class... P>
  static std::vector<std::uint8_t> bits(M m, const P&... contents) {
    m.T_TRAIN.raw = 9000;  // 90 s
    std::vector<std::uint8_t> bytes(256);
    BitWriter writer(bytes);
    lang::encode_message(writer, m, contents...);
    EXPECT_FALSE(writer.faulty());
    bytes.resize(writer.position() / 8);
    return bytes;
  }
  template <class M>
  static M from(M m, std::uint32_t NID_BG = 100) {
    m.NID_LRBG.raw = (1u << 14) | NID_BG;
    return m;
  }
  void receive(const std::vector<std::uint8_t>& bytes) {
    out = {};
    const RadioMessage messages[]{{bytes}};
    in.radio_messages = messages;
    state.radio.supervising.session.last_T_TRAIN.reset();
    receive_radio(reception);
    in.radio_messages = {};
  }
  void expect_event(What what, std::int32_t NID_MESSAGE, Clause clause) const {
    for (const Event& e : out.events)
      if (e.what == what && e.id == NID_MESSAGE && e.clause == clause) return;
    FAIL() << "not logged";
  }
  /// An authority of 2000 m on a track that is described in the same message.
  template <class M>
  void receive_authority(M m, std::uint8_t Q_DIR = 1) {
    lang::Packet15 authority;
    authority.Q_SCALE.raw = 1;
    authority.L_ENDSECTION.raw = 2000;
    authority.T_EMA.raw = 1023;
    lang::Packet21 gradient;
    lang::Packet27 speeds;
    speeds.V_STATIC.raw = 20;
    authority.Q_DIR.raw = gradient.Q_DIR.raw = speeds.Q_DIR.raw = Q_DIR;
    receive(bits(m, authority, gradient, speeds));
  }
};

TEST_F(RadioReception, AnAuthorityCountsFromItsReference) {  // 3.6.2.2.2 c
  receive_authority(from(lang::Message3{}));
  ASSERT_TRUE(state.track.ma.has_value());
  EXPECT_EQ(state.track.ma->end(), at(2950.0));
}

TEST_F(RadioReception, TheReferenceIsShiftedInTheNominalDirectionOfTheLRBG) {  // 3.6.3.2.5, 7.5.1.22
  const auto end_with = [&](Direction orientation, std::uint8_t Q_DIR) {
    state.track = {};
    remember(orientation);
    lang::Message33 m = from(lang::Message33{});
    m.Q_SCALE.raw = 1;
    m.D_REF.raw = 20;
    receive_authority(m, Q_DIR);
    return state.track.ma ? state.track.ma->end() : Place{};
  };
  EXPECT_EQ(end_with(Direction::nominal, 1), at(2970.0));
  EXPECT_EQ(end_with(Direction::reverse, 0), at(2930.0));
}

TEST_F(RadioReception, AnAuthorityWithoutAReferenceIsRefused) {  // 3.6.2.2.2
  receive_authority(from(lang::Message3{}, 77));
  expect_event(What::message_refused, 3, "3.6.2.2.2"_srs);
  EXPECT_FALSE(state.track.ma.has_value());
}

TEST_F(RadioReception, TimersCountFromTheTimeStamp) {  // 3.8.4.2.1; it is buffered with the stamp, 4.8.5.1
  state.level.level = Level::L1;
  state.level_transition.pending.emplace().to.level = Level::L2;
  receive(bits(from(lang::Message16{})));
  ASSERT_EQ(state.buffer.size(), 1u);
  EXPECT_EQ(state.buffer[0].received, Duration{90.0});
}

TEST_F(RadioReception, ANewerFormTakesThePlaceOfTheOlderOne) {  // 6.6.3.2.3 [13]
  state.radio.supervising.session.M_VERSION = M_VERSION_1_1;
  const lang::Packet39_v1_0 older{{1}, {1}, {100}, {1}};
  lang::Packet239 newer;
  newer.Q_DIR.raw = 1;
  newer.Q_SCALE.raw = 1;
  newer.M_VOLTAGE.raw = 1;
  newer.NID_CTRACTION.raw = 7;
  receive(bits(from(lang::Message24{}), newer, older));
  expect(39, What::packet_accepted);
  ASSERT_TRUE(state.track.traction.has_value());
  EXPECT_EQ(state.track.traction->NID_CTRACTION, 7);
}

TEST_F(RadioReception, TheVersionOfTheRbcIsOperatedFromItsMessageOn) {  // 3.17.2.8 b
  state.mode = Mode::SB;
  state.operated_X = 2;
  state.radio.supervising.session.phase = radio::Phase::waiting_version;
  lang::Message32 m;
  m.M_VERSION.raw = M_VERSION_1_1;
  receive(bits(from(m)));
  EXPECT_EQ(state.operated_X, 1);
}

TEST_F(RadioReception, AnUnknownMessageIsSkippedOnlyInALaterVersion) {  // 3.17.3.11, 3.16.3.1.1
  std::vector<std::uint8_t> unknown = bits(from(lang::Message24{}));
  unknown[0] = 99;  // NID_MESSAGE
  receive(unknown);
  expect_event(What::message_rejected, 99, "3.16.3.1.1"_srs);
  ASSERT_EQ(state.radio.errors.size(), 1u);
  EXPECT_EQ(state.radio.errors[0], ErrorReport::radio_message);
  state.radio.errors.clear();
  state.radio.supervising.session.M_VERSION = M_VERSION_2_2;
  receive(unknown);
  expect_event(What::message_unknown, 99, "3.17.3.11"_srs);
  EXPECT_TRUE(state.radio.errors.empty());
  receive(bits(from(lang::Message24{})));
  EXPECT_TRUE(happened(What::message_accepted)) << "one that it knows";
}

TEST_F(RadioReception, AMessageThatIsNotConsistentIsRejected) {  // 3.16.3.1.1
  std::vector<std::uint8_t> longer = bits(from(lang::Message24{}));
  longer.push_back(0);  // L_MESSAGE is smaller
  receive(longer);
  expect_event(What::message_rejected, 24, "3.16.3.1.1"_srs);
  EXPECT_FALSE(received.new_radio_message);
}

TEST_F(RadioReception, AMessageOutsideASessionIsRejected) {  // 3.5.2.1
  state.radio.supervising.session.phase = radio::Phase::idle;
  receive(bits(from(lang::Message24{})));
  expect_event(What::message_rejected, 24, "3.5.2.1"_srs);
  EXPECT_FALSE(received.new_radio_message);
}

TEST_F(RadioReception, AnInfillAuthorityByRadioIsRefusedByLevel) {  // 4.8.3, 3.9.3.4
  lang::Packet136 reference;
  lang::Packet12 authority;
  reference.Q_DIR.raw = authority.Q_DIR.raw = 1;
  const auto clause_in = [&](Level level) {
    state.level.level = level;
    receive(bits(from(lang::Message37{}), reference, authority));
    for (const Event& e : out.events)
      if (e.what == What::message_refused && e.id == 37) return e.clause;
    return Clause{};
  };
  EXPECT_EQ(clause_in(Level::L1), "3.9.3.4"_srs);
  EXPECT_EQ(clause_in(Level::L0), "4.8.3"_srs);
}

TEST(SessionVersion, IsThatOfTheSessionOrOursUntilItIsKnown) {  // 6.5.1.3, 3.5.3.7 d
  EXPECT_EQ(session_version(0, SrsVersion::v3_6_0), (lang::SystemVersion{2, 1}));
  EXPECT_EQ(session_version(16, SrsVersion::v3_6_0), (lang::SystemVersion{1, 0}));
  EXPECT_EQ(session_version(34, SrsVersion::v4_0_0), (lang::SystemVersion{2, 2}));
  EXPECT_EQ(session_version(48, SrsVersion::v4_0_0), (lang::SystemVersion{3, 0}));
  EXPECT_TRUE(lang::is_later(session_version(34, SrsVersion::v3_6_0)));
}

}  // namespace
}  // namespace evc::kernel
