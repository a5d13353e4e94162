#include "driver/status_texts.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "driver/driver.h"

// The start and end conditions are those of ERA_ERTMS_015560 15, Table 68.
namespace evc::driver {
namespace {

struct Cab {
  StatusTexts texts;
  StatusFacts facts;
  explicit Cab(Mode mode) { facts.mode = mode; }
  /// One cycle `after` the one before.
  void cycle(Duration after = Duration{0.1}) {
    facts.now = facts.now + after;
    step(texts, facts);
    facts.inform = {};
    facts.main_window_selection = false;
  }
  bool shows(StatusText text) const { return texts.shown.has(text); }
};

TEST(StatusTexts, RowsAreThoseOfTable68) {
  using enum StatusText;
  using enum TextEnd;
  const Set<Cause> runaway{Cause::roll_away, Cause::reverse_movement, Cause::standstill,
                           Cause::movement_while_entering_train_data, Cause::movement_while_entering_SR_data};
  const Set<Cause> balise{Cause::linking, Cause::balise_group_consistency, Cause::two_groups_missed};
  const auto caused = [](StatusText text, TextEnd end, Set<Cause> by) {
    return StatusRow{text, Output::brake_reason, end, by, {}, {}, {}};
  };
  const auto informed = [](StatusText text, Output output, TextEnd end, Inform by) {
    return StatusRow{text, output, end, {}, by, {}, {}};
  };
  const auto entered = [](StatusText text, Output output, Mode mode) {
    return StatusRow{text, output, with_its_reason, {}, {}, {}, mode};
  };
  const auto route = [](StatusText text, Suitability in) {
    return StatusRow{text, Output::route_unsuitability, with_its_reason, {}, {}, in, {}};
  };
  const std::array expected{
      caused(balise_read_error, s30_after_its_reason, balise),
      informed(StatusText::trackside_malfunction, Output::trackside_malfunction, s30, Inform::trackside_malfunction),
      caused(communication_error, s30_and_its_reason, {Cause::T_NVCONTACT}),
      entered(entering_FS, Output::entry_fs, Mode::FS),
      entered(entering_OS, Output::entry_os, Mode::OS),
      caused(runaway_movement, with_its_reason, runaway),
      informed(StatusText::SH_refused, Output::sh_refused, main_window, Inform::SH_refused),
      informed(StatusText::SH_request_failed, Output::sh_no_answer, main_window, Inform::SH_request_failed),
      informed(StatusText::trackside_not_compatible, Output::trackside_incompatible, s30,
               Inform::trackside_not_compatible),
      informed(train_is_rejected, Output::train_rejected, main_window, Inform::train_rejected),
      caused(RV_distance_exceeded, with_its_reason, {Cause::reversing_distance}),
      caused(PT_distance_exceeded, with_its_reason, {Cause::post_trip_distance}),
      route(route_unsuitable_gauge, Suitability::gauge),
      route(route_unsuitable_traction, Suitability::traction),
      route(route_unsuitable_axle_load, Suitability::axle_load),
      informed(StatusText::train_data_changed, Output::train_data_changed, s30_of_movement, Inform::train_data_changed),
      caused(StatusText::train_data_changed, with_its_reason, {Cause::train_data_changed}),
      informed(StatusText::network_registration_failed, Output::network_registration_failed, main_window,
               Inform::network_registration_failed),
      informed(national_system_not_available, Output::ntc_not_available, with_its_reason,
               Inform::national_system_not_available),
      informed(NL_no_longer_permitted, Output::nl_no_longer_permitted, acknowledged, Inform::NL_no_longer_permitted),
      informed(StatusText::odometer_impaired, Output::odometer_impaired, with_its_reason, Inform::odometer_impaired),
      entered(entering_SM, Output::entry_sm, Mode::SM),
      informed(SM_refused, Output::sm_refused, main_window, Inform::SM_refused),
      informed(SM_request_failed, Output::sm_no_answer, main_window, Inform::SM_request_failed),
      informed(consist_length_lost, Output::brake_reason, s30, Inform::consist_length_lost),
      caused(consist_length_lost, with_its_reason, {Cause::consist_length}),
  };
  ASSERT_EQ(expected.size(), srs_status_texts.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const StatusRow& row = srs_status_texts[i];
    EXPECT_EQ(row.text, expected[i].text) << i;
    EXPECT_EQ(row.output, expected[i].output) << i;
    EXPECT_EQ(row.end, expected[i].end) << i;
    EXPECT_EQ(row.brakes, expected[i].brakes) << i;
    EXPECT_EQ(row.inform, expected[i].inform) << i;
    EXPECT_EQ(row.unsuitable, expected[i].unsuitable) << i;
    EXPECT_EQ(row.entering, expected[i].entering) << i;
  }
}

TEST(StatusTexts, TheReasonOfATripIsToldUntilTripAndPostTripAreLeft) {
  Cab cab(Mode::TR);
  enter_trip(cab.texts, 42);
  cab.cycle();
  EXPECT_EQ(cab.texts.trip_reason, StatusText::SR_distance_exceeded);
  EXPECT_TRUE(cab.shows(StatusText::SR_distance_exceeded));
  cab.facts.mode = Mode::PT;
  cab.cycle(Duration{100.0});
  EXPECT_TRUE(cab.shows(StatusText::SR_distance_exceeded));
  EXPECT_EQ(cab.texts.since[static_cast<std::size_t>(StatusText::SR_distance_exceeded)], Duration{0.1});
  cab.facts.mode = Mode::SR;
  cab.cycle();
  EXPECT_TRUE(cab.texts.idle());
}

TEST(StatusTexts, ABaliseReadErrorStays30sAfterTheBrakeIsReleased) {
  for (const Cause cause : {Cause::linking, Cause::balise_group_consistency, Cause::two_groups_missed}) {
    Cab cab(Mode::FS);
    cab.facts.brakes = {cause};
    cab.cycle();
    cab.cycle(Duration{60.0});
    cab.facts.brakes = {};
    cab.cycle(Duration{29.5});
    EXPECT_TRUE(cab.shows(StatusText::balise_read_error));
    cab.cycle(Duration{1.0});
    EXPECT_FALSE(cab.shows(StatusText::balise_read_error));
  }
}

TEST(StatusTexts, ACommunicationErrorIsToldFor30sAndAsLongAsItBrakes) {
  Cab cab(Mode::FS);
  cab.facts.brakes = {Cause::T_NVCONTACT};
  cab.cycle();
  cab.facts.brakes = {};
  cab.cycle(Duration{29.5});
  EXPECT_TRUE(cab.shows(StatusText::communication_error));
  cab.cycle(Duration{1.0});
  EXPECT_FALSE(cab.shows(StatusText::communication_error));
  cab.facts.brakes = {Cause::T_NVCONTACT};
  cab.cycle();
  cab.cycle(Duration{60.0});
  EXPECT_TRUE(cab.shows(StatusText::communication_error));
  cab.facts.brakes = {};
  cab.cycle();
  EXPECT_FALSE(cab.shows(StatusText::communication_error));
}

TEST(StatusTexts, WhatIsToldOnceStays30s) {
  for (const Inform inform : {Inform::trackside_not_compatible, Inform::trackside_malfunction}) {
    Cab cab(Mode::FS);
    cab.facts.inform = {inform};
    cab.cycle();
    cab.cycle(Duration{29.5});
    EXPECT_FALSE(cab.texts.shown.empty());
    cab.cycle(Duration{1.0});
    EXPECT_TRUE(cab.texts.shown.empty());
  }
}

TEST(StatusTexts, ChangedTrainDataAreShownUntil30sAfterTheTrainMoved) {
  Cab cab(Mode::SR);
  cab.facts.inform = {Inform::train_data_changed};
  cab.cycle();
  cab.cycle(Duration{100.0});
  EXPECT_TRUE(cab.shows(StatusText::train_data_changed));
  cab.facts.moving = true;
  cab.cycle();
  cab.facts.moving = false;  // it stops again
  cab.cycle(Duration{29.5});
  EXPECT_TRUE(cab.shows(StatusText::train_data_changed));
  cab.cycle(Duration{1.0});
  EXPECT_FALSE(cab.shows(StatusText::train_data_changed));
  // Shown in motion, and shown anew.
  cab.facts.moving = true;
  cab.facts.inform = {Inform::train_data_changed};
  cab.cycle();
  cab.cycle(Duration{20.0});
  cab.facts.inform = {Inform::train_data_changed};
  cab.cycle();
  cab.cycle(Duration{29.5});
  EXPECT_TRUE(cab.shows(StatusText::train_data_changed));
  cab.cycle(Duration{1.0});
  EXPECT_FALSE(cab.shows(StatusText::train_data_changed));
}

TEST(StatusTexts, ChangedTrainDataThatBrakeAreShownUntilTheDriverHasReleasedTheBrake) {
  Cab cab(Mode::FS);
  cab.facts.moving = true;
  cab.facts.brakes = {Cause::train_data_changed};
  cab.cycle();
  cab.cycle(Duration{100.0});
  EXPECT_TRUE(cab.shows(StatusText::train_data_changed));
  cab.facts.brakes = {};
  cab.cycle();
  EXPECT_FALSE(cab.shows(StatusText::train_data_changed));
}

TEST(StatusTexts, AnAnswerIsToldUntilAButtonOfTheMainWindowIsSelected) {
  for (const Inform inform :
       {Inform::SH_refused, Inform::SH_request_failed, Inform::train_rejected, Inform::network_registration_failed}) {
    Cab cab(Mode::SB);
    cab.facts.inform = {inform};
    cab.cycle();
    cab.cycle(Duration{1000.0});
    EXPECT_FALSE(cab.texts.shown.empty()) << static_cast<int>(inform);
    cab.facts.main_window_selection = true;
    cab.cycle();
    EXPECT_TRUE(cab.texts.shown.empty()) << static_cast<int>(inform);
  }
}

TEST(StatusTexts, AnAnswerToTheSelectionOfThisCycleIsTold) {
  Cab cab(Mode::SB);
  cab.facts.inform = {Inform::network_registration_failed};
  cab.facts.main_window_selection = true;
  cab.cycle();
  EXPECT_TRUE(cab.shows(StatusText::network_registration_failed));
}

TEST(StatusTexts, EnteringFullSupervisionIsToldUntilTheTrackUnderTheTrainIsKnown) {
  Cab cab(Mode::FS);
  cab.facts.described_under_train = false;
  cab.cycle();
  EXPECT_TRUE(cab.shows(StatusText::entering_FS));
  EXPECT_FALSE(cab.shows(StatusText::entering_OS));
  cab.facts.mode = Mode::OS;
  cab.cycle();
  EXPECT_FALSE(cab.shows(StatusText::entering_FS));
  EXPECT_TRUE(cab.shows(StatusText::entering_OS));
  cab.facts.described_under_train = true;
  cab.cycle();
  EXPECT_TRUE(cab.texts.shown.empty());
}

TEST(StatusTexts, RunawayMovementIsToldUntilTheDriverHasReleasedTheBrake) {
  for (const Cause cause : {Cause::roll_away, Cause::reverse_movement, Cause::movement_while_entering_SR_data}) {
    Cab cab(Mode::SR);
    cab.facts.brakes = {cause};
    cab.cycle();
    EXPECT_TRUE(cab.shows(StatusText::runaway_movement));
    cab.facts.brakes = {};
    cab.cycle();
    EXPECT_FALSE(cab.shows(StatusText::runaway_movement));
  }
}

TEST(StatusTexts, AModeThatDoesNotShowItEndsIt) {  // 15.1.1.2
  Cab cab(Mode::SB);
  cab.facts.inform = {Inform::train_rejected};
  cab.cycle();
  EXPECT_TRUE(cab.shows(StatusText::train_is_rejected));
  cab.facts.mode = Mode::SR;
  cab.cycle();
  cab.facts.mode = Mode::SB;
  cab.cycle();
  EXPECT_FALSE(cab.shows(StatusText::train_is_rejected));
}

TEST(StatusTexts, OneTextStandsForAllItsReasons) {  // 15.1.1.7
  Cab cab(Mode::PT);
  enter_trip(cab.texts, 17);
  cab.facts.brakes = {Cause::linking};
  cab.cycle();
  cab.facts.brakes = {};
  cab.cycle(Duration{100.0});
  EXPECT_EQ(cab.texts.shown, Set<StatusText>{StatusText::balise_read_error});
}

TEST(StatusTexts, RoutesThatDoNotSuitTheTrain) {
  Cab cab(Mode::FS);
  cab.facts.unsuitable = {Suitability::gauge, Suitability::axle_load};
  cab.cycle();
  EXPECT_EQ(cab.texts.shown,
            (Set<StatusText>{StatusText::route_unsuitable_gauge, StatusText::route_unsuitable_axle_load}));
  cab.facts.unsuitable = {};
  cab.cycle();
  EXPECT_TRUE(cab.texts.shown.empty());
}

TEST(StatusTexts, EveryTextHasAStart) {
  std::set<StatusText> started;
  for (const StatusRow& row : srs_status_texts) {
    EXPECT_EQ(int{!row.brakes.empty()} + row.inform.has_value() + row.unsuitable.has_value() + row.entering.has_value(),
              1)
        << name(row.text);
    started.insert(row.text);
  }
  for (int n = 1; n < 100; ++n)
    if (const auto reason = trip_reason(n)) started.insert(*reason);
  EXPECT_EQ(started.size(), static_cast<std::size_t>(StatusText::count));
}

}  // namespace
}  // namespace evc::driver
