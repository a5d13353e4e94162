#pragma once
#include "procedures/observe.h"

// The conditions of 4.6.3 as formulas over the facts, once for all who evaluate them: the cycle with the facts
// themselves (observe), an explanation with facts that remember their names (explain/why.h).
namespace evc::procedures {

/// Calls `give(n, holds)` for every condition [n] in the order of the standard. `f` has the members of Facts.
template <class F, class Give>
constexpr void conditions_of(const F& f, Give give) {
  const auto in_1 = f.level == Level::L1;
  const auto in_2_3 = level_2_or_3(f.level);
  const auto in_0_ntc = !level_1_2_3(f.level);
  const auto to_0 = f.level_switched_to == Level::L0;
  const auto to_ntc = f.level_switched_to == Level::NTC;
  const auto to_1 = f.level_switched_to == Level::L1;
  const auto to_2_3 = level_2_or_3(f.level_switched_to);
  const auto to_1_2_3 = to_1 || to_2_3;
  // An acknowledgement counts only with its request (4.6.3: "is requested and").
  const auto acknowledges = [&](Ack ack) { return f.requested.has(ack) && f.acknowledged.has(ack); };
  const auto acknowledges_trip = acknowledges(Ack::trip) && f.standstill;
  const auto desks_closed = !f.desk_open;
  // After an acknowledgement ahead of the area, the train stays in OS or LS and does not return to FS (4.0.0 [75],
  // [76]).
  const auto held_by_ack_area = (f.mode_is_OS && f.front_in_OS_ack_area) || (f.mode_is_LS && f.front_in_LS_ack_area);
  const auto full = f.ma_ssp_gradient_stored && !f.profile_in_force;

  // An MA whose SSP or gradient does not begin at the train gives no mode by [25], [34], [61] or [71]. It is treated as
  // no MA, because UN and SN must not continue in a level to which they do not belong.
  const auto usable_ma = f.ma_accepted && f.ma_ssp_gradient_stored;

  // What the driver is asked for or may select is of the level before: where the level changes in the same cycle, it
  // counts only for a mode that the new level has (4.4).
  // clang-format off
  give( 1, f.isolated);
  give( 2, f.desk_open);
  give( 3, !f.sleeping && f.standstill);
  give( 4, f.powered);
  give( 5, f.standstill && (in_0_ntc || in_1) && f.selects_SH);
  give( 6, f.standstill && in_2_3 && f.SH_granted);
  give( 7, acknowledges_trip && !in_0_ntc);
  give( 8, acknowledges(Ack::SR) && !in_0_ntc);
  give(10, f.train_data_valid && full);
  give(12, in_1 && f.min_safe_antenna_beyond_eoa);
  give(13, f.safety_fault);
  give(14, f.sleeping && f.standstill && desks_closed);
  give(15, acknowledges(Ack::OS) && !in_0_ntc);
  give(16, in_2_3 && f.min_safe_front_beyond_eoa);
  give(17, f.linking_reaction_trip);
  give(18, f.trip_order && !f.override_active);
  give(19, f.standstill && f.selects_exit_SH);
  give(20, f.ues_accepted);
  give(21, to_0);
  give(22, f.desk_open && f.stop_shunting_stored);
  give(23, f.desk_open && !f.stop_shunting_stored);
  give(25, to_1_2_3 && full);
  give(26, desks_closed && f.continue_shunting && f.passive_shunting);
  give(27, desks_closed && !f.continue_shunting);
  give(28, desks_closed);
  give(29, !f.powered);
  give(30, desks_closed && !f.passive_shunting);
  give(31, in_2_3 && full && !held_by_ack_area);
  give(32, in_1 && full && !held_by_ack_area && !f.ma_with_trip_order);
  give(34, to_1_2_3 && f.profile_demands_OS);
  give(35, f.selects_SH && f.national_trip);
  give(36, f.group_passed_not_in_SR_list && !f.override_active);
  give(37, f.selects_override && !in_0_ntc);
  give(38, (to_0 || to_1_2_3) && f.national_trip);
  give(39, to_1_2_3 && !usable_ma);
  give(40, f.profile_demands_OS);
  give(41, f.T_NVCONTACT_trip);
  give(42, f.SR_distance_passed && !f.override_active);
  give(43, f.former_eoa_passed && !f.override_active);
  give(44, to_1 && f.override_active);
  give(45, to_2_3 && f.override_active && !f.ues_received);
  give(46, f.standstill && f.non_leading && f.selects_NL);
  give(47, f.standstill && !f.non_leading);
  give(49, f.stop_if_in_SH && !f.override_active);
  give(50, acknowledges(Ack::SH));
  give(51, f.profile_demands_SH);
  give(52, f.group_passed_not_in_SH_list && !f.override_active);
  give(54, f.stop_if_in_SR && !f.group_passed_in_SR_list && !f.override_active);
  give(56, to_ntc && !f.level_order_changed_national_system_only);
  give(58, f.level == Level::NTC && acknowledges(Ack::SN));
  give(59, f.standstill && acknowledges(Ack::RV) && !in_0_ntc);
  give(60, acknowledges(Ack::UN) && f.level == Level::L0);
  give(61, to_1_2_3 && f.profile_demands_SH);
  give(62, acknowledges_trip && f.level == Level::L0 && f.train_data_valid);
  give(63, acknowledges_trip && f.level == Level::NTC && f.train_data_valid);
  give(65, !in_0_ntc && f.telegram_version_too_high);
  give(66, f.linked_group_wrong_direction);
  give(67, to_1 && f.trip_order && !f.override_active);
  give(68, acknowledges_trip && in_0_ntc && !f.train_data_valid);
  give(69, f.front_in_rear_of_track_description);
  give(70, acknowledges(Ack::LS) && !in_0_ntc);
  give(71, to_1_2_3 && f.profile_demands_LS);
  give(72, f.profile_demands_LS);
  give(73, f.profile_demands_OS && !f.front_in_LS_ack_area);
  give(74, f.profile_demands_LS && !f.front_in_OS_ack_area);
  // clang-format on
}

/// The same for the conditions that 4.0.0 has and 3.x has not.
template <class F, class Give>
constexpr void conditions_of_4_0_0(const F& f, Give give) {
  const auto to_0 = f.level_switched_to == Level::L0;
  const auto to_ntc = f.level_switched_to == Level::NTC;
  const auto described = f.ma_ssp_gradient_stored;
  // clang-format off
  give( 9, described && f.level_crossing_approach_shown);
  give(11, level_2_or_3(f.level) && f.group_at_eoa_in_RSM);
  give(24, described && f.brake_commanded);
  give(33, described && !f.AD_requested);
  give(48, described && !f.described_for_whole_train);
  give(53, described && f.ATO_disengaged);
  // An authorisation for a supervised manoeuvre takes the place of the mode profile: it leads to SM alone.
  give(75, !f.front_in_OS_ack_area && !f.profile_in_force && !f.SM_authorised);
  give(76, !f.front_in_LS_ack_area && !f.profile_in_force && !f.SM_authorised);
  give(77, to_0 && f.train_data_valid);
  give(78, (to_0 || to_ntc) && !f.train_data_valid);
  give(79, to_ntc && f.train_data_valid);
  give(80, f.AD_requested && f.described_for_whole_train && !f.brake_commanded && f.selects_ATO_engage);
  give(81, f.SM_authorised);
  give(82, f.selects_exit_SM && f.standstill);
  give(83, f.train_data_valid && f.consist_in_front);
  give(84, f.odometer_beyond_threshold);
  // clang-format on
}

}  // namespace evc::procedures
