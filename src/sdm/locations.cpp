#include "sdm/locations.h"

#include <algorithm>

#include "sdm/evaluate.h"

namespace evc::sdm {
namespace {

Speed top_speed(const Inputs& in) { return in.V_top.value_or(in.train.V_MAXTRAIN + Speed{100.0 / 3.6}); }

/// Curves to a standstill at one place, one behind the other in `scratch`.
class CurvesToStop {
 public:
  CurvesToStop(Derived& scratch, const Decelerations& A, Place stop, Speed top)
      : d_(scratch), A_(A), stop_(stop), top_(top) {
    d_.valid = false;
  }

  CurveView operator()(CurveKind kind) {
    static_assert(3 * kMaxKnots <= kKnotPool);
    const std::size_t first = used_;
    // What does not fit is level, on the safe side.
    (void)trace({d_.knots.data(), first + kMaxKnots}, used_, A_, kind, false, stop_, {}, {}, top_);
    return {{d_.knots.data() + first, used_ - first}};
  }

 private:
  Derived& d_;
  const Decelerations& A_;
  Place stop_;
  Speed top_;
  std::size_t used_ = 0;  // at most three curves
};

}  // namespace

LxSubstitution lx_substitution(const Inputs& in, const Derived& d, Place LX_start, Speed V_LX, const Motion& m,
                               Derived& scratch) {
  LxSubstitution lx;
  CurvesToStop curve(scratch, d.decelerations, LX_start, top_speed(in));
  const CurveView EBD = curve(CurveKind::EBD);
  const CurveView SBD = curve(CurveKind::SBD);
  CurveView GUI;
  if (d.guidance) GUI = curve(CurveKind::GUI);
  // 3.4.0: no acceleration and f41(V_LX); 4.0.0: the current ones.
  Approach a{.V = V_LX, .V_delta0 = V_delta0_41(d, V_LX), .A_est1 = {}, .A_est2 = {}};
  if (d.rules.LX_with_current_motion) a = approach(V_LX, d.Q_NVINHSMICPERM ? Speed{0.0} : m.V_ura, m.A_est, d.fixed);
  // The stop is both EOA and SvL; 4.0.0 reduces the build-up times for V_LX (A.3.12).
  Target stop;
  stop.kind = TargetKind::EOA_SvL;
  stop.zero = true;
  stop.d_target = stop.d_EOA = LX_start;
  TimesAsked asked;
  if (d.rules.reduced_build_up) asked.reduced_from = Fronts{m.est_front, m.min_safe_front};
  const TargetTimes t = times_of(d, stop, a, asked);
  lx.EBD = limits_of_EBD(EBD, GUI, a, t.EBD, Speed{0.0}, std::nullopt, d.fixed);
  lx.SBD = limits_of_SBD(SBD, GUI, a, t.SBD, d.fixed);
  lx.from_SBD = lx.EBD.d_SBI - lx.SBD.d_SBI >= m.max_safe_front - m.est_front;
  lx.d_P = lx.from_SBD ? lx.SBD.d_P : lx.EBD.d_P;
  lx.passed = (lx.from_SBD ? m.est_front : m.max_safe_front) > lx.d_P;
  return lx;
}

ServiceBrakeStop service_brake_stop(const Inputs& in, const Derived& d, Place foot, Speed V, Derived& scratch) {
  CurvesToStop curve(scratch, d.decelerations, foot, top_speed(in));
  const CurveView SBD = curve(CurveKind::SBD);
  const Approach a = approach(V, Speed{0.0}, {}, d.fixed);
  Target stop;
  stop.kind = TargetKind::EOA_SvL;
  stop.zero = true;
  stop.d_target = stop.d_EOA = foot;
  const Limits limits = limits_of_SBD(SBD, CurveView{}, a, times_of(d, stop, a, {}).SBD, d.fixed);
  return {limits.d_SBI, limits.d_P};
}

Speed permitted_braking_distance_speed(const Inputs& in, Distance permitted, double grad, bool emergency_brake,
                                       Derived& scratch) {
  // 3.11.11.4: only the gradient of the packet, no trackside adhesion, inhibition or powerless
  // section; slippery rail selected by the driver counts. Traction cut-off and feedback as if not
  // implemented.
  TrackConditions conditions;
  conditions.slippery_rail = in.conditions.slippery_rail;
  determine(scratch.decelerations, in.train, in.national_values, in.fixed, in.brakes, grad, conditions);
  const Speed top = top_speed(in);
  CurvesToStop curve(scratch, scratch.decelerations, {permitted}, top);
  const CurveView EBD = curve(CurveKind::EBD);
  const CurveView SBD = curve(CurveKind::SBD);
  TimeConfig config = time_config(in.train, in.national_values);
  config.traction_cut_off_interface = false;
  config.feedback_available = false;
  const train::BuildUpTimes build_up = train::build_up_times(in.train, in.national_values, in.brakes, true);
  const Times t = times(config, build_up, std::nullopt, rules_of(in.srs), in.fixed);
  const Duration T_be = t.T_traction + t.T_berem;
  const auto V_delta0 = [&](Speed V) { return in.national_values.Q_NVINHSMICPERM ? Speed{0.0} : train::f41(V); };
  // Excess of the speed over the EBD at the place where the full effort begins (V_ = V + dV); beyond the curve the EBD
  // is 0.
  const auto EBD_excess = [&](Speed V_, Duration T_bs2) {
    const Speed v = V_ + V_delta0(V_);
    const Place x = Place{in.train.L_antenna_front} + v * in.fixed.T41_balise + v * T_be + V_ * T_bs2;
    return V_ - (EBD.speed_at(x) - V_delta0(V_));
  };
  const auto SBD_excess = [&](Speed V_) {
    const Place x = Place{in.train.L_antenna_front} + V_ * in.fixed.T41_balise + V_ * t.T_bs1;
    return V_ - SBD.speed_at(x);
  };
  const auto excess = [&](Speed V) {
    if (emergency_brake) return EBD_excess(V + dV_ebi(V, in.fixed), Duration{0.0});
    const Speed V_ = V + dV_sbi(V, in.fixed);
    return std::max(EBD_excess(V_, t.T_bs2), SBD_excess(V_));
  };
  // The excess grows continuously with V; the lowest speed within the tolerance is used (deterministic, safe side). 0
  // if the excess at 0 is higher already; the highest speed of the curves if no speed reaches the tolerance.
  Speed low{0.0};
  Speed high = top;
  for (int i = 0; i < 60; ++i) {
    const Speed middle = low + (high - low) / 2.0;
    (excess(middle) >= -in.fixed.search_tolerance ? high : low) = middle;
  }
  // Round down to 5 km/h, without a floor function: count the steps.
  Speed V{0.0};
  for (int n = 1; Speed{n * in.fixed.PBD_rounding.si} <= high; ++n) V = {n * in.fixed.PBD_rounding.si};
  return V;
}

}  // namespace evc::sdm
