#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/location.h"
#include "base/units.h"
#include "kernel/state.h"

// The track ahead as a matrix: a row for each quantum of distance. The unit stores exact profiles
// (docs/decisions/0003-exact-profiles-instead-of-a-turning-buffer.md); this is a view of them.
namespace evc::matrix {

inline constexpr std::size_t kMostRows = 400;
/// Speed steps of the brakes that a row has a column for.
inline constexpr std::size_t kSteps = 4;

/// The quantum for a target distance: 50 m beyond 2000 m, 5 m beyond 200 m, else 0.5 m.
constexpr Distance quantum_for(Distance target) {
  return target > Distance{2000.0} ? Distance{50.0} : target > Distance{200.0} ? Distance{5.0} : Distance{0.5};
}

/// One quantum, [from, to). Every value is the most restrictive one in it, so that no profile and no curve computed
/// from the rows is above the exact one.
struct Row {
  Place from{}, to{};
  std::optional<GroupId> group;  ///< the LRBG in the first row; in others the group that linking announces there
  std::optional<Speed> SSP;      ///< of this train, without delay for its length
  std::optional<bool> QF;        ///< Q_FRONT of that element: no delay
  double Grd = 0.0;              ///< per mille, the lowest under a train with its front end here (3.13.4.2)
  std::optional<Speed> ASP;      ///< of this train
  std::optional<Speed> V_LOA;    ///< in the row of the EOA (0) or LOA
  std::optional<Speed> TSR;
  bool Adh = false;                          ///< adhesion is reduced
  std::array<Acceleration, kSteps> Aeb{};    ///< of the emergency brake by speed step, without the gradient
  Speed MRSP{};                              ///< 3.13.7
  std::array<Acceleration, kSteps> Asafe{};  ///< A_safe by speed step (3.13.6.2)
};

struct Matrix {
  Place front{};                ///< estimated front end, where the first row begins
  std::optional<Place> target;  ///< EOA or LOA; without one the last row ends where the static speed profile ends
  Distance quantum{};
  bool cut = false;  ///< the target is beyond the last row: there would be more than kMostRows
  /// Upper limits of the first three speed steps; absent: infinite, the steps above are empty and have the same values.
  std::array<std::optional<Speed>, kSteps - 1> steps{};
  std::vector<Row> rows;  ///< none where nothing is stored, or no speed is supervised
};

/// `quantum` absent: by the target distance. `derived` belongs to `state`, after a cycle.
Matrix matrix_of(const kernel::State& state, const kernel::Derived& derived, std::optional<Distance> quantum = {});

}  // namespace evc::matrix
