#pragma once
#include <vector>

#include "deceleration/draws.h"
#include "deceleration/failed_units.h"
#include "deceleration/quantity.h"

namespace evc::deceleration {

/// A sample: the value of the quantity, and how much it counts.
struct Drawn {
  double value = 0.0;
  double weight = 0.0;
};

/// Samples of a quantity in the stratum in which `failed` units fail, drawn with the density of the samples times
/// exp(-theta L), where L is the linear form of the quantity. The mean of weight x f(value) is
/// P(`failed` units fail) x E(f(value) | `failed` units fail), for any f.
class Tilt {
 public:
  Tilt(const Quantity& quantity, std::size_t failed, double theta);
  /// log of E(exp(-theta L); `failed` units fail); not finite where theta is too large.
  double log_transform() const { return log_transform_; }
  /// Room for one sample, of one thread.
  using Flags = std::vector<char>;
  Drawn draw(const Source& source, Flags& flags) const;

 private:
  struct Group {
    Tilted first, second;
  };
  const Quantity& quantity_;
  double theta_;
  double common_slope_;
  double log_transform_ = 0.0;
  std::vector<FailedUnits> failed_;  // one; none where theta is too large
  std::vector<Group> groups_;
  std::vector<Tilted> common_;
};

/// How strong a tilt brings the mean of a stratum to a place. The transforms of all strata are computed once, at tilts
/// that are a sixth of an octave apart: one pass over the units gives those of all strata, and a place is then found
/// without the units. Between two of these tilts it is interpolated: any tilt gives right estimates.
class Tilts {
 public:
  /// For the strata of 0, 1, ... `strata` - 1 failed units.
  Tilts(const Quantity& quantity, std::size_t strata);
  /// The theta >= 0 with which the mean of L in the stratum is about `target`; 0 where it is below without a tilt.
  /// Where no theta leads so far, the largest of those computed.
  double theta_for(std::size_t failed, double target) const;

 private:
  std::vector<double> thetas_;                       // 0 and then rising
  std::vector<std::vector<double>> log_transforms_;  // by stratum, at each theta; it ends where it is not finite
};

/// log E(exp(-theta L)), over all strata.
double log_transform(const Quantity& quantity, double theta);

}  // namespace evc::deceleration
