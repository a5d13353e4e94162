#include "curves/xlsx.h"

#include <sys/mman.h>
#include <unistd.h>
#include <xlsxwriter.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <system_error>

// libxlsxwriter writes to a name: that of a file in memory, so that the result gets its name as all files do.
namespace evc::curves {
namespace {

constexpr std::size_t kLongestSheetName = 31;  // of the format
constexpr double kWidth = 13.0;                // of a column, in characters
constexpr time_t kCreated = 946684800;         // 2000-01-01: the same tables are the same file

class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("xlsx", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string name() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
  std::string bytes() const {
    std::string all;
    std::array<char, 65536> some{};
    for (;;) {
      const ssize_t count = pread(descriptor_, some.data(), some.size(), static_cast<off_t>(all.size()));
      if (count < 0) throw std::system_error(errno, std::generic_category(), "pread");
      if (count == 0) return all;
      all.append(some.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  int descriptor_;
};

void require(lxw_error error) {
  if (error != LXW_NO_ERROR) throw std::runtime_error(lxw_strerror(error));
}

/// Cells of a column without its head, as a formula has them.
std::string range_of(const std::string& sheet, const ResultTable& table, lxw_col_t column) {
  std::array<char, LXW_MAX_CELL_RANGE_LENGTH> cells{};
  lxw_rowcol_to_range_abs(cells.data(), 1, column, static_cast<lxw_row_t>(table.rows.size()), column);
  return "='" + sheet + "'!" + cells.data();
}

bool is_empty(const ResultTable& table, std::size_t column) {
  return std::ranges::none_of(table.rows, [&](const auto& row) {
    const auto* number = std::get_if<std::optional<double>>(&row[column]);
    return number != nullptr && *number && std::isfinite(**number);
  });
}

/// Speed over distance, a line for each curve, beside a table of distances by speed or of speeds by place. Other tables
/// have no chart.
void add_chart(lxw_workbook* book, lxw_worksheet* sheet, const std::string& name, const ResultTable& table) {
  const bool by_speed = table.key == "by_speed", by_position = table.key == "by_position";
  if (!by_speed && !by_position) return;
  std::vector<lxw_col_t> curves;
  for (std::size_t k = 1; k < table.columns.size(); ++k)
    if (std::string_view(table.columns[k].unit) == (by_speed ? "m" : "km/h") && !is_empty(table, k))
      curves.push_back(static_cast<lxw_col_t>(k));
  if (curves.empty()) return;  // a chart without a curve is refused
  lxw_chart* chart = workbook_add_chart(book, LXW_CHART_SCATTER_STRAIGHT);
  if (chart == nullptr) throw std::runtime_error("no chart of " + name);
  const std::string first = range_of(name, table, 0);
  for (const lxw_col_t k : curves) {
    const std::string values = range_of(name, table, k);
    lxw_chart_series* series =
        chart_add_series(chart, (by_speed ? values : first).c_str(), (by_speed ? first : values).c_str());
    if (series == nullptr) throw std::runtime_error("no chart of " + name);
    chart_series_set_name(series, table.columns[k].name.c_str());
  }
  chart_title_set_name(chart, by_speed ? "Curves and limits by speed" : "Speeds by position");
  chart_axis_set_name(chart->x_axis, by_speed ? "metres before the target" : "position [m]");
  chart_axis_set_name(chart->y_axis, "km/h");
  // From left to right as the train runs.
  if (by_speed) {
    chart_axis_set_reverse(chart->x_axis);
    chart_axis_set_crossing_max(chart->x_axis);
  }
  lxw_chart_options place{};
  place.x_scale = 2.0;
  place.y_scale = 2.0;
  require(worksheet_insert_chart_opt(sheet, 1, static_cast<lxw_col_t>(table.columns.size() + 1), chart, &place));
}

void add_sheet(lxw_workbook* book, const ResultTable& table, lxw_format* bold) {
  const std::string name = table.key.substr(0, kLongestSheetName);
  lxw_worksheet* sheet = workbook_add_worksheet(book, name.c_str());
  if (sheet == nullptr) throw std::runtime_error("no sheet " + name);
  const auto columns = static_cast<lxw_col_t>(table.columns.size());
  for (lxw_col_t k = 0; k < columns; ++k) {
    const TableColumn& column = table.columns[k];
    const std::string head = column.name + (*column.unit == '\0' ? "" : std::string(" [") + column.unit + "]");
    require(worksheet_write_string(sheet, 0, k, head.c_str(), bold));
  }
  if (columns > 0) require(worksheet_set_column(sheet, 0, static_cast<lxw_col_t>(columns - 1), kWidth, nullptr));
  worksheet_freeze_panes(sheet, 1, 0);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto row = static_cast<lxw_row_t>(i + 1);
    for (lxw_col_t k = 0; k < columns; ++k) {
      const Cell& cell = table.rows[i][k];
      if (const auto* text = std::get_if<std::string>(&cell)) {
        require(worksheet_write_string(sheet, row, k, text->c_str(), nullptr));
      } else if (const auto& number = std::get<std::optional<double>>(cell); number && std::isfinite(*number)) {
        require(worksheet_write_number(sheet, row, k, *number, nullptr));
      }
    }
  }
  add_chart(book, sheet, name, table);
}

}  // namespace

std::string xlsx_of(const std::vector<ResultTable>& tables) {
  const MemoryFile file;
  lxw_workbook* book = workbook_new(file.name().c_str());
  if (book == nullptr) throw std::runtime_error("no memory for a workbook");
  lxw_doc_properties properties{};
  properties.created = kCreated;
  try {
    require(workbook_set_properties(book, &properties));
    lxw_format* bold = workbook_add_format(book);
    format_set_bold(bold);
    for (const ResultTable& table : tables) add_sheet(book, table, bold);
  } catch (...) {
    (void)workbook_close(book);  // frees it
    throw;
  }
  require(workbook_close(book));
  return file.bytes();
}

}  // namespace evc::curves
