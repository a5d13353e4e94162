#include "brakes/brakes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "base/test_paths.h"

namespace evc::brakes {
namespace {

using enum Mode;

Context moving() { return {}; }
Context standing() {
  Context c;
  c.standstill = true;
  return c;
}
Context acknowledging() {
  Context c = standing();
  c.driver_acknowledges = true;
  return c;
}

TEST(Brakes, Every_cause_alone_commands_its_kind_and_names_itself) {
  for (const CauseRow& r : srs_3_14_1) {
    State state;
    const Command got = command(state, {r.cause}, moving());
    EXPECT_EQ(got.tco, r.kind == Kind::traction_cut_off) << name(r.cause);
    EXPECT_EQ(got.sb, r.kind == Kind::service_brake) << name(r.cause);
    EXPECT_EQ(got.eb, r.kind == Kind::emergency_brake) << name(r.cause);
    EXPECT_EQ(got.reasons, CauseSet{r.cause});
    EXPECT_FALSE(got.acknowledgement_wanted);
    EXPECT_EQ(&row(r.cause), &r);
  }
}

// For every rule: does the command of a cause that asked for one cycle last?
TEST(Brakes, Every_cause_is_released_by_its_own_rule_and_by_nothing_less) {
  for (const CauseRow& r : srs_3_14_1) {
    const auto left_after = [&](Context context, bool still_asked) {
      State state;
      command(state, {r.cause}, moving());
      return !command(state, still_asked ? CauseSet{r.cause} : CauseSet{}, context).reasons.empty();
    };
    Context message = moving();
    message.new_consistent_message = true;
    Context ack_while_moving = moving();
    ack_while_moving.driver_acknowledges = true;
    const Release rule = r.release;
    const bool gone = rule == Release::when_gone || rule == Release::gone_or_acknowledged_at_standstill;
    const bool stop = rule == Release::at_standstill || rule == Release::at_standstill_or_message;
    const bool ack = rule == Release::acknowledged_at_standstill || rule == Release::gone_or_acknowledged_at_standstill;
    EXPECT_EQ(left_after(moving(), false), !gone) << name(r.cause);
    EXPECT_EQ(left_after(standing(), false), !gone && !stop) << name(r.cause);
    EXPECT_EQ(left_after(standing(), true), !stop) << name(r.cause);
    EXPECT_EQ(left_after(ack_while_moving, false), !gone) << name(r.cause);
    EXPECT_EQ(left_after(acknowledging(), true), !ack && !stop) << name(r.cause);
    EXPECT_EQ(left_after(message, false), !gone && rule != Release::at_standstill_or_message) << name(r.cause);
  }
}

TEST(Brakes, A_released_command_comes_back_with_a_new_occurrence_only) {
  for (const Cause cause : {Cause::linking, Cause::consist_length}) {
    State state;
    command(state, {cause}, moving());
    EXPECT_TRUE(command(state, {cause}, standing()).reasons.empty());
    EXPECT_TRUE(command(state, {cause}, moving()).reasons.empty());
    command(state, {}, moving());
    EXPECT_TRUE(command(state, {cause}, moving()).sb);
  }
}

TEST(Brakes, Beyond_a_distance_every_further_movement_brakes_again) {
  for (const Cause cause : {Cause::post_trip_distance, Cause::reversing_distance, Cause::roll_away,
                            Cause::reverse_movement, Cause::standstill}) {
    State state;
    command(state, {cause}, moving());
    EXPECT_FALSE(command(state, {cause}, standing()).reasons.empty());
    EXPECT_TRUE(command(state, {cause}, acknowledging()).reasons.empty());
    EXPECT_TRUE(command(state, {cause}, standing()).reasons.empty());
    EXPECT_FALSE(command(state, {cause}, moving()).reasons.empty());
  }
}

TEST(Brakes, The_acknowledgement_is_wanted_once_the_train_stands) {
  State state;
  EXPECT_FALSE(command(state, {Cause::roll_away}, moving()).acknowledgement_wanted);
  EXPECT_TRUE(command(state, {}, standing()).acknowledgement_wanted);
  const Command after = command(state, {}, acknowledging());
  EXPECT_FALSE(after.acknowledgement_wanted);
  EXPECT_FALSE(after.eb);
}

TEST(Brakes, One_acknowledgement_is_for_the_causes_of_one_clause) {
  State state;
  command(state, {Cause::roll_away, Cause::reverse_movement, Cause::post_trip_distance}, moving());
  const Command first = command(state, {}, acknowledging());  // 3.14.1.5
  EXPECT_EQ(first.reasons, CauseSet{Cause::post_trip_distance});
  EXPECT_TRUE(first.acknowledgement_wanted);
  EXPECT_TRUE(command(state, {}, acknowledging()).reasons.empty());  // 3.14.1.7.4
}

TEST(Brakes, Movement_while_data_are_entered_is_in_another_clause_in_4_0_0) {  // 3.14.1.5, 3.14.1.7.3
  for (const Cause cause : {Cause::movement_while_entering_train_data, Cause::movement_while_entering_SR_data}) {
    const auto left_in = [&](SrsVersion srs) {
      State state;
      command(state, {Cause::roll_away, cause}, moving());
      Context c = acknowledging();
      c.srs = srs;
      EXPECT_EQ(acknowledged_causes(state, srs).has(cause), srs == SrsVersion::v4_0_0);
      return command(state, {}, c).reasons;
    };
    EXPECT_EQ(left_in(SrsVersion::v3_4_0), CauseSet{cause});
    EXPECT_EQ(left_in(SrsVersion::v3_6_0), CauseSet{cause});
    EXPECT_EQ(left_in(SrsVersion::v4_0_0), CauseSet{});
  }
}

TEST(Brakes, Two_causes_of_one_brake_release_it_only_together) {
  State state;
  command(state, {Cause::roll_away, Cause::trip}, moving());
  EXPECT_TRUE(command(state, {Cause::trip}, acknowledging()).eb);
  EXPECT_FALSE(command(state, {}, standing()).eb);
  command(state, {Cause::roll_away, Cause::overspeed_emergency}, moving());
  EXPECT_TRUE(command(state, {}, standing()).eb);  // the overspeed has ended, the roll away waits for the driver
}

/// Whether the emergency brake is commanded `s` seconds after power-up, with the service brake asked for.
bool emergency_at(State& state, double s, std::optional<ServiceBrakeFeedback> feedback) {
  Context c = moving();
  c.now = Duration{s};
  c.T_bs = Duration{3.0};
  c.feedback = feedback;
  return command(state, {Cause::overspeed_service}, c).eb;
}

TEST(Brakes, The_emergency_brake_takes_the_place_of_a_service_brake_that_fails) {
  State state;
  const ServiceBrakeFeedback silent{}, full{false, 500.0}, fallen{false, 470.0}, almost{false, 470.5};
  EXPECT_FALSE(emergency_at(state, 10.0, silent));
  EXPECT_FALSE(emergency_at(state, 13.0, silent));
  EXPECT_TRUE(emergency_at(state, 13.1, silent));
  EXPECT_TRUE(emergency_at(state, 13.2, ServiceBrakeFeedback{true, {}}));  // until the command ends
  EXPECT_FALSE(command(state, {}, moving()).eb);
  EXPECT_FALSE(emergency_at(state, 20.0, full));
  EXPECT_FALSE(emergency_at(state, 24.0, fallen));
  EXPECT_TRUE(emergency_at(state, 24.1, almost));
  EXPECT_FALSE(command(state, {}, moving()).sb);
  EXPECT_FALSE(emergency_at(state, 30.0, ServiceBrakeFeedback{true, {}}));
  EXPECT_FALSE(emergency_at(state, 40.0, ServiceBrakeFeedback{true, {}}));
  EXPECT_TRUE(emergency_at(state, 40.1, silent));  // it has let go
  State untold;
  EXPECT_FALSE(emergency_at(untold, 10.0, {}));
  EXPECT_FALSE(emergency_at(untold, 60.0, {}));
}

/// Whether the service brake counts as applied when the pressure was `braked` at the command and stays there; before,
/// a released brake had `released`.
bool applied_at(std::optional<double> released, double braked) {
  State state;
  Context c = moving();
  c.feedback = ServiceBrakeFeedback{false, released};
  (void)command(state, {}, c);
  EXPECT_FALSE(emergency_at(state, 10.0, ServiceBrakeFeedback{false, braked}));
  return !emergency_at(state, 13.1, ServiceBrakeFeedback{false, braked});
}

TEST(Brakes, A_service_brake_that_was_applied_before_its_command_has_not_failed) {  // 3.14.1.2
  EXPECT_TRUE(applied_at(500.0, 380.0));
  EXPECT_FALSE(applied_at(500.0, 380.5)) << "the driver brakes, but not fully";
  EXPECT_TRUE(applied_at(400.0, 280.0));
  EXPECT_FALSE(applied_at(400.0, 280.5));
  EXPECT_FALSE(applied_at(540.0, 380.5)) << "an overcharged pipe";
  EXPECT_TRUE(applied_at({}, 380.0)) << "never released: the nominal pressure counts";
  EXPECT_TRUE(applied_at(399.0, 380.0));
}

TEST(Brakes, The_emergency_brake_takes_the_place_of_a_service_brake_that_is_not_there) {
  State state;
  Context none = moving();
  none.service_brake_fitted = false;
  none.traction_cut_off_fitted = false;
  const Command b = command(state, {Cause::linking, Cause::overspeed_traction}, none);
  EXPECT_TRUE(b.eb && !b.sb && !b.tco);
}

TEST(Brakes, Mode_entries_revoke_what_4_12_says) {
  EXPECT_TRUE(revoked_on_mode_entry(Cause::roll_away, TR, FS));
  EXPECT_FALSE(revoked_on_mode_entry(Cause::roll_away, SR, FS));
  EXPECT_FALSE(revoked_on_mode_entry(Cause::reverse_movement, SR, FS));
  EXPECT_TRUE(revoked_on_mode_entry(Cause::reverse_movement, SR, PT));
  EXPECT_FALSE(revoked_on_mode_entry(Cause::trip, PT, TR));
  for (const CauseRow& r : srs_3_14_1)
    if (r.release != Release::when_gone) {
      EXPECT_TRUE(revoked_on_mode_entry(r.cause, NP, FS)) << name(r.cause);
      EXPECT_TRUE(revoked_on_mode_entry(r.cause, SB, FS)) << name(r.cause);
    }
  State state;
  command(state, {Cause::T_NVCONTACT, Cause::linking}, moving());
  on_mode_entry(state, SR, FS);
  EXPECT_EQ(command(state, {}, moving()).reasons, CauseSet{Cause::linking});
}

/// The causes of tests/reference/brake_causes.json, in the order of the table.
nlohmann::json reference() {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/brake_causes.json");
  return nlohmann::json::parse(in);
}

/// The marks of 4.12 by mode; a grey cell has the mark that was chosen for it.
std::array<char, kModes> marks_of(const nlohmann::json& file, const nlohmann::json& cause) {
  std::array<char, kModes> marks{};
  std::istringstream cells(cause.at("on_entry").get<std::string>());
  for (const auto& column : file["_meta"]["columns"]) {
    std::string mark;
    cells >> mark;
    if (mark == "-") {
      const auto& revoked = cause.at("grey_revoked");
      mark = std::find(revoked.begin(), revoked.end(), column) != revoked.end() ? "R" : "M";
    }
    for (std::size_t m = 0; m < kModes; ++m)
      if (column == name(static_cast<Mode>(m))) marks[m] = mark[0];
  }
  return marks;
}

TEST(Brakes, Every_cause_has_the_brake_and_the_rule_of_the_standard) {
  const nlohmann::json file = reference();
  ASSERT_EQ(file["causes"].size(), kCauses);
  const std::map<Kind, std::string> kinds{
      {Kind::traction_cut_off, "TCO"}, {Kind::service_brake, "SB"}, {Kind::emergency_brake, "EB"}};
  for (const CauseRow& r : srs_3_14_1) {
    const auto& cause = file["causes"][terms::index(r.cause)];
    EXPECT_EQ(cause["name"], name(r.cause));
    EXPECT_EQ(cause["brake"], kinds.at(r.kind)) << name(r.cause);
    EXPECT_EQ(clause_of(r.cause, SrsVersion::v4_0_0) != r.clause, cause.contains("clause_4_0_0")) << name(r.cause);
    if (r.release == Release::when_gone) continue;
    const auto has = [&](const nlohmann::json& way) {
      const auto& ways = cause["release"];
      return std::find(ways.begin(), ways.end(), way) != ways.end();
    };
    const bool acknowledged =
        r.release == Release::acknowledged_at_standstill || r.release == Release::gone_or_acknowledged_at_standstill;
    EXPECT_EQ(has({"standstill", "brake acknowledged"}), acknowledged) << name(r.cause);
    EXPECT_EQ(has({"standstill"}), !acknowledged) << name(r.cause);
    EXPECT_EQ(has({"message from the RBC"}), r.release == Release::at_standstill_or_message) << name(r.cause);
  }
}

/// 4.12, cell by cell. What is evaluated again, and what its room stops asking for, no mode entry revokes here.
TEST(Brakes, Every_mode_entry_revokes_what_4_12_says) {
  const nlohmann::json file = reference();
  for (const CauseRow& r : srs_3_14_1) {
    std::array<char, kModes> marks{};
    if (r.release != Release::when_gone) marks = marks_of(file, file["causes"][terms::index(r.cause)]);
    for (std::size_t to = 0; to < kModes; ++to)
      for (std::size_t from = 0; from < kModes; ++from) {
        const Mode entered = static_cast<Mode>(to), left = static_cast<Mode>(from);
        EXPECT_EQ(revoked_on_mode_entry(r.cause, entered, left), marks[to] == 'R' || (marks[to] == 'P' && left == PT))
            << name(r.cause) << " " << name(left) << " to " << name(entered);
      }
  }
}

TEST(Brakes, Reasons_and_clauses_are_there) {
  for (const CauseRow& r : srs_3_14_1) {
    EXPECT_FALSE(std::string(name(r.cause)).empty());
    EXPECT_TRUE(static_cast<bool>(r.clause));
  }
}

}  // namespace
}  // namespace evc::brakes
