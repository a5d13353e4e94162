#include <gtest/gtest.h>

#include "modes/acceptance.h"
#include "modes/conditions.h"
#include "modes/levels.h"
#include "modes/mode_properties.h"

// What a context that nobody filled in says, what stands next to a special case, and sets beyond the first 64 bits.
namespace evc::modes {
namespace {

AcceptanceContext unprepared(Mode mode, Level level, Medium medium, SrsVersion srs = SrsVersion::v3_6_0) {
  AcceptanceContext c;
  c.mode = mode;
  c.level = level;
  c.medium = medium;
  c.srs = srs;
  return c;
}

TEST(AcceptanceEdges, What_nobody_set_is_absent) {
  const AcceptanceContext unset;
  EXPECT_EQ(unset.mode, Mode::NP);
  EXPECT_EQ(unset.medium, Medium::balise);
  EXPECT_EQ(accept_by_level(Information::national_values, unset).verdict, Verdict::accepted);
  EXPECT_EQ(accept_by_level(Information::movement_authority, unset).verdict, Verdict::rejected) << "level 0";
  EXPECT_EQ(Acceptance{}.verdict, Verdict::rejected);
  // 4.8.3: [4] SSP and gradient do not cover the MA; [11] no order along; [14] the RBC of no transition.
  const AcceptanceContext balise_1 = unprepared(Mode::FS, Level::L1, Medium::balise);
  EXPECT_EQ(accept_by_level(Information::movement_authority, balise_1).clause, "4.8.3 [4]"_srs);
  // 4.8.4: [2] the desk is closed, [4] no valid train data.
  AcceptanceContext sb = unprepared(Mode::SB, Level::L1, Medium::balise);
  EXPECT_EQ(accept_by_mode(Information::stm_max_speed, sb).clause, "4.8.4 [2]"_srs);
  sb.desk_open = true;
  EXPECT_EQ(accept_by_mode(Information::stm_max_speed, sb).verdict, Verdict::accepted);
  // 4.8.4 [3]: in PS and SH an order to establish a session is one only where it says so.
  for (const Mode mode : {Mode::PS, Mode::SH}) {
    AcceptanceContext c = unprepared(mode, Level::L2, Medium::balise);
    EXPECT_EQ(accept_by_mode(Information::session_management, c).verdict, Verdict::accepted);
    c.orders_establishment = true;
    EXPECT_EQ(accept_by_mode(Information::session_management, c).verdict, Verdict::only_contact_stored);
  }
}

/// Flags of the context of which each information of the row and mode depends on one: without it the exception holds.
TEST(AcceptanceEdges, Each_fact_that_lets_an_information_pass_is_absent_unless_it_is_set) {
  struct Flag {
    bool AcceptanceContext::*fact;
    bool passes_when;  // the value that lets the information pass
    Clause exception;
  };
  const Flag flags[] = {
      {&AcceptanceContext::described_over_whole_ma, true, "4.8.3 [4]"_srs},
      {&AcceptanceContext::emergency_stop_pending, false, "4.8.3 [5]"_srs},
      {&AcceptanceContext::revocable_and_inhibited, false, "4.8.3 [8]"_srs},
      {&AcceptanceContext::other_previous_lrbg, false, "4.8.3 [10]"_srs},
      {&AcceptanceContext::level_order_along_or_announced, false, "4.8.3 [11]"_srs},
      {&AcceptanceContext::names_rbc_of_transition, false, "4.8.3 [14]"_srs},
      {&AcceptanceContext::text_awaits_acknowledgement, false, "4.8.3 [12]"_srs},
      {&AcceptanceContext::train_data_valid, true, "4.8.4 [4]"_srs},
      {&AcceptanceContext::override_active, false, "4.8.4 [6]"_srs},
      {&AcceptanceContext::null_distance, true, "4.8.4 [8]"_srs},
      {&AcceptanceContext::front_in_ls_area_of_message, true, "4.8.4 [9]"_srs},
  };
  const AcceptanceContext unset;
  for (const Flag& flag : flags) {
    EXPECT_FALSE(unset.*flag.fact) << &flag - flags;
    int met = 0;
    for (std::size_t i = 0; i < kInformation; ++i)
      for (const Level level : {Level::L1, Level::L2})
        for (const Medium medium : {Medium::balise, Medium::rbc})
          for (std::size_t m = 0; m < kModes; ++m) {
            const Information information = static_cast<Information>(i);
            AcceptanceContext c = unprepared(static_cast<Mode>(m), level, medium);
            c.desk_open = true;
            c.*flag.fact = flag.passes_when;
            EXPECT_NE(accept_by_level(information, c).clause, flag.exception);
            EXPECT_FALSE(accept_by_mode(information, c).clause == flag.exception &&
                         accept_by_mode(information, c).verdict == Verdict::rejected);
            c.*flag.fact = !flag.passes_when;
            met += accept_by_level(information, c).clause == flag.exception ||
                   (accept_by_mode(information, c).clause == flag.exception &&
                    accept_by_mode(information, c).verdict == Verdict::rejected);
          }
    EXPECT_GT(met, 0) << &flag - flags;
  }
}

TEST(AcceptanceEdges, Of_the_former_RBC_only_the_end_of_its_session_counts) {  // 3.15.1.3
  for (std::size_t i = 0; i < kInformation; ++i) {
    AcceptanceContext c = unprepared(Mode::FS, Level::L2, Medium::rbc);
    c.rbc = SessionRole::handing_over;
    const Information information = static_cast<Information>(i);
    const bool session =
        information == Information::session_management || information == Information::session_termination_ack;
    EXPECT_EQ(accept_by_rbc(information, c).verdict, session ? Verdict::accepted : Verdict::rejected) << i;
    c.orders_establishment = true;
    const bool answer = information == Information::session_termination_ack;
    EXPECT_EQ(accept_by_rbc(information, c).verdict, answer ? Verdict::accepted : Verdict::rejected) << i;
    c.medium = Medium::balise;
    EXPECT_EQ(accept_by_rbc(information, c).verdict, Verdict::accepted) << i;
  }
}

TEST(AcceptanceEdges, In_NL_texts_are_accepted_in_3_4_0_only_and_nothing_else_differs) {
  for (std::size_t i = 0; i < kInformation; ++i) {
    const Information information = static_cast<Information>(i);
    const bool text = information == Information::plain_text || information == Information::fixed_text;
    const Verdict old =
        accept_by_mode(information, unprepared(Mode::NL, Level::L1, Medium::balise, SrsVersion::v3_4_0)).verdict;
    const Verdict now = accept_by_mode(information, unprepared(Mode::NL, Level::L1, Medium::balise)).verdict;
    if (text) {
      EXPECT_EQ(old, Verdict::accepted);
      EXPECT_EQ(now, Verdict::rejected);
    } else {
      EXPECT_EQ(old, now) << i;
    }
  }
}

TEST(AcceptanceEdges, The_level_of_a_national_system_has_two_columns) {  // 4.8.3, last part
  for (const Information information : {Information::stm_max_speed, Information::stm_system_speed_distance})
    for (std::size_t l = 0; l < kLevels; ++l)
      for (const bool own : {false, true}) {
        const Level level = static_cast<Level>(l);
        const AcceptanceContext c = unprepared(Mode::FS, level, Medium::balise);
        const Acceptance announced = accept_from_stm(information, own, true, c);
        if (level != Level::NTC)
          EXPECT_EQ(announced.verdict, Verdict::accepted) << l;
        else if (!own && information == Information::stm_max_speed)
          EXPECT_EQ(announced.clause, "4.8.3 [6]"_srs) << "kept for the level of the other system";
        else
          EXPECT_EQ(announced.verdict, Verdict::rejected);
      }
}

TEST(AcceptanceEdges, What_only_a_national_system_sends_is_not_accepted_by_level) {
  for (const Information information : {Information::stm_max_speed, Information::stm_system_speed_distance}) {
    const Acceptance a = accept_by_level(information, unprepared(Mode::FS, Level::NTC, Medium::balise));
    EXPECT_EQ(a.verdict, Verdict::rejected);
    EXPECT_EQ(a.clause, "4.8.3"_srs);
  }
}

TEST(AvailableLevels, All_levels_unless_configured_otherwise_and_256_national_systems) {
  AvailableLevels unit;
  for (const Level level : {Level::L0, Level::L1, Level::L2, Level::L3}) EXPECT_TRUE(unit.has({level, 0, {}}));
  for (const unsigned n : {0u, 1u, 63u, 64u, 65u, 127u, 128u, 255u}) {
    AvailableLevels one;
    one.national_systems[n / 64] = std::uint64_t{1} << (n % 64);
    for (unsigned id = 0; id < 256; ++id)
      EXPECT_EQ(one.has({Level::NTC, static_cast<std::uint8_t>(id), {}}), id == n) << n << " " << id;
  }
}

TEST(AvailableLevels, The_driver_may_select_each_that_is_available) {  // 5.10.2.8
  for (std::size_t absent = 1; absent <= kLevels; ++absent) {          // level 0 always is
    AvailableLevels unit;
    unit.national_systems[0] = 2;
    if (absent < kLevels) unit.fitted[absent] = false;
    const Set<Level> levels = levels_allowed(nullptr, unit);
    for (std::size_t i = 0; i < kLevels; ++i)
      EXPECT_EQ(levels.has(static_cast<Level>(i)), i != absent) << i << " without " << absent;
  }
  EXPECT_FALSE(levels_allowed(nullptr, AvailableLevels{}).has(Level::NTC));
}

TEST(AvailableLevels, What_is_not_fitted_is_not_available_and_what_4_0_0_does_not_ask_for) {
  AvailableLevels unit;
  unit.national_systems[0] = 1;
  unit.fitted[static_cast<std::size_t>(Level::NTC)] = false;
  EXPECT_FALSE(unit.has({Level::NTC, 0, {}}));
  for (std::size_t l = 0; l < kLevels; ++l) {
    const Level to = static_cast<Level>(l);
    const bool needed = acknowledgement_needed({Level::NTC, 1, {}}, {to, 2, {}}, Mode::SN, SrsVersion::v4_0_0);
    EXPECT_EQ(needed, to != Level::L1 && to != Level::L2) << l;
  }
}

TEST(ModeProperties, Speed_limit_and_desk) {  // 4.4.3 to 4.4.20, the national values of A.3.2
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode mode = static_cast<Mode>(m);
    SpeedLimit limit = SpeedLimit::no_limit;
    if (mode == Mode::SB) limit = SpeedLimit::standstill;
    if (mode == Mode::SH) limit = SpeedLimit::V_NVSHUNT;
    if (mode == Mode::FS || mode == Mode::AD) limit = SpeedLimit::profile_only;
    if (mode == Mode::SM) limit = SpeedLimit::V_SM;
    if (mode == Mode::LS) limit = SpeedLimit::V_NVLIMSUPERV;
    if (mode == Mode::SR) limit = SpeedLimit::V_NVSTFF;
    if (mode == Mode::OS) limit = SpeedLimit::V_NVONSIGHT;
    if (mode == Mode::UN) limit = SpeedLimit::V_NVUNFIT;
    if (mode == Mode::SN) limit = SpeedLimit::national;
    if (mode == Mode::RV) limit = SpeedLimit::V_REVERSE;
    EXPECT_EQ(properties(mode).speed_limit, limit) << name(mode);
    const bool nobody_drives = mode == Mode::NP || mode == Mode::SB || mode == Mode::PS || mode == Mode::SL ||
                               mode == Mode::TR || mode == Mode::SF || mode == Mode::IS;
    EXPECT_EQ(properties(mode).desk_needed, !nobody_drives) << name(mode);
  }
}

TEST(Conditions, Numbers_beyond_64_are_as_good_as_the_others) {
  for (const int n : {1, 63, 64, 65, 74, 127}) {
    const Conditions one{n};
    EXPECT_FALSE(one.none());
    for (int m = 0; m < Conditions::kNumbers; ++m) EXPECT_EQ(one.test(m), m == n) << m;
    EXPECT_TRUE(one.any_of({n, 5}));
    EXPECT_FALSE(one.any_of({n == 127 ? 126 : n + 1}));
    EXPECT_EQ((one | Conditions{5}), (Conditions{5, n}));
    EXPECT_EQ((Conditions{5} | one), (Conditions{5, n}));
    EXPECT_EQ((Conditions{5, 70, n} & one), one);
    EXPECT_TRUE((Conditions{5} & Conditions{70}).none());
    Conditions cleared = one;
    cleared.set(n, false);
    EXPECT_TRUE(cleared.none());
  }
}

}  // namespace
}  // namespace evc::modes
