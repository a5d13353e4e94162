#include "cluster/ranks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// How cases are distributed: on a clock of the test, without MPI.
namespace evc::cluster {
namespace {

using std::chrono::milliseconds;

TEST(Supply, two_for_each_thread_at_the_beginning) {
  const auto now = Supply::Clock::now();
  Supply supply(3, now);
  EXPECT_EQ(supply.missing(now), 6U);
  supply.granted(6);
  EXPECT_EQ(supply.missing(now + milliseconds(1)), 0U);
}

TEST(Supply, grows_to_a_tenth_of_a_second_and_follows_the_cases) {
  auto now = Supply::Clock::now();
  Supply supply(1, now);
  std::uint64_t held = 0, largest = 0;
  // A case takes 1 ms.
  for (int i = 0; i < 500; ++i, now += milliseconds(1)) {
    const std::uint64_t asked = supply.missing(now);
    supply.granted(asked);
    held += asked;
    largest = std::max(largest, held);
    ASSERT_GE(held, 1U) << "nothing at hand after " << i << " ms";
    supply.finished(1);
    --held;
  }
  EXPECT_GE(largest, 80U);
  EXPECT_LE(largest, 110U);
  // From now on 50 ms: what was at hand is computed, then there are few.
  for (int i = 0; i < 300; ++i, now += milliseconds(50)) {
    const std::uint64_t asked = supply.missing(now);
    supply.granted(asked);
    held += asked;
    ASSERT_GE(held, 1U);
    supply.finished(1);
    --held;
  }
  EXPECT_LE(held, 2U);
}

// Ranks of unequal speed, cases of one length: all end within a few cases of one another, and all cases are granted.
TEST(Granted, all_ranks_end_together) {
  struct Rank {
    double case_ms, free_at_ms = 0.0;
  };
  std::vector<Rank> ranks{{1.0}, {1.0}, {2.5}, {0.7}};
  std::uint64_t left = 5000, computed = 0;
  while (left > 0) {
    Rank& next =
        *std::min_element(ranks.begin(), ranks.end(), [](auto& a, auto& b) { return a.free_at_ms < b.free_at_ms; });
    const std::uint64_t granted = granted_of(left, 100, ranks.size());
    ASSERT_GE(granted, 1U);
    ASSERT_LE(granted, left);
    left -= granted;
    computed += granted;
    next.free_at_ms += next.case_ms * static_cast<double>(granted);
  }
  EXPECT_EQ(computed, 5000U);
  const auto [first, last] =
      std::minmax_element(ranks.begin(), ranks.end(), [](auto& a, auto& b) { return a.free_at_ms < b.free_at_ms; });
  EXPECT_LT(last->free_at_ms - first->free_at_ms, 6.0);
}

}  // namespace
}  // namespace evc::cluster
