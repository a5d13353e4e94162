#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curves/compare.h"
#include "curves/svg.h"
#include "curves/workbook.h"

// The charts of `evc curves compare` and `--model workbook`.
namespace evc::curves {
namespace {

/// One panel with its axes: dark, like the driver's display.
struct Panel {
  double left, top, right, bottom;
  Axis x, y;

  void draw(Svg& svg, const std::string& x_name, const std::string& y_name) const {
    svg.rect(left, top, right - left, bottom - top, colour::dark_blue);
    for (const double v : y.ticks(8)) {
      svg.line(left, y.at(v), right, y.at(v), {v == 0.0 ? colour::medium_grey : colour::pasp_dark, 1.0, ""});
      svg.text(left - 7, y.at(v) + 4, label(v), 11.5, colour::ink, "end");
    }
    for (const double v : x.ticks(8)) {
      svg.line(x.at(v), top, x.at(v), bottom, {colour::pasp_dark, 1.0, ""});
      svg.text(x.at(v), bottom + 17, label(v), 11.5, colour::ink, "middle");
    }
    svg.text((left + right) / 2, bottom + 38, x_name, 12, colour::soft, "middle");
    svg.vertical_text(left - 48, (top + bottom) / 2, y_name, 12, colour::soft);
  }
  void curve(Svg& svg, const std::vector<std::pair<double, double>>& values, const Stroke& stroke) const {
    std::vector<std::pair<double, double>> points;
    points.reserve(values.size());
    for (const auto& [a, b] : values) points.emplace_back(x.at(a), y.at(b));
    svg.clip(left, top, right - left, bottom - top);
    svg.polyline(points, stroke);
    svg.end_clip();
  }
};

/// A row of entries on a dark strip.
void legend(Svg& svg, double left, double right, double top,
            const std::vector<std::pair<std::string, Stroke>>& entries) {
  svg.rect(left, top, right - left, 30, colour::dark_blue);
  double x = left + 14;
  for (const auto& [name, stroke] : entries) {
    svg.line(x, top + 15, x + 26, top + 15, stroke);
    svg.text(x + 33, top + 19, name, 12, colour::white);
    x += 33 + 7.3 * static_cast<double>(name.size()) + 18;
  }
}

struct Drawn {
  const char* name;
  Value SpeedRow::*value;
  Stroke stroke;
  double width_of_difference;  // SBI, W and P often have equal differences: the lines stay visible below each other
};
const Drawn kDrawn[] = {
    {"EBD", &SpeedRow::EBD, {colour::EBD, 1.7, ""}, 1.7},     {"SBD", &SpeedRow::SBD, {colour::SBD, 1.7, ""}, 1.7},
    {"GUI", &SpeedRow::GUI, {colour::GUI, 1.7, ""}, 1.7},     {"EBI", &SpeedRow::EBI, {colour::red, 2.4, ""}, 2.4},
    {"SBI", &SpeedRow::FLOI, {colour::orange, 2.2, ""}, 6.5}, {"W", &SpeedRow::W, {colour::orange, 1.2, ""}, 4.0},
    {"P", &SpeedRow::P, {colour::yellow, 2.2, ""}, 2.0},      {"I", &SpeedRow::I, {colour::white, 1.5, ""}, 1.5},
};

std::vector<std::pair<double, double>> of(const std::vector<SpeedRow>& rows, const Drawn& d, bool speed_first) {
  std::vector<std::pair<double, double>> points;
  for (const SpeedRow& row : rows) {
    const double v = (row.*d.value).value_or(std::nan(""));
    points.push_back(speed_first ? std::pair{row.v_kmh, v} : std::pair{v, row.v_kmh});
  }
  return points;
}

/// A range with a margin.
std::pair<double, double> widened(double low, double high) {
  if (!(high > low)) return {low - 1.0, high + 1.0};
  const double room = 0.06 * (high - low);
  return {low - room, high + room};
}

}  // namespace

std::string comparison_svg(const Comparison& c) {
  double farthest = 0.0, nearest = 0.0, low = 0.0, high = 0.0, top = 0.0;
  for (std::size_t i = 0; i < c.difference.size(); ++i)
    for (const Drawn& d : kDrawn) {
      for (const auto* rows : {&c.rows_a, &c.rows_b}) {
        farthest = std::max(farthest, ((*rows)[i].*d.value).value_or(0.0));
        nearest = std::min(nearest, ((*rows)[i].*d.value).value_or(0.0));
      }
      low = std::min(low, (c.difference[i].*d.value).value_or(0.0));
      high = std::max(high, (c.difference[i].*d.value).value_or(0.0));
      top = std::max(top, c.difference[i].v_kmh);
    }
  const auto [d_low, d_high] = widened(low, high);
  const auto [x_low, x_high] = widened(nearest, farthest);
  const double down = 18.0 * static_cast<double>(c.warnings.size());  // space for the warnings
  const double top_px = 174 + down, bottom_px = 662 + down;
  const Panel left{
      78, top_px, 640, bottom_px, {x_high, x_low, 78, 640}, {0.0, std::max(top * 1.04, 1.0), bottom_px, top_px}};
  const Panel right{
      742, top_px, 1264, bottom_px, {0.0, std::max(top * 1.04, 1.0), 742, 1264}, {d_low, d_high, bottom_px, top_px}};
  Svg svg(1280, 752 + down, c.name_a + " / " + c.name_b);
  svg.text(78, 34, "A  " + shortened(c.name_a, 100), 17, colour::ink, "start", true);
  svg.text(78, 58, "B  " + shortened(c.name_b, 100), 17, colour::ink, "start", true);
  svg.text(78, 80, differ_text(c), 13, colour::soft);
  for (std::size_t i = 0; i < c.warnings.size(); ++i)
    svg.text(78, 98 + 18.0 * static_cast<double>(i), "Warning: " + c.warnings[i], 13, colour::red);
  std::vector<std::pair<std::string, Stroke>> entries;
  for (const Drawn& d : kDrawn) {
    const auto has = [&](const SpeedRow& row) { return (row.*d.value).has_value(); };
    if (std::any_of(c.rows_a.begin(), c.rows_a.end(), has) || std::any_of(c.rows_b.begin(), c.rows_b.end(), has))
      entries.emplace_back(d.name, d.stroke);
  }
  entries.emplace_back("A (left)", Stroke{colour::grey, 2.0, ""});
  entries.emplace_back("B (left)", Stroke{colour::grey, 2.0, "6 4"});
  legend(svg, 78, 1264, 100 + down, entries);
  svg.text(78, 160 + down, "Curves and limits", 13.5, colour::ink, "start", true);
  svg.text(742, 160 + down, "B \u2212 A: positive where B has to brake earlier", 13.5, colour::ink, "start", true);
  left.draw(svg, "distance before the target [m]", "speed [km/h]");
  right.draw(svg, "speed [km/h]", "difference [m]");
  for (const Drawn& d : kDrawn) {
    left.curve(svg, of(c.rows_a, d, false), d.stroke);
    left.curve(svg, of(c.rows_b, d, false), {d.stroke.colour, d.stroke.width, "6 4"});
    right.curve(svg, of(c.difference, d, true), {d.stroke.colour, d.width_of_difference, ""});
  }
  svg.text(78, 738 + down, "openevc: no safety integrity is claimed", 10.5, colour::soft);
  return svg.finish();
}

std::string workbook_svg(const Workbook& w, const Approached& a) {
  using Points = std::vector<std::pair<double, double>>;
  Points mrsp, Vc, V0, EBD, EBI, d_EBD, d_EBI;
  double top = 0.0, low = -1.0, high = 1.0;
  for (std::size_t i = 0; i < w.rows.size(); ++i) {
    const WorkbookRow& r = w.rows[i];
    if (i > 0 && r.MRSP != w.rows[i - 1].MRSP) mrsp.emplace_back(w.rows[i - 1].distance, r.MRSP * kKmh);
    mrsp.emplace_back(r.distance, r.MRSP * kKmh);
    Vc.emplace_back(r.distance, r.Vc_EBD * kKmh);
    V0.emplace_back(r.distance, r.V0_EBI * kKmh);
    EBD.emplace_back(r.distance, w.SRS_EBD[i] * kKmh);
    EBI.emplace_back(r.distance, w.SRS_EBI[i] * kKmh);
    d_EBD.emplace_back(r.distance, (r.Vc_EBD - w.SRS_EBD[i]) * kKmh);
    d_EBI.emplace_back(r.distance, (r.V0_EBI - w.SRS_EBI[i]) * kKmh);
    for (const double d : {d_EBD.back().second, d_EBI.back().second}) {
      low = std::min(low, d);
      high = std::max(high, d);
    }
    top = std::max({top, r.MRSP_plus_dV * kKmh, w.SRS_EBD[i] * kKmh});
  }
  const auto [d_low, d_high] = widened(low, high);
  const double length = w.inputs.length.si;
  const Panel above{78, 152, 1264, 520, {0.0, length, 78, 1264}, {0.0, top * 1.06, 520, 152}};
  const Panel below{78, 606, 1264, 790, {0.0, length, 78, 1264}, {d_low, d_high, 790, 606}};
  Svg svg(1280, 880, w.name);
  svg.text(78, 34, shortened(w.name, 95), 18, colour::ink, "start", true);
  svg.text(78, 58,
           fmt::format("sheet: A_safe {:g} m/s\u00B2, DT {:g} s, DX {:g} m, DV {:g} m/s   |   SRS {}: {}",
                       w.inputs.A_safe.si, w.inputs.DT.si, w.inputs.DX.si, w.inputs.DV.si, name(a.input().inputs.srs),
                       a.input().train_name),
           13, colour::soft);
  const Stroke sheet_EBD{colour::white, 1.4, "6 4"}, sheet_EBI{colour::red, 2.4, "6 4"};
  const Stroke srs_EBD{colour::EBD, 1.8, ""}, srs_EBI{colour::red, 2.4, ""}, ceiling{colour::grey, 1.6, ""};
  legend(svg, 78, 1264, 78,
         {{"MRSP", ceiling},
          {"Vc = EBD, sheet", sheet_EBD},
          {"V0 = EBI, sheet", sheet_EBI},
          {"EBD, SRS", srs_EBD},
          {"EBI, SRS", srs_EBI}});
  svg.text(78, 138, "Emergency brake deceleration and intervention", 13.5, colour::ink, "start", true);
  above.draw(svg, "location along the line [m]", "speed [km/h]");
  above.curve(svg, mrsp, ceiling);
  above.curve(svg, EBD, srs_EBD);
  above.curve(svg, EBI, srs_EBI);
  above.curve(svg, Vc, sheet_EBD);
  above.curve(svg, V0, sheet_EBI);
  svg.text(78, 592, "Sheet \u2212 SRS: above 0 the sheet intervenes later than the standard", 13.5, colour::ink,
           "start", true);
  below.draw(svg, "location along the line [m]", "deviation [km/h]");
  below.curve(svg, d_EBD, srs_EBD);
  below.curve(svg, d_EBI, srs_EBI);
  svg.text(78, 866, "openevc: no safety integrity is claimed", 10.5, colour::soft);
  return svg.finish();
}

}  // namespace evc::curves
