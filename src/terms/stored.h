#pragma once
#include "terms/row.h"

namespace evc {

// clang-format off
/// What the unit remembers: the rows of 4.10.1.3.
enum class Stored : std::uint8_t {
  national_values,                // national values
  pending_national_values,        // national values that do not apply yet
  linking,                        // linking
  movement_authority,             // movement authority
  gradient,                       // gradient profile
  ssp,                            // static speed profile
  asp,                            // axle load speed profile
  stm_max_speed,                  // maximum speed of a national system
  stm_system_speed_distance,      // system speed and distance of a national system
  level_transition_order,         // level transition order, conditional order
  stop_sh_on_desk_opening,        // stop shunting on desk opening
  sh_bg_list,                     // balise groups allowed in SH
  ma_request_params,              // MA request parameters
  position_report_params,         // position report parameters
  sr_bg_list_speed_distance,      // balise groups allowed in SR; SR speed and distance from driver or trackside
  tsr,                            // temporary speed restrictions
  inhibit_revocable_tsr,          // inhibition of revocable TSRs
  default_gradient_tsr,           // default gradient for TSR
  signalling_speed,               // signalling related speed restriction
  route_suitability,              // route suitability data
  adhesion_trackside,             // adhesion factor from trackside
  adhesion_driver,                // adhesion factor from the driver
  plain_text,                     // plain texts
  fixed_text,                     // fixed texts
  geo_position,                   // geographical position
  mode_profile,                   // mode profile
  rbc_transition_order,           // RBC transition order
  radio_infill_area,              // radio infill area
  eolm,                           // end of loop marker
  track_conditions_general,       // track conditions except the next two rows
  track_conditions_horn_stopping, // sound horn, non stopping area, tunnel stopping area
  track_condition_bmm,            // big metal masses
  unconditional_stops,            // unconditional emergency stops
  conditional_stops,              // conditional emergency stops
  train_position,                 // train position
  train_data,                     // train data
  level,                          // ERTMS/ETCS level
  trackside_level_table,          // table of priority of levels from trackside
  driver_id,                      // driver identity
  radio_network_id,               // radio network identity
  rbc_id_phone,                   // RBC identity and phone number
  train_running_number,           // train running number
  reversing_area,                 // reversing area
  reversing_supervision,          // reversing supervision
  track_ahead_free_request,       // track ahead free request
  permitted_braking_distance,     // permitted braking distance
  level_crossing,                 // level crossings
  rbc_riu_version,                // system version of RBC and RIU
  operated_version,               // operated system version
  vbc,                            // virtual balise covers
  dmi_language,                   // language of the DMI
  generic_ls_marker,              // generic LS function marker
  lssma_toggle_on_order,          // LSSMA display on
  count
};

/// The names used in pages and tests.
inline constexpr auto kStoredRows = [] {
  using enum Stored;
  return std::to_array<terms::Row<Stored>>({
    {national_values,                "national_values"},
    {pending_national_values,        "pending_national_values"},
    {linking,                        "linking"},
    {movement_authority,             "movement_authority"},
    {gradient,                       "gradient"},
    {ssp,                            "ssp"},
    {asp,                            "asp"},
    {stm_max_speed,                  "stm_max_speed"},
    {stm_system_speed_distance,      "stm_system_speed_distance"},
    {level_transition_order,         "level_transition_order"},
    {stop_sh_on_desk_opening,        "stop_sh_on_desk_opening"},
    {sh_bg_list,                     "sh_bg_list"},
    {ma_request_params,              "ma_request_params"},
    {position_report_params,         "position_report_params"},
    {sr_bg_list_speed_distance,      "sr_bg_list_speed_distance"},
    {tsr,                            "tsr"},
    {inhibit_revocable_tsr,          "inhibit_revocable_tsr"},
    {default_gradient_tsr,           "default_gradient_tsr"},
    {signalling_speed,               "signalling_speed"},
    {route_suitability,              "route_suitability"},
    {adhesion_trackside,             "adhesion_trackside"},
    {adhesion_driver,                "adhesion_driver"},
    {plain_text,                     "plain_text"},
    {fixed_text,                     "fixed_text"},
    {geo_position,                   "geo_position"},
    {mode_profile,                   "mode_profile"},
    {rbc_transition_order,           "rbc_transition_order"},
    {radio_infill_area,              "radio_infill_area"},
    {eolm,                           "eolm"},
    {track_conditions_general,       "track_conditions_general"},
    {track_conditions_horn_stopping, "track_conditions_horn_stopping"},
    {track_condition_bmm,            "track_condition_bmm"},
    {unconditional_stops,            "unconditional_stops"},
    {conditional_stops,              "conditional_stops"},
    {train_position,                 "train_position"},
    {train_data,                     "train_data"},
    {level,                          "level"},
    {trackside_level_table,          "trackside_level_table"},
    {driver_id,                      "driver_id"},
    {radio_network_id,               "radio_network_id"},
    {rbc_id_phone,                   "rbc_id_phone"},
    {train_running_number,           "train_running_number"},
    {reversing_area,                 "reversing_area"},
    {reversing_supervision,          "reversing_supervision"},
    {track_ahead_free_request,       "track_ahead_free_request"},
    {permitted_braking_distance,     "permitted_braking_distance"},
    {level_crossing,                 "level_crossing"},
    {rbc_riu_version,                "rbc_riu_version"},
    {operated_version,               "operated_version"},
    {vbc,                            "vbc"},
    {dmi_language,                   "dmi_language"},
    {generic_ls_marker,              "generic_ls_marker"},
    {lssma_toggle_on_order,          "lssma_toggle_on_order"},
  });
}();
// clang-format on
static_assert(terms::in_order(kStoredRows) && kStoredRows.size() == terms::index(Stored::count));
inline constexpr std::size_t kStored = kStoredRows.size();

constexpr const char* name(Stored what) { return terms::kNames<kStoredRows>[terms::index(what)]; }

}  // namespace evc
