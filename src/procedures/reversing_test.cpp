#include "procedures/reversing.h"

#include <gtest/gtest.h>

#include "base/test_units.h"

namespace evc::procedures {
namespace {

using evc::test::at;

TEST(Reversing, Possible_at_standstill_in_the_area) {
  reversing::Inputs in;
  EXPECT_FALSE(step(in).possible);
  in.stored = reversing::Area{at(100.0), at(300.0)};
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
  for (const Mode mode : {Mode::SR, Mode::RV}) {
    in.mode = mode;
    EXPECT_FALSE(step(in).possible);
  }
}

}  // namespace
}  // namespace evc::procedures
