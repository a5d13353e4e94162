#pragma once
// For tests: one cycle of 3.13.10 again, plain and slow, from the text and tables of the standard. Every target is
// evaluated with all of its limits; nothing is left out, bounded or stored for later. Limits and curves are the tested
// ones (limits_of, speeds_of_EBD, speeds_of_SBD). Tables 5 to 15 are in test_reference_tables.h, the displayed values
// in test_reference_display.h.
#include <algorithm>
#include <optional>
#include <vector>

#include "sdm/evaluate.h"
#include "sdm/supervision.h"

namespace evc::sdm::test {

/// A supervised target at the position of the train. S: max safe front end and limits of the EBD; E: estimated front
/// end and limits of the SBD (EOA only).
struct Sight {
  Target t;
  TargetLimits l;
  bool S_I = false, S_P = false, S_W = false, S_SBI = false, S_EBI = false, S_I_M = false;
  bool E_I = false, E_P = false, E_W = false, E_SBI = false, E_I_M = false;
  LimitSpeeds V_S{}, V_E{};

  bool is_EOA() const { return t.kind == TargetKind::EOA_SvL; }
  bool I() const { return S_I || E_I; }
  bool P() const { return S_P || E_P; }
  bool W() const { return S_W || E_W; }
  bool SBI() const { return S_SBI || E_SBI; }
  bool I_M() const { return S_I_M || E_I_M; }
  Speed V_P() const { return is_EOA() ? std::min(V_S.V_P, V_E.V_P) : V_S.V_P; }
  TargetId id() const { return {t.kind, is_EOA() ? t.d_EOA : t.d_target, t.V_target}; }
};

/// Triggering conditions that are met. The condition of the highest status is reported, that of an emergency brake if
/// there is one.
struct Met {
  int condition = 0;
  bool any = false, TCO = false, SB = false, EB = false;
  Status status = Status::Normal;

  enum What { nothing, tco, sb, eb };
  void when(bool holds, int t, What what, Status to) {
    if (!holds) return;
    if (!any || to > status || (to == status && what == eb)) condition = t;
    any = true;
    status = std::max(status, to);
    TCO = TCO || what == tco;
    SB = SB || what == sb;
    EB = EB || what == eb;
  }
};

class ReferenceSupervision {
 public:
  Supervision s;  // the state
  Feedback feedback;
  std::vector<Sight> list;  // the supervised targets of the last cycle

  Result cycle(const Derived& derived, const Motion& motion);

 private:
  const Derived* d_ = nullptr;
  Motion m_;
  Speed V_, M_, M_w_, M_sbi_, M_ebi_;
  Approach a_;
  RsmStart rsm_;
  bool list_updated_ = false, V_MRSP_updated_ = false, reduced_ = false;

  bool v340() const { return d_->rules.pre_indication; }
  bool v400() const { return d_->rules.reduced_build_up; }
  bool v360() const { return !v340() && !v400(); }
  const ReleaseSpeed& release() const { return d_->release_speed; }
  bool braking() const { return s.sb || s.eb || s.eb_for_sb; }

  void ceiling();
  void see_targets();
  TimesAsked asked(const Target& t) const;
  TargetLimits limits_for(const Target& t, Speed V) const;
  void follow_feedback();
  void take_pressure();
  void follow_p();
  FeedbackTimes times_by_pressure(Duration T_bs, bool may_begin);
  bool target_passed() const;
  const Sight* find(const TargetId& id) const;
  bool up_to_SvL_from_trip(const Target& t) const;

  bool condition_1() const;
  bool condition_2() const;
  Monitoring next_monitoring() const;
  bool select_MRDT();
  const Sight* most_relevant() const;
  bool concerned(const Sight& x) const;
  Place d_P_at_target(const Target& t) const;

  Met triggers_CSM() const;
  void triggers(Met& met, const Sight& x, Speed Vt) const;
  Met monitor_CSM();
  Met monitor_TSM(bool MRDT_changed);
  Met monitor_RSM();

  void show(Result& out);
  void show_target(const Sight& x, Result& out) const;
  void show_first_indication(Result& out) const;
  void hold_values(Result& out);
  bool MA_request() const;
};

// ---- Where the train is -----------------------------------------------------------------------------

inline void ReferenceSupervision::ceiling() {
  // 3.13.7.2: the lowest element between min and max safe front end.
  const auto& steps = d_->mrsp.steps;
  M_ = steps.empty() ? Speed{0.0} : Speed{1e9};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool begins = i == 0 || steps[i].from <= m_.max_safe_front;
    const bool ends = i + 1 < steps.size() && steps[i + 1].from <= m_.min_safe_front;
    if (begins && !ends) M_ = std::min(M_, steps[i].value);
  }
  for (const Target& t : d_->targets)
    if (t.kind == TargetKind::LOA && m_.max_safe_front >= t.d_target) M_ = std::min(M_, t.V_target);
  M_w_ = M_ + dV_warning(M_, d_->fixed);
  M_sbi_ = M_ + dV_sbi(M_, d_->fixed);
  M_ebi_ = M_ + dV_ebi(M_, d_->fixed);
}

inline TimesAsked ReferenceSupervision::asked(const Target& t) const {
  TimesAsked q;
  q.feedback = t.zero ? feedback.cm0 : feedback.cmt;
  if (v400()) q.reduced_from = Fronts{m_.est_front, m_.min_safe_front};
  return q;
}

/// V_est replaced by another speed, everything else unchanged.
inline TargetLimits ReferenceSupervision::limits_for(const Target& t, Speed V) const {
  Approach a = a_;
  a.V = V;
  return limits_of(*d_, t, a, asked(t));
}

inline void ReferenceSupervision::see_targets() {
  list.clear();
  reduced_ = false;
  for (const Target& t : d_->targets) {
    if (t.kind == TargetKind::MRSP && m_.max_safe_front > t.d_target) continue;  // passed
    Sight x;
    x.t = t;
    x.l = limits_for(t, V_);
    const Place S = m_.max_safe_front;
    const Place E = m_.est_front;
    x.S_I = S > x.l.EBD.d_I;
    x.S_P = S > x.l.EBD.d_P;
    x.S_W = S > x.l.EBD.d_W;
    x.S_SBI = S > x.l.EBD.d_SBI;
    x.S_EBI = S > *x.l.EBD.d_EBI;
    x.V_S = speeds_of_EBD(d_->view(t.EBD), d_->view(t.GUI), a_, x.l.times.EBD, t.V_target, S, d_->fixed);
    if (x.l.SBD.has_value()) {
      x.E_I = E > x.l.SBD->d_I;
      x.E_P = E > x.l.SBD->d_P;
      x.E_W = E > x.l.SBD->d_W;
      x.E_SBI = E > x.l.SBD->d_SBI;
      x.V_E = speeds_of_SBD(d_->view(t.SBD), d_->view(t.GUI_EOA), a_, x.l.times.SBD, t.d_EOA, E, d_->fixed);
    }
    if (v340()) {
      const TargetLimits at_M = limits_for(t, M_);
      x.S_I_M = S > at_M.EBD.d_I;
      x.E_I_M = at_M.SBD.has_value() && E > at_M.SBD->d_I;
    }
    // A.3.13.2; 3.13.8.2.1 a: an element not lower than V_MRSP is no target.
    if (t.kind != TargetKind::MRSP || t.V_target < M_)
      reduced_ = reduced_ || x.l.times.reduced_be || (d_->time_config.service_brake_available && x.l.times.reduced_bs);
    list.push_back(x);
  }
}

inline const Sight* ReferenceSupervision::find(const TargetId& id) const {
  for (const Sight& x : list)
    if (x.id() == id) return &x;
  return nullptr;
}

// ---- Service brake feedback, A.3.10 -----------------------------------------------------------------

inline void ReferenceSupervision::follow_p() {
  FeedbackState& f = s.feedback;
  if (!m_.brake_pressure_kpa.has_value()) {
    f.searching = false;
    return;
  }
  const double p = std::min(*m_.brake_pressure_kpa, 550.0);
  if (f.p0_known) {
    for (; (m_.now - f.last).si >= 1.0; f.last.si += 1.0) {
      if (p > f.p0) {
        f.p0 = std::min(f.p0 + 1.5, 550.0);
      } else if (p < f.p0 && p > f.p0 - 30.0) {
        f.p0 -= 0.5;
      }
    }
    return;
  }
  if (p < 400.0) {
    f.searching = false;
  } else if (!f.searching || p > f.p_search + 20.0 || p < f.p_search - 20.0) {
    f.searching = true;
    f.p_search = p;
    f.since = m_.now;
  } else if ((m_.now - f.since).si >= 3.0) {
    f.p0_known = true;
    f.p0 = p;
    f.last = m_.now;
  }
}

inline FeedbackTimes ReferenceSupervision::times_by_pressure(Duration T_bs, bool may_begin) {
  FeedbackState& f = s.feedback;
  const Duration two{2.0};
  if (f.locked) return {{0.0}, two};
  if (!f.p0_known || !m_.brake_pressure_kpa.has_value()) return {T_bs, std::max(T_bs, two)};
  if (!f.started && !may_begin) return {T_bs, std::max(T_bs, two)};
  const double p = std::min(*m_.brake_pressure_kpa, 550.0);
  const double p1 = f.p0 - 30.0;
  const double p2 = f.p0 - 60.0;
  const double p3 = f.p0 - 150.0;
  if (p > p2) {
    if (f.started || p <= p1) {
      f.started = true;
      const Duration T = ((p - p3) / (f.p0 - p3)) * T_bs;
      if (T > T_bs) return {T_bs, std::max(T_bs, two)};
      return {T, std::max(T, two)};
    }
    return {T_bs, std::max(T_bs, two)};
  }
  f.started = true;
  f.locked = true;
  return {{0.0}, two};
}

/// 3.4.0, 3.6.0: the state of the feedback belongs to a target.
inline bool ReferenceSupervision::target_passed() const {
  std::size_t passed = 0;
  for (const Target& t : d_->targets) passed += t.kind == TargetKind::MRSP && m_.max_safe_front > t.d_target;
  if (s.list_revision == d_->revision) return passed > s.list_passed;
  return s.has_MRDT && s.MRDT.kind == TargetKind::MRSP && m_.max_safe_front > s.MRDT.d_target;
}

inline void ReferenceSupervision::follow_feedback() {
  feedback = {};
  if (!d_->time_config.feedback_available || !d_->time_config.service_brake_available) return;
  follow_p();
  const Duration T_bs = d_->cm0.T_bs;
  bool in_action = s.active && s.monitoring == Monitoring::TSM;
  if (v400()) in_action = s.active && s.monitoring != Monitoring::CSM;
  if (!v400() && target_passed()) in_action = false;
  if (!in_action) {
    s.feedback.started = s.feedback.locked = false;
    s.feedback.T_bs1_previous = T_bs;
    feedback.cm0 = FeedbackTimes{T_bs, T_bs};
    feedback.cmt = FeedbackTimes{d_->cmt.T_bs, d_->cmt.T_bs};
    return;
  }
  take_pressure();
}

inline void ReferenceSupervision::take_pressure() {
  const Duration T_bs = d_->cm0.T_bs;
  const bool may_begin = v400() || s.feedback.approaching;
  feedback.cm0 = times_by_pressure(T_bs, may_begin);
  feedback.cmt = times_by_pressure(d_->cmt.T_bs, may_begin);
  if (s.feedback.started && feedback.cm0->T_bs1 < s.feedback.T_bs1_previous) {
    s.hold_P = s.hold_target_distance = true;
    if (v400()) s.hold_SBI = true;
  }
  s.feedback.T_bs1_previous = feedback.cm0->T_bs1;
}

// ---- Table 16 ---------------------------------------------------------------------------------------

/// The SvL and the targets between trip location and SvL.
inline bool ReferenceSupervision::up_to_SvL_from_trip(const Target& t) const {
  if (t.kind == TargetKind::EOA_SvL) return true;
  if (t.kind != TargetKind::MRSP || !release().exists) return false;
  for (const Target& end : d_->targets)
    if (end.kind == TargetKind::EOA_SvL && t.d_target >= release().d_trip && t.d_target <= end.d_target) return true;
  return false;
}

inline bool ReferenceSupervision::condition_1() const {
  for (const Sight& x : list) {
    if (v340()) {
      if (x.t.preindication_passed_at_once) return true;
      if (x.t.d_preindication_EBD.has_value() && m_.max_safe_front > *x.t.d_preindication_EBD) return true;
      if (x.t.d_preindication_SBD.has_value() && m_.est_front > *x.t.d_preindication_SBD) return true;
    } else if (release().exists && V_ < release().V_release) {
      if (x.S_I && x.t.V_target < V_ && !up_to_SvL_from_trip(x.t)) return true;
    } else if (!m_.standstill) {
      if (x.S_I && x.t.V_target < M_ && x.t.V_target < V_) return true;
      if (x.E_I) return true;
    }
  }
  return false;
}

inline bool ReferenceSupervision::condition_2() const {
  if (!release().exists) return false;
  if (rsm_.d_SBI2 - rsm_.d_SBI1 >= m_.max_safe_front - m_.est_front) return m_.est_front > rsm_.d_SBI1;
  return m_.max_safe_front > rsm_.d_SBI2;
}

inline Monitoring ReferenceSupervision::next_monitoring() const {
  const bool one = condition_1();
  const bool two = condition_2();
  if (!s.active) return two ? Monitoring::RSM : one ? Monitoring::TSM : Monitoring::CSM;
  const Sight* MRDT = s.has_MRDT ? find(s.MRDT) : nullptr;
  const bool three = v340() ? list_updated_ && !one : MRDT == nullptr && !one && !two;
  const bool four = list_updated_ && one && !two;
  const bool five = list_updated_ && two;
  const bool six = !v340() && V_MRSP_updated_ && MRDT != nullptr && MRDT->t.V_target >= M_ && !one && !two;
  switch (s.monitoring) {
    case Monitoring::CSM:
      if (five || (two && !v340())) return Monitoring::RSM;
      return one || four ? Monitoring::TSM : Monitoring::CSM;
    case Monitoring::TSM:
      if (two || five) return Monitoring::RSM;
      return three || six ? Monitoring::CSM : Monitoring::TSM;
    case Monitoring::RSM:
      if (three) return Monitoring::CSM;
      // A release speed that does not exist any more cannot be monitored.
      return four || !release().exists ? Monitoring::TSM : Monitoring::RSM;
    case Monitoring::none:  // active supervision has one of the three types
      break;
  }
  return s.monitoring;
}

// ---- The cycle --------------------------------------------------------------------------------------

inline Result ReferenceSupervision::cycle(const Derived& derived, const Motion& motion) {
  d_ = &derived;
  m_ = motion;
  V_ = m_.V_est;
  ceiling();
  const Speed V_delta0 = d_->Q_NVINHSMICPERM ? Speed{0.0} : m_.V_ura;
  a_ = approach(V_, V_delta0, m_.A_est, d_->fixed);
  follow_feedback();
  see_targets();
  rsm_ = {};
  for (const Target& t : d_->targets)
    if (t.kind == TargetKind::EOA_SvL && release().exists)
      rsm_ = rsm_start(*d_, t, release().V_release, release().d_trip, release().on_board, feedback);
  const std::size_t passed = d_->targets.size() - list.size();
  list_updated_ = s.active && (s.list_revision != d_->revision || s.list_passed != passed);
  V_MRSP_updated_ = s.active && s.V_MRSP != M_;

  Result out;
  const Monitoring before = s.monitoring;
  const Status status_before = s.status;
  const bool was_supervising_a_target = s.active && before != Monitoring::CSM;
  const Monitoring next = next_monitoring();
  if (!s.active) {
    const FeedbackState kept = s.feedback;
    s = {};
    s.feedback = kept;
    s.active = true;
    s.monitoring = next;
    s.status = Status::Normal;
    s.tco = s.sb = s.eb = s.eb_for_sb = s.has_MRDT = false;
    s.hold_P = s.hold_SBI = s.hold_target_distance = false;
  }
  if (next != s.monitoring) {
    if (s.monitoring == Monitoring::TSM) s.tco = false;       // 3.13.10.6.3
    if (next == Monitoring::RSM) s.sb = s.eb_for_sb = false;  // 3.13.10.6.4
    if (next == Monitoring::CSM) s.has_MRDT = false;
    s.monitoring = next;
  }
  if (d_->time_config.feedback_available) {
    s.feedback.approaching = false;
    for (const Sight& x : list)
      if (x.I() && V_ > x.t.V_target) s.feedback.approaching = true;
    if (before == Monitoring::RSM && next == Monitoring::TSM) {  // A.3.10.4: initial values
      s.feedback.started = s.feedback.locked = false;
      s.feedback.T_bs1_previous = d_->cm0.T_bs;
      s.hold_P = s.hold_SBI = s.hold_target_distance = false;
    }
  }
  out.MRDT_changed = next != Monitoring::CSM && select_MRDT();
  const Met met = next == Monitoring::CSM   ? monitor_CSM()
                  : next == Monitoring::TSM ? monitor_TSM(out.MRDT_changed)
                                            : monitor_RSM();
  s.list_revision = d_->revision;
  s.list_passed = static_cast<std::uint16_t>(passed);
  s.V_MRSP = M_;
  out.monitoring = s.monitoring;
  out.status = s.status;
  out.tco = s.tco && d_->traction_cut_off_interface;
  out.sb = s.sb;
  out.eb = s.eb || s.eb_for_sb;
  out.highest = {s.monitoring, static_cast<std::uint8_t>(met.condition)};
  out.monitoring_changed = s.monitoring != before;
  out.status_changed = s.status != status_before;
  // A.3.10.4: on entry the first values shown are those by the pressure; the monitoring of this cycle used T_bs.
  const bool pressure_counts = next == Monitoring::TSM || (v400() && next == Monitoring::RSM);
  if (!was_supervising_a_target && pressure_counts && d_->time_config.feedback_available &&
      d_->time_config.service_brake_available) {
    take_pressure();
    see_targets();
  }
  show(out);
  out.MA_request = MA_request();
  out.truncated = d_->truncated;
  out.no_deceleration = d_->no_deceleration;
  return out;
}

}  // namespace evc::sdm::test
