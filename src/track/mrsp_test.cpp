#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "base/test_units.h"
#include "track/testing.h"

namespace evc::track {
namespace {

using namespace testing;

MrspQuery query(double length = 200.0, double train_max_kmh = 160.0) {
  MrspQuery q;
  q.from = at(-500);
  q.train_length = Distance{length};
  q.category = {2, 0, 0};
  if (!q.limits.push_back({std::nullopt, std::nullopt, Speed{train_max_kmh / 3.6}})) __builtin_trap();
  return q;
}
using evc::test::kmh;

TEST(Mrsp, TrainMaximumWhereNothingElseLimits) {
  const Mrsp f = mrsp(Description{}, query());
  ASSERT_EQ(f.size(), 1u);
  EXPECT_EQ(f.at(at(0)), kmh(160));
  MrspQuery free = query();
  free.limits.clear();
  EXPECT_EQ(mrsp(Description{}, free).at(at(0)), kNoLimit);
}

TEST(Mrsp, RisesOnlyWhenTheRearHasLeft) {
  Description d;
  ASSERT_TRUE(d.ssp.replace_from(ssp({{0, 80}, {1000, 120}, {2000, 140, true}, {3000, 60, true}, {4000, 130}})));
  const Mrsp f = mrsp(d, query(200));
  EXPECT_EQ(f.at(at(999)), kmh(80));
  EXPECT_EQ(f.at(at(1199)), kmh(80));
  EXPECT_EQ(f.at(at(1200)), kmh(120));
  EXPECT_EQ(f.at(at(2199)), kmh(120)) << "the delay belongs to the element that ends";
  EXPECT_EQ(f.at(at(2200)), kmh(140));
  EXPECT_EQ(f.at(at(3000)), kmh(60)) << "a fall is at its place";
  EXPECT_EQ(f.at(at(4000)), kmh(130)) << "Q_FRONT: no delay";
}

TEST(Mrsp, SeveralShortElementsUnderOneTrain) {
  Description d;
  ASSERT_TRUE(d.ssp.replace_from(ssp({{0, 120}, {1000, 40}, {1000, 80}, {1050, 60}, {1080, 140}})));
  const Mrsp f = mrsp(d, query(200));
  EXPECT_EQ(f.at(at(999)), kmh(120));
  EXPECT_EQ(f.at(at(1000)), kmh(40)) << "an element without length still delays";
  EXPECT_EQ(f.at(at(1199)), kmh(40));
  EXPECT_EQ(f.at(at(1200)), kmh(60));
  EXPECT_EQ(f.at(at(1279)), kmh(60));
  EXPECT_EQ(f.at(at(1280)), kmh(140));
}

TEST(Mrsp, LowestOfAllKinds) {
  Description d;
  ASSERT_TRUE(d.ssp.replace_from(ssp({{-1000, 140}, {9000, kEnd}})));
  TemporarySpeedRestriction tsr;
  tsr.from = at(500);
  tsr.to = at(700);
  tsr.V_TSR = 16;
  ASSERT_TRUE(d.tsr.push_back(tsr));
  tsr.from = at(600);
  tsr.to = at(650);
  tsr.V_TSR = 8;
  tsr.Q_FRONT = true;
  ASSERT_TRUE(d.tsr.push_back(tsr));
  AxleLoadRestriction asp;
  asp.from = at(2000);
  asp.to = at(2100);
  asp.V_AXLELOAD[0] = 12;
  ASSERT_TRUE(d.asp.push_back(asp));
  PermittedBrakingDistance pbd;
  pbd.from = at(3000);
  pbd.to = at(3100);
  ASSERT_TRUE(d.pbd.push_back(pbd));
  pbd.from = at(3050);
  ASSERT_TRUE(d.pbd.push_back(pbd));
  LevelCrossing lx;
  lx.from = at(4000);
  lx.to = at(4010);
  lx.unprotected = lx.substituted = true;
  lx.V_LX = 2;
  lx.V_LX_from = at(3900);
  ASSERT_TRUE(d.lx.push_back(lx));
  lx.NID_LX = 1;
  lx.substituted = false;
  lx.from = at(5000);
  lx.to = at(5010);
  ASSERT_TRUE(d.lx.push_back(lx));
  (void)d.signalling.push_back({at(6000), 6, at(6500)});
  MrspQuery q = query(100);
  const std::array<SpeedCode, 2> pbd_speeds{kNoSpeed, 10};
  q.pbd_speeds = pbd_speeds;
  ASSERT_TRUE(q.limits.push_back({at(7000), at(7100), kmh(30)}));
  const Mrsp f = mrsp(d, q);
  EXPECT_EQ(f.at(at(499)), kmh(140));
  EXPECT_EQ(f.at(at(500)), kmh(80));
  EXPECT_EQ(f.at(at(600)), kmh(40));
  EXPECT_EQ(f.at(at(650)), kmh(80));
  EXPECT_EQ(f.at(at(799)), kmh(80));
  EXPECT_EQ(f.at(at(800)), kmh(140));
  EXPECT_EQ(f.at(at(2199)), kmh(60));
  EXPECT_EQ(f.at(at(3040)), kmh(140)) << "its speed is not computed yet";
  EXPECT_EQ(f.at(at(3060)), kmh(50));
  EXPECT_EQ(f.at(at(3100)), kmh(140)) << "no train length delay";
  EXPECT_EQ(f.at(at(3950)), kmh(10));
  EXPECT_EQ(f.at(at(4010)), kmh(140));
  EXPECT_EQ(f.at(at(5005)), kmh(140)) << "a stop is not a speed restriction";
  EXPECT_EQ(f.at(at(6000)), kmh(30));
  EXPECT_EQ(f.at(at(6500)), kmh(140));
  EXPECT_EQ(f.at(at(7000)), kmh(30));
  EXPECT_EQ(f.at(at(9500)), kmh(160)) << "beyond the profile nothing but the train limits";
}

TEST(Mrsp, IsMadeOfWhatIsAskedFor) {
  // 4.5.2: each element alone, and all except one.
  Description d;
  StaticSpeed e;
  e.V_STATIC = 12;
  ASSERT_TRUE(d.ssp.append(at(0), e));
  AxleLoadRestriction asp;
  asp.from = at(0);
  asp.to = at(900);
  asp.V_AXLELOAD[0] = 10;
  ASSERT_TRUE(d.asp.push_back(asp));
  TemporarySpeedRestriction t;
  t.from = at(0);
  t.to = at(900);
  t.V_TSR = 8;
  ASSERT_TRUE(d.tsr.push_back(t));
  PermittedBrakingDistance pbd;
  pbd.from = at(0);
  pbd.to = at(900);
  ASSERT_TRUE(d.pbd.push_back(pbd));
  LevelCrossing lx;
  lx.to = at(900);
  lx.unprotected = lx.substituted = true;
  lx.V_LX = 4;
  lx.V_LX_from = at(0);
  ASSERT_TRUE(d.lx.push_back(lx));
  (void)d.signalling.push_back({at(0), 2, at(900)});
  const std::array<bool MrspElements::*, 6> elements{&MrspElements::ssp, &MrspElements::asp, &MrspElements::tsr,
                                                     &MrspElements::pbd, &MrspElements::lx,  &MrspElements::signalling};
  for (std::size_t i = 0; i < elements.size(); ++i) {
    MrspQuery q = query();
    const std::array<SpeedCode, 1> pbd_speeds{6};
    q.pbd_speeds = pbd_speeds;
    q.category.M_AXLELOADCAT = 5;
    q.elements = {false, false, false, false, false, false};
    EXPECT_EQ(mrsp(d, q).at(at(100)), kmh(160));
    q.elements.*elements[i] = true;
    EXPECT_EQ(mrsp(d, q).at(at(100)), kmh(60.0 - 10.0 * static_cast<double>(i)));
    q.elements = {};
    q.elements.*elements[i] = false;
    EXPECT_EQ(mrsp(d, q).at(at(100)), i == 5 ? kmh(20) : kmh(10));
  }
}

/// The lowest of the restrictions at every place: the merged function has to be equal to it.
Speed lowest_at(const Description& d, const MrspQuery& q, Place x) {
  Speed v = kNoLimit;
  const auto lower = [&](Place from, Place to, Speed s) {
    if (x >= from && x < to && s < v) v = s;
  };
  for (const Limit& l : q.limits) lower(l.from.value_or(at(-1e9)), l.to.value_or(at(1e9)), l.V);
  for (std::size_t i = 0; i < d.ssp.steps.size(); ++i) {
    const StaticSpeed& e = d.ssp.steps[i].value;
    if (!e.known()) continue;
    const bool last = i + 1 == d.ssp.steps.size();
    lower(d.ssp.steps[i].from, last ? at(1e9) : d.ssp.steps[i + 1].from + (e.Q_FRONT ? Distance{} : q.train_length),
          speed_of(e.speed_for(q.category)));
  }
  for (const auto& t : d.tsr) lower(t.from, t.Q_FRONT ? t.to : t.to + q.train_length, speed_of(t.V_TSR));
  return v;
}

TEST(Mrsp, EqualsTheLowestAtEveryPlaceForRandomData) {
  std::mt19937 random(7);
  const auto number = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  for (int run = 0; run < 2000; ++run) {
    Description d;
    double x = number(-300, 300);
    for (int i = number(0, 12); i > 0; --i, x += number(0, 400)) {
      StaticSpeed e;
      e.V_STATIC = static_cast<SpeedCode>(number(2, 30));
      e.Q_FRONT = number(0, 1) == 1;
      if (number(0, 9) == 0) e = StaticSpeed::unknown();
      ASSERT_TRUE(d.ssp.append(at(x), e));
    }
    for (int i = number(0, 6); i > 0; --i) {
      TemporarySpeedRestriction t;
      t.from = at(number(-600, 3000));
      t.to = t.from + Distance{static_cast<double>(number(0, 500))};
      t.V_TSR = static_cast<SpeedCode>(number(1, 30));
      t.Q_FRONT = number(0, 1) == 1;
      ASSERT_TRUE(d.tsr.push_back(t));
    }
    const MrspQuery q = query(number(20, 700), number(10, 32) * 5);
    const Mrsp f = mrsp(d, q);
    for (std::size_t i = 1; i < f.size(); ++i) {
      ASSERT_LT(f.steps[i - 1].from, f.steps[i].from);
      ASSERT_FALSE(f.steps[i - 1].value == f.steps[i].value) << "equal neighbours are one step";
    }
    for (double p = -500; p < 5000; p += 12.5) ASSERT_EQ(f.at(at(p)), lowest_at(d, q, at(p))) << run << " at " << p;
  }
}

TEST(Mrsp, NeverHigherThanDueWhenThereIsNoRoom) {
  std::mt19937 random(11);
  Description d;
  for (int i = 0; i < 60; ++i) {
    StaticSpeed e;
    e.V_STATIC = static_cast<SpeedCode>(i % 2 ? 28 : 24);
    ASSERT_TRUE(d.ssp.append(at(i * 100), e));
  }
  for (std::size_t i = 0; i < d.tsr.capacity(); ++i) {
    TemporarySpeedRestriction t;
    t.from = at(static_cast<double>(random() % 6000));
    t.to = t.from + Distance{40.0 + static_cast<double>(random() % 60)};
    t.V_TSR = static_cast<SpeedCode>(4 + random() % 18);
    t.Q_FRONT = true;
    ASSERT_TRUE(d.tsr.push_back(t));
  }
  const MrspQuery q = query(10);
  const Mrsp f = mrsp(d, q);
  for (double p = -500; p < 8000; p += 5) ASSERT_LE(f.at(at(p)), lowest_at(d, q, at(p))) << p;
}

/// 126 changes: of 40 axle load restrictions and 23 permitted braking distances.
void fill(Description& d) {
  for (int i = 0; i < 40; ++i) {
    AxleLoadRestriction asp;
    asp.from = at(100.0 * i + 10);
    asp.to = at(100.0 * i + 20);
    asp.Q_FRONT = true;
    asp.V_AXLELOAD[0] = static_cast<SpeedCode>(16 + i % 3);
    ASSERT_TRUE(d.asp.push_back(asp));
  }
  for (int i = 0; i < 23; ++i) {
    PermittedBrakingDistance pbd;
    pbd.from = at(100.0 * i + 30);
    pbd.to = at(100.0 * i + 40);
    ASSERT_TRUE(d.pbd.push_back(pbd));
  }
}

// What there is no room for is taken from the far end, even where it is added near the train.
TEST(Mrsp, WithoutRoomNothingIsLostNearTheTrain) {
  Description d;
  fill(d);
  const std::array<SpeedCode, 23> pbd_speeds{12, 13, 14, 12, 13, 14, 12, 13, 14, 12, 13, 14,
                                             12, 13, 14, 12, 13, 14, 12, 13, 14, 12, 13};
  MrspQuery q = query();
  q.pbd_speeds = pbd_speeds;
  ASSERT_TRUE(q.limits.push_back({at(6000), std::nullopt, kmh(50)}));
  const Mrsp whole = mrsp(d, q);
  ASSERT_EQ(whole.size(), kMrspSteps) << "just full";
  LevelCrossing lx;
  lx.from = lx.V_LX_from = at(50);
  lx.to = at(60);
  lx.unprotected = lx.substituted = true;
  lx.V_LX = 2;
  ASSERT_TRUE(d.lx.push_back(lx));
  const Mrsp f = mrsp(d, q);
  for (double x = -500; x < 3500; x += 5) {
    const Speed expected = x >= 50 && x < 60 ? kmh(10) : whole.at(at(x));
    EXPECT_EQ(f.at(at(x)), expected) << x;
  }
  for (double x = 3500; x < 8000; x += 5) EXPECT_LE(f.at(at(x)), whole.at(at(x))) << x;
  // A restriction of no length limits nothing and takes no room.
  d.lx[0].to = at(50);
  EXPECT_EQ(mrsp(d, q), whole);
  d.lx[0].to = at(45);
  EXPECT_EQ(mrsp(d, q), whole);
}

TEST(Mrsp, IsWrittenOverWhatStoodThere) {
  Description d;
  fill(d);
  Mrsp f = mrsp(d, query());
  mrsp(f, Description{}, query());
  EXPECT_EQ(f, mrsp(Description{}, query()));
}

TEST(Gradient, IsWrittenOverWhatStoodThere) {
  Description d;
  ASSERT_TRUE(d.gradient.replace_from(slopes({{0, 5}, {100, -7}})));
  GradientFunction f = gradient(d, at(50));
  gradient(f, Description{}, at(50), -3.0);
  EXPECT_EQ(f, gradient(Description{}, at(50), -3.0));
}

TEST(Gradient, IsLevelWhereNothingIsKnown) {  // 3.13.4.1.2
  GradientFunction f;
  gradient(f, Description{}, at(0));
  EXPECT_EQ(f.at(at(100)), 0.0);
}

TEST(Gradient, UnknownStretchesTakeTheDefault) {
  Description d;
  EXPECT_EQ(gradient(d, at(0)).at(at(100)), 0.0);
  ASSERT_TRUE(d.gradient.replace_from(slopes({{0, 5}, {100, -7}, {300, Gradient::kUnknown}})));
  const GradientFunction f = gradient(d, at(50), -12.0);
  EXPECT_EQ(f.at(at(50)), 5.0);
  EXPECT_EQ(f.at(at(100)), -7.0);
  EXPECT_EQ(f.at(at(300)), -12.0);
  EXPECT_EQ(gradient(d, at(-100)).at(at(-50)), 0.0);
  EXPECT_EQ(gradient(d, at(-100), 3.0).at(at(-50)), 3.0);
  EXPECT_EQ(gradient(d, at(-100)).at(at(50)), 5.0);
  EXPECT_EQ(gradient(d, at(200)).size(), 2u);
}

}  // namespace
}  // namespace evc::track
