#include "realtime/executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "realtime/test_clock.h"

namespace evc::realtime {
namespace {

using std::chrono::milliseconds;

constexpr Nanoseconds kPeriod = milliseconds(100);

/// Runs `costs.size()` cycles that take these times.
struct Executed {
  explicit Executed(const std::vector<Nanoseconds>& costs) {
    std::stop_source stop;
    Executor executor(clock, kPeriod);
    executor.run(clock.now(), stop.get_token(), [&](const Cycle& cycle) {
      cycles.push_back(cycle);
      clock.pass(costs[cycles.size() - 1]);
      if (cycles.size() == costs.size()) stop.request_stop();
    });
    timing = executor.timing();
  }
  TestClock clock;
  std::vector<Cycle> cycles;
  Timing timing;
};

TEST(Executor, CallsOneCycleInEachPeriod) {
  const Executed run({milliseconds(1), milliseconds(2), milliseconds(3)});
  ASSERT_EQ(run.cycles.size(), 3u);
  for (std::int64_t n = 0; n < 3; ++n) {
    const Cycle& cycle = run.cycles[static_cast<std::size_t>(n)];
    EXPECT_EQ(cycle.number, n);
    EXPECT_EQ(cycle.due, n * kPeriod);
    EXPECT_EQ(cycle.late, Nanoseconds{0});
  }
  EXPECT_EQ(run.timing.cycles, 3u);
  EXPECT_EQ(run.timing.missed, 0u);
  EXPECT_EQ(run.timing.jitter.max(), Nanoseconds{0});
  EXPECT_EQ(run.timing.response.max(), Nanoseconds{milliseconds(3)});
}

TEST(Executor, ACycleMayTakeTheWholePeriodAndNoMore) {
  EXPECT_EQ(Executed({kPeriod, kPeriod}).timing.missed, 0u);
  EXPECT_EQ(Executed({kPeriod + Nanoseconds{1}, Nanoseconds{0}}).timing.missed, 1u);
}

/// The first takes 2.5 periods: the next two are late, none is left out, and the one after them is in time again.
TEST(Executor, LateCyclesAreDoneOneAfterTheOther) {
  const Executed run({milliseconds(250), milliseconds(10), milliseconds(10), milliseconds(10), milliseconds(10)});
  ASSERT_EQ(run.cycles.size(), 5u);
  const std::vector<int> late_ms{0, 150, 60, 0, 0};
  for (std::size_t n = 0; n < run.cycles.size(); ++n) {
    EXPECT_EQ(run.cycles[n].number, static_cast<std::int64_t>(n));
    EXPECT_EQ(run.cycles[n].late, Nanoseconds{milliseconds(late_ms[n])}) << n;
  }
  // 0 ends 150 ms after its deadline, 1 ends at 260 ms where 200 was due, 2 ends at 270 of 300.
  EXPECT_EQ(run.timing.missed, 2u);
  EXPECT_EQ(run.timing.jitter.max(), Nanoseconds{milliseconds(150)});
  EXPECT_EQ(run.timing.response.max(), Nanoseconds{milliseconds(250)});
}

TEST(Executor, AStopBeforeTheFirstCycleLeavesNone) {
  std::stop_source stop;
  stop.request_stop();
  TestClock clock;
  Executor executor(clock, kPeriod);
  executor.run(clock.now(), stop.get_token(), [](const Cycle&) { FAIL(); });
  EXPECT_EQ(executor.timing().cycles, 0u);
}

TEST(Executor, StopsAnExecutorThatWaits) {
  MonotonicClock clock;
  Executor executor(clock, std::chrono::hours(1));
  std::atomic<int> cycles = 0;
  {
    std::jthread thread(
        [&](const std::stop_token& stop) { executor.run(clock.now(), stop, [&](const Cycle&) { ++cycles; }); });
    while (cycles == 0) std::this_thread::yield();
    // The next one is due in an hour. The destructor asks for the stop and waits for the end of the thread.
  }
  EXPECT_EQ(cycles, 1);
  EXPECT_EQ(executor.timing().cycles, 1u);
}

TEST(MonotonicClock, DoesNotReturnBeforeTheTime) {
  MonotonicClock clock;
  for (const auto at : {milliseconds(0), milliseconds(5), milliseconds(60), milliseconds(3)}) {
    clock.wait_until(at, {});
    EXPECT_GE(clock.now(), Nanoseconds{at});
  }
}

}  // namespace
}  // namespace evc::realtime
