#include "modes/active_functions.h"

namespace evc::modes {
namespace {

constexpr std::array<const char*, kFunctions> kNames{"link_consistency",
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

}  // namespace

const char* name(Function function) { return kNames[static_cast<std::size_t>(function)]; }

Activity activity(Function function, Mode mode, SrsVersion srs) {
  if (srs == SrsVersion::v3_4_0) {
    if (function == Function::text_messages && mode == Mode::NL) return Activity::active;
    if (function == Function::advance_route_display) return mode == Mode::FS ? Activity::optional : Activity::inactive;
    if (function == Function::report_data_consistency_error) return Activity::inactive;
  }
  return srs_4_5_2[static_cast<std::size_t>(function)].modes[static_cast<std::size_t>(mode)];
}

}  // namespace evc::modes
