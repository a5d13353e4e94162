#include <gtest/gtest.h>

#include "radio/radio.h"
#include "radio/testing.h"

namespace evc::radio {
namespace {

using namespace testing;

constexpr Rbc kThird{426, 3, 0x0031840880152FFF};

/// A unit in session with kRbc and, as the accepting RBC, with kOther.
struct Both : Unit {
  Both() {
    up();
    call_accepting(s, kOther, Duration{now}, out);
    cycle();
    link(RadioLink::connected);
    fresh();
    EXPECT_EQ(from_other(32), Rejected::no);
    receive_version(s, 0x21, Duration{now}, out, Peer::other);
    cycle();
    fresh();
  }
  Result link(RadioLink report, Peer peer = Peer::other) {
    in.link_of = peer;
    const Result r = cycle(report);
    in.link_of = Peer::supervising;
    return r;
  }
  Rejected from_other(std::uint8_t NID_MESSAGE) {
    return receive(s, {NID_MESSAGE, T_TRAIN_of(Duration{now}), false}, Duration{now}, out, Peer::other);
  }
  Ids to(Peer peer) const {
    Ids ids;
    for (const Intent& i : out.messages)
      if (i.to == peer) ids.push_back(i.NID_MESSAGE);
    return ids;
  }
};

TEST(Partners, TheAcceptingRbcHasASessionOfItsOwn) {  // 3.15.1.3.1 a, 3.15.1.3.3
  Unit u;
  u.up();
  call_accepting(u.s, kOther, Duration{u.now}, u.out);
  EXPECT_EQ(u.out.connect, kOther);
  EXPECT_FALSE(u.out.disconnect);
  EXPECT_TRUE(u.s.other_accepts);
  Both both;
  EXPECT_TRUE(both.s.supervising.session.established() && both.s.other.session.established());
  EXPECT_EQ(both.s.contact, kRbc) << "up to the border";
  EXPECT_TRUE(both.s.other.train_data_stamp) << "129 was sent to it";
  EXPECT_FALSE(both.s.supervising.train_data_stamp);
}

TEST(Partners, ReportsGoToBoth) {  // 3.15.1.3.4
  Both u;
  u.in.report_due = true;
  EXPECT_TRUE(u.cycle().reported_to_other);
  EXPECT_EQ(u.to(Peer::supervising), Ids{136});
  EXPECT_EQ(u.to(Peer::other), Ids{136});
  EXPECT_NE(u.out.messages[0].T_TRAIN, u.out.messages[1].T_TRAIN);
}

TEST(Partners, OneThatIsLostGetsNothing) {  // 3.5.4.5
  Both u;
  u.link(RadioLink::lost);
  u.fresh();
  u.in.report_due = true;
  EXPECT_FALSE(u.cycle().reported_to_other);
  EXPECT_EQ(u.to(Peer::supervising), Ids{136});
  EXPECT_TRUE(u.to(Peer::other).empty());
}

TEST(Partners, EachHasItsOwnOrderOfMessages) {  // 3.16.3.3.3
  Both u;
  EXPECT_EQ(receive(u.s, {24, T_TRAIN_of(Duration{u.now + 5}), false}, Duration{u.now}, u.out), Rejected::no);
  EXPECT_EQ(u.from_other(24), Rejected::no);
  EXPECT_EQ(u.message(24), Rejected::time_stamp);
}

TEST(Partners, OnlyTheSupervisingOneCountsForTheContact) {  // 3.16.3.4.1.2
  Both u;
  const std::optional<Duration> before = u.s.contact_reference;
  u.now += 10;
  EXPECT_EQ(u.from_other(24), Rejected::no);
  EXPECT_EQ(u.s.contact_reference, before);
  u.now += 10;
  exchange(u.s, Duration{u.now});
  EXPECT_NEAR(u.s.contact_reference->si, u.now - 10, 0.02);
  EXPECT_EQ(u.s.supervising.session.rbc, kOther);
  EXPECT_EQ(u.s.other.session.rbc, kRbc);
  EXPECT_FALSE(u.s.other_accepts);
}

TEST(Partners, AnInputWithoutANameIsOfTheOneCalledLast) {
  Both u;
  EXPECT_EQ(peer_of(u.s, std::nullopt), Peer::other);
  EXPECT_EQ(peer_of(u.s, kRbc), Peer::supervising);
  EXPECT_EQ(peer_of(u.s, kOther), Peer::other);
  EXPECT_EQ(peer_of(u.s, kThird), std::nullopt);
  exchange(u.s, Duration{u.now});
  EXPECT_EQ(peer_of(u.s, std::nullopt), Peer::supervising) << "the same RBC";
  terminate_all(u.s, Duration{u.now}, u.out);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::terminating);
  EXPECT_EQ(u.s.other.session.phase, Phase::terminating);
}

TEST(Partners, AnOrderConcernsTheOneThatItNames) {  // 3.5.3.5.2.1, 3.5.5.1 a
  Both u;
  u.order_session(kOther);
  EXPECT_TRUE(u.out.messages.empty()) << "a session with it is up";
  u.order_session(kOther, false);
  EXPECT_EQ(u.to(Peer::other), Ids{156});
  EXPECT_TRUE(u.to(Peer::supervising).empty());
}

TEST(Partners, AThirdRbcEndsBothSessions) {  // 3.5.3.5.2
  Both u;
  u.order_session(kThird);
  EXPECT_EQ(u.to(Peer::supervising), Ids{156});
  EXPECT_EQ(u.to(Peer::other), Ids{156});
  u.cycle();
  u.fresh();
  EXPECT_EQ(u.from_other(39), Rejected::no);
  EXPECT_EQ(u.message(39), Rejected::no);
  u.cycle();
  EXPECT_EQ(u.out.disconnect, kOther);
  EXPECT_EQ(u.out.connect, kThird);
  u.fresh();
  u.cycle();
  EXPECT_EQ(u.out.disconnect, kRbc) << "one order to the bearer in a cycle";
}

TEST(Partners, OneRequestInACycle) {
  Both u;
  u.link(RadioLink::lost, Peer::supervising);
  EXPECT_EQ(u.out.connect, kRbc);
  u.fresh();
  u.link(RadioLink::lost);
  EXPECT_EQ(u.out.connect, kOther);
  u.fresh();
  u.in.in_radio_hole = true;
  u.link(RadioLink::refused, Peer::supervising);
  u.link(RadioLink::refused);
  u.in.in_radio_hole = false;
  u.fresh();
  u.cycle();
  EXPECT_EQ(u.out.connect, kRbc);
  u.fresh();
  u.cycle();
  EXPECT_EQ(u.out.connect, kOther);
}

TEST(Partners, ASetUpThatIsAbortedIsNotBegunAgain) {  // 3.5.3.8
  Unit u;
  u.order_session();
  abort_set_ups(u.s, Duration{u.now}, u.out);
  EXPECT_EQ(u.out.disconnect, kRbc);
  EXPECT_EQ(u.s.supervising.session.phase, Phase::idle);
  Both both;
  abort_set_ups(both.s, Duration{both.now}, both.out);
  EXPECT_TRUE(both.s.supervising.session.established()) << "sessions stay";
}

TEST(RadioInfillUnits, AreBesideTheRbcs) {  // 3.9.3.6
  State s;
  const Rbc unit{426, 1, 7, true}, neighbour{426, 2, 8, true};
  s.supervising.session.rbc = {426, 1, 7};
  s.supervising.session.phase = Phase::up;
  EXPECT_FALSE(s.supervising.session.rbc.same_id(unit)) << "the numbers of RBCs and infill units are their own";
  EXPECT_EQ(sessions(s), 1u);
  EXPECT_FALSE(infill_unit(s, unit));
  s.session(Peer::infill_1).phase = Phase::up;
  s.session(Peer::infill_1).rbc = unit;
  s.session(Peer::infill_2).phase = Phase::connecting;
  s.session(Peer::infill_2).rbc = neighbour;
  EXPECT_EQ(sessions(s), 3u);
  EXPECT_EQ(infill_unit(s, unit), Peer::infill_1);
  EXPECT_EQ(infill_unit(s, neighbour), Peer::infill_2);
  EXPECT_EQ(peer_of(s, unit, true), Peer::infill_1);
  EXPECT_EQ(peer_of(s, neighbour, true), Peer::infill_2);
  EXPECT_FALSE(peer_of(s, Rbc{426, 3, 0, true}, true));
  EXPECT_EQ(peer_of(s, std::nullopt, true), Peer::infill_1);
  EXPECT_EQ(peer_of(s, std::nullopt), Peer::supervising);
}

TEST(RadioInfillUnits, TheOneCalledLastIsRemembered) {
  State s;
  Outbox out;
  Inputs in;
  s.session(Peer::infill_2).phase = Phase::connecting;
  s.session(Peer::infill_2).rbc = {426, 2, 8, true};
  (void)supervise(s, in, out);
  ASSERT_EQ(out.connect, s.session(Peer::infill_2).rbc);
  note_called(s, *out.connect);
  EXPECT_EQ(peer_of(s, std::nullopt, true), Peer::infill_2);
  EXPECT_EQ(peer_of(s, std::nullopt), Peer::supervising);
}

TEST(RadioInfillUnits, SayNothingOfTheRbc) {  // 3.16.3.4, 3.16.4
  State s;
  Outbox out;
  const Duration now{100.0};
  Session& session = s.session(Peer::infill_1);
  session.phase = Phase::waiting_version;
  session.rbc = {426, 1, 7, true};
  EXPECT_EQ(receive(s, {32, 9000, false}, now, out, Peer::infill_1), Rejected::no);
  EXPECT_TRUE(receive_version(s, 0x21, now, out, Peer::infill_1));
  EXPECT_FALSE(receive_version(s, 0x21, now, out, Peer::infill_1)) << "it is open";
  EXPECT_EQ(session.M_VERSION, 0x21);
  EXPECT_FALSE(s.contact_reference);
  EXPECT_FALSE(s.contact);
  EXPECT_FALSE(s.supervising.train_data_pending);
  EXPECT_EQ(receive(s, {24, 9000, false}, now, out, Peer::infill_1), Rejected::time_stamp);
  EXPECT_TRUE(s.errors.empty());
  EXPECT_EQ(receive(s, {24, 9001, true}, now, out, Peer::infill_1), Rejected::no);
  EXPECT_EQ(out.messages.back().to, Peer::infill_1);
}

TEST(RadioInfillUnits, ALostSessionEndsAfterItsTime) {  // 3.5.4.2.1
  State s;
  Outbox out;
  Inputs in;
  s.session(Peer::infill_1).phase = Phase::lost;
  s.session(Peer::infill_1).rbc = {426, 1, 7, true};
  in.now = Duration{301.0};
  EXPECT_TRUE(supervise(s, in, out).session_lost);
}

}  // namespace
}  // namespace evc::radio
