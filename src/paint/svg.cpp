#include "paint/svg.h"

#include <fmt/format.h>

#include "io/xml.h"
#include "paint/drawing.h"
#include "paint/font.h"
#include "paint/path_text.h"

namespace evc::paint {
namespace {

void append_shape(std::string& out, const Shape& shape) {
  if (shape.colour == dmi::Colour::none) return;
  out += "<path d=\"";
  append_path(out, shape.path);
  out += '"';
  if (shape.stroke > 0.0) {
    out += " fill=\"none\" stroke=\"" + hex_of(shape.colour) + "\" stroke-width=\"";
    append_cells(out, shape.stroke);
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
      size.w, size.h, io::escaped_xml(readable(screen.window.view())), hex_of(dmi::Colour::dark_blue));
  for (const Group& group : draw(screen)) {
    out += group.label.empty() ? "<g>\n" : "<g aria-label=\"" + io::escaped_xml(group.label) + "\">\n";
    for (const Shape& shape : group.shapes) append_shape(out, shape);
    out += "</g>\n";
  }
  return out + "</svg>\n";
}

}  // namespace evc::paint
