#include <gtest/gtest.h>

#include <random>

#include "track/testing.h"
#include "track/withdraw.h"

// Data stored, withdrawn and passed in any order: the properties that other rooms rely on hold.
namespace evc::track {
namespace {

using namespace testing;

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  int number(int low, int high) { return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1)); }
  bool one_in(int n) { return number(1, n) == 1; }
  double metres(int low, int high) { return static_cast<double>(number(low * 2, high * 2)) / 2.0; }

 private:
  std::mt19937 random_;
};

MovementAuthority random_authority(Dice& dice, double from) {
  MovementAuthority ma;
  double x = from;
  for (int i = dice.number(1, 4); i > 0; --i) {
    Section s;
    s.begin = at(x);
    x += dice.metres(50, 1500);
    s.end = at(x);
    s.timed = dice.one_in(3);
    s.stop = s.begin + Distance{10};
    s.timer = {Duration{dice.metres(1, 60)}, Duration{}, s.timed};
    if (!ma.sections.push_back(s)) __builtin_trap();
  }
  if (dice.one_in(4)) ma.V_LOA = Speed{dice.metres(1, 30)};
  if (ma.limited()) ma.loa_timer = {Duration{20}, Duration{}, dice.one_in(2)};
  if (dice.one_in(3)) ma.end_section = EndSectionTimer{at(x - dice.metres(0, 500)), {Duration{15}, {}, false}};
  if (dice.one_in(2)) ma.danger_point = DangerPoint{at(x + dice.metres(0, 200)), {ReleaseSpeedChoice::on_board, {}}};
  if (dice.one_in(2))
    ma.overlap = Overlap{at(x - dice.metres(0, 300)), at(x + dice.metres(0, 300)), {Duration{30}, {}, false}, {}};
  ma.level_1 = dice.one_in(2);
  return ma;
}

Contents random_contents(Dice& dice, double front) {
  Contents c;
  const double from = front - dice.metres(0, 400);
  if (dice.one_in(2)) c.ma = random_authority(dice, from);
  if (!dice.one_in(4)) {
    c.ssp = NewStaticSpeedProfile{};
    double x = from + dice.metres(-100, 300);
    for (int i = dice.number(1, 32); i > 0; --i, x += dice.metres(0, 700)) {
      StaticSpeed e;
      e.V_STATIC = static_cast<SpeedCode>(dice.number(1, 30));
      e.Q_FRONT = dice.one_in(2);
      if (i == 1 && dice.one_in(2)) e = StaticSpeed::unknown();
      c.ssp->append(at(x), e);
    }
  }
  if (!dice.one_in(4)) {
    c.gradient = NewGradientProfile{};
    double x = from + dice.metres(-100, 300);
    for (int i = dice.number(1, 32); i > 0; --i, x += dice.metres(0, 700))
      c.gradient->append(at(x), Gradient{static_cast<std::int16_t>(dice.number(-40, 40))});
  }
  if (dice.one_in(3)) {
    TemporarySpeedRestriction t;
    t.NID_TSR = static_cast<std::uint8_t>(dice.one_in(2) ? 255 : dice.number(0, 5));
    t.from = at(front + dice.metres(-300, 3000));
    t.to = t.from + Distance{dice.metres(0, 800)};
    t.V_TSR = static_cast<SpeedCode>(dice.number(1, 30));
    if (!c.tsr.push_back(t)) __builtin_trap();
  }
  if (dice.one_in(3)) {
    c.mode_profile = ModeProfile{};
    ModeArea area;
    area.from = at(front + dice.metres(-100, 2000));
    area.ack_from = area.from - Distance{200};
    if (!dice.one_in(3)) area.to = area.from + Distance{dice.metres(0, 600)};
    area.mode = mode_of_area(static_cast<std::uint64_t>(dice.number(0, 2)));
    area.also_SvL = dice.one_in(2);
    if (!c.mode_profile->push_back(area)) __builtin_trap();
  }
  if (dice.one_in(4) && c.ma) {
    c.infill = at(from + dice.metres(0, 500));
    c.ma = random_authority(dice, c.infill->from_origin.si);
  }
  if (dice.one_in(5)) c.V_MAIN = static_cast<SpeedCode>(dice.number(0, 20));
  if (dice.one_in(6)) {
    c.repositioned_section = Distance{dice.metres(0, 900)};
    c.reference = at(front);
  }
  return c;
}

template <class P>
void expect_in_order(const P& profile) {
  for (std::size_t i = 1; i < profile.steps.size(); ++i) ASSERT_LE(profile.steps[i - 1].from, profile.steps[i].from);
}

void expect_sound(const Description& d, const Here& here, Dice& dice) {
  expect_in_order(d.ssp);
  expect_in_order(d.gradient);
  if (d.ma) {
    ASSERT_FALSE(d.ma->sections.empty());
    for (const Section& s : d.ma->sections) ASSERT_LE(s.begin, s.end);
    for (std::size_t i = 1; i < d.ma->sections.size(); ++i)
      ASSERT_EQ(d.ma->sections[i - 1].end, d.ma->sections[i].begin);
    const Authority a = authority(d, {}, dice.one_in(2) ? Mode::FS : Mode::OS, kInRear);
    ASSERT_NE(a.EOA.has_value(), a.LOA.has_value());
    if (a.EOA) {
      ASSERT_LE(*a.EOA, d.ma->end() > *a.EOA ? d.ma->end() : *a.EOA);
      ASSERT_TRUE(a.SvL) << "whoever has to stop has a supervised location";
    }
    if (a.LOA) {
      ASSERT_GT(a.V_LOA, Speed{});
    }
  }
  MrspQuery q;
  q.from = here.min_safe_rear - Distance{100};
  q.train_length = Distance{200};
  q.limits.clear();
  ASSERT_TRUE(q.limits.push_back({std::nullopt, std::nullopt, Speed{40}}));
  const Mrsp f = mrsp(d, q);
  ASSERT_FALSE(f.empty());
  for (std::size_t i = 0; i < f.size(); ++i) {
    ASSERT_LE(f.steps[i].value, Speed{40});
    if (i > 0) {
      ASSERT_LT(f.steps[i - 1].from, f.steps[i].from);
    }
  }
  const GradientFunction g = gradient(d, q.from);
  ASSERT_FALSE(g.empty());
  ASSERT_LE(g.steps.front().from, here.est_front > q.from ? here.est_front : q.from);
}

TEST(Random, WhatOthersRelyOnHolds) {
  int accepted = 0, refused = 0, shortened = 0, timeouts = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    Dice dice(seed);
    Description d;
    double front = 0, now = 0;
    for (int step = 0; step < 60; ++step) {
      front += dice.metres(0, 120);
      now += dice.metres(0, 6);
      Here here = front_at(front, dice.metres(1, 20));
      here.now = Duration{now};
      here.standstill = dice.one_in(20);
      const std::uint32_t revision = d.revision;
      const std::optional<MovementAuthority> old = d.ma;
      switch (dice.number(0, 9)) {
        case 0: {
          const Place stop = at(front + dice.metres(0, 3000));
          const Authority before = authority(d, {}, Mode::OS, kInRear);
          stop_at(d, stop, here);
          const Authority after = authority(d, {}, Mode::OS, kInRear);
          ASSERT_GT(d.revision, revision);
          if (before.EOA && after.EOA) {
            ASSERT_LE(*after.EOA, *before.EOA);
          }
          break;
        }
        case 1:
          shorten(d, static_cast<Situation>(dice.number(0, 13)), at(front + dice.metres(0, 2000)), here,
                  dice.one_in(2));
          ASSERT_GT(d.revision, revision);
          break;
        case 2:
          forget(d, static_cast<evc::Stored>(dice.number(0, static_cast<int>(kStored) - 1)));
          break;
        case 3:
          accept_area(d, mode_of_area(static_cast<std::uint64_t>(dice.number(0, 2))), here);
          break;
        default: {
          Contents c = random_contents(dice, front);
          c.time = here.now;
          for (std::size_t i = 0; c.ma && i < c.ma->sections.size(); ++i) c.ma->sections[i].timer.started = here.now;
          const Stored s = store(d, c, here);
          accepted += s.ma_accepted;
          refused += s.ma_refused;
          shortened += s.shortened;
          if (s.ma_accepted && !c.repositioned_section && !c.infill && !d.ma->fixed_SvL) {
            ASSERT_TRUE(complete(d, here)) << seed << " step " << step;
          }
          if (s.ma_refused && !c.repositioned_section) {
            ASSERT_EQ(d.ma, old) << "refused: the old one stays";
          }
          break;
        }
      }
      expect_sound(d, here, dice);
      const Elapsed e = advance(d, here);
      timeouts += e.any();
      if (e.any()) {
        ASSERT_GT(d.revision, revision);
      }
      expect_sound(d, here, dice);
      if (HasFatalFailure()) FAIL() << "seed " << seed << " step " << step;
    }
  }
  EXPECT_GT(accepted, 500);
  EXPECT_GT(refused, 500);
  EXPECT_GT(shortened, 50);
  EXPECT_GT(timeouts, 100);
}

}  // namespace
}  // namespace evc::track
