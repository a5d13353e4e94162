#include "sim/motion.h"

#include <algorithm>
#include <cmath>

namespace evc::sim {
namespace {

constexpr double kGravity = 9.81;
constexpr double kTractionBuildUp_s = 2.0;  // from nothing to the full effort; cut off at once

double towards(double from, double to, double step) {
  return from < to ? std::min(to, from + step) : std::max(to, from - step);
}

}  // namespace

double at(const Dynamics::Table& table, double kmh) {
  if (table.empty()) return 0.0;
  if (kmh <= table.front().first) return table.front().second;
  for (std::size_t i = 1; i < table.size(); ++i) {
    if (kmh > table[i].first) continue;
    const auto& [x0, y0] = table[i - 1];
    const auto& [x1, y1] = table[i];
    return y0 + (y1 - y0) * (kmh - x0) / (x1 - x0);
  }
  return table.back().second;
}

Heights::Heights(const std::vector<GradientSegment>& gradient) {
  double height = 0.0;
  double position = gradient.empty() ? 0.0 : gradient.front().start_m;
  for (const GradientSegment& g : gradient) {
    // Where segments overlap, the earlier one applies to its end; a gap between them is level.
    if (g.start_m > position) {
      points_.push_back({position, height, 0.0});
      position = g.start_m;
    }
    if (g.end_m <= position) continue;
    points_.push_back({position, height, g.permille});
    height += (g.end_m - position) * g.permille / 1000.0;
    position = g.end_m;
  }
  points_.push_back({position, height, 0.0});
}

double Heights::at(double position_m) const {
  const auto after = std::upper_bound(points_.begin(), points_.end(), position_m,
                                      [](double x, const Point& p) { return x < p.position; });
  if (after == points_.begin()) return points_.front().height;
  const Point& p = *(after - 1);
  return p.height + (position_m - p.position) * p.permille / 1000.0;
}

Motion::Motion(const Dynamics& dynamics, double length_m, double rotating_pct, const Heights& heights, double front_m,
               double adhesion_mps2)
    : dynamics_(dynamics),
      length_(length_m),
      mass_kg_(dynamics.mass_t * 1000.0),
      inertia_kg_(mass_kg_ * (1.0 + rotating_pct / 100.0)),
      heights_(heights),
      front_(front_m),
      adhesion_(adhesion_mps2) {}

double Motion::coasting() const {
  const double speed = std::abs(v_);
  const double resistance = dynamics_.davis[0] + dynamics_.davis[1] * speed + dynamics_.davis[2] * speed * speed;
  const double slope = (heights_.at(front_) - heights_.at(front_ - length_)) / length_;
  const double gravity = -mass_kg_ * kGravity * slope;
  if (v_ > 0.0) return (gravity - resistance) / inertia_kg_;
  if (v_ < 0.0) return (gravity + resistance) / inertia_kg_;
  // At standstill the resistance holds the train on a slope up to its own force.
  if (std::abs(gravity) <= dynamics_.davis[0]) return 0.0;
  return (gravity > 0.0 ? gravity - dynamics_.davis[0] : gravity + dynamics_.davis[0]) / inertia_kg_;
}

double Motion::full_traction() const {
  return at(dynamics_.tractive_effort, std::abs(v_) * 3.6) * 1000.0 / inertia_kg_;
}

double Motion::full_service_brake() const { return at(dynamics_.service_brake, std::abs(v_) * 3.6); }

void Motion::move(const Handle& handle, double step_s) {
  const double rate = dynamics_.build_up_s > 0.0 ? step_s / dynamics_.build_up_s : 1.0;
  const double service = handle.service ? 1.0 : std::clamp(handle.brake, 0.0, 1.0);
  service_level_ = towards(service_level_, service, rate);
  emergency_level_ = towards(emergency_level_, handle.emergency ? 1.0 : 0.0, rate);
  const double kmh = std::abs(v_) * 3.6;
  const double wanted = std::max(service_level_ * at(dynamics_.service_brake, kmh),
                                 emergency_level_ * at(dynamics_.emergency_brake, kmh));
  const double brake = std::min(wanted, adhesion_);
  const bool cut = handle.cut_off || handle.service || handle.emergency;
  traction_level_ =
      cut ? 0.0 : towards(traction_level_, std::clamp(handle.traction, 0.0, 1.0), step_s / kTractionBuildUp_s);
  const double traction = traction_level_ * full_traction();
  const double free = coasting() + traction * handle.sense;
  const double before = v_;
  if (v_ == 0.0) {
    // The brake can hold a train at standstill but never moves it.
    const double moving = std::abs(free) <= brake ? 0.0 : (free > 0.0 ? free - brake : free + brake);
    v_ = moving * step_s;
  } else {
    const double a = v_ > 0.0 ? free - brake : free + brake;
    v_ += a * step_s;
    const bool crossed = (before > 0.0) != (v_ > 0.0);
    if (crossed && std::abs(free) <= brake + dynamics_.davis[0] / inertia_kg_) v_ = 0.0;
  }
  a_ = (v_ - before) / step_s;
  const double way = 0.5 * (before + v_) * step_s;
  traction_energy_ += std::max(0.0, traction * handle.sense * inertia_kg_ * way);
  front_ += way;
}

}  // namespace evc::sim
