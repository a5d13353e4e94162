#include "kernel/stored.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "base/test_units.h"

// What becomes of data that the kernel keeps outside the track description: their rows of 4.10, applied to them. The
// table itself is compared with the standard in the room `modes`.
namespace evc::kernel {
namespace {

using evc::test::at;

/// Every datum present and valid.
void fill(State& s) {
  s = State{};
  s.pending_national_values.emplace().from = at(500.0);
  EXPECT_TRUE(s.balise.linking.links.push_back({}));
  s.radio.ma_request.emplace();
  s.reports.parameters.emplace();
  s.staff_responsible.end = at(800.0);
  s.staff_responsible.by_rbc = true;
  s.staff_responsible.V = Speed{5.0};
  s.slippery_rail = true;
  EXPECT_TRUE(s.emergency_stops.pending.push_back({1, false, {}}));
  EXPECT_TRUE(s.emergency_stops.pending.push_back({2, true, at(900.0)}));
  s.position.status = DataStatus::valid;
  EXPECT_TRUE(s.position.references.push_back({}));
  s.data.train_data_status = DataStatus::valid;
  s.data.level_status = DataStatus::valid;
  s.data.driver_id_status = DataStatus::valid;
  s.data.train_running_number_status = DataStatus::valid;
  s.radio.contact.emplace();
  s.level_table.emplace();
  s.lssma.on = true;
  protection::request(s.track_ahead_free, at(100.0), at(200.0));
}

bool stop_pending(const State& s, bool conditional) {
  for (const protection::EmergencyStop& e : s.emergency_stops.pending)
    if (e.conditional == conditional) return true;
  return false;
}

/// A datum: whether it is there, and its status where it has one.
struct Datum {
  Stored row;
  bool (*there)(const State&);
  DataStatus (*status)(const State&) = nullptr;
};
constexpr Datum kData[] = {
    {Stored::pending_national_values, [](const State& s) { return s.pending_national_values.has_value(); }},
    {Stored::linking, [](const State& s) { return !s.balise.linking.links.empty(); }},
    {Stored::ma_request_params, [](const State& s) { return s.radio.ma_request.has_value(); }},
    {Stored::position_report_params, [](const State& s) { return s.reports.parameters.has_value(); }},
    {Stored::sr_bg_list_speed_distance,
     [](const State& s) {
       const StaffResponsible& sr = s.staff_responsible;
       EXPECT_EQ(sr.end.has_value(), sr.V.has_value());
       EXPECT_EQ(sr.end.has_value(), sr.by_rbc);
       return sr.end.has_value();
     }},
    {Stored::adhesion_driver, [](const State& s) { return s.slippery_rail; }},
    {Stored::unconditional_stops, [](const State& s) { return stop_pending(s, false); }},
    {Stored::conditional_stops, [](const State& s) { return stop_pending(s, true); }},
    {Stored::train_position, [](const State& s) { return !s.position.references.empty(); },
     [](const State& s) { return s.position.status; }},
    {Stored::train_data, [](const State& s) { return s.data.train_data_status != DataStatus::unknown; },
     [](const State& s) { return s.data.train_data_status; }},
    {Stored::level, [](const State& s) { return s.data.level_status != DataStatus::unknown; },
     [](const State& s) { return s.data.level_status; }},
    {Stored::trackside_level_table, [](const State& s) { return s.level_table.has_value(); }},
    {Stored::driver_id, [](const State& s) { return s.data.driver_id_status != DataStatus::unknown; },
     [](const State& s) { return s.data.driver_id_status; }},
    {Stored::rbc_id_phone, [](const State& s) { return s.radio.contact.has_value(); }},
    {Stored::train_running_number,
     [](const State& s) { return s.data.train_running_number_status != DataStatus::unknown; },
     [](const State& s) { return s.data.train_running_number_status; }},
    {Stored::lssma_toggle_on_order, [](const State& s) { return s.lssma.on; }},
    {Stored::track_ahead_free_request, [](const State& s) { return s.track_ahead_free.from.has_value(); }},
};

/// Every datum is what the row says, and those that are kept are as they were.
template <class FateOf>
void expect_fates(const State& s, FateOf fate_of, const std::string& where) {
  using modes::Fate;
  for (const Datum& d : kData) {
    const Fate fate = fate_of(d.row);
    const std::string what = where + ", " + "row " + std::to_string(static_cast<int>(d.row));
    EXPECT_EQ(d.there(s), fate != Fate::deleted && fate != Fate::reset) << what;
    if (d.status == nullptr) continue;
    EXPECT_EQ(d.status(s), fate == Fate::deleted             ? DataStatus::unknown
                           : fate == Fate::to_be_revalidated ? DataStatus::invalid
                                                             : DataStatus::valid)
        << what;
  }
}

TEST(StoredData, AreKeptOrLostWithTheMode) {  // 4.10
  const auto state = std::make_unique<State>();
  for (std::size_t i = 0; i < kModes; ++i) {
    const Mode to = static_cast<Mode>(i);
    for (const SrsVersion srs : {SrsVersion::v3_4_0, SrsVersion::v3_6_0}) {
      const Mode from = Mode::FS;
      fill(*state);
      state->srs = srs;
      keep_for_mode(*state, to, from);
      expect_fates(
          *state, [&](Stored row) { return modes::on_entry(to, from, row, state->srs); }, "mode " + std::to_string(i));
    }
  }
}

TEST(StoredData, AreKeptOrLostWithTheLevel) {  // 4.9.1
  const auto state = std::make_unique<State>();
  for (std::size_t i = 0; i < kLevels; ++i) {
    fill(*state);
    keep_for_level(*state, static_cast<Level>(i));
    expect_fates(
        *state, [&](Stored row) { return modes::on_level_entry(static_cast<Level>(i), row); },
        "level " + std::to_string(i));
  }
}

TEST(StoredData, AreKeptOrLostWhenTheDeskIsClosed) {  // A.3.4 k
  const auto state = std::make_unique<State>();
  fill(*state);
  state->level_transition.pending.emplace();
  state->buffer.grow()->accepting = true;
  state->buffer.grow()->accepting = false;
  keep_for_closed_desk(*state);
  EXPECT_FALSE(state->level_transition.pending);
  ASSERT_EQ(state->buffer.size(), 1u) << "what waits for the change of level is deleted with the order";
  EXPECT_TRUE(state->buffer[0].accepting);
  expect_fates(
      *state, [](Stored row) { return modes::on_desk_closed_in_start_of_mission(row); }, "desk closed");
}

TEST(StoredData, AreUnknownBeforeTheirFirstEntry) {  // 3.18
  const auto state = std::make_unique<State>();
  for (const DataStatus status : {state->position.status, state->data.train_data_status, state->data.level_status,
                                  state->data.driver_id_status, state->data.train_running_number_status})
    EXPECT_EQ(status, DataStatus::unknown);
}

TEST(StoredData, AreTrustedAfterPowerOffWithoutAMovement) {  // 4.11
  const auto state = std::make_unique<State>();
  for (const std::optional<bool> moved : {std::optional<bool>{}, std::optional{true}, std::optional{false}}) {
    fill(*state);
    state->position.status = state->data.level_status = state->contact_status = DataStatus::invalid;
    revalidate_after_power_off(*state, moved);
    const DataStatus status = moved == false ? DataStatus::valid : DataStatus::invalid;
    EXPECT_EQ(state->position.status, status);
    EXPECT_EQ(state->data.level_status, status);
    EXPECT_EQ(state->contact_status, status);
    EXPECT_EQ(state->level_table.has_value(), moved == false);
    state->data.level_status = state->contact_status = DataStatus::unknown;
    revalidate_after_power_off(*state, moved);
    EXPECT_EQ(state->data.level_status, DataStatus::unknown);
    EXPECT_EQ(state->contact_status, DataStatus::unknown);
  }
}

TEST(StoredData, TheAnnouncementOfALoopIsToBeRevalidatedWithoutPower) {  // 4.10, 4.11
  const auto state = std::make_unique<State>();
  for (const std::optional<bool> moved : {std::optional<bool>{}, std::optional{true}, std::optional{false}}) {
    state->loop.emplace();
    keep_for_mode(*state, Mode::NP, Mode::FS);
    ASSERT_TRUE(state->loop);
    EXPECT_EQ(state->loop->status, DataStatus::invalid);
    revalidate_after_power_off(*state, moved);
    ASSERT_EQ(state->loop.has_value(), moved == false);
    if (state->loop) {
      EXPECT_EQ(state->loop->status, DataStatus::valid);
    }
  }
}

TEST(StoredData, TheAnnouncementOfALoopInShuntingByEdition) {  // 4.10
  const auto state = std::make_unique<State>();
  for (const SrsVersion srs : {SrsVersion::v3_4_0, SrsVersion::v3_6_0, SrsVersion::v4_0_0})
    for (const Mode mode : {Mode::SH, Mode::PS, Mode::SL}) {
      state->srs = srs;
      state->loop.emplace();
      keep_for_mode(*state, mode, Mode::SB);
      EXPECT_EQ(state->loop.has_value(), srs != SrsVersion::v4_0_0 || mode == Mode::SL);
    }
}

TEST(StoredData, WhatWasUnknownIsNotToBeValidated) {  // 4.10
  const auto state = std::make_unique<State>();
  keep_for_mode(*state, Mode::SB, Mode::FS);
  EXPECT_EQ(state->data.train_data_status, DataStatus::unknown);
  EXPECT_EQ(state->data.driver_id_status, DataStatus::unknown);
}

TEST(StoredData, OfASessionEndWithIt) {  // 4.8.5.4 c, 3.11.5.14
  const auto memory = std::make_unique<State>();
  State& s = *memory;
  const auto left = [&](bool supervising, bool other) {
    s = State{};
    s.track.revocable_tsr_inhibited = true;
    const Medium media[] = {Medium::balise, Medium::rbc, Medium::rbc};
    for (std::size_t i = 0; i < 3; ++i) {
      BufferedSet& set = *s.buffer.grow();
      set.medium = media[i];
      set.accepting = i == 2;
    }
    delete_with_sessions(s, {supervising, other});
    EXPECT_EQ(s.track.revocable_tsr_inhibited, !supervising);
    EXPECT_EQ(s.buffer[0].medium, Medium::balise);
    return s.buffer.size();
  };
  EXPECT_EQ(left(false, false), 3u);
  EXPECT_EQ(left(true, false), 2u);
  EXPECT_TRUE(s.buffer[1].accepting);
  EXPECT_EQ(left(false, true), 2u);
  EXPECT_FALSE(s.buffer[1].accepting);
}

TEST(StoredData, BeyondAPlaceAreDeleted) {  // A.3.4
  const auto state = std::make_unique<State>();
  fill(*state);
  cut_beyond(*state, at(500.0));
  EXPECT_TRUE(state->pending_national_values.has_value()) << "they begin at that place";
  cut_beyond(*state, at(499.0));
  EXPECT_FALSE(state->pending_national_values.has_value());
}

TEST(StoredData, ThatAreShortenedEndThere) {  // A.3.4
  const auto state = std::make_unique<State>();
  fill(*state);
  track::MovementAuthority ma;
  ASSERT_TRUE(ma.sections.push_back({at(0.0), at(3000.0)}));
  state->track.ma = ma;
  shorten(*state, track::Situation::h_linking_reaction, at(400.0), {});
  EXPECT_FALSE(state->pending_national_values.has_value());
}

TEST(StoredData, TheListForShuntingIsKeptInShunting) {  // A.3.4
  const auto state = std::make_unique<State>();
  for (const Mode mode : {Mode::FS, Mode::SH}) {
    state->mode = mode;
    state->track.sh_list.emplace();
    shorten(*state, track::Situation::h_linking_reaction, at(400.0), {});
    EXPECT_EQ(state->track.sh_list.has_value(), mode == Mode::SH);
  }
}

TEST(StoredData, TheNationalDistanceInSRIsFromTheEstimatedFrontEnd) {  // 4.4.11.1.3.1
  const auto state = std::make_unique<State>();
  track::Here here;
  here.est_front = at(1000.0);
  here.min_safe_front = at(900.0);
  limit_SR_distance(*state, here);
  EXPECT_EQ(state->staff_responsible.end, std::nullopt) << "infinite by default (A.3.2)";
  state->national_values.D_NVSTFF = Distance{300.0};
  limit_SR_distance(*state, here);
  EXPECT_EQ(state->staff_responsible.end, at(1300.0));
  state->national_values.D_NVSTFF.reset();
  follow_national_SR_distance(*state);
  EXPECT_EQ(state->staff_responsible.end, std::nullopt);
  set_SR_distance(*state, here, Distance{500.0});
  state->national_values.D_NVSTFF = Distance{300.0};
  follow_national_SR_distance(*state);
  EXPECT_EQ(state->staff_responsible.end, at(1500.0)) << "that of the RBC or the driver";
}

}  // namespace
}  // namespace evc::kernel
