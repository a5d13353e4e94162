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
template <class M, std::size_t N, class Name>
void print_matrix(const std::array<Cell<M>, N>& table, std::size_t modes, Name name_of) {
  std::printf("| into \\ from |");
  for (std::size_t from = 0; from < modes; ++from) std::printf(" %s |", name_of(static_cast<M>(from)));
  std::printf("\n|---|");
  for (std::size_t from = 0; from < modes; ++from) std::printf("---|");
  std::printf("\n");
  for (std::size_t to = 0; to < modes; ++to) {
    std::printf("| **%s** |", name_of(static_cast<M>(to)));
    for (std::size_t from = 0; from < modes; ++from) {
      const Cell<M>* found = nullptr;
      for (const Cell<M>& cell : table)
        if (cell.to == static_cast<M>(to) && cell.from == static_cast<M>(from)) found = &cell;
      if (found != nullptr)
        std::printf(" %s<br>p%d |", conditions(*found, ", ").c_str(), found->priority);
      else
        std::printf(to == from ? " \u00b7 |" : "  |");
    }
    std::printf("\n");
  }
}

const char* origin(Origin o) {
  switch (o) {
    case Origin::train_interface:
      return "train interface";
    case Origin::safety_monitor:
      return "safety monitor";
    case Origin::driver_selection:
      return "driver";
    case Origin::start_of_mission:
      return "start of mission";
    case Origin::train_trip:
      return "train trip";
    case Origin::mode_profile:
      return "mode profile";
    case Origin::shunting:
      return "shunting";
    case Origin::override_:
      return "override";
    case Origin::level_transition:
      return "level transition";
    case Origin::reversing:
      return "reversing";
    case Origin::staff_responsible:
      return "staff responsible";
    case Origin::authority:
      return "authority and track";
    case Origin::balise:
      return "balise groups";
    case Origin::emergency_stop:
      return "emergency stop";
    case Origin::radio:
      return "radio";
  }
  return "";
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
  print_matrix(srs_4_6_2, kModes, [](Mode m) { return name(m); });
  std::printf("\n## Conditions (4.6.3)\nShort descriptions; the text of the standard applies.\n\n");
  std::printf("| number | condition | kind | observed by |\n|---|---|---|---|\n");
  for (const Condition& row : srs_4_6_3)
    std::printf("| [%d] | %s | %s | %s |\n", row.number, row.meaning, nature(row.nature), origin(row.origin));
  std::printf(
      "\nTwo cells of equal priority have no condition in common; the compiler checks this. If two hold in one cycle,\n"
      "a level transition comes first, then an event, then the order of the page.\n\n"
      "## The table of 4.0.0\n"
      "Data only: the unit uses the table of 3.x. %zu cells.\n\n",
      v400::srs_4_6_2.size());
  print_matrix(v400::srs_4_6_2, v400::kModes, [](v400::Mode m) { return v400::name(m); });
}
