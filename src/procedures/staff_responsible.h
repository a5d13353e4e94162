#pragma once
#include <optional>

#include "base/units.h"
#include "procedures/observe.h"

// What is supervised in SR and SH in addition to the speed: the SR distance and the lists of balise groups (4.4.8,
// 4.4.11).
namespace evc::procedures::staff_responsible {

/// 4.4.11.1.3: the end of the supervised SR distance; none when it is infinite. The distance in force is the newest of
/// national value (from the front at the entry to SR or at the selection of override), RBC, driver and loop.
constexpr bool distance_passed(std::optional<Place> end, Place est_front) {
  return end.has_value() && est_front > *end;
}

/// Whether a passed balise group is allowed by a stored list (4.4.8.1.1, 4.4.11.1.3 c): no list allows all groups, an
/// empty list none.
constexpr bool allowed(GroupList list, bool named) {
  return list == GroupList::none || (list == GroupList::some && named);
}

}  // namespace evc::procedures::staff_responsible
