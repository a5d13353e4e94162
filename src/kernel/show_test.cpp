#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "base/test_units.h"
#include "kernel/basis.h"
#include "kernel/curves.h"
#include "kernel/evc.h"
#include "kernel/state.h"

// The record of the display. A journey with it is in tests/scenarios/dmi.scenario.
namespace evc::kernel {
namespace {

using evc::test::at;
using evc::test::kmh;

/// A unit after a cycle in a mode, with an open desk.
class Show : public ::testing::Test {
 protected:
  Show() {
    state.mode = outputs->mode = Mode::FS;
    state.desk_was_open = true;
    state.position.now.counter = {{{1000.0}}, {{990.0}}, {{1010.0}}};
    state.data.level_status = DataStatus::valid;
    outputs->level = state.level.level = Level::L2;
    outputs->level_valid = true;
  }
  const Display& shown() {
    show(state, *derived, *outputs, *display);
    return *display;
  }
  void in(Mode mode) { state.mode = outputs->mode = mode; }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  std::unique_ptr<Derived> derived = std::make_unique<Derived>();
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
  std::unique_ptr<Display> display = std::make_unique<Display>();
};

TEST_F(Show, WhatWasShownBeforeIsGone) {
  outputs->V_P = kmh(100.0);
  (void)outputs->texts.push_back({});
  (void)state.displayed.acks.push_back({.what = Ack::OS});
  state.displayed.level_crossing = 4;
  EXPECT_EQ(shown().V_P, kmh(100.0));
  EXPECT_EQ(shown().acks.size(), 1u);
  EXPECT_EQ(shown().texts.size(), 1u);
  EXPECT_EQ(shown().conditions.size(), 1u);
  *outputs = {};
  in(Mode::FS);
  state.displayed = {};
  EXPECT_FALSE(shown().V_P);
  EXPECT_TRUE(shown().acks.empty());
  EXPECT_TRUE(shown().texts.empty());
  EXPECT_TRUE(shown().conditions.empty());
}

TEST_F(Show, WithAClosedDeskOnlyTheFailureAndTheIsolationAreTold) {
  state.desk_was_open = false;
  outputs->V_P = kmh(100.0);
  outputs->v = kmh(90.0);
  for (std::size_t m = 0; m < kModesOf3; ++m) {
    const Mode mode = static_cast<Mode>(m);
    in(mode);
    const bool told = mode == Mode::SF || mode == Mode::IS;
    EXPECT_EQ(shown().mode, told ? mode : Mode::NP) << name(mode);
    EXPECT_FALSE(shown().V_P) << name(mode);
    EXPECT_TRUE(shown().buttons.empty() && shown().texts.empty() && !shown().level_valid) << name(mode);
    EXPECT_TRUE(told || shown().v == Speed{}) << name(mode);
  }
}

TEST_F(Show, TheConfigurationOfTheHostStays) {
  display->config.languages.clear();
  (void)display->config.languages.push_back({});
  display->config.D_sr.most = 5000.0;
  (void)state.displayed.ntc_names.push_back({.nid_ntc = 7});
  state.srs = SrsVersion::v3_4_0;
  const port::DisplayConfig& config = shown().config;
  EXPECT_EQ(config.languages.size(), 1u);
  EXPECT_EQ(config.D_sr.most, 5000.0);
  EXPECT_EQ(config.ntc_names.size(), 1u);
  EXPECT_EQ(config.srs, SrsVersion::v3_4_0);
  EXPECT_TRUE(config.gsmr_fitted);
  EXPECT_FALSE(config.frmcs_fitted);
}

TEST_F(Show, TheDialIsThatOfTheConfiguration) {
  const struct {
    double kmh;
    port::Dial dial;
  } cases[] = {
      {140, port::Dial::to_140}, {180, port::Dial::to_180}, {250, port::Dial::to_250}, {400, port::Dial::to_400}};
  for (const auto& one : cases) {
    state.dial = kmh(one.kmh);
    EXPECT_EQ(shown().config.dial, one.dial) << one.kmh;
  }
}

TEST_F(Show, ABrakeForAMissingAcknowledgementIsToldFromOthers) {
  outputs->shown.add(DriverOutput::brake_indication);
  outputs->brake_reasons = {Cause::OS_unacknowledged, Cause::text_service};
  EXPECT_TRUE(shown().brake);
  EXPECT_TRUE(shown().brake_for_missing_ack);
  outputs->brake_reasons.add(Cause::linking);
  EXPECT_TRUE(shown().brake);
  EXPECT_FALSE(shown().brake_for_missing_ack);
  outputs->brake_reasons = {Cause::text_service};
  outputs->shown = {};
  EXPECT_FALSE(shown().brake_for_missing_ack);
}

TEST_F(Show, TheAnnouncedLevelIsThatOfTheTransition) {
  EXPECT_FALSE(shown().announced_level);
  state.level_transition.pending.emplace();
  state.level_transition.pending->to = {.level = Level::NTC, .nid_ntc = 6};
  ASSERT_TRUE(shown().announced_level);
  EXPECT_EQ(shown().announced_level->level, Level::NTC);
  EXPECT_EQ(shown().announced_level->nid_ntc, 6);
  in(Mode::SH);
  EXPECT_FALSE(shown().announced_level) << "4.7.2";
  // After the transition, until it is acknowledged.
  in(Mode::FS);
  state.level_transition.pending.reset();
  outputs->requests.add(Ack::level);
  ASSERT_TRUE(shown().announced_level);
  EXPECT_EQ(shown().announced_level->level, Level::L2);
}

TEST_F(Show, ConditionsAreInTheOrderOfTheirNumbersAndATunnelHasItsOwnPlace) {
  const auto add = [this](TrackConditionKind kind, ConditionPhase phase, std::uint16_t id) {
    track::TrackCondition c;
    c.kind = kind;
    c.from = at(1200.0);
    c.to = at(1500.0);
    c.progress.phase = phase;
    c.progress.shown_as = id;
    (void)state.track.conditions.push_back(c);
  };
  add(TrackConditionKind::air_tightness, ConditionPhase::announced, 1);
  add(TrackConditionKind::powerless_lower_pantograph, ConditionPhase::active, 65534);
  add(TrackConditionKind::radio_hole, ConditionPhase::active, 0);
  add(TrackConditionKind::tunnel_stopping_area, ConditionPhase::announced, 65535);
  state.displayed.level_crossing = 2;
  ASSERT_EQ(shown().conditions.size(), 3u);
  EXPECT_EQ(shown().conditions[0].picture, Picture::TC01) << "the numbers begin again";
  EXPECT_EQ(shown().conditions[1].picture, Picture::TC21);
  EXPECT_EQ(shown().conditions[2].picture, Picture::LX01);
  EXPECT_EQ(shown().conditions[1].id, 1);
  ASSERT_TRUE(shown().tunnel);
  EXPECT_FALSE(shown().tunnel->inside);
  EXPECT_EQ(shown().tunnel->distance, 200_m);
  state.track.conditions[3].progress.phase = ConditionPhase::active;
  EXPECT_TRUE(shown().tunnel->inside);
}

TEST_F(Show, NumbersOfConditionsAreNeverZero) {
  Displayed displayed;
  displayed.last_condition = 65534;
  EXPECT_EQ(displayed.next_condition(), 65535);
  EXPECT_EQ(displayed.next_condition(), 1);
}

TEST_F(Show, TextsHaveTheLocalTimeOfTheirBegin) {
  outputs->now = Duration{100.0};
  ShownText text;
  text.since = Duration{40.0};
  (void)outputs->texts.push_back(text);
  (void)outputs->status_texts.push_back({StatusText::trackside_malfunction, Duration{100.0}});
  ASSERT_EQ(shown().texts.size(), 2u);
  EXPECT_FALSE(shown().texts[0].minute_of_day);
  outputs->clock = DateTime{86400 * 5 + 30, 0};  // half a minute after midnight
  EXPECT_EQ(shown().second_of_day, 30u);
  EXPECT_EQ(shown().texts[0].minute_of_day, 23 * 60 + 59);
  EXPECT_EQ(shown().texts[1].minute_of_day, 0);
  outputs->clock->local_offset_min = -60;
  EXPECT_EQ(shown().second_of_day, 23u * 3600 + 30);
}

TEST_F(Show, TextsOfTheUnitNameTheNationalSystem) {
  outputs->national_system = 6;
  (void)outputs->status_texts.push_back({StatusText::national_system_not_available, {}});
  (void)outputs->status_texts.push_back({StatusText::NL_no_longer_permitted, {}});
  EXPECT_EQ(shown().texts[0].nid_ntc, 6);
  EXPECT_FALSE(shown().texts[0].acknowledge);
  EXPECT_EQ(shown().texts[1].id, kFirstStatusId + terms::index(StatusText::NL_no_longer_permitted));
  EXPECT_TRUE(shown().texts[1].acknowledge);
  EXPECT_TRUE(shown().texts[1].important);
}

TEST_F(Show, NationalSystemsAreThoseOfTheTableThatThereAre) {
  state.displayed.national_systems = (1u << 3) | (1u << 6);
  outputs->levels_allowed = {Level::L1, Level::NTC};
  ASSERT_EQ(shown().data.ntcs.size(), 2u);
  EXPECT_EQ(shown().data.ntcs[1], 6);
  EXPECT_EQ(shown().data.levels, 1u << terms::index(Level::L1) | 1u << terms::index(Level::NTC));
  state.level_table.emplace();
  for (const std::uint8_t nid_ntc : {std::uint8_t{9}, std::uint8_t{6}, std::uint8_t{200}})
    (void)state.level_table->push_back({.level = Level::NTC, .nid_ntc = nid_ntc});
  ASSERT_EQ(shown().data.ntcs.size(), 1u);
  EXPECT_EQ(shown().data.ntcs[0], 6);
  outputs->levels_allowed = {Level::L1};
  EXPECT_TRUE(shown().data.ntcs.empty());
}

TEST_F(Show, WhatIsWaitedForIsToldByTheStep) {
  const struct {
    Dialogue step;
    port::Waiting waiting;
  } cases[] = {{Dialogue::start_S0, port::Waiting::end_of_session},
               {Dialogue::start_D31, port::Waiting::session},
               {Dialogue::start_D33, port::Waiting::train_accepted},
               {Dialogue::start_A40, port::Waiting::end_of_session},
               {Dialogue::start_S11, port::Waiting::train_data_acknowledged},
               {Dialogue::start_S20, port::Waiting::nothing},
               {Dialogue::start_S21, port::Waiting::answer_to_ma_request},
               {Dialogue::trip_S150, port::Waiting::answer_to_ma_request},
               {Dialogue::shunting_S050, port::Waiting::answer_to_sh_request}};
  in(Mode::SB);
  EXPECT_EQ(shown().waiting, port::Waiting::nothing);
  EXPECT_FALSE(shown().start_of_mission);
  for (const auto& one : cases) {
    outputs->dialogue = ShownDialogue{one.step, std::nullopt};
    EXPECT_EQ(shown().waiting, one.waiting);
    EXPECT_EQ(shown().step, one.step);
    EXPECT_EQ(shown().start_of_mission, one.step < Dialogue::start_S10);
  }
}

// 015560 11.7.2 S3-2-3, 11.7.3 S5-2-3: for the network that the driver chose, at standstill. A registration that
// trackside orders while the train runs closes no menu.
TEST_F(Show, OnlyTheDriverWhoChoseANetworkWaitsForIt) {
  state.position.started = true;
  state.position.time = Duration{100.0};
  state.position.rest_since = Duration{50.0};
  state.network.awaited = true;
  EXPECT_EQ(shown().waiting, port::Waiting::nothing);
  state.network.by_driver = true;
  EXPECT_EQ(shown().waiting, port::Waiting::radio_registration);
  state.position.rest_since = state.position.time;  // it runs
  EXPECT_EQ(shown().waiting, port::Waiting::nothing);
  state.network.awaited = false;
  EXPECT_EQ(shown().waiting, port::Waiting::nothing);
}

// 015560 11.7.2 S3-2-1, 11.7.3 S5-2-1: the list is there when the sessions that the request for it ends have ended; a
// network that was entered before that is registered when they have.
TEST_F(Show, TheDriverWaitsForTheListOfNetworks) {
  state.position.started = true;
  state.position.time = Duration{100.0};
  state.position.rest_since = Duration{50.0};
  state.network.by_driver = true;
  EXPECT_EQ(shown().waiting, port::Waiting::network_list);
  state.radio.session(radio::Peer::supervising).registers_after = std::uint8_t{1};
  EXPECT_EQ(shown().waiting, port::Waiting::radio_registration);
  state.network.by_driver = false;
  EXPECT_EQ(shown().waiting, port::Waiting::nothing);
}

TEST_F(Show, ABrakePercentageIsAskedForWithTheConversionModel) {
  EXPECT_TRUE(shown().config.asks_brake_percentage);
  state.train.brake_model = train::BrakeModel::gamma;
  EXPECT_FALSE(shown().config.asks_brake_percentage);
}

TEST_F(Show, TheSelectorOfAutomaticOperationIsShownIn400) {
  state.displayed.ato_active = true;
  EXPECT_FALSE(shown().ato.on);
  state.srs = SrsVersion::v4_0_0;
  EXPECT_TRUE(shown().ato.on);
}

TEST_F(Show, EveryConditionThatIsStoredHasARow) {
  std::uint16_t id = 0;
  for (auto* c = state.track.conditions.grow(); c != nullptr; c = state.track.conditions.grow()) {
    c->kind = TrackConditionKind::sound_horn;
    c->progress = {ConditionPhase::active, ++id, {}};
  }
  state.track.traction.emplace();
  state.track.traction->M_VOLTAGE = 1;
  state.track.traction->progress = {ConditionPhase::active, ++id, {}};
  state.displayed.level_crossing = ++id;
  ASSERT_EQ(shown().conditions.size(), id);
  EXPECT_EQ(shown().conditions.back().id, id);
}

/// 015560 8.3.4.22: the announcement of 15 s at this speed lies in rear of the start (5.18.2.2), and is no order any
/// more once it was shown, whatever the speed. What ends is shown at its end.
TEST_F(Show, OrdersStandWhereTheirSymbolsWillAppear) {
  state.train.L_TRAIN = 100_m;
  state.train.V_MAXTRAIN = kmh(140.0);
  state.basis.number = 1;
  state.basis.min_safe_rear = at(890.0);
  state.basis.authority.EOA = state.basis.authority.SvL = at(4000.0);
  EXPECT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 28}));
  EXPECT_TRUE(state.track.gradient.append(at(0.0), {0}));
  build(derived->in_force, state, {}, state.basis);
  derived->built = state.basis.number;
  ASSERT_TRUE(
      state.track.conditions.push_back({at(2000.0), at(2500.0), TrackConditionKind::powerless_lower_pantograph}));
  ASSERT_TRUE(state.track.conditions.push_back({at(1800.0), at(1900.0), TrackConditionKind::radio_hole}));
  const auto orders = [&] {
    std::vector<std::pair<Picture, double>> all;
    for (const port::PlannedOrder& order : shown().orders) all.emplace_back(order.picture, order.at.si);
    return all;
  };
  using Orders = std::vector<std::pair<Picture, double>>;
  outputs->v = kmh(72.0);
  // From the max safe front end at 1010 m, 300 m before the start; from the min safe front end at 990 m.
  EXPECT_EQ(orders(), (Orders{{Picture::PL02, 690.0}, {Picture::PL10, 790.0}, {Picture::PL04, 1510.0}}));
  outputs->v = Speed{};
  EXPECT_EQ(orders(), (Orders{{Picture::PL10, 790.0}, {Picture::PL02, 990.0}, {Picture::PL04, 1510.0}}));
  state.track.conditions[0].progress.phase = ConditionPhase::announced;
  EXPECT_EQ(orders(), (Orders{{Picture::PL10, 790.0}, {Picture::PL04, 1510.0}}));
  // Of two alike that begin at one place each stands by its own phase.
  ASSERT_TRUE(
      state.track.conditions.push_back({at(2000.0), at(2600.0), TrackConditionKind::powerless_lower_pantograph}));
  EXPECT_EQ(orders(),
            (Orders{{Picture::PL10, 790.0}, {Picture::PL02, 990.0}, {Picture::PL04, 1510.0}, {Picture::PL04, 1610.0}}));
}

TEST_F(Show, InReversingTheDistanceIsThatLeftToRun) {
  outputs->d_target = 100_m;
  outputs->rv_left = 50_m;
  EXPECT_EQ(shown().d_target, 100_m);
  in(Mode::RV);
  EXPECT_EQ(shown().d_target, 50_m);
}

TEST_F(Show, ButtonsDoNotDependOnWhatIsToBeAcknowledged) {
  in(Mode::SR);
  state.data.driver_id_status = DataStatus::valid;
  outputs->enabled = {DriverInput::isolation};
  state.requested.add(Ack::OS);
  EXPECT_TRUE(shown().buttons.has(Button::train_running_number));
  EXPECT_TRUE(shown().enabled == Set<DriverInput>{DriverInput::isolation});
}

TEST_F(Show, BackwardsTheSpeedIsAnAmount) {
  in(Mode::RV);
  outputs->v = Speed{} - kmh(20.0);
  EXPECT_EQ(shown().v, kmh(20.0));
}

TEST_F(Show, AnInhibitedAlarmIsShown) {
  EXPECT_FALSE(shown().bmm_inhibited);
  outputs->shown.add(DriverOutput::bmm_inhibition);
  EXPECT_TRUE(shown().bmm_inhibited);
}

}  // namespace
}  // namespace evc::kernel
