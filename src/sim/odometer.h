#pragma once
#include "port/inputs.h"
#include "port/outputs.h"
#include "sim/random.h"

namespace evc::sim {

/// A wheel sensor with a wrong wheel diameter and slip: the measured distance differs from the true one by a constant
/// share and a slowly changing one. It declares a bound that is never exceeded: over any stretch the true distance is
/// between the counted `min` and `max`.
class Odometer {
 public:
  struct Errors {
    double declared = kDeclared;  // share of the counted distance that min and max allow for
    double least = -0.003;        // of the constant share
    double most = 0.003;
    double wander = 0.002;  // maximum of the changing share

    /// As much too much as it declares possible: the true distance is always at `min`.
    static constexpr Errors over() { return at_limit(kDeclared / (1.0 - kDeclared)); }
    /// As little as it declares possible: the true distance is always at `max`.
    static constexpr Errors under() { return at_limit(-kDeclared / (1.0 + kDeclared)); }
    /// With this constant share, above -1; the changing share remains. What it declares covers both.
    static constexpr Errors constant(double share) {
      Errors errors;
      errors.least = errors.most = share;
      // The true way is the counted one divided by 1 + share + wander; of rounding a billionth is left over.
      const double too_much = 1.0 - 1.0 / (1.0 + share + errors.wander);
      const double too_little = 1.0 / (1.0 + share - errors.wander) - 1.0;
      const double needed = (too_much > too_little ? too_much : too_little) + 1e-9;
      errors.declared = needed > kDeclared ? needed : kDeclared;
      return errors;
    }

   private:
    static constexpr double kDeclared = 0.01;
    static constexpr Errors at_limit(double share) {
      Errors errors;
      errors.least = errors.most = share;
      errors.wander = 0.0;
      return errors;
    }
  };
  Odometer(const Errors& errors, Random& random);

  /// The train moved by `way_m` (negative: backwards) within `step_s`.
  void move(double way_m, double step_s);
  /// The true acceleration over the last `step_s`; the sensor smooths it.
  void accelerate(double a, double step_s);
  /// Counters in whole millimetres; speed `v` and acceleration as measured by the sensor.
  port::Odometry read(double v) const;
  /// The nominal counter after a further true distance of `way_m` (a balise between two readings).
  double nominal_after(double way_m) const { return nominal_ + way_m * (1.0 + error()); }

 private:
  double error() const { return constant_ + wander_; }
  Errors errors_;
  Random& random_;
  double constant_ = 0.0, wander_ = 0.0, wander_to_ = 0.0, until_next_s_ = 0.0;
  double nominal_ = 0.0, min_ = 0.0, max_ = 0.0;
  double acceleration_ = 0.0;
};

}  // namespace evc::sim
