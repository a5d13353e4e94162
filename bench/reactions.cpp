// Reaction times of SUBSET-041 in simulated and in real time, with their margins. In real time the unit runs in a
// thread of its own, cycles by the clock; a second thread reads the odometer half a cycle before each cycle and hands
// in the event when it happens; a third one takes the outputs. Usage: reactions [TIMES [CYCLE_MS...]]; exit 1 when a
// limit is not kept.
#include "reactions.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <thread>

#include "io/data_files.h"
#include "realtime/exchange.h"
#include "realtime/executor.h"

namespace evc::bench {
namespace {

using realtime::Nanoseconds;
using std::chrono::duration_cast;
using std::chrono::milliseconds;

using Exchange = realtime::Exchange<sim::CycleInputs, kernel::Outputs>;

Nanoseconds ns(double s) { return Nanoseconds{static_cast<std::int64_t>(s * 1e9)}; }
double seconds(Nanoseconds t) { return static_cast<double>(t.count()) * 1e-9; }

/// One reaction by the clock. The first cycle is `first` after the moment of the scene.
class Timed {
 public:
  Timed(const Reaction& reaction, Nanoseconds first, Nanoseconds period)
      : r_(reaction), unit_(reaction.scene), first_(first), period_(period), begin_(clock_.now() + milliseconds(5)) {}

  std::optional<Nanoseconds> measure() {
    realtime::Executor executor(clock_, period_);
    std::jthread reader([this] { read(); });
    std::jthread executing([&](const std::stop_token& stop) {
      sim::CycleInputs inputs = r_.scene.inputs;
      executor.run(begin_, stop, [&](const realtime::Cycle& cycle) { step(cycle, inputs); });
      exchange_.close();
    });
    outside();
    executing.request_stop();
    executing.join();
    reader.join();
    missed_ = executor.timing().missed;
    if (seen_at_.load() == Nanoseconds{0}) return std::nullopt;
    return seen_at_.load() - event_at();
  }
  std::uint64_t missed() const { return missed_; }

 private:
  Nanoseconds event_at() const { return begin_ + ns(r_.event_s) - first_; }
  /// Seconds after the moment of the scene.
  double scene_time(Nanoseconds t) const { return seconds(t - begin_ + first_); }

  void step(const realtime::Cycle& cycle, sim::CycleInputs& inputs) {
    if (!exchange_.take(cycle.number, inputs)) inputs.clear();
    const double u = scene_time(cycle.due);
    const kernel::Outputs& outputs = unit_.step(inputs, r_.scene.t0 + u);
    exchange_.publish([&](Exchange::Result& result) { result.out = outputs; });
  }

  /// Takes the outputs.
  void read() {
    Exchange::Result result;
    while (exchange_.next(result)) {
      if (!r_.seen(result.out) || seen_at_.load() != Nanoseconds{0}) continue;
      seen_at_ = clock_.now();
    }
  }

  /// Makes the inputs until the reaction is seen, for 5 s at most.
  void outside() {
    for (std::int64_t n = 0; seen_at_.load() == Nanoseconds{0}; ++n) {
      const Nanoseconds reading = begin_ + n * period_ - period_ / 2;
      if (reading > event_at() + std::chrono::seconds(5)) return;
      if (!happened_ && event_at() <= reading) {
        clock_.wait_until(event_at(), {});
        happened_ = true;
        offer(n - 1);
      }
      clock_.wait_until(reading, {});
      reading_ = reading;
      offer(n);
    }
  }
  /// For that cycle, or the first that has not begun. The event belongs to one cycle, also when its reading is
  /// replaced.
  void offer(std::int64_t cycle) {
    for (;;) {
      sim::CycleInputs in = r_.scene.inputs;
      in.levels.odometry = r_.scene.odometry(scene_time(reading_));
      const bool with_event = happened_ && (event_cycle_ < 0 || event_cycle_ == cycle);
      if (with_event) r_.happen(in);
      const std::int64_t taken_for = exchange_.offer(cycle, in, clock_.now());
      if (taken_for == cycle) {
        if (with_event) event_cycle_ = cycle;
        return;
      }
      cycle = taken_for;
    }
  }

  const Reaction& r_;
  Unit unit_;
  realtime::MonotonicClock clock_;
  Nanoseconds first_, period_, begin_;
  Exchange exchange_{64};
  // Of the outside:
  Nanoseconds reading_{0};
  bool happened_ = false;
  std::int64_t event_cycle_ = -1;
  std::atomic<Nanoseconds> seen_at_{Nanoseconds{0}};
  std::uint64_t missed_ = 0;
};

struct Measured {
  Nanoseconds longest{0};
  std::uint64_t missed = 0;
};

/// At so many phases of the event in a cycle. Nothing when the reaction did not come.
std::optional<Measured> in_real_time(const Reaction& r, int cycle_ms, int times) {
  const Nanoseconds period = milliseconds(cycle_ms);
  Measured all;
  for (int n = 0; n < times; ++n) {
    Timed timed(r, period + period * (2 * n + 1) / (2 * times), period);
    const auto time = timed.measure();
    if (!time) return std::nullopt;
    all.longest = std::max(all.longest, *time);
    all.missed += timed.missed();
  }
  return all;
}

/// Whether all limits are kept.
bool print(int cycle_ms, int times) {
  std::printf("\ncycle of %d ms; by the clock %d times each, the event at different phases of the cycle\n", cycle_ms,
              times);
  std::printf("%-34s %-9s %7s %13s %8s %13s %8s %7s\n", "reaction", "SUBSET-041", "limit", "simulated max", "margin",
              "real time max", "margin", "missed");
  bool kept = true;
  for (const Reaction& r : reactions(io::data_file("lines/brunnental.json"))) {
    const auto of_simulated = longest_simulated(r, cycle_ms);
    const auto of_clock = in_real_time(r, cycle_ms, times);
    if (!of_simulated || !of_clock) {
      std::printf("%-34s %-9s the reaction did not come\n", r.what.c_str(), r.clause.c_str());
      kept = false;
      continue;
    }
    const double limit = r.limit_s * 1e3;
    const double a = *of_simulated * 1e3;
    const double b = seconds(of_clock->longest) * 1e3;
    std::printf("%-34s %-9s %4.0f ms %10.1f ms %5.0f ms %10.1f ms %5.0f ms %7llu\n", r.what.c_str(), r.clause.c_str(),
                limit, a, limit - a, b, limit - b, static_cast<unsigned long long>(of_clock->missed));
    kept = kept && a < limit && b < limit;
  }
  return kept;
}

}  // namespace
}  // namespace evc::bench

int main(int argc, char** argv) {
  try {
    const int times = argc > 1 ? std::atoi(argv[1]) : 20;
    bool kept = times > 0;
    if (argc <= 2) {
      kept = evc::bench::print(100, times) && kept;
      kept = evc::bench::print(10, times) && kept;
    }
    for (int i = 2; i < argc; ++i) kept = evc::bench::print(std::atoi(argv[i]), times) && kept;
    return kept ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "reactions: %s\n", error.what());
    return 2;
  }
}
