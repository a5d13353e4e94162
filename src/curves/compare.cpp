#include "curves/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

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

std::string members_of(const Comparison& c) {
  std::string out = "  \"a\": ";
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
  return out + (c.difference.empty() ? "]\n}" : "\n  ]\n}");
}

std::string as_json(const Comparison& c) {
  return "{\n  \"schema\": \"evc-curves-comparison/1\",\n" + members_of(c) + "\n";
}

std::string lower(std::size_t input) {
  std::string letter = input_letter(input);
  for (char& c : letter)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return letter;
}

/// v_kmh, then of every curve the value of A and of each other input its value and its difference.
ResultTable by_speed(const std::vector<Comparison>& all) {
  ResultTable table{"by_speed", "by_speed", {{"v_kmh", "km/h"}}, {}};
  for (const auto& curve : curve_columns()) {
    table.columns.push_back({curve.name + std::string("_a"), "m"});
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::string own = curve.name + ("_" + lower(k + 1));
      table.columns.push_back({own, "m"});
      table.columns.push_back({all.size() == 1 ? curve.name + std::string("_difference") : own + "_difference", "m"});
    }
  }
  for (std::size_t i = 0; i < all[0].difference.size(); ++i) {
    std::vector<Cell> cells{Value(all[0].difference[i].v_kmh)};
    for (const auto& curve : curve_columns()) {
      cells.emplace_back(all[0].rows_a[i].*curve.value);
      for (const Comparison& c : all) {
        cells.emplace_back(c.rows_b[i].*curve.value);
        cells.emplace_back(c.difference[i].*curve.value);
      }
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// `letter`: of the other input.
std::string as_table(const Comparison& c, const std::string& letter) {
  std::string out =
      fmt::format("A  {}\n{}  {}\n{}\n", io::printable(c.name_a), letter, io::printable(c.name_b), differ_text(c));
  for (const std::string& warning : c.warnings) out += "warning: " + warning + "\n";
  out += '\n';
  TextTable scalars({"", "A", letter, letter + " - A"});
  for (const auto& s : scalar_columns())
    if (c.a.*s.value || c.b.*s.value)
      scalars.add(
          {s.name, fixed(c.a.*s.value, 2), fixed(c.b.*s.value, 2), fixed(minus(c.b.*s.value, c.a.*s.value), 2)});
  out += scalars.text() +
         fmt::format("\n{0} - A in metres before the target: positive where {0} has to brake earlier\n", letter);
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

namespace {

/// Every speed of the inputs once, in order.
std::vector<double> all_speeds(std::initializer_list<const std::vector<double>*> lists) {
  std::vector<double> speeds;
  for (const auto* list : lists) speeds.insert(speeds.end(), list->begin(), list->end());
  std::sort(speeds.begin(), speeds.end());
  speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
  return speeds;
}

}  // namespace

Comparison compare_curves(const Approached& a, const Approached& b) {
  return compare_curves(a, b, all_speeds({&a.input().speeds_kmh, &b.input().speeds_kmh}));
}

std::vector<Comparison> compare_all(const std::vector<Approached>& inputs) {
  std::vector<double> speeds;
  for (const Approached& input : inputs) speeds = all_speeds({&speeds, &input.input().speeds_kmh});
  return compare_all(inputs, speeds);
}

std::vector<Comparison> compare_all(const std::vector<Approached>& inputs, const std::vector<double>& speeds_kmh) {
  std::vector<Comparison> all;
  for (std::size_t i = 1; i < inputs.size(); ++i) {
    all.push_back(compare_curves(inputs[0], inputs[i], speeds_kmh));
    // Warnings call the other input B: "A 7000 m, B 8000 m".
    for (std::string& warning : all.back().warnings)
      if (const std::size_t at = warning.find(", B "); at != std::string::npos)
        warning.replace(at + 2, 1, input_letter(i));
  }
  return all;
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

std::string input_letter(std::size_t input) {
  return input < 26 ? std::string(1, static_cast<char>('A' + input)) : std::to_string(input + 1);
}

std::vector<ResultTable> tables_of(const std::vector<Comparison>& all) {
  ResultTable scalars{"scalars", "scalars", {{"name"}, {"A"}}, {}};
  ResultTable inputs{
      "inputs", "inputs", {{"input"}, {"name"}, {"differ"}, {"warnings"}}, {{"A", all[0].name_a, "", ""}}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string letter = input_letter(k + 1);
    scalars.columns.push_back({letter});
    scalars.columns.push_back({letter + " - A"});
    std::string warnings;
    for (const std::string& warning : all[k].warnings) warnings += (warnings.empty() ? "" : "; ") + warning;
    inputs.rows.push_back({letter, all[k].name_b, differ_text(all[k]), warnings});
  }
  for (const auto& s : scalar_columns()) {
    std::vector<Cell> cells{std::string(s.name), all[0].a.*s.value};
    for (const Comparison& c : all) {
      cells.emplace_back(c.b.*s.value);
      cells.emplace_back(minus(c.b.*s.value, c.a.*s.value));
    }
    scalars.rows.push_back(std::move(cells));
  }
  return {std::move(inputs), std::move(scalars), by_speed(all)};
}

std::string comparisons_text(const std::vector<Comparison>& all, Format format) {
  std::string out;
  if (format == Format::csv) {
    append_csv(out, by_speed(all));
    return out;
  }
  if (all.size() == 1) return comparison_text(all[0], format);
  if (format == Format::table) {
    for (std::size_t k = 0; k < all.size(); ++k) out += (k == 0 ? "" : "\n") + as_table(all[k], input_letter(k + 1));
    return out;
  }
  out = "{\n\"schema\": \"evc-curves-comparisons/1\",\n\"comparisons\": [";
  for (std::size_t k = 0; k < all.size(); ++k) out += (k == 0 ? "\n{\n" : ",\n{\n") + members_of(all[k]);
  return out + "\n]\n}\n";
}

std::string comparison_text(const Comparison& comparison, Format format) {
  if (format == Format::csv) return comparisons_text({comparison}, format);
  return format == Format::table ? as_table(comparison, "B") : as_json(comparison);
}

}  // namespace evc::curves
