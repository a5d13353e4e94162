#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The buttons of the menu windows of the driver interface (ERA_ERTMS_015560 11.2, Tables 33 to 37). The on-board
/// evaluates the conditions under which they are enabled.
enum class Button : std::uint8_t {
  // Main window, Table 33
  start,
  driver_id,
  train_data,
  level,
  train_running_number,
  shunting,
  exit_shunting,
  non_leading,
  maintain_shunting,
  radio_data,
  initiate_sm,
  continue_sm,
  exit_sm,
  // Radio data window
  contact_last_rbc,
  use_short_number,
  enter_rbc_data,
  radio_network_type,
  gsmr_network_id,
  one_radio_system,
  // Override window
  eoa,
  // Special window
  adhesion,
  sr_speed_distance,
  train_integrity,
  bmm_inhibit,
  bmm_revoke,
  // Settings window
  language,
  volume,
  brightness,
  system_version,
  set_vbc,
  remove_vbc,
  ato,
  count
};

/// The names are the labels in English.
inline constexpr auto kButtonRows = std::to_array<terms::Row<Button>>({
    {Button::start, "Start"},
    {Button::driver_id, "Driver ID"},
    {Button::train_data, "Train data"},
    {Button::level, "Level"},
    {Button::train_running_number, "Train running number"},
    {Button::shunting, "Shunting"},
    {Button::exit_shunting, "Exit Shunting"},
    {Button::non_leading, "Non-Leading"},
    {Button::maintain_shunting, "Maintain Shunting"},
    {Button::radio_data, "Radio data"},
    {Button::initiate_sm, "Initiate SM"},
    {Button::continue_sm, "Continue in SM"},
    {Button::exit_sm, "Exit SM"},
    {Button::contact_last_rbc, "Contact last RBC"},
    {Button::use_short_number, "Use short number"},
    {Button::enter_rbc_data, "Enter RBC data"},
    {Button::radio_network_type, "Radio network type"},
    {Button::gsmr_network_id, "GSM-R network ID"},
    {Button::one_radio_system, "Mission with one radio system"},
    {Button::eoa, "EOA"},
    {Button::adhesion, "Adhesion"},
    {Button::sr_speed_distance, "SR speed / distance"},
    {Button::train_integrity, "Train integrity"},
    {Button::bmm_inhibit, "BMM reaction inhibition"},
    {Button::bmm_revoke, "Revoke BMM reaction inhibition"},
    {Button::language, "Language"},
    {Button::volume, "Volume"},
    {Button::brightness, "Brightness"},
    {Button::system_version, "System version"},
    {Button::set_vbc, "Set VBC"},
    {Button::remove_vbc, "Remove VBC"},
    {Button::ato, "ATO"},
});
static_assert(terms::in_order(kButtonRows) && kButtonRows.size() == terms::index(Button::count));

/// "Driver ID".
constexpr const char* name(Button button) { return terms::kNames<kButtonRows>[terms::index(button)]; }

}  // namespace evc
