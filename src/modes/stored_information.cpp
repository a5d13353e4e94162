#include "modes/stored_information.h"

namespace evc::modes {
namespace {

constexpr std::size_t index(Mode mode) { return static_cast<std::size_t>(mode); }

/// Where 3.4.0 differs from the table.
Fate of_3_4_0(Mode to, Stored stored, Fate fate) {
  if (to == Mode::NL && (stored == Stored::plain_text || stored == Stored::fixed_text)) return Fate::unchanged;
  if ((to == Mode::UN || to == Mode::SN) && stored == Stored::rbc_id_phone) return Fate::deleted;
  return fate;
}

struct FateChange {
  Stored what{};
  Mode to{};
  Fate fate{};
};

/// The cells of 4.10.1.3 of 4.0.0 that differ; its row of announced level transitions has no exceptions [1] and [2].
constexpr auto srs_4_10_changes_v400 = std::to_array<FateChange>({
    {Stored::eolm, Mode::PS, Fate::deleted},
    {Stored::eolm, Mode::SH, Fate::deleted},
    {Stored::train_data, Mode::NL, Fate::to_be_revalidated},
});

Fate of_4_0_0(Mode to, Stored stored, Fate fate) {
  for (const FateChange& change : srs_4_10_changes_v400)
    if (change.what == stored && change.to == to) return change.fate;
  return fate;
}

/// The row of 4.0.0 for an immediate or conditional level order that waits.
constexpr StoredRow kKeptOrder{Stored::level_transition_order,
                               //  NP SB PS SH FS LS SR OS SL NL UN TR PT SF IS SN RV SM AD
                               "U  U  U  U  D  D  D  D  U  U  D  U  D  NR NR D  D  D  D"};

}  // namespace

Fate on_entry(Mode to, Mode from, Stored stored, SrsVersion srs) {
  const StoredRow::Cell& cell = srs_4_10[static_cast<std::size_t>(stored)].on_entry[index(to)];
  if (srs == SrsVersion::v4_0_0) return of_4_0_0(to, stored, cell.fate);
  if ((cell.notes & 2u) != 0 && from == Mode::SH) return Fate::unchanged;
  if ((cell.notes & 4u) != 0 && from == Mode::PS) return Fate::unchanged;
  return srs == SrsVersion::v3_4_0 ? of_3_4_0(to, stored, cell.fate) : cell.fate;
}

Fate kept_level_order_on_entry(Mode to, Mode from, SrsVersion srs) {
  if (srs != SrsVersion::v4_0_0) return on_entry(to, from, Stored::level_transition_order, srs);
  return kKeptOrder.on_entry[index(to)].fate;
}

Fate on_level_entry(Level to, Stored stored) {
  using enum Stored;
  const bool to_0_ntc_1 = to == Level::L0 || to == Level::NTC || to == Level::L1;
  if (to_0_ntc_1 && stored == inhibit_revocable_tsr) return Fate::deleted;
  const bool rbc_only =
      stored == ma_request_params || stored == position_report_params || stored == track_ahead_free_request;
  return to == Level::L1 && rbc_only ? Fate::deleted : Fate::unchanged;
}

Fate on_desk_closed_in_start_of_mission(Stored stored) {
  switch (stored) {
    using enum Stored;
    case national_values:
    case stop_sh_on_desk_opening:
    case ma_request_params:
    case position_report_params:
    case geo_position:
    case eolm:
    case train_position:
    case level:
    case trackside_level_table:
    case radio_network_id:
    case rbc_id_phone:
    case rbc_riu_version:
    case operated_version:
    case vbc:
    case dmi_language:
    case generic_ls_marker:
      return Fate::unchanged;
    case track_conditions_general:
    case track_conditions_horn_stopping:
    case track_condition_bmm:
      return Fate::reset;
    case train_data:
    case driver_id:
    case train_running_number:
      return Fate::to_be_revalidated;
    default:
      return Fate::deleted;
  }
}

DataStatus on_exit_np(ColdMovement movement, Stored stored) {
  switch (stored) {
    using enum Stored;
    case eolm:
    case trackside_level_table:
      return movement == ColdMovement::none ? DataStatus::valid : DataStatus::unknown;
    case train_position:
    case level:
    case rbc_id_phone:
      return movement == ColdMovement::none ? DataStatus::valid : DataStatus::invalid;
    default:
      return DataStatus::valid;
  }
}

}  // namespace evc::modes
