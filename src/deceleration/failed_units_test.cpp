#include "deceleration/failed_units.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

namespace evc::deceleration {
namespace {

constexpr std::size_t kUnits = 7;
const std::vector<double> kFails{0.1, 0.02, 0.3, 0.05, 0.2, 0.01, 0.15};
const std::vector<double> kWorks{0.9, 0.5, 0.7, 1.4, 0.8, 0.99, 0.1};

double weight_of(unsigned set) {
  double weight = 1.0;
  for (std::size_t u = 0; u < kUnits; ++u) weight *= (set >> u & 1u) != 0 ? kFails[u] : kWorks[u];
  return weight;
}

TEST(FailedUnits, the_sum_is_that_over_all_sets) {
  for (std::size_t count = 0; count <= kUnits; ++count) {
    double sum = 0.0;
    for (unsigned set = 0; set < 1u << kUnits; ++set)
      if (static_cast<std::size_t>(std::popcount(set)) == count) sum += weight_of(set);
    EXPECT_NEAR(FailedUnits(kFails, kWorks, count).sum() / sum, 1.0, 1e-13) << count;
    EXPECT_NEAR(sums_by_failed(kFails, kWorks, kUnits)[count] / sum, 1.0, 1e-13) << count;
  }
}

TEST(FailedUnits, sets_are_drawn_by_their_weight) {
  constexpr std::uint32_t kDraws = 50000;
  const FailedUnits failed(kFails, kWorks, 2);
  std::vector<int> drawn(1u << kUnits, 0);
  std::vector<char> flags(kUnits);
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    failed.draw({5, 0, 0, i}, 3, flags);
    unsigned set = 0;
    for (std::size_t u = 0; u < kUnits; ++u) set |= (flags[u] != 0 ? 1u : 0u) << u;
    ASSERT_EQ(std::popcount(set), 2);
    ++drawn[set];
  }
  double chi_squared = 0.0;
  for (unsigned set = 0; set < drawn.size(); ++set) {
    const double expected = std::popcount(set) == 2 ? kDraws * weight_of(set) / failed.sum() : 0.0;
    if (expected > 0.0) chi_squared += std::pow(drawn[set] - expected, 2) / expected;
  }
  EXPECT_LT(chi_squared, 45.3);  // 20 degrees of freedom: exceeded once in a thousand times
}

TEST(FailedUnits, probabilities_are_those_of_the_binomial_distribution) {
  const std::vector<double> failure(12, 0.03);
  const auto probabilities = probabilities_of_failures(failure);
  ASSERT_EQ(probabilities.size(), 13U);
  double ways = 1.0;
  for (std::size_t n = 0; n < probabilities.size(); ++n) {
    const auto m = static_cast<double>(n);
    EXPECT_NEAR(probabilities[n] / (ways * std::pow(0.03, m) * std::pow(0.97, 12.0 - m)), 1.0, 1e-12) << n;
    ways *= (12.0 - m) / (m + 1.0);
  }
}

}  // namespace
}  // namespace evc::deceleration
