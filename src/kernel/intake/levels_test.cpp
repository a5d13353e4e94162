#include "kernel/intake/levels.h"

#include <gtest/gtest.h>

#include "kernel/intake/test_message.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_46.h"

// Level transition orders as they are read, and what waits for a level (5.10, 4.8.5).
namespace evc::kernel {
namespace {

using test::at;

class Levels : public test::OneMessage {
 protected:
  Levels() { information.medium = Medium::balise; }
  template <class P>
  procedures::level_transition::Order read(P p) {
    information.packets.clear();
    add(p);
    const auto order = order_of(information.packets[0], SrsVersion::v3_6_0);
    EXPECT_TRUE(order.has_value());
    return order.value_or(procedures::level_transition::Order{});
  }
  void receive(std::uint8_t M_LEVELTR, std::uint16_t D_LEVELTR) {
    information.packets.clear();
    add(order_to(M_LEVELTR, D_LEVELTR));
    evaluate_now();
  }
  void fill_buffer() {
    state.buffer.clear();
    EXPECT_NE(state.buffer.grow(), nullptr);
  }
};

TEST_F(Levels, AnOrderHasItsPlaceLevelsAndAcknowledgementLengths) {  // 7.4.2.9, 5.10.2
  lang::Packet41 p = order_to(2, 500);
  p.L_ACKLEVELTR.raw = 100;
  lang::Packet41_levels ntc;
  ntc.M_LEVELTR.raw = 1;
  ntc.NID_NTC.raw = 9;
  ntc.L_ACKLEVELTR.raw = 200;
  ASSERT_TRUE(p.levels.push_back(ntc));
  const auto order = read(p);
  EXPECT_EQ(order.kind, modes::OrderKind::announcement);
  ASSERT_EQ(order.table.size(), 2u);
  EXPECT_EQ(order.table[0].level, Level::L1);
  EXPECT_EQ(order.table[0].nid_ntc, 0);
  EXPECT_EQ(order.table[0].L_ack, Distance{100.0});
  EXPECT_EQ(order.table[1].level, Level::NTC);
  EXPECT_EQ(order.table[1].nid_ntc, 9);
  EXPECT_EQ(order.table[1].L_ack, Distance{200.0});
  EXPECT_EQ(read(order_to(2, 32767)).kind, modes::OrderKind::immediate);
}

TEST_F(Levels, AnAnnouncedBorderIsPlacedFromTheReference) {  // 4.8.1.6
  receive(2, 500);
  ASSERT_TRUE(reception.order.has_value());
  EXPECT_EQ(reception.order->decision.effect, modes::OrderEffect::announce);
  EXPECT_EQ(reception.order->order.border, at(1450.0));
}

TEST_F(Levels, AConditionalOrderHasNoPlace) {  // 7.4.2.9.2
  lang::Packet46 p;
  p.M_LEVELTR.raw = 3;
  const auto order = read(p);
  EXPECT_EQ(order.kind, modes::OrderKind::conditional);
  ASSERT_EQ(order.table.size(), 1u);
  EXPECT_EQ(order.table[0].level, Level::L2);
  EXPECT_EQ(order.table[0].L_ack, Distance{});
}

TEST_F(Levels, WhatWaitsGoesWithTheOrderItWaitsFor) {  // 4.8.5.4 a
  state.level.level = Level::L2;
  state.level_transition.pending.emplace().to.level = Level::L1;
  fill_buffer();
  receive(2, 500);  // level 1 as before
  EXPECT_EQ(state.buffer.size(), 1u);
  reception.order.reset();
  receive(0, 500);
  EXPECT_TRUE(state.buffer.empty());
}

TEST_F(Levels, AnOrderThatReplacesNoneLeavesWhatWaits) {  // 4.8.5.4 a, 5.10.2.5
  state.level.level = Level::L2;
  state.level_transition.pending.emplace().to.level = Level::L1;
  fill_buffer();
  information.packets.clear();
  lang::Packet46 conditional;
  conditional.M_LEVELTR.raw = 3;  // level 2
  add(conditional);
  reception.order.reset();
  (void)give_order(reception, *order_of(information.packets[0], SrsVersion::v3_6_0));
  EXPECT_EQ(state.buffer.size(), 1u);
}

TEST_F(Levels, AnOrderBehindOneThatIsExecutedIsJudgedFromItsLevel) {  // 5.10.1.6
  state.level.level = Level::L2;
  const auto level_after = [&](std::initializer_list<procedures::level_transition::Order> orders) {
    state.level.level = Level::L2;
    state.level_transition = {};
    state.level_table.reset();
    reception.order.reset();
    reception.announcement.reset();
    for (const auto& order : orders) (void)give_order(reception, order);
    run_level_transition(reception);
    return state.level.level;
  };
  const auto immediate = [&](std::uint8_t M_LEVELTR) { return read(order_to(M_LEVELTR, 32767)); };
  const auto conditional = [&](std::uint8_t first, std::uint8_t second) {
    lang::Packet46 p;
    p.M_LEVELTR.raw = first;
    lang::Packet46_levels further;
    further.M_LEVELTR.raw = second;
    EXPECT_TRUE(p.levels.push_back(further));
    return read(p);
  };
  EXPECT_EQ(level_after({immediate(0), immediate(3)}), Level::L2);
  EXPECT_EQ(level_after({immediate(0), immediate(2)}), Level::L1);
  EXPECT_EQ(level_after({immediate(2), immediate(2)}), Level::L1);
  EXPECT_EQ(level_after({immediate(0), conditional(2, 3)}), Level::L1) << "level 0 is not in the table";
  EXPECT_EQ(level_after({immediate(2), conditional(0, 2)}), Level::L1) << "level 1 is in the table";
  ASSERT_TRUE(state.level_table.has_value());
  EXPECT_EQ(state.level_table->size(), 2u) << "the table of the last one (5.10.2.9 b)";
  EXPECT_EQ(level_after({immediate(0), conditional(3, 2)}), Level::L2);
}

TEST_F(Levels, WhatWaitsGoesWithAnOrderThatTheKeptOneReplaces) {  // 4.8.5.4 a, 4.4.8.1.5
  state.level.level = Level::L1;
  state.level_transition.pending = modes::PendingTransition{{.level = Level::L2}, at(1500.0)};
  state.level_transition.kept = true;
  state.level_transition.kept_order.kind = modes::OrderKind::announcement;
  state.level_transition.kept_order.border = at(1500.0);
  ASSERT_TRUE(state.level_transition.kept_order.table.push_back({.level = Level::L0}));
  fill_buffer();
  run_level_transition(reception);
  EXPECT_TRUE(state.buffer.empty());
}

TEST_F(Levels, WhatWaitsForAnOrderOfThisCycleGoesWithIt) {  // 4.8.5.4 a, 5.10.1.6
  state.level.level = Level::L2;
  receive(2, 500);
  fill_buffer();
  receive(2, 600);
  EXPECT_EQ(state.buffer.size(), 1u);
  receive(0, 500);
  EXPECT_TRUE(state.buffer.empty());
}

TEST_F(Levels, AnOrderToBeExecutedIsNotReplacedByOneThatIsNot) {  // 5.10.1.6
  state.level.level = Level::L1;
  receive(3, 32767);
  EXPECT_TRUE(executes_order(reception));
  receive(0, 500);
  ASSERT_TRUE(executes_order(reception));
  EXPECT_EQ(reception.order->decision.to.level, Level::L2);
  receive(0, 32767);
  EXPECT_EQ(reception.order->decision.to.level, Level::L0);
}

TEST_F(Levels, ANewLevelIsValidAndLogged) {  // 5.10.1, 5.4.3.3
  state.level.level = Level::L1;
  state.data.level_status = DataStatus::invalid;
  const std::uint32_t revision = state.revision;
  receive(3, 32767);
  run_level_transition(reception);
  EXPECT_EQ(state.level.level, Level::L2);
  EXPECT_EQ(received.level_switched_to, Level::L2);
  EXPECT_FALSE(received.level_changed_by_driver);
  EXPECT_EQ(state.data.level_status, DataStatus::valid);
  EXPECT_NE(state.revision, revision);
  EXPECT_TRUE(happened(What::level_changed));
  EXPECT_FALSE(received.national_system_only);
}

TEST_F(Levels, TheRearReportsTheBorderOfAnRBCArea) {  // 3.6.5.1.4 e
  state.level.level = Level::L2;
  receive(2, 32767);
  run_level_transition(reception);
  ASSERT_EQ(state.level.level, Level::L1);
  EXPECT_EQ(state.reports.rear_border, at(950.0)) << "the group, not the front end";
  state.reports.rear_border.reset();
  reception.order.reset();
  receive(3, 32767);
  run_level_transition(reception);
  ASSERT_EQ(state.level.level, Level::L2);
  EXPECT_EQ(state.reports.rear_border, std::nullopt);
}

TEST_F(Levels, TheBorderOfAnAnnouncementIsItsPlace) {  // 3.6.5.1.4 f
  state.level.level = Level::L2;
  state.level_transition.pending.emplace().to.level = Level::L1;
  state.level_transition.pending->border = at(997.0);
  run_level_transition(reception);
  ASSERT_EQ(state.level.level, Level::L1);
  EXPECT_EQ(state.reports.rear_border, at(997.0));
}

TEST_F(Levels, TheTableOfAnAnnouncementCountsFromItsPlace) {  // 5.10.2.9 a
  receive(2, 200);                                            // 950 m + 200 m, to the level that it has
  run_level_transition(reception);
  EXPECT_FALSE(state.level_table.has_value());
  ASSERT_TRUE(state.level_transition.announced_table.has_value());
  EXPECT_EQ(state.level_transition.announced_table->border, at(1150.0));
  reception.order.reset();
  received.here.est_front = at(1150.0);
  run_level_transition(reception);
  ASSERT_TRUE(state.level_table.has_value());
  EXPECT_EQ(state.level_table->front().level, Level::L1);
  EXPECT_FALSE(state.level_transition.announced_table.has_value());
}

TEST_F(Levels, ReleaseWhatWaitedForThem) {  // 4.8.5.2
  state.level.level = Level::L1;
  state.level_transition.pending.emplace().to.level = Level::L2;
  information.medium = Medium::rbc;
  information.packets.clear();
  fill_buffer();
  receive(3, 32767);
  run_level_transition(reception);
  EXPECT_EQ(state.level.level, Level::L2);
  EXPECT_TRUE(state.buffer.empty());
}

TEST_F(Levels, OutsideAnRBCAreaHaveNoBorderToReport) {  // 3.6.5.1.4 e
  state.level.level = Level::L1;
  receive(0, 32767);
  run_level_transition(reception);
  ASSERT_EQ(state.level.level, Level::L0);
  EXPECT_EQ(state.reports.rear_border, std::nullopt);
}

TEST_F(Levels, FromOneNationalSystemToAnother) {  // 4.6.3 [56]
  const auto only_the_system = [&](Level from) {
    state.level = {};
    state.level.level = from;
    state.level.nid_ntc = from == Level::NTC ? 9 : 0;
    received.level_switched_to.reset();
    reception.order.reset();
    information.packets.clear();
    in.national_system.available = std::uint64_t{1} << 8 | std::uint64_t{1} << 9;
    lang::Packet41 p = order_to(1, 32767);
    p.NID_NTC.raw = 8;
    add(p);
    evaluate_now();
    run_level_transition(reception);
    EXPECT_EQ(received.level_switched_to, Level::NTC);
    return received.national_system_only;
  };
  EXPECT_TRUE(only_the_system(Level::NTC));
  EXPECT_FALSE(only_the_system(Level::L1));
}

TEST_F(Levels, AreAcknowledgedByModeAndEdition) {  // 5.10.4, 4.4.15, 5.10.4.2 of 4.0.0
  const auto asks = [&](Level from, std::uint8_t M_LEVELTR, Mode mode, SrsVersion srs) {
    state.level = {};
    state.level.level = from;
    state.level_transition = {};
    state.mode = mode;
    state.srs = srs;
    reception.order.reset();
    receive(M_LEVELTR, 32767);
    run_level_transition(reception);
    return received.level.requests.has(Ack::level);
  };
  EXPECT_TRUE(asks(Level::L1, 0, Mode::FS, SrsVersion::v3_6_0));
  EXPECT_FALSE(asks(Level::L1, 0, Mode::NL, SrsVersion::v3_6_0));
  EXPECT_TRUE(asks(Level::NTC, 2, Mode::SN, SrsVersion::v3_6_0));
  EXPECT_FALSE(asks(Level::NTC, 2, Mode::SN, SrsVersion::v4_0_0));
}

TEST_F(Levels, AnAnnouncedLevelThatWasSelectedMeanwhileIsNotAnnounced) {  // 4.8.3 [1], 5.10.1.7
  modes::PendingTransition pending;
  pending.to.level = Level::L2;
  state.level_transition.pending = pending;
  state.level = {};
  state.level.level = Level::L1;
  ASSERT_TRUE(ordered_level(reception).has_value());
  EXPECT_EQ(ordered_level(reception)->level, Level::L2);
  state.level.level = Level::L2;
  EXPECT_FALSE(ordered_level(reception).has_value());
}

TEST_F(Levels, AnOrderKeptInSHIsJudgedByWhatIsAvailableWhenItEnds) {  // 4.4.8.1.5, 5.10.2.4
  const auto level_after = [&](std::uint64_t available) {
    state.level = {};
    state.level.level = Level::L1;
    state.level_transition = {};
    state.level_transition.kept = true;
    modes::OrderedLevel ntc, other;
    ntc.level = Level::NTC;
    ntc.nid_ntc = 8;
    other.level = Level::L0;
    EXPECT_TRUE(state.level_transition.kept_order.table.push_back(ntc));
    EXPECT_TRUE(state.level_transition.kept_order.table.push_back(other));
    in.national_system.available = available;
    run_level_transition(reception);
    return state.level.level;
  };
  EXPECT_EQ(level_after(std::uint64_t{1} << 8), Level::NTC);
  EXPECT_EQ(level_after(0), Level::L0);
}

}  // namespace
}  // namespace evc::kernel
