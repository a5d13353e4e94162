#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "base/set.h"
#include "kernel/evc.h"
#include "terms/driver_output.h"
#include "terms/mode.h"

// What the driver interface shows and allows in each mode (4.7.2), as seen in the cycles of scenarios.
namespace evc::scenario {

/// What one scenario has seen on the display up to a cycle.
struct DisplayMemory {
  Set<DriverOutput> witnessed;  ///< shown in a cycle before, by a fact that the unit has held in each one since
  Mode mode = Mode::NP;         ///< of the cycle before
};

/// Takes note of one cycle of a unit, after its step.
void watch_display(DisplayMemory& memory, const kernel::State& state, const kernel::Outputs& out,
                   const std::string& scenario);

/// Cells of the table that are shown or enabled although the table has none there, with the scenario.
std::vector<std::string> wrong_on_display();
/// Cells that no scenario shows, or shows masked, as "4.0.0 output NAME MODE"; those of display_missing.txt left out.
std::vector<std::string> missing_on_display();
/// How many cells display_missing.txt names.
std::size_t known_missing_on_display();
/// Rows of display_missing.txt that are seen, or that the table does not have, or without a reason.
std::vector<std::string> not_missing_on_display();

/// The page docs/display-coverage.md.
std::string display_page();

}  // namespace evc::scenario
