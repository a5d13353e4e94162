#include <algorithm>
#include <string_view>

#include "dmi/drawing.h"
#include "dmi/entry.h"
#include "dmi/labels.h"
#include "dmi/touch.h"
#include "dmi/windows.h"

namespace evc::dmi {
namespace {

Rect within(Area area, Rect abs) {
  const Rect base = rect_of(area);
  return {static_cast<std::int16_t>(abs.x - base.x), static_cast<std::int16_t>(abs.y - base.y), abs.w, abs.h};
}

FieldState field_state(const State& state, std::size_t place) {
  const Field& field = state.entry.fields[place];
  const bool only = state.entry.fields.size() == 1;
  if (place == state.entry.selected && !(only && field.accepted)) return FieldState::selected;
  return field.accepted ? FieldState::accepted : FieldState::not_selected;
}

/// The cursor: half of half a second (015560 10.3.2.3).
void draw_cursor(const Drawing& to, const Item& field) {
  if (whole(to.now.si / 0.25 - 0.5, 0, 2000000000) % 2 != 0) return;
  const Rect data = field.data_at;
  const std::string_view shown = field.text.view();
  const std::size_t line = shown.rfind('\n');  // the end of the last line
  const bool lower = line != std::string_view::npos;
  std::string_view before = lower ? part_of(shown, line + 1) : shown;
  // Below the character that another press of its key would change (10.3.2.5 a), else where the next one will be.
  if (tap_runs(to.state.entry, to.now) && !before.empty()) before.remove_suffix(1);
  const std::int16_t end = cells(data.x + 10 + width_of(before, 12, false));
  const auto last = static_cast<std::int16_t>(data.x + data.w - 10);
  to.add(to.item(Kind::cursor, field.area, Colour::black,
                 {std::min(end, last), static_cast<std::int16_t>(data.y + (lower ? 44 : 34)), 9, 2}));
}

void draw_field(const Drawing& to, std::size_t place, std::size_t line) {
  const State& state = to.state;
  const Field& entered = state.entry.fields[place];
  const Layout layout = layout_of(state.window);
  const Area area = is_full(state.window) ? Area::full : Area::half;
  const Rect at = layout == Layout::entry_half ? kHalfField : full_field(static_cast<int>(line) + 1);
  const FieldState field_is = field_state(state, place);
  Item field = to.item(Kind::field, area, Colour::grey, within(area, at));
  field.data_at = field.at;
  if (layout == Layout::entry_full) field.data_at = data_part(field.at);
  if (layout != Layout::validation) field.name.append(label(entered.id, state.display.config.srs));
  field.text = shown_value(state, entered);
  field.state = field_is;
  field.number = static_cast<std::int16_t>(line + 1);
  field.background = field_is == FieldState::selected ? Colour::medium_grey : Colour::dark_grey;
  field.colour = field_is == FieldState::selected   ? Colour::black
                 : field_is == FieldState::accepted ? Colour::white
                                                    : Colour::grey;
  field.height = 12;
  field.indent = 10;
  field.border = Border::field;
  field.pressed = looks_pressed(state, {ActionKind::field, static_cast<std::uint8_t>(place)}, to.now);
  if (field_is == FieldState::selected && enter_is_delayed(state)) field.type = ButtonType::delay;
  field.enabled = field_is != FieldState::selected || enter_enabled(state);
  to.add(field);
  const Keyboard keyboard = keyboard_of(entered.id);
  if (field_is == FieldState::selected && (keyboard == Keyboard::numeric || keyboard == Keyboard::alphanumeric))
    draw_cursor(to, field);
}

void draw_echoes(const Drawing& to) {
  const State& state = to.state;
  const Entry& entry = layout_of(state.window) == Layout::validation ? state.validated : state.entry;
  for (std::size_t i = 0; i < entry.fields.size(); ++i) {
    const Echo echoed = echo_of(state, entry.fields[i]);
    Item echo = to.item(Kind::echo, Area::full, echoed.colour);
    echo.name.append(label(entry.fields[i].id, state.display.config.srs));
    echo.text = echoed.words;
    echo.number = static_cast<std::int16_t>(i + 1);
    echo.label_right = 199;
    echo.data_left = 209;
    echo.baseline = static_cast<std::int16_t>(127 + 24 * i);
    echo.height = 12;
    to.add(echo);
  }
}

Item key_item(const Drawing& to, Area area, Rect abs, std::uint8_t number) {
  Item key = to.item(Kind::key, area, Colour::grey, within(area, abs));
  key.number = number;
  key.height = 12;
  key.align = Align::centre;
  key.border = Border::button;
  key.type = ButtonType::down;
  key.pressed = looks_pressed(to.state, {ActionKind::key, number}, to.now);
  return key;
}

void draw_keys(const Drawing& to) {
  const Field* field = selected_field(to.state);
  if (field == nullptr) return;
  const Area area = is_full(to.state.window) ? Area::full : Area::half;
  const Keyboard keyboard = keyboard_of(field->id);
  const bool letters = keyboard == Keyboard::numeric || keyboard == Keyboard::alphanumeric;
  for (std::uint8_t number = 1; number <= 12; ++number) {
    const Key made = key_at(to.state, number);
    if (made.label.empty() && !made.picture) continue;
    Item key = key_item(to, area, key_place(number), number);
    key.text = made.label;
    key.picture = made.picture;
    key.enabled = made.enabled;
    key.bold = made.bold;
    if (letters) key.height = 16;
    if (!made.enabled) key.colour = Colour::dark_grey;
    key.type = made.type;
    to.add(key);
  }
}

void draw_validation_keys(const Drawing& to) {
  Item key = key_item(to, Area::full, kNoPlace, 7);
  key.text.append("No");
  key.name.append("no key");
  to.add(key);
  key = key_item(to, Area::full, kYesPlace, 8);
  key.text.append("Yes");
  key.name.append("yes key");
  to.add(key);
}

/// "Train data entry complete?" with its answer (015560 10.3.5.7).
void draw_question(const Drawing& to) {
  Words question = title_of(to.state, to.state.window);
  question.append(" entry complete?");
  to.rect(Area::full, Colour::dark_blue, {0, 350, 334, 50}, "question");
  Item text = to.text_item(Area::full, question, Colour::grey, 12, Align::centre, 0);
  text.at = {0, 350, 334, 50};
  to.add(text);
  const bool enabled = complete_enabled(to.state);
  Item yes = to.item(Kind::button, Area::full, Colour::black, {0, 400, 334, 50});
  yes.name.append("Yes");
  yes.text.append("Yes");
  yes.height = 12;
  yes.align = Align::centre;
  yes.background = enabled ? Colour::medium_grey : Colour::dark_grey;
  yes.enabled = enabled;
  yes.border = Border::field;
  yes.type = complete_is_delayed(to.state) ? ButtonType::delay : ButtonType::up;
  yes.pressed = looks_pressed(to.state, {ActionKind::complete, 0}, to.now);
  to.add(yes);
}

void draw_extra(const Drawing& to) {
  const auto button = [&](Rect abs, Action action, const char* called, const char* shown, std::uint8_t height) {
    Item made = to.item(Kind::button, is_full(to.state.window) ? Area::full : Area::half, Colour::grey,
                        within(is_full(to.state.window) ? Area::full : Area::half, abs));
    made.name.append(called);
    made.text.append(shown);
    made.height = height;
    made.align = Align::centre;
    made.border = Border::button;
    made.pressed = looks_pressed(to.state, action, to.now);
    return made;
  };
  if (has_switch(to.state)) {
    const bool types = !to.state.entry.fields.empty() && to.state.entry.fields[0].id == FieldId::train_type;
    to.add(button(kSwitchPlace, {ActionKind::switch_entry, 0}, "switch", types ? "Enter data" : "Select type", 12));
  }
  if (!has_shortcuts(to.state)) return;
  to.add(button(kNumberPlace, {ActionKind::open, static_cast<std::uint8_t>(WindowId::train_running_number)}, "TRN",
                "TRN", 10));
  Item settings =
      button(kSettingsPlace, {ActionKind::open, static_cast<std::uint8_t>(WindowId::settings)}, "SE04", "", 12);
  settings.picture = Picture::SE04;
  to.add(settings);
}

}  // namespace

void draw_entry(const Drawing& to) {
  const Layout layout = layout_of(to.state.window);
  const Shown shown = shown_fields(to.state);
  for (std::size_t i = shown.first; i < shown.last; ++i) draw_field(to, i, i - shown.first);
  if (layout != Layout::entry_half && to.state.window != WindowId::rbc_data) draw_echoes(to);
  if (layout == Layout::validation)
    draw_validation_keys(to);
  else
    draw_keys(to);
  if (layout == Layout::entry_full) draw_question(to);
  draw_extra(to);
}

}  // namespace evc::dmi
