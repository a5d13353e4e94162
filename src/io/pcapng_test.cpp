#include "io/pcapng.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "lang/telegram.h"

namespace evc::io {
namespace {

std::uint32_t little(const std::string& s, std::size_t at, unsigned bytes = 4) {
  std::uint32_t n = 0;
  for (unsigned i = bytes; i > 0; --i) n = (n << 8) | static_cast<unsigned char>(s[at + i - 1]);
  return n;
}
std::uint32_t network(const std::string& s, std::size_t at, unsigned bytes) {
  std::uint32_t n = 0;
  for (unsigned i = 0; i < bytes; ++i) n = (n << 8) | static_cast<unsigned char>(s[at + i]);
  return n;
}

TEST(Pcapng, Blocks) {
  std::string out;
  Pcapng trace(out);
  ASSERT_EQ(out.size(), 48u);
  EXPECT_EQ(little(out, 0), 0x0A0D0D0Au);
  EXPECT_EQ(little(out, 8), 0x1A2B3C4Du);
  EXPECT_EQ(little(out, 28), 1u);
  EXPECT_EQ(little(out, 36, 2), 228u);
  const std::array<std::uint8_t, 5> bits{0x90, 0x02, 0xFF, 0xB5, 0x40};
  trace.append(out, Pcapng::Port::balise, lang::Direction::to_train, bits);
  // Every block has its length at both ends, a multiple of four.
  std::size_t at = 0;
  std::vector<std::uint32_t> types;
  while (at < out.size()) {
    types.push_back(little(out, at));
    const std::uint32_t length = little(out, at + 4);
    ASSERT_EQ(length % 4, 0u);
    ASSERT_EQ(little(out, at + length - 4), length);
    at += length;
  }
  EXPECT_EQ(at, out.size());
  EXPECT_EQ(types, (std::vector<std::uint32_t>{0x0A0D0D0A, 1, 6}));
  const std::size_t ip = 48 + 28;
  EXPECT_EQ(little(out, 48 + 20), 20u + 8 + 5);
  EXPECT_EQ(network(out, ip + 2, 2), 20u + 8 + 5);
  EXPECT_EQ(network(out, ip + 22, 2), 50030u);
  EXPECT_EQ(network(out, ip + 24, 2), 8u + 5);
  // The checksum makes the header's sum all ones.
  std::uint32_t sum = 0;
  for (unsigned i = 0; i < 20; i += 2) sum += network(out, ip + i, 2);
  while (sum >> 16 != 0) sum = (sum & 0xFFFF) + (sum >> 16);
  EXPECT_EQ(sum, 0xFFFFu);
  EXPECT_EQ(static_cast<unsigned char>(out[ip + 28]), 0x90);
}

TEST(Pcapng, VersionComesFirst) {
  std::string out;
  Pcapng trace(out);
  trace.append_version(out, {1, 0});
  const std::size_t ip = 48 + 28;
  EXPECT_EQ(network(out, ip + 24, 2), 8u + 11);
  std::vector<std::uint8_t> message(out.begin() + static_cast<std::ptrdiff_t>(ip + 28),
                                    out.begin() + static_cast<std::ptrdiff_t>(ip + 28 + 11));
  const lang::MessageToTrainView view = lang::scan_message_to_train(message, {1, 0});
  EXPECT_EQ(view.fault, lang::Fault::none);
  EXPECT_EQ(view.NID_MESSAGE, 32);
  EXPECT_NE(out.find("added: the system version"), std::string::npos);
  trace.append(out, Pcapng::Port::radio, lang::Direction::to_track, message);
  // The second frame is in the other direction, a millisecond later.
  const std::size_t second = 48 + little(out, 48 + 4);
  EXPECT_EQ(little(out, second + 16), 1000u);
  EXPECT_EQ(network(out, second + 28 + 12, 4), 0x0A1A0002u);
}

}  // namespace
}  // namespace evc::io
