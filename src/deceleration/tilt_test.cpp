#include "deceleration/tilt.h"

#include <gtest/gtest.h>

#include <cmath>

#include "deceleration/spec.h"

namespace evc::deceleration {
namespace {

/// Unequal units of each kind of variable; those of the last group do not fail.
Quantity unequal_units() {
  Quantity quantity;
  double all = 0.0;
  const auto add = [&](std::size_t units, double failure, double weight, const Distribution& first) {
    Quantity::Group group;
    group.units = units;
    group.failure = failure;
    group.weight = weight;
    group.first = first;
    group.first_mean = first.mean();
    group.second_mean = 1.0;
    group.base = group.second_slope = weight * group.first_mean;
    group.first_slope = weight;
    quantity.groups.push_back(group);
    all += static_cast<double>(units) * weight * group.first_mean;
  };
  add(6, 0.01, 0.04, Distribution(Normal{1.0, 0.1, false, 0.0, 0.0}));
  add(5, 0.1, 0.06, Distribution(std::vector<Piece>{{0.8, 1.1, 1.0}}));
  add(4, 0.03, 0.05, Distribution(Normal{0.9, 0.1, true, 0.8, 1.2}));
  add(3, 0.0, 0.08, Distribution(1.0));
  quantity.common = Distribution(Normal{1.0, 0.05, false, 0.0, 0.0});
  quantity.common_slope = all;
  return quantity;
}

// The place in the table is the saddle point: no tilt beside it has a lower bound of Chernoff.
TEST(Tilts, the_mean_of_L_is_the_place) {
  const Quantity quantity = unequal_units();
  constexpr std::size_t kStrata = 6;
  const Tilts tilts(quantity, kStrata);
  for (std::size_t failed = 0; failed < kStrata; ++failed)
    for (const double target : {0.85, 0.75, 0.6, 0.5}) {
      const auto height = [&](double theta) { return Tilt(quantity, failed, theta).log_transform() + theta * target; };
      const double theta = tilts.theta_for(failed, target);
      if (theta == 0.0) {
        EXPECT_GE(height(2e-3), height(0.0)) << failed << ' ' << target;
        continue;
      }
      // The mean of L less the place, in deviations: the second derivative is the variance of L.
      const double step = 1e-3 * theta;
      const double first = (height(theta + step) - height(theta - step)) / (2.0 * step);
      const double second = (height(theta + step) - 2.0 * height(theta) + height(theta - step)) / (step * step);
      ASSERT_GT(second, 0.0) << failed << ' ' << target;
      EXPECT_LT(std::abs(first) / std::sqrt(second), 0.05) << failed << ' ' << target << ' ' << theta;
    }
}

TEST(Tilts, a_stratum_that_cannot_be_or_is_below_anyway_is_not_tilted) {
  const Quantity quantity = unequal_units();
  const Tilts tilts(quantity, 17);  // 15 units may fail
  EXPECT_EQ(tilts.theta_for(16, 0.5), 0.0);
  EXPECT_EQ(tilts.theta_for(3, 2.0), 0.0);
}

// A place beyond all that the units can be: the tilt stays one that can be computed.
TEST(Tilts, a_place_that_no_tilt_reaches_has_a_finite_one) {
  Quantity quantity = unequal_units();
  quantity.common = Distribution(1.0);
  quantity.common_slope = 0.0;
  quantity.groups.erase(quantity.groups.begin());
  const Tilts tilts(quantity, 3);
  for (std::size_t failed = 0; failed < 3; ++failed) {
    const double theta = tilts.theta_for(failed, -1.0);
    EXPECT_GT(theta, 1.0);
    EXPECT_TRUE(std::isfinite(Tilt(quantity, failed, theta).log_transform())) << failed << ' ' << theta;
  }
}

}  // namespace
}  // namespace evc::deceleration
