#pragma once
#include <cstddef>
#include <cstdint>

#include "openevc/base/step_function.h"
#include "openevc/base/units.h"

namespace evc::train {

/// Index of the step that applies at `x`, where every step includes its UPPER limit and the first one includes 0
/// (3.13.2.2.3.1.7, 3.13.2.2.9.1.3): from < x <= next from. This is how brake models and correction factors are read;
/// `StepFunction::at` includes the lower limit instead. Needs !empty().
template <class Axis, class Value, std::size_t N>
constexpr std::size_t step_below(const StepFunction<Axis, Value, N>& f, Axis x) {
  std::size_t i = f.size() - 1;
  while (i > 0 && !(f.steps[i].from < x)) --i;
  return i;
}
/// The value of that step.
template <class Axis, class Value, std::size_t N>
constexpr Value value_below(const StepFunction<Axis, Value, N>& f, Axis x) {
  return f.steps[step_below(f, x)].value;
}

/// A decimal factor of up to eight places in four bytes; `value()` is the double nearest to the
/// decimal, so 0.7 is stored and read back as 0.7. Range 0..42; finer values are rounded down, which is the safe side
/// for a correction factor of a deceleration.
struct Factor {
  std::uint32_t hundred_millionths = 0;

  static constexpr Factor of(double v) {
    if (!(v > 0.0)) return {0};
    if (v >= 42.0) return {4200000000u};
    const auto below = static_cast<std::uint32_t>(v * 1e8);
    // The product is rounded: a decimal of eight places may yield a product just below its integer.
    const bool exact_above = static_cast<double>(below + 1) / 1e8 <= v;
    return {exact_above ? below + 1 : below};
  }
  constexpr double value() const { return static_cast<double>(hundred_millionths) / 1e8; }
  friend constexpr bool operator==(Factor, Factor) = default;
};

}  // namespace evc::train
