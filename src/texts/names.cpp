#include "texts/texts.h"

namespace evc::texts {
namespace {

constexpr std::array<const char*, static_cast<std::size_t>(train::Fault::count)> kFaultNames{"none",
                                                                                             "brake_percentage",
                                                                                             "train_length_lambda",
                                                                                             "maximum_speed_lambda",
                                                                                             "train_length",
                                                                                             "maximum_speed",
                                                                                             "traction_cut_off_time",
                                                                                             "antenna",
                                                                                             "rotating_mass",
                                                                                             "no_emergency_model",
                                                                                             "no_service_model",
                                                                                             "no_emergency_time",
                                                                                             "no_service_time",
                                                                                             "deceleration",
                                                                                             "correction_factor",
                                                                                             "build_up_time",
                                                                                             "Kn",
                                                                                             "guidance_without_model",
                                                                                             "special_brake_interface",
                                                                                             "Kv_int",
                                                                                             "Kr_int",
                                                                                             "Kt_int",
                                                                                             "A_NVP",
                                                                                             "M_NVAVADH",
                                                                                             "M_NVEBCL",
                                                                                             "A_NVMAXREDADH"};

constexpr std::array<const char*, driver::kInputs> kInputNames{"train_data",
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

constexpr std::array<const char*, driver::kOutputs> kOutputNames{"mode",
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

constexpr std::array<const char*, static_cast<std::size_t>(driver::TripReason::count)> kTripReasons{
    "Balise read error",
    "Communication error",
    "SH refused",
    "Trackside not compatible",
    "Unauthorized passing of EOA / LOA",
    "No MA received at level transition",
    "SR distance exceeded",
    "SH stop order",
    "SR stop order",
    "Emergency stop",
    "No track description",
    "National system brake demand"};

}  // namespace

constexpr std::array<const char*, static_cast<std::size_t>(port::Select::count)> kSelectNames{
    "start",      "override",      "shunting",        "exit_shunting", "non_leading",     "maintain_shunting",
    "train_data", "slippery_rail", "adhesion_normal", "isolate",       "track_ahead_free"};
constexpr std::array<const char*, 3> kDirectionNames{"neutral", "forward", "backward"};

const char* text_of(driver::TripReason reason) { return kTripReasons[static_cast<std::size_t>(reason)]; }

const char* name(train::Fault fault) { return kFaultNames[static_cast<std::size_t>(fault)]; }
const char* name(driver::Input input) { return kInputNames[static_cast<std::size_t>(input)]; }
const char* name(driver::Output output) { return kOutputNames[static_cast<std::size_t>(output)]; }

const char* text_of(Inform inform) {
  switch (inform) {
    case Inform::network_registration_failed:
      return "Radio network registration failed";
    case Inform::train_rejected:
      return "Train is rejected";
    case Inform::SH_refused:
      return "SH refused";
    case Inform::SH_request_failed:
      return "SH request failed";
    default:  // ST04 shows that a session could not be opened
      return nullptr;
  }
}

}  // namespace evc::texts
