#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "realtime/clock.h"

namespace evc::realtime {

/// A distribution of times in a fixed memory, however long it is measured: 16 classes for each power of two, so that a
/// share is at most 1/16 too high; the maximum is exact.
class Times {
 public:
  void add(Nanoseconds time);
  std::uint64_t count() const { return count_; }
  Nanoseconds max() const { return max_; }
  /// The time that `share` (0..1) of the times do not exceed; 0 without any.
  Nanoseconds share(double share) const;

 private:
  static constexpr std::size_t kClasses = 16;
  std::array<std::uint32_t, 61 * kClasses> classes_{};
  std::uint64_t count_ = 0;
  Nanoseconds max_{0};
};

/// One cycle: when it was due, and what was.
struct CycleTimes {
  Nanoseconds due{0}, started{0}, ended{0};
};

/// What the executor measures. A cycle is missed when it has not ended by the time the next one is due.
struct Timing {
  std::uint64_t cycles = 0;
  std::uint64_t missed = 0;
  Times jitter;    ///< from due to started
  Times response;  ///< from due to ended

  void note(const CycleTimes& times, Nanoseconds period);
};

}  // namespace evc::realtime
