#pragma once
#include <optional>

#include "base/units.h"
#include "procedures/effects.h"
#include "terms/mode.h"

// Reversing, SUBSET-026-5 5.13 and SUBSET-026-3 3.15.4.
namespace evc::procedures::reversing {

/// Stored by packets 138 and 139. The reference of the distance is the end of the area received with it (3.15.4.3).
struct Reversing {
  Place start{}, end{};               // of the area
  Place reference{};                  // start of the distance
  std::optional<Distance> D_REVERSE;  // none: infinite
  Speed V_REVERSE{};
};

struct Inputs {
  Mode mode = Mode::FS;
  bool standstill = false;
  bool controller_backward = false;  // the driver's intention
  Place est_front{};
  std::optional<Reversing> stored;
};

struct Result {
  Effects effects;               // request Ack::RV
  bool possible = false;         // shown to the driver (ST06)
  bool distance_passed = false;  // RV: the estimated front end is beyond the distance, backwards
};

Result step(const Inputs& inputs);

}  // namespace evc::procedures::reversing
