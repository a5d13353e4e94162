#include "brake_rules.h"

#include <gtest/gtest.h>

#include "terms/requests.h"

// That the rules notice a unit that does not keep to them.
namespace evc::brake_rules {
namespace {

/// A unit whose outputs are given, cycle by cycle.
struct Unit {
  port::Inputs in;
  port::Outputs out;
  Memory memory;
  Seen seen;

  Unit() { in.train.desk_open = true; }
  std::vector<std::string> cycle(Mode mode, Set<Cause> causes, double V = 10.0, Set<Ack> acknowledged = {}) {
    in.now = in.now + Duration{0.1};
    in.odometry.V_est = Speed{V};
    in.driver.acknowledged = static_cast<std::uint32_t>(acknowledged.bits());
    out.mode = mode;
    out.brake_reasons = causes;
    return look(memory, in, out, true, &seen);
  }
  void stand() {
    for (int i = 0; i < 11; ++i) (void)cycle(memory.mode, memory.commanded, 0.0);
  }
};

Unit in_FS_with(Cause cause) {
  Unit unit;
  (void)unit.cycle(Mode::FS, {});
  EXPECT_TRUE(unit.cycle(Mode::FS, {cause}).empty());
  EXPECT_TRUE(unit.cycle(Mode::FS, {cause}).empty());
  return unit;
}

TEST(BrakeRules, A_command_that_ends_too_early_is_a_fault) {
  EXPECT_EQ(in_FS_with(Cause::linking).cycle(Mode::FS, {}).size(), 1u);
  EXPECT_EQ(in_FS_with(Cause::roll_away).cycle(Mode::FS, {}, 10.0, {Ack::brake}).size(), 1u) << "it moves";
  Unit unit = in_FS_with(Cause::roll_away);
  unit.stand();
  EXPECT_EQ(unit.cycle(Mode::FS, {}, 0.0).size(), 1u) << "nobody has acknowledged";
  unit = in_FS_with(Cause::roll_away);
  unit.stand();
  EXPECT_TRUE(unit.cycle(Mode::FS, {}, 0.0, {Ack::brake}).empty());
  EXPECT_TRUE(unit.seen.contains("roll_away by standstill + brake acknowledged"));
  EXPECT_TRUE(unit.seen.contains("roll_away without brake acknowledged (standstill + brake acknowledged)"));
}

TEST(BrakeRules, A_speed_above_one_that_is_held_may_be_permitted) {  // 3.13.10.4.8.1 of 4.0.0
  const auto faults = [](SrsVersion srs, Monitoring monitoring, double V_P) {
    Unit unit;
    unit.memory.srs = srs;
    unit.out.monitoring = monitoring;
    unit.out.V_P = Speed{8.0};
    (void)unit.cycle(Mode::FS, {});
    (void)unit.cycle(Mode::FS, {Cause::overspeed_service});
    unit.out.V_P = Speed{V_P};
    return unit.cycle(Mode::FS, {}).size();
  };
  EXPECT_EQ(faults(SrsVersion::v4_0_0, Monitoring::TSM, 8.0), 0u);
  EXPECT_EQ(faults(SrsVersion::v4_0_0, Monitoring::TSM, 7.9), 1u) << "it is not held";
  EXPECT_EQ(faults(SrsVersion::v4_0_0, Monitoring::CSM, 8.0), 1u);
  EXPECT_EQ(faults(SrsVersion::v3_6_0, Monitoring::TSM, 8.0), 1u);
}

TEST(BrakeRules, Of_two_clauses_in_one_issue_and_of_one_in_another) {  // 3.14.1.5, 3.14.1.7.3
  const auto faults = [](SrsVersion srs) {
    Unit unit = in_FS_with(Cause::roll_away);
    unit.memory.srs = srs;
    (void)unit.cycle(Mode::FS, {Cause::roll_away, Cause::movement_while_entering_train_data});
    unit.stand();
    return unit.cycle(Mode::FS, {}, 0.0, {Ack::brake}).size();
  };
  EXPECT_EQ(faults(SrsVersion::v3_6_0), 1u);
  EXPECT_EQ(faults(SrsVersion::v4_0_0), 0u);
}

TEST(BrakeRules, A_command_that_does_not_end_is_a_fault) {
  Unit unit = in_FS_with(Cause::linking);
  unit.stand();
  EXPECT_EQ(unit.cycle(Mode::FS, {Cause::linking}, 0.0).size(), 1u);
  unit = in_FS_with(Cause::roll_away);
  unit.stand();
  EXPECT_EQ(unit.cycle(Mode::FS, {Cause::roll_away}, 0.0, {Ack::brake}).size(), 1u);
}

TEST(BrakeRules, One_acknowledgement_is_for_one_clause) {
  const Set<Cause> both{Cause::roll_away, Cause::train_data_changed};
  Unit unit;
  (void)unit.cycle(Mode::FS, both);
  unit.stand();
  EXPECT_EQ(unit.cycle(Mode::FS, {}, 0.0, {Ack::brake}).size(), 1u);
}

TEST(BrakeRules, A_mode_entry_does_what_4_12_says) {
  EXPECT_TRUE(in_FS_with(Cause::linking).cycle(Mode::OS, {Cause::linking}).empty());
  EXPECT_EQ(in_FS_with(Cause::linking).cycle(Mode::OS, {}).size(), 1u);
  EXPECT_TRUE(in_FS_with(Cause::roll_away).cycle(Mode::TR, {}).empty());
  EXPECT_EQ(in_FS_with(Cause::roll_away).cycle(Mode::TR, {Cause::roll_away}).size(), 1u);
  // A command that lasts as long as it is asked for may end one cycle later.
  Unit unit = in_FS_with(Cause::text_service);
  EXPECT_TRUE(unit.cycle(Mode::SH, {Cause::text_service}).empty());
  EXPECT_EQ(unit.cycle(Mode::SH, {Cause::text_service}).size(), 1u);
}

/// The faults of a unit of `srs` whose alarm of the balise antenna brakes in SH of `level` after `run` metres, and that
/// commands `after` once it is in mode `to`.
std::size_t faults_of_alarm(SrsVersion srs, Level level, Mode to, Set<Cause> after, double run = 0.0) {
  Unit unit;
  unit.memory.srs = srs;
  unit.out.level = level;
  (void)unit.cycle(Mode::SH, {});
  unit.in.train.antenna_alarm = true;
  (void)unit.cycle(Mode::SH, {});
  unit.in.odometry.max = unit.in.odometry.max + Distance{run};
  (void)unit.cycle(Mode::SH, {Cause::balise_antenna});
  const std::size_t at_once = unit.cycle(to, after).size();
  return at_once + unit.cycle(to, after).size();
}

TEST(BrakeRules, An_alarm_that_lasts_brakes_in_the_mode_that_is_entered_if_the_edition_says_so) {
  using enum SrsVersion;
  const Set<Cause> alarm{Cause::balise_antenna};
  for (const Mode ignored : {Mode::NP, Mode::SL, Mode::NL, Mode::RV})
    for (const SrsVersion srs : {v3_6_0, v4_0_0}) {
      EXPECT_EQ(faults_of_alarm(srs, Level::L1, ignored, {}), 0u);
      EXPECT_GT(faults_of_alarm(srs, Level::L1, ignored, alarm), 0u);
    }
  for (const Mode edition : {Mode::SB, Mode::PS}) {
    EXPECT_EQ(faults_of_alarm(v3_6_0, Level::L1, edition, alarm), 0u);
    EXPECT_GT(faults_of_alarm(v3_6_0, Level::L1, edition, {}), 0u);
    EXPECT_EQ(faults_of_alarm(v4_0_0, Level::L1, edition, {}), 0u);
    EXPECT_GT(faults_of_alarm(v4_0_0, Level::L1, edition, alarm), 0u);
  }
  EXPECT_EQ(faults_of_alarm(v4_0_0, Level::L0, Mode::SB, alarm, 310.0), 0u);  // 3.15.7.4: of levels 1 and 2
  EXPECT_GT(faults_of_alarm(v4_0_0, Level::L0, Mode::SB, {}, 310.0), 0u);
  EXPECT_EQ(faults_of_alarm(v3_6_0, Level::L1, Mode::FS, alarm), 0u);
  EXPECT_GT(faults_of_alarm(v3_6_0, Level::L1, Mode::FS, {}), 0u);
}

TEST(BrakeRules, A_mode_that_is_left_at_once_does_not_end_the_brake_of_an_alarm) {
  Unit unit;
  unit.out.level = Level::L1;
  (void)unit.cycle(Mode::RV, {});
  unit.in.train.antenna_alarm = true;
  (void)unit.cycle(Mode::RV, {}, 0.0);
  EXPECT_TRUE(unit.cycle(Mode::SB, {Cause::balise_antenna}, 0.0).empty());
  EXPECT_TRUE(unit.cycle(Mode::SL, {}, 0.0).empty());
}

TEST(BrakeRules, An_alarm_is_ignored_for_300_m_in_level_0) {  // 3.15.7.2
  const auto faults = [](double run, Set<Cause> after) {
    return faults_of_alarm(SrsVersion::v3_6_0, Level::L0, Mode::SH, after, run);
  };
  EXPECT_EQ(faults(290.0, {}), 0u);
  EXPECT_GT(faults(290.0, {Cause::balise_antenna}), 0u);
  EXPECT_EQ(faults(310.0, {Cause::balise_antenna}), 0u);
  EXPECT_GT(faults(310.0, {}), 0u);
}

TEST(BrakeRules, The_release_is_asked_of_a_train_that_stands) {
  Unit unit = in_FS_with(Cause::roll_away);
  unit.out.requests.add(Ack::brake);
  EXPECT_EQ(unit.cycle(Mode::FS, {Cause::roll_away}).size(), 1u);
}

}  // namespace
}  // namespace evc::brake_rules
