#include "ride/panel.h"

#include "paint/drawing.h"
#include "paint/path_text.h"
#include "screen/screen_json.h"

namespace evc::ride {
namespace {

/// `["#C3C3C3",0,"M0 0L3 4Z",20,30]`
void append_shape(std::string& out, const paint::Shape& shape) {
  const paint::Hundredths at = paint::begin_of(shape);
  out += '[';
  paint::append_form(out, shape);
  out += ',';
  paint::append_hundredths(out, at.x);
  out += ',';
  paint::append_hundredths(out, at.y);
  out += ']';
}

}  // namespace

Panel::Panel() {
  // The display's own language, English.
  (void)record_.config.languages.push_back(Language{});
}

port::Display& Panel::record_at(Duration now) {
  record_.now = now;
  return record_;
}

void Panel::touch_button(Button button) {
  const dmi::Action action{dmi::ActionKind::button, static_cast<std::uint8_t>(button)};
  for (const dmi::Target& target : dmi::targets(state_)) {
    if (target.action != action) continue;
    const dmi::Rect& at = target.abs;
    if (touch({at.x + at.w / 2, at.y + at.h / 2})) lift();
    return;
  }
}

void Panel::show(const port::Display& record) {
  if (record.now < record_.now) return;
  record_ = record;
  shown();
}

const dmi::Screen& Panel::screen() {
  dmi::draw(state_, record_.now, screen_);
  return screen_;
}

std::string Panel::display_list() { return screen::screen_json(screen()); }

std::string Panel::drawing() {
  std::string out = "[";
  append_shape(out, paint::background());
  for (const paint::Group& group : paint::draw(screen()))
    for (const paint::Shape& shape : group.shapes) {
      if (shape.colour == dmi::Colour::none) continue;
      out += ',';
      append_shape(out, shape);
    }
  return out + ']';
}

}  // namespace evc::ride
