#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kernel/state.h"
#include "port/inputs.h"
#include "procedures/observe.h"
#include "terms/requests.h"
#include "terms/srs_version.h"

// The conditions of SUBSET-026-4 4.6.3 as rows to be laid beside the page: a condition is true when all its terms are.
// Written from the text of the standard, apart from the formulas of the unit (procedures/conditions_of.h): scenarios
// compare the two in every cycle (mode_coverage.h).
namespace evc::scenario {

/// What a cycle was about. What the driver, the train and the RBC give is taken from the inputs; what only the unit can
/// say (position, stored data, results of the filters of 4.8) from its own facts.
struct Moment {
  const port::Inputs& in;
  const procedures::Facts& facts;
  const kernel::State& state;  ///< after the cycle
  bool SH_was_asked_for;       ///< the RBC had not answered yet before the cycle
};

struct Term {
  std::string text;
  std::function<bool(const Moment&)> holds;
  // What the term reads from the inputs and the unit may refuse (4.7.2, 4.8): the condition does not hold then.
  std::optional<port::Select> selection = {};
  std::optional<Ack> acknowledgement = {};
  std::optional<int> NID_MESSAGE = {};
};

/// One row: `[number]` in the editions named.
struct ConditionRow {
  int number;
  bool of_3, of_4;  ///< 3.4.0 and 3.6.0; 4.0.0
  std::vector<Term> terms;

  bool is_of(SrsVersion srs) const { return srs == SrsVersion::v4_0_0 ? of_4 : of_3; }
};

/// Every condition of every edition, in the order of the standard.
const std::vector<ConditionRow>& condition_rows();

/// The row of an edition; null: the edition has no such condition.
const ConditionRow* condition_row(int number, SrsVersion srs);

}  // namespace evc::scenario
