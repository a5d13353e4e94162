#include "procedures/shunting.h"

#include <gtest/gtest.h>

namespace evc::procedures {
namespace {

struct Shunter {
  shunting::State state;
  shunting::Inputs in;
  Shunter() {
    in.standstill = true;
    in.session_open = true;
    in.level = Level::L2;
  }
  shunting::Result cycle() {
    in.now += Duration{1.0};
    const shunting::Result out = step(state, in);
    in.selects_SH = in.selects_continue = in.authorised = in.refused = false;
    return out;
  }
  shunting::Result ask() {
    in.selects_SH = true;
    return cycle();
  }
};

TEST(Shunting, In_levels_0_NTC_and_1_the_selection_acts_at_once) {
  for (const Level level : {Level::L0, Level::NTC, Level::L1}) {
    Shunter s;
    s.in.level = level;
    EXPECT_TRUE(s.ask().selects_SH);
    s.in.standstill = false;
    EXPECT_FALSE(s.ask().selects_SH);
  }
}

TEST(Shunting, In_level_2_the_RBC_grants_it) {
  Shunter s;
  s.in.authorised = true;
  EXPECT_FALSE(s.cycle().granted);  // nobody asked
  const auto asked = s.ask();
  EXPECT_TRUE(asked.effects.send.has(Send::shunting_request));
  EXPECT_FALSE(asked.selects_SH);
  EXPECT_TRUE(s.ask().effects.send.empty());  // sent once only
  s.in.authorised = true;
  EXPECT_TRUE(s.cycle().granted);
  s.in.authorised = true;
  EXPECT_FALSE(s.cycle().granted);
}

TEST(Shunting, A_grant_while_moving_is_lost) {
  Shunter s;
  s.ask();
  s.in.standstill = false;
  s.in.authorised = true;
  EXPECT_FALSE(s.cycle().granted);
  s.in.standstill = true;
  EXPECT_FALSE(s.cycle().granted);
}

TEST(Shunting, Refused_or_not_answered) {
  Shunter s;
  s.ask();
  s.in.refused = true;
  EXPECT_TRUE(s.cycle().effects.inform.has(Inform::SH_refused));
  s.ask();
  int repeated = 0;
  Effects last;
  for (int i = 0; i < 60; ++i) {
    last = s.cycle().effects;
    repeated += last.send.has(Send::shunting_request) ? 1 : 0;
  }
  EXPECT_EQ(repeated, 3);
  EXPECT_TRUE(last.inform.has(Inform::SH_request_failed));
  EXPECT_TRUE(last.send.has(Send::terminate_session));
}

TEST(Shunting, Goes_on_over_a_closed_desk_once) {
  Shunter s;
  s.in.selects_continue = true;
  s.cycle();
  EXPECT_FALSE(s.state.continues);
  s.in.mode = Mode::SH;
  s.in.selects_continue = true;
  s.cycle();
  EXPECT_TRUE(s.state.continues);
  s.cycle();
  EXPECT_TRUE(s.state.continues);
  for (const Mode mode : {Mode::PS, Mode::SB}) {
    s.state.continues = true;
    s.in.mode = mode;
    s.cycle();
    EXPECT_FALSE(s.state.continues);
  }
  s.in.mode = Mode::SH;  // again from PS
  s.cycle();
  EXPECT_FALSE(s.state.continues);
}

}  // namespace
}  // namespace evc::procedures
