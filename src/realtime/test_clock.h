#pragma once
#include <atomic>
#include <functional>
#include <thread>
#include <utility>

#include "realtime/clock.h"

namespace evc::realtime {

/// A clock whose time goes on only by waiting: whoever waits for a time is there at once. For tests of one thread, and
/// with `ready` for two: time reaches a cycle when `ready` says so.
class TestClock final : public Clock {
 public:
  TestClock() = default;
  explicit TestClock(std::function<bool(Nanoseconds)> ready) : ready_(std::move(ready)) {}

  Nanoseconds now() override { return now_.load(); }
  void wait_until(Nanoseconds at, const std::stop_token& stop) override {
    while (ready_ && !ready_(at) && !stop.stop_requested()) std::this_thread::yield();
    if (at > now_.load()) now_ = at;
  }
  /// Something takes this long.
  void pass(Nanoseconds time) { now_ = now_.load() + time; }

 private:
  std::function<bool(Nanoseconds)> ready_;
  std::atomic<Nanoseconds> now_{Nanoseconds{0}};  // one thread waits, any may ask
};

}  // namespace evc::realtime
