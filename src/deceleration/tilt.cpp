#include "deceleration/tilt.h"

#include <cmath>
#include <limits>

namespace evc::deceleration {
namespace {

/// log E(exp(-theta L)) of a unit that works.
double log_working(const Quantity::Group& g, double theta) {
  double sum = -theta * g.base;
  for (const auto& [variable, mean, slope] :
       {std::tuple(&g.first, g.first_mean, g.first_slope), std::tuple(&g.second, g.second_mean, g.second_slope)})
    sum += variable->log_transform(theta * slope) + theta * slope * mean;
  return sum;
}

double log_common(const Quantity& quantity, double theta, double slope) {
  return quantity.common.log_transform(theta * slope) + theta * slope * quantity.common_mean;
}

/// The common factor counts for the units that work.
double common_slope_of(const Quantity& quantity, std::size_t failed) {
  const auto units = static_cast<double>(quantity.units());
  return quantity.common_slope * (units - static_cast<double>(failed)) / units;
}

struct Terms {
  std::vector<double> fails, works;
  double log_scale = 0.0;  // the terms of the units that work are divided by exp of this
};
Terms terms_of(const Quantity& quantity, double theta) {
  std::vector<double> logs;
  Terms terms;
  for (const auto& group : quantity.groups) {
    logs.push_back(log_working(group, theta));
    terms.log_scale += logs.back() * static_cast<double>(group.units) / static_cast<double>(quantity.units());
  }
  for (std::size_t g = 0; g < logs.size(); ++g) {
    const auto& group = quantity.groups[g];
    terms.fails.insert(terms.fails.end(), group.units, group.failure);
    terms.works.insert(terms.works.end(), group.units, (1.0 - group.failure) * std::exp(logs[g] - terms.log_scale));
  }
  return terms;
}

}  // namespace

Tilt::Tilt(const Quantity& quantity, std::size_t failed, double theta)
    : quantity_(quantity), theta_(theta), common_slope_(common_slope_of(quantity, failed)) {
  const Terms terms = terms_of(quantity, theta);
  log_transform_ =
      log_common(quantity, theta, common_slope_) + static_cast<double>(quantity.units() - failed) * terms.log_scale;
  if (!std::isfinite(log_transform_)) return;
  failed_.emplace_back(terms.fails, terms.works, failed);
  log_transform_ += std::log(failed_.front().sum());
  if (!std::isfinite(log_transform_)) return;
  for (const auto& g : quantity.groups)
    groups_.push_back({g.first.tilted(theta * g.first_slope), g.second.tilted(theta * g.second_slope)});
  common_.push_back(quantity.common.tilted(theta * common_slope_));
}

Drawn Tilt::draw(const Source& source, Flags& flags) const {
  const std::size_t units = quantity_.units();
  flags.resize(units);
  const auto first_place = static_cast<std::uint32_t>(units);
  failed_.front().draw(source, first_place + 1, flags);
  const bool deceleration = quantity_.kind == Quantity::Kind::deceleration;
  double sum = 0.0, working = 0.0, all = 0.0, linear = 0.0;
  std::size_t unit = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Quantity::Group& group = quantity_.groups[g];
    for (const std::size_t end = unit + group.units; unit < end; ++unit) {
      if (flags[unit] != 0 && deceleration) continue;
      const auto shares = source.shares(static_cast<std::uint32_t>(unit));
      const double first = groups_[g].first.at(shares[0]);
      const double second = groups_[g].second.at(shares[1]);
      const double part = group.weight * first * second;
      all += part;
      if (flags[unit] != 0) continue;
      sum += part;
      working += group.weight;
      linear += group.base + group.first_slope * (first - group.first_mean) +
                group.second_slope * (second - group.second_mean);
    }
  }
  const double common = common_.front().at(source.shares(first_place)[0]);
  linear += common_slope_ * (common - quantity_.common_mean);
  const double weight = std::exp(theta_ * linear + log_transform_);
  if (deceleration) return {common * sum, weight};
  // Without any working unit there is no force: its time is that of the units as if they worked.
  return {working > 0.0 ? -sum / working : -all, weight};
}

Tilts::Tilts(const Quantity& quantity, std::size_t strata) : log_transforms_(strata) {
  constexpr double kLeast = 1e-3, kMost = 1e9, kStepsOfOctave = 6.0;
  const double step = std::exp2(1.0 / kStepsOfOctave);
  const auto units = static_cast<double>(quantity.units());
  bool any = strata > 0;
  for (double theta = 0.0; any && theta < kMost; theta = theta == 0.0 ? kLeast : theta * step) {
    const Terms terms = terms_of(quantity, theta);
    const std::vector<double> sums = sums_by_failed(terms.fails, terms.works, strata - 1);
    any = false;
    for (std::size_t n = 0; n < strata; ++n) {
      if (log_transforms_[n].size() != thetas_.size()) continue;  // it has ended
      const double log_transform = log_common(quantity, theta, common_slope_of(quantity, n)) +
                                   (units - static_cast<double>(n)) * terms.log_scale + std::log(sums[n]);
      if (!std::isfinite(log_transform)) continue;
      log_transforms_[n].push_back(log_transform);
      any = true;
    }
    thetas_.push_back(theta);
  }
}

double Tilts::theta_for(std::size_t failed, double target) const {
  const std::vector<double>& logs = log_transforms_[failed];
  // Convex in theta; its derivative is the target less the mean of L.
  const auto height = [&](std::size_t i) { return logs[i] + thetas_[i] * target; };
  std::size_t i = 0;
  while (i + 1 < logs.size() && height(i + 1) < height(i)) ++i;
  if (i == 0 || i + 1 == logs.size()) return i == 0 ? 0.0 : thetas_[i];
  // The vertex of the parabola through the lowest and its neighbours: between these, as it is convex.
  const double left = (height(i) - height(i - 1)) / (thetas_[i] - thetas_[i - 1]);
  const double right = (height(i + 1) - height(i)) / (thetas_[i + 1] - thetas_[i]);
  const double from = 0.5 * (thetas_[i - 1] + thetas_[i]), to = 0.5 * (thetas_[i] + thetas_[i + 1]);
  return right > left ? from + (to - from) * -left / (right - left) : thetas_[i];
}

double log_transform(const Quantity& quantity, double theta) {
  double sum = log_common(quantity, theta, quantity.common_slope);
  for (const auto& group : quantity.groups) {
    const double works = log_working(group, theta) + std::log1p(-group.failure);
    if (!std::isfinite(works)) return std::numeric_limits<double>::infinity();
    const double fails = group.failure > 0.0 ? std::log(group.failure) : -std::numeric_limits<double>::infinity();
    const double largest = std::max(works, fails);
    sum +=
        static_cast<double>(group.units) * (largest + std::log(std::exp(works - largest) + std::exp(fails - largest)));
  }
  return sum;
}

}  // namespace evc::deceleration
