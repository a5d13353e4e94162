#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "modes/page.h"
#include "terms/information.h"
#include "terms/level.h"
#include "terms/mode.h"

namespace evc::modes {

/// A cell of 4.8.3 or 4.8.4: `A` accepted, `R` rejected, `NR` not relevant, `-` cannot occur; bit n
/// of `notes` is the exception [n].
struct AcceptanceCell {
  enum class Mark : std::uint8_t { cannot_occur, accepted, rejected, not_relevant };
  Mark mark = Mark::cannot_occur;
  std::uint32_t notes = 0;

  constexpr AcceptanceCell() = default;
  constexpr explicit AcceptanceCell(std::string_view word) : notes(page::notes(word)) {
    const std::string_view m = page::mark(word);
    if (m == "A")
      mark = Mark::accepted;
    else if (m == "R")
      mark = Mark::rejected;
    else if (m == "NR")
      mark = Mark::not_relevant;
    else if (m != "-")
      page::row_cannot_be_read();
  }
};

/// A row of 4.8.3: the levels 0, NTC, 1, 2, 3 from balise group, loop or infill unit | from the RBC.
struct AcceptanceByLevel {
  Information what{};
  std::array<AcceptanceCell, kLevels> not_rbc{}, rbc{};

  constexpr AcceptanceByLevel() = default;
  constexpr AcceptanceByLevel(Information information, std::string_view row) : what(information) {
    const auto word = page::words<2 * kLevels + 1>(row);
    if (word[kLevels] != "|") page::row_cannot_be_read();
    for (std::size_t i = 0; i < kLevels; ++i) {
      not_rbc[i] = AcceptanceCell(word[i]);
      rbc[i] = AcceptanceCell(word[kLevels + 1 + i]);
    }
  }
};

/// A row of 4.8.4: the modes in the column order of the standard.
struct AcceptanceByMode {
  Information what{};
  std::array<AcceptanceCell, kModes> modes{};

  constexpr AcceptanceByMode() = default;
  constexpr AcceptanceByMode(Information information, std::string_view row) : what(information) {
    const auto word = page::words<kModes>(row);
    for (std::size_t i = 0; i < kModes; ++i) modes[i] = AcceptanceCell(word[i]);
  }
};

// clang-format off
/// 4.8.3 of 3.6.0. 3.4.0 has no exception [14]; the row session_initiation exists up to 3.4.0.
inline constexpr auto srs_4_8_3 = [] {
  using enum Information;
  return std::to_array<AcceptanceByLevel>({
    //                                     0 NTC 1 2 3 | 0 NTC 1 2 3
    {national_values,                    "A       A       A     A     A     | R[2]  R[2]  R[2]  A          A"},
    {linking,                            "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {signalling_speed,                   "R[1]    R[1]    A     R[1]  R[1]  | -     -     -     -          -"},
    {movement_authority,                 "R[1]    R[1]    A[4]  R[1]  R[1]  | R[2]  R[2]  R[2]  A[3][4][5] A[3][4][5]"},
    {repositioning,                      "R       R       A     R     R     | -     -     -     -          -"},
    {gradient,                           "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {ssp,                                "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {asp,                                "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {level_transition_order,             "A       A       A     A     A     | A     A     A     A          A"},
    {conditional_level_transition_order, "A[11]   A[11]   A[11] A[11] A[11] | -     -     -     -          -"},
    {session_management,                 "A       A       A     A[14] A[14] | A     A     A     A          A"},
    {radio_network_registration,         "A       A       A     A     A     | A     A     A     A          A"},
    {ma_request_params,                  "-       -       -     -     -     | A     A     A     A          A"},
    {position_report_params,             "-       -       -     -     -     | A     A     A     A          A"},
    {sr_authorisation,                   "-       -       -     -     -     | R     R     R     A[3]       A[3]"},
    {stop_if_in_sr,                      "R       R       A     A     A     | -     -     -     -          -"},
    {sr_distance_loop,                   "R       R       A     R     R     | -     -     -     -          -"},
    {tsr,                                "A       R[1][2] A     A[8]  A[8]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {tsr_revocation,                     "A       R[1][2] A     A     A     | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {inhibit_revocable_tsr,              "-       -       -     -     -     | R[2]  R[2]  R[2]  A          A"},
    {default_gradient_tsr,               "A       R[1][2] A     A     A     | -     -     -     -          -"},
    {route_suitability,                  "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {adhesion,                           "R[1]    R[1]    A     R     R     | R[2]  R[2]  R[2]  A          A"},
    {plain_text,                         "A       R[1][2] A     A     A     | R[2]  R[2]  R[2]  A[12]      A[12]"},
    {fixed_text,                         "A       R[1][2] A     A     A     | R[2]  R[2]  R[2]  A[12]      A[12]"},
    {geo_position,                       "A       R[1][2] A     A     A     | R[2]  R[2]  R[2]  A          A"},
    {rbc_transition_order,               "R       R       R     A     A     | R     R     R     A[3]       A[3]"},
    {danger_for_sh,                      "A[13]   A[13]   A     A     A     | -     -     -     -          -"},
    {stop_sh_on_desk_opening,            "A       A       A     A     A     | -     -     -     -          -"},
    {radio_infill_area,                  "R       R       A     R[1]  R[1]  | -     -     -     -          -"},
    {session_management_riu,             "R       R       A     R     R     | -     -     -     -          -"},
    {eolm,                               "A       A       A     A     A     | -     -     -     -          -"},
    {coordinate_system_assignment,       "-       -       -     -     -     | A[10] A[10] A[10] A[10]      A[10]"},
    {infill_location_reference,          "R       R       A     R[1]  R[1]  | -     -     -     -          -"},
    {track_conditions_general,           "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {track_conditions_horn_stopping,     "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {track_condition_bmm,                "A       A       A     A     A     | -     -     -     -          -"},
    {location_identity,                  "A       A       A     A     A     | -     -     -     -          -"},
    {exit_trip_recognition,              "-       -       -     -     -     | R     R     R     A          A"},
    {train_data_ack,                     "-       -       -     -     -     | A     A     A     A          A"},
    {ma_shortening_request,              "-       -       -     -     -     | R     R     R     A[3][4][5] A[3][4][5]"},
    {unconditional_emergency_stop,       "-       -       -     -     -     | R[2]  R[2]  R[2]  A          A"},
    {conditional_emergency_stop,         "-       -       -     -     -     | R[2]  R[2]  R[2]  A          A"},
    {emergency_stop_revocation,          "-       -       -     -     -     | R     R     R     A          A"},
    {sh_refused,                         "-       -       -     -     -     | R     R     R     A[3]       A[3]"},
    {sh_authorised,                      "-       -       -     -     -     | R     R     R     A[3]       A[3]"},
    {trackside_system_version,           "A       A       A     A     A     | A     A     A     A          A"},
    {system_version_order,               "A       A       A     A     A     | -     -     -     -          -"},
    {track_ahead_free_request,           "-       -       -     -     -     | R     R     R     A[3]       A[3]"},
    {train_running_number,               "-       -       -     -     -     | R     R     R     A          A"},
    {session_initiation,                 "-       -       -     -     -     | R     R     R     A          A"},
    {session_termination_ack,            "A       A       A     A     A     | A     A     A     A          A"},
    {train_rejected,                     "-       -       -     -     -     | R     R     R     A          A"},
    {train_accepted,                     "-       -       -     -     -     | R     R     R     A          A"},
    {som_position_confirmed,             "-       -       -     -     -     | R     R     R     A          A"},
    {reversing_area,                     "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {reversing_supervision,              "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {default_balise_info,                "A       A       A     A     A     | -     -     -     -          -"},
    {taf_up_to_l23,                      "A[9]    A[9]    A[9]  R     R     | -     -     -     -          -"},
    {permitted_braking_distance,         "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {level_crossing,                     "R[1][2] R[1][2] A     A     A     | R[2]  R[2]  R[2]  A[3]       A[3]"},
    {vbc_order,                          "A       A       A     A     A     | -     -     -     -          -"},
    {generic_ls_marker,                  "A       A       A     A     A     | -     -     -     -          -"},
    {lssma_toggle_on,                    "R[1]    R[1]    A     R[1]  R[1]  | R[2]  R[2]  R[2]  A[3][5]    A[3][5]"},
    {lssma_toggle_off,                   "R       R       A     R     R     | R     R     R     A          A"},
    {external_application_data,          "A       A       A     A     A     | A     A     A     A          A"},
    {movement_authority_sm,               "-       -       -     -     -     | R     R     R     R          R"},
    {sm_refused,                          "-       -       -     -     -     | R     R     R     R          R"},
    {safe_consist_length_ack,             "-       -       -     -     -     | R     R     R     R          R"},
  });
}();

/// 4.8.4 of 3.6.0. In 3.4.0 the two texts are accepted in NL.
inline constexpr auto srs_4_8_4 = [] {
  using enum Information;
  return std::to_array<AcceptanceByMode>({
    //                                     NP SB      PS   SH   FS   LS SR   OS   SL NL UN   TR PT      SF IS SN   RV SM AD
    {national_values,                    "NR A[2]    A    A    A    A  A    A    A  A  A    A  A[1]    NR NR A    A A A"},
    {linking,                            "NR A[2][4] R    R    A    A  A    A    R  A  A    R  A[1]    NR NR A    R A A"},
    {signalling_speed,                   "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R R A"},
    {movement_authority,                 "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R R A"},
    {repositioning,                      "NR R       R    R    A    A  R    A    R  R  R    R  R       NR NR R    R R A"},
    {gradient,                           "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R A A"},
    {ssp,                                "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R A A"},
    {asp,                                "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R A A"},
    {level_transition_order,             "NR A[2]    A[7] A[7] A    A  A    A    A  A  A    A  A[1][5] NR NR A    R A[7] A"},
    {conditional_level_transition_order, "NR A[2]    A[7] A[7] A    A  A    A    A  A  A    A  A[1][5] NR NR A    R A[7] A"},
    {session_management,                 "NR A       A[3] A[3] A    A  A    A    A  A  A    A  A[1]    NR NR A    A A[12] A"},
    {radio_network_registration,         "NR A[2]    A    A    A    A  A    A    A  A  A    A  A[1]    NR NR A    A A A"},
    {ma_request_params,                  "NR A[2]    R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R R A"},
    {position_report_params,             "NR A[2]    R    R    A    A  A    A    R  A  A    R  A[1]    NR NR A    A A A"},
    {sr_authorisation,                   "NR A[2][4] R    R    R    R  A    R    R  R  R    R  A[1]    NR NR R    R R R"},
    {stop_if_in_sr,                      "NR R       R    R    R    R  A    R    R  R  R    R  R       NR NR R    R R R"},
    {sr_distance_loop,                   "NR R       R    R    R    R  A[6] R    R  R  R    R  R       NR NR R    R R R"},
    {tsr,                                "NR A[2][4] R    R    A    A  A    A    R  R  A    A  A[1]    NR NR A    R A A"},
    {tsr_revocation,                     "NR A[2][4] R    R    A    A  A    A    R  R  A    A  A[1]    NR NR A    R A A"},
    {inhibit_revocable_tsr,              "NR A[2]    R    R    A    A  A    A    R  R  A    A  A[1]    NR NR A    R A A"},
    {default_gradient_tsr,               "NR A[2][4] R    R    A    A  A    A    R  R  A    A  A[1]    NR NR A    R A A"},
    {route_suitability,                  "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R R A"},
    {adhesion,                           "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R A A"},
    {plain_text,                         "NR A[2]    R    R    A    A  A    A    R  R  A    A  A[1]    NR NR A    A A A"},
    {fixed_text,                         "NR A[2]    R    R    A    A  A    A    R  R  A    A  A[1]    NR NR A    A A A"},
    {geo_position,                       "NR A[2]    R    R    A    A  A    A    R  A  A    A  A[1]    NR NR A    R A A"},
    {rbc_transition_order,               "NR A[2][4] A[8] A[8] A    A  A    A    A  A  R    A  A[1]    NR NR R    R A A"},
    {danger_for_sh,                      "NR R       R    A    R    R  R    R    R  R  R    R  R       NR NR R    R R R"},
    {stop_sh_on_desk_opening,            "NR R       A    R    R    R  R    R    R  R  R    R  R       NR NR R    R R R"},
    {radio_infill_area,                  "NR R       R    R    A    A  A    A    R  R  R    R  R       NR NR R    R R A"},
    {session_management_riu,             "NR R       R    R    A    A  A    A    R  R  R    R  R       NR NR R    R R A"},
    {eolm,                               "NR R       R    A    A    A  A    A    A  A  A    A  R       NR NR A    A A A"},
    {coordinate_system_assignment,       "NR A[2]    R    R    R    R  A    R    R  A  A    R  A[1]    NR NR A    R A R"},
    {infill_location_reference,          "NR R       R    R    A    A  R    R    R  R  R    R  R       NR NR R    R R A"},
    {track_conditions_general,           "NR A[2][4] R    R    A    A  A    A    R  A  A    A  A[1]    NR NR A    R A A"},
    {track_conditions_horn_stopping,     "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R A A"},
    {track_condition_bmm,                "NR A[2][4] A    A    A    A  A    A    A  A  A    A  A[1]    NR NR A    R A A"},
    {location_identity,                  "NR A[2]    A    A    A    A  A    A    A  A  A    A  A       NR NR A    A A A"},
    {exit_trip_recognition,              "NR R       R    R    R    R  R    R    R  R  R    R  A       NR NR R    R R R"},
    {train_data_ack,                     "NR A[2]    R    R    A    A  A    A    R  R  A    A  A       NR NR A    A R A"},
    {ma_shortening_request,              "NR R       R    R    A    A  R    A    R  R  R    R  R       NR NR R    R R A"},
    {unconditional_emergency_stop,       "NR A[2]    R    R    A    A  A    A    R  R  A    R  R       NR NR A    R A A"},
    {conditional_emergency_stop,         "NR R       R    R    A    A  R    A    R  R  A    R  R       NR NR A    R A A"},
    {emergency_stop_revocation,          "NR R       R    R    A    A  R    A    R  R  R    R  A[1]    NR NR R    R A A"},
    {sh_refused,                         "NR A[2]    R    R    A    A  A    A    R  R  R    R  A[1]    NR NR R    R A A"},
    {sh_authorised,                      "NR A[2]    R    R    A    A  A    A    R  R  R    R  A[1]    NR NR R    R A A"},
    {trackside_system_version,           "NR A       A    A    A    A  A    A    A  A  A    A  A       NR NR A    A A A"},
    {system_version_order,               "NR A       A    A    A    A  A    A    A  A  A    A  A       NR NR A    A A A"},
    {track_ahead_free_request,           "NR A[2]    R    R    R    A  A    A    R  R  R    R  A[1]    NR NR R    R R R"},
    {train_running_number,               "NR A[2]    R    R    A    A  A    A    R  A  R    A  A       NR NR R    A A A"},
    {session_initiation,                 "NR A       R    R    A    A  A    A    A  A  R    A  A       NR NR R    A R A"},
    {session_termination_ack,            "NR A       A    A    A    A  A    A    A  A  A    A  A       NR NR A    A A A"},
    {train_rejected,                     "NR A[2]    R    R    R    R  R    R    R  R  R    R  R       NR NR R    R R R"},
    {train_accepted,                     "NR A[2]    R    R    R    R  R    R    R  R  R    R  R       NR NR R    R R R"},
    {som_position_confirmed,             "NR A[2]    R    R    R    R  R    R    R  R  R    R  R       NR NR R    R R R"},
    {reversing_area,                     "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    A R A"},
    {reversing_supervision,              "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    A R A"},
    {default_balise_info,                "NR A[2]    A    A    A    A  A    A    A  A  A    A  A       NR NR A    A A A"},
    {taf_up_to_l23,                      "NR A[2]    R    R    A    A  A    A    R  R  A    A  A       NR NR A    R R A"},
    {permitted_braking_distance,         "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R R A"},
    {level_crossing,                     "NR A[2][4] R    R    A    A  A    A    R  R  A    R  A[1]    NR NR A    R A A"},
    {vbc_order,                          "NR A       A    A    A    A  A    A    A  A  A    A  A       NR NR A    A A A"},
    {generic_ls_marker,                  "NR A       A    A    A    A  A    A    A  A  A    A  A       NR NR A    A A A"},
    {lssma_toggle_on,                    "NR R       R    R    A[9] A  A[9] A[9] R  R  A[9] R  R       NR NR A[9] R R A[9]"},
    {lssma_toggle_off,                   "NR R       R    R    R    A  R    R    R  R  R    R  R       NR NR R    R R R"},
    {external_application_data,          "NR A       A    A    A    A  A    A    A  A  A    A  A       NR NR A    A A A"},
    {movement_authority_sm,              "NR R       R    R    R    R  R    R    R  R  R    R  R       NR NR R    R R R"},
    {sm_refused,                         "NR R       R    R    R    R  R    R    R  R  R    R  R       NR NR R    R R R"},
    {safe_consist_length_ack,            "NR R       R    R    R    R  R    R    R  R  R    R  R       NR NR R    R R R"},
    {stm_max_speed,                      "NR A[2]    R    R    A    A  A    A    R  R  A    A  A[1]    NR NR A    R R A"},
    {stm_system_speed_distance,          "NR A[2]    R    R    A    A  A    A    R  R  A    A  A[1]    NR NR R    R R A"},
  });
}();

/// Information from a national system X (4.8.3, last part): level 0, NTC X, NTC Y, 1, 2, 3.
inline constexpr auto srs_4_8_3_stm = std::to_array<std::array<AcceptanceCell, 6>>({
    // maximum speed; system speed and distance
    {AcceptanceCell("A[7]"), AcceptanceCell("R"), AcceptanceCell("R[6]"), AcceptanceCell("A[7]"), AcceptanceCell("A[7]"), AcceptanceCell("A[7]")},
    {AcceptanceCell("A[7]"), AcceptanceCell("R"), AcceptanceCell("R"),    AcceptanceCell("A[7]"), AcceptanceCell("A[7]"), AcceptanceCell("A[7]")},
});
// clang-format on

}  // namespace evc::modes
