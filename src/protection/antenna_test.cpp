#include "protection/antenna.h"

#include <gtest/gtest.h>

#include <memory>

// 3.15.7 with the distance of A.3.1.
namespace evc::protection {
namespace {

struct Antenna {
  AntennaAlarm state;
  AntennaSituation s;
  std::unique_ptr<track::Description> track = std::make_unique<track::Description>();
  explicit Antenna(Level level, Mode mode = Mode::SR) {
    s.alarm = true;
    s.level = level;
    s.mode = mode;
    run_to(0.0);
  }
  /// The odometer counts up to 2 % too much or too little.
  void run_to(double m) { s.counter = {{{m}}, {{m < 0 ? 1.02 * m : 0.98 * m}}, {{m < 0 ? 0.98 * m : 1.02 * m}}}; }
  bool brakes() { return asks_for_brake(state, s, *track); }
};

TEST(Antenna, An_alarm_in_levels_1_to_3_brakes_while_it_lasts) {
  for (const Level level : {Level::L1, Level::L2, Level::L3}) {
    Antenna a(level);
    EXPECT_TRUE(a.brakes());
    a.s.alarm = false;
    EXPECT_FALSE(a.brakes());
  }
}

TEST(Antenna, In_levels_0_and_NTC_it_is_ignored_for_300_m) {
  for (const Level level : {Level::L0, Level::NTC})
    for (const double way : {1.0, -1.0}) {
      Antenna a(level, Mode::UN);
      EXPECT_FALSE(a.brakes());
      a.run_to(way * 294.0);  // at most 299.9 m
      EXPECT_FALSE(a.brakes());
      a.run_to(way * 294.2);
      EXPECT_TRUE(a.brakes());
    }
}

TEST(Antenna, The_distance_begins_anew_with_the_alarm) {
  Antenna a(Level::L0, Mode::UN);
  EXPECT_FALSE(a.brakes());
  a.run_to(200.0);
  a.s.alarm = false;
  EXPECT_FALSE(a.brakes());
  a.s.alarm = true;
  EXPECT_FALSE(a.brakes());
  a.run_to(450.0);
  EXPECT_FALSE(a.brakes());
}

TEST(Antenna, It_is_ignored_in_a_big_metal_mass_in_every_level) {
  for (const Level level : {Level::L0, Level::NTC, Level::L1, Level::L2, Level::L3}) {
    const auto at = [&](double min, double max) {
      Antenna a(level);  // an alarm that began with its 300 m in levels 0 and NTC behind it
      a.state.since = a.s.counter;
      a.run_to(500.0);
      EXPECT_TRUE(a.track->big_metal.push_back({Place{100.0}, Place{150.0}}));
      a.s.min_safe_antenna = Place{min};
      a.s.max_safe_antenna = Place{max};
      return a.brakes();
    };
    EXPECT_TRUE(at(80.0, 99.9));
    EXPECT_FALSE(at(80.0, 100.0));
    EXPECT_FALSE(at(150.0, 170.0));
    EXPECT_TRUE(at(150.1, 170.0));
  }
}

TEST(Antenna, Its_reaction_goes_on_in_a_big_metal_mass_that_it_did_not_begin_in) {
  Antenna a(Level::L1);
  ASSERT_TRUE(a.track->big_metal.push_back({Place{100.0}, Place{150.0}}));
  EXPECT_TRUE(a.brakes());
  a.s.min_safe_antenna = Place{110.0};
  a.s.max_safe_antenna = Place{120.0};
  EXPECT_TRUE(a.brakes());
  a.s.alarm = false;
  EXPECT_FALSE(a.brakes());
  a.s.alarm = true;
  EXPECT_FALSE(a.brakes()) << "another one, in the metal";
}

// 5.22: the driver ends the reaction, also over metal; behind the inhibition the alarm is as a new one.
TEST(Antenna, Its_inhibition_ends_a_reaction_that_goes_on) {
  Antenna a(Level::L1);
  a.s.srs = SrsVersion::v4_0_0;
  ASSERT_TRUE(a.track->big_metal.push_back({Place{100.0}, Place{150.0}}));
  EXPECT_TRUE(a.brakes());
  a.state.inhibited = a.s.counter;
  EXPECT_FALSE(a.brakes());
  a.run_to(115.0);
  a.s.min_safe_antenna = Place{110.0};
  a.s.max_safe_antenna = Place{120.0};
  EXPECT_FALSE(a.brakes());
  EXPECT_FALSE(a.state.inhibited.has_value()) << "5.22.5.2.1";
  a.s.min_safe_antenna = Place{160.0};
  a.s.max_safe_antenna = Place{170.0};
  EXPECT_TRUE(a.brakes());
}

TEST(Antenna, Its_inhibition_goes_on_over_the_metal_that_it_begins_in) {  // 5.22.5.2.1 is for an area ahead
  Antenna a(Level::L1);
  a.s.srs = SrsVersion::v4_0_0;
  ASSERT_TRUE(a.track->big_metal.push_back({Place{100.0}, Place{150.0}}));
  a.s.min_safe_antenna = Place{110.0};
  a.s.max_safe_antenna = Place{120.0};
  a.state.inhibited = a.s.counter;
  for (const double way : {0.0, 20.0, 60.0, 290.0}) {
    a.run_to(way);
    a.s.min_safe_antenna = Place{110.0 + way};
    a.s.max_safe_antenna = Place{120.0 + way};
    EXPECT_FALSE(a.brakes()) << way;
    EXPECT_TRUE(a.state.inhibited.has_value()) << way;
  }
  a.run_to(301.0);
  EXPECT_TRUE(a.brakes()) << "5.22.5.1 a";
}

TEST(Antenna, It_is_ignored_in_reversing_and_where_the_unit_does_not_work) {
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode mode = static_cast<Mode>(m);
    Antenna a(Level::L1, mode);
    EXPECT_EQ(a.brakes(), mode != Mode::RV && mode != Mode::NP && mode != Mode::IS) << m;
  }
}

TEST(Antenna, Issue_4_0_0_ignores_it_in_SB_of_levels_1_to_3) {
  Antenna a(Level::L2, Mode::SB);
  EXPECT_TRUE(a.brakes());
  a.s.srs = SrsVersion::v4_0_0;
  EXPECT_FALSE(a.brakes());
  a.s.level = Level::L0;
  a.run_to(400.0);
  EXPECT_TRUE(a.brakes());
}

}  // namespace
}  // namespace evc::protection
