#pragma once
#include <cstdint>

// NID_MESSAGE (7.5.1.89) by name. What a message holds is declared in lang/messages.
namespace evc::message {

/// From the RBC or radio infill unit (8.4.4).
enum ToTrain : std::uint8_t {
  sr_authorisation = 2,
  movement_authority = 3,
  sm_authorised = 4,
  sm_refused = 5,
  exit_from_trip_recognised = 6,
  consist_length_acknowledged = 7,
  train_data_acknowledged = 8,
  request_to_shorten_ma = 9,
  conditional_emergency_stop = 15,
  unconditional_emergency_stop = 16,
  emergency_stop_revoked = 18,
  general_message = 24,
  sh_refused = 27,
  sh_authorised = 28,
  trackside_system_version = 32,
  movement_authority_shifted = 33,
  track_ahead_free_request = 34,
  infill_movement_authority = 37,
  session_initiated_by_rbc = 38,            ///< up to 2.0
  session_establishment_acknowledged = 38,  ///< from 2.3 on
  session_termination_acknowledged = 39,
  train_rejected = 40,
  train_accepted = 41,
  som_position_confirmed = 43,
  coordinate_system_assigned = 45,
};

/// From the train (8.6).
enum ToTrack : std::uint8_t {
  validated_train_data = 129,
  request_for_shunting = 130,
  request_for_sm = 131,
  ma_request = 132,
  safe_consist_length = 133,
  position_report = 136,
  shortening_granted = 137,
  shortening_rejected = 138,
  acknowledgement = 146,
  emergency_stop_acknowledged = 147,
  track_ahead_free_granted = 149,
  end_of_mission = 150,
  radio_infill_request = 153,
  no_compatible_version = 154,
  session_initiated = 155,
  session_terminated = 156,
  som_position_report = 157,
  text_acknowledged = 158,
  session_established = 159,
};

}  // namespace evc::message
