// Braking curves that are exact: places, speeds and decelerations are multiples of powers of two, so every knot is
// known to the last bit, and every function can be tested at it.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "sdm/test_reference_curves.h"

namespace {

using namespace evc;
using namespace evc::sdm;
using namespace evc::sdm::test;

// ---- A curve as a list of knots ------------------------------------------------------------------------------

/// Knots from the foot upstream, speeds whole numbers.
std::vector<Knot> random_knots(Dice& dice) {
  constexpr double kA[] = {0.0, 0.25, 0.5, 1.0, 2.0};
  std::vector<Knot> knots;
  double x = 1000.0;
  double V = dice.integer(0, 3);
  double A = kA[dice.integer(0, 4)];
  const int n = dice.integer(1, 12);
  for (int i = 0; i < n; ++i) {
    knots.push_back({{{x}}, {V * V}, {A}});
    const double before = V;
    if (A > 0.0) V += dice.integer(1, 5);
    x -= A > 0.0 ? (V * V - before * before) / (2.0 * A) : dice.integer(1, 50);
    const double level_before = A;
    do A = kA[dice.integer(0, 4)];
    while (A == level_before);
  }
  return knots;
}

constexpr double kShort = 1.0 / 1024.0;  // shorter than any arc

TEST(ExactCurves, PlacesAndSpeedsAtEveryKnot) {
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    Dice dice(static_cast<std::uint64_t>(i));
    const std::vector<Knot> knots = random_knots(dice);
    const CurveView c{{knots.data(), knots.size()}};
    EXPECT_EQ(c.knot_at(c.foot() + Distance{1.0}), 0u);
    EXPECT_EQ(c.speed_squared_at(c.foot() + Distance{1.0}), knots[0].w);
    std::size_t next = 0;
    for (std::size_t k = 0; k < knots.size(); ++k) {
      const Place x = knots[k].x;
      const std::size_t downstream = k == 0 ? 0 : k - 1;
      EXPECT_EQ(c.knot_at(x), downstream);
      EXPECT_EQ(c.knot_at(x + Distance{kTiny}), downstream);
      EXPECT_EQ(c.knot_at(x - Distance{kTiny}), k);
      EXPECT_EQ(c.speed_squared_at(x), knots[k].w);
      EXPECT_EQ(c.speed_at(x).si, std::sqrt(knots[k].w.si));
      EXPECT_EQ(c.speed_squared_at(x - Distance{kShort}), knots[k].w + 2.0 * (knots[k].A * Distance{kShort}));
      EXPECT_EQ(c.next_speed_at(x, next), c.speed_at(x));
      EXPECT_EQ(next, downstream);
      // The last place at which the train may run at the speed: the first knot from the foot that
      // has it.
      const Speed V{std::sqrt(knots[k].w.si)};
      std::size_t first = k;
      while (first > 0 && knots[first - 1].w == knots[k].w) --first;
      EXPECT_EQ(c.place_at(V), knots[first].x);
      EXPECT_EQ(c.knot_at(V), first == 0 ? 0 : first - 1);
      if (k + 1 < knots.size() && knots[k].A.si > 0.0) {
        EXPECT_EQ(c.knot_at(V + Speed{0.5}), k);
      }
    }
    const Knot& last = knots.back();
    const double V = std::sqrt(last.w.si) + 1.0;
    EXPECT_EQ(c.place_at({V}).from_origin.si,
              last.A.si > 0.0 ? last.x.from_origin.si - (V * V - last.w.si) / (2.0 * last.A.si) : -1e9);
    EXPECT_EQ(c.place_at({0.0}), c.foot());
    // From the upstream end back to the foot.
    for (std::size_t k = knots.size(); k-- > 0;) {
      EXPECT_EQ(c.next_speed_at(knots[k].x, next), c.speed_at(knots[k].x));
      EXPECT_EQ(next, k == 0 ? 0 : k - 1);
    }
    EXPECT_EQ(c.next_speed_at(c.foot() + Distance{9.0}, next), c.speed_at(c.foot()));
  }
}

// ---- A track for a known curve ---------------------------------------------------------------------------------

/// Brake of steps and gradient profile, built in upstream direction: after each arc the place, or the step of speed, or
/// both change. A_gradient is grad / 64 m/s2.
struct KnownCurve {
  Inputs in;
  std::vector<Knot> knots;
};

constexpr double kL = 16.0;

KnownCurve known_curve(Dice& dice, double V_foot) {
  KnownCurve c;
  c.in.revision = 1;
  c.in.train = simple_train();
  c.in.train.L_TRAIN = {kL};
  c.in.train.M_rotating_nom = 0.0;
  c.in.fixed.g = {15.625};
  c.in.national_values.Q_NVINHSMICPERM = true;
  struct Change {
    double x, upstream;
  };
  constexpr double kA[] = {0.25, 0.5, 1.0, 2.0};
  const auto other_A = [&](double A) {
    double B = A;
    while (B == A) B = kA[dice.integer(0, 3)];
    return B;
  };
  double x = 4096.0;
  double V = V_foot;
  double A = kA[dice.integer(0, 3)];
  double brake = dice.integer(8, 24) / 16.0;
  double grad = 64.0 * (A - brake);
  std::vector<Change> changes;
  const double first_grad = grad;
  std::vector<std::pair<double, double>> steps = {{0.0, brake}};
  double border = x + 1000.0;
  const int n = dice.integer(1, 14);
  for (int i = 0; i < n; ++i) {
    c.knots.push_back({{{x}}, {V * V}, {A}});
    const double from = V;
    const double at = x;
    V += dice.integer(1, 3);
    x = at - (V * V - from * from) / (2.0 * A);
    int what = dice.integer(1, 3);
    const double B = other_A(A);
    if ((what & 2) != 0 && (steps.size() == train::kSpeedSteps || B - grad / 64.0 < 0.0625)) what = 1;
    // The train is shorter than every stretch of the gradient.
    while ((what & 1) != 0 && border - x < 3.0 * kL) {
      V += 1.0;
      x = at - (V * V - from * from) / (2.0 * A);
    }
    if ((what & 2) != 0) {
      brake = (what & 1) != 0 ? dice.integer(8, 24) / 16.0 : B - grad / 64.0;
      steps.push_back({V, brake});
    }
    A = B;
    if ((what & 1) != 0) {
      const double upstream = 64.0 * (A - brake);
      // A fall counts until the whole train has left it, a rise from its start.
      changes.push_back({upstream < grad ? x - kL : x, upstream});
      grad = upstream;
      border = x;
    }
  }
  c.knots.push_back({{{x}}, {V * V}, {A}});
  c.in.V_top = Speed{V + 2.0};
  const double x_top = x - ((V + 2.0) * (V + 2.0) - V * V) / (2.0 * A);
  c.knots.push_back({{{x_top}}, {(V + 2.0) * (V + 2.0)}, {A}});
  auto& e = c.in.train.emergency[0].steps;
  auto& s = c.in.train.service[0].A_brake_service;
  auto step = e.steps[0].value;
  step.Kwet_rst = train::Factor::of(1.0);
  e = {};
  s = {};
  for (const auto& [from, value] : steps) {
    step.A_brake_emergency = {value};
    EXPECT_TRUE(e.append({from}, step));
    EXPECT_TRUE(s.append({from}, {value}));
  }
  auto& g = c.in.gradient.permille;
  double place = -1e6;
  for (std::size_t i = changes.size(); i-- > 0;) {
    EXPECT_TRUE(g.append({{place}}, changes[i].upstream));
    place = changes[i].x;
  }
  EXPECT_TRUE(g.append({{place}}, first_grad));
  return c;
}

void expect_knots(const BrakingCurve& curve, const std::vector<Knot>& knots) {
  ASSERT_EQ(curve.knots.size(), knots.size());
  for (std::size_t k = 0; k < knots.size(); ++k) {
    ASSERT_EQ(curve.knots[k].x, knots[k].x) << "knot " << k;
    ASSERT_EQ(curve.knots[k].w, knots[k].w) << "knot " << k;
    ASSERT_EQ(curve.knots[k].A, knots[k].A) << "knot " << k;
  }
}

TEST(ExactCurves, EveryKnotWhereverTheCurveIsAnchored) {
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    Dice dice(static_cast<std::uint64_t>(i));
    const double V_foot = dice.integer(0, 4);
    const KnownCurve c = known_curve(dice, V_foot);
    const Decelerations d = determined(c.in);
    for (const CurveKind kind : {CurveKind::EBD, CurveKind::SBD})
      for (std::size_t k = 0; k + 1 < c.knots.size(); ++k) {
        const Knot& anchor = c.knots[k];
        const Speed V{std::sqrt(anchor.w.si)};
        expect_knots(trace(d, kind, false, anchor.x, V, {V_foot}, *c.in.V_top), c.knots);
        // From a foot further upstream.
        expect_knots(trace(d, kind, false, anchor.x, V, V, *c.in.V_top),
                     {c.knots.begin() + static_cast<long>(k), c.knots.end()});
        // Anchored inside an arc: one knot more.
        const double inside = V.si + 0.5;
        if (inside * inside >= c.knots[k + 1].w.si) continue;
        const Knot middle{
            anchor.x - Distance{(inside * inside - anchor.w.si) / (2.0 * anchor.A.si)}, {inside * inside}, anchor.A};
        std::vector<Knot> more = c.knots;
        more.insert(more.begin() + static_cast<long>(k) + 1, middle);
        expect_knots(trace(d, kind, false, middle.x, {inside}, {V_foot}, *c.in.V_top), more);
        if (HasFatalFailure()) return;
      }
  }
}

TEST(ExactCurves, ARoomThatIsTooSmallIsFilledAndTheRestIsLevel) {
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    Dice dice(static_cast<std::uint64_t>(i));
    const KnownCurve c = known_curve(dice, 0.0);
    const Decelerations d = determined(c.in);
    std::array<Knot, 40> room{};
    for (std::size_t n = 1; n <= c.knots.size(); ++n) {
      std::size_t used = 3;
      const CurveWarnings warnings =
          trace({room.data(), used + n}, used, d, CurveKind::EBD, false, c.knots[0].x, {}, {}, *c.in.V_top);
      ASSERT_EQ(warnings.truncated, n < c.knots.size());
      ASSERT_FALSE(warnings.no_deceleration);
      ASSERT_EQ(used, 3 + n);
      for (std::size_t k = 0; k < n; ++k) {
        const bool level = k + 1 == n && warnings.truncated;
        ASSERT_EQ(room[3 + k].x, c.knots[k].x);
        ASSERT_EQ(room[3 + k].w, c.knots[k].w);
        ASSERT_EQ(room[3 + k].A, level ? Acceleration{0.0} : c.knots[k].A);
      }
    }
  }
}

// ---- Falls -------------------------------------------------------------------------------------------------------

TEST(ExactCurves, FallsAreCutToTheLowestSpeedUpstream) {
  int falls = 0;
  int meets_a_knot = 0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    Dice dice(static_cast<std::uint64_t>(i));
    Inputs in = simple_inputs();
    in.train.L_TRAIN = {kL};
    in.train.M_rotating_nom = 0.0;
    in.fixed.g = {15.625};
    const double V_top = 30.0;
    // Places are multiples of 64 m, decelerations powers of two, so squared speeds are multiples of 32.
    constexpr double kA[] = {-2.0, -1.0, -0.5, -0.25, 0.25, 0.5, 1.0, 2.0};
    auto& g = in.gradient.permille;
    g = {};
    EXPECT_TRUE(g.append({{-1e6}}, 0.0));
    for (int k = -10; k < 0; ++k) EXPECT_TRUE(g.append({{64.0 * k}}, 64.0 * (kA[dice.integer(0, 7)] - 1.0)));
    EXPECT_TRUE(g.append({{64.0}}, 0.0));
    const Decelerations d = determined(in);
    const Reference r(in);
    const double V_foot = dice.chance(0.5) ? 0.0 : 8.0;
    const ReferenceCurve expected(r, CurveKind::EBD, 0.0, V_foot, V_foot, V_top);
    const BrakingCurve curve = trace(d, CurveKind::EBD, false, {{0.0}}, {V_foot}, {V_foot}, {V_top});
    const auto& knots = curve.knots;
    ASSERT_EQ(curve.warnings.no_deceleration, expected.no_deceleration);
    falls += expected.no_deceleration;
    for (std::size_t k = 0; k < knots.size(); ++k) {
      const double x = knots[k].x.from_origin.si;
      ASSERT_EQ(knots[k].w.si, expected.w_at(x)) << "knot " << k << " at " << x;
      if (k == 0) continue;
      const Knot& before = knots[k - 1];
      // No knot occurs twice; each arc leads from one knot to the next, and only a fall makes it
      // level.
      ASSERT_LT(knots[k].x, before.x);
      ASSERT_GE(knots[k].w, before.w);
      ASSERT_EQ(knots[k].w, before.w + 2.0 * (before.A * (before.x - knots[k].x)));
      if (before.A.si == 0.0 && k > 1 && knots[k - 2].A.si > 0.0 && before.w.si > 0.0) ++meets_a_knot;
    }
    for (const auto& v : expected.walk)
      if (v.x > -1e5) {
        ASSERT_EQ(curve.view().speed_squared_at({{v.x}}).si, expected.w_at(v.x)) << "at " << v.x;
      }
  }
  EXPECT_GT(falls, 1000);
  EXPECT_GT(meets_a_knot, 100);
}

TEST(ExactCurves, WhatBeginsAtTheAnchorDoesNotCountUpstream) {
  Inputs in = simple_inputs();
  in.gradient.permille = {};
  ASSERT_TRUE(in.gradient.permille.append({{0.0}}, -200.0));  // from the second segment on the train cannot brake
  const BrakingCurve curve = trace(determined(in), CurveKind::EBD, false, {{0.0}}, {}, {}, {30.0});
  EXPECT_FALSE(curve.warnings.no_deceleration);
  EXPECT_EQ(curve.knots[0], (Knot{{{0.0}}, {0.0}, {1.0}}));
}

TEST(ExactCurves, AFootBehindTooManyArcsOrALevelStretchIsNotReached) {
  // 20 m/s with 1 m/s2, a border each 2 m: 30 of them are 31 arcs and 32 knots.
  for (const int borders : {30, 31}) {
    Inputs in = simple_inputs();
    in.train.L_TRAIN = {1.0};
    in.gradient.permille = {};
    for (int i = 0; i < borders; ++i)
      ASSERT_TRUE(in.gradient.permille.append({{2.0 * (i + 1)}}, i % 2 == 0 ? 1.0 : 2.0));
    const BrakingCurve curve = trace(determined(in), CurveKind::EBD, false, {{0.0}}, {20.0}, {}, {30.0});
    EXPECT_EQ(curve.warnings.no_deceleration, borders > 30);
    EXPECT_EQ(curve.view().foot() > (Place{{100.0}}), borders == 30);
  }
  // Exactly no deceleration 16 m behind the anchor, then 1 m/s2 again.
  Inputs in = simple_inputs();
  in.train.L_TRAIN = {kL};
  in.train.M_rotating_nom = 0.0;
  in.fixed.g = {15.625};
  in.gradient.permille = {};
  ASSERT_TRUE(in.gradient.permille.append({{16.0}}, -64.0));
  ASSERT_TRUE(in.gradient.permille.append({{48.0}}, 0.0));
  const BrakingCurve curve = trace(determined(in), CurveKind::EBD, false, {{0.0}}, {20.0}, {}, {30.0});
  EXPECT_TRUE(curve.warnings.no_deceleration);
  EXPECT_EQ(curve.knots[0], (Knot{{{0.0}}, {0.0}, {1.0}}));
  // The same stretch in rear of the anchor, to 64 m for the train's length: level.
  const BrakingCurve level = trace(determined(in), CurveKind::EBD, false, {{96.0}}, {}, {}, {30.0});
  EXPECT_TRUE(level.warnings.no_deceleration);
  EXPECT_EQ(level.knots[1], (Knot{{{64.0}}, {64.0}, {0.0}}));
  EXPECT_EQ(level.knots[2], (Knot{{{16.0}}, {64.0}, {1.0}}));
}

// ---- `explain` at a border -------------------------------------------------------------------------------

TEST(ExactCurves, DecelerationsOfAnExplanationAtEveryKnot) {
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Dice dice(static_cast<std::uint64_t>(i));
    KnownCurve c = known_curve(dice, 0.0);
    ASSERT_TRUE(c.in.mrsp.append({{-1e5}}, {30.0}));
    const double EOA = c.knots[0].x.from_origin.si;
    set_EOA(c.in, EOA, EOA);
    auto d = std::make_unique<Derived>();
    rebuild(*d, c.in);
    const Reference r(c.in);
    for (const Knot& k : c.knots) {
      const Speed V{std::sqrt(k.w.si)};
      const Explanation e = explain(*d, c.in, d->targets.back(), V, {}, {});
      ASSERT_EQ(e.d_EBD, k.x);
      ASSERT_EQ(*e.d_SBD, k.x);
      // A zone and a step include their ends: tested just upstream of the place and just below the
      // speed.
      const double x = k.x.from_origin.si - kTiny;
      ASSERT_EQ(e.A_safe.si, r.A(CurveKind::EBD, V.si, x));
      ASSERT_EQ(e.A_expected.si, r.A(CurveKind::SBD, V.si, x));
      ASSERT_EQ(e.A_brake_safe.si, r.A_brake(CurveKind::EBD, V.si, x));
      ASSERT_EQ(e.A_brake_service.si, r.A_brake(CurveKind::SBD, V.si, x));
      ASSERT_EQ(e.A_brake_emergency.si, e.A_brake_safe.si);
      ASSERT_EQ(e.A_gradient_EBD.si, r.A_gradient(x));
      ASSERT_EQ(e.A_gradient_SBD.si, r.A_gradient(x));
    }
  }
}

TEST(ExactCurves, AnInhibitionAtAKnot) {
  using Start = std::optional<Place> TrackConditions::*;
  struct Case {
    Start start;
    train::BrakeSet brake;
    bool emergency, service;
  };
  const Case all[] = {
      {&TrackConditions::regenerative_off, train::kRegenerative, true, true},
      {&TrackConditions::powerless, train::kRegenerative, true, true},
      {&TrackConditions::eddy_current_emergency_off, train::kEddyCurrent, true, false},
      {&TrackConditions::eddy_current_service_off, train::kEddyCurrent, false, true},
      {&TrackConditions::magnetic_shoe_off, train::kMagneticShoe, true, false},
  };
  for (const Case& one : all) {
    Inputs in = simple_inputs();
    in.train.regenerative = in.train.eddy_current = train::SpecialBrakeInterface::both;
    in.train.magnetic_shoe = train::SpecialBrakeInterface::emergency_only;
    in.train.service[0].A_brake_service.steps[0].value = {1.0};
    train::EmergencyModel e = in.train.emergency[0];
    e.with = one.brake;
    e.steps.steps[0].value.A_brake_emergency = {2.0};
    ASSERT_TRUE(in.train.emergency.push_back(e));
    train::ServiceModel s = in.train.service[0];
    s.with = one.brake;
    s.A_brake_service.steps[0].value = {2.0};
    ASSERT_TRUE(in.train.service.push_back(s));
    set_EOA(in, 1000.0, 1000.0);
    in.conditions.*one.start = Place{{800.0}};
    auto d = std::make_unique<Derived>();
    rebuild(*d, in);
    const auto at = [&](double V) { return explain(*d, in, d->targets.back(), {V}, {}, {}); };
    // v^2 = 400 at 800 m, the last place where the brake counts.
    if (one.emergency) {
      EXPECT_EQ(at(20.0).d_EBD.from_origin.si, 800.0);
      EXPECT_EQ(at(20.0).A_brake_emergency.si, 2.0);
      EXPECT_EQ(at(20.0).A_brake_safe.si, 2.0);
      EXPECT_EQ(at(19.0).A_brake_emergency.si, 1.0);
      EXPECT_EQ(at(19.0).A_brake_safe.si, 1.0);
      EXPECT_EQ(at(22.0).d_EBD.from_origin.si, 800.0 - 21.0);
    }
    if (one.service && one.brake != train::kMagneticShoe) {
      EXPECT_EQ(at(20.0).A_brake_service.si, 2.0);
      EXPECT_EQ(at(19.0).A_brake_service.si, 1.0);
      EXPECT_EQ(at(22.0).d_SBD->from_origin.si, 800.0 - 21.0);
    }
  }
}

}  // namespace
