#pragma once
#include "track/description.h"

// When track conditions are shown to the driver and output to the train (3.12.1.2.1, 5.18, 5.20).
namespace evc::track {

/// Whether what is sent now is the condition that was sent before, seen from another reference.
constexpr bool same(const TrackCondition& a, const TrackCondition& b) {
  return a.kind == b.kind && a.from <= b.to && b.from <= a.to;
}
constexpr bool same(const Platform& a, const Platform& b) { return a.from <= b.to && b.from <= a.to; }
constexpr bool same(const TractionChange& a, const TractionChange& b) {
  return a.M_VOLTAGE == b.M_VOLTAGE && a.NID_CTRACTION == b.NID_CTRACTION;
}
constexpr bool same(const CurrentChange& a, const CurrentChange& b) { return a.amperes == b.amperes; }

/// The front end, or for the end of some kinds the rear end, that has to pass the start or the end of a condition
/// (5.18): the place of that end of the train.
Place passes_start(TrackConditionKind kind, const Here& here);
Place passes_end(TrackConditionKind kind, const Here& here);

/// How long before the start of a condition, or before a change of the traction system, its first indication begins
/// (point C of 5.18). Zero for the stopping areas, whose indication begins by the braking curves.
Duration lead_of(TrackConditionKind kind);
Duration lead_of_traction();

/// What is known of a condition that is sent again: an announcement is not taken back (A.3.5.1).
constexpr Progress sent_again(const Progress& before) {
  Progress again;
  if (before.phase != ConditionPhase::ahead) again.phase = ConditionPhase::announced;
  again.shown_as = before.shown_as;
  return again;
}

/// Whether it has to be stored beyond 300 m behind the train: its last indication is not over (5.18.2.6).
constexpr bool still_shown(const TrackCondition& c) { return c.progress.phase == ConditionPhase::ending; }

/// One cycle: each condition by the place of the train, except the non stopping and the tunnel stopping areas, which
/// depend on braking curves (`watch.stopping`). `V`: the estimated speed, at least 0.
void advance_conditions(Description& d, const Here& here, Speed V);

/// Nothing begins before the max safe front end is at `at`.
constexpr void quiet_until(ConditionWatch& watch, Place at) {
  if (at < watch.quiet_to) watch.quiet_to = at;
}

/// Inside a radio hole: the loss of the radio connection is not supervised (3.12.1.3).
bool in_radio_hole(const Description& d);

}  // namespace evc::track
