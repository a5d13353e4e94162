#include "kernel/decide/mission.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"

// The procedures of chapter 5 with what the unit knows: each of their inputs by what it changes.
namespace evc::kernel {
namespace {

using procedures::Send;

using evc::test::at;

/// A unit at standstill at 1000 m.
class Mission : public ::testing::Test {
 protected:
  Mission() { restart(Mode::FS, Level::L1); }
  void restart(Mode mode, Level level) {
    state = State{};
    received = {};
    decided = {};
    facts = {};
    outputs->events.clear();
    state.mode = mode;
    state.level.level = level;
    state.now = {100.0};
    state.data.level_status = state.data.train_data_status = DataStatus::valid;
    track::Here& here = decided.here;
    here.est_front = here.min_safe_front = here.max_safe_front = at(1000.0);
    here.min_safe_antenna = at(995.0);
    here.standstill = true;
  }
  Log log() { return Log{outputs->events}; }
  bool happened(What what, Clause clause = {}) const {
    for (const Event& e : outputs->events)
      if (e.what == what && (!clause || e.clause == clause)) return true;
    return false;
  }
  void in_session() { state.radio.supervising.session.phase = radio::Phase::up; }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  Received received;
  Decided decided;
  procedures::Facts facts;
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
};

// --- 5.8 override

class Override : public Mission {
 protected:
  void run() { run_override(state, received, decided.here, facts, log()); }
  /// Active since 50 s, begun where the counter was 0.
  void activate(Mode mode, Level level = Level::L1) {
    restart(mode, level);
    state.override_.active = true;
    state.override_.since = {50.0};
    state.national_values.T_NVOVTRP = {70.0};
    state.national_values.D_NVOVTRP = Distance{300.0};
  }
  bool ends(Clause by) {
    run();
    EXPECT_EQ(state.override_.active, !happened(What::override_ended));
    return happened(What::override_ended, by);
  }
};

TEST_F(Override, EndsByTimeAndDistance) {  // 5.8.4.1 a, b
  activate(Mode::SR);
  EXPECT_FALSE(ends("5.8.4.1 a"_srs));
  state.now = {120.0};
  EXPECT_TRUE(ends("5.8.4.1 a"_srs));
  activate(Mode::SR);
  state.position.now.counter.nominal = {{300.0}};
  EXPECT_FALSE(ends("5.8.4.1 b"_srs));
  state.position.now.counter.nominal = {{300.1}};
  EXPECT_TRUE(ends("5.8.4.1 b"_srs));
}

TEST_F(Override, EndsBehindTheFormerEOA) {  // 5.8.4.1 c, 4.6.3 [43]
  activate(Mode::SR);
  state.override_.former_eoa = at(995.0);
  run();
  EXPECT_FALSE(facts.former_eoa_passed);
  EXPECT_TRUE(facts.override_active);
  decided.here.min_safe_antenna = at(995.1);
  EXPECT_TRUE(ends("5.8.4.1 c"_srs));
  EXPECT_TRUE(facts.former_eoa_passed);
  EXPECT_TRUE(facts.override_active) << "before the end conditions of this cycle";
  run();
  EXPECT_FALSE(facts.override_active);
}

TEST_F(Override, EndsByWhatIsReceived) {  // 5.8.4.1 d to g
  const auto ended_by = [&](bool Received::*fact, Clause by, Level level = Level::L1) {
    activate(Mode::SR, level);
    received.*fact = true;
    return ends(by);
  };
  EXPECT_TRUE(ended_by(&Received::stop_if_in_SR, "5.8.4.1 d"_srs));
  EXPECT_TRUE(ended_by(&Received::stop_if_in_SH, "5.8.4.1 d"_srs));
  EXPECT_TRUE(ended_by(&Received::balise_proceed, "5.8.4.1 e"_srs));
  EXPECT_TRUE(ended_by(&Received::ma_from_rbc, "5.8.4.1 f"_srs, Level::L2));
  EXPECT_FALSE(ended_by(&Received::ma_from_rbc, "5.8.4.1 f"_srs, Level::L1));
  EXPECT_TRUE(ended_by(&Received::group_passed_not_in_SR_list, "5.8.4.1 g"_srs));
  EXPECT_TRUE(ended_by(&Received::group_passed_not_in_SH_list, "5.8.4.1 g"_srs));
  activate(Mode::UN);
  received.balise_proceed = true;
  EXPECT_FALSE(ends("5.8.4.1 e"_srs)) << "in UN only time and distance count";
}

TEST_F(Override, EndsBehindTheDistanceOfSR) {  // 5.8.4.1 h
  activate(Mode::SR);
  state.override_.sr_distance_end = at(1000.0);
  EXPECT_FALSE(ends("5.8.4.1 h"_srs));
  decided.here.est_front = at(1000.1);
  EXPECT_TRUE(ends("5.8.4.1 h"_srs));
}

TEST_F(Override, BeginsWithTheSelectionOfTheDriver) {  // 5.8.2, 5.8.3.1
  run();
  EXPECT_FALSE(state.override_.active);
  EXPECT_FALSE(facts.selects_override);
  EXPECT_FALSE(happened(What::override_active));
  state.basis.authority.EOA = at(2000.0);
  state.staff_responsible.V = Speed{5.0};
  state.staff_responsible.by_rbc = true;
  state.position.now.counter.nominal = {{444.0}};
  const std::uint32_t revision = state.revision;
  received.selected.add(Select::override_);
  run();
  EXPECT_TRUE(state.override_.active);
  EXPECT_TRUE(facts.selects_override);
  EXPECT_TRUE(happened(What::override_active));
  EXPECT_EQ(state.override_.since, Duration{100.0});
  EXPECT_EQ(state.override_.start.from_origin, Distance{444.0});
  EXPECT_EQ(state.override_.former_eoa, at(2000.0));
  EXPECT_EQ(state.override_.sr_distance_end, std::nullopt) << "in SR only";
  EXPECT_EQ(state.staff_responsible.V, std::nullopt) << "the national values count again";
  EXPECT_FALSE(state.staff_responsible.by_rbc);
  EXPECT_EQ(state.staff_responsible.national_from, at(1000.0));
  EXPECT_NE(state.revision, revision);
}

TEST_F(Override, BeginsInSRWithTheDistanceThatIsSupervised) {  // 5.8.3.1, 5.8.4.1 h
  restart(Mode::SR, Level::L1);
  state.staff_responsible.end = at(1800.0);
  received.selected.add(Select::override_);
  run();
  EXPECT_EQ(state.override_.sr_distance_end, at(1800.0));
}

TEST_F(Override, BuildsTheCurvesAgainOnlyWhenItChanges) {  // 3.11.2.2
  activate(Mode::SR);
  const std::uint32_t revision = state.revision;
  run();
  EXPECT_EQ(state.revision, revision);
  received.balise_proceed = true;
  run();
  EXPECT_EQ(state.revision, revision + 1);
}

TEST_F(Override, BeginsAgainWhileItIsActive) {  // 5.8.3.1: the limits of SR begin anew
  activate(Mode::SR);
  const std::uint32_t revision = state.revision;
  received.selected.add(Select::override_);
  run();
  EXPECT_EQ(state.override_.since, Duration{100.0});
  EXPECT_NE(state.revision, revision);
}

// --- 5.6 shunting

class Shunting : public Mission {
 protected:
  void run() {
    effects = {};
    run_shunting(state, received, decided.here, facts, effects);
  }
  void select() {
    received.selected.add(Select::shunting);
    run();
    received.selected = {};
  }
  procedures::Effects effects;
};

TEST_F(Shunting, BeginsAtOnceOutsideLevel2) {  // 5.6.2 E015, 4.6.3 [5]
  select();
  EXPECT_TRUE(facts.selects_SH);
  decided.here.standstill = false;
  select();
  EXPECT_FALSE(facts.selects_SH);
  restart(Mode::SB, Level::L2);
  in_session();
  select();
  EXPECT_FALSE(facts.selects_SH);
}

TEST_F(Shunting, AsksTheRBC) {  // 5.6.2 A045, A050; A.3.1
  restart(Mode::SB, Level::L2);
  select();
  EXPECT_FALSE(effects.send.has(Send::shunting_request)) << "without a session";
  in_session();
  decided.here.standstill = false;
  select();
  EXPECT_FALSE(effects.send.has(Send::shunting_request));
  decided.here.standstill = true;
  select();
  EXPECT_TRUE(effects.send.has(Send::shunting_request));
  run();
  EXPECT_FALSE(effects.send.has(Send::shunting_request));
  state.now += Duration{15.0};
  run();
  EXPECT_TRUE(effects.send.has(Send::shunting_request)) << "again after 15 s";
  received.SH_authorised = true;
  run();
  EXPECT_TRUE(facts.SH_granted);
}

TEST_F(Shunting, IsRefused) {  // 5.6.2 E215
  restart(Mode::SB, Level::L2);
  in_session();
  select();
  received.SH_refused = true;
  run();
  EXPECT_FALSE(facts.SH_granted);
  EXPECT_TRUE(effects.inform.has(Inform::SH_refused));
}

TEST_F(Shunting, ContinuesByTheDriversChoice) {  // 5.12.4
  restart(Mode::SH, Level::L1);
  run();
  EXPECT_FALSE(facts.continue_shunting);
  received.selected.add(Select::maintain_shunting);
  run();
  EXPECT_TRUE(facts.continue_shunting);
}

// --- 5.13 reversing

TEST_F(Mission, ReversingIsPossibleInItsArea) {  // 5.13.1, 3.15.4
  const auto possible = [&] {
    run_reversing(state, DirectionController::forward, decided);
    return decided.reversing_possible;
  };
  const auto with_area = [&] {
    restart(Mode::FS, Level::L1);
    track::ReversingArea area;
    area.from = at(900.0);
    area.to = at(1100.0);
    state.track.reversing_area = area;
    state.track.reversing_supervision.emplace();
    state.track.reversing_reference = at(900.0);
  };
  with_area();
  EXPECT_TRUE(possible());
  with_area();
  decided.here.standstill = false;
  EXPECT_FALSE(possible());
  with_area();
  state.mode = Mode::SR;
  EXPECT_FALSE(possible());
  with_area();
  decided.here.est_front = at(1100.1);
  EXPECT_FALSE(possible());
  with_area();
  decided.here.est_front = at(899.9);
  EXPECT_FALSE(possible());
  with_area();
  state.track.reversing_area.reset();
  EXPECT_FALSE(possible());
  with_area();
  state.track.reversing_supervision.reset();
  EXPECT_FALSE(possible());
  with_area();
  state.track.reversing_reference.reset();
  EXPECT_FALSE(possible());
}

TEST_F(Mission, ReversingIsAskedForByTheDirectionController) {  // 5.13.1.3
  track::ReversingArea area;
  area.from = at(900.0);
  area.to = at(1100.0);
  state.track.reversing_area = area;
  state.track.reversing_supervision.emplace();
  state.track.reversing_reference = at(900.0);
  for (const DirectionController c :
       {DirectionController::forward, DirectionController::neutral, DirectionController::backward}) {
    decided.effects = {};
    run_reversing(state, c, decided);
    EXPECT_EQ(decided.effects.requests.has(Ack::RV), c == DirectionController::backward);
  }
}

// --- 4.4.11 start in SR

TEST_F(Mission, StartInSRAsksForAnAuthorityUntilItIsAnswered) {  // 4.4.11.1.6
  const auto starts = [&](Mode mode, Level level, bool session, bool Received::*answer = nullptr) {
    restart(mode, level);
    if (session) in_session();
    received.selected.add(Select::start);
    run_start_in_SR(state, received, decided);
    const bool first = decided.start_selected;
    received.selected = {};
    if (answer != nullptr) received.*answer = true;
    decided.start_selected = false;
    run_start_in_SR(state, received, decided);
    return std::pair(first, decided.start_selected);
  };
  constexpr std::pair yes(true, true), no(false, false), answered(true, false);
  EXPECT_EQ(starts(Mode::SR, Level::L2, true), yes);
  EXPECT_EQ(starts(Mode::SR, Level::L3, true), yes);
  EXPECT_EQ(starts(Mode::SR, Level::L1, true), no);
  EXPECT_EQ(starts(Mode::SR, Level::L2, false), no);
  EXPECT_EQ(starts(Mode::FS, Level::L2, true), no);
  EXPECT_EQ(starts(Mode::SR, Level::L2, true, &Received::ma_from_rbc), answered);
  EXPECT_EQ(starts(Mode::SR, Level::L2, true, &Received::SR_authorised), answered);
}

// --- 5.5 end of mission

TEST_F(Mission, TheEndOfTheMissionIsReportedUntilTheRBCEndsTheSession) {  // 5.5.3
  const auto after = [&](Mode mode, bool session, Level level = Level::L2) {
    restart(mode, level);
    state.previous_mode = Mode::FS;
    state.end_of_mission.mission = true;
    if (session) in_session();
    Decided ended;
    run_end_of_mission(state, false, received, ended);
    return ended.effects.send.has(Send::end_of_mission);
  };
  EXPECT_TRUE(after(Mode::SB, true));
  EXPECT_FALSE(after(Mode::SB, false));
  EXPECT_FALSE(after(Mode::FS, true));
  ASSERT_TRUE(after(Mode::SB, true));
  state.previous_mode = Mode::SB;
  Decided ended;
  run_end_of_mission(state, false, received, ended);
  EXPECT_TRUE(ended.effects.send.empty());
  state.now += Duration{15.0};
  run_end_of_mission(state, false, received, ended);
  EXPECT_TRUE(ended.effects.send.has(Send::end_of_mission)) << "again after 15 s";
  received.termination_ordered = true;
  ended = {};
  run_end_of_mission(state, false, received, ended);
  EXPECT_TRUE(ended.effects.send.has(Send::terminate_session));
}

TEST_F(Mission, ShuntingWithoutAMissionIsReportedInLevel2And3) {  // 5.6 A095
  for (const Level level : {Level::L1, Level::L2, Level::L3}) {
    restart(Mode::SH, level);
    state.previous_mode = Mode::SB;
    in_session();
    Decided ended;
    run_end_of_mission(state, false, received, ended);
    EXPECT_EQ(ended.effects.send.has(Send::position_report), level != Level::L1) << static_cast<int>(level);
  }
}

// --- 5.11 train trip

class TrainTrip : public Mission {
 protected:
  void run(std::optional<Mode> profile_at_front = {}) {
    decided.effects = {};
    decided.start_selected = false;
    run_train_trip(state, desk_open, received, profile_at_front, decided);
  }
  using Step = procedures::train_trip::Step;
  Step step() const { return state.train_trip.step; }
  void in_PT(Step s) {
    restart(Mode::PT, Level::L2);
    in_session();
    state.train_trip.step = s;
  }
  bool desk_open = true;
};

TEST_F(TrainTrip, IsAcknowledgedAtStandstillWithTheDeskOpen) {  // 5.11.2, 4.4.13.1.6
  restart(Mode::TR, Level::L1);
  run();
  EXPECT_TRUE(decided.effects.requests.has(Ack::trip));
  EXPECT_FALSE(decided.effects.send.has(Send::position_report));
  desk_open = false;
  run();
  EXPECT_FALSE(decided.effects.requests.has(Ack::trip));
  desk_open = true;
  decided.here.standstill = false;
  run();
  EXPECT_FALSE(decided.effects.requests.has(Ack::trip));
  restart(Mode::TR, Level::L2);
  run();
  EXPECT_TRUE(decided.effects.send.has(Send::position_report)) << "A030";
}

TEST_F(TrainTrip, IsReportedUntilTheRBCRecognisesItsExit) {  // 5.11.2 A115, S120
  in_PT(Step::S060);
  run();
  EXPECT_TRUE(decided.effects.send.has(Send::position_report));
  run();
  EXPECT_FALSE(decided.effects.send.has(Send::position_report));
  state.now += Duration{15.0};
  run();
  EXPECT_TRUE(decided.effects.send.has(Send::position_report));
  received.exit_from_trip = true;
  (void)state.emergency_stops.pending.push_back({1, false, {}});
  run();
  EXPECT_EQ(step(), Step::S130);
  received.exit_from_trip = false;
  state.emergency_stops.pending.clear();
  run();
  EXPECT_EQ(step(), Step::S140);
  EXPECT_TRUE(decided.effects.offers.has(Offer::start));
}

TEST_F(TrainTrip, StartAsksTheRBC) {  // 5.11.2 S140, S150
  in_PT(Step::S140);
  state.data.train_data_status = DataStatus::invalid;
  received.selected.add(Select::start);
  run();
  EXPECT_EQ(step(), Step::S140) << "without valid train data";
  EXPECT_FALSE(decided.start_selected);
  state.data.train_data_status = DataStatus::valid;
  run();
  EXPECT_EQ(step(), Step::S150);
  EXPECT_TRUE(decided.start_selected);
  received.selected = {};
  run();
  EXPECT_TRUE(decided.start_selected);
  received.SR_authorised = true;
  run();
  EXPECT_TRUE(decided.effects.requests.has(Ack::SR));
  EXPECT_FALSE(decided.start_selected);
  in_PT(Step::S150);
  received.SR_authorised = false;
  run(Mode::OS);
  EXPECT_TRUE(decided.effects.requests.has(Ack::OS));
}

TEST_F(TrainTrip, WithoutASessionTheRBCIsNotAsked) {  // 5.11.2 D140
  in_PT(Step::S140);
  state.radio.supervising.session = {};
  received.selected.add(Select::start);
  run();
  EXPECT_EQ(step(), Step::S140);
  restart(Mode::PT, Level::L1);
  state.train_trip.step = Step::S140;
  received.selected.add(Select::start);
  run();
  EXPECT_TRUE(decided.effects.requests.has(Ack::SR)) << "in level 1 SR is acknowledged";
}

// --- 5.9, 5.7, 5.19 mode profile

class Profile : public Mission {
 protected:
  void run() {
    facts = {};
    decided.effects = {};
    decided.asked = {};
    at_front = run_mode_profile(state, received, facts, decided);
  }
  /// The only area: 1100 m to 2000 m, to be acknowledged from 950 m on.
  track::ModeArea& area(Mode mode) {
    state.track.mode_profile.clear();
    track::ModeArea a;
    a.mode = mode;
    a.ack_from = at(950.0);
    a.from = at(1100.0);
    a.to = at(2000.0);
    a.V_MAMODE = track::kNoSpeed;
    EXPECT_TRUE(state.track.mode_profile.push_back(a));
    return state.track.mode_profile.back();
  }
  void fronts(double min, double est, double max) {
    decided.here.min_safe_front = at(min);
    decided.here.est_front = at(est);
    decided.here.max_safe_front = at(max);
  }
  std::optional<Mode> at_front;
};

TEST_F(Profile, AnAreaDemandsItsMode) {  // 5.7.3, 5.9.3, 5.19.3
  for (const Mode mode : {Mode::OS, Mode::LS, Mode::SH}) {
    restart(Mode::FS, Level::L1);
    area(mode);
    run();
    EXPECT_FALSE(facts.profile_in_force);
    EXPECT_EQ(at_front, std::nullopt);
    EXPECT_EQ(facts.front_in_OS_ack_area, mode == Mode::OS);
    EXPECT_EQ(facts.front_in_LS_ack_area, mode == Mode::LS);
    fronts(1090.0, 1095.0, 1100.0);
    run();
    EXPECT_EQ(facts.profile_demands_OS, mode == Mode::OS);
    EXPECT_EQ(facts.profile_demands_LS, mode == Mode::LS);
    EXPECT_EQ(facts.profile_demands_SH, mode == Mode::SH);
    EXPECT_TRUE(facts.profile_in_force);
    EXPECT_EQ(at_front, mode);
    // Behind its end; an area for shunting has none (3.12.4.2).
    fronts(2001.0, 2002.0, 2003.0);
    run();
    EXPECT_EQ(facts.profile_in_force, mode == Mode::SH);
  }
}

TEST_F(Profile, ATrainPartlyBehindTheAreaIsJudgedByTheEdition) {  // 5.9.3 of 4.0.0
  for (const SrsVersion srs : {SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    restart(Mode::FS, Level::L1);
    state.srs = srs;
    area(Mode::OS);
    fronts(1990.0, 2000.0, 2010.0);
    run();
    EXPECT_EQ(facts.profile_demands_OS, srs == SrsVersion::v4_0_0);
    EXPECT_TRUE(facts.profile_in_force);
  }
}

TEST_F(Profile, ItsModeIsAcknowledgedBelowItsSpeed) {  // 5.7.3.3, 5.9.3, 5.19.3
  const auto asked_at = [&](Mode mode, double kmh, track::SpeedCode V) {
    restart(Mode::FS, Level::L1);
    state.national_values.V_NVONSIGHT = Speed{30.0 / 3.6};
    state.national_values.V_NVLIMSUPERV = Speed{100.0 / 3.6};
    state.national_values.V_NVSHUNT = Speed{25.0 / 3.6};
    state.position.now.V_est = {kmh / 3.6};
    area(mode).V_MAMODE = V;
    run();
    return !decided.effects.requests.empty();
  };
  EXPECT_TRUE(asked_at(Mode::OS, 29.0, track::kNoSpeed));
  EXPECT_FALSE(asked_at(Mode::OS, 31.0, track::kNoSpeed));
  EXPECT_TRUE(asked_at(Mode::LS, 99.0, track::kNoSpeed));
  EXPECT_FALSE(asked_at(Mode::LS, 101.0, track::kNoSpeed));
  EXPECT_TRUE(asked_at(Mode::SH, 24.0, track::kNoSpeed));
  EXPECT_FALSE(asked_at(Mode::SH, 26.0, track::kNoSpeed));
  EXPECT_TRUE(asked_at(Mode::OS, 59.0, 12)) << "its own speed, 60 km/h";
  EXPECT_FALSE(asked_at(Mode::OS, 61.0, 12));
  EXPECT_FALSE(asked_at(Mode::LS, 61.0, 12));
}

TEST_F(Profile, ItsModeIsAcknowledgedFromTheGivenPlaceOn) {  // 5.9.3: L_ACKMAMODE
  area(Mode::OS);
  fronts(949.0, 949.9, 951.0);
  run();
  EXPECT_FALSE(decided.effects.requests.has(Ack::OS));
  fronts(949.0, 950.0, 951.0);
  run();
  EXPECT_TRUE(decided.effects.requests.has(Ack::OS));
}

TEST_F(Profile, AModeThatIsNotAcknowledgedBrakes) {  // 5.7.3.5, 5.9.3.5, 5.19.3.5
  for (const Mode mode : {Mode::OS, Mode::LS, Mode::SH}) {
    restart(mode, Level::L1);
    procedures::mode_profile::on_mode_change(state.mode_profile, mode,
                                             mode == Mode::OS   ? 34
                                             : mode == Mode::LS ? 72
                                                                : 51,
                                             state.now);
    run();
    EXPECT_TRUE(decided.asked.empty());
    state.now += Duration{5.0};
    run();
    EXPECT_EQ(decided.asked.has(brakes::Cause::OS_unacknowledged), mode == Mode::OS);
    EXPECT_EQ(decided.asked.has(brakes::Cause::LS_unacknowledged), mode == Mode::LS);
    EXPECT_EQ(decided.asked.has(brakes::Cause::SH_unacknowledged), mode == Mode::SH);
    received.acknowledged.add(mode == Mode::OS ? Ack::OS : mode == Mode::LS ? Ack::LS : Ack::SH);
    run();
    EXPECT_TRUE(decided.asked.empty());
  }
}

// --- 5.17 change of train data

class DataChange : public Mission {
 protected:
  DataChange() { change(false); }
  void change(bool driver_validates) {
    train::TrainData data;
    data.loading_gauge = train::LoadingGauge::GB;
    state.train_data_change.pending = data;
    state.train_data_change.driver_validates = driver_validates;
  }
  void run() {
    decided.effects = {};
    decided.asked = {};
    run_train_data_change(state, received, decided, log());
  }
  bool brakes() const { return decided.asked.has(brakes::Cause::train_data_changed); }
  bool pending() const { return state.train_data_change.pending.has_value(); }
};

TEST_F(DataChange, CountsAtOnceAtStandstill) {  // 5.17.2 A7
  run();
  EXPECT_FALSE(brakes());
  EXPECT_FALSE(pending());
  EXPECT_EQ(state.train.loading_gauge, train::LoadingGauge::GB);
  EXPECT_TRUE(happened(What::train_data_valid));
  EXPECT_TRUE(decided.effects.inform.has(Inform::train_data_changed));
  outputs->events.clear();
  run();
  EXPECT_FALSE(happened(What::train_data_valid)) << "once";
}

TEST_F(DataChange, ThatConcernsTheAuthorityBrakesFirst) {  // 5.17.2 D1, D3, S2, S3
  decided.here.standstill = false;
  run();
  EXPECT_TRUE(brakes());
  EXPECT_TRUE(pending());
  EXPECT_NE(state.train.loading_gauge, train::LoadingGauge::GB);
  decided.here.standstill = true;
  state.brakes.active.add(brakes::Cause::train_data_changed);
  run();
  run();
  EXPECT_TRUE(pending()) << "until the driver acknowledges the brake";
  state.brakes.active = {};
  run();
  EXPECT_FALSE(pending());
  EXPECT_EQ(state.train.loading_gauge, train::LoadingGauge::GB);
}

TEST_F(DataChange, ThatDoesNotConcernTheRouteCountsAtOnce) {  // 5.17.2 D1
  train::TrainData data;
  data.L_TRAIN = {321.0};
  state.train_data_change.pending = data;
  decided.here.standstill = false;
  run();
  EXPECT_FALSE(brakes());
  EXPECT_EQ(state.train.L_TRAIN, Distance{321.0});
}

TEST_F(DataChange, InSRConcernsWhatWaitsOfAnRBC) {  // 5.17.2 D5
  for (const auto& [medium, waiting] : {std::pair{Medium::balise, 1u}, {Medium::rbc, 1u}, {Medium::rbc, 2u}}) {
    restart(Mode::SR, Level::L1);
    change(false);
    decided.here.standstill = false;
    ASSERT_NE(state.buffer.grow(), nullptr);
    state.buffer[0].medium = medium;
    state.buffer[0].of_authority = 1;
    state.buffer[0].waiting = waiting;
    ASSERT_NE(state.buffer.grow(), nullptr);
    run();
    EXPECT_EQ(brakes(), medium == Medium::rbc && waiting == 1);
  }
}

TEST_F(DataChange, ThatTheDriverValidates) {  // 5.17.2.2 D0, D9, S6
  change(true);
  run();
  EXPECT_TRUE(decided.effects.entries.has(Entry::train_data));
  EXPECT_TRUE(pending());
  received.entered.add(Entered::train_data);
  run();
  EXPECT_FALSE(pending());
  EXPECT_NE(state.train.loading_gauge, train::LoadingGauge::GB) << "what the driver entered counts";
  EXPECT_FALSE(happened(What::train_data_to_be_validated));
}

TEST_F(DataChange, WithoutValidDataIsToBeValidated) {  // 5.17.2.2
  state.data.train_data_status = DataStatus::unknown;
  const std::uint32_t revision = state.revision;
  run();
  EXPECT_FALSE(pending());
  EXPECT_EQ(state.train.loading_gauge, train::LoadingGauge::GB);
  EXPECT_EQ(state.data.train_data_status, DataStatus::invalid);
  EXPECT_NE(state.revision, revision);
  EXPECT_TRUE(happened(What::train_data_to_be_validated));
}

TEST_F(DataChange, OutOfItsRangesIsNotStored) {  // 3.18.3
  state.data.train_data_status = DataStatus::unknown;
  state.train_data_change.pending->L_TRAIN = {-1.0};
  run();
  EXPECT_FALSE(pending());
  EXPECT_GT(state.train.L_TRAIN, Distance{});
}

TEST_F(DataChange, InATripWaitsForItsEnd) {  // 5.17.2 S1
  restart(Mode::TR, Level::L1);
  change(true);
  run();
  EXPECT_TRUE(pending());
  EXPECT_FALSE(decided.effects.entries.has(Entry::train_data));
}

// --- 5.4 start of mission

class Start : public Mission {
 protected:
  Start() { restart_in(Step::S10, Level::L1); }
  using Step = procedures::start_of_mission::Step;
  void restart_in(Step step, Level level) {
    restart(Mode::SB, level);
    state.start_of_mission.step = step;
    state.data.driver_id_status = state.data.train_running_number_status = DataStatus::valid;
    desk_open = true;
  }
  void run(std::optional<Mode> profile_at_front = {}) {
    decided.effects = {};
    decided.start_selected = false;
    run_start_of_mission(state, desk_open, received, profile_at_front, decided);
  }
  Step step() const { return state.start_of_mission.step; }
  bool desk_open = true;
};

TEST_F(Start, AsksForTheDriverId) {  // 5.4.4 S1
  restart_in(Step::S0, Level::L1);
  state.data.driver_id_status = DataStatus::invalid;
  run();
  EXPECT_EQ(step(), Step::S1);
  EXPECT_TRUE(decided.effects.entries.has(Entry::driver_id));
  state.position.status = DataStatus::valid;
  state.data.driver_id_status = DataStatus::valid;
  run();
  EXPECT_EQ(step(), Step::S10) << "position and level are valid";
}

TEST_F(Start, AsksForALevelThatIsNotValid) {  // 5.4.4 D2, S2
  restart_in(Step::S1, Level::L1);
  state.position.status = DataStatus::valid;
  state.data.level_status = DataStatus::invalid;
  run();
  EXPECT_EQ(step(), Step::S2);
  restart_in(Step::S1, Level::L1);
  state.position.status = DataStatus::invalid;
  state.contact_status = DataStatus::valid;
  run();
  EXPECT_EQ(step(), Step::S2);
  EXPECT_EQ(state.data.level_status, DataStatus::invalid);
  EXPECT_EQ(state.contact_status, DataStatus::invalid);
  received.entered.add(Entered::level);
  run();
  EXPECT_EQ(step(), Step::S10);
  EXPECT_EQ(state.data.level_status, DataStatus::valid);
}

TEST_F(Start, OpensTheSessionAgain) {  // 5.4.4 D7, A31, A29
  restart_in(Step::S1, Level::L2);
  state.position.status = DataStatus::valid;
  run();
  EXPECT_EQ(step(), Step::D31);
  EXPECT_TRUE(decided.effects.send.has(Send::open_session));
  restart_in(Step::S1, Level::L2);
  state.position.status = DataStatus::valid;
  state.fitted_levels[static_cast<std::size_t>(Level::L2)] = false;
  run();
  EXPECT_EQ(step(), Step::S10);
  EXPECT_TRUE(decided.effects.inform.has(Inform::network_registration_failed));
}

TEST_F(Start, OpensTheSessionWithTheContactEntered) {  // 5.4.4 S3
  restart_in(Step::S3, Level::L2);
  run();
  EXPECT_EQ(step(), Step::S3);
  received.entered.add(Entered::rbc_contact);
  state.radio.contact = radio::Rbc{5, 77, 0x1234};
  run();
  EXPECT_EQ(step(), Step::D31);
  EXPECT_EQ(state.contact_status, DataStatus::valid);
  EXPECT_TRUE(decided.effects.send.has(Send::open_session));
}

TEST_F(Start, OpensTheSessionByTheShortNumber) {  // 5.4.4 S3, 3.18.4.3.4
  restart_in(Step::S3, Level::L2);
  received.selected.add(Select::short_number);
  run();
  EXPECT_EQ(step(), Step::D31);
  EXPECT_EQ(state.contact_status, DataStatus::unknown);
  EXPECT_TRUE(decided.effects.send.has(Send::open_session));
}

TEST_F(Start, WaitsForTheSession) {  // 5.4.4 D31
  using radio::Phase;
  const auto after = [&](Phase phase) {
    restart_in(Step::D31, Level::L2);
    state.radio.supervising.session.phase = phase;
    state.position.status = DataStatus::valid;
    run();
    return std::pair(step(), decided.effects.send.has(Send::start_of_mission_report));
  };
  EXPECT_EQ(after(Phase::connecting), std::pair(Step::D31, false));
  EXPECT_EQ(after(Phase::waiting_version), std::pair(Step::D31, false));
  EXPECT_EQ(after(Phase::up), std::pair(Step::S10, true));
  EXPECT_EQ(after(Phase::lost), std::pair(Step::S10, true)) << "it is kept";
  EXPECT_EQ(after(Phase::idle), std::pair(Step::S10, false));
  EXPECT_EQ(after(Phase::terminating), std::pair(Step::S10, false));
}

TEST_F(Start, TheRBCValidatesThePosition) {  // 5.4.4 D33, D22, A24, A35, A39
  const auto after = [&](bool Received::*answer) {
    restart_in(Step::D33, Level::L2);
    in_session();
    state.position.status = DataStatus::invalid;
    ASSERT_TRUE(state.position.references.push_back({}));
    run();
    ASSERT_EQ(step(), Step::D33);
    received.*answer = true;
    run();
  };
  after(&Received::position_confirmed);
  EXPECT_EQ(step(), Step::S10);
  EXPECT_EQ(state.position.status, DataStatus::valid);
  after(&Received::train_accepted);
  EXPECT_EQ(step(), Step::S10);
  EXPECT_EQ(state.position.status, DataStatus::unknown);
  after(&Received::train_rejected);
  EXPECT_EQ(step(), Step::A40);
  EXPECT_TRUE(decided.effects.send.has(Send::terminate_session));
  run();
  EXPECT_EQ(step(), Step::A40) << "until the session is terminated";
  state.radio.supervising.session.phase = radio::Phase::terminating;
  run();
  EXPECT_EQ(step(), Step::A40);
  state.radio.supervising.session.phase = radio::Phase::idle;
  run();
  EXPECT_TRUE(decided.effects.inform.has(Inform::train_rejected));
}

TEST_F(Start, AChangedPositionIsThatOfTheRestOfTheCycle) {  // 5.4.3.3
  restart_in(Step::D33, Level::L2);
  in_session();
  state.position.status = DataStatus::invalid;
  received.train_accepted = true;
  decided.here.now = {};
  run();
  EXPECT_EQ(decided.here.now, state.now);
}

TEST_F(Start, OffersStartWithValidData) {  // 5.4.4 S10
  run();
  EXPECT_TRUE(decided.effects.offers.has(Offer::start));
  state.data.train_data_status = DataStatus::invalid;
  run();
  EXPECT_FALSE(decided.effects.offers.has(Offer::start));
  state.data.train_data_status = DataStatus::valid;
  state.data.train_running_number_status = DataStatus::invalid;
  run();
  EXPECT_FALSE(decided.effects.offers.has(Offer::start));
}

TEST_F(Start, TrainDataEnteredAgainAreSent) {  // 5.4.4 S12, D10, S11
  restart_in(Step::S10, Level::L2);
  in_session();
  received.entered.add(Entered::train_data);
  run();
  EXPECT_EQ(step(), Step::S11);
  EXPECT_TRUE(decided.effects.send.has(Send::train_data));
  received.entered = {};
  run();
  EXPECT_EQ(step(), Step::S11);
  state.radio.supervising.train_data_acknowledged = true;
  run();
  EXPECT_EQ(step(), Step::S20);
}

TEST_F(Start, ALevelEnteredAgainIsAskedWithItsContact) {  // 5.4.4 S10
  restart_in(Step::S10, Level::L2);
  state.contact_status = DataStatus::valid;
  received.entered.add(Entered::level);
  run();
  EXPECT_EQ(step(), Step::S3);
  EXPECT_EQ(state.contact_status, DataStatus::invalid);
}

TEST_F(Start, AsksTheRBCForAnAuthority) {  // 5.4.4 S21, 3.8.2.3 a
  restart_in(Step::S20, Level::L2);
  in_session();
  received.selected.add(Select::start);
  run();
  EXPECT_EQ(step(), Step::S21);
  EXPECT_TRUE(decided.start_selected);
  received.selected = {};
  run();
  EXPECT_TRUE(decided.start_selected);
  received.SR_authorised = true;
  run();
  EXPECT_TRUE(decided.effects.requests.has(Ack::SR));
  EXPECT_FALSE(decided.start_selected);
  restart_in(Step::S21, Level::L2);
  in_session();
  run(Mode::LS);
  EXPECT_TRUE(decided.effects.requests.has(Ack::LS));
}

TEST_F(Start, EachLevelHasItsAcknowledgement) {  // 5.4.4 S22 to S24
  const auto asked_in = [&](Level level) {
    restart_in(Step::S20, level);
    received.selected.add(Select::start);
    run();
    return decided.effects.requests;
  };
  EXPECT_TRUE(asked_in(Level::NTC).has(Ack::SN));
  EXPECT_TRUE(asked_in(Level::L0).has(Ack::UN));
  EXPECT_TRUE(asked_in(Level::L1).has(Ack::SR));
}

TEST_F(Start, IsEndedWithTheDesk) {  // 5.4, A.3.4 k
  const std::uint32_t revision = state.revision;
  desk_open = false;
  run();
  EXPECT_EQ(step(), Step::S0);
  EXPECT_NE(state.revision, revision);
  EXPECT_EQ(state.data.driver_id_status, DataStatus::invalid) << "4.10";
  const std::uint32_t after = state.revision;
  run();
  EXPECT_EQ(state.revision, after) << "once";
}

TEST_F(Start, IsOverInAnotherMode) {  // 5.4.3.3: the position that was not validated is unknown
  state.position.status = DataStatus::invalid;
  state.mode = Mode::SR;
  const std::uint32_t revision = state.revision;
  run();
  EXPECT_EQ(state.position.status, DataStatus::unknown);
  EXPECT_EQ(state.revision, revision) << "that is no closed desk";
}

}  // namespace
}  // namespace evc::kernel
