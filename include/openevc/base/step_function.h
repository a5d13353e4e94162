#pragma once
#include <cstddef>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/units.h"

namespace evc {

/// A function that is constant between change points: `steps[i].value` holds for
/// `steps[i].from` <= x < `steps[i + 1].from`; the last value holds to the end of the axis. The
/// change points are strictly increasing. Axis is a place, a speed or a distance.
template <class Axis, class Value, std::size_t Capacity>
struct StepFunction {
  struct Step {
    Axis from{};
    Value value{};
    friend constexpr bool operator==(const Step&, const Step&) = default;
  };
  InplaceVector<Step, Capacity> steps;

  constexpr bool empty() const { return steps.empty(); }
  constexpr std::size_t size() const { return steps.size(); }

  /// Appends a step to the right of all others; equal neighbours are merged. False when full or out
  /// of order.
  [[nodiscard]] constexpr bool append(Axis from, Value value) {
    if (!steps.empty()) {
      if (steps.back().value == value) return from >= steps.back().from;
      if (from == steps.back().from) {
        steps.back().value = value;
        return true;
      }
      if (from < steps.back().from) return false;
    }
    return steps.push_back({from, value});
  }
  /// Index of the step that holds at `x`; 0 where `x` lies before the first one. Needs !empty().
  constexpr std::size_t index_at(Axis x) const {
    EVC_REQUIRE(!steps.empty());
    std::size_t low = 0;
    std::size_t high = steps.size();
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      if (steps[middle].from <= x)
        low = middle;
      else
        high = middle;
    }
    return low;
  }
  /// The value at `x`; before the first step the first value. Needs !empty().
  constexpr Value at(Axis x) const { return steps[index_at(x)].value; }
  friend constexpr bool operator==(const StepFunction&, const StepFunction&) = default;
};

}  // namespace evc
