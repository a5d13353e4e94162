#include <gtest/gtest.h>

#include "modes/acceptance.h"
#include "modes/levels.h"
#include "modes/next_mode.h"

// The tables of this room together.
namespace evc::modes {
namespace {

static_assert(next_mode(Mode::FS, {59})->to == Mode::RV);
static_assert(next_mode(Mode::FS, {59, 12})->to == Mode::TR);
static_assert(next_mode(Mode::FS, {59, 12, 1})->to == Mode::IS);
static_assert(!next_mode(Mode::IS, {28}));
static_assert(!next_mode(Mode::TR, {28}), "a desk closed in TR changes nothing (4.4.13.1.6)");
static_assert(next_mode(Mode::UN, {44, 67, 39})->to == Mode::SR, "override outranks the trip at the border");

TEST(NextMode, Nothing_holds_nothing_happens) {
  for (std::size_t m = 0; m < kModes; ++m) EXPECT_FALSE(next_mode(static_cast<Mode>(m), {}).has_value());
}

TEST(NextMode, Isolation_goes_before_all_and_power_before_the_rest) {
  Conditions all;
  for (const Condition& c : srs_4_6_3) all.set(c.number);
  for (const Condition& c : srs_4_6_3_v400) all.set(c.number);
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode mode = static_cast<Mode>(m);
    if (mode == Mode::IS) continue;
    Conditions rest = all;
    rest.set(1, false);
    const Mode without = mode == Mode::NP ? Mode::SB : Mode::NP;
    EXPECT_EQ(next_mode(mode, all, SrsVersion::v4_0_0)->to, Mode::IS) << name(mode);
    EXPECT_EQ(next_mode(mode, rest, SrsVersion::v4_0_0)->to, without) << name(mode);
    if (mode == Mode::SM || mode == Mode::AD) continue;
    EXPECT_EQ(next_mode(mode, all)->to, Mode::IS) << name(mode);
    EXPECT_EQ(next_mode(mode, rest)->to, without) << name(mode);
  }
}

TEST(NextMode, Names_the_first_condition_of_the_cell_that_holds) {
  const auto went = next_mode(Mode::SN, {20, 39});
  ASSERT_TRUE(went.has_value());
  EXPECT_EQ(went->to, Mode::TR);
  EXPECT_EQ(went->number, 39);
  EXPECT_EQ(went->priority, 5);
}

TEST(NextMode, Of_equal_priorities_what_would_be_lost_goes_first) {
  // FS: on sight area [40] and level 0 [21] in one cycle. The level transition would not be seen
  // again.
  EXPECT_EQ(next_mode(Mode::FS, {40, 21})->to, Mode::UN);
  // LS: back to FS [32] and the driver's override [37].
  EXPECT_EQ(next_mode(Mode::LS, {32, 37})->to, Mode::SR);
  // SB: the MA was received [10] while the driver acknowledged on sight [15].
  EXPECT_EQ(next_mode(Mode::SB, {10, 15})->to, Mode::OS);
  // FS: override [37] and level 0 [21].
  EXPECT_EQ(next_mode(Mode::FS, {37, 21})->to, Mode::UN);
  // Two of one kind: the page's order.
  EXPECT_EQ(next_mode(Mode::FS, {40, 72})->to, Mode::LS);
}

TEST(NextMode, Of_4_0_0_knows_the_new_modes) {
  constexpr SrsVersion of_4 = SrsVersion::v4_0_0;
  EXPECT_EQ(next_mode(Mode::FS, {80}, of_4)->to, Mode::AD);
  EXPECT_EQ(next_mode(Mode::SB, {81}, of_4)->to, Mode::SM);
  EXPECT_EQ(next_mode(Mode::PT, {77}, of_4)->to, Mode::UN);
  EXPECT_FALSE(next_mode(Mode::PS, {13}, of_4).has_value());
  for (const SrsVersion of_3 : {SrsVersion::v3_4_0, SrsVersion::v3_6_0}) {
    EXPECT_FALSE(next_mode(Mode::FS, {80}, of_3).has_value());
    EXPECT_FALSE(next_mode(Mode::PT, {77}, of_3).has_value());
    EXPECT_EQ(next_mode(Mode::PS, {13}, of_3)->to, Mode::SF);
  }
}

TEST(NextMode, The_cells_that_leave_a_mode_are_those_of_the_edition) {
  EXPECT_EQ(cells_leaving(Mode::AD, SrsVersion::v4_0_0).size(), 15u);
  EXPECT_EQ(cells_leaving(Mode::AD, SrsVersion::v3_6_0).size(), 0u);
  EXPECT_EQ(cells_leaving(Mode::PT, SrsVersion::v4_0_0).size(), 12u);
}

TEST(Conditions, Are_a_set_of_numbers) {
  Conditions c{3, 74};
  EXPECT_TRUE(c.test(3));
  EXPECT_TRUE(c.test(74));
  EXPECT_FALSE(c.test(4));
  c.set(3, false);
  EXPECT_EQ(c, Conditions{74});
  EXPECT_TRUE(Conditions{}.none());
  EXPECT_EQ(c | Conditions{1}, (Conditions{1, 74}));
  EXPECT_EQ((Conditions{1, 2, 70} & Conditions{2, 70, 71}), (Conditions{2, 70}));
  EXPECT_EQ(meaning(55), nullptr);
}

AcceptanceContext prepared(Mode mode, Level level, Medium medium) {
  AcceptanceContext c;
  c.mode = mode;
  c.level = level;
  c.medium = medium;
  c.desk_open = true;
  c.train_data_valid = true;
  c.described_over_whole_ma = true;
  return c;
}

void expect(const Acceptance& a, Verdict verdict, Clause clause) {
  EXPECT_EQ(a.verdict, verdict) << kSrsClauses[clause.place_in_register()];
  EXPECT_EQ(a.clause, clause);
}

TEST(Accept, An_MA_in_its_own_level_and_mode) {
  expect(accept(Information::movement_authority, prepared(Mode::FS, Level::L2, Medium::rbc)), Verdict::accepted, {});
  expect(accept(Information::movement_authority, prepared(Mode::FS, Level::L1, Medium::balise)), Verdict::accepted, {});
  expect(accept(Information::movement_authority, prepared(Mode::FS, Level::L2, Medium::balise)), Verdict::rejected,
         "4.8.3"_srs);
  expect(accept(Information::movement_authority, prepared(Mode::SH, Level::L1, Medium::balise)), Verdict::rejected,
         "4.8.4"_srs);
  expect(accept(Information::movement_authority, prepared(Mode::SF, Level::L1, Medium::balise)), Verdict::rejected,
         "4.8.4"_srs);
}

TEST(Accept, Every_exception_of_4_8_3_decides) {
  AcceptanceContext c = prepared(Mode::FS, Level::NTC, Medium::rbc);
  c.mode = Mode::SN;
  c.announced = Level::L2;
  expect(accept(Information::movement_authority, c), Verdict::buffered, "4.8.3 [2]"_srs);
  c.medium = Medium::balise;
  c.announced = Level::L1;
  expect(accept(Information::movement_authority, c), Verdict::buffered, "4.8.3 [1]"_srs);
  c.announced.reset();
  expect(accept(Information::movement_authority, c), Verdict::rejected, "4.8.3"_srs);

  const auto rejects = [](Information what, AcceptanceContext context, Clause clause) {
    expect(accept(what, context), Verdict::rejected, clause);
  };
  c = prepared(Mode::FS, Level::L2, Medium::rbc);
  c.train_data_unacknowledged = true;
  rejects(Information::movement_authority, c, "4.8.3 [3]"_srs);
  c = prepared(Mode::FS, Level::L2, Medium::rbc);
  c.described_over_whole_ma = false;
  rejects(Information::movement_authority, c, "4.8.3 [4]"_srs);
  c = prepared(Mode::FS, Level::L2, Medium::rbc);
  c.emergency_stop_pending = true;
  rejects(Information::movement_authority, c, "4.8.3 [5]"_srs);
  c = prepared(Mode::FS, Level::L2, Medium::balise);
  c.revocable_and_inhibited = true;
  rejects(Information::tsr, c, "4.8.3 [8]"_srs);
  c = prepared(Mode::FS, Level::L1, Medium::balise);
  rejects(Information::taf_up_to_l23, c, "4.8.3 [9]"_srs);
  c.announced = Level::L3;
  expect(accept(Information::taf_up_to_l23, c), Verdict::accepted, {});
  c = prepared(Mode::SR, Level::L2, Medium::rbc);
  c.other_previous_lrbg = true;
  rejects(Information::coordinate_system_assignment, c, "4.8.3 [10]"_srs);
  c = prepared(Mode::FS, Level::L2, Medium::balise);
  c.level_order_along_or_announced = true;
  rejects(Information::conditional_level_transition_order, c, "4.8.3 [11]"_srs);
  c = prepared(Mode::FS, Level::L2, Medium::rbc);
  c.text_awaits_acknowledgement = true;
  rejects(Information::plain_text, c, "4.8.3 [12]"_srs);
  c = prepared(Mode::SH, Level::L0, Medium::balise);
  rejects(Information::danger_for_sh, c, "4.8.3 [13]"_srs);
  c.immediate_order_to_1_2_3 = true;
  expect(accept(Information::danger_for_sh, c), Verdict::accepted, {});
  c = prepared(Mode::FS, Level::L2, Medium::balise);
  c.names_rbc_of_transition = true;
  rejects(Information::session_management, c, "4.8.3 [14]"_srs);
  c.srs = SrsVersion::v3_4_0;
  expect(accept(Information::session_management, c), Verdict::accepted, {});
}

TEST(Accept, Every_exception_of_4_8_4_decides) {
  AcceptanceContext c = prepared(Mode::PT, Level::L2, Medium::rbc);
  expect(accept(Information::sr_authorisation, c), Verdict::rejected, "4.8.4 [1]"_srs);
  c.exit_from_trip_recognised = true;
  expect(accept(Information::sr_authorisation, c), Verdict::accepted, {});
  c.level = Level::L1;
  c.medium = Medium::balise;
  expect(accept(Information::movement_authority, c), Verdict::rejected, "4.8.4 [1]"_srs);
  c = prepared(Mode::SB, Level::L1, Medium::balise);
  c.desk_open = false;
  expect(accept(Information::movement_authority, c), Verdict::rejected, "4.8.4 [2]"_srs);
  c.desk_open = true;
  c.train_data_valid = false;
  expect(accept(Information::movement_authority, c), Verdict::rejected, "4.8.4 [4]"_srs);
  c = prepared(Mode::SH, Level::L1, Medium::balise);
  c.orders_establishment = true;
  expect(accept(Information::session_management, c), Verdict::only_contact_stored, "4.8.4 [3]"_srs);
  c.orders_establishment = false;
  expect(accept(Information::session_management, c), Verdict::accepted, {});
  c = prepared(Mode::PT, Level::L2, Medium::rbc);
  c.exit_from_trip_recognised = true;
  expect(accept(Information::level_transition_order, c), Verdict::rejected, "4.8.4 [5]"_srs);
  c.order = OrderKind::announcement;
  expect(accept(Information::level_transition_order, c), Verdict::accepted, {});
  c = prepared(Mode::SR, Level::L1, Medium::loop);
  c.override_active = true;
  expect(accept(Information::sr_distance_loop, c), Verdict::rejected, "4.8.4 [6]"_srs);
  c = prepared(Mode::SH, Level::L1, Medium::balise);
  expect(accept(Information::level_transition_order, c), Verdict::order_stored, "4.8.4 [7]"_srs);
  c.order = OrderKind::announcement;
  expect(accept(Information::level_transition_order, c), Verdict::rejected, "4.8.4 [7]"_srs);
  c = prepared(Mode::SH, Level::L2, Medium::balise);
  expect(accept(Information::rbc_transition_order, c), Verdict::rejected, "4.8.4 [8]"_srs);
  c.null_distance = true;
  expect(accept(Information::rbc_transition_order, c), Verdict::only_contact_stored, "4.8.4 [8]"_srs);
  c = prepared(Mode::FS, Level::L1, Medium::balise);
  expect(accept(Information::lssma_toggle_on, c), Verdict::rejected, "4.8.4 [9]"_srs);
  c.front_in_ls_area_of_message = true;
  expect(accept(Information::lssma_toggle_on, c), Verdict::accepted, {});
  c = prepared(Mode::SM, Level::L2, Medium::balise);
  c.srs = SrsVersion::v4_0_0;
  expect(accept(Information::session_management, c), Verdict::accepted, {});
  c.orders_establishment = true;
  expect(accept(Information::session_management, c), Verdict::rejected, "4.8.4 [12]"_srs);
  c = prepared(Mode::OS, Level::L1, Medium::balise);
  c.srs = SrsVersion::v4_0_0;
  expect(accept(Information::lssma_toggle_on, c), Verdict::rejected, "4.8.4 [10]"_srs);
  c.front_in_ls_area_of_message = true;
  expect(accept(Information::lssma_toggle_on, c), Verdict::accepted, {});
  c.front_in_OS_ack_area = true;
  expect(accept(Information::lssma_toggle_on, c), Verdict::rejected, "4.8.4 [10]"_srs);
}

TEST(Accept, Infill_counts_in_FS_and_LS_only) {
  for (std::size_t m = 0; m < kModes; ++m) {
    AcceptanceContext c = prepared(static_cast<Mode>(m), Level::L1, Medium::balise);
    c.infill = true;
    const bool runs = c.mode == Mode::FS || c.mode == Mode::LS || c.mode == Mode::AD;
    EXPECT_EQ(accept(Information::gradient, c).verdict == Verdict::accepted, runs) << name(c.mode);
  }
}

TEST(Accept, The_accepting_RBC_is_heard_at_the_border) {
  AcceptanceContext c = prepared(Mode::FS, Level::L2, Medium::rbc);
  c.rbc = SessionRole::accepting;
  expect(accept(Information::movement_authority, c), Verdict::buffered, "4.8.2.1"_srs);
  expect(accept(Information::train_data_ack, c), Verdict::accepted, {});
  expect(accept(Information::trackside_system_version, c), Verdict::accepted, {});
  expect(accept(Information::session_management, c), Verdict::accepted, {});
  expect(accept(Information::emergency_stop_revocation, c), Verdict::rejected, "4.8.2.1"_srs);
  expect(accept(Information::ma_shortening_request, c), Verdict::rejected, "4.8.2.1"_srs);
  expect(accept(Information::rbc_transition_order, c), Verdict::buffered, "4.8.2.1"_srs);
  c.srs = SrsVersion::v4_0_0;
  expect(accept(Information::rbc_transition_order, c), Verdict::rejected, "4.8.2.1"_srs);
  c.srs = SrsVersion::v3_6_0;
  c.mode = Mode::LS;
  expect(accept(Information::lssma_toggle_off, c), Verdict::rejected, "4.8.2.1"_srs);
  c.srs = SrsVersion::v3_4_0;
  expect(accept(Information::lssma_toggle_off, c), Verdict::buffered, "4.8.2.1"_srs);
  expect(accept(Information::session_initiation, c), Verdict::accepted, {});
  c = prepared(Mode::FS, Level::L2, Medium::rbc);
  c.rbc = SessionRole::handing_over;
  expect(accept(Information::movement_authority, c), Verdict::rejected, "4.8.2.1"_srs);
  expect(accept(Information::session_management, c), Verdict::accepted, {});
  c.medium = Medium::balise;  // only an RBC has a role
  expect(accept(Information::tsr, c), Verdict::accepted, {});
}

TEST(Accept, Editions) {
  AcceptanceContext c = prepared(Mode::NL, Level::L2, Medium::rbc);
  expect(accept(Information::plain_text, c), Verdict::rejected, "4.8.4"_srs);
  expect(accept(Information::session_initiation, c), Verdict::rejected, "4.8.3"_srs);
  c.srs = SrsVersion::v3_4_0;
  expect(accept(Information::plain_text, c), Verdict::accepted, {});
  expect(accept(Information::session_initiation, c), Verdict::accepted, {});
}

TEST(Accept, National_systems) {
  AcceptanceContext c = prepared(Mode::FS, Level::L1, Medium::balise);
  expect(accept(Information::stm_max_speed, c), Verdict::rejected, "4.8.3"_srs);
  expect(accept_from_stm(Information::gradient, false, false, c), Verdict::rejected, "4.8.3"_srs);
  expect(accept_from_stm(Information::stm_max_speed, false, false, c), Verdict::rejected, "4.8.3 [7]"_srs);
  expect(accept_from_stm(Information::stm_max_speed, false, true, c), Verdict::accepted, {});
  c = prepared(Mode::SN, Level::NTC, Medium::balise);
  expect(accept_from_stm(Information::stm_max_speed, true, false, c), Verdict::rejected, "4.8.3"_srs);
  expect(accept_from_stm(Information::stm_max_speed, false, true, c), Verdict::buffered, "4.8.3 [6]"_srs);
  expect(accept_from_stm(Information::stm_system_speed_distance, false, true, c), Verdict::rejected, "4.8.3"_srs);
  c = prepared(Mode::UN, Level::L0, Medium::balise);
  expect(accept_from_stm(Information::stm_system_speed_distance, false, true, c), Verdict::accepted, {});
}

OrderedLevel at(Level level, std::uint8_t nid_ntc = 0) {
  return {.level = level, .nid_ntc = nid_ntc, .L_ack = Distance{100.0}};
}
LevelTable table(std::initializer_list<OrderedLevel> levels) {
  LevelTable t;
  for (const OrderedLevel& l : levels) EXPECT_TRUE(t.push_back(l));
  return t;
}

TEST(Levels, The_first_available_is_taken_otherwise_the_last) {
  AvailableLevels unit;
  unit.national_systems[0] = std::uint64_t{1} << 9;
  const LevelTable t = table({at(Level::NTC, 1), at(Level::L2), at(Level::NTC, 9)});
  EXPECT_EQ(select_level(t, unit), at(Level::L2));
  unit.mobile_terminal = false;
  EXPECT_EQ(select_level(t, unit), at(Level::NTC, 9));
  unit.national_systems = {};
  unit.fitted[static_cast<std::size_t>(Level::L1)] = false;
  EXPECT_EQ(select_level(table({at(Level::L1), at(Level::L3)}), unit), at(Level::L3));
  EXPECT_EQ(select_level(table({at(Level::L3), at(Level::L0)}), unit), at(Level::L0));
}

TEST(Levels, Acknowledgement) {
  EXPECT_FALSE(acknowledgement_needed(at(Level::NTC, 1), at(Level::NTC, 1), Mode::SN));
  EXPECT_TRUE(acknowledgement_needed(at(Level::NTC, 1), at(Level::NTC, 2), Mode::SN));
  EXPECT_TRUE(acknowledgement_needed(at(Level::NTC, 1), at(Level::L2), Mode::SN));
  EXPECT_FALSE(acknowledgement_needed(at(Level::NTC, 1), at(Level::L2), Mode::SN, SrsVersion::v4_0_0));
  EXPECT_TRUE(acknowledgement_needed(at(Level::NTC, 1), at(Level::L0), Mode::SN, SrsVersion::v4_0_0));
  EXPECT_FALSE(acknowledgement_needed(at(Level::L2), at(Level::L0), Mode::NL));
  EXPECT_FALSE(acknowledgement_needed(at(Level::L2), at(Level::L0), Mode::SL)) << "nobody is there (4.4.6.1.2)";
  EXPECT_TRUE(acknowledgement_needed(at(Level::L2), at(Level::L0), Mode::FS));
}

TEST(Levels, Orders) {
  const AvailableLevels unit;
  const OrderedLevel one = at(Level::L1);
  const auto judged = [&](OrderKind kind, const LevelTable& t, Mode mode = Mode::FS) {
    return judge(kind, t, one, mode, unit);
  };
  const LevelTable to_2 = table({at(Level::L2)});
  EXPECT_EQ(judged(OrderKind::immediate, to_2).effect, OrderEffect::execute);
  EXPECT_EQ(judged(OrderKind::announcement, to_2).effect, OrderEffect::announce);
  EXPECT_EQ(judged(OrderKind::conditional, to_2).effect, OrderEffect::execute);
  const OrderDecision kept = judged(OrderKind::conditional, table({at(Level::L2), at(Level::L1)}));
  EXPECT_EQ(kept.effect, OrderEffect::none);
  EXPECT_TRUE(kept.to.same_level(one));
  EXPECT_FALSE(kept.cancels_pending);
  const OrderDecision same = judged(OrderKind::immediate, table({at(Level::L1)}));
  EXPECT_EQ(same.effect, OrderEffect::none);
  EXPECT_TRUE(same.cancels_pending);
  EXPECT_EQ(judged(OrderKind::announcement, to_2, Mode::SH).effect, OrderEffect::rejected);
  EXPECT_EQ(judged(OrderKind::immediate, to_2, Mode::PS).effect, OrderEffect::keep_until_mode_left);
  EXPECT_EQ(judged(OrderKind::immediate, to_2, Mode::PT).effect, OrderEffect::rejected);
  EXPECT_EQ(judged(OrderKind::announcement, to_2, Mode::PT).effect, OrderEffect::announce);
  EXPECT_EQ(judged(OrderKind::immediate, to_2, Mode::RV).effect, OrderEffect::rejected);
  EXPECT_EQ(judged(OrderKind::immediate, LevelTable{}).effect, OrderEffect::rejected);
}

TEST(Levels, Places) {
  const PendingTransition pending{at(Level::L2), Place{Distance{1000.0}}};
  EXPECT_FALSE(border_reached(pending, Place{Distance{999.9}}));
  EXPECT_TRUE(border_reached(pending, Place{Distance{1000.0}}));
  EXPECT_FALSE(in_acknowledgement_length(pending, Place{Distance{899.9}}));
  EXPECT_TRUE(in_acknowledgement_length(pending, Place{Distance{900.0}}));
  EXPECT_TRUE(announced_to_driver(pending, at(Level::L1)));
  EXPECT_FALSE(announced_to_driver(pending, at(Level::L2)));
}

TEST(Levels, What_the_driver_may_choose) {
  AvailableLevels unit;
  unit.mobile_terminal = false;
  EXPECT_TRUE(driver_may_select(at(Level::L1), nullptr, unit));
  EXPECT_FALSE(driver_may_select(at(Level::L2), nullptr, unit));
  const LevelTable trackside = table({at(Level::L1)});
  EXPECT_TRUE(driver_may_select(at(Level::L1), &trackside, unit));
  EXPECT_FALSE(driver_may_select(at(Level::L0), &trackside, unit));
  const LevelTable none;
  EXPECT_TRUE(driver_may_select(at(Level::L0), &none, unit));
}

TEST(Levels, Those_that_are_allowed) {  // 5.10.2.8
  AvailableLevels unit;
  unit.fitted[static_cast<std::size_t>(Level::L3)] = false;
  const Set<Level> own{Level::L0, Level::L1, Level::L2};
  EXPECT_EQ(levels_allowed(nullptr, unit), own) << "no national system is there";
  const LevelTable none;
  EXPECT_EQ(levels_allowed(&none, unit), own);
  unit.national_systems[0] = 1u << 7;
  EXPECT_TRUE(levels_allowed(nullptr, unit).has(Level::NTC));
  OrderedLevel national = at(Level::NTC);
  national.nid_ntc = 6;
  const LevelTable trackside = table({at(Level::L3), national, at(Level::L1)});
  EXPECT_EQ(levels_allowed(&trackside, unit), Set<Level>{Level::L1});
  unit.national_systems[0] = 1u << 6;
  EXPECT_EQ(levels_allowed(&trackside, unit), (Set<Level>{Level::L1, Level::NTC}));
}

TEST(Names, Levels) {
  EXPECT_STREQ(name(Level::NTC), "NTC");
  EXPECT_STREQ(name(Mode::RV), "RV");
}

}  // namespace
}  // namespace evc::modes
