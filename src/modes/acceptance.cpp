#include "modes/acceptance.h"

#include <array>

#include "modes/acceptance_tables_v400.h"

namespace evc::modes {
namespace {

using Mark = AcceptanceCell::Mark;

static_assert(
    [] {
      for (std::size_t i = 0; i < srs_4_8_3.size(); ++i)
        if (static_cast<std::size_t>(srs_4_8_3[i].what) != i) return false;
      for (std::size_t i = 0; i < srs_4_8_4.size(); ++i)
        if (static_cast<std::size_t>(srs_4_8_4[i].what) != i) return false;
      return srs_4_8_4.size() == kInformation && srs_4_8_3.size() == kInformation - 2;
    }(),
    "one row for each information, in order; what an STM sends has its own table of levels");

constexpr Clause k483 = "4.8.3"_srs;
constexpr Clause k484 = "4.8.4"_srs;
constexpr std::size_t kNotes483 = 18;  // one more than the number of the last exception
constexpr std::size_t kNotes484 = 13;

constexpr Acceptance kAccepted{Verdict::accepted, {}};

/// The exceptions of 4.8.3 that reject what the cell accepts.
bool level_exception_rejects(std::size_t n, const AcceptanceContext& c) {
  switch (n) {
    case 3:
      return c.train_data_unacknowledged;
    case 4:
      return !c.described_over_whole_ma;
    case 5:
      return c.emergency_stop_pending;
    case 7:
      return c.announced != Level::NTC;
    case 8:
      return c.revocable_and_inhibited;
    case 9:
      return !level_2_or_3(c.announced);
    case 10:
      return c.other_previous_lrbg;
    case 11:
      return c.level_order_along_or_announced;
    case 12:
      return c.text_awaits_acknowledgement;
    case 13:
      return !c.immediate_order_to_1_2_3;
    case 14:
      return c.srs != SrsVersion::v3_4_0 && c.names_rbc_of_transition;
    case 15:
      return c.network_missing;
    case 17:
      return c.consist_length_unacknowledged;
    default:  // 16
      return c.unlinked_with_level_1;
  }
}

/// The exceptions of 4.8.3 that buffer what the cell rejects.
bool level_exception_buffers(std::size_t n, const AcceptanceContext& c) {
  switch (n) {
    case 1:
      return c.announced == Level::L1;
    case 2:
      return level_2_or_3(c.announced);
    default:  // 6
      return c.announced == Level::NTC;
  }
}

Acceptance judge_level_cell(const AcceptanceCell& cell, const AcceptanceContext& c) {
  for (std::size_t n = 1; n < kNotes483; ++n) {
    if (((cell.notes >> n) & 1u) == 0) continue;
    if (cell.mark == Mark::accepted && level_exception_rejects(n, c)) return {Verdict::rejected, k483.exception(n)};
    if (cell.mark == Mark::rejected && level_exception_buffers(n, c)) return {Verdict::buffered, k483.exception(n)};
  }
  return cell.mark == Mark::accepted ? kAccepted : Acceptance{Verdict::rejected, k483};
}

/// The exceptions of 4.8.4 that reject what the cell accepts.
bool mode_exception_rejects(std::size_t n, const AcceptanceContext& c) {
  switch (n) {
    case 1:  // level 1: always; levels 2 and 3: until the exit from trip is recognised, and older information
      return !level_2_or_3(c.level) || !c.exit_from_trip_recognised;
    case 2:
      return !c.desk_open;
    case 4:
      return !c.train_data_valid;
    case 5:
      return c.order != OrderKind::announcement;
    case 6:
      return c.override_active;
    case 7:
      return c.order == OrderKind::announcement;
    case 8:
      return !c.null_distance;
    case 9:
      return !c.front_in_ls_area_of_message;
    case 10:
      return !c.front_in_ls_area_of_message || c.front_in_OS_ack_area;
    case 11:
      return !c.train_running_number;
    case 12:
      return c.orders_establishment;
    default:
      return false;
  }
}

/// The exceptions of 4.8.4 that let only a part of the information through.
Verdict mode_exception_verdict(std::size_t n, const AcceptanceContext& c) {
  if (n == 3 && c.orders_establishment) return Verdict::only_contact_stored;
  if (n == 7) return Verdict::order_stored;
  if (n == 8) return Verdict::only_contact_stored;
  return Verdict::accepted;
}

bool speaks_for_both_rbcs(Information information, SrsVersion srs) {
  switch (information) {
    case Information::train_data_ack:
    case Information::trackside_system_version:
    case Information::session_management:
    case Information::session_termination_ack:
      return true;
    case Information::session_initiation:
      return srs == SrsVersion::v3_4_0;
    default:
      return false;
  }
}

bool only_of_supervising_rbc(Information information, SrsVersion srs) {
  switch (information) {
    case Information::ma_shortening_request:
    case Information::emergency_stop_revocation:
      return true;
    case Information::lssma_toggle_on:
    case Information::lssma_toggle_off:
      return srs != SrsVersion::v3_4_0;
    case Information::rbc_transition_order:
      return srs == SrsVersion::v4_0_0;
    default:
      return false;
  }
}

}  // namespace

Acceptance accept_by_level(Information information, const AcceptanceContext& c) {
  const std::size_t i = static_cast<std::size_t>(information);
  if (i >= srs_4_8_3.size()) return {Verdict::rejected, k483};
  // 3.6.0 has no initiation of a session by the RBC.
  if (information == Information::session_initiation && c.srs != SrsVersion::v3_4_0) return {Verdict::rejected, k483};
  const AcceptanceByLevel& row = (c.srs == SrsVersion::v4_0_0 ? srs_4_8_3_v400 : srs_4_8_3)[i];
  return judge_level_cell((c.medium == Medium::rbc ? row.rbc : row.not_rbc)[static_cast<std::size_t>(c.level)], c);
}

Acceptance accept_by_rbc(Information information, const AcceptanceContext& c) {
  if (c.medium != Medium::rbc || c.rbc == SessionRole::supervising) return kAccepted;
  if (c.rbc == SessionRole::handing_over) {  // from the former RBC only the end of the session is accepted (3.15.1.3)
    const bool ends = (information == Information::session_management && !c.orders_establishment) ||
                      information == Information::session_termination_ack;
    return ends ? kAccepted : Acceptance{Verdict::rejected, "4.8.2.1"_srs};
  }
  if (speaks_for_both_rbcs(information, c.srs)) return kAccepted;
  if (only_of_supervising_rbc(information, c.srs)) return {Verdict::rejected, "4.8.2.1"_srs};
  return {Verdict::buffered, "4.8.2.1"_srs};
}

Acceptance accept_by_mode(Information information, const AcceptanceContext& c) {
  if (c.infill && c.mode != Mode::FS && c.mode != Mode::AD && c.mode != Mode::LS)
    return {Verdict::rejected, "4.8.4 infill"_srs};
  const auto& table = c.srs == SrsVersion::v4_0_0 ? srs_4_8_4_v400 : srs_4_8_4;
  const AcceptanceCell& cell = table[static_cast<std::size_t>(information)].modes[static_cast<std::size_t>(c.mode)];
  const bool text = information == Information::plain_text || information == Information::fixed_text;
  if (text && c.mode == Mode::NL && c.srs == SrsVersion::v3_4_0) return kAccepted;
  if (cell.mark != Mark::accepted) return {Verdict::rejected, k484};
  Acceptance out = kAccepted;
  for (std::size_t n = 1; n < kNotes484; ++n) {
    if (((cell.notes >> n) & 1u) == 0) continue;
    if (mode_exception_rejects(n, c)) return {Verdict::rejected, k484.exception(n)};
    const Verdict verdict = mode_exception_verdict(n, c);
    if (verdict != Verdict::accepted) out = {verdict, k484.exception(n)};
  }
  return out;
}

Acceptance accept(Information information, const AcceptanceContext& c) {
  const Acceptance level = accept_by_level(information, c);
  if (level.verdict != Verdict::accepted) return level;
  const Acceptance rbc = accept_by_rbc(information, c);
  if (rbc.verdict != Verdict::accepted) return rbc;
  return accept_by_mode(information, c);
}

Acceptance accept_from_stm(Information information, bool own_level_ntc, bool announced_own,
                           const AcceptanceContext& c) {
  if (information != Information::stm_max_speed && information != Information::stm_system_speed_distance)
    return {Verdict::rejected, k483};
  const std::size_t row = information == Information::stm_max_speed ? 0 : 1;
  const std::size_t level = static_cast<std::size_t>(c.level);
  // Columns 0, NTC X, NTC Y, 1, 2, 3.
  const std::size_t column = c.level == Level::L0 ? 0 : c.level == Level::NTC ? (own_level_ntc ? 1u : 2u) : level + 1;
  AcceptanceContext own = c;
  own.announced = announced_own ? std::optional<Level>(Level::NTC) : std::nullopt;
  const Acceptance by_level = judge_level_cell(srs_4_8_3_stm[row][column], own);
  return by_level.verdict == Verdict::accepted ? accept_by_mode(information, c) : by_level;
}

}  // namespace evc::modes
