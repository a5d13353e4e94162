#pragma once
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
/// - inputs: the outside owns its own object, the exchange the offered one, the unit the one it computes with. A
///   hand-over swaps two of them under the lock, so that nobody sees a value that is half written.
/// - results: a ring. The slots behind the published ones belong to the unit, the published ones to the outside, which
///   gives one back by taking it. Slots are filled and emptied without the lock, which guards their numbers only.
/// The unit never waits for the outside. An outside that is so late that the ring is full loses results: counted.
template <class In, class Out>
class Exchange {
 public:
  struct Result {
    std::int64_t cycle = -1;
    bool fresh = false;  ///< the cycle had inputs of its own
    In in{};
    Out out{};
  };
  explicit Exchange(std::size_t capacity) : ring_(capacity) {}

  /// The outside: inputs for a cycle; `in` becomes an object for the next ones. They replace what was offered and not
  /// taken. Returns `cycle`; or, where that has begun without them, the first that has not: nothing changes owner.
  std::int64_t offer(std::int64_t cycle, In& in, Nanoseconds now) {
    const std::lock_guard lock(mutex_);
    if (cycle < next_) return next_;
    std::swap(offered_, in);
    offered_for_ = cycle;
    offered_at_ = now;
    return cycle;
  }

  /// The unit, at the begin of a cycle: its inputs, and when they were offered; without any `in` stays as it is.
  std::optional<Nanoseconds> take(std::int64_t cycle, In& in) {
    const std::lock_guard lock(mutex_);
    next_ = cycle + 1;
    if (offered_for_ != cycle) return std::nullopt;
    std::swap(offered_, in);
    return offered_at_;
  }

  /// The unit, at the end of a cycle: `fill` writes its result into a slot.
  template <class Fill>
  void publish(Fill&& fill) {
    std::size_t at = 0;
    {
      const std::lock_guard lock(mutex_);
      if (published_ - taken_ == ring_.size()) {
        ++lost_;
        return;
      }
      at = published_ % ring_.size();
    }
    fill(ring_[at]);
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
      changed_.wait(lock, [&] { return published_ != taken_ || closed_; });
      if (published_ == taken_) return false;
      at = taken_ % ring_.size();
    }
    std::swap(into, ring_[at]);
    const std::lock_guard lock(mutex_);
    ++taken_;
    return true;
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
    return offered_for_ == cycle;
  }
  std::size_t lost() const {
    const std::lock_guard lock(mutex_);
    return lost_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  In offered_{};
  std::int64_t offered_for_ = -1;
  Nanoseconds offered_at_{0};
  std::int64_t next_ = 0;  ///< the first cycle that has not begun
  std::vector<Result> ring_;
  std::size_t published_ = 0, taken_ = 0, lost_ = 0;
  bool closed_ = false;
};

}  // namespace evc::realtime
