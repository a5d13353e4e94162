// `explain` and `speeds_at` compared with the limits and the independent model.
#include <gtest/gtest.h>

#include <memory>

#include "sdm/evaluate.h"
#include "sdm/test_reference_curves.h"

namespace {

using namespace evc;
using namespace evc::sdm;
using namespace evc::sdm::test;

Inputs random_track(Dice& dice, int i) {
  Inputs in = rich_inputs(dice);
  in.revision = 1;
  in.srs = static_cast<SrsVersion>(i % 3);
  in.national_values.Q_NVGUIPERM = dice.chance(0.4);
  in.national_values.Q_NVINHSMICPERM = dice.chance(0.4);
  for (auto& s : in.gradient.permille.steps) s.value = std::max(s.value, -15.0);  // trains that brake everywhere
  for (auto& e : in.train.emergency)
    for (auto& s : e.steps.steps) s.value.A_brake_emergency += Acceleration{0.3};
  (void)in.mrsp.append({{-2000.0}}, {50.0});
  (void)in.mrsp.append({{50.0 * dice.integer(20, 60)}}, {2.5 * dice.integer(0, 10)});
  in.mrsp_due_to_TSR[1] = dice.chance(0.5);
  const double EOA = 50.0 * dice.integer(65, 120);
  set_EOA(in, EOA, EOA + 50.0 * dice.integer(0, 10));
  return in;
}

/// The brake at the place where the curve has the speed; none if this is too close to a border to decide.
void expect_decelerations(const Explanation& e, const Inputs& in, const Target& t, Speed V) {
  const Reference r(in, t.due_to_TSR);
  const Reference plain(in);
  const auto clear = [&](double x) {
    for (const double b : r.borders())
      if (std::abs(b - x) < 1e-6) return false;
    return true;
  };
  const double x = e.d_EBD.from_origin.si;
  if (clear(x)) {
    EXPECT_NEAR(e.A_safe.si, r.A(CurveKind::EBD, V.si, x), 1e-12);
    EXPECT_NEAR(e.A_gradient_EBD.si, r.A_gradient(x), 1e-12);
    const auto used = train::in_use_emergency(in.train, in.brakes, r.inhibited(x, false));
    EXPECT_EQ(e.A_brake_safe, train::value_below(r.safe[used], V));  // before the cap of reduced adhesion
    EXPECT_EQ(e.A_brake_emergency, train::value_below(train::A_brake_emergency(in.train, used), V));
  }
  const double z = e.d_SBD.value_or(e.d_EBD).from_origin.si;
  if (clear(z)) {
    EXPECT_NEAR(e.A_expected.si, plain.A(CurveKind::SBD, V.si, z), 1e-12);
    EXPECT_NEAR(e.A_gradient_SBD.si, plain.A_gradient(z), 1e-12);
    EXPECT_EQ(e.A_brake_service.si, plain.A_brake(CurveKind::SBD, V.si, z));
  }
}

TEST(ReferenceExplain, EveryValueIsTheOneOfItsTarget) {
  for (int i = 0; i < cases(300); ++i) {
    SCOPED_TRACE(i);
    Dice dice(static_cast<std::uint64_t>(i) + 40000);
    const Inputs in = random_track(dice, i);
    const auto d = built(in);
    for (const Target& t : d->targets) {
      const Speed V{dice.chance(0.5) ? 2.5 * dice.integer(0, 40) : dice.real(0.0, 70.0)};
      const Speed V_ura{dice.real(0.0, 2.0)};
      const Acceleration A_est{dice.real(-0.5, 0.8)};
      Motion motion;
      motion.est_front = {{dice.real(-1000.0, 6000.0)}};
      motion.min_safe_front = motion.est_front - Distance{dice.real(0.0, 300.0)};
      const Explanation e = explain(*d, in, t, V, V_ura, A_est, &motion);
      const Approach a = approach(V, in.national_values.Q_NVINHSMICPERM ? Speed{0.0} : V_ura, A_est, in.fixed);
      TimesAsked asked;
      if (d->rules.reduced_build_up) asked.reduced_from = Fronts{motion.est_front, motion.min_safe_front};
      const TargetLimits l = limits_of(*d, t, a, asked);
      EXPECT_EQ(e.times, l.times.EBD);
      EXPECT_EQ(e.build_up, train::build_up_times(in.train, in.national_values, in.brakes, t.V_target.si == 0.0));
      EXPECT_EQ(e.EBD.d_I, l.EBD.d_I);
      const bool stop = t.kind == TargetKind::EOA_SvL;
      ASSERT_EQ(e.SBD.has_value(), stop);
      EXPECT_EQ(e.d_EBD, d->view(t.EBD).place_at(V));
      ASSERT_EQ(e.d_SBD.has_value(), stop);
      ASSERT_EQ(e.d_GUI.has_value(), d->guidance);
      Place d_FLOI = l.EBD.d_SBI;
      Place d_W = l.EBD.d_W;
      Place d_P = in.srs == SrsVersion::v3_4_0 ? std::min(l.EBD.d_P, t.d_target) : l.EBD.d_P;
      Place d_I = l.EBD.d_I;
      if (stop) {
        EXPECT_EQ(*e.d_SBD, d->view(t.SBD).place_at(V));
        d_FLOI = std::min(d_FLOI, l.SBD->d_SBI);
        d_W = std::min(d_W, l.SBD->d_W);
        d_P = std::min(d_P, l.SBD->d_P);
        d_I = std::min(d_I, l.SBD->d_I);
      }
      EXPECT_EQ(e.d_FLOI, d_FLOI);
      EXPECT_EQ(e.d_W, d_W);
      EXPECT_EQ(e.d_P, d_P);
      EXPECT_EQ(e.d_I, d_I);
      if (d->guidance) {
        const Place GUI = d->view(t.GUI).place_at(V);
        EXPECT_EQ(*e.d_GUI, stop ? std::min(GUI, d->view(t.GUI_EOA).place_at(V)) : GUI);
      }
      expect_decelerations(e, in, t, V);
      // Without a place: a train about to reach its first limit by unreduced times.
      if (!d->rules.reduced_build_up) continue;
      const TargetLimits earliest = limits_of(*d, t, a, {});
      const Place here = stop ? std::min(earliest.EBD.d_I, earliest.SBD->d_I) : earliest.EBD.d_I;
      const Explanation nowhere = explain(*d, in, t, V, V_ura, A_est);
      EXPECT_EQ(nowhere.est_front, here);
      EXPECT_EQ(nowhere.min_safe_front, here);
      EXPECT_EQ(nowhere.times, limits_of(*d, t, a, {{}, Fronts{here, here}}).times.EBD);
    }
    if (HasFailure()) return;
  }
}

TEST(ReferenceExplain, TheSpeedsAtAPlaceAreTheLastOnesWithTheirLimitBeyondIt) {
  for (int i = 0; i < cases(100); ++i) {
    SCOPED_TRACE(i);
    Dice dice(static_cast<std::uint64_t>(i) + 60000);
    Inputs in = random_track(dice, i);
    const Place x{{dice.real(0.0, 6000.0)}};
    const Distance under_reading{dice.real(0.0, 400.0)};
    if (i % 2 == 0)
      (void)in.conditions.reduced_adhesion.push_back(
          {x - Distance{in.train.L_TRAIN.si + 100.0}, x - Distance{in.train.L_TRAIN.si + 50.0}});
    const auto d = built(in);
    const Speed V_ura{dice.real(0.0, 2.0)};
    const Acceleration A_est{dice.real(-0.5, 0.8)};
    Motion here;
    here.est_front = here.max_safe_front = x;
    here.min_safe_front = x - under_reading;
    for (const Target& t : d->targets) {
      const PositionRow row = speeds_at(*d, in, t, x, V_ura, A_est, under_reading);
      EXPECT_EQ(row.EBD, d->view(t.EBD).speed_at(x));
      EXPECT_EQ(row.SBD, t.kind == TargetKind::EOA_SvL ? d->view(t.SBD).speed_at(x) : Speed{});
      const auto expect = [&](Speed V, auto pick, const char* what) {
        const auto place = [&](Speed of) { return pick(explain(*d, in, t, of, V_ura, A_est, &here)); };
        if (V.si > 0.0) {
          EXPECT_GE(place(V), x) << what;
        }
        if (V < *in.V_top) {
          EXPECT_LE(place(V + Speed{1e-9}), x) << what;
        }
      };
      expect(
          row.EBI, [](const Explanation& e) { return *e.EBD.d_EBI; }, "EBI");
      expect(
          row.SBI, [](const Explanation& e) { return e.d_FLOI; }, "SBI");
      expect(
          row.W, [](const Explanation& e) { return e.d_W; }, "W");
      expect(
          row.P, [](const Explanation& e) { return e.d_P; }, "P");
      expect(
          row.I, [](const Explanation& e) { return e.d_I; }, "I");
    }
    if (HasFailure()) return;
  }
}

TEST(ReferenceExplain, EndsOfTheSearchForASpeed) {
  Inputs in = simple_inputs(SrsVersion::v3_4_0);
  in.V_top = Speed{59.9};
  ASSERT_TRUE(in.mrsp.append({{4000.0}}, {10.0}));
  const auto d = built(in);
  const Target& t = d->targets[0];
  // At the limit of the highest speed, exactly that speed is returned (bisection would only come close); also further
  // upstream.
  const Explanation top = explain(*d, in, t, {59.9}, {}, {});
  EXPECT_EQ(speeds_at(*d, in, t, *top.EBD.d_EBI, {}, {}).EBI.si, 59.9);
  EXPECT_EQ(speeds_at(*d, in, t, *top.EBD.d_EBI - Distance{1.0}, {}, {}).EBI.si, 59.9);
  EXPECT_LT(speeds_at(*d, in, t, *top.EBD.d_EBI + Distance{1.0}, {}, {}).EBI.si, 59.9);
  // All speeds up to the target's have their limit at one place; at this place and beyond no speed is left, the safe
  // side.
  const Place last = *explain(*d, in, t, {0.0}, {}, {}).EBD.d_EBI;
  ASSERT_EQ(*explain(*d, in, t, {10.0}, {}, {}).EBD.d_EBI, last);
  EXPECT_EQ(speeds_at(*d, in, t, last, {}, {}).EBI.si, 0.0);
  EXPECT_GE(speeds_at(*d, in, t, last - Distance{kTiny}, {}, {}).EBI.si, 10.0);
  EXPECT_EQ(speeds_at(*d, in, t, last + Distance{1.0}, {}, {}).EBI.si, 0.0);
}

TEST(ReferenceExplain, PIsDrawnToTheTargetAtMostIn340Only) {
  for (const auto srs : {SrsVersion::v3_4_0, SrsVersion::v3_6_0}) {
    Inputs in = simple_inputs(srs);
    in.train.T_traction_cut_off = {0.0};
    in.train.T_emergency[0].T_brake = {0.1};
    ASSERT_TRUE(in.mrsp.append({{4000.0}}, {10.0}));
    const auto d = built(in);
    const Explanation e = explain(*d, in, d->targets[0], {1.0}, {}, {});
    EXPECT_GT(e.EBD.d_P.from_origin.si, 4000.0);
    EXPECT_EQ(e.d_P, srs == SrsVersion::v3_4_0 ? Place{{4000.0}} : e.EBD.d_P);
  }
}

TEST(ReferenceExplain, ReducedAdhesionUnderTheMinSafeFrontEndCounts) {
  // Reduced adhesion up to 4840 m plus the train length; the train is at 4900 m or just before.
  Inputs in = simple_inputs(SrsVersion::v4_0_0);
  in.train.service_brake_interface = false;
  in.train.T_traction_cut_off = {0.0};
  in.train.T_emergency[0].T_brake = {14.0};
  set_EOA(in, 5000.0, 5000.0);
  ASSERT_TRUE(in.conditions.reduced_adhesion.push_back({{{4690.0}}, {{4740.0}}}));
  const auto d = built(in);
  Motion m = at(4900.0, 10.0);
  EXPECT_LT(explain(*d, in, d->targets[0], {10.0}, {}, {}, &m).times.T_be.si, 13.9);
  m.min_safe_front = {{4800.0}};
  EXPECT_EQ(explain(*d, in, d->targets[0], {10.0}, {}, {}, &m).times.T_be.si, 14.0);
  const auto EBI = [&](double under_reading) {
    return speeds_at(*d, in, d->targets[0], {{4900.0}}, {}, {}, {under_reading}).EBI;
  };
  EXPECT_EQ(EBI(50.0), EBI(0.0));
  EXPECT_LT(EBI(100.0), EBI(0.0));
}

TEST(ReferenceExplain, InFrontOfTheProfileAndWhereNoSpeedIsAllowed) {
  Inputs in = simple_inputs();
  in.gradient.permille = {};
  ASSERT_TRUE(in.gradient.permille.append({{1000.0}}, 10.0));
  set_EOA(in, 2000.0, 2000.0);
  auto d = built(in);
  // The gradient is unknown in front of the profile and until the train is on it.
  EXPECT_EQ(explain(*d, in, d->targets.back(), {50.0}, {}, {}).A_gradient_EBD.si, 0.0);
  EXPECT_GT(explain(*d, in, d->targets.back(), {10.0}, {}, {}).A_gradient_EBD.si, 0.0);
  // A fall too steep for the brake: the speed has no place.
  in.gradient.permille.steps[0] = {{{-1e9}}, -200.0};
  ++in.revision;
  d = built(in);
  EXPECT_EQ(explain(*d, in, d->targets.back(), {10.0}, {}, {}).d_EBD.from_origin.si, -1e9);
}

}  // namespace
