#include "deceleration/bands.h"

#include <gtest/gtest.h>

#include <random>

namespace evc::deceleration {
namespace {

std::vector<Step> random_steps(std::mt19937& engine) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Step> steps(1 + engine() % 20);
  double from = 0.0;
  for (Step& step : steps) {
    step.from_kmh = from;
    from += 5.0 + 40.0 * share(engine);
    step.A_brake_emergency = 0.2 + 1.2 * share(engine);
    double factor = 1.1;
    for (double& k : step.Kdry_rst) k = factor *= 0.8 + 0.2 * share(engine);
  }
  return steps;
}

const Step& at(const std::vector<Step>& steps, double kmh) {
  std::size_t s = 0;
  while (s + 1 < steps.size() && steps[s + 1].from_kmh <= kmh) ++s;
  return steps[s];
}

TEST(Bands, promise_nowhere_more_than_the_steps) {
  std::mt19937 engine(4);
  for (int i = 0; i < 300; ++i) {
    const auto steps = random_steps(engine);
    const std::size_t most = 1 + engine() % 7;
    const auto joint = joined(steps, most, 400.0);
    ASSERT_LE(joint.size(), most);
    ASSERT_EQ(joint.front().from_kmh, 0.0);
    for (const Step& step : steps) {
      const Step& promised = at(joint, step.from_kmh);
      EXPECT_LE(promised.A_brake_emergency, step.A_brake_emergency);
      for (std::size_t k = 0; k < kLevels; ++k) {
        EXPECT_LE(promised.Kdry_rst[k], 1.0);
        EXPECT_LE(promised.A_brake_emergency * promised.Kdry_rst[k], step.A_brake_emergency * step.Kdry_rst[k] + 1e-12);
      }
    }
  }
}

TEST(Bands, few_steps_stay_as_they_are) {
  std::vector<Step> steps(3);
  for (std::size_t s = 0; s < steps.size(); ++s) {
    steps[s].from_kmh = 50.0 * static_cast<double>(s);
    steps[s].A_brake_emergency = 1.2 - 0.1 * static_cast<double>(s);
    steps[s].Kdry_rst.fill(0.9);
  }
  const auto joint = joined(steps, 7, 160.0);
  ASSERT_EQ(joint.size(), 3U);
  for (std::size_t s = 0; s < steps.size(); ++s) {
    EXPECT_EQ(joint[s].from_kmh, steps[s].from_kmh);
    EXPECT_NEAR(joint[s].A_brake_emergency, steps[s].A_brake_emergency, 1e-9);
    EXPECT_NEAR(joint[s].Kdry_rst[9], 0.9, 1e-9);
  }
}

// Of eight steps two must become one: those whose difference costs least.
TEST(Bands, neighbours_that_differ_least_are_joined) {
  std::vector<Step> steps(8);
  for (std::size_t s = 0; s < steps.size(); ++s) {
    steps[s].from_kmh = 20.0 * static_cast<double>(s);
    steps[s].A_brake_emergency = 1.2 - 0.05 * static_cast<double>(s);
    steps[s].Kdry_rst.fill(0.9);
  }
  steps[5].A_brake_emergency = steps[4].A_brake_emergency - 0.01;
  const auto joint = joined(steps, 7, 160.0);
  ASSERT_EQ(joint.size(), 7U);
  EXPECT_EQ(joint[4].from_kmh, 80.0);
  EXPECT_EQ(joint[5].from_kmh, 120.0);
  EXPECT_NEAR(joint[4].A_brake_emergency, 0.99, 1e-9);
}

}  // namespace
}  // namespace evc::deceleration
