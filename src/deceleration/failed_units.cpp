#include "deceleration/failed_units.h"

#include <algorithm>

namespace evc::deceleration {

FailedUnits::FailedUnits(std::span<const double> fails, std::span<const double> works, std::size_t count)
    : fails_(fails.begin(), fails.end()), units_(fails.size()), count_(count), sums_((units_ + 1) * (count + 1), 0.0) {
  sums_[units_ * (count_ + 1)] = 1.0;
  for (std::size_t u = units_; u-- > 0;)
    for (std::size_t n = 0; n <= count_; ++n)
      sums_[u * (count_ + 1) + n] = works[u] * sum_from(u + 1, n) + (n == 0 ? 0.0 : fails[u] * sum_from(u + 1, n - 1));
}

void FailedUnits::draw(const Source& source, std::uint32_t place, std::vector<char>& failed) const {
  std::fill(failed.begin(), failed.end(), char{0});
  std::size_t left = count_;
  std::array<double, 2> shares{};
  for (std::size_t u = 0; u < units_ && left > 0; ++u) {
    if (u % 2 == 0) shares = source.shares(place + static_cast<std::uint32_t>(u / 2));
    const double fails = fails_[u] * sum_from(u + 1, left - 1) / sum_from(u, left);
    if (units_ - u > left && !(shares[u % 2] < fails)) continue;
    failed[u] = 1;
    --left;
  }
}

std::vector<double> sums_by_failed(std::span<const double> fails, std::span<const double> works, std::size_t count) {
  std::vector<double> sums(count + 1, 0.0);
  sums[0] = 1.0;
  for (std::size_t u = fails.size(); u-- > 0;)  // as FailedUnits does, so that they are finite in the same cases
    for (std::size_t n = count + 1; n-- > 0;) sums[n] = sums[n] * works[u] + (n == 0 ? 0.0 : sums[n - 1] * fails[u]);
  return sums;
}

std::vector<double> probabilities_of_failures(std::span<const double> failure) {
  std::vector<double> works;
  for (const double f : failure) works.push_back(1.0 - f);
  return sums_by_failed(failure, works, failure.size());
}

}  // namespace evc::deceleration
