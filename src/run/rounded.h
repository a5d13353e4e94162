#pragma once
#include <cmath>

namespace evc::run {

/// To a tenth, as summaries and reports have it; what rounds to -0 is 0.
inline double tenth(double value) { return std::nearbyint(value * 10.0) / 10.0 + 0.0; }

}  // namespace evc::run
