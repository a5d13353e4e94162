#pragma once
#include <string>
#include <string_view>

#include "io/diagnostic.h"

namespace evc::io {

/// Encodes a readable description of a line (`evc-line-description/1`, docs/make-line.md) into a line file
/// (`etcs-line/1`, system version 2.1): every place is given in metres along the run, and the distances, profiles and
/// linking of each telegram and message are computed from its reference.
io::Result<std::string> make_line(std::string_view description, const std::string& file);

}  // namespace evc::io
