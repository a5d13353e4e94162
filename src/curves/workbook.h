#pragma once
#include <string>
#include <vector>

#include "curves/drawing.h"
#include "curves/result.h"
#include "curves/workbook_model.h"

namespace evc::curves {

/// The workbook model, row by row, with the values of the standard at the same places.
struct Workbook {
  std::string name;
  io::WorkbookInputs inputs;
  std::vector<WorkbookRow> rows;
  std::vector<double> SRS_EBD, SRS_EBI;  // m/s, by row
};
/// Constants that are not in the input are computed from its train: DT = T_traction + T_berem, DV and DX from its
/// acceleration, A_safe at its highest speed.
Workbook workbook_of(const Approached& approached);
/// `evc-workbook-result/1`: the sheet's columns; CSV and table.
std::string workbook_text(const Workbook& workbook, Format format);
/// One table with the columns of the sheet and those of the standard.
ResultTable table_of(const Workbook& workbook);
Drawing workbook_drawing(const Workbook& workbook, const Approached& approached, Theme theme);

}  // namespace evc::curves
