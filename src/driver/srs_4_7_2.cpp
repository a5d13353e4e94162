#include "driver/srs_4_7_2.h"

namespace evc::driver {
namespace {

constexpr std::array<const char*, kInputs> kInputNames{"train_data",
                                                       "language",
                                                       "driver_id",
                                                       "train_running_number",
                                                       "level",
                                                       "adhesion",
                                                       "rbc_contact",
                                                       "integrity_confirmation",
                                                       "start",
                                                       "override",
                                                       "shunting",
                                                       "continue_shunting",
                                                       "exit_shunting",
                                                       "non_leading",
                                                       "ack_fixed_text",
                                                       "ack_plain_text",
                                                       "ack_level",
                                                       "ack_LS",
                                                       "ack_OS",
                                                       "ack_SH",
                                                       "ack_SR",
                                                       "ack_UN",
                                                       "ack_RV",
                                                       "ack_SN",
                                                       "ack_trip",
                                                       "ack_roll_away",
                                                       "ack_reverse_movement",
                                                       "ack_standstill",
                                                       "ack_pt_distance",
                                                       "ack_train_data_change",
                                                       "ack_rv_distance",
                                                       "track_ahead_free",
                                                       "sr_speed_distance",
                                                       "vbc",
                                                       "isolation",
                                                       "radio_network_id"};

constexpr std::array<const char*, kOutputs> kOutputNames{"mode",
                                                         "level",
                                                         "train_speed",
                                                         "permitted_speed",
                                                         "sbi_speed",
                                                         "target_speed",
                                                         "target_distance",
                                                         "release_speed",
                                                         "lssma",
                                                         "monitoring_status",
                                                         "trip_reason",
                                                         "train_data",
                                                         "driver_id",
                                                         "train_running_number",
                                                         "rbc_contact",
                                                         "vbc",
                                                         "brake_indication",
                                                         "fixed_text",
                                                         "plain_text",
                                                         "reversing_allowed",
                                                         "track_cond_general",
                                                         "track_cond_horn_stopping",
                                                         "geo_position",
                                                         "override_status",
                                                         "lx_not_protected",
                                                         "sh_refused",
                                                         "sh_no_answer",
                                                         "level_announcement",
                                                         "taf_request",
                                                         "slippery_rail",
                                                         "trackside_malfunction",
                                                         "train_data_changed",
                                                         "operated_version",
                                                         "network_registration_failed",
                                                         "radio_link_status",
                                                         "local_time",
                                                         "gradient",
                                                         "mrsp",
                                                         "brake_reason",
                                                         "trackside_incompatible",
                                                         "train_rejected",
                                                         "route_unsuitability",
                                                         "radio_network_id",
                                                         "time_to_indication",
                                                         "entry_fs",
                                                         "entry_os",
                                                         "first_indication_location",
                                                         "eoa_loa",
                                                         "set_speed",
                                                         "ntc_not_available",
                                                         "ntc_data_need",
                                                         "ntc_failed"};

template <class Rows>
constexpr bool in_order(const Rows& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].what) != i) return false;
  return true;
}
static_assert(in_order(srs_4_7_2_inputs) && in_order(srs_4_7_2_outputs), "one row for each, in order");

}  // namespace

const char* name(Input input) { return kInputNames[static_cast<std::size_t>(input)]; }
const char* name(Output output) { return kOutputNames[static_cast<std::size_t>(output)]; }

}  // namespace evc::driver
