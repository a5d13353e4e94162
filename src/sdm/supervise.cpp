#include <algorithm>

#include "sdm/evaluate.h"
#include "sdm/supervision.h"
#include "sdm/tables.h"

namespace evc::sdm {
namespace {

constexpr double kFar = 1e18;

/// What a target looks like in this cycle. Plain numbers: nothing is cleared that is not used.
struct Seen {
  unsigned beyond;  // bit per Limit
  bool beyond_I_EBD, beyond_I_SBD;
  bool near;  // some limit of it can be exceeded; only then the speeds are valid
  double V_P, V_P_EBD, V_P_SBD, V_W, V_SBI, V_EBI;
};

constexpr unsigned bit(Limit l) { return 1u << static_cast<unsigned>(l); }

struct Cycle {
  Supervision& s;
  const Derived& d;
  const Motion& m;
  std::size_t first = 0;  // MRSP targets before it are passed
  Speed M{};              // V_MRSP
  Speed V_delta0{};
  Approach a{};
  Times cm0{}, cmt{};
  std::optional<FeedbackTimes> feedback_cm0{}, feedback_cmt{};
  bool reduced = false;  // some build-up time is reduced
  bool list_updated = false;
  bool V_MRSP_updated = false;
  Speed M_ebi{};  // V_MRSP + dV_ebi: the highest ceiling shown
  double first_indication = kFar;
  std::size_t first_indication_target = kTargets;
  RsmStart rsm{};
};

TargetId id_of(const Target& t) { return {t.kind, t.d_target, t.V_target}; }

const ReleaseSpeed& release(const Cycle& c) { return c.d.release_speed; }

/// 3.13.10.4.13: none, or not below V_MRSP: the tables are read with 0.
Speed V_release_in_tables(const Cycle& c) {
  return release(c).exists && release(c).V_release < c.M ? release(c).V_release : Speed{0.0};
}

bool behind_trip_location(const Cycle& c, const Target& t) {
  // The SvL and targets between trip location and SvL (3.13.10.3.8, Table 16 [1]).
  if (t.kind == TargetKind::EOA_SvL) return true;
  return t.kind == TargetKind::MRSP && release(c).exists && t.d_target >= release(c).d_trip;
}

TimesAsked asked(const Cycle& c, const Target& t) {
  TimesAsked q;
  q.feedback = t.zero ? c.feedback_cm0 : c.feedback_cmt;
  if (c.d.rules.reduced_build_up) q.reduced_from = Fronts{c.m.est_front, c.m.min_safe_front};
  return q;
}

/// Limits for another speed than V_est, with that speed's own assumptions.
TargetLimits limits_at(const Cycle& c, const Target& t, Speed V) {
  Approach a = c.a;
  a.V = V;
  return limits_of(c.d, t, a, asked(c, t));
}

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

/// Conditions [1]-[6] of Table 16, bit n for [n].
unsigned transition_conditions(const Cycle& c, const Seen* seen) {
  const ReleaseSpeed& r = release(c);
  bool one = false;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i) {
    const Target& t = c.d.targets[i];
    if (c.d.rules.pre_indication) {
      one = one || t.preindication_passed_at_once ||
            (t.d_preindication_EBD.has_value() && c.m.max_safe_front > *t.d_preindication_EBD) ||
            (t.d_preindication_SBD.has_value() && c.m.est_front > *t.d_preindication_SBD);
      continue;
    }
    if (!r.exists || c.a.V >= r.V_release) {
      const bool EBD = seen[i].beyond_I_EBD && t.V_target < c.M && t.V_target < c.a.V;
      one = one || (!c.m.standstill && (EBD || seen[i].beyond_I_SBD));
    } else {
      one = one || (seen[i].beyond_I_EBD && t.V_target < c.a.V && !behind_trip_location(c, t));
    }
  }
  bool two = false;
  if (r.exists) {
    const bool from_SBD = c.rsm.d_SBI2 - c.rsm.d_SBI1 >= c.m.max_safe_front - c.m.est_front;
    two = from_SBD ? c.m.est_front > c.rsm.d_SBI1 : c.m.max_safe_front > c.rsm.d_SBI2;
  }
  bool MRDT_in_list = false;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i)
    MRDT_in_list = MRDT_in_list || (c.s.has_MRDT && id_of(c.d.targets[i]) == c.s.MRDT);
  const bool three = c.d.rules.pre_indication ? c.list_updated && !one : !MRDT_in_list && !one && !two;
  const bool six = c.V_MRSP_updated && MRDT_in_list && !(c.s.MRDT.V_target < c.M) && !one && !two;
  unsigned met = 0;
  if (one) met |= condition(1);
  if (two) met |= condition(2);
  if (three) met |= condition(3);
  if (c.list_updated && one && !two) met |= condition(4);
  if (c.list_updated && two) met |= condition(5);
  if (six) met |= condition(6);
  return met;
}

Monitoring next_monitoring(const Cycle& c, unsigned met) {
  if (!c.s.active) {
    if ((met & condition(2)) != 0) return Monitoring::RSM;
    return (met & condition(1)) != 0 ? Monitoring::TSM : Monitoring::CSM;
  }
  // A release speed that is gone cannot be monitored: its target is, until it goes too.
  if (c.s.monitoring == Monitoring::RSM && !release(c).exists && (met & condition(3)) == 0) return Monitoring::TSM;
  for (const TransitionRow& row : transition_table(c.d.rules))
    if (row.from == c.s.monitoring && (met & row.conditions) != 0) return row.to;
  return c.s.monitoring;
}

/// 3.13.10.6.2-4: what happens to commands on a transition.
void enter(Supervision& s, Monitoring to) {
  if (to == s.monitoring) return;
  if (s.monitoring == Monitoring::TSM) s.tco = false;
  if (to == Monitoring::RSM) {
    // From CSM too: release speed monitoring knows no revocation of the service brake.
    s.sb = false;
    s.eb_for_sb = false;
  }
  if (to == Monitoring::CSM) s.has_MRDT = false;
  s.monitoring = to;
}

using Bounds = std::array<Speed, static_cast<std::size_t>(Bound::count)>;

Speed& at(Bounds& b, Bound which) { return b[static_cast<std::size_t>(which)]; }
Speed at(const Bounds& b, Bound which) { return b[static_cast<std::size_t>(which)]; }

void set_target(Bounds& b, Speed Vt, const train::FixedValues& f) {
  at(b, Bound::Vt) = Vt;
  at(b, Bound::Vt_w) = Vt + dV_warning(Vt, f);
  at(b, Bound::Vt_sbi) = Vt + dV_sbi(Vt, f);
  at(b, Bound::Vt_ebi) = Vt + dV_ebi(Vt, f);
}
Bounds ceiling_bounds(Speed M, const train::FixedValues& f) {
  Bounds b{};
  at(b, Bound::M) = M;
  at(b, Bound::M_w) = M + dV_warning(M, f);
  at(b, Bound::M_sbi) = M + dV_sbi(M, f);
  at(b, Bound::M_ebi) = M + dV_ebi(M, f);
  return b;
}

bool holds(const TriggerRow& row, const Bounds& b, Speed V, unsigned beyond) {
  if (row.equal) {
    // A release speed of 0 stands for none.
    if (!(V == at(b, row.above)) || V.si <= 0.0) return false;
  } else {
    if (row.above != Bound::none && !(V > at(b, row.above))) return false;
    if (row.upto != Bound::none && !(V <= at(b, row.upto))) return false;
  }
  if (row.beyond != Limit::none && (beyond & bit(row.beyond)) == 0) return false;
  return row.not_beyond == Limit::none || (beyond & bit(row.not_beyond)) == 0;
}
bool holds(const RevocationRow& row, const Bounds& b, Speed V, unsigned beyond, bool standstill) {
  if (row.standstill) return standstill;
  if (row.above != Bound::none && !(V > at(b, row.above))) return false;
  if (row.upto != Bound::none && !(V <= at(b, row.upto))) return false;
  return row.not_beyond == Limit::none || (beyond & bit(row.not_beyond)) == 0;
}

/// All triggering conditions that are met, of all targets.
struct Triggered {
  bool any = false, tco = false, sb = false, eb = false;
  Status status = Status::Normal;
  std::uint8_t highest = 0;  // the condition of the highest status and strongest command

  void take(const TriggerRow& row) {
    const bool stronger = !any || row.status > status || (row.status == status && row.command == Command::EB);
    if (stronger) highest = row.id;
    any = true;
    status = std::max(status, row.status);
    tco = tco || row.command == Command::TCO;
    sb = sb || row.command == Command::SB;
    eb = eb || row.command == Command::EB;
  }
};

/// What may be taken back: all that every target agrees to.
struct Revoked {
  bool all = true;  // a condition is met for every target
  bool tco = true, sb = true;
  bool eb = true;         // also by Q_NVEMRRLS or a target speed of 0
  bool to_normal = true;  // every target's condition leads to Normal status
  bool only_r2 = false;   // for some target only r2 (d <= d_I) holds
};

void apply_triggers(Cycle& c, const Triggered& t, bool service_brake) {
  if (t.tco) c.s.tco = true;
  if (t.sb) (service_brake ? c.s.sb : c.s.eb_for_sb) = true;
  if (t.eb) c.s.eb = true;
}

bool braking(const Supervision& s) { return s.sb || s.eb || s.eb_for_sb; }

Triggered ceiling_triggers(const Cycle& c, const Bounds& b) {
  Triggered t;
  for (const TriggerRow& row : kCSM)
    if (holds(row, b, c.a.V, 0)) t.take(row);
  return t;
}

Triggered monitor_CSM(Cycle& c) {
  const Bounds b = ceiling_bounds(c.M, c.d.fixed);
  const Triggered t = ceiling_triggers(c, b);
  apply_triggers(c, t, c.d.service_brake_interface);
  for (const RevocationRow& row : kCSM_revocation) {
    if (!holds(row, b, c.a.V, 0, c.m.standstill)) continue;
    if (row.SB) c.s.sb = c.s.eb_for_sb = false;
    if (row.EB == EbRelease::always || (row.EB == EbRelease::if_permitted && c.d.Q_NVEMRRLS)) c.s.eb = false;
  }
  const bool below = c.a.V <= c.M;  // r1, or r0 of a brake that was not needed any more
  if (t.status > c.s.status)
    c.s.status = t.status;
  else if (below && (c.s.status != Status::Intervention || !braking(c.s)))
    c.s.status = Status::Normal;
  // 3.13.10.3.6: Indication does not exist here.
  if (c.s.status == Status::Indication) c.s.status = t.status;
  return t;
}

Triggered monitor_RSM(Cycle& c) {
  Bounds b = ceiling_bounds(c.M, c.d.fixed);
  at(b, Bound::Vt) = release(c).V_release;
  Triggered t;
  for (const TriggerRow& row : kRSM)
    if (holds(row, b, c.a.V, 0)) t.take(row);
  apply_triggers(c, t, true);
  const bool r0 = c.m.standstill;
  if (r0) c.s.eb = false;
  if (t.status == Status::Intervention)
    c.s.status = Status::Intervention;
  else if (c.s.status != Status::Intervention || (r0 && !braking(c.s)))
    c.s.status = Status::Indication;
  return t;
}

/// Tables 8-12 over all targets.
Triggered monitor_TSM(Cycle& c, const Seen* seen, bool MRDT_changed) {
  const Rules& rules = c.d.rules;
  Bounds b = ceiling_bounds(c.M, c.d.fixed);
  Triggered t;
  Revoked r;
  const bool at_or_below_M = c.a.V <= c.M;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i) {
    const Target& target = c.d.targets[i];
    const bool EOA_SvL = target.kind == TargetKind::EOA_SvL || target.kind == TargetKind::SR_end;
    // 3.13.10.4.10.1 (3.6.0 on): only targets below V_MRSP.
    if (!EOA_SvL && !rules.pre_indication && !(target.V_target < c.M)) continue;
    Speed Vt = target.V_target;
    if (target.kind == TargetKind::EOA_SvL) Vt = V_release_in_tables(c);
    const unsigned beyond = seen[i].beyond;
    if (beyond == 0 && at_or_below_M && c.a.V > Vt) {
      // In rear of all limits: no row of the tables but Normal status (t2); r3 holds, in 3.4.0 r2.
      if (rules.pre_indication)
        r.only_r2 = true;
      else
        r.to_normal = false;
      r.eb = r.eb && c.d.Q_NVEMRRLS;
      continue;
    }
    set_target(b, Vt, c.d.fixed);
    for (const TriggerRow& row : trigger_table(rules, EOA_SvL))
      if (holds(row, b, c.a.V, beyond)) t.take(row);
    bool any = false;
    bool eb = false;
    bool normal = false;
    bool by_r1 = false;
    for (const RevocationRow& row : revocation_table(rules)) {
      if (row.standstill || !holds(row, b, c.a.V, beyond, false)) continue;
      any = true;
      eb = eb || (row.EB == EbRelease::or_zero && Vt.si <= 0.0) || c.d.Q_NVEMRRLS;
      normal = normal || row.to == Status::Normal;
      by_r1 = by_r1 || row.id == 1;
    }
    r.all = r.all && any;
    r.eb = r.eb && any && eb;
    r.to_normal = r.to_normal && normal;
    r.only_r2 = r.only_r2 || (normal && !by_r1);
  }
  if (!t.any && c.a.V > c.M) {
    // No row speaks (3.6.0, no Indication limit exceeded): the ceiling is supervised all the same.
    t = ceiling_triggers(c, b);
    r.all = false;
  }
  apply_triggers(c, t, c.d.time_config.service_brake_available);
  const bool revoked = r.all && !t.tco && !t.sb && !t.eb && at_or_below_M;
  if (revoked) c.s.tco = c.s.sb = c.s.eb_for_sb = false;
  if (c.m.standstill || (revoked && r.eb)) c.s.eb = false;
  if (t.any && t.status > c.s.status) {
    c.s.status = t.status;
  } else if (c.s.status > Status::Indication ? revoked && !(c.s.status == Status::Intervention && braking(c.s))
                                             : false) {
    c.s.status = r.to_normal && rules.pre_indication ? Status::Normal : Status::Indication;
  } else if (c.s.status == Status::Indication && rules.pre_indication && revoked && r.to_normal &&
             (!r.only_r2 || MRDT_changed)) {
    c.s.status = Status::Normal;
  }
  // 3.13.10.4.17: from 3.6.0 on there is no Normal status here.
  if (c.s.status == Status::Normal && !rules.pre_indication) c.s.status = Status::Indication;
  return t;
}

// ---- Most relevant displayed target -----------------------------------------------------------------

bool concerned(const Cycle& c, const Seen& seen, const Target& t) {
  if (t.kind == TargetKind::EOA_SvL) return seen.beyond_I_EBD || seen.beyond_I_SBD;
  return seen.beyond_I_EBD && t.V_target < c.M && c.a.V >= t.V_target;
}
/// V_P of a target among the concerned ones: for EOA/SvL only the part whose Indication is exceeded.
double concerned_V_P(const Seen& s, const Target& t) {
  if (t.kind != TargetKind::EOA_SvL) return s.V_P;
  return std::min(s.beyond_I_EBD ? s.V_P_EBD : kFar, s.beyond_I_SBD ? s.V_P_SBD : kFar);
}

/// Is `t` masked by a target with speed V_t and its d_P there? Distance of its I in rear of that, else < 0.
double masked_by(const Cycle& c, const Target& t, Speed V, Place d_P) {
  const TargetLimits l = limits_at(c, t, V);
  double in_rear = (d_P - l.EBD.d_I).si;
  if (l.SBD.has_value()) in_rear = std::max(in_rear, (d_P - l.SBD->d_I).si);
  return in_rear;
}

std::size_t select_MRDT_masking(const Cycle& c, const Seen* seen) {
  std::size_t best = kTargets;
  double lowest = kFar;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i) {
    if (!concerned(c, seen[i], c.d.targets[i])) continue;
    const double V_P = concerned_V_P(seen[i], c.d.targets[i]);
    if (best == kTargets || V_P < lowest) {
      best = i;
      lowest = V_P;
    }
  }
  if (best == kTargets) return best;
  for (;;) {
    const Target& MRDT = c.d.targets[best];
    if (MRDT.kind == TargetKind::EOA_SvL || MRDT.V_target.si <= 0.0) return best;
    const Place d_P = limits_at(c, MRDT, MRDT.V_target).EBD.d_P;
    std::size_t next = kTargets;
    double furthest = 0.0;
    // Each step goes to a lower target speed: no target comes twice.
    for (std::size_t i = c.first; i < c.d.targets.size(); ++i) {
      const Target& t = c.d.targets[i];
      if (i == best || !(t.V_target < MRDT.V_target) || !concerned(c, seen[i], t)) continue;
      const double in_rear = masked_by(c, t, MRDT.V_target, d_P);
      if (in_rear > furthest) {
        furthest = in_rear;
        next = i;
      }
    }
    if (next == kTargets) return best;
    best = next;
  }
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

/// 3.13.10.4.2, 3.13.10.4.5. True when the driver is to be informed of a change.
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
    if (current == kTargets && c.s.has_MRDT) c.s.has_MRDT = false;
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

// ---- Display ----------------------------------------------------------------------------------------

Distance target_distance(const Cycle& c, const Target& t) {
  if (t.kind == TargetKind::EOA_SvL)
    return std::max(Distance{0.0}, std::min(t.d_EOA - c.m.est_front, t.d_target - c.m.max_safe_front));
  Place d_P = t.d_P_target;
  const std::optional<FeedbackTimes>& feedback = t.zero ? c.feedback_cm0 : c.feedback_cmt;
  if (feedback.has_value()) {
    const train::BuildUpTimes& build_up = t.zero ? c.d.cm0 : c.d.cmt;
    d_P = d_P_at_target_speed(c.d.view(t.EBD), t.V_target, t.d_target,
                              times(c.d.time_config, build_up, feedback, c.d.rules, c.d.fixed), build_up,
                              c.d.time_config, V_delta0_41(c.d, t.V_target), c.d.rules, c.d.fixed);
  }
  return std::max(Distance{0.0}, d_P - c.m.max_safe_front);
}

void show_limits(const Cycle& c, const Seen* seen, Result& out) {
  const Bounds b = ceiling_bounds(c.M, c.d.fixed);
  out.V_MRSP = c.M;
  out.V_P = at(b, Bound::M);
  out.V_W = at(b, Bound::M_w);
  out.V_SBI = at(b, Bound::M_sbi);
  out.V_EBI = at(b, Bound::M_ebi);
  if (c.s.monitoring == Monitoring::CSM) return;
  if (c.s.monitoring == Monitoring::RSM) {
    out.V_W = out.V_SBI = out.V_EBI = release(c).V_release;
    const std::size_t i = index_of(c, c.s.MRDT);
    if (i != kTargets && seen[i].near) out.V_P = std::min(out.V_P, Speed{seen[i].V_P});
    return;
  }
  const std::size_t MRDT = c.s.has_MRDT ? index_of(c, c.s.MRDT) : kTargets;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i) {
    if (!seen[i].near) continue;
    // 3.4.0 shows the MRDT's; it has the lowest one anyway.
    if (c.d.rules.masking || i == MRDT) out.V_P = std::min(out.V_P, Speed{seen[i].V_P});
    out.V_W = std::min(out.V_W, Speed{seen[i].V_W});
    out.V_SBI = std::min(out.V_SBI, Speed{seen[i].V_SBI});
    out.V_EBI = std::min(out.V_EBI, Speed{seen[i].V_EBI});
  }
}

void show_target(const Cycle& c, std::size_t i, Result& out) {
  const Target& t = c.d.targets[i];
  out.V_target = t.V_target;
  out.d_target = target_distance(c, t);
  out.MRDT = id_of(t);
  if (t.kind == TargetKind::EOA_SvL && release(c).exists) out.V_release = release(c).V_release;
}

/// 3.13.10.3.8-10: what ceiling speed monitoring says about the first Indication.
void show_first_indication(const Cycle& c, Result& out) {
  if (c.first_indication_target == kTargets) return;
  const double distance = std::max(c.first_indication, 0.0);
  out.first_indication = Distance{distance};
  if (c.d.csm_display == train::MaxReducedAdhesion::Display::target_information)
    show_target(c, c.first_indication_target, out);
  if (c.d.csm_display == train::MaxReducedAdhesion::Display::time_to_indication && c.a.V.si > 0.0) {
    const Duration TTI{distance / c.a.V.si};
    if (TTI < c.d.fixed.T_dispTTI) out.TTI = TTI;
  }
}

template <class T>
void hold(bool& flag, bool also, std::optional<T>& shown, T& value) {
  if ((flag || also) && shown.has_value()) {
    if (value < *shown)
      flag = false;  // each value is free again once it falls
    else
      value = *shown;
  }
  shown = value;
}

/// A.3.10, A.3.13: shown values do not rise because build-up times shrink.
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
  if (s.monitoring == Monitoring::TSM) hold(s.hold_SBI, pawl, s.shown_SBI, out.V_SBI);
  if (out.d_target.has_value()) {
    Distance shown = *out.d_target;
    hold(s.hold_target_distance, false, s.shown_target_distance, shown);
    out.d_target = shown;
  }
}

// ---- Service brake feedback -------------------------------------------------------------------------

void use_feedback(Cycle& c) {
  if (!c.d.time_config.feedback_available || !c.d.time_config.service_brake_available) return;
  Supervision& s = c.s;
  follow_pressure(s.feedback, c.m.brake_pressure_kpa, c.m.now);
  const bool approaching = s.active && (s.monitoring == Monitoring::TSM ||
                                        (c.d.rules.feedback_until_CSM && s.monitoring == Monitoring::RSM));
  if (!approaching) {
    reset_feedback(s.feedback, c.d.cm0.T_bs);
    c.feedback_cm0 = FeedbackTimes{c.d.cm0.T_bs, c.d.cm0.T_bs};
    c.feedback_cmt = FeedbackTimes{c.d.cmt.T_bs, c.d.cmt.T_bs};
    return;
  }
  c.feedback_cm0 = feedback_times(s.feedback, c.m.brake_pressure_kpa, c.d.cm0.T_bs, c.d.fixed);
  c.feedback_cmt = feedback_times(s.feedback, c.m.brake_pressure_kpa, c.d.cmt.T_bs, c.d.fixed);
  if (c.feedback_cm0->T_bs1 < s.feedback.T_bs1_previous) {
    s.hold_P = s.hold_target_distance = true;
    s.hold_SBI = c.d.rules.feedback_until_CSM;
  }
  s.feedback.T_bs1_previous = c.feedback_cm0->T_bs1;
}

bool MA_request(const Cycle& c) {
  if (!c.m.T_MAR.has_value()) return false;
  const Perturbation& p = c.d.perturbation;
  bool has_authority = false;
  bool LOA = false;
  for (const Target& t : c.d.targets) {
    has_authority = has_authority || t.kind == TargetKind::EOA_SvL || t.kind == TargetKind::LOA;
    LOA = LOA || t.kind == TargetKind::LOA;
  }
  if (!has_authority) return false;
  if (p.passed_at_once) return true;
  const Distance ahead = (c.M + dV_warning(c.M, c.d.fixed)) * *c.m.T_MAR;
  // A location that was not found lies before the track description: passed.
  if (!p.from_EBD.has_value() || c.m.max_safe_front > *p.from_EBD - ahead) return true;
  return !LOA && (!p.from_SBD.has_value() || c.m.est_front > *p.from_SBD - ahead);
}

Speed V_MRSP_with_LOA(const Derived& d, const Motion& m) {
  Speed M = V_MRSP(d.mrsp, m.min_safe_front, m.max_safe_front);
  // 3.13.9.2.7: beyond the LOA its speed is a ceiling.
  for (const Target& t : d.targets)
    if (t.kind == TargetKind::LOA && m.max_safe_front >= t.d_target) M = std::min(M, t.V_target);
  return M;
}

}  // namespace

Speed V_MRSP(const Mrsp& mrsp, Place min_safe_front, Place max_safe_front) {
  if (mrsp.empty()) return Speed{0.0};  // nothing is known: nothing is allowed
  std::size_t i = mrsp.index_at(min_safe_front);
  Speed V = mrsp.steps[i].value;
  for (++i; i < mrsp.size() && mrsp.steps[i].from <= max_safe_front; ++i) V = std::min(V, mrsp.steps[i].value);
  return V;
}

Result supervise(Supervision& s, const Derived& d, const Motion& m) {
  EVC_REQUIRE(d.valid);
  Result out;
  Cycle c{.s = s, .d = d, .m = m};
  c.M = V_MRSP_with_LOA(d, m);
  c.M_ebi = c.M + dV_ebi(c.M, d.fixed);
  c.V_delta0 = d.Q_NVINHSMICPERM ? Speed{0.0} : m.V_ura;
  c.a = approach(m.V_est, c.V_delta0, m.A_est, d.fixed);
  while (c.first < d.targets.size() && d.targets[c.first].kind == TargetKind::MRSP &&
         m.max_safe_front > d.targets[c.first].d_target)
    ++c.first;
  c.list_updated =
      s.active && (s.list_revision != d.revision || s.list_passed != c.first || s.list_size != d.targets.size());
  c.V_MRSP_updated = s.active && !(s.V_MRSP == c.M);
  use_feedback(c);
  c.cm0 = times(d.time_config, d.cm0, c.feedback_cm0, d.rules, d.fixed);
  c.cmt = times(d.time_config, d.cmt, c.feedback_cmt, d.rules, d.fixed);
  c.rsm = {release(c).d_SBI1, release(c).d_SBI2};
  if (release(c).exists && c.feedback_cm0.has_value())
    for (const Target& t : d.targets)
      if (t.kind == TargetKind::EOA_SvL)
        c.rsm = rsm_start(d, t, release(c).V_release, release(c).d_trip, release(c).on_board, c.feedback_cm0);

  std::array<Seen, kTargets> seen;
  for (std::size_t i = c.first; i < d.targets.size(); ++i) evaluate(c, i, seen[i]);

  const Monitoring before = s.monitoring;
  const Status status_before = s.status;
  const Monitoring next = next_monitoring(c, transition_conditions(c, seen.data()));
  if (s.active)
    enter(s, next);
  else
    s = {.active = true, .monitoring = next, .status = Status::Normal, .feedback = s.feedback};
  if (s.monitoring != Monitoring::CSM) out.MRDT_changed = select_MRDT(c, seen.data());
  Triggered t;
  switch (s.monitoring) {
    case Monitoring::CSM:
      t = monitor_CSM(c);
      break;
    case Monitoring::TSM:
      t = monitor_TSM(c, seen.data(), out.MRDT_changed);
      break;
    case Monitoring::RSM:
      t = monitor_RSM(c);
      break;
  }
  s.list_revision = d.revision;
  s.list_passed = static_cast<std::uint16_t>(c.first);
  s.list_size = static_cast<std::uint16_t>(d.targets.size());
  s.V_MRSP = c.M;

  out.monitoring = s.monitoring;
  out.status = s.status;
  out.monitoring_changed = s.monitoring != before;
  out.status_changed = s.status != status_before;
  out.tco = s.tco && d.traction_cut_off_interface;
  out.sb = s.sb;
  out.eb = s.eb || s.eb_for_sb;
  out.highest = {s.monitoring, t.highest};
  show_limits(c, seen.data(), out);
  out.show_SBI = s.status >= Status::Overspeed;
  if (s.monitoring == Monitoring::CSM) {
    show_first_indication(c, out);
  } else if (s.has_MRDT) {
    if (const std::size_t i = index_of(c, s.MRDT); i != kTargets) show_target(c, i, out);
  }
  if (s.monitoring == Monitoring::RSM) out.V_release = release(c).V_release;
  hold_shown_values(c, out.MRDT_changed, out);
  out.MA_request = MA_request(c);
  out.truncated = d.truncated;
  out.no_deceleration = d.no_deceleration;
  return out;
}

MemoStatus memo_status(const Result& r, Speed V_est, bool trip) {
  if (trip) return MemoStatus::Trip;
  if (r.eb || V_est > r.V_EBI) return MemoStatus::EB;
  if (r.sb || V_est > r.V_SBI) return MemoStatus::SB;
  if (r.status == Status::Warning || V_est > r.V_W) return MemoStatus::W;
  if (r.status == Status::Overspeed || V_est > r.V_P) return MemoStatus::P;
  return MemoStatus::Null;
}

bool passed_end_of_authority(const Authority& a, const Motion& m, bool level_1, Distance L_antenna_front) {
  if (a.kind == Authority::Kind::none) return false;
  const Place front = level_1 ? m.min_safe_front - L_antenna_front : m.min_safe_front;
  return front > a.EOA;
}

}  // namespace evc::sdm
