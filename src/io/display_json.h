#pragma once
#include <string>

#include "kernel/port.h"

namespace evc::io {

/// Appends the record of the display as one JSON object, `evc-dmi/1` (docs/replay.md): speeds in km/h, distances in
/// metres, both rounded to a millionth; texts in UTF-8.
void append_display(std::string& out, const kernel::Display& display);

/// The same without what changes by motion and time alone: two records with the same text differ in nothing else
/// (`--changes`).
std::string motionless(const kernel::Display& display);

}  // namespace evc::io
