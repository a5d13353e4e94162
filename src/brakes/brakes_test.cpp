#include "brakes/brakes.h"

#include <gtest/gtest.h>

#include <string>

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
  State state;
  command(state, {Cause::linking}, moving());
  EXPECT_TRUE(command(state, {Cause::linking}, standing()).reasons.empty());
  EXPECT_TRUE(command(state, {Cause::linking}, moving()).reasons.empty());
  command(state, {}, moving());
  EXPECT_TRUE(command(state, {Cause::linking}, moving()).sb);
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

TEST(Brakes, Two_causes_of_one_brake_release_it_only_together) {
  State state;
  command(state, {Cause::roll_away, Cause::trip}, moving());
  EXPECT_TRUE(command(state, {Cause::trip}, acknowledging()).eb);
  EXPECT_FALSE(command(state, {}, standing()).eb);
  command(state, {Cause::roll_away, Cause::overspeed_emergency}, moving());
  EXPECT_TRUE(command(state, {}, standing()).eb);  // the overspeed has ended, the roll away waits for the driver
}

TEST(Brakes, The_emergency_brake_takes_the_place_of_a_service_brake_that_fails_or_is_not_there) {
  State state;
  Context failed = moving();
  failed.service_brake_failed = true;
  const Command a = command(state, {Cause::overspeed_service}, failed);
  EXPECT_TRUE(a.sb && a.eb);
  EXPECT_FALSE(command(state, {}, failed).eb);
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

TEST(Brakes, Reasons_and_clauses_are_there) {
  for (const CauseRow& r : srs_3_14_1) {
    EXPECT_FALSE(std::string(name(r.cause)).empty());
    EXPECT_TRUE(static_cast<bool>(r.clause));
  }
}

}  // namespace
}  // namespace evc::brakes
