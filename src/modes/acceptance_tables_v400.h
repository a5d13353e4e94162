#pragma once
#include "modes/acceptance_tables.h"

// 4.8.3 and 4.8.4 of SRS 4.0.0: the tables of 3.6.0 with the cells that differ. Left out are [13] and [14] of 4.8.4: an
// answer that does not name the last request for a supervised manoeuvre is refused as a whole before
// (kernel/intake/manoeuvre.h). [18], a zero speed by infill, is ignored in every edition
// (3.11.6.5).
namespace evc::modes {

struct ModeCellChange {
  Information what{};
  Mode mode{};
  std::string_view cell;
};

/// A cell of 4.8.3.
struct LevelCellChange {
  Information what{};
  Level level{};
  std::string_view cell;
};

// clang-format off
inline constexpr auto srs_4_8_4_changes_v400 = [] {
  using enum Information;
  return std::to_array<ModeCellChange>({
    // [4] in PT too: without valid train data nothing that depends on them counts.
    {linking,                        Mode::PT, "A[1][4]"},
    {signalling_speed,               Mode::PT, "A[1][4]"},
    {movement_authority,             Mode::PT, "A[1][4]"},
    {gradient,                       Mode::PT, "A[1][4]"},
    {ssp,                            Mode::PT, "A[1][4]"},
    {asp,                            Mode::PT, "A[1][4]"},
    {sr_authorisation,               Mode::PT, "A[1][4]"},
    {tsr,                            Mode::PT, "A[1][4]"},
    {tsr_revocation,                 Mode::PT, "A[1][4]"},
    {route_suitability,              Mode::PT, "A[1][4]"},
    {adhesion,                       Mode::PT, "A[1][4]"},
    {rbc_transition_order,           Mode::PT, "A[1][4]"},
    {track_conditions_general,       Mode::PT, "A[1][4]"},
    {track_conditions_horn_stopping, Mode::PT, "A[1][4]"},
    {track_condition_bmm,            Mode::PT, "A[1][4]"},
    {reversing_area,                 Mode::PT, "A[1][4]"},
    {reversing_supervision,          Mode::PT, "A[1][4]"},
    {permitted_braking_distance,     Mode::PT, "A[1][4]"},
    {level_crossing,                 Mode::PT, "A[1][4]"},
    // [11]: not without a running number.
    {movement_authority,             Mode::SB, "A[2][4][11]"},
    {sr_authorisation,               Mode::SB, "A[2][4][11]"},
    {eolm,                           Mode::SH, "R"},
    {lssma_toggle_on,                Mode::OS, "A[10]"},
    // Supervised manoeuvre.
    {movement_authority_sm,          Mode::SB, "A[2]"},
    {movement_authority_sm,          Mode::SM, "A"},
    {movement_authority_sm,          Mode::FS, "A"},
    {movement_authority_sm,          Mode::AD, "A"},
    {movement_authority_sm,          Mode::LS, "A"},
    {movement_authority_sm,          Mode::SR, "A"},
    {movement_authority_sm,          Mode::OS, "A"},
    {movement_authority_sm,          Mode::PT, "A[1]"},
    {sm_refused,                     Mode::SB, "A[2]"},
    {sm_refused,                     Mode::SM, "A"},
    {sm_refused,                     Mode::FS, "A"},
    {sm_refused,                     Mode::AD, "A"},
    {sm_refused,                     Mode::LS, "A"},
    {sm_refused,                     Mode::SR, "A"},
    {sm_refused,                     Mode::OS, "A"},
    {sm_refused,                     Mode::PT, "A[1]"},
    {safe_consist_length_ack,        Mode::SB, "A"},
    {safe_consist_length_ack,        Mode::SM, "A"},
    {safe_consist_length_ack,        Mode::FS, "A"},
    {safe_consist_length_ack,        Mode::AD, "A"},
    {safe_consist_length_ack,        Mode::LS, "A"},
    {safe_consist_length_ack,        Mode::SR, "A"},
    {safe_consist_length_ack,        Mode::OS, "A"},
    {safe_consist_length_ack,        Mode::TR, "A"},
    {safe_consist_length_ack,        Mode::PT, "A"},
  });
}();

inline constexpr auto srs_4_8_3_changes_v400 = [] {
  using enum Information;
  return std::to_array<LevelCellChange>({
    // [15]: no call to an RBC with an order for a network that is not the one of a terminal.
    {session_management,                 Level::L0, "A[15]"},
    {session_management,                 Level::NTC, "A[15]"},
    {session_management,                 Level::L1, "A[15]"},
    {session_management,                 Level::L2, "A[14][15]"},
    {rbc_transition_order,               Level::L2, "A[15]"},
    {radio_infill_area,                  Level::L1, "A[15]"},
    {session_management_riu,             Level::L1, "A[15]"},
    // [16]: not from a group that is marked as unlinked, with level 1 in its table.
    {level_transition_order,             Level::L2, "A[16]"},
    {conditional_level_transition_order, Level::L2, "A[11][16]"},
  });
}();
/// The same of information from the RBC.
inline constexpr auto srs_4_8_3_changes_of_rbc_v400 = [] {
  using enum Information;
  return std::to_array<LevelCellChange>({
    {session_management,                 Level::L0, "A[15]"},
    {session_management,                 Level::NTC, "A[15]"},
    {session_management,                 Level::L1, "A[15]"},
    {session_management,                 Level::L2, "A[15]"},
    {rbc_transition_order,               Level::L2, "A[3][15][17]"},
    // An RBC of 3.0 sends it, one of 2.3 with an SM authorisation.
    {track_condition_bmm,                Level::L0, "R[2]"},
    {track_condition_bmm,                Level::NTC, "R[2]"},
    {track_condition_bmm,                Level::L1, "R[2]"},
    {track_condition_bmm,                Level::L2, "A[17]"},
    // [17]: not while a safe consist length waits for its acknowledgement.
    {linking,                             Level::L2, "A[3][17]"},
    {gradient,                            Level::L2, "A[3][17]"},
    {ssp,                                 Level::L2, "A[3][17]"},
    {asp,                                 Level::L2, "A[3][17]"},
    {tsr,                                 Level::L2, "A[3][17]"},
    {tsr_revocation,                      Level::L2, "A[3][17]"},
    {route_suitability,                   Level::L2, "A[3][17]"},
    {track_conditions_general,            Level::L2, "A[3][17]"},
    {track_conditions_horn_stopping,      Level::L2, "A[3][17]"},
    {level_crossing,                      Level::L2, "A[3][17]"},
    {movement_authority_sm,               Level::L2, "A[4][5][17]"},
    {sm_refused,                          Level::L2, "A"},
    {safe_consist_length_ack,             Level::L2, "A"},
  });
}();
// clang-format on

inline constexpr auto srs_4_8_4_v400 = [] {
  auto table = srs_4_8_4;
  for (const ModeCellChange& change : srs_4_8_4_changes_v400)
    table[static_cast<std::size_t>(change.what)].modes[terms::index(change.mode)] = AcceptanceCell(change.cell);
  return table;
}();

inline constexpr auto srs_4_8_3_v400 = [] {
  auto table = srs_4_8_3;
  for (const LevelCellChange& change : srs_4_8_3_changes_v400)
    table[static_cast<std::size_t>(change.what)].not_rbc[terms::index(change.level)] = AcceptanceCell(change.cell);
  for (const LevelCellChange& change : srs_4_8_3_changes_of_rbc_v400)
    table[static_cast<std::size_t>(change.what)].rbc[terms::index(change.level)] = AcceptanceCell(change.cell);
  return table;
}();

}  // namespace evc::modes
