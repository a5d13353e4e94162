#include "procedures/observe.h"

namespace evc::procedures {
modes::Conditions observe(const Facts& f) {
  const bool in_1 = f.level == Level::L1;
  const bool in_2_3 = level_2_or_3(f.level);
  const bool in_0_ntc = !level_1_2_3(f.level);
  const bool to_0 = f.level_switched_to == Level::L0;
  const bool to_ntc = f.level_switched_to == Level::NTC;
  const bool to_1 = f.level_switched_to == Level::L1;
  const bool to_2_3 = f.level_switched_to.has_value() && level_2_or_3(*f.level_switched_to);
  const bool to_1_2_3 = to_1 || to_2_3;
  // An acknowledgement counts only with its request (4.6.3: "is requested and").
  const auto acknowledges = [&](Ack ack) { return f.requested.has(ack) && f.acknowledged.has(ack); };
  const bool acknowledges_trip = acknowledges(Ack::trip) && f.standstill;
  const bool desks_closed = !f.desk_open;
  // After an acknowledgement ahead of the area, the train stays in OS or LS and does not return to FS (4.0.0 [75],
  // [76]).
  const bool held_by_ack_area = (f.mode_is_OS && f.front_in_OS_ack_area) || (f.mode_is_LS && f.front_in_LS_ack_area);
  const bool full = f.ma_ssp_gradient_stored && !f.profile_in_force;

  // An MA whose SSP or gradient does not begin at the train gives no mode by [25], [34], [61] or [71]. It is treated as
  // no MA, because UN and SN must not continue in a level to which they do not belong.
  const bool usable_ma = f.ma_accepted && f.ma_ssp_gradient_stored;

  modes::Conditions c;
  // What the driver is asked for or may select is of the level before: where the level changes in the same cycle, it
  // counts only for a mode that the new level has (4.4).
  // clang-format off
  c.set( 1, f.isolated);
  c.set( 2, f.desk_open);
  c.set( 3, !f.sleeping && f.standstill);
  c.set( 4, f.powered);
  c.set( 5, f.standstill && (in_0_ntc || in_1) && f.selects_SH);
  c.set( 6, f.standstill && in_2_3 && f.SH_granted);
  c.set( 7, acknowledges_trip && !in_0_ntc);
  c.set( 8, acknowledges(Ack::SR) && !in_0_ntc);
  c.set(10, f.train_data_valid && full);
  c.set(12, in_1 && f.min_safe_antenna_beyond_eoa);
  c.set(13, f.safety_fault);
  c.set(14, f.sleeping && f.standstill && desks_closed);
  c.set(15, acknowledges(Ack::OS) && !in_0_ntc);
  c.set(16, in_2_3 && (f.min_safe_front_beyond_eoa || f.group_at_eoa_in_RSM));
  c.set(17, f.linking_reaction_trip);
  c.set(18, f.trip_order && !f.override_active);
  c.set(19, f.standstill && f.selects_exit_SH);
  c.set(20, f.ues_accepted);
  c.set(21, to_0);
  c.set(22, f.desk_open && f.stop_shunting_stored);
  c.set(23, f.desk_open && !f.stop_shunting_stored);
  c.set(25, to_1_2_3 && full);
  c.set(26, desks_closed && f.continue_shunting && f.passive_shunting);
  c.set(27, desks_closed && !f.continue_shunting);
  c.set(28, desks_closed);
  c.set(29, !f.powered);
  c.set(30, desks_closed && !f.passive_shunting);
  c.set(31, in_2_3 && full && !held_by_ack_area);
  c.set(32, in_1 && full && !held_by_ack_area && !f.ma_with_trip_order);
  c.set(34, to_1_2_3 && f.profile_demands_OS);
  c.set(35, f.selects_SH && f.national_trip);
  c.set(36, f.group_passed_not_in_SR_list && !f.override_active);
  c.set(37, f.selects_override && !in_0_ntc);
  c.set(38, (to_0 || to_1_2_3) && f.national_trip);
  c.set(39, to_1_2_3 && !usable_ma);
  c.set(40, f.profile_demands_OS);
  c.set(41, f.T_NVCONTACT_trip);
  c.set(42, f.SR_distance_passed && !f.override_active);
  c.set(43, f.former_eoa_passed && !f.override_active);
  c.set(44, to_1 && f.override_active);
  c.set(45, to_2_3 && f.override_active && !f.ues_received);
  c.set(46, f.standstill && f.non_leading && f.selects_NL);
  c.set(47, f.standstill && !f.non_leading);
  c.set(49, f.stop_if_in_SH && !f.override_active);
  c.set(50, acknowledges(Ack::SH));
  c.set(51, f.profile_demands_SH);
  c.set(52, f.group_passed_not_in_SH_list && !f.override_active);
  c.set(54, f.stop_if_in_SR && !f.group_passed_in_SR_list && !f.override_active);
  c.set(56, to_ntc && !f.level_order_changed_national_system_only);
  c.set(58, f.level == Level::NTC && acknowledges(Ack::SN));
  c.set(59, f.standstill && acknowledges(Ack::RV) && !in_0_ntc);
  c.set(60, acknowledges(Ack::UN) && f.level == Level::L0);
  c.set(61, to_1_2_3 && f.profile_demands_SH);
  c.set(62, acknowledges_trip && f.level == Level::L0 && f.train_data_valid);
  c.set(63, acknowledges_trip && f.level == Level::NTC && f.train_data_valid);
  c.set(65, !in_0_ntc && f.telegram_version_too_high);
  c.set(66, f.linked_group_wrong_direction);
  c.set(67, to_1 && f.trip_order && !f.override_active);
  c.set(68, acknowledges_trip && in_0_ntc && !f.train_data_valid);
  c.set(69, f.front_in_rear_of_track_description);
  c.set(70, acknowledges(Ack::LS) && !in_0_ntc);
  c.set(71, to_1_2_3 && f.profile_demands_LS);
  c.set(72, f.profile_demands_LS);
  c.set(73, f.profile_demands_OS && !f.front_in_LS_ack_area);
  c.set(74, f.profile_demands_LS && !f.front_in_OS_ack_area);
  // clang-format on
  return c;
}

}  // namespace evc::procedures
