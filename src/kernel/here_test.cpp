#include "kernel/here.h"

#include <gtest/gtest.h>

#include <memory>

namespace evc::kernel {
namespace {

// 4.4.6.1.4, 4.4.7.1.6, 4.4.8.1.3, 4.4.15.1.3, 4.4.20.1.4.
TEST(Here, TheEngineCountsWhereNoTrainDataDo) {
  const auto state = std::make_unique<State>();
  state->L_engine = 20_m;
  state->train.L_TRAIN = 300_m;
  const auto length = [&](Mode mode, DataStatus status) {
    state->mode = mode;
    state->data.train_data_status = status;
    return length_of(*state);
  };
  for (const Mode mode : {Mode::SH, Mode::SL, Mode::NL, Mode::PS})
    EXPECT_EQ(length(mode, DataStatus::valid), 20_m) << static_cast<int>(mode);
  for (const Mode mode : {Mode::SB, Mode::FS, Mode::LS, Mode::OS, Mode::SR, Mode::UN, Mode::TR, Mode::PT, Mode::RV})
    EXPECT_EQ(length(mode, DataStatus::valid), 300_m) << static_cast<int>(mode);
  EXPECT_EQ(length(Mode::SB, DataStatus::invalid), 20_m);
  EXPECT_EQ(length(Mode::SB, DataStatus::unknown), 20_m);
  EXPECT_EQ(length(Mode::FS, DataStatus::invalid), 300_m) << "changed by another source (5.17)";
  const track::Here train = here(*state);
  EXPECT_EQ((train.min_safe_front - train.min_safe_rear), 300_m);
}

}  // namespace
}  // namespace evc::kernel
