#include "sdm/limits.h"

#include <algorithm>

namespace evc::sdm {
namespace {

/// The common formula of dV_ebi, dV_sbi and dV_warning (3.13.9.2.3).
Speed margin(Speed V, Speed dV_min, Speed dV_max, Speed V_min, Speed V_max) {
  if (V <= V_min) return dV_min;
  const Ratio C = (dV_max - dV_min) / (V_max - V_min);
  return std::min(dV_min + C * (V - V_min), dV_max);
}

}  // namespace

Speed dV_ebi(Speed V, const train::FixedValues& f) {
  return margin(V, f.dV_ebi_min, f.dV_ebi_max, f.V_ebi_min, f.V_ebi_max);
}
Speed dV_sbi(Speed V, const train::FixedValues& f) {
  return margin(V, f.dV_sbi_min, f.dV_sbi_max, f.V_sbi_min, f.V_sbi_max);
}
Speed dV_warning(Speed V, const train::FixedValues& f) {
  return margin(V, f.dV_warning_min, f.dV_warning_max, f.V_warning_min, f.V_warning_max);
}

TimeConfig time_config(const train::TrainData& t, const train::NationalValues& v) {
  return {
      .T_traction_cut_off = t.T_traction_cut_off,
      .traction_cut_off_interface = t.traction_cut_off_interface,
      .service_brake_available = train::service_brake_available(t, v),
      .feedback_available = train::service_brake_feedback_available(t, v),
  };
}

Duration T_traction(const TimeConfig& c, Duration T_bs2, const train::FixedValues& f) {
  if (!c.traction_cut_off_interface) return c.T_traction_cut_off;
  return std::max(c.T_traction_cut_off - (f.T_warning + T_bs2), Duration{0.0});
}

Times times(const TimeConfig& c, const train::BuildUpTimes& build_up, const std::optional<FeedbackTimes>& feedback,
            const Rules& rules, const train::FixedValues& f) {
  Times t{};
  t.T_be = build_up.T_be;
  t.T_bs = build_up.T_bs;
  // 3.13.9.3.3.3-5.
  if (c.service_brake_available) {
    t.T_bs1 = t.T_bs;
    t.T_bs2 = t.T_bs;
    if (c.feedback_available) {
      if (feedback.has_value()) {
        t.T_bs1 = feedback->T_bs1;
        t.T_bs2 = feedback->T_bs2;
      }
      t.T_bs2 = std::max(t.T_bs2, f.T_bs2_min);
    }
  }
  t.T_traction = T_traction(c, t.T_bs2, f);
  t.T_berem = std::max(t.T_be - t.T_traction, Duration{0.0});
  t.T_indication =
      c.feedback_available ? f.T_indication_min : std::max(f.T_indication_factor * t.T_bs, f.T_indication_min);
  if (rules.indication_includes_T_driver) t.T_indication += f.T_driver;
  return t;
}

Approach approach(Speed V, Speed V_delta0, Acceleration A_est, const train::FixedValues& f) {
  const Acceleration A_est1 = std::max(A_est, Acceleration{0.0});
  return {.V = V, .V_delta0 = V_delta0, .A_est1 = A_est1, .A_est2 = std::min(A_est1, f.A_est2_max)};
}

BuildUpLoss before_emergency_effort(const Approach& a, const Times& t, Speed V_target) {
  const Speed V_delta1 = a.A_est1 * t.T_traction;
  const Speed V_delta2 = a.A_est2 * t.T_berem;
  const Speed after_traction = std::max(a.V + a.V_delta0 + V_delta1, V_target);
  return {
      .V_delta1 = V_delta1,
      .V_delta2 = V_delta2,
      .V_bec = after_traction + V_delta2,
      .D_bec = std::max(a.V + a.V_delta0 + V_delta1 / 2.0, V_target) * t.T_traction +
               (after_traction + V_delta2 / 2.0) * t.T_berem,
  };
}

Distance D_be_display(const Approach& a, const Times& t) {
  const Speed V_delta1 = a.A_est1 * t.T_traction;
  const Speed V_delta2 = a.A_est2 * t.T_berem;
  return (a.V + a.V_delta0 + V_delta1 / 2.0) * t.T_traction +
         (a.V + a.V_delta0 + V_delta1 + V_delta2 / 2.0) * t.T_berem;
}

Limits limits_of_EBD(CurveView EBD, CurveView GUI, const Approach& a, const Times& t, Speed V_target,
                     const std::optional<Place>& d_target, const train::FixedValues& f) {
  Limits l{};
  l.loss = before_emergency_effort(a, t, V_target);
  l.d_curve = EBD.place_at(l.loss.V_bec);
  l.d_EBI = l.d_curve - l.loss.D_bec;
  l.d_SBI = *l.d_EBI - a.V * t.T_bs2;
  l.d_W = l.d_SBI - a.V * f.T_warning;
  l.d_P = l.d_SBI - a.V * f.T_driver;
  if (GUI.exists()) {
    l.d_GUI = GUI.place_at(a.V);
    l.d_P = std::min(l.d_P, *l.d_GUI);
  } else if (d_target.has_value()) {
    l.d_P = std::min(l.d_P, *d_target);
  }
  l.d_I = l.d_P - a.V * t.T_indication;
  return l;
}

Limits limits_of_SBD(CurveView SBD, CurveView GUI, const Approach& a, const Times& t, const train::FixedValues& f) {
  Limits l{};
  l.d_curve = SBD.place_at(a.V);
  l.d_SBI = l.d_curve - a.V * t.T_bs1;
  l.d_W = l.d_SBI - a.V * f.T_warning;
  l.d_P = l.d_SBI - a.V * f.T_driver;
  if (GUI.exists()) {
    l.d_GUI = GUI.place_at(a.V);
    l.d_P = std::min(l.d_P, *l.d_GUI);
  }
  l.d_I = l.d_P - a.V * t.T_indication;
  return l;
}

LimitSpeeds speeds_of_EBD(CurveView EBD, CurveView GUI, const Approach& a, const Times& t, Speed V_target, Place front,
                          const train::FixedValues& f) {
  const Distance D_be = D_be_display(a, t);
  const Speed V_delta = a.V_delta0 + a.A_est1 * t.T_traction + a.A_est2 * t.T_berem;
  std::size_t knot = 0;
  // From its foot on, the curve has V_target; no floor is below it.
  const auto speed = [&](Duration before, Speed floor) {
    return std::max(EBD.next_speed_at(front + a.V * before + D_be, knot) - V_delta, floor);
  };
  // From the most downstream place to the most upstream one.
  LimitSpeeds s{};
  s.V_I = speed(t.T_bs2 + f.T_driver + t.T_indication, V_target);
  s.V_P = speed(t.T_bs2 + f.T_driver, V_target);
  s.V_W = speed(t.T_bs2 + f.T_warning, V_target + dV_warning(V_target, f));
  s.V_SBI = speed(t.T_bs2, V_target + dV_sbi(V_target, f));
  s.V_EBI = speed({0.0}, V_target + dV_ebi(V_target, f));
  // 3.13.9.3.5.8: beyond the foot of the guidance curve the target speed is permitted.
  if (GUI.exists()) {
    s.V_P = std::max(std::min(s.V_P, GUI.speed_at(front)), V_target);
    s.V_I = std::max(std::min(s.V_I, GUI.speed_at(front + a.V * t.T_indication)), V_target);
  }
  return s;
}

LimitSpeeds speeds_of_SBD(CurveView SBD, CurveView GUI, const Approach& a, const Times& t, Place d_EOA, Place front,
                          const train::FixedValues& f) {
  std::size_t knot = 0;
  const auto speed = [&](Duration before) {
    const Place x = front + a.V * before;
    return x >= d_EOA ? Speed{0.0} : SBD.next_speed_at(x, knot);
  };
  LimitSpeeds s{};
  s.V_I = speed(t.T_bs1 + f.T_driver + t.T_indication);
  s.V_P = speed(t.T_bs1 + f.T_driver);
  s.V_W = speed(t.T_bs1 + f.T_warning);
  s.V_SBI = speed(t.T_bs1);
  if (GUI.exists()) {
    s.V_P = std::min(s.V_P, GUI.speed_at(front));
    s.V_I = std::min(s.V_I, GUI.speed_at(front + a.V * t.T_indication));
  }
  return s;
}

Place d_P_at_target_speed(CurveView EBD, Speed V_target, Place d_target, const Times& t,
                          const train::BuildUpTimes& build_up, const TimeConfig& c, Speed V_delta0t, const Rules& rules,
                          const train::FixedValues& f) {
  Duration T_be = t.T_be;
  Duration T_bs_foot = t.T_bs2;
  Duration T_traction_max = t.T_traction;
  if (rules.reduced_build_up) {
    // 3.13.9.3.5.9 c, d: fully reduced, with T_traction_max of A.3.12.2.7.
    T_be = build_up.T_be_react;
    if (c.service_brake_available && !c.feedback_available) T_bs_foot = build_up.T_bs_react;
    T_traction_max = T_traction(c, c.service_brake_available ? build_up.T_bs_react : Duration{0.0}, f);
  }
  const Duration T_berem = std::max(T_be - T_traction_max, Duration{0.0});
  const Place d_EBI = EBD.place_at(V_target + V_delta0t) - (V_target + V_delta0t) * (T_berem + T_traction_max);
  const Place d_P = d_EBI - V_target * (f.T_driver + T_bs_foot);
  return rules.P_not_beyond_target ? std::min(d_P, d_target) : d_P;
}

}  // namespace evc::sdm
