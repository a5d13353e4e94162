#include "kernel/intake/national_values.h"

#include <gtest/gtest.h>

#include "lang/packets/packet_3.h"

namespace evc::kernel {
namespace {

/// A packet 3 with seven steps of Kr_int, of which five find room.
lang::Packet3 with_seven_steps(std::uint8_t lowest_at) {
  lang::Packet3 p;
  p.Q_NVKINT.raw = 1;
  p.M_NVKRINT.raw = 20;
  for (std::uint8_t i = 1; i < 7; ++i) {
    lang::Packet3_kr_steps step;
    step.L_NVKRINT.raw = i;
    step.M_NVKRINT.raw = i == lowest_at ? 10 : static_cast<std::uint8_t>(18 - i);  // equal ones would join
    EXPECT_TRUE(p.kr_steps.push_back(step));
  }
  return p;
}

TEST(NationalValues, MoreStepsThanThereIsRoomForGiveTheLowestEverywhere) {  // 3.13.2.3.7.11
  for (const std::uint8_t lowest_at : {std::uint8_t{1}, std::uint8_t{6}}) {
    const train::NationalValues nv = read(with_seven_steps(lowest_at)).values;
    ASSERT_EQ(nv.Kr_int.size(), 1u);
    EXPECT_DOUBLE_EQ(nv.Kr_int.steps.front().value, 0.5);
    EXPECT_EQ(nv.Kr_int.steps.front().from, Distance{});
  }
}

TEST(NationalValues, StepsThatFindRoomStayAsTheyAre) {
  lang::Packet3 p = with_seven_steps(2);
  while (p.kr_steps.size() > 4) p.kr_steps.pop_back();
  const train::NationalValues nv = read(p).values;
  ASSERT_EQ(nv.Kr_int.size(), 5u);
  EXPECT_DOUBLE_EQ(nv.Kr_int.steps[0].value, 1.0);
  EXPECT_DOUBLE_EQ(nv.Kr_int.steps[2].value, 0.5);
}

}  // namespace
}  // namespace evc::kernel
