#pragma once
#include <array>
#include <cstdint>

#include "random/philox.h"

namespace evc::deceleration {

/// Where the draws of a sample come from: each is a function of the seed, of what is computed, of the number of the
/// sample, and of its place in the sample. Nothing is drawn one after another, so that threads make no difference.
struct Source {
  std::uint64_t seed = 0;
  std::uint32_t purpose = 0;  ///< which quantity, level of confidence, pilot or not
  std::uint32_t stratum = 0;
  std::uint32_t sample = 0;

  /// Two uniform shares, 0 < share < 1.
  std::array<double, 2> shares(std::uint32_t place) const {
    const auto bits = words(place);
    return {share_of(bits[0], bits[1]), share_of(bits[2], bits[3])};
  }
  std::array<std::uint32_t, 4> words(std::uint32_t place) const {
    return random::philox({sample, stratum, place, purpose},
                          {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
  }

 private:
  static double share_of(std::uint32_t low, std::uint32_t high) {
    // 52 bits and a half: exact, so that no share is 1.
    const std::uint64_t bits = (std::uint64_t{high} << 32 | low) >> 12;
    return (static_cast<double>(bits) + 0.5) / 4503599627370496.0;
  }
};

}  // namespace evc::deceleration
