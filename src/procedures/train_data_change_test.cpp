#include "procedures/train_data_change.h"

#include <gtest/gtest.h>

// The boxes are those of SUBSET-026-5 5.17.2.2.
namespace evc::procedures::train_data_change {
namespace {

struct Change {
  State state;
  Inputs in;
  explicit Change(Mode mode, bool driver_validates) {
    in.mode = mode;
    in.pending = true;
    in.driver_validates = driver_validates;
    in.train_data_valid = true;
  }
  Result cycle() { return step(state, in); }
};

TEST(TrainDataChange, Nothing_happens_without_a_change) {
  Change c(Mode::FS, true);
  c.in.pending = false;
  const Result r = c.cycle();
  EXPECT_EQ(r.data, Fate::kept);
  EXPECT_FALSE(r.brake);
  EXPECT_EQ(c.state.step, Step::S0);
}

TEST(TrainDataChange, Only_the_modes_of_S0_begin_it) {
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode mode = static_cast<Mode>(m);
    const Set<Mode> modes{Mode::FS, Mode::LS, Mode::OS, Mode::SR, Mode::SB,
                          Mode::SN, Mode::UN, Mode::TR, Mode::PT, Mode::AD};
    Change c(mode, false);
    c.in.standstill = true;
    EXPECT_EQ(c.cycle().data, modes.has(mode) ? Fate::in_force : Fate::kept) << m;
  }
}

TEST(TrainDataChange, In_motion_the_driver_acknowledges_the_brake_and_validates) {
  Change c(Mode::FS, true);
  EXPECT_TRUE(c.cycle().brake);
  EXPECT_EQ(c.state.step, Step::S4);
  c.in.brake_commanded = true;
  EXPECT_TRUE(c.cycle().brake);
  c.in.standstill = true;
  EXPECT_FALSE(c.cycle().brake);
  EXPECT_EQ(c.state.step, Step::S5);
  EXPECT_TRUE(c.cycle().effects.entries.empty());
  c.in.brake_commanded = false;
  EXPECT_TRUE(c.cycle().effects.entries.has(Entry::train_data));
  EXPECT_EQ(c.state.step, Step::S6);
  EXPECT_EQ(c.cycle().data, Fate::kept);
  c.in.driver_validated = true;
  EXPECT_EQ(c.cycle().data, Fate::by_the_driver);
  EXPECT_EQ(c.state.step, Step::S0);
}

TEST(TrainDataChange, At_standstill_the_driver_validates_at_once) {
  Change c(Mode::SB, true);
  c.in.standstill = true;
  const Result r = c.cycle();
  EXPECT_TRUE(r.effects.entries.has(Entry::train_data));
  EXPECT_TRUE(r.effects.inform.empty());
  EXPECT_FALSE(r.brake);
}

TEST(TrainDataChange, An_entry_before_the_change_does_not_validate_it) {
  Change c(Mode::SB, true);
  c.in.standstill = c.in.driver_validated = true;
  EXPECT_EQ(c.cycle().data, Fate::kept);
  EXPECT_EQ(c.state.step, Step::S6);
}

TEST(TrainDataChange, A_trip_is_waited_for) {
  for (const Mode trip : {Mode::TR, Mode::PT}) {
    Change c(trip, true);
    c.in.standstill = true;
    EXPECT_TRUE(c.cycle().effects.entries.empty());
    EXPECT_EQ(c.state.step, Step::S1);
    c.cycle();
    EXPECT_EQ(c.state.step, Step::S1);
    c.in.mode = Mode::SR;
    EXPECT_TRUE(c.cycle().effects.entries.has(Entry::train_data));
    EXPECT_EQ(c.state.step, Step::S6);
  }
}

TEST(TrainDataChange, A_trip_that_ends_in_SH_leaves_no_valid_train_data) {
  Change c(Mode::PT, true);
  c.cycle();
  c.in.mode = Mode::SH;
  EXPECT_EQ(c.cycle().data, Fate::to_validate);
  EXPECT_EQ(c.state.step, Step::S0);
}

TEST(TrainDataChange, Without_valid_train_data_they_are_to_be_validated) {
  for (const Mode mode : {Mode::SB, Mode::SH, Mode::NL}) {
    Change c(mode, false);
    c.in.train_data_valid = false;
    EXPECT_EQ(c.cycle().data, Fate::to_validate);
  }
}

TEST(TrainDataChange, While_they_are_validated_a_trip_asks_for_nothing) {
  Change c(Mode::FS, true);
  c.in.standstill = true;
  c.cycle();
  c.in.mode = Mode::TR;
  EXPECT_TRUE(c.cycle().effects.entries.empty());
  c.in.mode = Mode::NL;
  EXPECT_TRUE(c.cycle().effects.entries.empty());
  EXPECT_EQ(c.state.step, Step::S6);
}

TEST(TrainDataChange, Who_is_only_informed) {
  // D1: other data; D3: SB, PT; D5: nothing of an RBC waits; D7: standstill.
  const auto informed = [](const Change& change) {
    Change c = change;
    const Result r = c.cycle();
    return r.data == Fate::in_force && r.effects.inform.has(Inform::train_data_changed) && !r.brake;
  };
  for (std::size_t m = 0; m < kModes; ++m) {
    Change c(static_cast<Mode>(m), false);
    const Set<Mode> modes{Mode::FS, Mode::LS, Mode::OS, Mode::SR, Mode::SB,
                          Mode::SN, Mode::UN, Mode::TR, Mode::PT, Mode::AD};
    if (!modes.has(c.in.mode)) continue;
    EXPECT_TRUE(informed(c)) << m;
    c.in.route_matters = true;
    const Set<Mode> with_authority{Mode::FS, Mode::LS, Mode::OS, Mode::AD};
    EXPECT_EQ(informed(c), !with_authority.has(c.in.mode)) << m;
    c.in.authority_waits = true;
    EXPECT_EQ(informed(c), c.in.mode == Mode::SB || c.in.mode == Mode::PT) << m;
    c.in.standstill = true;
    EXPECT_TRUE(informed(c)) << m;
  }
}

TEST(TrainDataChange, What_concerns_the_authority_brakes_first) {
  Change c(Mode::OS, false);
  c.in.route_matters = true;
  EXPECT_TRUE(c.cycle().brake);
  EXPECT_EQ(c.state.step, Step::S2);
  EXPECT_TRUE(c.cycle().brake);
  c.in.standstill = c.in.brake_commanded = true;
  EXPECT_FALSE(c.cycle().brake);
  EXPECT_EQ(c.cycle().data, Fate::kept);
  c.in.brake_commanded = false;
  const Result r = c.cycle();
  EXPECT_EQ(r.data, Fate::in_force);
  EXPECT_TRUE(r.effects.entries.empty());
  EXPECT_EQ(c.state.step, Step::S0);
}

TEST(TrainDataChange, A_second_change_that_the_driver_validates_joins) {
  Change c(Mode::FS, false);
  c.in.route_matters = true;
  c.cycle();
  Change at_standstill = c;
  c.in.driver_validates = true;
  EXPECT_TRUE(c.cycle().brake);
  EXPECT_EQ(c.state.step, Step::S4);
  at_standstill.in.standstill = at_standstill.in.brake_commanded = true;
  at_standstill.cycle();
  at_standstill.in.driver_validates = true;
  at_standstill.cycle();
  EXPECT_EQ(at_standstill.state.step, Step::S5);
}

}  // namespace
}  // namespace evc::procedures::train_data_change
