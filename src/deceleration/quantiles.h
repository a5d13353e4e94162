#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "deceleration/quantity.h"

namespace evc::deceleration {

inline constexpr std::size_t kLevels = 10;
/// How likely a value below the quantile is, by M_NVEBCL: confidence of 50 %, 90 %, 99 %, ... 99.9999999 %.
inline constexpr std::array<double, kLevels> kBelow{0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
/// Of a normal variable 95 % lie within so many deviations.
inline constexpr double kNormal95 = 1.959963984540054;

/// An estimate with its bounds, which enclose the true value in 95 of 100 cases.
struct Quantile {
  double value = 0.0, low = 0.0, high = 0.0;
};
using Quantiles = std::array<Quantile, kLevels>;

struct Effort {
  std::uint64_t seed = 1;
  std::size_t samples = 20000;  ///< for each level
  unsigned threads = 1;
  std::function<void(double)> progress = [](double) {};  ///< gets the share that is done, in the caller's thread
};

/// The values below which the quantity is with the probabilities kBelow. `number` distinguishes the quantities of one
/// spec: each has draws of its own. The result does not depend on the number of threads.
Quantiles quantiles(const Quantity& quantity, std::uint32_t number, const Effort& effort);

/// One sample of a stratum.
struct Weighted {
  double value = 0.0, weight = 0.0;
  std::uint32_t stratum = 0;
};
/// The quantile for `below` from samples whose weights, summed over a stratum and divided by its number of samples
/// (`sizes`), estimate its part of the distribution. `left_out` is the probability of strata without samples: it
/// counts as below, in the high bound as above. Without any sample lower than it, or where all samples together do not
/// have the probability, the low bound is `lowest`.
Quantile weighted_quantile(std::vector<Weighted> samples, std::span<const std::size_t> sizes, double left_out,
                           double below, double lowest);

}  // namespace evc::deceleration
