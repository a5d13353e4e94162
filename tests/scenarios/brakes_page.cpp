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

/// What has to be seen of one cell of 4.12; nothing of a grey one. What is evaluated again has to be commanded when the
/// mode is entered.
std::vector<std::string> keys_of(const Rule& rule, std::size_t mode) {
  const std::string entered = name(static_cast<Mode>(mode));
  switch (rule.marks[mode]) {
    case 'R':
      return {rule.id + " revoked " + entered};
    case 'M':
      return {rule.id + " kept " + entered};
    case 'P':
      return {rule.id + " kept " + entered, rule.id + " revoked " + entered + " from PT"};
    case 'O':
      return {rule.id + " kept " + entered, rule.id + " revoked " + entered};
    case 'T':
      return {rule.id + " evaluated " + entered};
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
    for (std::size_t m = 0; m < evc::kModes; ++m)
      for (const std::string& key : keys_of(rule, m)) want(key);
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

void add_entries(std::string& page, const MissingList& absent) {
  page += "| cause |";
  for (std::size_t m = 0; m < evc::kModes; ++m) page += " " + std::string(name(static_cast<Mode>(m))) + " |";
  page += "\n|---|";
  for (std::size_t m = 0; m < evc::kModes; ++m) page += "---|";
  page += "\n";
  for (const Rule& rule : brake_rules::rules()) {
    if (rule.marks[0] == 0) continue;
    page += "| `" + rule.id + "` |";
    for (std::size_t m = 0; m < evc::kModes; ++m) {
      std::string cell;
      for (const std::string& key : keys_of(rule, m)) {
        const std::string what = key.substr(rule.id.size() + 1);
        const char* letter = what[0] == 'k' ? "m" : what[0] == 'r' ? "r" : "t";
        cell += is_shown(key) ? letter : absent.contains(key) ? "?" : "missing";
      }
      page += " " + cell + " |";
    }
    page += "\n";
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
      "4.12 of 4.0.0, which the unit applies in every edition (of a national system: SUBSET-035 5.3.1.1): `r` seen "
      "revoked, `m` seen\n"
      "maintained (both: `r` from PT), `t` seen evaluated again, `?` not seen, see below; empty: not relevant or not "
      "defined by the table.\n\n";
  add_entries(page, absent);
  page += "\n## Not seen\n| what | why |\n|---|---|\n";
  for (const auto& [key, why] : absent) page += "| " + key + " | " + why + " |\n";
  return page;
}

}  // namespace evc::scenario
