#pragma once
// For tests: Tables 5 to 15 of 3.13.10 as plain conditions, for the reference supervision.
#include "sdm/test_reference_supervision.h"

namespace evc::sdm::test {

// ---- Tables 5 to 15 ---------------------------------------------------------------------------------

inline Met ReferenceSupervision::triggers_CSM() const {
  Met met;
  met.when(V_ <= M_, 1, Met::nothing, Status::Normal);
  met.when(V_ > M_, 2, Met::nothing, Status::Overspeed);
  met.when(V_ > M_w_, 3, Met::nothing, Status::Warning);
  met.when(V_ > M_sbi_, 4, Met::sb, Status::Intervention);
  met.when(V_ > M_ebi_, 5, Met::eb, Status::Intervention);
  return met;
}

/// Tables 8 and 9. `Vt`: target or release speed.
inline void ReferenceSupervision::triggers(Met& met, const Sight& x, Speed Vt) const {
  using enum Status;
  const bool EOA = x.is_EOA() || x.t.kind == TargetKind::SR_end;
  const Speed V = V_;
  const Speed Vt_w = EOA ? Vt : Vt + dV_warning(Vt, d_->fixed);
  const Speed Vt_sbi = EOA ? Vt : Vt + dV_sbi(Vt, d_->fixed);
  const Speed Vt_ebi = EOA ? Vt : Vt + dV_ebi(Vt, d_->fixed);
  const bool upto_M = Vt < V && V <= M_;
  const bool over_M = M_ < V && V <= M_w_;
  const bool over_W = M_w_ < V && V <= M_sbi_;
  const bool over_SBI = M_sbi_ < V && V <= M_ebi_;
  const bool over_EBI = M_ebi_ < V;
  if (v340()) {
    met.when(V <= Vt, 1, Met::nothing, Normal);
    met.when(upto_M && !x.I(), 2, Met::nothing, Normal);
    met.when(upto_M && x.I(), 3, Met::nothing, Indication);
    met.when(upto_M && x.P(), 4, Met::nothing, Overspeed);
    met.when(over_M && !x.I_M(), 5, Met::nothing, Overspeed);
    met.when(over_M && x.I_M() && !x.W(), 6, Met::nothing, Overspeed);
    met.when(Vt_w < V && V <= M_w_ && x.W(), 7, Met::tco, Warning);
    met.when(over_W && !x.I_M(), 8, Met::tco, Warning);
    met.when(over_W && x.I_M() && !x.SBI(), 9, Met::tco, Warning);
    met.when(Vt_sbi < V && V <= M_sbi_ && x.SBI(), 10, Met::sb, Intervention);
    met.when(over_SBI && !x.I_M(), 11, Met::sb, Intervention);
    met.when(over_SBI && x.I_M() && !x.S_EBI, 12, Met::sb, Intervention);
    met.when(Vt_ebi < V && V <= M_ebi_ && x.S_EBI, 13, Met::eb, Intervention);
    met.when(over_EBI && !x.I_M(), 14, Met::eb, Intervention);
    met.when(over_EBI && x.I_M(), 15, Met::eb, Intervention);
    return;
  }
  // 3.6.0 has no t0-t2 and requires the Indication limit in the rows of the ceiling.
  const bool ceiling = v400() || x.I();
  const bool at_release = v400() && EOA && V == Vt && Vt.si > 0.0;
  met.when(at_release && x.I(), 0, Met::nothing, Indication);
  met.when(at_release && x.P(), 1, Met::nothing, Overspeed);
  met.when(at_release && x.W(), 2, Met::tco, Warning);
  met.when(upto_M && x.I() && !x.P(), 3, Met::nothing, Indication);
  met.when(upto_M && x.P(), 4, Met::nothing, Overspeed);
  met.when(over_M && ceiling && !x.W(), 6, Met::nothing, Overspeed);
  met.when(Vt_w < V && V <= M_w_ && x.W(), 7, Met::tco, Warning);
  met.when(over_W && ceiling && !x.SBI(), 9, Met::tco, Warning);
  met.when(Vt_sbi < V && V <= M_sbi_ && x.SBI(), 10, Met::sb, Intervention);
  met.when(over_SBI && ceiling && !x.S_EBI, 12, Met::sb, Intervention);
  met.when(Vt_ebi < V && V <= M_ebi_ && x.S_EBI, 13, Met::eb, Intervention);
  met.when(over_EBI && ceiling, 15, Met::eb, Intervention);
}

inline Met ReferenceSupervision::monitor_CSM() {
  const Met met = triggers_CSM();
  if (met.SB && d_->service_brake_interface) s.sb = true;
  if (met.SB && !d_->service_brake_interface) s.eb_for_sb = true;
  if (met.EB) s.eb = true;
  if (m_.standstill) s.eb = false;  // r0
  if (V_ <= M_) {                   // r1
    s.sb = s.eb_for_sb = false;
    if (d_->Q_NVEMRRLS) s.eb = false;
  }
  if (met.status > s.status) {
    s.status = met.status;
  } else if (V_ <= M_ && !(s.status == Status::Intervention && braking())) {
    s.status = Status::Normal;
  }
  return met;
}

inline Met ReferenceSupervision::monitor_RSM() {
  Met met;
  met.when(V_ <= release().V_release, 1, Met::nothing, Status::Indication);
  met.when(V_ > release().V_release, 2, Met::eb, Status::Intervention);
  if (met.EB) s.eb = true;
  if (m_.standstill) s.eb = false;  // r0
  if (met.EB) {
    s.status = Status::Intervention;
  } else if (s.status != Status::Intervention || m_.standstill) {
    s.status = Status::Indication;
  }
  return met;
}

inline Met ReferenceSupervision::monitor_TSM(bool MRDT_changed) {
  Met met;
  bool r_any = true;  // r1, r2 or r3 for every target
  bool r_EB = true;   // and the emergency brake too
  bool r_12 = true;   // r1 or r2 for every target
  bool r_1 = true;    // r1 for every target
  for (const Sight& x : list) {
    const bool EOA = x.is_EOA() || x.t.kind == TargetKind::SR_end;
    if (!v340() && !EOA && x.t.V_target >= M_) continue;  // 3.13.10.4.10.1
    Speed Vt = x.t.V_target;
    if (x.is_EOA()) Vt = release().exists && release().V_release < M_ ? release().V_release : Speed{0.0};
    triggers(met, x, Vt);
    const bool r1 = V_ <= Vt;
    const bool r2 = v340() && V_ > Vt && V_ <= M_ && !x.I();
    const bool r3 = V_ > Vt && V_ <= M_ && !x.P();
    r_any = r_any && (r1 || r2 || r3);
    r_EB = r_EB && (d_->Q_NVEMRRLS || (r1 && Vt.si == 0.0));
    r_12 = r_12 && (r1 || r2);
    r_1 = r_1 && r1;
  }
  if (V_ > M_ && met.status < Status::Overspeed) {
    // No row applies: the ceiling is supervised nevertheless (safe side).
    met = triggers_CSM();
    r_any = false;
  }
  if (met.TCO) s.tco = true;
  if (met.SB && d_->time_config.service_brake_available) s.sb = true;
  if (met.SB && !d_->time_config.service_brake_available) s.eb_for_sb = true;
  if (met.EB) s.eb = true;
  // A condition that triggers in this cycle is not revoked (t1, t2 and r1 at the release speed).
  const bool revoked = r_any && V_ <= M_ && met.status < Status::Overspeed;
  if (revoked) s.tco = s.sb = s.eb_for_sb = false;
  if (m_.standstill || (revoked && r_EB)) s.eb = false;
  if (met.status > s.status) {
    s.status = met.status;
  } else if (s.status == Status::Intervention && braking()) {
    // 3.13.10.2.5
  } else if (s.status >= Status::Overspeed) {
    if (revoked) s.status = v340() && r_12 ? Status::Normal : Status::Indication;
  } else if (v340() && s.status == Status::Indication) {
    if (revoked && (r_1 || (r_12 && MRDT_changed))) s.status = Status::Normal;
  }
  if (!v340() && s.status == Status::Normal) s.status = Status::Indication;  // 3.13.10.4.17
  return met;
}

}  // namespace evc::sdm::test
