#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace evc::random {

/// The number in [0, 1) that entry `entry` of `vary` has in case `number`. It depends on these and the seed alone.
double uniform_draw(std::uint64_t seed, std::uint64_t number, std::uint32_t entry);

/// The value below which a standard normal variable is with probability `p`, 0 < p < 1 (Wichura, algorithm AS 241:
/// relative error about 1e-16).
double normal_quantile(double p);

/// Sobol points with the direction numbers of Joe and Kuo (2008, new-joe-kuo-6.21201), whose table Boost carries.
/// Point `n` is computed by itself; the origin is left out.
class Sobol {
 public:
  static constexpr std::size_t kMostDimensions = 64;
  static constexpr std::size_t kBits = 40;  ///< points with a number below 2^40 - 1
  explicit Sobol(std::size_t dimensions);
  /// In (0, 1).
  double at(std::uint64_t number, std::size_t dimension) const;

 private:
  std::vector<std::array<std::uint64_t, kBits>> directions_;
};

}  // namespace evc::random
