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
                                                                                              "radio_network",
                                                                                              "toggle",
                                                                                              "ato_engage",
                                                                                              "ato_disengage",
                                                                                              "sm",
                                                                                              "continue_sm",
                                                                                              "exit_sm",
                                                                                              "bmm_inhibit",
                                                                                              "bmm_revoke"};
static_assert(kSelectNames.back() != nullptr, "one for each");
constexpr std::array<const char*, 3> kDirectionNames{"neutral", "forward", "backward"};
constexpr std::array<const char*, 2> kCabNames{"A", "B"};
constexpr std::array<const char*, static_cast<std::size_t>(port::Window::count)> kWindowNames{"train_data", "sr_data"};

const char* name(train::Fault fault) { return kFaultNames[static_cast<std::size_t>(fault)]; }

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
    case ato_engage:
    case ato_disengage:
    case exit_sm:
    case bmm_inhibit:
    case bmm_revoke:
    case language:
      return {name(input)};
    case sm:
      return {"sm", "continue_sm"};
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
