// Prints docs/modes.md from the tables that the unit uses. tools/check_tables.py compiles and runs it.
#include <cstdio>
#include <string>

#include "modes/conditions.h"
#include "modes/srs_4_6_2.h"
#include "modes/srs_4_6_2_v400.h"
#include "terms/mode.h"

namespace {

using namespace evc;
using namespace evc::modes;

template <class M>
std::string conditions(const Cell<M>& cell, const char* between) {
  std::string text;
  for (const std::uint8_t n : cell.when) {
    if (n == 0) break;
    if (!text.empty()) text += between;
    text += std::to_string(n);
  }
  return text;
}

/// The matrix as on the page of the standard: a row for each mode entered, a column for each mode left.
template <std::size_t N, std::size_t Modes>
void print_matrix(const std::array<Cell<Mode>, N>& table, const std::array<Mode, Modes>& columns) {
  std::printf("| into \\ from |");
  for (const Mode from : columns) std::printf(" %s |", name(from));
  std::printf("\n|---|");
  for (std::size_t from = 0; from < Modes; ++from) std::printf("---|");
  std::printf("\n");
  for (const Mode to : columns) {
    std::printf("| **%s** |", name(to));
    for (const Mode from : columns) {
      const Cell<Mode>* found = nullptr;
      for (const Cell<Mode>& cell : table)
        if (cell.to == to && cell.from == from) found = &cell;
      if (found != nullptr)
        std::printf(" %s<br>p%d |", conditions(*found, ", ").c_str(), found->priority);
      else
        std::printf(to == from ? " \u00b7 |" : "  |");
    }
    std::printf("\n");
  }
}

const char* nature(Nature n) {
  switch (n) {
    case Nature::state:
      return "state";
    case Nature::event:
      return "event";
    case Nature::level:
      return "level transition";
  }
  return "";
}

template <std::size_t N>
void print_conditions(const std::array<Condition, N>& rows) {
  std::printf("| number | condition | kind |\n|---|---|---|\n");
  for (const Condition& row : rows) std::printf("| [%d] | %s | %s |\n", row.number, row.meaning, nature(row.nature));
}

}  // namespace

int main() {
  std::printf(
      "# The mode table\n"
      "Generated from `src/modes/` by `tools/check_tables.py --write` from the tables that the unit uses.\n\n"
      "## Transitions between modes (SUBSET-026-4 4.6.2, 3.3.0 to 3.6.0)\n"
      "A row for each mode entered, a column for each mode left; a cell contains the numbers of the conditions, any "
      "of\n"
      "which leads to the transition, and its priority (p1 is the highest). %zu cells.\n\n",
      srs_4_6_2.size());
  print_matrix(srs_4_6_2, kColumns);
  std::printf("\n## Conditions (4.6.3)\nShort descriptions; the text of the standard applies.\n\n");
  print_conditions(srs_4_6_3);
  std::printf(
      "\nTwo cells of equal priority have no condition in common; the compiler checks this. If two hold in one cycle,\n"
      "a level transition comes first, then an event, then the order of the page.\n\n"
      "## The table of 4.0.0\n"
      "Used with that edition. %zu cells.\n\n",
      v400::srs_4_6_2.size());
  print_matrix(v400::srs_4_6_2, v400::kColumns);
  std::printf("\nConditions that 3.x has not; those of 3.x count too, level 3 apart.\n\n");
  print_conditions(srs_4_6_3_v400);
}
