// Times, reduced build-up times, limits and locations of 3.13.9, 3.11.11 and A.3.12 compared with a separate model:
// plain numbers from the text of the clauses, equations solved by bisection. Curves (3.13.8), decelerations (3.13.6)
// and the times of the brake model are those of the product; they have their own tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "sdm/evaluate.h"
#include "sdm/locations.h"
#include "sdm/reduced_build_up.h"
#include "sdm/test_cases.h"

namespace {

using namespace evc;
using namespace evc::sdm;
using namespace evc::sdm::test;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// ---- The model ---------------------------------------------------------------------------------------

/// The train data, national values and version on which the times depend.
struct Setting {
  double T_cut_off;
  bool cut_off_at_warning, SB, feedback;
  bool later_than_340, reduces;
};
Setting setting_of(const Inputs& in) {
  return {in.train.T_traction_cut_off.si,
          in.train.traction_cut_off_interface,
          in.train.service_brake_interface && in.national_values.Q_NVSBTSMPERM,
          in.train.service_brake_feedback && in.national_values.Q_NVSBFBPERM,
          in.srs != SrsVersion::v3_4_0,
          in.srs == SrsVersion::v4_0_0};
}

double traction_time(const Setting& s, double T_bs2) {
  return s.cut_off_at_warning ? std::max(s.T_cut_off - 2.0 - T_bs2, 0.0) : s.T_cut_off;
}

struct ModelTimes {
  double bs1 = 0.0, bs2 = 0.0, traction = 0.0, be = 0.0, indication = 0.0;
  double rest() const { return std::max(be - traction, 0.0); }
};
ModelTimes model_times(const Setting& s, double T_be, double T_bs, const std::optional<FeedbackTimes>& in_action) {
  ModelTimes t;
  if (s.SB) {
    t.bs1 = t.bs2 = T_bs;
    if (s.feedback && in_action.has_value()) {
      t.bs1 = in_action->T_bs1.si;
      t.bs2 = in_action->T_bs2.si;
    }
    if (s.feedback && t.bs2 < 2.0) t.bs2 = 2.0;
  }
  t.be = T_be;
  t.traction = traction_time(s, t.bs2);
  t.indication = s.feedback || 0.8 * T_bs < 5.0 ? 5.0 : 0.8 * T_bs;
  if (s.later_than_340) t.indication += 4.0;
  return t;
}

/// Exact for polynomials of the third degree (Simpson).
template <class F>
double integral(F f, double a, double b) {
  return (b - a) / 6.0 * (f(a) + 4.0 * f((a + b) / 2.0) + f(b));
}
/// The zero of a rising function.
template <class F>
double zero_of(F f, double low, double high) {
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2.0;
    (f(middle) >= 0.0 ? high : low) = middle;
  }
  return high;
}

struct ModelRamp {
  double T, react, v0, Vt;
  bool stop;
  double a1 = 0.0, a2 = 0.0, T_max = 0.0, T_min = 0.0;  // A_est1, A_est2, T_traction_max, T_traction_min
  double A_brake = 0.0, A_max = 0.0;
};
/// A.3.12.3-8.
double model_reduced(const ModelRamp& r) {
  if (r.T <= r.react) return r.T;
  const double full = 2.0 * r.T - r.react;
  const double V_t1 = integral([&](double t) { return t <= r.T_max ? r.a1 : r.a2; }, 0.0, 0.0) + r.v0 +
                      (r.T_max < r.react ? r.a1 * r.T_max + r.a2 * (r.react - r.T_max) : r.a1 * r.react);
  if (r.stop ? V_t1 == 0.0 : V_t1 <= r.Vt) return r.react;
  // Loss of speed by the brake up to a time on the ramp.
  const auto taken = [&](double t) {
    return integral([&](double u) { return r.A_brake * (u - r.react) / (full - r.react); }, r.react, t);
  };
  const auto gained = [&](double t) { return r.a1 * r.T_max + r.a2 * (t - r.T_max); };
  const double V_t2 = std::max(0.0, r.v0 + gained(full) - taken(full));
  if (r.stop ? V_t2 > 0.0 : V_t2 >= r.Vt) return r.T;
  if (r.A_max <= 0.0) return r.T;
  // t2_enough; later than the end of the ramp: the full brake effort is needed.
  const double above = std::max(0.0, r.v0 - r.Vt);
  const auto reached = [&](double t) { return taken(t) - gained(t) - above; };
  if (reached(full) <= 0.0) return r.T;
  const double enough = zero_of(reached, r.react, full);
  const double D = integral([&](double t) { return r.v0 + r.a1 * t; }, 0.0, r.T_max) +
                   integral([&](double t) { return r.v0 + gained(t); }, r.T_max, enough) -
                   integral(taken, r.react, enough);
  // The step model: nothing until `t`, then A_max down to the target speed.
  const auto speed = [&](double t) { return r.v0 + r.a1 * r.T_min + r.a2 * (t - r.T_min); };
  const auto run = [&](double t) {
    return integral([&](double u) { return r.v0 + r.a1 * u; }, 0.0, r.T_min) + integral(speed, r.T_min, t) +
           (speed(t) * speed(t) - r.Vt * r.Vt) / (2.0 * r.A_max) - D;
  };
  const double least = (r.react + enough) / 2.0;
  if (least >= r.T || run(r.T) <= 0.0) return r.T;
  return run(least) >= 0.0 ? least : zero_of(run, least, r.T);
}

struct ModelRange {
  double A_brake = kInfinite, A_max = -kInfinite;
};
/// Lowest brake deceleration and highest deceleration in [from, to] x [low, high]. A place on a border belongs to the
/// segment that begins there, a speed on a step to the step that ends there.
ModelRange model_range(const Decelerations& d, CurveKind kind, bool TSR, double from, double to, double adhesion_from,
                       double low, double high) {
  const Segments& segments = d.segments_of(TSR);
  const auto meets = [&](std::size_t i, double a, double b) {
    const double begin = i == 0 ? -kInfinite : m(segments[i].from);
    const double end = i + 1 == segments.size() ? kInfinite : m(segments[i + 1].from);
    return begin <= b && end > a;
  };
  bool slippery = false;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i].reduced_adhesion && meets(i, adhesion_from, to)) slippery = true;
  ModelRange range;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!meets(i, from, to)) continue;
    const Bands& bands = d.bands(kind, segments[i]);
    for (std::size_t k = 0; k < bands.size(); ++k) {
      const double above = k == 0 ? -1.0 : bands[k - 1].w_upto.si;
      if (bands[k].w_upto.si < low * low || above >= high * high) continue;
      range.A_brake = std::min(range.A_brake, bands[k].A[slippery ? 1 : 0].si);
      range.A_max =
          std::max(range.A_max, bands[k].A[segments[i].reduced_adhesion ? 1 : 0].si + segments[i].A_gradient.si);
    }
  }
  return range;
}

struct ModelLoss {
  double V_bec, D_bec;
};
ModelLoss model_loss(double V, double V0, double A_est, const ModelTimes& t, double Vt) {
  const double a1 = A_est > 0.0 ? A_est : 0.0;
  const double a2 = a1 > 0.4 ? 0.4 : a1;
  const double after = V + V0 + a1 * t.traction;
  return {std::max(after, Vt) + a2 * t.rest(), std::max(V + V0 + a1 * t.traction / 2.0, Vt) * t.traction +
                                                   (std::max(after, Vt) + a2 * t.rest() / 2.0) * t.rest()};
}

struct ModelLimits {
  double EBI = 0.0, SBI = 0.0, W = 0.0, P = 0.0, I = 0.0;
};
/// From SBI on; `cap`: P not beyond it.
ModelLimits model_limits(double SBI, CurveView GUI, double V, double T_indication, double cap) {
  ModelLimits l;
  l.SBI = SBI;
  l.W = SBI - 2.0 * V;
  l.P = SBI - 4.0 * V;
  l.P = std::min(l.P, GUI.exists() ? m(GUI.place_at({V})) : cap);
  l.I = l.P - V * T_indication;
  return l;
}

/// One target and one speed.
struct Model {
  const Inputs& in;
  const Derived& d;
  const Target& t;
  double V, V0, A_est;
  std::optional<FeedbackTimes> in_action;
  std::optional<Fronts> fronts;
  Setting s = setting_of(in);
  train::BuildUpTimes full = train::build_up_times(in.train, in.national_values, in.brakes, t.V_target.si == 0.0);
  bool stop = t.kind == TargetKind::EOA_SvL || t.kind == TargetKind::SR_end;

  double T_bs(double end) const {
    if (!s.reduces || !fronts.has_value() || s.feedback) return full.T_bs.si;
    ModelRamp r{full.T_bs.si, full.T_bs_react.si, V, t.V_target.si, stop};
    const double from = std::min(m(fronts->est), end);
    if (V > t.V_target.si) {
      const ModelRange a = model_range(d.decelerations, CurveKind::SBD, t.due_to_TSR, from, end, from, r.Vt, V);
      r.A_brake = a.A_brake;
      r.A_max = a.A_max;
    }
    return model_reduced(r);
  }
  double T_be(const ModelTimes& unreduced) const {
    // T_be = 0: Kt_int = 0 (A.3.12.1.4).
    if (!s.reduces || !fronts.has_value() || full.T_be.si == 0.0) return full.T_be.si;
    if (unreduced.traction >= full.T_be.si) return full.T_be.si;
    ModelRamp r{full.T_be.si, full.T_be_react.si, V + V0, t.V_target.si, stop};
    r.a1 = std::max(A_est, 0.0);
    r.a2 = std::min(r.a1, 0.4);
    r.T_max = traction_time(s, s.SB ? full.T_bs_react.si : 0.0);
    r.T_min = traction_time(s, s.SB ? full.T_bs.si : 0.0);
    const double end = m(t.d_target);
    const ModelRange a =
        model_range(d.decelerations, CurveKind::EBD, t.due_to_TSR, std::min(m(fronts->est), end), end,
                    std::min(m(fronts->min_safe), end), r.Vt, model_loss(V, V0, A_est, unreduced, r.Vt).V_bec);
    r.A_brake = a.A_brake;
    r.A_max = a.A_max;
    return model_reduced(r);
  }
  ModelTimes times_EBD() const {
    ModelTimes u = model_times(s, full.T_be.si, T_bs(m(t.d_target)), in_action);
    u.be = T_be(u);
    return u;
  }
  ModelTimes times_SBD() const { return model_times(s, full.T_be.si, T_bs(m(t.d_EOA)), in_action); }
  ModelLimits EBD() const {
    const ModelTimes u = times_EBD();
    const ModelLoss loss = model_loss(V, V0, A_est, u, t.V_target.si);
    const double EBI = m(d.view(t.EBD).place_at({loss.V_bec})) - loss.D_bec;
    ModelLimits l = model_limits(EBI - V * u.bs2, d.view(t.GUI), V, u.indication,
                                 in.srs == SrsVersion::v4_0_0 ? m(t.d_target) : kInfinite);
    l.EBI = EBI;
    if (s.reduces && in_action.has_value()) l.I = as_without_feedback().EBD().I;
    return l;
  }
  ModelLimits SBD() const {
    const ModelTimes u = times_SBD();
    ModelLimits l =
        model_limits(m(d.view(t.SBD).place_at({V})) - V * u.bs1, d.view(t.GUI_EOA), V, u.indication, kInfinite);
    if (s.reduces && in_action.has_value()) l.I = as_without_feedback().SBD().I;
    return l;
  }
  /// 3.13.9.3.6.5: T_bs1 = T_bs2 = T_bs.
  Model as_without_feedback() const { return {in, d, t, V, V0, A_est, {}, fronts}; }
};

double f41(double V) {
  const double v = V * 3.6;
  return (v <= 30.0 ? 2.0 : 2.0 + (v - 30.0) / 47.0) / 3.6;
}
double margin(double V, double least, double most, double from, double to) {
  const double v = V * 3.6;
  return (v <= from ? least : std::min(least + (most - least) / (to - from) * (v - from), most)) / 3.6;
}
double ebi_margin(double V) { return margin(V, 7.5, 15.0, 110.0, 210.0); }
double sbi_margin(double V) { return margin(V, 5.5, 10.0, 110.0, 210.0); }
double warning_margin(double V) { return margin(V, 4.0, 5.0, 110.0, 140.0); }

// ---- Cases -------------------------------------------------------------------------------------------

template <class Steps>
void random_steps(Dice& dice, Steps& steps, double low, double high) {
  (void)steps.append({0.0}, {dice.real(low, high)});
  if (dice.chance(0.5)) (void)steps.append({dice.real(5.0, 30.0)}, {dice.real(low, high)});
}

/// random_case with features it never has: guidance, feedback, a regenerative brake and zones where it is off, times of
/// 0, targets of TSRs, the end of the SR distance, low speeds and any acceleration.
RandomCase wide_case(std::uint64_t seed) {
  RandomCase c = random_case(seed, static_cast<SrsVersion>(seed % 3));
  Dice dice(seed ^ 0x71a3e5ull);
  train::TrainData& t = c.in.train;
  train::NationalValues& v = c.in.national_values;
  const bool gamma = t.brake_model == train::BrakeModel::gamma;
  if (dice.chance(0.3)) {
    v.Q_NVGUIPERM = true;
    t.normal_service.A_SB01 = {dice.real(0.3, 0.8)};
    t.normal_service.A_SB12 = t.normal_service.A_SB01 + Acceleration{dice.real(0.0, 0.3)};
    for (auto& model : t.normal_service.A_brake_normal_service) random_steps(dice, model, 0.2, 0.9);
    random_steps(dice, t.Kn_plus, 0.0, 5.0);
    random_steps(dice, t.Kn_minus, 0.0, 5.0);
  }
  if (dice.chance(0.25)) {
    v.Q_NVSBFBPERM = dice.chance(0.8);
    t.service_brake_feedback = dice.chance(0.8);
  }
  if (dice.chance(0.3)) t.T_traction_cut_off = {dice.chance(0.5) ? 0.0 : dice.real(0.0, 2.0)};
  if (gamma) {
    for (auto* times : {&t.T_emergency[0], &t.T_service[0]}) {
      const int kind = dice.integer(0, 9);
      if (kind == 0) times->T_brake_react = {0.0};
      if (kind == 1) times->T_brake_react = times->T_brake;
      if (kind > 5) times->T_brake_react = {dice.real(0.0, times->T_brake.si)};
    }
    if (dice.chance(0.4)) {
      t.regenerative = train::SpecialBrakeInterface::both;
      train::EmergencyModel e;
      train::EmergencyStep step;
      step.A_brake_emergency = {dice.real(0.5, 2.0)};
      step.Kdry_rst.fill(train::Factor::of(1.0));
      (void)e.steps.append({0.0}, step);
      e.with = train::kRegenerative;
      (void)t.emergency.push_back(e);
      c.in.conditions.regenerative_off = Place{{dice.real(0.0, 8000.0)}};
    }
  } else {
    if (dice.chance(0.2)) v.Kt_int = dice.chance(0.5) ? 0.0 : dice.real(0.0, 1.5);
    // A configured service brake time is used if it is shorter, even than the reaction time.
    if (dice.chance(0.3)) (void)t.T_service.push_back({{dice.real(0.5, 4.0)}, {dice.real(0.0, 4.0)}, 0});
  }
  if (dice.chance(0.4)) {
    c.in.gradient.default_for_TSR = static_cast<double>(dice.integer(-15, 15));
    c.in.gradient.known_to = Place{{dice.real(0.0, 6000.0)}};
    for (std::size_t i = 0; i < c.in.mrsp.size(); ++i) c.in.mrsp_due_to_TSR[i] = dice.chance(0.5);
  }
  if (dice.chance(0.15)) c.in.SR_end = Place{{dice.real(500.0, 6000.0)}};
  c.motion.A_est = {dice.chance(0.2) ? 0.0 : dice.real(-1.0, 1.0)};
  return c;
}

/// Speeds to test, and relevant places of the train for the target.
double speed_for(Dice& dice, const Inputs& in, const Target& t) {
  const double Vt = t.V_target.si;
  switch (dice.integer(0, 5)) {
    case 0:
      return Vt;
    case 1:
      return Vt + dice.real(0.0, 1.0);
    case 2:
      return Vt + dice.real(0.0, 8.0);
    case 3:
      return std::max(0.0, Vt - dice.real(0.0, 3.0));
    case 4:
      return dice.chance(0.3) ? 0.0 : dice.real(0.0, 3.0);
    default:
      return dice.real(0.0, in.train.V_MAXTRAIN.si * 1.1);
  }
}
Fronts fronts_for(Dice& dice, const Target& t) {
  const double est = m(t.d_target) + (dice.chance(0.2) ? dice.real(0.0, 100.0) : -dice.real(0.0, 1500.0));
  return {{{est}}, {{est - dice.real(0.0, 300.0)}}};
}
std::optional<FeedbackTimes> feedback_for(Dice& dice, const Inputs& in, double T_bs) {
  if (!setting_of(in).feedback || dice.chance(0.4)) return std::nullopt;
  const double T = dice.chance(0.3) ? 0.0 : dice.real(0.0, T_bs);
  return FeedbackTimes{{T}, {T}};
}

void expect_near(double value, double expected, const char* what, std::uint64_t seed) {
  ASSERT_NEAR(value, expected, 1e-7 * std::max(1.0, std::abs(expected) / 1e3)) << what << ", seed " << seed;
}

// ---- Tests -------------------------------------------------------------------------------------------

TEST(ReferenceTimes, OfEveryConfiguration) {
  for (int i = 0; i < 3000; ++i) {
    Dice dice(static_cast<std::uint64_t>(i));
    const auto time = [&] { return dice.chance(0.2) ? 0.0 : dice.real(0.0, 12.0); };
    const TimeConfig c{{time()}, dice.chance(0.5), dice.chance(0.5), dice.chance(0.5)};
    const train::BuildUpTimes b{{time()}, {time()}, {time()}, {time()}};
    std::optional<FeedbackTimes> in_action;
    if (dice.chance(0.5)) in_action = FeedbackTimes{{time()}, {time()}};
    const auto srs = static_cast<SrsVersion>(i % 3);
    const Setting s{c.T_traction_cut_off.si, c.traction_cut_off_interface, c.service_brake_available,
                    c.feedback_available,    srs != SrsVersion::v3_4_0,    srs == SrsVersion::v4_0_0};
    const ModelTimes expected = model_times(s, b.T_be.si, b.T_bs.si, in_action);
    const Times t = times(c, b, in_action, rules_of(srs), train::FixedValues{});
    ASSERT_EQ(t.T_be, b.T_be) << i;
    ASSERT_EQ(t.T_bs, b.T_bs) << i;
    ASSERT_EQ(t.T_bs1.si, expected.bs1) << i;
    ASSERT_EQ(t.T_bs2.si, expected.bs2) << i;
    ASSERT_NEAR(t.T_traction.si, expected.traction, 1e-12) << i;
    ASSERT_NEAR(t.T_berem.si, expected.rest(), 1e-12) << i;
    ASSERT_NEAR(t.T_indication.si, expected.indication, 1e-12) << i;
  }
}

TEST(ReferenceTimes, MarginsOfTheCeiling) {
  const train::FixedValues f;
  for (int i = 0; i <= 600; ++i) {
    const double V = i / 3.6;
    ASSERT_NEAR(dV_ebi({V}, f).si, ebi_margin(V), 1e-12) << i;
    ASSERT_NEAR(dV_sbi({V}, f).si, sbi_margin(V), 1e-12) << i;
    ASSERT_NEAR(dV_warning({V}, f).si, warning_margin(V), 1e-12) << i;
  }
}

Ramp random_ramp(Dice& dice) {
  // Large and small ones: the equations must hold at walking speed too.
  const double scale = dice.chance(0.5) ? 1.0 : 0.05;
  Ramp r{.T = {scale * dice.real(0.5, 9.0)}};
  r.T_react = {dice.chance(0.1) ? r.T.si : dice.real(0.0, 1.1) * r.T.si};
  r.stop = dice.chance(0.4);
  r.V_target = {r.stop ? 0.0 : dice.real(0.0, 30.0) * scale};
  r.v0 = {std::max(0.0, r.V_target.si + dice.real(-2.0, 4.0) * scale)};
  if (dice.chance(0.1)) r.v0 = r.V_target;
  if (dice.chance(0.6)) r.A_est1 = {dice.real(0.0, 1.0)};
  r.A_est2 = {std::min(r.A_est1.si, 0.4)};
  r.T_traction_min = {dice.chance(0.3) ? 0.0 : dice.real(0.0, 1.2) * r.T.si};
  r.T_traction_max = {r.T_traction_min.si + (dice.chance(0.3) ? 0.0 : dice.real(0.0, 0.5) * r.T.si)};
  r.A.A_brake_min = {dice.real(0.2, 3.0)};
  r.A.A_max = {r.A.A_brake_min.si + dice.real(-0.3, 0.5)};
  return r;
}

TEST(ReferenceTimes, ReducedBuildUpTimes) {
  int reaction = 0;
  int between = 0;
  int full = 0;
  for (int i = 0; i < 20000; ++i) {
    Dice dice(static_cast<std::uint64_t>(i));
    const Ramp r = random_ramp(dice);
    const double expected =
        model_reduced({r.T.si, r.T_react.si, r.v0.si, r.V_target.si, r.stop, r.A_est1.si, r.A_est2.si,
                       r.T_traction_max.si, r.T_traction_min.si, r.A.A_brake_min.si, r.A.A_max.si});
    ASSERT_NEAR(reduced_build_up_time(r).si, expected, 1e-9) << i;
    ++(expected == r.T.si ? full : expected == r.T_react.si ? reaction : between);
    // The bound is not too high: below this target speed nothing is reduced.
    const Speed below = full_build_up_below(r, r.A.A_brake_min);
    if (r.T > r.T_react && r.V_target < below) {
      ASSERT_EQ(expected, r.T.si) << i;
    }
  }
  EXPECT_GT(reaction, 2000);
  EXPECT_GT(between, 2000);
  EXPECT_GT(full, 2000);
}

TEST(ReferenceTimes, TheSmallestAccelerationIsLikeNone) {
  // The distance decides: A_max is well above A_brake_min. At constant speed odometry does not measure exactly 0.
  Ramp r{.T = {6.0}, .T_react = {2.0}, .v0 = {30.0}, .V_target = {29.0}, .A = {{0.5}, {0.55}}};
  const double without = reduced_build_up_time(r).si;
  EXPECT_GT(without, 4.9);
  EXPECT_LT(without, 5.9);
  for (double A = 1e-6; A > 1e-20; A /= 10.0) {
    r.A_est1 = r.A_est2 = {A};
    EXPECT_NEAR(reduced_build_up_time(r).si, without, 100.0 * A + 1e-9) << A;
  }
}

TEST(ReferenceTimes, BordersOfTheReduction) {
  // Just at the target speed when the brake begins to act; not above it.
  Ramp r{.T = {4.0}, .T_react = {1.0}, .v0 = {10.0}, .V_target = {10.0}, .A = {{1.0}, {1.0}}};
  EXPECT_EQ(reduced_build_up_time(r).si, 1.0);
  // Just at it at the end of the ramp: 3 s with an average of half of 1 m/s2, from 13 m/s.
  r.v0 = {13.0};
  EXPECT_EQ(reduced_build_up_time(r).si, 4.0);
  // To a stop exactly at the end of the ramp.
  r = {.T = {4.0}, .T_react = {1.0}, .v0 = {3.0}, .stop = true, .A = {{1.0}, {1.0}}};
  EXPECT_EQ(reduced_build_up_time(r).si, 4.0);
  // Still moving at the end of the ramp: this decides on any track.
  r.v0 = {3.5};
  EXPECT_EQ(build_up_time_settled(r, {1.0}), r.T);
  r.v0 = {0.0};
  EXPECT_EQ(reduced_build_up_time(r).si, 1.0);
  // Slow, but not at standstill: not the reaction time.
  r.v0 = {0.5};
  EXPECT_NEAR(reduced_build_up_time(r).si, 0.75 + 2 * std::sqrt(6.0) / 3, 1e-12);
  // In a fall where the brake only just holds the train, the step model never reaches the target
  // speed.
  r.A.A_max = {0.0};
  EXPECT_EQ(reduced_build_up_time(r).si, 4.0);
  // No ramp: T is the reaction time.
  r.T_react = {4.0};
  EXPECT_EQ(reduced_build_up_time(r).si, 4.0);
  EXPECT_GT(full_build_up_below(r, {1.0}).si, 1e6);
}

TEST(ReferenceTimes, FullBuildUpIsKnownAsFarAsTheRampTells) {
  for (int i = 0; i < 3000; ++i) {
    Dice dice(static_cast<std::uint64_t>(i) + 50);
    Ramp r = random_ramp(dice);
    if (r.T <= r.T_react) continue;
    r.stop = false;
    r.A.A_max = r.A.A_brake_min;
    const Speed below = full_build_up_below(r, r.A.A_brake_min);
    r.V_target = below - Speed{1e-9};
    if (r.V_target.si > 0.0) {
      ASSERT_EQ(reduced_build_up_time(r), r.T) << i;
    }
    // Towards a higher target speed the time is reduced, unless the distance prevents it.
    r.V_target = below + Speed{1e-6};
    ASSERT_FALSE(build_up_time_settled(r, r.A.A_brake_min) == r.T) << i;
  }
}

TEST(ReferenceTimes, RangesAtBordersAndSteps) {
  for (int i = 0; i < 400; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const RandomCase c = wide_case(seed);
    Dice dice(seed + 900);
    const auto d = built(c.in);
    const bool TSR = dice.chance(0.5);
    const Segments& s = d->decelerations.segments_of(TSR);
    const auto place = [&] {
      const auto n = static_cast<std::size_t>(dice.integer(0, static_cast<int>(s.size()) - 1));
      return dice.chance(0.6) ? std::max(m(s[n].from), -20000.0) : dice.real(-3000.0, 9000.0);
    };
    for (int n = 0; n < 10; ++n) {
      const CurveKind kind = n % 2 == 0 ? CurveKind::EBD : CurveKind::SBD;
      const Bands& bands = d->decelerations.bands(kind, s[0]);
      const auto speed = [&] {
        const auto k = static_cast<std::size_t>(dice.integer(0, static_cast<int>(bands.size()) - 1));
        if (dice.chance(0.1)) return 0.0;
        return dice.chance(0.6) ? std::min(std::sqrt(bands[k].w_upto.si), 80.0) : dice.real(0.0, 60.0);
      };
      const auto [from, to] = std::minmax({place(), place()});
      const auto [low, high] = std::minmax({speed(), speed()});
      const double adhesion_from = dice.chance(0.5) ? from : std::min(from, place());
      const DecelerationRange r =
          deceleration_range(d->decelerations, kind, TSR, {{from}}, {{to}}, {{adhesion_from}}, {low}, {high});
      const ModelRange expected = model_range(d->decelerations, kind, TSR, from, to, adhesion_from, low, high);
      ASSERT_EQ(r.A_brake_min.si, expected.A_brake) << i;
      ASSERT_EQ(r.A_max.si, expected.A_max) << i;
    }
  }
}

TEST(ReferenceLimits, OfEveryTarget) {
  int reduced = 0;
  int feedback = 0;
  for (int i = 0; i < cases(); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const RandomCase c = wide_case(seed);
    const auto d = built(c.in);
    Dice dice(seed + 7000);
    for (const Target& t : d->targets)
      for (int n = 0; n < 4; ++n) {
        Model model{
            c.in, *d, t, speed_for(dice, c.in, t), d->Q_NVINHSMICPERM ? 0.0 : c.motion.V_ura.si, c.motion.A_est.si,
            {},   {}};
        model.in_action = feedback_for(dice, c.in, model.full.T_bs.si);
        if (dice.chance(0.8) && model.s.reduces) model.fronts = fronts_for(dice, t);
        const Approach a = approach({model.V}, {model.V0}, {model.A_est}, d->fixed);
        const TargetLimits l = limits_of(*d, t, a, {model.in_action, model.fronts});
        const ModelTimes times = model.times_EBD();
        expect_near(l.times.EBD.T_be.si, times.be, "T_be", seed);
        expect_near(l.times.EBD.T_bs1.si, times.bs1, "T_bs1", seed);
        expect_near(l.times.EBD.T_bs2.si, times.bs2, "T_bs2", seed);
        expect_near(l.times.EBD.T_traction.si, times.traction, "T_traction", seed);
        expect_near(l.times.EBD.T_berem.si, times.rest(), "T_berem", seed);
        expect_near(l.times.EBD.T_indication.si, times.indication, "T_indication", seed);
        const ModelLimits EBD = model.EBD();
        expect_near(m(*l.EBD.d_EBI), EBD.EBI, "EBI", seed);
        expect_near(m(l.EBD.d_SBI), EBD.SBI, "SBI2", seed);
        expect_near(m(l.EBD.d_W), EBD.W, "W", seed);
        expect_near(m(l.EBD.d_P), EBD.P, "P", seed);
        expect_near(m(l.EBD.d_I), EBD.I, "I", seed);
        const bool EOA = t.kind == TargetKind::EOA_SvL;
        ASSERT_EQ(l.SBD.has_value(), EOA);
        const bool bs_reduced =
            model.T_bs(m(t.d_target)) < model.full.T_bs.si || (EOA && model.T_bs(m(t.d_EOA)) < model.full.T_bs.si);
        ASSERT_EQ(l.times.reduced_be, times.be < model.full.T_be.si) << seed;
        ASSERT_EQ(l.times.reduced_bs, bs_reduced) << seed;
        if (l.times.reduced_be) ++reduced;
        if (model.in_action.has_value()) ++feedback;
        if (::testing::Test::HasFatalFailure()) return;
        if (!EOA) continue;
        const ModelLimits SBD = model.SBD();
        expect_near(l.times.SBD.T_bs1.si, model.times_SBD().bs1, "T_bs1 of the EOA", seed);
        expect_near(m(l.SBD->d_SBI), SBD.SBI, "SBI1", seed);
        expect_near(m(l.SBD->d_W), SBD.W, "W of the EOA", seed);
        expect_near(m(l.SBD->d_P), SBD.P, "P of the EOA", seed);
        expect_near(m(l.SBD->d_I), SBD.I, "I of the EOA", seed);
        if (::testing::Test::HasFatalFailure()) return;
      }
  }
  EXPECT_GT(reduced, cases() / 10);
  EXPECT_GT(feedback, cases() / 10);
}

TEST(ReferenceLimits, StrongTractionWithoutServiceBrake) {
  // The remaining traction after the Warning limit (A.3.12.2.8) decides where the distance decides.
  int reduced = 0;
  for (int i = 0; i < 1000; ++i) {
    Dice dice(static_cast<std::uint64_t>(i));
    Inputs in = simple_inputs(SrsVersion::v4_0_0);
    in.train.service_brake_interface = dice.chance(0.3);
    in.train.T_traction_cut_off = {dice.real(2.0, 6.0)};
    in.train.T_emergency[0].T_brake = {dice.real(4.0, 12.0)};
    in.train.T_emergency[0].T_brake_react = {dice.real(0.5, 3.0)};
    in.train.emergency[0].steps.steps[0].value.A_brake_emergency = {dice.real(0.8, 2.0)};
    (void)in.gradient.permille.append({{3900.0}}, static_cast<double>(dice.integer(0, 30)));
    (void)in.mrsp.append({{4500.0}}, {dice.real(3.0, 25.0)});
    const auto d = built(in);
    const Target& t = d->targets[0];
    Model model{in, *d, t, t.V_target.si + dice.real(-1.0, 4.0), dice.real(0.0, 1.0), dice.real(0.2, 1.0), {}, {}};
    model.fronts = Fronts{{{4100.0}}, {{4100.0}}};
    const TargetTimes times =
        times_of(*d, t, approach({model.V}, {model.V0}, {model.A_est}, d->fixed), {{}, model.fronts});
    ASSERT_NEAR(times.EBD.T_be.si, model.times_EBD().be, 1e-9) << i;
    ASSERT_NEAR(times.EBD.T_traction.si, model.times_EBD().traction, 1e-12) << i;
    if (times.reduced_be && times.EBD.T_be > d->cmt.T_be_react) ++reduced;
  }
  EXPECT_GT(reduced, 200);
}

TEST(ReferenceLimits, TractionThatLastsAsLongAsTheBuildUp) {
  // A.3.12.1.5: T_traction = T_be = 8 s: not reduced, just below it is.
  Inputs in = simple_inputs(SrsVersion::v4_0_0);
  in.train.traction_cut_off_interface = false;
  in.train.T_traction_cut_off = {8.0};
  set_EOA(in, 5000.0, 5000.0);
  auto d = built(in);
  const TimesAsked asked{{}, Fronts{{{4900.0}}, {{4900.0}}}};
  TargetTimes t = times_of(*d, d->targets[0], approach({1.0}, {}, {}, d->fixed), asked);
  EXPECT_EQ(t.EBD.T_be.si, 8.0);
  EXPECT_FALSE(t.reduced_be);
  in.train.T_traction_cut_off = {7.999};
  ++in.revision;
  d = built(in);
  t = times_of(*d, d->targets[0], approach({1.0}, {}, {}, d->fixed), asked);
  EXPECT_LT(t.EBD.T_be.si, 8.0);
  EXPECT_TRUE(t.reduced_be);
}

TEST(ReferenceLimits, SpeedsAtThePlaceOfTheTrain) {
  for (int i = 0; i < cases() / 2; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const RandomCase c = wide_case(seed);
    const auto d = built(c.in);
    Dice dice(seed + 8000);
    for (const Target& t : d->targets)
      for (int n = 0; n < 3; ++n) {
        const double V = speed_for(dice, c.in, t);
        const double V0 = dice.real(0.0, 2.0);
        const Approach a = approach({V}, {V0}, c.motion.A_est, d->fixed);
        const Times T = times_of(*d, t, a, {}).EBD;
        const double Vt = t.V_target.si;
        const double front = dice.chance(0.2) ? m(t.foot) : m(t.d_target) + dice.real(-2500.0, 200.0);
        const double v1 = a.A_est1.si * T.T_traction.si;
        const double v2 = a.A_est2.si * T.T_berem.si;
        const double D_be = (V + V0 + v1 / 2.0) * T.T_traction.si + (V + V0 + v1 + v2 / 2.0) * T.T_berem.si;
        const CurveView EBD = d->view(t.EBD);
        const CurveView GUI = d->view(t.GUI);
        const auto speed = [&](double before, double least) {
          const double x = front + V * before + D_be;
          if (x >= m(EBD.place_at(t.V_target))) return least;
          return std::max(EBD.speed_at({{x}}).si - (V0 + v1 + v2), least);
        };
        double V_P = speed(4.0 + T.T_bs2.si, Vt);
        if (GUI.exists()) {
          V_P = std::max(std::min(V_P, GUI.speed_at({{front}}).si), Vt);
          if (front >= m(GUI.place_at(t.V_target))) V_P = Vt;
        }
        const LimitSpeeds s = speeds_of_EBD(EBD, GUI, a, T, t.V_target, {{front}}, d->fixed);
        expect_near(s.V_P.si, V_P, "V_P", seed);
        expect_near(s.V_W.si, speed(2.0 + T.T_bs2.si, Vt + warning_margin(Vt)), "V_W", seed);
        expect_near(s.V_SBI.si, speed(T.T_bs2.si, Vt + sbi_margin(Vt)), "V_SBI", seed);
        expect_near(s.V_EBI.si, speed(0.0, Vt + ebi_margin(Vt)), "V_EBI", seed);
        if (::testing::Test::HasFatalFailure()) return;
        if (t.kind != TargetKind::EOA_SvL) continue;
        const CurveView GUI_EOA = d->view(t.GUI_EOA);
        const auto towards_EOA = [&](double before) {
          const double x = front + V * before;
          return x >= m(t.d_EOA) ? 0.0 : d->view(t.SBD).speed_at({{x}}).si;
        };
        const LimitSpeeds e = speeds_of_SBD(d->view(t.SBD), GUI_EOA, a, T, t.d_EOA, {{front}}, d->fixed);
        V_P = towards_EOA(4.0 + T.T_bs1.si);
        if (GUI_EOA.exists()) V_P = std::min(V_P, GUI_EOA.speed_at({{front}}).si);
        expect_near(e.V_P.si, V_P, "V_P of the EOA", seed);
        expect_near(e.V_W.si, towards_EOA(2.0 + T.T_bs1.si), "V_W of the EOA", seed);
        expect_near(e.V_SBI.si, towards_EOA(T.T_bs1.si), "V_SBI of the EOA", seed);
        if (::testing::Test::HasFatalFailure()) return;
      }
  }
}

TEST(ReferenceLimits, PermittedSpeedLocationAtTheTargetSpeed) {
  for (int i = 0; i < cases(); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const RandomCase c = wide_case(seed);
    const auto d = built(c.in);
    for (const Target& t : d->targets) {
      const Model model{c.in, *d, t, 0.0, 0.0, 0.0, {}, {}};
      const Setting& s = model.s;
      ModelTimes T = model_times(s, model.full.T_be.si, model.full.T_bs.si, {});
      double T_bs_foot = T.bs2;
      if (s.reduces) {
        // 3.13.9.3.5.9 c, d and A.3.12.2.7.
        T.be = model.full.T_be_react.si;
        T.traction = traction_time(s, s.SB ? model.full.T_bs_react.si : 0.0);
        if (s.SB && !s.feedback) T_bs_foot = model.full.T_bs_react.si;
      }
      const double V = t.V_target.si;
      const double v = V + (c.in.national_values.Q_NVINHSMICPERM ? 0.0 : f41(V));
      double expected = m(d->view(t.EBD).place_at({v})) - v * (T.rest() + T.traction) - V * (4.0 + T_bs_foot);
      if (s.reduces) expected = std::min(expected, m(t.d_target));
      ASSERT_NEAR(m(t.d_P_target), expected, 1e-7) << seed;
    }
  }
}

TEST(ReferenceLimits, NothingIsLongerThanTheLongestTimes) {
  int full = 0;
  for (int i = 0; i < cases(); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const RandomCase c = wide_case(seed);
    const auto d = built(c.in);
    Dice dice(seed + 9000);
    for (const Target& t : d->targets) {
      const train::BuildUpTimes& b = t.zero ? d->cm0 : d->cmt;
      const Model model{c.in, *d, t, speed_for(dice, c.in, t), dice.real(0.0, 2.0), c.motion.A_est.si, {}, {}};
      const Times unreduced = times(d->time_config, b, std::nullopt, d->rules, d->fixed);
      Times expected = unreduced;
      // When T_bs2 is reduced, at most to the reaction time, only T_traction grows.
      if (model.s.reduces && !model.s.feedback)
        expected.T_traction = {traction_time(model.s, model.s.SB ? std::min(b.T_bs, b.T_bs_react).si : 0.0)};
      const Times longest = longest_times(unreduced, *d, b);
      ASSERT_NEAR(longest.T_traction.si, expected.T_traction.si, 1e-12) << seed;
      expected.T_traction = longest.T_traction;
      ASSERT_EQ(longest, expected) << seed;
      if (!model.s.reduces) continue;
      const Approach a = approach({model.V}, {model.V0}, {model.A_est}, d->fixed);
      const Speed below = full_build_up_below(*d, b, a, unreduced);
      Target slower = t;
      if (!model.stop) slower.V_target = {std::min(t.V_target.si, below.si - 1e-6)};
      if (slower.V_target >= below || slower.V_target.si < 0.0) continue;
      const TargetTimes tt = times_of(*d, slower, a, {std::nullopt, fronts_for(dice, t)});
      ASSERT_FALSE(tt.reduced_be || tt.reduced_bs) << seed;
      ++full;
    }
  }
  EXPECT_GT(full, cases() / 4);
}

TEST(ReferenceLimits, FullBuildUpAsFarAsTheStrongestBrakeTells) {
  // Not stricter than A.3.12.4: where both brakes would be fully built up at the strongest deceleration.
  for (int i = 0; i < cases() / 2; ++i) {
    const auto seed = static_cast<std::uint64_t>(3 * i + 2);  // 4.0.0
    const RandomCase c = wide_case(seed);
    const auto d = built(c.in);
    Dice dice(seed + 9100);
    const train::BuildUpTimes& b = d->cmt;
    const Setting s = setting_of(c.in);
    const double V = dice.real(0.0, 40.0);
    const double V0 = dice.real(0.0, 2.0);
    const Approach a = approach({V}, {V0}, c.motion.A_est, d->fixed);
    const Times unreduced = times(d->time_config, b, std::nullopt, d->rules, d->fixed);
    const double Tx = traction_time(s, s.SB ? b.T_bs_react.si : 0.0);
    const auto end_of_ramp = [&](double v0, double a1, double a2, double T, double react, double cut, double A) {
      const double V1 = v0 + (cut < react ? a1 * cut + a2 * (react - cut) : a1 * react);
      return std::min(V1, std::max(0.0, v0 + a1 * cut + a2 * (2.0 * T - react - cut) - A * (T - react)));
    };
    double expected = kInfinite;
    if (unreduced.T_traction < b.T_be && b.T_be > b.T_be_react)
      expected = end_of_ramp(V + V0, a.A_est1.si, a.A_est2.si, b.T_be.si, b.T_be_react.si, Tx,
                             d->decelerations.highest_safe.si);
    if (!s.feedback && b.T_bs > b.T_bs_react)
      expected = std::min(
          expected, end_of_ramp(V, 0.0, 0.0, b.T_bs.si, b.T_bs_react.si, 0.0, d->decelerations.highest_expected.si));
    const double below = full_build_up_below(*d, b, a, unreduced).si;
    if (expected == kInfinite)
      ASSERT_GT(below, 1e6) << seed;
    else
      ASSERT_NEAR(below, expected, 1e-9) << seed;
  }
}

TEST(ReferenceLocations, StartOfReleaseSpeedMonitoring) {
  int several = 0;
  for (int i = 0; i < cases(); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    RandomCase c = wide_case(seed);
    if (c.in.authority.kind != Authority::Kind::EOA_SvL) continue;
    Dice dice(seed + 10000);
    // Restrictions around EOA and SvL.
    const double EOA = m(c.in.authority.EOA);
    (void)c.in.mrsp.append({{EOA - 50.0}}, kmh(90.0));
    (void)c.in.mrsp.append({{EOA + 20.0}}, kmh(30.0));
    (void)c.in.mrsp.append({{EOA + 60.0}}, kmh(10.0));
    c.in.authority.SvL = c.in.authority.EOA + Distance{dice.chance(0.3) ? 60.0 : dice.real(0.0, 200.0)};
    if (dice.chance(0.6)) {
      // A short train on a track that changes every few metres: the result depends on the start of
      // its range.
      c.in.train.L_TRAIN = {10.0};
      c.in.gradient = {};
      for (int k = 0; k < 40; ++k)
        (void)c.in.gradient.permille.append({{EOA - 500.0 + 20.0 * k}}, static_cast<double>(dice.integer(-18, 18)));
    }
    const auto d = built(c.in);
    const Target& EOA_SvL = *std::find_if(d->targets.begin(), d->targets.end(),
                                          [](const Target& t) { return t.kind == TargetKind::EOA_SvL; });
    const double V = dice.real(0.0, 15.0);
    const double V0 = c.in.national_values.Q_NVINHSMICPERM ? 0.0 : f41(V);
    const Place d_trip{{dice.chance(0.3) ? EOA + 20.0 : EOA + dice.real(0.0, 80.0)}};
    const bool on_board = dice.chance(0.6);
    Feedback feedback;
    feedback.cm0 = feedback_for(dice, c.in, d->cm0.T_bs.si);
    feedback.cmt = feedback_for(dice, c.in, d->cmt.T_bs.si);
    // A train about to reach the location with unreduced times.
    const auto model_of = [&](const Target& t) {
      Model model{c.in, *d, t, V, V0, 0.0, t.V_target.si == 0.0 ? feedback.cm0 : feedback.cmt, {}};
      if (model.s.reduces) {
        double here = model.EBD().SBI;
        if (t.kind == TargetKind::EOA_SvL) here = std::min(here, model.SBD().SBI);
        model.fronts = Fronts{{{here}}, {{here}}};
      }
      return Model{c.in, *d, t, V, V0, 0.0, model.in_action, model.fronts};
    };
    const double SBI1 = model_of(EOA_SvL).SBD().SBI;
    double SBI2 = model_of(EOA_SvL).EBD().SBI;
    int counted = 0;
    for (const Target& t : d->targets)
      // A target speed above the release speed cannot be exceeded.
      if (on_board && t.kind == TargetKind::MRSP && t.V_target.si <= V && t.d_target >= d_trip &&
          t.d_target <= EOA_SvL.d_target) {
        SBI2 = std::min(SBI2, model_of(t).EBD().SBI);
        ++counted;
      }
    if (counted > 1) ++several;
    const RsmStart start = rsm_start(*d, EOA_SvL, {V}, d_trip, on_board, feedback);
    expect_near(m(start.d_SBI1), SBI1, "SBI1", seed);
    expect_near(m(start.d_SBI2), SBI2, "SBI2", seed);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(several, 20);
}

TEST(ReferenceLocations, WhereTheSpeedOfALevelCrossingTakesOver) {
  int SBD_decides = 0;
  int passed = 0;
  for (int i = 0; i < cases(); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    RandomCase c = wide_case(seed);
    Dice dice(seed + 11000);
    const Place start{{dice.real(1000.0, 5000.0)}};
    // The stop is like an authority that ends there.
    Inputs ends_there = c.in;
    ends_there.authority = {};
    ends_there.authority.kind = Authority::Kind::EOA_SvL;
    ends_there.authority.EOA = ends_there.authority.SvL = start;
    ends_there.SR_end.reset();
    const auto d = built(ends_there);
    const Target& stop = d->targets.back();
    ASSERT_EQ(stop.kind, TargetKind::EOA_SvL);
    const double V = dice.chance(0.3) ? dice.real(0.0, 2.0) : dice.real(0.0, 25.0);
    const bool v400 = c.in.srs == SrsVersion::v4_0_0;
    double V0 = v400 ? c.motion.V_ura.si : f41(V);
    if (c.in.national_values.Q_NVINHSMICPERM) V0 = 0.0;
    Model model{ends_there, *d, stop, V, V0, v400 ? c.motion.A_est.si : 0.0, {}, {}};
    c.motion.est_front = start - Distance{dice.real(-20.0, 700.0)};
    c.motion.max_safe_front = c.motion.est_front + Distance{dice.chance(0.5) ? 0.0 : dice.real(0.0, 150.0)};
    c.motion.min_safe_front = c.motion.est_front - Distance{dice.real(0.0, 60.0)};
    if (v400) model.fronts = Fronts{c.motion.est_front, c.motion.min_safe_front};
    // P follows from SBI or guidance only (3.13.9.3.5.12): the target does not limit it.
    const Model plain{ends_there, *d, stop, V, V0, model.A_est, {}, model.fronts};
    const ModelTimes T = plain.times_EBD();
    const ModelLimits SBD = plain.SBD();
    const ModelLimits EBD = model_limits(plain.EBD().SBI, d->view(stop.GUI), V, T.indication, kInfinite);
    const LxSubstitution lx = lx_substitution(c.in, *d, start, {V}, c.motion);
    const bool from_SBD = EBD.SBI - SBD.SBI >= (c.motion.max_safe_front - c.motion.est_front).si;
    ASSERT_EQ(lx.from_SBD, from_SBD) << seed;
    const double P = from_SBD ? SBD.P : EBD.P;
    expect_near(m(lx.d_P), P, "P", seed);
    expect_near(m(lx.EBD.d_SBI), EBD.SBI, "SBI2", seed);
    expect_near(m(lx.SBD.d_SBI), SBD.SBI, "SBI1", seed);
    expect_near(m(lx.EBD.d_P), EBD.P, "P of the EBD", seed);
    expect_near(m(lx.SBD.d_P), SBD.P, "P of the SBD", seed);
    const double front = m(from_SBD ? c.motion.est_front : c.motion.max_safe_front);
    ASSERT_EQ(lx.passed, front > P) << seed;
    if (::testing::Test::HasFatalFailure()) return;
    if (from_SBD) ++SBD_decides;
    if (lx.passed) ++passed;
  }
  EXPECT_GT(SBD_decides, cases() / 50);
  EXPECT_GT(passed, cases() / 20);
}

TEST(ReferenceLocations, SpeedOfAPermittedBrakingDistance) {
  int positive = 0;
  for (int i = 0; i < cases() / 2; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    RandomCase c = wide_case(seed);
    Inputs& in = c.in;
    Dice dice(seed + 12000);
    in.train.L_antenna_front = {dice.real(0.0, 20.0)};
    in.fixed.T41_balise = {dice.real(0.0, 2.0)};
    in.fixed.PBD_rounding = kmh(dice.chance(0.5) ? 5.0 : 0.01);
    const double distance = dice.chance(0.3) ? dice.real(0.0, 150.0) : dice.real(0.0, 3000.0);
    const double grad = dice.integer(-20, 20);
    const bool emergency = dice.chance(0.5);
    // The curves to a stop on a track of this gradient, with slippery rail by the driver as the only condition.
    Inputs track = in;
    track.gradient = {};
    (void)track.gradient.permille.append({{-1e6}}, grad);
    track.conditions = {};
    track.conditions.slippery_rail = in.conditions.slippery_rail;
    track.authority = {};
    track.authority.kind = Authority::Kind::EOA_SvL;
    track.authority.EOA = track.authority.SvL = Place{{distance}};
    track.SR_end.reset();
    track.mrsp_due_to_TSR = {};
    const auto d = built(track);
    const Target& stop = d->targets.back();
    Setting s = setting_of(in);
    s.cut_off_at_warning = false;
    s.feedback = false;
    const train::BuildUpTimes b = train::build_up_times(in.train, in.national_values, in.brakes, true);
    const ModelTimes T = model_times(s, b.T_be.si, b.T_bs.si, {});
    const auto too_fast = [&](double V) {
      const double v = V + (emergency ? ebi_margin(V) : sbi_margin(V));
      const double V0 = in.national_values.Q_NVINHSMICPERM ? 0.0 : f41(v);
      const double offset = in.train.L_antenna_front.si + in.fixed.T41_balise.si * (v + V0);
      double x = offset + (v + V0) * (T.rest() + T.traction) + (emergency ? 0.0 : v * T.bs2);
      double excess = x > distance ? kInfinite : v - (d->view(stop.EBD).speed_at({{x}}).si - V0);
      if (!emergency) {
        x = in.train.L_antenna_front.si + in.fixed.T41_balise.si * v + v * T.bs1;
        excess = std::max(excess, x > distance ? kInfinite : v - d->view(stop.SBD).speed_at({{x}}).si);
      }
      return excess + 1.0 / 3.6;
    };
    const double fastest = zero_of(too_fast, 0.0, in.V_top->si);
    const double step = in.fixed.PBD_rounding.si;
    const double V = permitted_braking_distance_speed(in, {distance}, grad, emergency).si;
    ASSERT_LE(V, fastest + 1e-9) << seed;
    ASSERT_GT(V + step, fastest - 1e-9) << seed;
    ASSERT_NEAR(std::remainder(V, step), 0.0, 1e-9) << seed;
    if (V > 0.0) ++positive;
  }
  EXPECT_GT(positive, cases() / 4);
}

// ---- Cases that random values do not reach ---------------------------------------------------------------------

TEST(ReferenceLocations, FrontExactlyWhereTheLevelCrossingGivesWay) {
  const Inputs in = simple_inputs();
  const auto d = built(in);
  Motion motion = at(2500.0, 20.0);
  const LxSubstitution lx = lx_substitution(in, *d, {{3000.0}}, {10.0}, motion);
  motion.max_safe_front = motion.est_front = lx.d_P;
  EXPECT_FALSE(lx_substitution(in, *d, {{3000.0}}, {10.0}, motion).passed);
  motion.max_safe_front = lx.d_P + Distance{1e-9};
  EXPECT_TRUE(lx_substitution(in, *d, {{3000.0}}, {10.0}, motion).passed);
  // Both limits are reached together if they are as far apart as the front ends: the SBD decides.
  Motion apart = at(2500.0, 20.0);
  Inputs weak = in;
  weak.train.service[0].A_brake_service.steps[0].value = {0.1};
  const auto w = built(weak);
  const LxSubstitution s = lx_substitution(weak, *w, {{3000.0}}, {10.0}, apart);
  apart.max_safe_front = apart.est_front + (s.EBD.d_SBI - s.SBD.d_SBI);
  EXPECT_TRUE(lx_substitution(weak, *w, {{3000.0}}, {10.0}, apart).from_SBD);
}

TEST(ReferenceLocations, APermittedBrakingDistanceKnowsNothingOfFeedback) {
  // With feedback T_bs2 would be at least 2 s.
  Inputs in = simple_inputs();
  in.fixed.PBD_rounding = kmh(0.01);
  in.train.T_service[0].T_brake = {0.5};
  const Speed without = permitted_braking_distance_speed(in, {1000.0}, 0.0, false);
  in.train.service_brake_feedback = in.national_values.Q_NVSBFBPERM = true;
  EXPECT_EQ(permitted_braking_distance_speed(in, {1000.0}, 0.0, false), without);
}

TEST(ReferenceLocations, APermittedBrakingDistanceFasterThanAnyTrain) {
  // The highest speed of the curves: V_MAXTRAIN 108 km/h and 100 km/h, rounded down; or the given one.
  Inputs in = simple_inputs();
  EXPECT_NEAR(permitted_braking_distance_speed(in, {90000.0}, 0.0, true).si * 3.6, 205.0, 1e-9);
  in.V_top = 40 * in.fixed.PBD_rounding;
  EXPECT_EQ(permitted_braking_distance_speed(in, {90000.0}, 0.0, true), *in.V_top);
}

}  // namespace
