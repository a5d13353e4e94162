#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "curves/compare.h"
#include "curves/drawing.h"
#include "curves/workbook.h"

// The charts of `evc curves compare` and `--model workbook`.
namespace evc::curves {
namespace {

/// One panel with its axes: dark, like the driver's display.
struct Panel {
  double left, top, right, bottom;
  Axis x, y;

  void draw(Drawing& drawing, const std::string& x_name, const std::string& y_name) const {
    drawing.rect(left, top, right - left, bottom - top, colour::dark_blue);
    for (const double v : y.ticks(8)) {
      drawing.line(left, y.at(v), right, y.at(v), {v == 0.0 ? colour::medium_grey : colour::pasp_dark, 1.0, ""});
      drawing.text(left - 7, y.at(v) + 4, label(v), 11.5, colour::ink, "end");
    }
    for (const double v : x.ticks(8)) {
      drawing.line(x.at(v), top, x.at(v), bottom, {colour::pasp_dark, 1.0, ""});
      drawing.text(x.at(v), bottom + 17, label(v), 11.5, colour::ink, "middle");
    }
    drawing.text((left + right) / 2, bottom + 38, x_name, 12, colour::soft, "middle");
    drawing.vertical_text(left - 48, (top + bottom) / 2, y_name, 12, colour::soft);
  }
  void curve(Drawing& drawing, const std::vector<std::pair<double, double>>& values, const Stroke& stroke) const {
    std::vector<std::pair<double, double>> points;
    points.reserve(values.size());
    for (const auto& [a, b] : values) points.emplace_back(x.at(a), y.at(b));
    drawing.clip(left, top, right - left, bottom - top);
    drawing.polyline(std::move(points), stroke);
    drawing.end_clip();
  }
};

/// A row of entries on a dark strip.
void legend(Drawing& drawing, double left, double right, double top,
            const std::vector<std::pair<std::string, Stroke>>& entries) {
  drawing.rect(left, top, right - left, 30, colour::dark_blue);
  double x = left + 14;
  for (const auto& [name, stroke] : entries) {
    drawing.line(x, top + 15, x + 26, top + 15, stroke);
    drawing.text(x + 33, top + 19, name, 12, colour::white);
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

namespace {

/// The dashes of A, B, C, ...: each curve has the colour of its limit.
const char* dash_of(std::size_t input) {
  constexpr const char* kDashes[] = {"", "6 4", "2 3", "10 3 2 3", "1 3", "14 4"};
  return kDashes[input % std::size(kDashes)];
}

/// "SBI = W = P": limits whose differences are the same at every speed, and lie on each other.
std::string coincident(const std::vector<Comparison>& all) {
  const auto same = [&](const Drawn& d, const Drawn& e) {
    bool any = false;
    for (const Comparison& c : all)
      for (const SpeedRow& row : c.difference) {
        const Value &x = row.*d.value, &y = row.*e.value;
        if (x.has_value() != y.has_value() || (x && std::abs(*x - *y) > 0.05)) return false;
        any = any || x;
      }
    return any;
  };
  std::string text;
  std::vector<bool> named(std::size(kDrawn), false);
  for (std::size_t i = 0; i < std::size(kDrawn); ++i) {
    std::string group = kDrawn[i].name;
    for (std::size_t k = i + 1; k < std::size(kDrawn); ++k)
      if (!named[i] && !named[k] && same(kDrawn[i], kDrawn[k])) {
        group += std::string(" = ") + kDrawn[k].name;
        named[k] = true;
      }
    if (group != kDrawn[i].name) text += (text.empty() ? "; equal: " : ", ") + group;
  }
  return text;
}

struct Extent {
  double farthest = 0.0, nearest = 0.0, low = 0.0, high = 0.0, top = 0.0;
};
Extent extent_of(const std::vector<Comparison>& all) {
  Extent e;
  for (const Comparison& c : all)
    for (std::size_t i = 0; i < c.difference.size(); ++i)
      for (const Drawn& d : kDrawn) {
        for (const auto* rows : {&c.rows_a, &c.rows_b}) {
          e.farthest = std::max(e.farthest, ((*rows)[i].*d.value).value_or(0.0));
          e.nearest = std::min(e.nearest, ((*rows)[i].*d.value).value_or(0.0));
        }
        e.low = std::min(e.low, (c.difference[i].*d.value).value_or(0.0));
        e.high = std::max(e.high, (c.difference[i].*d.value).value_or(0.0));
        e.top = std::max(e.top, c.difference[i].v_kmh);
      }
  return e;
}

std::vector<std::pair<std::string, Stroke>> entries_of(const std::vector<Comparison>& all) {
  std::vector<std::pair<std::string, Stroke>> entries;
  for (const Drawn& d : kDrawn) {
    const auto has = [&](const SpeedRow& row) { return (row.*d.value).has_value(); };
    if (std::any_of(all.begin(), all.end(), [&](const Comparison& c) {
          return std::any_of(c.rows_a.begin(), c.rows_a.end(), has) ||
                 std::any_of(c.rows_b.begin(), c.rows_b.end(), has);
        }))
      entries.emplace_back(d.name, d.stroke);
  }
  return entries;
}

}  // namespace

Drawing comparison_drawing(const std::vector<Comparison>& all, Theme theme) {
  EVC_REQUIRE(!all.empty());
  const bool two = all.size() == 1;
  const Extent e = extent_of(all);
  const auto [d_low, d_high] = widened(e.low, e.high);
  const auto [x_low, x_high] = widened(e.nearest, e.farthest);
  // The head: a line for each input, with the dash of its curves, what differs, and the warnings.
  struct Line {
    std::string text;
    double size;
    const char* fill;
    bool bold;
  };
  std::vector<Line> head;
  head.push_back({"A  " + shortened(all[0].name_a, 100), 17, colour::ink, true});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string letter = input_letter(i + 1);
    head.push_back({letter + "  " + shortened(all[i].name_b, 100), 17, colour::ink, true});
    head.push_back({(two ? "" : "A and " + letter + ": ") + differ_text(all[i]), 13, colour::soft, false});
    for (const std::string& warning : all[i].warnings) head.push_back({"Warning: " + warning, 13, colour::red, false});
  }
  double y = 34;
  for (const Line& line : head) y += line.size > 15 ? 24 : 19;
  const double legend_top = y - 12, top_px = y + 62, bottom_px = top_px + 488;
  Drawing drawing(1280, bottom_px + 90, all[0].name_a + " / " + all[0].name_b);
  y = 34;
  for (std::size_t i = 0, input = 0; i < head.size(); ++i) {
    drawing.text(78, y, head[i].text, head[i].size, head[i].fill, "start", head[i].bold);
    if (head[i].bold) {
      drawing.line(20, y - 6, 66, y - 6, {colour::ink, 2.2, dash_of(input)});
      ++input;
    }
    y += head[i].size > 15 ? 24 : 19;
  }
  const double top = std::max(e.top * 1.04, 1.0);
  const Panel left{78, top_px, 640, bottom_px, {x_high, x_low, 78, 640}, {0.0, top, bottom_px, top_px}};
  const Panel right{742, top_px, 1264, bottom_px, {0.0, top, 742, 1264}, {d_low, d_high, bottom_px, top_px}};
  legend(drawing, 78, 1264, legend_top, entries_of(all));
  drawing.text(78, top_px - 12, "Curves and limits: line styles as above", 13.5, colour::ink, "start", true);
  drawing.text(742, top_px - 12,
               (two ? "B \u2212 A: positive where B has to brake earlier"
                    : "Difference to A: positive where the other has to brake earlier"),
               13.5, colour::ink, "start", true);
  left.draw(drawing, "distance before the target [m]", "speed [km/h]");
  right.draw(drawing, "speed [km/h]", "difference [m]" + coincident(all));
  for (const Drawn& d : kDrawn) {
    left.curve(drawing, of(all[0].rows_a, d, false), d.stroke);
    for (std::size_t i = 0; i < all.size(); ++i) {
      left.curve(drawing, of(all[i].rows_b, d, false), {d.stroke.colour, d.stroke.width, dash_of(i + 1)});
      right.curve(drawing, of(all[i].difference, d, true),
                  {d.stroke.colour, two ? d.width_of_difference : d.stroke.width, two ? "" : dash_of(i + 1)});
    }
  }
  if (theme == Theme::print) drawing.for_paper();
  drawing.text(78, bottom_px + 76, "openevc: no safety integrity is claimed", 10.5, colour::soft);
  return drawing;
}

Drawing workbook_drawing(const Workbook& w, const Approached& a, Theme theme) {
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
  Drawing drawing(1280, 880, w.name);
  drawing.text(78, 34, shortened(w.name, 95), 18, colour::ink, "start", true);
  drawing.text(78, 58,
               fmt::format("sheet: A_safe {:g} m/s\u00B2, DT {:g} s, DX {:g} m, DV {:g} m/s   |   SRS {}: {}",
                           w.inputs.A_safe.si, w.inputs.DT.si, w.inputs.DX.si, w.inputs.DV.si,
                           name(a.input().inputs.srs), a.input().train_name),
               13, colour::soft);
  const Stroke sheet_EBD{colour::white, 1.4, "6 4"}, sheet_EBI{colour::red, 2.4, "6 4"};
  // Wide: the dashes of the sheet lie on it.
  const Stroke srs_EBD{colour::EBD, 4.5, ""}, srs_EBI{colour::red, 2.4, ""}, ceiling{colour::grey, 1.6, ""};
  legend(drawing, 78, 1264, 78,
         {{"MRSP", ceiling},
          {"Vc = EBD, sheet", sheet_EBD},
          {"V0 = EBI, sheet", sheet_EBI},
          {"EBD, SRS", srs_EBD},
          {"EBI, SRS", srs_EBI}});
  drawing.text(78, 138, "Emergency brake deceleration and intervention", 13.5, colour::ink, "start", true);
  above.draw(drawing, "location along the line [m]", "speed [km/h]");
  above.curve(drawing, mrsp, ceiling);
  above.curve(drawing, EBD, srs_EBD);
  above.curve(drawing, EBI, srs_EBI);
  above.curve(drawing, Vc, sheet_EBD);
  above.curve(drawing, V0, sheet_EBI);
  drawing.text(78, 592, "Sheet \u2212 SRS: above 0 the sheet intervenes later than the standard", 13.5, colour::ink,
               "start", true);
  below.draw(drawing, "location along the line [m]", "deviation [km/h]");
  below.curve(drawing, d_EBD, {colour::EBD, 1.8, ""});
  below.curve(drawing, d_EBI, srs_EBI);
  if (theme == Theme::print) drawing.for_paper();
  drawing.text(78, 866, "openevc: no safety integrity is claimed", 10.5, colour::soft);
  return drawing;
}

}  // namespace evc::curves
