#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "base/test_units.h"
#include "procedures/end_of_mission.h"
#include "procedures/level_transition.h"
#include "procedures/mode_profile.h"
#include "procedures/override.h"
#include "procedures/reversing.h"
#include "procedures/shunting.h"
#include "procedures/start_of_mission.h"
#include "procedures/train_trip.h"

// Places exactly on a border, two events in one cycle, and what must not be left over from before.
namespace evc::procedures {
namespace {

using evc::test::at;
constexpr OdometerPlace run(double metres) { return OdometerPlace{Distance{metres}}; }

TEST(Effects, All_sets_are_joined) {
  Effects a, b;
  b.requests = {Ack::LS};
  b.entries = {Entry::level};
  b.offers = {Offer::start};
  b.send = {Send::train_data};
  b.inform = {Inform::SH_refused};
  b.status = {Status::level_valid};
  a |= b;
  EXPECT_EQ(a.requests, b.requests);
  EXPECT_EQ(a.entries, b.entries);
  EXPECT_EQ(a.offers, b.offers);
  EXPECT_EQ(a.send, b.send);
  EXPECT_EQ(a.inform, b.inform);
  EXPECT_EQ(a.status, b.status);
}

// ---- Override, 5.8 ------------------------------------------------------------------------------------------------

struct Overriding {
  override_::State state;
  override_::Inputs in;
  Overriding(Mode mode, Level level = Level::L1) {
    in.mode = mode;
    in.level = level;
    in.eoa_or_loa = at(100.0);
    in.est_front = at(95.0);
    in.min_safe_antenna = at(85.0);
    in.odometer = run(1000.0);
  }
  override_::Result cycle() {
    in.now += Duration{1.0};
    const override_::Result out = step(state, in);
    in.selected = false;
    return out;
  }
  override_::Result select() {
    in.selected = true;
    return cycle();
  }
};

TEST(Override, The_distance_begins_where_it_was_selected_and_is_not_passed_at_its_end) {
  for (const double way : {200.0, -200.0}) {
    Overriding o(Mode::FS);
    o.select();
    o.in.odometer = run(1000.0 + way);
    EXPECT_EQ(o.cycle().ended_by, Clause{});
    o.in.odometer = run(1000.0 + way * 1.001);
    EXPECT_EQ(o.cycle().ended_by, "5.8.4.1 b"_srs);
  }
}

TEST(Override, A_new_former_EOA_can_be_passed_again) {
  for (const Mode mode : {Mode::FS, Mode::LS, Mode::OS, Mode::SB, Mode::PT}) {
    Overriding o(mode, Level::L2);
    o.select();
    o.in.min_safe_antenna = at(100.0);  // on the EOA is not beyond it
    EXPECT_EQ(o.cycle().former_eoa_passed, mode == Mode::SB || mode == Mode::PT) << name(mode);
    o.in.min_safe_antenna = at(100.1);
    o.cycle();
    EXPECT_FALSE(o.cycle().former_eoa_passed);
    o.in.eoa_or_loa = o.in.est_front = at(300.0);
    o.select();
    EXPECT_FALSE(o.cycle().former_eoa_passed) << name(mode);
    o.in.min_safe_antenna = at(300.1);
    EXPECT_TRUE(o.cycle().former_eoa_passed) << name(mode);
  }
}

TEST(Override, Borders_and_levels_of_its_ends) {
  Overriding three(Mode::FS, Level::L3);
  three.select();
  three.in.ma_from_rbc = true;
  EXPECT_EQ(three.cycle().ended_by, "5.8.4.1 f"_srs);
  Overriding sr(Mode::SR);
  sr.in.sr_distance_end = at(120.0);
  sr.select();
  sr.in.est_front = at(120.0);
  EXPECT_EQ(sr.cycle().ended_by, Clause{});
}

TEST(Override, What_is_not_active_does_not_end_nor_with_an_authority_of_the_cycle_in_which_it_starts) {
  Overriding o(Mode::FS);
  EXPECT_EQ(o.cycle().ended_by, Clause{});
  o.in.balise_proceed = true;
  const override_::Result r = o.select();
  EXPECT_TRUE(r.started);
  EXPECT_EQ(r.ended_by, Clause{});
  EXPECT_TRUE(o.state.active);
}

TEST(Override, Goes_on_in_SR_UN_and_SN_only) {
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode to = static_cast<Mode>(m);
    Overriding o(Mode::UN);
    o.select();
    override_::on_mode_change(o.state, to);
    EXPECT_EQ(o.state.active, to == Mode::SR || to == Mode::UN || to == Mode::SN) << name(to);
  }
}

// ---- Level transitions, 5.10 --------------------------------------------------------------------------------------

using modes::OrderKind;

struct Transition {
  level_transition::State state;
  level_transition::Inputs in;
  level_transition::Order order;
  Transition(Level level, Mode mode) {
    in.current = {level, 0, false, Distance{300.0}};
    in.mode = mode;
    in.available.national_systems[0] = ~std::uint64_t{0};
  }
  level_transition::Result cycle(double front = 0.0) {
    in.now += Duration{1.0};
    in.est_front = in.max_safe_front = at(front);
    const level_transition::Result out = step(state, in);
    in.order = nullptr;
    in.acknowledged = false;
    in.driver_level.reset();
    if (out.switch_to.has_value()) in.current = *out.switch_to;
    return out;
  }
  level_transition::Result give(OrderKind kind, Level level, double border = 0.0, double front = 0.0,
                                std::uint8_t ntc = 1) {
    order = {kind, at(border), {}};
    EXPECT_TRUE(order.table.push_back({level, level == Level::NTC ? ntc : std::uint8_t{0}, false, Distance{300.0}}));
    const level_transition::JudgedOrder judged{
        order, modes::judge(order.kind, order.table, in.current, in.mode, in.available)};
    in.order = &judged;
    return cycle(front);
  }
  level_transition::Result acknowledge(double front = 0.0) {
    in.acknowledged = true;
    return cycle(front);
  }
  level_transition::Result driver_chooses(Level level, double front = 0.0) {
    in.driver_level = {level, 0, false, Distance{300.0}};
    return cycle(front);
  }
};

TEST(LevelTransition, The_level_that_is_not_acknowledged_is_named) {
  Transition t(Level::L1, Mode::FS);
  EXPECT_FALSE(t.give(OrderKind::immediate, Level::NTC).overdue.has_value());
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(t.cycle().overdue.has_value());
  EXPECT_EQ(t.cycle().overdue, Level::NTC);
}

TEST(LevelTransition, An_acknowledgement_counts_for_one_transition) {
  Transition t(Level::L2, Mode::FS);
  EXPECT_FALSE(t.give(OrderKind::announcement, Level::NTC, 1000.0, 800.0).cancelled);
  t.acknowledge(810.0);
  EXPECT_TRUE(t.cycle(1000.0).switch_to.has_value());
  EXPECT_TRUE(t.cycle(1001.0).effects.requests.empty());
  EXPECT_EQ(t.give(OrderKind::immediate, Level::L0, 0.0, 1002.0).effects.requests, Set<Ack>{Ack::level});
}

TEST(LevelTransition, Another_level_ahead_is_acknowledged_anew) {
  Transition t(Level::L2, Mode::FS);
  t.give(OrderKind::announcement, Level::NTC, 1000.0, 800.0);
  t.acknowledge(810.0);
  const level_transition::Result other = t.give(OrderKind::announcement, Level::NTC, 1000.0, 820.0, 2);
  EXPECT_TRUE(other.cancelled);
  EXPECT_EQ(other.effects.requests, Set<Ack>{Ack::level});
  // One that a mode change deleted, and that comes again.
  t.acknowledge(830.0);
  level_transition::on_mode_change(t.state, Mode::FS, Mode::SR, SrsVersion::v3_6_0);
  EXPECT_EQ(t.give(OrderKind::announcement, Level::NTC, 1000.0, 840.0, 2).effects.requests, Set<Ack>{Ack::level});
}

TEST(LevelTransition, A_conditional_order_for_the_level_leaves_what_waits) {
  Transition t(Level::L1, Mode::FS);
  t.give(OrderKind::announcement, Level::L2, 1000.0);
  EXPECT_FALSE(t.give(OrderKind::conditional, Level::L1).cancelled);
  EXPECT_EQ(t.cycle(1000.0).switch_to->level, Level::L2);
}

TEST(LevelTransition, A_kept_order_is_executed_once) {
  for (const Mode mode : {Mode::SH, Mode::PS}) {
    Transition t(Level::L1, mode);
    t.give(OrderKind::immediate, Level::L2);
    EXPECT_FALSE(t.cycle().switch_to.has_value());
    t.in.mode = Mode::SB;
    EXPECT_TRUE(t.cycle().switch_to.has_value());
    EXPECT_TRUE(t.driver_chooses(Level::L1).by_driver);
    EXPECT_FALSE(t.cycle().switch_to.has_value()) << name(mode);
  }
}

TEST(LevelTransition, What_the_driver_chose_meanwhile_is_forgotten_at_the_border) {
  Transition t(Level::L1, Mode::FS);
  t.give(OrderKind::announcement, Level::L2, 1000.0);
  t.driver_chooses(Level::L2, 500.0);
  EXPECT_FALSE(t.cycle(1000.0).switch_to.has_value());
  EXPECT_TRUE(t.driver_chooses(Level::L1, 1001.0).by_driver);
  EXPECT_FALSE(t.cycle(1002.0).switch_to.has_value());
  // In 4.0.0 at once.
  Transition newer(Level::L1, Mode::FS);
  newer.in.srs = SrsVersion::v4_0_0;
  newer.give(OrderKind::announcement, Level::L2, 1000.0);
  EXPECT_TRUE(newer.driver_chooses(Level::L0, 500.0).cancelled);
  EXPECT_FALSE(newer.cycle(1000.0).switch_to.has_value());
}

TEST(LevelTransition, The_driver_leaves_a_level_that_he_has_not_acknowledged) {
  Transition t(Level::L2, Mode::UN);
  EXPECT_EQ(t.give(OrderKind::immediate, Level::L0).effects.requests, Set<Ack>{Ack::level});
  EXPECT_TRUE(t.driver_chooses(Level::L1).effects.requests.empty());
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(t.cycle().overdue.has_value());
}

// 4.12 of 4.0.0, "change to level ... not acknowledged". UN, SN, FS, LS, SR and OS are entered by the level transition
// itself: what is asked for there is the acknowledgement of the new level. In PT and RV the driver gives none (4.7.2).
TEST(LevelTransition, Modes_that_revoke_the_brake_command_of_a_missing_acknowledgement) {
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode to = static_cast<Mode>(m);
    Transition t(Level::L2, Mode::FS);
    t.give(OrderKind::immediate, Level::L0);
    EXPECT_TRUE(t.state.unacknowledged);
    level_transition::on_mode_change(t.state, Mode::FS, to, SrsVersion::v3_6_0);
    const bool goes_on = to == Mode::FS || to == Mode::LS || to == Mode::SR || to == Mode::OS || to == Mode::UN ||
                         to == Mode::SN || to == Mode::AD;
    EXPECT_EQ(t.state.unacknowledged, goes_on) << name(to);
  }
}

TEST(LevelTransition, An_acknowledgement_that_was_not_asked_for_is_none) {
  Transition t(Level::L2, Mode::FS);
  t.in.acknowledged = true;
  EXPECT_EQ(t.give(OrderKind::immediate, Level::L0).effects.requests, Set<Ack>{Ack::level});
  EXPECT_EQ(t.cycle().effects.requests, Set<Ack>{Ack::level});
}

// ---- Mode profile, 5.7, 5.9, 5.19 ---------------------------------------------------------------------------------

struct Ahead {
  mode_profile::State state;
  mode_profile::Inputs in;
  std::vector<mode_profile::Area> areas;
  Ahead(Mode mode, Mode area) {
    areas.push_back({area, at(1000.0), at(2000.0), Speed{10.0}, Distance{200.0}});
    in.mode = mode;
  }
  mode_profile::Result cycle(double front, double interval = 0.0) {
    in.now += Duration{1.0};
    in.est_front = at(front);
    in.min_safe_front = at(front - interval);
    in.max_safe_front = at(front + interval);
    in.areas = areas;
    const mode_profile::Result r = step(state, in);
    if (r.asks_for) areas[*r.asks_for].asked = true;
    return r;
  }
};

TEST(ModeProfile, The_length_of_acknowledgement_ends_at_the_area) {
  for (const Mode area : {Mode::OS, Mode::LS}) {
    Ahead a(Mode::FS, area);
    const auto front_in = [&](const mode_profile::Result& r) {
      EXPECT_FALSE(area == Mode::OS ? r.front_in_LS_ack_area : r.front_in_OS_ack_area);
      return area == Mode::OS ? r.front_in_OS_ack_area : r.front_in_LS_ack_area;
    };
    EXPECT_FALSE(front_in(a.cycle(799.9)));
    EXPECT_TRUE(front_in(a.cycle(800.0)));
    EXPECT_TRUE(front_in(a.cycle(999.9)));
    EXPECT_FALSE(front_in(a.cycle(1000.0)));
  }
}

TEST(ModeProfile, Where_the_max_safe_front_end_is_at_the_area_nothing_is_asked_ahead) {
  Ahead a(Mode::FS, Mode::OS);
  const mode_profile::Result r = a.cycle(990.0, 10.0);
  EXPECT_TRUE(r.demands_OS);
  EXPECT_TRUE(r.effects.requests.empty());
}

TEST(ModeProfile, In_OS_and_LS_the_max_safe_front_end_decides_as_in_FS) {
  for (const Mode mode : {Mode::FS, Mode::OS, Mode::LS}) {
    Ahead a(mode, Mode::OS);
    const mode_profile::Result r = a.cycle(1995.0, 10.0);
    EXPECT_FALSE(r.demands_OS) << name(mode);
    EXPECT_TRUE(r.in_force) << name(mode);
  }
}

TEST(ModeProfile, A_mode_change_ends_what_was_asked) {
  Ahead a(Mode::FS, Mode::OS);
  EXPECT_EQ(a.cycle(900.0).effects.requests, Set<Ack>{Ack::OS});
  a.in.V_est = Speed{11.0};  // once shown it stays
  EXPECT_EQ(a.cycle(910.0).effects.requests, Set<Ack>{Ack::OS});
  mode_profile::on_mode_change(a.state, Mode::LS, 70, a.in.now);
  a.areas[0].asked = false;  // by the kernel
  a.in.mode = Mode::LS;
  EXPECT_TRUE(a.cycle(920.0).effects.requests.empty());
  // Entered by the area and not acknowledged: a trip ends that too.
  mode_profile::on_mode_change(a.state, Mode::OS, 40, a.in.now);
  a.in.mode = Mode::OS;
  EXPECT_EQ(a.cycle(1000.0).effects.requests, Set<Ack>{Ack::OS});
  mode_profile::on_mode_change(a.state, Mode::TR, 20, a.in.now);
  a.in.mode = Mode::TR;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(a.cycle(1001.0).overdue.has_value());
}

// ---- Reversing, 5.13 ----------------------------------------------------------------------------------------------

TEST(Reversing, In_which_modes_and_where) {
  reversing::Inputs in;
  in.standstill = true;
  EXPECT_FALSE(reversing::step(in).possible);  // nothing is stored
  in.stored = reversing::Area{at(0.0), at(100.0)};
  for (std::size_t m = 0; m < kModes; ++m) {
    in.mode = static_cast<Mode>(m);
    const bool possible = full_supervision(in.mode) || in.mode == Mode::LS || in.mode == Mode::OS;
    for (const auto& [front, in_area] : {std::pair{-0.1, false}, {0.0, true}, {100.0, true}, {100.1, false}}) {
      in.est_front = at(front);
      EXPECT_EQ(reversing::step(in).possible, possible && in_area) << name(in.mode) << " " << front;
    }
  }
}

// ---- Shunting, 5.6 ------------------------------------------------------------------------------------------------

struct Asking {
  shunting::State state;
  shunting::Inputs in;
  Asking() {
    in.level = Level::L2;
    in.standstill = in.session_open = true;
  }
  shunting::Result cycle(double seconds = 1.0) {
    in.now += Duration{seconds};
    const shunting::Result out = step(state, in);
    in.selects_SH = in.authorised = in.refused = false;
    return out;
  }
  void ask() {
    in.selects_SH = true;
    EXPECT_TRUE(cycle().effects.send.has(Send::shunting_request));
  }
  bool granted() {
    in.authorised = true;
    return cycle().granted;
  }
};

TEST(Shunting, The_request_ends_with_the_session_the_level_or_the_mode) {
  Asking still;
  still.ask();
  EXPECT_TRUE(still.granted());
  Asking session;
  session.ask();
  session.in.session_open = false;
  session.cycle();
  session.in.session_open = true;
  EXPECT_TRUE(session.cycle(15.0).effects.send.empty());
  EXPECT_FALSE(session.granted());
  Asking level;
  level.ask();
  level.in.level = Level::L1;
  level.cycle();
  level.in.level = Level::L3;
  EXPECT_FALSE(level.granted());
  for (const Mode mode : {Mode::SH, Mode::PS}) {
    Asking in_mode;
    in_mode.ask();
    in_mode.in.mode = mode;
    in_mode.cycle();
    in_mode.in.selects_SH = true;
    EXPECT_TRUE(in_mode.cycle().effects.send.empty()) << name(mode);
    in_mode.in.mode = Mode::SB;
    EXPECT_FALSE(in_mode.granted()) << name(mode);
  }
}

TEST(Shunting, A_grant_and_a_refusal_in_one_cycle_are_a_grant) {
  Asking a;
  a.ask();
  a.in.authorised = a.in.refused = true;
  const shunting::Result r = a.cycle();
  EXPECT_TRUE(r.granted);
  EXPECT_TRUE(r.effects.inform.empty());
}

TEST(Shunting, After_giving_up_a_late_grant_is_none) {
  Asking a;
  a.ask();
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(a.cycle(15.0).effects.send.has(Send::shunting_request));
  const shunting::Result r = a.cycle(15.0);
  EXPECT_TRUE(r.effects.inform.has(Inform::SH_request_failed));
  EXPECT_EQ(r.effects.send, Set<Send>{Send::terminate_session});
  EXPECT_FALSE(a.granted());
}

// ---- End of mission, 5.5 ------------------------------------------------------------------------------------------

TEST(EndOfMission, From_PS_to_SH_no_session_ends) {
  end_of_mission::State state;
  end_of_mission::Inputs in;
  in.level_2_or_3 = in.session_open = true;
  in.mode = Mode::SH;
  in.previous_mode = Mode::PS;
  EXPECT_TRUE(end_of_mission::step(state, in).send.empty());
  in.previous_mode = Mode::SB;
  EXPECT_EQ(end_of_mission::step(state, in).send, Set<Send>{Send::position_report});
}

TEST(EndOfMission, An_order_that_comes_with_the_report_does_not_answer_it) {
  end_of_mission::State state;
  state.mission = true;
  end_of_mission::Inputs in;
  in.session_open = in.termination_ordered = true;
  in.previous_mode = Mode::FS;
  in.mode = Mode::SB;
  EXPECT_EQ(end_of_mission::step(state, in).send, Set<Send>{Send::end_of_mission});
  EXPECT_TRUE(state.waits_for_order);
}

TEST(EndOfMission, A_session_that_ended_by_itself_ends_the_wait) {
  end_of_mission::State state;
  state.mission = true;
  end_of_mission::Inputs in;
  in.session_open = true;
  in.previous_mode = Mode::FS;
  in.mode = Mode::SB;
  end_of_mission::step(state, in);
  in.previous_mode = Mode::SB;
  in.session_open = false;
  end_of_mission::step(state, in);
  in.session_open = true;
  in.now = Duration{15.0};
  EXPECT_TRUE(end_of_mission::step(state, in).send.empty());
}

TEST(EndOfMission, After_the_order_nothing_is_repeated) {
  end_of_mission::State state;
  state.mission = true;
  end_of_mission::Inputs in;
  in.session_open = true;
  in.previous_mode = Mode::FS;
  in.mode = Mode::SB;
  end_of_mission::step(state, in);
  in.previous_mode = Mode::SB;
  in.termination_ordered = true;
  EXPECT_EQ(end_of_mission::step(state, in).send, Set<Send>{Send::terminate_session});
  in.termination_ordered = false;
  in.now = Duration{15.0};  // the session is still being closed
  EXPECT_TRUE(end_of_mission::step(state, in).send.empty());
}

// ---- Start of mission, 5.4 ----------------------------------------------------------------------------------------

struct Starting {
  start_of_mission::State state;
  start_of_mission::Inputs in;
  Starting(start_of_mission::Step step, Level level) {
    state.step = step;
    state.desk_was_open = true;
    in.desk_open = true;
    in.level = level;
    in.driver_id = DataStatus::valid;
  }
  Effects cycle() { return start_of_mission::step(state, in); }
};

using start_of_mission::Session;
using SoM = start_of_mission::Step;

TEST(StartOfMission, Without_a_session_nothing_is_reported) {  // D31, D32, A34
  Starting s(SoM::D31, Level::L2);
  const Effects e = s.cycle();
  EXPECT_EQ(s.state.step, SoM::S10);
  EXPECT_FALSE(e.send.has(Send::start_of_mission_report));
  EXPECT_TRUE(e.status.empty());
}

// What the RBC is asked for belongs to level 2; trackside may order another level meanwhile.
TEST(StartOfMission, A_step_that_waits_for_the_RBC_ends_with_level_2) {  // 5.4.3.2 S2, D10
  for (const auto& [step, next] : {std::pair{SoM::S3, SoM::S10},
                                   {SoM::D33, SoM::S10},
                                   {SoM::S11, SoM::S20},
                                   {SoM::S21, SoM::S20},
                                   {SoM::S24, SoM::S24},
                                   {SoM::S25, SoM::S20}})
    for (const Level level : {Level::L2, Level::L1}) {
      Starting s(step, level);
      s.in.session = Session::open;
      s.in.mobile_terminal_registered = true;
      (void)s.cycle();
      EXPECT_EQ(s.state.step, level == Level::L2 ? step : next) << int(step);
    }
}

TEST(StartOfMission, The_session_of_the_mission_before_is_terminated_once) {  // 5.4.1.4
  start_of_mission::State state;
  start_of_mission::Inputs in;
  in.desk_open = true;
  in.session = Session::open;
  EXPECT_TRUE(start_of_mission::step(state, in).send.has(Send::terminate_session));
  EXPECT_FALSE(start_of_mission::step(state, in).send.has(Send::terminate_session));
  in.mode = Mode::SR;
  (void)start_of_mission::step(state, in);
  in.mode = Mode::SB;  // the desk has been open all the time
  EXPECT_FALSE(start_of_mission::step(state, in).send.has(Send::terminate_session));
}

TEST(StartOfMission, It_had_a_session_when_one_was_open) {
  for (const Session session : {Session::none, Session::establishing, Session::open}) {
    Starting s(SoM::S10, Level::L2);
    s.in.session = session;
    (void)s.cycle();
    EXPECT_EQ(s.state.had_session, session == Session::open);
    EXPECT_EQ(start_of_mission::without_session(s.state), session != Session::open);
  }
}

TEST(StartOfMission, Each_step_asks_for_its_own_entry_only) {
  struct Row {
    SoM step;
    Level level;
    Set<Entry> entries;
    Set<Offer> offers;
    Set<Ack> requests;
  };
  const Set<Offer> all = {Offer::shunting,  Offer::non_leading,   Offer::train_data,
                          Offer::override_, Offer::driver_id,     Offer::train_running_number,
                          Offer::level,     Offer::rbc_contact,   Offer::radio_network,
                          Offer::vbc,       Offer::bmm_inhibition};
  const Row rows[] = {
      {SoM::S1, Level::L1, {Entry::driver_id}, {Offer::train_running_number, Offer::vbc}, {}},
      {SoM::S2, Level::L1, {Entry::level}, {}, {}},
      {SoM::S3, Level::L2, {Entry::rbc_contact}, {Offer::radio_network}, {}},
      {SoM::S10, Level::L1, {Entry::train_data}, all, {}},
      {SoM::S20, Level::L1, {Entry::train_data}, all, {}},
      {SoM::S12, Level::L1, {Entry::train_data}, {}, {}},
      {SoM::S13, Level::L1, {Entry::train_running_number}, {}, {}},
      {SoM::S22, Level::NTC, {}, {}, {Ack::SN}},
      {SoM::S23, Level::L0, {}, {}, {Ack::UN}},
      {SoM::S24, Level::L1, {}, {}, {Ack::SR}},
  };
  for (const Row& row : rows) {
    Starting s(row.step, row.level);
    if (row.step == SoM::S1) s.in.driver_id = DataStatus::unknown;
    s.in.entry_of_train_data_open = s.state.entry_was_open = row.step == SoM::S12;
    s.in.mobile_terminal_registered = true;
    const Effects out = s.cycle();
    EXPECT_EQ(s.state.step, row.step);
    EXPECT_EQ(out.entries, row.entries) << int(row.step);
    EXPECT_EQ(out.offers, row.offers) << int(row.step);
    EXPECT_EQ(out.requests, row.requests) << int(row.step);
  }
}

TEST(StartOfMission, Start_is_offered_with_train_data_and_running_number) {
  for (const bool data : {false, true})
    for (const bool number : {false, true}) {
      Starting s(SoM::S10, Level::L1);
      s.in.train_data = data ? DataStatus::valid : DataStatus::invalid;
      s.in.train_running_number = number ? DataStatus::valid : DataStatus::invalid;
      const Effects out = s.cycle();
      EXPECT_EQ(out.offers.has(Offer::start), data && number);
      EXPECT_EQ(out.entries.has(Entry::train_data), !data);
    }
}

TEST(StartOfMission, A_level_is_invalid_where_the_position_is_and_the_driver_did_not_just_enter_it) {
  for (const bool entered : {false, true}) {
    Starting s(SoM::S1, Level::L1);
    s.in.level_status = DataStatus::valid;
    s.in.position = DataStatus::invalid;
    s.in.enters_level = entered;
    EXPECT_EQ(s.cycle().status.has(Status::level_invalid), !entered);
  }
  Starting unknown(SoM::S1, Level::L1);
  unknown.in.position = DataStatus::valid;
  EXPECT_FALSE(unknown.cycle().status.has(Status::level_invalid));  // it is not valid already
}

TEST(StartOfMission, With_position_and_level_the_session_is_opened_at_once_in_levels_2_and_3) {
  for (std::size_t l = 0; l < kLevels; ++l) {
    Starting s(SoM::S1, static_cast<Level>(l));
    s.in.position = s.in.level_status = DataStatus::valid;
    s.in.mobile_terminal_registered = true;
    const Effects out = s.cycle();
    const bool rbc = level_2_or_3(s.in.level);
    EXPECT_EQ(out.send, rbc ? Set<Send>{Send::open_session} : Set<Send>{});
    EXPECT_TRUE(out.inform.empty());
    EXPECT_EQ(s.state.step, rbc ? SoM::D31 : SoM::S10);
  }
}

TEST(StartOfMission, Status_of_the_RBC_contact_and_the_position) {
  Starting contact(SoM::S3, Level::L2);
  contact.in.mobile_terminal_registered = contact.in.enters_rbc_contact = true;
  EXPECT_EQ(contact.cycle().status, Set<Status>{Status::rbc_contact_valid});
  Starting opened(SoM::D31, Level::L2);
  opened.in.session = Session::open;
  EXPECT_EQ(opened.cycle().status, Set<Status>{Status::rbc_contact_valid});
  Starting rejected(SoM::D33, Level::L2);
  rejected.in.session = Session::open;
  rejected.in.train_rejected = true;
  EXPECT_EQ(rejected.cycle().status, Set<Status>{Status::position_unknown});
  // A level entered in S2 is entered once.
  Starting level(SoM::S2, Level::L1);
  level.in.enters_level = true;
  EXPECT_EQ(level.cycle().status, Set<Status>{Status::level_valid});
}

TEST(StartOfMission, A_desk_that_is_closed_in_SB_leaves_the_position_as_it_is) {
  Starting s(SoM::S10, Level::L1);
  s.in.desk_open = false;
  s.in.position = DataStatus::invalid;
  EXPECT_TRUE(s.cycle().status.empty());
  EXPECT_EQ(s.state.step, SoM::S0);
}

TEST(StartOfMission, A_desk_that_is_closed_meanwhile_ends_the_session) {  // 3.5.3.8 a, 3.5.5.1
  Starting s(SoM::D31, Level::L2);
  s.in.session = Session::establishing;
  s.in.desk_open = false;
  EXPECT_EQ(s.cycle().send, Set<Send>{Send::terminate_session});
  EXPECT_TRUE(s.cycle().send.empty()) << "once";
  Starting left(SoM::S24, Level::L2);
  left.in.mode = Mode::SR;
  left.in.desk_open = false;
  EXPECT_TRUE(left.cycle().send.empty()) << "the mission has begun: its end is another procedure";
}

TEST(StartOfMission, A_session_that_is_open_when_the_desk_is_opened_is_terminated_first) {  // 5.4.1.4
  Starting s(SoM::S0, Level::L2);
  s.state.desk_was_open = false;
  s.in.session = Session::open;
  EXPECT_EQ(s.cycle().send, Set<Send>{Send::terminate_session});
  EXPECT_EQ(s.state.step, SoM::S0);
  EXPECT_TRUE(s.cycle().send.empty()) << "once";
  s.in.session = Session::terminating;
  (void)s.cycle();
  EXPECT_NE(s.state.step, SoM::S0);
}

TEST(StartOfMission, A_session_that_comes_before_the_start_is_terminated_once_it_was_used) {  // 5.4.1.4, S0
  Starting s(SoM::S0, Level::L2);
  s.state.desk_was_open = true;
  s.in.session = Session::establishing;
  EXPECT_TRUE(s.cycle().send.empty());
  s.in.session = Session::open;
  EXPECT_TRUE(s.cycle().send.empty()) << "stand by is reported";
  EXPECT_EQ(s.cycle().send, Set<Send>{Send::terminate_session});
  EXPECT_TRUE(s.cycle().send.empty()) << "once";
  EXPECT_EQ(s.state.step, SoM::S0);
  s.in.session = Session::none;
  (void)s.cycle();
  s.state.step = SoM::S0;
  s.in.session = Session::open;
  EXPECT_TRUE(s.cycle().send.empty()) << "another one";
  EXPECT_EQ(s.cycle().send, Set<Send>{Send::terminate_session});
}

TEST(StartOfMission, The_entry_of_train_data_is_left_as_it_was_entered) {  // E11, S12
  for (const bool known : {false, true}) {
    Starting s(SoM::S20, Level::L2);
    s.in.session = Session::open;
    s.in.train_data = s.in.train_running_number = DataStatus::valid;
    s.in.train_data_acknowledged = known;
    s.in.entry_of_train_data_open = true;
    (void)s.cycle();
    EXPECT_EQ(s.state.step, SoM::S12);
    (void)s.cycle();
    EXPECT_EQ(s.state.step, SoM::S12);
    s.in.entry_of_train_data_open = false;
    EXPECT_TRUE(s.cycle().send.empty());
    EXPECT_EQ(s.state.step, known ? SoM::S20 : SoM::S10);
  }
  Starting s(SoM::S10, Level::L1);
  s.in.entry_of_train_data_open = true;
  (void)s.cycle();
  s.in.train_data = s.in.train_running_number = DataStatus::valid;
  s.in.enters_train_data = true;
  (void)s.cycle();
  EXPECT_EQ(s.state.step, SoM::S20);
  s.in.enters_train_data = false;
  (void)s.cycle();
  EXPECT_EQ(s.state.step, SoM::S20) << "the entry is still open, and was made";
}

TEST(StartOfMission, Knows_whether_it_had_a_session) {  // 3.5.3.4 g
  Starting s(SoM::S10, Level::L2);
  EXPECT_TRUE(start_of_mission::without_session(s.state));
  s.in.session = Session::open;
  (void)s.cycle();
  s.in.session = Session::none;
  (void)s.cycle();
  EXPECT_FALSE(start_of_mission::without_session(s.state));
  EXPECT_FALSE(start_of_mission::without_session(start_of_mission::State{})) << "it does not go on";
}

TEST(StartOfMission, What_is_sent_in_a_cycle_is_not_answered_in_it) {
  Starting data(SoM::S12, Level::L2);
  data.in.session = Session::open;
  data.in.train_data = data.in.train_running_number = DataStatus::valid;
  data.in.train_data_acknowledged = data.in.enters_train_data = true;
  EXPECT_EQ(data.cycle().send, Set<Send>{Send::train_data});
  EXPECT_EQ(data.state.step, SoM::S11);
  Starting request(SoM::S20, Level::L2);
  request.in.session = Session::open;
  request.in.train_data = request.in.train_running_number = DataStatus::valid;
  request.in.selects_start = request.in.SR_authorised = true;
  request.cycle();
  EXPECT_EQ(request.state.step, SoM::S21) << "a request of this cycle is answered in the next one at the earliest";
}

// ---- Train trip, 5.11 ---------------------------------------------------------------------------------------------

struct Post {
  train_trip::State state;
  train_trip::Inputs in;
  Post(train_trip::Step step, Level level) {
    state.step = step;
    in.mode = Mode::PT;
    in.level = level;
    in.now = Duration{1.0};
    in.desk_open = in.standstill = in.session_open = in.train_data_valid = true;
  }
  Effects cycle() { return train_trip::step(state, in); }
};

TEST(TrainTrip, Exit_recognised_by_step) {
  using enum train_trip::Step;
  for (const train_trip::Step step : {S010, S050, S060, S120, S121})
    EXPECT_FALSE(train_trip::exit_recognised({step, Mode::OS, {}})) << int(step);
  for (const train_trip::Step step : {S130, S140, S150, S160, S170})
    EXPECT_TRUE(train_trip::exit_recognised({step, Mode::OS, {}})) << int(step);
}

TEST(TrainTrip, PT_begins_with_its_report_wherever_it_is_entered_from) {
  using enum train_trip::Step;
  for (const train_trip::Step from : {S010, S050, S060}) {
    Post p(from, Level::L2);
    EXPECT_EQ(p.cycle().send, Set<Send>{Send::position_report}) << int(from);
    EXPECT_EQ(p.state.step, S120);
  }
  // A second trip: nothing is left of the first one's repetitions.
  Post again(S060, Level::L2);
  again.cycle();
  again.in.mode = Mode::TR;
  again.cycle();
  again.in.mode = Mode::PT;
  EXPECT_EQ(again.cycle().send, Set<Send>{Send::position_report});
}

TEST(TrainTrip, A_session_opened_again_gets_the_report_at_once) {
  Post p(train_trip::Step::S060, Level::L2);
  p.cycle();
  p.in.session_open = false;
  EXPECT_TRUE(p.cycle().send.empty());
  p.in.session_open = true;
  EXPECT_EQ(p.cycle().send, Set<Send>{Send::position_report});
}

TEST(TrainTrip, Without_emergency_stop_the_driver_may_go_on_in_the_cycle_of_the_recognition) {
  Post p(train_trip::Step::S060, Level::L2);
  EXPECT_TRUE(p.cycle().requests.empty());
  p.in.exit_recognised = true;
  EXPECT_EQ(p.cycle().offers, (Set<Offer>{Offer::shunting, Offer::start}));
  p.in.session_open = false;
  EXPECT_EQ(p.cycle().offers, Set<Offer>{Offer::shunting});
}

TEST(TrainTrip, The_MA_request_ends_with_level_2) {  // 5.11.2.2 S140 a
  Post p(train_trip::Step::S150, Level::L2);
  p.cycle();
  EXPECT_EQ(p.state.step, train_trip::Step::S150);
  p.in.level = Level::L1;
  EXPECT_TRUE(p.cycle().offers.has(Offer::start));
  EXPECT_EQ(p.state.step, train_trip::Step::S140);
}

TEST(TrainTrip, The_MA_request_is_not_answered_in_its_cycle) {
  Post p(train_trip::Step::S140, Level::L2);
  p.in.selects_start = p.in.SR_authorised = true;
  p.cycle();
  EXPECT_EQ(p.state.step, train_trip::Step::S150);
  p.in.selects_start = p.in.SR_authorised = false;
  p.in.session_open = false;
  p.cycle();
  EXPECT_EQ(p.state.step, train_trip::Step::S140);
}

}  // namespace
}  // namespace evc::procedures
