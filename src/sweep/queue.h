#pragma once
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "sweep/plan.h"

namespace evc::sweep {

/// Numbers of cases from `first` to before `end`.
struct Range {
  std::uint64_t first = 0, end = 0;
  bool operator==(const Range&) const = default;
};

/// The numbers that are still to be computed, given in blocks. Whoever computes takes from it: threads here, the
/// ranks of a cluster through the one that has it. Any thread may call it.
class Todo {
 public:
  /// None yet: they come by `add`, until `close`.
  Todo() = default;
  /// These, and no others.
  explicit Todo(const std::vector<Range>& ranges);
  /// At most `most` numbers in a row; nothing when none is left. While others may come, it waits for them.
  std::optional<Range> take(std::uint64_t most);
  std::uint64_t left() const;
  void add(Range range);
  /// No others come.
  void close();

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Range> ranges_;
  std::uint64_t left_ = 0;
  bool closed_ = false;
};

/// Blocks of rows on their way from those who compute to the one who writes. It holds few: who computes faster than
/// rows can be written waits.
class Rows {
 public:
  explicit Rows(std::size_t most) : most_(most) {}
  /// False when nobody takes any more.
  bool put(std::vector<Row>&& rows);
  /// The next block, or nothing after this time.
  std::optional<std::vector<Row>> take(std::chrono::milliseconds wait);
  /// No more are put, none are taken.
  void close();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::vector<Row>> blocks_;
  std::size_t most_;
  bool closed_ = false;
};

/// Gets rows in the order in which they are finished, in the thread of who waits for them; from time to time none. It
/// returns whether to go on.
using Take = std::function<bool(std::vector<Row>&&)>;

/// Computes what is to be done with this number of threads. `take` is called in the thread of the caller, at least once
/// in `idle`, without rows where none were finished. An exception of a case ends it, and is thrown here.
void compute(const Plan& plan, Todo& todo, unsigned threads, const Take& take,
             std::chrono::milliseconds idle = std::chrono::milliseconds(100));

}  // namespace evc::sweep
