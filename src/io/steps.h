#pragma once
#include "base/step_function.h"
#include "io/json.h"

namespace evc::io {

/// Reads `[[from, value], ...]` into a step function: the first step begins at 0, steps increase, and
/// there are at most as many as the standard allows in `clause`. `read_value(row)` reads what follows `from`.
template <class Function, class ReadValue>
Function read_steps(const JsonPlace& table, double unit, Clause clause, ReadValue read_value) {
  Function f;
  if (table.size() == 0) table.fail("at least one [from, value]" + of_clause(clause));
  for (std::size_t i = 0; i < table.size(); ++i) {
    const JsonPlace row = table[i];
    const double from = row[0].number(0.0, 1e6, clause);
    if (i == 0 && from != 0.0) row[0].fail("0: the first step begins at 0" + of_clause(clause));
    if (i > 0 && !(from > table[i - 1][0].number()))
      row[0].fail("a step further than the one before" + of_clause(clause));
    // Not `append`: it merges equal neighbours, but the table is stored as given.
    if (!f.steps.push_back({{from / unit}, read_value(row)}))
      table.fail("at most " + std::to_string(Function{}.steps.capacity()) + " steps" + of_clause(clause));
  }
  return f;
}

/// Requires a row of exactly `n` numbers.
inline void require_row(const JsonPlace& row, std::size_t n) {
  if (row.size() != n) row.fail("an array of " + std::to_string(n));
}

}  // namespace evc::io
