#include "procedures/train_trip.h"

#include <gtest/gtest.h>

#include <utility>

namespace evc::procedures {
namespace {

struct Tripped {
  train_trip::State state;
  train_trip::Inputs in;
  Tripped(Level level) {
    in.level = level;
    in.mode = Mode::TR;
    in.desk_open = in.train_data_valid = true;
    in.session_open = true;
  }
  Effects cycle() {
    in.now += Duration{1.0};
    const Effects out = step(state, in);
    in.exit_recognised = in.selects_start = in.SR_authorised = false;
    return out;
  }
  Effects to_pt() {
    cycle();
    in.standstill = true;
    cycle();
    in.mode = Mode::PT;
    return cycle();
  }
};

TEST(TrainTrip, The_acknowledgement_is_asked_for_at_standstill) {
  Tripped t(Level::L2);
  EXPECT_TRUE(t.cycle().send.has(Send::position_report));
  EXPECT_EQ(t.state.step, train_trip::Step::S050);
  EXPECT_TRUE(t.cycle().send.empty());
  t.in.standstill = true;
  EXPECT_EQ(t.cycle().requests, Set<Ack>{Ack::trip});
  t.in.desk_open = false;
  EXPECT_TRUE(t.cycle().requests.empty());
  t.in.desk_open = true;
  EXPECT_EQ(t.cycle().requests, Set<Ack>{Ack::trip});
  Tripped one(Level::L1);
  EXPECT_TRUE(one.cycle().send.empty());
}

TEST(TrainTrip, Level_1_goes_on_with_Start_and_SR) {
  Tripped t(Level::L1);
  const Effects e = t.to_pt();
  EXPECT_EQ(t.state.step, train_trip::Step::S140);
  EXPECT_TRUE(e.offers.has(Offer::start) && e.offers.has(Offer::shunting));
  t.in.selects_start = true;
  EXPECT_EQ(t.cycle().requests, Set<Ack>{Ack::SR});
  EXPECT_EQ(t.cycle().requests, Set<Ack>{Ack::SR});
  t.in.mode = Mode::SR;
  t.cycle();
  EXPECT_EQ(t.state.step, train_trip::Step::S010);
}

TEST(TrainTrip, Level_2_waits_for_the_RBC) {
  Tripped t(Level::L2);
  t.in.emergency_stop_pending = true;
  EXPECT_TRUE(t.to_pt().send.has(Send::position_report));
  EXPECT_EQ(t.state.step, train_trip::Step::S120);
  EXPECT_FALSE(train_trip::exit_recognised(t.state));
  t.in.exit_recognised = true;
  EXPECT_TRUE(t.cycle().offers.empty());
  EXPECT_EQ(t.state.step, train_trip::Step::S130);
  EXPECT_TRUE(train_trip::exit_recognised(t.state));
  t.in.emergency_stop_pending = false;
  EXPECT_TRUE(t.cycle().offers.has(Offer::start));
  t.in.train_data_valid = false;
  EXPECT_FALSE(t.cycle().offers.has(Offer::start));
  t.in.selects_start = true;
  t.cycle();
  EXPECT_EQ(t.state.step, train_trip::Step::S140);
  t.in.train_data_valid = true;
  t.in.selects_start = true;
  t.cycle();
  EXPECT_EQ(t.state.step, train_trip::Step::S150);
  t.in.selects_start = false;
  const Tripped waiting = t;
  t.in.SR_authorised = true;
  EXPECT_EQ(t.cycle().requests, Set<Ack>{Ack::SR});
  t.in.session_open = false;
  t.cycle();
  EXPECT_EQ(t.state.step, train_trip::Step::S140);
  for (const auto& [mode, ack] : {std::pair{Mode::OS, Ack::OS}, {Mode::LS, Ack::LS}, {Mode::SH, Ack::SH}}) {
    t = waiting;
    t.in.profile_at_front = mode;
    EXPECT_EQ(t.cycle().requests, Set<Ack>{ack});
  }
  t = waiting;
  t.in.session_open = false;
  t.cycle();
  EXPECT_EQ(t.state.step, train_trip::Step::S140);
  t.in.selects_start = true;
  t.cycle();
  EXPECT_EQ(t.state.step, train_trip::Step::S140);
}

TEST(TrainTrip, An_RBC_that_does_not_answer_is_left) {
  Tripped t(Level::L2);
  t.to_pt();
  int reports = 0;
  bool terminated = false;
  for (int i = 0; i < 100 && !terminated; ++i) {
    const Effects e = t.cycle();
    reports += e.send.has(Send::position_report) ? 1 : 0;
    terminated = e.send.has(Send::terminate_session);
  }
  EXPECT_EQ(reports, 3);
  EXPECT_TRUE(terminated);
  EXPECT_EQ(t.state.step, train_trip::Step::S121);
  t.cycle();
  EXPECT_EQ(t.state.step, train_trip::Step::S121);
  t.in.session_open = false;
  EXPECT_TRUE(t.cycle().offers.empty());
  EXPECT_TRUE(t.cycle().send.empty());
  t.in.session_open = true;
  EXPECT_TRUE(t.cycle().send.has(Send::position_report));
  EXPECT_EQ(t.state.step, train_trip::Step::S120);
}

}  // namespace
}  // namespace evc::procedures
