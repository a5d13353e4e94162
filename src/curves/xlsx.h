#pragma once
#include <string>
#include <vector>

#include "curves/tables.h"

namespace evc::curves {

/// The tables as an Office Open XML workbook: a sheet for each, its first row has the names with their units; beside
/// those by speed and by position a chart of speed over distance. Throws std::runtime_error where it cannot be made (no
/// memory, no room for temporary files).
std::string xlsx_of(const std::vector<ResultTable>& tables);

}  // namespace evc::curves
