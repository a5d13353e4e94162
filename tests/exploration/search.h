#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "actions.h"

namespace evc::exploration {

/// How far a search goes.
struct Bounds {
  int depth = 2;             ///< every sequence of so many actions from power-up
  std::size_t states = 300;  ///< then the states seen least, until so many are expanded
};

/// What a search found. States that show the driver, the train and the RBC the same are one.
struct Found {
  std::size_t expanded = 0, states = 0, inputs = 0, ways_on = 0;
  int depth = 0;  ///< longest way
  std::map<std::pair<std::string, std::string>, std::uint64_t> cells;
  std::map<std::string, std::uint64_t> cycles;  ///< of each mode that was visited
  std::vector<std::string> modes;               ///< of the edition
  Applied applied{};                            ///< of each rule of rules.h
  std::vector<std::string> faults;              ///< each kind once, with the actions from power-up that lead to it
};
/// Prints the output line after each action of `way`, names with "; " between them.
void print_way(SrsVersion srs, const std::string& way);
Found search(SrsVersion srs, Bounds bounds);

}  // namespace evc::exploration
