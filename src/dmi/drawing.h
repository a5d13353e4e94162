#pragma once
#include "dmi/geometry.h"
#include "dmi/screen.h"
#include "dmi/state.h"
#include "dmi/words.h"

// What the sources of the room share to draw: the screen under way, and one function per part of it.
namespace evc::dmi {

struct Drawing {
  const State& state;
  const port::Display& display;
  Duration now;
  Screen& screen;

  /// Adds an item; the screen has room for every display, and what would exceed it is left out.
  void add(const Item& item) const {
    if (!screen.items.push_back(item)) return;
  }
  Item item(Kind kind, Area area, Colour colour = Colour::none, Rect at = {}) const {
    Item made;
    made.kind = kind;
    made.area = area;
    made.colour = colour;
    made.at = at;
    return made;
  }
  void rect(Area area, Colour colour, Rect at, const char* name = "") const {
    Item made = item(Kind::rect, area, colour, at);
    made.name.append(name);
    add(made);
  }
  /// A symbol in the middle of a part of an area.
  void symbol(Area area, Picture picture, Rect part) const;
  /// A symbol in the middle of an area.
  void symbol(Area area, Picture picture) const {
    const Rect whole_area = rect_of(area);
    symbol(area, picture, {0, 0, whole_area.w, whole_area.h});
  }
  Item text_item(Area area, const Words& text, Colour colour, std::uint8_t height, Align align,
                 std::uint8_t indent) const;
  void text(Area area, const Words& text_shown, Colour colour, std::uint8_t height, Align align = Align::left,
            std::uint8_t indent = 3) const {
    add(text_item(area, text_shown, colour, height, align, indent));
  }
};

/// How the toggle of 015560 8.2.2.4 stands: in OS, SR and SH as the driver set it, else as if on.
inline bool toggled_on(const State& state) {
  const Mode mode = state.display.mode;
  return (mode != Mode::OS && mode != Mode::SR && mode != Mode::SH) || state.toggles.speed;
}
inline bool is_400(const port::Display& display) { return display.config.srs == SrsVersion::v4_0_0; }

// dial.cpp: areas A1 to A3 and B.
void draw_distance(const Drawing&);
void draw_speed(const Drawing&);
/// Whether the time to Indication is shown in A1 (015560 8.2.2.5).
bool shows_TTI(const State&);
// planning.cpp: area D.
bool shows_planning(const State&);
void draw_planning(const Drawing&);
// fields.cpp: symbols and buttons of the default window.
void draw_fields(const Drawing&);
void draw_side(const Drawing&);
// texts.cpp: areas E5 to E11.
void draw_texts(const Drawing&);
bool can_scroll(const State&, bool up);
// windows_draw.cpp, entry_draw.cpp: windows.
void draw_window(const Drawing&);
void draw_entry(const Drawing&);
// touch.cpp
void draw_touch(const Drawing&);
/// Whether the button of this action is drawn as pressed now.
bool looks_pressed(const State&, Action, Duration now);

}  // namespace evc::dmi
