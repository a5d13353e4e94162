#include "sim/odometer.h"

#include <algorithm>
#include <cmath>

namespace evc::sim {
namespace {

constexpr double kWanderEvery_s = 20.0;  // a new wandering share is drawn
constexpr double kSpeedError = 0.25;     // m/s declared in addition to the share
constexpr double kSmoothing_s = 1.0;     // of the acceleration
double milli(double v) { return std::nearbyint(v * 1e3) / 1e3 + 0.0; }

}  // namespace

Odometer::Odometer(const Errors& errors, Random& random) : errors_(errors), random_(random) {
  constant_ = random_.between(errors_.least, errors_.most);
}

void Odometer::move(double way_m, double step_s) {
  until_next_s_ -= step_s;
  if (until_next_s_ <= 0.0) {
    wander_to_ = random_.between(-errors_.wander, errors_.wander);
    until_next_s_ = kWanderEvery_s;
  }
  wander_ += (wander_to_ - wander_) * std::min(1.0, step_s / 5.0);
  const double counted = way_m * (1.0 + error());
  const double bound = std::abs(counted) * errors_.declared;
  nominal_ += counted;
  min_ += counted - bound;
  max_ += counted + bound;
}

void Odometer::accelerate(double a, double step_s) {
  acceleration_ += (a - acceleration_) * std::min(1.0, step_s / kSmoothing_s);
}

port::Odometry Odometer::read(double v) const {
  port::Odometry o;
  // Rounded outwards, so that the true value stays inside.
  o.nominal = {{milli(nominal_)}};
  o.min = {{std::floor(min_ * 1e3) / 1e3 + 0.0}};
  o.max = {{std::ceil(max_ * 1e3) / 1e3 + 0.0}};
  o.min = std::min(o.min, o.nominal);
  o.max = std::max(o.max, o.nominal);
  const double seen = v * (1.0 + error());
  const double half = std::min(std::abs(seen), kSpeedError + std::abs(seen) * errors_.declared);
  o.V_est = {milli(seen)};
  o.V_min = {std::min(std::floor((seen - half) * 1e3) / 1e3 + 0.0, o.V_est.si)};
  o.V_max = {std::max(std::ceil((seen + half) * 1e3) / 1e3 + 0.0, o.V_est.si)};
  o.A_est = {milli(acceleration_)};
  return o;
}

}  // namespace evc::sim
