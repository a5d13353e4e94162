#include "missing_list.h"

#include <fstream>
#include <set>
#include <sstream>

#include "base/test_paths.h"

namespace evc::scenario {

MissingList missing_list(const std::string& file) {
  MissingList rows;
  std::ifstream in(evc::test::source_folder() + "/tests/scenarios/" + file);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t space = line.find(' '), colon = line.find(": ");
    const std::string why = colon == std::string::npos ? "" : line.substr(colon + 2);
    const std::string key = line.substr(space, colon == std::string::npos ? colon : colon - space);
    for (const std::string& name : items_of(line.substr(0, space))) rows[name + key] = why;
  }
  return rows;
}

std::vector<std::string> without_row(const MissingList& list, const std::vector<std::string>& not_shown) {
  std::vector<std::string> keys;
  for (const std::string& key : not_shown)
    if (!list.contains(key)) keys.push_back(key);
  return keys;
}

std::vector<std::string> wrong_rows(const MissingList& list, const std::vector<std::string>& not_shown) {
  const std::set<std::string> known(not_shown.begin(), not_shown.end());
  std::vector<std::string> keys;
  for (const auto& [key, why] : list)
    if (!known.contains(key) || why.empty()) keys.push_back(key);
  return keys;
}

std::vector<std::string> items_of(const std::string& list) {
  std::vector<std::string> items;
  std::istringstream in(list);
  for (std::string item; std::getline(in, item, ',');) items.push_back(item);
  return items;
}

}  // namespace evc::scenario
