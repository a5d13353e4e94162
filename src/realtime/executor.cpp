#include "realtime/executor.h"

namespace evc::realtime {

void Executor::run(Nanoseconds begin, const std::stop_token& stop, const Work& work) {
  for (std::int64_t n = 0;; ++n) {
    CycleTimes times;
    times.due = begin + n * period_;
    clock_.wait_until(times.due, stop);
    if (stop.stop_requested()) return;
    times.started = clock_.now();
    work({n, times.due, times.started - times.due});
    times.ended = clock_.now();
    const std::lock_guard lock(mutex_);
    timing_.note(times, period_);
  }
}

Timing Executor::timing() const {
  const std::lock_guard lock(mutex_);
  return timing_;
}

}  // namespace evc::realtime
