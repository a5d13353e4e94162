#include "kernel/train_data.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"
#include "kernel/here.h"
#include "kernel/train_category.h"

// Changes of the train data, and the codes that are made of them (3.18.3, 7.5.1.82).
namespace evc::kernel {
namespace {

using evc::test::at;

/// A unit at standstill with an authority, buffered information and valid train data.
class TrainDataOfTheUnit : public ::testing::Test {
 protected:
  TrainDataOfTheUnit() { restart(); }
  void restart() {
    state = State{};
    state.mode = Mode::FS;
    state.data.train_data_status = DataStatus::valid;
    EXPECT_TRUE(state.track.ma.emplace().sections.push_back({at(0.0), at(3000.0)}));
    EXPECT_NE(state.buffer.grow(), nullptr);
    here.standstill = true;
    here.max_safe_front = at(1000.0);
    outputs->events.clear();
  }
  bool happened(What what) const {
    for (const Event& e : outputs->events)
      if (e.what == what) return true;
    return false;
  }
  /// Whether the change ends what was received for other train data.
  bool forgets(const train::TrainData& data) {
    change_train_data(state, data, here, Log{outputs->events});
    EXPECT_EQ(happened(What::track_description_shortened), state.buffer.empty());
    return state.buffer.empty();
  }
  static train::TrainData other_route() {
    train::TrainData data;
    data.loading_gauge = train::LoadingGauge::GB;
    return data;
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
  track::Here here;
};

TEST_F(TrainDataOfTheUnit, OfFourKindsTheRouteDepends) {  // 3.18.3.7
  const train::TrainData before;
  EXPECT_FALSE(route_matters(before, before));
  train::TrainData data = before;
  data.L_TRAIN = {321.0};
  EXPECT_FALSE(route_matters(before, data));
  data = before;
  data.cant_deficiency_mm = 165;
  EXPECT_TRUE(route_matters(before, data));
  data = before;
  data.other_categories = train::kFreightG;
  EXPECT_TRUE(route_matters(before, data));
  data = before;
  data.axle_load = train::AxleLoad::E5;
  EXPECT_TRUE(route_matters(before, data));
  EXPECT_TRUE(route_matters(before, other_route()));
  data = before;
  data.traction_systems.clear();
  ASSERT_TRUE(data.traction_systems.push_back({300, 1}));
  EXPECT_TRUE(route_matters(before, data));
}

TEST_F(TrainDataOfTheUnit, EndWhatWasReceivedForOthers) {  // 3.18.3.7, A.3.4 j
  EXPECT_TRUE(forgets(other_route()));
  restart();
  EXPECT_FALSE(forgets(train::TrainData{})) << "the same";
  restart();
  here.standstill = false;
  EXPECT_FALSE(forgets(other_route())) << "while it runs";
  restart();
  state.data.train_data_status = DataStatus::invalid;
  EXPECT_FALSE(forgets(other_route())) << "there were no valid ones";
}

TEST_F(TrainDataOfTheUnit, WithoutAnAuthorityTheRestEndsAtTheTrainToo) {  // 3.18.3.7 a
  state.track.ma.reset();
  change_train_data(state, other_route(), here, Log{outputs->events});
  EXPECT_FALSE(happened(What::track_description_shortened)) << "nothing is stored";
  restart();
  state.track.ma.reset();
  ASSERT_TRUE(state.track.ssp.append(evc::test::at(0.0), {.V_STATIC = 20}));
  change_train_data(state, other_route(), here, Log{outputs->events});
  EXPECT_TRUE(happened(What::track_description_shortened));
}

TEST_F(TrainDataOfTheUnit, AreInForceAtOnceAndSentToTheRBC) {  // 3.18.3.4
  state.data.train_data_status = DataStatus::invalid;
  const std::uint32_t revision = state.revision;
  change_train_data(state, other_route(), here, Log{outputs->events});
  EXPECT_EQ(state.train, other_route());
  EXPECT_EQ(state.data.train_data_status, DataStatus::valid);
  EXPECT_NE(state.revision, revision);
  EXPECT_TRUE(state.radio.supervising.train_data_pending);
  EXPECT_TRUE(happened(What::train_data_valid));
}

TEST_F(TrainDataOfTheUnit, OfALongerTrainTheTrackBehindIsUnknown) {  // 3.18.3.8
  using evc::test::at;
  here.min_safe_rear = at(800.0);
  const auto known_after = [&](double longer, DataStatus status) {
    state.train.L_TRAIN = {200.0};
    state.data.train_data_status = status;
    state.track.ssp = {};
    state.track.gradient = {};
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 8}) &&
                state.track.ssp.append(at(700.0), {.V_STATIC = 28}));
    EXPECT_TRUE(state.track.gradient.append(at(0.0), {-5}));
    train::TrainData data = state.train;
    data.L_TRAIN = {200.0 + longer};
    change_train_data(state, data, here, Log{outputs->events});
    EXPECT_TRUE(state.track.ssp.covers(at(800.0), at(5000.0)) && state.track.gradient.covers(at(800.0), at(5000.0)));
    return state.track.ssp.covers(at(799.0), at(801.0)) && state.track.gradient.covers(at(799.0), at(801.0));
  };
  EXPECT_FALSE(known_after(1.0, DataStatus::valid));
  EXPECT_TRUE(known_after(0.0, DataStatus::valid));
  EXPECT_TRUE(known_after(-1.0, DataStatus::valid));
  EXPECT_TRUE(known_after(1.0, DataStatus::invalid)) << "there was no train before";
}

TEST_F(TrainDataOfTheUnit, OutOfTheirRangesAreRefused) {  // 3.18.3
  train::TrainData data;
  EXPECT_TRUE(acceptable(data, Log{outputs->events}));
  EXPECT_FALSE(happened(What::train_data_refused));
  data.L_TRAIN = {-1.0};
  EXPECT_FALSE(acceptable(data, Log{outputs->events}));
  ASSERT_TRUE(happened(What::train_data_refused));
  EXPECT_EQ(outputs->events[0].id, static_cast<std::int32_t>(train::check(data)));
}

TEST(TrainCategory, HasTheCodeOfItsCantDeficiency) {  // 7.5.1.82.1
  constexpr std::uint16_t mm[] = {80, 100, 130, 150, 165, 180, 210, 225, 245, 275, 300};
  for (std::uint8_t code = 0; code < 11; ++code) {
    train::TrainData train;
    train.cant_deficiency_mm = mm[code];
    EXPECT_EQ(category_of(train).NC_CDTRAIN, code);
    --train.cant_deficiency_mm;
    EXPECT_EQ(category_of(train).NC_CDTRAIN, code > 0 ? code - 1 : 0) << "the next lower one";
  }
}

TEST(TrainCategory, HasTheCodesOfTheTrain) {  // 7.5.1.62, 7.5.1.82, 3.12.2
  train::TrainData train;
  train.other_categories = train::kFreightP | train::kPassenger;
  train.axle_load = train::AxleLoad::D4;
  train.loading_gauge = train::LoadingGauge::GC;
  train.traction_systems.clear();
  ASSERT_TRUE(train.traction_systems.push_back({300, 1}));
  const track::TrainCategory c = category_of(train);
  EXPECT_EQ(c.NC_TRAIN, 5);
  EXPECT_EQ(c.M_AXLELOADCAT, 9);
  const track::TrainInterfaces i = interfaces_of(train);
  EXPECT_EQ(i.M_LOADINGGAUGE, 4);
  EXPECT_EQ(i.M_AXLELOADCAT, 9);
  ASSERT_EQ(i.tractions.size(), 1u);
  EXPECT_EQ(i.tractions[0].M_VOLTAGE, 1);
  EXPECT_EQ(i.tractions[0].NID_CTRACTION, 300);
}

TEST(Here, HasTheSpeedOfEitherDirection) {  // 3.13.9.3.2.1
  position::Odometry now;
  now.V_est = {10.0};
  now.V_min = {9.0};
  now.V_max = {12.0};
  now.A_est = {0.5};
  kernel::Run run = run_of(now);
  EXPECT_EQ(run.V, Speed{10.0});
  EXPECT_EQ(run.V_ura, Speed{2.0});
  EXPECT_EQ(run.A, Acceleration{0.5});
  now.V_est = {-10.0};
  now.V_min = {-13.0};
  now.V_max = {-9.0};
  run = run_of(now);
  EXPECT_EQ(run.V, Speed{10.0});
  EXPECT_EQ(run.V_ura, Speed{3.0});
  EXPECT_EQ(run.A, Acceleration{-0.5});
  now.V_est = now.V_min = now.V_max = {};
  run = run_of(now);
  EXPECT_EQ(run.V, Speed{});
  EXPECT_EQ(run.A, Acceleration{0.5}) << "it starts to move ahead";
}

TEST(Here, IsTheTrainOfTheUnit) {  // 3.6.4
  const auto memory = std::make_unique<State>();
  State& state = *memory;
  state.train.L_TRAIN = {200.0};
  state.train.L_antenna_front = {5.0};
  state.now = {77.0};
  position::Odometry o;
  o.counter = {{{1000.0}}, {{990.0}}, {{1020.0}}};
  position::update(state.position, o, state.now);
  const PlaceInterval front = position::front(state.position);
  const track::Here h = here(state);
  EXPECT_EQ(h.est_front, front.est);
  EXPECT_EQ(h.min_safe_front, front.min);
  EXPECT_EQ(h.max_safe_front, front.max);
  EXPECT_EQ(h.min_safe_rear, front.min - Distance{200.0});
  EXPECT_EQ(h.min_safe_antenna, front.min - Distance{5.0});
  EXPECT_EQ(h.now, Duration{77.0});
  EXPECT_EQ(h.standstill, position::at_standstill(state.position));
}

TEST(Here, OnlyWhatWasValidIsToBeValidatedAgain) {  // 5.4.3.3
  for (const DataStatus status : {DataStatus::unknown, DataStatus::invalid, DataStatus::valid}) {
    DataStatus after = status;
    invalidate(after);
    EXPECT_EQ(after, status == DataStatus::valid ? DataStatus::invalid : status);
    EXPECT_EQ(valid(status), status == DataStatus::valid);
  }
}

}  // namespace
}  // namespace evc::kernel
