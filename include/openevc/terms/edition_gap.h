#pragma once
#include "openevc/terms/clause.h"
#include "openevc/terms/row.h"

namespace evc {

/// What SRS 4.0.0 requires and the unit does not do, or does otherwise: of the register of requirements the clauses
/// that are "4.0.0 only", and of those "deliberately otherwise" the ones that 4.0.0 changed.
/// tools/check_requirements.py compares the table with the register. An event at power-up names each.
enum class EditionGap : std::uint8_t {
  choice_of_radio_system,
  radio_system_kept,
  default_network_type,
  single_reference,
  three_places,
  recomposed_profiles,
  override_of_stm,
  tsr_with_operated_X_1,
  tsr_with_operated_X_2,
  count
};

struct EditionGapRow {
  EditionGap value;
  Clause clause;
  const char* name;
};

inline constexpr auto kEditionGapRows = std::to_array<EditionGapRow>({
    {EditionGap::choice_of_radio_system, "3.5.3.7.1"_srs, "the choice between FRMCS and GSM-R"},
    {EditionGap::radio_system_kept, "3.5.3.7.2"_srs, "the radio system of the last connection"},
    {EditionGap::default_network_type, "3.5.6.4"_srs, "the default type of the radio network"},
    {EditionGap::single_reference, "3.6.4.2.2"_srs, "one reference group of the train and of all data"},
    {EditionGap::three_places, "3.6.4.2.4"_srs, "min, estimated and max place of each location"},
    {EditionGap::recomposed_profiles, "3.6.4.2.6"_srs, "profiles put in order again"},
    {EditionGap::override_of_stm, "5.8.3.7.1"_srs, "override by an STM"},
    {EditionGap::tsr_with_operated_X_1, "6.6.2.1.3"_srs, "TSR by the estimated front end with X = 1"},
    {EditionGap::tsr_with_operated_X_2, "6.6.4.1.2"_srs, "TSR by the estimated front end with X = 2"},
});
static_assert(terms::in_order(kEditionGapRows) && kEditionGapRows.size() == terms::index(EditionGap::count));

/// The clauses alone, in the order of the enumeration: the kernel does not link the names.
inline constexpr auto kEditionGapClauses = [] {
  std::array<Clause, kEditionGapRows.size()> clauses{};
  for (std::size_t i = 0; i < clauses.size(); ++i) clauses[i] = kEditionGapRows[i].clause;
  return clauses;
}();

}  // namespace evc
