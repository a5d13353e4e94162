#include "protection/authority.h"

#include "track/services.h"

namespace evc::protection {
namespace {

bool beyond_end(const track::Authority& a, Place at) { return (a.EOA && at > *a.EOA) || (a.LOA && at > *a.LOA); }

// Codes of M_MODE (7.5.1.72).
constexpr std::uint8_t kOS = 1, kSR = 2, kSH = 3, kUN = 4, kTR = 7, kLS = 12, kSN = 13;

}  // namespace

bool passes_end_level_1(const track::Authority& authority, const track::Here& here) {
  return beyond_end(authority, here.min_safe_antenna);
}
bool passes_end_level_2(const track::Authority& authority, const track::Here& here) {
  return beyond_end(authority, here.min_safe_front);
}
bool before_track_description(const track::Description& d, const track::Here& here) {
  return track::before_track_description(d, here);
}

bool select(Override& state, const OverrideInputs& in, Speed V_est, Speed V_NVALLOWOVTRP, std::optional<Place> end) {
  if (V_est > V_NVALLOWOVTRP) return false;
  if (in.M_MODE != kSR) state.former_end = end ? *end : in.est_front;
  state.active = true;
  state.since = in.now;
  state.from = in.nominal;
  return true;
}

void supervise(Override& state, const OverrideInputs& in) {
  const Distance run = in.nominal - state.from;
  const Distance away = run < Distance{} ? -run : run;
  const bool over = (in.T_NVOVTRP && in.now - state.since > *in.T_NVOVTRP) || (in.D_NVOVTRP && away > *in.D_NVOVTRP);
  if (in.M_MODE == kUN || in.M_MODE == kSN) {
    state.active = state.active && !over;
    return;
  }
  const bool end_passed = state.active && state.former_end && in.min_safe_antenna > *state.former_end;
  const bool distance_passed = in.sr_distance_end && in.est_front > *in.sr_distance_end;
  const bool left = in.mode_entered && (in.M_MODE == kTR || in.M_MODE == kLS || in.M_MODE == kOS || in.M_MODE == kSH);
  if (over || end_passed || in.stop_information || in.proceed_information || distance_passed || left)
    state.active = false;
  // Passed under override it is no reason for a trip any more; it belongs to SR only.
  if (end_passed || in.stop_information || (in.mode_entered && in.M_MODE != kSR)) state.former_end.reset();
}

bool passes_former_end(const Override& state, const track::Here& here) {
  return !state.active && state.former_end && here.min_safe_antenna > *state.former_end;
}

bool passes_distance_end(const StaffResponsible& sr, const track::Here& here, bool override_active) {
  return !override_active && sr.distance_end && here.est_front > *sr.distance_end;
}

bool outside_list(const std::optional<track::GroupList>& list, GroupId group) {
  if (!list) return false;
  for (const GroupId& allowed : *list)
    if (allowed == group) return false;
  return true;
}

bool stopped_in_sr(bool stop_if_in_sr, const std::optional<track::GroupList>& list, GroupId group,
                   bool system_version_1) {
  if (!stop_if_in_sr) return false;
  if (system_version_1) return true;  // 6.6.2.2
  return !list || outside_list(list, group);
}

void request(TrackAheadFree& state, Place from, Place to) { state = TrackAheadFree{from, to, false}; }

TafResult ask(TrackAheadFree& state, Place est_front, bool acknowledged) {
  TafResult result;
  if (!state.from) return result;
  if (state.to && est_front > *state.to) {
    state = {};
    return result;
  }
  // Once it is shown it stays, also when the train rolls back (A.3.5).
  state.asking = state.asking || est_front >= *state.from;
  if (state.asking && acknowledged) {
    state = {};
    result.granted = true;
    return result;
  }
  result.asking = state.asking;
  return result;
}

}  // namespace evc::protection
