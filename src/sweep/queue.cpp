#include "sweep/queue.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

namespace evc::sweep {
namespace {

using Clock = std::chrono::steady_clock;

/// A block takes about this long: long against the hand-over, short against what an interruption loses.
constexpr double kBlock_s = 0.02;
constexpr std::uint64_t kLargestBlock = 1024;

/// The size of the next block after one of `size` cases that took `seconds`.
std::uint64_t next_size(std::uint64_t size, double seconds) {
  const double fitting = static_cast<double>(size) * kBlock_s / std::max(seconds, 1e-9);
  const auto wanted = static_cast<std::uint64_t>(std::min(fitting, static_cast<double>(kLargestBlock)));
  // Cases differ: not more than twice as many at once.
  return std::clamp<std::uint64_t>(wanted, 1, 2 * size);
}

/// One of the threads that compute.
void work_through(const Plan& plan, Todo& todo, Rows& rows) {
  const auto scratch = plan.scratch();
  std::uint64_t size = 1;
  while (const auto range = todo.take(size)) {
    const auto begin = Clock::now();
    std::vector<Row> block;
    block.reserve(range->end - range->first);
    for (std::uint64_t number = range->first; number < range->end; ++number)
      block.push_back(plan.compute(number, *scratch));
    if (!rows.put(std::move(block))) return;
    size = next_size(range->end - range->first, std::chrono::duration<double>(Clock::now() - begin).count());
  }
}

}  // namespace

Todo::Todo(const std::vector<Range>& ranges) {
  for (const Range& range : ranges) add(range);
  close();
}

void Todo::add(Range range) {
  if (range.first >= range.end) return;
  const std::lock_guard lock(mutex_);
  ranges_.push_back(range);
  left_ += range.end - range.first;
  changed_.notify_all();
}

void Todo::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

std::optional<Range> Todo::take(std::uint64_t most) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return closed_ || !ranges_.empty(); });
  if (ranges_.empty() || most == 0) return std::nullopt;
  Range& next = ranges_.front();
  const Range taken{next.first, next.first + std::min(most, next.end - next.first)};
  next.first = taken.end;
  left_ -= taken.end - taken.first;
  if (next.first == next.end) ranges_.pop_front();
  return taken;
}

std::uint64_t Todo::left() const {
  const std::lock_guard lock(mutex_);
  return left_;
}

bool Rows::put(std::vector<Row>&& rows) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return closed_ || blocks_.size() < most_; });
  if (closed_) return false;
  blocks_.push_back(std::move(rows));
  changed_.notify_all();
  return true;
}

std::optional<std::vector<Row>> Rows::take(std::chrono::milliseconds wait) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, wait, [this] { return closed_ || !blocks_.empty(); });
  if (blocks_.empty()) return std::nullopt;
  std::vector<Row> rows = std::move(blocks_.front());
  blocks_.pop_front();
  changed_.notify_all();
  return rows;
}

void Rows::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

void compute(const Plan& plan, Todo& todo, unsigned threads, const Take& take, std::chrono::milliseconds idle) {
  Rows rows(4 * threads);
  std::atomic<unsigned> working = threads;
  std::mutex failing;
  std::exception_ptr failure;
  const auto thread = [&] {
    try {
      work_through(plan, todo, rows);
    } catch (...) {
      const std::lock_guard lock(failing);
      failure = std::current_exception();
      rows.close();
      todo.close();
    }
    if (--working == 0) (void)rows.put({});  // wakes the caller
  };
  {
    std::vector<std::jthread> pool;
    struct Closing {  // before the threads are waited for, also when `take` throws
      Rows& rows;
      Todo& todo;
      ~Closing() {
        rows.close();
        todo.close();
      }
    };
    pool.reserve(threads);
    const Closing closing{rows, todo};
    for (unsigned i = 0; i < threads; ++i) pool.emplace_back(thread);
    bool wanted = true;
    for (bool last = false; wanted && !last;) {
      last = working == 0;  // what is finished is there now
      auto block = rows.take(idle);
      if (block && !block->empty()) last = false;
      wanted = take(block ? *std::move(block) : std::vector<Row>());
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace evc::sweep
