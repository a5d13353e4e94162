#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/bit_cursor.h"
#include "kernel/evc.h"
#include "kernel/state.h"
#include "lang/encode.h"
#include "lang/packets/packet_239.h"
#include "lang/packets/packet_254.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_76.h"
#include "lang/testing.h"

// What a message of an older version, and of one to come, is to the unit (6.6.3.2.3, 3.17.3.11).
namespace evc::kernel {
namespace {

using lang::testing::M_VERSION_1_0;
using lang::testing::M_VERSION_1_1;
using lang::testing::M_VERSION_2_1;

struct Bits {
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(104, 0);
};
template <class... P>
Bits telegram(std::uint8_t M_VERSION, std::uint8_t N_PIG, const P&... packets) {
  Bits t;
  BitWriter out(t.bytes);
  lang::TelegramHeader header;
  header.M_VERSION.raw = M_VERSION;
  header.N_PIG.raw = N_PIG;
  header.N_TOTAL.raw = 1;
  header.NID_C.raw = 1;
  header.NID_BG.raw = 7;
  lang::begin_telegram(out, header);
  (lang::encode(out, packets), ...);
  lang::end_telegram(out, 830);
  return t;
}

/// The change of traction system that a unit in SR, level 1, takes from a group of two balises.
std::optional<track::TractionChange> traction(const Bits& first, const Bits& second) {
  const Config config;
  const auto state = std::make_unique<State>();
  const auto derived = std::make_unique<Derived>();
  power_up(*state, *derived, config);
  Inputs in;
  Outputs out;
  in.train.desk_open = true;
  for (int cycle = 0; cycle < 10; ++cycle) {
    in.now = {0.1 * cycle};
    step(*state, *derived, in, out);
  }
  state->mode = Mode::SR;
  state->level.level = Level::L1;
  const std::array<BaliseTelegram, 2> read{BaliseTelegram{first.bytes, 830, {{0.0}}},
                                           BaliseTelegram{second.bytes, 830, {{3.0}}}};
  in.balise_telegrams = read;
  in.now = {1.0};
  step(*state, *derived, in, out);
  return state->track.traction;
}

lang::Packet39_v1_0 traction_of_1_0() { return {{2}, {1}, {100}, {1}}; }
lang::Packet239 traction_of_1_1() { return {{2}, {1}, {100}, {1}, {7}}; }

TEST(OlderVersions, ANewerFormAnywhereInTheMessageTakesThePlaceOfTheOlderOne) {
  const Bits older = telegram(M_VERSION_1_0, 1, traction_of_1_0());
  const auto alone = traction(telegram(M_VERSION_1_0, 0), older);
  ASSERT_TRUE(alone);
  EXPECT_EQ(alone->NID_CTRACTION, 10);  // translated, 6.6.3.2.3 [13]
  const auto other_telegram = traction(telegram(M_VERSION_1_1, 0, traction_of_1_1()), older);
  ASSERT_TRUE(other_telegram);
  EXPECT_EQ(other_telegram->NID_CTRACTION, 7);
  const auto same_telegram =
      traction(telegram(M_VERSION_1_1, 0, traction_of_1_1(), traction_of_1_0()), telegram(M_VERSION_1_0, 1));
  ASSERT_TRUE(same_telegram);
  EXPECT_EQ(same_telegram->NID_CTRACTION, 7);
  // One for the other direction takes nothing away.
  lang::Packet239 other = traction_of_1_1();
  other.Q_DIR.raw = 0;
  const auto other_direction = traction(telegram(M_VERSION_1_1, 0, other), older);
  ASSERT_TRUE(other_direction);
  EXPECT_EQ(other_direction->NID_CTRACTION, 10);
}

TEST(OlderVersions, AFixedTextIsIgnored) {  // 6.6.3.1.1.1
  lang::Packet76_v1_0 text;
  text.Q_DIR.raw = 2;
  const Bits change = telegram(M_VERSION_1_0, 1, traction_of_1_0());
  for (const std::uint8_t version : {M_VERSION_1_0, M_VERSION_1_1})
    EXPECT_TRUE(traction(telegram(version, 0, text), change));
  // A spare value in it does not matter either: it is not read.
  text.Q_TEXTCLASS.raw = 3;
  for (const std::uint8_t version : {M_VERSION_1_0, M_VERSION_1_1})
    EXPECT_TRUE(traction(telegram(version, 0, text), change));
}

TEST(OlderVersions, PacketsOfALaterYAreSkipped) {
  const auto unknown = [](std::uint8_t M_VERSION) {
    Bits t = telegram(M_VERSION, 0, lang::Packet254{{2}});
    // NID_PACKET at bit 50 becomes 77.
    t.bytes[6] = static_cast<std::uint8_t>((t.bytes[6] & 0xC0) | 77 >> 2);
    t.bytes[7] = static_cast<std::uint8_t>((t.bytes[7] & 0x3F) | (77 & 3) << 6);
    return t;
  };
  lang::Packet39 change;
  change.Q_DIR.raw = 2;
  change.M_VOLTAGE.raw = 1;
  const Bits known = telegram(M_VERSION_2_1, 1, change);
  EXPECT_TRUE(traction(unknown(34), known));
  EXPECT_FALSE(traction(unknown(M_VERSION_2_1), known));  // inconsistent
}

}  // namespace
}  // namespace evc::kernel
