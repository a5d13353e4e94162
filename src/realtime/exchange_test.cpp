#include "realtime/exchange.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

#include "realtime/executor.h"
#include "realtime/test_clock.h"

namespace evc::realtime {
namespace {

/// Large enough that a value which is half written would be seen.
struct Value {
  std::array<std::int64_t, 512> words{};
  void set(std::int64_t to) { words.fill(to); }
  std::int64_t whole() const {
    for (const std::int64_t word : words)
      if (word != words[0]) return -1;
    return words[0];
  }
};
using Values = Exchange<Value, Value>;

void publish(Values& exchange, std::int64_t cycle) {
  exchange.publish([&](Values::Result& result) {
    result.cycle = cycle;
    result.out.set(cycle);
  });
}

TEST(Exchange, InputsAreForTheirCycle) {
  Values exchange(4);
  Value mine, units;
  units.set(7);
  mine.set(1);
  EXPECT_EQ(exchange.offer(1, mine, Nanoseconds{10}), 1);
  EXPECT_TRUE(exchange.ready(1));
  // Cycle 0 begins without inputs; those for cycle 1 stay.
  EXPECT_FALSE(exchange.take(0, units));
  EXPECT_EQ(units.whole(), 7);
  const auto taken = exchange.take(1, units);
  ASSERT_TRUE(taken);
  EXPECT_EQ(*taken, Nanoseconds{10});
  EXPECT_EQ(units.whole(), 1);
  // They are taken once.
  EXPECT_FALSE(exchange.take(2, units));
}

/// A unit that is late gets the inputs of each cycle, none replaces those of another one.
TEST(Exchange, InputsWaitForALateUnit) {
  Values exchange(2);
  Value mine, units;
  for (const std::int64_t cycle : {0, 1, 1, 2}) {
    mine.set(10 * (cycle + 1));
    EXPECT_EQ(exchange.offer(cycle, mine, Nanoseconds{cycle}), cycle);
  }
  EXPECT_EQ(exchange.lost(), 1u);  // those of cycle 2: the ring has two places
  EXPECT_EQ(exchange.take(0, units), Nanoseconds{0});
  EXPECT_EQ(units.whole(), 10);
  EXPECT_EQ(exchange.take(1, units), Nanoseconds{1});
  EXPECT_EQ(units.whole(), 20);
  EXPECT_FALSE(exchange.take(2, units));
}

TEST(Exchange, ASecondOfferForACycleReplacesTheFirst) {
  Values exchange(2);
  Value mine, units;
  mine.set(1);
  (void)exchange.offer(0, mine, Nanoseconds{1});
  mine.set(2);
  (void)exchange.offer(0, mine, Nanoseconds{2});
  EXPECT_EQ(exchange.take(0, units), Nanoseconds{2});
  EXPECT_EQ(units.whole(), 2);
  EXPECT_FALSE(exchange.take(1, units));
}

TEST(Exchange, ACycleThatHasBegunTakesNoMoreInputs) {
  Values exchange(4);
  Value mine, units;
  mine.set(5);
  EXPECT_FALSE(exchange.take(3, units));
  EXPECT_EQ(exchange.offer(3, mine, {}), 4);
  EXPECT_EQ(mine.whole(), 5);
  EXPECT_EQ(exchange.offer(4, mine, {}), 4);
}

TEST(Exchange, ResultsComeInOrder) {
  Values exchange(4);
  for (const std::int64_t cycle : {0, 1, 2}) publish(exchange, cycle);
  exchange.close();
  Values::Result result;
  for (const std::int64_t cycle : {0, 1, 2}) {
    EXPECT_TRUE(exchange.waiting());
    ASSERT_TRUE(exchange.next(result));
    EXPECT_EQ(result.cycle, cycle);
    EXPECT_EQ(result.out.whole(), cycle);
  }
  EXPECT_FALSE(exchange.waiting());
  EXPECT_FALSE(exchange.next(result));
  EXPECT_EQ(exchange.lost(), 0u);
}

/// The unit does not wait for who takes its results.
TEST(Exchange, AFullRingLosesResultsAndCountsThem) {
  Values exchange(2);
  for (const std::int64_t cycle : {0, 1, 2, 3}) publish(exchange, cycle);
  EXPECT_EQ(exchange.lost(), 2u);
  Values::Result result;
  ASSERT_TRUE(exchange.next(result));
  publish(exchange, 4);
  ASSERT_TRUE(exchange.next(result));
  EXPECT_EQ(result.cycle, 1);
  ASSERT_TRUE(exchange.next(result));
  EXPECT_EQ(result.cycle, 4);
}

/// An offer for a cycle that the unit has left out does not stop those behind it.
TEST(Exchange, InputsOfACycleThatIsLeftOutAreLost) {
  Values exchange(4);
  Value mine, units;
  for (const std::int64_t cycle : {0, 1, 2}) {
    mine.set(cycle);
    (void)exchange.offer(cycle, mine, Nanoseconds{cycle});
  }
  EXPECT_TRUE(exchange.ready(2));
  EXPECT_EQ(exchange.take(2, units), Nanoseconds{2});
  EXPECT_EQ(units.whole(), 2);
  EXPECT_EQ(exchange.lost(), 2u);
}

TEST(Exchange, InputsAreOfferedInTheOrderOfCycles) {
  Values exchange(4);
  Value mine, units;
  mine.set(3);
  EXPECT_EQ(exchange.offer(3, mine, Nanoseconds{3}), 3);
  mine.set(2);
  EXPECT_EQ(exchange.offer(2, mine, Nanoseconds{2}), 3);
  EXPECT_EQ(mine.whole(), 2);
  EXPECT_FALSE(exchange.take(2, units));
  EXPECT_EQ(exchange.take(3, units), Nanoseconds{3});
  EXPECT_EQ(units.whole(), 3);
}

/// The unit doubles its inputs, or what it had last; the outside answers each result with inputs for a later cycle.
TEST(Exchange, BetweenTwoThreadsValuesAreWholeAndNoneIsLeftOut) {
  constexpr std::int64_t kCycles = 3000;
  Values exchange(8);
  TestClock clock([&, cycle = std::int64_t{0}](Nanoseconds) mutable {
    // Every seventh cycle begins whether there are inputs or not.
    if (cycle % 7 != 0 && !exchange.ready(cycle)) return false;
    ++cycle;
    return true;
  });
  Executor executor(clock, Nanoseconds{1000});
  Value mine;
  ASSERT_EQ(exchange.offer(0, mine, {}), 0);
  std::jthread thread([&](const std::stop_token& stop) {
    Value value;
    executor.run({}, stop, [&](const Cycle& cycle) {
      const bool fresh = exchange.take(cycle.number, value).has_value();
      exchange.publish([&](Values::Result& result) {
        result.cycle = cycle.number;
        result.fresh = fresh;
        result.in = value;
        result.out.set(2 * value.whole());
      });
    });
    exchange.close();
  });
  Values::Result result;
  std::int64_t last = -1;
  std::int64_t held = -1;
  std::int64_t offered_for = 0;
  while (last + 1 < kCycles) {
    ASSERT_TRUE(exchange.next(result));
    ASSERT_EQ(result.cycle, last + 1);
    ASSERT_EQ(result.out.whole(), 2 * result.in.whole());
    ASSERT_EQ(result.in.whole(), result.fresh ? result.cycle : held);
    held = result.in.whole();
    last = result.cycle;
    if (last < offered_for) continue;
    offered_for = last + 1;
    mine.set(offered_for);
    for (std::int64_t first = 0; (first = exchange.offer(offered_for, mine, {})) != offered_for; offered_for = first)
      mine.set(first);
  }
  EXPECT_EQ(exchange.lost(), 0u);
}

}  // namespace
}  // namespace evc::realtime
