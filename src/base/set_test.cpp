#include "base/set.h"

#include <gtest/gtest.h>

namespace evc {
namespace {

enum class Full : std::uint8_t { first, second, at_31 = 31, at_32, last = 63, count };
enum class Three : std::uint8_t { a, b, c, count };

/// Constants: a shift by too many bits would not compile.
TEST(Set, HoldsSixtyFour) {
  constexpr Set<Full> all = Set<Full>::of_bits(~std::uint64_t{0});
  static_assert(all.bits() == ~std::uint64_t{0});
  static_assert(all.has(Full::first) && all.has(Full::at_31) && all.has(Full::at_32) && all.has(Full::last));
  constexpr Set<Full> upper{Full::at_32, Full::last};
  static_assert(upper.bits() == 0x8000000100000000u && Set<Full>::of_bits(upper.bits()) == upper);
  EXPECT_EQ(upper.bits() >> 32, 0x80000001u);
  EXPECT_TRUE(Set<Full>::of_bits(0).empty());
}

TEST(Set, BitsOfNoEnumeratorAreLeftOut) {
  EXPECT_EQ(Set<Three>::of_bits(~std::uint64_t{0}), (Set<Three>{Three::a, Three::b, Three::c}));
  EXPECT_EQ(Set<Three>::of_bits(0xFFFFFFF8u).bits(), 0u);
}

}  // namespace
}  // namespace evc
