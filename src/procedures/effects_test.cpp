#include "procedures/effects.h"

#include <gtest/gtest.h>

#include <vector>

namespace evc::procedures {
namespace {

TEST(Effects, Are_joined) {
  Effects a, b;
  a.requests.add(Ack::OS);
  b.send.add(Send::train_data);
  a |= b;
  EXPECT_TRUE(a.requests.has(Ack::OS) && a.send.has(Send::train_data));
  EXPECT_EQ(Set<Ack>::of_bits(0b101), (Set<Ack>{Ack::OS, Ack::SH}));
  EXPECT_EQ((Set<Ack>{Ack::OS, Ack::SH}).bits(), 0b101u);
  EXPECT_EQ(Set<Ack>::of_bits(~0u).bits(), (1u << 12) - 1u);
}

TEST(Repetition, Four_sendings_fifteen_seconds_apart_then_the_end) {
  Repetition r;
  r.start(Duration{0.0});
  std::vector<double> sent;
  for (double t = 0.0; t < 100.0; t += 1.0) {
    const Repetition::Due due = r.due(Duration{t});
    if (due == Repetition::Due::send_again) sent.push_back(t);
    if (due == Repetition::Due::give_up) {
      EXPECT_EQ(t, 60.0);
      break;
    }
  }
  EXPECT_EQ(sent, (std::vector<double>{15.0, 30.0, 45.0}));
  EXPECT_EQ(r.due(Duration{200.0}), Repetition::Due::nothing);
}

}  // namespace
}  // namespace evc::procedures
