#include "procedures/end_of_mission.h"

#include <gtest/gtest.h>

namespace evc::procedures {
namespace {

struct Mission {
  end_of_mission::State state;
  end_of_mission::Inputs in;
  Effects to(Mode mode) {
    in.previous_mode = in.mode;
    in.mode = mode;
    return cycle();
  }
  Effects cycle() {
    in.now += Duration{1.0};
    const Effects out = step(state, in);
    in.previous_mode = in.mode;
    in.termination_ordered = false;
    return out;
  }
};

TEST(EndOfMission, Transitions_of_5_5_2) {
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode from = static_cast<Mode>(m);
    const bool to_sb = from == Mode::FS || from == Mode::LS || from == Mode::OS || from == Mode::UN ||
                       from == Mode::NL || from == Mode::SR || from == Mode::RV || from == Mode::SN ||
                       from == Mode::PT || from == Mode::SM || from == Mode::AD;
    EXPECT_EQ(end_of_mission::ends_mission(from, Mode::SB, true), to_sb) << name(from);
    const bool to_sh = to_sb && from != Mode::NL && from != Mode::RV;
    EXPECT_EQ(end_of_mission::ends_mission(from, Mode::SH, true), to_sh) << name(from);
    EXPECT_EQ(end_of_mission::ends_mission(from, Mode::SL, true), from == Mode::SB || from == Mode::PS);
    EXPECT_FALSE(end_of_mission::ends_mission(from, Mode::SB, false));
    EXPECT_FALSE(end_of_mission::ends_mission(from, Mode::FS, true));
  }
}

TEST(EndOfMission, Reports_and_waits_for_the_order) {
  Mission m;
  m.to(Mode::SB);
  EXPECT_TRUE(m.to(Mode::SR).send.empty());
  m.in.session_open = true;
  EXPECT_TRUE(m.to(Mode::SB).send.has(Send::end_of_mission));
  EXPECT_TRUE(m.cycle().send.empty());
  m.in.termination_ordered = true;
  EXPECT_TRUE(m.cycle().send.has(Send::terminate_session));
  EXPECT_TRUE(m.cycle().send.empty());
}

TEST(EndOfMission, A_mission_that_begins_ends_the_report_of_the_one_before) {  // 5.4.6.1
  Mission m;
  m.in.session_open = true;
  m.to(Mode::FS);
  EXPECT_TRUE(m.to(Mode::SH).send.has(Send::end_of_mission));
  EXPECT_TRUE(m.to(Mode::NL).send.empty());
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(m.cycle().send.empty());
}

TEST(EndOfMission, Gives_up_after_three_repetitions) {
  Mission m;
  m.in.session_open = true;
  m.to(Mode::FS);
  m.to(Mode::SB);
  int reports = 0;
  bool terminated = false;
  for (int i = 0; i < 100 && !terminated; ++i) {
    const Effects e = m.cycle();
    reports += e.send.has(Send::end_of_mission) ? 1 : 0;
    terminated = e.send.has(Send::terminate_session);
  }
  EXPECT_EQ(reports, 3);
  EXPECT_TRUE(terminated);
}

TEST(EndOfMission, Without_a_session_nothing_is_opened) {
  Mission m;
  m.to(Mode::FS);
  EXPECT_TRUE(m.to(Mode::SB).send.empty());
  m.in.session_open = true;
  EXPECT_TRUE(m.cycle().send.empty());
  // The loss of the session ends the wait.
  m.to(Mode::FS);
  m.to(Mode::SB);
  m.in.session_open = false;
  EXPECT_TRUE(m.cycle().send.empty());
  EXPECT_FALSE(m.state.waits_for_order);
}

TEST(EndOfMission, Shunting_without_a_mission_reports_the_mode) {
  Mission m;
  m.in.session_open = m.in.level_2_or_3 = true;
  m.to(Mode::SB);
  EXPECT_TRUE(m.to(Mode::SH).send.has(Send::position_report));
  for (int i = 0; i < 14; ++i) EXPECT_TRUE(m.cycle().send.empty());
  EXPECT_TRUE(m.cycle().send.has(Send::position_report));
  Mission one;
  one.in.session_open = true;
  one.to(Mode::SB);
  EXPECT_TRUE(one.to(Mode::SH).send.empty());
}

TEST(EndOfMission, Power_off_forgets_the_mission) {
  Mission m;
  m.to(Mode::FS);
  EXPECT_TRUE(m.state.mission);
  m.to(Mode::NP);
  EXPECT_FALSE(m.state.mission);
}

// 5.5.3.1.3 of 4.0.0, an RBC of 2.3 or later: with the desk closed the report is all; in SH the order is awaited.
TEST(EndOfMission, With_the_desk_closed_the_report_is_all) {
  Mission m;
  m.in.session_open = m.in.report_ends_it = true;
  (void)m.to(Mode::FS);
  EXPECT_TRUE(m.to(Mode::SB).send.has(Send::end_of_mission));
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(m.cycle().send.empty()) << i;
  Mission shunting;
  shunting.in.session_open = shunting.in.report_ends_it = true;
  (void)shunting.to(Mode::FS);
  EXPECT_TRUE(shunting.to(Mode::SH).send.has(Send::end_of_mission));
  shunting.in.termination_ordered = true;
  EXPECT_TRUE(shunting.cycle().send.has(Send::terminate_session));
}

}  // namespace
}  // namespace evc::procedures
