// Properties of curves and limits over random trains, tracks and targets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "sdm/test_cases.h"

namespace {

using namespace evc;
using namespace evc::sdm;
using namespace evc::sdm::test;

/// Every limit location of every target at a few speeds; NaN where the EBD is beyond its target (below V_target +
/// dV_ebi, and further with a weaker brake: 3.13.8.3.1), and at speeds up to the target speed, which are not
/// supervised.
std::vector<double> limit_places(const Inputs& in, const Motion& m) {
  const auto d = built(in);
  std::vector<double> places;
  for (const Target& t : d->targets)
    for (double v = 5.0; v <= 200.0; v += 39.0) {
      const Explanation e = explain(*d, in, t, kmh(v), m.V_ura, m.A_est);
      const bool short_of_target = e.EBD.d_curve <= t.d_target && kmh(v) > t.V_target;
      places.push_back(e.d_EBD <= t.d_target && kmh(v) > t.V_target ? e.d_EBD.from_origin.si : NAN);
      for (const Place p : {*e.EBD.d_EBI, e.EBD.d_SBI, e.EBD.d_W, e.EBD.d_P, e.EBD.d_I, e.d_FLOI, e.d_I})
        places.push_back(short_of_target ? p.from_origin.si : NAN);
    }
  return places;
}

/// No place of `worse` is nearer to the target (downstream) than its counterpart.
void expect_not_nearer(const std::vector<double>& base, const std::vector<double>& worse, const char* what,
                       std::uint64_t seed, Compared& compared) {
  ASSERT_EQ(base.size(), worse.size());
  for (std::size_t i = 0; i < base.size(); ++i) {
    if (std::isnan(base[i]) || std::isnan(worse[i])) continue;
    ++compared;
    ASSERT_LE(worse[i], base[i] + 1e-6) << what << ", seed " << seed << ", limit " << i;
  }
}

TEST(Properties, LimitsAreInOrder) {
  const int number = cases();
  Compared compared(number, 13.0);
  for (int i = 0; i < number; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const RandomCase c = random_case(seed, static_cast<SrsVersion>(i % 3));
    const auto d = built(c.in);
    for (const Target& t : d->targets)
      for (double v = 0.0; v <= 220.0; v += 20.0) {
        const Explanation e = explain(*d, c.in, t, kmh(v), c.motion.V_ura, c.motion.A_est);
        // Much of the order follows from subtracting non-negative times: only strict order is counted.
        if (e.EBD.d_I < e.EBD.d_P && e.EBD.d_P < e.EBD.d_W && e.EBD.d_W < e.EBD.d_SBI && e.EBD.d_SBI < *e.EBD.d_EBI)
          ++compared;
        ASSERT_LE(e.EBD.d_I, e.EBD.d_P) << seed;
        ASSERT_LE(e.EBD.d_P, e.EBD.d_W) << seed;
        ASSERT_LE(e.EBD.d_W, e.EBD.d_SBI) << seed;
        ASSERT_LE(e.EBD.d_SBI, *e.EBD.d_EBI) << seed;
        ASSERT_LE(*e.EBD.d_EBI, e.d_EBD) << seed;
        if (e.SBD.has_value()) {
          ASSERT_LE(e.SBD->d_I, e.SBD->d_P) << seed;
          ASSERT_LE(e.SBD->d_P, e.SBD->d_W) << seed;
          ASSERT_LE(e.SBD->d_W, e.SBD->d_SBI) << seed;
          ASSERT_LE(e.SBD->d_SBI, *e.d_SBD) << seed;
        }
        ASSERT_LE(e.d_FLOI, *e.EBD.d_EBI) << seed;
      }
  }
}

TEST(Properties, AWorseTrainOrTrackNeverMovesALimitTowardsTheTarget) {
  const int number = cases(1000);
  Compared compared(number, 400.0);
  for (int i = 0; i < number; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    RandomCase c = random_case(seed);
    // Targets and release speeds stay the same; only the inputs of the limits change.
    const std::vector<double> base = limit_places(c.in, c.motion);
    Dice dice(seed ^ 0x5eedull);
    const std::size_t k = static_cast<std::size_t>(dice.integer(0, 1000));
    {
      Inputs in = c.in;
      if (in.train.brake_model == train::BrakeModel::gamma) {
        auto& steps = in.train.emergency[0].steps.steps;
        auto& A = steps[k % steps.size()].value.A_brake_emergency;
        A = 0.9 * A;
        auto& service = in.train.service[0].A_brake_service.steps;
        service[k % service.size()].value = 0.9 * service[k % service.size()].value;
      } else {
        in.national_values.Kv_int_freight.steps[0].value *= 0.9;
        in.national_values.Kv_int_passenger.steps[0].value.a *= 0.9;
        in.national_values.Kv_int_passenger.steps[0].value.b *= 0.9;
      }
      expect_not_nearer(base, limit_places(in, c.motion), "weaker brake", seed, compared);
    }
    {
      Inputs in = c.in;
      auto& steps = in.gradient.permille.steps;
      steps[k % steps.size()].value -= 3.0;
      expect_not_nearer(base, limit_places(in, c.motion), "steeper fall", seed, compared);
    }
    {
      Inputs in = c.in;
      if (in.train.brake_model == train::BrakeModel::gamma)
        in.train.T_emergency[0].T_brake += Duration{1.0};
      else
        in.national_values.Kt_int += 0.1;
      expect_not_nearer(base, limit_places(in, c.motion), "longer emergency build-up", seed, compared);
    }
    {
      Inputs in = c.in;
      in.train.T_traction_cut_off += Duration{1.0};
      expect_not_nearer(base, limit_places(in, c.motion), "longer traction cut-off", seed, compared);
    }
    {
      Motion m = c.motion;
      m.V_ura += Speed{0.5};
      expect_not_nearer(base, limit_places(c.in, m), "larger speed error", seed, compared);
    }
  }
}

TEST(Properties, FallsTooSteepForTheBrakesAreMonotonousToo) {
  const int number = cases(500);
  Compared compared(number, 75.0);
  for (int i = 0; i < number; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    RandomCase c = random_case(seed);
    Dice dice(seed + 77);
    auto& steps = c.in.gradient.permille.steps;
    double lowest_V = 1e9;
    for (int n = 0; n < 3; ++n)
      steps[static_cast<std::size_t>(dice.integer(0, 1000)) % steps.size()].value = -dice.real(30.0, 140.0);
    const std::vector<double> base = limit_places(c.in, c.motion);
    for (const double p : base) lowest_V = std::min(lowest_V, p);
    Inputs in = c.in;
    auto& worse = in.gradient.permille.steps;
    worse[static_cast<std::size_t>(dice.integer(0, 1000)) % worse.size()].value -= 5.0;
    expect_not_nearer(base, limit_places(in, c.motion), "steeper fall", seed, compared);
    // Curves are monotonic: no speed is allowed further downstream than a lower one.
    const auto d = built(c.in);
    for (const Target& t : d->targets) {
      const CurveView EBD = d->view(t.EBD);
      for (std::size_t n = 1; n < EBD.knots.size(); ++n) {
        ASSERT_LE(EBD.knots[n].x, EBD.knots[n - 1].x) << seed;
        ASSERT_GE(EBD.knots[n].w, EBD.knots[n - 1].w) << seed;
      }
    }
  }
}

TEST(Properties, ShiftingTheLineShiftsEverything) {
  const int number = cases(500);
  Compared compared(number, 75.0);
  for (int i = 0; i < number; ++i) {
    const RandomCase c = random_case(static_cast<std::uint64_t>(i));
    const Distance by{1024.0 * (i % 7 - 3)};
    Inputs in = c.in;
    for (auto& s : in.gradient.permille.steps) s.from = s.from + by;
    if (in.gradient.known_to.has_value()) in.gradient.known_to = *in.gradient.known_to + by;
    for (auto& s : in.mrsp.steps) s.from = s.from + by;
    for (auto& z : in.conditions.reduced_adhesion) z = {z.from + by, z.to + by};
    in.authority.EOA = in.authority.EOA + by;
    in.authority.SvL = in.authority.SvL + by;
    in.authority.reference = in.authority.reference + by;
    const std::vector<double> base = limit_places(c.in, c.motion);
    const std::vector<double> moved = limit_places(in, c.motion);
    for (std::size_t n = 0; n < base.size(); ++n)
      if (base[n] > -1e8) {  // NaN and nowhere are left out
        ++compared;
        ASSERT_NEAR(base[n] + by.si, moved[n], 1e-6);
      }
  }
}

TEST(Properties, SplittingASegmentChangesNothing) {
  const int number = cases(500);
  Compared compared(number, 33.0);
  for (int i = 0; i < number; ++i) {
    RandomCase c = random_case(static_cast<std::uint64_t>(i));
    c.in.train.brake_model = train::BrakeModel::gamma;
    if (c.in.train.emergency.empty()) continue;
    const std::vector<double> base = limit_places(c.in, c.motion);
    // Borders of brakes that the train does not have: they only divide segments.
    Inputs in = c.in;
    Dice dice(static_cast<std::uint64_t>(i) + 5);
    in.conditions.regenerative_off = Place{{dice.real(0.0, 5000.0)}};
    in.conditions.magnetic_shoe_off = Place{{dice.real(0.0, 5000.0)}};
    in.conditions.powerless = Place{{dice.real(0.0, 5000.0)}};
    const std::vector<double> split = limit_places(in, c.motion);
    for (std::size_t n = 0; n < base.size(); ++n)
      if (base[n] > -1e8) {  // NaN and nowhere are left out
        ++compared;
        ASSERT_NEAR(base[n], split[n], 1e-9);
      }
  }
}

TEST(Properties, PlaceToSpeedToPlace) {
  const int number = cases(500);
  Compared compared(number, 22.0);
  for (int i = 0; i < number; ++i) {
    const RandomCase c = random_case(static_cast<std::uint64_t>(i));
    const auto d = built(c.in);
    Dice dice(static_cast<std::uint64_t>(i) + 11);
    for (const Target& t : d->targets) {
      const CurveView EBD = d->view(t.EBD);
      if (t.warnings.no_deceleration) continue;
      for (int n = 0; n < 10; ++n) {
        const Place x = EBD.foot() - Distance{dice.real(0.001, 6000.0)};
        ++compared;
        ASSERT_NEAR(EBD.place_at(EBD.speed_at(x)).from_origin.si, x.from_origin.si, 1e-6);
      }
    }
  }
}

// ---- An independent fine-step integrator -----------------------------------------------------------

/// Gradient under a train by evaluating every step of the uncompensated input.
double lowest_gradient(const Inputs& in, double front) {
  const double rear = front - in.train.L_TRAIN.si;
  const auto& steps = in.gradient.permille.steps;
  double lowest = 1e9;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double from = steps[i].from.from_origin.si;
    double to = i + 1 < steps.size() ? steps[i + 1].from.from_origin.si : 1e9;
    if (in.gradient.known_to.has_value()) to = std::min(to, in.gradient.known_to->from_origin.si);
    if (from < to && from <= front && to > rear) lowest = std::min(lowest, steps[i].value);
  }
  const double known_from = steps[0].from.from_origin.si;
  const double known_to = in.gradient.known_to.has_value() ? in.gradient.known_to->from_origin.si : 1e9;
  if (rear < known_from || front >= known_to) lowest = std::min(lowest, 0.0);
  return lowest;
}

double safe_deceleration(const Inputs& in, double v, double front) {
  const train::TrainData& t = in.train;
  double A = 0.0;
  if (t.brake_model == train::BrakeModel::gamma) {
    for (const auto& s : t.emergency[0].steps.steps)
      if (s.from.si < v || s.from.si == 0.0) {
        const double wet = s.value.Kwet_rst.value();
        A = s.value.A_brake_emergency.si * s.value.Kdry_rst[9].value() *
            (wet + in.national_values.M_NVAVADH * (1.0 - wet));
      }
  } else {
    const double l = t.brake_percentage;
    const double V = v * 3.6;
    const double V_lim = 16.85 * std::pow(l, 0.428);
    if (V <= V_lim)
      A = 0.0075 * l + 0.076;
    else if (V <= 100.0)
      A = -6.30e-7 * l * l * l + 6.10e-5 * l * l + 4.72e-3 * l + 0.0663;
    else if (V <= 120.0)
      A = 2.73e-7 * l * l * l - 4.54e-6 * l * l + 5.14e-3 * l + 0.1300;
    else if (V <= 150.0)
      A = 5.58e-8 * l * l * l - 6.76e-6 * l * l + 5.81e-3 * l + 0.0479;
    else if (V <= 180.0)
      A = 3.00e-8 * l * l * l - 3.85e-6 * l * l + 5.52e-3 * l + 0.0480;
    else
      A = 3.23e-9 * l * l * l + 1.66e-6 * l * l + 5.06e-3 * l + 0.0559;
    A *= 0.7 * 0.9;
  }
  bool reduced = in.conditions.slippery_rail;
  for (const Zone& z : in.conditions.reduced_adhesion)
    reduced = reduced || (front > z.from.from_origin.si && front <= z.to.from_origin.si + t.L_TRAIN.si);
  if (reduced) A = std::min(A, 0.7);
  const double grad = lowest_gradient(in, front);
  const double m = t.M_rotating_nom.value_or(grad > 0.0 ? 15.0 : 2.0);
  return A + 9.81 * grad / (1000.0 + 10.0 * m);
}

TEST(Properties, TheCurveIsThatOfAFineStepIntegrator) {
  constexpr double kStep = 0.05;
  const int number = std::max(40, cases(2000) / 50);
  Compared compared(number, 19.0);
  for (int i = 0; i < number; ++i) {
    const RandomCase c = random_case(static_cast<std::uint64_t>(i) + 100000);
    const auto d = built(c.in);
    for (const Target& t : d->targets) {
      if (t.kind == TargetKind::MRSP && t.d_target != d->targets[0].d_target) continue;
      if (t.warnings.no_deceleration) continue;
      const CurveView EBD = d->view(t.EBD);
      double w = std::pow(t.V_target.si + (t.kind == TargetKind::EOA_SvL ? 0.0 : dV_ebi(t.V_target, c.in.fixed).si), 2);
      double x = t.d_target.from_origin.si;
      for (int n = 0; n < 80000 && w < std::pow(200.0 / 3.6, 2); ++n) {
        const double A = safe_deceleration(c.in, std::sqrt(w) + 1e-9, x - kStep / 2.0);
        w += 2.0 * A * kStep;
        x -= kStep;
        // At most one step of speed or track is missed per change, each causing 2 dA dx in v^2.
        if (n % 4000 == 0) {
          ++compared;
          ASSERT_NEAR(EBD.speed_squared_at({{x}}).si, w, 60 * 2.0 * 1.5 * kStep * 0.5) << "case " << i << " at " << x;
        }
      }
    }
  }
}

// ---- Supervision ------------------------------------------------------------------------------------

void expect_equal(const Result& a, const Result& b, int seed) {
  ASSERT_EQ(a.monitoring, b.monitoring) << seed;
  ASSERT_EQ(a.status, b.status) << seed;
  ASSERT_EQ(a.tco, b.tco) << seed;
  ASSERT_EQ(a.sb, b.sb) << seed;
  ASSERT_EQ(a.eb, b.eb) << seed;
  ASSERT_EQ(a.V_P, b.V_P) << seed;
  ASSERT_EQ(a.V_W, b.V_W) << seed;
  ASSERT_EQ(a.V_SBI, b.V_SBI) << seed;
  ASSERT_EQ(a.V_EBI, b.V_EBI) << seed;
  ASSERT_EQ(a.V_target, b.V_target) << seed;
  ASSERT_EQ(a.d_target, b.d_target) << seed;
  ASSERT_EQ(a.MRDT, b.MRDT) << seed;
  ASSERT_EQ(a.V_release, b.V_release) << seed;
  ASSERT_EQ(a.first_indication, b.first_indication) << seed;
  ASSERT_EQ(a.TTI, b.TTI) << seed;
  ASSERT_EQ(a.highest.condition, b.highest.condition) << seed;
}

TEST(Properties, LeavingOutFarTargetsChangesNothing) {
  const int number = cases();
  Compared compared(number, 8.5);
  for (int i = 0; i < number; ++i) {
    RandomCase c = random_case(static_cast<std::uint64_t>(i), static_cast<SrsVersion>(i % 3));
    c.in.national_values.A_NVMAXREDADH2 =
        train::MaxReducedAdhesion::without_maximum(i % 2 == 0 ? train::MaxReducedAdhesion::Display::target_information
                                                              : train::MaxReducedAdhesion::Display::time_to_indication);
    const auto quick = built(c.in);
    auto slow = std::make_unique<Derived>(*quick);
    for (Target& t : slow->targets) t.warnings.truncated = true;
    Supervision a;
    Supervision b;
    Motion m = c.motion;
    for (int n = 0; n < 20; ++n) {
      const Result ra = supervise(a, *quick, m);
      const Result rb = supervise(b, *slow, m);
      expect_equal(ra, rb, i);
      if (ra.monitoring != Monitoring::CSM) ++compared;
      const Distance run = m.V_est * Duration{2.0};
      m.est_front = m.est_front + run;
      m.max_safe_front = m.max_safe_front + run;
      m.min_safe_front = m.min_safe_front + run;
    }
  }
}

/// Whether a train that runs half a second more at V is then still in rear of P for V, of every target.
bool permitted(const Derived& d, const Inputs& in, const Motion& m, Speed V) {
  const Place front = m.max_safe_front + V * Duration{0.5};
  if (V > V_MRSP(in.mrsp, m.min_safe_front, front)) return false;
  for (const Target& t : d.targets) {
    if (t.kind == TargetKind::MRSP && front > t.d_target) continue;
    if (t.kind == TargetKind::LOA && front >= t.d_target && V > t.V_target) return false;
    if (V > t.V_target && front > explain(d, in, t, V, m.V_ura, {}, &m).d_P) return false;
  }
  return true;
}

TEST(Properties, ADriverWhoStaysBelowThePermittedSpeedIsNeverBraked) {
  const int number = std::max(45, cases() / 50);
  Compared compared(number, 950.0);
  for (int i = 0; i < number; ++i) {
    RandomCase c = random_case(static_cast<std::uint64_t>(i), static_cast<SrsVersion>(i % 3));
    const auto d = built(c.in);
    Supervision s;
    Motion m = c.motion;
    m.est_front = m.max_safe_front = m.min_safe_front = Place{{-450.0}};
    m.V_est = {};
    m.A_est = {};
    for (int n = 0; n < 1200; ++n) {
      m.standstill = m.V_est.si == 0.0;
      const Result r = supervise(s, *d, m);
      // Standstill proves nothing.
      if (!m.standstill) ++compared;
      ASSERT_FALSE(r.eb || r.sb || r.tco) << i << " at " << m.est_front.from_origin.si;
      ASSERT_LE(r.status, Status::Indication) << i << " at " << m.est_front.from_origin.si;
      // The highest speed that is still permitted half a second later.
      Speed low{0.0};
      Speed high = m.V_est + Speed{0.3};
      for (int k = 0; k < 14; ++k) {
        const Speed middle = low + (high - low) / 2.0;
        (permitted(*d, c.in, m, middle) ? low : high) = middle;
      }
      m.V_est = low;
      const Distance run = m.V_est * Duration{0.5};
      m.est_front = m.max_safe_front = m.min_safe_front = m.est_front + run;
    }
  }
}

TEST(Properties, AnUnbrakedTrainIsStoppedBeforeTheSupervisedLocation) {
  // Above the permitted speed the commands come early enough: from the emergency command on, a train that brakes as
  // modelled stops at the SvL at the latest.
  const int number = cases(400);
  Compared compared(number, 0.2);
  for (int i = 0; i < number; ++i) {
    RandomCase c = random_case(static_cast<std::uint64_t>(i), static_cast<SrsVersion>(i % 3));
    if (c.in.authority.kind != Authority::Kind::EOA_SvL) continue;
    c.in.authority.release_speed = ReleaseSpeedChoice::none;
    c.in.national_values.Q_NVINHSMICPERM = true;
    c.in.mrsp = {};
    ASSERT_TRUE(c.in.mrsp.append({{-20000.0}}, c.in.train.V_MAXTRAIN));
    c.in.mrsp_due_to_TSR = {};
    const auto d = built(c.in);
    if (d->no_deceleration) continue;
    Supervision s;
    Motion m = c.motion;
    m.V_est = c.in.train.V_MAXTRAIN;
    m.V_ura = {};
    m.A_est = {};
    m.est_front = m.max_safe_front = m.min_safe_front = d->view(d->targets[0].EBD).place_at(m.V_est) - Distance{6000.0};
    constexpr double kCycle = 0.1;
    int n = 0;
    Result r;
    do {
      r = supervise(s, *d, m);
      const Distance run = m.V_est * Duration{kCycle};
      m.est_front = m.max_safe_front = m.min_safe_front = m.est_front + run;
    } while (!r.eb && ++n < 5000);
    ASSERT_TRUE(r.eb) << i;
    // Traction until T_traction, nothing until the build-up is over, then the EBD.
    const Distance lost = m.V_est * (d->cm0.T_be > c.in.train.T_traction_cut_off ? d->cm0.T_be : Duration{0.0});
    const Place full = m.est_front + lost;
    const double one_cycle = m.V_est.si * kCycle * 2.0;
    if (c.in.srs == SrsVersion::v4_0_0 || c.in.train.T_traction_cut_off >= d->cm0.T_be) continue;
    ++compared;
    EXPECT_LE(full.from_origin.si, d->view(d->targets[0].EBD).place_at(m.V_est).from_origin.si + one_cycle) << i;
  }
}

}  // namespace
