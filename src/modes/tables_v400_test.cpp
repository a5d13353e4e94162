#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/test_paths.h"
#include "modes/acceptance_tables_v400.h"
#include "modes/active_functions.h"
#include "modes/conditions.h"
#include "modes/srs_4_6_2_v400.h"
#include "modes/stored_information.h"

// The tables of 4.0.0 with all 19 modes against a second reading of its pages.
namespace evc::modes {
namespace {

using nlohmann::json;

using Rows = std::map<std::string, std::vector<std::string>>;

Rows rows_v400(const char* table) {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/mode_tables_v400.json");
  const json file = json::parse(in);
  Rows rows;
  for (const auto& [id, row] : file[table].items()) {
    std::istringstream words(row.get<std::string>());
    for (std::string word; words >> word;)
      if (word != "|") rows[id].push_back(word);
  }
  return rows;
}

std::string cell_text(const AcceptanceCell& cell) {
  const char* marks[] = {"-", "A", "R", "NR"};
  std::string out = marks[static_cast<int>(cell.mark)];
  for (unsigned n = 1; n < 32; ++n)
    if ((cell.notes >> n) & 1u) out += "[" + std::to_string(n) + "]";
  return out;
}

/// Without the exceptions that acceptance_tables_v400.h leaves out, the others in the order of their numbers.
std::string without(const std::string& cell, const std::set<int>& left_out) {
  std::set<int> notes;
  const std::regex number("\\[(\\d+)\\]");
  for (std::sregex_iterator i(cell.begin(), cell.end(), number), end; i != end; ++i)
    if (const int n = std::stoi((*i)[1]); left_out.count(n) == 0) notes.insert(n);
  std::string out = cell.substr(0, cell.find('['));
  for (const int n : notes) out += "[" + std::to_string(n) + "]";
  return out;
}

std::string reference_id(Information what, const Rows& rows) {
  const std::string id = name(what);
  if (rows.count(id) != 0) return id;
  if (id == "level_transition_order" || id == "conditional_level_transition_order") return "level_transition_orders";
  return "track_conditions_no_bmm";
}

/// Not in the tables of 4.0.0: what the version of the trackside was sent in before.
bool before_4_0_0(Information what) {
  return what == Information::trackside_system_version || what == Information::system_version_order ||
         what == Information::session_initiation;
}

TEST(Acceptance_4_0_0, By_mode_is_4_8_4) {
  const Rows rows = rows_v400("4_8_4");
  for (const AcceptanceByMode& row : srs_4_8_4_v400) {
    if (before_4_0_0(row.what)) {  // in a new mode as in the nearest one that 3.6.0 has
      const Mode nearest = row.what == Information::session_initiation ? Mode::SH : Mode::FS;
      EXPECT_EQ(cell_text(row.modes[terms::index(Mode::SM)]), cell_text(row.modes[terms::index(nearest)]));
      continue;
    }
    const std::string id = reference_id(row.what, rows);
    ASSERT_EQ(rows.count(id), 1u) << id;
    for (std::size_t m = 0; m < kModes; ++m)
      EXPECT_EQ(cell_text(row.modes[m]), without(rows.at(id)[m], {13, 14})) << id << name(static_cast<Mode>(m));
  }
}

TEST(Acceptance_4_0_0, By_level_is_4_8_3) {
  const Rows rows = rows_v400("4_8_3");
  constexpr std::size_t levels = 4;  // there is no level 3
  for (const AcceptanceByLevel& row : srs_4_8_3_v400) {
    if (before_4_0_0(row.what)) continue;
    const std::string id = reference_id(row.what, rows);
    ASSERT_EQ(rows.count(id), 1u) << id;
    for (std::size_t l = 0; l < levels; ++l) {
      const std::string level = name(static_cast<Level>(l));
      EXPECT_EQ(cell_text(row.not_rbc[l]), without(rows.at(id)[l], {15})) << id << level;
      if (row.what == Information::track_condition_bmm) continue;  // no RBC of a version up to 2.1 sends it
      EXPECT_EQ(cell_text(row.rbc[l]), without(rows.at(id)[levels + l], {})) << id << level;
    }
  }
}

TEST(Stored_4_0_0, Is_4_10) {
  const Rows rows = rows_v400("4_10");
  const std::map<std::string, Fate> fates{{"U", Fate::unchanged},
                                          {"D", Fate::deleted},
                                          {"TBR", Fate::to_be_revalidated},
                                          {"R", Fate::reset},
                                          {"NR", Fate::not_relevant}};
  const auto expect_row = [&](const std::string& id, const auto& fate_in) {
    ASSERT_EQ(rows.count(id), 1u) << id;
    for (std::size_t m = 0; m < kModes; ++m)
      EXPECT_EQ(fate_in(static_cast<Mode>(m)), fates.at(without(rows.at(id)[m], {1})))
          << id << name(static_cast<Mode>(m));
  };
  for (const Mode from : {Mode::FS, Mode::SH, Mode::PS}) {
    for (std::size_t i = 0; i < kStored; ++i) {
      const Stored stored = static_cast<Stored>(i);
      const bool order = stored == Stored::level_transition_order;
      expect_row(order ? "level_transition_announcement" : name(stored),
                 [&](Mode to) { return on_entry(to, from, stored, SrsVersion::v4_0_0); });
    }
    expect_row("level_transition_order_immediate_conditional",
               [&](Mode to) { return kept_level_order_on_entry(to, from, SrsVersion::v4_0_0); });
  }
}

TEST(Functions_4_0_0, Are_4_5_2) {
  const Rows rows = rows_v400("4_5_2");
  std::size_t compared = 0;
  for (std::size_t i = 0; i < kFunctions; ++i) {
    const Function function = static_cast<Function>(i);
    const auto row = rows.find(name(function));
    if (row == rows.end()) {
      // Other paragraphs decide: SM is as FS but for what 4.8.4 rejects, and for its default train data.
      const bool unlike_FS = function == Function::coop_ma_shortening || function == Function::route_suitability ||
                             function == Function::supervise_trip_signal_speed ||
                             function == Function::track_ahead_free || function == Function::train_data_external_change;
      EXPECT_EQ(activity(function, Mode::SM, SrsVersion::v4_0_0),
                unlike_FS ? Activity::inactive : activity(function, Mode::FS, SrsVersion::v4_0_0))
          << name(function);
      continue;
    }
    for (std::size_t m = 0; m < kModes; ++m) {
      const std::string& says = row->second[m];
      const Mode in = static_cast<Mode>(m);
      if (says[0] == '?' || says == "NR") continue;
      ++compared;
      EXPECT_EQ(activity(function, in, SrsVersion::v4_0_0) == Activity::active, says[0] == 'X')
          << name(function) << name(in);
    }
  }
  EXPECT_GT(compared, 500u);
}

TEST(Conditions_4_0_0, Are_those_of_the_table_and_no_others) {
  std::set<int> used, rows;
  for (const Cell<Mode>& cell : v400::srs_4_6_2)
    for (const std::uint8_t n : cell.when)
      if (n != 0) used.insert(n);
  for (const Condition& c : srs_4_6_3) rows.insert(c.number);
  for (const Condition& c : srs_4_6_3_v400) rows.insert(c.number);
  EXPECT_EQ(used, rows);
  const std::map<std::string, Nature> natures{
      {"event", Nature::event}, {"state", Nature::state}, {"level", Nature::level}};
  const Rows reference = rows_v400("4_6_3");
  EXPECT_EQ(reference.size(), srs_4_6_3_v400.size());
  for (const Condition& c : srs_4_6_3_v400)
    EXPECT_EQ(c.nature, natures.at(reference.at(std::to_string(c.number))[0])) << int{c.number};
  for (const int n : used) EXPECT_NE(meaning(n), nullptr) << n;
}

}  // namespace
}  // namespace evc::modes
