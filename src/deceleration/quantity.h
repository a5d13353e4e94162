#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "deceleration/spec.h"

namespace evc::deceleration {

/// A quantity of the train that varies with its brake units, of which small values are dangerous, in one step of speed:
/// - the deceleration as a share of the nominal one: all_units x sum(weight x friction x pressure) over the units that
///   work;
/// - the build-up time times -1: - sum(weight x response) / sum(weight) over these units.
struct Quantity {
  enum class Kind : std::uint8_t { deceleration, build_up_time };
  struct Group {
    std::size_t units = 1;
    double failure = 0.0;
    double weight = 0.0;         ///< of one unit; over all units the sum is 1
    Distribution first, second;  ///< friction and pressure; response and 1
    double first_mean = 0.0, second_mean = 0.0;
    /// Its linear form, for the tilt: base + first_slope (first - mean) + second_slope (second - mean) if it works.
    double base = 0.0, first_slope = 0.0, second_slope = 0.0;
  };
  Kind kind = Kind::deceleration;
  std::vector<Group> groups;
  Distribution common;
  double common_mean = 1.0, common_slope = 0.0;

  std::size_t units() const;
};

/// A_brake_emergency without any variation (m/s2) from this speed on.
double nominal_deceleration(const Spec& spec, double from_kmh);
Quantity deceleration_of(const Spec& spec, double from_kmh);
/// The spec has response times.
Quantity build_up_time_of(const Spec& spec, double from_kmh);
/// Whether the units have the same weights: the quantities are the same.
bool same_weights(const Quantity& a, const Quantity& b);

}  // namespace evc::deceleration
