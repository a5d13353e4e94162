#pragma once
#include <chrono>
#include <stop_token>

namespace evc::realtime {

using Nanoseconds = std::chrono::nanoseconds;

/// Time for the executor, given from outside: a test passes a clock of its own and waits for nothing.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Never falls.
  virtual Nanoseconds now() = 0;
  /// Returns at `at` or later, at once if that is past, and soon after a stop was requested.
  virtual void wait_until(Nanoseconds at, const std::stop_token& stop) = 0;
};

/// The monotonic clock of the system, from 0 at construction.
class MonotonicClock final : public Clock {
 public:
  MonotonicClock() : begin_(std::chrono::steady_clock::now()) {}
  Nanoseconds now() override;
  void wait_until(Nanoseconds at, const std::stop_token& stop) override;

 private:
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace evc::realtime
