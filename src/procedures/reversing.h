#pragma once
#include <optional>

#include "base/units.h"
#include "procedures/effects.h"
#include "terms/mode.h"

// Reversing, SUBSET-026-5 5.13 and SUBSET-026-3 3.15.4.
namespace evc::procedures::reversing {

/// The area of packet 138, with the supervision of packet 139 stored as well (3.15.4.2).
struct Area {
  Place start{}, end{};
};

struct Inputs {
  Mode mode = Mode::FS;
  bool standstill = false;
  bool controller_backward = false;  // the driver's intention
  Place est_front{};
  std::optional<Area> stored;
};

struct Result {
  Effects effects;        // request Ack::RV
  bool possible = false;  // shown to the driver (ST06)
};

Result step(const Inputs& inputs);

}  // namespace evc::procedures::reversing
