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

}  // namespace

constexpr std::array<const char*, static_cast<std::size_t>(port::Select::count)> kSelectNames{"start",
                                                                                              "override",
                                                                                              "shunting",
                                                                                              "exit_shunting",
                                                                                              "non_leading",
                                                                                              "maintain_shunting",
                                                                                              "train_data",
                                                                                              "slippery_rail",
                                                                                              "adhesion_normal",
                                                                                              "isolate",
                                                                                              "track_ahead_free",
                                                                                              "main",
                                                                                              "integrity_confirmed",
                                                                                              "last_rbc",
                                                                                              "short_number",
                                                                                              "vbc_set",
                                                                                              "vbc_remove",
                                                                                              "radio_network"};
constexpr std::array<const char*, 3> kDirectionNames{"neutral", "forward", "backward"};
constexpr std::array<const char*, 2> kCabNames{"A", "B"};
constexpr std::array<const char*, static_cast<std::size_t>(port::Window::count)> kWindowNames{"train_data", "sr_data"};

const char* name(train::Fault fault) { return kFaultNames[static_cast<std::size_t>(fault)]; }
const char* name(driver::Output output) { return kOutputNames[static_cast<std::size_t>(output)]; }

InputKeys keys_of(DriverInput input) {
  using enum DriverInput;
  switch (input) {
    case override_:
    case shunting:
    case exit_shunting:
    case non_leading:
    case start:
    case track_ahead_free:
    case driver_id:
    case train_running_number:
    case train_data:
    case level:
      return {name(input)};
    case continue_shunting:
      return {"maintain_shunting"};
    case adhesion:
      return {"slippery_rail", "adhesion_normal"};
    case isolation:
      return {"isolate"};
    case rbc_contact:
      return {"rbc", "last_rbc", "short_number"};
    case radio_network_id:
      return {"network", "radio_network"};
    case vbc:
      return {"vbc", "vbc_set", "vbc_remove"};
    case sr_speed_distance:
      return {"V_sr_kmh", "D_sr_m"};
    case integrity_confirmation:
      return {"integrity_confirmed"};
    default:
      return {};
  }
}

}  // namespace evc::texts
