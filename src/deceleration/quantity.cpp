#include "deceleration/quantity.h"

#include <cmath>

namespace evc::deceleration {
namespace {

/// Without its variables.
Quantity::Group group_of(const UnitGroup& units, double weight) {
  Quantity::Group group;
  group.units = units.units;
  group.failure = units.failure;
  group.weight = weight;
  return group;
}

}  // namespace

std::size_t Quantity::units() const {
  std::size_t units = 0;
  for (const Group& group : groups) units += group.units;
  return units;
}

double nominal_deceleration(const Spec& spec, double from_kmh) {
  double sum = 0.0;
  for (const UnitGroup& group : spec.groups)
    sum += static_cast<double>(group.units) * at_speed(group.nominal, from_kmh);
  return sum;
}

Quantity deceleration_of(const Spec& spec, double from_kmh) {
  Quantity quantity;
  quantity.common = spec.all_units;
  quantity.common_mean = spec.all_units.mean();
  const double nominal = nominal_deceleration(spec, from_kmh);
  for (const UnitGroup& unit : spec.groups) {
    Quantity::Group group = group_of(unit, at_speed(unit.nominal, from_kmh) / nominal);
    group.first = unit.friction;
    group.second = unit.pressure;
    group.first_mean = unit.friction.mean();
    group.second_mean = unit.pressure.mean();
    const double mean = group.weight * group.first_mean * group.second_mean;
    group.base = quantity.common_mean * mean;
    group.first_slope = quantity.common_mean * group.weight * group.second_mean;
    group.second_slope = quantity.common_mean * group.weight * group.first_mean;
    quantity.common_slope += static_cast<double>(group.units) * mean;
    quantity.groups.push_back(std::move(group));
  }
  return quantity;
}

Quantity build_up_time_of(const Spec& spec, double from_kmh) {
  Quantity quantity;
  quantity.kind = Quantity::Kind::build_up_time;
  const double nominal = nominal_deceleration(spec, from_kmh);
  for (const UnitGroup& unit : spec.groups) {
    Quantity::Group group = group_of(unit, at_speed(unit.nominal, from_kmh) / nominal);
    group.first = *unit.response_s;
    group.first_mean = unit.response_s->mean();
    group.second_mean = 1.0;
    group.first_slope = -group.weight;
    quantity.groups.push_back(std::move(group));
  }
  return quantity;
}

bool same_weights(const Quantity& a, const Quantity& b) {
  for (std::size_t g = 0; g < a.groups.size(); ++g)
    if (!(std::abs(a.groups[g].weight - b.groups[g].weight) <= 1e-12)) return false;
  return true;
}

}  // namespace evc::deceleration
