#include "cluster/ranks.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "cluster/message.h"
#include "run/stop_signals.h"

namespace evc::cluster {
namespace {

using sweep::Plan;
using sweep::Range;
using sweep::Row;
using sweep::Todo;

/// How often a rank that has nothing else to do looks for messages: little against what a rank has at hand.
constexpr std::chrono::milliseconds kLook(2);
/// See Supply.
constexpr double kAtHand_s = 0.1;
constexpr std::uint64_t kMostAtHand = 65536;

/// The content of a message, which another rank of the same program has written.
template <class T>
T content(std::optional<T> read) {
  if (!read) throw std::runtime_error("a message that no rank of this program sends");
  return *std::move(read);
}

void send_rows(Messenger& messenger, const std::vector<Row>& rows) {
  for (std::size_t first = 0; first < rows.size();) messenger.send(0, Kind::rows, bytes_of(rows, first));
}

/// The plan that rank 0 has, at another rank.
io::Result<std::unique_ptr<const Plan>> plan_of(const Order& order) {
  if (order.version != EVC_VERSION)
    return tl::unexpected(
        io::Diagnostic{"", "", std::string("evc-mpi ") + EVC_VERSION, "that of rank 0: " + order.version});
  auto plan = Plan::make(order.spec, order.file);
  if (plan && (*plan)->identity() != order.identity)
    return tl::unexpected(io::Diagnostic{order.file, "", "files of `base` that differ from those of rank 0",
                                         "the same on every computer"});
  return plan;
}

/// The cases that are granted to a rank that is not 0, to the last one or until rank 0 ends it.
void work(Messenger& messenger, const Plan& plan, unsigned threads) {
  const run::StopSignals signals;
  Todo todo;
  Supply supply(threads, Supply::Clock::now());
  bool asked = false, last = false, passed_on = false, ended = false;
  const auto take = [&](std::vector<Row>&& rows) {
    supply.finished(rows.size());
    send_rows(messenger, rows);
    while (const auto message = messenger.received()) {
      if (message->kind == Kind::end) {
        ended = true;
        continue;
      }
      const Range range = content(range_of(message->bytes));
      asked = false;
      last = range.first == range.end;
      supply.granted(range.end - range.first);
      todo.add(range);
      if (last) todo.close();
    }
    if (signals.seen() && !passed_on) {
      messenger.send(0, Kind::stop, "");
      passed_on = true;
    }
    if (!asked && !last)
      if (const std::uint64_t missing = supply.missing(Supply::Clock::now()); missing > 0) {
        messenger.send(0, Kind::ask, bytes_of(missing));
        asked = true;
      }
    return !ended;
  };
  sweep::compute(plan, todo, threads, take, kLook);
  messenger.send(0, Kind::done, "");
}

}  // namespace

void Supply::finished(std::uint64_t cases) {
  held_ -= std::min(cases, held_);
  finished_ += cases;
}

std::uint64_t Supply::missing(Clock::time_point now) {
  if (held_ > wanted_ / 2) return 0;
  const double seconds = std::chrono::duration<double>(now - since_).count();
  if (finished_ > 0 && seconds > 0.0) {
    // Cases differ: not more than four times as many at once.
    const double most = static_cast<double>(std::min(4 * wanted_, std::max(kMostAtHand, least_)));
    const double fitting = kAtHand_s * static_cast<double>(finished_) / seconds;
    wanted_ = std::max(static_cast<std::uint64_t>(std::min(fitting, most)), least_);
  }
  finished_ = 0;
  since_ = now;
  return wanted_ > held_ ? wanted_ - held_ : 0;
}

std::uint64_t granted_of(std::uint64_t left, std::uint64_t asked, std::uint64_t threads) {
  return std::min(asked, std::max<std::uint64_t>(left / (2 * threads), 1));
}

/// The messages of the others while rank 0 computes.
class Leader::Work {
 public:
  Work(Messenger& messenger, Todo& todo, std::uint64_t threads, const sweep::Take& take)
      : messenger_(messenger), todo_(todo), threads_(threads), take_(take), working_(messenger.ranks() - 1) {}

  /// Rows of this rank, and whatever has arrived. Whether to go on.
  bool step(std::vector<Row>&& rows) {
    accept(std::move(rows));
    while (auto message = messenger_.received()) answer(*message);
    if (!wanted_ && !ended_) {
      for (int rank = 1; rank < messenger_.ranks(); ++rank) messenger_.send(rank, Kind::end, "");
      ended_ = true;
    }
    return wanted_;
  }
  /// Ranks whose rows are not all here.
  int working() const { return working_; }

 private:
  void accept(std::vector<Row>&& rows) {
    // Also without rows: the one who takes them looks at the clock, and for signals.
    if (wanted_) wanted_ = take_(std::move(rows));
  }
  void answer(const Message& message) {
    switch (message.kind) {
      case Kind::rows:
        accept(content(rows_of(message.bytes)));
        break;
      case Kind::ask:
        if (wanted_) grant(message.from, content(count_of(message.bytes)));
        break;
      case Kind::stop:
        wanted_ = false;
        break;
      case Kind::done:
        --working_;
        break;
      default:
        throw std::runtime_error("a message that no rank of this program sends");
    }
  }
  void grant(int rank, std::uint64_t asked) {
    const auto range = todo_.take(granted_of(todo_.left(), asked, threads_));
    messenger_.send(rank, Kind::grant, bytes_of(range.value_or(Range{})));
  }

  Messenger& messenger_;
  Todo& todo_;
  std::uint64_t threads_;
  const sweep::Take& take_;
  int working_;
  bool wanted_ = true, ended_ = false;
};

io::Result<bool> Leader::prepare(const Plan& plan) {
  const std::string& file = plan.spec().file;
  std::error_code ignored;
  Order order;
  order.what = Order::What::prepare;
  order.spec = plan.spec().text;
  order.file = file == "-" ? file : std::filesystem::absolute(file, ignored).string();
  order.identity = plan.identity();
  order.version = EVC_VERSION;
  (void)messenger_.broadcast(bytes_of(order));
  io::Result<bool> prepared = true;
  for (int missing = messenger_.ranks() - 1; missing > 0;) {
    const auto message = messenger_.received();
    if (!message) {
      std::this_thread::sleep_for(kLook);
      continue;
    }
    --missing;
    if (message->bytes.empty()) continue;
    io::Diagnostic refusal = content(refusal_of(message->bytes));
    refusal.file = fmt::format("rank {}{}{}", message->from, refusal.file.empty() ? "" : ": ", refusal.file);
    prepared = tl::unexpected(std::move(refusal));
  }
  return prepared;
}

void Leader::compute(const Plan& plan, Todo& todo, unsigned threads, const sweep::Take& take) {
  Order order;
  order.what = Order::What::compute;
  order.threads = std::max(threads, 1u);
  (void)messenger_.broadcast(bytes_of(order));
  computing_ = true;
  Work work(messenger_, todo, std::uint64_t{order.threads} * static_cast<unsigned>(messenger_.ranks()), take);
  const auto mine = static_cast<unsigned>(std::min<std::uint64_t>(order.threads, todo.left()));
  sweep::compute(
      plan, todo, mine, [&](std::vector<Row>&& rows) { return work.step(std::move(rows)); }, kLook);
  while (work.working() > 0) {
    (void)work.step({});
    std::this_thread::sleep_for(kLook);
  }
  computing_ = false;
}

void Leader::finish(int exit_code) {
  Order order;
  order.what = Order::What::finish;
  order.exit_code = exit_code;
  (void)messenger_.broadcast(bytes_of(order));
}

int follow(Messenger& messenger) {
  std::unique_ptr<const Plan> plan;
  for (;;) {
    const Order order = content(order_of(messenger.broadcast("")));
    switch (order.what) {
      case Order::What::prepare: {
        auto made = plan_of(order);
        if (!made)
          made.error().file = messenger.computer() + (made.error().file.empty() ? "" : ": ") + made.error().file;
        messenger.send(0, Kind::prepared, made ? "" : bytes_of(made.error()));
        if (made) plan = *std::move(made);
        break;
      }
      case Order::What::compute:
        work(messenger, *plan, order.threads);
        break;
      case Order::What::finish:
        while (messenger.received()) {  // the word to end came after the last case
        }
        return order.exit_code;
    }
  }
}

}  // namespace evc::cluster
