#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "base/test_paths.h"
#include "modes/acceptance_tables_v400.h"
#include "modes/active_functions.h"
#include "modes/conditions.h"
#include "modes/levels.h"
#include "modes/mode_properties.h"
#include "modes/srs_4_6_2.h"
#include "modes/srs_4_6_2_v400.h"
#include "modes/stored_information.h"

// Every table of this room against the reference data, cell by cell, both ways.
namespace evc::modes {
namespace {

using nlohmann::json;

json reference(const std::string& file) {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/" + file);
  return json::parse(in);
}

Mode mode(const std::string& abbreviation) {
  for (std::size_t i = 0; i < kModes; ++i)
    if (abbreviation == name(static_cast<Mode>(i))) return static_cast<Mode>(i);
  ADD_FAILURE() << abbreviation;
  return Mode::NP;
}

using Cells = std::map<std::pair<std::string, std::string>, std::pair<std::vector<int>, int>>;

Cells cells_of(const json& file) {
  Cells cells;
  for (const json& t : file["transitions"])
    cells[{t["from"], t["to"]}] = {t["conditions"].get<std::vector<int>>(),
                                   std::stoi(t["priority"].get<std::string>().substr(1))};
  return cells;
}

template <class M, std::size_t N>
Cells cells_of(const std::array<Cell<M>, N>& table) {
  Cells cells;
  for (const Cell<M>& c : table) {
    std::vector<int> numbers;
    for (const std::uint8_t n : c.when)
      if (n != 0) numbers.push_back(n);
    cells[{name(c.from), name(c.to)}] = {numbers, c.priority};
  }
  return cells;
}

/// Information that only 4.0.0 has, of supervised manoeuvre: tables_v400_test.cpp.
bool of_manoeuvre(Information what) {
  return what == Information::movement_authority_sm || what == Information::sm_refused ||
         what == Information::safe_consist_length_ack;
}
constexpr std::size_t kOf_4_0_0 = 3;

TEST(ModeTable, Is_the_matrix_of_4_6_2) {
  EXPECT_EQ(cells_of(srs_4_6_2), cells_of(reference("mode_transitions.json")));
}

TEST(ModeTable, Of_4_0_0_is_its_matrix) {
  EXPECT_EQ(cells_of(v400::srs_4_6_2), cells_of(reference("mode_transitions_v400.json")));
}

TEST(ModeTable, Every_condition_of_every_cell_alone_takes_its_way_with_its_priority) {
  const json file = reference("mode_transitions.json");
  for (const json& t : file["transitions"])
    for (const int n : t["conditions"]) {
      const auto went = next_mode(mode(t["from"]), Conditions{n});
      ASSERT_TRUE(went.has_value());
      // One condition may be in two cells of one row: then the higher priority wins.
      int best = 99;
      std::string to;
      for (const json& other : file["transitions"]) {
        const auto numbers = other["conditions"].get<std::set<int>>();
        const int p = std::stoi(other["priority"].get<std::string>().substr(1));
        if (other["from"] == t["from"] && numbers.count(n) != 0 && p < best) {
          best = p;
          to = other["to"];
        }
      }
      EXPECT_STREQ(name(went->to), to.c_str()) << t;
      EXPECT_EQ(went->number, n);
      EXPECT_EQ(went->priority, best);
    }
}

TEST(Conditions, Are_those_of_4_6_3) {
  std::set<int> active;
  const json file = reference("mode_conditions.json");
  for (const json& c : file["conditions"]) {
    const int n = c["id"];
    if (c["status"] != "active") {
      for (const Condition& row : srs_4_6_3) EXPECT_NE(row.number, n);
      continue;
    }
    active.insert(n);
    ASSERT_NE(meaning(n), nullptr) << n;
    // The table contains a condition if the reference does.
    std::set<std::string> used;
    for (const Cell<Mode>& cell : srs_4_6_2)
      if (cell.any.test(n)) used.insert(std::string(name(cell.from)) + ">" + name(cell.to));
    EXPECT_EQ(used, c["used_by"].get<std::set<std::string>>()) << n;
  }
  EXPECT_EQ(active.size(), srs_4_6_3.size());
  for (const Condition& row : srs_4_6_3) EXPECT_EQ(active.count(row.number), 1u) << int{row.number};
}

TEST(Conditions, Have_the_nature_of_the_reference_but_for_its_corrections) {
  const json file = reference("mode_conditions.json");
  for (const json& c : file["conditions"]) {
    if (c["status"] != "active") continue;
    const int n = c["id"];
    bool event = c["kind"] == "event";
    if (n == 43) event = true;  // passing the former EOA is an edge (5.8.4.1 c)
    if (n == 1) event = false;  // the device may be operated without power: its state counts
    const bool level_switch = c["expr"].get<std::string>().find("level_switch") != std::string::npos;
    for (const Condition& row : srs_4_6_3)
      if (row.number == n) {
        EXPECT_EQ(row.nature != Nature::state, event) << n;
        EXPECT_EQ(row.nature == Nature::level, level_switch) << n;
      }
  }
}

std::string text(const AcceptanceCell& cell) {
  const char* marks[] = {"-", "A", "R", "NR"};
  std::string out = marks[static_cast<int>(cell.mark)];
  for (unsigned n = 1; n < 32; ++n)
    if ((cell.notes >> n) & 1u) out += "[" + std::to_string(n) + "]";
  return out;
}

std::string text(const json& cell) {
  if (cell.is_null()) return "-";
  std::string out = cell["r"];
  for (const int n : cell["x"].get<std::set<int>>()) out += "[" + std::to_string(n) + "]";
  return out;
}

std::vector<std::string> informations(const std::string& id) {
  if (id == "track_conditions_no_bmm") return {"track_conditions_general", "track_conditions_horn_stopping"};
  if (id == "level_transition_orders") return {"level_transition_order", "conditional_level_transition_order"};
  return {id};
}

TEST(Acceptance, By_level_is_4_8_3) {
  const json file = reference("acceptance_by_level.json");
  std::map<std::string, const AcceptanceByLevel*> rows;
  for (const AcceptanceByLevel& row : srs_4_8_3) rows[name(row.what)] = &row;
  std::size_t compared = 0;
  for (const json& r : file["information"])
    for (const std::string& id : informations(r["id"])) {
      ASSERT_EQ(rows.count(id), 1u) << id;
      ++compared;
      for (std::size_t l = 0; l < kLevels; ++l) {
        const char* level = name(static_cast<Level>(l));
        const bool since_360 = id == "session_management" && l >= 3;
        EXPECT_EQ(text(rows[id]->not_rbc[l]), since_360 ? "A[14]" : text(r["non_RBC"][level])) << id << level;
        EXPECT_EQ(text(rows[id]->rbc[l]), text(r["RBC"][level])) << id << level;
      }
    }
  EXPECT_EQ(compared + kOf_4_0_0, srs_4_8_3.size());
  const char* columns[] = {"0", "NTC_X", "NTC_Y", "1", "2", "3"};
  for (std::size_t row = 0; row < 2; ++row)
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_EQ(text(srs_4_8_3_stm[row][c]), text(file["from_stm"][row][columns[c]])) << row << columns[c];
}

TEST(Acceptance, By_mode_is_4_8_4) {
  const json file = reference("acceptance_by_mode.json");
  std::map<std::string, const AcceptanceByMode*> rows;
  for (const AcceptanceByMode& row : srs_4_8_4) rows[name(row.what)] = &row;
  std::size_t compared = 0;
  for (const json& r : file["information"])
    for (const std::string& id : informations(r["id"])) {
      ASSERT_EQ(rows.count(id), 1u) << id;
      ++compared;
      for (std::size_t m = 0; m < kModesOf3; ++m) {
        const std::string column = name(static_cast<Mode>(m));
        const std::string changed = id + "/" + column;
        const json& v360 = file["_meta"]["v360"];
        const std::string expected =
            v360.contains(changed) ? v360[changed].get<std::string>() : text(r["modes"][column]);
        EXPECT_EQ(text(rows[id]->modes[m]), expected) << changed;
      }
    }
  EXPECT_EQ(compared + kOf_4_0_0, srs_4_8_4.size());
}

/// No trackside sends it to a unit of 3.x: where its text has no row, it is refused as what the mode does not know.
TEST(Acceptance, Of_a_manoeuvre_nothing_counts_in_3_x) {
  std::set<Information> rows;
  for (const auto& row : srs_4_8_4) {
    if (!of_manoeuvre(row.what)) continue;
    EXPECT_TRUE(rows.insert(row.what).second) << name(row.what);
    for (std::size_t m = 0; m < kModes; ++m) {
      const auto mode = static_cast<Mode>(m);
      const bool never = mode == Mode::NP || mode == Mode::SF || mode == Mode::IS;
      EXPECT_EQ(text(row.modes[m]), never ? "NR" : "R") << name(row.what) << " in " << name(mode);
    }
  }
  EXPECT_EQ(rows.size(), kOf_4_0_0);
  rows.clear();
  for (const auto& row : srs_4_8_3) {
    if (!of_manoeuvre(row.what)) continue;
    EXPECT_TRUE(rows.insert(row.what).second) << name(row.what);
    for (std::size_t l = 0; l < kLevels; ++l) {
      EXPECT_EQ(text(row.not_rbc[l]), "-") << name(row.what);
      EXPECT_EQ(text(row.rbc[l]), "R") << name(row.what);
    }
  }
  EXPECT_EQ(rows.size(), kOf_4_0_0);
}

/// Read from the pages of 4.0.0: where they differ from 3.6.0, the exceptions left out that acceptance_tables_v400.h
/// names.
TEST(Acceptance, Of_4_0_0_differs_in_these_cells_only) {
  std::map<std::string, std::string> by_mode{{"movement_authority/SB", "A[2][4][11]"},
                                             {"sr_authorisation/SB", "A[2][4][11]"},
                                             {"eolm/SH", "R"},
                                             {"lssma_toggle_on/OS", "A[10]"}};
  for (const char* id :
       {"linking", "signalling_speed", "movement_authority", "gradient", "ssp", "asp", "sr_authorisation", "tsr",
        "tsr_revocation", "route_suitability", "adhesion", "rbc_transition_order", "track_conditions_general",
        "track_conditions_horn_stopping", "track_condition_bmm", "reversing_area", "reversing_supervision",
        "permitted_braking_distance", "level_crossing"})
    by_mode[std::string(id) + "/PT"] = "A[1][4]";
  for (std::size_t i = 0; i < srs_4_8_4.size(); ++i)
    for (std::size_t m = 0; m < kModes && !of_manoeuvre(srs_4_8_4[i].what); ++m) {
      const std::string cell = std::string(name(srs_4_8_4[i].what)) + "/" + name(static_cast<Mode>(m));
      const auto changed = by_mode.find(cell);
      EXPECT_EQ(text(srs_4_8_4_v400[i].modes[m]),
                changed != by_mode.end() ? changed->second : text(srs_4_8_4[i].modes[m]))
          << cell;
    }
  const std::map<std::string, std::string> by_level{
      {"level_transition_order/2", "A[16]"}, {"conditional_level_transition_order/2", "A[11][16]"},
      {"session_management/0", "A[15]"},     {"session_management/NTC", "A[15]"},
      {"session_management/1", "A[15]"},     {"session_management/2", "A[14][15]"},
      {"rbc_transition_order/2", "A[15]"},   {"radio_infill_area/1", "A[15]"},
      {"session_management_riu/1", "A[15]"}};
  for (std::size_t i = 0; i < srs_4_8_3.size(); ++i)
    for (std::size_t l = 0; l < kLevels; ++l) {
      const std::string cell = std::string(name(srs_4_8_3[i].what)) + "/" + name(static_cast<Level>(l));
      const auto changed = by_level.find(cell);
      EXPECT_EQ(text(srs_4_8_3_v400[i].not_rbc[l]),
                changed != by_level.end() ? changed->second : text(srs_4_8_3[i].not_rbc[l]))
          << cell;
    }  // from the RBC: tables_v400_test.cpp
}

/// 4.0.0 treats AD as FS in 4.5.2, 4.8.4 and 4.10.
TEST(Automatic_driving, Has_the_columns_of_full_supervision) {
  for (const AcceptanceByMode& row : srs_4_8_4_v400)
    EXPECT_EQ(text(row.modes[static_cast<std::size_t>(Mode::AD)]), text(row.modes[static_cast<std::size_t>(Mode::FS)]))
        << name(row.what);
  for (std::size_t i = 0; i < kStored; ++i)
    EXPECT_EQ(on_entry(Mode::AD, Mode::FS, static_cast<Stored>(i), SrsVersion::v4_0_0),
              on_entry(Mode::FS, Mode::LS, static_cast<Stored>(i), SrsVersion::v4_0_0))
        << name(static_cast<Stored>(i));
  for (std::size_t i = 0; i < kFunctions; ++i)
    EXPECT_EQ(activity(static_cast<Function>(i), Mode::AD), activity(static_cast<Function>(i), Mode::FS))
        << name(static_cast<Function>(i));
}

TEST(Stored, Is_4_10_in_3_4_0_and_3_6_0) {
  const json file = reference("stored_information.json");
  const std::map<std::string, Fate> fates{{"U", Fate::unchanged},
                                          {"D", Fate::deleted},
                                          {"TBR", Fate::to_be_revalidated},
                                          {"R", Fate::reset},
                                          {"NR", Fate::not_relevant}};
  ASSERT_EQ(file["on_mode_entry"].size(), kStored);
  for (std::size_t i = 0; i < kStored; ++i) {
    const json& r = file["on_mode_entry"][i];
    const Stored stored = static_cast<Stored>(i);
    ASSERT_EQ(r["id"], name(stored));
    for (std::size_t m = 0; m < kModesOf3; ++m) {
      const Mode to = static_cast<Mode>(m);
      const json& cell = r["on_entry"][name(to)];
      std::set<int> notes;
      if (cell.contains("x")) notes = cell["x"].get<std::set<int>>();
      for (const Mode from : {Mode::FS, Mode::SH, Mode::PS}) {
        const bool kept = (from == Mode::SH && notes.count(1) != 0) || (from == Mode::PS && notes.count(2) != 0);
        const Fate old = kept ? Fate::unchanged : fates.at(cell["a"]);
        Fate now = old;
        if (r.contains("v360") && r["v360"].contains(name(to))) now = fates.at(r["v360"][name(to)].get<std::string>());
        EXPECT_EQ(on_entry(to, from, stored, SrsVersion::v3_4_0), old) << r["id"] << name(to);
        EXPECT_EQ(on_entry(to, from, stored), now) << r["id"] << name(to);
      }
    }
  }
}

/// The cells of 4.10 that differ from 3.6.0, and the row that was split; read from the page of 4.0.0.
TEST(Stored, Is_4_10_in_4_0_0) {
  const std::map<std::pair<Stored, Mode>, Fate> differing{{{Stored::eolm, Mode::PS}, Fate::deleted},
                                                          {{Stored::eolm, Mode::SH}, Fate::deleted},
                                                          {{Stored::train_data, Mode::NL}, Fate::to_be_revalidated}};
  const std::set<Mode> keeps{Mode::NP, Mode::SB, Mode::PS, Mode::SH, Mode::SL, Mode::NL, Mode::TR};
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode to = static_cast<Mode>(m);
    for (const Mode from : {Mode::FS, Mode::SH, Mode::PS}) {
      for (std::size_t i = 0; i < kStored; ++i) {
        const Stored stored = static_cast<Stored>(i);
        const auto cell = differing.find({stored, to});
        // No exceptions: the cell of a mode that they do not name.
        const Fate same = on_entry(to, Mode::FS, stored, SrsVersion::v3_6_0);
        EXPECT_EQ(on_entry(to, from, stored, SrsVersion::v4_0_0), cell != differing.end() ? cell->second : same)
            << name(stored) << name(to);
      }
      EXPECT_EQ(kept_level_order_on_entry(to, from, SrsVersion::v4_0_0), to == Mode::SF || to == Mode::IS
                                                                             ? Fate::not_relevant
                                                                         : keeps.count(to) != 0 ? Fate::unchanged
                                                                                                : Fate::deleted)
          << name(to);
      EXPECT_EQ(kept_level_order_on_entry(to, from, SrsVersion::v3_6_0),
                on_entry(to, from, Stored::level_transition_order, SrsVersion::v3_6_0))
          << name(to);
    }
  }
}

TEST(Stored, On_level_entry_on_power_up_and_on_a_closed_desk) {
  const json file = reference("stored_information.json");
  for (std::size_t i = 0; i < kStored; ++i) {
    const Stored stored = static_cast<Stored>(i);
    for (std::size_t l = 0; l < kLevels; ++l) {
      const Level level = static_cast<Level>(l);
      const auto deleted = file["on_level_entry"][name(level)]["deleted"].get<std::set<std::string>>();
      EXPECT_EQ(on_level_entry(level, stored) == Fate::deleted, deleted.count(name(stored)) != 0)
          << name(stored) << name(level);
    }
    const std::map<std::string, Fate> fates{{"U", Fate::unchanged},
                                            {"D", Fate::deleted},
                                            {"D*", Fate::deleted},
                                            {"TBR", Fate::to_be_revalidated},
                                            {"R", Fate::reset}};
    EXPECT_EQ(on_desk_closed_in_start_of_mission(stored),
              fates.at(file["som_desk_closed"]["items"][name(stored)].get<std::string>()))
        << name(stored);
    for (const ColdMovement movement : {ColdMovement::none, ColdMovement::moved_or_unknown}) {
      const json& items =
          file["on_exit_NP"][movement == ColdMovement::none ? "no_cold_movement" : "cold_movement_or_unknown"];
      DataStatus expected = DataStatus::valid;
      if (items.contains(name(stored))) {
        const std::string says = items[name(stored)];
        expected = says == "invalid->valid"     ? DataStatus::valid
                   : says == "invalid->unknown" ? DataStatus::unknown
                                                : DataStatus::invalid;
      }
      EXPECT_EQ(on_exit_np(movement, stored), expected) << name(stored);
    }
    // NP makes exactly the items of 4.11 invalid.
    EXPECT_EQ(on_entry(Mode::NP, Mode::FS, stored) == Fate::to_be_revalidated,
              file["on_exit_NP"]["no_cold_movement"].contains(name(stored)))
        << name(stored);
  }
}

TEST(Functions, Are_4_5_2) {
  const json file = reference("active_functions.json");
  ASSERT_EQ(file["functions"].size(), kFunctions);
  const std::map<std::string, Activity> marks{
      {"X", Activity::active}, {"O", Activity::optional}, {"-", Activity::inactive}};
  // The marks of 4.0.0 that 3.x has not.
  const std::set<std::pair<std::string, std::string>> added{
      {"report_standstill", "SB"},
      {"report_integrity_confirmed", "UN"},
      {"report_integrity_confirmed", "SN"},
      {"report_integrity_lost", "UN"},
      {"report_integrity_lost", "SN"},
      {"report_rbc_border", "SL"},
      {"report_rbc_border", "NL"},
      {"report_level_border_rear", "SL"},
      {"report_level_change_trackside", "SL"},
      {"report_rbc_requested", "SL"},
      {"report_every_bg", "SB"},
      {"report_every_bg", "SL"},
  };
  for (std::size_t i = 0; i < kFunctions; ++i) {
    const json& f = file["functions"][i];
    const Function function = static_cast<Function>(i);
    ASSERT_EQ(f["id"], name(function));
    for (std::size_t m = 0; m < kModesOf3; ++m) {
      const Mode in = static_cast<Mode>(m);
      Activity old = marks.at(f["marks"][name(in)]);
      Activity now = old;
      if (f.contains("v360") && f["v360"].contains(name(in))) now = marks.at(f["v360"][name(in)].get<std::string>());
      if (f.value("since", "").rfind("3.6.0", 0) == 0) old = Activity::inactive;
      EXPECT_EQ(activity(function, in), now) << f["id"] << name(in);
      EXPECT_EQ(activity(function, in, SrsVersion::v3_4_0), old) << f["id"] << name(in);
      EXPECT_EQ(activity(function, in, SrsVersion::v4_0_0),
                added.count({name(function), name(in)}) != 0 ? Activity::active : now)
          << f["id"] << name(in);
      EXPECT_EQ(active(function, in), now == Activity::active) << f["id"] << name(in);
    }
  }
}

TEST(Levels, Acknowledgement_is_5_10_4) {
  const json file = reference("level_transitions.json");
  const json& table = file["acknowledgement"]["table"];
  for (std::size_t from = 0; from < kLevels; ++from)
    for (std::size_t to = 0; to < kLevels; ++to) {
      const std::string says = table[name(static_cast<Level>(from))][name(static_cast<Level>(to))];
      EXPECT_EQ(srs_5_10_4[from][to], says == "Yes") << from << to;
    }
}

// clang-format off
/// 5.10.3 with 4.6.2: what becomes of the mode when the level is switched, by rows "from modes -> to level". The mode
/// table does the work; this is the same by level.
struct ModeConsequence { Mode from; Level to; Mode becomes; int number; };
constexpr auto srs_5_10_3 = [] {
  using enum Mode;
  using enum Level;
  return std::to_array<ModeConsequence>({
    {FS, L0,  UN, 21}, {LS, L0,  UN, 21}, {SR, L0,  UN, 21}, {OS, L0,  UN, 21}, {SN, L0, UN, 21},
    {FS, NTC, SN, 56}, {LS, NTC, SN, 56}, {SR, NTC, SN, 56}, {OS, NTC, SN, 56}, {UN, NTC, SN, 56},
    {UN, L1,  FS, 25}, {UN, L2,  FS, 25}, {UN, L3,  FS, 25}, {SN, L1,  FS, 25}, {SN, L2, FS, 25}, {SN, L3, FS, 25},
    {UN, L1,  TR, 39}, {UN, L2,  TR, 39}, {UN, L3,  TR, 39}, {SN, L1,  TR, 39}, {SN, L2, TR, 39}, {SN, L3, TR, 39},
    {UN, L1,  LS, 71}, {UN, L2,  LS, 71}, {UN, L3,  LS, 71}, {SN, L1,  LS, 71}, {SN, L2, LS, 71}, {SN, L3, LS, 71},
    {UN, L1,  OS, 34}, {UN, L2,  OS, 34}, {UN, L3,  OS, 34}, {SN, L1,  OS, 34}, {SN, L2, OS, 34}, {SN, L3, OS, 34},
    {UN, L1,  SH, 61}, {UN, L2,  SH, 61}, {UN, L3,  SH, 61}, {SN, L1,  SH, 61}, {SN, L2, SH, 61}, {SN, L3, SH, 61},
    {UN, L1,  SR, 44}, {UN, L2,  SR, 45}, {UN, L3,  SR, 45}, {SN, L1,  SR, 44}, {SN, L2, SR, 45}, {SN, L3, SR, 45},
    {UN, L1,  TR, 67}, {SN, L1,  TR, 67},
    {SN, L0,  TR, 38}, {SN, L1,  TR, 38}, {SN, L2,  TR, 38}, {SN, L3,  TR, 38},
  });
}();
// clang-format on

TEST(Levels, The_mode_table_does_what_5_10_3_says) {
  for (const ModeConsequence& row : srs_5_10_3) {
    const auto went = next_mode(row.from, Conditions{row.number});
    ASSERT_TRUE(went.has_value());
    EXPECT_EQ(went->to, row.becomes) << name(row.from) << name(row.to) << row.number;
  }
}

TEST(Properties, Levels_are_4_4) {
  const json file = reference("mode_properties.json");
  for (std::size_t m = 0; m < kModesOf3; ++m) {
    const Mode in = static_cast<Mode>(m);
    EXPECT_EQ(properties(in).mode, in);
    const auto levels = file["modes"][name(in)]["levels"].get<std::set<std::string>>();
    for (std::size_t l = 0; l < kLevels; ++l)
      EXPECT_EQ(possible_in(in, static_cast<Level>(l)), levels.count(name(static_cast<Level>(l))) != 0)
          << name(in) << l;
  }
}

TEST(Properties, Supervision_agrees_with_the_functions_of_4_5_2) {
  for (std::size_t m = 0; m < kModes; ++m) {
    const Mode in = static_cast<Mode>(m);
    const Supervision s = properties(in).supervision;
    EXPECT_EQ(s == Supervision::full, active(Function::sdm_full, in)) << name(in);
    EXPECT_EQ(s == Supervision::mrsp_targets, active(Function::sdm_mrsp_only, in)) << name(in);
    EXPECT_EQ(s == Supervision::mrsp_and_sr_distance, active(Function::sdm_mrsp_sr_distance, in)) << name(in);
    EXPECT_EQ(s == Supervision::ceiling, active(Function::csm_only, in)) << name(in);
    EXPECT_EQ(properties(in).brake == ModeBrake::emergency_brake, active(Function::command_eb, in)) << name(in);
    const bool mode_limit =
        properties(in).speed_limit != SpeedLimit::no_limit && properties(in).speed_limit != SpeedLimit::standstill &&
        properties(in).speed_limit != SpeedLimit::profile_only && properties(in).speed_limit != SpeedLimit::national;
    EXPECT_EQ(mode_limit, active(Function::mrsp_mode, in)) << name(in);
  }
}

}  // namespace
}  // namespace evc::modes
