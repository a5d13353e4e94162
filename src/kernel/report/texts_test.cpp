#include "kernel/report/texts.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/test_units.h"
#include "kernel/driver_inputs.h"

// What the driver sees beside speed and distance: texts, selections that are possible, places (015560, 3.12.3, 3.6.6).
namespace evc::kernel {
namespace {

using evc::test::at;

class Shown : public ::testing::Test {
 protected:
  Shown() { restart(Mode::SB); }
  void restart(Mode mode) {
    state = State{};
    received = {};
    decided = {};
    inform = {};
    out = {};
    state.mode = state.previous_mode = mode;
    state.level.level = Level::L1;
    state.data.level_status = DataStatus::valid;
    state.now = {100.0};
    in.train.desk_open = true;
    decided.here.est_front = at(1000.0);
    decided.here.min_safe_rear = at(800.0);
    decided.here.standstill = true;
  }
  bool shows(StatusText text) {
    out.status_texts.clear();
    show_texts(state, desk_open, received, decided, inform, out);
    inform = {};
    for (const ShownStatus& s : out.status_texts)
      if (s.text == text) return true;
    return false;
  }
  void enabled_now() {
    out = {};
    show_enabled(state, in, decided.here, out);
  }

  std::unique_ptr<State> memory = std::make_unique<State>();
  State& state = *memory;
  Inputs in;
  Received received;
  Decided decided;
  Set<Inform> inform;
  bool desk_open = true;
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();
  Outputs& out = *outputs;
};

TEST_F(Shown, TextsOfTheTrackside) {  // 3.12.3
  track::Text plain, fixed;
  plain.id = 3;
  plain.Q_TEXTCLASS = 1;
  plain.shown_since = {90.0};
  plain.length = 2;
  plain.characters[0] = 'h';
  fixed.id = 4;
  fixed.Q_TEXT = 1;
  track::Text other = plain;
  other.id = 5;
  for (const track::Text& t : {plain, fixed, other}) ASSERT_TRUE(state.track.texts.push_back(t));
  for (const std::uint8_t id : {std::uint8_t{4}, std::uint8_t{3}}) ASSERT_TRUE(decided.texts.shown.push_back(id));
  ASSERT_TRUE(decided.texts.to_acknowledge.push_back(3));
  ASSERT_TRUE(decided.texts.to_acknowledge.push_back(5));
  show_texts(state, desk_open, received, decided, inform, out);
  ASSERT_EQ(out.texts.size(), 2u);
  EXPECT_EQ(out.texts[0].id, 4);
  EXPECT_EQ(out.texts[0].Q_TEXT, 1);
  EXPECT_FALSE(out.texts[0].important);
  EXPECT_FALSE(out.texts[0].acknowledge);
  const ShownText& t = out.texts[1];
  EXPECT_EQ(t.id, 3);
  EXPECT_TRUE(t.important);
  EXPECT_TRUE(t.acknowledge);
  EXPECT_EQ(t.since, Duration{90.0});
  EXPECT_EQ(t.length, 2);
  EXPECT_EQ(t.characters[0], 'h');
  EXPECT_EQ(t.Q_TEXT, std::nullopt);
}

TEST_F(Shown, ASelectionInTheMainWindowEndsItsTexts) {  // 015560 11.2.1, 15
  const auto ended_by = [&](Select select) {
    restart(Mode::SB);
    inform.add(Inform::SH_refused);
    EXPECT_TRUE(shows(StatusText::SH_refused));
    EXPECT_TRUE(shows(StatusText::SH_refused)) << "it stays";
    received.selected.add(select);
    return !shows(StatusText::SH_refused);
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(Select::count); ++i) {
    const auto select = static_cast<Select>(i);
    const bool main = select == Select::start || select == Select::shunting || select == Select::exit_shunting ||
                      select == Select::non_leading || select == Select::maintain_shunting ||
                      select == Select::train_data || select == Select::main || select == Select::sm ||
                      select == Select::continue_sm || select == Select::exit_sm;
    EXPECT_EQ(ended_by(select), main) << i;
  }
  restart(Mode::SB);
  inform.add(Inform::SH_refused);
  ASSERT_TRUE(shows(StatusText::SH_refused));
  received.entered.add(Entered::driver_id);
  EXPECT_FALSE(shows(StatusText::SH_refused));
}

TEST_F(Shown, ATextLasts30Seconds) {  // 015560 15
  inform.add(Inform::trackside_malfunction);
  ASSERT_TRUE(shows(StatusText::trackside_malfunction));
  ASSERT_EQ(out.status_texts.size(), 1u);
  EXPECT_EQ(out.status_texts[0].since, Duration{100.0});
  state.now = {129.9};
  EXPECT_TRUE(shows(StatusText::trackside_malfunction));
  EXPECT_EQ(out.status_texts[0].since, Duration{100.0});
  state.now = {130.0};
  EXPECT_FALSE(shows(StatusText::trackside_malfunction));
}

TEST_F(Shown, SomeTextsLastUntilTheTrainHasMoved) {  // 015560 15
  inform.add(Inform::train_data_changed);
  ASSERT_TRUE(shows(StatusText::train_data_changed));
  state.now = {200.0};
  ASSERT_TRUE(shows(StatusText::train_data_changed));
  decided.here.standstill = false;
  ASSERT_TRUE(shows(StatusText::train_data_changed));
  state.now = {231.0};
  EXPECT_FALSE(shows(StatusText::train_data_changed));
}

TEST_F(Shown, OfABrakeUntilItsCommandIsRevoked) {  // 4.12, 015560 15.1.1.6
  std::size_t revoked = 0;
  for (std::size_t i = 0; i < kModes; ++i) {
    const Mode to = static_cast<Mode>(i);
    const auto shown_after = [&](bool entered) {
      restart(Mode::FS);
      out.brake_reasons.add(Cause::linking);
      EXPECT_TRUE(shows(StatusText::balise_read_error));
      out.brake_reasons = {};
      EXPECT_TRUE(shows(StatusText::balise_read_error)) << "for 30 s";
      state.mode = to;
      decided.mode_changed = entered;
      return shows(StatusText::balise_read_error);
    };
    const bool allowed = driver::allowed(driver::Output::brake_reason, to, SrsVersion::v3_6_0);
    const bool revokes = brakes::revoked_on_mode_entry(Cause::linking, to, Mode::FS);
    EXPECT_EQ(shown_after(false), allowed) << i;
    EXPECT_EQ(shown_after(true), allowed && !revokes) << i;
    revoked += allowed && revokes ? 1u : 0u;
  }
  EXPECT_GT(revoked, 0u);
}

TEST_F(Shown, NoneWithTheDeskClosed) {  // 4.7.2
  inform.add(Inform::trackside_malfunction);
  desk_open = false;
  EXPECT_FALSE(shows(StatusText::trackside_malfunction));
}

TEST_F(Shown, AnUnknownTrackUnderTheTrain) {  // 4.4.9.1.4
  for (const Mode mode : {Mode::FS, Mode::OS, Mode::LS}) {
    restart(mode);
    ASSERT_TRUE(state.track.ssp.append(at(900.0), {.V_STATIC = 20}));
    ASSERT_TRUE(state.track.gradient.append(at(0.0), {0}));
    EXPECT_EQ(shows(StatusText::entering_FS), mode == Mode::FS);
    EXPECT_EQ(shows(StatusText::entering_OS), mode == Mode::OS);
    decided.here.min_safe_rear = at(900.0);
    EXPECT_FALSE(shows(StatusText::entering_FS) || shows(StatusText::entering_OS));
  }
}

TEST_F(Shown, ARouteThatDoesNotSuitTheTrain) {  // 3.12.2
  restart(Mode::FS);
  ASSERT_TRUE(state.track.ssp.append(at(0.0), {.V_STATIC = 20}));
  ASSERT_TRUE(state.track.gradient.append(at(0.0), {0}));
  EXPECT_FALSE(shows(StatusText::route_unsuitable_axle_load));
  state.train.axle_load = train::AxleLoad::E5;
  track::RouteSuitability item;
  item.at = at(2000.0);
  item.kind = Suitability::axle_load;
  ASSERT_TRUE(state.track.suitability.push_back(item));
  EXPECT_TRUE(shows(StatusText::route_unsuitable_axle_load));
}

TEST_F(Shown, TheReasonOfATrip) {  // 4.4.13.1.3
  restart(Mode::TR);
  driver::enter_trip(state.status_texts, 20);
  const auto reason = state.status_texts.trip_reason;
  ASSERT_TRUE(reason.has_value());
  EXPECT_TRUE(shows(*reason));
  EXPECT_EQ(out.trip_reason, reason);
}

TEST_F(Shown, LevelAndLevelsAllowed) {  // 5.10.1.7
  enabled_now();
  EXPECT_TRUE(out.level_valid);
  EXPECT_TRUE(out.levels_allowed.has(Level::L2));
  state.data.level_status = DataStatus::invalid;
  state.level_table.emplace();
  ASSERT_TRUE(state.level_table->push_back({.level = Level::L1}));
  enabled_now();
  EXPECT_FALSE(out.level_valid);
  EXPECT_TRUE(out.levels_allowed.has(Level::L1));
  EXPECT_FALSE(out.levels_allowed.has(Level::L2));
}

TEST_F(Shown, TheGeographicalPositionInItsModes) {  // 3.6.6, 4.5.2
  const auto geo_in = [&](Mode mode) {
    restart(mode);
    track::GeoReference reference;
    reference.applies_from = at(900.0);
    reference.M_POSITION = 5000;
    reference.applicable = true;
    EXPECT_TRUE(state.track.geo.push_back(reference));
    enabled_now();
    return out.geo;
  };
  EXPECT_EQ(geo_in(Mode::FS), Distance{5100.0});
  EXPECT_EQ(geo_in(Mode::SL), std::nullopt);
  state.track.geo.clear();
  state.mode = Mode::FS;
  enabled_now();
  EXPECT_EQ(out.geo, std::nullopt);
}

TEST_F(Shown, TheDistanceLeftForReversing) {  // 3.15.4
  for (const Mode mode : {Mode::RV, Mode::FS}) {
    restart(mode);
    state.track.reversing_reference = at(1000.0);
    state.track.reversing_supervision.emplace().D_REVERSE = Distance{200.0};
    enabled_now();
    EXPECT_EQ(out.rv_left, mode == Mode::RV ? std::optional(Distance{200.0}) : std::nullopt);
  }
}

TEST_F(Shown, TheSelectionsThatArePossible) {  // 4.7.2
  enabled_now();
  EXPECT_EQ(out.enabled, driver::enabled(action_context(state, in, decided.here)));
  EXPECT_FALSE(out.enabled.empty());
}

TEST_F(Shown, TheSessions) {  // 3.5.3
  enabled_now();
  EXPECT_TRUE(out.sessions.empty());
  state.radio.supervising.session.phase = radio::Phase::up;
  state.radio.supervising.session.rbc = {3, 77, 0};
  enabled_now();
  ASSERT_EQ(out.sessions.size(), 1u);
  EXPECT_EQ(out.sessions[0].NID_C, 3);
  EXPECT_EQ(out.sessions[0].NID_RBC, 77);
  EXPECT_EQ(out.sessions[0].phase, SessionPhase::up);
  EXPECT_EQ(out.sessions[0].role, SessionRole::supervising);
  state.radio.other.session.phase = radio::Phase::connecting;
  for (const bool accepts : {true, false}) {  // 3.15.1
    state.radio.other_accepts = accepts;
    enabled_now();
    ASSERT_EQ(out.sessions.size(), 2u);
    EXPECT_EQ(out.sessions[1].role, accepts ? SessionRole::accepting : SessionRole::handing_over);
  }
}

// --- what may be selected or entered, from the state of the unit

TEST_F(Shown, WhatActionsDependOn) {  // 4.7.2, 5.8.2, 5.4
  const auto context = [&] { return action_context(state, in, decided.here); };
  driver::ActionContext c = context();
  EXPECT_EQ(c.mode, Mode::SB);
  EXPECT_EQ(c.level, Level::L1);
  EXPECT_TRUE(c.desk_open);
  EXPECT_TRUE(c.standstill);
  EXPECT_FALSE(c.driver_id_valid || c.train_data_valid || c.train_running_number_valid);
  EXPECT_FALSE(c.session_open || c.train_data_acknowledged || c.non_leading_signal || c.passive_shunting_signal);
  EXPECT_FALSE(c.track_ahead_free_asked);
  EXPECT_FALSE(c.offers.has(Offer::train_data));
  state.data.level_status = DataStatus::invalid;
  EXPECT_EQ(context().level, std::nullopt);
  in.train.desk_open = false;
  EXPECT_FALSE(context().desk_open);
  decided.here.standstill = false;
  EXPECT_FALSE(context().standstill);
  state.data.driver_id_status = DataStatus::valid;
  EXPECT_TRUE(context().driver_id_valid);
  EXPECT_FALSE(context().train_data_valid);
  state.data.train_data_status = DataStatus::valid;
  EXPECT_TRUE(context().train_data_valid);
  EXPECT_FALSE(context().train_running_number_valid);
  state.data.train_running_number_status = DataStatus::valid;
  EXPECT_TRUE(context().train_running_number_valid);
  state.radio.supervising.session.phase = radio::Phase::up;
  EXPECT_TRUE(context().session_open);
  state.radio.supervising.train_data_acknowledged = true;
  EXPECT_TRUE(context().train_data_acknowledged);
  in.train.non_leading = true;
  EXPECT_TRUE(context().non_leading_signal);
  in.train.passive_shunting = true;
  EXPECT_TRUE(context().passive_shunting_signal);
  state.track_ahead_free.asking = true;
  EXPECT_TRUE(context().track_ahead_free_asked);
  state.offers.add(Offer::start);
  EXPECT_TRUE(context().offers.has(Offer::start));
  EXPECT_FALSE(context().offers.has(Offer::train_data));
  state.entries.add(Entry::train_data);
  EXPECT_TRUE(context().offers.has(Offer::train_data));
  state.requested.add(Ack::OS);
  EXPECT_TRUE(context().requests.has(Ack::OS));
}

TEST_F(Shown, WhatActionsDependOnOfTheNationalValues) {  // 5.8.2.1, A.3.2
  train::NationalValues& nv = state.national_values;
  const auto context = [&] { return action_context(state, in, decided.here); };
  nv.V_NVALLOWOVTRP = Speed{2.0};
  state.position.now.V_est = {2.0};
  EXPECT_TRUE(context().slow_enough_for_override);
  state.position.now.V_est = {2.1};
  EXPECT_FALSE(context().slow_enough_for_override);
  for (const bool value : {true, false}) {
    nv.Q_NVDRIVER_ADHES = value;
    nv.M_NVDERUN = !value;
    EXPECT_EQ(context().driver_may_change_adhesion, value);
    EXPECT_EQ(context().driver_id_while_running, !value);
  }
}

TEST_F(Shown, TheLevelsAvailable) {  // 5.10.2.4
  state.fitted_levels = {true, false, true, false, true};
  NationalSystem system;
  system.available = std::uint64_t{1} << 9;
  const modes::AvailableLevels a = available_levels(state, system);
  EXPECT_EQ(a.fitted, state.fitted_levels);
  EXPECT_EQ(a.national_systems[0], system.available);
}

}  // namespace
}  // namespace evc::kernel
