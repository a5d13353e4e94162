#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "dmi/test_display.h"

namespace evc::dmi {
namespace {

/// The texts of the one gradient of a planning area of 4000 m, from above.
std::vector<Item> texts_of_gradient(double from_m, double to_m, std::int16_t permille) {
  port::Display display = test::neutral(Mode::FS);
  display.planning.EOA = Distance{4000.0};
  (void)display.planning.speeds.push_back({Distance{0.0}, Speed{30.0}, {}});
  (void)display.planning.gradients.push_back({Distance{from_m}, Distance{to_m}, permille});
  State state;
  show(state, display);
  std::vector<Item> texts;
  for (const Item& item : test::drawn(state).items)
    if (item.kind == Kind::text && item.area == Area::D5) texts.push_back(item);
  std::stable_sort(texts.begin(), texts.end(), [](const Item& a, const Item& b) { return a.at.y < b.at.y; });
  return texts;
}

/// 015560 8.3.5.6 to 8.3.5.8: signs at both ends and the number between them, as far as there is room.
TEST(Planning, SignsAndNumberOfAGradientDoNotTouch) {
  std::size_t most = 0, ones = 0;
  for (const std::int16_t permille : {std::int16_t{12}, std::int16_t{-7}, std::int16_t{0}})
    for (double to_m = 510.0; to_m <= 4000.0; to_m += 10.0) {
      const std::vector<Item> texts = texts_of_gradient(500.0, to_m, permille);
      most = std::max(most, texts.size());
      if (texts.size() == 1 && permille != 0) {
        ++ones;
        EXPECT_EQ(texts[0].text.view(), permille > 0 ? "+" : "-") << to_m;
      }
      for (std::size_t n = 1; n < texts.size(); ++n)
        EXPECT_GE(texts[n].at.y, texts[n - 1].at.y + texts[n - 1].at.h) << to_m << " m, " << permille;
    }
  EXPECT_EQ(most, 3U);
  EXPECT_GT(ones, 0U);
}

}  // namespace
}  // namespace evc::dmi
