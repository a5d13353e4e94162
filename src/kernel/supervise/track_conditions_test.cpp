#include "kernel/supervise/track_conditions.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"
#include "kernel/curves.h"
#include "kernel/supervise/supervise.h"
#include "sdm/locations.h"

// Stopping areas, whose indication depends on braking curves (5.18.4, 5.18.8), and when conditions are looked at.
namespace evc::kernel {
namespace {

using evc::test::at;

/// A train of 200 m in FS at 30 m/s on level track, its authority is to 10 km.
class StoppingAreas : public ::testing::Test {
 protected:
  StoppingAreas() {
    state.mode = Mode::FS;
    state.level.level = Level::L1;
    state.now = {100.0};
    state.train.L_TRAIN = {200.0};
    EXPECT_TRUE(state.track.ma.emplace().sections.push_back({at(0.0), at(10000.0)}));
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 28}));
    EXPECT_TRUE(state.track.gradient.append(at(0.0), {0}));
    runs(30.0);
    front(500.0);
    (void)supervise(state, *derived, train, here, false, false, Log{outputs->events});
  }
  void runs(double v) { state.position.now.V_est = state.position.now.V_min = state.position.now.V_max = {v}; }
  void front(double x) {
    here.est_front = here.min_safe_front = here.max_safe_front = at(x);
    here.min_safe_rear = at(x - 200.0);
  }
  void add(TrackConditionKind kind, double from, double to) {
    ASSERT_TRUE(state.track.conditions.push_back({at(from), at(to), kind, {}}));
  }
  /// The phase of a condition in the next cycle.
  ConditionPhase phase(std::size_t i = 0) {
    state.track.watch.changed = true;
    advance_track_conditions(state, *derived, here);
    return state.track.conditions[i].progress.phase;
  }
  sdm::ServiceBrakeStop stop(double foot, double V) {
    return sdm::service_brake_stop(derived->in_force.inputs, derived->in_force.sdm, at(foot), Speed{V},
                                   derived->scratch.curves.sdm);
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  std::unique_ptr<Derived> derived = std::make_unique<Derived>();
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
  TrainSignals train;
  track::Here here;
};

using enum ConditionPhase;

TEST_F(StoppingAreas, OneForNoStopIsShownWhileAStopWouldEndInIt) {  // 5.18.4.2
  add(TrackConditionKind::non_stopping_area, 3000.0, 3300.0);
  const Place C = stop(3000.0, 30.0).d_SBI, E = stop(3500.0, 30.0).d_SBI;  // of the train's rear end too
  ASSERT_LT(C, at(3000.0));
  front(500.0);
  EXPECT_EQ(phase(), ahead);
  here.max_safe_front = C;
  EXPECT_EQ(phase(), ahead);
  here.max_safe_front = C + Distance{0.1};
  EXPECT_EQ(phase(), announced);
  here.max_safe_front = at(2999.9);
  EXPECT_EQ(phase(), announced);
  here.max_safe_front = at(3000.0);
  EXPECT_EQ(phase(), active);
  here.min_safe_front = E - Distance{0.1};
  EXPECT_EQ(phase(), active);
  here.min_safe_front = E;
  EXPECT_EQ(phase(), ahead) << "a stop would end beyond it";
  runs(0.5);
  here.min_safe_front = at(3490.0);
  EXPECT_EQ(phase(), active) << "at this speed it would not";
  here.min_safe_front = at(3500.0);
  EXPECT_EQ(phase(), over);
}

TEST_F(StoppingAreas, OneForNoStopIsLookedAtFromTheHighestSpeedOn) {  // 5.18.4.2
  add(TrackConditionKind::non_stopping_area, 6000.0, 6300.0);
  const double fastest = state.train.V_MAXTRAIN.si + 50.0 / 3.6;
  const Place earliest = stop(6000.0, fastest).d_SBI;
  here.max_safe_front = earliest - Distance{0.1};
  (void)phase();
  EXPECT_FALSE(state.track.watch.shown);
  EXPECT_EQ(state.track.watch.quiet_to, earliest);
  here.max_safe_front = earliest;
  (void)phase();
  EXPECT_TRUE(state.track.watch.shown);
  const Place still_earlier = stop(6000.0, fastest + 10.0).d_SBI;
  runs(fastest + 10.0);
  here.max_safe_front = still_earlier - Distance{0.1};
  (void)phase();
  EXPECT_EQ(state.track.watch.quiet_to, still_earlier) << "a train that is faster";
}

TEST_F(StoppingAreas, TheClosestTunnelAreaInWhichItCanStopIsShown) {  // 5.18.8.3
  const auto kind = TrackConditionKind::tunnel_stopping_area;
  add(kind, 5000.0, 5300.0);
  add(kind, 3000.0, 3300.0);
  add(kind, 7000.0, 7300.0);
  front(1000.0);
  EXPECT_EQ(phase(1), announced);
  EXPECT_EQ(state.track.conditions[0].progress.phase, ahead);
  EXPECT_EQ(state.track.conditions[2].progress.phase, ahead);
  const Place last = stop(3300.0, 30.0).d_P;
  here.est_front = last - Distance{0.1};
  EXPECT_EQ(phase(1), last > at(3000.1) ? active : announced);
  here.est_front = last;
  EXPECT_EQ(phase(1), ahead);
  EXPECT_EQ(state.track.conditions[0].progress.phase, announced);
  EXPECT_EQ(state.track.conditions[2].progress.phase, ahead);
  runs(1.0);
  here.est_front = at(2999.9);
  EXPECT_EQ(phase(1), announced);
  here.est_front = at(3000.0);
  EXPECT_EQ(phase(1), active);
  here.est_front = at(3300.1);
  EXPECT_EQ(phase(1), ahead);
  EXPECT_EQ(state.track.conditions[0].progress.phase, announced);
  EXPECT_TRUE(state.track.watch.shown);
  here.est_front = at(7301.0);
  EXPECT_EQ(phase(2), ahead);
  EXPECT_FALSE(state.track.watch.shown);
}

TEST_F(StoppingAreas, OfTwoTunnelAreasWithOneStartOneIsShown) {  // 5.18.8.3
  add(TrackConditionKind::tunnel_stopping_area, 3000.0, 3300.0);
  add(TrackConditionKind::tunnel_stopping_area, 3000.0, 3400.0);
  front(1000.0);
  EXPECT_EQ(phase(0), announced);
  EXPECT_EQ(phase(1), ahead) << "the one that was received first";
}

TEST_F(StoppingAreas, AreLookedAtAgainWithOtherCurves) {  // 5.18.4.2
  add(TrackConditionKind::non_stopping_area, 3000.0, 3300.0);
  front(stop(3000.0, 30.0).d_SBI.from_origin.si + 10.0);
  state.track.watch = {.changed = false, .shown = false, .stopping = true, .quiet_to = at(5000.0)};
  const auto next = [&] {
    (void)supervise(state, *derived, train, here, false, false, Log{outputs->events});
    return state.track.conditions[0].progress.phase;
  };
  EXPECT_EQ(next(), ahead);
  ++state.revision;
  EXPECT_EQ(next(), announced);
}

TEST_F(StoppingAreas, NeedSupervisionOfSpeed) {  // 4.5.2
  add(TrackConditionKind::tunnel_stopping_area, 3000.0, 3300.0);
  front(1000.0);
  state.mode = Mode::NL;
  EXPECT_EQ(phase(), ahead);
  state.mode = Mode::FS;
  EXPECT_EQ(phase(), announced);
}

TEST_F(StoppingAreas, NothingIsLookedAtInTheQuietPart) {  // A condition whose time has not come costs nothing.
  add(TrackConditionKind::sound_horn, 3000.0, 3300.0);
  track::ConditionWatch& watch = state.track.watch;
  const auto looked_at = [&](bool changed, bool shown, double quiet_to) {
    state.track.conditions[0].progress = {};
    watch.changed = changed;
    watch.shown = shown;
    watch.quiet_to = at(quiet_to);
    front(2900.0);
    advance_track_conditions(state, *derived, here);
    return state.track.conditions[0].progress.phase == active;
  };
  EXPECT_FALSE(looked_at(false, false, 2900.1));
  EXPECT_TRUE(looked_at(false, false, 2900.0));
  EXPECT_TRUE(looked_at(true, false, 5000.0));
  EXPECT_TRUE(looked_at(false, true, 5000.0));
}

}  // namespace
}  // namespace evc::kernel
