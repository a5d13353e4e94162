#include "procedures/override.h"

#include <gtest/gtest.h>

#include "base/test_units.h"

namespace evc::procedures {
namespace {

using evc::test::at;

struct Driver {
  override_::State state;
  override_::Inputs in;
  Driver() {
    in.mode = Mode::FS;
    in.level = Level::L2;
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
  /// Selects override in FS, which leads to SR.
  override_::Result select() {
    in.selected = true;
    const override_::Result out = cycle();
    override_::on_mode_change(state, Mode::SR);
    in.mode = Mode::SR;
    return out;
  }
};

TEST(Override, TheTimeOfTheNationalValuesOfNow) {  // 3.18.2.11
  Driver d;
  d.select();
  d.cycle(29.0);
  d.in.T_NVOVTRP = Duration{30.0};
  EXPECT_EQ(d.cycle().ended_by, "5.8.4.1 a"_srs) << "30 s after the selection";
  Driver longer;
  longer.select();
  longer.in.T_NVOVTRP = Duration{90.0};
  EXPECT_FALSE(longer.cycle(89.0).ended_by);
  EXPECT_EQ(longer.cycle().ended_by, "5.8.4.1 a"_srs);
}

TEST(Override, Every_end_condition_ends_it_and_is_named) {
  const auto ended_by = [](auto&& change, double seconds = 1.0) {
    Driver d;
    const auto selected = d.select();
    EXPECT_TRUE(selected.selected && selected.started && selected.active);
    change(d);
    const auto r = d.cycle(seconds);
    EXPECT_TRUE(r.active);  // the status before the end conditions of this cycle (5.8.4.2)
    EXPECT_EQ(d.state.active, !r.ended_by);
    return r.ended_by;
  };
  EXPECT_EQ(ended_by([](Driver&) {}), Clause{});
  EXPECT_EQ(ended_by([](Driver&) {}, 60.0), "5.8.4.1 a"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.odometer = OdometerPlace{Distance{200.1}}; }), "5.8.4.1 b"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.odometer = OdometerPlace{Distance{-200.1}}; }), "5.8.4.1 b"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.min_safe_antenna = at(100.1); }), "5.8.4.1 c"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.stop_if_in_SR = true; }), "5.8.4.1 d"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.stop_if_in_SH = true; }), "5.8.4.1 d"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.balise_proceed = true; }), "5.8.4.1 e"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.ma_from_rbc = true; }), "5.8.4.1 f"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.group_not_in_list = true; }), "5.8.4.1 g"_srs);
  EXPECT_EQ(ended_by([](Driver& d) {
              d.in.level = Level::L1;
              d.in.ma_from_rbc = true;
            }),
            Clause{});
  EXPECT_EQ(ended_by([](Driver& d) {
              d.in.D_NVOVTRP.reset();
              d.in.odometer = OdometerPlace{Distance{1.0e6}};
            }),
            Clause{});
}

TEST(Override, What_comes_in_the_cycle_of_the_selection_ends_it) {
  const auto ended_by = [](auto&& change) {
    Driver d;
    d.select();
    d.in.selected = true;
    change(d);
    const auto r = d.cycle();
    EXPECT_TRUE(r.started && r.active);  // no trip in this cycle
    EXPECT_EQ(d.state.active, !r.ended_by);
    return r.ended_by;
  };
  EXPECT_EQ(ended_by([](Driver&) {}), Clause{});
  EXPECT_EQ(ended_by([](Driver& d) { d.in.min_safe_antenna = at(100.1); }), "5.8.4.1 c"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.stop_if_in_SR = true; }), "5.8.4.1 d"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.group_not_in_list = true; }), "5.8.4.1 g"_srs);
  EXPECT_EQ(ended_by([](Driver& d) { d.in.balise_proceed = true; }), Clause{});
  EXPECT_EQ(ended_by([](Driver& d) { d.in.ma_from_rbc = true; }), Clause{});
}

TEST(Override, In_UN_and_SN_only_time_and_distance_end_it) {
  for (const Mode mode : {Mode::UN, Mode::SN}) {
    Driver d;
    d.in.mode = mode;
    d.in.selected = true;
    d.cycle();
    d.in.balise_proceed = d.in.group_not_in_list = true;
    EXPECT_EQ(d.cycle().ended_by, Clause{});
    EXPECT_FALSE(d.state.former_eoa.has_value());
    EXPECT_EQ(d.cycle(60.0).ended_by, "5.8.4.1 a"_srs);
  }
}

TEST(Override, The_SR_distance_before_it_ends_it) {
  Driver d;
  d.in.mode = Mode::SR;
  d.in.sr_distance_end = at(120.0);
  d.in.selected = true;
  d.cycle();
  d.in.sr_distance_end = at(1000.0);
  EXPECT_EQ(d.cycle().ended_by, Clause{});
  d.in.est_front = at(120.1);
  EXPECT_EQ(d.cycle().ended_by, "5.8.4.1 h"_srs);
}

TEST(Override, The_former_EOA_is_passed_once) {
  Driver d;
  d.select();
  EXPECT_EQ(d.cycle(60.0).ended_by, "5.8.4.1 a"_srs);
  d.in.min_safe_antenna = at(100.1);
  const auto passed = d.cycle();
  EXPECT_TRUE(passed.former_eoa_passed);
  EXPECT_FALSE(passed.active);  // [43]
  EXPECT_FALSE(d.cycle().former_eoa_passed);
  // While override is active, passing the former EOA ends it and does not trip the train
  // afterwards.
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
  override_::on_mode_change(e.state, Mode::SB);
  EXPECT_FALSE(e.state.former_eoa.has_value());
  EXPECT_FALSE(e.state.active);
}

TEST(Override, A_trip_that_comes_with_the_selection_deletes_the_former_EOA) {
  Driver d;
  d.in.selected = true;
  d.cycle();
  EXPECT_EQ(d.state.former_eoa, at(100.0));
  override_::on_mode_change(d.state, Mode::TR);
  override_::on_mode_change(d.state, Mode::PT);
  override_::on_mode_change(d.state, Mode::SR);
  d.in.mode = Mode::SR;
  d.in.min_safe_antenna = at(101.0);
  EXPECT_FALSE(d.cycle().former_eoa_passed);
}

TEST(Override, Selected_again_it_starts_again) {
  Driver d;
  d.select();
  d.cycle(50.0);
  d.in.selected = true;
  EXPECT_TRUE(d.cycle().started);
  EXPECT_EQ(d.cycle(50.0).ended_by, Clause{});
  EXPECT_EQ(d.state.former_eoa, at(100.0));  // in SR a later selection changes nothing
}

TEST(Override, Mode_changes_end_it) {
  for (const Mode to : {Mode::TR, Mode::LS, Mode::OS, Mode::SH}) {
    Driver d;
    d.select();
    override_::on_mode_change(d.state, to);
    EXPECT_FALSE(d.state.active) << name(to);
  }
  Driver d;
  d.in.mode = Mode::SN;
  d.in.selected = true;
  d.cycle();
  override_::on_mode_change(d.state, Mode::SR);
  EXPECT_TRUE(d.state.active);
}

}  // namespace
}  // namespace evc::procedures
