// Decelerations and braking curves compared with the independent model of test_reference_curves.h, often exactly at
// borders of segments, steps of speed and knots.
#include <gtest/gtest.h>

#include <memory>

#include "sdm/test_reference_curves.h"

namespace {

using namespace evc;
using namespace evc::sdm;
using namespace evc::sdm::test;

constexpr CurveKind kKinds[] = {CurveKind::EBD, CurveKind::SBD, CurveKind::GUI};

TEST(ReferenceModel, CompensatedGradientAtEveryBorder) {
  for (int i = 0; i < cases(600); ++i) {
    Dice dice(static_cast<std::uint64_t>(i));
    const Inputs in = rich_inputs(dice);
    for (const bool TSR : {false, true}) {
      const Reference r(in, TSR);
      const CompensatedGradient c = compensated_gradient(in.gradient, in.train.L_TRAIN, TSR);
      for (const double b : r.borders())
        for (const double x : {b, b - kTiny}) ASSERT_EQ(c.permille.at({{x}}), r.grad(x)) << i << " at " << x;
      ASSERT_EQ(c.permille.at({{-1e6}}), r.grad(-1e6)) << i;
      ASSERT_EQ(c.permille.at({{1e6}}), r.grad(1e6)) << i;
      for (std::size_t n = 1; n < c.permille.size(); ++n)
        ASSERT_LT(c.permille.steps[n - 1].from, c.permille.steps[n].from) << i;
    }
  }
}

/// The strongest of the brakes that count anywhere, without gradient and cap.
double highest(const Reference& r, bool emergency, const std::vector<double>& places) {
  double A = 0.0;
  for (const double x : places) {
    const train::TrainData& t = r.in.train;
    if (emergency)
      for (const auto& s : r.safe[train::in_use_emergency(t, r.in.brakes, r.inhibited(x, false))].steps)
        A = std::max(A, s.value.si);
    else
      for (const auto& s : r.full_service[train::in_use_service(t, r.in.brakes, r.inhibited(x, true))].steps)
        A = std::max(A, s.value.si);
  }
  return A;
}

TEST(ReferenceModel, WhatIsDeterminedAnewKeepsNothing) {
  auto d = std::make_unique<Decelerations>();
  for (int i = 0; i < cases(300); ++i) {
    SCOPED_TRACE(i);
    Dice dice(static_cast<std::uint64_t>(i) + 3000);
    Inputs in = rich_inputs(dice);
    in.national_values.Q_NVGUIPERM = dice.chance(0.5);
    determine(*d, in.train, in.national_values, in.fixed, in.brakes, in.gradient, in.conditions);
    const Decelerations fresh = determined(in);
    EXPECT_EQ(d->segments, fresh.segments);
    EXPECT_EQ(d->segments_for_TSR, fresh.segments_for_TSR);
    EXPECT_EQ(d->segments_for_TSR.empty(), !in.gradient.default_for_TSR.has_value());
    EXPECT_EQ(d->normal_service[0].empty(), !in.national_values.Q_NVGUIPERM);
    EXPECT_EQ(d->highest_safe, fresh.highest_safe);
    EXPECT_EQ(d->highest_expected, fresh.highest_expected);
    const Reference r(in);
    std::vector<double> places = r.borders();
    places.push_back(-1e8);
    EXPECT_EQ(d->highest_safe.si, highest(r, true, places));
    EXPECT_EQ(d->highest_expected.si, highest(r, false, places));
    for (const Segments* s : {&d->segments, &d->segments_for_TSR})
      for (std::size_t n = 1; n < s->size(); ++n) EXPECT_LT((*s)[n - 1].from, (*s)[n].from);
    // The conversion model has no special brakes (3.13.2.2.6.3).
    if (in.train.brake_model != train::BrakeModel::lambda) continue;
    Inputs plain = in;
    plain.conditions = {};
    plain.conditions.reduced_adhesion = in.conditions.reduced_adhesion;
    plain.conditions.slippery_rail = in.conditions.slippery_rail;
    EXPECT_EQ(d->segments, determined(plain).segments);
  }
}

TEST(ReferenceModel, DecelerationsAtEveryBorderAndStepOfSpeed) {
  for (int i = 0; i < cases(500); ++i) {
    Dice dice(static_cast<std::uint64_t>(i));
    const Inputs in = rich_inputs(dice);
    const Decelerations d = determined(in);
    for (const bool TSR : {false, true}) {
      const Reference r(in, TSR);
      const std::vector<double> borders = r.borders();
      for (const CurveKind kind : kKinds) {
        const std::vector<double> steps = r.speed_steps(kind);
        for (const double b : borders)
          for (const double x : {b, b - kTiny}) {
            // One speed of every kind at every place, in turn: standstill, a step, just above it, any.
            const double step =
                steps.empty() ? 0.0 : steps[static_cast<std::size_t>(dice.integer(0, 99)) % steps.size()];
            const double V =
                std::array{0.0, step, step + 1e-6, dice.real(0.0, 60.0)}[static_cast<std::size_t>(dice.integer(0, 3))];
            const double w_V = std::sqrt(V * V) == V ? V : 0.0;
            ASSERT_NEAR(d.at(kind, {w_V}, {{x}}, TSR).si, r.A(kind, w_V, x), 1e-12)
                << i << " kind " << static_cast<int>(kind) << " V " << w_V << " at " << x;
          }
      }
    }
  }
}

void expect_curve(const BrakingCurve& curve, const ReferenceCurve& r, Dice& dice, const char* what, int seed) {
  SCOPED_TRACE(testing::Message() << what << ", case " << seed);
  ASSERT_TRUE(curve.exists());
  ASSERT_FALSE(curve.warnings.truncated);
  ASSERT_EQ(curve.warnings.no_deceleration, r.no_deceleration);
  for (std::size_t n = 1; n < curve.knots.size(); ++n) {
    ASSERT_LE(curve.knots[n].x, curve.knots[n - 1].x);
    ASSERT_GE(curve.knots[n].w, curve.knots[n - 1].w);
  }
  const double foot = curve.view().foot().from_origin.si;
  const auto at = [&](double x) {
    ASSERT_NEAR(curve.view().speed_squared_at({{x}}).si, r.w_at(x), 1e-6) << "at " << x;
  };
  for (const auto& v : r.walk)
    if (v.x > -1e6) at(v.x);
  for (int n = 0; n < 10; ++n) at(foot - dice.real(0.0, 6000.0));
  at(foot + 1.0);
  if (r.foot_w() > 0.0) {
    ASSERT_EQ(curve.place_at({0.0}), curve.view().foot());
  }
  for (int n = 0; n < 10; ++n) {
    const double V = dice.chance(0.5) ? 2.5 * dice.integer(0, 40) : dice.real(0.0, 100.0);
    if (V * V <= r.foot_w() + 1e-6) continue;
    // At exactly the speed of a level stretch, rounding may select either end: left out.
    const double x = r.place_of(V * V);
    const double y = r.place_of(V * V + 1e-6);
    if (x - y > 1e-3) continue;
    ASSERT_NEAR(curve.place_at({V}).from_origin.si, std::max(x, -1e9), 1e-3) << "V " << V;
  }
}

TEST(ReferenceModel, CurvesOfRichTracks) {
  int falling = 0;
  for (int i = 0; i < cases(1200); ++i) {
    Dice dice(static_cast<std::uint64_t>(i) + 1000000);
    const Inputs in = rich_inputs(dice);
    const Decelerations d = determined(in);
    const bool TSR = dice.chance(0.3);
    const Reference r(in, TSR);
    const double anchor = 50.0 * dice.integer(20, 120);
    const double V_foot = dice.chance(0.4) ? 0.0 : 2.5 * dice.integer(0, 16);
    const double V_anchor = V_foot + (dice.chance(0.5) ? 0.0 : dice.chance(0.5) ? 2.5 : dice.real(0.0, 4.0));
    for (const CurveKind kind : kKinds) {
      const ReferenceCurve expected(r, kind, anchor, V_anchor, V_foot, in.V_top->si);
      const BrakingCurve curve = trace(d, kind, TSR, {{anchor}}, {V_anchor}, {V_foot}, *in.V_top);
      falling += expected.no_deceleration;
      expect_curve(curve, expected, dice, kind == CurveKind::EBD ? "EBD" : kind == CurveKind::SBD ? "SBD" : "GUI", i);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(falling, 50);
}

}  // namespace
