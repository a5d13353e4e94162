#pragma once
#include <array>
#include <cstdint>

#include "base/location.h"
#include "base/units.h"

// How far the odometer may be wrong over the last distance, 3.6.8 of SRS 4.0.0.
namespace evc::position {

/// The counters of the odometer with their bounds.
struct Counters {
  OdometerPlace nominal, min, max;
};

struct OdometerAccuracy {
  /// What the bounds grew by; forward and backward movements count by their amount.
  struct Errors {
    Distance under{}, over{};
  };
  static constexpr std::size_t kIntervals = 50;  // 5000 m in intervals of 100 m (A.3.1)

  std::array<Errors, kIntervals> intervals{};
  Errors open{};          // of the interval that is not over yet
  Errors recovering{};    // while impaired: since the errors were last too large for the distance
  Distance travelled{};   // in the open interval
  Distance recovered{};   // for `recovering`
  Counters last{};        // of the cycle before
  std::uint8_t next = 0;  // the oldest interval, the next to be replaced
  bool begun = false;
  bool impaired = false;                 // 3.6.8.5, .6: at the last check
  bool beyond_safety_threshold = false;  // [84]: at the last check
  bool impairment_reported = false;      // to the RBC (3.16.4.2), while impaired
  bool safety_threshold_reported = false;
};

/// Accumulates the movement since the cycle before and checks it at the end of each interval (3.6.8.2 to 3.6.8.7).
void accumulate(OdometerAccuracy& accuracy, const Counters& now);

}  // namespace evc::position
