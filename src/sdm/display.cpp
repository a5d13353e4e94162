#include <algorithm>

#include "sdm/cycle.h"

namespace evc::sdm {
namespace {

// ---- Most relevant displayed target -----------------------------------------------------------------

bool concerned(const Cycle& c, const Seen& seen, const Target& t) {
  if (t.kind == TargetKind::EOA_SvL) return seen.beyond_I_EBD || seen.beyond_I_SBD;
  return seen.beyond_I_EBD && t.V_target < c.M && c.a.V >= t.V_target;
}

/// 3.13.9.3.5.9: where the Permitted speed has fallen to the target speed; for the target distance and for masking.
Place d_P_at_target_speed(const Cycle& c, const Target& t) {
  const std::optional<FeedbackTimes>& feedback = c.feedback.towards(t);
  if (!feedback.has_value()) return t.d_P_target;
  const train::BuildUpTimes& build_up = t.zero ? c.d.cm0 : c.d.cmt;
  return d_P_at_target_speed(c.d.view(t.EBD), t.V_target, t.d_target,
                             times(c.d.time_config, build_up, feedback, c.d.rules, c.d.fixed), build_up,
                             c.d.time_config, V_delta0_41(c.d, t.V_target), c.d.rules, c.d.fixed);
}

/// Distance of the Indication limit of `t` for speed V in rear of d_P; where it is negative nothing is masked.
double in_rear(const Cycle& c, const Target& t, Speed V, Place d_P) {
  const TargetLimits l = limits_at(c, t, V);
  const double EBD = (d_P - l.EBD.d_I).si;
  return l.SBD.has_value() ? std::max(EBD, (d_P - l.SBD->d_I).si) : EBD;
}

/// 3.13.10.4.4.1: of the targets masked by the MRDT, the one whose Indication limit is furthest in rear (the first of
/// equal ones); kTargets if it masks none.
std::size_t furthest_masked(const Cycle& c, const Seen* seen, std::size_t masking) {
  const Target& MRDT = c.d.targets[masking];
  const Ahead ahead = ahead_of(c, MRDT.V_target);
  const Place d_P = d_P_at_target_speed(c, MRDT);
  // Bounds first: only the few candidates that may be the furthest are evaluated exactly, the best one first.
  InplaceVector<std::uint8_t, kTargets> candidates;
  std::array<double, kTargets> at_most;  // of each candidate; 0 when it was looked at
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i) {
    const Target& t = c.d.targets[i];
    if (i == masking || !(t.V_target < MRDT.V_target) || !concerned(c, seen[i], t)) continue;
    const Earliest I = earliest_indication(c, t, ahead, Speed{0.0});
    at_most[i] = (d_P - I.EBD).si;
    if (t.kind == TargetKind::EOA_SvL) at_most[i] = std::max(at_most[i], (d_P - I.SBD).si);
    if (at_most[i] > 0.0) (void)candidates.push_back(static_cast<std::uint8_t>(i));
  }
  std::size_t furthest = kTargets;
  double distance = 0.0;
  for (;;) {
    std::size_t next = kTargets;
    for (const std::uint8_t i : candidates)
      if (at_most[i] >= distance && at_most[i] > 0.0 && (next == kTargets || at_most[i] > at_most[next])) next = i;
    if (next == kTargets) return furthest;
    at_most[next] = 0.0;
    const double d = in_rear(c, c.d.targets[next], MRDT.V_target, d_P);
    if (d > distance || (d == distance && next < furthest && furthest != kTargets)) {
      distance = d;
      furthest = next;
    }
  }
}

std::size_t select_MRDT_masking(const Cycle& c, const Seen* seen) {
  std::size_t best = kTargets;
  double lowest = kFar;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i) {
    if (!concerned(c, seen[i], c.d.targets[i])) continue;
    if (best == kTargets || seen[i].V_P_beyond_I < lowest) {
      best = i;
      lowest = seen[i].V_P_beyond_I;
    }
  }
  // Each step leads to a lower target speed: no target occurs twice.
  for (std::size_t next = best; next != kTargets; next = furthest_masked(c, seen, next)) best = next;
  return best;
}

std::size_t lowest_V_P(const Cycle& c, const Seen* seen) {
  std::size_t best = kTargets;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i)
    if (best == kTargets || seen[i].V_P < seen[best].V_P) best = i;
  return best;
}

std::size_t index_of(const Cycle& c, const TargetId& id) {
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i)
    if (id_of(c.d.targets[i]) == id) return i;
  return kTargets;
}

// ---- Display ----------------------------------------------------------------------------------------

Distance target_distance(const Cycle& c, const Target& t) {
  if (t.kind == TargetKind::EOA_SvL)
    return std::max(Distance{0.0}, std::min(t.d_EOA - c.m.est_front, t.d_target - c.m.max_safe_front));
  return std::max(Distance{0.0}, d_P_at_target_speed(c, t) - c.m.max_safe_front);
}

void show_limits(const Cycle& c, const Seen* seen, Result& out) {
  const Bounds b = ceiling_bounds(c.M, c.d.fixed);
  out.V_MRSP = c.M;
  out.V_P = at(b, Bound::M);
  out.V_W = at(b, Bound::M_w);
  out.V_SBI = at(b, Bound::M_sbi);
  out.V_EBI = at(b, Bound::M_ebi);
  // No target that is far away has an Indication limit below V_MRSP here.
  if (c.s.monitoring != Monitoring::RSM) out.V_I = std::min(c.M, Speed{c.V_I});
  if (c.s.monitoring == Monitoring::CSM) return;
  if (c.s.monitoring == Monitoring::RSM) {
    out.V_W = out.V_SBI = out.V_EBI = release(c).V_release;
    const std::size_t i = index_of(c, c.s.MRDT);
    if (i != kTargets) out.V_P = std::min(out.V_P, Speed{seen[i].V_P});
    return;
  }
  const std::size_t MRDT = c.s.has_MRDT ? index_of(c, c.s.MRDT) : kTargets;
  // The speeds of a target that is far away are far above all others. 3.4.0 shows the Permitted speed of the MRDT; it
  // has the lowest one anyway.
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i)
    if (c.d.rules.masking || i == MRDT) out.V_P = std::min(out.V_P, Speed{seen[i].V_P});
  out.V_W = std::min(out.V_W, Speed{c.V_W});
  out.V_SBI = std::min(out.V_SBI, Speed{c.V_SBI});
  out.V_EBI = std::min(out.V_EBI, Speed{c.V_EBI});
}

void show_target(const Cycle& c, std::size_t i, Result& out) {
  const Target& t = c.d.targets[i];
  out.V_target = t.V_target;
  out.d_target = target_distance(c, t);
  out.MRDT = id_of(t);
  if (t.kind == TargetKind::EOA_SvL && release(c).exists) out.V_release = release(c).V_release;
}

/// 3.13.10.3.8: does the target count for the first Indication location?
bool leads_to_indication(const Cycle& c, const Target& t, bool above_release) {
  if (t.kind == TargetKind::EOA_SvL) return true;
  return t.V_target < c.M && t.V_target < c.a.V && (above_release || !behind_trip_location(c, t));
}

/// Distance to the Indication limit of a target, to the start of release speed monitoring below the release speed.
double to_indication(const Cycle& c, const Target& t, const Seen& seen, bool above_release) {
  if (t.kind == TargetKind::EOA_SvL && !above_release)
    return std::min((c.rsm.d_SBI1 - c.m.est_front).si, (c.rsm.d_SBI2 - c.m.max_safe_front).si);
  if (seen.near) return seen.to_I;
  const TargetLimits l = limits_at(c, t, c.a.V);
  const double EBD = (l.EBD.d_I - c.m.max_safe_front).si;
  return l.SBD.has_value() ? std::min(EBD, (l.SBD->d_I - c.m.est_front).si) : EBD;
}

/// 3.13.10.3.8-10: the outputs of ceiling speed monitoring about the first Indication.
void show_first_indication(const Cycle& c, const Seen* seen, Result& out) {
  if (!c.d.rules.first_indication) return;
  const bool above_release = !release(c).exists || c.a.V >= release(c).V_release;
  std::size_t first = kTargets;
  double distance = kFar;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i) {
    const Target& t = c.d.targets[i];
    const bool may_be_nearer = seen[i].to_I < distance || (t.kind == TargetKind::EOA_SvL && !above_release);
    if (!may_be_nearer || !leads_to_indication(c, t, above_release)) continue;
    const double d = to_indication(c, t, seen[i], above_release);
    if (d < distance) {
      distance = d;
      first = i;
    }
  }
  if (first == kTargets) return;
  distance = std::max(distance, 0.0);
  out.first_indication = Distance{distance};
  out.first_indication_of = id_of(c.d.targets[first]);
  if (c.d.csm_display == train::MaxReducedAdhesion::Display::target_information) show_target(c, first, out);
  if (c.d.csm_display == train::MaxReducedAdhesion::Display::time_to_indication &&
      Distance{distance} < c.a.V * c.d.fixed.T_dispTTI)
    out.TTI = Duration{distance / c.a.V.si};
}

template <class T>
void hold(bool& flag, bool also, std::optional<T>& shown, T& value) {
  if ((flag || also) && shown.has_value()) {
    if (value < *shown)
      flag = false;  // a value is no longer held once it falls
    else
      value = *shown;
  }
  shown = value;
}

/// A.3.10, A.3.13: displayed values do not rise because build-up times get shorter.
void hold_shown_values(Cycle& c, bool MRDT_changed, Result& out) {
  Supervision& s = c.s;
  const bool pawl = c.d.rules.reduced_build_up && c.reduced && !MRDT_changed;
  if (s.monitoring == Monitoring::CSM || MRDT_changed) s.hold_P = s.hold_SBI = s.hold_target_distance = false;
  if (s.monitoring == Monitoring::CSM) {
    s.shown_P.reset();
    s.shown_SBI.reset();
    s.shown_target_distance.reset();
    return;
  }
  hold(s.hold_P, pawl, s.shown_P, out.V_P);
  if (s.monitoring == Monitoring::TSM)
    hold(s.hold_SBI, pawl, s.shown_SBI, out.V_SBI);
  else
    s.shown_SBI.reset();  // 3.13.10.5: release speed monitoring displays no SBI that might have to be held
  if (out.d_target.has_value()) {
    Distance shown = *out.d_target;
    hold(s.hold_target_distance, false, s.shown_target_distance, shown);
    out.d_target = shown;
  }
}

}  // namespace

bool select_MRDT(Cycle& c, const Seen* seen) {
  std::size_t selected = kTargets;
  if (c.s.monitoring == Monitoring::RSM) {
    for (std::size_t i = c.first; i < c.d.targets.size(); ++i)
      if (c.d.targets[i].kind == TargetKind::EOA_SvL) selected = i;
  } else if (c.d.rules.masking) {
    selected = select_MRDT_masking(c, seen);
  } else {
    selected = lowest_V_P(c, seen);
  }
  const std::size_t current = c.s.has_MRDT ? index_of(c, c.s.MRDT) : kTargets;
  if (selected == kTargets) {
    if (current == kTargets) c.s.has_MRDT = false;
    return false;
  }
  const TargetId id = id_of(c.d.targets[selected]);
  if (c.s.has_MRDT && id == c.s.MRDT) return false;
  const bool stays = c.d.rules.masking && c.s.monitoring == Monitoring::TSM && current != kTargets &&
                     !(id.V_target <= c.s.MRDT.V_target);
  if (stays) return false;
  c.s.has_MRDT = true;
  c.s.MRDT = id;
  return true;
}

void display(Cycle& c, const Seen* seen, Result& out) {
  show_limits(c, seen, out);
  out.show_SBI = c.s.status >= Status::Overspeed;
  if (c.s.monitoring == Monitoring::CSM) {
    show_first_indication(c, seen, out);
  } else if (c.s.has_MRDT) {
    if (const std::size_t i = index_of(c, c.s.MRDT); i != kTargets) show_target(c, i, out);
  }
  hold_shown_values(c, out.MRDT_changed, out);
}

}  // namespace evc::sdm
