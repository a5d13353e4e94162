#include "sdm/reduced_build_up.h"

#include <algorithm>

namespace evc::sdm {
namespace {

/// V_t1 of A.3.12.3: the speed when the brake begins to act.
double speed_before_ramp(const Ramp& r) {
  const double t_max = r.T_traction_max.si;
  const double react = r.T_react.si;
  return r.v0.si + r.A_est1.si * std::min(t_max, react) + r.A_est2.si * std::max(react - t_max, 0.0);
}
/// V_t2 of A.3.12.4: the speed when the brake has its full effort `A`.
double speed_after_ramp(const Ramp& r, double A) {
  const double t2 = 2.0 * r.T.si - r.T_react.si;  // A.3.12.2.1
  const double t_max = r.T_traction_max.si;
  return std::max(0.0, r.v0.si + r.A_est1.si * t_max + r.A_est2.si * (t2 - t_max) - A * (t2 - r.T_react.si) / 2.0);
}

/// A.3.12.7: the time after which the step model has run the distance `D`, including braking to V_target. The root of
/// a2 k t^2 / 2 + u k t + c = 0, in the form that is valid for A_est2 down to 0.
double time_of_step_model(const Ramp& r, double D) {
  const double A_max = r.A.A_max.si;
  const double a1 = r.A_est1.si;
  const double a2 = r.A_est2.si;
  const double t_min = r.T_traction_min.si;
  const double k = 1.0 + a2 / A_max;
  const double u = r.v0.si + (a1 - a2) * t_min;
  const double c = (u * u - r.V_target.si * r.V_target.si) / (2.0 * A_max) - (a1 - a2) * t_min * t_min / 2.0 - D;
  // Without acceleration u = v0 is above the target speed here (A.3.12.3), so above 0.
  return -2.0 * c / (u * k + __builtin_sqrt(std::max(0.0, u * k * (u * k) - 2.0 * a2 * k * c)));
}

}  // namespace

DecelerationRange deceleration_range(const Decelerations& d, CurveKind kind, bool due_to_TSR, Place from, Place to,
                                     Place reduced_from, Speed V_low, Speed V_high) {
  const Segments& segments = d.segments_of(due_to_TSR);
  const SpeedSquared w_low = V_low * V_low;
  const SpeedSquared w_high = V_high * V_high;
  DecelerationRange range{{1e9}, {-1e9}};
  const std::size_t n = segments.size();
  const auto contains = [&](std::size_t i, Place x) { return i + 1 == n || segments[i + 1].from > x; };
  bool reduced = false;
  for (std::size_t i = 0; i < n && segments[i].from <= to; ++i)
    reduced = reduced || (segments[i].reduced_adhesion && contains(i, std::min(from, reduced_from)));
  std::size_t i = 0;
  while (!contains(i, from)) ++i;
  while (i < n && segments[i].from <= to) {
    // Of consecutive segments with the same bands the steepest rise counts. EBD and SBD have no Kn.
    const Segment& first = segments[i];
    const Bands& bands = d.bands(kind, first);
    Segment steepest = first;
    for (++i; i < n && segments[i].from <= to && &d.bands(kind, segments[i]) == &bands &&
              segments[i].reduced_adhesion == first.reduced_adhesion;
         ++i)
      steepest.A_gradient = std::max(steepest.A_gradient, segments[i].A_gradient);
    SpeedSquared w_from{-1.0};
    for (const Band& b : bands) {
      if (b.w_upto >= w_low && w_from < w_high) {
        range.A_brake_min = std::min(range.A_brake_min, b.A[reduced ? 1 : 0]);
        range.A_max = std::max(range.A_max, deceleration(b, steepest));
      }
      w_from = b.w_upto;
    }
  }
  return range;
}

std::optional<Duration> build_up_time_settled(const Ramp& r, Acceleration A_highest) {
  const double Vt = r.V_target.si;
  if (r.T <= r.T_react) return r.T;
  if (speed_before_ramp(r) <= Vt) return r.T_react;  // A.3.12.3
  // A.3.12.4. Rounding is monotonic: a weaker brake never ends the ramp at a lower speed.
  const double V_t2 = speed_after_ramp(r, A_highest.si);
  if (r.stop ? V_t2 > 0.0 : V_t2 >= Vt) return r.T;
  return std::nullopt;
}

Speed full_build_up_below(const Ramp& r, Acceleration A_highest) {
  if (r.T <= r.T_react) return Speed{1e9};
  return {std::min(speed_before_ramp(r), speed_after_ramp(r, A_highest.si))};
}

Duration reduced_build_up_time(const Ramp& r) {
  const double A_B = r.A.A_brake_min.si;
  const double A_max = r.A.A_max.si;
  const std::optional<Duration> settled = build_up_time_settled(r, r.A.A_brake_min);
  if (settled.has_value()) return *settled;
  if (A_max <= 0.0) return r.T;
  const double react = r.T_react.si;
  const double a1 = r.A_est1.si;
  const double a2 = r.A_est2.si;
  const double t_max = r.T_traction_max.si;
  const double incr = 2.0 * (r.T.si - react);
  // A.3.12.5: the time when the target speed is reached on the ramp. A_B and the root are positive: without a brake the
  // train would not be slower at the end of the ramp (A.3.12.4), and A_est2 <= A_est1.
  const double B = std::max(0.0, r.v0.si - r.V_target.si) + a1 * t_max + a2 * (react - t_max);
  const double x = incr / A_B * (a2 + __builtin_sqrt(a2 * a2 + 2.0 * A_B * B / incr));
  const double t_e = react + x;
  // A.3.12.6: the distance run until then.
  const double D = r.v0.si * t_e + a1 * t_max * t_max / 2.0 + a1 * t_max * (t_e - t_max) +
                   a2 * (t_e - t_max) * (t_e - t_max) / 2.0 - A_B * x * x * x / (6.0 * incr);
  // A.3.12.8. If the target speed is not reached on the ramp, the result would be more than T.
  return {std::min(r.T.si, std::max((react + t_e) / 2.0, time_of_step_model(r, D)))};
}

}  // namespace evc::sdm
