#include "deceleration/plain_run.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "curves/parallel.h"
#include "deceleration/draws.h"

namespace evc::deceleration {
namespace {

constexpr std::size_t kBins = 200000;
constexpr double kBinsPerOne = 100000.0;
/// Unlike the purpose of any sample of `quantiles`.
constexpr std::uint32_t kPurpose = 0xFFFFFFFF;
constexpr std::uint64_t kSamples_of_block = 1 << 16;

/// How many values are in each bin, for each step of speed.
using Counts = std::vector<std::vector<std::uint64_t>>;

struct Group {
  std::size_t units;
  double failure;
  Tilted friction, pressure;
};

/// Trains drawn by the units' distributions.
class Trains {
 public:
  explicit Trains(const Spec& spec) : common_(spec.all_units.tilted(0.0)), units_(spec.units()) {
    for (const UnitGroup& g : spec.groups)
      groups_.push_back({g.units, g.failure, g.friction.tilted(0.0), g.pressure.tilted(0.0)});
    for (const double from : spec.speeds_kmh) {
      const Quantity quantity = deceleration_of(spec, from);
      weights_.emplace_back();
      for (const auto& group : quantity.groups) weights_.back().push_back(group.weight);
    }
  }

  void draw(const Source& source, std::vector<double>& sums, Counts& counts) const {
    const auto first = static_cast<std::uint32_t>(units_);
    const double common = common_.at(source.shares(first)[0]);
    sums.assign(groups_.size(), 0.0);
    std::uint32_t unit = 0;
    std::array<std::uint32_t, 4> words{};
    for (std::size_t g = 0; g < groups_.size(); ++g)
      for (std::size_t u = 0; u < groups_[g].units; ++u, ++unit) {
        if (unit % 4 == 0) words = source.words(first + 1 + unit / 4);
        if ((static_cast<double>(words[unit % 4]) + 0.5) / 4294967296.0 < groups_[g].failure) continue;
        const auto shares = source.shares(unit);
        sums[g] += groups_[g].friction.at(shares[0]) * groups_[g].pressure.at(shares[1]);
      }
    for (std::size_t s = 0; s < weights_.size(); ++s) {
      double value = 0.0;
      for (std::size_t g = 0; g < sums.size(); ++g) value += weights_[s][g] * sums[g];
      const double bin = std::clamp(common * value * kBinsPerOne, 0.0, static_cast<double>(kBins - 1));
      ++counts[s][static_cast<std::size_t>(bin)];
    }
  }
  std::size_t steps() const { return weights_.size(); }

 private:
  Tilted common_;
  std::size_t units_;
  std::vector<Group> groups_;
  std::vector<std::vector<double>> weights_;
};

/// The lower edge of the bin in which the value of this rank is, from 1.
double value_of_rank(const std::vector<std::uint64_t>& counts, double rank) {
  double sum = 0.0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    sum += static_cast<double>(counts[bin]);
    if (sum >= rank) return static_cast<double>(bin) / kBinsPerOne;
  }
  return static_cast<double>(kBins) / kBinsPerOne;
}

PlainQuantiles quantiles_of(const std::vector<std::uint64_t>& counts, std::uint64_t samples) {
  PlainQuantiles found;
  const auto n = static_cast<double>(samples);
  for (std::size_t k = 0; k < kLevels; ++k) {
    const double rank = n * kBelow[k];
    if (rank < kFewestBelow) continue;
    const double error = kNormal95 * std::sqrt(rank * (1.0 - kBelow[k]));
    constexpr double kBin = 1.0 / kBinsPerOne;
    found[k] = Quantile{value_of_rank(counts, rank) + 0.5 * kBin, value_of_rank(counts, std::max(rank - error, 1.0)),
                        value_of_rank(counts, std::min(rank + error + 1.0, n)) + kBin};
  }
  return found;
}

}  // namespace

std::vector<PlainQuantiles> plain_run(const Spec& spec, std::uint64_t samples, const Effort& effort) {
  const Trains trains(spec);
  // A block of a thread counts for itself; sums of whole numbers do not depend on the order.
  Counts all(trains.steps(), std::vector<std::uint64_t>(kBins, 0));
  std::mutex mutex;
  const std::uint64_t blocks = (samples + kSamples_of_block - 1) / kSamples_of_block;
  const std::uint64_t parts = std::min<std::uint64_t>(blocks, std::uint64_t{effort.threads} * 50);
  const auto job = [&](unsigned, std::size_t part) {
    Counts counts(trains.steps(), std::vector<std::uint64_t>(kBins, 0));
    std::vector<double> sums;
    for (std::uint64_t block = part; block < blocks; block += parts)
      for (std::uint64_t i = block * kSamples_of_block; i < std::min((block + 1) * kSamples_of_block, samples); ++i)
        trains.draw({effort.seed, kPurpose, static_cast<std::uint32_t>(i >> 32), static_cast<std::uint32_t>(i)}, sums,
                    counts);
    const std::lock_guard lock(mutex);
    for (std::size_t s = 0; s < all.size(); ++s)
      for (std::size_t bin = 0; bin < kBins; ++bin) all[s][bin] += counts[s][bin];
  };
  curves::in_threads(effort.threads, parts, job, effort.progress);
  std::vector<PlainQuantiles> found;
  for (const auto& counts : all) found.push_back(quantiles_of(counts, samples));
  return found;
}

}  // namespace evc::deceleration
