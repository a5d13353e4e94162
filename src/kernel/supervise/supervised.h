#pragma once
#include <optional>

#include "brakes/brakes.h"
#include "sdm/supervision.h"

namespace evc::kernel {

/// What supervision found in this cycle.
struct Supervised {
  std::optional<sdm::Result> limits;  ///< 3.13.10; none where the mode does not supervise speed
  std::optional<Speed> LSSMA;         ///< 4.4.19.1.4, when it is to be shown
  brakes::CauseSet asked;             ///< brakes asked for
};

}  // namespace evc::kernel
