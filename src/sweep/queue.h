#pragma once
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
/// ranks of a cluster through the one that has it.
class Todo {
 public:
  explicit Todo(const std::vector<Range>& ranges);
  /// At most `most` numbers in a row; nothing when none is left. Any thread may call it.
  std::optional<Range> take(std::uint64_t most);
  std::uint64_t left() const;

 private:
  mutable std::mutex mutex_;
  std::deque<Range> ranges_;
};

/// Blocks of rows on their way from those who compute to the one who writes. It holds few: who computes faster than
/// rows can be written waits.
class Rows {
 public:
  explicit Rows(std::size_t most) : most_(most) {}
  /// False when nobody takes any more.
  bool put(std::vector<Row>&& rows);
  /// The next block, or nothing after a tenth of a second.
  std::optional<std::vector<Row>> take();
  /// No more are put, none are taken.
  void close();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::vector<Row>> blocks_;
  std::size_t most_;
  bool closed_ = false;
};

/// Computes what is to be done with this number of threads. `take` gets the rows in the order in which they are
/// finished, in the thread of the caller, and nothing (no rows) at least five times a second; it returns whether to go
/// on. An exception of a case ends it, and is thrown here.
void compute(const Plan& plan, Todo& todo, unsigned threads, const std::function<bool(std::vector<Row>&&)>& take);

}  // namespace evc::sweep
