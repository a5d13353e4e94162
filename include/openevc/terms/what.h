#pragma once
#include <cstdint>

namespace evc {

/// What happened in a cycle: the kind of an event. The texts of the outputs are in texts/events.cpp, one row each.
enum class What : std::uint8_t {
  events_lost,  ///< more events than the outputs hold; replaces the last one
  odometry_not_sound,

  // Balise groups; `id` is NID_BG.
  group_accepted,  ///< its information may be used
  group_too_many_packets,
  linking_ok,                 ///< the announced group was found in its window
  linking_error_early,        ///< 3.16.2.3.1 a
  linking_error_missed,       ///< 3.16.2.3.1 b
  linking_error_later,        ///< 3.16.2.3.1 c
  group_wrong_direction,      ///< 3.16.2.3.2 [66]
  double_linking_error,       ///< 3.16.2.7.1.1
  double_repositioning,       ///< 3.16.2.7.2.2
  group_inconsistent,         ///< 3.16.2.4.1, .4, 3.16.2.5.1
  group_ignored,              ///< rejected without reaction
  telegram_covered,           ///< 3.15.9.3
  telegram_version_old,       ///< X = 0: 3.17.3.5 a
  telegram_version_new,       ///< X above the highest supported: 3.17.3.5 d, e
  telegram_against_movement,  ///< 3.14.3.6
  telegram_not_decoded,       ///< 3.16.1.1: a spare value, a broken packet, or no header
  group_capacity,             ///< something could not be stored: see the clause
  linking_capacity,
  cover_capacity,

  // Messages (`id` is NID_MESSAGE) and packets (NID_PACKET) through the filters of 4.8.
  message_accepted,
  message_buffered,  ///< waits in the transition buffer (4.8.5)
  message_refused,   ///< by a filter, or because of its contents
  message_refused_no_room,
  message_rejected,  ///< by the radio link: not consistent, or not in sequence
  message_unknown,
  message_not_sent,
  loop_accepted,  ///< `id` of these is NID_LOOP
  loop_refused,   ///< the message as a whole: not the announced loop, or not consistent
  loop_left,
  packet_accepted,
  packet_buffered,
  packet_refused,
  packet_refused_no_room,
  buffer_full,             ///< the newest set in place of the oldest of three (4.8.5.3)
  packet_kept,             ///< a level order, until another mode than SH or PS is entered (4.8.4 [7])
  packet_contact_stored,   ///< the rest of the packet is not used (4.8.4 [3], [8])
  packet_not_used,         ///< accepted, without effect: no authority beside it, no cover of it, or of another version
  packet_other_direction,  ///< ignored: not for the direction of the train
  packet_superseded,       ///< ignored: another of the same message takes its place
  packet_no_room,
  packet_shortened,
  infill_refused,  ///< `id` is NID_BG of the group that linking does not name

  // Movement authority and track description.
  authority_accepted,
  authority_refused,
  authority_timer_elapsed,
  shortening_granted,
  shortening_rejected,
  trip_ordered,
  track_description_shortened,
  track_description_ended,
  emergency_stop_accepted,  ///< `id` of these is NID_EM
  emergency_stop_place_passed,
  emergency_stop_other_direction,
  emergency_stop_unconditional,
  emergency_stop_revoked,
  level_crossing_speed,  ///< `id` is NID_LX
  targets_lost,
  no_deceleration,
  service_brake_failed,

  // Session, national values, system version.
  session_ordered,
  session_termination_ordered,
  network_missing,  ///< an order of trackside to establish a session is not executed
  session_established,
  session_lost,
  rbc_handover_ordered,  ///< `id` of these is NID_RBC of the accepting RBC
  rbc_handed_over,
  national_values_in_force,
  national_values_default,
  version_operated,  ///< `id` is the M_VERSION that is operated from now on

  // Modes, levels, procedures.
  mode_changed,  ///< `id` is the number of the condition of 4.6.3
  level_changed,
  level_changed_by_driver,
  override_active,
  override_ended,

  // The driver.
  selection_not_enabled,        ///< `id` is a Select
  entry_not_enabled,            ///< `id` is an Entered
  entry_out_of_range,           ///< the same
  acknowledgement_not_enabled,  ///< `id` is an Ack
  train_data_valid,
  train_data_refused,  ///< `id` is a train::Fault
  SR_data_out_of_range,
  train_data_changed_by_source,  ///< by another source than the driver
  train_data_to_be_validated,
  cover_set,  ///< `id` of these is the NID_VBCMK of a virtual balise cover
  cover_removed,

  cab_changed,                ///< the other cab is active: position and orientation are mirrored
  train_turned,               ///< by the direction of a supervised manoeuvre authorisation, or at its end
  consist_changed,            ///< the safe consist length, or it became available
  consist_lost,               ///< it became unavailable
  odometer_out_of_tolerance,  ///< between two groups; `id` is the NID_BG of the second
  mode_not_of_level,          ///< the stored mode and level exclude each other
  edition_incomplete,         ///< at power-up: what the edition has and the unit has not
  received_without_power,     ///< a telegram or message that nobody receives (4.5.1.4)
  count
};

}  // namespace evc
