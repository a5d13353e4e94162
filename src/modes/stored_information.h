#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "modes/page.h"
#include "terms/data_status.h"
#include "terms/level.h"
#include "terms/mode.h"
#include "terms/srs_version.h"
#include "terms/stored.h"

namespace evc::modes {

/// What happens to a piece of stored information: `U`, `D`, `TBR` (kept, but invalid until it is revalidated), `R`
/// (set to its initial value), `NR` (the mode can only be left by power off; treated as unchanged).
enum class Fate : std::uint8_t { unchanged, deleted, to_be_revalidated, reset, not_relevant };

/// A row of 4.10.1.3. [1]: unchanged when coming from SH; [2]: unchanged when coming from PS.
struct StoredRow {
  struct Cell {
    Fate fate = Fate::not_relevant;
    std::uint8_t notes = 0;
  };
  Stored what{};
  std::array<Cell, kModes> on_entry{};

  constexpr StoredRow(Stored stored, std::string_view row) : what(stored) {
    const auto word = page::words<kModes>(row);
    for (std::size_t i = 0; i < kModes; ++i) {
      const std::string_view m = page::mark(word[i]);
      on_entry[i].notes = static_cast<std::uint8_t>(page::notes(word[i]));
      if (m == "U")
        on_entry[i].fate = Fate::unchanged;
      else if (m == "D")
        on_entry[i].fate = Fate::deleted;
      else if (m == "TBR")
        on_entry[i].fate = Fate::to_be_revalidated;
      else if (m == "R")
        on_entry[i].fate = Fate::reset;
      else if (m != "NR")
        page::row_cannot_be_read();
    }
  }
};

// clang-format off
/// 4.10.1.3 of 3.6.0: on entry of the mode of the column. In 3.4.0 the texts are kept in NL and the RBC identity and
/// phone number are deleted in UN and SN. In 4.0.0 the announcement of a loop is deleted in PS and SH, train data are to be
/// revalidated in NL, and an announced level transition has no exceptions.
inline constexpr auto srs_4_10 = [] {
  using enum Stored;
  return std::to_array<StoredRow>({
    //                                 NP  SB      PS SH   FS LS SR OS SL   NL   UN TR PT SF IS SN RV SM AD
    {national_values,                "U   U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {pending_national_values,        "D   U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {linking,                        "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D U U"},
    {movement_authority,             "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D D U"},
    {gradient,                       "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D U U"},
    {ssp,                            "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D U U"},
    {asp,                            "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D U U"},
    {stm_max_speed,                  "D   D       D  D    U  U  D  U  D    D    U  U  U  NR NR U  D D U"},
    {stm_system_speed_distance,      "D   D       D  D    U  U  D  U  D    D    U  U  U  NR NR U  D D U"},
    {level_transition_order,         "D   D[1][2] U  D[2] U  U  D  U  D[2] D[1] D  U  U  NR NR D  D D U"},
    {stop_sh_on_desk_opening,        "D   D       U  U    U  U  U  U  D    U    U  U  U  NR NR U  U D U"},
    {sh_bg_list,                     "D   D       U  U    U  U  D  U  D    D    D  D  U  NR NR D  D D U"},
    {ma_request_params,              "D   U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {position_report_params,         "D   U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {sr_bg_list_speed_distance,      "D   D       D  D    D  D  U  D  D    D    D  D  U  NR NR D  D D D"},
    {tsr,                            "D   D       D  D    U  U  U  U  D    D    U  U  U  NR NR D  D U U"},
    {inhibit_revocable_tsr,          "D   D       D  D    U  U  D  U  D    D    D  U  U  NR NR D  D U U"},
    {default_gradient_tsr,           "D   D       D  D    U  U  U  U  D    D    U  U  U  NR NR D  D U U"},
    {signalling_speed,               "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D D U"},
    {route_suitability,              "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D D U"},
    {adhesion_trackside,             "R   R       R  R    U  U  U  U  R    R    U  U  U  NR NR R  U U U"},
    {adhesion_driver,                "R   R       R  R    U  U  U  U  R    R    U  U  U  NR NR U  U U U"},
    {plain_text,                     "D   D       D  D    U  U  U  U  D    D    U  U  U  NR NR D  U U U"},
    {fixed_text,                     "D   D       D  D    U  U  U  U  D    D    U  U  U  NR NR D  U U U"},
    {geo_position,                   "D   U       D  D    U  U  U  U  D    U    U  U  U  NR NR D  D U U"},
    {mode_profile,                   "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D D U"},
    {rbc_transition_order,           "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D D U"},
    {radio_infill_area,              "D   D       D  D    U  U  D  D  D    D    D  D  U  NR NR D  D D U"},
    {eolm,                           "TBR U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {track_conditions_general,       "R   R       R  R    U  U  R  U  R    U    R  U  U  NR NR R  R U U"},
    {track_conditions_horn_stopping, "R   R       R  R    U  U  R  U  R    R    R  R  R  NR NR R  R U U"},
    {track_condition_bmm,            "R   R       R  R    U  U  R  U  R    U    U  U  U  NR NR U  R U U"},
    {unconditional_stops,            "D   D       D  D    U  U  D  U  D    D    D  U  U  NR NR D  D U U"},
    {conditional_stops,              "D   D       D  D    U  U  D  U  D    D    D  U  U  NR NR D  D U U"},
    {train_position,                 "TBR U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {train_data,                     "D   TBR     U  TBR  U  U  U  U  U    U    U  U  U  NR NR U  U TBR U"},
    {level,                          "TBR U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {trackside_level_table,          "TBR U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {driver_id,                      "D   TBR     U  U    U  U  U  U  D    U    U  U  U  NR NR U  U U U"},
    {radio_network_id,               "U   U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {rbc_id_phone,                   "TBR U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {train_running_number,           "D   TBR     U  U    U  U  U  U  D    U    U  U  U  NR NR U  U U U"},
    {reversing_area,                 "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  U D U"},
    {reversing_supervision,          "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  U D U"},
    {track_ahead_free_request,       "D   D       D  D    D  D  U  U  D    D    D  D  U  NR NR D  D D D"},
    {permitted_braking_distance,     "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D D U"},
    {level_crossing,                 "D   D       D  D    U  U  D  U  D    D    D  D  U  NR NR D  D U U"},
    {rbc_riu_version,                "D   U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {operated_version,               "U   U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {vbc,                            "U   U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {dmi_language,                   "U   U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {generic_ls_marker,              "U   U       U  U    U  U  U  U  U    U    U  U  U  NR NR U  U U U"},
    {lssma_toggle_on_order,          "D   D       D  D    D  U  D  D  D    D    D  D  U  NR NR D  D D D"},
  });
}();
// clang-format on
static_assert(srs_4_10.size() == kStored);
static_assert(
    [] {
      for (std::size_t i = 0; i < kStored; ++i)
        if (static_cast<std::size_t>(srs_4_10[i].what) != i) return false;
      return true;
    }(),
    "one row for each, in order");

/// 4.10: what to do with `stored` when mode `to` is entered from mode `from`.
Fate on_entry(Mode to, Mode from, Stored stored, SrsVersion srs = SrsVersion::v3_6_0);

/// 4.10: the same for a level order that waits until SH or PS is left (4.4.8.1.5). Before 4.0.0 it is in the row of
/// `level_transition_order`; 4.0.0 has a row of its own.
Fate kept_level_order_on_entry(Mode to, Mode from, SrsVersion srs);

/// 4.9.1: what to do with `stored` when level `to` is entered; any other level change changes nothing.
Fate on_level_entry(Level to, Stored stored);

/// A.3.4 situation k: what to do with `stored` when the desk is closed during start of mission (the mode stays SB, so
/// on_entry does not apply).
Fate on_desk_closed_in_start_of_mission(Stored stored);

/// Status of the five items that NP makes invalid, after power-up (4.11).
enum class ColdMovement : std::uint8_t { none, moved_or_unknown };

/// 4.11.1: the validity after power-up of an item that entering NP made invalid: eolm, train_position, level,
/// trackside_level_table, rbc_id_phone. Items that NP left valid do not change (result: valid).
DataStatus on_exit_np(ColdMovement movement, Stored stored);

}  // namespace evc::modes
