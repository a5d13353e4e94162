#include "lang/telegram.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lang/decode.h"
#include "lang/encode.h"
#include "lang/packets/packet_45.h"
#include "lang/packets/packet_5.h"
#include "lang/si.h"

namespace evc::lang {
namespace {

std::vector<std::uint8_t> from_hex(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi((hex + "0").substr(i, 2), nullptr, 16)));
  return bytes;
}

TEST(Telegram, OfARealLine) {
  const auto bytes = from_hex("9002FFB540B00B501790210FFF8");
  const TelegramView t = scan_telegram(bytes, 105);
  ASSERT_EQ(t.fault, Fault::none) << text_of(t.fault) << t.at.bit;
  EXPECT_EQ(t.sv, (SystemVersion{1, 0}));
  EXPECT_EQ(t.NID_BG.raw, 352);
  ASSERT_EQ(t.packets.size(), 1u);
  EXPECT_EQ(t.packets[0].NID_PACKET, 45);
  Packet45 p;
  ASSERT_EQ(decode(t.packets[0], p), Fault::none);
  EXPECT_EQ(p.NID_MN.raw, 2114079u);
  Packet5 linking;
  EXPECT_EQ(decode(t.packets[0], linking), Fault::not_a_packet_of_this_kind);
}

}  // namespace
}  // namespace evc::lang
