#pragma once
#include <cstdint>
#include <optional>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/set.h"
#include "openevc/base/units.h"
#include "openevc/terms/mrsp_source.h"
#include "openevc/terms/symbol.h"
#include "openevc/terms/track_condition.h"

// The advance display of route related information (3.15.10). It is computed on demand, not in each cycle. Distances
// are those that the front end still has to run: the min safe, the estimated or the max safe one, as each is
// supervised.
namespace evc::port {

/// A change of the most restrictive speed profile.
struct PlannedSpeed {
  Distance at;
  Speed V;
  Set<MrspSource> sources;  // the restrictions of this speed
};
/// An element of the gradient profile, against the estimated front end (3.15.10.3).
struct PlannedGradient {
  Distance from, to;
  std::int16_t permille = 0;  // positive uphill
};
/// A place at which a track condition asks for something: its start, or its end.
struct PlannedCondition {
  Symbol symbol{};
  std::optional<TrackConditionKind> kind = {};  // absent: change of traction system
  Distance at{};
  bool end = false;                              // of the condition; else its start
  ConditionPhase phase = ConditionPhase::ahead;  // how far the condition has come for the driver (5.18)
};

struct Planning {
  InplaceVector<PlannedSpeed, 128> speeds;  // the first one, at 0, is in force
  InplaceVector<PlannedGradient, 96> gradients;
  InplaceVector<PlannedCondition, 97> conditions;  // in the order of distance
  // The end of the authority; both are absent beyond a speed of zero in rear of it (3.15.10.4).
  std::optional<Distance> EOA, LOA;
  Speed V_LOA;
};

}  // namespace evc::port
