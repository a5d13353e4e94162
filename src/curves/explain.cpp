#include "curves/explain.h"

#include <fmt/format.h>

#include <cmath>

#include "curves/explain_brakes.h"
#include "curves/explain_page.h"
#include "curves/explain_ramp.h"
#include "sdm/evaluate.h"

namespace evc::curves {
namespace {

/// The clause that requires the EBD of a target.
const char* EBD_clause(const sdm::Target& t) {
  if (t.kind == sdm::TargetKind::EOA_SvL) return "3.13.8.3.2";
  return t.kind == sdm::TargetKind::SR_end ? "3.13.8.3.3" : "3.13.8.3.1";
}

const char* target_name(const sdm::Target& t) {
  switch (t.kind) {
    case sdm::TargetKind::MRSP:
      return "a decrease of the MRSP";
    case sdm::TargetKind::LOA:
      return "a limit of authority";
    case sdm::TargetKind::EOA_SvL:
      return "an end of authority with its supervised location";
    case sdm::TargetKind::SR_end:
      return "the end of the SR distance";
  }
  return "";
}

void location_on(ExplainPage& page, const std::string& symbol, sdm::CurveView curve, Speed V, Place result,
                 const char* clause) {
  const sdm::Knot& k = curve.knots[curve.knot_at(V)];
  const double v_k = std::sqrt(k.w.si);
  if (V * V < k.w)
    page.step(symbol, "foot of the curve: V is below its speed there", "", result.from_origin.si, "m", clause);
  else if (!(k.A.si > 0.0))
    page.step(symbol, "where the curve becomes level", "", result.from_origin.si, "m", clause);
  else
    page.step(symbol, "x_k - (V^2 - v_k^2) / (2 * A_k)",
              fmt::format("{} - ({}^2 - {}^2) / (2 * {:.7f})", n4(k.x.from_origin.si), n4(V.si), n4(v_k), k.A.si),
              result.from_origin.si, "m", clause);
}

/// Adds a note if a curve does not have a speed at any place, because the train does not
/// decelerate.
bool nowhere(ExplainPage& page, const char* speed, Place place) {
  if (is_somewhere(place)) return false;
  page.line(std::string(speed) +
            " is allowed nowhere (A <= 0): the curve does not reach it, there are no limits for it");
  return true;
}

/// T_bs1, T_bs2 and T_indication of one curve: with 4.0.0 those of EBD and SBD may differ.
void service_brake_times(ExplainPage& page, const Approached& a, const sdm::Times& t) {
  const sdm::Derived& d = a.derived();
  const sdm::TimeConfig& config = d.time_config;
  const train::FixedValues& f = d.fixed;
  if (!config.service_brake_available) {
    page.step("T_bs1 = T_bs2", "0: the service brake command is not available", "", t.T_bs2.si, "s", "3.13.9.3.3.5");
  } else if (const auto fed_back = sdm::assumed_feedback(d, a.target(), a.input().assumed)) {
    const sdm::BrakePressure& b = *a.input().assumed.brake_pressure;
    if (fed_back->T_bs1 < t.T_bs && fed_back->T_bs1.si > 0.0)
      page.step("T_bs1", "T_bs * (p - p3) / (p0 - p3), p3 = p0 - 150 kPa",
                fmt::format("{} * ({} - {}) / ({} - {})", n4(t.T_bs.si), short_number(b.p), short_number(b.p0 - 150.0),
                            short_number(b.p0), short_number(b.p0 - 150.0)),
                t.T_bs1.si, "s", "A.3.10.3");
    else
      page.step("T_bs1",
                fed_back->T_bs1.si > 0.0 ? "T_bs: the pressure shows no braking"
                                         : "0: locked, the pressure was p0 - 60 kPa or less",
                "", t.T_bs1.si, "s", "A.3.10.3");
    page.step("T_bs2", "max(T_bs1, 2 s)", fmt::format("max({}, {})", n4(t.T_bs1.si), short_number(f.T_bs2_min.si)),
              t.T_bs2.si, "s", "A.3.10.3");
  } else if (config.feedback_available) {
    page.step("T_bs1", "T_bs: feedback available, brake not yet applied", "", t.T_bs1.si, "s", "3.13.9.3.3.4");
    page.step("T_bs2", "max(T_bs, 2 s)", fmt::format("max({}, {})", n4(t.T_bs.si), short_number(f.T_bs2_min.si)),
              t.T_bs2.si, "s", "3.13.9.3.3.4.1");
  } else {
    page.step("T_bs1 = T_bs2", "T_bs: the service brake command is available", "", t.T_bs2.si, "s", "3.13.9.3.3.3");
  }
  const bool later = d.rules.indication_includes_T_driver;
  const std::string T_driver = later ? " + " + short_number(f.T_driver.si) : "";
  const std::string at_least = short_number(f.T_indication_min.si);
  if (config.feedback_available)
    page.step("T_indication", later ? "5 s + T_driver: service brake feedback" : "5 s: service brake feedback",
              later ? at_least + T_driver : "", t.T_indication.si, "s", "3.13.9.3.6.4");
  else
    page.step("T_indication", later ? "max(0.8 * T_bs, 5 s) + T_driver" : "max(0.8 * T_bs, 5 s)",
              fmt::format("max({} * {}, {}){}", short_number(f.T_indication_factor), n4(t.T_bs.si), at_least, T_driver),
              t.T_indication.si, "s", "3.13.9.3.6.2");
}

/// The position of the train for the reduced times: as given, else about to reach its first limit.
sdm::Fronts fronts_of(const sdm::Explanation& e) { return {e.est_front, e.min_safe_front}; }

void times(ExplainPage& page, const Approached& a, const sdm::Explanation& e, const sdm::TargetTimes& both) {
  const sdm::Derived& d = a.derived();
  const train::FixedValues& f = d.fixed;
  const sdm::TimeConfig& config = d.time_config;
  const sdm::Times& t = both.EBD;
  page.heading("Times");
  explain_build_up_times(page, a, e);
  if (d.rules.reduced_build_up) explain_T_bs_reduced(page, a, e, a.target().d_target, fronts_of(e).est, t.T_bs);
  service_brake_times(page, a, t);
  if (config.traction_cut_off_interface)
    page.step("T_traction", "max(T_traction_cut_off - (T_warning + T_bs2), 0)",
              fmt::format("max({} - ({} + {}), 0)", short_number(config.T_traction_cut_off.si),
                          short_number(f.T_warning.si), n4(t.T_bs2.si)),
              t.T_traction.si, "s", "3.13.9.3.2.3");
  else
    page.step("T_traction", "T_traction_cut_off: no cut-off by the on-board", "", t.T_traction.si, "s", "3.13.9.3.2.3");
  if (d.rules.reduced_build_up) explain_T_be_reduced(page, a, e, fronts_of(e).est, fronts_of(e).min_safe, t);
  page.step("T_berem", "max(T_be - T_traction, 0)", fmt::format("max({} - {}, 0)", n4(t.T_be.si), n4(t.T_traction.si)),
            t.T_berem.si, "s", "3.13.9.3.2.6");
}

void build_up(ExplainPage& page, const Approached& a, const sdm::Explanation& e) {
  const sdm::Approach& p = e.approach;
  const sdm::Times& t = e.times;
  const sdm::BuildUpLoss& l = e.EBD.loss;
  const std::string V_target = n4(a.target().V_target.si);
  page.heading("Speed and distance until the emergency brake has its full effort");
  page.step("V_delta0",
            a.derived().Q_NVINHSMICPERM      ? "0: Q_NVINHSMICPERM"
            : a.input().assumed.V_ura_of_041 ? "V_ura = f41(V), SUBSET-041 5.3.1.2"
                                             : "V_ura",
            "", p.V_delta0.si, "m/s", "3.13.9.3.2.1");
  page.step("A_est1", "max(A_est, 0)", fmt::format("max({}, 0)", short_number(a.input().A_est.si)), p.A_est1.si, "m/s2",
            "3.13.9.3.2.8");
  page.step("A_est2", "min(A_est1, 0.4 m/s2)",
            fmt::format("min({}, {})", n5(p.A_est1.si), short_number(a.derived().fixed.A_est2_max.si)), p.A_est2.si,
            "m/s2", "3.13.9.3.2.9");
  page.step("V_delta1", "A_est1 * T_traction", n5(p.A_est1.si) + " * " + n4(t.T_traction.si), l.V_delta1.si, "m/s",
            "3.13.9.3.2.10");
  page.step("V_delta2", "A_est2 * T_berem", n5(p.A_est2.si) + " * " + n4(t.T_berem.si), l.V_delta2.si, "m/s",
            "3.13.9.3.2.10");
  const std::string faster = fmt::format("{} + {} + {}", n4(p.V.si), n4(p.V_delta0.si), n4(l.V_delta1.si));
  page.step("V_bec", "max(V + V_delta0 + V_delta1, V_target) + V_delta2",
            fmt::format("max({}, {}) + {}", faster, V_target, n4(l.V_delta2.si)), l.V_bec.si, "m/s", "3.13.9.3.2.10");
  page.step("D_bec",
            "max(V + V_delta0 + V_delta1 / 2, V_target) * T_traction\n"
            "+ (max(V + V_delta0 + V_delta1, V_target) + V_delta2 / 2) * T_berem",
            fmt::format("max({} / 2, {}) * {}\n", faster, V_target, n4(t.T_traction.si)) +
                fmt::format("+ (max({}, {}) + {} / 2) * {}", faster, V_target, n4(l.V_delta2.si), n4(t.T_berem.si)),
            l.D_bec.si, "m", "3.13.9.3.2.10");
}

/// The anchor of an EBD towards a target speed (3.13.8.3.1).
void anchor(ExplainPage& page, const sdm::Target& target, const train::FixedValues& f) {
  if (target.kind != sdm::TargetKind::MRSP && target.kind != sdm::TargetKind::LOA) return;
  const Speed V = target.V_target;
  const Speed dV = sdm::dV_ebi(V, f);
  const auto kmh = [](Speed v) { return short_number(rounded_kmh(v)); };
  if (V <= f.V_ebi_min)
    page.step("dV_ebi(V_target)", fmt::format("dV_ebi_min: V_target <= {} km/h", kmh(f.V_ebi_min)), "", dV.si * kKmh,
              "km/h", "3.13.9.2.3");
  else
    page.step(
        "dV_ebi(V_target)",
        "min(dV_ebi_min + (dV_ebi_max - dV_ebi_min) / (V_ebi_max - V_ebi_min) * (V_target - V_ebi_min), dV_ebi_max)",
        fmt::format("min({0} + ({1} - {0}) / ({2} - {3}) * ({4} - {3}), {1})", kmh(f.dV_ebi_min), kmh(f.dV_ebi_max),
                    kmh(f.V_ebi_max), kmh(f.V_ebi_min), kmh(V)),
        dV.si * kKmh, "km/h", "3.13.9.2.3");
  page.step("V_EBD(d_target)", "V_target + dV_ebi(V_target)", kmh(V) + " + " + n4(dV.si * kKmh), (V + dV).si * kKmh,
            "km/h", "3.13.8.3.1");
}

/// From the intervention upstream: W, P, I.
void chain(ExplainPage& page, const Approached& a, const sdm::Explanation& e, const sdm::Limits& l, const sdm::Times& t,
           const char* SBI, sdm::CurveView GUI) {
  const train::FixedValues& f = a.derived().fixed;
  const std::string V = n4(e.approach.V.si);
  const auto minus = [&](Place from, Duration T) {
    return fmt::format("{} - {} * {}", n4(from.from_origin.si), V, n4(T.si));
  };
  page.step("d_W", fmt::format("{} - V * T_warning", SBI), minus(l.d_SBI, f.T_warning), l.d_W.from_origin.si, "m",
            "3.13.9.3.4.1");
  std::string formula = fmt::format("{} - V * T_driver", SBI);
  std::string with = minus(l.d_SBI, f.T_driver);
  if (l.d_GUI) {
    explain_arcs(page, a, sdm::CurveKind::GUI, GUI, e.approach.V);
    location_on(page, "d_GUI(V)", GUI, e.approach.V, *l.d_GUI, "3.13.8.5");
    formula = "min(" + formula + ", d_GUI(V))";
    with = fmt::format("min({}, {})", with, n4(l.d_GUI->from_origin.si));
  } else if (a.derived().rules.P_not_beyond_target && l.d_EBI) {
    formula = "min(" + formula + ", d_target)";
    with = fmt::format("min({}, {})", with, n4(a.target().d_target.from_origin.si));
  }
  page.step("d_P", formula, with, l.d_P.from_origin.si, "m", l.d_GUI ? "3.13.9.3.5.4" : "3.13.9.3.5.1");
  if (a.derived().rules.indication_ignores_feedback &&
      sdm::assumed_feedback(a.derived(), a.target(), a.input().assumed))
    page.step("d_I", "as d_P - V * T_indication with T_bs1 = T_bs2 = T_bs in all its terms", "", l.d_I.from_origin.si,
              "m", "3.13.9.3.6.5");
  else
    page.step("d_I", "d_P - V * T_indication", minus(l.d_P, t.T_indication), l.d_I.from_origin.si, "m", "3.13.9.3.6.1");
}

void EBD_limits(ExplainPage& page, const Approached& a, const sdm::Explanation& e) {
  const sdm::Target& target = a.target();
  const sdm::CurveView EBD = a.derived().view(target.EBD);
  page.heading("Limits from the emergency brake deceleration curve (EBD)");
  anchor(page, target, a.derived().fixed);
  explain_arcs(page, a, sdm::CurveKind::EBD, EBD, e.EBD.loss.V_bec);
  if (e.EBD.loss.V_bec != e.approach.V && is_somewhere(e.d_EBD))
    location_on(page, "d_EBD(V)", EBD, e.approach.V, e.d_EBD, EBD_clause(target));
  if (nowhere(page, "V_bec", e.EBD.d_curve)) return;
  location_on(page, "d_EBD(V_bec)", EBD, e.EBD.loss.V_bec, e.EBD.d_curve, EBD_clause(target));
  page.step("d_EBI", "d_EBD(V_bec) - D_bec", n4(e.EBD.d_curve.from_origin.si) + " - " + n4(e.EBD.loss.D_bec.si),
            e.EBD.d_EBI->from_origin.si, "m", "3.13.9.3.2.12");
  page.step("d_SBI2", "d_EBI - V * T_bs2",
            fmt::format("{} - {} * {}", n4(e.EBD.d_EBI->from_origin.si), n4(e.approach.V.si), n4(e.times.T_bs2.si)),
            e.EBD.d_SBI.from_origin.si, "m", "3.13.9.3.3.2");
  chain(page, a, e, e.EBD, e.times, "d_SBI2", a.derived().view(target.GUI));
}

void SBD_limits(ExplainPage& page, const Approached& a, const sdm::Explanation& e, const sdm::Times& t) {
  const sdm::CurveView SBD = a.derived().view(a.target().SBD);
  page.heading("Limits from the service brake deceleration curve (SBD)");
  // If its end differs from that of the EBD, so does the time (A.3.12.2.4-5).
  if (a.derived().rules.reduced_build_up && a.target().d_EOA != a.target().d_target) {
    explain_T_bs_reduced(page, a, e, a.target().d_EOA, fronts_of(e).est, t.T_bs);
    service_brake_times(page, a, t);
  }
  explain_arcs(page, a, sdm::CurveKind::SBD, SBD, e.approach.V);
  if (nowhere(page, "V", e.SBD->d_curve)) return;
  location_on(page, "d_SBD(V)", SBD, e.approach.V, e.SBD->d_curve, "3.13.8.4.1");
  page.step("d_SBI1", "d_SBD(V) - V * T_bs1",
            fmt::format("{} - {} * {}", n4(e.SBD->d_curve.from_origin.si), n4(e.approach.V.si), n4(t.T_bs1.si)),
            e.SBD->d_SBI.from_origin.si, "m", "3.13.9.3.3.1");
  chain(page, a, e, *e.SBD, t, "d_SBI1", a.derived().view(a.target().GUI_EOA));
}

void results(ExplainPage& page, const Approached& a, double v_kmh) {
  page.heading("Result: the most restrictive place, and metres before the target");
  const SpeedRow row = speed_row(a, v_kmh);
  const auto result = [&](const char* symbol, const Value& before) {
    if (before)
      page.line(fmt::format("{:<5} at {:>12.3f} m   {:>10.3f} m before", symbol,
                            a.input().target_location.from_origin.si - *before, *before));
  };
  result("EBD", row.EBD);
  result("SBD", row.SBD);
  result("EBI", row.EBI);
  result("SBI", row.FLOI);
  result("W", row.W);
  result("P", row.P);
  result("I", row.I);
  for (const std::string& note : a.notes()) page.line("note: " + note);
}

}  // namespace

std::string explain_text(const Approached& a, double v_kmh) {
  const sdm::Target& target = a.target();
  const io::CurvesInput& c = a.input();
  const sdm::Explanation e = a.explain(Speed{v_kmh / kKmh});
  std::string head = fmt::format("{}\nSUBSET-026 {}, train \"{}\", towards {}\n", io::printable(c.name),
                                 name(c.inputs.srs), io::printable(c.train_name), target_name(target));
  head += fmt::format("V = {:g} km/h = {:.4f} m/s; V_target = {:g} km/h; target at {:.3f} m", v_kmh, v_kmh / kKmh,
                      target.V_target.si * kKmh, c.target_location.from_origin.si);
  if (e.SBD && target.d_EOA != target.d_target)
    head += fmt::format(", SvL at {:.3f} m", target.d_target.from_origin.si);
  const sdm::TargetTimes both = a.times_of(e);
  ExplainPage page;
  explain_brakes(page, a, e);
  explain_decelerations(page, a, e);
  times(page, a, e, both);
  build_up(page, a, e);
  EBD_limits(page, a, e);
  if (e.SBD) SBD_limits(page, a, e, both.SBD);
  results(page, a, v_kmh);
  return head + "\n" + std::move(page).text();
}

}  // namespace evc::curves
