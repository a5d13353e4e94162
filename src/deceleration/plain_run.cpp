#include "deceleration/plain_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>

#include "curves/parallel.h"
#include "deceleration/draws.h"

namespace evc::deceleration {
namespace {

constexpr std::size_t kCells = 200000;
/// The first samples, of which the largest ends the cells.
constexpr std::uint64_t kFirst = 4096;
/// Unlike the purpose of any sample of `quantiles`.
constexpr std::uint32_t kPurpose = 0xFFFFFFFF;
constexpr std::uint64_t kSamplesOfBlock = 1 << 16;

/// How many values of one step of speed are in each cell. All threads count in it: sums of whole numbers do not depend
/// on the order.
class Histogram {
 public:
  explicit Histogram(double end) : width_(end / static_cast<double>(kCells)), counts_(kCells) {}
  void count(double value) {
    const double cell = std::clamp(value / width_, 0.0, static_cast<double>(kCells - 1));
    counts_[static_cast<std::size_t>(cell)].fetch_add(1, std::memory_order_relaxed);
  }
  double width() const { return width_; }
  /// The lower edge of the cell in which the value of this rank is, from 1.
  double value_of_rank(double rank) const {
    double sum = 0.0;
    std::size_t cell = 0;
    for (; cell + 1 < kCells; ++cell) {
      sum += static_cast<double>(counts_[cell].load(std::memory_order_relaxed));
      if (sum >= rank) break;
    }
    return static_cast<double>(cell) * width_;
  }

 private:
  double width_;
  std::vector<std::atomic<std::uint64_t>> counts_;
};

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

  /// The values of one train, by steps of speed. `sums` is room of the caller.
  void draw(const Source& source, std::vector<double>& sums, std::vector<double>& values) const {
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
    values.resize(weights_.size());
    for (std::size_t s = 0; s < weights_.size(); ++s) {
      double value = 0.0;
      for (std::size_t g = 0; g < sums.size(); ++g) value += weights_[s][g] * sums[g];
      values[s] = common * value;
    }
  }
  std::size_t steps() const { return weights_.size(); }

 private:
  Tilted common_;
  std::size_t units_;
  std::vector<Group> groups_;
  std::vector<std::vector<double>> weights_;
};

Source source_of(std::uint64_t sample, std::uint64_t seed) {
  return {seed, kPurpose, static_cast<std::uint32_t>(sample >> 32), static_cast<std::uint32_t>(sample)};
}

/// Empty cells for each step of speed, as wide as the first samples ask for.
std::vector<Histogram> cells_for(const Trains& trains, std::uint64_t samples, std::uint64_t seed) {
  std::vector<double> ends(trains.steps(), 0.0), sums, values;
  for (std::uint64_t i = 0; i < std::min(samples, kFirst); ++i) {
    trains.draw(source_of(i, seed), sums, values);
    for (std::size_t s = 0; s < ends.size(); ++s) ends[s] = std::max(ends[s], values[s]);
  }
  std::vector<Histogram> cells;
  cells.reserve(ends.size());
  for (const double end : ends) cells.emplace_back(end > 0.0 ? end : 1.0);  // 0: in no sample a unit works
  return cells;
}

PlainQuantiles quantiles_of(const Histogram& cells, std::uint64_t samples) {
  PlainQuantiles found;
  const auto n = static_cast<double>(samples);
  for (std::size_t k = 0; k < kLevels; ++k) {
    const double rank = n * kBelow[k];
    if (rank < kFewestBelow) continue;
    const double error = kNormal95 * std::sqrt(rank * (1.0 - kBelow[k]));
    found[k] =
        Quantile{cells.value_of_rank(rank) + 0.5 * cells.width(), cells.value_of_rank(std::max(rank - error, 1.0)),
                 cells.value_of_rank(std::min(rank + error + 1.0, n)) + cells.width()};
  }
  return found;
}

}  // namespace

PlainRun plain_run(const Spec& spec, std::uint64_t samples, const Effort& effort) {
  const auto begin = std::chrono::steady_clock::now();
  const Trains trains(spec);
  std::vector<Histogram> cells = cells_for(trains, samples, effort.seed);
  const auto job = [&](unsigned, std::size_t block) {
    std::vector<double> sums, values;
    const std::uint64_t first = block * kSamplesOfBlock;
    for (std::uint64_t i = first; i < std::min(first + kSamplesOfBlock, samples); ++i) {
      trains.draw(source_of(i, effort.seed), sums, values);
      for (std::size_t s = 0; s < values.size(); ++s) cells[s].count(values[s]);
    }
  };
  curves::in_threads(effort.threads, (samples + kSamplesOfBlock - 1) / kSamplesOfBlock, job, effort.progress);
  PlainRun run;
  run.samples = samples;
  for (const Histogram& step : cells) {
    run.steps.push_back(quantiles_of(step, samples));
    run.resolution = std::max(run.resolution, step.width());
  }
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return run;
}

}  // namespace evc::deceleration
