#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

// Tables of a result as data: names, units and values, for every format of the output.
namespace evc::curves {

/// A number that may not exist, or a text.
using Cell = std::variant<std::optional<double>, std::string>;

struct TableColumn {
  std::string name;
  const char* unit = "";  ///< empty: none
  int digits = 1;         ///< decimals in tables to be read
};
struct ResultTable {
  std::string key, title;
  std::vector<TableColumn> columns;
  std::vector<std::vector<Cell>> rows;
};

/// `,"key": [{...}, ...]`.
void append_json(std::string& out, const ResultTable& table);
/// Names and rows after an empty line.
void append_csv(std::string& out, const ResultTable& table);
/// The title and right-aligned columns.
void append_text(std::string& out, const ResultTable& table);

}  // namespace evc::curves
