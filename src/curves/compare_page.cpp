#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curves/compare.h"
#include "curves/drawing.h"
#include "io/number.h"
#include "io/xml.h"

// The interactive page of `evc curves compare`: results at every km/h; the page interpolates.
namespace evc::curves {

extern const char compare_page_template[];

namespace {

constexpr double kDrawn_kmh = 1.0;  // of drawn_speeds

struct Shown {
  const char* key;
  Value SpeedRow::*value;
  const char* colour;
  double width;
};
const Shown kShown[] = {
    {"EBD", &SpeedRow::EBD, colour::EBD, 1.7},     {"SBD", &SpeedRow::SBD, colour::SBD, 1.7},
    {"GUI", &SpeedRow::GUI, colour::GUI, 1.7},     {"EBI", &SpeedRow::EBI, colour::red, 2.4},
    {"SBI", &SpeedRow::FLOI, colour::orange, 2.2}, {"W", &SpeedRow::W, colour::orange, 1.3},
    {"P", &SpeedRow::P, colour::yellow, 2.2},      {"I", &SpeedRow::I, colour::white, 1.5},
};

/// More precise than a chart shows.
void append_rounded(std::string& out, const Value& v) {
  if (v.has_value() && std::isfinite(*v))
    io::append_number(out, std::nearbyint(*v * 100.0) / 100.0 + 0.0);
  else
    out += "null";
}
std::string side(const Approached& a) {
  const io::CurvesInput& c = a.input();
  return fmt::format("{}, L_TRAIN {:g} m, SUBSET-026 {}", c.train_name, c.inputs.train.L_TRAIN.si, name(c.inputs.srs));
}

/// `"curves":{"EBD":[...],...},"scalars":{...}`: the curves that it has, at every km/h up to the highest of so many
/// rows.
void append_results(std::string& out, const Approached& a, std::size_t count) {
  std::vector<SpeedRow> rows;
  for (std::size_t i = 0; i < count; ++i) rows.push_back(speed_row(a, static_cast<double>(i) * kDrawn_kmh));
  out += "\"curves\":{";
  for (const Shown& s : kShown) {
    if (std::none_of(rows.begin(), rows.end(), [&](const SpeedRow& row) { return (row.*s.value).has_value(); }))
      continue;
    out += fmt::format("{}\"{}\":[", out.back() == '{' ? "" : ",", s.key);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i > 0) out += ',';
      append_rounded(out, rows[i].*s.value);
    }
    out += ']';
  }
  out += "},\"scalars\":{";
  const Scalars scalars = scalars_of(a);
  for (const auto& s : scalar_columns()) {
    if (!(scalars.*s.value)) continue;
    out += fmt::format("{}\"{}\":", out.back() == '{' ? "" : ",", s.name);
    append_rounded(out, scalars.*s.value);
  }
  out += '}';
}

/// What the page has of an input that is compared with A.
std::string other_of(const Approached& a, const Approached& b, const Comparison& asked, std::size_t count) {
  std::string out = "{\"name\":";
  io::append_string(out, asked.name_b);
  out += ",\"subtitle\":";
  io::append_string(out, "A: " + side(a) + "; B: " + side(b) + "; " + differ_text(asked));
  out += ",\"warnings\":[";
  for (const std::string& warning : asked.warnings) {
    if (out.back() != '[') out += ',';
    io::append_string(out, warning);
  }
  out += fmt::format("],\"rows\":{},", count);
  append_results(out, b, count);
  return out + '}';
}

/// A once, and the others: the page compares them.
std::string data_of(const Approached& a, std::span<const Approached> others) {
  std::string list;
  std::size_t longest = 0;
  for (const Approached& b : others) {
    const Comparison asked = compare_curves(a, b);
    const std::size_t count = drawn_speeds(asked).size();
    longest = std::max(longest, count);
    list += (list.empty() ? "" : ",") + other_of(a, b, asked, count);
  }
  std::string out = fmt::format("{{\"step\":{:g},\"shown\":[", kDrawn_kmh);
  for (const Shown& s : kShown)
    out += fmt::format("{}{{\"key\":\"{}\",\"colour\":\"{}\",\"width\":{:g}}}", out.back() == '[' ? "" : ",", s.key,
                       s.colour, s.width);
  out += "],\"scalars\":[";
  for (const auto& s : scalar_columns()) out += fmt::format("{}\"{}\"", out.back() == '[' ? "" : ",", s.name);
  out += "],\"a\":{\"name\":";
  io::append_string(out, a.input().name);
  out += ',';
  append_results(out, a, longest);
  return out + "},\"others\":[" + list + "]}";
}

}  // namespace

std::string comparison_html(const Approached& a, std::span<const Approached> others) {
  std::string page = compare_page_template;
  const std::string slot = "/*DATA*/null";
  page.replace(page.find(slot), slot.size(), io::json_in_script(data_of(a, others)));
  return page;
}

}  // namespace evc::curves
