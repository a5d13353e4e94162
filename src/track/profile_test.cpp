#include "track/profile.h"

#include <gtest/gtest.h>

#include "track/testing.h"

namespace evc::track {
namespace {

using namespace testing;

TEST(Profile, NewDataReplaceFromTheirStartOn) {
  GradientProfile p;
  ASSERT_TRUE(p.replace_from(slopes({{0, 1}, {100, 2}, {200, 3}})));
  ASSERT_TRUE(p.replace_from(slopes({{150, 7}})));
  ASSERT_EQ(p.steps.size(), 3u);
  EXPECT_EQ(p.at(at(149))->permille, 2);
  EXPECT_EQ(p.at(at(150))->permille, 7);
  EXPECT_EQ(p.at(at(1e6))->permille, 7);
  EXPECT_FALSE(p.at(at(-1)));
  EXPECT_TRUE(p.replace_from(NewGradientProfile{}));
  EXPECT_EQ(p.steps.size(), 3u);
}

TEST(Profile, CutEndsItAndSaysWhetherAnythingStoodThere) {
  GradientProfile p;
  EXPECT_FALSE(p.cut(at(0)));
  ASSERT_TRUE(p.replace_from(slopes({{0, 1}, {100, 2}, {200, Gradient::kUnknown}})));
  EXPECT_FALSE(p.cut(at(200)));
  EXPECT_TRUE(p.cut(at(150)));
  EXPECT_FALSE(p.at(at(150)));
  EXPECT_EQ(p.at(at(149))->permille, 2);
  EXPECT_TRUE(p.cut(at(100)));
  EXPECT_FALSE(p.at(at(100)));
  EXPECT_TRUE(p.cut(at(0)));
  EXPECT_TRUE(p.empty());
}

TEST(Profile, HolesAndEndsAreNoCover) {
  GradientProfile p;
  EXPECT_FALSE(p.covers(at(0), at(1)));
  ASSERT_TRUE(p.replace_from(slopes({{0, 1}, {100, Gradient::kUnknown}, {150, 2}, {300, Gradient::kUnknown}})));
  EXPECT_TRUE(p.covers(at(0), at(100)));
  EXPECT_FALSE(p.covers(at(0), at(101)));
  EXPECT_FALSE(p.covers(at(99), at(160)));
  EXPECT_FALSE(p.covers(at(120), at(160)));
  EXPECT_TRUE(p.covers(at(150), at(300)));
  EXPECT_FALSE(p.covers(at(-1), at(50)));
  EXPECT_FALSE(p.covers(at(150), at(301)));
}

TEST(Profile, StoredAndNewTogether) {
  GradientProfile p;
  ASSERT_TRUE(p.replace_from(slopes({{0, 1}, {200, Gradient::kUnknown}})));
  EXPECT_TRUE(covers_together(p, slopes({{150, 2}, {400, Gradient::kUnknown}}), at(10), at(400)));
  EXPECT_FALSE(covers_together(p, slopes({{250, 2}, {400, Gradient::kUnknown}}), at(10), at(400)));
  EXPECT_FALSE(covers_together(p, slopes({{150, 2}, {300, Gradient::kUnknown}}), at(10), at(400)));
  EXPECT_TRUE(covers_together(p, slopes({{5, 2}}), at(10), at(400)));
  EXPECT_TRUE(covers_together(p, slopes({{500, 2}}), at(10), at(200)));
  EXPECT_TRUE(covers_together(p, NewGradientProfile{}, at(10), at(200)));
  EXPECT_FALSE(covers_together(p, NewGradientProfile{}, at(10), at(201)));
}

TEST(Profile, AFullOneEndsAtItsLastStep) {
  Profile<Gradient, 3> p;
  EXPECT_TRUE(p.append(at(0), Gradient{1}));
  EXPECT_TRUE(p.append(at(10), Gradient{2}));
  EXPECT_FALSE(p.append(at(5), Gradient{2})) << "out of order";
  EXPECT_TRUE(p.append(at(20), Gradient{3}));
  EXPECT_FALSE(p.append(at(30), Gradient{4}));
  EXPECT_TRUE(p.covers(at(0), at(20)));
  EXPECT_FALSE(p.covers(at(0), at(21))) << "what there is no room for is not known";
}

TEST(Profile, ThereIsAlwaysRoomForNothing) {
  Profile<Gradient, 3> p;
  EXPECT_TRUE(p.has_room_for(NewGradientProfile{}));
  while (!p.steps.full()) ASSERT_TRUE(p.append(at(0), Gradient{1}));
  EXPECT_TRUE(p.has_room_for(NewGradientProfile{}));
}

TEST(Profile, KeepsTheStepAcrossTheLimit) {
  GradientProfile p;
  ASSERT_TRUE(p.replace_from(slopes({{0, 1}, {100, 2}, {200, 3}})));
  p.forget_before(at(150));
  ASSERT_EQ(p.steps.size(), 2u);
  EXPECT_EQ(p.steps.front().from, at(100));
  p.forget_before(at(1000));
  EXPECT_EQ(p.steps.size(), 1u);
}

TEST(Profile, AnElementWithoutLengthCounts) {
  StaticSpeedProfile p;
  ASSERT_TRUE(p.replace_from(ssp({{0, 100}, {50, 40}, {50, 80}})));
  EXPECT_EQ(p.steps.size(), 3u);
  EXPECT_EQ(p.at(at(50))->V_STATIC, 16);
}

// 3.11.3.2: the table of choices, basic speed 100 km/h.
struct Choice {
  std::uint8_t NC_CDTRAIN;
  std::uint16_t NC_TRAIN;
  int expected_kmh;
};
StaticSpeed element(int cd100, int cd130, int cd165, int passenger, int Q_DIFF) {
  StaticSpeed e;
  e.V_STATIC = 20;
  if (cd100) e.cd[1] = static_cast<SpeedCode>(cd100 / 5);
  if (cd130) e.cd[2] = static_cast<SpeedCode>(cd130 / 5);
  if (cd165) e.cd[4] = static_cast<SpeedCode>(cd165 / 5);
  if (passenger) e.other[2] = static_cast<SpeedCode>(passenger / 5);
  if (Q_DIFF == 1) e.replaces_cd = 4;
  return e;
}
int kmh(const StaticSpeed& e, std::uint8_t cd, std::uint16_t other) { return e.speed_for({cd, other, 0}) * 5; }

TEST(StaticSpeed, SpeedForTheTrain) {
  EXPECT_EQ(kmh(element(0, 120, 0, 0, 0), 2, 0), 120);
  EXPECT_EQ(kmh(element(0, 120, 0, 0, 0), 2, 4), 120);
  EXPECT_EQ(kmh(element(0, 120, 0, 0, 0), 1, 0), 100) << "the basic speed stands below every class";
  EXPECT_EQ(kmh(element(110, 0, 140, 0, 0), 2, 0), 110) << "highest lower class";
  EXPECT_EQ(kmh(element(0, 120, 0, 90, 2), 2, 4), 90);
  EXPECT_EQ(kmh(element(0, 120, 0, 90, 2), 2, 1), 120) << "another category";
  EXPECT_EQ(kmh(element(0, 120, 0, 150, 1), 2, 4), 150) << "replaces the cant deficiency speed";
  EXPECT_EQ(kmh(element(0, 120, 0, 150, 2), 2, 4), 120);
}

TEST(AxleLoad, LowestOfTheCategoriesUpToTheTrains) {
  AxleLoadRestriction e;
  e.V_AXLELOAD[4] = 16;
  e.V_AXLELOAD[7] = 12;
  EXPECT_EQ(e.speed_for({0, 0, 3}), kNoSpeed);
  EXPECT_EQ(e.speed_for({0, 0, 4}), 16);
  EXPECT_EQ(e.speed_for({0, 0, 12}), 12);
}

}  // namespace
}  // namespace evc::track
