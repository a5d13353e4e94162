#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// What the driver may do: the input rows of SUBSET-026-4 4.7.2, in their order.
enum class DriverInput : std::uint8_t {
  train_data,
  language,
  driver_id,
  train_running_number,
  level,
  adhesion,
  rbc_contact,
  integrity_confirmation,
  start,
  override_,
  shunting,
  continue_shunting,
  exit_shunting,
  non_leading,
  ack_fixed_text,
  ack_plain_text,
  ack_level,
  ack_LS,
  ack_OS,
  ack_SH,
  ack_SR,
  ack_UN,
  ack_RV,
  ack_SN,
  ack_trip,
  ack_roll_away,
  ack_reverse_movement,
  ack_standstill,
  ack_pt_distance,
  ack_train_data_change,
  ack_rv_distance,
  track_ahead_free,
  sr_speed_distance,
  vbc,
  isolation,
  radio_network_id,
  count
};

inline constexpr auto kDriverInputRows = std::to_array<terms::Row<DriverInput>>({
    {DriverInput::train_data, "train_data"},
    {DriverInput::language, "language"},
    {DriverInput::driver_id, "driver_id"},
    {DriverInput::train_running_number, "train_running_number"},
    {DriverInput::level, "level"},
    {DriverInput::adhesion, "adhesion"},
    {DriverInput::rbc_contact, "rbc_contact"},
    {DriverInput::integrity_confirmation, "integrity_confirmation"},
    {DriverInput::start, "start"},
    {DriverInput::override_, "override"},
    {DriverInput::shunting, "shunting"},
    {DriverInput::continue_shunting, "continue_shunting"},
    {DriverInput::exit_shunting, "exit_shunting"},
    {DriverInput::non_leading, "non_leading"},
    {DriverInput::ack_fixed_text, "ack_fixed_text"},
    {DriverInput::ack_plain_text, "ack_plain_text"},
    {DriverInput::ack_level, "ack_level"},
    {DriverInput::ack_LS, "ack_LS"},
    {DriverInput::ack_OS, "ack_OS"},
    {DriverInput::ack_SH, "ack_SH"},
    {DriverInput::ack_SR, "ack_SR"},
    {DriverInput::ack_UN, "ack_UN"},
    {DriverInput::ack_RV, "ack_RV"},
    {DriverInput::ack_SN, "ack_SN"},
    {DriverInput::ack_trip, "ack_trip"},
    {DriverInput::ack_roll_away, "ack_roll_away"},
    {DriverInput::ack_reverse_movement, "ack_reverse_movement"},
    {DriverInput::ack_standstill, "ack_standstill"},
    {DriverInput::ack_pt_distance, "ack_pt_distance"},
    {DriverInput::ack_train_data_change, "ack_train_data_change"},
    {DriverInput::ack_rv_distance, "ack_rv_distance"},
    {DriverInput::track_ahead_free, "track_ahead_free"},
    {DriverInput::sr_speed_distance, "sr_speed_distance"},
    {DriverInput::vbc, "vbc"},
    {DriverInput::isolation, "isolation"},
    {DriverInput::radio_network_id, "radio_network_id"},
});
static_assert(terms::in_order(kDriverInputRows) && kDriverInputRows.size() == terms::index(DriverInput::count));

/// "train_data", "ack_OS".
constexpr const char* name(DriverInput input) { return terms::kNames<kDriverInputRows>[terms::index(input)]; }

}  // namespace evc
