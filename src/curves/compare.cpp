#include "curves/compare.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/number.h"

namespace evc::curves {
namespace {

Value minus(const Value& b, const Value& a) { return a && b ? Value(*b - *a) : std::nullopt; }

void append_strings(std::string& out, const char* key, const std::vector<std::string>& list) {
  out += fmt::format(",\n  \"{}\": [", key);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) out += ", ";
    io::append_string(out, list[i]);
  }
  out += ']';
}

std::string as_json(const Comparison& c) {
  std::string out = "{\n  \"schema\": \"evc-curves-comparison/1\",\n  \"a\": ";
  io::append_string(out, c.name_a);
  out += ",\n  \"b\": ";
  io::append_string(out, c.name_b);
  append_strings(out, "differ", c.differ);
  append_strings(out, "warnings", c.warnings);
  out += ",\n  \"scalars\": {";
  for (const auto& s : scalar_columns()) {
    if (out.back() != '{') out += ",";
    out += fmt::format("\n    \"{}\": {{\"a\": {}, \"b\": {}, \"difference\": {}}}", s.name,
                       shortest(c.a.*s.value, "null"), shortest(c.b.*s.value, "null"),
                       shortest(minus(c.b.*s.value, c.a.*s.value), "null"));
  }
  out += "\n  },\n  \"by_speed\": [";
  for (std::size_t i = 0; i < c.difference.size(); ++i) {
    out += fmt::format("{}    {{\"v_kmh\": {}", i == 0 ? "\n" : ",\n", shortest(c.difference[i].v_kmh, "null"));
    for (const auto& curve : curve_columns())
      out += fmt::format(", \"{}\": {}", curve.name, shortest(c.difference[i].*curve.value, "null"));
    out += "}";
  }
  return out + (c.difference.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

std::string as_csv(const Comparison& c) {
  std::string out = "v_kmh";
  for (const auto& curve : curve_columns()) out += fmt::format(",{0}_a,{0}_b,{0}_difference", curve.name);
  out += '\n';
  for (std::size_t i = 0; i < c.difference.size(); ++i) {
    out += shortest(c.difference[i].v_kmh, "");
    for (const auto& curve : curve_columns())
      for (const SpeedRow* row : {&c.rows_a[i], &c.rows_b[i], &c.difference[i]})
        out += "," + shortest(row->*curve.value, "");
    out += '\n';
  }
  return out;
}

std::string as_table(const Comparison& c) {
  std::string out = fmt::format("A  {}\nB  {}\n{}\n", io::printable(c.name_a), io::printable(c.name_b), differ_text(c));
  for (const std::string& warning : c.warnings) out += "warning: " + warning + "\n";
  out += '\n';
  TextTable scalars({"", "A", "B", "B - A"});
  for (const auto& s : scalar_columns())
    if (c.a.*s.value || c.b.*s.value)
      scalars.add(
          {s.name, fixed(c.a.*s.value, 2), fixed(c.b.*s.value, 2), fixed(minus(c.b.*s.value, c.a.*s.value), 2)});
  out += scalars.text() + "\nB - A in metres before the target: positive where B has to brake earlier\n";
  std::vector<std::string> names{"km/h"};
  std::vector<Column<SpeedRow>> used;
  for (const auto& curve : curve_columns())
    if (std::any_of(c.difference.begin(), c.difference.end(),
                    [&](const SpeedRow& row) { return (row.*curve.value).has_value(); })) {
      used.push_back(curve);
      names.emplace_back(curve.name);
    }
  TextTable table(names);
  for (const SpeedRow& row : c.difference) {
    std::vector<std::string> cells{shortest(row.v_kmh, "-")};
    for (const auto& curve : used) cells.push_back(fixed(row.*curve.value, 1));
    table.add(cells);
  }
  return out + table.text();
}

}  // namespace

std::string differ_text(const Comparison& c) {
  if (c.differ.empty()) return "they do not differ";
  std::string out = "they differ in: ";
  for (std::size_t i = 0; i < c.differ.size(); ++i) out += (i == 0 ? "" : ", ") + c.differ[i];
  return out;
}

Comparison compare_curves(const Approached& a, const Approached& b) {
  std::vector<double> speeds = a.input().speeds_kmh;
  speeds.insert(speeds.end(), b.input().speeds_kmh.begin(), b.input().speeds_kmh.end());
  std::sort(speeds.begin(), speeds.end());
  speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
  return compare_curves(a, b, speeds);
}

std::vector<double> drawn_speeds(const Comparison& c) {
  double top = 1.0;
  for (const SpeedRow& row : c.difference) top = std::max(top, row.v_kmh);
  std::vector<double> speeds;
  for (double v = 0.0; v < top + 1.0; v += 1.0) speeds.push_back(v);
  return speeds;
}

Comparison compare_curves(const Approached& a, const Approached& b, const std::vector<double>& speeds_kmh) {
  Comparison c;
  c.name_a = a.input().name;
  c.name_b = b.input().name;
  c.a = scalars_of(a);
  c.b = scalars_of(b);
  for (const double v : speeds_kmh) {
    c.rows_a.push_back(speed_row(a, v));
    c.rows_b.push_back(speed_row(b, v));
    SpeedRow difference;
    difference.v_kmh = v;
    for (const auto& curve : curve_columns())
      difference.*curve.value = minus(c.rows_b.back().*curve.value, c.rows_a.back().*curve.value);
    c.difference.push_back(difference);
  }
  compare_inputs(c, a, b);
  return c;
}

std::string comparison_text(const Comparison& comparison, Format format) {
  if (format == Format::csv) return as_csv(comparison);
  return format == Format::table ? as_table(comparison) : as_json(comparison);
}

}  // namespace evc::curves
