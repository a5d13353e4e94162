#include "deceleration/quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "curves/parallel.h"
#include "deceleration/tilt.h"

namespace evc::deceleration {
namespace {

/// Strata so unlikely, compared with the probability that is looked for, get no samples.
constexpr double kLeftOut = 1e-6;
constexpr std::size_t kFewestSamples = 32;
/// Of the search for the place: samples as a share of those of the estimate, and rounds.
constexpr std::size_t kPilotShare = 16;
constexpr std::uint32_t kMostRounds = 14;
/// The number of the round that estimates.
constexpr std::uint32_t kLastRound = 15;
constexpr std::size_t kBlock = 512;

/// The samples of one level of confidence.
struct Level {
  double below = 0.5;
  std::uint32_t purpose = 0;  // of its draws
  double left_out = 0.0;
  std::vector<Tilt> tilts;         // of strata 0, 1, ... failed units
  std::vector<char> tilted;        // whether the tilt of a stratum is one
  std::vector<std::size_t> sizes;  // how many samples of each
  std::vector<Weighted> samples;
};

/// The mean of L under the tilt of all strata together that brings the bound of Chernoff down to this probability: a
/// place not far from the quantile.
double first_guess(const Quantity& quantity, double below) {
  const auto mean = [&](double theta) {
    const double step = 1e-4 * (1.0 + theta);
    return -(log_transform(quantity, theta + step) - log_transform(quantity, std::max(theta - step, 0.0))) /
           (theta > step ? 2.0 * step : theta + step);
  };
  const auto bound = [&](double theta) { return log_transform(quantity, theta) + theta * mean(theta); };
  double low = 0.0, high = 1.0;
  // A median needs no tilt; the bound is above the tail by an order of magnitude.
  const double wanted = below >= 0.5 ? 0.0 : std::log(below);
  for (int i = 0; i < 40; ++i) {
    const double at = bound(high);
    if (!(std::isfinite(at) && at > wanted)) break;
    low = high;
    high *= 2.0;
  }
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    const double at = bound(middle);
    (std::isfinite(at) && at > wanted ? low : high) = middle;
  }
  return mean(low);
}

/// How many strata, from that without a failure on, get samples, and the probability of the others.
std::pair<std::size_t, double> strata_with_samples(const std::vector<double>& strata, double below) {
  std::size_t count = strata.size();
  double left_out = 0.0;
  while (count > 1 && left_out + strata[count - 1] <= kLeftOut * below) left_out += strata[--count];
  return {count, left_out};
}

/// Tilts towards `target`, and the samples where the most of the probability is.
Level level_of(const Quantity& quantity, const Tilts& tilts, const std::vector<double>& strata, double below,
               double target, std::size_t samples) {
  Level level;
  level.below = below;
  std::size_t count = 0;
  std::tie(count, level.left_out) = strata_with_samples(strata, below);
  std::vector<double> parts;
  double all = 0.0;
  for (std::size_t n = 0; n < count; ++n) {
    const double theta = tilts.theta_for(n, target);
    level.tilts.emplace_back(quantity, n, theta);
    level.tilted.push_back(theta > 0.0 ? 1 : 0);
    parts.push_back(std::min(strata[n], std::exp(level.tilts.back().log_transform() + theta * target)));
    all += parts.back();
  }
  const std::size_t fewest = std::max(kFewestSamples, samples / (8 * count));
  for (const double part : parts) {
    const double share = all > 0.0 ? part / all : 1.0 / static_cast<double>(count);
    level.sizes.push_back(fewest + static_cast<std::size_t>(share * static_cast<double>(samples)));
  }
  for (std::size_t n = 0; n < count; ++n)
    level.samples.insert(level.samples.end(), level.sizes[n], {0.0, 0.0, static_cast<std::uint32_t>(n)});
  return level;
}

/// Draws the samples of all levels.
void draw(std::vector<Level>& levels, const Effort& effort, const std::function<void(double)>& progress) {
  struct Block {
    std::size_t level, first, end, begin_of_stratum;
  };
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < levels.size(); ++k)
    for (std::size_t n = 0, begin = 0; n < levels[k].sizes.size(); begin += levels[k].sizes[n++])
      for (std::size_t first = 0; first < levels[k].sizes[n]; first += kBlock)
        blocks.push_back({k, begin + first, begin + std::min(first + kBlock, levels[k].sizes[n]), begin});
  const auto job = [&](unsigned, std::size_t i) {
    const Block& block = blocks[i];
    Level& level = levels[block.level];
    Tilt::Flags flags;
    for (std::size_t s = block.first; s < block.end; ++s) {
      Weighted& sample = level.samples[s];
      const Source source{effort.seed, level.purpose, sample.stratum,
                          static_cast<std::uint32_t>(s - block.begin_of_stratum)};
      const Drawn drawn = level.tilts[sample.stratum].draw(source, flags);
      sample.value = drawn.value;
      sample.weight = drawn.weight;
    }
  };
  curves::in_threads(effort.threads, blocks.size(), job, progress);
}

/// Sums of the weights of one stratum.
struct Sums {
  double first = 0.0, second = 0.0;
  double variance(std::size_t size) const {
    const auto n = static_cast<double>(size);
    const double mean = first / n;
    return std::max(0.0, second / n - mean * mean) / (n - 1.0);
  }
};

/// The smallest standard deviation of the samples within a stratum that is tilted; infinite where none is.
double spread_of(const Level& level) {
  double spread = std::numeric_limits<double>::infinity();
  std::size_t begin = 0;
  for (std::size_t n = 0; n < level.sizes.size(); begin += level.sizes[n++]) {
    if (level.tilted[n] == 0) continue;
    const auto size = static_cast<double>(level.sizes[n]);
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = begin; i < begin + level.sizes[n]; ++i) sum += level.samples[i].value;
    for (std::size_t i = begin; i < begin + level.sizes[n]; ++i)
      squares += (level.samples[i].value - sum / size) * (level.samples[i].value - sum / size);
    spread = std::min(spread, std::sqrt(squares / size));
  }
  return spread;
}

/// A value that the quantity is never below: 0 or, of a time, minus infinity where variables have no bound.
double least_of(const Quantity& quantity) {
  if (quantity.kind == Quantity::Kind::build_up_time) {
    double longest = 0.0;
    for (const auto& group : quantity.groups) longest = std::max(longest, group.first.range().second);
    return -longest;
  }
  double sum = 0.0;  // of the units that cannot fail
  for (const auto& group : quantity.groups) {
    const double first = group.first.range().first, second = group.second.range().first;
    if (!(first > 0.0 && second > 0.0)) return 0.0;
    if (group.failure == 0.0) sum += static_cast<double>(group.units) * group.weight * first * second;
  }
  return std::max(0.0, quantity.common.range().first) * sum;
}

std::vector<double> strata_of(const Quantity& quantity) {
  std::vector<double> failure;
  for (const auto& group : quantity.groups) failure.insert(failure.end(), group.units, group.failure);
  return probabilities_of_failures(failure);
}

/// The quantiles of one quantity: rounds that find their places, and one that estimates them. The samples of the
/// search are not used again: the bounds would be too narrow.
class Search {
 public:
  Search(const Quantity& quantity, std::uint32_t number, const Effort& effort)
      : quantity_(quantity),
        number_(number),
        effort_(effort),
        strata_(strata_of(quantity)),
        tilts_(quantity, strata_with_samples(strata_, kBelow.back()).first) {
    lowest_ = least_of(quantity);
    if (quantity.kind == Quantity::Kind::build_up_time) {
      // The linear form of a build-up time is without its mean.
      for (const auto& group : quantity.groups)
        offset_ += static_cast<double>(group.units) * group.weight * group.first_mean;
    }
  }

  Quantiles found() {
    constexpr double kPilot = 0.25;  // of the work, about
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < kLevels; ++k) {
      targets_[k] = first_guess(quantity_, kBelow[k]);
      open.push_back(k);
    }
    for (std::uint32_t round = 0; round < kMostRounds && !open.empty(); ++round) {
      improve(open, round);
      effort_.progress(kPilot * (1.0 - static_cast<double>(open.size()) / kLevels));
    }
    std::vector<std::size_t> all(kLevels);
    std::iota(all.begin(), all.end(), std::size_t{0});
    auto levels = sampled(all, kLastRound, effort_.samples,
                          [&](double share) { effort_.progress(kPilot + (1.0 - kPilot) * share); });
    Quantiles found;
    for (const std::size_t k : all) found[k] = quantile_of(levels[k]);
    // Of a place that was not found nothing is promised.
    for (const std::size_t k : open) found[k].low = lowest_;
    return found;
  }

 private:
  std::vector<Level> sampled(const std::vector<std::size_t>& which, std::uint32_t round, std::size_t samples,
                             const std::function<void(double)>& progress) const {
    std::vector<Level> levels;
    for (const std::size_t k : which) {
      levels.push_back(level_of(quantity_, tilts_, strata_, kBelow[k], targets_[k], samples));
      levels.back().purpose = (number_ * 16 + round) * 16 + static_cast<std::uint32_t>(k);
    }
    draw(levels, effort_, progress);
    return levels;
  }

  Quantile quantile_of(const Level& level) const {
    return weighted_quantile(level.samples, level.sizes, level.left_out, level.below, lowest_);
  }

  /// A round for the levels that are open: they get a better target, and are closed where it is as near to the one
  /// before as the samples lie together: then these reach to both sides of it.
  void improve(std::vector<std::size_t>& open, std::uint32_t round) {
    const auto levels = sampled(open, round, std::max<std::size_t>(effort_.samples / kPilotShare, 250), [](double) {});
    std::vector<std::size_t> still;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const double target = quantile_of(levels[i]).value + offset_;
      if (!(std::abs(target - targets_[open[i]]) <= 0.5 * spread_of(levels[i]))) still.push_back(open[i]);
      targets_[open[i]] = target;
    }
    open = still;
  }

  const Quantity& quantity_;
  std::uint32_t number_;
  const Effort& effort_;
  std::vector<double> strata_;
  Tilts tilts_;
  double lowest_ = 0.0, offset_ = 0.0;
  std::array<double, kLevels> targets_{};
};

}  // namespace

Quantile weighted_quantile(std::vector<Weighted> samples, std::span<const std::size_t> sizes, double left_out,
                           double below, double lowest) {
  std::sort(samples.begin(), samples.end(), [](const Weighted& a, const Weighted& b) {
    return a.value != b.value ? a.value < b.value : a.stratum < b.stratum;
  });
  std::vector<Sums> sums(sizes.size());
  Quantile found;
  bool low = false, value = false;
  double probability = left_out, variance = 0.0;
  found.low = lowest;
  found.value = found.high = samples.back().value;
  for (std::size_t i = 0; i < samples.size();) {
    const double at = samples[i].value;
    const bool first = i == 0;
    for (; i < samples.size() && samples[i].value == at; ++i) {
      const std::size_t n = samples[i].stratum;
      const double w = samples[i].weight;
      probability += w / static_cast<double>(sizes[n]);
      variance -= sums[n].variance(sizes[n]);
      sums[n].first += w;
      sums[n].second += w * w;
      variance += sums[n].variance(sizes[n]);
    }
    const double error = kNormal95 * std::sqrt(std::max(variance, 0.0));
    if (!low && probability + error >= below) {
      found.low = first ? std::min(lowest, at) : at;
      low = true;
    }
    // What has no samples counts as below in the low bound, as above in the high one.
    if (!value && probability >= below) {
      found.value = at;
      value = true;
    }
    if (probability - left_out - error >= below) {
      found.high = at;
      break;
    }
  }
  return found;
}

Quantiles quantiles(const Quantity& quantity, std::uint32_t number, const Effort& effort) {
  return Search(quantity, number, effort).found();
}

}  // namespace evc::deceleration
