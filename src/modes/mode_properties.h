#pragma once
#include <array>
#include <cstdint>

#include "terms/level.h"
#include "terms/mode.h"

namespace evc::modes {

/// The source of the mode's speed limit (4.4, 3.11.7).
enum class SpeedLimit : std::uint8_t {
  no_limit,       // no speed supervised
  standstill,     // SB: the train has to stand
  profile_only,   // FS: the most restrictive speed profile has no mode element
  V_NVSHUNT,      // unless the mode profile gives another one
  V_NVSTFF,       // unless the driver enters another one
  V_NVONSIGHT,    // unless the mode profile gives another one
  V_NVLIMSUPERV,  // unless the mode profile gives another one
  V_NVUNFIT,
  V_REVERSE,  // packet 139
  V_SM,       // given with the authorisation of the supervised manoeuvre
  national,   // given by the national system through the STM
};

/// Kind of speed and distance monitoring (4.5.2).
enum class Supervision : std::uint8_t { unsupervised, ceiling, mrsp_targets, mrsp_and_sr_distance, full };

/// The brake command of the mode itself (4.4).
enum class ModeBrake : std::uint8_t { none, emergency_brake };

struct ModeProperties {
  Mode mode;
  std::uint8_t levels;  // bit n: possible in Level n
  SpeedLimit speed_limit;
  Supervision supervision;
  ModeBrake brake;
  bool desk_needed;  // the driver drives from here
};

inline constexpr std::uint8_t kAnyLevel = 0b11111;
inline constexpr std::uint8_t kLevel0 = 0b00001;
inline constexpr std::uint8_t kLevelNTC = 0b00010;
inline constexpr std::uint8_t kLevel2 = 0b01000;
inline constexpr std::uint8_t kLevels123 = 0b11100;

// clang-format off
/// 4.4.3 to 4.4.21, in the order of `Mode`. The comment of a row: responsibility of the unit | responsibility of the
/// driver.
inline constexpr auto srs_4_4 = [] {
  using enum SpeedLimit;
  using enum Supervision;
  constexpr ModeBrake nothing = ModeBrake::none, eb = ModeBrake::emergency_brake;
  return std::to_array<ModeProperties>({
    {Mode::NP, kAnyLevel,  no_limit,         unsupervised,          eb,      false},  // keep the emergency brake on | nothing
    {Mode::SB, kAnyLevel,  standstill,       unsupervised,         nothing, false},  // keep the train standing | nothing
    {Mode::PS, kAnyLevel,  no_limit,         unsupervised,          nothing, false},  // know where the engine is | nothing: another engine leads
    {Mode::SH, kAnyLevel,  V_NVSHUNT,        ceiling,              nothing, true},  // shunting speed and the border of the area, if any | stay in the area, every movement
    {Mode::FS, kLevels123, profile_only,     full,                 nothing, true},  // everything | the EOA below the release speed; the rear not covered at entry
    {Mode::LS, kLevels123, V_NVLIMSUPERV,    full,                 nothing, true},  // what the data allow, in the background | lineside signals and rules
    {Mode::SR, kLevels123, V_NVSTFF,         mrsp_and_sr_distance, nothing, true},  // ceiling speed, SR distance and list if any | track, points, lineside information
    {Mode::OS, kLevels123, V_NVONSIGHT,      full,                 nothing, true},  // everything but an occupied track | look out for what is on the track
    {Mode::SL, kAnyLevel,  no_limit,         unsupervised,          nothing, false},  // know where the engine is | nothing: another engine leads
    {Mode::NL, kAnyLevel,  no_limit,         unsupervised,          nothing, true},  // show track conditions | obey what is shown; another engine leads
    {Mode::UN, kLevel0,    V_NVUNFIT,        mrsp_targets,         nothing, true},  // ceiling speed and temporary restrictions | lineside signals, everything
    {Mode::TR, kAnyLevel,  no_limit,         unsupervised,          eb,      false},  // stop the train and hold it | acknowledge at standstill
    {Mode::PT, kLevels123, no_limit,         unsupervised,          nothing, true},  // backwards only, within D_NVPOTRP | moving backwards
    {Mode::SF, kAnyLevel,  no_limit,         unsupervised,          eb,      false},  // keep the emergency brake on | nothing
    {Mode::IS, kAnyLevel,  no_limit,         unsupervised,          nothing, false},  // nothing | everything
    {Mode::SN, kLevelNTC,  national,         ceiling,              nothing, true},  // what the national system asks for | as the national system says
    {Mode::RV, kLevels123, V_REVERSE,        ceiling,              nothing, true},  // ceiling speed and reversing distance | keep within the distance
    {Mode::SM, kLevel2,    V_SM,     full,                 nothing, true},  // the train, with default train data | the EOA below the release speed; what is on the track
    {Mode::AD, kLevels123, profile_only,     full,                 nothing, true},  // everything | to engage it again after a stop
  });
}();
// clang-format on
static_assert(srs_4_4.size() == kModes);
static_assert(
    [] {
      for (std::size_t i = 0; i < kModes; ++i)
        if (static_cast<std::size_t>(srs_4_4[i].mode) != i) return false;
      return true;
    }(),
    "one row for each, in order");

constexpr const ModeProperties& properties(Mode mode) { return srs_4_4[static_cast<std::size_t>(mode)]; }
constexpr bool possible_in(Mode mode, Level level) {
  return ((properties(mode).levels >> static_cast<unsigned>(level)) & 1u) != 0;
}

}  // namespace evc::modes
