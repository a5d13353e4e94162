#include <algorithm>

#include "sdm/cycle.h"

namespace evc::sdm {
namespace {

/// No limit of the target can be exceeded and none of its speeds can be the lowest: both curves are above every
/// relevant speed at every relevant place. `room` is set to a lower bound of the distance to the Indication limit.
bool far_away(const Cycle& c, const Target& t, double& room) {
  if (c.d.rules.pre_indication) return false;
  const BuildUpLoss& loss = t.zero ? c.ahead.loss_cm0 : c.ahead.loss_cmt;
  const Earliest I = earliest_indication(c, t, c.ahead, c.M_ebi + c.V_delta0 + loss.V_delta1 + loss.V_delta2);
  room = (I.EBD - c.m.max_safe_front).si;
  if (t.kind == TargetKind::EOA_SvL) room = std::min(room, (I.SBD - c.m.est_front).si);
  return room > 0.0;
}

void set_beyond(Seen& seen, const Limits& l, Place front, bool EBD) {
  if (front > l.d_I) seen.beyond |= bit(Limit::I);
  if (front > l.d_P) seen.beyond |= bit(Limit::P);
  if (front > l.d_W) seen.beyond |= bit(Limit::W);
  if (front > l.d_SBI) seen.beyond |= bit(Limit::SBI);
  if (EBD && front > *l.d_EBI) seen.beyond |= bit(Limit::EBI);
}

/// Whether it is certain, without evaluating the track, that no build-up time is reduced.
bool full_build_up(const Cycle& c, const Target& t) {
  return !c.d.rules.reduced_build_up || t.V_target < (t.zero ? c.full_below_cm0 : c.full_below_cmt);
}

/// 3.13.8.2.1 a (4.0.0): an element of the MRSP that is not lower than V_MRSP is no target now.
bool in_list(const Cycle& c, const Target& t) { return t.kind != TargetKind::MRSP || t.V_target < c.M; }

/// Above it the Indication limit of the target is passed where the train is. With 4.0.0 feedback does not move that
/// limit (3.13.9.3.6.5): `EBD` and `SBD`, speeds with the times of the moment, count without feedback only.
Speed V_I(const Cycle& c, const Target& t, const LimitSpeeds& EBD, const std::optional<LimitSpeeds>& SBD) {
  const Speed of_the_moment = SBD.has_value() ? std::min(EBD.V_I, SBD->V_I) : EBD.V_I;
  if (!c.d.rules.indication_ignores_feedback) return of_the_moment;
  const TimesAsked q = asked(c, t);
  if (!q.feedback.has_value()) return of_the_moment;
  const TargetTimes times = times_of(c.d, t, c.a, {std::nullopt, q.reduced_from});
  const Speed V =
      speeds_of_EBD(c.d.view(t.EBD), c.d.view(t.GUI), c.a, times.EBD, t.V_target, c.m.max_safe_front, c.d.fixed).V_I;
  if (!SBD.has_value()) return V;
  return std::min(
      V, speeds_of_SBD(c.d.view(t.SBD), c.d.view(t.GUI_EOA), c.a, times.SBD, t.d_EOA, c.m.est_front, c.d.fixed).V_I);
}

void note_reduced(Cycle& c, const Target& target, const TargetTimes& t) {
  if (!in_list(c, target)) return;
  c.reduced = c.reduced || t.reduced_be || (t.reduced_bs && c.d.time_config.service_brake_available);
}

}  // namespace

Ahead ahead_of(const Cycle& c, Speed V) {
  Ahead ahead{.a = c.a};
  ahead.a.V = V;
  ahead.loss_cm0 = before_emergency_effort(ahead.a, c.longest_cm0, Speed{0.0});
  ahead.loss_cmt = before_emergency_effort(ahead.a, c.longest_cmt, Speed{0.0});
  return ahead;
}

Earliest earliest_indication(const Cycle& c, const Target& t, const Ahead& ahead, Speed V_least) {
  if (c.d.guidance || c.d.time_config.feedback_available || t.warnings.truncated) return {{{-kFar}}, {{-kFar}}};
  const Times& longest = t.zero ? c.longest_cm0 : c.longest_cmt;
  BuildUpLoss loss = t.zero ? ahead.loss_cm0 : ahead.loss_cmt;
  if (t.V_target > ahead.a.V) loss = before_emergency_effort(ahead.a, longest, t.V_target);
  const Speed V = std::max(loss.V_bec, V_least) + kSpare;
  const Duration to_I = c.d.fixed.T_driver + longest.T_indication;
  // With 4.0.0, P is not beyond the target.
  Earliest I;
  I.EBD = std::min(c.d.view(t.EBD).place_at(V), t.d_target) - (ahead.a.V * (longest.T_bs2 + to_I) + loss.D_bec);
  if (t.kind == TargetKind::EOA_SvL) I.SBD = c.d.view(t.SBD).place_at(V) - ahead.a.V * (longest.T_bs1 + to_I);
  return I;
}

void evaluate(Cycle& c, std::size_t i, Seen& seen) {
  const Target& t = c.d.targets[i];
  seen = Seen{0, false, false, false, kFar, kFar, kFar};
  if (far_away(c, t, seen.to_I)) {
    // A.3.13 depends on whether the build-up time of any target is reduced, including far ones.
    if (c.d.rules.reduced_build_up && !c.reduced && in_list(c, t) && !full_build_up(c, t))
      note_reduced(c, t, times_of(c.d, t, c.a, asked(c, t)));
    return;
  }
  seen.near = true;
  TargetLimits l;
  if (!full_build_up(c, t) || c.d.time_config.feedback_available) {
    l = limits_of(c.d, t, c.a, asked(c, t));
    note_reduced(c, t, l.times);
  } else {
    l.times.EBD = l.times.SBD = t.zero ? c.cm0 : c.cmt;
    l.EBD = EBD_limits_of(c.d, t, c.a, l.times.EBD);
    if (t.kind == TargetKind::EOA_SvL) l.SBD = SBD_limits_of(c.d, t, c.a, l.times.SBD);
  }
  set_beyond(seen, l.EBD, c.m.max_safe_front, true);
  seen.beyond_I_EBD = c.m.max_safe_front > l.EBD.d_I;
  const LimitSpeeds e =
      speeds_of_EBD(c.d.view(t.EBD), c.d.view(t.GUI), c.a, l.times.EBD, t.V_target, c.m.max_safe_front, c.d.fixed);
  seen.V_P = e.V_P.si;
  if (seen.beyond_I_EBD) seen.V_P_beyond_I = e.V_P.si;
  // 3.13.10.4.4: towards EOA and SvL never below the release speed.
  const double floor = t.kind == TargetKind::EOA_SvL && release(c).exists ? release(c).V_release.si : 0.0;
  c.V_W = std::min(c.V_W, std::max(e.V_W.si, floor));
  c.V_SBI = std::min(c.V_SBI, std::max(e.V_SBI.si, floor));
  c.V_EBI = std::min(c.V_EBI, std::max(e.V_EBI.si, floor));
  std::optional<LimitSpeeds> s;
  if (l.SBD.has_value()) {
    set_beyond(seen, *l.SBD, c.m.est_front, false);
    seen.beyond_I_SBD = c.m.est_front > l.SBD->d_I;
    s = speeds_of_SBD(c.d.view(t.SBD), c.d.view(t.GUI_EOA), c.a, l.times.SBD, t.d_EOA, c.m.est_front, c.d.fixed);
    seen.V_P = std::min(seen.V_P, s->V_P.si);
    if (seen.beyond_I_SBD) seen.V_P_beyond_I = std::min(seen.V_P_beyond_I, s->V_P.si);
    c.V_W = std::min(c.V_W, std::max(s->V_W.si, floor));
    c.V_SBI = std::min(c.V_SBI, std::max(s->V_SBI.si, floor));
  }
  c.V_I = std::min(c.V_I, V_I(c, t, e, s).si);
  if (c.d.rules.pre_indication && c.a.V > c.M) {
    Approach at_M = c.a;
    at_M.V = c.M;
    if (c.m.max_safe_front > EBD_limits_of(c.d, t, at_M, l.times.EBD).d_I ||
        (l.SBD.has_value() && c.m.est_front > SBD_limits_of(c.d, t, at_M, l.times.SBD).d_I))
      seen.beyond |= bit(Limit::I_M);
  }
  seen.to_I = (l.EBD.d_I - c.m.max_safe_front).si;
  if (l.SBD.has_value()) seen.to_I = std::min(seen.to_I, (l.SBD->d_I - c.m.est_front).si);
}

}  // namespace evc::sdm
