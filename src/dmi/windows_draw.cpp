#include "dmi/acks.h"
#include "dmi/dmi.h"
#include "dmi/drawing.h"
#include "dmi/entry.h"
#include "dmi/labels.h"
#include "dmi/touch.h"
#include "dmi/windows.h"

namespace evc::dmi {
namespace {

Rect relative(Area area, Rect abs) {
  const Rect base = rect_of(area);
  return {static_cast<std::int16_t>(abs.x - base.x), static_cast<std::int16_t>(abs.y - base.y), abs.w, abs.h};
}

void draw_title(const Drawing& to, Area area) {
  const bool full = area == Area::full;
  const Rect at{0, 0, static_cast<std::int16_t>(full ? 334 : 306), 24};
  Words title = title_of(to.state, to.state.window);
  const std::uint8_t pages = pages_of(to.state);
  if (pages > 1) {
    title.append(" (");
    append_number(title, to.state.page + 1);
    title.append('/');
    append_number(title, pages);
    title.append(')');
  }
  Item bar = to.item(Kind::rect, area, Colour::black, at);
  bar.background = Colour::black;
  bar.name.append("title");
  bar.align = full ? Align::right : Align::left;
  bar.text = title;
  to.add(bar);
  Item text = to.text_item(area, title, Colour::grey, 12, full ? Align::right : Align::left, 3);
  text.at = at;
  to.add(text);
}

/// A button of a window with a picture or a label.
Item window_button(const Drawing& to, Area area, Rect abs, Action action, bool enabled, const Words& called) {
  Item button = to.item(Kind::button, area, enabled ? Colour::grey : Colour::dark_grey, relative(area, abs));
  button.name.append(called.view());
  button.height = 12;
  button.align = Align::centre;
  button.enabled = enabled;
  button.border = Border::button;
  button.pressed = looks_pressed(to.state, action, to.now);
  return button;
}

void draw_window_buttons(const Drawing& to, Area area) {
  const State& state = to.state;
  const bool can_close = close_enabled(state);
  Item button = window_button(to, area, kClosePlace, {ActionKind::close, 0}, can_close, "close");
  button.picture = can_close ? Picture::NA11 : Picture::NA12;
  to.add(button);
  if (pages_of(state) < 2) return;
  const bool back = can_turn_page(state, false), forward = can_turn_page(state, true);
  button = window_button(to, area, kPreviousPlace, {ActionKind::previous, 0}, back, "previous");
  button.picture = back ? Picture::NA18 : Picture::NA19;
  to.add(button);
  button = window_button(to, area, kNextPlace, {ActionKind::next, 0}, forward, "next");
  button.picture = forward ? Picture::NA17 : Picture::NA18_2;
  to.add(button);
}

/// The hour glass in the title, every second at the next of ten places (015560 11.2.1.6, 11.2.5.6). Of Radio data it
/// goes over the end of the title, on ground of its own, so that both can be read.
void draw_hour_glass(const Drawing& to) {
  if (!is_waiting(to.state)) return;
  constexpr std::int32_t kFirst = 42, kStep = 26, kPlaces = 10;
  const double passed = (to.now - to.state.waiting_since).si;
  const std::int32_t place = whole(passed - 0.5, 0, 2000000000) % kPlaces;
  const Rect at{static_cast<std::int16_t>(kFirst + kStep * place), 2, 20, 20};
  to.rect(Area::half, Colour::black, at);
  Item glass = to.item(Kind::symbol, Area::half, Colour::none, at);
  glass.picture = Picture::ST05;
  to.add(glass);
}

void draw_menu(const Drawing& to) {
  for (const MenuButton& row : menu_buttons(to.state, to.state.window)) {
    const bool enabled = button_enabled(to.state, row.button);
    const Words called = label(row.button, to.display.config.srs);
    Item button = window_button(to, Area::half, menu_place(row.number),
                                {ActionKind::button, static_cast<std::uint8_t>(row.button)}, enabled, called);
    button.number = row.number;
    button.type = row.type;
    if (row.picture)
      button.picture = row.picture;
    else
      button.text = called;
    to.add(button);
  }
  draw_window_buttons(to, Area::half);
  if (to.state.window == WindowId::main || to.state.window == WindowId::radio_data) draw_hour_glass(to);
}

void draw_view(const Drawing& to) {
  const ViewItems items = view_items(to.state);
  const std::size_t first = kViewLines * to.state.page;
  for (std::size_t line = 0; line < kViewLines && first + line < items.size(); ++line) {
    const ViewItem& shown = items[first + line];
    if (shown.label.empty() && shown.value.empty()) continue;
    Item item = to.item(Kind::view_item, Area::half, Colour::grey);
    item.name.append(shown.label.view());
    item.text = shown.value;
    item.number = static_cast<std::int16_t>(line + 1);
    item.label_right = 533;
    item.data_left = 543;
    item.baseline = static_cast<std::int16_t>(77 + 24 * line);
    item.height = 12;
    to.add(item);
  }
  draw_window_buttons(to, Area::half);
}

}  // namespace

void draw_window(const Drawing& to) {
  const Area area = is_full(to.state.window) ? Area::full : Area::half;
  draw_title(to, area);
  switch (layout_of(to.state.window)) {
    case Layout::menu:
      return draw_menu(to);
    case Layout::view:
      return draw_view(to);
    default:
      draw_entry(to);
      draw_window_buttons(to, area);
      return;
  }
}

}  // namespace evc::dmi
