#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "modes/page.h"
#include "terms/mode.h"
#include "terms/srs_version.h"

namespace evc::modes {

// clang-format off
/// The functions of 4.5.2.
enum class Function : std::uint8_t {
  // data consistency
  link_consistency,              // linking consistency check (3.16.2.3 3.4.4)
  bg_msg_consistency_linked,     // BG message consistency while linking is checked (3.16.2.4.1 3.16.2.4.3)
  bg_msg_consistency_no_linking, // BG message consistency when linking not checked/available (3.16.2.4.4)
  bg_msg_consistency_unlinked,   // unlinked BG message consistency (3.16.2.5)
  radio_msg_correctness,         // correctness of radio messages (3.16.3.1.1)
  radio_sequence,                // radio message sequence check (3.16.3.3)
  safe_radio_supervision,        // safe radio link supervision (L2/3) (3.16.3.4)
  // position
  position_lrbg,                 // train position vs LRBG (3.6.1 3.6.4)
  speed_accel_standstill,        // speed, acceleration, standstill determination
  geo_position,                  // geographical position (3.6.6)
  report_standstill,             // position report: standstill reached (3.6.5.1.4 a))
  report_mode_change,            // position report: mode changed to the column mode (3.6.5.1.4 b))
  report_integrity_confirmed,    // position report: driver confirms integrity (3.6.5.1.4 c))
  report_integrity_lost,         // position report: integrity lost (3.6.5.1.4 d))
  report_rbc_border,             // position report: front/rear crosses RBC border (3.6.5.1.4 e) 3.6.5.1.4 k))
  report_level_border_rear,      // position report: rear leaves L2/3 at level border (3.6.5.1.4 f))
  report_level_change_trackside, // position report: level changed by trackside (3.6.5.1.4 g))
  report_level_change_driver,    // position report: level changed by driver (3.6.5.1.4 g))
  report_session_established,    // position report: RBC session established (3.6.5.1.4 h))
  report_data_consistency_error, // position report: data consistency error (L2/3) (3.6.5.1.4 l))
  report_rbc_requested,          // position report: as parametrised by RBC (3.6.5.1.4)
  report_every_bg,               // position report: each balise group (no params) (3.6.5.1.4 j))
  // ma
  ma_request_cyclic,             // cyclic MA request (T_MAR / T_TIMEOUTRQST), L2/3 (3.8.2.3 a) and b))
  ma_request_start,              // MA request cyclic after Start, L2/3 (4.4.11 5.4, 5.11)
  ma_request_taf,                // MA request on track-ahead-free up to L2/3 border (L0/1/NTC) (3.8.2.7.1)
  ma_request_td_deleted,         // MA request after track description deletion (3.8.2.7.3)
  determine_eoa_svl_dp,          // EOA/LOA, SvL, danger point determination (3.8.4 3.8.5)
  coop_ma_shortening,            // co-operative MA shortening (3.8.6)
  unconditional_emergency_stop,  // unconditional emergency stop handling (3.10)
  conditional_emergency_stop,    // conditional emergency stop handling (3.10)
  // mrsp
  mrsp_ssp,                      // MRSP: static speed profile (3.11.3)
  mrsp_asp,                      // MRSP: axle load profile (3.11.4)
  mrsp_tsr,                      // MRSP: temporary restrictions (3.11.5)
  mrsp_signalling,               // MRSP: signalling related limit (3.11.6)
  mrsp_mode,                     // MRSP: mode limit (3.11.7)
  mrsp_train,                    // MRSP: max train speed (3.11.8)
  mrsp_stm_max,                  // MRSP: STM max speed (3.11.2.2 g))
  mrsp_stm_system,               // MRSP: STM system speed (3.11.2.2 h))
  mrsp_lx,                       // MRSP: level crossing speed (3.12.5.6)
  mrsp_pbd,                      // MRSP: permitted-braking-distance limit (3.11.11)
  mrsp_override,                 // MRSP: override limit (5.8.3.6)
  // speed supervision
  sdm_full,                      // speed+distance monitoring with MA, gradient, RS, mode profile, LX, unsuitability (3.13 5.9.3.5 5.7.3.4 3.12.2.8 3.12.5.4)
  sdm_mrsp_only,                 // speed+distance monitoring with MRSP only (4.4.10.1)
  sdm_mrsp_sr_distance,          // speed+distance monitoring with MRSP and SR distance (4.4.11)
  csm_only,                      // ceiling speed monitoring only (4.4.8.1.1 a) 4.4.18.1.3 a))
  // movement supervision
  backward_distance,             // allowed backward distance monitoring (4.4)
  roll_away,                     // roll-away protection (3.14.2)
  reverse_movement,              // reverse movement protection (3.14.3)
  standstill_supervision,        // standstill supervision (3.14.4 4.4.7.1.5)
  supervise_sh_bg,               // SH stop info / SH BG list supervision (4.4.8.1.1 b) and c))
  supervise_sr_bg,               // SR stop info / SR BG list supervision (4.4.11.1.3 c) and d))
  supervise_trip_signal_speed,   // zero signalling speed as trip order (3.11.6.4)
  command_eb,                    // emergency brake permanently commanded (4)
  // mode level
  determine_mode,                // mode determination (3.12.4, 4.6)
  determine_level,               // level determination (5.10)
  // other
  system_version,                // system version management (3.17)
  communication_session,         // radio session management (3.5)
  delete_revoked_tsr,            // deletion of revoked TSR (3.11.5.5)
  override_trip_inhibition,      // override (trip inhibition) (5.8)
  track_cond_general,            // track conditions except horn/NSA/TSA/BMM (3.12.1)
  track_cond_horn_stopping,      // track conditions horn, non-stop, tunnel stopping (3.12.1)
  track_cond_bmm,                // track condition big metal mass (3.12.1)
  route_suitability,             // route suitability (3.12.2)
  text_messages,                 // text messages to driver (3.12.3)
  lssma_display,                 // LSSMA display management (4.4.19.1)
  rbc_handover,                  // RBC/RBC handover (3.15.1, 5.15)
  track_ahead_free,              // track ahead free request (3.15.5)
  national_fixed_values,         // fixed, default and national values (3.18.1 3.18.2)
  train_data_external_change,    // train data change by external source (5.17)
  date_time,                     // date and time (3.18.5)
  juridical,                     // juridical data output (3.20)
  inhibit_revocable_tsr,         // inhibition of revocable balise TSR (L2/3) (3.11.5.12 3.11.5.13 3.11.5.14 3.11.5.15)
  cold_movement_detection,       // cold movement detection
  continue_shunting,             // continue-shunting-on-desk-closure function (5.12.4)
  stop_sh_on_desk_opening,       // stop-shunting-on-desk-opening handling (4.4.20.1.8 4.4.20.1.9)
  virtual_balise_cover,          // virtual balise covers (3.15.9)
  advance_route_display,         // advance display of route data (3.15.10)
  count
};
// clang-format on
inline constexpr std::size_t kFunctions = static_cast<std::size_t>(Function::count);

/// The names used in pages.
inline constexpr std::array<const char*, kFunctions> kFunctionNames{"link_consistency",
                                                                    "bg_msg_consistency_linked",
                                                                    "bg_msg_consistency_no_linking",
                                                                    "bg_msg_consistency_unlinked",
                                                                    "radio_msg_correctness",
                                                                    "radio_sequence",
                                                                    "safe_radio_supervision",
                                                                    "position_lrbg",
                                                                    "speed_accel_standstill",
                                                                    "geo_position",
                                                                    "report_standstill",
                                                                    "report_mode_change",
                                                                    "report_integrity_confirmed",
                                                                    "report_integrity_lost",
                                                                    "report_rbc_border",
                                                                    "report_level_border_rear",
                                                                    "report_level_change_trackside",
                                                                    "report_level_change_driver",
                                                                    "report_session_established",
                                                                    "report_data_consistency_error",
                                                                    "report_rbc_requested",
                                                                    "report_every_bg",
                                                                    "ma_request_cyclic",
                                                                    "ma_request_start",
                                                                    "ma_request_taf",
                                                                    "ma_request_td_deleted",
                                                                    "determine_eoa_svl_dp",
                                                                    "coop_ma_shortening",
                                                                    "unconditional_emergency_stop",
                                                                    "conditional_emergency_stop",
                                                                    "mrsp_ssp",
                                                                    "mrsp_asp",
                                                                    "mrsp_tsr",
                                                                    "mrsp_signalling",
                                                                    "mrsp_mode",
                                                                    "mrsp_train",
                                                                    "mrsp_stm_max",
                                                                    "mrsp_stm_system",
                                                                    "mrsp_lx",
                                                                    "mrsp_pbd",
                                                                    "mrsp_override",
                                                                    "sdm_full",
                                                                    "sdm_mrsp_only",
                                                                    "sdm_mrsp_sr_distance",
                                                                    "csm_only",
                                                                    "backward_distance",
                                                                    "roll_away",
                                                                    "reverse_movement",
                                                                    "standstill_supervision",
                                                                    "supervise_sh_bg",
                                                                    "supervise_sr_bg",
                                                                    "supervise_trip_signal_speed",
                                                                    "command_eb",
                                                                    "determine_mode",
                                                                    "determine_level",
                                                                    "system_version",
                                                                    "communication_session",
                                                                    "delete_revoked_tsr",
                                                                    "override_trip_inhibition",
                                                                    "track_cond_general",
                                                                    "track_cond_horn_stopping",
                                                                    "track_cond_bmm",
                                                                    "route_suitability",
                                                                    "text_messages",
                                                                    "lssma_display",
                                                                    "rbc_handover",
                                                                    "track_ahead_free",
                                                                    "national_fixed_values",
                                                                    "train_data_external_change",
                                                                    "date_time",
                                                                    "juridical",
                                                                    "inhibit_revocable_tsr",
                                                                    "cold_movement_detection",
                                                                    "continue_shunting",
                                                                    "stop_sh_on_desk_opening",
                                                                    "virtual_balise_cover",
                                                                    "advance_route_display"};
/// "link_consistency".
constexpr const char* name(Function function) { return kFunctionNames[static_cast<std::size_t>(function)]; }

/// `X` active, `O` optional (not needed for interoperability; this unit has the advance display alone), `-` inactive.
enum class Activity : std::uint8_t { inactive, active, optional };

struct FunctionRow {
  Function what{};
  std::array<Activity, kModes> modes{};

  constexpr FunctionRow(Function function, std::string_view row) : what(function) {
    const auto word = page::words<kModes>(row);
    for (std::size_t i = 0; i < kModes; ++i) {
      if (word[i] == "X")
        modes[i] = Activity::active;
      else if (word[i] == "O")
        modes[i] = Activity::optional;
      else if (word[i] != "-")
        page::row_cannot_be_read();
    }
  }
};

// clang-format off
/// 4.5.2 of 3.6.0. In 3.4.0 texts are shown in NL, the route display is optional in FS and not in OS, and the report
/// on a data consistency error has no row.
inline constexpr auto srs_4_5_2 = [] {
  using enum Function;
  return std::to_array<FunctionRow>({
    //                                NP SB PS SH FS LS SR OS SL NL UN TR PT SF IS SN RV SM AD
    // data consistency
    {link_consistency,              "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - X X"},
    {bg_msg_consistency_linked,     "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - X X"},
    {bg_msg_consistency_no_linking, "-  X  X  X  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {bg_msg_consistency_unlinked,   "-  X  X  X  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {radio_msg_correctness,         "-  X  X  X  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {radio_sequence,                "-  X  X  X  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {safe_radio_supervision,        "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - X X"},
    // position
    {position_lrbg,                 "-  X  X  X  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {speed_accel_standstill,        "-  X  X  X  X  X  X  X  X  X  X  X  X  -  O  X  X X X"},
    {geo_position,                  "-  X  -  -  X  X  X  X  -  X  X  X  X  -  -  -  - X X"},
    {report_standstill,             "-  -  -  -  X  X  X  X  -  -  -  -  -  -  O  -  X X X"},
    {report_mode_change,            "-  X  -  X  X  X  X  X  X  X  X  X  X  X  O  X  X X X"},
    {report_integrity_confirmed,    "-  X  -  -  X  X  X  X  -  -  -  -  X  -  -  -  - X X"},
    {report_integrity_lost,         "-  X  -  -  X  X  X  X  -  -  -  X  X  -  -  -  X X X"},
    {report_rbc_border,             "-  -  -  -  X  X  X  X  -  -  -  X  -  -  -  -  - X X"},
    {report_level_border_rear,      "-  -  -  -  X  X  X  X  -  -  X  X  -  -  -  X  - - X"},
    {report_level_change_trackside, "-  -  -  -  X  X  X  X  -  X  -  X  -  -  -  -  - - X"},
    {report_level_change_driver,    "-  X  -  -  X  X  X  X  -  X  -  -  -  -  -  -  - - X"},
    {report_session_established,    "-  X  -  X  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {report_data_consistency_error, "-  X  -  -  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {report_rbc_requested,          "-  X  -  -  X  X  X  X  -  X  X  X  X  -  -  X  X X X"},
    {report_every_bg,               "-  -  -  -  X  X  X  X  -  X  X  X  X  -  -  X  X X X"},
    // ma
    {ma_request_cyclic,             "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - - X"},
    {ma_request_start,              "-  X  -  -  -  -  X  -  -  -  -  -  X  -  -  -  - - -"},
    {ma_request_taf,                "-  X  -  -  X  X  X  X  -  -  X  X  X  -  -  X  - - X"},
    {ma_request_td_deleted,         "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - X X"},
    {determine_eoa_svl_dp,          "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - X X"},
    {coop_ma_shortening,            "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - - X"},
    {unconditional_emergency_stop,  "-  X  -  -  X  X  X  X  -  -  -  -  X  -  -  -  - X X"},
    {conditional_emergency_stop,    "-  -  -  -  X  X  -  X  -  -  -  -  X  -  -  -  - X X"},
    // mrsp
    {mrsp_ssp,                      "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - X X"},
    {mrsp_asp,                      "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - X X"},
    {mrsp_tsr,                      "-  -  -  -  X  X  X  X  -  -  X  -  -  -  -  -  - X X"},
    {mrsp_signalling,               "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - - X"},
    {mrsp_mode,                     "-  -  -  X  -  X  X  X  -  -  X  -  -  -  -  -  X X -"},
    {mrsp_train,                    "-  -  -  -  X  X  X  X  -  -  X  -  -  -  -  -  X X X"},
    {mrsp_stm_max,                  "-  -  -  -  X  X  X  X  -  -  X  -  -  -  -  X  - - X"},
    {mrsp_stm_system,               "-  -  -  -  X  X  X  X  -  -  X  -  -  -  -  -  - - X"},
    {mrsp_lx,                       "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - X X"},
    {mrsp_pbd,                      "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - - X"},
    {mrsp_override,                 "-  -  -  X  -  -  X  -  -  -  X  -  -  -  -  -  - - -"},
    // speed supervision
    {sdm_full,                      "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - X X"},
    {sdm_mrsp_only,                 "-  -  -  -  -  -  -  -  -  -  X  -  -  -  -  -  - - -"},
    {sdm_mrsp_sr_distance,          "-  -  -  -  -  -  X  -  -  -  -  -  -  -  -  -  - - -"},
    {csm_only,                      "-  -  -  X  -  -  -  -  -  -  -  -  -  -  -  X  X - -"},
    // movement supervision
    {backward_distance,             "-  -  -  -  -  -  -  -  -  -  -  -  X  -  -  -  X - -"},
    {roll_away,                     "-  -  -  X  X  X  X  X  -  -  X  -  X  -  -  -  X X X"},
    {reverse_movement,              "-  -  -  -  X  X  X  X  -  -  -  -  X  -  -  -  X X X"},
    {standstill_supervision,        "-  X  -  -  -  -  -  -  -  -  -  -  -  -  -  -  - - -"},
    {supervise_sh_bg,               "-  -  -  X  -  -  -  -  -  -  -  -  -  -  -  -  - - -"},
    {supervise_sr_bg,               "-  -  -  -  -  -  X  -  -  -  -  -  -  -  -  -  - - -"},
    {supervise_trip_signal_speed,   "-  -  -  -  X  X  X  X  -  -  -  -  -  -  -  -  - - X"},
    {command_eb,                    "X  -  -  -  -  -  -  -  -  -  -  X  -  X  -  -  - - -"},
    // mode level
    {determine_mode,                "X  X  X  X  X  X  X  X  X  X  X  X  X  X  X  X  X X X"},
    {determine_level,               "-  X  X  X  X  X  X  X  X  X  X  X  X  -  X  X  X X X"},
    // other
    {system_version,                "-  X  X  X  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {communication_session,         "-  X  X  X  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {delete_revoked_tsr,            "-  X  -  -  X  X  X  X  -  -  X  X  X  -  -  -  - X X"},
    {override_trip_inhibition,      "-  -  -  X  -  -  X  -  -  -  X  -  -  -  -  X  - - -"},
    {track_cond_general,            "-  -  -  -  X  X  -  X  -  X  -  X  X  -  -  -  - X X"},
    {track_cond_horn_stopping,      "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - X X"},
    {track_cond_bmm,                "-  X  X  X  X  X  X  X  X  X  X  X  X  O  -  X  - X X"},
    {route_suitability,             "-  -  -  -  X  X  -  X  -  -  -  -  -  -  -  -  - - X"},
    {text_messages,                 "-  X  -  -  X  X  X  X  -  -  X  X  X  -  -  -  X X X"},
    {lssma_display,                 "-  -  -  -  -  X  -  -  -  -  -  -  -  -  -  -  - - -"},
    {rbc_handover,                  "-  -  -  -  X  X  X  X  X  X  -  X  -  -  -  -  - X X"},
    {track_ahead_free,              "-  X  -  -  -  X  X  X  -  -  -  -  X  -  -  -  - - -"},
    {national_fixed_values,         "-  X  X  X  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {train_data_external_change,    "-  X  -  -  X  X  X  X  -  -  X  X  X  -  -  X  - - X"},
    {date_time,                     "-  X  X  X  X  X  X  X  X  X  X  X  X  -  -  X  X X X"},
    {juridical,                     "-  X  X  X  X  X  X  X  X  X  X  X  X  O  O  X  X X X"},
    {inhibit_revocable_tsr,         "-  -  -  -  X  X  -  X  -  -  -  X  X  -  -  -  - X X"},
    {cold_movement_detection,       "O  -  -  -  -  -  -  -  -  -  -  -  -  -  -  -  - - -"},
    {continue_shunting,             "-  -  -  X  -  -  -  -  -  -  -  -  -  -  -  -  - - -"},
    {stop_sh_on_desk_opening,       "-  -  X  -  -  -  -  -  -  -  -  -  -  -  -  -  - - -"},
    {virtual_balise_cover,          "-  X  X  X  X  X  X  X  X  X  X  X  X  O  O  X  X X X"},
    {advance_route_display,         "-  -  -  -  X  -  -  X  -  -  -  -  -  -  -  -  - X X"},
  });
}();
// clang-format on
static_assert(srs_4_5_2.size() == kFunctions);
static_assert(
    [] {
      for (std::size_t i = 0; i < kFunctions; ++i)
        if (static_cast<std::size_t>(srs_4_5_2[i].what) != i) return false;
      return true;
    }(),
    "one row for each, in order");

/// Whether `function` is active in `mode`; optional counts as inactive. Some rows apply in levels 2 and 3 only, as
/// their names say: the caller checks the level.
constexpr bool active(Function function, Mode mode) {
  return srs_4_5_2[static_cast<std::size_t>(function)].modes[static_cast<std::size_t>(mode)] == Activity::active;
}
/// The mark itself, in the given issue.
Activity activity(Function function, Mode mode, SrsVersion srs = SrsVersion::v3_6_0);

}  // namespace evc::modes
