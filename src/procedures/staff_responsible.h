#pragma once
#include <optional>

#include "base/units.h"

// What is supervised in SR beside the speed: the SR distance (4.4.11).
namespace evc::procedures::staff_responsible {

/// 4.4.11.1.3: the end of the supervised SR distance; none when it is infinite. The distance in force is the newest of
/// national value (from the front at the entry to SR or at the selection of override), RBC, driver and loop.
constexpr bool distance_passed(std::optional<Place> end, Place est_front) {
  return end.has_value() && est_front > *end;
}

}  // namespace evc::procedures::staff_responsible
