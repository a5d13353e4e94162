#include "display.h"

#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "base/test_paths.h"
#include "display_facts.h"
#include "kernel/state.h"
#include "missing_list.h"
#include "terms/driver_input.h"
#include "terms/driver_output.h"
#include "terms/mode.h"
#include "terms/srs_version.h"

namespace evc::scenario {
namespace {

using Marks = std::map<std::string, std::map<std::string, std::string>>;  // row, mode: mark

/// The issues whose cycles are watched. 3.4.0 stands with 3.6.0 but for the cells that differ.
constexpr std::size_t kIssues = kSrsVersionRows.size();
constexpr std::size_t k3_4 = terms::index(SrsVersion::v3_4_0);
constexpr std::size_t k3_6 = terms::index(SrsVersion::v3_6_0);
constexpr std::size_t k4_0 = terms::index(SrsVersion::v4_0_0);

std::string issue_name(std::size_t issue) { return std::string(name(static_cast<SrsVersion>(issue))); }

Marks rows_of(const nlohmann::json& rows) {
  Marks out;
  for (const auto& row : rows) out[row["id"]] = row["marks"].get<Marks::mapped_type>();
  return out;
}

/// The rows of 3.6.0, computed from those of 3.4.0 and the listed differences.
Marks rows_of_3_6_0(const nlohmann::json& file, const std::string& kind) {
  Marks out = rows_of(file[kind]);
  const auto& newer = file["differences_3_6_0"];
  for (const auto& [id, change] : newer[kind + "_changed"].items())
    for (const auto& [mode, mark] : (change.contains("marks") ? change["marks"] : change).items())
      if (mode != "note") out[id][mode] = mark;
  for (const auto& [id, marks] : newer[kind + "_new"].items()) out[id] = marks.get<Marks::mapped_type>();
  if (kind == "outputs")
    for (const auto& id : newer["outputs_removed"]) out.erase(id.get<std::string>());
  return out;
}

/// The rows of 4.0.0 by our names. The shade of SN is lost in the text read: what 3.6.0 leaves to the national system
/// is left to it.
Marks rows_of_4_0_0(const nlohmann::json& file, const std::string& kind) {
  std::map<std::string, std::string> ours{{"radio_network", "radio_network_id"}};
  if (kind == "inputs")
    ours.insert({{"bmm_inhibition", "bmm_inhibit"}, {"revoke_bmm_inhibition", "bmm_revoke"}, {"sm_request", "sm"}});
  const Marks older = rows_of_3_6_0(file, kind);
  Marks out;
  for (auto& [id, marks] : rows_of(file["table_4_0_0"][kind])) {
    const auto renamed = ours.find(id);
    const std::string& row = renamed == ours.end() ? id : renamed->second;
    out[row] = marks;
    const auto before = older.find(row);
    if (before != older.end() && before->second.at("SN") == "NS") out[row]["SN"] = "NS";
  }
  return out;
}

std::array<Marks, kIssues> marks_of(const std::string& kind) {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/dmi_io_by_mode.json");
  const auto file = nlohmann::json::parse(in);
  std::array<Marks, kIssues> out;
  out[k3_4] = rows_of(file[kind]);
  out[k3_6] = rows_of_3_6_0(file, kind);
  out[k4_0] = rows_of_4_0_0(file, kind);
  return out;
}

/// What scenarios of one issue have seen of one half of the table.
template <class E>
struct Seen {
  std::array<Set<E>, evc::kModes> shown{}, masked{}, ended{};
};

/// One half of the table, in all issues.
template <class E>
struct Cells {
  std::string kind;
  std::array<Marks, kIssues> marks;
  std::array<Seen<E>, kIssues> seen{};
  std::vector<std::string> wrong;

  explicit Cells(const std::string& of) : kind(of), marks(marks_of(of + "s")) {}
  /// Empty: the table of the issue has no such row or mode.
  std::string mark(std::size_t issue, E e, std::size_t mode) const {
    const auto row = marks[issue].find(name(e));
    if (row == marks[issue].end()) return {};
    const auto found = row->second.find(std::string(name(static_cast<Mode>(mode))));
    return found == row->second.end() ? std::string() : found->second;
  }
  bool has(std::size_t issue, E e, std::size_t mode) const {
    const std::string m = mark(issue, e, mode);
    return m == "X" || m == "A";
  }
  std::string cell(std::size_t issue, E e, std::size_t mode) const {
    return issue_name(issue) + " " + kind + " " + name(e) + " " + std::string(name(static_cast<Mode>(mode)));
  }
  /// Whether one of the issues that have the same mark there has seen it.
  bool any(std::array<Set<E>, evc::kModes> Seen<E>::*what, std::size_t issue, E e, std::size_t mode) const {
    if ((seen[issue].*what)[mode].has(e)) return true;
    return issue == k3_6 && mark(k3_4, e, mode) == mark(k3_6, e, mode) && (seen[k3_4].*what)[mode].has(e);
  }
  /// What has to be seen of the cell and was not; empty: nothing.
  std::string unseen(std::size_t issue, E e, std::size_t mode) const {
    if (has(issue, e, mode)) return any(&Seen<E>::shown, issue, e, mode) ? "" : cell(issue, e, mode);
    const bool required = kind == "output" && mark(issue, e, mode) == "-";
    if (!required || any(&Seen<E>::masked, issue, e, mode) || any(&Seen<E>::ended, issue, e, mode)) return {};
    return cell(issue, e, mode);
  }
  void watch(std::size_t issue, Mode mode, Set<E> now, const std::string& scenario) {
    const std::size_t m = terms::index(mode);
    for (std::size_t i = 0; i < terms::index(E::count); ++i) {
      const E e = static_cast<E>(i);
      if (!now.has(e) || seen[issue].shown[m].has(e)) continue;
      seen[issue].shown[m].add(e);
      // Up to 3.4.0 some rows of today were part of others.
      const bool no_row = issue == k3_4 && mark(issue, e, m).empty();
      if (!has(issue, e, m) && !no_row) wrong.push_back(cell(issue, e, m) + ": " + scenario);
    }
  }
  bool differs(E e, std::size_t mode) const {
    const std::string old = mark(k3_4, e, mode);
    return !old.empty() && old != mark(k3_6, e, mode);
  }
  /// The cells of the page: all of 3.6.0 and 4.0.0, and those of 3.4.0 that differ.
  template <class Take>
  void each(Take take) const {
    for (std::size_t issue = 0; issue < kIssues; ++issue)
      for (std::size_t i = 0; i < terms::index(E::count); ++i)
        for (std::size_t m = 0; m < evc::kModes; ++m) {
          const E e = static_cast<E>(i);
          if (issue != k3_4 || differs(e, m)) take(issue, e, m);
        }
  }
};

struct Display {
  Cells<DriverOutput> outputs{"output"};
  Cells<DriverInput> inputs{"input"};
};
Display& display() {
  static Display all;
  return all;
}

/// Rows of the table of 4.0.0 that the unit does not have, as "4.0.0 output NAME -".
template <class E>
std::vector<std::string> rows_without_ours(const Cells<E>& cells) {
  std::vector<std::string> out;
  for (const auto& [row, marks] : cells.marks[k4_0]) {
    bool ours = false;
    for (std::size_t i = 0; i < terms::index(E::count); ++i) ours = ours || row == name(static_cast<E>(i));
    if (!ours) out.push_back(issue_name(k4_0) + " " + cells.kind + " " + row + " -");
  }
  return out;
}

/// The modes that are only there with closed desks.
constexpr bool without_desk(Mode mode) { return mode == Mode::NP || mode == Mode::PS || mode == Mode::SL; }

struct Reason {
  std::string issues, kind, row, modes, why;
};
/// The rows of display_missing.txt.
const std::vector<Reason>& reasons() {
  static const std::vector<Reason> all = [] {
    std::vector<Reason> rows;
    std::ifstream in(evc::test::source_folder() + "/tests/scenarios/display_missing.txt");
    for (std::string line; std::getline(in, line);) {
      if (line.empty() || line[0] == '#') continue;
      std::istringstream words(line);
      Reason r;
      words >> r.issues >> r.kind >> r.row >> r.modes >> std::ws;
      std::getline(words, r.why);
      rows.push_back(r);
    }
    return rows;
  }();
  return all;
}

/// By cell: why no scenario shows it.
const std::map<std::string, std::string>& known_missing() {
  static const std::map<std::string, std::string> all = [] {
    std::map<std::string, std::string> cells;
    for (const Reason& r : reasons())
      for (const std::string& issue : items_of(r.issues))
        for (const std::string& row : items_of(r.row))
          for (const std::string& mode : items_of(r.modes))
            cells[issue + " " + r.kind + " " + row + " " + mode] =
                r.why;  // NOLINT(performance-inefficient-string-concatenation)
    return cells;
  }();
  return all;
}

template <class E>
const char* text_of(const Cells<E>& cells, std::size_t issue, E e, std::size_t m) {
  const bool output = cells.kind == "output";
  if (cells.has(issue, e, m)) {
    if (cells.any(&Seen<E>::shown, issue, e, m)) return output ? "s" : "e";
    return known_missing().contains(cells.cell(issue, e, m)) ? "?" : "missing";
  }
  if (cells.mark(issue, e, m) != "-") return "";
  if (!output) return "-";
  if (cells.any(&Seen<E>::masked, issue, e, m)) return "m";
  if (cells.any(&Seen<E>::ended, issue, e, m)) return "d";
  return known_missing().contains(cells.cell(issue, e, m)) ? "-" : "missing";
}

/// The modes of the issue: SM and AD are of 4.0.0.
constexpr std::size_t modes_of(std::size_t issue) { return issue == k4_0 ? evc::kModes : evc::kModes - 2; }

template <class E>
void add_table(std::string& page, const Cells<E>& cells, std::size_t issue) {
  page += "\n| " + cells.kind + " |";
  for (std::size_t m = 0; m < modes_of(issue); ++m)
    page += std::string(" ") + std::string(name(static_cast<Mode>(m))) + " |";
  page += "\n|---|";
  for (std::size_t m = 0; m < modes_of(issue); ++m) page += "---|";
  for (std::size_t i = 0; i < terms::index(E::count); ++i) {
    const E e = static_cast<E>(i);
    if (!cells.marks[issue].contains(name(e))) continue;
    page += std::string("\n| `") + name(e) + "` |";
    for (std::size_t m = 0; m < modes_of(issue); ++m) page += std::string(" ") + text_of(cells, issue, e, m) + " |";
  }
  page += "\n";
}

template <class E>
void add_differences(std::string& page, const Cells<E>& cells) {
  cells.each([&](std::size_t issue, E e, std::size_t m) {
    if (issue != k3_4) return;
    page += "| " + cells.kind + " `" + name(e) + "` | " + std::string(name(static_cast<Mode>(m))) + " | " +
            cells.mark(k3_4, e, m) + " " + text_of(cells, k3_4, e, m) + " | " + cells.mark(k3_6, e, m) + " " +
            text_of(cells, k3_6, e, m) + " |\n";
  });
}

/// How many cells have which letter.
template <class E>
void add_figures(std::string& page, const Cells<E>& cells) {
  for (const std::size_t issue : {k3_6, k4_0}) {
    std::map<std::string, int> n;
    cells.each([&](std::size_t of, E e, std::size_t m) {
      if (of == issue) ++n[text_of(cells, of, e, m)];
    });
    page += "| " + cells.kind + "s of " + issue_name(issue) + " |";
    for (const char* letter : {cells.kind == "output" ? "s" : "e", "m", "d", "-", "?"})
      page += " " + std::to_string(n[letter]) + " |";
    page += "\n";
  }
}

/// Of both halves the cells of which something has to be seen and was not, and the rows that the unit does not have.
std::set<std::string> all_unseen() {
  std::set<std::string> out;
  const auto take = [&](const auto& cells) {
    cells.each([&](std::size_t issue, auto e, std::size_t m) {
      const std::string cell = cells.unseen(issue, e, m);
      if (!cell.empty()) out.insert(cell);
    });
    for (const std::string& row : rows_without_ours(cells)) out.insert(row);
  };
  take(display().outputs);
  take(display().inputs);
  return out;
}

}  // namespace

void watch_display(DisplayMemory& memory, const kernel::State& state, const kernel::Outputs& out,
                   const std::string& scenario) {
  Cells<DriverOutput>& cells = display().outputs;
  const std::size_t issue = terms::index(state.srs), m = terms::index(out.mode);
  const Set<DriverOutput> facts = held(state, out);
  const bool entered = out.mode != memory.mode;
  cells.watch(issue, out.mode, out.shown, scenario);
  display().inputs.watch(issue, out.mode, out.enabled, scenario);
  for (std::size_t i = 0; i < terms::index(DriverOutput::count); ++i) {
    const auto e = static_cast<DriverOutput>(i);
    if (!memory.witnessed.has(e) || out.shown.has(e) || cells.mark(issue, e, m) != "-") continue;
    if (!facts.has(e))
      cells.seen[issue].ended[m].add(e, entered);
    else
      cells.seen[issue].masked[m].add(e, state.desk_was_open || without_desk(out.mode));
  }
  memory.witnessed |= out.shown;
  memory.witnessed &= facts;
  memory.mode = out.mode;
}

std::vector<std::string> wrong_on_display() {
  std::vector<std::string> all = display().outputs.wrong;
  all.insert(all.end(), display().inputs.wrong.begin(), display().inputs.wrong.end());
  return all;
}

std::vector<std::string> missing_on_display() {
  std::vector<std::string> all;
  for (const std::string& cell : all_unseen())
    if (!known_missing().contains(cell)) all.push_back(cell);
  return all;
}

std::size_t known_missing_on_display() { return known_missing().size(); }

std::vector<std::string> not_missing_on_display() {
  const std::set<std::string> unseen = all_unseen();
  std::vector<std::string> all;
  for (const auto& [cell, why] : known_missing())
    if (!unseen.contains(cell) || why.empty()) all.push_back(cell);
  return all;
}

std::string display_page() {
  std::string page = R"(# What the display shows in each mode
SUBSET-026-4 4.7.2, cell by cell and issue by issue, as seen in the cycles of all [scenarios](scenarios.md) of the issue: made by
`scenarios_test --display`. A test fails when this page is not up to date, when a cell is shown that the table does not
have, and when of a cell neither what has to be seen was seen nor the reason is [below](#not-seen).

An output that the table has in a mode is seen when a cycle shows it (output `shown`), an input when a cycle enables it
(output `enabled`). An output that the table does not have in a mode is seen *masked* there when

1. it was shown in a mode before, and
2. the fact by which it was shown is held by the unit in every cycle since then, the one in this mode included, and
3. in this mode it is not shown, though a desk is open (in NP, PS and SL none can be).

The facts are those of the unit's memory: the stored data, authority, texts, conditions and orders, the sessions, the brake
commands and their causes; of what is computed anew in each cycle, the output itself (speeds and distances). Most modes
delete on their entry most of what they do not show: there an output can only be seen *deleted*: it was shown, by a fact
that was held up to the last cycle of the mode before, and in the first cycle of this mode there is neither (4.10; of a
brake 4.12, of a speed 4.5.2, of a status text ERA_ERTMS_015560 15.1.1.2).

| in a cell | |
|---|---|
| `s` | seen shown |
| `e` | seen enabled |
| `m` | the table does not have it: seen masked |
| `d` | the table does not have it: seen deleted by the entry of the mode |
| `-` | the table does not have it; of an output: it cannot be seen there, [why](#not-seen) |
| `?` | the table has it; it cannot be seen, [why](#not-seen) |
| empty | the table leaves it open (SF, IS, in SN what is the national system's) |

)";
  page += "| cells | s, e | m | d | - | ? |\n|---|---|---|---|---|---|\n";
  add_figures(page, display().outputs);
  add_figures(page, display().inputs);
  page += "\n## 3.4.0 and 3.6.0: outputs\n";
  add_table(page, display().outputs, k3_6);
  page += "\n## 3.4.0 and 3.6.0: inputs\n";
  add_table(page, display().inputs, k3_6);
  page +=
      "\n## Where 3.4.0 differs\nIn the tables above these are the cells of 3.6.0. Rows that are new in 3.6.0 have no "
      "cell in 3.4.0.\n\n| row | mode | 3.4.0 | 3.6.0 |\n|---|---|---|---|\n";
  add_differences(page, display().outputs);
  add_differences(page, display().inputs);
  page += "\n## 4.0.0: outputs\n";
  add_table(page, display().outputs, k4_0);
  page += "\n## 4.0.0: inputs\n";
  add_table(page, display().inputs, k4_0);
  page += "\n## Not seen\n| issue | row | modes | why |\n|---|---|---|---|\n";
  const auto spaced = [](const std::string& list) {
    std::string out;
    for (const std::string& item : items_of(list)) out += (out.empty() ? "" : ", ") + item;
    return out;
  };
  for (const Reason& r : reasons())
    page += "| " + spaced(r.issues) + " | " + r.kind + " " + spaced(r.row) + " | " +
            (r.modes == "-" ? "all" : spaced(r.modes)) + " | " + r.why + " |\n";
  return page;
}

}  // namespace evc::scenario
