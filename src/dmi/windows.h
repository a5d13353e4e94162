#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "dmi/state.h"

// The windows of chapter 11 as data, and what opens and closes them.
namespace evc::dmi {

enum class Layout : std::uint8_t { default_, menu, entry_half, entry_full, validation, view };

struct WindowRow {
  WindowId id;
  const char* title;  ///< of 4.0.0; see `title_of`
  Layout layout;
  WindowId parent;
  Button button;        ///< of its parent, whose condition holds it open; count: none
  bool closes_on_loss;  ///< Table 48: it closes when that condition is lost
};
inline constexpr std::size_t kWindows = static_cast<std::size_t>(WindowId::count);
extern const std::array<WindowRow, kWindows> kWindowRows;
inline const WindowRow& row_of(WindowId id) { return kWindowRows[static_cast<std::size_t>(id) % kWindows]; }
inline Layout layout_of(WindowId id) { return row_of(id).layout; }
inline bool is_entry(WindowId id) {
  const Layout layout = layout_of(id);
  return layout == Layout::entry_half || layout == Layout::entry_full || layout == Layout::validation;
}
/// The windows that cover A to G.
inline bool is_full(WindowId id) {
  const Layout layout = layout_of(id);
  return layout == Layout::entry_full || layout == Layout::validation;
}

/// What the title of a window says in the edition of the display.
Words title_of(const State&, WindowId);

/// A button of a menu window at its place.
struct MenuButton {
  std::uint8_t number = 0;  ///< 1 to 12
  Button button{};
  std::optional<Picture> picture;
  ButtonType type = ButtonType::up;
};
using MenuButtons = InplaceVector<MenuButton, 12>;
MenuButtons menu_buttons(const State&, WindowId);
bool button_enabled(const State&, Button);
bool close_enabled(const State&);
/// Whether the hour glass is shown and buttons are disabled: the on-board waits for a network or an RBC.
bool is_waiting(const State&);

/// Pages of the window: Previous and Next.
std::uint8_t pages_of(const State&);

void open_window(State&, WindowId);
/// To the parent.
void close_window(State&);
/// Leaves data entry for an acknowledgement or because its condition is lost (015560 11.7.1.7, .9).
void abort_entry(State&);
/// A button of a menu acts.
void choose(State&, Button, Duration now);
/// The on-board's dialogue opens windows and waits (015560 11.7).
void follow_dialogue(State&, const port::Display& before);

/// A line of a view window. Without a label it goes on with the value before, without both it separates topics.
struct ViewItem {
  Words label, value;
};
using ViewItems = InplaceVector<ViewItem, 40>;
ViewItems view_items(const State&);
inline constexpr std::size_t kViewLines = 14;  ///< of a page

}  // namespace evc::dmi
