#include "sdm/reduced_build_up.h"

#include <algorithm>

namespace evc::sdm {
namespace {

Acceleration lowest(Acceleration a, Acceleration b) { return std::min(a, b); }

}  // namespace

DecelerationRange deceleration_range(const Decelerations& d, CurveKind kind, bool due_to_TSR, Place from, Place to,
                                     Place reduced_from, Speed V_low, Speed V_high) {
  const Segments& segments = d.segments_of(due_to_TSR);
  const SpeedSquared w_low = V_low * V_low;
  const SpeedSquared w_high = V_high * V_high;
  DecelerationRange range{{1e9}, {-1e9}};
  bool reduced = false;
  const auto begins = [&](std::size_t i) { return i == 0 ? Place{{-1e18}} : segments[i].from; };
  const auto ends = [&](std::size_t i) { return i + 1 < segments.size() ? segments[i + 1].from : Place{{1e18}}; };
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i].reduced_adhesion && ends(i) > std::min(from, reduced_from) && begins(i) <= to) reduced = true;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (ends(i) <= from && i + 1 < segments.size()) continue;
    if (begins(i) > to && i > 0) break;
    const Bands& bands = d.bands(kind, segments[i]);
    SpeedSquared w_from{-1.0};
    for (const Band& b : bands) {
      if (b.w_upto >= w_low && w_from < w_high) {
        range.A_brake_min = lowest(range.A_brake_min, b.A[reduced ? 1 : 0]);
        range.A_max = std::max(range.A_max, deceleration(b, segments[i]));
      }
      w_from = b.w_upto;
    }
  }
  return range;
}

Duration reduced_build_up_time(const Ramp& r) {
  const double T = r.T.si;
  const double react = r.T_react.si;
  const double v0 = r.v0.si;
  const double Vt = r.stop ? 0.0 : r.V_target.si;
  const double a1 = r.A_est1.si;
  const double a2 = r.A_est2.si;
  const double t_max = r.T_traction_max.si;
  const double A_B = r.A.A_brake_min.si;
  const double A_max = r.A.A_max.si;
  const double t2 = 2.0 * T - react;  // A.3.12.2.1
  const double incr = t2 - react;
  if (incr <= 0.0) return r.T;
  // A.3.12.3: speed when the ramp begins.
  const double V_t1 = v0 + a1 * std::min(t_max, react) + a2 * std::max(react - t_max, 0.0);
  if (r.stop ? V_t1 <= 0.0 : V_t1 <= Vt) return std::min(r.T, r.T_react);
  if (A_B <= 0.0 || A_max <= 0.0) return r.T;
  // A.3.12.4: speed when it ends.
  const double V_t2 = std::max(0.0, v0 + a1 * t_max + a2 * (t2 - t_max) - A_B * incr / 2.0);
  if (r.stop ? V_t2 > 0.0 : V_t2 >= Vt) return r.T;
  // A.3.12.5: when the target speed is reached on the ramp; react + x.
  const double B = std::max(0.0, v0 - Vt) + a1 * t_max + a2 * (react - t_max);
  const double root = a2 * a2 + 2.0 * A_B * B / incr;
  const double x = incr / A_B * (a2 + __builtin_sqrt(std::max(0.0, root)));
  const double t_e = std::min(std::max(react + x, react), t2);
  // A.3.12.6: the distance until then.
  const double ramp = t_e - react;
  const double D = v0 * t_e + a1 * t_max * t_max / 2.0 + a1 * t_max * (t_e - t_max) +
                   a2 * (t_e - t_max) * (t_e - t_max) / 2.0 - A_B * ramp * ramp * ramp / (6.0 * incr);
  // A.3.12.7: the time after which the step model has run the same distance.
  const double t_min = r.T_traction_min.si;
  double t_d = 0.0;
  if (a2 > 0.0) {
    const double V1 = v0 + a1 * t_min;
    const double D0 = v0 * t_min + a1 * t_min * t_min / 2.0;
    const double q = (V1 / a2) * (V1 / a2) - (V1 * V1 - Vt * Vt + 2.0 * A_max * (D0 - D)) / (a2 * (A_max + a2));
    t_d = -(v0 + (a1 - a2) * t_min) / a2 + __builtin_sqrt(std::max(0.0, q));
  } else {
    // Without acceleration v0 is above the target speed here (A.3.12.3), so above 0.
    t_d = (D + Vt * Vt / (2.0 * A_max)) / v0 - v0 / (2.0 * A_max);
  }
  // A.3.12.8.
  return {std::min(T, std::max((react + t_e) / 2.0, t_d))};
}

}  // namespace evc::sdm
