#include "deceleration/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curves/drawing.h"
#include "deceleration/train_document.h"

namespace evc::deceleration {
namespace {

namespace colour = curves::colour;
using curves::Axis;
using curves::Drawing;
using curves::Stroke;

constexpr double kWidth = 1280.0, kHeight = 640.0;
constexpr double kTop = 84.0, kBottom = 548.0;
constexpr double kLeft = 74.0, kRight = 760.0;                  // decelerations over speed
constexpr double kFactorsLeft = 850.0, kFactorsRight = 1256.0;  // factors by level
/// The levels of the left panel: more lines than these look alike.
struct Shown {
  std::size_t level;
  Stroke stroke;
};
const Shown kShown[] = {{0, {colour::grey, 1.6, ""}},
                        {3, {colour::yellow, 1.6, ""}},
                        {6, {colour::orange, 1.6, ""}},
                        {9, {colour::EBD, 2.2, ""}}};
const char* const kColours[] = {colour::EBD,    colour::SBD,  colour::GUI, colour::yellow,
                                colour::orange, colour::grey, colour::red, colour::white};

using Points = std::vector<std::pair<double, double>>;

void grid(Drawing& drawing, const Axis& x, const Axis& y, double left, double right) {
  drawing.rect(left, kTop, right - left, kBottom - kTop, colour::dark_blue);
  for (const double v : y.ticks(8)) {
    drawing.line(left, y.at(v), right, y.at(v), {colour::pasp_dark, 1.0, ""});
    drawing.text(left - 8, y.at(v) + 4, curves::label(v), 12, colour::ink, "end");
  }
  for (const double v : x.ticks(9)) {
    drawing.line(x.at(v), kTop, x.at(v), kBottom, {colour::pasp_dark, 1.0, ""});
    drawing.text(x.at(v), kBottom + 18, curves::label(v), 12, colour::ink, "middle");
  }
}

/// A line with a step at each speed.
template <class Steps, class ValueOf>
Points staircase(const Steps& steps, const Axis& x, const Axis& y, ValueOf value_of) {
  Points points;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    const double to = s + 1 < steps.size() ? steps[s + 1].from_kmh : x.to;
    points.emplace_back(x.at(steps[s].from_kmh), y.at(value_of(steps[s])));
    points.emplace_back(x.at(to), y.at(value_of(steps[s])));
  }
  return points;
}

void legend(Drawing& drawing, double left, double top, const std::vector<std::pair<std::string, Stroke>>& entries,
            double column) {
  double x = left + 14;
  for (const auto& [name, stroke] : entries) {
    drawing.line(x, top, x + 24, top, stroke);
    drawing.text(x + 30, top + 4, name, 11.5, colour::white);
    x += column;
  }
}

void draw_decelerations(Drawing& drawing, const Spec& spec, const Guaranteed& result) {
  const std::vector<Step> joint = train_steps(spec, result.safe_steps());
  double top = 0.0;
  for (const auto& step : result.steps)
    top = std::max(top, step.A_brake_emergency * std::max(1.0, step.Kdry_rst[0].value));
  const auto train = spec.document.find("train");
  double to_kmh = spec.speeds_kmh.back() + std::max(20.0, 0.15 * spec.speeds_kmh.back());
  if (train != spec.document.end() && train->contains("max_speed_kmh"))
    to_kmh = std::max(spec.speeds_kmh.back() + 1.0, (*train)["max_speed_kmh"].get<double>());
  const Axis x{0.0, to_kmh, kLeft, kRight};
  const Axis y{0.0, top * 1.18, kBottom, kTop};
  grid(drawing, x, y, kLeft, kRight);
  drawing.text((kLeft + kRight) / 2, kBottom + 40, "speed [km/h]", 12, colour::soft, "middle");
  drawing.vertical_text(20, (kTop + kBottom) / 2, "deceleration [m/s\u00B2]", 12, colour::soft);
  std::vector<std::pair<std::string, Stroke>> entries;
  const Stroke nominal{colour::white, 2.2, ""}, file{colour::SBD, 1.6, "5 3"};
  drawing.polyline(staircase(result.steps, x, y, [](const auto& s) { return s.A_brake_emergency; }), nominal);
  entries.emplace_back("A_brake_emergency", nominal);
  for (const Shown& shown : kShown) {
    drawing.polyline(staircase(result.steps, x, y,
                               [&](const auto& s) { return s.A_brake_emergency * s.Kdry_rst[shown.level].value; }),
                     shown.stroke);
    entries.emplace_back(fmt::format("level {}", shown.level), shown.stroke);
  }
  drawing.polyline(staircase(joint, x, y, [](const Step& s) { return s.A_brake_emergency * s.Kdry_rst[9]; }), file);
  entries.emplace_back("train file, level 9", file);
  drawing.text(kLeft, kTop - 10, "Deceleration: nominal, and guaranteed by M_NVEBCL", 12.5, colour::ink, "start", true);
  legend(drawing, kLeft, kTop + 18, {entries.front()}, 0.0);
  legend(drawing, kLeft + 170, kTop + 18, {entries.begin() + 1, entries.end()}, 94.0);
}

void draw_factors(Drawing& drawing, const Guaranteed& result) {
  double low = 1.0, high = 1.0;
  for (const auto& step : result.steps)
    for (const Quantile& q : step.Kdry_rst) {
      low = std::min(low, q.low);
      high = std::max(high, q.high);
    }
  const double margin = 0.05 * (high - low) + 0.002;
  const Axis x{-0.4, 9.4, kFactorsLeft, kFactorsRight};
  const Axis y{low - margin, high + 3.0 * margin, kBottom, kTop};
  grid(drawing, x, y, kFactorsLeft, kFactorsRight);
  drawing.text((kFactorsLeft + kFactorsRight) / 2, kBottom + 40, "M_NVEBCL", 12, colour::soft, "middle");
  drawing.vertical_text(kFactorsLeft - 58, (kTop + kBottom) / 2, "Kdry_rst", 12, colour::soft);
  drawing.text(kFactorsLeft, kTop - 10, "Kdry_rst with its 95 % bounds, by speed", 12.5, colour::ink, "start", true);
  // With many steps: as many of them as there are colours, evenly.
  const std::size_t n = result.steps.size(), lines = std::min(n, std::size(kColours));
  double row = kBottom - 12.0 - 15.0 * static_cast<double>(lines - 1);
  for (std::size_t i = 0; i < lines; ++i) {
    const auto& step = result.steps[lines == 1 ? 0 : i * (n - 1) / (lines - 1)];
    Points points;
    for (std::size_t k = 0; k < kLevels; ++k) {
      const Quantile& q = step.Kdry_rst[k];
      const double at = x.at(static_cast<double>(k));
      points.emplace_back(at, y.at(q.value));
      drawing.line(at, y.at(q.low), at, y.at(q.high), {kColours[i], 3.0, ""});
    }
    drawing.polyline(points, {kColours[i], 1.3, ""});
    drawing.line(kFactorsLeft + 12, row - 4, kFactorsLeft + 34, row - 4, {kColours[i], 1.6, ""});
    drawing.text(kFactorsLeft + 40, row, fmt::format("from {:g} km/h", step.from_kmh), 11, colour::white);
    row += 15.0;
  }
}

}  // namespace

std::string chart(const Spec& spec, const Guaranteed& result) {
  const std::string name = spec.name.empty() ? "Guaranteed deceleration" : spec.name;
  Drawing drawing(kWidth, kHeight, name);
  drawing.text(kLeft, 32, curves::shortened(name, 88), 20, colour::ink, "start", true);
  std::string text = fmt::format("{} brake units, {:g} t   |   {} samples for each speed and level", spec.units(),
                                 spec.mass_t, spec.samples);
  if (const auto time = result.build_up_at(spec.response_level))
    text += fmt::format("   |   T_brake_emergency {:.2f} s (level {})", *time, spec.response_level);
  drawing.text(kLeft, 54, text, 13, colour::soft);
  draw_decelerations(drawing, spec, result);
  draw_factors(drawing, result);
  drawing.text(kLeft, kHeight - 14, "openevc: no safety integrity is claimed", 10.5, colour::soft);
  return curves::svg_of(drawing);
}

}  // namespace evc::deceleration
