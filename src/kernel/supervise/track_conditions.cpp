#include "kernel/supervise/track_conditions.h"

#include "kernel/basis.h"
#include "kernel/here.h"
#include "kernel/manoeuvre.h"
#include "sdm/locations.h"
#include "track/indication.h"

namespace evc::kernel {
namespace {

/// No speed above that of the train by more than this is expected: from it, the earliest place is found at which a non
/// stopping area can begin to matter.
constexpr Speed kAboveTrain{50.0 / 3.6};

/// Stops with the full service brake from the current speed.
class Stops {
 public:
  Stops(Derived& d, Speed V) : in_force_(d.in_force), scratch_(d.scratch.curves.sdm), V_(V) {}
  sdm::ServiceBrakeStop at(Place foot) const { return at(foot, V_); }
  sdm::ServiceBrakeStop at(Place foot, Speed V) const {
    return sdm::service_brake_stop(in_force_.inputs, in_force_.sdm, foot, V, scratch_);
  }
  Speed V() const { return V_; }

 private:
  const Derived::Curves& in_force_;
  sdm::Derived& scratch_;
  Speed V_;
};

/// 5.18.4.2: shown while a full service brake would stop the train in the area.
void advance_non_stopping_area(track::TrackCondition& c, const train::TrainData& train, const track::Here& here,
                               const Stops& stops, track::ConditionWatch& watch) {
  c.progress.phase = ConditionPhase::ahead;
  const Place G = c.to + train.L_TRAIN;
  if (here.min_safe_front >= G) {
    c.progress.phase = ConditionPhase::over;
    return;
  }
  const Speed fastest = train.V_MAXTRAIN + kAboveTrain;
  const Place earliest = stops.at(c.from, stops.V() > fastest ? stops.V() : fastest).d_SBI;
  if (here.max_safe_front < earliest) return track::quiet_until(watch, earliest);
  watch.shown = true;
  if (here.max_safe_front <= stops.at(c.from).d_SBI || here.min_safe_front >= stops.at(G).d_SBI) return;
  c.progress.phase = here.max_safe_front >= c.from ? ConditionPhase::active : ConditionPhase::announced;
}

/// 5.18.8.3: the closest area before whose end the train can be stopped.
void advance_tunnel_stopping_areas(track::Description& d, const track::Here& here, const Stops& stops) {
  track::TrackCondition* closest = nullptr;
  for (track::TrackCondition& c : d.conditions) {
    if (c.kind != TrackConditionKind::tunnel_stopping_area) continue;
    c.progress.phase = ConditionPhase::ahead;
    if (here.est_front > c.to) continue;
    d.watch.shown = true;
    if (closest != nullptr && closest->from <= c.from) continue;
    if (here.est_front < stops.at(c.to).d_P) closest = &c;
  }
  if (closest != nullptr)
    closest->progress.phase = here.est_front >= closest->from ? ConditionPhase::active : ConditionPhase::announced;
}

}  // namespace

void advance_track_conditions(State& s, Derived& d, const track::Here& here) {
  track::ConditionWatch& watch = s.track.watch;
  if (!watch.changed && !watch.shown && here.max_safe_front < watch.quiet_to) return;
  const Speed V = run_of(s.position.now).V;
  track::advance_conditions(s.track, here, V);
  if (!watch.stopping || !supervises_speed(s.mode)) return;
  const Stops stops(d, V);
  for (track::TrackCondition& c : s.track.conditions)
    if (c.kind == TrackConditionKind::non_stopping_area)
      advance_non_stopping_area(c, supervised_train(s), here, stops, watch);
  advance_tunnel_stopping_areas(s.track, here, stops);
}

}  // namespace evc::kernel
