#include "ride/panel.h"

#include <cmath>

#include "io/number.h"
#include "paint/drawing.h"
#include "screen/screen_json.h"

namespace evc::ride {
namespace {

/// Hundredths of a cell: finer than any screen.
void append_cells(std::string& out, double value) {
  io::append_number(out, std::nearbyint(value * 100.0) / 100.0 + 0.0);
}

void append_point(std::string& out, paint::Point p) {
  append_cells(out, p.x);
  out += ' ';
  append_cells(out, p.y);
}

void append_path(std::string& out, const paint::Path& path) {
  for (const paint::Path::Step& step : path.steps()) {
    switch (step.kind) {
      case paint::Path::Kind::move:
        out += 'M';
        append_point(out, step.end);
        break;
      case paint::Path::Kind::line:
        out += 'L';
        append_point(out, step.end);
        break;
      case paint::Path::Kind::curve:
        out += 'C';
        append_point(out, step.a);
        out += ' ';
        append_point(out, step.b);
        out += ' ';
        append_point(out, step.end);
        break;
      case paint::Path::Kind::close:
        out += 'Z';
        break;
    }
  }
}

void append_colour(std::string& out, dmi::Colour colour) {
  out += "\"#";
  io::append_hex(out, dmi::kColourRows[terms::index(colour)].rgb);
  out += '"';
}

void append_shape(std::string& out, const paint::Shape& shape) {
  out += '[';
  append_colour(out, shape.colour);
  out += ',';
  append_cells(out, shape.stroke);
  out += ",\"";
  append_path(out, shape.path);
  out += "\"]";
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

const dmi::Screen& Panel::screen() {
  dmi::draw(state_, record_.now, screen_);
  return screen_;
}

std::string Panel::display_list() { return screen::screen_json(screen()); }

std::string Panel::drawing() {
  // The background of 5.2.1.3.
  std::string out = "[[";
  append_colour(out, dmi::Colour::dark_blue);
  out += ",0,\"M0 0L640 0L640 480L0 480Z\"]";
  for (const paint::Group& group : paint::draw(screen()))
    for (const paint::Shape& shape : group.shapes) {
      if (shape.colour == dmi::Colour::none) continue;
      out += ',';
      append_shape(out, shape);
    }
  return out + ']';
}

}  // namespace evc::ride
