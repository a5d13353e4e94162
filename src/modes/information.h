#pragma once
#include <cstddef>
#include <cstdint>

#include "base/inplace_vector.h"

namespace evc::modes {

// clang-format off
/// The rows of the acceptance tables 4.8.3 and 4.8.4. Where the two tables cut differently (level transition
/// orders, track conditions) the finer cut is taken.
enum class Information : std::uint8_t {
  national_values,                    // national values
  linking,                            // linking
  signalling_speed,                   // signalling related speed restriction
  movement_authority,                 // movement authority with its mode profile and list of balise groups for SH
  repositioning,                      // repositioning information
  gradient,                           // gradient profile
  ssp,                                // international static speed profile
  asp,                                // axle load speed profile
  level_transition_order,             // level transition order
  conditional_level_transition_order, // conditional level transition order
  session_management,                 // session management
  radio_network_registration,         // radio network registration
  ma_request_params,                  // MA request parameters
  position_report_params,             // position report parameters
  sr_authorisation,                   // SR authorisation with its list of balise groups
  stop_if_in_sr,                      // stop if in SR
  sr_distance_loop,                   // SR distance from a loop
  tsr,                                // temporary speed restriction
  tsr_revocation,                     // temporary speed restriction revocation
  inhibit_revocable_tsr,              // inhibition of revocable TSRs from balises in level 2/3
  default_gradient_tsr,               // default gradient for TSR
  route_suitability,                  // route suitability data
  adhesion,                           // adhesion factor
  plain_text,                         // plain text
  fixed_text,                         // fixed text
  geo_position,                       // geographical position
  rbc_transition_order,               // RBC transition order
  danger_for_sh,                      // danger for shunting
  stop_sh_on_desk_opening,            // stop shunting on desk opening
  radio_infill_area,                  // radio infill area
  session_management_riu,             // session management with a radio infill unit
  eolm,                               // end of loop marker
  coordinate_system_assignment,       // assignment of coordinate system
  infill_location_reference,          // infill location reference
  track_conditions_general,           // track conditions but the next two rows
  track_conditions_horn_stopping,     // sound horn, non stopping area, tunnel stopping area
  track_condition_bmm,                // big metal masses
  location_identity,                  // identity of the balise group
  exit_trip_recognition,              // recognition of exit from trip
  train_data_ack,                     // acknowledgement of train data
  ma_shortening_request,              // request to shorten the MA
  unconditional_emergency_stop,       // unconditional emergency stop
  conditional_emergency_stop,         // conditional emergency stop
  emergency_stop_revocation,          // revocation of an emergency stop
  sh_refused,                         // shunting refused
  sh_authorised,                      // shunting authorised
  trackside_system_version,           // system version of the trackside
  system_version_order,               // system version order
  track_ahead_free_request,           // track ahead free request
  train_running_number,               // train running number from the RBC
  session_initiation,                 // initiation of a session (until 3.4.0)
  session_termination_ack,            // acknowledgement of session termination
  train_rejected,                     // train rejected
  train_accepted,                     // train accepted
  som_position_confirmed,             // position at start of mission confirmed
  reversing_area,                     // reversing area
  reversing_supervision,              // reversing supervision
  default_balise_info,                // default balise information
  taf_up_to_l23,                      // track ahead free up to the level 2/3 transition
  permitted_braking_distance,         // permitted braking distance
  level_crossing,                     // level crossing
  vbc_order,                          // virtual balise cover order
  generic_ls_marker,                  // generic LS function marker
  lssma_toggle_on,                    // LSSMA display on
  lssma_toggle_off,                   // LSSMA display off
  external_application_data,          // data for applications outside ERTMS/ETCS
  stm_max_speed,                      // maximum speed of a national system
  stm_system_speed_distance,          // system speed and distance of a national system
  count
};
// clang-format on
inline constexpr std::size_t kInformation = static_cast<std::size_t>(Information::count);

/// The name used in events ("movement_authority").
const char* name(Information information);

/// The rows that one packet or message fills.
using Informations = InplaceVector<Information, 2>;

/// The rows of packet NID_PACKET of the direction track to train. `detail` is M_TRACKCOND for packet 68 and Q_LSSMA
/// for packet 180, otherwise not used. Empty where the packet is no row of its own: 49, 63 and 80 belong to the MA,
/// SR or SH authorisation that they come with; 0, 145 and 255 act before the tables (4.8.2.2); or it is not known.
Informations information_of_packet(int NID_PACKET, int detail = 0);

/// The rows of radio message NID_MESSAGE itself, without its packets. Empty for 24 (packets only), 37 (infill) and
/// those that are not known; 3 and 33 are the movement authority.
Informations information_of_message(int NID_MESSAGE);

}  // namespace evc::modes
