#include "procedures/level_transition.h"

#include <gtest/gtest.h>

#include "base/test_units.h"

namespace evc::procedures {
namespace {

using evc::test::at;

modes::OrderedLevel level(Level l, std::uint8_t ntc = 0) {
  return {.level = l, .nid_ntc = ntc, .L_ack = Distance{300.0}};
}

struct Border {
  level_transition::State state;
  level_transition::Inputs in;
  level_transition::Order order;
  bool send = false;
  Border(modes::OrderedLevel current, Mode mode) {
    in.current = current;
    in.mode = mode;
    in.available.national_systems[0] = ~std::uint64_t{0};
  }
  void give(modes::OrderKind kind, modes::OrderedLevel to, double border = 0.0) {
    order = {};
    order.kind = kind;
    order.border = at(border);
    EXPECT_TRUE(order.table.push_back(to));
    send = true;
  }
  level_transition::Result cycle(double front) {
    in.now += Duration{1.0};
    in.est_front = at(front);
    in.max_safe_front = at(front + 10.0);
    const level_transition::JudgedOrder judged{
        order,
        send ? modes::judge(order.kind, order.table, in.current, in.mode, in.available) : modes::OrderDecision{}};
    in.order = send ? &judged : nullptr;
    const level_transition::Result out = step(state, in);
    in.order = nullptr;
    send = false;
    in.acknowledged = false;
    in.driver_level.reset();
    if (out.switch_to.has_value()) in.current = *out.switch_to;
    return out;
  }
};

using modes::OrderKind;

TEST(LevelTransition, Announced_and_executed_at_its_place_without_acknowledgement) {
  Border b(level(Level::L1), Mode::FS);
  b.give(OrderKind::announcement, level(Level::L2), 1000.0);
  auto r = b.cycle(500.0);
  EXPECT_TRUE(r.announced);
  EXPECT_FALSE(r.switch_to.has_value());
  EXPECT_TRUE(b.cycle(999.9).announced);
  r = b.cycle(1000.0);
  ASSERT_TRUE(r.switch_to.has_value());
  EXPECT_EQ(r.switch_to->level, Level::L2);
  EXPECT_FALSE(r.announced || r.by_driver);
  EXPECT_TRUE(r.effects.requests.empty());
  EXPECT_FALSE(b.cycle(1001.0).switch_to.has_value());
}

TEST(LevelTransition, Acknowledged_ahead) {
  Border b(level(Level::L2), Mode::FS);
  b.give(OrderKind::announcement, level(Level::NTC, 1), 1000.0);
  EXPECT_TRUE(b.cycle(500.0).effects.requests.empty());
  EXPECT_TRUE(b.cycle(689.0).effects.requests.empty());
  EXPECT_EQ(b.cycle(690.0).effects.requests, Set<Ack>{Ack::level});
  b.in.acknowledged = true;
  EXPECT_TRUE(b.cycle(700.0).effects.requests.empty());
  // The same order again asks for no further acknowledgement.
  b.give(OrderKind::announcement, level(Level::NTC, 1), 1010.0);
  const auto again = b.cycle(710.0);
  EXPECT_TRUE(again.effects.requests.empty());
  EXPECT_FALSE(again.cancelled);
  const auto r = b.cycle(1010.0);
  EXPECT_TRUE(r.switch_to.has_value());
  EXPECT_TRUE(r.effects.requests.empty());
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(b.cycle(1020.0).overdue.has_value());
}

TEST(LevelTransition, The_request_ahead_is_not_taken_back) {  // A.3.5.1
  Border b(level(Level::L2), Mode::FS);
  b.give(OrderKind::announcement, level(Level::NTC, 1), 1000.0);
  EXPECT_TRUE(b.cycle(689.0).effects.requests.empty());
  EXPECT_EQ(b.cycle(690.0).effects.requests, Set<Ack>{Ack::level});
  EXPECT_EQ(b.cycle(600.0).effects.requests, Set<Ack>{Ack::level});
  // It is for this transition: not for one farther on, nor for another one.
  b.give(OrderKind::announcement, level(Level::NTC, 1), 1010.0);
  EXPECT_TRUE(b.cycle(600.0).effects.requests.empty());
  EXPECT_EQ(b.cycle(700.0).effects.requests, Set<Ack>{Ack::level});
  b.give(OrderKind::announcement, level(Level::L0), 1100.0);
  EXPECT_TRUE(b.cycle(600.0).effects.requests.empty());
  EXPECT_TRUE(b.cycle(789.0).effects.requests.empty());
  EXPECT_EQ(b.cycle(790.0).effects.requests, Set<Ack>{Ack::level});
}

// The driver answers what he was shown: with an order for another level in the same cycle he is asked again.
TEST(LevelTransition, An_acknowledgement_is_for_the_level_that_was_shown) {  // 5.10.4.1
  for (const OrderKind kind : {OrderKind::announcement, OrderKind::immediate, OrderKind::conditional}) {
    Border b(level(Level::L2), Mode::FS);
    b.give(OrderKind::announcement, level(Level::L0), 1000.0);
    ASSERT_EQ(b.cycle(800.0).effects.requests, Set<Ack>{Ack::level});
    b.in.acknowledged = true;
    b.give(kind, level(Level::NTC, 1), 1000.0);
    EXPECT_EQ(b.cycle(810.0).effects.requests, Set<Ack>{Ack::level});
    b.in.acknowledged = true;
    EXPECT_TRUE(b.cycle(820.0).effects.requests.empty());
  }
}

TEST(LevelTransition, An_acknowledgement_of_a_level_that_is_left_is_none_of_the_next) {  // 5.10.4.1
  Border b(level(Level::L2), Mode::SN);
  b.give(OrderKind::immediate, level(Level::NTC, 1));
  ASSERT_EQ(b.cycle(0.0).effects.requests, Set<Ack>{Ack::level});
  b.in.acknowledged = true;
  b.give(OrderKind::immediate, level(Level::NTC, 2));
  EXPECT_EQ(b.cycle(0.0).effects.requests, Set<Ack>{Ack::level});
  EXPECT_EQ(b.cycle(0.0).effects.requests, Set<Ack>{Ack::level});
  b.give(OrderKind::announcement, level(Level::L0), 100.0);
  (void)b.cycle(0.0);
  b.in.acknowledged = true;
  b.in.driver_level = level(Level::L1);
  EXPECT_EQ(b.cycle(10.0).effects.requests, Set<Ack>{Ack::level}) << "of the announced level";
  EXPECT_EQ(b.cycle(10.0).effects.requests, Set<Ack>{Ack::level});
}

TEST(LevelTransition, What_was_shown_before_the_train_turned_or_its_mode_changed_is_not_answered) {  // 5.10.4.1
  for (const bool turns : {true, false}) {
    Border ahead(level(Level::L2), Mode::FS);
    ahead.give(OrderKind::announcement, level(Level::L0), 1000.0);
    ASSERT_EQ(ahead.cycle(800.0).effects.requests, Set<Ack>{Ack::level});
    if (turns)
      level_transition::turn(ahead.state);
    else
      level_transition::forget_order(ahead.state);
    ahead.in.acknowledged = true;
    ahead.give(OrderKind::announcement, level(Level::NTC, 1), 1000.0);
    EXPECT_EQ(ahead.cycle(810.0).effects.requests, Set<Ack>{Ack::level});
  }
  Border entered(level(Level::L2), Mode::FS);
  entered.give(OrderKind::immediate, level(Level::L0));
  ASSERT_EQ(entered.cycle(0.0).effects.requests, Set<Ack>{Ack::level});
  level_transition::on_mode_change(entered.state, Mode::FS, Mode::TR, SrsVersion::v3_6_0);
  entered.in.acknowledged = true;
  entered.give(OrderKind::announcement, level(Level::NTC, 1), 100.0);
  EXPECT_EQ(entered.cycle(0.0).effects.requests, Set<Ack>{Ack::level});
}

TEST(LevelTransition, An_order_that_waited_is_older_than_one_that_is_received) {  // 5.10.1.6, 4.4.8.1.5
  Border b(level(Level::L1), Mode::SH);
  b.give(OrderKind::immediate, level(Level::L0));
  EXPECT_FALSE(b.cycle(0.0).switch_to.has_value());
  EXPECT_TRUE(b.state.kept);
  b.in.mode = Mode::SB;
  b.give(OrderKind::immediate, level(Level::L2));
  EXPECT_EQ(b.cycle(0.0).switch_to, level(Level::L2));
  EXPECT_FALSE(b.cycle(0.0).switch_to.has_value());
}

TEST(LevelTransition, Not_acknowledged_brakes_after_5_s) {
  Border b(level(Level::L2), Mode::FS);
  b.give(OrderKind::immediate, level(Level::L0));
  auto r = b.cycle(0.0);
  EXPECT_EQ(r.switch_to->level, Level::L0);
  EXPECT_EQ(r.effects.requests, Set<Ack>{Ack::level});
  level_transition::on_mode_change(b.state, Mode::FS, Mode::UN, SrsVersion::v3_6_0);
  b.in.mode = Mode::UN;
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(b.cycle(10.0).overdue.has_value());
  r = b.cycle(10.0);
  EXPECT_TRUE(r.overdue.has_value());
  EXPECT_EQ(r.overdue, Level::L0);
  b.in.acknowledged = true;
  r = b.cycle(10.0);
  EXPECT_FALSE(r.overdue.has_value());
  EXPECT_TRUE(r.effects.requests.empty());
}

TEST(LevelTransition, In_SB_4_0_0_asks_only_at_the_change) {
  for (const SrsVersion srs : {SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Border b(level(Level::L2), Mode::SB);
    b.in.srs = srs;
    b.give(OrderKind::announcement, level(Level::L0), 1000.0);
    EXPECT_EQ(b.cycle(900.0).effects.requests.empty(), srs == SrsVersion::v4_0_0);
    EXPECT_EQ(b.cycle(1000.0).effects.requests, Set<Ack>{Ack::level});
  }
}

/// 4.4: PT and RV belong to levels 1 to 3, and no change of level leads out of them.
TEST(LevelTransition, A_level_that_the_mode_excludes_waits_until_it_is_left) {
  for (const Mode mode : {Mode::PT, Mode::RV}) {
    for (const Level to : {Level::L0, Level::NTC}) {
      Border b(level(Level::L2), Mode::FS);
      b.give(OrderKind::announcement, level(to, 1), 1000.0);
      EXPECT_FALSE(b.cycle(990.0).switch_to.has_value());
      b.in.mode = mode;
      EXPECT_FALSE(b.cycle(1000.0).switch_to.has_value());
      b.in.mode = Mode::SR;
      const auto r = b.cycle(1000.0);
      ASSERT_TRUE(r.switch_to.has_value());
      EXPECT_EQ(r.switch_to->level, to);
    }
    Border b(level(Level::L2), Mode::FS);
    b.give(OrderKind::announcement, level(Level::L1), 1000.0);
    b.cycle(990.0);
    b.in.mode = mode;
    EXPECT_TRUE(b.cycle(1000.0).switch_to.has_value());
  }
}

TEST(LevelTransition, The_newest_order_counts) {
  Border b(level(Level::L2), Mode::FS);
  b.give(OrderKind::announcement, level(Level::NTC, 1), 1000.0);
  b.cycle(500.0);
  b.give(OrderKind::announcement, level(Level::L1), 2000.0);
  EXPECT_TRUE(b.cycle(600.0).cancelled);
  EXPECT_FALSE(b.cycle(1500.0).switch_to.has_value());
  // An order for the current level deletes the pending transition.
  b.give(OrderKind::immediate, level(Level::L2));
  const auto r = b.cycle(1600.0);
  EXPECT_TRUE(r.cancelled);
  EXPECT_FALSE(r.announced || r.switch_to.has_value());
  EXPECT_FALSE(b.cycle(2100.0).switch_to.has_value());
}

TEST(LevelTransition, An_order_for_a_place_already_passed_is_executed_at_once) {
  Border b(level(Level::L1), Mode::FS);
  b.give(OrderKind::announcement, level(Level::L2), 400.0);
  EXPECT_TRUE(b.cycle(500.0).switch_to.has_value());
}

TEST(LevelTransition, A_pending_level_that_the_driver_chose_meanwhile_is_no_transition) {
  Border b(level(Level::L1), Mode::FS);
  b.give(OrderKind::announcement, level(Level::L2), 1000.0);
  b.cycle(500.0);
  b.in.driver_level = level(Level::L2);
  const auto r = b.cycle(600.0);
  EXPECT_TRUE(r.by_driver);
  EXPECT_FALSE(r.announced);
  EXPECT_TRUE(r.effects.requests.empty());  // a level selected by the driver needs no acknowledgement
  EXPECT_FALSE(b.cycle(1000.0).switch_to.has_value());
  // 4.0.0 deletes the order.
  Border n(level(Level::L1), Mode::FS);
  n.in.srs = SrsVersion::v4_0_0;
  n.give(OrderKind::announcement, level(Level::L2), 1000.0);
  n.cycle(500.0);
  n.in.driver_level = level(Level::L0);
  EXPECT_TRUE(n.cycle(600.0).cancelled);
  n.in.driver_level = level(Level::L0);
  EXPECT_FALSE(n.cycle(600.0).switch_to.has_value());
}

/// 5.10.4.1.3: what the driver acknowledged ahead counts for the transition that was pending, and for no later one.
TEST(LevelTransition, An_acknowledgement_ahead_goes_with_its_transition) {
  for (const SrsVersion srs : {SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Border b(level(Level::L1), Mode::FS);
    b.in.srs = srs;
    b.give(OrderKind::announcement, level(Level::L0), 1000.0);
    EXPECT_EQ(b.cycle(800.0).effects.requests, Set<Ack>{Ack::level});
    b.in.acknowledged = true;
    EXPECT_TRUE(b.cycle(800.0).effects.requests.empty());
    // 4.0.0: the driver's level deletes the order (5.10.1.6.1); 3.x: the place of a level that he chose is passed.
    b.in.driver_level = level(srs == SrsVersion::v4_0_0 ? Level::L2 : Level::L0);
    b.cycle(800.0);
    b.cycle(1000.0);
    b.in.current = level(Level::L1);
    b.give(OrderKind::immediate, level(Level::L0));
    EXPECT_EQ(b.cycle(1100.0).effects.requests, Set<Ack>{Ack::level});
  }
}

TEST(LevelTransition, Kept_in_shunting) {
  Border b(level(Level::L1), Mode::SH);
  b.give(OrderKind::announcement, level(Level::L2), 100.0);
  EXPECT_FALSE(b.cycle(0.0).announced);
  b.give(OrderKind::immediate, level(Level::L2));
  EXPECT_FALSE(b.cycle(0.0).switch_to.has_value());
  EXPECT_FALSE(b.cycle(0.0).switch_to.has_value());
  level_transition::on_mode_change(b.state, Mode::SH, Mode::SB, SrsVersion::v3_6_0);
  b.in.mode = Mode::SB;
  EXPECT_EQ(b.cycle(0.0).switch_to->level, Level::L2);
  // SH is left for a mode that deletes the order (4.10).
  Border d(level(Level::L1), Mode::SH);
  d.give(OrderKind::immediate, level(Level::L2));
  d.cycle(0.0);
  level_transition::on_mode_change(d.state, Mode::SH, Mode::NP, SrsVersion::v3_6_0);
  d.in.mode = Mode::SB;
  EXPECT_FALSE(d.cycle(0.0).switch_to.has_value());
}

TEST(LevelTransition, Kept_in_shunting_in_4_0_0) {
  for (const Mode to : {Mode::SB, Mode::TR, Mode::NL, Mode::SR}) {
    Border b(level(Level::L1), Mode::SH);
    b.give(OrderKind::immediate, level(Level::L2));
    b.cycle(0.0);
    level_transition::on_mode_change(b.state, Mode::SH, to, SrsVersion::v4_0_0);
    b.in.mode = to;
    EXPECT_EQ(b.cycle(0.0).switch_to.has_value(), to != Mode::SR);
  }
  // An announcement is deleted on the same way, and stays in PS.
  Border a(level(Level::L2), Mode::FS);
  a.give(OrderKind::announcement, level(Level::L1), 1000.0);
  a.cycle(500.0);
  level_transition::on_mode_change(a.state, Mode::SH, Mode::PS, SrsVersion::v4_0_0);
  EXPECT_TRUE(a.state.pending.has_value());
  level_transition::on_mode_change(a.state, Mode::PS, Mode::SB, SrsVersion::v4_0_0);
  EXPECT_FALSE(a.state.pending.has_value());
}

TEST(LevelTransition, Mode_entries_delete_what_4_10_says) {
  Border b(level(Level::L2), Mode::FS);
  b.give(OrderKind::announcement, level(Level::L1), 1000.0);
  b.cycle(500.0);
  level_transition::on_mode_change(b.state, Mode::FS, Mode::OS, SrsVersion::v3_6_0);
  EXPECT_TRUE(b.state.pending.has_value());
  level_transition::on_mode_change(b.state, Mode::OS, Mode::SR, SrsVersion::v3_6_0);
  EXPECT_FALSE(b.state.pending.has_value());
  // In TR no acknowledgement of a level is asked for.
  Border t(level(Level::L2), Mode::FS);
  t.give(OrderKind::immediate, level(Level::L0));
  t.cycle(0.0);
  level_transition::on_mode_change(t.state, Mode::FS, Mode::TR, SrsVersion::v3_6_0);
  t.in.mode = Mode::TR;
  EXPECT_TRUE(t.cycle(0.0).effects.requests.empty());
}

}  // namespace
}  // namespace evc::procedures
