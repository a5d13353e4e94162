#include "deceleration/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace evc::deceleration {
namespace {

struct Case {
  std::string name;
  Distribution distribution;
  double scale;  // of its values: the tilt is measured with it
};

std::vector<Case> cases() {
  return {{"constant", Distribution(0.9), 0.1},
          {"normal", Distribution(Normal{1.0, 0.1, false, 0.0, 0.0}), 0.1},
          {"truncated", Distribution(Normal{1.0, 0.1, true, 0.9, 1.3}), 0.1},
          {"ends in the middle", Distribution(Normal{0.5, 0.1, true, 0.5, 1.5}), 0.1},
          {"one side", Distribution(Normal{1.0, 0.2, true, 1.2, 2.0}), 0.2},
          {"uniform", Distribution(std::vector<Piece>{{0.8, 1.1, 1.0}}), 0.1},
          {"discrete", Distribution(std::vector<Piece>{{0.5, 0.5, 0.01}, {0.9, 0.9, 0.29}, {1.0, 1.0, 0.7}}), 0.1},
          {"tabulated", Distribution(std::vector<Piece>{{0.7, 0.9, 0.1}, {0.9, 1.0, 0.4}, {1.1, 1.2, 0.5}}), 0.1}};
}

/// The mean of f over the values of a distribution, by 200 000 shares.
template <class F>
double mean_of(const Tilted& tilted, F f) {
  constexpr int kShares = 200000;
  double sum = 0.0;
  for (int i = 0; i < kShares; ++i) sum += f(tilted.at((i + 0.5) / kShares));
  return sum / kShares;
}

TEST(Distribution, its_mean_is_that_of_its_values) {
  for (const Case& c : cases())
    EXPECT_NEAR(c.distribution.mean(), mean_of(c.distribution.tilted(0.0), [](double y) { return y; }), 2e-6) << c.name;
}

TEST(Distribution, its_transform_is_the_mean_of_the_exponential) {
  for (const Case& c : cases())
    for (const double tilt : {-1.5, -0.5, 0.0, 1e-12, 0.5, 1.5}) {
      const double theta = tilt / c.scale;
      const double mean = mean_of(c.distribution.tilted(0.0), [&](double y) { return std::exp(-theta * y); });
      EXPECT_NEAR(c.distribution.log_transform(theta), std::log(mean), 5e-4) << c.name << ' ' << tilt;
    }
}

// What importance sampling rests on: the weight takes the tilt back, for any function of the value.
TEST(Distribution, the_weights_take_the_tilt_back) {
  for (const Case& c : cases())
    for (const double tilt : {-1.2, 0.7, 1.2}) {
      const double theta = tilt / c.scale;
      const double norm = c.distribution.log_transform(theta);
      const auto weight = [&](double y) { return std::exp(theta * y + norm); };
      const Tilted tilted = c.distribution.tilted(theta), plain = c.distribution.tilted(0.0);
      EXPECT_NEAR(mean_of(tilted, weight), 1.0, 1e-2) << c.name << ' ' << tilt;
      const double median = plain.at(0.5);
      const auto is_low = [&](double y) { return y < median ? 1.0 : 0.0; };
      EXPECT_NEAR(mean_of(tilted, [&](double y) { return weight(y) * is_low(y); }), mean_of(plain, is_low), 1e-2)
          << c.name << ' ' << tilt;
    }
}

TEST(Distribution, a_tilt_that_is_too_large_is_told_and_others_stay_in_the_range) {
  for (const Case& c : cases()) {
    const auto [from, to] = c.distribution.range();
    for (double theta = -1e7; theta < 1e7; theta = theta < -1.0  ? theta / 3.0
                                                   : theta < 1.0 ? theta + 0.5
                                                                 : theta * 3.0) {
      if (!std::isfinite(c.distribution.log_transform(theta))) continue;
      const Tilted tilted = c.distribution.tilted(theta);
      double before = from;
      for (const double share : {1e-16, 0.1, 0.5, 0.9, 1.0 - 1e-16}) {
        const double value = tilted.at(share);
        EXPECT_TRUE(value >= from && value <= to) << c.name << ' ' << theta << ' ' << value;
        if (theta == 0.0) {
          EXPECT_GE(value, before) << c.name;
        }
        before = value;
      }
    }
  }
}

}  // namespace
}  // namespace evc::deceleration
