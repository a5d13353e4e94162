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
void append_rows(std::string& out, const char* key, const std::vector<SpeedRow>& rows, Value SpeedRow::*value) {
  out += fmt::format(",\"{}\":[", key);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0) out += ',';
    append_rounded(out, rows[i].*value);
  }
  out += ']';
}
bool exists(const std::vector<SpeedRow>& rows, Value SpeedRow::*value) {
  return std::any_of(rows.begin(), rows.end(), [&](const SpeedRow& row) { return (row.*value).has_value(); });
}

std::string side(const Approached& a) {
  const io::CurvesInput& c = a.input();
  return fmt::format("{}, L_TRAIN {:g} m, SUBSET-026 {}", c.train_name, c.inputs.train.L_TRAIN.si, name(c.inputs.srs));
}

std::string data_of(const Approached& a, const Approached& b) {
  const Comparison asked = compare_curves(a, b);
  const std::vector<double> speeds = drawn_speeds(asked);
  const Comparison c = compare_curves(a, b, speeds);
  std::string out = "{\"name_a\":";
  io::append_string(out, c.name_a);
  out += ",\"name_b\":";
  io::append_string(out, c.name_b);
  out += ",\"subtitle\":";
  io::append_string(out, "A: " + side(a) + "; B: " + side(b) + "; " + differ_text(asked));
  out += ",\"warnings\":[";
  for (const std::string& warning : asked.warnings) {
    if (out.back() != '[') out += ',';
    io::append_string(out, warning);
  }
  out += ']';
  out += fmt::format(",\"step\":{:g},\"v\":[", kDrawn_kmh);
  for (std::size_t i = 0; i < speeds.size(); ++i) out += fmt::format("{}{:g}", i == 0 ? "" : ",", speeds[i]);
  out += "],\"scalars\":[";
  for (const auto& s : scalar_columns()) {
    if (!(c.a.*s.value) && !(c.b.*s.value)) continue;
    out += fmt::format("{}{{\"name\":\"{}\",\"a\":", out.back() == '[' ? "" : ",", s.name);
    append_rounded(out, c.a.*s.value);
    out += ",\"b\":";
    append_rounded(out, c.b.*s.value);
    out += '}';
  }
  out += "],\"curves\":[";
  for (const Shown& s : kShown) {
    if (!exists(c.rows_a, s.value) && !exists(c.rows_b, s.value)) continue;
    out += fmt::format("{}{{\"key\":\"{}\",\"colour\":\"{}\",\"width\":{:g}", out.back() == '[' ? "" : ",", s.key,
                       s.colour, s.width);
    append_rows(out, "a", c.rows_a, s.value);
    append_rows(out, "b", c.rows_b, s.value);
    out += '}';
  }
  return out + "]}";
}

}  // namespace

std::string comparison_html(const Approached& a, std::span<const Approached> others) {
  std::string data = "[";
  for (const Approached& b : others) data += (data.size() > 1 ? "," : "") + io::json_in_script(data_of(a, b));
  data += ']';
  std::string page = compare_page_template;
  const std::string slot = "/*DATA*/null";
  page.replace(page.find(slot), slot.size(), data);
  return page;
}

}  // namespace evc::curves
