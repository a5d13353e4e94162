#include "deceleration/quantiles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "deceleration/guaranteed.h"
#include "io/program_test.h"

namespace evc::deceleration {
namespace {

/// Equal units whose friction is normal.
Quantity equal_units(std::size_t units, double deviation, double failure) {
  Quantity quantity;
  Quantity::Group group;
  group.units = units;
  group.failure = failure;
  group.weight = 1.0 / static_cast<double>(units);
  group.first = Distribution(Normal{1.0, deviation, false, 0.0, 0.0});
  group.first_mean = group.second_mean = 1.0;
  group.base = group.first_slope = group.second_slope = group.weight;
  quantity.common_slope = 1.0;
  quantity.groups.push_back(group);
  return quantity;
}

/// The distribution of their deceleration: a normal one for each number of units that work.
double probability_below(double value, std::size_t units, double deviation, double failure) {
  const auto n = static_cast<double>(units);
  double ways = 1.0, sum = 0.0;
  for (std::size_t failed = 0; failed < units; ++failed) {
    const auto f = static_cast<double>(failed);
    const double working = n - f;
    const double z = (value - working / n) / (deviation * std::sqrt(working) / n);
    sum += ways * std::pow(failure, f) * std::pow(1.0 - failure, working) * 0.5 * std::erfc(-z / std::sqrt(2.0));
    ways *= working / (f + 1.0);
  }
  return sum + (value >= 0.0 ? std::pow(failure, n) : 0.0);
}

double exact(double below, std::size_t units, double deviation, double failure) {
  double low = 0.0, high = 2.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (probability_below(middle, units, deviation, failure) < below ? low : high) = middle;
  }
  return high;
}

/// How often, of 100 seeds, each level's bounds enclose the exact value.
std::array<int, kLevels> enclosed(std::size_t units, double deviation, double failure) {
  const Quantity quantity = equal_units(units, deviation, failure);
  std::array<double, kLevels> expected{};
  for (std::size_t k = 0; k < kLevels; ++k) expected[k] = exact(kBelow[k], units, deviation, failure);
  std::array<int, kLevels> count{};
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Effort effort;
    effort.seed = seed;
    effort.samples = 2000;
    effort.threads = 2;
    const Quantiles found = quantiles(quantity, 0, effort);
    for (std::size_t k = 0; k < kLevels; ++k) count[k] += found[k].low <= expected[k] && expected[k] <= found[k].high;
  }
  return count;
}

// 95 of 100, at each level and over all: a binomial count of 100 is below 86 or a sum of 1000 outside 925 to 975 less
// than once in two thousand times. Bounds that are too wide fail too.
void expect_95_of_100(const std::array<int, kLevels>& count) {
  int sum = 0;
  for (std::size_t k = 0; k < kLevels; ++k) {
    EXPECT_GE(count[k], 86) << k;
    sum += count[k];
  }
  EXPECT_GE(sum, 925);
  EXPECT_LE(sum, 975);
}

TEST(Quantiles, bounds_enclose_the_exact_value_in_95_of_100_seeds) { expect_95_of_100(enclosed(8, 0.06, 0.0)); }

TEST(Quantiles, bounds_enclose_the_exact_value_in_95_of_100_seeds_where_units_fail) {
  expect_95_of_100(enclosed(10, 0.05, 0.01));
}

TEST(Quantiles, of_normal_units_are_those_of_the_normal_distribution) {
  Effort effort;
  effort.threads = 2;
  const Quantiles found = quantiles(equal_units(32, 0.113137085, 0.0), 0, effort);
  // The deviation is 0.02; deviations of a normal variable at 0.5, 0.1, ... 1e-9.
  const double z[] = {0.0, 1.28155, 2.32635, 3.09023, 3.71902, 4.26489, 4.75342, 5.19934, 5.61200, 5.99781};
  for (std::size_t k = 0; k < kLevels; ++k) {
    EXPECT_NEAR(found[k].value, 1.0 - 0.02 * z[k], 5e-4) << k;
    EXPECT_LT(found[k].high - found[k].low, 1.2e-3) << k;
  }
}

// Units without any other variation: the deceleration is the share of those that work, the quantile a step.
TEST(Quantiles, of_units_that_only_fail_are_exact) {
  Quantity quantity = equal_units(20, 0.05, 0.002);
  quantity.groups.front().first = Distribution(1.0);
  Effort effort;
  effort.samples = 4000;
  const Quantiles found = quantiles(quantity, 0, effort);
  double ways = 1.0, at_least = 1.0;
  std::size_t failed = 0;  // the most units of which more fail with less than the probability of the level
  for (std::size_t k = 0; k < kLevels; ++k) {
    for (;; ++failed) {
      const auto f = static_cast<double>(failed);
      const double more = at_least - ways * std::pow(0.002, f) * std::pow(0.998, 20.0 - f);
      if (more < kBelow[k] * (1.0 - kLevels * 1e-4)) break;
      at_least = more;
      ways *= (20.0 - f) / (f + 1.0);
    }
    EXPECT_NEAR(found[k].value, 1.0 - static_cast<double>(failed) / 20.0, 1e-9) << k;
  }
}

TEST(Quantiles, do_not_depend_on_the_number_of_threads) {
  const Quantity quantity = equal_units(12, 0.05, 0.01);
  std::array<Quantiles, 3> found;
  for (unsigned threads = 1; threads <= 3; ++threads) {
    Effort effort;
    effort.samples = 3000;
    effort.threads = threads;
    found[threads - 1] = quantiles(quantity, 4, effort);
  }
  for (std::size_t k = 0; k < kLevels; ++k)
    for (const Quantiles& other : found) {
      EXPECT_EQ(found[0][k].value, other[k].value);
      EXPECT_EQ(found[0][k].low, other[k].low);
      EXPECT_EQ(found[0][k].high, other[k].high);
    }
}

TEST(Quantiles, nothing_below_the_first_sample_is_known) {
  std::vector<Weighted> samples{{0.9, 1.0, 0}, {0.8, 1.0, 0}, {1.0, 1.0, 0}};
  const std::size_t sizes[] = {3};
  EXPECT_EQ(weighted_quantile(samples, sizes, 0.0, 0.1, -1.0).low, -1.0);
  EXPECT_EQ(weighted_quantile(samples, sizes, 0.0, 0.5, -1.0).value, 0.9);
  // What has no samples counts as below.
  EXPECT_EQ(weighted_quantile(samples, sizes, 0.2, 0.5, -1.0).value, 0.8);
}

Spec shipped(const char* name) {
  const std::string file = evc::test::source_folder() + "/examples/brakes/" + name;
  auto spec = read_spec(text_of(file), file);
  EXPECT_TRUE(spec) << spec.error().text();
  return *spec;
}

// All samples of a constant are the same: its bounds are the value, as no other one can be.
TEST(Quantiles, of_a_constant_are_known) {
  Quantity quantity = equal_units(8, 0.1, 0.0);
  quantity.groups[0].first = Distribution(0.9);
  quantity.groups[0].first_mean = 0.9;
  for (const Quantile& q : quantiles(quantity, 0, {1, 1000, 1, [](double) {}})) {
    EXPECT_NEAR(q.low, 0.9, 1e-9);
    EXPECT_NEAR(q.high, 0.9, 1e-9);
  }
  quantity.kind = Quantity::Kind::build_up_time;
  quantity.groups[0].first = Distribution(1.5);
  for (const Quantile& q : quantiles(quantity, 0, {1, 1000, 1, [](double) {}})) EXPECT_NEAR(q.low, -1.5, 1e-9);
}

// Everything together: all kinds of distributions, unequal units that fail, a common factor, products of factors.
TEST(Guaranteed, a_plain_run_agrees) {
  for (const char* name : {"locomotive_and_wagons.json", "high_speed_set.json"}) {
    Spec spec = shipped(name);
    spec.samples = 4000;
    spec.speeds_kmh.resize(2);
    const Guaranteed result = guaranteed(spec, 2, 100000, [](double) {});
    int compared = 0, in_common = 0;
    ASSERT_TRUE(result.plain);
    for (std::size_t s = 0; s < result.steps.size(); ++s)
      for (std::size_t k = 0; k < kLevels; ++k) {
        const auto& step = result.steps[s];
        const auto& plain = result.plain->steps[s][k];
        ASSERT_EQ(plain.has_value(), k <= 4) << k;  // 100 000 samples have ten below 1e-4
        if (!plain) continue;
        ++compared;
        in_common += plain->low <= step.Kdry_rst[k].high && step.Kdry_rst[k].low <= plain->high ? 1 : 0;
        EXPECT_NEAR(plain->value, step.Kdry_rst[k].value, k < 3 ? 0.002 : 0.01) << name << ' ' << k;
      }
    // One train has a value in both steps: they miss together.
    EXPECT_GE(in_common, compared - 2) << name;
  }
}

// Brakes better than nominal, up to 5 times: no value is cut.
TEST(PlainRun, large_values_are_counted) {
  Spec spec = shipped("normal_units.json");
  spec.all_units = Distribution(5.0);
  const PlainRun run = plain_run(spec, 100000, {1, 1000, 2, {}});
  ASSERT_TRUE(run.steps[0][0] && run.steps[0][2]);
  EXPECT_NEAR(run.steps[0][0]->value, 5.0, 0.002);
  EXPECT_NEAR(run.steps[0][2]->value, 5.0 * (1.0 - 0.02 * 2.32635), 0.005);
  EXPECT_LT(run.resolution, 5e-5);
  EXPECT_GT(run.steps[0][0]->high, run.steps[0][0]->low);
}

// Small ones as finely as large ones.
TEST(PlainRun, small_values_have_their_digits) {
  Spec spec = shipped("normal_units.json");
  spec.all_units = Distribution(1e-4);
  const PlainRun run = plain_run(spec, 20000, {1, 1000, 2, {}});
  EXPECT_LT(run.resolution, 1e-9);
  EXPECT_NEAR(run.steps[0][0]->value, 1e-4, 1e-7);
}

// The first samples end the cells: their number may be that of all samples, or less than one.
TEST(PlainRun, few_samples_are_all_in_cells) {
  const Spec spec = shipped("normal_units.json");
  for (const std::uint64_t samples : {std::uint64_t{1}, std::uint64_t{20}, std::uint64_t{4096}, std::uint64_t{4097}}) {
    const PlainRun run = plain_run(spec, samples, {1, 1000, 2, {}});
    EXPECT_EQ(run.steps[0][0].has_value(), samples >= 20) << samples;
    if (samples >= 20) {
      EXPECT_NEAR(run.steps[0][0]->value, 1.0, 0.02) << samples;
    }
  }
}

TEST(Guaranteed, factors_fall_and_times_rise_with_the_level) {
  Spec spec = shipped("locomotive_and_wagons.json");
  spec.samples = 2000;
  const Guaranteed result = guaranteed(spec, 2, 0, [](double) {});
  double mean = 0.0, units = 0.0;
  for (const auto& group : spec.groups) {
    const double weight = static_cast<double>(group.units) * at_speed(group.nominal, 0.0);
    mean += weight * group.response_s->mean();
    units += weight;
  }
  EXPECT_NEAR((*result.steps[0].build_up_s)[0].value, mean / units, 0.02);
  for (const auto& step : result.steps)
    for (std::size_t k = 1; k < kLevels; ++k) {
      EXPECT_LT(step.Kdry_rst[k].value, step.Kdry_rst[k - 1].value);
      EXPECT_GT((*step.build_up_s)[k].value, (*step.build_up_s)[k - 1].value);
      EXPECT_LE((*step.build_up_s)[k].high, *result.build_up_at(k));
    }
}

// The mark: 0.002 at 1e-9.
TEST(Guaranteed, of_the_400_m_set_the_last_level_is_known_to_2_thousandths) {
  Spec spec = shipped("high_speed_set.json");
  EXPECT_EQ(spec.units(), 64U);
  EXPECT_EQ(spec.speeds_kmh.size(), 8U);
  spec.samples = 2000;  // a tenth of what it has: the error is wider
  EXPECT_LT(guaranteed(spec, 2, 0, [](double) {}).error_at(9), 0.002);
}

}  // namespace
}  // namespace evc::deceleration
