#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "modes/page.h"
#include "terms/driver_input.h"
#include "terms/mode.h"

// SUBSET-026-4 4.7.2: the inputs and outputs of the driver interface in each mode, of 3.6.0.
namespace evc::driver {

/// `X` always in the mode; `A` when further conditions hold; `-` not; `NA` cannot be decided (SF, IS); `NS` left to the
/// national system.
enum class Mark : std::uint8_t { no, always, available, cannot_be_told, national };

/// The marks of a row of 4.7.2, the modes in the column order of the standard.
constexpr std::array<Mark, kModes> marks(std::string_view row) {
  const auto word = modes::page::words<kModes>(row);
  std::array<Mark, kModes> out{};
  for (std::size_t i = 0; i < kModes; ++i) {
    if (word[i] == "X")
      out[i] = Mark::always;
    else if (word[i] == "A")
      out[i] = Mark::available;
    else if (word[i] == "NA")
      out[i] = Mark::cannot_be_told;
    else if (word[i] == "NS")
      out[i] = Mark::national;
    else if (word[i] != "-")
      modes::page::row_cannot_be_read();
  }
  return out;
}

using Input = DriverInput;
inline constexpr std::size_t kInputs = static_cast<std::size_t>(Input::count);

/// Whether there is one row for each, in the order of the enumeration.
template <class Rows>
constexpr bool in_order(const Rows& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].what) != i) return false;
  return true;
}

struct InputRow {
  Input what{};
  std::array<Mark, kModes> modes{};
  constexpr InputRow(Input which, std::string_view row) : what(which), modes(marks(row)) {}
};

// clang-format off
inline constexpr auto srs_4_7_2_inputs = [] {
  using enum DriverInput;
  return std::to_array<InputRow>({
    //                         NP SB PS SH FS LS SR OS SL NL UN TR PT SF IS SN RV
    {train_data,             "-  A  -  -  A  A  A  A  -  -  A  -  -  NA NA A  -"},
    {language,               "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A"},
    {driver_id,              "-  A  -  A  A  A  A  A  -  A  A  -  -  NA NA A  -"},
    {train_running_number,   "-  A  -  -  A  A  A  A  -  A  A  -  -  NA NA A  -"},
    {level,                  "-  A  -  -  A  A  A  A  -  A  A  -  -  NA NA A  -"},
    {adhesion,               "-  A  -  -  A  A  A  A  -  -  A  -  -  NA NA A  -"},
    {rbc_contact,            "-  A  -  -  A  A  A  A  -  A  -  -  A  NA NA -  -"},
    {integrity_confirmation, "-  A  -  -  A  A  A  A  -  -  -  -  A  NA NA -  -"},
    {start,                  "-  A  -  -  -  -  A  -  -  -  -  -  A  NA NA -  -"},
    {override_,              "-  A  -  A  A  A  A  A  -  -  A  -  A  NA NA A  -"},
    {shunting,               "-  A  -  -  A  A  A  A  -  -  A  -  A  NA NA A  -"},
    {continue_shunting,      "-  -  -  A  -  -  -  -  -  -  -  -  -  NA NA -  -"},
    {exit_shunting,          "-  -  -  X  -  -  -  -  -  -  -  -  -  NA NA -  -"},
    {non_leading,            "-  A  -  A  A  A  A  A  -  -  -  -  -  NA NA -  -"},
    {ack_fixed_text,         "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA -  A"},
    {ack_plain_text,         "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA -  A"},
    {ack_level,              "-  A  -  -  A  A  A  A  -  -  A  A  -  NA NA A  -"},
    {ack_LS,                 "-  A  -  -  A  A  -  A  -  -  -  -  A  NA NA -  -"},
    {ack_OS,                 "-  A  -  -  A  A  -  A  -  -  -  -  A  NA NA -  -"},
    {ack_SH,                 "-  A  -  A  A  A  -  A  -  -  -  -  A  NA NA -  -"},
    {ack_SR,                 "-  A  -  -  -  -  -  -  -  -  -  -  A  NA NA -  -"},
    {ack_UN,                 "-  A  -  -  -  -  -  -  -  -  -  -  -  NA NA -  -"},
    {ack_RV,                 "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA -  -"},
    {ack_SN,                 "-  A  -  -  -  -  -  -  -  -  -  -  -  NA NA -  -"},
    {ack_trip,               "-  -  -  -  -  -  -  -  -  -  -  A  -  NA NA -  -"},
    {ack_roll_away,          "-  -  -  A  A  A  A  A  -  -  A  -  A  NA NA -  A"},
    {ack_reverse_movement,   "-  -  -  -  A  A  A  A  -  -  -  -  A  NA NA -  A"},
    {ack_standstill,         "-  A  -  -  -  -  -  -  -  -  -  -  -  NA NA -  -"},
    {ack_pt_distance,        "-  -  -  -  -  -  -  -  -  -  -  -  A  NA NA -  -"},
    {ack_train_data_change,  "-  -  -  -  A  A  A  A  -  -  A  A  -  NA NA A  -"},
    {ack_rv_distance,        "-  -  -  -  -  -  -  -  -  -  -  -  -  NA NA -  A"},
    {track_ahead_free,       "-  A  -  -  -  A  A  A  -  -  -  -  A  NA NA -  -"},
    {sr_speed_distance,      "-  -  -  -  -  -  A  -  -  -  -  -  -  NA NA -  -"},
    {vbc,                    "-  A  -  -  -  -  -  -  -  -  -  -  -  NA NA -  -"},
    {isolation,              "X  X  X  X  X  X  X  X  X  X  X  X  X  X  X  X  X"},
    {radio_network_id,       "-  A  -  -  A  A  A  A  -  A  A  -  A  NA NA A  -"},
  });
}();
// clang-format on
static_assert(srs_4_7_2_inputs.size() == kInputs && in_order(srs_4_7_2_inputs));

constexpr Mark mark(Input which, Mode mode) {
  return srs_4_7_2_inputs[static_cast<std::size_t>(which)].modes[static_cast<std::size_t>(mode)];
}

/// 4.7.2: the outputs to the driver.
enum class Output : std::uint8_t {
  mode,
  level,
  train_speed,
  permitted_speed,
  sbi_speed,
  target_speed,
  target_distance,
  release_speed,
  lssma,
  monitoring_status,
  trip_reason,
  train_data,
  driver_id,
  train_running_number,
  rbc_contact,
  vbc,
  brake_indication,
  fixed_text,
  plain_text,
  reversing_allowed,
  track_cond_general,
  track_cond_horn_stopping,
  geo_position,
  override_status,
  lx_not_protected,
  sh_refused,
  sh_no_answer,
  level_announcement,
  taf_request,
  slippery_rail,
  trackside_malfunction,
  train_data_changed,
  operated_version,
  network_registration_failed,
  radio_link_status,
  local_time,
  gradient,
  mrsp,
  brake_reason,
  trackside_incompatible,
  train_rejected,
  route_unsuitability,
  radio_network_id,
  time_to_indication,
  entry_fs,
  entry_os,
  first_indication_location,
  eoa_loa,
  set_speed,
  ntc_not_available,
  ntc_data_need,
  ntc_failed,
  count
};
inline constexpr std::size_t kOutputs = static_cast<std::size_t>(Output::count);

struct OutputRow {
  Output what{};
  std::array<Mark, kModes> modes{};
  constexpr OutputRow(Output which, std::string_view row) : what(which), modes(marks(row)) {}
};

// clang-format off
inline constexpr auto srs_4_7_2_outputs = [] {
  using enum Output;
  return std::to_array<OutputRow>({
    //                              NP SB PS SH FS LS SR OS SL NL UN TR PT SF IS SN RV
    {mode,                        "-  A  -  X  X  X  X  X  -  X  X  A  X  A  X  X  X"},
    {level,                       "-  A  -  X  X  X  X  X  -  X  X  A  X  NA NA X  X"},
    {train_speed,                 "-  A  -  X  X  X  X  X  -  X  X  A  X  NA NA A  X"},
    {permitted_speed,             "-  -  -  A  X  -  A  A  -  -  -  -  -  NA NA NS X"},
    {sbi_speed,                   "-  -  -  -  A  -  -  -  -  -  -  -  -  NA NA NS -"},
    {target_speed,                "-  -  -  -  A  -  A  A  -  -  -  -  -  NA NA NS -"},
    {target_distance,             "-  -  -  -  A  -  A  A  -  -  -  -  -  NA NA NS X"},
    {release_speed,               "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA NS -"},
    {lssma,                       "-  -  -  -  -  A  -  -  -  -  -  -  -  NA NA -  -"},
    {monitoring_status,           "-  -  -  A  A  A  A  A  -  -  A  -  A  NA NA NS A"},
    {trip_reason,                 "-  -  -  -  -  -  -  -  -  -  -  A  X  NA NA -  -"},
    {train_data,                  "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA A  A"},
    {driver_id,                   "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A"},
    {train_running_number,        "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A"},
    {rbc_contact,                 "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A"},
    {vbc,                         "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A"},
    {brake_indication,            "-  A  -  A  A  A  A  A  -  -  A  A  A  NA NA A  A"},
    {fixed_text,                  "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA -  A"},
    {plain_text,                  "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA -  A"},
    {reversing_allowed,           "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA -  -"},
    {track_cond_general,          "-  -  -  -  A  A  -  A  -  A  -  A  A  NA NA -  -"},
    {track_cond_horn_stopping,    "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA -  -"},
    {geo_position,                "-  A  -  -  A  A  A  A  -  A  A  A  A  NA NA -  -"},
    {override_status,             "-  -  -  A  -  -  A  -  -  -  A  -  -  NA NA A  -"},
    {lx_not_protected,            "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA -  -"},
    {sh_refused,                  "-  A  -  -  A  A  A  A  -  -  -  -  A  NA NA -  -"},
    {sh_no_answer,                "-  A  -  -  A  A  A  A  -  -  -  -  A  NA NA -  -"},
    {level_announcement,          "-  -  -  -  A  A  A  A  -  A  A  A  A  NA NA A  -"},
    {taf_request,                 "-  A  -  -  -  A  A  A  -  -  -  -  A  NA NA -  -"},
    {slippery_rail,               "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA A  A"},
    {trackside_malfunction,       "-  A  -  A  A  A  A  A  -  -  A  A  A  NA NA A  A"},
    {train_data_changed,          "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA A  -"},
    {operated_version,            "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A"},
    {network_registration_failed, "-  A  -  -  A  A  A  A  -  A  -  -  A  NA NA -  -"},
    {radio_link_status,           "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A"},
    {local_time,                  "-  A  -  X  X  X  X  X  -  X  X  A  X  NA NA A  X"},
    {gradient,                    "-  -  -  -  X  -  -  A  -  -  -  -  -  NA NA -  -"},
    {mrsp,                        "-  -  -  -  X  -  -  A  -  -  -  -  -  NA NA -  -"},
    {brake_reason,                "-  A  -  A  A  A  A  A  -  -  A  -  A  NA NA A  A"},
    {trackside_incompatible,      "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A"},
    {train_rejected,              "-  A  -  -  -  -  -  -  -  -  -  -  -  NA NA -  -"},
    {route_unsuitability,         "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA -  -"},
    {radio_network_id,            "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A"},
    {time_to_indication,          "-  -  -  -  A  -  A  A  -  -  -  -  -  NA NA -  -"},
    {entry_fs,                    "-  -  -  -  A  -  -  -  -  -  -  -  -  NA NA -  -"},
    {entry_os,                    "-  -  -  -  -  -  -  A  -  -  -  -  -  NA NA -  -"},
    {first_indication_location,   "-  -  -  -  A  -  -  A  -  -  -  -  -  NA NA -  -"},
    {eoa_loa,                     "-  -  -  -  A  -  -  A  -  -  -  -  -  NA NA -  -"},
    {set_speed,                   "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A"},
    {ntc_not_available,           "-  -  -  -  -  -  -  -  -  A  -  -  -  NA NA A  -"},
    {ntc_data_need,               "-  -  -  -  A  A  A  A  -  -  A  A  A  NA NA A  -"},
    {ntc_failed,                  "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  -"},
  });
}();
// clang-format on
static_assert(srs_4_7_2_outputs.size() == kOutputs && in_order(srs_4_7_2_outputs));

constexpr Mark mark(Output which, Mode mode) {
  return srs_4_7_2_outputs[static_cast<std::size_t>(which)].modes[static_cast<std::size_t>(mode)];
}

/// Whether the mode allows it, without further conditions.
template <class What>
constexpr bool allowed(What which, Mode mode) {
  const Mark m = mark(which, mode);
  return m == Mark::always || m == Mark::available || m == Mark::national;
}

}  // namespace evc::driver
