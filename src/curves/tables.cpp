#include "curves/tables.h"

#include <fmt/format.h>

#include "curves/result.h"
#include "io/number.h"

namespace evc::curves {
namespace {

std::string as_json(const Cell& cell) {
  if (const auto* number = std::get_if<Value>(&cell)) return shortest(*number, "null");
  std::string out;
  io::append_string(out, std::get<std::string>(cell));
  return out;
}
std::string as_csv(const Cell& cell) {
  const auto* number = std::get_if<Value>(&cell);
  return number != nullptr ? shortest(*number, "") : std::get<std::string>(cell);
}
std::string as_text(const Cell& cell, int digits) {
  const auto* number = std::get_if<Value>(&cell);
  return number != nullptr ? fixed(*number, digits) : std::get<std::string>(cell);
}

}  // namespace

void append_json(std::string& out, const ResultTable& table) {
  out += fmt::format(",\n  \"{}\": [", table.key);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    out += i == 0 ? "\n    {" : ",\n    {";
    for (std::size_t k = 0; k < table.columns.size(); ++k)
      out += fmt::format("{}\"{}\": {}", k == 0 ? "" : ", ", table.columns[k].name, as_json(table.rows[i][k]));
    out += '}';
  }
  out += table.rows.empty() ? "]" : "\n  ]";
}

void append_csv(std::string& out, const ResultTable& table) {
  if (!out.empty()) out += '\n';
  for (std::size_t k = 0; k < table.columns.size(); ++k) out += (k == 0 ? "" : ",") + table.columns[k].name;
  out += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t k = 0; k < row.size(); ++k) out += (k == 0 ? "" : ",") + as_csv(row[k]);
    out += '\n';
  }
}

void append_text(std::string& out, const ResultTable& table) {
  std::vector<std::string> names;
  for (const TableColumn& column : table.columns) names.push_back(column.name);
  TextTable text(names);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t k = 0; k < row.size(); ++k) cells.push_back(as_text(row[k], table.columns[k].digits));
    text.add(cells);
  }
  out += fmt::format("\n{}\n{}", table.title, text.text());
}

}  // namespace evc::curves
