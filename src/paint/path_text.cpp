#include "paint/path_text.h"

#include <algorithm>
#include <cmath>

#include "io/number.h"

namespace evc::paint {
namespace {

std::int32_t hundredths(double cells) {
  constexpr double least = -1e6, most = 1e6;
  const double kept = std::isfinite(cells) ? std::clamp(cells, least, most) : 0.0;
  return static_cast<std::int32_t>(std::lround(kept * 100.0));
}

Hundredths hundredths(Point p) { return {hundredths(p.x), hundredths(p.y)}; }

void append_point(std::string& out, Point point, Hundredths origin) {
  const Hundredths p = hundredths(point);
  append_hundredths(out, p.x - origin.x);
  out += ' ';
  append_hundredths(out, p.y - origin.y);
}

}  // namespace

void append_hundredths(std::string& out, std::int32_t hundredths) {
  const std::int32_t size = std::abs(hundredths), rest = size % 100;
  if (hundredths < 0) out += '-';
  io::append_number(out, std::int64_t{size / 100});
  if (rest == 0) return;
  out += '.';
  out += static_cast<char>('0' + rest / 10);
  if (rest % 10 != 0) out += static_cast<char>('0' + rest % 10);
}

void append_cells(std::string& out, double cells) { append_hundredths(out, hundredths(cells)); }

std::string hex_of(dmi::Colour colour) {
  std::string out = "#";
  io::append_hex(out, dmi::kColourRows[terms::index(colour)].rgb);
  return out;
}

void append_path(std::string& out, const Path& path, Hundredths origin) {
  for (const Path::Step& step : path.steps()) {
    switch (step.kind) {
      case Path::Kind::move:
        out += 'M';
        append_point(out, step.end, origin);
        break;
      case Path::Kind::line:
        out += 'L';
        append_point(out, step.end, origin);
        break;
      case Path::Kind::curve:
        out += 'C';
        append_point(out, step.a, origin);
        out += ' ';
        append_point(out, step.b, origin);
        out += ' ';
        append_point(out, step.end, origin);
        break;
      case Path::Kind::close:
        out += 'Z';
        break;
    }
  }
}

Hundredths begin_of(const Shape& shape) {
  return shape.path.steps().empty() ? Hundredths{} : hundredths(shape.path.steps().front().end);
}

void append_form(std::string& out, const Shape& shape) {
  out += '"';
  out += hex_of(shape.colour);
  out += "\",";
  append_cells(out, shape.stroke);
  out += ",\"";
  append_path(out, shape.path, begin_of(shape));
  out += '"';
}

}  // namespace evc::paint
