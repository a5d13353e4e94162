#include "curves/explain_ramp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sdm/reduced_build_up.h"

namespace evc::curves {
namespace {

/// The ramp of one brake with the suffix of its times: be or bs.
struct Ramp {
  std::string be;
  double T, react, v0, V_target;
  bool stop;
  double A_est1, A_est2, t_max, t_min;
  double A_brake, A_max;
  double reduced;

  bool emergency() const { return be == "be"; }
  const char* A_name() const { return emergency() ? "A_EB" : "A_SB"; }
  double t2() const { return 2.0 * T - react; }
  double increase() const { return t2() - react; }
  std::string paragraph(int n, int n_emergency, int n_service) const {
    return fmt::format("A.3.12.{}.{}", n, emergency() ? n_emergency : n_service);
  }
};

bool stops(const sdm::Target& t) { return t.kind == sdm::TargetKind::EOA_SvL || t.kind == sdm::TargetKind::SR_end; }

/// The time when the target speed is reached on the ramp (A.3.12.5).
double time_enough(ExplainPage& page, const Ramp& r) {
  const std::string T_react = "T_" + r.be + "_react", react = n4(r.react);
  const double B = std::max(0.0, r.v0 - r.V_target) + r.A_est1 * r.t_max + r.A_est2 * (r.react - r.t_max);
  if (r.emergency())
    page.step("B", "max(0, v0 - V_target) + A_est1 * T_traction_max + A_est2 * (T_be_react - T_traction_max)",
              fmt::format("max(0, {} - {}) + {} * {} + {} * ({} - {})", n4(r.v0), n4(r.V_target), n5(r.A_est1),
                          n4(r.t_max), n5(r.A_est2), react, n4(r.t_max)),
              B, "m/s", "A.3.12.5.1");
  else
    page.step("B", "max(0, V - V_target)", fmt::format("max(0, {} - {})", n4(r.v0), n4(r.V_target)), B, "m/s",
              "A.3.12.5.2");
  const double increase = r.increase();
  const double x = increase / r.A_brake * (r.A_est2 + std::sqrt(r.A_est2 * r.A_est2 + 2.0 * r.A_brake * B / increase));
  const double enough = std::min(std::max(r.react + x, r.react), r.t2());
  page.step("t_enough",
            fmt::format("min({0} + incr / {1} * (A_est2 + (A_est2^2 + 2 * {1} * B / incr)^0.5), t2)   incr = t2 - {0}",
                        T_react, r.A_name()),
            fmt::format("min({0} + {1} / {2} * ({3} + ({3}^2 + 2 * {2} * {4} / {1})^0.5), {5})", react, n4(increase),
                        n5(r.A_brake), n5(r.A_est2), n4(B), n4(r.t2())),
            enough, "s", r.paragraph(5, 1, 2));
  return enough;
}

/// The distance run until then (A.3.12.6).
double distance_enough(ExplainPage& page, const Ramp& r, double enough) {
  const double ramp = enough - r.react;
  const double free = enough - r.t_max;
  const double D = r.v0 * enough + r.A_est1 * r.t_max * r.t_max / 2.0 + r.A_est1 * r.t_max * free +
                   r.A_est2 * free * free / 2.0 - r.A_brake * ramp * ramp * ramp / (6.0 * r.increase());
  const std::string t = n4(enough);
  page.step("D_enough",
            fmt::format("v0 * t + A_est1 * (T_max^2 / 2 + T_max * (t - T_max)) + A_est2 * (t - T_max)^2 / 2\n"
                        "- {} * (t - T_{}_react)^3 / (6 * incr)   t = t_enough, T_max = T_traction_max",
                        r.A_name(), r.be),
            fmt::format("{0} * {1} + {2} * ({3}^2 / 2 + {3} * ({1} - {3})) + {4} * ({1} - {3})^2 / 2\n", n4(r.v0), t,
                        n5(r.A_est1), n4(r.t_max), n5(r.A_est2)) +
                fmt::format("- {} * ({} - {})^3 / (6 * {})", n5(r.A_brake), t, n4(r.react), n4(r.increase())),
            D, "m", r.paragraph(6, 1, 2));
  return D;
}

/// The time after which the step model has run the same distance, with traction until T_traction_min (A.3.12.7.1).
double step_with_acceleration(ExplainPage& page, const Ramp& r, double D) {
  const std::string A1 = n5(r.A_est1), A2 = n5(r.A_est2), t_min = n4(r.t_min), A_max = n5(r.A_max);
  const double V1 = r.v0 + r.A_est1 * r.t_min;
  const double D0 = r.v0 * r.t_min + r.A_est1 * r.t_min * r.t_min / 2.0;
  page.step("V1", "v0 + A_est1 * T_traction_min", fmt::format("{} + {} * {}", n4(r.v0), A1, t_min), V1, "m/s",
            "A.3.12.7.1");
  page.step("D0", "v0 * T_traction_min + A_est1 * T_traction_min^2 / 2",
            fmt::format("{0} * {1} + {2} * {1}^2 / 2", n4(r.v0), t_min, A1), D0, "m", "A.3.12.7.1");
  const double q = (V1 / r.A_est2) * (V1 / r.A_est2) -
                   (V1 * V1 - r.V_target * r.V_target + 2.0 * r.A_max * (D0 - D)) / (r.A_est2 * (r.A_max + r.A_est2));
  const double t_d = -(r.v0 + (r.A_est1 - r.A_est2) * r.t_min) / r.A_est2 + std::sqrt(std::max(0.0, q));
  page.step("t_step_dist",
            "-(v0 + (A_est1 - A_est2) * T_traction_min) / A_est2\n"
            "+ ((V1 / A_est2)^2 - (V1^2 - V_target^2 + 2 * A_safe_max * (D0 - D_enough))\n"
            "/ (A_est2 * (A_safe_max + A_est2)))^0.5",
            fmt::format("-({} + ({} - {}) * {}) / {}\n", n4(r.v0), A1, A2, t_min, A2) +
                fmt::format("+ (({0} / {1})^2 - ({0}^2 - {2}^2 + 2 * {3} * ({4} - {5}))\n", n4(V1), A2, n4(r.V_target),
                            A_max, n4(D0), n4(D)) +
                fmt::format("/ ({0} * ({1} + {0})))^0.5", A2, A_max),
            t_d, "s", "A.3.12.7.1");
  return t_d;
}
/// The same without acceleration.
double step_at_constant_speed(ExplainPage& page, const Ramp& r, double D) {
  const double t_d = (D + r.V_target * r.V_target / (2.0 * r.A_max)) / r.v0 - r.v0 / (2.0 * r.A_max);
  page.step(
      "t_step_dist",
      fmt::format("(D_enough + V_target^2 / (2 * {0})) / v0 - v0 / (2 * {0})",
                  r.emergency() ? "A_safe_max" : "A_expected_max"),
      fmt::format("({0} + {1}^2 / (2 * {2})) / {3} - {3} / (2 * {2})", n4(D), n4(r.V_target), n5(r.A_max), n4(r.v0)),
      t_d, "s", r.paragraph(7, 1, 2));
  return t_d;
}

/// A.3.12.5 to A.3.12.8, where the target speed is reached on the ramp.
void on_the_ramp(ExplainPage& page, const Ramp& r) {
  const double enough = time_enough(page, r);
  const double D = distance_enough(page, r, enough);
  const double t_d = r.A_est2 > 0.0 ? step_with_acceleration(page, r, D) : step_at_constant_speed(page, r, D);
  page.step("T_" + r.be + "_reduced", fmt::format("min(T_{0}, max((T_{0}_react + t_enough) / 2, t_step_dist))", r.be),
            fmt::format("min({}, max(({} + {}) / 2, {}))", n4(r.T), n4(r.react), n4(enough), n4(t_d)), r.reduced, "s",
            "A.3.12.8.1");
}

/// For either brake: the speeds before and after the ramp, the result if they decide, else the remaining steps.
void reduction(ExplainPage& page, const Ramp& r) {
  const bool emergency = r.emergency();
  const std::string T = "T_" + r.be, T_react = T + "_react";
  const double V_t1 = r.v0 + r.A_est1 * std::min(r.t_max, r.react) + r.A_est2 * std::max(r.react - r.t_max, 0.0);
  if (emergency)
    page.step("V_t1be", "v0 + A_est1 * min(T_traction_max, T_be_react) + A_est2 * max(T_be_react - T_traction_max, 0)",
              fmt::format("{0} + {1} * min({2}, {3}) + {4} * max({3} - {2}, 0)", n4(r.v0), n5(r.A_est1), n4(r.t_max),
                          n4(r.react), n5(r.A_est2)),
              V_t1, "m/s", "A.3.12.3.1");
  if (V_t1 <= r.V_target) {
    const std::string why = emergency ? "the target speed is reached before the brake acts" : "V <= V_target";
    page.step(T + "_reduced", fmt::format("min({}, {}): {}", T, T_react, why),
              fmt::format("min({}, {})", n4(r.T), n4(r.react)), r.reduced, "s",
              r.stop ? r.paragraph(3, 3, 5) : r.paragraph(3, 2, 4));
    return;
  }
  page.step("t2", fmt::format("2 * {} - {}", T, T_react), fmt::format("2 * {} - {}", n4(r.T), n4(r.react)), r.t2(), "s",
            "A.3.12.2.1");
  if (r.increase() <= 0.0) {
    page.step(T + "_reduced", T + ": the brake has no ramp", "", r.reduced, "s", "A.3.12.2.1");
    return;
  }
  const double V_t2 =
      std::max(0.0, r.v0 + r.A_est1 * r.t_max + r.A_est2 * (r.t2() - r.t_max) - r.A_brake * r.increase() / 2.0);
  if (emergency)
    page.step("V_t2be",
              "max(0, v0 + A_est1 * T_traction_max + A_est2 * (t2 - T_traction_max) - A_EB * (t2 - T_be_react) / 2)",
              fmt::format("max(0, {0} + {1} * {2} + {3} * ({4} - {2}) - {5} * ({4} - {6}) / 2)", n4(r.v0), n5(r.A_est1),
                          n4(r.t_max), n5(r.A_est2), n4(r.t2()), n5(r.A_brake), n4(r.react)),
              V_t2, "m/s", "A.3.12.4.1");
  else
    page.step("V_t2bs", "max(0, V - A_SB * (t2 - T_bs_react) / 2)",
              fmt::format("max(0, {} - {} * ({} - {}) / 2)", n4(r.v0), n5(r.A_brake), n4(r.t2()), n4(r.react)), V_t2,
              "m/s", "A.3.12.4.4");
  if (r.stop ? V_t2 > 0.0 : V_t2 >= r.V_target)
    page.step(T + "_reduced", T + (r.stop ? ": still running after the ramp" : ": not below V_target after the ramp"),
              "", r.reduced, "s", r.stop ? r.paragraph(4, 3, 6) : r.paragraph(4, 2, 5));
  else if (r.A_brake <= 0.0 || r.A_max <= 0.0)
    page.step(T + "_reduced", T + ": no deceleration to count on", "", r.reduced, "s", "A.3.12");
  else
    on_the_ramp(page, r);
}

Duration T_traction_with(const sdm::Derived& d, Duration T_bs2) {
  const sdm::TimeConfig& c = d.time_config;
  if (!c.traction_cut_off_interface) return c.T_traction_cut_off;
  return std::max(c.T_traction_cut_off - (d.fixed.T_warning + T_bs2), Duration{0.0});
}

void traction(ExplainPage& page, const sdm::Derived& d, const char* symbol, Duration value, const char* T_bs,
              Duration T_bs2, const char* clause) {
  const sdm::TimeConfig& c = d.time_config;
  if (!c.traction_cut_off_interface) {
    page.step(symbol, "T_traction_cut_off: no cut-off by the on-board", "", value.si, "s", clause);
    return;
  }
  page.step(symbol,
            c.service_brake_available ? fmt::format("max(T_traction_cut_off - (T_warning + {}), 0)", T_bs)
                                      : "max(T_traction_cut_off - T_warning, 0): no service brake command",
            fmt::format("max({} - ({} + {}), 0)", short_number(c.T_traction_cut_off.si),
                        short_number(d.fixed.T_warning.si), n4(T_bs2.si)),
            value.si, "s", c.service_brake_available ? clause : "A.3.12.2.8");
}

/// The reaction time (3.13.6.2.2.3, 3.13.6.3.2.4).
void reaction(ExplainPage& page, const Approached& a, bool emergency, Duration react) {
  const train::TrainData& t = a.input().inputs.train;
  const char* clause = emergency ? "3.13.6.2.2.3" : "3.13.6.3.2.4";
  const std::string symbol = emergency ? "T_be_react" : "T_bs_react";
  const double Kt_int = a.input().inputs.national_values.Kt_int;
  if (t.brake_model == train::BrakeModel::lambda && emergency && Kt_int > 0.0)
    page.step(symbol, "Kt_int * T_brake_emergency_react (A.3.8.6)",
              fmt::format("{} * {}", short_number(Kt_int), short_number(react.si / Kt_int)), react.si, "s", clause);
  else
    page.step(symbol, emergency ? "T_brake_emergency_react" : "T_brake_service_react", "", react.si, "s", clause);
}

}  // namespace

void explain_T_bs_reduced(ExplainPage& page, const Approached& a, const sdm::Explanation& e, Place end, Place est,
                          Duration reduced) {
  const sdm::Derived& d = a.derived();
  const sdm::Target& target = a.target();
  if (d.time_config.feedback_available) {
    page.step("T_bs_reduced", "T_bs: service brake feedback is available", "", reduced.si, "s", "3.13.6.3.2.5");
    return;
  }
  Ramp r{
      "bs", e.build_up.T_bs.si, e.build_up.T_bs_react.si, e.approach.V.si, 0.0, stops(target), 0.0, 0.0, 0.0, 0.0, 0.0,
      0.0,  reduced.si};
  if (!r.stop) r.V_target = target.V_target.si;
  reaction(page, a, false, e.build_up.T_bs_react);
  if (r.v0 > r.V_target) {
    const Place from = std::min(est, end);
    const sdm::DecelerationRange A = sdm::deceleration_range(d.decelerations, sdm::CurveKind::SBD, target.due_to_TSR,
                                                             from, end, from, Speed{r.V_target}, e.approach.V);
    r.A_brake = A.A_brake_min.si;
    r.A_max = A.A_max.si;
    const std::string where = fmt::format("from {:.3f} m to {:.3f} m, {:.6g} to {:.6g} km/h", from.from_origin.si,
                                          end.from_origin.si, r.V_target * 3.6, r.v0 * 3.6);
    page.step("A_SB", "lowest A_brake_service " + where, "", r.A_brake, "m/s2", "A.3.12.2.4");
    page.step("A_expected_max", "highest A_expected there", "", r.A_max, "m/s2", "A.3.12.2.5");
  }
  reduction(page, r);
}

void explain_T_be_reduced(ExplainPage& page, const Approached& a, const sdm::Explanation& e, Place est, Place min_safe,
                          const sdm::Times& times) {
  const sdm::Derived& d = a.derived();
  const sdm::Target& target = a.target();
  const train::BuildUpTimes& b = e.build_up;
  if (times.T_traction >= b.T_be) {
    page.step("T_be_reduced", "T_be: T_traction >= T_be", "", times.T_be.si, "s", "A.3.12.1");
    return;
  }
  const bool available = d.time_config.service_brake_available;
  const Duration to_react = available ? b.T_bs_react : Duration{0.0}, to_full = available ? b.T_bs : Duration{0.0};
  Ramp r{"be",
         b.T_be.si,
         b.T_be_react.si,
         (e.approach.V + e.approach.V_delta0).si,
         0.0,
         stops(target),
         e.approach.A_est1.si,
         e.approach.A_est2.si,
         T_traction_with(d, to_react).si,
         T_traction_with(d, to_full).si,
         0.0,
         0.0,
         times.T_be.si};
  if (!r.stop) r.V_target = target.V_target.si;
  reaction(page, a, true, b.T_be_react);
  page.step("v0", "V + V_delta0", n4(e.approach.V.si) + " + " + n4(e.approach.V_delta0.si), r.v0, "m/s", "A.3.12.3.1");
  traction(page, d, "T_traction_max", {r.t_max}, "T_bs_react", to_react, "A.3.12.2.7");
  traction(page, d, "T_traction_min", {r.t_min}, "T_bs", to_full, "A.3.12.2.6");
  sdm::Times unreduced = times;
  unreduced.T_be = b.T_be;
  unreduced.T_berem = std::max(b.T_be - times.T_traction, Duration{0.0});
  const Speed V_bec = sdm::before_emergency_effort(e.approach, unreduced, Speed{r.V_target}).V_bec;
  const Speed V_high = std::max(V_bec, Speed{r.V_target});
  const Place end = target.d_target, from = std::min(est, end);
  const sdm::DecelerationRange A =
      sdm::deceleration_range(d.decelerations, sdm::CurveKind::EBD, target.due_to_TSR, from, end,
                              std::min(min_safe, end), Speed{r.V_target}, V_high);
  r.A_brake = A.A_brake_min.si;
  r.A_max = A.A_max.si;
  page.step("A_EB",
            fmt::format("lowest A_brake_safe from {:.3f} m to {:.3f} m, {:.6g} to {:.6g} km/h", from.from_origin.si,
                        end.from_origin.si, r.V_target * 3.6, V_high.si * 3.6),
            "", r.A_brake, "m/s2", "A.3.12.2.2");
  page.step("A_safe_max", "highest A_safe there", "", r.A_max, "m/s2", "A.3.12.2.3");
  reduction(page, r);
}

}  // namespace evc::curves
