#include <algorithm>

#include "sdm/cycle.h"

namespace evc::sdm {
namespace {

/// Condition [1] of Table 16 for a target, 3.4.0: beyond the pre-indication location.
bool beyond_preindication(const Cycle& c, const Target& t) {
  return t.preindication_passed_at_once ||
         (t.d_preindication_EBD.has_value() && c.m.max_safe_front > *t.d_preindication_EBD) ||
         (t.d_preindication_SBD.has_value() && c.m.est_front > *t.d_preindication_SBD);
}

/// The same from 3.6.0 on: beyond an Indication limit.
bool beyond_indication(const Cycle& c, const Target& t, const Seen& seen) {
  const ReleaseSpeed& r = release(c);
  if (r.exists && !(c.a.V >= r.V_release))
    return seen.beyond_I_EBD && t.V_target < c.a.V && !behind_trip_location(c, t);
  if (c.m.standstill) return false;
  return (seen.beyond_I_EBD && t.V_target < c.M && t.V_target < c.a.V) || seen.beyond_I_SBD;
}

/// Condition [2]: beyond the start of release speed monitoring.
bool beyond_start_of_RSM(const Cycle& c) {
  if (!release(c).exists) return false;
  const bool from_SBD = c.rsm.d_SBI2 - c.rsm.d_SBI1 >= c.m.max_safe_front - c.m.est_front;
  return from_SBD ? c.m.est_front > c.rsm.d_SBI1 : c.m.max_safe_front > c.rsm.d_SBI2;
}

/// Conditions [1]-[6] of Table 16, bit n for [n].
unsigned transition_conditions(const Cycle& c, const Seen* seen) {
  bool one = false;
  bool MRDT_in_list = false;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i) {
    const Target& t = c.d.targets[i];
    one = one || (c.d.rules.pre_indication ? beyond_preindication(c, t) : beyond_indication(c, t, seen[i]));
    MRDT_in_list = MRDT_in_list || (c.s.has_MRDT && id_of(t) == c.s.MRDT);
  }
  const bool two = beyond_start_of_RSM(c);
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
  // A release speed that no longer exists cannot be monitored; its target is monitored as long as it exists.
  if (c.s.monitoring == Monitoring::RSM && !release(c).exists && (met & condition(3)) == 0) return Monitoring::TSM;
  for (const TransitionRow& row : transition_table(c.d.rules))
    if (row.from == c.s.monitoring && (met & row.conditions) != 0) return row.to;
  return c.s.monitoring;
}

/// 3.13.10.6.2-4: the commands at a transition.
void enter(Supervision& s, Monitoring to) {
  if (to == s.monitoring) return;
  if (s.monitoring == Monitoring::TSM) s.tco = false;
  if (to == Monitoring::RSM) {
    // From CSM too: release speed monitoring does not revoke the service brake.
    s.sb = false;
    s.eb_for_sb = false;
  }
  if (to == Monitoring::CSM) s.has_MRDT = false;
  s.monitoring = to;
}

bool holds(const TriggerRow& row, const Bounds& b, Speed V, unsigned beyond) {
  if (row.equal) {
    // A release speed of 0 means none.
    if (!(V == at(b, row.above)) || V.si <= 0.0) return false;
  } else {
    if (row.above != Bound::none && !(V > at(b, row.above))) return false;
    if (row.upto != Bound::none && !(V <= at(b, row.upto))) return false;
  }
  if (row.beyond != Limit::none && (beyond & bit(row.beyond)) == 0) return false;
  return (beyond & bit(row.not_beyond)) == 0;  // nothing is beyond Limit::none
}
bool holds(const RevocationRow& row, const Bounds& b, Speed V, unsigned beyond, bool standstill) {
  if (row.standstill) return standstill;
  if (row.above != Bound::none && !(V > at(b, row.above))) return false;
  if (row.upto != Bound::none && !(V <= at(b, row.upto))) return false;
  return (beyond & bit(row.not_beyond)) == 0;  // nothing is beyond Limit::none
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

/// The commands that may be revoked: those for which every target meets a revocation condition.
struct Revoked {
  bool all = true;        // a condition is met for every target
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
  const bool below = c.a.V <= c.M;  // r1, or r0 of a brake that was no longer needed
  // 3.13.10.3.6: ceiling speed monitoring has no Indication status; one of these ends it.
  if (t.status > c.s.status)
    c.s.status = t.status;
  else if (below && (c.s.status != Status::Intervention || !braking(c.s)))
    c.s.status = Status::Normal;
  return t;
}

Triggered monitor_RSM(Cycle& c) {
  Bounds b = ceiling_bounds(c.M, c.d.fixed);
  at(b, Bound::Vt) = release(c).V_release;
  Triggered t;
  for (const TriggerRow& row : kRSM)
    if (holds(row, b, c.a.V, 0)) t.take(row);
  c.s.eb = c.s.eb || t.eb;
  const bool r0 = c.m.standstill;
  if (r0) c.s.eb = false;
  // No other brake is commanded here (`enter`).
  if (t.status == Status::Intervention)
    c.s.status = Status::Intervention;
  else if (c.s.status != Status::Intervention || r0)
    c.s.status = Status::Indication;
  return t;
}

/// Applies the rows of Tables 8-12 to one target with speed `Vt`.
void take_target(const Cycle& c, Bounds& b, bool EOA_SvL, Speed Vt, unsigned beyond, Triggered& t, Revoked& r) {
  const Rules& rules = c.d.rules;
  set_target(b, Vt, c.d.fixed);
  for (const TriggerRow& row : trigger_table(rules, EOA_SvL))
    if (!(c.m.automatic && row.command == Command::SB) && holds(row, b, c.a.V, beyond)) t.take(row);
  bool any = false;
  bool eb = false;
  bool normal = false;
  bool by_r1 = false;
  for (const RevocationRow& row : revocation_table(rules)) {
    if (!holds(row, b, c.a.V, beyond, false)) continue;  // r0: `monitor_TSM`
    any = true;
    eb = eb || (row.EB == EbRelease::or_zero && Vt.si <= 0.0) || c.d.Q_NVEMRRLS;
    normal = normal || row.to == Status::Normal;
    by_r1 = by_r1 || row.id == 1;
  }
  r.all = r.all && any;
  r.eb = r.eb && eb;
  r.to_normal = r.to_normal && normal;
  r.only_r2 = r.only_r2 || (normal && !by_r1);
}

/// The same for all targets.
void take_targets(const Cycle& c, const Seen* seen, Bounds& b, Triggered& t, Revoked& r) {
  const Rules& rules = c.d.rules;
  const bool at_or_below_M = c.a.V <= c.M;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i) {
    const Target& target = c.d.targets[i];
    const bool EOA_SvL = target.kind == TargetKind::EOA_SvL || target.kind == TargetKind::SR_end;
    // 3.13.10.4.10.1 (3.6.0 on): only targets below V_MRSP.
    if (!EOA_SvL && !rules.pre_indication && !(target.V_target < c.M)) continue;
    Speed Vt = target.V_target;
    if (target.kind == TargetKind::EOA_SvL) Vt = V_release_in_tables(c);
    const unsigned beyond = seen[i].beyond;
    if (!rules.pre_indication && beyond == 0 && at_or_below_M && c.a.V > Vt) {
      // In rear of all limits: no row of the tables triggers; r3 holds.
      r.eb = r.eb && c.d.Q_NVEMRRLS;
      continue;
    }
    take_target(c, b, EOA_SvL, Vt, beyond, t, r);
  }
}

/// The status of target speed monitoring: it rises with triggering conditions, and falls only with revocations
/// (3.13.10.4.13-17).
Status status_in_TSM(const Cycle& c, const Triggered& t, const Revoked& r, bool revoked, bool MRDT_changed) {
  const Rules& rules = c.d.rules;
  Status status = c.s.status;
  if (t.status > status) {
    status = t.status;
  } else if (status > Status::Indication) {
    if (revoked && !(status == Status::Intervention && braking(c.s)))
      status = r.to_normal && rules.pre_indication ? Status::Normal : Status::Indication;
  } else if (status == Status::Indication && rules.pre_indication && revoked && r.to_normal &&
             (!r.only_r2 || MRDT_changed)) {
    status = Status::Normal;
  }
  // 3.13.10.4.17: from 3.6.0 on there is no Normal status here.
  if (status == Status::Normal && !rules.pre_indication) status = Status::Indication;
  return status;
}

/// Tables 8-12 over all targets.
Triggered monitor_TSM(Cycle& c, const Seen* seen, bool MRDT_changed) {
  Bounds b = ceiling_bounds(c.M, c.d.fixed);
  Triggered t;
  Revoked r;
  take_targets(c, seen, b, t, r);
  if (t.status < Status::Overspeed && c.a.V > c.M) {
    // No row covers it (3.6.0: no Indication limit exceeded; 3.4.0: beyond limits of a target above V_MRSP): the
    // ceiling is supervised nevertheless.
    t = ceiling_triggers(c, b);
  }
  apply_triggers(c, t, c.d.time_config.service_brake_available);
  // A condition that triggers in this cycle is not revoked: with 4.0.0, t1 and t2 hold at the release speed, and r1
  // too. Above V_MRSP a condition always triggers.
  const bool revoked = r.all && t.status < Status::Overspeed;
  if (revoked) c.s.tco = c.s.sb = c.s.eb_for_sb = false;
  if (c.m.standstill || (revoked && r.eb)) c.s.eb = false;
  c.s.status = status_in_TSM(c, t, r, revoked, MRDT_changed);
  return t;
}

// ---- Service brake feedback -------------------------------------------------------------------------

/// 3.4.0: a target for which the driver may have braked was passed in this cycle.
bool target_passed(const Cycle& c) {
  if (c.s.list_revision == c.d.revision) return c.first > c.s.list_passed;
  return c.s.has_MRDT && c.s.MRDT.kind == TargetKind::MRSP && c.m.max_safe_front > c.s.MRDT.d_target;
}

/// In target speed monitoring, with 4.0.0 in release speed monitoring too.
bool feedback_counts(const Cycle& c) {
  const bool in_RSM = c.d.rules.feedback_until_CSM && c.s.monitoring == Monitoring::RSM;
  return c.s.active && (c.s.monitoring == Monitoring::TSM || in_RSM);
}

void take_feedback(Cycle& c) {
  Supervision& s = c.s;
  const bool until_CSM = c.d.rules.feedback_until_CSM;
  const bool may_begin = until_CSM || s.feedback.approaching;
  c.feedback.cm0 = feedback_times(s.feedback, c.m.brake_pressure_kpa, c.d.cm0.T_bs, c.d.fixed, may_begin);
  c.feedback.cmt = feedback_times(s.feedback, c.m.brake_pressure_kpa, c.d.cmt.T_bs, c.d.fixed, may_begin);
  if (s.feedback.started && c.feedback.cm0->T_bs1 < s.feedback.T_bs1_previous) {
    s.hold_P = s.hold_target_distance = true;
    s.hold_SBI = until_CSM;
  }
  s.feedback.T_bs1_previous = c.feedback.cm0->T_bs1;
}

void use_feedback(Cycle& c) {
  if (!c.d.time_config.feedback_available || !c.d.time_config.service_brake_available) return;
  follow_pressure(c.s.feedback, c.m.brake_pressure_kpa, c.m.now);
  if (feedback_counts(c) && (c.d.rules.feedback_until_CSM || !target_passed(c)))
    take_feedback(c);
  else
    reset_feedback(c.s.feedback, c.d.cm0.T_bs);  // T_bs counts
}

/// The state for the feedback of the next cycle.
void follow_feedback(Cycle& c, const Seen* seen, Monitoring before) {
  Supervision& s = c.s;
  s.feedback.approaching = false;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i)
    if ((seen[i].beyond_I_EBD || seen[i].beyond_I_SBD) && c.a.V > c.d.targets[i].V_target)
      s.feedback.approaching = true;
  // A.3.10.4 (4.0.0): initial values when target speed monitoring is entered, also from release speed monitoring.
  if (before == Monitoring::RSM && s.monitoring == Monitoring::TSM) {
    reset_feedback(s.feedback, c.d.cm0.T_bs);
    s.hold_P = s.hold_SBI = s.hold_target_distance = false;
  }
}

void find_times(Cycle& c) {
  const Derived& d = c.d;
  c.cm0 = times(d.time_config, d.cm0, c.feedback.cm0, d.rules, d.fixed);
  c.cmt = times(d.time_config, d.cmt, c.feedback.cmt, d.rules, d.fixed);
  c.longest_cm0 = longest_times(c.cm0, d, d.cm0);
  c.longest_cmt = longest_times(c.cmt, d, d.cmt);
  c.ahead = ahead_of(c, c.m.V_est);
  if (!d.rules.reduced_build_up) return;
  c.full_below_cm0 = full_build_up_below(d, d.cm0, c.a, c.cm0);
  c.full_below_cmt = full_build_up_below(d, d.cmt, c.a, c.cmt);
}

/// A.3.10.4 in the cycle in which target or release speed monitoring is entered, when the driver brakes already: the
/// values shown first are those with the feedback. Those of T_bs would be held from the next cycle on, lower than any
/// that follow. The monitoring of this cycle was done with T_bs, the safe side.
void show_with_feedback(Cycle& c, Seen* seen) {
  if (!c.d.time_config.feedback_available || !c.d.time_config.service_brake_available || !feedback_counts(c)) return;
  take_feedback(c);
  if (!c.s.feedback.started) return;
  find_times(c);
  c.V_I = c.V_W = c.V_SBI = c.V_EBI = kFar;
  for (std::size_t i = c.first; i < c.d.targets.size(); ++i) evaluate(c, i, seen[i]);
}

bool MA_request(const Cycle& c) {
  if (!c.m.T_MAR.has_value()) return false;
  const Perturbation& p = c.d.perturbation;
  bool EOA = false;
  bool LOA = false;
  for (const Target& t : c.d.targets) {
    EOA = EOA || t.kind == TargetKind::EOA_SvL;
    LOA = LOA || t.kind == TargetKind::LOA;
  }
  if (!EOA && !LOA) return false;
  if (p.passed_at_once) return true;
  const Distance ahead = (c.M + dV_warning(c.M, c.d.fixed)) * *c.m.T_MAR;
  // A location that was not found is before the track description: passed.
  if (!p.from_EBD.has_value() || c.m.max_safe_front > *p.from_EBD - ahead) return true;
  return EOA && (!p.from_SBD.has_value() || c.m.est_front > *p.from_SBD - ahead);
}

Speed V_MRSP_with_LOA(const Derived& d, const Motion& m) {
  Speed M = V_MRSP(d.mrsp, m.min_safe_front, m.max_safe_front);
  // 3.13.9.2.7: beyond the LOA its speed is a ceiling.
  for (const Target& t : d.targets)
    if (t.kind == TargetKind::LOA && m.max_safe_front >= t.d_target) M = std::min(M, t.V_target);
  return M;
}

/// Values from the train's speed, place and brakes in this cycle, before any target is evaluated.
void begin(Cycle& c) {
  const Derived& d = c.d;
  const Motion& m = c.m;
  c.M = V_MRSP_with_LOA(d, m);
  c.M_ebi = c.M + dV_ebi(c.M, d.fixed);
  c.V_delta0 = d.Q_NVINHSMICPERM ? Speed{0.0} : m.V_ura;
  c.a = approach(m.V_est, c.V_delta0, m.A_est, d.fixed);
  while (c.first < d.targets.size() && d.targets[c.first].kind == TargetKind::MRSP &&
         m.max_safe_front > d.targets[c.first].d_target)
    ++c.first;
  // Used only when active.
  c.list_updated = c.s.list_revision != d.revision || c.s.list_passed != c.first;
  c.V_MRSP_updated = !(c.s.V_MRSP == c.M);
  use_feedback(c);
  find_times(c);
  for (const Target& t : d.targets) {
    if (t.kind != TargetKind::EOA_SvL || !release(c).exists) continue;
    c.d_SvL = t.d_target;
    c.rsm = {release(c).d_SBI1, release(c).d_SBI2};
    if (c.feedback.cm0.has_value())
      c.rsm = rsm_start(d, t, release(c).V_release, release(c).d_trip, release(c).on_board, c.feedback);
  }
}

}  // namespace

Speed V_MRSP(const Mrsp& mrsp, Place min_safe_front, Place max_safe_front) {
  if (mrsp.empty()) return Speed{0.0};  // no profile: no speed is allowed
  std::size_t i = mrsp.index_at(min_safe_front);
  Speed V = mrsp.steps[i].value;
  for (++i; i < mrsp.size() && mrsp.steps[i].from <= max_safe_front; ++i) V = std::min(V, mrsp.steps[i].value);
  return V;
}

Result supervise(Supervision& s, const Derived& d, const Motion& m) {
  EVC_REQUIRE(d.valid);
  Result out;
  Cycle c{.s = s, .d = d, .m = m};
  begin(c);
  std::array<Seen, kTargets> seen;
  for (std::size_t i = c.first; i < d.targets.size(); ++i) evaluate(c, i, seen[i]);

  const Monitoring before = s.monitoring;
  const Status status_before = s.status;
  const bool from_ceiling = !s.active || before == Monitoring::CSM;
  const Monitoring next = next_monitoring(c, transition_conditions(c, seen.data()));
  if (s.active)
    enter(s, next);
  else
    s = {.active = true, .monitoring = next, .status = Status::Normal, .feedback = s.feedback};
  if (d.time_config.feedback_available) follow_feedback(c, seen.data(), before);
  if (s.monitoring != Monitoring::CSM) out.MRDT_changed = select_MRDT(c, seen.data());
  const Triggered t = s.monitoring == Monitoring::CSM   ? monitor_CSM(c)
                      : s.monitoring == Monitoring::TSM ? monitor_TSM(c, seen.data(), out.MRDT_changed)
                                                        : monitor_RSM(c);
  s.list_revision = d.revision;
  s.list_passed = static_cast<std::uint16_t>(c.first);
  s.V_MRSP = c.M;

  out.monitoring = s.monitoring;
  out.status = s.status;
  out.monitoring_changed = s.monitoring != before;
  out.status_changed = s.status != status_before;
  out.tco = s.tco && d.traction_cut_off_interface;
  out.sb = s.sb;
  out.eb = s.eb || s.eb_for_sb;
  out.highest = {s.monitoring, t.highest};
  if (from_ceiling && s.monitoring != Monitoring::CSM) show_with_feedback(c, seen.data());
  display(c, seen.data(), out);
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

}  // namespace evc::sdm
