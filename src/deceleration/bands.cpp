#include "deceleration/bands.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evc::deceleration {
namespace {

/// To thousandths; a decimal that is only a rounding error away stays.
double rounded_down(double value) { return std::floor(value * 1000.0 + 1e-9) / 1000.0; }

/// The step that takes the place of these.
Step step_for(std::span<const Step> steps) {
  Step joint = steps.front();
  std::array<double, kLevels> product{};
  product.fill(std::numeric_limits<double>::infinity());
  for (const Step& step : steps) {
    joint.A_brake_emergency = std::min(joint.A_brake_emergency, step.A_brake_emergency);
    for (std::size_t k = 0; k < kLevels; ++k)
      product[k] = std::min(product[k], step.A_brake_emergency * std::max(step.Kdry_rst[k], 0.0));
  }
  joint.A_brake_emergency = rounded_down(joint.A_brake_emergency);
  for (std::size_t k = 0; k < kLevels; ++k)
    joint.Kdry_rst[k] =
        joint.A_brake_emergency > 0.0 ? rounded_down(std::min(1.0, product[k] / joint.A_brake_emergency)) : 0.0;
  return joint;
}

/// What the joint step gives away, by speed and level, as shares.
double loss_of(std::span<const Step> steps, std::span<const double> widths) {
  const Step joint = step_for(steps);
  double loss = 0.0;
  for (std::size_t s = 0; s < steps.size(); ++s)
    for (std::size_t k = 0; k < kLevels; ++k) {
      const double product = steps[s].A_brake_emergency * steps[s].Kdry_rst[k];
      if (product > 0.0) loss += widths[s] * (1.0 - joint.A_brake_emergency * joint.Kdry_rst[k] / product);
    }
  return loss;
}

}  // namespace

std::vector<Step> joined(std::span<const Step> steps, std::size_t most, double top_kmh) {
  const std::size_t n = steps.size();
  std::vector<double> widths;
  for (std::size_t s = 0; s < n; ++s)
    widths.push_back(std::max(1.0, (s + 1 < n ? steps[s + 1].from_kmh : top_kmh) - steps[s].from_kmh));
  // least[b][e]: the least loss of the first e steps in b joint ones; begin[b][e]: where the last of these begins.
  constexpr double kImpossible = std::numeric_limits<double>::infinity();
  const std::size_t bands = std::min(most, n);
  std::vector<std::vector<double>> least(bands + 1, std::vector<double>(n + 1, kImpossible));
  std::vector<std::vector<std::size_t>> begin(bands + 1, std::vector<std::size_t>(n + 1, 0));
  least[0][0] = 0.0;
  for (std::size_t first = 0; first < n; ++first)
    for (std::size_t end = first + 1; end <= n; ++end) {
      const double loss = loss_of(steps.subspan(first, end - first), std::span(widths).subspan(first, end - first));
      for (std::size_t b = 1; b <= bands; ++b)
        if (least[b - 1][first] + loss < least[b][end]) {
          least[b][end] = least[b - 1][first] + loss;
          begin[b][end] = first;
        }
    }
  std::size_t best = 1;
  for (std::size_t b = 2; b <= bands; ++b)
    if (least[b][n] < least[best][n]) best = b;
  std::vector<Step> result;
  for (std::size_t end = n, b = best; b > 0; end = begin[b--][end])
    result.push_back(step_for(steps.subspan(begin[b][end], end - begin[b][end])));
  std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace evc::deceleration
