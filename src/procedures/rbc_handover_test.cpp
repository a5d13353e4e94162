#include "procedures/rbc_handover.h"

#include <gtest/gtest.h>

namespace evc::procedures {
namespace {

struct Handover {
  rbc_handover::State state;
  rbc_handover::Inputs in;

  Handover() {
    in.stored = true;
    in.reports = true;
    in.established = true;
  }
  rbc_handover::Result cycle() {
    in.now += Duration{1.0};
    const rbc_handover::Result r = step(state, in);
    in.ordered = false;
    return r;
  }
  void announce() {
    in.ordered = true;
    (void)cycle();
  }
  void run_to_border() {
    announce();
    in.max_safe_front = in.est_front = true;
    (void)cycle();
  }
};

TEST(RbcHandover, The_front_end_reports_the_border_once) {  // 3.15.1.3.1 b
  Handover h;
  h.announce();
  EXPECT_FALSE(h.cycle().report);
  h.in.max_safe_front = true;
  EXPECT_TRUE(h.cycle().report);
  EXPECT_EQ(h.state.step, rbc_handover::Step::at_border);
  EXPECT_FALSE(h.cycle().report);
}

TEST(RbcHandover, The_contact_changes_with_the_estimated_front_end) {  // 3.15.1.3.7
  Handover h;
  h.announce();
  h.in.max_safe_front = true;
  EXPECT_FALSE(h.cycle().change_contact);
  h.in.est_front = true;
  EXPECT_TRUE(h.cycle().change_contact);
  EXPECT_FALSE(h.cycle().change_contact);
}

TEST(RbcHandover, Only_a_report_from_beyond_the_border_hands_over) {  // 3.15.1.3.5
  Handover h;
  h.announce();
  EXPECT_FALSE(reported_to_accepting(h.state));
  h.in.max_safe_front = true;
  (void)h.cycle();
  EXPECT_TRUE(reported_to_accepting(h.state));
  EXPECT_FALSE(reported_to_accepting(h.state)) << "once";
}

TEST(RbcHandover, The_rear_end_is_reported_four_times_and_then_the_session_ends) {  // 3.15.1.3.9
  Handover h;
  h.run_to_border();
  ASSERT_TRUE(reported_to_accepting(h.state));
  h.in.min_safe_rear = true;
  const rbc_handover::Result first = h.cycle();
  EXPECT_TRUE(first.report && first.rear_passed_now);
  int reports = 0, seconds = 0;
  bool terminated = false;
  while (!terminated && seconds < 100) {
    const rbc_handover::Result r = h.cycle();
    ++seconds;
    reports += r.report ? 1 : 0;
    terminated = r.terminate;
  }
  EXPECT_EQ(reports, 3);
  EXPECT_EQ(seconds, 60);
  h.in.established = false;
  h.in.ended = true;
  EXPECT_TRUE(h.cycle().over);
  EXPECT_EQ(h.state.step, rbc_handover::Step::none);
}

TEST(RbcHandover, An_ended_session_ends_the_repetition) {
  Handover h;
  h.run_to_border();
  h.in.min_safe_rear = true;
  (void)h.cycle();
  h.in.established = false;
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(h.cycle().report);
  h.in.established = true;
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(h.cycle().report);
}

TEST(RbcHandover, A_mode_that_does_not_report_the_border) {  // 4.5.2
  Handover h;
  h.in.reports = false;
  h.announce();
  h.in.max_safe_front = h.in.min_safe_rear = true;
  const rbc_handover::Result r = h.cycle();
  EXPECT_FALSE(r.report);
  EXPECT_TRUE(r.rear_passed_now);
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(h.cycle().terminate);
}

TEST(RbcHandover, With_one_session_the_accepting_RBC_is_called_at_its_end) {  // 3.15.1.3.2
  Handover h;
  h.in.one_session = true;
  h.announce();
  h.in.ended = true;
  EXPECT_FALSE(h.cycle().call_accepting) << "the border is ahead";
  h.in.max_safe_front = h.in.est_front = true;
  EXPECT_TRUE(h.cycle().call_accepting);
  EXPECT_FALSE(h.cycle().call_accepting);
  h.in.min_safe_rear = true;
  EXPECT_TRUE(h.cycle().over);
}

TEST(RbcHandover, A_deleted_order_ends_the_handover_ahead_of_the_border) {  // 3.15.1.3.8 b
  Handover h;
  h.announce();
  h.in.stored = false;
  h.in.max_safe_front = true;
  EXPECT_FALSE(h.cycle().report);
  EXPECT_EQ(h.state.step, rbc_handover::Step::none);
  h.in.stored = true;
  h.run_to_border();
  h.in.stored = false;
  h.in.min_safe_rear = true;
  EXPECT_TRUE(h.cycle().report) << "the train is in the area of the accepting RBC";
  h.in.alone = true;
  (void)h.cycle();
  EXPECT_EQ(h.state.step, rbc_handover::Step::none) << "there is no second session";
}

TEST(RbcHandover, A_new_order_begins_anew) {  // 3.15.1.3.2.2
  Handover h;
  h.run_to_border();
  h.in.min_safe_rear = true;
  (void)h.cycle();
  h.in.max_safe_front = h.in.est_front = h.in.min_safe_rear = false;
  h.announce();
  EXPECT_EQ(h.state.step, rbc_handover::Step::announced);
  EXPECT_FALSE(h.state.contact_changed || h.state.rear_passed);
}

}  // namespace
}  // namespace evc::procedures
