#pragma once
#include <array>
#include <bitset>
#include <set>
#include <string>
#include <vector>

#include "condition_terms.h"
#include "kernel/evc.h"
#include "modes/conditions.h"
#include "terms/mode.h"

// Which scenario causes each cell of the mode table 4.6.2, and shows each term of each condition of 4.6.3, by edition:
// what was seen in the inputs and outputs of their cycles.
namespace evc::scenario {

/// What one scenario shows.
class ModeWatch {
 public:
  /// A cycle that began in mode `from`.
  void watch(SrsVersion srs, Mode from, const Moment& moment, const kernel::Outputs& out);
  /// Whether the outputs had the transition, whatever its condition.
  bool has(const std::string& from, const std::string& to) const;
  /// Adds it to what all scenarios show, under a name as "radio: train accepted".
  void add_to_all(const std::string& scenario) const;

 private:
  /// [from][to]: the conditions that caused the transition.
  using Caused = std::array<std::array<modes::Conditions, evc::kModes>, evc::kModes>;

  void compare(int number, Mode from, int by, const Moment& moment, const kernel::Outputs& out);

  SrsVersion srs_ = SrsVersion::v3_6_0;
  Caused caused_{};
  modes::Conditions caused_by_;
  std::array<std::bitset<8>, modes::Conditions::kNumbers> only_missing_{};  ///< by condition: its term
  std::set<std::string> wrong_;
};

/// Where table and unit differ: a transition without a cell, a condition with a term that is false, a condition of
/// which all terms are true while the mode stays. With the scenario.
std::vector<std::string> wrong_of_modes();
/// Cells and terms that no scenario shows, as the rows of modes_missing.txt; those that it names left out.
std::vector<std::string> missing_of_modes();
/// Rows of modes_missing.txt that are shown, that no edition has, or without a reason.
std::vector<std::string> not_missing_of_modes();
/// The rows of modes_missing.txt, each edition for itself.
std::size_t known_missing_of_modes();

/// The sections of docs/scenario-coverage.md.
std::string modes_page();

}  // namespace evc::scenario
