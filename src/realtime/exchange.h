#pragma once
#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "realtime/clock.h"

namespace evc::realtime {

/// Hand-over of whole values between two threads: the *outside*, which makes inputs and uses outputs, and the *unit*,
/// whose cycles the executor calls. Who owns what:
/// - inputs: a ring. An offer swaps the outside's object with one of it, the unit takes it by swapping too, under the
///   lock: nobody sees a value that is half written, and none is copied.
/// - results: another ring. The slots behind the published ones belong to the unit, the published ones to the outside,
///   which gives one back by taking it. Slots are filled and emptied without the lock, which guards their numbers.
/// The unit never waits for what the outside makes or does, only for the lock: for the time of a swap at most. A full
/// ring loses what would come into it, and a cycle that is left out its inputs: counted.
template <class In, class Out>
class Exchange {
 public:
  struct Result {
    std::int64_t cycle = -1;
    bool fresh = false;  ///< the cycle had inputs of its own
    In in{};
    Out out{};
  };
  explicit Exchange(std::size_t capacity) : inputs_(capacity), results_(capacity) {}

  /// The outside: inputs for a cycle; a second offer for it replaces the first. `in` becomes an object for the next
  /// ones. Returns `cycle`; or, where that has begun or is before that of the last offer, the first that can still be
  /// offered: `in` stays.
  std::int64_t offer(std::int64_t cycle, In& in, Nanoseconds now) {
    const std::lock_guard lock(mutex_);
    const bool waiting = offered_ != taken_;
    const std::int64_t last = waiting ? inputs_[(offered_ - 1) % inputs_.size()].cycle : -1;
    const std::int64_t first = std::max(next_, last);
    if (cycle < first) return first;
    const bool again = waiting && last == cycle;
    if (!again && offered_ - taken_ == inputs_.size()) {
      ++lost_;
      return cycle;
    }
    if (!again) ++offered_;
    Offer& slot = inputs_[(offered_ - 1) % inputs_.size()];
    std::swap(slot.in, in);
    slot.cycle = cycle;
    slot.at = now;
    return cycle;
  }

  /// The unit, at the begin of a cycle: its inputs, and when they were offered; without any `in` stays as it is.
  std::optional<Nanoseconds> take(std::int64_t cycle, In& in) {
    const std::lock_guard lock(mutex_);
    next_ = cycle + 1;
    for (; offered_ != taken_ && inputs_[taken_ % inputs_.size()].cycle < cycle; ++taken_) ++lost_;
    if (!has(cycle)) return std::nullopt;
    Offer& slot = inputs_[taken_++ % inputs_.size()];
    std::swap(slot.in, in);
    return slot.at;
  }

  /// The unit, at the end of a cycle: `fill` writes its result into a slot.
  template <class Fill>
  void publish(Fill&& fill) {
    std::size_t at = 0;
    {
      const std::lock_guard lock(mutex_);
      if (published_ - used_ == results_.size()) {
        ++lost_;
        return;
      }
      at = published_ % results_.size();
    }
    fill(results_[at]);
    {
      const std::lock_guard lock(mutex_);
      ++published_;
    }
    changed_.notify_one();
  }

  /// The outside: waits for the next result, in the order of cycles. False when there will be no more.
  bool next(Result& into) {
    std::size_t at = 0;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return published_ != used_ || closed_; });
      if (published_ == used_) return false;
      at = used_ % results_.size();
    }
    std::swap(into, results_[at]);
    const std::lock_guard lock(mutex_);
    ++used_;
    return true;
  }

  /// Whether a result waits to be taken.
  bool waiting() const {
    const std::lock_guard lock(mutex_);
    return published_ != used_;
  }

  /// The unit: nothing more is published.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    changed_.notify_one();
  }

  /// Whether inputs wait for this cycle; from any thread.
  bool ready(std::int64_t cycle) const {
    const std::lock_guard lock(mutex_);
    return has(cycle);
  }
  std::size_t lost() const {
    const std::lock_guard lock(mutex_);
    return lost_;
  }

 private:
  struct Offer {
    std::int64_t cycle = -1;
    Nanoseconds at{0};
    In in{};
  };
  bool has(std::int64_t cycle) const {
    for (std::size_t n = taken_; n != offered_; ++n)
      if (inputs_[n % inputs_.size()].cycle == cycle) return true;
    return false;
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Offer> inputs_;
  std::vector<Result> results_;
  std::size_t offered_ = 0, taken_ = 0;   // numbers of inputs
  std::size_t published_ = 0, used_ = 0;  // numbers of results
  std::size_t lost_ = 0;
  std::int64_t next_ = 0;  // the first cycle that has not begun
  bool closed_ = false;
};

}  // namespace evc::realtime
