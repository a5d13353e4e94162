#pragma once
#include <string>
#include <vector>

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
std::string workbook_svg(const Workbook& workbook, const Approached& approached);

}  // namespace evc::curves
