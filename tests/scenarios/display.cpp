#include "display.h"

#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "base/test_paths.h"
#include "terms/driver_input.h"
#include "terms/driver_output.h"
#include "terms/mode.h"

namespace evc::scenario {
namespace {

using Marks = std::map<std::string, std::map<std::string, std::string>>;  // row, mode: mark

/// The rows of 3.6.0, computed from those of 3.4.0 and the listed differences.
Marks marks_of(const std::string& kind) {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/dmi_io_by_mode.json");
  const auto file = nlohmann::json::parse(in);
  Marks out;
  for (const auto& row : file[kind]) out[row["id"]] = row["marks"].get<Marks::mapped_type>();
  const auto& newer = file["differences_3_6_0"];
  for (const auto& [id, change] : newer[kind + "_changed"].items())
    for (const auto& [mode, mark] : (change.contains("marks") ? change["marks"] : change).items())
      if (mode != "note") out[id][mode] = mark;
  for (const auto& [id, marks] : newer[kind + "_new"].items()) out[id] = marks.get<Marks::mapped_type>();
  return out;
}

/// The cells of one half of the table.
template <class E>
struct Cells {
  std::string kind;
  Marks marks;
  std::array<Set<E>, evc::kModes> seen{}, masked{};
  std::vector<std::string> wrong;

  explicit Cells(const std::string& name) : kind(name), marks(marks_of(name + "s")) {}
  /// Empty: the table of 3.6.0 has no such row or mode.
  std::string mark(E e, std::size_t mode) const {
    const auto row = marks.find(name(e));
    if (row == marks.end()) return {};
    const auto found = row->second.find(std::string(name(static_cast<Mode>(mode))));
    return found == row->second.end() ? std::string() : found->second;
  }
  bool has(E e, std::size_t mode) const { return mark(e, mode) == "X" || mark(e, mode) == "A"; }
  std::string cell(E e, std::size_t mode) const {
    return kind + " " + name(e) + " " + std::string(name(static_cast<Mode>(mode)));
  }
  void watch(Mode mode, Set<E> now, Set<E> given, const std::string& scenario) {
    const std::size_t m = terms::index(mode);
    for (std::size_t i = 0; i < terms::index(E::count); ++i) {
      const E e = static_cast<E>(i);
      if (given.has(e) && !now.has(e)) masked[m].add(e);
      if (!now.has(e) || seen[m].has(e)) continue;
      seen[m].add(e);
      if (!has(e, m)) wrong.push_back(cell(e, m) + ": " + scenario);
    }
  }
  template <class Take>
  void each(Take take) const {
    for (std::size_t i = 0; i < terms::index(E::count); ++i)
      for (std::size_t m = 0; m < evc::kModes; ++m) take(static_cast<E>(i), m);
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

/// The outputs for which the line has something, whatever the mode.
Set<DriverOutput> given_in(const kernel::Outputs& o) {
  using enum DriverOutput;
  Set<DriverOutput> given{mode, level, train_speed, operated_version};
  const auto known = [](DataStatus status) { return status != DataStatus::unknown; };
  given.add(permitted_speed, o.V_P.has_value());
  given.add(sbi_speed, o.V_SBI.has_value());
  given.add(target_speed, o.V_target.has_value());
  given.add(target_distance, o.d_target.has_value());
  given.add(release_speed, o.V_release.has_value());
  given.add(monitoring_status, o.status != Status::none);
  given.add(time_to_indication, o.TTI.has_value());
  given.add(first_indication_location, o.d_indication.has_value());
  for (const DriverOutput planned : {gradient, mrsp, eoa_loa}) given.add(planned, o.EOA.has_value());
  given.add(lssma, o.LSSMA.has_value());
  given.add(trip_reason, o.trip_reason.has_value());
  given.add(train_data, known(o.data.train_status));
  given.add(driver_id, known(o.data.driver_id_status));
  given.add(train_running_number, known(o.data.train_running_number_status));
  given.add(rbc_contact, known(o.data.rbc_status));
  given.add(vbc, !o.covers.empty());
  given.add(radio_network_id, o.data.network.has_value());
  given.add(brake_indication, o.sb || o.eb);
  given.add(slippery_rail, o.data.slippery_rail);
  given.add(radio_link_status, !o.sessions.empty());
  given.add(local_time, o.clock.has_value());
  return given;
}

/// The rows of display_missing.txt: the cell, and why no scenario shows it.
std::map<std::string, std::string> known_missing() {
  std::map<std::string, std::string> rows;
  std::ifstream in(evc::test::source_folder() + "/tests/scenarios/display_missing.txt");
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string kind, row, mode, why;
    words >> kind >> row >> mode >> std::ws;
    std::getline(words, why);
    for (std::istringstream modes(mode); std::getline(modes, mode, ',');) rows[kind + " " + row + " " + mode] = why;
  }
  return rows;
}

template <class E>
void add_table(std::string& page, const Cells<E>& cells, const char* seen,
               const std::map<std::string, std::string>& absent) {
  page += "\n| " + cells.kind + " |";
  for (std::size_t m = 0; m < evc::kModes; ++m)
    page += std::string(" ") + std::string(name(static_cast<Mode>(m))) + " |";
  page += "\n|---|";
  for (std::size_t m = 0; m < evc::kModes; ++m) page += "---|";
  cells.each([&](E e, std::size_t m) {
    if (m == 0) page += std::string("\n| `") + name(e) + "` |";
    const std::string mark = cells.mark(e, m);
    const char* text = "";
    if (cells.seen[m].has(e))
      text = seen;
    else if (cells.has(e, m))
      text = absent.contains(cells.cell(e, m)) ? "?" : "missing";
    else if (mark == "-")
      text = cells.masked[m].has(e) ? "m" : "-";
    page += std::string(" ") + text + " |";
  });
  page += "\n";
}

template <class E, class Take>
void each_unseen(const Cells<E>& cells, Take take) {
  cells.each([&](E e, std::size_t m) {
    if (cells.has(e, m) && !cells.seen[m].has(e)) take(cells.cell(e, m));
  });
}

}  // namespace

void watch_display(const kernel::Outputs& out, const std::string& scenario) {
  display().outputs.watch(out.mode, out.shown, given_in(out), scenario);
  display().inputs.watch(out.mode, out.enabled, {}, scenario);
}

std::vector<std::string> wrong_on_display() {
  std::vector<std::string> all = display().outputs.wrong;
  all.insert(all.end(), display().inputs.wrong.begin(), display().inputs.wrong.end());
  return all;
}

std::vector<std::string> missing_on_display() {
  std::vector<std::string> all;
  const auto absent = known_missing();
  const auto take = [&](const std::string& cell) {
    if (!absent.contains(cell)) all.push_back(cell);
  };
  each_unseen(display().outputs, take);
  each_unseen(display().inputs, take);
  return all;
}

std::vector<std::string> not_missing_on_display() {
  std::set<std::string> unseen;
  const auto take = [&](const std::string& cell) { unseen.insert(cell); };
  each_unseen(display().outputs, take);
  each_unseen(display().inputs, take);
  std::vector<std::string> all;
  for (const auto& [cell, why] : known_missing())
    if (!unseen.contains(cell) || why.empty()) all.push_back(cell);
  return all;
}

std::string display_page() {
  std::string page =
      "# What the display shows in each mode\n"
      "SUBSET-026-4 4.7.2 of 3.6.0, cell by cell, as seen in the cycles of all [scenarios](scenarios.md) of that "
      "issue: "
      "made by\n"
      "`scenarios_test --display`; a test fails when this page is not up to date, when a cell is shown that the table "
      "does not\n"
      "have, and when a cell that it has is neither shown nor named below.\n\n"
      "`s`: seen shown (output `shown`); `e`: seen enabled (output `enabled`); `m`: seen masked, the line has a value "
      "and the mode\n"
      "does not show it; `-`: masked by the table, never shown; `?`: not seen, see below; empty: the table leaves it "
      "open.\n";
  const auto absent = known_missing();
  page += "\n## Outputs\n";
  add_table(page, display().outputs, "s", absent);
  page += "\n## Inputs\n";
  add_table(page, display().inputs, "e", absent);
  page += "\n## Not seen\n| cell | why |\n|---|---|\n";
  for (const auto& [cell, why] : absent) page += "| " + cell + " | " + why + " |\n";
  return page;
}

}  // namespace evc::scenario
