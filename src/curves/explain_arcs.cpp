#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curves/explain_brakes.h"

// Gradient, resulting decelerations, and the arcs of a curve.
namespace evc::curves {
namespace {

/// "min(0, -5)": gradients of the profile between `rear` and `front`; 0 for track with unknown gradient, and `also`,
/// which counts beside them.
std::string gradients_under(const sdm::GradientProfile& p, Place rear, Place front, const std::optional<double>& also) {
  const sdm::KnownPart k = sdm::known_part(p);
  std::string all;
  const auto add = [&](double permille) { all += (all.empty() ? "" : ", ") + short_number(permille); };
  if (rear < k.from) add(0.0);
  for (std::size_t i = 0; i < p.permille.size(); ++i) {
    const Place from = std::max(p.permille.steps[i].from, k.from);
    const Place to = i + 1 < p.permille.size() ? std::min(p.permille.steps[i + 1].from, k.to) : k.to;
    if (from < to && from < front && to >= rear) add(p.permille.steps[i].value);
  }
  if (k.from < front && k.to < front) add(0.0);
  if (also) add(*also);
  return "min(" + all + ")";
}

void gradient_at(ExplainPage& page, const Approached& a, const sdm::Segment& s, Place x, const char* place) {
  const sdm::Inputs& in = a.input().inputs;
  const train::FixedValues& f = a.derived().fixed;
  const sdm::GradientProfile& p = in.gradient;
  const sdm::KnownPart k = sdm::known_part(p);
  const bool covered = x > k.from && x <= k.to;
  if (a.target().due_to_TSR && p.default_for_TSR && !covered) {
    page.step("grad",
              fmt::format("default gradient for TSR at {} = {:.3f} m; a steeper known fall counts", place, m(x)), "",
              s.grad, "o/oo", "3.13.4.1.3");
  } else {
    const Place rear = x - in.train.L_TRAIN;
    // The default of a TSR counts under a rear that the profile does not cover, where it is a fall.
    std::optional<double> under_rear;
    if (a.target().due_to_TSR && p.default_for_TSR && *p.default_for_TSR < 0.0 && rear < k.from)
      under_rear = p.default_for_TSR;
    page.step("grad",
              fmt::format("lowest under the train: {} - L_TRAIN = {:.3f} m to {} = {:.3f} m{}", place, m(rear), place,
                          m(x), under_rear ? ";\nthe default gradient for TSR under its rear" : ""),
              gradients_under(p, rear, x, under_rear), s.grad, "o/oo", under_rear ? "3.13.4.1.3" : "3.13.4.2.1");
  }
  const auto& nominal = in.train.M_rotating_nom;
  const double M = nominal ? *nominal : s.grad > 0.0 ? f.M_rotating_max : f.M_rotating_min;
  page.step("M_rotating",
            nominal        ? "M_rotating_nom, of the train"
            : s.grad > 0.0 ? "M_rotating_max: uphill, M_rotating_nom not known"
                           : "M_rotating_min: not uphill, M_rotating_nom not known",
            "", M, "%", nominal ? "3.13.2.2.10" : "A.3.1");
  page.step("A_gradient", "g * grad / (1000 + 10 * M_rotating)",
            fmt::format("{} * {} / (1000 + 10 * {})", short_number(f.g.si), short_number(s.grad), short_number(M)),
            s.A_gradient.si, "m/s2", "3.13.4.3.2");
}

/// A_safe of 3.13.6.2.1.3, with A_MAXREDADH under reduced adhesion.
void safe(ExplainPage& page, const Approached& a, const sdm::Explanation& e, const sdm::Segment& s) {
  const sdm::Inputs& in = a.input().inputs;
  const std::string with_gradient = plus_n5(e.A_gradient_EBD.si);
  const train::MaxReducedAdhesion cap = train::A_MAXREDADH(in.train, in.national_values, in.brakes);
  if (s.reduced_adhesion && !cap.no_maximum) {
    const bool freight = in.train.brake_position != train::BrakePosition::PassengerP;
    const bool independent = in.train.adhesion_independent_brake && in.brakes.adhesion_independent;
    page.step("A_MAXREDADH",
              freight       ? "A_NVMAXREDADH3: freight train; adhesion is reduced here"
              : independent ? "A_NVMAXREDADH1: with a brake independent of adhesion; it is reduced here"
                            : "A_NVMAXREDADH2: passenger train in P; adhesion is reduced here",
              "", cap.A.si, "m/s2", "3.13.6.2.1.6");
    page.step("A_safe", "min(A_brake_safe, A_MAXREDADH) + A_gradient",
              fmt::format("min({}, {}){}", n5(e.A_brake_safe.si), n5(cap.A.si), with_gradient), e.A_safe.si, "m/s2",
              "3.13.6.2.1.3");
    return;
  }
  page.step("A_safe",
            s.reduced_adhesion ? "A_brake_safe + A_gradient: reduced adhesion, no maximum by national value"
                               : "A_brake_safe + A_gradient",
            n5(e.A_brake_safe.si) + with_gradient, e.A_safe.si, "m/s2", "3.13.6.2.1.3");
}

const char* title_of(sdm::CurveKind kind) {
  switch (kind) {
    case sdm::CurveKind::EBD:
      return "EBD from its foot, arcs of constant A_safe (3.13.8.1.3):";
    case sdm::CurveKind::SBD:
      return "SBD from its foot, arcs of constant A_expected (3.13.8.1.3):";
    case sdm::CurveKind::GUI:
      break;
  }
  return "GUI from its foot, arcs of constant A_normal_service (3.13.8.1.3):";
}

}  // namespace

void explain_decelerations(ExplainPage& page, const Approached& a, const sdm::Explanation& e) {
  const sdm::Decelerations& d = a.derived().decelerations;
  page.heading("Gradient and resulting deceleration, at the place where the curve has this speed");
  const sdm::Segments& segments = d.segments_of(a.target().due_to_TSR);
  const sdm::Segment& s = segments[sdm::segment_upstream_of(segments, e.d_EBD)];
  if (is_somewhere(e.d_EBD))
    gradient_at(page, a, s, e.d_EBD, "d_EBD(V)");
  else
    page.step("A_gradient", "where the line begins: the EBD has this speed nowhere", "", s.A_gradient.si, "m/s2",
              "3.13.4.3.2");
  safe(page, a, e, s);
  if (!e.d_SBD) return;
  gradient_at(page, a, d.segments[sdm::segment_upstream_of(d.segments, *e.d_SBD)], *e.d_SBD, "d_SBD(V)");
  page.step("A_expected", "A_brake_service + A_gradient", n5(e.A_brake_service.si) + plus_n5(e.A_gradient_SBD.si),
            e.A_expected.si, "m/s2", "3.13.6.3.1.3");
}

void explain_arcs(ExplainPage& page, const Approached& a, sdm::CurveKind kind, sdm::CurveView curve, Speed V) {
  const sdm::Decelerations& d = a.derived().decelerations;
  const sdm::Segments& segments = d.segments_of(a.target().due_to_TSR);
  const bool GUI = kind == sdm::CurveKind::GUI;
  page.line(title_of(kind));
  page.line(fmt::format("  {:>12} {:>9} {:>14} {:>8} {:>12}{} {:>10}", "x_k, m", "v_k, km/h",
                        kind == sdm::CurveKind::EBD ? "A_brake_safe" : "A_brake", "grad", "A_gradient",
                        GUI ? "  -Kn*grad/1000" : "", "A_k, m/s2"));
  bool capped = false;
  for (std::size_t k = 0; k <= curve.knot_at(V); ++k) {
    const sdm::Knot& knot = curve.knots[k];
    if (!is_somewhere(knot.x)) break;  // level from the last knot on
    const std::string start = fmt::format("  {:>12.3f} {:>9.3f}", m(knot.x), std::sqrt(knot.w.si) * kKmh);
    if (!(knot.A.si > 0.0)) {
      page.line(start + "   level: no deceleration here (A <= 0), or the curve falls upstream of here");
      continue;
    }
    // A place and a speed inside the arc; the last arc continues.
    const bool last = k + 1 == curve.knots.size();
    const double half = last ? 1e-3 : (knot.x - curve.knots[k + 1].x).si / 2.0;
    const sdm::Segment& s = segments[sdm::segment_upstream_of(segments, knot.x - Distance{half})];
    const sdm::Bands& bands = d.bands(kind, s);
    const sdm::Band& b = bands[sdm::band_below(bands, knot.w + 2.0 * (knot.A * Distance{half}))];
    const bool at_maximum = s.reduced_adhesion && b.A[1] < b.A[0];
    capped = capped || at_maximum;
    const double Kn = (s.grad > 0.0 ? b.Kn_plus.si : b.Kn_minus.si) * s.grad / 1000.0;
    page.line(fmt::format("{} {:>13.5f}{} {:>8} {:>12}{} {:>10}", start, b.A[s.reduced_adhesion ? 1 : 0].si,
                          at_maximum ? "*" : " ", short_number(s.grad), plus_n5(s.A_gradient.si),
                          GUI ? fmt::format(" {:>14}", plus_n5(-Kn)) : "", n5(knot.A.si)));
  }
  if (capped) page.line("  * A_MAXREDADH: adhesion is reduced there (3.13.6.2.1.3)");
}

}  // namespace evc::curves
