#include "kernel/intake/loops.h"

#include <gtest/gtest.h>

#include "kernel/cab.h"
#include "kernel/intake/test_message.h"
#include "lang/packets/packet_13.h"
#include "lang/packets/packet_134.h"

// Euroloop: the announcement, the area, the SR distance (3.4.5, 4.4.11.1.3.1 c).
namespace evc::kernel {
namespace {

using test::at;

/// A train at 1000 m whose LRBG is group 100 at 950 m.
class Loops : public test::OneMessage {
 protected:
  Loops() {
    restart();
    information.medium = Medium::balise;
  }
  void restart(Mode mode = Mode::SR) {
    state = State{};
    state.mode = mode;
    state.level.level = Level::L1;
    state.srs = SrsVersion::v4_0_0;
    state.train.L_antenna_front = {10.0};
    moves_to(1000.0);
    position::Reference group;
    group.id = {1, 100};
    group.place = at(950.0);
    group.counter.nominal = group.counter.min = group.counter.max = {{950.0}};
    group.orientation = Direction::nominal;
    (void)state.position.references.push_back(group);
  }
  void moves_to(double counter) {
    position::Odometry o;
    o.counter = {{{counter}}, {{counter}}, {{counter}}};
    position::update(state.position, o, state.now);
  }
  void evaluate_one() {
    evaluate_now();
    information.packets.clear();
  }
  void announce(lang::Packet134 p) {
    p.Q_SCALE.raw = 1;
    add(p);
    evaluate_one();
  }
  static lang::Packet134 loop(std::uint16_t NID_LOOP) {
    lang::Packet134 p;
    p.NID_LOOP.raw = NID_LOOP;
    p.D_LOOP.raw = 100;
    p.L_LOOP.raw = 300;
    p.Q_LOOPDIR.raw = 1;
    return p;
  }
  /// Group 101 is at the signal.
  static lang::Packet13 distance(std::uint16_t NID_BG, std::uint16_t D_SR) {
    lang::Packet13 p;
    p.Q_SCALE.raw = 1;
    p.NID_BG_MAIN.raw = 101;
    p.NID_BG.raw = NID_BG;
    p.D_SR.raw = D_SR;
    return p;
  }
  void gives(const lang::Packet13& p) {
    information.medium = Medium::loop;
    information.located = false;
    add(p);
    evaluate_one();
    information.medium = Medium::balise;
    information.located = true;
  }
  std::optional<Place> end() const { return state.staff_responsible.end; }
};

TEST_F(Loops, TheAnnouncementHoldsLoopAndArea) {  // 3.4.5.1.3, 3.4.5.1.5
  information.anchor = Anchor::unlinked;
  announce(loop(7));
  ASSERT_TRUE(state.loop);
  EXPECT_EQ(state.loop->NID_C, 1);
  EXPECT_EQ(state.loop->NID_LOOP, 7);
  EXPECT_EQ(state.loop->orientation, Direction::nominal);
  EXPECT_EQ(state.loop->anchor, Anchor::unlinked);
  EXPECT_EQ(state.loop->from, at(950.0));
  EXPECT_EQ(state.loop->to, at(1350.0));
  EXPECT_EQ(state.loop->status, DataStatus::valid);
  for (const bool of_D_LOOP : {true, false}) {
    lang::Packet134 p = loop(8);
    (of_D_LOOP ? p.D_LOOP.raw : p.L_LOOP.raw) = 32767;
    announce(p);
    EXPECT_FALSE(state.loop->to) << of_D_LOOP;
  }
}

TEST_F(Loops, TheDirectionOfTheLoopIsThatOfTheGroupOrTheOther) {  // 3.4.5.1.3, 3.6.3.1.1
  lang::Packet134 p = loop(7);
  p.Q_LOOPDIR.raw = 0;
  announce(p);
  EXPECT_EQ(state.loop->orientation, Direction::reverse);
  state.position.references.back().orientation = Direction::reverse;
  announce(p);
  EXPECT_EQ(state.loop->orientation, Direction::nominal);
  state.position.references.back().orientation = Direction::unknown;
  announce(p);
  EXPECT_EQ(state.loop->orientation, Direction::unknown);
}

TEST_F(Loops, TheDirectionInShuntingIsThatOfTheTrainNotOfTheCrossing) {  // 3.6.3.1.3.1
  restart(Mode::SH);
  information.orientation = Direction::nominal;  // crossed backwards
  state.position.references.back().orientation = Direction::reverse;
  state.srs = SrsVersion::v3_6_0;
  announce(loop(7));
  ASSERT_TRUE(state.loop);
  EXPECT_EQ(state.loop->orientation, Direction::reverse);
  information.group = {1, 110};  // unlinked
  announce(loop(8));
  EXPECT_EQ(state.loop->orientation, Direction::unknown);
  position::Reference unlinked;
  unlinked.id = {1, 110};
  unlinked.orientation = Direction::nominal;
  state.position.unlinked = unlinked;
  announce(loop(8));
  EXPECT_EQ(state.loop->orientation, Direction::nominal);
}

TEST_F(Loops, TheAreaEndsBehindTheMinSafeAntenna) {  // 3.4.5.1.6
  announce(loop(7));
  const auto left_at = [&](double front) {
    out = {};
    moves_to(front);
    receive_loops(reception);
    return happened(What::loop_left);
  };
  EXPECT_FALSE(left_at(955.0));  // the antenna is in rear of the area, which it has not entered
  EXPECT_FALSE(left_at(1355.0));
  EXPECT_TRUE(left_at(1380.0));
  EXPECT_FALSE(state.loop);
  EXPECT_FALSE(left_at(1390.0));
}

TEST_F(Loops, BackwardsTheAreaEndsInRearOfItsStart) {  // 3.4.5.1.6
  announce(loop(7));
  const auto stays_at = [&](double front) {
    moves_to(front);
    receive_loops(reception);
    return state.loop.has_value();
  };
  EXPECT_TRUE(stays_at(1000.0));
  EXPECT_TRUE(stays_at(970.0));
  EXPECT_FALSE(stays_at(940.0));
}

TEST_F(Loops, WithoutAnEndTheAreaIsNotLeftForwards) {  // 3.4.5.1.6
  lang::Packet134 p = loop(7);
  p.D_LOOP.raw = 32767;
  announce(p);
  moves_to(9000.0);
  receive_loops(reception);
  EXPECT_TRUE(state.loop);
}

TEST_F(Loops, AChangeOfCabMirrorsTheArea) {  // 5.12.2.5
  TrainSignals train;
  train.desk_open = true;
  train.cab = Cab::B;
  announce(loop(7));
  follow_cab(state, train, reception.log);
  ASSERT_TRUE(state.loop);
  EXPECT_EQ(state.loop->orientation, Direction::reverse);
  EXPECT_EQ(state.loop->from, at(-1350.0));
  EXPECT_EQ(state.loop->to, at(-950.0));
  restart();
  lang::Packet134 p = loop(7);
  p.L_LOOP.raw = 32767;
  announce(p);
  follow_cab(state, train, reception.log);
  EXPECT_FALSE(state.loop->from);
  EXPECT_EQ(state.loop->to, at(-950.0));
  moves_to(955.0);
  receive_loops(reception);
  EXPECT_TRUE(state.loop) << "its antenna is still in the area";
  moves_to(900.0);
  receive_loops(reception);
  EXPECT_FALSE(state.loop);
}

TEST_F(Loops, UpTo3_6_0TheAreaLimitsNothing) {
  for (const SrsVersion srs : {SrsVersion::v3_4_0, SrsVersion::v3_6_0}) {
    restart();
    state.srs = srs;
    announce(loop(7));
    moves_to(9000.0);
    receive_loops(reception);
    EXPECT_TRUE(state.loop);
  }
}

TEST_F(Loops, TheSRDistanceCountsFromTheLRBG) {  // 4.4.11.1.3.1 c
  announce(loop(7));
  const std::uint32_t revision = state.revision;
  gives(distance(100, 400));
  EXPECT_EQ(end(), at(1350.0));
  EXPECT_NE(state.revision, revision);
  gives(distance(100, 32767));
  EXPECT_FALSE(end()) << "infinite";
  gives(distance(99, 50));
  EXPECT_FALSE(end());
  lang::Packet13 second = distance(99, 50);
  lang::Packet13_groups group;
  group.NID_BG.raw = 100;
  group.D_SR.raw = 300;
  ASSERT_TRUE(second.groups.push_back(group));
  gives(second);
  EXPECT_EQ(end(), at(1250.0));
}

TEST_F(Loops, TheGroupsOfTheSRDistanceHaveCountries) {  // 7.5.1.121
  announce(loop(7));
  lang::Packet13 p = distance(100, 400);
  p.Q_NEWCOUNTRY.raw = 1;
  p.NID_C.raw = 2;
  gives(p);
  EXPECT_FALSE(end());
  lang::Packet13 back = p;  // the second group is of the country of the first one unless it has its own
  lang::Packet13_groups group;
  group.NID_BG.raw = 100;
  group.D_SR.raw = 300;
  ASSERT_TRUE(back.groups.push_back(group));
  gives(back);
  EXPECT_FALSE(end());
  back.groups.back().Q_NEWCOUNTRY.raw = 1;
  back.groups.back().NID_C.raw = 1;
  gives(back);
  EXPECT_EQ(end(), at(1250.0));
  EXPECT_EQ(state.loop->signal, (GroupId{1, 101}));
  lang::Packet13 abroad = distance(100, 400);  // its signal and its first group
  abroad.Q_NEWCOUNTRY_MAIN.raw = 1;
  abroad.NID_C_MAIN.raw = 2;
  gives(abroad);
  EXPECT_EQ(end(), at(1250.0)) << "the group is of country 2 as the signal's is";
}

TEST_F(Loops, WithoutAnLRBGThereIsNoSRDistance) {
  announce(loop(7));
  state.position.references.clear();
  gives(distance(100, 400));
  EXPECT_FALSE(end());
}

TEST_F(Loops, BeyondTheSignalTheSRDistanceIsIgnored) {  // 4.4.11.1.6.7
  announce(loop(7));
  note_signal_of_loop(state, {1, 101});
  gives(distance(100, 400));
  EXPECT_EQ(end(), at(1350.0)) << "it was not named before";
  note_signal_of_loop(state, {1, 102});
  gives(distance(100, 300));
  EXPECT_EQ(end(), at(1250.0));
  state.mode = Mode::FS;
  note_signal_of_loop(state, {1, 101});
  state.mode = Mode::SR;
  gives(distance(100, 200));
  EXPECT_EQ(end(), at(1150.0));
  note_signal_of_loop(state, {1, 101});
  gives(distance(100, 100));
  EXPECT_EQ(end(), at(1150.0));
  announce(loop(7));
  gives(distance(100, 100));
  EXPECT_EQ(end(), at(1150.0)) << "the same loop";
  announce(loop(8));
  gives(distance(100, 100));
  EXPECT_EQ(end(), at(1050.0)) << "another loop";
}

TEST_F(Loops, OutsideSRTheSameLoopBeginsAnew) {  // 4.4.11.1.6.7
  announce(loop(7));
  gives(distance(100, 400));
  note_signal_of_loop(state, {1, 101});
  state.mode = Mode::FS;
  announce(loop(7));
  EXPECT_FALSE(state.loop->signal_passed);
  EXPECT_FALSE(state.loop->signal);
}

}  // namespace
}  // namespace evc::kernel
