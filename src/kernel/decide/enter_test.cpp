#include "kernel/decide/enter.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"

// What the entry of a mode does beside 4.10.
namespace evc::kernel {
namespace {

using evc::test::at;
constexpr Mode kModesEntered[] = {Mode::NP, Mode::SB, Mode::PS, Mode::SH, Mode::FS, Mode::LS,
                                  Mode::SR, Mode::OS, Mode::SL, Mode::NL, Mode::UN, Mode::TR,
                                  Mode::PT, Mode::SF, Mode::IS, Mode::SN, Mode::RV};
constexpr bool in_authority(Mode mode) { return mode == Mode::FS || mode == Mode::LS || mode == Mode::OS; }

class Enter : public ::testing::Test {
 protected:
  void restart(Mode from) {
    state = State{};
    outputs->events.clear();
    state.mode = from;
    state.level.level = Level::L1;
    state.now = {100.0};
    here.est_front = here.min_safe_front = here.max_safe_front = at(1000.0);
  }
  void enter(Mode to, int number = 0) { enter_mode(state, to, number, here, Log{outputs->events}); }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
  track::Here here;
};

TEST_F(Enter, TheModeIsThatOfTheTransition) {  // 4.6.3
  restart(Mode::SB);
  enter(Mode::SR, 8);
  EXPECT_EQ(state.mode, Mode::SR);
  EXPECT_EQ(state.revision, 1u);
  ASSERT_EQ(outputs->events.size(), 1u);
  EXPECT_EQ(outputs->events[0], Event::mode_changed(Mode::SB, Mode::SR, 8));
}

TEST_F(Enter, TheLSSMAIsNotShownWithTheEntryToLS) {  // 4.4.19.1.4.6
  restart(Mode::SB);
  state.lssma.on = true;
  state.lssma.waiting = {Duration{99.0}, Duration{5.0}};
  enter(Mode::LS);
  EXPECT_FALSE(state.lssma.on);
  EXPECT_TRUE(state.lssma.waiting.has_value()) << "the order of the message that leads to LS";
}

TEST_F(Enter, TheAreaOfItsModeIsAccepted) {  // 5.7, 5.9, 5.19
  for (const Mode to : {Mode::OS, Mode::LS, Mode::FS}) {
    restart(Mode::SR);
    for (const double from : {1100.0, 3000.0}) {
      track::ModeArea area;
      area.mode = to;
      area.ack_from = at(from - 150.0);
      area.from = at(from);
      area.to = at(from + 500.0);
      ASSERT_TRUE(state.track.mode_profile.push_back(area));
    }
    enter(to);
    ASSERT_EQ(state.track.mode_profile.size(), 2u);
    EXPECT_EQ(state.track.mode_profile[0].accepted, to != Mode::FS) << static_cast<int>(to);
    EXPECT_FALSE(state.track.mode_profile[1].accepted) << "farther on";
  }
}

TEST_F(Enter, ShuntingOfTheDriverHasNoList) {  // 5.6.2, 4.6.3 [5]
  const auto keeps_list = [&](Mode to, int number) {
    restart(Mode::FS);
    state.track.sh_list.emplace();
    enter(to, number);
    return state.track.sh_list.has_value();
  };
  EXPECT_FALSE(keeps_list(Mode::SH, 5));
  EXPECT_TRUE(keeps_list(Mode::SH, 51));
  EXPECT_TRUE(keeps_list(Mode::OS, 5));
}

TEST_F(Enter, ShuntingHasTheSpeedOfTheAreaThatLedToIt) {  // 3.11.7.1.1
  for (const int number : {5, 6, 23, 50, 51, 61, 68}) {
    restart(number == 23 ? Mode::PS : Mode::FS);
    state.V_SH = 9;
    track::ModeArea area;
    area.mode = Mode::SH;
    area.from = at(990.0);
    area.V_MAMODE = 4;
    ASSERT_TRUE(state.track.mode_profile.push_back(area));
    enter(Mode::SH, number);
    EXPECT_EQ(state.V_SH, number == 23 ? 9 : number >= 50 && number <= 61 ? 4 : track::kNoSpeed) << number;
  }
}

TEST_F(Enter, ATripOrderCountsForItsAuthorityOnly) {  // 4.6.3 [32]
  for (const Mode to : kModesEntered) {
    restart(Mode::FS);
    state.ma_with_trip_order = state.shorten_at_standstill = true;
    enter(to);
    EXPECT_EQ(state.ma_with_trip_order, in_authority(to)) << static_cast<int>(to);
    EXPECT_EQ(state.shorten_at_standstill, in_authority(to)) << static_cast<int>(to);
  }
}

TEST_F(Enter, WithoutPowerNothingGoesOn) {  // 4.10
  for (const Mode to : {Mode::NP, Mode::SB}) {
    restart(Mode::SR);
    state.balise.open.emplace();
    state.train_data_change.pending.emplace();
    state.train_data_change.procedure.step = procedures::train_data_change::Step::S6;
    enter(to);
    const bool goes_on = to != Mode::NP;
    EXPECT_EQ(state.balise.open.has_value(), goes_on);
    EXPECT_EQ(state.train_data_change.pending.has_value(), goes_on);
    EXPECT_EQ(state.train_data_change.procedure.step == procedures::train_data_change::Step::S6, goes_on);
  }
}

TEST_F(Enter, WhatWaitsGoesWithItsTransition) {  // 4.8.5.4, 4.10
  const auto waits = [&](Mode to) {
    restart(Mode::FS);
    state.level_transition.pending.emplace().to.level = Level::L2;
    EXPECT_NE(state.buffer.grow(), nullptr);
    enter(to);
    EXPECT_EQ(state.buffer.empty(), !state.level_transition.pending.has_value());
    return !state.buffer.empty();
  };
  EXPECT_TRUE(waits(Mode::OS));
  EXPECT_FALSE(waits(Mode::SH));
}

TEST_F(Enter, TheProceduresKnowIt) {  // 5.8.4.1 i, 5.7.3.5, 3.14.2
  restart(Mode::FS);
  state.override_.active = true;
  enter(Mode::OS, 40);
  EXPECT_FALSE(state.override_.active);
  EXPECT_TRUE(state.mode_profile.unacknowledged);
  EXPECT_EQ(state.mode_profile.asked, Mode::OS);
  EXPECT_EQ(state.mode_profile.deadline, Duration{105.0});
  restart(Mode::SR);
  state.override_.former_eoa = at(500.0);
  enter(Mode::SB, 28);
  EXPECT_EQ(state.override_.former_eoa, std::nullopt) << "SR was left";
  restart(Mode::TR);
  state.position.now.counter.nominal = {{444.0}};
  enter(Mode::PT, 7);
  ASSERT_TRUE(state.guards.post_trip_from.has_value());
  EXPECT_EQ(state.guards.post_trip_from->from_origin, Distance{444.0});
}

TEST_F(Enter, BrakeCommandsAreRevokedByTheMode) {  // 4.12
  for (const Mode to : kModesEntered) {
    restart(Mode::FS);
    state.brakes.active.add(brakes::Cause::linking);
    brakes::State alone = state.brakes;
    brakes::on_mode_entry(alone, to, Mode::FS);
    enter(to);
    EXPECT_EQ(state.brakes.active, alone.active) << static_cast<int>(to);
  }
}

TEST_F(Enter, ATripHasItsReason) {  // 4.4.13.1.3
  for (const Mode to : {Mode::TR, Mode::SB}) {
    restart(Mode::FS);
    enter(to, 20);
    EXPECT_EQ(state.status_texts.trip_reason.has_value(), to == Mode::TR);
  }
}

TEST_F(Enter, StaffResponsibleHasItsDistance) {  // 4.4.11.1.3.1
  const auto end = [&](Mode to, bool by_rbc) {
    restart(Mode::SB);
    state.national_values.D_NVSTFF = Distance{700.0};
    state.staff_responsible.by_rbc = by_rbc;
    enter(to, 8);
    return state.staff_responsible.end;
  };
  EXPECT_EQ(end(Mode::SR, false), at(1700.0));
  EXPECT_EQ(end(Mode::SR, true), std::nullopt);
  EXPECT_EQ(end(Mode::UN, false), std::nullopt);
}

}  // namespace
}  // namespace evc::kernel
