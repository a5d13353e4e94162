#include "driver/buttons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/test_paths.h"
#include "texts/texts.h"

namespace evc::driver {
namespace {

using nlohmann::json;

/// tests/reference/dmi_buttons.json: the conditions of 015560 11.2, the modes, and cases.
const json& buttons_reference() {
  static const json file = [] {
    std::ifstream in(evc::test::source_folder() + "/tests/reference/dmi_buttons.json");
    return json::parse(in);
  }();
  return file;
}

Mode mode_named(const std::string& text) {
  for (const auto& row : kModeRows)
    if (text == row.name) return row.value;
  throw std::invalid_argument(text);
}
Level level_named(const std::string& text) {
  for (const auto& row : kLevelRows)
    if (text == row.name) return row.value;
  throw std::invalid_argument(text);
}
Button button_named(const std::string& text) {
  for (const auto& row : kButtonRows)
    if (text == row.name) return row.value;
  throw std::invalid_argument(text);
}

/// What a word of the reference says, set and asked for in a context.
struct Word {
  std::function<void(ButtonContext&, bool)> set;
  std::function<bool(const ButtonContext&)> holds;
};
Word of(bool ButtonContext::*field) {
  return {[field](ButtonContext& c, bool on) { c.*field = on; }, [field](const ButtonContext& c) { return c.*field; }};
}
Word of(bool ActionContext::*field) {
  return {[field](ButtonContext& c, bool on) { c.action.*field = on; },
          [field](const ButtonContext& c) { return c.action.*field; }};
}

/// The networks that Table 37 requires, in its own words.
bool required_networks(const ButtonContext& c) {
  const bool only_frmcs = c.frmcs.fitted && !c.gsmr.fitted;
  const bool only_gsmr = c.gsmr.fitted && !c.frmcs.fitted;
  if (c.network_type == NetworkType::frmcs || (c.network_type == NetworkType::both && only_frmcs))
    return c.frmcs.registered;
  if (c.network_type == NetworkType::gsmr || (c.network_type == NetworkType::both && only_gsmr))
    return c.gsmr.registered;
  if (c.one_radio_system) return c.gsmr.registered || c.frmcs.registered;
  return c.gsmr.registered && c.frmcs.registered;
}
bool both_fitted(const ButtonContext& c) {
  return c.network_type == NetworkType::both && c.gsmr.fitted && c.frmcs.fitted;
}
bool short_number(const ButtonContext& c) {
  const bool only_gsmr = c.network_type == NetworkType::both && c.gsmr.fitted && !c.frmcs.fitted;
  return c.gsmr.registered && (c.network_type == NetworkType::gsmr || only_gsmr ||
                               (both_fitted(c) && (c.frmcs.registered || c.one_radio_system)));
}

const std::map<std::string, Word>& words() {
  using A = ActionContext;
  using C = ButtonContext;
  static const std::map<std::string, Word> all{
      {"standstill", of(&A::standstill)},
      {"driver_id", of(&A::driver_id_valid)},
      {"level",
       {[](C& c, bool on) { c.action.level = on ? std::optional(Level::L1) : std::nullopt; },
        [](const C& c) { return c.action.level.has_value(); }}},
      {"train_data", of(&A::train_data_valid)},
      {"trn", of(&A::train_running_number_valid)},
      {"session", of(&A::session_open)},
      {"train_data_acked", of(&A::train_data_acknowledged)},
      {"emergency_stop", of(&C::emergency_stop_pending)},
      {"nv_driver_id_running", of(&A::driver_id_while_running)},
      {"nv_adhesion_by_driver", of(&A::driver_may_change_adhesion)},
      {"non_leading_signal", of(&A::non_leading_signal)},
      {"passive_shunting_signal", of(&A::passive_shunting_signal)},
      {"slow", of(&A::slow_enough_for_override)},
      {"position", of(&C::position_valid)},
      {"length_in_range", of(&C::length_in_range)},
      {"vbc_stored", of(&C::cover_stored)},
      {"vbc_full", of(&C::covers_full)},
      {"contact", of(&C::contact_known)},
      {"alarm_inhibited", of(&A::alarm_inhibited)},
      {"consist", of(&C::consist_known)},
      {"consist_in_front",
       {[](C& c, bool on) { c.consist_known = c.consist_in_front = on; },
        [](const C& c) { return c.consist_known && c.consist_in_front; }}},
      {"consist_acked", of(&C::consist_acknowledged)},
      {"rbc_above_2_2",
       {[](C& c, bool on) {
          c.session_above_2_2 = on;
          if (on) c.action.session_open = true;
        },
        [](const C& c) { return c.action.session_open && c.session_above_2_2; }}},
      {"second_session", of(&C::second_session)},
      {"rbc_transition", of(&C::RBC_transition_ordered)},
      {"networks", {[](C& c, bool on) { c.gsmr.registered = on; }, required_networks}},
      {"short_number", {[](C& c, bool on) { c.gsmr.registered = on; }, short_number}},
      {"gsm_r_in_type",
       {[](C& c, bool on) { c.network_type = on ? NetworkType::gsmr : NetworkType::frmcs; },
        [](const C& c) { return c.network_type != NetworkType::frmcs; }}},
      {"one_of_two_registered",
       {[](C& c, bool on) {
          c.network_type = on ? NetworkType::both : NetworkType::gsmr;
          c.gsmr = {.fitted = true, .registered = true};
          c.frmcs = {.fitted = on, .registered = false};
        },
        [](const C& c) { return both_fitted(c) && c.gsmr.registered != c.frmcs.registered; }}},
  };
  return all;
}

/// With an open desk and what procedures offer, nothing else.
ButtonContext neutral(SrsVersion srs) {
  ButtonContext c;
  c.action.srs = srs;
  c.action.desk_open = true;
  c.action.offers = Set<Offer>::of_bits(~0u);
  c.action.network_offered = true;
  c.gsmr.fitted = true;
  return c;
}

/// With what depends on others in a unit.
ButtonContext complete(ButtonContext c) {
  c.action.alarm_may_be_inhibited =
      c.action.srs == SrsVersion::v4_0_0 && c.action.level && level_1_2_3(*c.action.level);
  c.inputs = enabled(c.action);
  return c;
}
Set<Button> buttons_of(const ButtonContext& c) { return buttons(complete(c)); }
/// By Tables 33 to 37 alone: 4.7.2 closes nothing.
Set<Button> by_the_tables(const ButtonContext& c) {
  ButtonContext open = complete(c);
  open.inputs = Set<Input>::of_bits(~std::uint64_t{0});
  return buttons(open);
}

bool in(const json& list, const std::string& text) { return std::find(list.begin(), list.end(), text) != list.end(); }

bool alternative_holds(const json& alternative, const ButtonContext& c) {
  const auto word = [&c](const json& text) { return words().at(text).holds(c); };
  if (!in(alternative["modes"], name(c.action.mode))) return false;
  if (!alternative["levels"].empty() && !(c.action.level && in(alternative["levels"], name(*c.action.level))))
    return false;
  return std::all_of(alternative["needs"].begin(), alternative["needs"].end(), word) &&
         std::none_of(alternative["without"].begin(), alternative["without"].end(), word);
}

/// Each button of the reference with its alternatives.
std::vector<std::pair<std::string, json>> conditions() {
  std::vector<std::pair<std::string, json>> out;
  for (const auto& [window, of_window] : buttons_reference()["conditions"].items())
    for (const auto& [button, alternatives] : of_window.items()) out.emplace_back(button, alternatives);
  return out;
}
bool any_holds(const json& alternatives, const ButtonContext& c) {
  return std::any_of(alternatives.begin(), alternatives.end(),
                     [&c](const json& alternative) { return alternative_holds(alternative, c); });
}

/// The alternative and no more, in one of its modes and levels.
ButtonContext satisfying(const json& alternative, const std::string& mode, const std::string& level) {
  ButtonContext c = neutral(SrsVersion::v4_0_0);
  c.action.mode = mode_named(mode);
  for (const json& word : alternative["needs"]) words().at(word).set(c, true);
  if (!level.empty()) c.action.level = level_named(level);
  return c;
}

std::vector<std::string> levels_of(const json& alternative) {
  std::vector<std::string> levels = alternative["levels"];
  if (levels.empty()) levels.emplace_back();
  return levels;
}

/// 4.7.2 asks for more than the tables: valid train data for an override, a valid level for what an RBC gives, a
/// confirmation of the train's integrity in SM and without train data is not supported.
bool narrowed_by_4_7_2(const std::string& button, const ButtonContext& c) {
  const std::optional<Input> input = input_of(button_named(button));
  return input && !complete(c).inputs.has(*input);
}

TEST(Buttons, Every_button_has_its_conditions_in_the_reference) {
  std::set<std::string> named;
  for (const auto& [button, alternatives] : conditions()) named.insert(button);
  EXPECT_EQ(named.size(), kButtonRows.size());
  for (const auto& row : kButtonRows) EXPECT_EQ(named.count(row.name), 1u) << row.name;
}

TEST(Buttons, Each_alternative_enables_its_button_and_each_missing_term_does_not) {
  int seen = 0, refused = 0;
  for (const auto& [button, alternatives] : conditions())
    for (const json& alternative : alternatives)
      for (const std::string mode : alternative["modes"])
        for (const std::string& level : levels_of(alternative)) {
          const ButtonContext c = satisfying(alternative, mode, level);
          const std::string where = button + ' ' + mode + ' ' + level + ' ' + alternative.dump();
          EXPECT_TRUE(by_the_tables(c).has(button_named(button))) << where;
          if (narrowed_by_4_7_2(button, c)) continue;
          EXPECT_TRUE(buttons_of(c).has(button_named(button))) << where;
          ++seen;
          const auto without = [&](const std::string& word, bool value) {
            ButtonContext less = c;
            words().at(word).set(less, value);
            if (any_holds(alternatives, less)) return;
            EXPECT_FALSE(by_the_tables(less).has(button_named(button))) << where << " but " << word;
            EXPECT_FALSE(buttons_of(less).has(button_named(button))) << where << " but " << word;
            ++refused;
          };
          for (const std::string word : alternative["needs"]) without(word, false);
          for (const std::string word : alternative["without"]) without(word, true);
        }
  EXPECT_GT(seen, 300);
  EXPECT_GT(refused, 400);
}

TEST(Buttons, In_any_situation_they_are_those_of_the_tables) {
  std::mt19937 random(7);
  const auto coin = [&random] { return random() % 2 == 0; };
  std::map<std::string, int> on, off;
  for (int n = 0; n < 20000; ++n) {
    ButtonContext c = neutral(static_cast<SrsVersion>(random() % kSrsVersionRows.size()));
    const bool newer = c.action.srs == SrsVersion::v4_0_0;
    for (const auto& [text, word] : words()) word.set(c, random() % 4 != 0);
    // Many conditions name what seldom is.
    for (bool ButtonContext::*rare : {&ButtonContext::consist_in_front, &ButtonContext::RBC_transition_ordered,
                                      &ButtonContext::second_session, &ButtonContext::emergency_stop_pending})
      c.*rare = random() % 4 == 0;
    c.network_type = static_cast<NetworkType>(random() % 3);
    c.gsmr = {.fitted = coin(), .registered = coin()};
    c.frmcs = {.fitted = !c.gsmr.fitted || coin(), .registered = coin()};  // one of them is
    c.one_radio_system = coin();
    c.action.mode = static_cast<Mode>(random() % (newer ? kModes : kModesOf3));
    c.action.level = static_cast<Level>(random() % (newer ? kLevels - 1 : kLevels));
    if (random() % 4 == 0) c.action.level.reset();
    const Set<Button> enabled_now = buttons_of(c), of_tables = by_the_tables(c);
    for (const auto& [button, alternatives] : conditions()) {
      const bool of_edition = newer || !in(buttons_reference()["only_4_0_0"], button);
      const bool by_table = of_edition && any_holds(alternatives, c);
      ASSERT_EQ(of_tables.has(button_named(button)), by_table)
          << button << ' ' << name(c.action.mode) << ' ' << name(c.action.srs);
      const bool expected = by_table && !narrowed_by_4_7_2(button, c);
      ASSERT_EQ(enabled_now.has(button_named(button)), expected)
          << button << ' ' << name(c.action.mode) << ' ' << name(c.action.srs);
      ++(expected ? on : off)[button];
    }
  }
  for (const auto& row : kButtonRows) {
    EXPECT_GT(on[row.name], 0) << row.name;
    EXPECT_GT(off[row.name], 0) << row.name;
  }
}

/// No button is enabled whose input 4.7.2 refuses, and an input that is enabled has its button but for what the start
/// of mission opens by itself (11.7.2) and what the tables ask for more than 4.7.2.
TEST(Buttons, Agree_with_the_inputs_of_4_7_2) {
  std::mt19937 random(8);
  for (int n = 0; n < 5000; ++n) {
    ButtonContext c = neutral(static_cast<SrsVersion>(random() % kSrsVersionRows.size()));
    for (const auto& [text, word] : words()) word.set(c, random() % 3 != 0);
    c.action.mode = static_cast<Mode>(random() % kModes);
    c.action.level = static_cast<Level>(random() % kLevels);
    c.action.offers = Set<Offer>::of_bits(random());
    c.action.requests = random() % 4 == 0 ? Set<Ack>::of_bits(random()) : Set<Ack>{};
    c.action.desk_open = random() % 8 != 0;
    c.action.alarm_may_be_inhibited = random() % 2 == 0;
    c.inputs = enabled(c.action);
    const Set<Button> shown = buttons(c);
    for (const auto& row : kButtonRows) {
      const std::optional<Input> input = input_of(row.value);
      EXPECT_TRUE(!input || !shown.has(row.value) || c.inputs.has(*input)) << row.name << ' ' << name(c.action.mode);
    }
    EXPECT_TRUE((c.action.desk_open && c.action.requests.empty()) || shown.empty());
    // Those that the tables ask no more for.
    for (const Button button : {Button::level, Button::exit_shunting, Button::maintain_shunting, Button::language,
                                Button::sr_speed_distance, Button::exit_sm, Button::non_leading}) {
      if (button == Button::exit_sm && c.action.srs != SrsVersion::v4_0_0) continue;
      EXPECT_EQ(shown.has(button), c.inputs.has(*input_of(button))) << name(button) << ' ' << name(c.action.mode);
    }
  }
}

TEST(Buttons, Are_in_the_modes_of_the_standard) {
  std::map<std::string, std::set<std::string>> modes;
  for (const auto& [button, alternatives] : conditions())
    for (const json& alternative : alternatives)
      for (const std::string mode : alternative["modes"]) {
        for (const std::string& level : levels_of(alternative)) {
          ButtonContext c = satisfying(alternative, mode, level);
          const auto on = [&] { return buttons_of(c).has(button_named(button)); };
          if (on()) modes[button].insert(mode);
          // What 4.7.2 asks for in addition.
          c.action.train_data_valid = c.action.driver_id_valid = true;
          if (!c.action.level) c.action.level = Level::L2;
          if (on()) modes[button].insert(mode);
        }
      }
  int compared = 0;
  for (const auto& [buttons, expected] : buttons_reference()["buttons_by_mode"].items()) {
    // Rows that several buttons share are separated by a slash, as is one label.
    std::vector<std::string> labels;
    if (buttons == "SR speed / distance") {
      labels.push_back(buttons);
    } else {
      std::istringstream all(buttons);
      for (std::string label; std::getline(all, label, '/');) labels.push_back(label);
    }
    for (const std::string& label : labels) {
      EXPECT_EQ(modes[label], expected.get<std::set<std::string>>()) << label;
      ++compared;
    }
  }
  EXPECT_EQ(compared, static_cast<int>(kButtonRows.size()) - 1);  // one row for both labels of the antenna alarm
}

/// The context of a case of the reference, in which everything else is neutral.
ButtonContext given(const json& g) {
  ButtonContext c = neutral(SrsVersion::v4_0_0);
  const auto flag = [&g](const char* key) { return g.value(key, false); };
  ActionContext& a = c.action;
  a.mode = mode_named(g["mode"]);
  if (g.value("level_valid", false)) a.level = level_named(g["level"]);
  a.standstill = flag("standstill");
  a.driver_id_valid = g.value("driver_id", "") == "valid";
  a.train_data_valid = g.value("train_data", "") == "valid";
  a.train_running_number_valid = g.value("trn", "") == "valid";
  a.session_open = flag("session");
  a.train_data_acknowledged = flag("train_data_acked");
  a.non_leading_signal = flag("non_leading_signal");
  a.passive_shunting_signal = flag("passive_shunting_signal");
  a.slow_enough_for_override = g.value("v", 0.0) <= g.value("v_override_limit", 0.0);
  a.driver_may_change_adhesion = flag("nv_adhesion_by_driver");
  a.driver_id_while_running = flag("nv_driver_id_running");
  if (flag("ack_pending")) a.requests = {Ack::text};
  c.emergency_stop_pending = flag("pending_emergency_stop");
  c.position_valid = flag("position_valid_lrbg");
  c.length_in_range = flag("integrity_range_ok");
  c.cover_stored = g.value("vbc_count", 0) > 0;
  c.covers_full = g.contains("vbc_capacity") && g.value("vbc_count", 0) >= g["vbc_capacity"];
  c.contact_known = g.value("rbc_contact", "unknown") != "unknown";
  c.consist_known = flag("safe_consist_length");
  c.consist_in_front = g.value("consist_front_m", 0) > 0;
  c.network_type = g.value("radio_type", "GSM-R") == "FRMCS" ? NetworkType::frmcs : NetworkType::gsmr;
  c.gsmr.registered = flag("gsmr_registered");
  c.frmcs = {.fitted = c.network_type == NetworkType::frmcs, .registered = flag("frmcs_registered")};
  return c;
}

TEST(Buttons, Are_enabled_in_the_cases_of_the_reference) {
  EXPECT_EQ(buttons_reference()["cases"].size(), 60u);
  for (const json& one : buttons_reference()["cases"])
    EXPECT_EQ(buttons_of(given(one["given"])).has(button_named(one["button"])), one["enabled"].get<bool>())
        << one.dump();
}

}  // namespace
}  // namespace evc::driver
