#include "kernel/decide/decide.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"

// From what the unit knows in a cycle to its mode (4.6.3): facts that no other test shows by themselves.
namespace evc::kernel {
namespace {

using evc::test::at;

/// A unit at 1000 m with an authority and the track described, powered, its desk open.
class Decide : public ::testing::Test {
 protected:
  Decide() { restart(Mode::FS, Level::L1); }
  void restart(Mode mode, Level level) {
    state = State{};
    received = Received{};
    state.mode = mode;
    state.level.level = level;
    state.data.level_status = state.data.train_data_status = DataStatus::valid;
    track::MovementAuthority ma;
    EXPECT_TRUE(ma.sections.push_back({at(0.0), at(3000.0)}));
    state.track.ma = ma;
    EXPECT_TRUE(state.track.gradient.append(at(0.0), {0}));
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 20}));
    in.train.powered = in.train.desk_open = true;
    received.here.est_front = received.here.min_safe_front = received.here.max_safe_front = at(1000.0);
    received.here.min_safe_antenna = at(995.0);
    received.here.min_safe_rear = at(800.0);
  }
  Mode mode_after() {
    decided = decide(state, in, received, Log{outputs->events});
    return state.mode;
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  Inputs in;
  Received received;
  Decided decided;
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
};

TEST_F(Decide, AnAuthorityWithoutAProfileGivesFS) {  // [32]
  for (const Mode mode : {Mode::FS, Mode::OS, Mode::LS}) {
    restart(mode, Level::L1);
    EXPECT_EQ(mode_after(), Mode::FS);
  }
}

TEST_F(Decide, EachCauseOfATripTrips) {  // 4.6.3 [17], [18], [20], [65], [66]
  for (bool Received::*cause : {&Received::linking_reaction_trip, &Received::trip_order, &Received::ues_accepted,
                                &Received::telegram_version_too_high, &Received::linked_group_wrong_direction}) {
    restart(Mode::FS, Level::L1);
    received.*cause = true;
    EXPECT_EQ(mode_after(), Mode::TR);
  }
}

TEST_F(Decide, AGroupOfTheListForSRDoesNotStopTheTrainUnlessXIs1) {  // [54], 6.6.2.2.2
  for (const std::uint8_t X : {std::uint8_t{1}, std::uint8_t{2}}) {
    restart(Mode::SR, Level::L2);
    state.track.ma.reset();
    received.stop_if_in_SR = received.group_passed_in_SR_list = true;
    state.operated_X = X;
    EXPECT_EQ(mode_after(), X == 1 ? Mode::TR : Mode::SR);
  }
}

TEST_F(Decide, ATrainInRearOfItsTrackDescriptionTrips) {  // [69]
  state.track.gradient = {};
  state.track.ssp = {};
  EXPECT_TRUE(state.track.gradient.append(at(1500.0), {0}));
  EXPECT_TRUE(state.track.ssp.append(at(1500.0), {.V_STATIC = 20}));
  EXPECT_EQ(mode_after(), Mode::TR);
}

TEST_F(Decide, AnAuthorityThatCameWithATripOrderIsNoProceed) {  // [32]
  restart(Mode::SR, Level::L1);
  state.ma_with_trip_order = true;
  EXPECT_EQ(mode_after(), Mode::SR);
  state.ma_with_trip_order = false;
  EXPECT_EQ(mode_after(), Mode::FS);
}

TEST_F(Decide, AheadOfAnAcknowledgedAreaItsModeStays) {  // [32]; [75] and [76] of 4.0.0
  const auto after = [&](Mode mode, Mode area) {
    restart(mode, Level::L1);
    track::ModeArea a;
    a.mode = area;
    a.ack_from = at(950.0);
    a.from = at(1100.0);
    a.to = at(2000.0);
    EXPECT_TRUE(state.track.mode_profile.push_back(a));
    return mode_after();
  };
  EXPECT_EQ(after(Mode::OS, Mode::OS), Mode::OS);
  EXPECT_EQ(after(Mode::LS, Mode::LS), Mode::LS);
  EXPECT_EQ(after(Mode::OS, Mode::LS), Mode::FS);
  EXPECT_EQ(after(Mode::LS, Mode::OS), Mode::FS);
}

TEST_F(Decide, AnotherNationalSystemIsNoNewLevel) {  // [56]
  const auto after = [&](bool national_system_only) {
    restart(Mode::UN, Level::NTC);
    received.level_switched_to = Level::NTC;
    if (national_system_only) received.national_system_only = true;
    return mode_after();
  };
  EXPECT_EQ(after(false), Mode::SN);
  EXPECT_EQ(after(true), Mode::UN);
}

TEST_F(Decide, AnEmergencyStopEndsTheEntryToSRByOverride) {  // [45]
  const auto after = [&](bool received_now, bool pending) {
    restart(Mode::UN, Level::L2);
    state.track.ma.reset();
    state.override_.active = true;
    received.level_switched_to = Level::L2;
    if (received_now) received.ues_received = true;
    if (pending) (void)state.emergency_stops.pending.push_back({1, false, {}});
    return mode_after();
  };
  EXPECT_EQ(after(false, false), Mode::SR);
  EXPECT_NE(after(true, false), Mode::SR);
  EXPECT_NE(after(false, true), Mode::SR);
}

TEST_F(Decide, AnAreaIsAcknowledgedOnlyWithItsAuthority) {  // 5.4.4 S21, S25
  using Step = procedures::start_of_mission::Step;
  for (const bool authority : {true, false}) {
    restart(Mode::SB, Level::L2);
    state.radio.supervising.session.phase = radio::Phase::up;
    state.start_of_mission.step = Step::S21;
    track::ModeArea a;
    a.mode = Mode::OS;
    a.from = a.ack_from = at(900.0);
    a.to = at(2000.0);
    EXPECT_TRUE(state.track.mode_profile.push_back(a));
    if (!authority) state.track.gradient = {};
    (void)mode_after();
    EXPECT_EQ(state.start_of_mission.step, authority ? Step::S25 : Step::S21);
  }
}

TEST_F(Decide, TheAuthorityOfTheCycleCounts) {  // 4.6.3 [12], [16]
  for (const Level level : {Level::L1, Level::L2}) {
    restart(Mode::FS, level);
    ASSERT_EQ(mode_after(), Mode::FS);
    state.track.ma->sections[0].end = at(990.0);
    ++state.track.revision;
    EXPECT_EQ(mode_after(), Mode::TR) << static_cast<int>(level);
  }
}

TEST_F(Decide, TheCurvesOfTheNewModeAreBuiltAtOnce) {  // 4.5.2, 3.13
  ASSERT_EQ(mode_after(), Mode::FS);
  ASSERT_EQ(mode_after(), Mode::FS);
  EXPECT_FALSE(decided.basis_renewed);
  in.train.isolated = true;
  EXPECT_EQ(mode_after(), Mode::IS);
  EXPECT_TRUE(decided.basis_renewed);
  EXPECT_EQ(state.basis.key.mode, Mode::IS);
}

}  // namespace
}  // namespace evc::kernel
