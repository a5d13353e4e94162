#pragma once
#include "base/step_function.h"
#include "base/units.h"

namespace evc::io {

/// The sheet of the workbook model (`evc curves --model workbook`): a grid of `quantum` from the farthest point
/// (position 0, the target's side) against the running direction to the train.
struct WorkbookInputs {
  Distance quantum{10.0};
  Distance length{700.0};
  Duration DT{5.0};
  Distance DX{5.0};
  Speed DV{1.0};
  Speed dV{1.0};  // the ceiling is MRSP + dV
  Acceleration A_safe{1.2};
  bool danger_point_in_first_row = true;
  /// Over the distance along the line, in running direction.
  StepFunction<Distance, Speed, 128> mrsp;
};

}  // namespace evc::io
