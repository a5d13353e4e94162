#include "random/draws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "random/philox.h"

namespace evc::random {
namespace {

using Counter = std::array<std::uint32_t, 4>;

// The known answers that its authors publish for philox4x32 with 10 rounds (Random123, kat_vectors).
TEST(Philox, known_answers) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Counter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Counter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Counter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Draws, depend_on_seed_number_and_entry) {
  std::set<double> all;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (std::uint64_t number : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32})
      for (std::uint32_t entry = 0; entry < 3; ++entry) {
        const double draw = uniform_draw(seed, number, entry);
        EXPECT_TRUE(draw >= 0.0 && draw < 1.0);
        EXPECT_EQ(draw, uniform_draw(seed, number, entry));
        all.insert(draw);
      }
  EXPECT_EQ(all.size(), 27U);
}

TEST(Draws, are_uniform) {
  constexpr int kBins = 20, kDraws = 20000;
  std::array<int, kBins> bins{};
  for (int n = 0; n < kDraws; ++n)
    ++bins[static_cast<std::size_t>(uniform_draw(7, static_cast<std::uint64_t>(n), 2) * kBins)];
  double chi_squared = 0.0;
  for (const int count : bins) chi_squared += std::pow(count - kDraws / kBins, 2) / (kDraws / kBins);
  EXPECT_LT(chi_squared, 43.8);  // 19 degrees of freedom: exceeded once in a thousand times
}

TEST(Quantile, is_the_inverse_of_the_distribution) {
  for (double p = 1e-12; p < 1.0; p = p < 0.01 ? p * 3.7 : p + 0.013) {
    const double back = 0.5 * std::erfc(-normal_quantile(p) / std::sqrt(2.0));
    EXPECT_NEAR(back / p, 1.0, 1e-13) << p;
  }
  EXPECT_EQ(normal_quantile(0.5), 0.0);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-15);
}

// The first points of the sequence, as in the notes of Joe and Kuo, in the order of the Gray code.
TEST(Sobol, first_points) {
  const Sobol sobol(3);
  const double expected[][3] = {{0.5, 0.5, 0.5},       {0.75, 0.25, 0.25},    {0.25, 0.75, 0.75},
                                {0.375, 0.375, 0.625}, {0.875, 0.875, 0.125}, {0.625, 0.125, 0.875},
                                {0.125, 0.625, 0.375}};
  for (std::size_t n = 0; n < std::size(expected); ++n)
    for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(sobol.at(n, d), expected[n][d]) << n << ' ' << d;
}

// With the origin, the first 2^k points have one in each of 2^k equal parts of every axis, and each axis is another
// one.
TEST(Sobol, every_axis_is_even) {
  constexpr std::size_t kPoints = 1024;
  const Sobol sobol(Sobol::kMostDimensions);
  std::set<std::vector<double>> axes;
  for (std::size_t d = 0; d < Sobol::kMostDimensions; ++d) {
    std::set<std::size_t> parts{0};
    std::vector<double> axis;
    for (std::size_t n = 0; n + 1 < kPoints; ++n) {
      const double x = sobol.at(n, d);
      EXPECT_TRUE(x > 0.0 && x < 1.0);
      axis.push_back(x);
      parts.insert(static_cast<std::size_t>(x * kPoints));
    }
    EXPECT_EQ(parts.size(), kPoints) << d;
    axes.insert(std::move(axis));
  }
  EXPECT_EQ(axes.size(), Sobol::kMostDimensions);
}

}  // namespace
}  // namespace evc::random
