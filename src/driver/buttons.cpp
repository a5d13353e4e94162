#include "driver/buttons.h"

namespace evc::driver {
namespace {

/// The buttons of functions that came with 4.0.0.
constexpr Set<Button> kOf_4_0_0{Button::initiate_sm,        Button::continue_sm,     Button::exit_sm,
                                Button::bmm_inhibit,        Button::bmm_revoke,      Button::ato,
                                Button::radio_network_type, Button::one_radio_system};

/// Table 37, "required networks": with both systems chosen and fitted both, or one when the mission is run with one.
bool networks_registered(const ButtonContext& c) {
  switch (c.network_type) {
    case NetworkType::gsmr:
      return c.gsmr.registered;
    case NetworkType::frmcs:
      return c.frmcs.registered;
    case NetworkType::both:
      break;
  }
  if (!c.frmcs.fitted) return c.gsmr.registered;
  if (!c.gsmr.fitted) return c.frmcs.registered;
  return c.one_radio_system ? c.gsmr.registered || c.frmcs.registered : c.gsmr.registered && c.frmcs.registered;
}

/// A short number is of GSM-R.
bool short_number_reachable(const ButtonContext& c) {
  if (!c.gsmr.registered) return false;
  switch (c.network_type) {
    case NetworkType::gsmr:
      return true;
    case NetworkType::frmcs:
      return false;
    case NetworkType::both:
      break;
  }
  return c.gsmr.fitted && (!c.frmcs.fitted || c.frmcs.registered || c.one_radio_system);
}

bool holds(const ButtonRow& row, const ActionContext& action, Set<Fact> facts) {
  if (!row.modes.has(action.mode)) return false;
  if (!(row.levels == Set<Level>{}) && !(action.level && row.levels.has(*action.level))) return false;
  return (facts & row.needs) == row.needs && (facts & row.without).empty();
}

}  // namespace

Set<Fact> facts_of(const ButtonContext& c) {
  using enum Fact;
  const ActionContext& a = c.action;
  Set<Fact> out;
  out.add(standstill, a.standstill);
  out.add(driver_id_valid, a.driver_id_valid);
  out.add(level_valid, a.level.has_value());
  out.add(train_data_valid, a.train_data_valid);
  out.add(train_running_number_valid, a.train_running_number_valid);
  out.add(session, a.session_open);
  out.add(train_data_acknowledged, a.train_data_acknowledged);
  out.add(emergency_stop, c.emergency_stop_pending);
  out.add(non_leading_signal, a.non_leading_signal);
  out.add(passive_shunting_signal, a.passive_shunting_signal);
  out.add(driver_id_while_running, a.driver_id_while_running);
  out.add(adhesion_by_driver, a.driver_may_change_adhesion);
  out.add(slow_enough_for_override, a.slow_enough_for_override);
  out.add(position_valid, c.position_valid);
  out.add(length_in_range, c.length_in_range);
  out.add(cover_stored, c.cover_stored);
  out.add(covers_full, c.covers_full);
  out.add(contact_known, c.contact_known);
  out.add(Fact::networks_registered, driver::networks_registered(c));
  out.add(Fact::short_number_reachable, driver::short_number_reachable(c));
  out.add(gsmr_chosen, c.network_type != NetworkType::frmcs);
  const bool two = c.network_type == NetworkType::both && c.gsmr.fitted && c.frmcs.fitted;
  out.add(one_of_two_registered, two && c.gsmr.registered != c.frmcs.registered);
  out.add(alarm_inhibited, a.alarm_inhibited);
  out.add(consist_known, c.consist_known);
  out.add(consist_in_front, c.consist_known && c.consist_in_front);
  out.add(consist_acknowledged, c.consist_acknowledged);
  out.add(session_above_2_2, a.session_open && c.session_above_2_2);
  out.add(second_session, c.second_session);
  out.add(RBC_transition_ordered, c.RBC_transition_ordered);
  return out;
}

std::optional<Input> input_of(Button button) {
  switch (button) {
    case Button::start:
      return Input::start;
    case Button::driver_id:
      return Input::driver_id;
    case Button::train_data:
      return Input::train_data;
    case Button::level:
      return Input::level;
    case Button::train_running_number:
      return Input::train_running_number;
    case Button::shunting:
      return Input::shunting;
    case Button::exit_shunting:
      return Input::exit_shunting;
    case Button::non_leading:
      return Input::non_leading;
    case Button::maintain_shunting:
      return Input::continue_shunting;
    case Button::exit_sm:
      return Input::exit_sm;
    case Button::eoa:
      return Input::override_;
    case Button::adhesion:
      return Input::adhesion;
    case Button::sr_speed_distance:
      return Input::sr_speed_distance;
    case Button::train_integrity:
      return Input::integrity_confirmation;
    case Button::bmm_inhibit:
      return Input::bmm_inhibit;
    case Button::bmm_revoke:
      return Input::bmm_revoke;
    case Button::language:
      return Input::language;
    case Button::set_vbc:
    case Button::remove_vbc:
      return Input::vbc;
    case Button::contact_last_rbc:
    case Button::use_short_number:
    case Button::enter_rbc_data:
      return Input::rbc_contact;
    case Button::gsmr_network_id:
      return Input::radio_network_id;
    default:
      return std::nullopt;
  }
}

Set<Button> buttons(const ButtonContext& c) {
  if (!c.action.desk_open || !c.action.requests.empty()) return {};
  const Set<Fact> facts = facts_of(c);
  Set<Button> out;
  for (const ButtonRow& row : dmi_11_2) {
    if (kOf_4_0_0.has(row.button) && c.action.srs != SrsVersion::v4_0_0) continue;
    if (!holds(row, c.action, facts)) continue;
    const std::optional<Input> input = input_of(row.button);
    out.add(row.button, !input || c.inputs.has(*input));
  }
  return out;
}

}  // namespace evc::driver
