#include <algorithm>

#include "sdm/cycle.h"

namespace evc::sdm {
namespace {

/// No limit of the target can be exceeded and none of its speeds can be the lowest: both curves lie
/// above V_relevant at every place that matters. `d_I_at_least` gets a lower bound of the distance to
/// the Indication limit.
bool far_away(const Cycle& c, const Target& t, double& d_I_at_least) {
  d_I_at_least = -kFar;
  if (c.d.guidance || c.d.time_config.feedback_available || c.d.rules.pre_indication || t.warnings.truncated)
    return false;
  const Times& times = t.zero ? c.cm0 : c.cmt;
  const BuildUpLoss loss = before_emergency_effort(c.a, times, t.V_target);
  if (loss.V_bec >= c.d.V_relevant) return false;
  if (c.d.V_relevant - (c.V_delta0 + loss.V_delta1 + loss.V_delta2) <= c.M_ebi) return false;
  const Distance before = c.a.V * (times.T_bs2 + c.d.fixed.T_driver + times.T_indication) + loss.D_bec;
  // A curve that falls upstream is lower than V_relevant only in front of x_relevant.
  double room = (t.x_relevant - before - c.m.max_safe_front).si;
  if (t.kind == TargetKind::EOA_SvL) {
    const Distance before_EOA = c.a.V * (times.T_bs1 + c.d.fixed.T_driver + times.T_indication);
    room = std::min(room, (t.x_relevant_EOA - before_EOA - c.m.est_front).si);
  }
  if (room <= 0.0) return false;
  d_I_at_least = room;
  return true;
}

void set_beyond(Seen& seen, const Limits& l, Place front, bool EBD) {
  if (front > l.d_I) seen.beyond |= bit(Limit::I);
  if (front > l.d_P) seen.beyond |= bit(Limit::P);
  if (front > l.d_W) seen.beyond |= bit(Limit::W);
  if (front > l.d_SBI) seen.beyond |= bit(Limit::SBI);
  if (EBD && front > *l.d_EBI) seen.beyond |= bit(Limit::EBI);
}

void first_indication(Cycle& c, std::size_t i, const Target& t, const TargetLimits& l) {
  if (!c.d.rules.first_indication) return;
  const bool above_release = !release(c).exists || c.a.V >= release(c).V_release;
  double distance = kFar;
  if (t.kind == TargetKind::EOA_SvL) {
    if (above_release)
      distance = std::min((l.SBD->d_I - c.m.est_front).si, (l.EBD.d_I - c.m.max_safe_front).si);
    else
      distance = std::min((c.rsm.d_SBI1 - c.m.est_front).si, (c.rsm.d_SBI2 - c.m.max_safe_front).si);
  } else if (t.V_target < c.M && t.V_target < c.a.V && (above_release || !behind_trip_location(c, t))) {
    distance = (l.EBD.d_I - c.m.max_safe_front).si;
  }
  if (distance < c.first_indication) {
    c.first_indication = distance;
    c.first_indication_target = i;
  }
}

void note_reduced(Cycle& c, const TargetTimes& t) {
  c.reduced = c.reduced || t.reduced_be || (t.reduced_bs && c.d.time_config.service_brake_available);
}

}  // namespace

void evaluate(Cycle& c, std::size_t i, Seen& seen) {
  const Target& t = c.d.targets[i];
  seen = Seen{0, false, false, false, kFar, kFar, kFar, kFar, kFar, kFar};
  double room = 0.0;
  if (far_away(c, t, room) && (!c.d.rules.first_indication || room >= c.first_indication)) {
    // A.3.13 asks whether any target's build-up time is reduced, the far ones' too.
    if (c.d.rules.reduced_build_up && !c.reduced) note_reduced(c, times_of(c.d, t, c.a, asked(c, t)));
    return;
  }
  seen.near = true;
  TargetLimits l;
  if (c.d.rules.reduced_build_up || c.d.time_config.feedback_available) {
    l = limits_of(c.d, t, c.a, asked(c, t));
    note_reduced(c, l.times);
  } else {
    l.times.EBD = l.times.SBD = t.zero ? c.cm0 : c.cmt;
    l.EBD = EBD_limits_of(c.d, t, c.a, l.times.EBD);
    if (t.kind == TargetKind::EOA_SvL) l.SBD = SBD_limits_of(c.d, t, c.a, l.times.SBD);
  }
  set_beyond(seen, l.EBD, c.m.max_safe_front, true);
  seen.beyond_I_EBD = c.m.max_safe_front > l.EBD.d_I;
  const LimitSpeeds e =
      speeds_of_EBD(c.d.view(t.EBD), c.d.view(t.GUI), c.a, l.times.EBD, t.V_target, c.m.max_safe_front, c.d.fixed);
  seen.V_P_EBD = e.V_P.si;
  seen.V_P = e.V_P.si;
  // 3.13.10.4.4: towards EOA and SvL never below the release speed.
  const double floor = t.kind == TargetKind::EOA_SvL && release(c).exists ? release(c).V_release.si : 0.0;
  seen.V_W = std::max(e.V_W.si, floor);
  seen.V_SBI = std::max(e.V_SBI.si, floor);
  seen.V_EBI = std::max(e.V_EBI.si, floor);
  if (l.SBD.has_value()) {
    set_beyond(seen, *l.SBD, c.m.est_front, false);
    seen.beyond_I_SBD = c.m.est_front > l.SBD->d_I;
    const LimitSpeeds s =
        speeds_of_SBD(c.d.view(t.SBD), c.d.view(t.GUI_EOA), c.a, l.times.SBD, t.d_EOA, c.m.est_front, c.d.fixed);
    seen.V_P_SBD = s.V_P.si;
    seen.V_P = std::min(seen.V_P, s.V_P.si);
    seen.V_W = std::min(seen.V_W, std::max(s.V_W.si, floor));
    seen.V_SBI = std::min(seen.V_SBI, std::max(s.V_SBI.si, floor));
  }
  if (c.d.rules.pre_indication && c.a.V > c.M) {
    const TargetLimits at_M = limits_at(c, t, c.M);
    if (c.m.max_safe_front > at_M.EBD.d_I || (at_M.SBD.has_value() && c.m.est_front > at_M.SBD->d_I))
      seen.beyond |= bit(Limit::I_M);
  }
  first_indication(c, i, t, l);
}

}  // namespace evc::sdm
