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

TEST(BrakeRules, The_release_is_asked_of_a_train_that_stands) {
  Unit unit = in_FS_with(Cause::roll_away);
  unit.out.requests.add(Ack::brake);
  EXPECT_EQ(unit.cycle(Mode::FS, {Cause::roll_away}).size(), 1u);
}

}  // namespace
}  // namespace evc::brake_rules
