#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "deceleration/draws.h"

namespace evc::deceleration {

/// Which units fail, where each does so by itself and `count` of them do.
///
/// Each unit has a term if it fails and one if it works; the set of failed units S has the weight
/// product(fails[u], u in S) product(works[u], u not in S). With the probabilities as terms the weight of a set is its
/// probability, the sum over all sets of `count` units that of the stratum.
class FailedUnits {
 public:
  FailedUnits(std::span<const double> fails, std::span<const double> works, std::size_t count);
  /// The sum of the weights of all sets of `count` units.
  double sum() const { return sums_[count_]; }
  /// Draws a set, each as likely as its weight says. `failed` gets a flag for each unit.
  void draw(const Source& source, std::uint32_t place, std::vector<char>& failed) const;

 private:
  double sum_from(std::size_t unit, std::size_t count) const { return sums_[unit * (count_ + 1) + count]; }

  std::vector<double> fails_;
  std::size_t units_, count_;
  std::vector<double> sums_;  // over the sets of units from `unit` on, of 0 to `count_` units
};

/// The sums of the weights of all sets of 0, 1, ... `count` units.
std::vector<double> sums_by_failed(std::span<const double> fails, std::span<const double> works, std::size_t count);

/// The probability of 0, 1, 2, ... failed units, each of which fails with its probability.
std::vector<double> probabilities_of_failures(std::span<const double> failure);

}  // namespace evc::deceleration
