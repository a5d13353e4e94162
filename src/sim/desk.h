#pragma once
#include <algorithm>

#include "port/inputs.h"
#include "sim/motion.h"

namespace evc::sim {

/// The controls of a driver's desk, for a world that is driven by hand.
struct Desk {
  double lever = -1.0;  ///< combined: 1 full traction, 0 coasting, -1 full service brake
  port::DirectionController direction = port::DirectionController::neutral;
  bool open = false;       ///< the key is in the lock and turned
  bool emergency = false;  ///< the emergency push button is down
};

/// What the controls do to the train. With a closed desk, or in neutral, there is no traction; a closed desk brakes.
inline Handle handle_of(const Desk& desk) {
  using enum port::DirectionController;
  Handle handle;
  if (desk.open && desk.direction != neutral) handle.traction = std::clamp(desk.lever, 0.0, 1.0);
  handle.brake = desk.open ? std::clamp(-desk.lever, 0.0, 1.0) : 1.0;
  handle.emergency = desk.emergency;
  handle.sense = desk.direction == backward ? -1.0 : 1.0;
  return handle;
}

}  // namespace evc::sim
