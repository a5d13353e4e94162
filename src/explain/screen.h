#pragma once
#include <string>

#include "explain/journal.h"

// The answer of `evc explain`, lines of at most 100 columns.
namespace evc::explain {

/// Mode, level, brake, speed limit and position with their reasons, and the transitions out of the mode with what
/// hinders each.
std::string situation(const Journal& journal);
/// The chain of each brake command, or of the last ones before. `answered`: there was one.
std::string why_brake(const Journal& journal, bool& answered);

}  // namespace evc::explain
