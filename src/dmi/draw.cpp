#include "dmi/acks.h"
#include "dmi/dmi.h"
#include "dmi/drawing.h"
#include "dmi/windows.h"

namespace evc::dmi {
namespace {

void draw_border(const Drawing& to, Area area) {
  const Rect at = rect_of(area);
  Item border = to.item(Kind::border, area, Colour::shadow, {0, 0, at.w, at.h});
  border.border = Border::area;
  to.add(border);
}

/// The borders of layers -1 and -2 (015560 8.1.1.4); D and G have none below a half window.
void draw_borders(const Drawing& to, bool whole_default) {
  for (const Area area : {Area::A1, Area::A2_A3, Area::A4, Area::B,        Area::B3, Area::B4,   Area::B5, Area::B6,
                          Area::B7, Area::B8,    Area::C1, Area::C2_C3_C4, Area::C5, Area::C6,   Area::C7, Area::C8,
                          Area::C9, Area::E1,    Area::E2, Area::E3,       Area::E4, Area::E5_E9})
    draw_border(to, area);
  if (!whole_default) return;
  for (const Area area : {Area::D, Area::G1, Area::G2, Area::G3, Area::G4, Area::G5, Area::G11, Area::G12, Area::G13})
    draw_border(to, area);
}

/// The flashing frame of what is to be acknowledged: half a second, of which it is visible half (015560 5.1.1.3.2).
void draw_frame(const Drawing& to) {
  const State& state = to.state;
  if (!state.offered || is_full(state.window)) return;
  const Area area = place_of(state.offered->ack.what).frame;
  if (!to.screen.flashing.push_back(area)) return;
  const double quarters = (to.now - state.offered->since).si / 0.25;
  if (whole(quarters - 0.5, 0, 2000000000) % 2 != 0) return;
  const Rect at = rect_of(area);
  Item frame = to.item(Kind::frame, area, Colour::yellow, {0, 0, at.w, at.h});
  frame.w = 2;
  to.add(frame);
}

}  // namespace

void Drawing::symbol(Area area, Picture picture, Rect part) const {
  if (picture >= Picture::count) return;
  const PictureRow& row = kPictureRows[terms::index(picture)];
  const auto middle = [](int from, int room, int size) { return static_cast<std::int16_t>(from + (room - size) / 2); };
  Item made = item(Kind::symbol, area, Colour::none,
                   {middle(part.x, part.w, row.width), middle(part.y, part.h, row.height), row.width, row.height});
  made.picture = picture;
  add(made);
}

Item Drawing::text_item(Area area, const Words& text, Colour colour, std::uint8_t height, Align align,
                        std::uint8_t indent) const {
  const Rect at = rect_of(area);
  Item made = item(Kind::text, area, colour, {0, 0, at.w, at.h});
  made.text = text;
  made.height = height;
  made.align = align;
  made.indent = indent;
  return made;
}

void draw(const State& state, Duration now, Screen& screen) {
  screen.t_ms = now.si * 1000.0;
  screen.items.clear();
  screen.flashing.clear();
  screen.touch.clear();
  screen.window.clear();
  screen.window.append(title_of(state, state.window).view());
  screen.sounds = state.commands.sounds;
  screen.brightness = state.brightness;
  screen.volume = state.volume;
  const Drawing to{state, state.display, now, screen};
  to.rect(Area::screen, Colour::dark_blue, {0, 0, 640, 480}, "background");
  const Mode mode = state.display.mode;
  if (mode == Mode::NP || mode == Mode::IS) return;
  if (!is_full(state.window)) {
    const bool whole_default = layout_of(state.window) == Layout::default_;
    draw_borders(to, whole_default);
    draw_distance(to);
    draw_speed(to);
    draw_fields(to);
    draw_texts(to);
    if (whole_default) {
      draw_planning(to);
      draw_side(to);
    }
  }
  if (layout_of(state.window) != Layout::default_) draw_window(to);
  draw_frame(to);
  draw_touch(to);
}

}  // namespace evc::dmi
