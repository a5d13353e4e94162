#pragma once
#include <array>
#include <span>
#include <vector>

#include "deceleration/quantiles.h"

namespace evc::deceleration {

/// A step of speed of the train: what it brakes with nominally, and the share of it that is guaranteed by M_NVEBCL.
struct Step {
  double from_kmh = 0.0;
  double A_brake_emergency = 0.0;  ///< m/s2
  std::array<double, kLevels> Kdry_rst{};
};

/// At most `most` steps that promise nowhere more than these: in each the deceleration and, at every level, its product
/// with the factor is at most that of each step that it takes the place of. Factors are at most 1, and both are rounded
/// down to thousandths. Of all ways to join neighbours it is the one that gives away the least of the product, as a
/// share, over all speeds up to `top_kmh` and levels.
std::vector<Step> joined(std::span<const Step> steps, std::size_t most, double top_kmh);

}  // namespace evc::deceleration
