#pragma once
#include <array>

// Words of the record of the display (evc-dmi/1) that no table of src/terms has, in the order of their enumerations in
// port/display.h: its writer and its reader use them.
namespace evc::io::names {

inline constexpr std::array<int, 4> kDials{140, 180, 250, 400};
inline constexpr std::array<const char*, 3> kEntryNames{"flexible", "fixed", "switchable"};
inline constexpr std::array<const char*, 4> kTextKindNames{"fixed", "plain", "status", "national"};
inline constexpr std::array<const char*, 2> kSmNames{"forward", "backward"};
inline constexpr std::array<const char*, 3> kRadioNames{"none", "failed", "up"};
inline constexpr std::array<const char*, 10> kWaitingNames{"nothing",
                                                           "end_of_session",
                                                           "radio_registration",
                                                           "network_list",
                                                           "session",
                                                           "train_accepted",
                                                           "train_data_acknowledged",
                                                           "answer_to_ma_request",
                                                           "answer_to_sh_request",
                                                           "answer_to_sm_request"};
inline constexpr std::array<const char*, 3> kNetworkTypeNames{"FRMCS", "FRMCS+GSM-R", "GSM-R"};
inline constexpr std::array<const char*, 6> kAtoStatusNames{"none",    "selected",    "ready",
                                                            "engaged", "disengaging", "failure"};
inline constexpr std::array<const char*, 4> kAtoStopNames{"none", "overshoot", "undershoot", "accurate"};
inline constexpr std::array<const char*, 8> kAtoDoorsNames{"none",     "open_both", "open_left", "open_right",
                                                           "are_open", "close",     "closing",   "closed"};
inline constexpr std::array<const char*, 4> kAtoSkipNames{"none", "inactive", "by_trackside", "by_driver"};

}  // namespace evc::io::names
