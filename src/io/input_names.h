#pragma once
#include <initializer_list>

/// The names of ports.md in the order of the kernel's enumerations.
namespace evc::io {

inline constexpr std::initializer_list<const char*> kLevelNames = {"0", "NTC", "1", "2", "3"};
inline constexpr std::initializer_list<const char*> kSessionNames = {"connected", "lost", "refused"};
inline constexpr std::initializer_list<const char*> kDirectionNames = {"neutral", "forward", "backward"};
inline constexpr std::initializer_list<const char*> kSelectNames = {
    "start",      "override",      "shunting",        "exit_shunting", "non_leading",     "maintain_shunting",
    "train_data", "slippery_rail", "adhesion_normal", "isolate",       "track_ahead_free"};
inline constexpr std::initializer_list<const char*> kAckNames = {"OS", "LS",   "SH",    "SR",   "UN",    "SN",
                                                                 "RV", "trip", "level", "text", "brake", "train_data"};

}  // namespace evc::io
