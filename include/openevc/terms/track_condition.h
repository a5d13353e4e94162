#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The kinds of track condition that packet 68 orders (3.12.1).
enum class TrackConditionKind : std::uint8_t {
  non_stopping_area,
  tunnel_stopping_area,
  sound_horn,
  powerless_lower_pantograph,
  radio_hole,
  air_tightness,
  switch_off_regenerative_brake,
  switch_off_eddy_current_service_brake,
  switch_off_magnetic_shoe_brake,
  powerless_main_switch_off,
  switch_off_eddy_current_emergency_brake,
};

// clang-format off
/// Code: M_TRACKCOND (7.5.1.77).
inline constexpr auto kTrackConditionRows = [] {
  using enum TrackConditionKind;
  return std::to_array<terms::WireRow<TrackConditionKind>>({
    {non_stopping_area,                       0,  "non stopping area"},
    {tunnel_stopping_area,                    1,  "tunnel stopping area"},
    {sound_horn,                              2,  "sound horn"},
    {powerless_lower_pantograph,              3,  "powerless section, lower pantograph"},
    {radio_hole,                              4,  "radio hole"},
    {air_tightness,                           5,  "air tightness"},
    {switch_off_regenerative_brake,           6,  "switch off regenerative brake"},
    {switch_off_eddy_current_service_brake,   7,  "switch off eddy current brake for service brake"},
    {switch_off_magnetic_shoe_brake,          8,  "switch off magnetic shoe brake"},
    {powerless_main_switch_off,               9,  "powerless section, switch off main power switch"},
    {switch_off_eddy_current_emergency_brake, 10, "switch off eddy current brake for emergency brake"},
  });
}();
// clang-format on
static_assert(terms::in_order(kTrackConditionRows));

/// The kind of a code of M_TRACKCOND; none for a spare code.
constexpr std::optional<TrackConditionKind> track_condition_of(std::uint64_t M_TRACKCOND) {
  return terms::of_code<TrackConditionKind, kTrackConditionRows>(M_TRACKCOND);
}

/// Track conditions that the train executes by itself, so that they are announced and the driver is not asked to act
/// (5.18.2.2.2 and others).
struct ByTrain {
  std::array<bool, kTrackConditionRows.size()> conditions{};  ///< by kind
  bool traction_system = false;                               ///< its change (5.18.10.4)
};
/// Whether the train may execute it by itself: pantograph, main switch, air intake, special brakes.
constexpr bool may_be_by_train(TrackConditionKind kind) {
  using enum TrackConditionKind;
  return kind == powerless_lower_pantograph || kind == powerless_main_switch_off || kind == air_tightness ||
         kind == switch_off_regenerative_brake || kind == switch_off_eddy_current_service_brake ||
         kind == switch_off_magnetic_shoe_brake || kind == switch_off_eddy_current_emergency_brake;
}

/// Non stopping area, tunnel stopping area, sound horn: a row of their own in 4.8.3, 4.8.4 and 4.10.1.3.
constexpr bool horn_or_stopping(TrackConditionKind kind) {
  return kind == TrackConditionKind::non_stopping_area || kind == TrackConditionKind::tunnel_stopping_area ||
         kind == TrackConditionKind::sound_horn;
}

/// How far a track condition has come for driver and train (5.18, 5.20); a step is not taken back (A.3.5.1).
enum class ConditionPhase : std::uint8_t {
  ahead,      ///< not shown yet
  announced,  ///< from point C on
  active,     ///< from point D on
  ending,     ///< from point E on: what it asked for is to be undone
  over
};

inline constexpr auto kConditionPhaseRows = std::to_array<terms::Row<ConditionPhase>>({
    {ConditionPhase::ahead, "ahead"},
    {ConditionPhase::announced, "announced"},
    {ConditionPhase::active, "active"},
    {ConditionPhase::ending, "ending"},
    {ConditionPhase::over, "over"},
});
static_assert(terms::in_order(kConditionPhaseRows));

/// What has to fit the train on the route (3.12.2).
enum class Suitability : std::uint8_t { gauge, axle_load, traction };

/// Code: Q_SUITABILITY (7.5.1.135).
inline constexpr auto kSuitabilityRows = std::to_array<terms::WireRow<Suitability>>({
    {Suitability::gauge, 0, "loading gauge"},
    {Suitability::axle_load, 1, "axle load"},
    {Suitability::traction, 2, "traction system"},
});
static_assert(terms::in_order(kSuitabilityRows));

/// The kind of a code of Q_SUITABILITY; none for a spare code.
constexpr std::optional<Suitability> suitability_of(std::uint64_t Q_SUITABILITY) {
  return terms::of_code<Suitability, kSuitabilityRows>(Q_SUITABILITY);
}

}  // namespace evc
