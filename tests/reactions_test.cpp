// The reactions with a time limit of SUBSET-041 in simulated time; `make reactions` measures them by the clock too.
#include "../bench/reactions.h"

#include <gtest/gtest.h>

#include "base/test_paths.h"

namespace {

/// Each comes in the cycle behind its event. That leaves the rest of the limit to antenna, radio, train and display.
TEST(Reactions, ComeInTheNextCycleWhateverThePhase) {
  const auto all = evc::bench::reactions(evc::test::source_folder() + "/data/lines/brunnental.json");
  ASSERT_EQ(all.size(), 5u);
  for (const int cycle_ms : {10, 100})
    for (const evc::bench::Reaction& r : all) {
      const auto longest = evc::bench::longest_simulated(r, cycle_ms);
      ASSERT_TRUE(longest) << r.what;
      EXPECT_LT(*longest, r.limit_s) << r.what;
      // The lowest speed bounds the place at the end of authority: it is passed a little later than by the speed.
      EXPECT_LE(*longest, 1.03 * cycle_ms / 1000.0) << r.what;
      EXPECT_GE(*longest, 0.9 * cycle_ms / 1000.0) << r.what;
    }
}

}  // namespace
