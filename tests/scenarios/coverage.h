#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "script.h"

// Which scenarios cover each message, procedure, row of the table of stored information and brake cause.
namespace evc::scenario {

struct Required {
  std::string kind, name, about;
};
/// What has to be covered: from the language, the reference table of 4.10 and required.txt.
std::vector<Required> required();
/// The rows of missing.txt: "kind name" -> reason why no scenario covers it yet.
std::map<std::string, std::string> missing();

struct Shown {
  std::string file, name;
  bool open;
};
using Coverage = std::map<std::string, std::vector<Shown>>;  ///< by "kind name"

/// The page docs/scenario-coverage.md; all scenarios have been run.
std::string coverage_page(const Coverage& coverage);

}  // namespace evc::scenario
