#include "kernel/intake/system_version.h"

#include <gtest/gtest.h>

#include "kernel/intake/test_message.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_2.h"
#include "lang/packets/packet_3.h"

// The operated system version (3.17.2).
namespace evc::kernel {
namespace {

using test::at;

constexpr radio::Rbc kOneRbc{1, 10, 1010}, kNextRbc{1, 20, 2020};

class OperatedVersion : public test::OneMessage {
 protected:
  OperatedVersion() {
    information.medium = Medium::balise;
    state.mode = Mode::SR;
    state.level.level = Level::L1;
  }
  /// The X that is operated after a group with the packets added before.
  int after_group(std::uint8_t operated, std::uint8_t X, bool other_country = false) {
    state.operated_X = operated;
    information.version = SenderVersion{X, other_country};
    reception.order.reset();
    evaluate_now();
    return state.operated_X;
  }
  void add_order(std::uint8_t M_VERSION) {
    lang::Packet2 p;
    p.M_VERSION.raw = M_VERSION;
    add(p);
  }
  /// A session with an RBC of version X = 1 is established.
  void establish(radio::Session& session, const radio::Rbc& rbc, std::uint8_t M_VERSION = 0x11) {
    session.phase = radio::Phase::up;
    session.rbc = rbc;
    session.M_VERSION = M_VERSION;
  }
  int of_rbc(Level level, Level before, std::uint8_t operated = 2) {
    out = {};
    state.operated_X = operated;
    state.level.level = level;
    operate_version_of_rbc(reception, before);
    return state.operated_X;
  }
  Clause clause() const {
    for (const Event& e : out.events)
      if (e.what == What::version_operated) return e.clause;
    return {};
  }
};

TEST_F(OperatedVersion, OnlyAHigherXOfAGroupIsOperated) {  // 3.17.2.3
  EXPECT_EQ(after_group(1, 1), 1);
  EXPECT_EQ(after_group(1, 2), 2);
  EXPECT_EQ(clause(), "3.17.2.3"_srs);
  EXPECT_EQ(after_group(2, 1), 2);
  EXPECT_FALSE(happened(What::version_operated));
}

TEST_F(OperatedVersion, AnotherCountryLowersIt) {  // 3.17.2.6
  EXPECT_EQ(after_group(2, 1, true), 1);
  EXPECT_EQ(clause(), "3.17.2.6"_srs);
}

TEST_F(OperatedVersion, AnOrderOfASupportedXCounts) {  // 3.17.2.5, 3.17.2.7
  add_order(0x10);
  EXPECT_EQ(after_group(2, 2), 1);
  EXPECT_EQ(clause(), "3.17.2.5"_srs);
  expect(2, What::packet_accepted);
  information.packets.clear();
  add_order(0x20);
  EXPECT_EQ(after_group(1, 1), 2);
  EXPECT_EQ(clause(), "3.17.2.5"_srs);
  for (const std::uint8_t M_VERSION : {std::uint8_t{0x30}, std::uint8_t{0x00}}) {
    information.packets.clear();
    add_order(M_VERSION);
    EXPECT_EQ(after_group(1, 2), 1) << int{M_VERSION};
    EXPECT_EQ(after_group(2, 1, true), 2) << int{M_VERSION};
  }
}

TEST_F(OperatedVersion, NothingOfItInAMessageThatIsNoGroupOfNow) {
  add_order(0x10);
  state.operated_X = 2;
  evaluate_now();
  EXPECT_EQ(state.operated_X, 2);
}

TEST_F(OperatedVersion, IsNotManagedInEveryMode) {  // 4.5.2
  add_order(0x10);
  state.mode = Mode::NP;
  EXPECT_EQ(after_group(2, 2), 2);
  EXPECT_EQ(after_group(1, 2), 1);
  establish(state.radio.supervising.session, kOneRbc);
  EXPECT_EQ(of_rbc(Level::L2, Level::L2), 2);
}

TEST_F(OperatedVersion, CountriesOfTheGroupsOwnValuesIn_4_0_0) {  // 3.17.2.6
  lang::Packet3 p;
  p.D_VALIDNV.raw = 32767;
  p.NID_C.raw = 7;
  EXPECT_TRUE(p.areas.push_back({lang::var::NID_C{1}}));
  add(p);
  EXPECT_EQ(after_group(2, 1, true), 1);
  state.srs = SrsVersion::v4_0_0;
  EXPECT_EQ(after_group(2, 1, true), 2);
  information.group.NID_C = 2;
  EXPECT_EQ(after_group(2, 1, false), 1);
  information.packets.clear();
  p.D_VALIDNV.raw = 100;  // not at once
  add(p);
  EXPECT_EQ(after_group(2, 1, false), 2);
  information.packets.clear();
  lang::Packet136 infill;
  infill.NID_BG.raw = 300;
  add(infill);
  p.D_VALIDNV.raw = 32767;
  add(p);
  EXPECT_EQ(after_group(2, 1, false), 2) << "values at another group are not its own";
}

TEST_F(OperatedVersion, ThatOfTheRbcInLevels2And3) {  // 3.17.2.8 a, b, d
  radio::Session& session = state.radio.supervising.session;
  establish(session, kOneRbc);
  EXPECT_EQ(of_rbc(Level::L1, Level::L1), 2);
  EXPECT_EQ(of_rbc(Level::L2, Level::L1), 1);
  EXPECT_EQ(clause(), "3.17.2.8 a"_srs);
  EXPECT_EQ(of_rbc(Level::L3, Level::L3), 1);
  EXPECT_EQ(clause(), "3.17.2.8 b"_srs);
  EXPECT_EQ(after_group(1, 2), 1) << "the group does not count";
  for (const radio::Phase phase :
       {radio::Phase::connecting, radio::Phase::waiting_version, radio::Phase::terminating}) {
    session.phase = phase;
    EXPECT_EQ(of_rbc(Level::L2, Level::L2), 2);
    EXPECT_EQ(after_group(1, 2), 2);
  }
  session.phase = radio::Phase::lost;
  EXPECT_EQ(of_rbc(Level::L2, Level::L2), 1);
}

TEST_F(OperatedVersion, ThatOfTheLevelThatTheGroupOrders) {  // 3.17.2.8.1, .2
  establish(state.radio.supervising.session, kOneRbc);
  add(order_to(3, 32767));
  EXPECT_EQ(after_group(2, 2), 1);
  EXPECT_EQ(clause(), "3.17.2.8 a"_srs);
  information.packets.clear();
  add(order_to(2, 32767));
  state.level.level = Level::L2;
  EXPECT_EQ(after_group(1, 2), 2);
  EXPECT_EQ(clause(), "3.17.2.3"_srs);
}

TEST_F(OperatedVersion, ThatOfTheAcceptingRbcBeyondTheBorder) {  // 3.17.2.8 c, e
  establish(state.radio.supervising.session, kOneRbc, 0x21);
  establish(state.radio.other.session, kNextRbc);
  state.handover.order =
      track::RbcTransition{at(1000.5), kNextRbc.NID_C, kNextRbc.NID_RBC, kNextRbc.NID_RADIO, false, {}};
  EXPECT_EQ(of_rbc(Level::L2, Level::L2), 2);
  received.here.max_safe_front = at(1000.5);
  EXPECT_EQ(of_rbc(Level::L2, Level::L2), 1);
  EXPECT_EQ(clause(), "3.17.2.8 c"_srs);
  establish(state.radio.other.session, {1, 30, 3030});
  EXPECT_EQ(of_rbc(Level::L2, Level::L2), 2) << "a third RBC";
  state.radio.other.session = {};
  EXPECT_EQ(of_rbc(Level::L2, Level::L2, 1), 1) << "no session with it: nothing changes";
  EXPECT_EQ(after_group(1, 2), 2);
  // The accepting RBC supervises.
  establish(state.radio.supervising.session, kNextRbc);
  EXPECT_EQ(of_rbc(Level::L2, Level::L2), 1);
  received.here.max_safe_front = at(1000.0);
  EXPECT_EQ(of_rbc(Level::L2, Level::L2), 1) << "relocated to a place in rear of the border";
}

}  // namespace
}  // namespace evc::kernel
