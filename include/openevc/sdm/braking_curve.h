#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/units.h"

namespace evc::sdm {

/// A point of a braking curve and the deceleration of the arc that leads from it UPSTREAM (against the
/// running direction) to the next knot: v^2 = w + 2 A (x - place) along it. A = 0: the curve is level.
struct Knot {
  Place x{};
  SpeedSquared w{};
  Acceleration A{};
  friend constexpr bool operator==(const Knot&, const Knot&) = default;
};

/// A braking curve (3.13.8) as exact parabola arcs: knots from the foot upstream; places decrease,
/// speeds do not decrease. Empty: no curve. Beyond the last knot its arc is continued.
struct CurveView {
  std::span<const Knot> knots;

  constexpr bool exists() const { return !knots.empty(); }
  /// Where the curve ends: it has its lowest speed there.
  Place foot() const { return knots.front().x; }
  /// V_X(d): the curve's speed at a place; at and beyond the foot the foot's speed.
  Speed speed_at(Place x) const;
  SpeedSquared speed_squared_at(Place x) const;
  /// The same, fast for a sequence of places, each further upstream: `knot` is 0 for the first one and is updated by
  /// each call.
  Speed next_speed_at(Place x, std::size_t& knot) const;
  /// d_X(V): the last place where a train may run at `V` (the downstream end of a level stretch at `V`); the foot for a
  /// speed below the foot's; -1e9 for a speed that is allowed nowhere.
  Place place_at(Speed V) const;
  /// The knot from which the arc at `x` leads upstream: the last one downstream of `x`; the foot, if `x` is at or
  /// beyond it. The search begins at `low`, which is the foot or downstream of `x`.
  std::size_t knot_at(Place x, std::size_t low = 0) const;
  /// The knot from which the arc leads upstream to the speed `V`: the last one with a lower speed.
  std::size_t knot_at(Speed V) const;
};

inline constexpr std::size_t kMaxKnots = 176;

/// Cases in a trace that the standard does not cover or that did not fit; handled on the safe side.
struct CurveWarnings {
  bool no_deceleration = false;  // A <= 0 at some place: the curve is level or falls upstream there
  bool truncated = false;        // more arcs than fit: level from there upstream
  friend constexpr bool operator==(const CurveWarnings&, const CurveWarnings&) = default;
};

/// A braking curve that owns its arcs.
struct BrakingCurve {
  InplaceVector<Knot, kMaxKnots> knots;
  CurveWarnings warnings;

  CurveView view() const { return {{knots.begin(), knots.size()}}; }
  bool exists() const { return !knots.empty(); }
  Speed speed_at(Place x) const { return view().speed_at(x); }
  Place place_at(Speed V) const { return view().place_at(V); }
  friend constexpr bool operator==(const BrakingCurve&, const BrakingCurve&) = default;
};

}  // namespace evc::sdm
