#include "protection/authority.h"

namespace evc::protection {
namespace {

bool beyond_end(const track::Authority& a, Place at) {
  const std::optional<Place> end = a.EOA_or_LOA();
  return end && at > *end;
}

}  // namespace

bool passes_end_level_1(const track::Authority& authority, const track::Here& here) {
  return beyond_end(authority, here.min_safe_antenna);
}
bool passes_end_level_2(const track::Authority& authority, const track::Here& here) {
  return beyond_end(authority, here.min_safe_front);
}
bool group_trips(const track::Authority& authority, Place first_possible, Distance L_antenna_front) {
  if (!authority.EOA) return false;
  return first_possible >= *authority.EOA || first_possible > *authority.EOA - L_antenna_front;
}
void request(TrackAheadFree& state, Place from, Place to) {
  const bool repeated = state.from == from && state.to == to;
  state = TrackAheadFree{from, to, repeated && state.asking};
}

bool ask(TrackAheadFree& state, Place est_front, bool acknowledged) {
  if (!state.from) return false;
  if (state.to && est_front > *state.to) {
    state = {};
    return false;
  }
  // Once shown, the request stays, even when the train rolls back (A.3.5).
  const bool was_shown = state.asking;
  state.asking = state.asking || est_front >= *state.from;
  if (!was_shown || !acknowledged) return false;  // the driver answers what he has seen, not a request of this cycle
  state = {};
  return true;
}

}  // namespace evc::protection
