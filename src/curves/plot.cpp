#include "curves/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "curves/drawing.h"
#include "curves/picture.h"

namespace evc::curves {
namespace {

constexpr const char* kPaleGrey = "#C2C9D1";
constexpr double kWidth = 1280.0;
constexpr double kLeft = 74.0, kLegend = 1072.0;
constexpr double kHeight = 496.0;  // of the panel of curves
constexpr double kStripHeight = 92.0;
constexpr double kZoneRow = 16.0;
constexpr double kTitleLine = 25.0;
constexpr double kMarkRow = 15.0;
constexpr double kCharacter = 7.0;  // mean width of one, at the size of marks

/// Where the parts of a chart are: the panel of curves, the rows of zones, the strip of gradients.
struct Layout {
  double right, top, bottom, strip_top, strip_bottom;
};
Layout layout_of(const Picture& p, std::size_t title_lines, Theme theme) {
  Layout l{};
  l.right = theme == Theme::print ? kWidth - 28.0 : kLegend - 20.0;
  l.top = 79.0 + kTitleLine * static_cast<double>(title_lines);
  l.bottom = l.top + kHeight;
  l.strip_top = l.bottom + 28.0 + kZoneRow * static_cast<double>(p.zone_rows > 1 ? p.zone_rows - 1 : 0);
  l.strip_bottom = l.strip_top + kStripHeight;
  return l;
}

void grid(Drawing& drawing, const Axis& x, const Axis& y, const Layout& l, const Approached& a) {
  drawing.rect(kLeft, l.top, l.right - kLeft, l.bottom - l.top, colour::dark_blue);
  for (const double v : y.ticks(9)) {
    drawing.line(kLeft, y.at(v), l.right, y.at(v), {colour::pasp_dark, 1.0, ""});
    drawing.text(kLeft - 8, y.at(v) + 4, label(v), 12, colour::ink, "end");
  }
  for (const double place : x.ticks(10)) {
    drawing.line(x.at(place), l.top, x.at(place), l.bottom, {colour::pasp_dark, 1.0, ""});
    drawing.text(x.at(place), l.strip_bottom + 20, label(place), 12, colour::ink, "middle");
  }
  // Distance to the target, above: with the step of the grid, on its lines where the target is at a round place.
  const double target = a.input().target_location.from_origin.si;
  const double step = x.step(10);
  for (double d = std::ceil((target - x.to) / step - 1e-9) * step; d <= target - x.from + 1e-6; d += step) {
    const double at = x.at(target - d);
    drawing.line(at, l.top - 5, at, l.top, {colour::ink, 1.0, ""});
    drawing.text(at, l.top - 9, label(d), 12, colour::ink, "middle");
  }
  drawing.text((kLeft + l.right) / 2, l.top - 26, "distance before the target [m]", 12, colour::soft, "middle");
  drawing.text((kLeft + l.right) / 2, l.strip_bottom + 42, "location along the line [m]", 12, colour::soft, "middle");
  drawing.vertical_text(20, (l.top + l.bottom) / 2, "speed [km/h]", 12, colour::soft);
  drawing.vertical_text(20, (l.strip_top + l.strip_bottom) / 2, "gradient [\u2030]", 12, colour::soft);
}

/// Names of places at the top, each on its own side of its line where the next one is close, in rows where they would
/// touch.
void marks(Drawing& drawing, const Picture& p, const Axis& x, const Axis& y, const Layout& l) {
  std::vector<Picture::Mark> sorted;
  for (const Picture::Mark& mark : p.marks)
    if (mark.x_m >= p.from_m && mark.x_m <= p.to_m) sorted.push_back(mark);
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.x_m < b.x_m; });
  std::vector<double> filled;  // the right end of the names in each row
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double at = x.at(sorted[i].x_m);
    drawing.line(at, l.top, at, l.bottom, {colour::medium_grey, 1.2, "2 4"});
    const double width = kCharacter * static_cast<double>(characters(sorted[i].name)) + 10.0;
    const bool next_is_close = i + 1 < sorted.size() && x.at(sorted[i + 1].x_m) < at + width;
    const bool on_left = at - width > kLeft && (next_is_close || at + width > l.right);
    const double from = on_left ? at - width : at, to = from + width;
    std::size_t row = 0;
    while (row < filled.size() && filled[row] > from) ++row;
    if (row == filled.size()) filled.push_back(0.0);
    filled[row] = to;
    drawing.text(on_left ? at - 5 : at + 5, l.top + 16 + kMarkRow * static_cast<double>(row), sorted[i].name, 11.5,
                 colour::grey, on_left ? "end" : "start");
  }
  if (p.V_release_kmh && p.start_of_RSM_m) {
    // In force from the start of release speed monitoring to the SvL.
    const double from = x.at(std::max(*p.start_of_RSM_m, p.from_m)), to = x.at(std::min(p.end_of_RSM_m, p.to_m));
    drawing.line(from, y.at(*p.V_release_kmh), to, y.at(*p.V_release_kmh), {colour::medium_grey, 3.0, ""});
  }
}

/// Conditions on a stretch of the track: a bar with its name.
void zones(Drawing& drawing, const Picture& p, const Axis& x, const Layout& l) {
  for (const Picture::Zone& z : p.zones) {
    const double top = l.bottom + 7.0 + kZoneRow * static_cast<double>(z.row);
    const double from = x.at(z.from_m), to = x.at(z.to_m);
    drawing.rect(from, top, std::max(to - from, 2.0), kZoneRow - 2.0, colour::pasp_light);
    const double width = 6.2 * static_cast<double>(z.name.size());  // of the text
    if (to - from > width + 8.0)
      drawing.text((from + to) / 2, top + 11, z.name, 10.5, colour::white, "middle");
    else if (from - width - 6.0 > kLeft)
      drawing.text(from - 5, top + 11, z.name, 10.5, colour::ink, "end");
    else
      drawing.text(to + 5, top + 11, z.name, 10.5, colour::ink);
  }
}

/// The gradient of the track and, lighter, the one that counts for the train.
void gradient_strip(Drawing& drawing, const Picture& p, const Axis& x, const Layout& l) {
  double steepest = 5.0;
  for (const auto& step : p.gradient) steepest = std::max(steepest, std::abs(step.value));
  const Axis y{-steepest * 1.25, steepest * 1.25, l.strip_bottom, l.strip_top};
  drawing.rect(kLeft, l.strip_top, l.right - kLeft, kStripHeight, colour::dark_blue);
  drawing.clip(kLeft, l.strip_top, l.right - kLeft, kStripHeight);
  for (std::size_t i = 0; i < p.gradient.size(); ++i) {
    const double from = std::max(p.gradient[i].from_m, p.from_m);
    const double to = std::min(i + 1 < p.gradient.size() ? p.gradient[i + 1].from_m : p.to_m, p.to_m);
    const double value = p.gradient[i].value;
    if (!(to > from)) continue;
    const double height = std::abs(y.at(value) - y.at(0));
    drawing.rect(x.at(from), std::min(y.at(value), y.at(0)), x.at(to) - x.at(from), std::max(height, 1.0),
                 value < 0.0 ? colour::dark_grey : colour::grey);
    const double width = x.at(to) - x.at(from), middle = (x.at(from) + x.at(to)) / 2;
    if (width > 26 && value != 0.0)
      drawing.text(middle, value > 0.0 ? y.at(0) + 14 : y.at(0) - 5, label(value), 11, colour::white, "middle");
    else if (width > 9 && value != 0.0)
      drawing.vertical_text(middle + 3.5, value > 0.0 ? y.at(0) + 15 : y.at(0) - 15, label(value), 9.5, colour::white);
  }
  std::vector<std::pair<double, double>> line;
  for (std::size_t i = 0; i < p.under_train.size(); ++i) {
    // Known track may go on far beyond the chart; Cairo has no room for such places.
    const double from = std::clamp(i == 0 ? p.from_m : p.under_train[i].from_m, p.from_m, p.to_m);
    const double next = i + 1 < p.under_train.size() ? p.under_train[i + 1].from_m : p.to_m;
    const double to = std::clamp(next, p.from_m, p.to_m);
    if (!(to > from)) continue;
    line.emplace_back(x.at(from), y.at(p.under_train[i].value));
    line.emplace_back(x.at(to), y.at(p.under_train[i].value));
  }
  drawing.polyline(line, {colour::EBD, 1.6, "5 3"});
  drawing.end_clip();
  for (const double v : {-steepest, 0.0, steepest})
    drawing.text(kLeft - 8, y.at(v) + 4, label(v), 11, colour::ink, "end");
}

void legend(Drawing& drawing, const Picture& p, const Layout& l) {
  drawing.rect(kLegend, l.top, kWidth - kLegend - 16, l.strip_bottom - l.top, colour::dark_blue);
  double y = l.top + 26;
  const auto entry = [&](const Stroke& stroke, const std::string& name) {
    drawing.line(kLegend + 12, y - 4, kLegend + 40, y - 4, stroke);
    const auto gap = name.find("  ");
    drawing.text(kLegend + 48, y, name.substr(0, gap), 12.5, colour::white, "start", true);
    if (gap != std::string::npos) drawing.text(kLegend + 48, y + 15, name.substr(gap + 2), 10.5, colour::grey);
    y += gap == std::string::npos ? 28 : 42;
  };
  for (const PictureCurve& c : p.curves) entry(c.stroke, c.name);
  if (p.V_release_kmh)
    entry({colour::medium_grey, 3.0, ""},
          "V_release  " + label(std::nearbyint(*p.V_release_kmh * 100.0) / 100.0) + " km/h");
  y = l.strip_top + 18;
  drawing.rect(kLegend + 12, y - 11, 28, 11, colour::grey);
  drawing.text(kLegend + 48, y, "uphill", 11, colour::white);
  y += 24;
  drawing.rect(kLegend + 12, y - 11, 28, 11, colour::dark_grey);
  drawing.text(kLegend + 48, y, "downhill", 11, colour::white);
  y += 24;
  drawing.line(kLegend + 12, y - 4, kLegend + 40, y - 4, {colour::EBD, 1.6, "5 3"});
  drawing.text(kLegend + 48, y, "lowest under train", 11, colour::white);
}

/// A rectangle in the panel that a name fills.
struct Taken {
  double x, y, half_width;
};

/// Names on the curves, on paper: each where its curve is farthest from all others and from the names before it.
void names_at_curves(Drawing& drawing, const Picture& p, const Axis& x, const Axis& y, const Layout& l) {
  constexpr double kSize = 11.5, kMargin = 8.0;
  std::vector<Taken> taken;
  if (p.V_release_kmh && p.start_of_RSM_m) {
    const double from = std::max(*p.start_of_RSM_m, p.from_m), to = std::min(p.end_of_RSM_m, p.to_m);
    const std::string name = "V_release " + label(std::nearbyint(*p.V_release_kmh * 100.0) / 100.0) + " km/h";
    const double half = kCharacter * static_cast<double>(name.size()) / 2.0;
    taken.push_back({std::min(x.at((from + to) / 2.0), l.right - half - kMargin), y.at(*p.V_release_kmh) + 14.0, half});
    drawing.name(taken.back().x, taken.back().y + 4.0, name, kSize, colour::grey);
  }
  // The points beside a name as well: a line may end there.
  const auto beside = [&](std::size_t i, double half) {
    const double reach = half + kMargin;
    std::size_t from = i, to = i;
    while (from > 0 && x.at(p.x_m[from - 1]) > x.at(p.x_m[i]) - reach) --from;
    while (to + 1 < p.x_m.size() && x.at(p.x_m[to + 1]) < x.at(p.x_m[i]) + reach) ++to;
    return std::pair{from, to};
  };
  const auto room_at = [&](const PictureCurve& own, std::size_t i, double half) {
    const double at_x = x.at(p.x_m[i]), at_y = y.at(own.v[i]);
    if (at_x < kLeft + half + kMargin || at_x > l.right - half - kMargin) return -1.0;
    if (at_y < l.top + 3.0 * kMarkRow || at_y > l.bottom - kMargin) return -1.0;
    double room = 60.0;  // more is no better
    const auto [from, to] = beside(i, half);
    for (const PictureCurve& other : p.curves)
      for (std::size_t k = from; &other != &own && k <= to; ++k)
        if (std::isfinite(other.v[k])) room = std::min(room, std::abs(y.at(other.v[k]) - at_y));
    for (const Taken& t : taken)
      if (std::abs(t.x - at_x) < t.half_width + half + kMargin) room = std::min(room, std::abs(t.y - at_y) - kSize);
    return room;
  };
  const auto whole = [&](const PictureCurve& own, std::size_t i, double half) {
    const auto [from, to] = beside(i, half);
    return std::all_of(own.v.begin() + static_cast<std::ptrdiff_t>(from),
                       own.v.begin() + static_cast<std::ptrdiff_t>(to) + 1, [](double v) { return std::isfinite(v); });
  };
  for (const PictureCurve& c : p.curves) {
    const double half = 4.2 * static_cast<double>(c.key.size());
    std::size_t best = 0;
    double most = -1.0;
    // Not at the end of a line, where the name would be next to it, unless the line is short.
    for (const bool inside : {true, false}) {
      for (std::size_t i = 0; i < p.x_m.size() && (inside || most < 0.0); ++i)
        if (std::isfinite(c.v[i]) && (!inside || whole(c, i, half)))
          if (const double room = room_at(c, i, half); room > most + 1e-9) {
            most = room;
            best = i;
          }
    }
    if (most < 0.0) continue;
    taken.push_back({x.at(p.x_m[best]), y.at(c.v[best]), half});
    drawing.name(taken.back().x, taken.back().y + 4.0, c.key, kSize, c.stroke.colour);
  }
}

std::string subtitle(const Approached& a) {
  const io::CurvesInput& c = a.input();
  const Scalars s = scalars_of(a);
  std::string text = fmt::format("{}, L_TRAIN {:g} m   |   SUBSET-026 {}   |   T_be {} s, T_bs {} s", c.train_name,
                                 c.inputs.train.L_TRAIN.si, name(c.inputs.srs), fixed(s.T_be_s, 2), fixed(s.T_bs_s, 2));
  if (c.A_est.si != 0.0) text += fmt::format("   |   A_est {:g} m/s\u00B2", c.A_est.si);
  return text;
}

}  // namespace

Drawing curves_drawing(const Approached& a, Theme theme) {
  const Picture p = picture_of(a);
  const std::vector<std::string> title = wrapped(a.input().name, 88, 4);
  const Layout l = layout_of(p, title.size(), theme);
  const Axis x{p.from_m, p.to_m, kLeft, l.right};
  const Axis y{p.bottom_kmh, p.top_kmh, l.bottom, l.top};
  const double height = l.strip_bottom + 80.0;
  Drawing drawing(kWidth, height, a.input().name);
  for (std::size_t i = 0; i < title.size(); ++i)
    drawing.text(kLeft, 34 + kTitleLine * static_cast<double>(i), title[i], 20, colour::ink, "start", true);
  drawing.text(kLeft, 33 + kTitleLine * static_cast<double>(title.size()), shortened(subtitle(a), 150), 13,
               colour::soft);
  grid(drawing, x, y, l, a);
  drawing.clip(kLeft, l.top, l.right - kLeft, l.bottom - l.top);
  marks(drawing, p, x, y, l);
  for (const PictureCurve& c : p.curves) {
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < p.x_m.size(); ++i) points.emplace_back(x.at(p.x_m[i]), y.at(c.v[i]));
    // On paper a wide line is lighter.
    const bool pale = theme == Theme::print && c.key == "MRSP";
    drawing.polyline(std::move(points), {pale ? kPaleGrey : c.stroke.colour, c.stroke.width, c.stroke.dash});
  }
  drawing.end_clip();
  zones(drawing, p, x, l);
  gradient_strip(drawing, p, x, l);
  if (theme == Theme::screen)
    legend(drawing, p, l);
  else
    names_at_curves(drawing, p, x, y, l);
  if (theme == Theme::print) {
    drawing.text(l.right, l.strip_bottom + 42, "dashed: the lowest gradient under the train", 11, colour::soft, "end");
    drawing.line(kLeft, l.bottom, l.right, l.bottom, {colour::soft, 1.0, ""});
    drawing.line(kLeft, l.top, kLeft, l.bottom, {colour::soft, 1.0, ""});
    drawing.for_paper();
  }
  drawing.text(kLeft, height - 14, "openevc: no safety integrity is claimed", 10.5, colour::soft);
  return drawing;
}

}  // namespace evc::curves
