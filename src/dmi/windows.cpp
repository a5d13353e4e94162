#include "dmi/windows.h"

#include <array>

#include "dmi/acks.h"
#include "dmi/entry.h"
#include "dmi/labels.h"
#include "dmi/words.h"

namespace evc::dmi {

using enum WindowId;
constexpr Button kNoButton = Button::count;

constexpr std::array<WindowRow, kWindows> kWindowRows{{
    {default_, "default", Layout::default_, default_, kNoButton, false},
    {main, "Main", Layout::menu, default_, kNoButton, false},
    {override_, "Override", Layout::menu, default_, kNoButton, false},
    {data_view, "Data view", Layout::view, default_, kNoButton, false},
    {special, "Special", Layout::menu, default_, kNoButton, false},
    {settings, "Settings", Layout::menu, default_, kNoButton, false},
    {radio_data, "Radio data", Layout::menu, main, Button::radio_data, false},
    {driver_id, "Driver ID", Layout::entry_half, main, Button::driver_id, true},
    {train_running_number, "Train running number", Layout::entry_half, main, Button::train_running_number, true},
    {level, "Level", Layout::entry_half, main, Button::level, true},
    {language, "Language", Layout::entry_half, settings, Button::language, true},
    {volume, "Volume", Layout::entry_half, settings, Button::volume, true},
    {brightness, "Brightness", Layout::entry_half, settings, Button::brightness, true},
    {system_version, "System version", Layout::view, settings, Button::system_version, false},
    {set_vbc, "Set VBC", Layout::entry_full, settings, Button::set_vbc, false},
    {remove_vbc, "Remove VBC", Layout::entry_full, settings, Button::remove_vbc, false},
    {ato, "ATO selector", Layout::entry_half, settings, Button::ato, true},
    {adhesion, "Adhesion", Layout::entry_half, special, Button::adhesion, true},
    {sr_data, "SR speed / distance", Layout::entry_full, special, Button::sr_speed_distance, true},
    {rbc_data, "RBC data", Layout::entry_full, radio_data, Button::enter_rbc_data, true},
    {network_id, "GSM-R network ID", Layout::entry_half, radio_data, Button::gsmr_network_id, true},
    {radio_type, "Radio network type", Layout::entry_half, radio_data, Button::radio_network_type, true},
    {one_radio_system, "Mission with one radio system", Layout::entry_half, radio_data, Button::one_radio_system, true},
    {train_data, "Train data", Layout::entry_full, main, Button::train_data, true},
    {validate_train_data, "Validate train data", Layout::validation, main, Button::train_data, true},
    {validate_set_vbc, "Validate set VBC", Layout::validation, settings, Button::set_vbc, false},
    {validate_remove_vbc, "Validate remove VBC", Layout::validation, settings, Button::remove_vbc, false},
}};
static_assert([] {
  for (std::size_t i = 0; i < kWindows; ++i)
    if (static_cast<std::size_t>(kWindowRows[i].id) != i) return false;
  return true;
}());

namespace {

/// The buttons of Tables 33 to 37 at their places. Of two buttons at one place the second takes it where it applies.
struct MenuRow {
  WindowId window;
  std::uint8_t number;
  Button button;
  Button instead;
  ButtonType type;
  bool since_400;
  Picture picture;
};
constexpr Picture kText = Picture::count;
constexpr auto kMenuRows = std::to_array<MenuRow>({
    MenuRow{main, 1, Button::start, kNoButton, ButtonType::up, false, kText},
    MenuRow{main, 2, Button::driver_id, kNoButton, ButtonType::up, false, kText},
    MenuRow{main, 3, Button::train_data, kNoButton, ButtonType::up, false, kText},
    MenuRow{main, 5, Button::level, kNoButton, ButtonType::up, false, kText},
    MenuRow{main, 6, Button::train_running_number, kNoButton, ButtonType::up, false, kText},
    MenuRow{main, 7, Button::shunting, Button::exit_shunting, ButtonType::delay, false, kText},
    MenuRow{main, 8, Button::non_leading, kNoButton, ButtonType::delay, false, kText},
    MenuRow{main, 9, Button::maintain_shunting, kNoButton, ButtonType::delay, false, kText},
    MenuRow{main, 10, Button::radio_data, kNoButton, ButtonType::up, false, kText},
    MenuRow{main, 11, Button::initiate_sm, Button::continue_sm, ButtonType::delay, true, kText},
    MenuRow{main, 12, Button::exit_sm, kNoButton, ButtonType::delay, true, kText},
    MenuRow{override_, 1, Button::eoa, kNoButton, ButtonType::up, false, kText},
    MenuRow{special, 1, Button::adhesion, kNoButton, ButtonType::up, false, kText},
    MenuRow{special, 2, Button::sr_speed_distance, kNoButton, ButtonType::up, false, kText},
    MenuRow{special, 3, Button::train_integrity, kNoButton, ButtonType::delay, false, kText},
    MenuRow{special, 4, Button::bmm_inhibit, Button::bmm_revoke, ButtonType::up, true, kText},
    MenuRow{settings, 1, Button::language, kNoButton, ButtonType::up, false, Picture::SE03},
    MenuRow{settings, 2, Button::volume, kNoButton, ButtonType::up, false, Picture::SE02},
    MenuRow{settings, 3, Button::brightness, kNoButton, ButtonType::up, false, Picture::SE01},
    MenuRow{settings, 4, Button::system_version, kNoButton, ButtonType::up, false, kText},
    MenuRow{settings, 5, Button::set_vbc, kNoButton, ButtonType::up, false, kText},
    MenuRow{settings, 6, Button::remove_vbc, kNoButton, ButtonType::up, false, kText},
    MenuRow{settings, 7, Button::ato, kNoButton, ButtonType::up, true, kText},
    MenuRow{radio_data, 1, Button::contact_last_rbc, kNoButton, ButtonType::up, false, kText},
    MenuRow{radio_data, 2, Button::use_short_number, kNoButton, ButtonType::up, false, kText},
    MenuRow{radio_data, 3, Button::enter_rbc_data, kNoButton, ButtonType::up, false, kText},
    MenuRow{radio_data, 5, Button::radio_network_type, kNoButton, ButtonType::up, true, kText},
    MenuRow{radio_data, 6, Button::gsmr_network_id, kNoButton, ButtonType::delay, false, kText},
    MenuRow{radio_data, 7, Button::one_radio_system, kNoButton, ButtonType::up, true, kText},
});

/// The windows with the hour glass.
bool waits_here(const State& state) { return state.window == main || state.window == radio_data; }

bool takes_place(const port::Display& display, Button instead) {
  switch (instead) {
    case Button::exit_shunting:
      return display.mode == Mode::SH;
    case Button::continue_sm:
      // Without valid train data no manoeuvre can be initiated in PT, but one be continued (Table 33).
      return display.mode == Mode::SM ||
             (display.mode == Mode::PT && display.data.stored.train_status != DataStatus::valid);
    case Button::bmm_revoke:
      return display.bmm_inhibited;
    default:
      return false;
  }
}

/// The lines of a value, the label before the first one: it has eight characters on a line (015560 5.1.5.2), and fewer
/// where they would not fit beside the label.
void add_item(ViewItems& items, std::string_view label_text, const Words& value) {
  constexpr double kRoom = 640.0 - 543.0 - 3.0;
  std::string_view rest = value.view();
  do {
    std::size_t end = 0;
    while (end < rest.size() && rest[end] != '\n') ++end;
    end = line_length(part_of(rest, 0, end), 12, false, kRoom);
    if (!items.push_back({Words{label_text}, Words{part_of(rest, 0, end)}})) return;
    const bool separated = end < rest.size() && (rest[end] == '\n' || rest[end] == ' ');
    rest = part_of(rest, separated ? end + 1 : end);
    label_text = {};
  } while (!rest.empty());
}

/// The value of stored data, as the entry window would show it.
Words stored_words(const State& state, FieldId id, DataStatus status) {
  if (status != DataStatus::valid) return {};
  Field field;
  field.id = id;
  field.value = stored_value(state, id);
  return shown_value(state, field);
}

void add_stored(ViewItems& items, const State& state, FieldId id, DataStatus status) {
  add_item(items, label(id, state.display.config.srs), stored_words(state, id, status));
}

/// Lines up to the end of a page stay empty.
void fill_page(ViewItems& items) {
  while (items.size() % kViewLines != 0 && items.push_back({}))
    ;
}

void add_train_items(ViewItems& items, const State& state) {
  const DataStatus status = state.display.data.stored.train_status;
  if (uses_train_types(state)) add_stored(items, state, FieldId::train_type, status);
  static constexpr auto kFields =
      std::to_array<FieldId>({FieldId::category, FieldId::length, FieldId::brake_percentage, FieldId::maximum_speed,
                              FieldId::axle_load, FieldId::airtight, FieldId::gauge});
  for (const FieldId id : kFields)
    if (is_entered(state.display, id)) add_stored(items, state, id, status);
}

void add_covers(ViewItems& items, const State& state) {
  if (!state.display.data.covers.empty()) add_item(items, {}, {});
  std::int64_t number = 0;
  for (const port::ShownCover& cover : state.display.data.covers) {
    Words label_words{"VBC #"};
    append_number(label_words, ++number);
    label_words.append(" set code");
    // As it is entered (015560 11.3.12.5): NID_VBCMK in the low 6 bits, then NID_C, then T_VBC.
    const std::int64_t code =
        (std::int64_t{cover.T_VBC} << 16) | (std::int64_t{cover.NID_C & 0x3FFu} << 6) | (cover.NID_VBCMK & 0x3F);
    add_item(items, label_words.view(), number_words(code));
  }
}

Words version_words(std::uint8_t M_VERSION) {
  Words words = number_words(M_VERSION >> 4 & 7);
  words.append('.');
  append_number(words, M_VERSION & 15);
  return words;
}

}  // namespace

Words title_of(const State& state, WindowId window) {
  if (window == network_id) return Words{label(FieldId::network, state.display.config.srs)};
  return Words{row_of(window).title};
}

MenuButtons menu_buttons(const State& state, WindowId window) {
  MenuButtons buttons;
  const port::Display& display = state.display;
  for (const MenuRow& row : kMenuRows) {
    if (row.window != window || (row.since_400 && display.config.srs != SrsVersion::v4_0_0)) continue;
    MenuButton button{row.number, takes_place(display, row.instead) ? row.instead : row.button, std::nullopt, row.type};
    if (row.picture != kText) button.picture = row.picture;
    if (!buttons.push_back(button)) return buttons;
  }
  return buttons;
}

bool is_waiting(const State& state) { return state.display.waiting != port::Waiting::nothing || state.awaited.on; }

bool button_enabled(const State& state, Button button) {
  return button < Button::count && state.display.buttons.has(button) && !ack_pending(state) &&
         !(waits_here(state) && is_waiting(state));
}

bool close_enabled(const State& state) {
  if (waits_here(state) && is_waiting(state)) return false;
  if (!state.display.start_of_mission) return true;  // 015560 11.7.3.2
  switch (state.window) {
    case settings:
    case network_id:
    case rbc_data:
    case radio_type:
      return true;  // S1-1, S3-2-2, S3-3, S3-4 (015560 11.7.2)
    case train_running_number:
      return state.from_driver_id;  // S1-2
    case driver_id:
    case main:
    case radio_data:
    case level:
    case one_radio_system:
      return false;
    default:
      return true;
  }
}

std::uint8_t pages_of(const State& state) {
  if (layout_of(state.window) == Layout::view)
    return static_cast<std::uint8_t>((view_items(state).size() + kViewLines - 1) / kViewLines);
  if (!is_entry(state.window)) return 1;
  return static_cast<std::uint8_t>((state.entry.fields.size() + kFieldsPerPage - 1) / kFieldsPerPage);
}

ViewItems view_items(const State& state) {
  ViewItems items;
  const port::DisplayedData& data = state.display.data;
  if (state.window == system_version) {
    add_item(items, "Operated system version", version_words(data.M_VERSION));
    return items;
  }
  // An empty line between topics (015560 10.5.1.6, Tables 44 and 45).
  add_stored(items, state, FieldId::driver_id, data.stored.driver_id_status);
  add_item(items, {}, {});
  add_stored(items, state, FieldId::train_running_number, data.stored.train_running_number_status);
  add_item(items, {}, {});
  add_train_items(items, state);
  fill_page(items);
  const bool is_400 = state.display.config.srs == SrsVersion::v4_0_0;
  if (is_400) add_stored(items, state, FieldId::radio_type, DataStatus::valid);
  add_stored(items, state, FieldId::network, data.stored.network ? DataStatus::valid : DataStatus::unknown);
  if (!is_400) add_item(items, {}, {});  // radio data are one topic since 4.0.0
  add_stored(items, state, FieldId::rbc_id, data.stored.rbc_status);
  if (is_entered(state.display, FieldId::rbc_phone))
    add_stored(items, state, FieldId::rbc_phone, data.stored.rbc_status);
  add_covers(items, state);
  return items;
}

void open_window(State& state, WindowId window) {
  if (window >= WindowId::count) return;
  state.window = window;
  state.page = 0;
  if (is_entry(window))
    begin_entry(state, window);
  else
    state.entry = Entry{};
}

void close_window(State& state) {
  WindowId parent = row_of(state.window).parent;
  if (state.from_driver_id && (state.window == settings || state.window == train_running_number)) {
    parent = driver_id;
    state.from_driver_id = false;
  }
  state.trip_awaited_since.reset();
  open_window(state, parent);
}

void abort_entry(State& state) {
  state.from_driver_id = false;
  open_window(state, row_of(state.window).parent);
}

}  // namespace evc::dmi
