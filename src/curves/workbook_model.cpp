#include "curves/workbook_model.h"

#include <algorithm>
#include <cmath>

namespace evc::curves {

const char* const kWorkbookColumnNames[kWorkbookColumns] = {
    "distance", "position", "Vc_EBD", "Vc_prime", "Asafe", "MRSP", "is_DP_OL", "dV", "MRSP_plus_dV", "VT",
    "XT",       "TSM",      "DT",     "DX",       "DV",    "b",    "c",        "D",  "V0_EBI",       "Vbec"};

double column(const WorkbookRow& r, std::size_t i) {
  const double columns[kWorkbookColumns] = {
      r.distance, r.position, r.Vc_EBD, r.Vc_prime, r.Asafe, r.MRSP, r.is_DP_OL, r.dV, r.MRSP_plus_dV, r.VT,
      r.XT,       r.TSM,      r.DT,     r.DX,       r.DV,    r.b,    r.c,        r.D,  r.V0_EBI,       r.Vbec};
  EVC_REQUIRE(i < kWorkbookColumns);
  return columns[i];
}

WorkbookRow workbook_row(const io::WorkbookInputs& in, std::size_t i, const WorkbookRow* before) {
  EVC_REQUIRE((i == 0) == (before == nullptr));
  const double quantum = in.quantum.si;
  const double E = in.A_safe.si;
  const double M = in.DT.si;
  const double N = in.DX.si;
  const double O = in.DV.si;
  WorkbookRow r{};
  r.position = static_cast<double>(i) * quantum;
  r.distance = in.length.si - r.position;
  r.Asafe = E;
  r.MRSP = in.mrsp.at(Distance{r.distance}).si;
  r.is_DP_OL = i == 0 && in.danger_point_in_first_row ? 1.0 : 0.0;
  r.dV = in.dV.si;
  r.MRSP_plus_dV = r.dV + r.MRSP;
  r.DT = M;
  r.DX = N;
  r.DV = O;
  const double I = r.MRSP_plus_dV;
  if (before == nullptr) {
    r.Vc_EBD = r.Vc_prime = r.VT = r.MRSP;
  } else {
    const WorkbookRow& u = *before;
    r.Vc_EBD = std::min(std::sqrt(u.Vc_EBD * u.Vc_EBD + 2.0 * quantum * u.Asafe), I);
    r.Vc_prime =
        u.V0_EBI < u.MRSP_plus_dV ? std::sqrt(u.Vc_prime * u.Vc_prime + 2.0 * quantum * u.Asafe) : u.MRSP_plus_dV;
    // A rise of the speed, in the direction away from the target, is a target: the lower speed at
    // its end.
    r.VT = r.MRSP > u.MRSP ? u.MRSP : u.VT;
    r.XT = i == 1 ? 0.0 : r.MRSP > u.MRSP ? r.position : u.XT;
  }
  r.TSM = r.Vc_EBD < I ? 1.0 : 0.0;
  r.b = 2.0 * (O + E * M);
  const double ahead = r.position - r.XT;
  // The first two rows have the opposite sign; the ceiling hides it.
  r.c = O * O + 2.0 * E * (i < 2 ? N + ahead : N - ahead) - r.VT * r.VT;
  r.D = std::max(r.b * r.b - 4.0 * r.c, 0.0);
  const double root = std::sqrt(r.D) / 2.0 - O - E * M;
  const double held = before == nullptr ? root : std::max(root, before->V0_EBI);
  // (G = 1) ^ (F <> 0) with the power operator of the sheet: true where G = 1, or where F = 0.
  const bool ceiling_only = i < 2 && (r.is_DP_OL == 1.0 || r.MRSP == 0.0);
  r.V0_EBI = ceiling_only ? I : std::min(held, I);
  r.Vbec = r.V0_EBI + O;
  return r;
}

std::size_t workbook_rows(const io::WorkbookInputs& in) {
  return static_cast<std::size_t>(in.length.si / in.quantum.si + 1e-9) + 1;
}

}  // namespace evc::curves
