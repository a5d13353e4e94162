#include "curves/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curves/picture.h"
#include "curves/svg.h"

namespace evc::curves {
namespace {

constexpr double kWidth = 1280.0;
constexpr double kLeft = 74.0, kRight = 1052.0, kTop = 104.0, kBottom = 600.0;
constexpr double kStripHeight = 92.0;
constexpr double kZoneRow = 16.0;
constexpr double kLegend = 1072.0;

/// The place of the strip of gradients: below the rows of zones.
struct Strip {
  double top, bottom;
};
Strip strip_of(const Picture& p) {
  const double top = kBottom + 28.0 + kZoneRow * static_cast<double>(p.zone_rows > 1 ? p.zone_rows - 1 : 0);
  return {top, top + kStripHeight};
}

void grid(Svg& svg, const Axis& x, const Axis& y, const Strip& strip, const Approached& a) {
  svg.rect(kLeft, kTop, kRight - kLeft, kBottom - kTop, colour::dark_blue);
  for (const double v : y.ticks(9)) {
    svg.line(kLeft, y.at(v), kRight, y.at(v), {colour::pasp_dark, 1.0, ""});
    svg.text(kLeft - 8, y.at(v) + 4, label(v), 12, colour::ink, "end");
  }
  for (const double place : x.ticks(10)) {
    svg.line(x.at(place), kTop, x.at(place), kBottom, {colour::pasp_dark, 1.0, ""});
    svg.text(x.at(place), strip.bottom + 20, label(place), 12, colour::ink, "middle");
  }
  // Distance to the target, above.
  const double target = a.input().target_location.from_origin.si;
  const Axis before{target - x.from, target - x.to, x.start, x.end};
  for (const double d : before.ticks(10)) {
    svg.line(before.at(d), kTop - 5, before.at(d), kTop, {colour::ink, 1.0, ""});
    svg.text(before.at(d), kTop - 9, label(d), 12, colour::ink, "middle");
  }
  svg.text((kLeft + kRight) / 2, kTop - 26, "distance before the target [m]", 12, colour::soft, "middle");
  svg.text((kLeft + kRight) / 2, strip.bottom + 42, "location along the line [m]", 12, colour::soft, "middle");
  svg.vertical_text(20, (kTop + kBottom) / 2, "speed [km/h]", 12, colour::soft);
  svg.vertical_text(20, (strip.top + strip.bottom) / 2, "gradient [\u2030]", 12, colour::soft);
}

void marks(Svg& svg, const Picture& p, const Axis& x, const Axis& y) {
  double above = kTop + 16;  // names are where no curve is: above on the right, below on the left
  double below = kBottom - 9;
  for (const Picture::Mark& mark : p.marks) {
    if (mark.x_m < p.from_m || mark.x_m > p.to_m) continue;
    const double at = x.at(mark.x_m);
    svg.line(at, kTop, at, kBottom, {colour::medium_grey, 1.2, "2 4"});
    const double width = 7.0 * static_cast<double>(mark.name.size());
    if (at < (kLeft + kRight) / 2) {
      svg.text(at + 5, below, mark.name, 11.5, colour::grey);
      below -= 15;
    } else if (at + width + 8.0 < kRight) {
      // On the far side of its line: separate from an SvL close to its EOA.
      svg.text(at + 5, above, mark.name, 11.5, colour::grey);
      above += 15;
    } else {
      svg.text(at - 5, above, mark.name, 11.5, colour::grey, "end");
      above += 15;
    }
  }
  if (p.V_release_kmh && p.start_of_RSM_m) {
    const double from = x.at(std::max(*p.start_of_RSM_m, p.from_m));
    svg.line(from, y.at(*p.V_release_kmh), kRight, y.at(*p.V_release_kmh), {colour::medium_grey, 3.0, ""});
    svg.line(from, y.at(*p.V_release_kmh), from, kBottom, {colour::medium_grey, 1.2, "2 4"});
  }
}

/// Conditions on a stretch of the track: a bar with its name.
void zones(Svg& svg, const Picture& p, const Axis& x) {
  for (const Picture::Zone& z : p.zones) {
    const double top = kBottom + 7.0 + kZoneRow * static_cast<double>(z.row);
    const double from = x.at(z.from_m), to = x.at(z.to_m);
    svg.rect(from, top, std::max(to - from, 2.0), kZoneRow - 2.0, colour::pasp_light);
    const double width = 6.2 * static_cast<double>(z.name.size());  // of the text
    if (to - from > width + 8.0)
      svg.text((from + to) / 2, top + 11, z.name, 10.5, colour::white, "middle");
    else if (from - width - 6.0 > kLeft)
      svg.text(from - 5, top + 11, z.name, 10.5, colour::ink, "end");
    else
      svg.text(to + 5, top + 11, z.name, 10.5, colour::ink);
  }
}

/// The gradient of the track and, lighter, the one that counts for the train.
void gradient_strip(Svg& svg, const Picture& p, const Axis& x, const Strip& strip) {
  double steepest = 5.0;
  for (const auto& step : p.gradient) steepest = std::max(steepest, std::abs(step.value));
  const Axis y{-steepest * 1.25, steepest * 1.25, strip.bottom, strip.top};
  svg.rect(kLeft, strip.top, kRight - kLeft, kStripHeight, colour::dark_blue);
  svg.clip(kLeft, strip.top, kRight - kLeft, kStripHeight);
  for (std::size_t i = 0; i < p.gradient.size(); ++i) {
    const double from = std::max(p.gradient[i].from_m, p.from_m);
    const double to = std::min(i + 1 < p.gradient.size() ? p.gradient[i + 1].from_m : p.to_m, p.to_m);
    const double value = p.gradient[i].value;
    if (!(to > from)) continue;
    const double height = std::abs(y.at(value) - y.at(0));
    svg.rect(x.at(from), std::min(y.at(value), y.at(0)), x.at(to) - x.at(from), std::max(height, 1.0),
             value < 0.0 ? colour::dark_grey : colour::grey);
    if (x.at(to) - x.at(from) > 26 && value != 0.0)
      svg.text((x.at(from) + x.at(to)) / 2, value > 0.0 ? y.at(0) + 14 : y.at(0) - 5, label(value), 11, colour::white,
               "middle");
  }
  std::vector<std::pair<double, double>> line;
  for (std::size_t i = 0; i < p.under_train.size(); ++i) {
    const double from = i == 0 ? p.from_m : p.under_train[i].from_m;
    const double to = i + 1 < p.under_train.size() ? p.under_train[i + 1].from_m : p.to_m;
    line.emplace_back(x.at(from), y.at(p.under_train[i].value));
    line.emplace_back(x.at(to), y.at(p.under_train[i].value));
  }
  svg.polyline(line, {colour::EBD, 1.6, "5 3"});
  svg.end_clip();
  for (const double v : {-steepest, 0.0, steepest}) svg.text(kLeft - 8, y.at(v) + 4, label(v), 11, colour::ink, "end");
}

void legend(Svg& svg, const Picture& p, const Strip& strip) {
  svg.rect(kLegend, kTop, kWidth - kLegend - 16, strip.bottom - kTop, colour::dark_blue);
  double y = kTop + 26;
  const auto entry = [&](const Stroke& stroke, const std::string& name) {
    svg.line(kLegend + 12, y - 4, kLegend + 40, y - 4, stroke);
    const auto gap = name.find("  ");
    svg.text(kLegend + 48, y, name.substr(0, gap), 12.5, colour::white, "start", true);
    if (gap != std::string::npos) svg.text(kLegend + 48, y + 15, name.substr(gap + 2), 10.5, colour::grey);
    y += gap == std::string::npos ? 28 : 42;
  };
  for (const PictureCurve& c : p.curves) entry(c.stroke, c.name);
  if (p.V_release_kmh)
    entry({colour::medium_grey, 3.0, ""},
          "V_release  " + label(std::nearbyint(*p.V_release_kmh * 100.0) / 100.0) + " km/h");
  y = strip.top + 18;
  svg.rect(kLegend + 12, y - 11, 28, 11, colour::grey);
  svg.text(kLegend + 48, y, "uphill", 11, colour::white);
  y += 24;
  svg.rect(kLegend + 12, y - 11, 28, 11, colour::dark_grey);
  svg.text(kLegend + 48, y, "downhill", 11, colour::white);
  y += 24;
  svg.line(kLegend + 12, y - 4, kLegend + 40, y - 4, {colour::EBD, 1.6, "5 3"});
  svg.text(kLegend + 48, y, "lowest under train", 11, colour::white);
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

std::string curves_svg(const Approached& a) {
  const Picture p = picture_of(a);
  const Axis x{p.from_m, p.to_m, kLeft, kRight};
  const Axis y{0.0, p.top_kmh, kBottom, kTop};
  const Strip strip = strip_of(p);
  const double height = strip.bottom + 80.0;
  Svg svg(kWidth, height, a.input().name);
  svg.text(kLeft, 34, shortened(a.input().name, 88), 20, colour::ink, "start", true);
  svg.text(kLeft, 58, shortened(subtitle(a), 150), 13, colour::soft);
  grid(svg, x, y, strip, a);
  svg.clip(kLeft, kTop, kRight - kLeft, kBottom - kTop);
  marks(svg, p, x, y);
  for (const PictureCurve& c : p.curves) {
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < p.x_m.size(); ++i) points.emplace_back(x.at(p.x_m[i]), y.at(c.v[i]));
    svg.polyline(points, c.stroke);
  }
  svg.end_clip();
  zones(svg, p, x);
  gradient_strip(svg, p, x, strip);
  legend(svg, p, strip);
  svg.text(kLeft, height - 14, "openevc: no safety integrity is claimed", 10.5, colour::soft);
  return svg.finish();
}

}  // namespace evc::curves
