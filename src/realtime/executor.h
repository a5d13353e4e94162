#pragma once
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>

#include "realtime/clock.h"
#include "realtime/timing.h"

namespace evc::realtime {

/// A cycle as its work sees it.
struct Cycle {
  std::int64_t number = 0;
  Nanoseconds due{0};
  Nanoseconds late{0};  ///< how long after `due` it begins
};

/// Calls one function once in each period of a clock. The line of cycles has no gap: a cycle that is late is done as
/// soon as possible, and those that have become due meanwhile one after the other behind it, each with its own number.
/// So the clock decides when a cycle is computed and never what: the same inputs give the same outputs.
class Executor {
 public:
  using Work = std::function<void(const Cycle&)>;
  Executor(Clock& clock, Nanoseconds period) : clock_(clock), period_(period) {}

  /// Cycle n is due n periods after `begin`. Returns when a stop is requested; a cycle that has begun is ended.
  void run(Nanoseconds begin, const std::stop_token& stop, const Work& work);

  /// What was measured so far; from any thread.
  Timing timing() const;

 private:
  Clock& clock_;
  Nanoseconds period_;
  mutable std::mutex mutex_;  // of timing_
  Timing timing_;
};

}  // namespace evc::realtime
