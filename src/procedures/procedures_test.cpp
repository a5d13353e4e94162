#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "procedures/end_of_mission.h"
#include "procedures/leaving_rbc.h"
#include "procedures/level_transition.h"
#include "procedures/mode_profile.h"
#include "procedures/override.h"
#include "procedures/reversing.h"
#include "procedures/shunting.h"
#include "procedures/train_trip.h"

namespace evc::procedures {
namespace {

using modes::Level;
using modes::Mode;

constexpr Place at(double metres) { return Place{Distance{metres}}; }

TEST(Effects, Are_joined) {
  Effects a, b;
  a.requests.add(Ack::OS);
  b.send.add(Send::ma_request);
  b.service_brake = true;
  a |= b;
  EXPECT_TRUE(a.requests.has(Ack::OS) && a.send.has(Send::ma_request) && a.service_brake);
  EXPECT_EQ(Set<Ack>::of_bits(0b101), (Set<Ack>{Ack::OS, Ack::SH}));
  EXPECT_EQ((Set<Ack>{Ack::OS, Ack::SH}).bits(), 0b101u);
  EXPECT_EQ(Set<Ack>::of_bits(~0u).bits(), (1u << 12) - 1u);
}

TEST(Repetition, Four_sendings_fifteen_seconds_apart_then_the_end) {
  Repetition r;
  r.start(Duration{0.0});
  std::vector<double> sent;
  for (double t = 0.0; t < 100.0; t += 1.0) {
    const Repetition::Due due = r.due(Duration{t});
    if (due == Repetition::Due::send_again) sent.push_back(t);
    if (due == Repetition::Due::give_up) {
      EXPECT_EQ(t, 60.0);
      break;
    }
  }
  EXPECT_EQ(sent, (std::vector<double>{15.0, 30.0, 45.0}));
  EXPECT_EQ(r.due(Duration{200.0}), Repetition::Due::nothing);
}

// --- end of mission ---------------------------------------------------------------------------------

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
  for (std::size_t m = 0; m < modes::kModes; ++m) {
    const Mode from = static_cast<Mode>(m);
    const bool to_sb = from == Mode::FS || from == Mode::LS || from == Mode::OS || from == Mode::UN ||
                       from == Mode::NL || from == Mode::SR || from == Mode::RV || from == Mode::SN || from == Mode::PT;
    EXPECT_EQ(end_of_mission::ends_mission(from, Mode::SB, true), to_sb) << modes::name(from);
    const bool to_sh = to_sb && from != Mode::NL && from != Mode::RV;
    EXPECT_EQ(end_of_mission::ends_mission(from, Mode::SH, true), to_sh) << modes::name(from);
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
  // A session that is lost ends the wait.
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

// --- leaving the RBC's area -------------------------------------------------------------------------

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
  EXPECT_TRUE(l.cycle().send.empty());  // the report of the border itself is the radio's
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

// --- shunting ---------------------------------------------------------------------------------------

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
  EXPECT_TRUE(s.ask().effects.send.empty());  // once is enough
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
  s.in.mode = Mode::PS;
  s.cycle();
  EXPECT_TRUE(s.state.continues);
  s.in.mode = Mode::SB;
  s.cycle();
  EXPECT_FALSE(s.state.continues);
}

// --- override ---------------------------------------------------------------------------------------

struct Driver {
  override_::State state;
  override_::Inputs in;
  Driver() {
    in.mode = Mode::FS;
    in.level = Level::L2;
    in.train_data_valid = true;
    in.V_NVALLOWOVTRP = Speed{5.0};
    in.eoa_or_loa = at(100.0);
    in.est_front = at(95.0);
    in.min_safe_antenna = at(85.0);
  }
  override_::Result cycle(double seconds = 1.0) {
    in.now += Duration{seconds};
    const override_::Result out = step(state, in);
    in.selected = in.stop_if_in_SR = in.stop_if_in_SH = in.balise_proceed = in.ma_from_rbc = in.group_not_in_list =
        false;
    return out;
  }
  /// Selects override in FS and goes to SR.
  override_::Result select() {
    in.selected = true;
    const override_::Result out = cycle();
    override_::on_mode_change(state, in.mode, Mode::SR);
    in.mode = Mode::SR;
    return out;
  }
};

TEST(Override, Where_it_may_be_selected) {
  for (std::size_t m = 0; m < modes::kModes; ++m) {
    Driver d;
    d.in.mode = static_cast<Mode>(m);
    const bool with_data = d.in.mode == Mode::FS || d.in.mode == Mode::LS || d.in.mode == Mode::OS ||
                           d.in.mode == Mode::SR || d.in.mode == Mode::UN || d.in.mode == Mode::PT ||
                           d.in.mode == Mode::SN || d.in.mode == Mode::SB;
    EXPECT_EQ(override_::selectable(d.in), with_data || d.in.mode == Mode::SH) << modes::name(d.in.mode);
    d.in.train_data_valid = false;
    EXPECT_EQ(override_::selectable(d.in), d.in.mode == Mode::SH) << modes::name(d.in.mode);
    d.in.train_data_valid = true;
    d.in.V_est = Speed{5.1};
    EXPECT_FALSE(override_::selectable(d.in));
  }
  Driver standby;
  standby.in.mode = Mode::SB;
  standby.in.level = Level::L1;
  EXPECT_FALSE(override_::selectable(standby.in));
}

TEST(Override, Too_fast_is_no_selection) {
  Driver d;
  d.in.selected = true;
  d.in.V_est = Speed{6.0};
  const auto r = d.cycle();
  EXPECT_FALSE(r.selected || r.started || r.active);
}

TEST(Override, Every_end_condition_ends_it_and_is_named) {
  const auto ended_by = [](auto&& change, double seconds = 1.0) {
    Driver d;
    const auto selected = d.select();
    EXPECT_TRUE(selected.selected && selected.started && selected.active);
    change(d);
    const auto r = d.cycle(seconds);
    EXPECT_TRUE(r.active);  // the status before the end conditions of this cycle (5.8.4.2)
    EXPECT_EQ(d.state.active, r.ended_by == nullptr);
    return r.ended_by;
  };
  EXPECT_EQ(ended_by([](Driver&) {}), nullptr);
  EXPECT_STREQ(ended_by([](Driver&) {}, 60.0), "5.8.4.1 a");
  EXPECT_STREQ(ended_by([](Driver& d) { d.in.odometer = OdometerPlace{Distance{200.1}}; }), "5.8.4.1 b");
  EXPECT_STREQ(ended_by([](Driver& d) { d.in.odometer = OdometerPlace{Distance{-200.1}}; }), "5.8.4.1 b");
  EXPECT_STREQ(ended_by([](Driver& d) { d.in.min_safe_antenna = at(100.1); }), "5.8.4.1 c");
  EXPECT_STREQ(ended_by([](Driver& d) { d.in.stop_if_in_SR = true; }), "5.8.4.1 d");
  EXPECT_STREQ(ended_by([](Driver& d) { d.in.stop_if_in_SH = true; }), "5.8.4.1 d");
  EXPECT_STREQ(ended_by([](Driver& d) { d.in.balise_proceed = true; }), "5.8.4.1 e");
  EXPECT_STREQ(ended_by([](Driver& d) { d.in.ma_from_rbc = true; }), "5.8.4.1 f");
  EXPECT_STREQ(ended_by([](Driver& d) { d.in.group_not_in_list = true; }), "5.8.4.1 g");
  EXPECT_EQ(ended_by([](Driver& d) {
              d.in.level = Level::L1;
              d.in.ma_from_rbc = true;
            }),
            nullptr);
  EXPECT_EQ(ended_by([](Driver& d) {
              d.in.D_NVOVTRP.reset();
              d.in.odometer = OdometerPlace{Distance{1.0e6}};
            }),
            nullptr);
}

TEST(Override, In_UN_and_SN_only_time_and_distance_end_it) {
  for (const Mode mode : {Mode::UN, Mode::SN}) {
    Driver d;
    d.in.mode = mode;
    d.in.selected = true;
    d.cycle();
    d.in.balise_proceed = d.in.group_not_in_list = true;
    EXPECT_EQ(d.cycle().ended_by, nullptr);
    EXPECT_FALSE(d.state.former_eoa.has_value());
    EXPECT_STREQ(d.cycle(60.0).ended_by, "5.8.4.1 a");
  }
}

TEST(Override, The_SR_distance_before_it_ends_it) {
  Driver d;
  d.in.mode = Mode::SR;
  d.in.sr_distance_end = at(120.0);
  d.in.selected = true;
  d.cycle();
  d.in.sr_distance_end = at(1000.0);
  EXPECT_EQ(d.cycle().ended_by, nullptr);
  d.in.est_front = at(120.1);
  EXPECT_STREQ(d.cycle().ended_by, "5.8.4.1 h");
}

TEST(Override, The_former_EOA_is_passed_once) {
  Driver d;
  d.select();
  EXPECT_STREQ(d.cycle(60.0).ended_by, "5.8.4.1 a");
  d.in.min_safe_antenna = at(100.1);
  const auto passed = d.cycle();
  EXPECT_TRUE(passed.former_eoa_passed);
  EXPECT_FALSE(passed.active);  // [43]
  EXPECT_FALSE(d.cycle().former_eoa_passed);
  // While override is on the passage ends it, and is no trip afterwards.
  Driver on;
  on.select();
  on.in.min_safe_antenna = at(100.1);
  const auto r = on.cycle();
  EXPECT_TRUE(r.former_eoa_passed && r.active);
  const auto after = on.cycle();
  EXPECT_FALSE(after.former_eoa_passed || after.active);
}

TEST(Override, The_former_EOA_is_where_the_train_stands_in_SB_and_PT) {
  for (const Mode mode : {Mode::SB, Mode::PT}) {
    Driver d;
    d.in.mode = mode;
    d.select();
    EXPECT_EQ(d.state.former_eoa, at(95.0));
  }
}

TEST(Override, The_former_EOA_goes_with_a_stop_or_with_SR) {
  Driver d;
  d.select();
  d.in.stop_if_in_SR = true;
  d.cycle();
  EXPECT_FALSE(d.state.former_eoa.has_value());
  Driver e;
  e.select();
  override_::on_mode_change(e.state, Mode::SR, Mode::SB);
  EXPECT_FALSE(e.state.former_eoa.has_value());
  EXPECT_FALSE(e.state.active);
}

TEST(Override, Selected_again_it_starts_again) {
  Driver d;
  d.select();
  d.cycle(50.0);
  d.in.selected = true;
  EXPECT_TRUE(d.cycle().started);
  EXPECT_EQ(d.cycle(50.0).ended_by, nullptr);
  EXPECT_EQ(d.state.former_eoa, at(100.0));  // in SR a later selection changes nothing
}

TEST(Override, Mode_changes_end_it) {
  for (const Mode to : {Mode::TR, Mode::LS, Mode::OS, Mode::SH}) {
    Driver d;
    d.select();
    override_::on_mode_change(d.state, Mode::SR, to);
    EXPECT_FALSE(d.state.active) << modes::name(to);
  }
  Driver d;
  d.in.mode = Mode::SN;
  d.in.selected = true;
  d.cycle();
  override_::on_mode_change(d.state, Mode::SN, Mode::SR);
  EXPECT_TRUE(d.state.active);
}

// --- train trip -------------------------------------------------------------------------------------

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
  EXPECT_TRUE(t.cycle().send.has(Send::ma_request));
  int requests = 0;
  for (int i = 0; i < 120; ++i) requests += t.cycle().send.has(Send::ma_request) ? 1 : 0;
  EXPECT_EQ(requests, 2);
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
  EXPECT_TRUE(t.cycle().offers.has(Offer::override_));
  EXPECT_TRUE(t.cycle().send.empty());
  t.in.session_open = true;
  EXPECT_TRUE(t.cycle().send.has(Send::position_report));
  EXPECT_STREQ(train_trip::name(t.state.step), "S120");
}

// --- mode profile -----------------------------------------------------------------------------------

struct Profile {
  mode_profile::State state;
  mode_profile::Inputs in;
  std::vector<mode_profile::Area> areas;
  Profile(Mode mode, std::optional<Place> end = at(2000.0)) {
    areas.push_back({mode, at(1000.0), end, Speed{10.0}, Distance{200.0}});
    in.mode = Mode::FS;
    in.level = Level::L2;
    in.V_est = Speed{9.0};
  }
  /// The estimated front end at `front`, the confidence interval 10 m each way.
  mode_profile::Result cycle(double front, Set<Ack> acknowledged = {}) {
    in.now += Duration{1.0};
    in.est_front = at(front);
    in.min_safe_front = at(front - 10.0);
    in.max_safe_front = at(front + 10.0);
    in.acknowledged = acknowledged;
    in.areas = areas;
    return step(state, in);
  }
};

TEST(ModeProfile, Demands_are_by_the_max_safe_front_end) {
  for (const Mode mode : {Mode::OS, Mode::LS, Mode::SH}) {
    Profile p(mode);
    const auto demanded = [&](const mode_profile::Result& r) {
      return mode == Mode::OS ? r.demands_OS : mode == Mode::LS ? r.demands_LS : r.demands_SH;
    };
    auto r = p.cycle(989.0);
    EXPECT_FALSE(demanded(r) || r.in_force || r.at_front.has_value());
    r = p.cycle(990.0);
    EXPECT_TRUE(demanded(r) && r.in_force);
    EXPECT_EQ(r.at_front, mode);
    r = p.cycle(1995.0);
    EXPECT_EQ(demanded(r), mode == Mode::SH);  // the max safe front end has left the area, SH has no end
    EXPECT_TRUE(r.in_force);                   // the min safe front end has not (5.9.6.1.1)
    r = p.cycle(2010.0);
    EXPECT_EQ(r.in_force, mode == Mode::SH);
    EXPECT_EQ(int{r.demands_OS} + int{r.demands_LS} + int{r.demands_SH}, mode == Mode::SH ? 1 : 0);
  }
  Profile endless(Mode::OS, std::nullopt);
  EXPECT_TRUE(endless.cycle(1.0e6).in_force);
}

TEST(ModeProfile, The_window_ahead_of_the_area) {
  for (const auto& [mode, ack] : {std::pair{Mode::OS, Ack::OS}, {Mode::LS, Ack::LS}, {Mode::SH, Ack::SH}}) {
    Profile p(mode);
    EXPECT_TRUE(p.cycle(799.0).effects.requests.empty());
    p.in.V_est = Speed{10.0};
    EXPECT_TRUE(p.cycle(800.0).effects.requests.empty());  // not slower than the limit
    p.in.edition = modes::Edition::v4_0_0;
    Profile newer = p;
    EXPECT_FALSE(newer.cycle(800.0).effects.requests.empty());
    p.in.edition = modes::Edition::v3_6_0;
    p.in.V_est = Speed{9.9};
    auto r = p.cycle(810.0);
    EXPECT_EQ(r.effects.requests, Set<Ack>{ack});
    EXPECT_EQ(r.front_in_OS_ack_area, mode == Mode::OS);
    EXPECT_EQ(r.front_in_LS_ack_area, mode == Mode::LS);
    p.in.V_est = Speed{20.0};
    EXPECT_EQ(p.cycle(820.0).effects.requests, Set<Ack>{ack});  // not withdrawn
    p.areas.clear();
    EXPECT_TRUE(p.cycle(830.0).effects.requests.empty());
  }
}

TEST(ModeProfile, Only_from_FS_LS_and_OS_is_asked_ahead) {
  for (std::size_t m = 0; m < modes::kModes; ++m) {
    Profile p(Mode::OS);
    p.in.mode = static_cast<Mode>(m);
    EXPECT_EQ(!p.cycle(850.0).effects.requests.empty(), p.in.mode == Mode::FS || p.in.mode == Mode::LS)
        << modes::name(p.in.mode);
  }
}

TEST(ModeProfile, The_nearest_area_of_another_mode_is_asked_for) {
  Profile p(Mode::OS);
  p.areas.insert(p.areas.begin(), {Mode::LS, at(1500.0), at(1900.0), Speed{10.0}, Distance{2000.0}});
  EXPECT_EQ(p.cycle(850.0).effects.requests, Set<Ack>{Ack::OS});
  p.in.mode = Mode::OS;
  EXPECT_EQ(p.cycle(860.0).effects.requests, Set<Ack>{Ack::LS});  // the OS area no longer counts
}

TEST(ModeProfile, An_entry_without_acknowledgement_brakes_after_5_s) {
  struct Entry {
    Mode to;
    Ack ack;
    std::vector<int> numbers;
  };
  const Entry entries[] = {
      {Mode::OS, Ack::OS, {34, 40, 73}}, {Mode::LS, Ack::LS, {71, 72, 74}}, {Mode::SH, Ack::SH, {51, 61}}};
  for (const Entry& e : entries)
    for (const int n : e.numbers) {
      Profile p(e.to);
      mode_profile::on_mode_change(p.state, e.to, n, p.in.now);
      p.in.mode = e.to;
      for (int i = 0; i < 4; ++i) {
        const auto r = p.cycle(1100.0);
        EXPECT_EQ(r.effects.requests, Set<Ack>{e.ack});
        EXPECT_FALSE(r.effects.service_brake);
      }
      auto r = p.cycle(1100.0);
      EXPECT_TRUE(r.effects.service_brake) << n;
      EXPECT_EQ(r.overdue, e.to);
      r = p.cycle(1100.0, {e.ack});
      EXPECT_FALSE(r.effects.service_brake);
      EXPECT_TRUE(r.effects.requests.empty());
    }
}

TEST(ModeProfile, An_acknowledged_entry_needs_nothing_more) {
  Profile p(Mode::OS);
  p.cycle(850.0);
  mode_profile::on_mode_change(p.state, Mode::OS, 15, p.in.now);
  p.in.mode = Mode::OS;
  const auto r = p.cycle(860.0);
  EXPECT_TRUE(r.effects.requests.empty());
  EXPECT_TRUE(r.front_in_OS_ack_area);
}

// --- level transition -------------------------------------------------------------------------------

modes::OrderedLevel level(Level l, std::uint8_t ntc = 0) { return {l, ntc, Distance{300.0}}; }

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
    in.order = send ? &order : nullptr;
    const level_transition::Result out = step(state, in);
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
  // The same order again asks for nothing new.
  b.give(OrderKind::announcement, level(Level::NTC, 1), 1010.0);
  const auto again = b.cycle(710.0);
  EXPECT_TRUE(again.effects.requests.empty());
  EXPECT_FALSE(again.cancelled);
  const auto r = b.cycle(1010.0);
  EXPECT_TRUE(r.switch_to.has_value());
  EXPECT_TRUE(r.effects.requests.empty());
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(b.cycle(1020.0).effects.service_brake);
}

TEST(LevelTransition, Not_acknowledged_brakes_after_5_s) {
  Border b(level(Level::L2), Mode::FS);
  b.give(OrderKind::immediate, level(Level::L0));
  auto r = b.cycle(0.0);
  EXPECT_EQ(r.switch_to->level, Level::L0);
  EXPECT_EQ(r.effects.requests, Set<Ack>{Ack::level});
  level_transition::on_mode_change(b.state, Mode::FS, Mode::UN);
  b.in.mode = Mode::UN;
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(b.cycle(10.0).effects.service_brake);
  r = b.cycle(10.0);
  EXPECT_TRUE(r.effects.service_brake);
  EXPECT_EQ(r.overdue, Level::L0);
  b.in.acknowledged = true;
  r = b.cycle(10.0);
  EXPECT_FALSE(r.effects.service_brake);
  EXPECT_TRUE(r.effects.requests.empty());
}

TEST(LevelTransition, In_SB_4_0_0_asks_only_at_the_change) {
  for (const modes::Edition edition : {modes::Edition::v3_6_0, modes::Edition::v4_0_0}) {
    Border b(level(Level::L2), Mode::SB);
    b.in.edition = edition;
    b.give(OrderKind::announcement, level(Level::L0), 1000.0);
    EXPECT_EQ(b.cycle(900.0).effects.requests.empty(), edition == modes::Edition::v4_0_0);
    EXPECT_EQ(b.cycle(1000.0).effects.requests, Set<Ack>{Ack::level});
  }
}

TEST(LevelTransition, The_newest_order_counts) {
  Border b(level(Level::L2), Mode::FS);
  b.give(OrderKind::announcement, level(Level::NTC, 1), 1000.0);
  b.cycle(500.0);
  b.give(OrderKind::announcement, level(Level::L1), 2000.0);
  EXPECT_TRUE(b.cycle(600.0).cancelled);
  EXPECT_FALSE(b.cycle(1500.0).switch_to.has_value());
  // An order for the level that the unit is in drops what waits.
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
  EXPECT_TRUE(r.effects.requests.empty());  // a level that the driver chose needs no acknowledgement
  EXPECT_FALSE(b.cycle(1000.0).switch_to.has_value());
  // 4.0.0 drops the order.
  Border n(level(Level::L1), Mode::FS);
  n.in.edition = modes::Edition::v4_0_0;
  n.give(OrderKind::announcement, level(Level::L2), 1000.0);
  n.cycle(500.0);
  n.in.driver_level = level(Level::L0);
  EXPECT_TRUE(n.cycle(600.0).cancelled);
  n.in.driver_level = level(Level::L0);
  EXPECT_FALSE(n.cycle(600.0).switch_to.has_value());
}

TEST(LevelTransition, Kept_in_shunting) {
  Border b(level(Level::L1), Mode::SH);
  b.give(OrderKind::announcement, level(Level::L2), 100.0);
  EXPECT_FALSE(b.cycle(0.0).announced);
  b.give(OrderKind::immediate, level(Level::L2));
  EXPECT_FALSE(b.cycle(0.0).switch_to.has_value());
  EXPECT_FALSE(b.cycle(0.0).switch_to.has_value());
  level_transition::on_mode_change(b.state, Mode::SH, Mode::SB);
  b.in.mode = Mode::SB;
  EXPECT_EQ(b.cycle(0.0).switch_to->level, Level::L2);
  // Left to a mode that deletes the order (4.10).
  Border d(level(Level::L1), Mode::SH);
  d.give(OrderKind::immediate, level(Level::L2));
  d.cycle(0.0);
  level_transition::on_mode_change(d.state, Mode::SH, Mode::NP);
  d.in.mode = Mode::SB;
  EXPECT_FALSE(d.cycle(0.0).switch_to.has_value());
}

TEST(LevelTransition, Mode_entries_delete_what_4_10_says) {
  Border b(level(Level::L2), Mode::FS);
  b.give(OrderKind::announcement, level(Level::L1), 1000.0);
  b.cycle(500.0);
  level_transition::on_mode_change(b.state, Mode::FS, Mode::OS);
  EXPECT_TRUE(b.state.pending.has_value());
  level_transition::on_mode_change(b.state, Mode::OS, Mode::SR);
  EXPECT_FALSE(b.state.pending.has_value());
  // And in TR nothing is asked of the driver for a level.
  Border t(level(Level::L2), Mode::FS);
  t.give(OrderKind::immediate, level(Level::L0));
  t.cycle(0.0);
  level_transition::on_mode_change(t.state, Mode::FS, Mode::TR);
  t.in.mode = Mode::TR;
  EXPECT_TRUE(t.cycle(0.0).effects.requests.empty());
}

// --- reversing --------------------------------------------------------------------------------------

TEST(Reversing, Possible_at_standstill_in_the_area) {
  reversing::Inputs in;
  EXPECT_FALSE(step(in).possible);
  in.stored = reversing::Reversing{at(100.0), at(300.0), at(300.0), Distance{500.0}, Speed{5.0}};
  in.standstill = true;
  in.est_front = at(200.0);
  EXPECT_TRUE(step(in).possible);
  EXPECT_TRUE(step(in).effects.requests.empty());
  in.controller_backward = true;
  EXPECT_EQ(step(in).effects.requests, Set<Ack>{Ack::RV});
  in.est_front = at(301.0);
  EXPECT_FALSE(step(in).possible);
  in.est_front = at(99.0);
  EXPECT_FALSE(step(in).possible);
  in.est_front = at(200.0);
  in.standstill = false;
  EXPECT_FALSE(step(in).possible);
  in.standstill = true;
  in.mode = Mode::SR;
  EXPECT_FALSE(step(in).possible);
}

TEST(Reversing, The_distance_counts_backwards_from_its_reference) {
  reversing::Inputs in;
  in.mode = Mode::RV;
  in.stored = reversing::Reversing{at(100.0), at(200.0), at(300.0), Distance{500.0}, Speed{5.0}};
  in.est_front = at(-200.0);
  EXPECT_FALSE(step(in).distance_passed);
  in.est_front = at(-200.1);
  EXPECT_TRUE(step(in).distance_passed);
  in.stored->D_REVERSE.reset();
  EXPECT_FALSE(step(in).distance_passed);
}

}  // namespace
}  // namespace evc::procedures
