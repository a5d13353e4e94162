#pragma once
#include <string>

#include "script.h"

namespace evc::scenario {

/// Runs a scenario on a unit of its own, cycle by cycle, through the stream of inputs and the output lines of `evc
/// replay`. Nothing if it passed; otherwise the failure: place, statement, expected, found, the last outputs. An open
/// scenario has to fail at a `then` of its own.
std::string run(const Scenario& scenario);
/// The same, and its inputs as of inputs_of().
std::string run(const Scenario& scenario, std::string& inputs);

/// The inputs of a run as `evc replay` reads them, one line each; to investigate a scenario.
std::string inputs_of(const Scenario& scenario);

}  // namespace evc::scenario
