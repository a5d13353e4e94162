#include "base/bit_cursor.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace evc {
namespace {

TEST(BitCursor, FastReaderEqualsTheBitByBitOne) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 20000; ++n) {
    std::vector<std::uint8_t> bytes(random() % 24);
    for (auto& b : bytes) b = static_cast<std::uint8_t>(random());
    const std::size_t bits = random() % (bytes.size() * 8 + 5);
    BitReader fast(bytes, bits);
    BitReader slow(bytes, bits);
    while (!fast.faulty()) {
      const auto width = static_cast<unsigned>(1 + random() % 64);
      ASSERT_EQ(fast.left(), slow.left());
      ASSERT_EQ(fast.read(width, "x"), slow.read_bit_by_bit(width, "x"));
      ASSERT_EQ(fast.position(), slow.position());
      ASSERT_EQ(fast.faulty(), slow.faulty());
    }
    ASSERT_STREQ(fast.failed_on(), "x");
    ASSERT_EQ(fast.left(), 0u);
    ASSERT_EQ(fast.read(1), 0u);
  }
}

TEST(BitCursor, TheBitByBitReaderEndsWhereTheFastOneDoes) {
  const std::array<std::uint8_t, 2> bytes{0xFF, 0xFF};
  BitReader fast(bytes, 12), slow(bytes, 12);
  EXPECT_EQ(fast.read(9), slow.read_bit_by_bit(9));
  EXPECT_EQ(fast.read(4, "x"), 0u);
  EXPECT_EQ(slow.read_bit_by_bit(4, "x"), 0u);
  EXPECT_TRUE(fast.faulty() && slow.faulty());
  EXPECT_STREQ(fast.failed_on(), slow.failed_on());
  EXPECT_EQ(fast.position(), slow.position());
}

TEST(BitCursor, WriterAndReaderAgree) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 5000; ++n) {
    std::array<std::uint8_t, 64> bytes{};
    for (auto& b : bytes) b = static_cast<std::uint8_t>(random());
    BitWriter out(bytes);
    std::vector<std::pair<std::uint64_t, unsigned>> written;
    for (;;) {
      const auto width = static_cast<unsigned>(1 + random() % 64);
      const std::uint64_t value = width == 64 ? random() : random() & ((std::uint64_t{1} << width) - 1);
      if (out.position() + width > 512) break;
      out.write(value, width);
      written.emplace_back(value, width);
    }
    ASSERT_FALSE(out.faulty());
    BitReader in(out.bytes(), out.position());
    for (const auto& [value, width] : written) ASSERT_EQ(in.read(width), value);
    ASSERT_EQ(in.left(), 0u);
  }
}

TEST(BitCursor, Patch) {
  std::array<std::uint8_t, 4> bytes{};
  BitWriter out(bytes);
  out.write(0, 5);
  out.write(0, 9);
  out.write(3, 2);
  out.patch(5, 0x155, 9);
  BitReader in(bytes, 16);
  EXPECT_EQ(in.read(5), 0u);
  EXPECT_EQ(in.read(9), 0x155u);
  EXPECT_EQ(in.read(2), 3u);
  out.patch(10, 0, 9);  // not written yet
  EXPECT_TRUE(out.faulty());
  out.write(1, 1);
  EXPECT_EQ(out.position(), 16u);
}

TEST(BitCursor, Seek) {
  const std::array<std::uint8_t, 2> bytes{0x12, 0x34};
  BitReader in(bytes);
  EXPECT_TRUE(in.has(16));
  EXPECT_FALSE(in.has(17));
  in.seek(4);
  EXPECT_EQ(in.read(8), 0x23u);
  in.seek(17, "far");
  EXPECT_TRUE(in.faulty());
  EXPECT_STREQ(in.failed_on(), "far");
  in.fail("later");
  EXPECT_STREQ(in.failed_on(), "far");
  EXPECT_EQ(BitReader(bytes, 16, 20).left(), 0u);
  EXPECT_EQ(BitReader({}, 0).window(), 0u);
}

}  // namespace
}  // namespace evc
