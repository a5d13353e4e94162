#include "kernel/intake/intake.h"

#include <gtest/gtest.h>

#include <functional>

#include "kernel/evc.h"
#include "kernel/here.h"
#include "kernel/intake/test_message.h"

// The inputs of a cycle as a whole: which of them are valid, and what time and standstill do to stored data.
namespace evc::kernel {
namespace {

using test::at;

class Cycle : public test::OneMessage {
 protected:
  Cycle() {
    state.now = {50.0};
    in.now = {50.1};
    state.data.level_status = DataStatus::valid;
  }
  const Received& run() {
    out = {};
    received = intake(state, *scratch, in, outbox, Log{out.events});
    return received;
  }
  /// Whether a cycle is valid with this change of its inputs.
  bool valid_with(const std::function<void()>& change) {
    const State before = state;
    in.odometry = {};
    in.balise_telegrams = {};
    in.now = {50.1};
    change();
    const bool valid = !run().safety_fault;
    EXPECT_EQ(happened(What::odometry_not_sound), !valid);
    state = before;
    in.balise_telegrams = {};
    return valid;
  }
};

TEST_F(Cycle, IsValidWithinTheBoundsOfItsInputs) {  // 4.4.5
  Odometry& o = in.odometry;
  const double far = 1e9, fast = 1e3, more = 1.0001;
  for (const double factor : {1.0, more}) {
    const bool valid = factor == 1.0;
    const double high = far * factor, low = -high, quick = fast * factor, back = -quick;
    EXPECT_EQ(valid_with([&] { o.max.from_origin.si = high; }), valid);
    EXPECT_EQ(valid_with([&] { o.min.from_origin.si = low; }), valid);
    EXPECT_EQ(valid_with([&] { o.V_max.si = quick; }), valid);
    EXPECT_EQ(valid_with([&] { o.V_min.si = back; }), valid);
    EXPECT_EQ(valid_with([&] { o.A_est.si = quick; }), valid);
    EXPECT_EQ(valid_with([&] { o.A_est.si = back; }), valid);
    EXPECT_EQ(valid_with([&] { in.now = {high}; }), valid);
    for (const double place : {high, low})
      EXPECT_EQ(valid_with([&] {
                  static BaliseTelegram telegram;
                  telegram.at.from_origin.si = place;
                  in.balise_telegrams = {&telegram, 1};
                }),
                valid);
  }
}

TEST_F(Cycle, IsValidWithItsInputsInOrder) {  // 4.4.5
  Odometry& o = in.odometry;
  EXPECT_TRUE(valid_with([] {})) << "all are equal";
  EXPECT_FALSE(valid_with([&] { o.min.from_origin.si = 0.1; }));
  EXPECT_FALSE(valid_with([&] { o.max.from_origin.si = -0.1; }));
  EXPECT_FALSE(valid_with([&] { o.V_min.si = 0.1; }));
  EXPECT_FALSE(valid_with([&] { o.V_max.si = -0.1; }));
  EXPECT_TRUE(valid_with([&] { in.now = {50.0}; })) << "the same moment";
  EXPECT_FALSE(valid_with([&] { in.now = {49.9}; }));
}

TEST_F(Cycle, HasTheFaultsOfPlatformAndConfiguration) {  // 4.4.5
  EXPECT_FALSE(run().safety_fault);
  in.safety_fault = true;
  EXPECT_TRUE(run().safety_fault);
  in.safety_fault = false;
  state.configuration_refused = true;
  EXPECT_TRUE(run().safety_fault);
}

TEST_F(Cycle, MemorisesAFaultInSleepingAndNonLeading) {  // 4.4.6.1.6, 4.4.15.1.5
  for (std::size_t i = 0; i < kModes; ++i) {
    const Mode mode = static_cast<Mode>(i);
    const bool memorises = mode == Mode::SL || mode == Mode::NL;
    state.mode = mode;
    state.level.level = mode == Mode::UN ? Level::L0 : mode == Mode::SN ? Level::NTC : Level::L2;
    state.safety_fault_memorised = false;
    state.radio.errors.clear();
    in.safety_fault = true;
    EXPECT_EQ(run().safety_fault, !memorises) << i;
    EXPECT_EQ(state.safety_fault_memorised, memorises) << i;
    EXPECT_EQ(state.radio.errors.size(), memorises ? 1u : 0u) << i;
    state.radio.errors.clear();
    run();
    EXPECT_TRUE(state.radio.errors.empty()) << "reported once";
    in.safety_fault = false;
    EXPECT_FALSE(run().safety_fault) << i;
    state.mode = Mode::SB;
    EXPECT_EQ(run().safety_fault, memorises) << i;
    state.mode = Mode::NP;
    EXPECT_FALSE(run().safety_fault) << "the equipment is started anew";
  }
}

TEST_F(Cycle, KeepsTimeAndPlaceOfTheLastValidOne) {  // 4.4.5
  run();
  ASSERT_EQ(state.now, Duration{50.1});
  in.now = {60.0};
  in.odometry.V_min.si = 1.0;
  run();
  EXPECT_EQ(state.now, Duration{50.1});
}

TEST_F(Cycle, HasTheOdometerOfItsInputs) {  // 3.6.4
  Odometry& o = in.odometry;
  o = {{{10.0}}, {{9.0}}, {{12.0}}, {2.0}, {1.5}, {2.75}, {0.5}};
  run();
  const position::Odometry& now = state.position.now;
  EXPECT_EQ(now.counter.nominal, o.nominal);
  EXPECT_EQ(now.counter.min, o.min);
  EXPECT_EQ(now.counter.max, o.max);
  EXPECT_EQ(now.V_est, o.V_est);
  EXPECT_EQ(now.V_min, o.V_min);
  EXPECT_EQ(now.V_max, o.V_max);
  EXPECT_EQ(now.A_est, o.A_est);
}

TEST_F(Cycle, ItsPlacesCountFromTheGroupThatWasPassedInIt) {  // 3.6.4.3
  std::array<std::uint8_t, 104> bytes{};
  BitWriter writer(bytes);
  lang::TelegramHeader header;
  header.NID_C.raw = 1;
  header.NID_BG.raw = 200;
  header.Q_LINK.raw = 1;
  lang::begin_telegram(writer, header);
  lang::end_telegram(writer, 210);
  const BaliseTelegram telegram{bytes, 210, {{100.0}}, {}};
  state.mode = Mode::SR;
  run();
  in.now = {50.2};
  in.odometry.nominal = {{100.0}};
  in.odometry.min = {{80.0}};
  in.odometry.max = {{120.0}};
  in.balise_telegrams = {&telegram, 1};
  run();
  ASSERT_TRUE(received.new_lrbg);
  EXPECT_EQ(received.here.max_safe_front, here(state).max_safe_front);
  EXPECT_LT(received.here.max_safe_front, received.here.est_front + 20.0_m);
}

TEST_F(Cycle, ItsPlacesAreThoseOfTheTrainThatWasEnteredInIt) {  // 3.18.3
  state.mode = Mode::SB;
  state.data.driver_id_status = DataStatus::valid;
  state.offers.add(Offer::train_data);
  run();
  train::TrainData data = state.train;
  data.L_TRAIN = state.train.L_TRAIN + 250.0_m;
  in.now = {60.0};  // at standstill
  in.driver.train_data = &data;
  run();
  ASSERT_EQ(state.train.L_TRAIN, data.L_TRAIN);
  EXPECT_EQ(received.here.min_safe_rear, here(state).min_safe_rear);
}

TEST_F(Cycle, ALoopMessageWithoutAHeaderIsRefused) {  // 3.16.1.1
  const LoopMessage loop;
  in.loop_messages = {&loop, 1};
  run();
  EXPECT_TRUE(happened(What::loop_refused));
}

/// An authority to 2000 m with an end section that is timed out, and linking up to 3000 m.
class Elapsing : public Cycle {
 protected:
  Elapsing() {
    track::MovementAuthority& ma = state.track.ma.emplace();
    track::Section first, second;
    first.end = second.begin = at(1000.0);
    second.end = at(2000.0);
    second.timed = true;
    second.stop = at(1000.0);
    second.timer = {Duration{10.0}, Duration{45.0}, true};
    EXPECT_TRUE(ma.sections.push_back(first));
    EXPECT_TRUE(ma.sections.push_back(second));
    EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 20}));
    EXPECT_TRUE(state.track.ssp.append(at(1500.0), {.V_STATIC = 10}));
    EXPECT_TRUE(state.track.gradient.append(at(0.0), {0}));
    for (const double place : {500.0, 1500.0, 2500.0}) {
      balise::Link link;
      link.place = at(place);
      EXPECT_TRUE(state.balise.linking.links.push_back(link));
    }
  }
};

TEST_F(Elapsing, ATimerOfTheAuthorityEndsItsSection) {  // 3.8.4.2, A.3.4 c
  run();
  EXPECT_FALSE(happened(What::authority_timer_elapsed));
  EXPECT_EQ(state.balise.linking.links.size(), 3u);
  EXPECT_FALSE(state.track_description_deleted);
  in.now = {55.2};
  run();
  EXPECT_TRUE(happened(What::authority_timer_elapsed));
  ASSERT_TRUE(state.track.ma.has_value());
  EXPECT_EQ(state.track.ma->end(), at(1000.0));
  EXPECT_EQ(state.balise.linking.links.size(), 1u) << "linking beyond is deleted";
  EXPECT_TRUE(state.track_description_deleted);
}

TEST_F(Elapsing, AReactionShortensAtStandstill) {  // A.3.4 h
  state.track.ma->sections[1].timed = false;
  state.track.ma->sections[1].timer = {};
  state.shorten_at_standstill = true;
  in.odometry.V_est = in.odometry.V_max = {5.0};
  run();
  EXPECT_FALSE(happened(What::track_description_shortened)) << "the train moves";
  EXPECT_EQ(state.balise.linking.links.size(), 3u);
  EXPECT_TRUE(state.shorten_at_standstill);
  in.odometry.V_est = in.odometry.V_max = {0.0};
  for (int i = 0; i < 40; ++i) {
    in.now += Duration{0.1};
    run();
    if (happened(What::track_description_shortened)) break;
  }
  EXPECT_TRUE(happened(What::track_description_shortened));
  EXPECT_TRUE(state.balise.linking.links.empty());
  EXPECT_FALSE(state.shorten_at_standstill);
  in.now += Duration{0.1};
  run();
  EXPECT_FALSE(happened(What::track_description_shortened)) << "once";
}

TEST(Log, TellsThatItIsFull) {
  const auto outputs = std::make_unique<Outputs>();
  const Log log{outputs->events};
  const std::size_t room = decltype(outputs->events)::capacity();
  for (std::size_t i = 0; i < room; ++i) log.note({.what = What::group_accepted});
  EXPECT_EQ(outputs->events.back().what, What::group_accepted);
  log.note({.what = What::group_accepted});
  EXPECT_EQ(outputs->events.size(), room);
  EXPECT_EQ(outputs->events.back().what, What::events_lost);
}

TEST(PowerUp, TakesItsConfiguration) {
  const auto state = std::make_unique<State>();
  const auto derived = std::make_unique<Derived>();
  Config config;
  config.srs = SrsVersion::v4_0_0;
  config.levels[static_cast<std::size_t>(Level::L3)] = false;
  config.terminals = 1;
  config.train.L_TRAIN = {321.0};
  config.L_engine = {19.0};
  config.national_values.D_NVROLL = Distance{3.5};
  derived->built = 7;
  power_up(*state, *derived, config);
  EXPECT_EQ(state->srs, config.srs);
  EXPECT_EQ(state->fitted_levels, config.levels);
  EXPECT_EQ(state->terminals, 1);
  EXPECT_EQ(state->train, config.train);
  EXPECT_EQ(state->L_engine, Distance{19.0});
  EXPECT_EQ(state->national_values.D_NVROLL, Distance{3.5});
  EXPECT_EQ(derived->built, 0u) << "the curves of before are not those of this unit";
}

TEST(PowerUp, RefusesAnEngineWithoutLength) {
  const auto state = std::make_unique<State>();
  const auto derived = std::make_unique<Derived>();
  const auto refused = [&](double L_engine) {
    Config config;
    config.L_engine = {L_engine};
    power_up(*state, *derived, config);
    return state->configuration_refused;
  };
  EXPECT_TRUE(refused(0.0));
  EXPECT_FALSE(refused(0.1));
  EXPECT_FALSE(refused(1000.0));
  EXPECT_TRUE(refused(1000.1));
}

}  // namespace
}  // namespace evc::kernel
