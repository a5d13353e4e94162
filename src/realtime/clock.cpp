#include "realtime/clock.h"

#include <algorithm>
#include <thread>

namespace evc::realtime {
namespace {

/// The longest sleep before a stop is looked for. One sleep without a lock wakes up earlier after its time than a
/// condition variable does.
constexpr Nanoseconds kLongestSleep = std::chrono::milliseconds(50);

}  // namespace

Nanoseconds MonotonicClock::now() {
  return std::chrono::duration_cast<Nanoseconds>(std::chrono::steady_clock::now() - begin_);
}

void MonotonicClock::wait_until(Nanoseconds at, const std::stop_token& stop) {
  for (Nanoseconds t = now(); t < at && !stop.stop_requested(); t = now())
    std::this_thread::sleep_until(begin_ + std::min(at, t + kLongestSleep));
}

}  // namespace evc::realtime
