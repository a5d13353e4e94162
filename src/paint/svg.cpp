#include "paint/svg.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "paint/drawing.h"
#include "paint/font.h"

namespace evc::paint {
namespace {

/// Characters of XML. Control characters, which a document may not contain, become spaces.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out;
}

/// Hundredths of a cell, without trailing zeros: finer than any screen, and above what sine and cosine of two libraries
/// of mathematics differ.
void append_number(std::string& out, double value) {
  constexpr double least = -1e6, most = 1e6;
  const double kept = std::isfinite(value) ? std::min(std::max(value, least), most) : 0.0;
  const auto hundredths = static_cast<long>(std::lround(kept * 100.0));
  const long rest = std::labs(hundredths % 100);
  if (hundredths < 0) out += '-';
  fmt::format_to(std::back_inserter(out), "{}", std::labs(hundredths / 100));
  if (rest == 0) return;
  if (rest % 10 == 0)
    fmt::format_to(std::back_inserter(out), ".{}", rest / 10);
  else
    fmt::format_to(std::back_inserter(out), ".{:02}", rest);
}

void append_point(std::string& out, Point p) {
  append_number(out, p.x);
  out += ' ';
  append_number(out, p.y);
}

std::string data_of(const Path& path) {
  std::string out;
  for (const Path::Step& step : path.steps()) {
    switch (step.kind) {
      case Path::Kind::move:
        out += 'M';
        append_point(out, step.end);
        break;
      case Path::Kind::line:
        out += 'L';
        append_point(out, step.end);
        break;
      case Path::Kind::curve:
        out += 'C';
        append_point(out, step.a);
        out += ' ';
        append_point(out, step.b);
        out += ' ';
        append_point(out, step.end);
        break;
      case Path::Kind::close:
        out += 'Z';
        break;
    }
  }
  return out;
}

std::string hex_of(dmi::Colour colour) {
  const auto& rgb = dmi::kColourRows[terms::index(colour)].rgb;
  return fmt::format("#{:02X}{:02X}{:02X}", rgb[0], rgb[1], rgb[2]);
}

void append_shape(std::string& out, const Shape& shape) {
  if (shape.colour == dmi::Colour::none) return;
  out += "<path d=\"" + data_of(shape.path) + '"';
  if (shape.stroke > 0.0) {
    out += " fill=\"none\" stroke=\"" + hex_of(shape.colour) + "\" stroke-width=\"";
    append_number(out, shape.stroke);
    out += "\"/>\n";
  } else {
    out += " fill=\"" + hex_of(shape.colour) + "\"/>\n";
  }
}

}  // namespace

std::string svg_of(const dmi::Screen& screen) {
  constexpr dmi::Rect size = dmi::rect_of(dmi::Area::screen);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\">\n"
      "<title>ETCS driver-machine interface: {2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n",
      size.w, size.h, escaped(readable(screen.window.view())), hex_of(dmi::Colour::dark_blue));
  for (const Group& group : draw(screen)) {
    out += group.label.empty() ? "<g>\n" : "<g aria-label=\"" + escaped(group.label) + "\">\n";
    for (const Shape& shape : group.shapes) append_shape(out, shape);
    out += "</g>\n";
  }
  return out + "</svg>\n";
}

}  // namespace evc::paint
