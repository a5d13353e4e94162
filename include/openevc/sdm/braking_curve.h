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
  /// The same, quick for one place after the other, each further upstream: `knot` is 0 at first, the one found then.
  Speed next_speed_at(Place x, std::size_t& knot) const;
  /// d_X(V): how far a train may run at `V`, the end of a level stretch that has it; below the foot's speed the foot;
  /// -1e9 for a speed that is nowhere allowed.
  Place place_at(Speed V) const;
  /// The knot from which the arc at `x` leads upstream: the last one downstream of `x`, at and beyond the foot the
  /// foot. Looked for from `low` on, which is one downstream of `x` or the foot.
  std::size_t knot_at(Place x, std::size_t low = 0) const;
  /// The knot from which the arc leads upstream to the speed `V`: the last one with a lower speed.
  std::size_t knot_at(Speed V) const;
};

inline constexpr std::size_t kMaxKnots = 176;

/// What a trace met that the standard does not foresee or that did not fit; answered on the safe side.
struct CurveWarnings {
  bool no_deceleration = false;  // A <= 0 somewhere: the curve is level or falls upstream there
  bool truncated = false;        // more arcs than there is room for: level from there upstream
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
