#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/evc.h"

// What the driver interface shows and allows in each mode (4.7.2), as seen in the cycles of scenarios.
namespace evc::scenario {

/// Takes note of one cycle of a unit of 3.6.0.
void watch_display(const kernel::Outputs& out, const std::string& scenario);

/// Cells of the table that are shown or enabled although the table has none there, with the scenario.
std::vector<std::string> wrong_on_display();
/// Cells that the table has and no scenario shows, as "output NAME MODE"; those of display_missing.txt left out.
std::vector<std::string> missing_on_display();
/// Rows of display_missing.txt that are shown, or that the table does not have.
std::vector<std::string> not_missing_on_display();

/// The page docs/display-coverage.md.
std::string display_page();

}  // namespace evc::scenario
