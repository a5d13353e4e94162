#include "mode_coverage.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "base/test_paths.h"
#include "missing_list.h"
#include "modes/next_mode.h"

namespace evc::scenario {
namespace {

constexpr std::array kEditions{SrsVersion::v3_4_0, SrsVersion::v3_6_0, SrsVersion::v4_0_0};

/// What all scenarios show: the key of a cell or term, and the names of the scenarios.
struct All {
  std::map<std::string, std::set<std::string>> shown;
  std::set<std::string> wrong;
};
All& all() {
  static All seen;
  return seen;
}

std::string bracket(int number) { return "[" + std::to_string(number) + "]"; }
std::string cell_key(const std::string& from, const std::string& to, int number) {
  return from + ">" + to + " " + bracket(number);
}
std::string term_key(int number, const std::string& term) { return bracket(number) + " without " + term; }
std::string of(SrsVersion srs, const std::string& key) { return std::string(name(srs)) + " " + key; }

/// A condition of a cell of 4.6.2, from the reference table of an edition.
struct CellRow {
  std::string from, to;
  int number;
  friend bool operator==(const CellRow&, const CellRow&) = default;
};
std::vector<CellRow> read_cells(const char* file) {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/" + file);
  const auto table = nlohmann::json::parse(in);
  std::vector<CellRow> rows;
  for (const auto& cell : table["transitions"])
    for (const auto& number : cell["conditions"])
      rows.push_back({cell["from"].get<std::string>(), cell["to"].get<std::string>(), number.get<int>()});
  return rows;
}
const std::vector<CellRow>& cells_of(SrsVersion srs) {
  static const std::vector<CellRow> of_3 = read_cells("mode_transitions.json");
  static const std::vector<CellRow> of_4 = read_cells("mode_transitions_v400.json");
  return srs == SrsVersion::v4_0_0 ? of_4 : of_3;
}

/// The cells of all editions, each once, by the mode that is left.
std::vector<CellRow> every_cell() {
  std::vector<CellRow> rows = cells_of(SrsVersion::v4_0_0);
  const auto leaves = [](const std::string& mode) { return [mode](const CellRow& c) { return c.from == mode; }; };
  for (const CellRow& cell : cells_of(SrsVersion::v3_6_0)) {
    if (std::find(rows.begin(), rows.end(), cell) != rows.end()) continue;
    const auto last = std::find_if(rows.rbegin(), rows.rend(), leaves(cell.from));
    rows.insert(last.base(), cell);
  }
  return rows;
}

/// Cells and terms that no scenario shows.
std::vector<std::string> unseen_of_modes() {
  std::vector<std::string> keys;
  const auto want = [&](const std::string& key) {
    if (!all().shown.contains(key)) keys.push_back(key);
  };
  for (const SrsVersion srs : kEditions) {
    for (const CellRow& c : cells_of(srs)) {
      want(of(srs, cell_key(c.from, c.to, c.number)));
      if (condition_row(c.number, srs) == nullptr) want(of(srs, "a row of " + bracket(c.number)));
    }
    for (const ConditionRow& row : condition_rows())
      for (const Term& term : row.terms)
        if (row.is_of(srs)) want(of(srs, term_key(row.number, term.text)));
  }
  return keys;
}

/// Each edition for itself.
MissingList modes_not_shown() { return missing_list("modes_missing.txt"); }

/// The scenario that shows it: one that shows the condition true as well, if there is any; of these the first by name.
std::string example(SrsVersion srs, const std::string& key, int number) {
  const auto found = all().shown.find(of(srs, key));
  if (found == all().shown.end()) return {};
  const auto true_in = all().shown.find(of(srs, bracket(number)));
  if (true_in != all().shown.end())
    for (const std::string& scenario : found->second)
      if (true_in->second.contains(scenario)) return scenario;
  return *found->second.begin();
}

std::string shown_or_why(SrsVersion srs, const std::string& key, int number, const MissingList& absent) {
  const std::string scenario = example(srs, key, number);
  if (!scenario.empty()) return scenario;
  const auto why = absent.find(of(srs, key));
  return why == absent.end() ? "**missing**" : "none: " + why->second;
}

constexpr const char* kColumns = " 3.4.0 | 3.6.0 | 4.0.0 |\n";

void add_cells(std::string& page, const MissingList& absent) {
  page += std::string("| from | to | condition |") + kColumns + "|---|---|---|---|---|---|\n";
  for (const CellRow& c : every_cell()) {
    page += "| " + c.from + " | " + c.to + " | " + bracket(c.number) + " |";
    for (const SrsVersion srs : kEditions) {
      const auto& cells = cells_of(srs);
      const bool has = std::find(cells.begin(), cells.end(), c) != cells.end();
      page += " " + (has ? shown_or_why(srs, cell_key(c.from, c.to, c.number), c.number, absent) : "-") + " |";
    }
    page += "\n";
  }
}

void add_conditions(std::string& page, const MissingList& absent) {
  page += std::string("| condition | |") + kColumns + "|---|---|---|---|---|\n";
  const auto add_row = [&](const ConditionRow& row, const std::string& text, const std::string& key) {
    page += "| " + bracket(row.number) + " | " + text + " |";
    for (const SrsVersion srs : kEditions)
      page += " " + (row.is_of(srs) ? shown_or_why(srs, key, row.number, absent) : "-") + " |";
    page += "\n";
  };
  for (const ConditionRow& row : condition_rows()) {
    std::string whole;
    for (const Term& term : row.terms) whole += (whole.empty() ? "" : "; ") + term.text;
    add_row(row, whole, bracket(row.number));
    for (const Term& term : row.terms) add_row(row, "*without* " + term.text, term_key(row.number, term.text));
  }
}

}  // namespace

namespace {

/// What a term reads from the inputs was refused: the driver's selection or acknowledgement was not enabled (4.7.2), or
/// the RBC's message was refused (4.8).
bool is_refused(const Term& term, const port::Event& event) {
  switch (event.what) {
    case What::selection_not_enabled:
      return term.selection && event.id == static_cast<std::int32_t>(*term.selection);
    case What::acknowledgement_not_enabled:
      return term.acknowledgement && event.id == static_cast<std::int32_t>(*term.acknowledgement);
    case What::message_refused:
      return term.NID_MESSAGE && event.id == *term.NID_MESSAGE;
    default:
      return false;
  }
}

bool is_refused(const ConditionRow& row, const kernel::Outputs& out) {
  return std::any_of(row.terms.begin(), row.terms.end(), [&](const Term& term) {
    return std::any_of(out.events.begin(), out.events.end(),
                       [&](const port::Event& event) { return is_refused(term, event); });
  });
}

}  // namespace

/// `by`: the condition by which the mode was left, 0 if it stays.
void ModeWatch::compare(int number, Mode from, int by, const Moment& moment, const kernel::Outputs& out) {
  const bool by_it = number == by;
  const ConditionRow* row = condition_row(number, srs_);
  const std::string mode = std::string(name(from));
  if (row == nullptr) {
    if (by_it) wrong_.insert(mode + " is left by " + bracket(number) + ", which the edition does not have");
    return;
  }
  std::size_t n = 0, missing = 0;
  for (std::size_t i = 0; i < row->terms.size(); ++i) {
    if (row->terms[i].holds(moment)) continue;
    ++n;
    missing = i;
  }
  if (by_it && n != 0) wrong_.insert(mode + " is left by " + bracket(number) + " without " + row->terms[missing].text);
  if (by == 0 && n == 0 && !is_refused(*row, out))
    wrong_.insert(mode + " stays although " + bracket(number) + " holds");
  if (n == 1 && !by_it) only_missing_[static_cast<std::size_t>(number)].set(missing);
}

void ModeWatch::watch(SrsVersion srs, Mode from, const Moment& moment, const kernel::Outputs& out) {
  srs_ = srs;
  int by = 0;
  for (const port::Event& event : out.events) {
    if (event.what != What::mode_changed) continue;
    by = event.id;
    if (event.from != terms::index(from) || event.to != terms::index(out.mode))
      wrong_.insert("the event of a transition names other modes than the outputs");
    caused_[event.from][event.to].set(by);
    caused_by_.set(by);
  }
  for (const auto& cell : modes::cells_leaving(from, srs))
    for (const int number : cell.when)
      if (number != 0) compare(number, from, by, moment, out);
}

bool ModeWatch::has(const std::string& from, const std::string& to) const {
  for (std::size_t i = 0; i < evc::kModes; ++i)
    for (std::size_t j = 0; j < evc::kModes; ++j)
      if (from == name(static_cast<Mode>(i)) && to == name(static_cast<Mode>(j))) return !caused_[i][j].none();
  return false;
}

void ModeWatch::add_to_all(const std::string& scenario) const {
  auto& shown = all().shown;
  for (std::size_t from = 0; from < evc::kModes; ++from)
    for (std::size_t to = 0; to < evc::kModes; ++to)
      for (int n = 0; n < modes::Conditions::kNumbers; ++n) {
        if (!caused_[from][to].test(n)) continue;
        const CellRow cell{std::string(name(static_cast<Mode>(from))), std::string(name(static_cast<Mode>(to))), n};
        const auto& cells = cells_of(srs_);
        const std::string key = of(srs_, cell_key(cell.from, cell.to, n));
        if (std::find(cells.begin(), cells.end(), cell) == cells.end())
          all().wrong.insert(key + " is not in the table: " + scenario);
        shown[key].insert(scenario);
      }
  for (int n = 0; n < modes::Conditions::kNumbers; ++n) {
    if (caused_by_.test(n)) shown[of(srs_, bracket(n))].insert(scenario);
    const auto& missing = only_missing_[static_cast<std::size_t>(n)];
    for (std::size_t i = 0; i < missing.size(); ++i)
      if (missing.test(i)) shown[of(srs_, term_key(n, condition_row(n, srs_)->terms[i].text))].insert(scenario);
  }
  for (const std::string& what : wrong_) all().wrong.insert(of(srs_, what + ": " + scenario));
}

std::vector<std::string> wrong_of_modes() { return {all().wrong.begin(), all().wrong.end()}; }

std::vector<std::string> missing_of_modes() { return without_row(modes_not_shown(), unseen_of_modes()); }
std::vector<std::string> not_missing_of_modes() { return wrong_rows(modes_not_shown(), unseen_of_modes()); }
std::size_t known_missing_of_modes() { return modes_not_shown().size(); }

std::string modes_page() {
  const auto absent = modes_not_shown();
  std::string page =
      "\n## Cells of the mode table\n"
      "4.6.2, each condition of each cell, by edition: a scenario in whose outputs the transition was seen, by this "
      "condition;\n"
      "`-`: the edition has no such cell.\n\n";
  add_cells(page, absent);
  page +=
      "\n## Conditions of the mode table\n"
      "4.6.3, by edition. First row of a condition, its terms: a scenario in which all hold and the mode is left by "
      "it. *without*:\n"
      "one in which a mode that has the condition is not left by it in a cycle in which this term alone does not "
      "hold. In every\n"
      "cycle of every scenario these terms (`tests/scenarios/condition_terms.cpp`) and the unit have to agree.\n\n";
  add_conditions(page, absent);
  return page;
}

}  // namespace evc::scenario
