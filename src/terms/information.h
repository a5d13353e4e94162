#pragma once
#include "terms/row.h"

namespace evc {

// clang-format off
/// What trackside sends: the rows of the acceptance tables 4.8.3 and 4.8.4. Where the two tables divide differently
/// (level transition orders, track conditions), the finer division is used.
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
  track_conditions_general,           // track conditions except the next two rows
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
  movement_authority_sm,              // movement authority of a supervised manoeuvre authorisation (4.0.0)
  sm_refused,                         // supervised manoeuvre refused (4.0.0)
  safe_consist_length_ack,            // acknowledgement of the safe consist length (4.0.0)
  stm_max_speed,                      // maximum speed of a national system
  stm_system_speed_distance,          // system speed and distance of a national system
  count
};

/// The names used in pages and tests.
inline constexpr auto kInformationRows = [] {
  using enum Information;
  return std::to_array<terms::Row<Information>>({
    {national_values,                    "national_values"},
    {linking,                            "linking"},
    {signalling_speed,                   "signalling_speed"},
    {movement_authority,                 "movement_authority"},
    {repositioning,                      "repositioning"},
    {gradient,                           "gradient"},
    {ssp,                                "ssp"},
    {asp,                                "asp"},
    {level_transition_order,             "level_transition_order"},
    {conditional_level_transition_order, "conditional_level_transition_order"},
    {session_management,                 "session_management"},
    {radio_network_registration,         "radio_network_registration"},
    {ma_request_params,                  "ma_request_params"},
    {position_report_params,             "position_report_params"},
    {sr_authorisation,                   "sr_authorisation"},
    {stop_if_in_sr,                      "stop_if_in_sr"},
    {sr_distance_loop,                   "sr_distance_loop"},
    {tsr,                                "tsr"},
    {tsr_revocation,                     "tsr_revocation"},
    {inhibit_revocable_tsr,              "inhibit_revocable_tsr"},
    {default_gradient_tsr,               "default_gradient_tsr"},
    {route_suitability,                  "route_suitability"},
    {adhesion,                           "adhesion"},
    {plain_text,                         "plain_text"},
    {fixed_text,                         "fixed_text"},
    {geo_position,                       "geo_position"},
    {rbc_transition_order,               "rbc_transition_order"},
    {danger_for_sh,                      "danger_for_sh"},
    {stop_sh_on_desk_opening,            "stop_sh_on_desk_opening"},
    {radio_infill_area,                  "radio_infill_area"},
    {session_management_riu,             "session_management_riu"},
    {eolm,                               "eolm"},
    {coordinate_system_assignment,       "coordinate_system_assignment"},
    {infill_location_reference,          "infill_location_reference"},
    {track_conditions_general,           "track_conditions_general"},
    {track_conditions_horn_stopping,     "track_conditions_horn_stopping"},
    {track_condition_bmm,                "track_condition_bmm"},
    {location_identity,                  "location_identity"},
    {exit_trip_recognition,              "exit_trip_recognition"},
    {train_data_ack,                     "train_data_ack"},
    {ma_shortening_request,              "ma_shortening_request"},
    {unconditional_emergency_stop,       "unconditional_emergency_stop"},
    {conditional_emergency_stop,         "conditional_emergency_stop"},
    {emergency_stop_revocation,          "emergency_stop_revocation"},
    {sh_refused,                         "sh_refused"},
    {sh_authorised,                      "sh_authorised"},
    {trackside_system_version,           "trackside_system_version"},
    {system_version_order,               "system_version_order"},
    {track_ahead_free_request,           "track_ahead_free_request"},
    {train_running_number,               "train_running_number"},
    {session_initiation,                 "session_initiation"},
    {session_termination_ack,            "session_termination_ack"},
    {train_rejected,                     "train_rejected"},
    {train_accepted,                     "train_accepted"},
    {som_position_confirmed,             "som_position_confirmed"},
    {reversing_area,                     "reversing_area"},
    {reversing_supervision,              "reversing_supervision"},
    {default_balise_info,                "default_balise_info"},
    {taf_up_to_l23,                      "taf_up_to_l23"},
    {permitted_braking_distance,         "permitted_braking_distance"},
    {level_crossing,                     "level_crossing"},
    {vbc_order,                          "vbc_order"},
    {generic_ls_marker,                  "generic_ls_marker"},
    {lssma_toggle_on,                    "lssma_toggle_on"},
    {lssma_toggle_off,                   "lssma_toggle_off"},
    {external_application_data,          "external_application_data"},
    {movement_authority_sm,              "movement_authority_sm"},
    {sm_refused,                         "sm_refused"},
    {safe_consist_length_ack,            "safe_consist_length_ack"},
    {stm_max_speed,                      "stm_max_speed"},
    {stm_system_speed_distance,          "stm_system_speed_distance"},
  });
}();
// clang-format on
static_assert(terms::in_order(kInformationRows) && kInformationRows.size() == terms::index(Information::count));
inline constexpr std::size_t kInformation = kInformationRows.size();

constexpr const char* name(Information what) { return terms::kNames<kInformationRows>[terms::index(what)]; }

}  // namespace evc
