#pragma once
#include <cstdint>

#include "base/inplace_vector.h"
#include "modes/conditions.h"
#include "procedures/observe.h"
#include "terms/requests.h"

// Why a condition of 4.6.3 holds or not: the facts that decide it.
namespace evc::explain {

/// A member of Facts, or what a condition asks of its levels and acknowledgements.
enum class Fact : std::uint8_t {
  isolated,
  powered,
  desk_open,
  standstill,
  sleeping,
  non_leading,
  passive_shunting,
  safety_fault,
  level_0,
  level_NTC,
  level_1,
  level_2_or_3,
  level_1_2_3,
  level_becomes_0,
  level_becomes_NTC,
  level_becomes_1,
  level_becomes_2_or_3,
  national_system_only,
  requested,     ///< with `ack`
  acknowledged,  ///< with `ack`
  selects_SH,
  selects_exit_SH,
  selects_NL,
  selects_override,
  train_data_valid,
  ma_ssp_gradient_stored,
  ma_accepted,
  ma_with_trip_order,
  profile_demands_OS,
  profile_demands_LS,
  profile_demands_SH,
  profile_in_force,
  front_in_OS_ack_area,
  front_in_LS_ack_area,
  mode_is_OS,
  mode_is_LS,
  min_safe_antenna_beyond_eoa,
  min_safe_front_beyond_eoa,
  group_at_eoa_in_RSM,
  front_in_rear_of_track_description,
  linking_reaction_trip,
  linked_group_wrong_direction,
  telegram_version_too_high,
  trip_order,
  stop_if_in_SH,
  stop_if_in_SR,
  group_passed_not_in_SH_list,
  group_passed_not_in_SR_list,
  group_passed_in_SR_list,
  ues_accepted,
  ues_received,
  T_NVCONTACT_trip,
  SH_granted,
  override_active,
  former_eoa_passed,
  SR_distance_passed,
  continue_shunting,
  stop_shunting_stored,
  national_trip,
  level_crossing_approach_shown,
  brake_commanded,
  AD_requested,
  described_for_whole_train,
  selects_ATO_engage,
  ATO_disengaged,
  SM_authorised,
  selects_exit_SM,
  consist_in_front,
  odometer_beyond_threshold,
  count
};

/// A fact in a formula, and whether it is so. Of the literals of an explanation those with one `choice` are
/// alternatives: a change of any of them counts; of the others each has to change.
struct Literal {
  Fact fact{};
  bool holds = false;
  Ack ack{};
  std::uint8_t choice = 0;
  friend constexpr bool operator==(const Literal&, const Literal&) = default;
};
using Literals = InplaceVector<Literal, 12>;

/// A condition, and what would have to change for the contrary.
struct Reason {
  std::uint8_t number = 0;
  bool holds = false;
  Literals because;
};
using Reasons = InplaceVector<Reason, modes::srs_4_6_3.size() + modes::srs_4_6_3_v400.size()>;

/// Every condition of 4.6.3, in the order of the standard, those that only 4.0.0 has behind them: the formulas of
/// observe().
Reasons reasons(const procedures::Facts& facts, SrsVersion srs = SrsVersion::v3_6_0);

}  // namespace evc::explain
