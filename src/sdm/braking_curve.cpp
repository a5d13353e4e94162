#include "sdm/braking_curve.h"

#include <algorithm>

namespace evc::sdm {

std::size_t CurveView::knot_at(Place x, std::size_t low) const {
  // With doubling steps, then by bisection: the result is usually near.
  std::size_t step = 1;
  std::size_t high = knots.size();
  while (low + step < high) {
    if (x < knots[low + step].x)
      low += step;
    else
      high = low + step;
    step *= 2;
  }
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    if (x < knots[middle].x)
      low = middle;
    else
      high = middle;
  }
  return low;
}

std::size_t CurveView::knot_at(Speed V) const {
  // The last knot with a lower speed: at the speed of a level stretch, its downstream end counts.
  const SpeedSquared w = V * V;
  std::size_t low = 0;
  std::size_t high = knots.size();
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    if (knots[middle].w < w)
      low = middle;
    else
      high = middle;
  }
  return low;
}

namespace {

/// v^2 on the arc that leads upstream from `k`; downstream of `k`, that of the knot.
inline SpeedSquared on_arc(const Knot& k, Place x) { return k.w + 2.0 * (k.A * std::max(k.x - x, Distance{})); }

}  // namespace

SpeedSquared CurveView::speed_squared_at(Place x) const { return on_arc(knots[knot_at(x)], x); }

Speed CurveView::next_speed_at(Place x, std::size_t& knot) const {
  knot = knot_at(x, x < knots[knot].x ? knot : 0);
  return {__builtin_sqrt(on_arc(knots[knot], x).si)};
}

Speed CurveView::speed_at(Place x) const { return {__builtin_sqrt(speed_squared_at(x).si)}; }

Place CurveView::place_at(Speed V) const {
  const SpeedSquared w = V * V;
  const Knot& k = knots[knot_at(V)];
  if (w <= k.w) return k.x;
  if (k.A.si <= 0.0) return {{-1e9}};  // a level end: this speed is allowed nowhere
  return k.x - Distance{(w - k.w).si / (2.0 * k.A.si)};
}

}  // namespace evc::sdm
