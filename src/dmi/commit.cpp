#include "dmi/commit.h"

#include "dmi/entry.h"
#include "dmi/labels.h"
#include "dmi/windows.h"

namespace evc::dmi {
namespace {

using port::Select;

void tell(State& state, Select what) { state.commands.actions.selected |= 1u << static_cast<unsigned>(what); }

std::uint64_t number_of(const State& state, FieldId id) {
  const Value* value = value_of(state.entry, id);
  const auto number = value != nullptr ? typed_number(*value) : std::nullopt;
  return number ? *number : 0;
}
int choice_of(const State& state, FieldId id) {
  const Value* value = value_of(state.entry, id);
  return value != nullptr ? value->choice : -1;
}
std::string_view characters_of(const State& state, FieldId id) {
  const Value* value = value_of(state.entry, id);
  return value != nullptr ? value->typed.view() : std::string_view{};
}

/// Whether a radio network type asks for a system: a type of one system for it, that of both for those that are fitted.
bool asks_for_frmcs(const port::DisplayConfig& config, port::RadioNetworkType type) {
  return type == port::RadioNetworkType::frmcs ||
         (type == port::RadioNetworkType::frmcs_and_gsmr && config.frmcs_fitted);
}
bool asks_for_gsmr(const port::DisplayConfig& config, port::RadioNetworkType type) {
  return type == port::RadioNetworkType::gsmr || (type == port::RadioNetworkType::frmcs_and_gsmr && config.gsmr_fitted);
}

/// Whether the networks are registered that the stored radio network type asks for (015560 11.7.3 D5).
bool networks_are_registered(const port::Display& display) {
  const port::DisplayedData& data = display.data;
  const bool by_frmcs = asks_for_frmcs(display.config, data.radio), by_gsmr = asks_for_gsmr(display.config, data.radio);
  return (by_frmcs || by_gsmr) && (!by_frmcs || data.frmcs_registered) && (!by_gsmr || data.gsmr_registered);
}

/// Whether the choice of a radio network type ends as a failed registration (015560 11.7.3 S5-4, E1). Other than D5 it
/// asks for FRMCS alone, and where this is fitted: to GSM-R the train registers later, with the network that the driver
/// chooses (S5-2).
bool registration_has_failed(const port::Display& display, port::RadioNetworkType type) {
  return asks_for_frmcs(display.config, type) && display.config.frmcs_fitted && !display.data.frmcs_registered;
}

void commit_level(State& state, Duration now) {
  const int choice = choice_of(state, FieldId::level);
  if (choice < 0) return;
  const auto number = static_cast<std::size_t>(choice);
  const std::optional<std::uint8_t> system = system_of_choice(state.display, number);
  if (!system && number >= kLevelChoices.size()) return;  // it is not offered any more
  const Level level = system ? Level::NTC : kLevelChoices[number];
  state.commands.actions.level = level;
  if (system) state.commands.actions.nid_ntc = *system;
  if (state.display.start_of_mission) return await(state, WindowId::main, now);  // the on-board says what follows
  if (!level_2_or_3(level)) return open_window(state, WindowId::main);
  // 015560 11.7.3 D5
  if (state.display.level == Level::L0 || state.display.level == Level::NTC) state.trip_awaited_since = now;
  const bool can_call =
      state.display.data.stored.rbc_status == DataStatus::valid && networks_are_registered(state.display);
  if (can_call) return await(state, WindowId::main, now);
  open_window(state, WindowId::radio_data);
}

void commit_number(State& state) {
  const std::string_view digits = characters_of(state, FieldId::train_running_number);
  state.commands.actions.train_running_number = static_cast<std::uint32_t>(to_bcd(digits, 8));
  if (state.from_driver_id) {
    state.from_driver_id = false;
    return open_window(state, WindowId::driver_id);
  }
  open_window(state, WindowId::main);
}

void commit_rbc(State& state, Duration now) {
  const std::uint64_t id = number_of(state, FieldId::rbc_id);
  port::DriverActions::RbcContact contact{};
  contact.NID_RBC = static_cast<std::uint16_t>(id & 0x3FFF);
  contact.NID_C = static_cast<std::uint16_t>((id >> 14) & 0x3FF);
  contact.NID_RADIO = to_bcd(characters_of(state, FieldId::rbc_phone), 16);
  state.commands.actions.rbc_contact = contact;
  await(state, WindowId::main, now);
}

void commit_network(State& state, Duration now) {
  const int choice = choice_of(state, FieldId::network);
  if (choice >= 0 && static_cast<std::size_t>(choice) < state.display.data.networks.size())
    state.commands.actions.network = state.display.data.networks[static_cast<std::size_t>(choice)];
  await_network(state, WindowId::radio_data, now);  // until it is registered (015560 11.7.3 S5-2-3)
}

/// 015560 11.7.3 S5-4: a failed registration is A6, then D9. In the start of mission the on-board says what follows.
void commit_radio_type(State& state) {
  const port::Display& display = state.display;
  const auto type = static_cast<port::RadioNetworkType>(choice_of(state, FieldId::radio_type) % 3);
  state.commands.radio = type;
  const bool stays = !registration_has_failed(display, type) || display.start_of_mission;
  open_window(state, stays ? WindowId::radio_data : after_failed_registration(display, type));
}

void commit_sr(State& state) {
  state.commands.actions.V_sr = Speed{static_cast<double>(number_of(state, FieldId::sr_speed)) / kKmh};
  state.commands.actions.D_sr = Distance{static_cast<double>(number_of(state, FieldId::sr_distance))};
  open_window(state, WindowId::special);
}

/// The codes of virtual balise covers: the bits have another order to set than to remove (015560 11.3.12.5, 11.3.13.5).
port::DriverActions::Cover cover_of(std::uint64_t code, bool remove) {
  port::DriverActions::Cover cover{};
  if (remove) {
    cover.NID_C = static_cast<std::uint16_t>(code & 0x3FF);
    cover.NID_VBCMK = static_cast<std::uint8_t>((code >> 10) & 0x3F);
  } else {
    cover.NID_VBCMK = static_cast<std::uint8_t>(code & 0x3F);
    cover.NID_C = static_cast<std::uint16_t>((code >> 6) & 0x3FF);
    cover.T_VBC = static_cast<std::uint8_t>((code >> 16) & 0xFF);
  }
  return cover;
}

/// The window of the entry that a validation window asks about.
WindowId validated_window(WindowId window) {
  return window == WindowId::validate_set_vbc      ? WindowId::set_vbc
         : window == WindowId::validate_remove_vbc ? WindowId::remove_vbc
                                                   : WindowId::train_data;
}
WindowId validation_of(WindowId window) {
  return window == WindowId::set_vbc      ? WindowId::validate_set_vbc
         : window == WindowId::remove_vbc ? WindowId::validate_remove_vbc
                                          : WindowId::validate_train_data;
}

void commit_validation(State& state, Duration now) {
  const WindowId window = state.window;
  const bool yes = choice_of(state, FieldId::validation) == 1;
  const Entry entered = state.validated;
  if (!yes) {
    // Back to the entry with the values of before (015560 11.7.3 S3-2). Its process goes on (10.6.1.3): what was
    // accepted in it stays so.
    open_window(state, validated_window(window));
    state.entry = entered;
    state.entry.selected = state.entry.choices_from = state.entry.tap_key = 0;
    return;
  }
  state.entry = entered;
  if (window != WindowId::validate_train_data) {
    const bool remove = window == WindowId::validate_remove_vbc;
    state.commands.actions.cover =
        cover_of(number_of(state, remove ? FieldId::vbc_to_remove : FieldId::vbc_to_set), remove);
    tell(state, remove ? Select::vbc_remove : Select::vbc_set);
    return open_window(state, WindowId::settings);
  }
  state.commands.train_data = entered_train_data(state, entered);
  if (const Value* type = value_of(entered, FieldId::train_type); type != nullptr && type->choice >= 0)
    state.commands.train_type = static_cast<std::uint8_t>(type->choice);
  // 015560 11.7.3 D6: without a valid train running number it is entered next.
  if (state.display.data.stored.train_running_number_status != DataStatus::valid) {
    open_window(state, WindowId::train_running_number);
    return;
  }
  if (level_2_or_3(state.display.level) && state.display.radio == RadioIndication::up)
    return await(state, WindowId::main, now);
  open_window(state, WindowId::main);
}

/// The windows of the settings, whose values stay in the display but for language and ATO.
void commit_settings(State& state) {
  switch (state.window) {
    case WindowId::language: {
      const int choice = choice_of(state, FieldId::language);
      if (choice >= 0 && static_cast<std::size_t>(choice) < state.display.config.languages.size())
        state.commands.actions.language = state.display.config.languages[static_cast<std::size_t>(choice)];
      break;
    }
    case WindowId::volume:
      state.volume = static_cast<std::uint8_t>(20 * (choice_of(state, FieldId::volume) + 1));
      break;
    case WindowId::brightness:
      state.brightness = static_cast<std::uint8_t>(20 * (choice_of(state, FieldId::brightness) + 1));
      break;
    default:
      state.commands.ato_on = choice_of(state, FieldId::ato) == 1;
      break;
  }
  open_window(state, WindowId::settings);
}

void commit_one_system(State& state, Duration now) {
  const bool yes = choice_of(state, FieldId::one_radio_system) == 1;
  state.commands.one_radio_system = yes;
  if (state.display.start_of_mission) return await(state, WindowId::main, now);
  open_window(state, yes ? WindowId::radio_data : WindowId::main);  // 015560 11.7.3 S10
}

}  // namespace

WindowId after_failed_registration(const port::Display& display, port::RadioNetworkType type) {
  const bool both = display.config.frmcs_fitted && display.config.gsmr_fitted;
  return both && type == port::RadioNetworkType::frmcs_and_gsmr ? WindowId::radio_data : WindowId::main;
}

void complete_entry(State& state, Duration now) {
  switch (state.window) {
    case WindowId::driver_id:
      state.commands.actions.driver_id = DriverId{characters_of(state, FieldId::driver_id)};
      if (state.display.start_of_mission) return await(state, WindowId::main, now);  // D2 of 015560 11.7.2
      return open_window(state, WindowId::main);
    case WindowId::train_running_number:
      return commit_number(state);
    case WindowId::level:
      return commit_level(state, now);
    case WindowId::adhesion:
      tell(state, choice_of(state, FieldId::adhesion) == 1 ? Select::slippery_rail : Select::adhesion_normal);
      return open_window(state, WindowId::special);
    case WindowId::sr_data:
      return commit_sr(state);
    case WindowId::rbc_data:
      return commit_rbc(state, now);
    case WindowId::network_id:
      return commit_network(state, now);
    case WindowId::radio_type:
      return commit_radio_type(state);
    case WindowId::one_radio_system:
      return commit_one_system(state, now);
    case WindowId::train_data:
    case WindowId::set_vbc:
    case WindowId::remove_vbc: {
      const Entry entered = state.entry;
      open_window(state, validation_of(state.window));
      state.validated = entered;
      return;
    }
    case WindowId::validate_train_data:
    case WindowId::validate_set_vbc:
    case WindowId::validate_remove_vbc:
      return commit_validation(state, now);
    default:
      return commit_settings(state);
  }
}

}  // namespace evc::dmi
