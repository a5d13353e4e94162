#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "modes/page.h"
#include "terms/driver_input.h"
#include "terms/driver_output.h"
#include "terms/mode.h"
#include "terms/srs_version.h"

// SUBSET-026-4 4.7.2: the inputs and outputs of the driver interface in each mode, of 3.6.0, and the cells of the other
// editions that differ.
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
    //                         NP SB PS SH FS LS SR OS SL NL UN TR PT SF IS SN RV SM AD
    {train_data,             "-  A  -  -  A  A  A  A  -  -  A  -  -  NA NA A  - - A"},
    {language,               "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A A A"},
    {driver_id,              "-  A  -  A  A  A  A  A  -  A  A  -  -  NA NA A  - A A"},
    {train_running_number,   "-  A  -  -  A  A  A  A  -  A  A  -  -  NA NA A  - A A"},
    {level,                  "-  A  -  -  A  A  A  A  -  A  A  -  -  NA NA A  - - A"},
    {adhesion,               "-  A  -  -  A  A  A  A  -  -  A  -  -  NA NA A  - A A"},
    {rbc_contact,            "-  A  -  -  A  A  A  A  -  A  -  -  A  NA NA -  - A A"},
    {integrity_confirmation, "-  A  -  -  A  A  A  A  -  -  -  -  A  NA NA -  - A A"},
    {start,                  "-  A  -  -  -  -  A  -  -  -  -  -  A  NA NA -  - - -"},
    {override_,              "-  A  -  A  A  A  A  A  -  -  A  -  A  NA NA A  - - A"},
    {shunting,               "-  A  -  -  A  A  A  A  -  -  A  -  A  NA NA A  - A A"},
    {continue_shunting,      "-  -  -  A  -  -  -  -  -  -  -  -  -  NA NA -  - - -"},
    {exit_shunting,          "-  -  -  X  -  -  -  -  -  -  -  -  -  NA NA -  - - -"},
    {non_leading,            "-  A  -  A  A  A  A  A  -  -  -  -  -  NA NA -  - A A"},
    {ack_fixed_text,         "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA -  A A A"},
    {ack_plain_text,         "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA -  A A A"},
    {ack_level,              "-  A  -  -  A  A  A  A  -  -  A  A  -  NA NA A  - - A"},
    {ack_LS,                 "-  A  -  -  A  A  -  A  -  -  -  -  A  NA NA -  - - A"},
    {ack_OS,                 "-  A  -  -  A  A  -  A  -  -  -  -  A  NA NA -  - - A"},
    {ack_SH,                 "-  A  -  A  A  A  -  A  -  -  -  -  A  NA NA -  - - A"},
    {ack_SR,                 "-  A  -  -  -  -  -  -  -  -  -  -  A  NA NA -  - - -"},
    {ack_UN,                 "-  A  -  -  -  -  -  -  -  -  -  -  -  NA NA -  - - -"},
    {ack_RV,                 "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA -  - - A"},
    {ack_SN,                 "-  A  -  -  -  -  -  -  -  -  -  -  -  NA NA -  - - -"},
    {ack_trip,               "-  -  -  -  -  -  -  -  -  -  -  A  -  NA NA -  - - -"},
    {ack_roll_away,          "-  -  -  A  A  A  A  A  -  -  A  -  A  NA NA -  A A -"},
    {ack_reverse_movement,   "-  -  -  -  A  A  A  A  -  -  -  -  A  NA NA -  A A -"},
    {ack_standstill,         "-  A  -  -  -  -  -  -  -  -  -  -  -  NA NA -  - - -"},
    {ack_pt_distance,        "-  -  -  -  -  -  -  -  -  -  -  -  A  NA NA -  - - -"},
    {ack_train_data_change,  "-  -  -  -  A  A  A  A  -  -  A  A  -  NA NA A  - - A"},
    {ack_rv_distance,        "-  -  -  -  -  -  -  -  -  -  -  -  -  NA NA -  A - -"},
    {track_ahead_free,       "-  A  -  -  -  A  A  A  -  -  -  -  A  NA NA -  - - -"},
    {sr_speed_distance,      "-  -  -  -  -  -  A  -  -  -  -  -  -  NA NA -  - - -"},
    {vbc,                    "-  A  -  -  -  -  -  -  -  -  -  -  -  NA NA -  - - -"},
    {isolation,              "X  X  X  X  X  X  X  X  X  X  X  X  X  X  X  X  X X X"},
    {radio_network_id,       "-  A  -  -  A  A  A  A  -  A  A  -  A  NA NA A  - A A"},
    // 4.0.0
    {ato_engage,             "-  -  -  -  A  -  -  -  -  -  -  -  -  NA NA -  - - A"},
    {ato_disengage,          "-  -  -  -  -  -  -  -  -  -  -  -  -  NA NA -  - - A"},
    {sm,                     "-  A  -  -  A  A  A  A  -  -  -  -  A  NA NA -  - A A"},
    {exit_sm,                "-  -  -  -  -  -  -  -  -  -  -  -  -  NA NA -  - A -"},
    {bmm_inhibit,            "-  A  -  A  -  -  A  -  -  -  -  -  -  NA NA -  - - -"},
    {bmm_revoke,             "-  A  -  A  -  -  A  -  -  -  -  -  -  NA NA -  - - -"},
    {ack_nl_no_longer_permitted, "-  -  -  -  -  -  -  -  -  A  -  -  -  NA NA -  - - -"},
  });
}();
// clang-format on
static_assert(srs_4_7_2_inputs.size() == kInputs && in_order(srs_4_7_2_inputs));

/// A cell of another edition than 3.6.0.
template <class What>
struct CellOfEdition {
  SrsVersion srs{};
  What what{};
  Mode mode{};
  Mark mark{};
};

inline constexpr auto srs_4_7_2_inputs_of_editions = std::to_array<CellOfEdition<Input>>({
    {SrsVersion::v3_4_0, Input::ack_fixed_text, Mode::NL, Mark::available},
    {SrsVersion::v3_4_0, Input::ack_plain_text, Mode::NL, Mark::available},
    {SrsVersion::v4_0_0, Input::integrity_confirmation, Mode::UN, Mark::available},
    {SrsVersion::v4_0_0, Input::integrity_confirmation, Mode::SN, Mark::available},
    {SrsVersion::v4_0_0, Input::exit_shunting, Mode::SH, Mark::available},
    {SrsVersion::v4_0_0, Input::ack_level, Mode::SH, Mark::available},
});

constexpr Mark mark(Input which, Mode mode, SrsVersion srs) {
  for (const CellOfEdition<Input>& cell : srs_4_7_2_inputs_of_editions)
    if (cell.srs == srs && cell.what == which && cell.mode == mode) return cell.mark;
  return srs_4_7_2_inputs[static_cast<std::size_t>(which)].modes[static_cast<std::size_t>(mode)];
}

using Output = DriverOutput;
inline constexpr std::size_t kOutputs = static_cast<std::size_t>(Output::count);

struct OutputRow {
  Output what{};
  std::array<Mark, kModes> modes{};
  constexpr OutputRow(Output which, std::string_view row) : what(which), modes(marks(row)) {}
};

// clang-format off
inline constexpr auto srs_4_7_2_outputs = [] {
  using enum DriverOutput;
  return std::to_array<OutputRow>({
    //                              NP SB PS SH FS LS SR OS SL NL UN TR PT SF IS SN RV SM AD
    {mode,                        "-  A  -  X  X  X  X  X  -  X  X  A  X  A  X  X  X X X"},
    {level,                       "-  A  -  X  X  X  X  X  -  X  X  A  X  NA NA X  X X X"},
    {train_speed,                 "-  A  -  X  X  X  X  X  -  X  X  A  X  NA NA A  X X X"},
    {permitted_speed,             "-  -  -  A  X  -  A  A  -  -  -  -  -  NA NA NS X X X"},
    {sbi_speed,                   "-  -  -  -  A  -  -  -  -  -  -  -  -  NA NA NS - A A"},
    {target_speed,                "-  -  -  -  A  -  A  A  -  -  -  -  -  NA NA NS - A A"},
    {target_distance,             "-  -  -  -  A  -  A  A  -  -  -  -  -  NA NA NS X A A"},
    {release_speed,               "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA NS - A A"},
    {lssma,                       "-  -  -  -  -  A  -  -  -  -  -  -  -  NA NA -  - - -"},
    {monitoring_status,           "-  -  -  A  A  A  A  A  -  -  A  -  A  NA NA NS A A A"},
    {trip_reason,                 "-  -  -  -  -  -  -  -  -  -  -  A  X  NA NA -  - - -"},
    {train_data,                  "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA A  A - A"},
    {driver_id,                   "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A A A"},
    {train_running_number,        "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A A A"},
    {rbc_contact,                 "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A A A"},
    {vbc,                         "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A A A"},
    {brake_indication,            "-  A  -  A  A  A  A  A  -  -  A  A  A  NA NA A  A A -"},
    {fixed_text,                  "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA -  A A A"},
    {plain_text,                  "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA -  A A A"},
    {reversing_allowed,           "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA -  - - A"},
    {track_cond_general,          "-  -  -  -  A  A  -  A  -  A  -  A  A  NA NA -  - A A"},
    {track_cond_horn_stopping,    "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA -  - A A"},
    {geo_position,                "-  A  -  -  A  A  A  A  -  A  A  A  A  NA NA -  - A A"},
    {override_status,             "-  -  -  A  -  -  A  -  -  -  A  -  -  NA NA A  - - -"},
    {lx_not_protected,            "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA -  - A A"},
    {sh_refused,                  "-  A  -  -  A  A  A  A  -  -  -  -  A  NA NA -  - A A"},
    {sh_no_answer,                "-  A  -  -  A  A  A  A  -  -  -  -  A  NA NA -  - A A"},
    {level_announcement,          "-  -  -  -  A  A  A  A  -  A  A  A  A  NA NA A  - - A"},
    {taf_request,                 "-  A  -  -  -  A  A  A  -  -  -  -  A  NA NA -  - - -"},
    {slippery_rail,               "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA A  A A A"},
    {trackside_malfunction,       "-  A  -  A  A  A  A  A  -  -  A  A  A  NA NA A  A A A"},
    {train_data_changed,          "-  A  -  -  A  A  A  A  -  -  A  A  A  NA NA A  - - A"},
    {operated_version,            "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A A A"},
    {network_registration_failed, "-  A  -  -  A  A  A  A  -  A  -  -  A  NA NA -  - A A"},
    {radio_link_status,           "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A A A"},
    {local_time,                  "-  A  -  X  X  X  X  X  -  X  X  A  X  NA NA A  X X X"},
    {gradient,                    "-  -  -  -  X  -  -  A  -  -  -  -  -  NA NA -  - X X"},
    {mrsp,                        "-  -  -  -  X  -  -  A  -  -  -  -  -  NA NA -  - X X"},
    {brake_reason,                "-  A  -  A  A  A  A  A  -  -  A  -  A  NA NA A  A A -"},
    {trackside_incompatible,      "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A A A"},
    {train_rejected,              "-  A  -  -  -  -  -  -  -  -  -  -  -  NA NA -  - - -"},
    {route_unsuitability,         "-  -  -  -  A  A  -  A  -  -  -  -  -  NA NA -  - - A"},
    {radio_network_id,            "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A A A"},
    {time_to_indication,          "-  -  -  -  A  -  A  A  -  -  -  -  -  NA NA -  - A A"},
    {entry_fs,                    "-  -  -  -  A  -  -  -  -  -  -  -  -  NA NA -  - - -"},
    {entry_os,                    "-  -  -  -  -  -  -  A  -  -  -  -  -  NA NA -  - - -"},
    {first_indication_location,   "-  -  -  -  A  -  -  A  -  -  -  -  -  NA NA -  - A A"},
    {eoa_loa,                     "-  -  -  -  A  -  -  A  -  -  -  -  -  NA NA -  - A A"},
    {set_speed,                   "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  A A A"},
    {ntc_not_available,           "-  -  -  -  -  -  -  -  -  A  -  -  -  NA NA A  - - -"},
    {ntc_data_need,               "-  -  -  -  A  A  A  A  -  -  A  A  A  NA NA A  - - A"},
    {ntc_failed,                  "-  A  -  A  A  A  A  A  -  A  A  A  A  NA NA A  - A A"},
    // 4.0.0
    {nl_no_longer_permitted,      "-  -  -  -  -  -  -  -  -  A  -  -  -  NA NA -  - - -"},
    {odometer_impaired,           "-  -  -  -  A  A  A  A  -  -  -  -  -  NA NA -  - A A"},
    {sm_refused,                  "-  A  -  -  A  A  A  A  -  -  -  -  A  NA NA -  - A A"},
    {sm_no_answer,                "-  A  -  -  A  A  A  A  -  -  -  -  A  NA NA -  - A A"},
    {entry_sm,                    "-  -  -  -  -  -  -  -  -  -  -  -  -  NA NA -  - A -"},
    {authorised_direction,        "-  -  -  -  -  -  -  -  -  -  -  -  -  NA NA -  - X -"},
    {bmm_inhibition,              "-  A  -  A  -  -  A  -  -  -  -  -  -  NA NA -  - - -"},
  });
}();
// clang-format on
static_assert(srs_4_7_2_outputs.size() == kOutputs && in_order(srs_4_7_2_outputs));

inline constexpr auto srs_4_7_2_outputs_of_editions = std::to_array<CellOfEdition<Output>>({
    {SrsVersion::v3_4_0, Output::trip_reason, Mode::PT, Mark::no},
    {SrsVersion::v3_4_0, Output::fixed_text, Mode::NL, Mark::available},
    {SrsVersion::v3_4_0, Output::plain_text, Mode::NL, Mark::available},
    {SrsVersion::v3_4_0, Output::gradient, Mode::FS, Mark::available},
    {SrsVersion::v3_4_0, Output::gradient, Mode::OS, Mark::no},
    {SrsVersion::v3_4_0, Output::mrsp, Mode::FS, Mark::available},
    {SrsVersion::v3_4_0, Output::mrsp, Mode::OS, Mark::no},
    {SrsVersion::v4_0_0, Output::brake_reason, Mode::TR, Mark::available},
});

constexpr Mark mark(Output which, Mode mode, SrsVersion srs) {
  for (const CellOfEdition<Output>& cell : srs_4_7_2_outputs_of_editions)
    if (cell.srs == srs && cell.what == which && cell.mode == mode) return cell.mark;
  return srs_4_7_2_outputs[static_cast<std::size_t>(which)].modes[static_cast<std::size_t>(mode)];
}

/// Whether the mode allows it, without further conditions.
template <class What>
constexpr bool allowed(What which, Mode mode, SrsVersion srs) {
  const Mark m = mark(which, mode, srs);
  return m == Mark::always || m == Mark::available || m == Mark::national;
}

}  // namespace evc::driver
