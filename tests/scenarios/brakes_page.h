#pragma once
#include <string>
#include <vector>

#include "brake_rules.h"

// Every brake command seen given, held and released, and every cell of 4.12, in the cycles of scenarios.
namespace evc::scenario {

/// Takes note of one cycle of a unit; returns what breaks the rules.
std::vector<std::string> watch_brakes(brake_rules::Memory& memory, const port::Inputs& in, const port::Outputs& out,
                                      bool emergency_until_standstill, const std::string& scenario);

/// What the rules have and no scenario shows; that of brakes_missing.txt left out.
std::vector<std::string> missing_of_brakes();
/// Rows of brakes_missing.txt that are shown, that the rules do not have, or that are without a reason.
std::vector<std::string> not_missing_of_brakes();
std::size_t known_missing_of_brakes();

/// The page docs/brake-coverage.md.
std::string brakes_page();

}  // namespace evc::scenario
