#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>

#include "base/test_units.h"
#include "procedures/end_of_mission.h"
#include "procedures/leaving_rbc.h"
#include "procedures/level_transition.h"
#include "procedures/mode_profile.h"
#include "procedures/observe.h"
#include "procedures/override.h"
#include "procedures/rbc_handover.h"
#include "procedures/reversing.h"
#include "procedures/shunting.h"
#include "procedures/start_of_mission.h"
#include "procedures/train_data_change.h"
#include "procedures/train_trip.h"

// What nobody set is absent: no condition holds, nothing is asked or sent, because of an input that was left alone.
namespace evc::procedures {
namespace {

using evc::test::at;

TEST(Unset, Facts_make_no_condition_true) {
  struct Row {
    const char* given;
    std::function<void(Facts&)> set;
    modes::Conditions conditions;
  };
  // A powered unit whose desk is closed: [4], [27], [28], [30]; at standstill also [3] and [47].
  const Row rows[] = {
      {"nothing", [](Facts&) {}, {4, 27, 28, 30}},
      {"standstill", [](Facts& f) { f.standstill = true; }, {3, 4, 27, 28, 30, 47}},
      {"non leading", [](Facts& f) { f.standstill = f.non_leading = true; }, {3, 4, 27, 28, 30}},
      {"desk", [](Facts& f) { f.desk_open = true; }, {2, 4, 23}},
      {"passive shunting", [](Facts& f) { f.passive_shunting = true; }, {4, 27, 28}},
      {"level 1", [](Facts& f) { f.level = Level::L1; }, {4, 27, 28, 30}},
      {"level 1, standstill",
       [](Facts& f) {
         f.level = Level::L1;
         f.standstill = true;
       },
       {3, 4, 27, 28, 30, 47}},
      {"level 2, standstill",
       [](Facts& f) {
         f.level = Level::L2;
         f.standstill = true;
       },
       {3, 4, 27, 28, 30, 47}},
      {"MA, level 1",
       [](Facts& f) {
         f.level = Level::L1;
         f.ma_ssp_gradient_stored = true;
       },
       {4, 27, 28, 30, 32}},
      {"MA, train data, level 2",
       [](Facts& f) {
         f.level = Level::L2;
         f.ma_ssp_gradient_stored = f.train_data_valid = true;
       },
       {4, 10, 27, 28, 30, 31}},
      {"MA, level 2, acknowledgement areas",
       [](Facts& f) {
         f.level = Level::L2;
         f.ma_ssp_gradient_stored = f.front_in_OS_ack_area = f.front_in_LS_ack_area = true;
       },
       {4, 27, 28, 30, 31}},
      {"MA, level 2, in OS, in the acknowledgement area of LS",
       [](Facts& f) {
         f.level = Level::L2;
         f.ma_ssp_gradient_stored = f.mode_is_OS = f.front_in_LS_ack_area = true;
       },
       {4, 27, 28, 30, 31}},
      {"MA, level 2, in LS, in the acknowledgement area of OS",
       [](Facts& f) {
         f.level = Level::L2;
         f.ma_ssp_gradient_stored = f.mode_is_LS = f.front_in_OS_ack_area = true;
       },
       {4, 27, 28, 30, 31}},
      {"to level 1, no MA accepted",
       [](Facts& f) {
         f.level = Level::L1;
         f.level_switched_to = Level::L1;
         f.ma_ssp_gradient_stored = true;
       },
       {4, 25, 27, 28, 30, 32, 39}},
      {"to level 2, override",
       [](Facts& f) {
         f.level = Level::L2;
         f.level_switched_to = Level::L2;
         f.override_active = true;
       },
       {4, 27, 28, 30, 39, 45}},
      {"profile asks for OS", [](Facts& f) { f.profile_demands_OS = true; }, {4, 27, 28, 30, 40, 73}},
      {"profile asks for LS", [](Facts& f) { f.profile_demands_LS = true; }, {4, 27, 28, 30, 72, 74}},
      {"stop if in SR", [](Facts& f) { f.stop_if_in_SR = true; }, {4, 27, 28, 30, 54}},
      {"shunting selected while moving", [](Facts& f) { f.selects_SH = true; }, {4, 27, 28, 30}},
      {"trip acknowledged in level 0",
       [](Facts& f) {
         f.standstill = f.train_data_valid = true;
         f.requested = f.acknowledged = {Ack::trip};
       },
       {3, 4, 27, 28, 30, 47, 62}},
  };
  for (const Row& row : rows) {
    Facts facts;
    row.set(facts);
    const modes::Conditions found = observe(facts);
    for (int n = 1; n < modes::Conditions::kNumbers; ++n)
      EXPECT_EQ(found.test(n), row.conditions.test(n)) << row.given << " [" << n << "]";
  }
}

TEST(Unset, Handover) {
  using rbc_handover::Step;
  rbc_handover::State state;
  rbc_handover::Inputs in;
  const auto nothing = [](const rbc_handover::Result& r) {
    return !r.change_contact && !r.report && !r.rear_passed_now && !r.terminate && !r.call_accepting && !r.over;
  };
  EXPECT_TRUE(nothing(rbc_handover::step(state, in)));
  in.est_front = in.max_safe_front = in.min_safe_rear = true;  // without an order
  EXPECT_TRUE(nothing(rbc_handover::step(state, in)));
  in = {};
  in.stored = true;  // not ordered in this cycle
  EXPECT_TRUE(nothing(rbc_handover::step(state, in)));
  EXPECT_EQ(state.step, Step::none);
  in = {};
  in.ordered = true;
  EXPECT_TRUE(nothing(rbc_handover::step(state, in)));
  EXPECT_EQ(state.step, Step::none);  // not stored
  in.stored = true;
  EXPECT_TRUE(nothing(rbc_handover::step(state, in)));
  EXPECT_EQ(state.step, Step::announced);
  in.ordered = false;
  in.min_safe_rear = true;  // only after the front end
  EXPECT_TRUE(nothing(rbc_handover::step(state, in)));
  in.min_safe_rear = false;
  in.max_safe_front = true;
  EXPECT_TRUE(nothing(rbc_handover::step(state, in)));  // the mode does not report
  EXPECT_EQ(state.step, Step::at_border);
  in.ended = true;
  EXPECT_TRUE(nothing(rbc_handover::step(state, in)));  // two sessions
  EXPECT_EQ(state.step, Step::at_border);
  in.min_safe_rear = in.reports = true;  // no session with the handing over RBC
  const rbc_handover::Result left = rbc_handover::step(state, in);
  EXPECT_TRUE(left.rear_passed_now);
  EXPECT_FALSE(left.report);
}

TEST(Unset, Change_of_train_data) {
  using namespace train_data_change;
  State state;
  Inputs in;
  EXPECT_EQ(step(state, in).data, Fate::kept);
  in.pending = true;
  EXPECT_EQ(step(state, in).data, Fate::to_validate);
  in.train_data_valid = true;  // in SB, with another source that the driver does not validate
  EXPECT_EQ(step(state, in).data, Fate::in_force);
  state.step = Step::S3;
  EXPECT_EQ(step(state, in).data, Fate::in_force);
}

TEST(Unset, Shunting) {
  shunting::State state;
  shunting::Inputs in;
  in.selects_SH = true;
  EXPECT_FALSE(shunting::step(state, in).selects_SH);  // not at standstill
  in.standstill = true;
  EXPECT_TRUE(shunting::step(state, in).selects_SH);
  in.level = Level::L2;
  const shunting::Result without_session = shunting::step(state, in);
  EXPECT_TRUE(without_session.effects.send.empty());
  EXPECT_FALSE(without_session.selects_SH || without_session.granted || state.waits_for_answer);
  in.session_open = true;
  EXPECT_TRUE(shunting::step(state, in).effects.send.has(Send::shunting_request));
  // Waiting, without an answer.
  shunting::Inputs waiting;
  waiting.level = Level::L2;
  waiting.standstill = waiting.session_open = true;
  const shunting::Result r = shunting::step(state, waiting);
  EXPECT_FALSE(r.granted || r.selects_SH);
  EXPECT_TRUE(r.effects.inform.empty() && state.waits_for_answer);
  // In SH without the choice of the driver.
  waiting.mode = Mode::SH;
  shunting::step(state, waiting);
  EXPECT_FALSE(state.continues);
}

TEST(Unset, Override) {
  override_::Inputs in;
  in.mode = Mode::SB;
  in.level = Level::L2;
  override_::State state;
  override_::Result r = override_::step(state, in);
  EXPECT_FALSE(r.selected || r.started || r.active || r.former_eoa_passed || r.ended_by);
  in.selected = true;
  override_::step(state, in);
  in.selected = false;
  in.mode = Mode::SR;
  r = override_::step(state, in);
  EXPECT_EQ(r.ended_by, Clause{});
  EXPECT_FALSE(r.former_eoa_passed);
  EXPECT_TRUE(state.former_eoa.has_value() && !state.former_eoa_passed);  // no stop if in SR
}

TEST(Unset, Reversing) {
  reversing::Inputs in;
  in.stored = reversing::Area{at(0.0), at(100.0)};
  in.est_front = at(50.0);
  reversing::Result r = reversing::step(in);
  EXPECT_FALSE(r.possible);
  in.standstill = true;
  r = reversing::step(in);
  EXPECT_TRUE(r.possible);
  EXPECT_TRUE(r.effects.requests.empty());
}

TEST(Unset, Leaving_an_RBC) {
  leaving_rbc::State state;
  state.repetition.start(Duration{});
  leaving_rbc::Inputs in;
  in.now = Duration{15.0};
  leaving_rbc::step(state, in);  // no session
  EXPECT_FALSE(state.repetition.waiting);
  state.repetition.start(Duration{});
  in.session_open = true;
  EXPECT_EQ(leaving_rbc::step(state, in).send, Set<Send>{Send::position_report});
}

TEST(Unset, End_of_mission) {
  end_of_mission::State state;
  EXPECT_TRUE(end_of_mission::step(state, {}).send.empty());
  EXPECT_FALSE(state.mission || state.waits_for_order);
  end_of_mission::Inputs in;  // powered up in SB
  in.mode = Mode::SB;
  in.session_open = true;
  EXPECT_TRUE(end_of_mission::step(state, in).send.empty());
  // While it waits, without an order.
  in.previous_mode = Mode::FS;
  state.mission = true;
  EXPECT_EQ(end_of_mission::step(state, in).send, Set<Send>{Send::end_of_mission});
  in.previous_mode = Mode::SB;
  EXPECT_TRUE(end_of_mission::step(state, in).send.empty());
  EXPECT_TRUE(state.waits_for_order);
}

TEST(Unset, Level_transition) {
  level_transition::State state;
  const level_transition::Result r = level_transition::step(state, {});
  EXPECT_FALSE(r.switch_to.has_value() || r.by_driver || r.overdue.has_value() || r.announced || r.cancelled);
  EXPECT_TRUE(r.effects.requests.empty());
  EXPECT_FALSE(state.shown || state.kept || state.acknowledged || state.unacknowledged);
  // An immediate order in SB, without an acknowledgement; the edition is 3.6.0, in which NTC to 1 asks for one.
  level_transition::Inputs in;
  level_transition::JudgedOrder judged;
  level_transition::Order& order = judged.order;
  ASSERT_TRUE(order.table.push_back({.level = Level::L1}));
  in.current.level = Level::NTC;
  judged.decision = modes::judge(order.kind, order.table, in.current, in.mode, in.available);
  in.order = &judged;
  EXPECT_EQ(level_transition::step(state, in).effects.requests, Set<Ack>{Ack::level});
  in.current.level = Level::L1;
  in.order = nullptr;
  EXPECT_EQ(level_transition::step(state, in).effects.requests, Set<Ack>{Ack::level});
}

TEST(Unset, Mode_profile) {
  mode_profile::State state;
  const mode_profile::Result r = mode_profile::step(state, {});
  EXPECT_FALSE(r.demands_OS || r.demands_LS || r.demands_SH || r.in_force || r.front_in_OS_ack_area ||
               r.front_in_LS_ack_area || r.overdue.has_value() || r.at_front.has_value() || r.asks_for.has_value());
  EXPECT_TRUE(r.effects.requests.empty());
  EXPECT_FALSE(state.unacknowledged);
}

TEST(Unset, Start_of_mission) {
  using namespace start_of_mission;
  State state;
  step(state, {});  // no desk
  EXPECT_EQ(state.step, Step::S0);
  Inputs in;
  in.desk_open = true;
  step(state, in);
  EXPECT_EQ(state.step, Step::S1);  // no driver identity
  in.driver_id = DataStatus::valid;
  EXPECT_EQ(step(state, in).entries, Set<Entry>{Entry::level});  // position and level are not known
  EXPECT_EQ(state.step, Step::S2);
  step(state, in);
  EXPECT_EQ(state.step, Step::S2);  // nothing entered
  in.level = Level::L2;
  in.mobile_terminal_registered = true;
  state.step = Step::S3;
  step(state, in);
  EXPECT_EQ(state.step, Step::S3);
  in.session = Session::open;
  in.position = DataStatus::invalid;
  state.step = Step::D33;
  EXPECT_TRUE(step(state, in).status.empty());
  EXPECT_EQ(state.step, Step::D33);  // no answer
  state.step = Step::S10;
  in.train_running_number = in.train_data = DataStatus::valid;
  step(state, in);
  EXPECT_EQ(state.step, Step::S10);  // nothing chosen
  state.step = Step::S20;
  step(state, in);
  EXPECT_EQ(state.step, Step::S20);
  state.step = Step::S21;
  step(state, in);
  EXPECT_EQ(state.step, Step::S21);  // no answer
  in.train_running_number = DataStatus::unknown;
  state.step = Step::S13;
  step(state, in);
  EXPECT_EQ(state.step, Step::S13);
  in.train_data = DataStatus::unknown;
  state.step = Step::S12;
  in.entry_of_train_data_open = true;
  step(state, in);
  EXPECT_EQ(state.step, Step::S12);
}

TEST(Unset, Train_trip) {
  using namespace train_trip;
  State state;
  Inputs in;
  in.mode = Mode::TR;
  EXPECT_TRUE(step(state, in).requests.empty());
  EXPECT_EQ(state.step, Step::S050);  // not at standstill
  in.standstill = true;
  EXPECT_TRUE(step(state, in).requests.empty());  // the desk is closed
  in.mode = Mode::PT;
  in.level = Level::L2;
  EXPECT_TRUE(step(state, in).offers.empty());  // no session
  EXPECT_EQ(state.step, Step::S120);
  in.session_open = true;
  EXPECT_EQ(step(state, in).send, Set<Send>{Send::position_report});
  EXPECT_EQ(state.step, Step::S120);  // not recognised
  state.step = Step::S130;
  step(state, in);
  EXPECT_EQ(state.step, Step::S140);                               // no emergency stop
  EXPECT_EQ(step(state, in).offers, Set<Offer>{Offer::shunting});  // no train data
  in.train_data_valid = true;
  step(state, in);
  EXPECT_EQ(state.step, Step::S140);  // Start is not selected
  state.step = Step::S150;
  step(state, in);
  EXPECT_EQ(state.step, Step::S150);  // no answer
}

}  // namespace
}  // namespace evc::procedures
