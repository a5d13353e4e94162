#include "procedures/reversing.h"

#include <gtest/gtest.h>

namespace evc::procedures {
namespace {

constexpr Place at(double metres) { return Place{Distance{metres}}; }

TEST(Reversing, Possible_at_standstill_in_the_area) {
  reversing::Inputs in;
  EXPECT_FALSE(step(in).possible);
  in.stored = reversing::Reversing{at(100.0), at(300.0), at(300.0), Distance{500.0}, Speed{5.0}};
  in.standstill = true;
  in.est_front = at(200.0);
  EXPECT_TRUE(step(in).possible);
  EXPECT_TRUE(step(in).effects.requests.empty());
  in.controller_backward = true;
  EXPECT_EQ(step(in).effects.requests, Set<Ack>{Ack::RV});
  in.est_front = at(301.0);
  EXPECT_FALSE(step(in).possible);
  in.est_front = at(99.0);
  EXPECT_FALSE(step(in).possible);
  in.est_front = at(200.0);
  in.standstill = false;
  EXPECT_FALSE(step(in).possible);
  in.standstill = true;
  in.mode = Mode::SR;
  EXPECT_FALSE(step(in).possible);
}

TEST(Reversing, The_distance_counts_backwards_from_its_reference) {
  reversing::Inputs in;
  in.mode = Mode::RV;
  in.stored = reversing::Reversing{at(100.0), at(200.0), at(300.0), Distance{500.0}, Speed{5.0}};
  in.est_front = at(-200.0);
  EXPECT_FALSE(step(in).distance_passed);
  in.est_front = at(-200.1);
  EXPECT_TRUE(step(in).distance_passed);
  in.stored->D_REVERSE.reset();
  EXPECT_FALSE(step(in).distance_passed);
}

}  // namespace
}  // namespace evc::procedures
