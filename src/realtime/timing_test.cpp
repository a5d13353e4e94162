#include "realtime/timing.h"

#include <gtest/gtest.h>

#include <limits>

namespace evc::realtime {
namespace {

TEST(Times, OfNoneAreZero) {
  const Times times;
  EXPECT_EQ(times.count(), 0u);
  EXPECT_EQ(times.max(), Nanoseconds{0});
  EXPECT_EQ(times.share(0.5), Nanoseconds{0});
}

/// Never too low, at most 1/16 too high.
TEST(Times, AShareIsOfItsClass) {
  for (std::int64_t t = 1; t < 4'000'000'000'000'000'000; t = t + t / 3 + 1) {
    Times times;
    times.add(Nanoseconds{t});
    times.add(Nanoseconds{std::numeric_limits<std::int64_t>::max()});
    const std::int64_t half = times.share(0.5).count();
    EXPECT_GE(half, t);
    EXPECT_LE(half - t, t / 16) << t;
  }
}

TEST(Times, SharesOfAThousand) {
  Times times;
  for (int us = 1; us <= 1000; ++us) times.add(std::chrono::microseconds(us));
  EXPECT_EQ(times.count(), 1000u);
  EXPECT_EQ(times.max(), Nanoseconds{std::chrono::microseconds(1000)});
  EXPECT_NEAR(static_cast<double>(times.share(0.5).count()), 500e3, 500e3 / 16);
  EXPECT_NEAR(static_cast<double>(times.share(0.999).count()), 999e3, 999e3 / 16);
  EXPECT_EQ(times.share(1.0), times.max());
}

/// A clock that falls is none: a time before zero counts as zero.
TEST(Times, NoneIsBelowZero) {
  Times times;
  times.add(Nanoseconds{-5});
  EXPECT_EQ(times.share(1.0), Nanoseconds{0});
}

}  // namespace
}  // namespace evc::realtime
