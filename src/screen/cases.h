#pragma once
#include <string>

#include "io/json.h"
#include "screen/screen_json.h"

namespace evc::screen {

/// The answer to one case of a file of cases: its `id`, and what its `expect` asks for. Nothing is compared. Throws
/// ReadError, with the place in the file, for a case that is not understood.
OrderedJson answer(const io::JsonPlace& one_case);

/// `evc dmi --cases`: a line for each case. Returns the exit status: 0, or 2 with one line on standard error.
int cases(const std::string& input, const std::string& output);

}  // namespace evc::screen
