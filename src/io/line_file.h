#pragma once
#include <string>
#include <string_view>

#include "io/diagnostic.h"
#include "sim/line.h"

namespace evc::io {

/// Reads `etcs-line/1`. Unknown keys are allowed in this schema only. A file in which no group has bits is rejected.
Result<sim::Line> read_line(std::string_view text, const std::string& file);

}  // namespace evc::io
