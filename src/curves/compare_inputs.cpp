#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curves/compare.h"

// Whether two inputs are the same query: `compare` measures distances from the target of each input.
namespace evc::curves {
namespace {

constexpr double kSame = 1e-6;

double target_of(const Approached& a) { return m(a.input().target_location); }

std::string speed_text(Speed V) { return fmt::format("{:.6g} km/h", V.si * kKmh); }

std::string target_text(const Approached& a) {
  const sdm::Target& t = a.target();
  const io::CurvesInput& c = a.input();
  switch (t.kind) {
    case sdm::TargetKind::EOA_SvL:
      if (t.d_target == t.d_EOA) return "an end of authority with the SvL at its place";
      return fmt::format("an end of authority with the SvL {:.6g} m beyond it", (t.d_target - t.d_EOA).si);
    case sdm::TargetKind::LOA:
      return "a limit of authority at " + speed_text(t.V_target);
    case sdm::TargetKind::SR_end:
      return "the end of the SR distance";
    case sdm::TargetKind::MRSP:
      break;
  }
  return std::string("a restriction") + (c.target == sdm::TargetKind::MRSP && t.due_to_TSR ? " due to a TSR" : "") +
         " to " + speed_text(t.V_target);
}

/// The distance in rear of the target up to which data affect the compared curves.
double reach(const Comparison& c, const Approached& a, const Approached& b) {
  double far = 0.0;
  for (const auto* rows : {&c.rows_a, &c.rows_b})
    for (const SpeedRow& row : *rows) far = std::max(far, row.I.value_or(0.0));
  return far + std::max(a.input().inputs.train.L_TRAIN, b.input().inputs.train.L_TRAIN).si;
}
/// The places, relative to the target of each, at which two step functions can differ, from `-far` to `beyond`.
template <class Function>
std::vector<double> change_points(const Function& f, double origin, double far, double beyond) {
  std::vector<double> points{-far};
  for (const auto& step : f.steps)
    if (const double x = m(step.from) - origin; x > -far && x < beyond) points.push_back(x);
  return points;
}

double gradient_at(const sdm::GradientProfile& p, double x) {
  const Place place{{x + kSame}};
  const bool unknown = p.permille.empty() || place < p.permille.steps[0].from ||
                       (p.known_from && place < *p.known_from) || (p.known_to && place >= *p.known_to);
  return unknown ? 0.0 : p.permille.at(place);
}
bool same_gradient(const Approached& a, const Approached& b, double far, double beyond) {
  const sdm::GradientProfile& p = a.input().inputs.gradient;
  const sdm::GradientProfile& q = b.input().inputs.gradient;
  std::vector<double> points = change_points(p.permille, target_of(a), far, beyond);
  const std::vector<double> others = change_points(q.permille, target_of(b), far, beyond);
  points.insert(points.end(), others.begin(), others.end());
  for (const auto& [end, origin] : {std::pair{p.known_to, target_of(a)}, std::pair{q.known_to, target_of(b)}})
    if (end && m(*end) - origin > -far && m(*end) - origin < beyond) points.push_back(m(*end) - origin);
  return p.default_for_TSR == q.default_for_TSR && std::all_of(points.begin(), points.end(), [&](double x) {
           return std::abs(gradient_at(p, target_of(a) + x) - gradient_at(q, target_of(b) + x)) < 1e-9;
         });
}
bool same_mrsp(const Approached& a, const Approached& b, double far) {
  const sdm::Mrsp& p = a.input().inputs.mrsp;
  const sdm::Mrsp& q = b.input().inputs.mrsp;
  std::vector<double> points = change_points(p, target_of(a), far, kSame);
  const std::vector<double> others = change_points(q, target_of(b), far, kSame);
  points.insert(points.end(), others.begin(), others.end());
  return std::all_of(points.begin(), points.end(), [&](double x) {
    return std::abs((p.at({{target_of(a) + x + kSame}}) - q.at({{target_of(b) + x + kSame}})).si) < 1e-9;
  });
}

bool same_start(const std::optional<Place>& a, const std::optional<Place>& b, double shift) {
  return a.has_value() == b.has_value() && (!a || std::abs(m(*b) - m(*a) - shift) < kSame);
}
bool same_conditions(const Approached& a, const Approached& b) {
  const sdm::TrackConditions& p = a.input().inputs.conditions;
  const sdm::TrackConditions& q = b.input().inputs.conditions;
  const double shift = target_of(b) - target_of(a);
  if (p.slippery_rail != q.slippery_rail || p.reduced_adhesion.size() != q.reduced_adhesion.size()) return false;
  for (std::size_t i = 0; i < p.reduced_adhesion.size(); ++i)
    if (!same_start(p.reduced_adhesion[i].from, q.reduced_adhesion[i].from, shift) ||
        !same_start(p.reduced_adhesion[i].to, q.reduced_adhesion[i].to, shift))
      return false;
  return same_start(p.regenerative_off, q.regenerative_off, shift) &&
         same_start(p.eddy_current_emergency_off, q.eddy_current_emergency_off, shift) &&
         same_start(p.eddy_current_service_off, q.eddy_current_service_off, shift) &&
         same_start(p.magnetic_shoe_off, q.magnetic_shoe_off, shift) && same_start(p.powerless, q.powerless, shift);
}
bool same_release_speed(const Approached& a, const Approached& b) {
  const sdm::Authority& p = a.input().inputs.authority;
  const sdm::Authority& q = b.input().inputs.authority;
  if (a.target().kind != sdm::TargetKind::EOA_SvL || b.target().kind != sdm::TargetKind::EOA_SvL) return true;
  return p.release_speed == q.release_speed && p.V_release == q.V_release && p.level_1_at_EOA == q.level_1_at_EOA;
}
bool same_assumed(const sdm::Assumed& a, const sdm::Assumed& b) {
  return a.V_ura_of_041 == b.V_ura_of_041 && a.brake_pressure == b.brake_pressure;
}
bool same_state(const io::CurvesInput& a, const io::CurvesInput& b) {
  return a.A_est == b.A_est && a.V_ura == b.V_ura && same_assumed(a.assumed, b.assumed) &&
         a.inputs.brakes == b.inputs.brakes && a.motion.has_value() == b.motion.has_value();
}

}  // namespace

void compare_inputs(Comparison& c, const Approached& a, const Approached& b) {
  const io::CurvesInput& p = a.input();
  const io::CurvesInput& q = b.input();
  const auto differ = [&](bool same, const char* what) {
    if (!same) c.differ.emplace_back(what);
    return !same;
  };
  differ(p.inputs.srs == q.inputs.srs, "SRS version");
  differ(p.inputs.train == q.inputs.train, "train");
  differ(p.inputs.national_values == q.inputs.national_values, "national values");
  differ(p.inputs.fixed == q.inputs.fixed, "fixed values");
  differ(same_state(p, q), "state");
  differ(same_release_speed(a, b), "release speed");
  const std::string own = "; the distances of each are from its own target";
  const std::string target_a = target_text(a), target_b = target_text(b);
  if (differ(target_a == target_b, "target"))
    c.warnings.push_back("the targets differ: A " + target_a + ", B " + target_b + own);
  else if (std::abs(target_of(a) - target_of(b)) > kSame)
    c.warnings.push_back(
        fmt::format("the targets are at different places: A {:.6g} m, B {:.6g} m", target_of(a), target_of(b)) + own);
  const double far = reach(c, a, b);
  const double beyond = std::max(m(a.target().foot) - target_of(a), m(b.target().foot) - target_of(b));
  if (differ(same_gradient(a, b, far, std::max(beyond, kSame)), "gradients"))
    c.warnings.emplace_back("the gradients on the way to the target differ: the tracks contribute to the difference");
  if (differ(same_conditions(a, b), "track conditions"))
    c.warnings.emplace_back("adhesion or track conditions differ: the tracks contribute to the difference");
  differ(same_mrsp(a, b, far), "MRSP");
}

}  // namespace evc::curves
