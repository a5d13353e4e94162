#include "explain/why.h"

#include <gtest/gtest.h>

#include <random>

#include "explain/words.h"

namespace evc::explain {
namespace {

const Reason& reason(const Reasons& all, int number) {
  for (const Reason& r : all)
    if (r.number == number) return r;
  ADD_FAILURE() << "no condition " << number;
  return all[0];
}

TEST(Why, every_condition_in_the_order_of_the_standard) {
  EXPECT_EQ(reasons(procedures::Facts{}).size(), modes::srs_4_6_3.size());
  const Reasons all = reasons(procedures::Facts{}, SrsVersion::v4_0_0);
  ASSERT_EQ(all.size(), modes::srs_4_6_3.size() + modes::srs_4_6_3_v400.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t n = modes::srs_4_6_3.size();
    EXPECT_EQ(all[i].number, i < n ? modes::srs_4_6_3[i].number : modes::srs_4_6_3_v400[i - n].number);
    EXPECT_FALSE(all[i].because.empty()) << int{all[i].number};
    EXPECT_LT(all[i].because.size(), Literals::capacity()) << int{all[i].number};
  }
}

procedures::Facts any_facts(std::mt19937& random) {
  const auto coin = [&random] { return (random() & 1u) != 0; };
  procedures::Facts f;
  // The first member up to the last one, each by its name where it is not a flag.
  bool* const flags[] = {&f.isolated,
                         &f.powered,
                         &f.desk_open,
                         &f.standstill,
                         &f.sleeping,
                         &f.non_leading,
                         &f.passive_shunting,
                         &f.safety_fault,
                         &f.selects_SH,
                         &f.selects_exit_SH,
                         &f.selects_NL,
                         &f.selects_override,
                         &f.train_data_valid,
                         &f.ma_ssp_gradient_stored,
                         &f.ma_accepted,
                         &f.ma_with_trip_order,
                         &f.profile_demands_OS,
                         &f.profile_demands_LS,
                         &f.profile_demands_SH,
                         &f.profile_in_force,
                         &f.front_in_OS_ack_area,
                         &f.front_in_LS_ack_area,
                         &f.mode_is_OS,
                         &f.mode_is_LS,
                         &f.min_safe_antenna_beyond_eoa,
                         &f.min_safe_front_beyond_eoa,
                         &f.group_at_eoa_in_RSM,
                         &f.front_in_rear_of_track_description,
                         &f.linking_reaction_trip,
                         &f.linked_group_wrong_direction,
                         &f.telegram_version_too_high,
                         &f.trip_order,
                         &f.stop_if_in_SH,
                         &f.stop_if_in_SR,
                         &f.group_passed_not_in_SH_list,
                         &f.group_passed_not_in_SR_list,
                         &f.group_passed_in_SR_list,
                         &f.ues_accepted,
                         &f.ues_received,
                         &f.T_NVCONTACT_trip,
                         &f.SH_granted,
                         &f.override_active,
                         &f.former_eoa_passed,
                         &f.SR_distance_passed,
                         &f.continue_shunting,
                         &f.stop_shunting_stored,
                         &f.national_trip,
                         &f.level_order_changed_national_system_only};
  for (bool* flag : flags) *flag = coin();
  f.level = static_cast<Level>(random() % kLevels);
  if (coin()) f.level_switched_to = f.level;
  for (unsigned a = 0; a < static_cast<unsigned>(Ack::count); ++a) {
    f.acknowledged.add(static_cast<Ack>(a), coin());
    f.requested.add(static_cast<Ack>(a), coin());
  }
  return f;
}

TEST(Why, says_what_observe_says) {
  std::mt19937 random(1);
  for (int n = 0; n < 2000; ++n) {
    const procedures::Facts facts = any_facts(random);
    const modes::Conditions observed = procedures::observe(facts);
    for (const Reason& r : reasons(facts)) {
      ASSERT_EQ(r.holds, observed.test(r.number)) << int{r.number};
      ASSERT_LT(r.because.size(), Literals::capacity()) << int{r.number};  // none was left out
    }
  }
}

TEST(Why, the_false_terms_of_a_condition) {
  procedures::Facts f;
  f.level = Level::L2;
  f.ma_ssp_gradient_stored = true;
  f.profile_in_force = true;
  f.mode_is_OS = f.front_in_OS_ack_area = true;
  const Reasons all = reasons(f);
  const Reason& to_FS = reason(all, 31);
  EXPECT_FALSE(to_FS.holds);
  ASSERT_EQ(to_FS.because.size(), 3u);
  EXPECT_EQ(to_FS.because[0], (Literal{Fact::profile_in_force, true, {}, 0}));
  // Of these either one has to change.
  EXPECT_EQ(to_FS.because[1], (Literal{Fact::mode_is_OS, true, {}, 1}));
  EXPECT_EQ(to_FS.because[2], (Literal{Fact::front_in_OS_ack_area, true, {}, 1}));
}

TEST(Why, an_alternative_that_is_missing) {
  procedures::Facts f;
  f.level = Level::L2;
  const Reasons all = reasons(f, SrsVersion::v4_0_0);
  const Reason& to_SH = reason(all, 78);
  ASSERT_EQ(to_SH.because.size(), 2u);
  EXPECT_EQ(to_SH.because[0].choice, to_SH.because[1].choice);
}

TEST(Why, the_terms_of_a_condition_that_holds) {
  procedures::Facts f;
  f.level = Level::L1;
  f.standstill = f.selects_SH = true;
  const Reasons all = reasons(f);
  const Reason& shunting = reason(all, 5);
  EXPECT_TRUE(shunting.holds);
  ASSERT_EQ(shunting.because.size(), 3u);
  EXPECT_EQ(shunting.because[2].fact, Fact::selects_SH);
}

// "or" is what / says: what holds together is joined by "and".
TEST(Why, the_words_of_a_condition) {
  procedures::Facts f;
  f.level = Level::L1;
  f.standstill = true;
  EXPECT_EQ(words(reason(reasons(f), 5)), "shunting not selected");
  f.selects_SH = true;
  EXPECT_EQ(words(reason(reasons(f), 5)), "standstill and level 1 and shunting selected");
  f.level = Level::L2;
  EXPECT_EQ(words(reason(reasons(f), 5)), "level 1, 2 or 3 / not level 1");
}

TEST(Why, an_acknowledgement_is_named) {
  procedures::Facts f;
  f.level = Level::L1;
  f.requested.add(Ack::OS);
  const Reasons all = reasons(f);
  const Reason& on_sight = reason(all, 15);
  ASSERT_EQ(on_sight.because.size(), 1u);
  EXPECT_EQ(on_sight.because[0], (Literal{Fact::acknowledged, false, Ack::OS, 0}));
}

}  // namespace
}  // namespace evc::explain
