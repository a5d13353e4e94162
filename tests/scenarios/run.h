#pragma once
#include <string>

#include "script.h"

namespace evc::scenario {

/// Runs a scenario on a unit of its own, cycle by cycle, through the stream of inputs and the output lines of `evc
/// replay`. Nothing when it went as it has to; else what did not: place, statement, expected, found, the last outputs.
/// A scenario that is open has to fail at a `then` of its own.
std::string run(const Scenario& scenario);

/// The inputs of a run as `evc replay` reads them, one line each; for a scenario that has to be looked at closely.
std::string inputs_of(const Scenario& scenario);

}  // namespace evc::scenario
