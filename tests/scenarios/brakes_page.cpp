#include "brakes_page.h"

#include "missing_list.h"

namespace evc::scenario {
namespace {

using brake_rules::Rule;
using brake_rules::Way;

brake_rules::Seen& seen() {
  static brake_rules::Seen all;
  return all;
}

/// The marks of a cause for mode entries, of one issue where they are of one.
struct Entries {
  std::string name;
  brake_rules::Marks marks{};
};
std::vector<Entries> entries_of(const Rule& rule) {
  std::vector<Entries> all{{rule.entries_in(SrsVersion::v3_6_0), rule.marks}};
  if (rule.marks_4_0_0) all.push_back({rule.entries_in(SrsVersion::v4_0_0), *rule.marks_4_0_0});
  return all;
}

/// What has to be seen of one cell of 4.12; nothing of a grey one. What is evaluated again has to be commanded when the
/// mode is entered.
std::vector<std::string> keys_of(const Entries& row, std::size_t mode) {
  const std::string entered = name(static_cast<Mode>(mode));
  switch (row.marks[mode]) {
    case 'R':
      return {row.name + " revoked " + entered};
    case 'M':
      return {row.name + " kept " + entered};
    case 'P':
      return {row.name + " kept " + entered, row.name + " revoked " + entered + " from PT"};
    case 'O':
    case 'L':
      return {row.name + " kept " + entered, row.name + " revoked " + entered};
    case 'T':
      return {row.name + " evaluated " + entered};
    default:
      return {};
  }
}

bool is_seen(const std::string& key) {
  if (seen().contains(key)) return true;
  std::string other = key;
  const std::size_t at = key.find(" evaluated ");
  if (at == std::string::npos) {
    // From PT it is the same cell, where the table makes no difference.
    return key.find(" from PT") == std::string::npos && seen().contains(key + " from PT");
  }
  for (const char* way : {" kept ", " revoked "})
    if (is_seen(other.replace(at, std::string::npos, way + key.substr(at + 11)))) return true;
  return false;
}

std::string without(const Way& way, const brake_rules::NamedCondition& c) {
  return "without " + c.name + " (" + name_of(way) + ")";
}

std::string modes_of(const Rule& rule) {
  std::string modes;
  for (std::size_t m = 0; m < evc::kModes; ++m)
    if (seen().contains(rule.id + " in " + name(static_cast<Mode>(m))))
      modes += (modes.empty() ? "" : " ") + std::string(name(static_cast<Mode>(m)));
  return modes;
}

bool is_shown(const std::string& key) {
  const std::size_t at = key.rfind(" commanded");
  if (at == std::string::npos) return is_seen(key);
  for (const Rule& rule : brake_rules::rules())
    if (rule.id == key.substr(0, at)) return !modes_of(rule).empty();
  return false;
}

/// What the rules have and no scenario shows.
std::vector<std::string> unseen_of_brakes() {
  std::vector<std::string> keys;
  const auto want = [&](const std::string& key) {
    if (!is_shown(key)) keys.push_back(key);
  };
  for (const Rule& rule : brake_rules::rules()) {
    want(rule.id + " commanded");
    for (const Way& way : rule.ways) {
      for (const auto& c : way) want(rule.id + " " + without(way, c));
      want(rule.id + " by " + name_of(way));
    }
    for (const Entries& row : entries_of(rule))
      for (std::size_t m = 0; m < evc::kModes; ++m)
        for (const std::string& key : keys_of(row, m)) want(key);
  }
  return keys;
}

/// A key for each mode of a row, whose last word is MODE,MODE.
MissingList brakes_not_shown() {
  MissingList rows;
  for (const auto& [key, why] : missing_list("brakes_missing.txt")) {
    const std::size_t modes = key.rfind(' ') + 1;
    for (const std::string& mode : items_of(key.substr(modes))) rows[key.substr(0, modes) + mode] = why;
  }
  return rows;
}

std::string shown(const std::string& key, const std::string& text) {
  return is_shown(key) ? text : text + (brakes_not_shown().contains(key) ? " (not seen)" : " (missing)");
}

void add_rules(std::string& page) {
  page += "| cause | brake | clause | commanded in | held while missing | released by |\n|---|---|---|---|---|---|\n";
  for (const Rule& rule : brake_rules::rules()) {
    std::string held, released;
    for (const Way& way : rule.ways) {
      for (const auto& c : way) held += (held.empty() ? "" : ", ") + shown(rule.id + " " + without(way, c), c.name);
      released += (released.empty() ? "" : "; ") + shown(rule.id + " by " + name_of(way), name_of(way));
    }
    page += "| `" + rule.id + "` | " + rule.brake + " | " + rule.clause + " | " + modes_of(rule) + " | " + held +
            " | " + released + " |\n";
  }
}

std::string cell_of(const Entries& row, std::size_t mode, const MissingList& absent) {
  std::string cell;
  for (const std::string& key : keys_of(row, mode)) {
    const char what = key[row.name.size() + 1];
    const char* letter = what == 'k' ? "m" : what == 'r' ? "r" : "t";
    cell += is_shown(key) ? letter : absent.contains(key) ? "?" : "missing";
  }
  return cell;
}

void add_entries(std::string& page, const MissingList& absent) {
  page += "| cause |";
  for (std::size_t m = 0; m < evc::kModes; ++m) page += " " + std::string(name(static_cast<Mode>(m))) + " |";
  page += "\n|---|";
  for (std::size_t m = 0; m < evc::kModes; ++m) page += "---|";
  page += "\n";
  for (const Rule& rule : brake_rules::rules()) {
    for (const Entries& row : entries_of(rule)) {
      if (row.marks[0] == 0) continue;
      page += "| `" + rule.id + "`" + row.name.substr(rule.id.size()) + " |";
      for (std::size_t m = 0; m < evc::kModes; ++m) page += " " + cell_of(row, m, absent) + " |";
      page += "\n";
    }
  }
}

}  // namespace

std::vector<std::string> watch_brakes(brake_rules::Memory& memory, const port::Inputs& in, const port::Outputs& out,
                                      bool emergency_until_standstill, const std::string& scenario) {
  return brake_rules::look(memory, in, out, emergency_until_standstill, &seen(), scenario);
}

std::vector<std::string> missing_of_brakes() { return without_row(brakes_not_shown(), unseen_of_brakes()); }
std::vector<std::string> not_missing_of_brakes() { return wrong_rows(brakes_not_shown(), unseen_of_brakes()); }
std::size_t known_missing_of_brakes() { return brakes_not_shown().size(); }

std::string brakes_page() {
  const auto absent = brakes_not_shown();
  std::string page =
      "# What commands the brakes, and what releases them\n"
      "Every cause of a brake command (SUBSET-026-3 3.14.1), as seen from outside in the cycles of all "
      "[scenarios](scenarios.md):\n"
      "made by `scenarios_test --brakes`. The rules are those of "
      "[brake_causes.json](../tests/reference/brake_causes.json),\n"
      "written from the text of the standard. In every cycle of every scenario, and of the "
      "[exploration](exploration.md), a command\n"
      "that ends without its release conditions, or that a mode entry should have revoked or maintained, is a fault.\n";
  page +=
      "\n## Commanded, held, released\n"
      "Ways to a release are divided by `;`, what each of them needs by `+`. Held: seen commanded with this condition "
      "missing\n"
      "and the others of its way fulfilled.\n\n";
  add_rules(page);
  page +=
      "\n## Mode entries\n"
      "4.12 of 4.0.0, which the unit applies in every edition (of a national system: SUBSET-035 5.3.1.1; of the balise "
      "antenna, which\n"
      "4.12 does not have: 3.15.7 and 4.4 of each edition): `r` seen revoked, `m` seen maintained (both: `r` from PT; "
      "in "
      "SB: in levels 1\n"
      "and 2), `t` seen evaluated again, `?` not seen, see below; empty: not relevant or not defined by the table.\n\n";
  add_entries(page, absent);
  page += "\n## Not seen\n| what | why |\n|---|---|\n";
  for (const auto& [key, why] : absent) page += "| " + key + " | " + why + " |\n";
  return page;
}

}  // namespace evc::scenario
