#pragma once
// For tests: the most relevant displayed target and the other displayed values, for the reference supervision.
#include "sdm/test_reference_supervision.h"

namespace evc::sdm::test {

// ---- Most relevant displayed target -----------------------------------------------------------------

inline bool ReferenceSupervision::concerned(const Sight& x) const {
  if (x.is_EOA()) return x.I();
  return x.S_I && M_ > x.t.V_target && V_ >= x.t.V_target;
}

/// 3.13.9.3.5.9.
inline Place ReferenceSupervision::d_P_at_target(const Target& t) const {
  const train::BuildUpTimes& b = t.zero ? d_->cm0 : d_->cmt;
  return d_P_at_target_speed(d_->view(t.EBD), t.V_target, t.d_target,
                             times(d_->time_config, b, t.zero ? feedback.cm0 : feedback.cmt, d_->rules, d_->fixed), b,
                             d_->time_config, V_delta0_41(*d_, t.V_target), d_->rules, d_->fixed);
}

/// 3.13.10.4.2; 3.4.0: the lowest Permitted speed of all.
inline const Sight* ReferenceSupervision::most_relevant() const {
  const Sight* best = nullptr;
  Speed lowest{};
  for (const Sight& x : list) {
    Speed V_P = x.V_P();
    if (!v340()) {
      if (!concerned(x)) continue;
      if (x.is_EOA() && !x.S_I) V_P = x.V_E.V_P;
      if (x.is_EOA() && !x.E_I) V_P = x.V_S.V_P;
    }
    if (best == nullptr || V_P < lowest) {
      best = &x;
      lowest = V_P;
    }
  }
  if (v340()) return best;
  while (best != nullptr) {
    const Sight* masked = nullptr;
    Distance furthest{0.0};
    const Place d_P = d_P_at_target(best->t);
    for (const Sight& x : list) {
      if (!concerned(x) || !(x.t.V_target < best->t.V_target)) continue;
      const TargetLimits l = limits_for(x.t, best->t.V_target);
      Distance in_rear = d_P - l.EBD.d_I;
      if (l.SBD.has_value()) in_rear = std::max(in_rear, d_P - l.SBD->d_I);
      if (in_rear > furthest) {
        furthest = in_rear;
        masked = &x;
      }
    }
    if (masked == nullptr) break;
    best = masked;
  }
  return best;
}

inline bool ReferenceSupervision::select_MRDT() {
  const Sight* selected = nullptr;
  if (s.monitoring == Monitoring::RSM) {
    for (const Sight& x : list)
      if (x.is_EOA()) selected = &x;
  } else {
    selected = most_relevant();
  }
  const Sight* current = s.has_MRDT ? find(s.MRDT) : nullptr;
  if (selected == nullptr) {
    if (current == nullptr) s.has_MRDT = false;
    return false;
  }
  if (selected == current) return false;
  // 3.13.10.4.5
  if (!v340() && s.monitoring == Monitoring::TSM && current != nullptr && selected->t.V_target > current->t.V_target)
    return false;
  s.has_MRDT = true;
  s.MRDT = selected->id();
  return true;
}

// ---- Display ----------------------------------------------------------------------------------------

inline void ReferenceSupervision::show_target(const Sight& x, Result& out) const {
  Distance distance = d_P_at_target(x.t) - m_.max_safe_front;
  if (x.is_EOA()) {
    distance = std::min(x.t.d_EOA - m_.est_front, x.t.d_target - m_.max_safe_front);
    if (release().exists) out.V_release = release().V_release;
  }
  out.V_target = x.t.V_target;
  out.d_target = std::max(distance, Distance{0.0});
  out.MRDT = x.id();
}

/// 3.13.10.3.8-10.
inline void ReferenceSupervision::show_first_indication(Result& out) const {
  if (v340()) return;
  const bool below_release = release().exists && V_ < release().V_release;
  const Sight* first = nullptr;
  Distance distance{};
  for (const Sight& x : list) {
    Distance to = x.l.EBD.d_I - m_.max_safe_front;
    if (x.is_EOA() && below_release) {
      to = std::min(rsm_.d_SBI1 - m_.est_front, rsm_.d_SBI2 - m_.max_safe_front);
    } else if (x.is_EOA()) {
      to = std::min(to, x.l.SBD->d_I - m_.est_front);
    } else {
      if (x.t.V_target >= M_ || x.t.V_target >= V_) continue;
      if (below_release && up_to_SvL_from_trip(x.t)) continue;
    }
    if (first == nullptr || to < distance) {
      first = &x;
      distance = to;
    }
  }
  if (first == nullptr) return;
  distance = std::max(distance, Distance{0.0});
  out.first_indication = distance;
  using Display = train::MaxReducedAdhesion::Display;
  if (d_->csm_display == Display::target_information) show_target(*first, out);
  if (d_->csm_display == Display::time_to_indication && distance < V_ * Duration{14.0})
    out.TTI = Duration{distance.si / V_.si};
}

inline void ReferenceSupervision::hold_values(Result& out) {
  const bool CSM = s.monitoring == Monitoring::CSM;
  if (CSM || out.MRDT_changed) s.hold_P = s.hold_SBI = s.hold_target_distance = false;
  if (CSM) {
    s.shown_P.reset();
    s.shown_SBI.reset();
    s.shown_target_distance.reset();
    return;
  }
  const bool pawl = v400() && reduced_ && !out.MRDT_changed;
  if (s.shown_P.has_value()) {
    if (out.V_P < *s.shown_P) s.hold_P = false;
    if (s.hold_P || pawl) out.V_P = std::min(out.V_P, *s.shown_P);
  }
  s.shown_P = out.V_P;
  if (s.monitoring == Monitoring::TSM) {
    if (s.shown_SBI.has_value()) {
      if (out.V_SBI < *s.shown_SBI) s.hold_SBI = false;
      if (s.hold_SBI || pawl) out.V_SBI = std::min(out.V_SBI, *s.shown_SBI);
    }
    s.shown_SBI = out.V_SBI;
  } else {
    s.shown_SBI.reset();  // 3.13.10.5: release speed monitoring shows none
  }
  if (out.d_target.has_value()) {
    if (s.shown_target_distance.has_value()) {
      if (*out.d_target < *s.shown_target_distance) s.hold_target_distance = false;
      if (s.hold_target_distance) out.d_target = std::min(*out.d_target, *s.shown_target_distance);
    }
    s.shown_target_distance = out.d_target;
  }
}

inline void ReferenceSupervision::show(Result& out) {
  out.V_MRSP = out.V_P = M_;
  out.V_W = M_w_;
  out.V_SBI = M_sbi_;
  out.V_EBI = M_ebi_;
  out.show_SBI = s.status >= Status::Overspeed;
  const Sight* MRDT = s.has_MRDT ? find(s.MRDT) : nullptr;
  if (s.monitoring == Monitoring::CSM) {
    show_first_indication(out);
  } else if (MRDT != nullptr) {
    show_target(*MRDT, out);
  }
  if (s.monitoring == Monitoring::TSM) {
    for (const Sight& x : list) {
      // 3.13.10.4.4: EOA and SvL not below the release speed.
      const Speed least = x.is_EOA() && release().exists ? release().V_release : Speed{0.0};
      if (!v340() || &x == MRDT) out.V_P = std::min(out.V_P, x.V_P());
      out.V_W = std::min(out.V_W, std::max(x.V_S.V_W, least));
      out.V_SBI = std::min(out.V_SBI, std::max(x.V_S.V_SBI, least));
      out.V_EBI = std::min(out.V_EBI, std::max(x.V_S.V_EBI, least));
      if (!x.is_EOA()) continue;
      out.V_W = std::min(out.V_W, std::max(x.V_E.V_W, least));
      out.V_SBI = std::min(out.V_SBI, std::max(x.V_E.V_SBI, least));
    }
  }
  if (s.monitoring == Monitoring::RSM) {
    out.V_release = out.V_W = out.V_SBI = out.V_EBI = release().V_release;
    if (MRDT != nullptr) out.V_P = std::min(out.V_P, MRDT->V_P());
  }
  hold_values(out);
}

/// 3.13.11.8-9.
inline bool ReferenceSupervision::MA_request() const {
  if (!m_.T_MAR.has_value()) return false;
  const Perturbation& p = d_->perturbation;
  const Distance ahead = M_w_ * *m_.T_MAR;
  for (const Target& t : d_->targets) {
    if (t.kind != TargetKind::EOA_SvL && t.kind != TargetKind::LOA) continue;
    if (p.passed_at_once || !p.from_EBD.has_value() || m_.max_safe_front > *p.from_EBD - ahead) return true;
    if (t.kind == TargetKind::LOA) continue;
    if (!p.from_SBD.has_value() || m_.est_front > *p.from_SBD - ahead) return true;
  }
  return false;
}

}  // namespace evc::sdm::test
