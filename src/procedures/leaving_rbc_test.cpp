#include "procedures/leaving_rbc.h"

#include <gtest/gtest.h>

namespace evc::procedures {
namespace {

struct Leaving {
  leaving_rbc::State state;
  leaving_rbc::Inputs in;
  Leaving() { in.session_open = true; }
  Effects cycle() {
    in.now += Duration{1.0};
    const Effects out = step(state, in);
    in.exit_reported = in.termination_ordered = false;
    return out;
  }
};

TEST(LeavingRbc, The_report_is_repeated_and_then_the_session_ends) {
  Leaving l;
  EXPECT_TRUE(l.cycle().send.empty());
  l.in.exit_reported = true;
  EXPECT_TRUE(l.cycle().send.empty());  // radio sends the report at the border
  int reports = 0;
  Effects last;
  for (int i = 0; i < 60; ++i) {
    last = l.cycle();
    reports += last.send.has(Send::position_report) ? 1 : 0;
  }
  EXPECT_EQ(reports, 3);
  EXPECT_TRUE(last.send.has(Send::terminate_session));
  for (int i = 0; i < 60; ++i) EXPECT_TRUE(l.cycle().send.empty());
}

TEST(LeavingRbc, An_order_a_lost_session_or_level_2_end_the_wait) {
  for (int which = 0; which < 3; ++which) {
    Leaving l;
    l.in.exit_reported = true;
    l.cycle();
    if (which == 0) l.in.termination_ordered = true;
    if (which == 1) l.in.session_open = false;
    if (which == 2) l.in.level_2_or_3 = true;
    l.cycle();
    l.in.session_open = true;
    l.in.level_2_or_3 = false;
    for (int i = 0; i < 70; ++i) EXPECT_TRUE(l.cycle().send.empty()) << which;
  }
}

}  // namespace
}  // namespace evc::procedures
