#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "deceleration/quantiles.h"

namespace evc::deceleration {

/// A level of confidence has an estimate where so many samples are below it.
inline constexpr double kFewestBelow = 10.0;

/// Quantiles by levels; nothing where there are too few samples.
using PlainQuantiles = std::array<std::optional<Quantile>, kLevels>;

/// What a plain run found, and how.
struct PlainRun {
  std::uint64_t samples = 0;
  std::vector<PlainQuantiles> steps;  ///< by steps of speed
  double resolution = 0.0;            ///< values are counted in cells no wider than this
  double seconds = 0.0;               ///< that it took
};

/// The deceleration as a share of the nominal one, in each step of speed, by samples of the units as they are: no
/// strata, no tilt. One sample is one train: it gives a value in every step. Values of a step are counted in 200 000
/// cells from 0 to the largest of its first 4096 samples; the last cell has the larger ones too, none of which is a
/// quantile, as the highest is the median. The bounds are those of the binomial distribution, and a cell wider.
/// Memory: 1.6 MB for each step of speed, whatever the number of samples and threads.
PlainRun plain_run(const Spec& spec, std::uint64_t samples, const Effort& effort);

}  // namespace evc::deceleration
