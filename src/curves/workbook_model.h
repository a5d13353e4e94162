#pragma once
#include <cstddef>

#include "io/workbook_inputs.h"

// The workbook model of the emergency brake intervention, "V0 = f(X0)": from the train's place
// X0 to the speed V0 at which braking must be commanded so that the train reaches the target {X1, V1}.
// 3.13.9.3.2 solves this with a curve; this model with a second-degree equation and one A_safe.
namespace evc::curves {

/// One row with the sheet's columns and names; flags are 0 or 1 as in the sheet.
struct WorkbookRow {
  double distance, position;
  double Vc_EBD, Vc_prime, Asafe, MRSP, is_DP_OL, dV, MRSP_plus_dV;
  double VT, XT, TSM;
  double DT, DX, DV;
  double b, c, D;
  double V0_EBI, Vbec;
};
inline constexpr std::size_t kWorkbookColumns = 20;
/// Names of the columns in the order of the members.
extern const char* const kWorkbookColumnNames[kWorkbookColumns];
/// The value of column `i` in that order.
double column(const WorkbookRow& row, std::size_t i);

/// Row `i` of the sheet; `before`: the row nearer to the target, null for the first. The rules of the sheet are kept:
/// the target anchor V1 = VT, the EBI that never falls in the direction away from the target, the sign of c in the
/// first two rows.
WorkbookRow workbook_row(const io::WorkbookInputs& in, std::size_t i, const WorkbookRow* before);
/// How many rows the sheet has.
std::size_t workbook_rows(const io::WorkbookInputs& in);

}  // namespace evc::curves
