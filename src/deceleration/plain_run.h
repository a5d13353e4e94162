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

/// The deceleration as a share of the nominal one, in each step of speed, by samples of the units as they are: no
/// strata, no tilt. One sample is one train: it gives a value in every step. Values are counted in steps of 0.00001:
/// the bounds are those of the binomial distribution, and a step wider.
std::vector<PlainQuantiles> plain_run(const Spec& spec, std::uint64_t samples, const Effort& effort);

}  // namespace evc::deceleration
