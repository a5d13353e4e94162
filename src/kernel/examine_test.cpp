#include "kernel/examine.h"

#include <gtest/gtest.h>

#include <memory>

#include "kernel/state.h"

namespace evc::kernel {
namespace {

struct Twin {
  State state;
  Derived derived;
  Outputs outputs;
};

TEST(Examine, is_a_cycle_as_any_other_and_says_what_it_decided_on) {
  const auto stepped = std::make_unique<Twin>(), examined = std::make_unique<Twin>();
  const auto seen = std::make_unique<Examined>();
  power_up(stepped->state, stepped->derived, Config{});
  power_up(examined->state, examined->derived, Config{});
  Inputs in;
  for (int n = 0; n < 20; ++n) {
    in.now = Duration{0.1 * n};
    in.train.desk_open = n >= 10;
    in.train.sleeping = n == 15;
    in.train.powered = n != 17;
    step(stepped->state, stepped->derived, in, stepped->outputs);
    const Mode before = examined->state.mode;
    examine(examined->state, examined->derived, in, examined->outputs, *seen);
    const procedures::Facts& facts = seen->facts;
    EXPECT_EQ(seen->deciding.now, in.now) << n;
    EXPECT_EQ(seen->deciding.mode, before) << n;
    EXPECT_EQ(stepped->outputs.mode, examined->outputs.mode) << n;
    EXPECT_EQ(stepped->outputs.events, examined->outputs.events) << n;
    EXPECT_EQ(stepped->outputs.brake_reasons, examined->outputs.brake_reasons) << n;
    EXPECT_EQ(stepped->outputs.enabled, examined->outputs.enabled) << n;
    EXPECT_EQ(stepped->state.mode, examined->state.mode) << n;
    EXPECT_EQ(stepped->state.revision, examined->state.revision) << n;
    EXPECT_EQ(facts.desk_open, n >= 10) << n;
    EXPECT_EQ(facts.sleeping, n == 15) << n;
    EXPECT_EQ(facts.powered, n != 17) << n;
    EXPECT_EQ(examined->outputs.mode, n == 17 ? Mode::NP : Mode::SB) << n;
  }
}

}  // namespace
}  // namespace evc::kernel
