#pragma once
#include <string>
#include <string_view>

#include "io/diagnostic.h"
#include "kernel/port.h"

namespace evc::io {

/// Reads `evc-persistent/1`, what a unit kept without power: every key is required, unknown keys are errors.
Result<kernel::Retained> read_retained(std::string_view text, const std::string& file);
/// The whole text of such a file.
std::string retained_text(const kernel::Retained& retained);

}  // namespace evc::io
