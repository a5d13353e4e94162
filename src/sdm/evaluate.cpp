#include "sdm/evaluate.h"

#include <algorithm>

#include "sdm/reduced_build_up.h"

namespace evc::sdm {
namespace {

Ramp service_ramp(const train::BuildUpTimes& b, const Approach& a) {
  return {.T = b.T_bs, .T_react = b.T_bs_react, .v0 = a.V};
}
Ramp emergency_ramp(const Derived& d, const train::BuildUpTimes& b, const Approach& a) {
  const TimeConfig& c = d.time_config;
  return {.T = b.T_be,
          .T_react = b.T_be_react,
          .v0 = a.V + a.V_delta0,
          .A_est1 = a.A_est1,
          .A_est2 = a.A_est2,
          .T_traction_max = T_traction(c, c.service_brake_available ? b.T_bs_react : Duration{0.0}, d.fixed),
          .T_traction_min = T_traction(c, c.service_brake_available ? b.T_bs : Duration{0.0}, d.fixed)};
}
/// A.3.12.1.5; and A.3.12.1.4, as T_be is 0 with a Kt_int of 0.
bool never_reduced(const train::BuildUpTimes& b, const Times& unreduced) { return unreduced.T_traction >= b.T_be; }

void aim(Ramp& r, const Target& target) {
  r.stop = target.kind == TargetKind::EOA_SvL || target.kind == TargetKind::SR_end;
  r.V_target = target.V_target;
}

/// T_bs_reduced for the curve that ends at `end` (A.3.12, service brake).
Duration reduced_T_bs(const Derived& d, const Target& target, const train::BuildUpTimes& b, const Approach& a,
                      Place end, const Fronts& fronts) {
  Ramp r = service_ramp(b, a);
  aim(r, target);
  if (const auto T = build_up_time_settled(r, d.decelerations.highest_expected)) return *T;
  r.A = deceleration_range(d.decelerations, CurveKind::SBD, target.due_to_TSR, std::min(fronts.est, end), end,
                           fronts.est, r.V_target, a.V);
  return reduced_build_up_time(r);
}

Duration reduced_T_be(const Derived& d, const Target& target, const train::BuildUpTimes& b, const Approach& a,
                      const Times& unreduced, const Fronts& fronts) {
  if (never_reduced(b, unreduced)) return b.T_be;
  Ramp r = emergency_ramp(d, b, a);
  aim(r, target);
  if (const auto T = build_up_time_settled(r, d.decelerations.highest_safe)) return *T;
  const Place end = target.d_target;
  const Speed V_bec = before_emergency_effort(a, unreduced, r.V_target).V_bec;
  r.A = deceleration_range(d.decelerations, CurveKind::EBD, target.due_to_TSR, std::min(fronts.est, end), end,
                           fronts.min_safe, r.V_target, V_bec);
  return reduced_build_up_time(r);
}

}  // namespace

Speed V_delta0_41(const Derived& d, Speed V) { return d.Q_NVINHSMICPERM ? Speed{0.0} : train::f41(V); }

TargetTimes times_of(const Derived& d, const Target& target, const Approach& a, const TimesAsked& asked) {
  const train::BuildUpTimes& full = target.zero ? d.cm0 : d.cmt;
  TargetTimes t;
  if (!d.rules.reduced_build_up || !asked.reduced_from.has_value()) {
    t.EBD = t.SBD = times(d.time_config, full, asked.feedback, d.rules, d.fixed);
    return t;
  }
  train::BuildUpTimes reduced = full;
  train::BuildUpTimes reduced_SBD = full;
  // 3.13.6.3.2.5: only without feedback. The service brake first: T_traction depends on its time.
  if (!d.time_config.feedback_available) {
    reduced.T_bs = reduced_T_bs(d, target, full, a, target.d_target, *asked.reduced_from);
    if (target.kind == TargetKind::EOA_SvL)
      reduced_SBD.T_bs = reduced_T_bs(d, target, full, a, target.d_EOA, *asked.reduced_from);
  }
  t.EBD = t.SBD = times(d.time_config, reduced, asked.feedback, d.rules, d.fixed);
  reduced.T_be = reduced_T_be(d, target, full, a, t.EBD, *asked.reduced_from);
  // T_be occurs only in T_berem.
  t.EBD.T_be = reduced.T_be;
  t.EBD.T_berem = std::max(t.EBD.T_be - t.EBD.T_traction, Duration{0.0});
  if (target.kind == TargetKind::EOA_SvL) t.SBD = times(d.time_config, reduced_SBD, asked.feedback, d.rules, d.fixed);
  t.reduced_be = reduced.T_be < full.T_be;
  t.reduced_bs = reduced.T_bs < full.T_bs || reduced_SBD.T_bs < full.T_bs;
  return t;
}

Speed full_build_up_below(const Derived& d, const train::BuildUpTimes& build_up, const Approach& a,
                          const Times& unreduced) {
  Speed V = never_reduced(build_up, unreduced)
                ? Speed{1e9}
                : full_build_up_below(emergency_ramp(d, build_up, a), d.decelerations.highest_safe);
  if (!d.time_config.feedback_available)
    V = std::min(V, full_build_up_below(service_ramp(build_up, a), d.decelerations.highest_expected));
  return V;
}

Times longest_times(const Times& unreduced, const Derived& d, const train::BuildUpTimes& build_up) {
  Times t = unreduced;
  if (!d.rules.reduced_build_up || d.time_config.feedback_available) return t;
  const Duration T_bs2 =
      d.time_config.service_brake_available ? std::min(build_up.T_bs, build_up.T_bs_react) : Duration{0.0};
  t.T_traction = T_traction(d.time_config, T_bs2, d.fixed);
  return t;
}

Limits EBD_limits_of(const Derived& d, const Target& target, const Approach& a, const Times& t) {
  std::optional<Place> d_target;
  if (d.rules.P_not_beyond_target) d_target = target.d_target;
  return limits_of_EBD(d.view(target.EBD), d.view(target.GUI), a, t, target.V_target, d_target, d.fixed);
}

Limits SBD_limits_of(const Derived& d, const Target& target, const Approach& a, const Times& t) {
  return limits_of_SBD(d.view(target.SBD), d.view(target.GUI_EOA), a, t, d.fixed);
}

TargetLimits limits_of(const Derived& d, const Target& target, const Approach& a, const TimesAsked& asked) {
  TargetLimits l;
  l.times = times_of(d, target, a, asked);
  l.EBD = EBD_limits_of(d, target, a, l.times.EBD);
  if (target.kind == TargetKind::EOA_SvL) l.SBD = SBD_limits_of(d, target, a, l.times.SBD);
  if (d.rules.indication_ignores_feedback && asked.feedback.has_value()) {
    // 3.13.9.3.6.5: T_bs1 = T_bs2 = T_bs in all terms of d_I; T_be is the reduced one there too.
    const TargetTimes without = times_of(d, target, a, {std::nullopt, asked.reduced_from});
    l.EBD.d_I = EBD_limits_of(d, target, a, without.EBD).d_I;
    if (l.SBD.has_value()) l.SBD->d_I = SBD_limits_of(d, target, a, without.SBD).d_I;
  }
  return l;
}

RsmStart rsm_start(const Derived& d, const Target& EOA_SvL, Speed V_release, Place d_trip, bool on_board,
                   const Feedback& feedback) {
  const Approach a{.V = V_release, .V_delta0 = V_delta0_41(d, V_release), .A_est1 = {}, .A_est2 = {}};
  const auto asked = [&](const Target& t) {
    TimesAsked times{feedback.towards(t), {}};
    if (d.rules.reduced_build_up) {
      // The location must not depend on the train's position: a train about to reach it is assumed. The place with
      // unreduced times is the earliest possible one; the longest stretch ahead is the safe side (A.3.12.2.2-5).
      const TargetLimits earliest = limits_of(d, t, a, times);
      Place here = earliest.EBD.d_SBI;
      if (earliest.SBD.has_value()) here = std::min(here, earliest.SBD->d_SBI);
      times.reduced_from = Fronts{here, here};
    }
    return times;
  };
  const TargetLimits l = limits_of(d, EOA_SvL, a, asked(EOA_SvL));
  RsmStart start{l.SBD->d_SBI, l.EBD.d_SBI};
  if (!on_board) return start;
  // 3.13.9.4.7: the limits at the release speed. A target speed above it cannot be exceeded: it has no limit there.
  for (const Target& t : d.targets)
    if (t.kind == TargetKind::MRSP && t.V_target <= V_release && t.d_target >= d_trip && t.d_target <= EOA_SvL.d_target)
      start.d_SBI2 = std::min(start.d_SBI2, limits_of(d, t, a, asked(t)).EBD.d_SBI);
  return start;
}

}  // namespace evc::sdm
