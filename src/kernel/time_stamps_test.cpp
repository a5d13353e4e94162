#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/bit_cursor.h"
#include "base/test_units.h"
#include "kernel/evc.h"
#include "kernel/state.h"
#include "lang/encode.h"
#include "lang/messages.h"
#include "lang/testing.h"
#include "radio/messages.h"

// The clock of the unit overflows after 497 days, in the middle of a session (3.16.3.2.3).
namespace evc::kernel {
namespace {

using evc::test::at;

/// A train at a standstill in FS, level 2, with a session since 10 s before the overflow.
class Overflow : public ::testing::Test {
 protected:
  Overflow() {
    power_up(*state, *derived, Config{});
    in.train.desk_open = true;
    for (; now < 1.0; now += 0.1) cycle();
    now = overflow() - 10.0;
    cycle();
    state->mode = Mode::FS;
    state->level.level = Level::L2;
    state->national_values.T_NVCONTACT = {{8.0}};
    state->national_values.M_NVCONTACT = Reaction::trip;
    track::MovementAuthority authority;
    EXPECT_TRUE(authority.sections.push_back({.begin = at(-10.0), .end = at(2000.0)}));
    state->track.ma = authority;
    EXPECT_TRUE(state->track.ssp.append(at(-1000.0), {}));
    EXPECT_TRUE(state->track.gradient.append(at(-1000.0), {0}));
    radio::Session& session = state->radio.supervising.session;
    session.phase = radio::Phase::up;
    session.rbc = {1, 10, 1010};
    session.M_VERSION = lang::testing::M_VERSION_2_1;
  }
  /// The code after the last one is that of 0 s: 0xFFFF'FFFF is "unknown" (7.5.1.154).
  static double overflow() { return 0xFFFF'FFFF / 100.0; }
  void cycle(const std::vector<std::uint8_t>& message = {}) {
    const RadioMessage messages[]{{message}};
    if (!message.empty()) in.radio_messages = messages;
    in.now = {now};
    step(*state, *derived, in, *out);
    in.radio_messages = {};
  }
  /// A message 24 that asks for an acknowledgement. Returns the stamp that the acknowledgement names.
  std::optional<std::uint32_t> acknowledged(std::uint32_t T_TRAIN) {
    lang::Message24 m;
    m.M_ACK.raw = 1;
    m.T_TRAIN.raw = T_TRAIN;
    m.NID_LRBG.raw = radio::kUnknownLrbg;
    std::vector<std::uint8_t> bytes(64);
    BitWriter writer(bytes);
    lang::encode_message(writer, m);
    bytes.resize(writer.position() / 8);
    cycle(bytes);
    for (const OutgoingMessage& sent : out->radio_out)
      if (sent.bytes[0] == 146) {
        BitReader reader(sent.bytes);
        (void)reader.read(8 + 10);
        own_stamps.push_back(static_cast<std::uint32_t>(reader.read(32)));
        (void)reader.read(24);
        return static_cast<std::uint32_t>(reader.read(32));
      }
    return {};
  }

  std::unique_ptr<State> state = std::make_unique<State>();
  std::unique_ptr<Derived> derived = std::make_unique<Derived>();
  std::unique_ptr<Outputs> out = std::make_unique<Outputs>();
  Inputs in;
  double now = 0.0;
  std::vector<std::uint32_t> own_stamps;
};

TEST_F(Overflow, OfTheClockHasNoEffectOnASession) {
  for (double t = -9.0; t <= 9.0; t += 1.0) {
    now = overflow() + t;
    const auto stamp = static_cast<std::uint32_t>(t < 0.0 ? 0xFFFF'FFFF + t * 100.0 : t * 100.0);
    EXPECT_EQ(acknowledged(stamp), stamp) << t;
    EXPECT_EQ(out->mode, Mode::FS) << t;
  }
  ASSERT_EQ(own_stamps.size(), 19u);
  EXPECT_EQ(own_stamps.front(), 0xFFFF'FFFFu - 900u);
  EXPECT_EQ(own_stamps.back(), 900u);
}

TEST_F(Overflow, AMessageOfBeforeItComesTooLateAfterIt) {
  now = overflow() + 1.0;
  EXPECT_EQ(acknowledged(100), 100u);
  now += 1.0;
  EXPECT_FALSE(acknowledged(0xFFFF'FFF0));
}

TEST_F(Overflow, TheContactCountsAcrossIt) {
  now = overflow() - 4.0;
  EXPECT_TRUE(acknowledged(0xFFFF'FFFF - 400));
  for (double t = -3.0; t < 4.0; t += 1.0) {
    now = overflow() + t;
    cycle();
    EXPECT_EQ(out->mode, Mode::FS) << t;
  }
  for (double t = 4.5; t < 6.0; t += 0.5) {
    now = overflow() + t;
    cycle();
  }
  EXPECT_EQ(out->mode, Mode::TR);
}

}  // namespace
}  // namespace evc::kernel
