#pragma once
#include <span>
#include <string>

#include "kernel/port.h"

namespace evc::io {

/// A sound of the display (015560 14) by its name, and what is done with it: null: heard once; else "loop" or "stop".
struct NamedSound {
  const char* id = "";
  const char* what = nullptr;
};

/// Appends the record of the display as one JSON object, `evc-dmi/1` (docs/replay.md): speeds in km/h, distances in
/// metres, both rounded to a millionth; texts in UTF-8. `sounds`: those that a driver-machine interface orders.
void append_display(std::string& out, const kernel::Display& display, std::span<const NamedSound> sounds = {});

/// The same without what changes by motion and time alone: two records with the same text differ in nothing else
/// (`--changes`).
std::string motionless(const kernel::Display& display);

}  // namespace evc::io
