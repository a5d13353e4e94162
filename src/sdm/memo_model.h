#pragma once
#include <cstddef>
#include <cstdint>

#include "base/inplace_vector.h"
#include "base/step_function.h"
#include "base/units.h"

// The workbook model of the emergency brake intervention, "V0 = f(X0)": from the train's place
// X0 to the speed V0 at which braking must be commanded so that the train reaches the target {X1, V1}.
// It is what 3.13.9.3.2 solves as a curve; here a second-degree equation with one A_safe on the way.
namespace evc::sdm {

/// What happens between the command and the full effort: time, distance beyond V0 * DT, and speed.
struct MemoLoss {
  Duration DT;
  Distance DX;
  Speed DV;
};
/// Two times with constant accelerations: T1 (traction still on) with A_est1, T2 (brake builds up) with
/// A_est2. DT = T1 + T2, DV = A_est1 T1 + A_est2 T2, DX = (A_est1 T1^2 + A_est2 T2^2) / 2 + A_est1 T1 T2.
/// The cross term is in it (the workbook leaves it out, on the unsafe side).
MemoLoss memo_loss(Duration T1, Duration T2, Acceleration A_est1, Acceleration A_est2);

struct MemoTarget {
  Place X1;
  Speed V1;
};

/// The second-degree equation V0^2 + b V0 + c = 0 and its root.
struct MemoSolution {
  Speed b;         // 2 (DV + A_safe DT)
  SpeedSquared c;  // 2 A_safe (DX + X0 - X1) + DV^2 - V1^2
  SpeedSquared D;  // b^2 - 4 c, not below 0
  Speed V0;        // sqrt(D) / 2 - (DV + A_safe DT), not below 0
};
/// V0 = f(X0). `A_safe` > 0.
MemoSolution memo_V0(Place X0, const MemoTarget& target, Acceleration A_safe, const MemoLoss& loss);
/// The inverse: where V0 is the speed of intervention.
Place memo_X0(Speed V0, const MemoTarget& target, Acceleration A_safe, const MemoLoss& loss);
/// Speed of the braking curve itself: Vc^2 = V1^2 + 2 A_safe (X1 - X0), 0 beyond standstill. With
/// DT = 0 (and so DX = 0, DV = 0) V0 = Vc.
Speed memo_Vc(Place X0, const MemoTarget& target, Acceleration A_safe);

/// The workbook's sheet: a grid of `quantum` from the farthest point (position 0, the target's side)
/// against the running direction to the train.
struct WorkbookInputs {
  Distance quantum{10.0};
  Distance length{700.0};
  Duration DT{5.0};
  Distance DX{5.0};
  Speed DV{1.0};
  Speed dV{1.0};  // the ceiling is MRSP + dV
  Acceleration A_safe{1.2};
  bool danger_point_in_first_row = true;
  /// By distance along the line, in running direction.
  StepFunction<Distance, Speed, 128> mrsp;
};

/// One row with the sheet's columns and names; flags are 0 or 1 as they stand there.
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

/// Row `i` of the sheet; `before`: the row nearer to the target, null for the first. The sheet's own
/// rules are kept: the target anchor V1 = VT, the EBI that never falls away from the target, the sign
/// of c in the first two rows.
WorkbookRow workbook_row(const WorkbookInputs& in, std::size_t i, const WorkbookRow* before);
/// How many rows the sheet has.
std::size_t workbook_rows(const WorkbookInputs& in);

}  // namespace evc::sdm
