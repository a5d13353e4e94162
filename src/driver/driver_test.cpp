#include "driver/driver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "base/test_paths.h"
#include "texts/texts.h"

namespace evc::driver {
namespace {

using nlohmann::json;
using texts::name;

json reference() {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/dmi_io_by_mode.json");
  return json::parse(in);
}

std::string text(Mark mark) {
  const char* texts[] = {"-", "X", "A", "NA", "NS"};
  return texts[static_cast<int>(mark)];
}

using Cells = std::map<std::string, std::map<std::string, std::string>>;

Cells cells_of(const json& rows) {
  Cells out;
  for (const json& r : rows) out[r["id"]] = r["marks"].get<std::map<std::string, std::string>>();
  return out;
}

Cells rows_of_3_4_0(const std::string& kind) { return cells_of(reference()[kind]); }

/// The rows of 3.6.0, computed from those of 3.4.0 and the listed differences.
Cells rows_of_3_6_0(const std::string& kind) {
  const json file = reference();
  Cells out = rows_of_3_4_0(kind);
  const json& newer = file["differences_3_6_0"];
  for (const auto& [id, change] : newer[kind + "_changed"].items()) {
    const json& marks = change.contains("marks") ? change["marks"] : change;
    for (const auto& [mode, mark] : marks.items())
      if (mode != "note") out[id][mode] = mark;
  }
  for (const auto& [id, marks] : newer[kind + "_new"].items())
    out[id] = marks.get<std::map<std::string, std::string>>();
  if (kind == "outputs")
    for (const json& id : newer["outputs_removed"]) out.erase(id.get<std::string>());
  return out;
}

/// The rows of 4.0.0 that the on-board has. The shade of SN (left to the national system) is lost in the text read: the
/// mark of 3.6.0 stays.
Cells rows_of_4_0_0(const std::string& kind) {
  const std::map<std::string, std::string> ours{{"radio_network", "radio_network_id"},
                                                {"bmm_inhibition", "bmm_inhibit"},
                                                {"revoke_bmm_inhibition", "bmm_revoke"},
                                                {"sm_request", "sm"}};
  Cells older = rows_of_3_6_0(kind), out;
  for (auto& [id, marks] : cells_of(reference()["table_4_0_0"][kind])) {
    const std::string name = kind == "inputs" || id == "radio_network" ? ours.count(id) ? ours.at(id) : id : id;
    if (older[name]["SN"] == "NS") marks["SN"] = "NS";
    out[name] = marks;
  }
  return out;
}

/// `without`: how many rows the edition does not have.
template <class Rows>
void expect_rows(const Rows& table, const Cells& expected, SrsVersion srs, std::size_t modes, std::size_t without) {
  std::size_t compared = 0;
  for (const auto& row : table) {
    if (expected.count(name(row.what)) == 0) continue;
    ++compared;
    for (std::size_t m = 0; m < modes; ++m) {
      const Mode mode = static_cast<Mode>(m);
      EXPECT_EQ(text(mark(row.what, mode, srs)), expected.at(name(row.what)).at(name(mode)))
          << name(row.what) << name(mode) << name(srs);
    }
  }
  // A row that an edition does not have is used by none of its functions.
  EXPECT_EQ(compared + without, table.size()) << name(srs);
}

TEST(Driver, Inputs_are_4_7_2) {
  expect_rows(srs_4_7_2_inputs, rows_of_3_4_0("inputs"), SrsVersion::v3_4_0, kModesOf3, 8);
  expect_rows(srs_4_7_2_inputs, rows_of_3_6_0("inputs"), SrsVersion::v3_6_0, kModesOf3, 7);
  expect_rows(srs_4_7_2_inputs, rows_of_4_0_0("inputs"), SrsVersion::v4_0_0, kModes, 0);
}

TEST(Driver, Outputs_are_4_7_2) {
  expect_rows(srs_4_7_2_outputs, rows_of_3_4_0("outputs"), SrsVersion::v3_4_0, kModesOf3, 17);
  expect_rows(srs_4_7_2_outputs, rows_of_3_6_0("outputs"), SrsVersion::v3_6_0, kModesOf3, 7);
  expect_rows(srs_4_7_2_outputs, rows_of_4_0_0("outputs"), SrsVersion::v4_0_0, kModes, 0);
}

/// Everything that can be true is true.
ActionContext everything(Mode mode, Level level) {
  ActionContext c;
  c.mode = mode;
  c.level = level;
  c.desk_open = c.standstill = c.driver_id_valid = c.train_data_valid = c.train_running_number_valid = true;
  c.session_open = c.train_data_acknowledged = c.non_leading_signal = true;
  c.passive_shunting_signal = c.slow_enough_for_override = c.driver_may_change_adhesion = c.network_offered = true;
  c.driver_id_while_running = c.track_ahead_free_asked = c.automatic_driving_asked = true;
  c.alarm_may_be_inhibited = true;
  c.offers = Set<Offer>::of_bits(~0u);
  return c;
}

TEST(Driver, With_every_condition_met_exactly_the_inputs_of_the_mode_are_enabled) {
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode mode = static_cast<Mode>(m);
    const Set<Input> choices = enabled(everything(mode, Level::L2));
    ActionContext asked = everything(mode, Level::L2);
    asked.requests = Set<Ack>::of_bits(~0u);
    const Set<Input> acks = enabled(asked);
    for (std::size_t i = 0; i < kInputs; ++i) {
      const Input input = static_cast<Input>(i);
      const bool is_ack = std::string(name(input)).rfind("ack_", 0) == 0;
      EXPECT_EQ((is_ack ? acks : choices).has(input),
                allowed(input, mode, SrsVersion::v3_6_0) && input != Input::sm && input != Input::bmm_revoke)
          << name(mode) << name(input);
    }
  }
}

TEST(Driver, Without_a_desk_only_the_isolation_device_is_left) {
  for (std::size_t m = 0; m < kModes; ++m) {
    ActionContext c = everything(static_cast<Mode>(m), Level::L2);
    c.desk_open = false;
    EXPECT_EQ(enabled(c), Set<Input>{Input::isolation});
  }
}

TEST(Driver, While_an_acknowledgement_is_asked_for_the_menus_are_closed) {
  ActionContext c = everything(Mode::FS, Level::L2);
  c.requests = {Ack::OS};
  EXPECT_EQ(enabled(c), (Set<Input>{Input::ack_OS, Input::isolation}));
}

// 015560 11.7.1.9: in the start-up dialogue acknowledgements wait, so the dialogue goes on.
TEST(Driver, In_the_start_up_an_acknowledgement_closes_nothing) {
  ActionContext c = everything(Mode::SB, Level::L2);
  const Set<Input> before = enabled(c);
  ASSERT_TRUE(before.has(Input::driver_id));
  c.requests = {Ack::level};
  EXPECT_FALSE(enabled(c).has(Input::driver_id));
  c.start_up = true;
  EXPECT_EQ(enabled(c) & before, before);
}

TEST(Driver, Each_condition_closes_what_needs_it) {
  struct Case {
    Mode mode;
    Level level;
    bool ActionContext::*fact;
    Input input;
  };
  using C = ActionContext;
  const Case cases[] = {
      {Mode::SB, Level::L1, &C::standstill, Input::start},
      {Mode::SB, Level::L1, &C::train_data_valid, Input::start},
      {Mode::SB, Level::L1, &C::train_running_number_valid, Input::start},
      {Mode::SB, Level::L2, &C::train_data_acknowledged, Input::start},
      {Mode::PT, Level::L1, &C::standstill, Input::start},
      {Mode::SR, Level::L2, &C::session_open, Input::start},
      {Mode::SB, Level::L2, &C::session_open, Input::shunting},
      {Mode::FS, Level::L1, &C::standstill, Input::shunting},
      {Mode::FS, Level::L1, &C::driver_id_valid, Input::shunting},
      {Mode::FS, Level::L1, &C::slow_enough_for_override, Input::override_},
      {Mode::FS, Level::L1, &C::train_data_valid, Input::override_},
      {Mode::SB, Level::L2, &C::train_running_number_valid, Input::override_},
      {Mode::PT, Level::L2, &C::train_running_number_valid, Input::override_},
      {Mode::SH, Level::L1, &C::slow_enough_for_override, Input::override_},
      {Mode::SB, Level::L1, &C::standstill, Input::driver_id},
      {Mode::FS, Level::L1, &C::standstill, Input::train_data},
      {Mode::FS, Level::L1, &C::standstill, Input::level},
      {Mode::SB, Level::L1, &C::standstill, Input::train_running_number},
      {Mode::FS, Level::L2, &C::standstill, Input::rbc_contact},
      {Mode::FS, Level::L1, &C::non_leading_signal, Input::non_leading},
      {Mode::SH, Level::L1, &C::passive_shunting_signal, Input::continue_shunting},
      {Mode::FS, Level::L1, &C::driver_may_change_adhesion, Input::adhesion},
      {Mode::FS, Level::L1, &C::network_offered, Input::radio_network_id},
      {Mode::SR, Level::L1, &C::standstill, Input::sr_speed_distance},
      {Mode::SH, Level::L1, &C::standstill, Input::exit_shunting},
      {Mode::FS, Level::L2, &C::train_data_valid, Input::integrity_confirmation},
      {Mode::OS, Level::L2, &C::track_ahead_free_asked, Input::track_ahead_free},
  };
  for (const Case& one : cases) {
    ActionContext c = everything(one.mode, one.level);
    EXPECT_TRUE(enabled(c).has(one.input)) << name(one.mode) << name(one.input);
    c.*one.fact = false;
    EXPECT_FALSE(enabled(c).has(one.input)) << name(one.mode) << name(one.input);
  }
}

TEST(Driver, Override_in_standby_needs_level_2_or_3) {  // 5.8.2.1 b
  for (std::size_t l = 0; l < kLevels; ++l) {
    const Level level = static_cast<Level>(l);
    EXPECT_EQ(enabled(everything(Mode::SB, level)).has(Input::override_), level_2_or_3(level)) << name(level);
  }
}

TEST(Driver, A_manoeuvre_is_offered_with_shunting_in_standby_and_post_trip) {  // 5.4.3.2 S10, 5.11.2.2 S140
  for (const Mode mode : {Mode::SB, Mode::PT, Mode::FS}) {
    ActionContext c = everything(mode, Level::L2);
    c.srs = SrsVersion::v4_0_0;
    c.manoeuvre_possible = true;
    EXPECT_TRUE(enabled(c).has(Input::sm)) << name(mode);
    c.offers = {};
    EXPECT_EQ(enabled(c).has(Input::sm), mode == Mode::FS) << name(mode);
  }
}

TEST(Driver, Start_of_mission_opens_the_choices_of_standby) {
  ActionContext c = everything(Mode::SB, Level::L1);
  c.offers = {};
  for (const Input input : {Input::start, Input::shunting, Input::override_, Input::train_data})
    EXPECT_FALSE(enabled(c).has(input)) << name(input);
  c.level.reset();
  c.offers = Set<Offer>::of_bits(~0u);
  for (const Input input : {Input::start, Input::shunting, Input::non_leading}) EXPECT_FALSE(enabled(c).has(input));
  // S1: before the driver ID (5.4.3.2).
  c.driver_id_valid = false;
  EXPECT_TRUE(enabled(c).has(Input::train_running_number));
  EXPECT_FALSE(enabled(c).has(Input::level));
  c.standstill = false;
  EXPECT_FALSE(enabled(c).has(Input::train_running_number));
  // Start in level 2 without a session leads to SR (5.4.5.3 h).
  c = everything(Mode::SB, Level::L2);
  c.session_open = c.train_data_acknowledged = false;
  EXPECT_TRUE(enabled(c).has(Input::start));
  // While running the driver identity may be changed where the national value allows it.
  c = everything(Mode::FS, Level::L2);
  c.standstill = false;
  EXPECT_TRUE(enabled(c).has(Input::driver_id));
  c.driver_id_while_running = false;
  EXPECT_FALSE(enabled(c).has(Input::driver_id));
}

std::vector<std::string> list(const Show& shown) {
  std::vector<std::string> out;
  for (const Symbol s : shown.symbols) out.emplace_back(name(s));
  return out;
}

ShowContext cab(Mode mode, Level level) {
  ShowContext c;
  c.mode = mode;
  c.level = level;
  c.desk_open = true;
  return c;
}

using Symbols = std::vector<std::string>;

TEST(Driver, Mode_and_level_are_shown) {
  EXPECT_EQ(list(show(cab(Mode::FS, Level::L2))), (Symbols{"MO11", "LE04"}));
  EXPECT_EQ(list(show(cab(Mode::SN, Level::NTC))), (Symbols{"MO19", "LE02"}));
  EXPECT_EQ(list(show(cab(Mode::SF, Level::L1))), (Symbols{"MO18"}));
  std::set<std::string> symbols;
  for (std::size_t m = 0; m < kModes; ++m)
    if (const auto s = symbol(static_cast<Mode>(m))) symbols.insert(name(*s));
  EXPECT_EQ(symbols.size(), 15u);
}

TEST(Driver, Nothing_is_shown_without_a_desk_or_power) {
  ShowContext c = cab(Mode::SB, Level::L1);
  c.desk_open = false;
  EXPECT_TRUE(show(c).symbols.empty());
  for (const Mode mode : {Mode::NP, Mode::PS, Mode::SL}) EXPECT_TRUE(show(cab(mode, Level::L1)).symbols.empty());
}

TEST(Driver, A_mode_acknowledgement_hides_the_announcement_of_a_level) {
  ShowContext c = cab(Mode::FS, Level::L2);
  c.announced = Level::NTC;
  EXPECT_EQ(list(show(c)), (Symbols{"MO11", "LE04", "LE08"}));
  c.requests = {Ack::level};
  EXPECT_EQ(list(show(c)), (Symbols{"MO11", "LE04", "LE09"}));
  c.requests = {Ack::level, Ack::OS};
  EXPECT_EQ(list(show(c)), (Symbols{"MO11", "LE04", "MO08"}));
  // After the transition the new level is acknowledged.
  ShowContext after = cab(Mode::SN, Level::NTC);
  after.requests = {Ack::level};
  EXPECT_EQ(list(show(after)), (Symbols{"MO19", "LE02", "LE09"}));
}

TEST(Driver, Acknowledgements_of_modes_have_symbols) {
  std::set<std::string> symbols;
  for (std::size_t a = 0; a < static_cast<std::size_t>(Ack::count); ++a)
    if (const auto s = symbol(static_cast<Ack>(a))) symbols.insert(name(*s));
  EXPECT_EQ(symbols, (std::set<std::string>{"MO02", "MO05", "MO08", "MO10", "MO15", "MO17", "MO20", "MO22"}));
}

TEST(Driver, Status_symbols_appear_in_the_modes_that_have_them) {
  ShowContext c = cab(Mode::FS, Level::L2);
  c.override_active = c.brake_commanded = c.slippery_rail = c.reversing_possible = c.lx_not_protected = true;
  c.lssma = c.track_ahead_free_asked = true;
  ASSERT_TRUE(c.track_conditions.push_back(Symbol::TC36));
  ASSERT_TRUE(c.track_conditions.push_back(Symbol::TC05));
  c.radio = RadioIndication::up;
  EXPECT_EQ(list(show(c)), (Symbols{"MO11", "LE04", "ST02", "LX01", "TC05", "ST06", "ST01", "ST03", "TC36"}));
  c.mode = Mode::SR;
  c.track_conditions.clear();  // by the mode, where they are found
  c.radio = RadioIndication::failed;
  EXPECT_EQ(list(show(c)), (Symbols{"MO09", "LE04", "ST02", "MO03", "ST01", "DR02", "ST04"}));
  c.mode = Mode::LS;
  const Symbols in_ls = list(show(c));
  EXPECT_EQ(std::count(in_ls.begin(), in_ls.end(), "LS01"), 1);
}

TEST(Driver, Track_conditions_have_the_symbols_of_015560) {
  using enum TrackConditionKind;
  using enum ConditionPhase;
  ByTrain by_train;
  const auto named = [&](TrackConditionKind kind) {
    Symbols symbols;
    for (const ConditionPhase phase : {ahead, announced, active, ending, over})
      if (const auto s = symbol(kind, phase, by_train)) symbols.push_back(name(*s));
    return symbols;
  };
  EXPECT_EQ(named(powerless_lower_pantograph), (Symbols{"TC03", "TC01", "TC05"}));
  EXPECT_EQ(named(powerless_main_switch_off), (Symbols{"TC07", "TC06", "TC09"}));
  EXPECT_EQ(named(non_stopping_area), (Symbols{"TC11", "TC10"}));
  EXPECT_EQ(named(radio_hole), (Symbols{"TC12"}));
  EXPECT_EQ(named(switch_off_magnetic_shoe_brake), (Symbols{"TC14", "TC13"}));
  EXPECT_EQ(named(switch_off_eddy_current_service_brake), (Symbols{"TC16", "TC15"}));
  EXPECT_EQ(named(switch_off_eddy_current_emergency_brake), (Symbols{"TC16", "TC15"}));
  EXPECT_EQ(named(switch_off_regenerative_brake), (Symbols{"TC18", "TC17"}));
  EXPECT_EQ(named(air_tightness), (Symbols{"TC21", "TC19", "TC22"}));
  EXPECT_EQ(named(sound_horn), (Symbols{"TC35"}));
  EXPECT_EQ(named(tunnel_stopping_area), (Symbols{"TC37", "TC36"}));
  const auto traction = [&] {
    Symbols symbols;
    for (std::uint8_t M_VOLTAGE = 0; M_VOLTAGE < 7; ++M_VOLTAGE)
      for (const ConditionPhase phase : {announced, active, ending})
        if (const auto s = symbol_of_traction(M_VOLTAGE, phase, by_train)) symbols.push_back(name(*s));
    return symbols;
  };
  EXPECT_EQ(traction(),
            (Symbols{"TC24", "TC23", "TC26", "TC25", "TC28", "TC27", "TC30", "TC29", "TC32", "TC31", "TC34", "TC33"}));
  // What the train does by itself is announced in grey.
  by_train.conditions.fill(true);
  by_train.traction_system = true;
  EXPECT_EQ(named(powerless_lower_pantograph), (Symbols{"TC02", "TC01", "TC04"}));
  EXPECT_EQ(named(powerless_main_switch_off), (Symbols{"TC06", "TC06", "TC08"}));
  EXPECT_EQ(named(non_stopping_area), (Symbols{"TC11", "TC10"}));
  EXPECT_EQ(named(radio_hole), (Symbols{"TC12"}));
  EXPECT_EQ(named(switch_off_magnetic_shoe_brake), (Symbols{"TC13", "TC13"}));
  EXPECT_EQ(named(switch_off_eddy_current_service_brake), (Symbols{"TC15", "TC15"}));
  EXPECT_EQ(named(switch_off_eddy_current_emergency_brake), (Symbols{"TC15", "TC15"}));
  EXPECT_EQ(named(switch_off_regenerative_brake), (Symbols{"TC17", "TC17"}));
  EXPECT_EQ(named(air_tightness), (Symbols{"TC19", "TC19", "TC20"}));
  EXPECT_EQ(named(sound_horn), (Symbols{"TC35"}));
  EXPECT_EQ(named(tunnel_stopping_area), (Symbols{"TC37", "TC36"}));
  EXPECT_EQ(traction(),
            (Symbols{"TC23", "TC23", "TC25", "TC25", "TC27", "TC27", "TC29", "TC29", "TC31", "TC31", "TC33", "TC33"}));
}

/// 015560 8.3.4
TEST(Driver, Symbols_of_the_advance_display) {
  using enum TrackConditionKind;
  ByTrain by_train;
  const auto named = [&](TrackConditionKind kind) {
    Symbols names;
    for (const bool end : {false, true})
      if (const auto s = planning_symbol(kind, end, by_train)) names.push_back(name(*s));
    return names;
  };
  EXPECT_EQ(named(powerless_lower_pantograph), (Symbols{"PL02", "PL04"}));
  EXPECT_EQ(named(powerless_main_switch_off), (Symbols{"PL06", "PL08"}));
  EXPECT_EQ(named(non_stopping_area), (Symbols{"PL09"}));
  EXPECT_EQ(named(radio_hole), (Symbols{"PL10"}));
  EXPECT_EQ(named(switch_off_magnetic_shoe_brake), (Symbols{"PL12"}));
  EXPECT_EQ(named(switch_off_eddy_current_service_brake), (Symbols{"PL14"}));
  EXPECT_EQ(named(switch_off_eddy_current_emergency_brake), (Symbols{"PL14"}));
  EXPECT_EQ(named(switch_off_regenerative_brake), (Symbols{"PL16"}));
  EXPECT_EQ(named(air_tightness), (Symbols{"PL19", "PL20"}));
  EXPECT_EQ(named(sound_horn), (Symbols{"PL24"}));
  EXPECT_EQ(named(tunnel_stopping_area), Symbols{});
  const auto traction = [&] {
    Symbols symbols;
    for (std::uint8_t M_VOLTAGE = 0; M_VOLTAGE < 7; ++M_VOLTAGE)
      if (const auto s = planning_symbol_of_traction(M_VOLTAGE, by_train)) symbols.push_back(name(*s));
    return symbols;
  };
  EXPECT_EQ(traction(), (Symbols{"PL26", "PL28", "PL30", "PL32", "PL34", "PL36"}));
  by_train.conditions.fill(true);
  by_train.traction_system = true;
  EXPECT_EQ(named(powerless_lower_pantograph), (Symbols{"PL01", "PL03"}));
  EXPECT_EQ(named(powerless_main_switch_off), (Symbols{"PL05", "PL07"}));
  EXPECT_EQ(named(non_stopping_area), (Symbols{"PL09"}));
  EXPECT_EQ(named(radio_hole), (Symbols{"PL10"}));
  EXPECT_EQ(named(switch_off_magnetic_shoe_brake), (Symbols{"PL11"}));
  EXPECT_EQ(named(switch_off_eddy_current_service_brake), (Symbols{"PL13"}));
  EXPECT_EQ(named(switch_off_eddy_current_emergency_brake), (Symbols{"PL13"}));
  EXPECT_EQ(named(switch_off_regenerative_brake), (Symbols{"PL15"}));
  EXPECT_EQ(named(air_tightness), (Symbols{"PL17", "PL18"}));
  EXPECT_EQ(named(sound_horn), (Symbols{"PL24"}));
  EXPECT_EQ(named(tunnel_stopping_area), Symbols{});
  EXPECT_EQ(traction(), (Symbols{"PL25", "PL27", "PL29", "PL31", "PL33", "PL35"}));
}

TEST(Driver, Trip_reasons) {
  for (const int n : {12, 16, 17, 18, 20, 35, 36, 38, 39, 41, 42, 43, 49, 52, 54, 65, 66, 67, 69})
    EXPECT_TRUE(trip_reason(n).has_value()) << n;
  EXPECT_FALSE(trip_reason(28).has_value());
  EXPECT_EQ(trip_reason(12), StatusText::passing_of_EOA_or_LOA);
  EXPECT_STREQ(name(StatusText::passing_of_EOA_or_LOA), "Unauthorized passing of EOA / LOA");
}

}  // namespace
}  // namespace evc::driver
