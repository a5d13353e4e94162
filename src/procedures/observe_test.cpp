#include "procedures/observe.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "modes/srs_4_6_2.h"
#include "procedures/staff_responsible.h"

// MC/DC of 4.6.3: for every condition the facts that make it true; inverting any single one makes it false.
namespace evc::procedures {
namespace {

struct Term {
  const char* what;
  std::function<void(Facts&)> make_true;
  std::function<void(Facts&)> make_false;
};
struct Case {
  int number;
  std::vector<Term> terms;
};

template <class T>
Term is(const char* what, T Facts::*fact, bool wanted = true) {
  return {what, [=](Facts& f) { f.*fact = wanted; }, [=](Facts& f) { f.*fact = !wanted; }};
}
Term level(Level good, Level bad) {
  return {"level", [=](Facts& f) { f.level = good; }, [=](Facts& f) { f.level = bad; }};
}
Term switched(Level good, Level bad) {
  return {"switch", [=](Facts& f) { f.level_switched_to = good; }, [=](Facts& f) { f.level_switched_to = bad; }};
}
Term switched(Level good) {
  return {"switch", [=](Facts& f) { f.level_switched_to = good; }, [](Facts& f) { f.level_switched_to.reset(); }};
}
Term requested(Ack ack) {
  return {"requested", [=](Facts& f) { f.requested.add(ack); }, [=](Facts& f) { f.requested.remove(ack); }};
}
Term acknowledged(Ack ack) {
  return {"acknowledged", [=](Facts& f) { f.acknowledged.add(ack); }, [=](Facts& f) { f.acknowledged.remove(ack); }};
}
Term standstill() { return is("standstill", &Facts::standstill); }
Term described() { return is("ma", &Facts::ma_ssp_gradient_stored); }
/// Whether 3.x has the condition.
bool in_3(int number) {
  for (const modes::Condition& row : modes::srs_4_6_3)
    if (row.number == number) return true;
  return false;
}
Term no_override() { return is("override", &Facts::override_active, false); }

std::vector<Case> cases() {
  using F = Facts;
  const auto ack = [](Ack a) { return std::vector<Term>{requested(a), acknowledged(a)}; };
  const auto with = [](std::vector<Term> a, std::vector<Term> b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  const std::vector<Term> full = {is("ma", &F::ma_ssp_gradient_stored), is("profile", &F::profile_in_force, false)};
  const std::vector<Term> trip_ack = with(ack(Ack::trip), {standstill()});
  return {
      {1, {is("isolated", &F::isolated)}},
      {2, {is("desk", &F::desk_open)}},
      {3, {is("sleeping", &F::sleeping, false), standstill()}},
      {4, {is("powered", &F::powered)}},
      {5, {standstill(), level(Level::L1, Level::L2), is("SH", &F::selects_SH)}},
      {5, {standstill(), level(Level::L0, Level::L3), is("SH", &F::selects_SH)}},
      {5, {standstill(), level(Level::NTC, Level::L2), is("SH", &F::selects_SH)}},
      {6, {standstill(), level(Level::L2, Level::L1), is("granted", &F::SH_granted)}},
      {6, {standstill(), level(Level::L3, Level::NTC), is("granted", &F::SH_granted)}},
      {7, with(trip_ack, {level(Level::L1, Level::L0)})},
      {7, with(trip_ack, {level(Level::L2, Level::NTC)})},
      {8, with(ack(Ack::SR), {level(Level::L1, Level::L0)})},
      {10, with(full, {is("train data", &F::train_data_valid)})},
      {12, {level(Level::L1, Level::L2), is("antenna", &F::min_safe_antenna_beyond_eoa)}},
      {13, {is("fault", &F::safety_fault)}},
      {14, {is("sleeping", &F::sleeping), standstill(), is("desk", &F::desk_open, false)}},
      {15, with(ack(Ack::OS), {level(Level::L2, Level::NTC)})},
      {16, {level(Level::L2, Level::L1), is("front", &F::min_safe_front_beyond_eoa)}},
      {16, {level(Level::L3, Level::L0), is("front", &F::min_safe_front_beyond_eoa)}},
      {17, {is("linking", &F::linking_reaction_trip)}},
      {18, {is("order", &F::trip_order), no_override()}},
      {19, {standstill(), is("exit", &F::selects_exit_SH)}},
      {20, {is("ues", &F::ues_accepted)}},
      {21, {switched(Level::L0, Level::L1)}},
      {22, {is("desk", &F::desk_open), is("stop", &F::stop_shunting_stored)}},
      {23, {is("desk", &F::desk_open), is("stop", &F::stop_shunting_stored, false)}},
      {25, with(full, {switched(Level::L1, Level::L0)})},
      {25, with(full, {switched(Level::L3, Level::NTC)})},
      {26,
       {is("desk", &F::desk_open, false), is("continue", &F::continue_shunting), is("passive", &F::passive_shunting)}},
      {27, {is("desk", &F::desk_open, false), is("continue", &F::continue_shunting, false)}},
      {28, {is("desk", &F::desk_open, false)}},
      {29, {is("powered", &F::powered, false)}},
      {30, {is("desk", &F::desk_open, false), is("passive", &F::passive_shunting, false)}},
      {31, with(full, {level(Level::L2, Level::L1)})},
      {32, with(full, {level(Level::L1, Level::L2), is("trip order", &F::ma_with_trip_order, false)})},
      {34, {switched(Level::L2, Level::L0), is("OS", &F::profile_demands_OS)}},
      {35, {is("SH", &F::selects_SH), is("national trip", &F::national_trip)}},
      {36, {is("group", &F::group_passed_not_in_SR_list), no_override()}},
      {37, {level(Level::L2, Level::L0), is("override", &F::selects_override)}},
      {38, {switched(Level::L0, Level::NTC), is("national trip", &F::national_trip)}},
      {38, {switched(Level::L2), is("national trip", &F::national_trip)}},
      {39,
       {switched(Level::L1, Level::L0),
        {"ma", [](F&) {}, [](F& f) { f.ma_accepted = f.ma_ssp_gradient_stored = true; }}}},
      {40, {is("OS", &F::profile_demands_OS)}},
      {41, {is("T_NVCONTACT", &F::T_NVCONTACT_trip)}},
      {42, {is("distance", &F::SR_distance_passed), no_override()}},
      {43, {is("former eoa", &F::former_eoa_passed), no_override()}},
      {44, {switched(Level::L1, Level::L2), is("override", &F::override_active)}},
      {45, {switched(Level::L3, Level::L1), is("override", &F::override_active), is("ues", &F::ues_received, false)}},
      {46, {standstill(), is("signal", &F::non_leading), is("NL", &F::selects_NL)}},
      {47, {standstill(), is("signal", &F::non_leading, false)}},
      {49, {is("stop", &F::stop_if_in_SH), no_override()}},
      {50, ack(Ack::SH)},
      {51, {is("SH", &F::profile_demands_SH)}},
      {52, {is("group", &F::group_passed_not_in_SH_list), no_override()}},
      {54, {is("stop", &F::stop_if_in_SR), is("listed", &F::group_passed_in_SR_list, false), no_override()}},
      {56, {switched(Level::NTC, Level::L0), is("same", &F::level_order_changed_national_system_only, false)}},
      {58, with(ack(Ack::SN), {level(Level::NTC, Level::L0)})},
      {59, with(ack(Ack::RV), {standstill(), level(Level::L2, Level::L0)})},
      {60, with(ack(Ack::UN), {level(Level::L0, Level::L1)})},
      {61, {switched(Level::L1, Level::NTC), is("SH", &F::profile_demands_SH)}},
      {62, with(trip_ack, {level(Level::L0, Level::L1), is("train data", &F::train_data_valid)})},
      {63, with(trip_ack, {level(Level::NTC, Level::L0), is("train data", &F::train_data_valid)})},
      {65, {level(Level::L1, Level::L0), is("version", &F::telegram_version_too_high)}},
      {65, {level(Level::L3, Level::NTC), is("version", &F::telegram_version_too_high)}},
      {66, {is("direction", &F::linked_group_wrong_direction)}},
      {67, {switched(Level::L1, Level::L2), is("order", &F::trip_order), no_override()}},
      {68, with(trip_ack, {level(Level::L0, Level::L1), is("train data", &F::train_data_valid, false)})},
      {68, with(trip_ack, {level(Level::NTC, Level::L2), is("train data", &F::train_data_valid, false)})},
      {69, {is("description", &F::front_in_rear_of_track_description)}},
      {70, with(ack(Ack::LS), {level(Level::L1, Level::NTC)})},
      {71, {switched(Level::L2, Level::L0), is("LS", &F::profile_demands_LS)}},
      {72, {is("LS", &F::profile_demands_LS)}},
      {73, {is("OS", &F::profile_demands_OS), is("ack area", &F::front_in_LS_ack_area, false)}},
      {74, {is("LS", &F::profile_demands_LS), is("ack area", &F::front_in_OS_ack_area, false)}},
      // 4.0.0
      {9, {described(), is("level crossing", &F::level_crossing_approach_shown)}},
      {11, {level(Level::L2, Level::L1), is("group", &F::group_at_eoa_in_RSM)}},
      {24, {described(), is("brake", &F::brake_commanded)}},
      {33, {described(), is("AD", &F::AD_requested, false)}},
      {48, {described(), is("whole train", &F::described_for_whole_train, false)}},
      {53, {described(), is("disengaged", &F::ATO_disengaged)}},
      {75, {is("ack area", &F::front_in_OS_ack_area, false), is("profile", &F::profile_in_force, false)}},
      {76, {is("ack area", &F::front_in_LS_ack_area, false), is("profile", &F::profile_in_force, false)}},
      {77, {switched(Level::L0, Level::NTC), is("train data", &F::train_data_valid)}},
      {78, {switched(Level::L0, Level::L1), is("train data", &F::train_data_valid, false)}},
      {78, {switched(Level::NTC, Level::L2), is("train data", &F::train_data_valid, false)}},
      {79, {switched(Level::NTC, Level::L0), is("train data", &F::train_data_valid)}},
      {80,
       {is("AD", &F::AD_requested), is("whole train", &F::described_for_whole_train),
        is("brake", &F::brake_commanded, false), is("engaged", &F::selects_ATO_engage)}},
      {81, {is("authorised", &F::SM_authorised)}},
      {82, {is("exit", &F::selects_exit_SM), standstill()}},
      {83, {is("train data", &F::train_data_valid), is("consist", &F::consist_in_front)}},
      {84, {is("odometer", &F::odometer_beyond_threshold)}},
  };
}

TEST(Observe, Every_term_of_every_condition_decides) {
  for (const Case& c : cases()) {
    Facts facts;
    facts.powered = c.number != 29;
    for (const Term& t : c.terms) t.make_true(facts);
    EXPECT_TRUE(observe(facts, SrsVersion::v4_0_0).test(c.number)) << c.number;
    EXPECT_EQ(observe(facts).test(c.number), in_3(c.number)) << c.number;
    for (const Term& t : c.terms) {
      Facts without = facts;
      t.make_false(without);
      EXPECT_FALSE(observe(without, SrsVersion::v4_0_0).test(c.number)) << c.number << " without " << t.what;
    }
  }
}

TEST(Observe, Every_condition_of_the_standard_has_a_case_and_no_other_is_set) {
  modes::Conditions covered;
  for (const Case& c : cases()) covered.set(c.number);
  for (const modes::Condition& row : modes::srs_4_6_3) EXPECT_TRUE(covered.test(row.number)) << int{row.number};
  for (const modes::Condition& row : modes::srs_4_6_3_v400) EXPECT_TRUE(covered.test(row.number)) << int{row.number};
  for (int n = 0; n < modes::Conditions::kNumbers; ++n)
    if (modes::meaning(n) == nullptr) {
      for (const Case& c : cases()) {
        Facts facts;
        for (const Term& t : c.terms) t.make_true(facts);
        EXPECT_FALSE(observe(facts, SrsVersion::v4_0_0).test(n)) << n;
      }
    }
}

TEST(Observe, A_mode_entered_by_an_early_acknowledgement_is_not_left_for_FS) {
  Facts f;
  f.level = Level::L2;
  f.ma_ssp_gradient_stored = true;
  EXPECT_TRUE(observe(f).test(31));
  f.mode_is_OS = f.front_in_OS_ack_area = true;
  EXPECT_FALSE(observe(f).test(31));
  EXPECT_TRUE(observe(f).test(10) == false);  // without train data
  f.mode_is_OS = false;
  EXPECT_TRUE(observe(f).test(31));
  f.mode_is_LS = f.front_in_LS_ack_area = true;
  EXPECT_FALSE(observe(f).test(31));
  f.level = Level::L1;
  EXPECT_FALSE(observe(f).test(32));
}

TEST(Observe, An_MA_without_a_description_under_the_train_is_none_at_the_border) {
  Facts f;
  f.level = Level::L2;
  f.level_switched_to = Level::L2;
  f.ma_accepted = true;
  EXPECT_TRUE(observe(f).test(39));
}

TEST(Observe, From_one_national_system_to_another_SN_stays) {
  Facts f;
  f.level = Level::NTC;
  f.level_switched_to = Level::NTC;
  f.level_order_changed_national_system_only = true;
  f.desk_open = true;
  EXPECT_FALSE(modes::next_mode(Mode::SN, observe(f)).has_value());
}

TEST(StaffResponsible, Distance) {
  using namespace staff_responsible;
  const Place end{Distance{100.0}};
  EXPECT_FALSE(distance_passed(std::nullopt, end));
  EXPECT_FALSE(distance_passed(end, end));
  EXPECT_TRUE(distance_passed(end, Place{Distance{100.1}}));
}

}  // namespace
}  // namespace evc::procedures
