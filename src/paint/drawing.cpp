#include "paint/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace evc::paint {
namespace {

double radians(double deg) { return deg * std::numbers::pi / 180.0; }

void include(Bounds& bounds, Point p, double margin) {
  bounds.least = {std::min(bounds.least.x, p.x - margin), std::min(bounds.least.y, p.y - margin)};
  bounds.most = {std::max(bounds.most.x, p.x + margin), std::max(bounds.most.y, p.y + margin)};
}

}  // namespace

Point on_circle(Point centre, double radius, double deg) {
  return {centre.x + radius * std::sin(radians(deg)), centre.y - radius * std::cos(radians(deg))};
}

Point Path::here() const { return steps_.empty() ? Point{} : steps_.back().end; }

void Path::quadratic_to(Point control, Point end) {
  const Point from = here();
  curve_to({from.x + (control.x - from.x) * 2.0 / 3.0, from.y + (control.y - from.y) * 2.0 / 3.0},
           {end.x + (control.x - end.x) * 2.0 / 3.0, end.y + (control.y - end.y) * 2.0 / 3.0}, end);
}

void Path::arc(Point centre, double radius, double from_deg, double to_deg, Kind first) {
  // One Bezier curve for at most 45 degrees: its distance from the circle is then below 1e-5 of the radius.
  constexpr double widest = 45.0;
  constexpr int most_pieces = 64;
  add({first, {}, {}, on_circle(centre, radius, from_deg)});
  const int pieces = std::clamp(static_cast<int>(std::ceil(std::abs(to_deg - from_deg) / widest)), 1, most_pieces);
  const double step = (to_deg - from_deg) / pieces;
  const double reach = 4.0 / 3.0 * std::tan(radians(step) / 4.0) * radius;
  for (int i = 0; i < pieces; ++i) {
    const double begin = from_deg + step * i;
    const double end = from_deg + step * (i + 1);
    const Point from = on_circle(centre, radius, begin);
    const Point to = on_circle(centre, radius, end);
    curve_to({from.x + reach * std::cos(radians(begin)), from.y + reach * std::sin(radians(begin))},
             {to.x - reach * std::cos(radians(end)), to.y - reach * std::sin(radians(end))}, to);
  }
}

void Path::circle(Point centre, double radius) {
  arc(centre, radius, 0.0, 360.0, Kind::move);
  close();
}

void Path::rectangle(double x, double y, double w, double h) {
  move_to({x, y});
  line_to({x + w, y});
  line_to({x + w, y + h});
  line_to({x, y + h});
  close();
}

Bounds bounds_of(const std::vector<Shape>& shapes) {
  Bounds bounds;
  for (const Shape& shape : shapes)
    for (const Path::Step& step : shape.path.steps()) {
      if (step.kind == Path::Kind::close) continue;
      include(bounds, step.end, shape.stroke / 2.0);
      if (step.kind != Path::Kind::curve) continue;
      include(bounds, step.a, shape.stroke / 2.0);
      include(bounds, step.b, shape.stroke / 2.0);
    }
  return bounds;
}

}  // namespace evc::paint
