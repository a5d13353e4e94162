#include "coverage.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/test_paths.h"
#include "lang/layouts.h"
#include "mode_coverage.h"

namespace evc::scenario {
namespace {

const std::string kRoot = evc::test::source_folder();

/// `KIND NAME rest` of each line that is not a comment.
std::vector<Required> rows_of(const std::string& path) {
  std::vector<Required> rows;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    Required r;
    words >> r.kind >> r.name >> std::ws;
    std::getline(words, r.about);
    rows.push_back(std::move(r));
  }
  return rows;
}

}  // namespace

std::vector<Required> required() {
  std::vector<Required> all;
  for (const lang::MessageLayout& m : lang::message_layouts()) {
    if (m.info->direction != lang::Direction::to_train) continue;
    const std::string name = std::to_string(m.info->NID_MESSAGE);
    if (all.empty() || all.back().name != name)
      all.push_back({"message", name, std::string(m.info->ref) + " " + m.info->name});
  }
  std::ifstream in(kRoot + "/tests/reference/stored_information.json");
  const auto reference = nlohmann::json::parse(in);
  for (const auto& row : reference["on_mode_entry"]) all.push_back({"stored", row["id"].get<std::string>(), "4.10"});
  for (Required& r : rows_of(kRoot + "/tests/scenarios/required.txt")) all.push_back(std::move(r));
  for (Required& r : rows_of(kRoot + "/tests/reference/procedure_steps.txt")) all.push_back(std::move(r));
  std::ifstream table(kRoot + "/tests/reference/mode_transitions_v400.json");
  const auto modes = nlohmann::json::parse(table);
  for (const auto& cell : modes["transitions"])
    all.push_back({"cell", cell["from"].get<std::string>() + ">" + cell["to"].get<std::string>(),
                   "4.6.2 " + cell["conditions"].dump()});
  return all;
}

std::map<std::string, std::string> missing() {
  std::map<std::string, std::string> all;
  for (const Required& r : rows_of(kRoot + "/tests/scenarios/missing.txt")) all[r.kind + " " + r.name] = r.about;
  return all;
}

std::string coverage_page(const Coverage& coverage) {
  std::string page =
      "# What the scenarios show\n"
      "Made from the `covers` lines of [the scenarios](scenarios.md), and for the mode table from what was seen in "
      "them, by\n"
      "`scenarios_test --coverage`; a test fails when this page is not up to date. *open*: the scenario is expected to "
      "fail until a finding is corrected.\n";
  const auto absent = missing();
  std::string kind;
  for (const Required& r : required()) {
    if (r.kind == "cell") continue;  // as they are caused, of every edition: modes_page()
    if (r.kind != kind) {
      kind = r.kind;
      page += "\n## " +
              std::string(kind == "message"     ? "Messages to the train"
                          : kind == "stored"    ? "Stored information (4.10)"
                          : kind == "procedure" ? "Procedures"
                          : kind == "step"      ? "Steps and branches of the procedures"
                                                : "Brake causes") +
              "\n| " + kind + " | clause | scenarios |\n|---|---|---|\n";
    }
    page += "| " + r.name + " | " + r.about + " | ";
    const auto shown = coverage.find(r.kind + " " + r.name);
    if (shown != coverage.end()) {
      bool first = true;
      for (const Shown& s : shown->second) {
        page += (first ? "" : "; ") + s.file + ": " + s.name + (s.open ? " (*open*)" : "");
        first = false;
      }
    } else if (const auto why = absent.find(r.kind + " " + r.name); why != absent.end()) {
      page += "none: " + why->second;
    }
    page += " |\n";
  }
  page += modes_page();
  return page;
}

}  // namespace evc::scenario
