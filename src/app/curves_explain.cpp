#include "app/curves_explain.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace evc::app {
namespace {

constexpr double kKmh = 3.6;

/// A page of steps: symbol, formula, the formula with its values, result, paragraph.
class Page {
 public:
  void heading(const std::string& text) { out_ += "\n" + std::to_string(++heading_) + "  " + text + "\n"; }
  void line(const std::string& text) { out_ += "   " + text + "\n"; }
  /// `with`: the formula with values; empty where the value is given.
  void step(const std::string& symbol, const std::string& formula, const std::string& with, double value,
            const char* unit, const char* clause) {
    std::vector<std::string> lines;
    append_lines(lines, "= ", formula);
    if (!with.empty()) append_lines(lines, "= ", with);
    lines.front() = fmt::format("{:<18}", symbol) + lines.front();
    for (std::size_t i = 1; i < lines.size(); ++i) lines[i] = std::string(18, ' ') + lines[i];
    std::string& last = lines.back();
    last = fmt::format("{:<86}= {:>11.4f} {:<5} [{}]", last, value + 0.0, unit, clause);
    for (const std::string& text : lines) line(text);
  }
  std::string text() { return std::move(out_); }

 private:
  /// Further lines of a formula stand under the first one's text.
  static void append_lines(std::vector<std::string>& lines, const std::string& sign, const std::string& text) {
    for (std::size_t from = 0; from != std::string::npos;) {
      const std::size_t end = text.find('\n', from);
      lines.push_back((from == 0 ? sign : std::string(sign.size(), ' ')) + text.substr(from, end - from));
      from = end == std::string::npos ? end : end + 1;
    }
  }

  std::string out_;
  int heading_ = 0;
};

std::string n(double v) { return fmt::format("{:.4f}", v + 0.0); }

/// Which clause asks for the EBD of a target.
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

/// The arcs that the location comes from, from the foot upstream.
void arcs(Page& page, const char* name, sdm::CurveView curve, Speed V) {
  const std::size_t last = curve.knot_at(V);
  page.line(fmt::format("{} from its foot, arcs of constant deceleration (3.13.8.1.3):", name));
  for (std::size_t k = 0; k <= last; ++k) {
    const sdm::Knot& knot = curve.knots[k];
    page.line(fmt::format("  from {:>12.3f} m at {:>8.3f} km/h upstream with {:>8.5f} m/s2", knot.x.from_origin.si,
                          std::sqrt(knot.w.si) * kKmh, knot.A.si));
  }
}

void location_on(Page& page, const std::string& symbol, sdm::CurveView curve, Speed V, Place result,
                 const char* clause) {
  const sdm::Knot& k = curve.knots[curve.knot_at(V)];
  const bool on_arc = k.A.si > 0.0 && V * V >= k.w;
  page.step(symbol, on_arc ? "x_k - (V^2 - v_k^2) / (2 A_k)" : "foot of the curve",
            on_arc ? fmt::format("{} - ({}^2 - {}^2) / (2 * {})", n(k.x.from_origin.si), n(V.si), n(std::sqrt(k.w.si)),
                                 fmt::format("{:.5f}", k.A.si))
                   : "",
            result.from_origin.si, "m", clause);
}

void decelerations(Page& page, const Approached& a, const sdm::Explanation& e) {
  const io::CurvesInput& c = a.input();
  const bool lambda = c.inputs.train.brake_model == train::BrakeModel::lambda;
  page.heading("Decelerations at this speed, at the place where the curve has it");
  page.step("A_brake_emergency", lambda ? "of the brake percentage (conversion model)" : "of the train's step table",
            "", e.A_brake_emergency.si, "m/s2", lambda ? "A.3.7" : "3.13.2.2.3.1");
  page.step("A_brake_safe",
            lambda ? "Kv_int(V) * Kr_int(L_TRAIN) * A_brake_emergency"
                   : "Kdry_rst * (Kwet_rst + M_NVAVADH * (1 - Kwet_rst)) * A_brake_emergency",
            "", e.A_brake_safe.si, "m/s2", "3.13.6.2.1.4");
  page.step("A_gradient", "g * grad / (1000 + 10 * M_rotating), lowest under the train", "", e.A_gradient_EBD.si,
            "m/s2", "3.13.4.3.2");
  // Reduced adhesion: what counts of the brakes is not more than A_MAXREDADH.
  if (e.A_safe < e.A_brake_safe + e.A_gradient_EBD)
    page.step("A_safe", "min(A_brake_safe, A_MAXREDADH) + A_gradient",
              fmt::format("min({}, {}) + {}", n(e.A_brake_safe.si), n((e.A_safe - e.A_gradient_EBD).si),
                          n(e.A_gradient_EBD.si)),
              e.A_safe.si, "m/s2", "3.13.6.2.1.3");
  else
    page.step("A_safe", "A_brake_safe + A_gradient", n(e.A_brake_safe.si) + " + " + n(e.A_gradient_EBD.si), e.A_safe.si,
              "m/s2", "3.13.6.2.1.3");
  if (!e.d_SBD) return;
  page.step("A_brake_service", lambda ? "of the brake percentage, at most 135 %" : "of the train's step table", "",
            e.A_brake_service.si, "m/s2", lambda ? "A.3.7" : "3.13.2.2.3.1");
  page.step("A_expected", "A_brake_service + A_gradient", n(e.A_brake_service.si) + " + " + n(e.A_gradient_SBD.si),
            e.A_expected.si, "m/s2", "3.13.6.3.1.3");
}

void times(Page& page, const Approached& a, const sdm::Explanation& e) {
  const train::FixedValues& f = a.derived().fixed;
  const sdm::TimeConfig& config = a.derived().time_config;
  const sdm::Times& t = e.times;
  const bool lambda = a.input().inputs.train.brake_model == train::BrakeModel::lambda;
  page.heading("Times");
  page.step("T_be", lambda ? "Kt_int * T_brake_emergency" : "T_brake_emergency",
            lambda && a.input().inputs.national_values.Kt_int > 0.0
                ? fmt::format("{} * {}", n(a.input().inputs.national_values.Kt_int),
                              n(e.build_up.T_be.si / a.input().inputs.national_values.Kt_int))
                : "",
            e.build_up.T_be.si, "s", "3.13.6.2.2.3");
  page.step("T_bs", "T_brake_service", "", e.build_up.T_bs.si, "s", "3.13.6.3.2.4");
  if (t.T_be != e.build_up.T_be) page.step("T_be_reduced", "in place of T_be", "", t.T_be.si, "s", "A.3.12");
  if (t.T_bs != e.build_up.T_bs) page.step("T_bs_reduced", "in place of T_bs", "", t.T_bs.si, "s", "A.3.12");
  const char* service = config.service_brake_available ? "T_bs: the service brake command is available"
                                                       : "0: the service brake command is not available";
  const char* clause = !config.service_brake_available ? "3.13.9.3.3.5"
                       : config.feedback_available     ? "3.13.9.3.3.4"
                                                       : "3.13.9.3.3.3";
  page.step("T_bs1", service, "", t.T_bs1.si, "s", clause);
  page.step("T_bs2", service, "", t.T_bs2.si, "s", clause);
  if (config.traction_cut_off_interface)
    page.step("T_traction", "max(T_traction_cut_off - (T_warning + T_bs2), 0)",
              fmt::format("max({} - ({} + {}), 0)", n(config.T_traction_cut_off.si), n(f.T_warning.si), n(t.T_bs2.si)),
              t.T_traction.si, "s", "3.13.9.3.2.3");
  else
    page.step("T_traction", "T_traction_cut_off: no cut-off by the on-board", "", t.T_traction.si, "s", "3.13.9.3.2.3");
  page.step("T_berem", "max(T_be - T_traction, 0)", fmt::format("max({} - {}, 0)", n(t.T_be.si), n(t.T_traction.si)),
            t.T_berem.si, "s", "3.13.9.3.2.6");
  const bool later = a.derived().rules.indication_includes_T_driver;
  const std::string formula = later ? "max(0.8 T_bs, 5 s) + T_driver" : "max(0.8 T_bs, 5 s)";
  const std::string with =
      fmt::format("max({} * {}, {})", n(f.T_indication_factor), n(t.T_bs.si), n(f.T_indication_min.si));
  if (config.feedback_available)
    page.step("T_indication", later ? "5 s + T_driver: service brake feedback" : "5 s: service brake feedback", "",
              t.T_indication.si, "s", "3.13.9.3.6.4");
  else
    page.step("T_indication", formula, later ? with + " + " + n(f.T_driver.si) : with, t.T_indication.si, "s",
              "3.13.9.3.6.2");
}

void build_up(Page& page, const sdm::Explanation& e, const sdm::Target& target) {
  const sdm::Approach& p = e.approach;
  const sdm::Times& t = e.times;
  const sdm::BuildUpLoss& l = e.EBD.loss;
  page.heading("Speed and distance until the emergency brake has its full effort");
  page.step("V_delta0", "V_ura (0 where Q_NVINHSMICPERM)", "", p.V_delta0.si, "m/s", "3.13.9.3.2.1");
  page.step("A_est1", "max(A_est, 0)", "", p.A_est1.si, "m/s2", "3.13.9.3.2.8");
  page.step("A_est2", "A_est1, at most 0.4 m/s2", "", p.A_est2.si, "m/s2", "3.13.9.3.2.9");
  page.step("V_delta1", "A_est1 * T_traction", n(p.A_est1.si) + " * " + n(t.T_traction.si), l.V_delta1.si, "m/s",
            "3.13.9.3.2.10");
  page.step("V_delta2", "A_est2 * T_berem", n(p.A_est2.si) + " * " + n(t.T_berem.si), l.V_delta2.si, "m/s",
            "3.13.9.3.2.10");
  const std::string faster = fmt::format("{} + {} + {}", n(p.V.si), n(p.V_delta0.si), n(l.V_delta1.si));
  page.step("V_bec", "max(V + V_delta0 + V_delta1, V_target) + V_delta2",
            fmt::format("max({}, {}) + {}", faster, n(target.V_target.si), n(l.V_delta2.si)), l.V_bec.si, "m/s",
            "3.13.9.3.2.10");
  page.step("D_bec",
            "max(V + V_delta0 + V_delta1 / 2, V_target) * T_traction\n"
            "+ (max(V + V_delta0 + V_delta1, V_target) + V_delta2 / 2) * T_berem",
            fmt::format("max({} + {} + {} / 2, {}) * {}\n", n(p.V.si), n(p.V_delta0.si), n(l.V_delta1.si),
                        n(target.V_target.si), n(t.T_traction.si)) +
                fmt::format("+ (max({}, {}) + {} / 2) * {}", faster, n(target.V_target.si), n(l.V_delta2.si),
                            n(t.T_berem.si)),
            l.D_bec.si, "m", "3.13.9.3.2.10");
}

/// From the intervention upstream: W, P, I.
void chain(Page& page, const Approached& a, const sdm::Explanation& e, const sdm::Limits& l, const char* SBI) {
  const train::FixedValues& f = a.derived().fixed;
  const std::string V = n(e.approach.V.si);
  const auto minus = [&](Place from, Duration T) {
    return fmt::format("{} - {} * {}", n(from.from_origin.si), V, n(T.si));
  };
  page.step("d_W", fmt::format("{} - V * T_warning", SBI), minus(l.d_SBI, f.T_warning), l.d_W.from_origin.si, "m",
            "3.13.9.3.4.1");
  std::string formula = fmt::format("{} - V * T_driver", SBI);
  std::string with = minus(l.d_SBI, f.T_driver);
  if (l.d_GUI) {
    formula = "min(" + formula + ", d_GUI(V))";
    with = fmt::format("min({}, {})", with, n(l.d_GUI->from_origin.si));
  } else if (a.derived().rules.P_not_beyond_target && l.d_EBI) {
    formula = "min(" + formula + ", d_target)";
    with = fmt::format("min({}, {})", with, n(a.target().d_target.from_origin.si));
  }
  page.step("d_P", formula, with, l.d_P.from_origin.si, "m", l.d_GUI ? "3.13.9.3.5.4" : "3.13.9.3.5.1");
  page.step("d_I", "d_P - V * T_indication", minus(l.d_P, e.times.T_indication), l.d_I.from_origin.si, "m",
            "3.13.9.3.6.1");
}

}  // namespace

std::string explain_text(const Approached& a, double v_kmh) {
  const sdm::Target& target = a.target();
  const io::CurvesInput& c = a.input();
  const sdm::Explanation e = a.explain(Speed{v_kmh / kKmh});
  Page page;
  std::string head = fmt::format("{}\nSUBSET-026 {}, train \"{}\", towards {}\n", c.name, io::name(c.inputs.srs),
                                 c.train_name, target_name(target));
  head += fmt::format("V = {:g} km/h = {:.4f} m/s; V_target = {:g} km/h; target at {:.3f} m", v_kmh, v_kmh / kKmh,
                      target.V_target.si * kKmh, c.target_location.from_origin.si);
  if (e.SBD && target.d_EOA != target.d_target)
    head += fmt::format(", SvL at {:.3f} m", target.d_target.from_origin.si);
  decelerations(page, a, e);
  times(page, a, e);
  build_up(page, e, target);

  page.heading("Limits from the emergency brake deceleration curve (EBD)");
  const sdm::CurveView EBD = a.derived().view(target.EBD);
  arcs(page, "EBD", EBD, e.EBD.loss.V_bec);
  location_on(page, "d_EBD(V_bec)", EBD, e.EBD.loss.V_bec, e.EBD.d_curve, EBD_clause(target));
  page.step("d_EBI", "d_EBD(V_bec) - D_bec", n(e.EBD.d_curve.from_origin.si) + " - " + n(e.EBD.loss.D_bec.si),
            e.EBD.d_EBI->from_origin.si, "m", "3.13.9.3.2.12");
  page.step("d_SBI2", "d_EBI - V * T_bs2",
            fmt::format("{} - {} * {}", n(e.EBD.d_EBI->from_origin.si), n(e.approach.V.si), n(e.times.T_bs2.si)),
            e.EBD.d_SBI.from_origin.si, "m", "3.13.9.3.3.2");
  chain(page, a, e, e.EBD, "d_SBI2");

  if (e.SBD) {
    page.heading("Limits from the service brake deceleration curve (SBD)");
    const sdm::CurveView SBD = a.derived().view(target.SBD);
    arcs(page, "SBD", SBD, e.approach.V);
    location_on(page, "d_SBD(V)", SBD, e.approach.V, e.SBD->d_curve, "3.13.8.4.1");
    page.step("d_SBI1", "d_SBD(V) - V * T_bs1",
              fmt::format("{} - {} * {}", n(e.SBD->d_curve.from_origin.si), n(e.approach.V.si), n(e.times.T_bs1.si)),
              e.SBD->d_SBI.from_origin.si, "m", "3.13.9.3.3.1");
    chain(page, a, e, *e.SBD, "d_SBI1");
  }

  page.heading("Result: the most restrictive place, and metres before the target");
  const SpeedRow row = speed_row(a, v_kmh);
  const auto result = [&](const char* symbol, const Value& before) {
    if (before)
      page.line(fmt::format("{:<5} at {:>12.3f} m   {:>10.3f} m before", symbol,
                            c.target_location.from_origin.si - *before, *before));
  };
  result("EBD", row.EBD);
  result("SBD", row.SBD);
  result("EBI", row.EBI);
  result("SBI", row.FLOI);
  result("W", row.W);
  result("P", row.P);
  result("I", row.I);
  for (const std::string& note : a.notes()) page.line("note: " + note);
  return head + "\n" + page.text();
}

}  // namespace evc::app
