#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "batch/limits.h"

// What the kernels read: one array of numbers for all trains. A place in it is an index; indices in it are kept as the
// bits of a number.
namespace evc::batch {

inline double as_number(std::int64_t index) { return std::bit_cast<double>(index); }
inline std::int64_t as_index(double number) { return std::bit_cast<std::int64_t>(number); }

/// The values of a train that no target changes, from the train's index on.
enum TrainValue : std::int64_t {
  kVDelta0,
  kTopSquared,  // of V_top
  kTWarning,
  kTDriver,
  kCapPAtTarget,  // 1 where d_P is drawn not beyond the target (3.4.0)
  kStrideEBD,     // bits: from a segment's cells to those of the next one
  kStrideSBD,
  kStrideGUI,
  kTimesZero,  // the times for V_target = 0
};
/// The times of one class of targets and what follows from them, from `kTimesZero` on, and behind them those for
/// V_target > 0.
enum TimesValue : std::int64_t {
  kTTraction,
  kTBerem,
  kTBs1,
  kTBs2,
  kTIndication,
  kVDelta1,
  kHalfVDelta1,
  kVDelta2,
  kHalfVDelta2,
  kTBeFoot,  // T_berem + T_traction of d_P(V_target)
  kTPFoot,   // T_driver + T_bs2 of it
  kTimesValues,
};
inline constexpr std::int64_t kTrainValues = std::int64_t{kTimesZero} + 2 * kTimesValues;

/// One segment: where it begins, and its first cells (bits).
enum SegmentValue : std::int64_t { kFrom, kCellEBD, kCellSBD, kCellGUI, kSegmentValues };
/// One cell of constant deceleration: a speed band of a segment. Those of a segment follow one another as the bands do,
/// the segments as on the track; a row of cells that is never reached is behind them.
enum CellValue : std::int64_t {
  kA,      // deceleration
  kUpto,   // the square of the band's upper speed
  kBegin,  // of the segment
  kAbove,  // the square of the band's lower speed; of the lowest band minus infinity
  kCellValues
};

inline constexpr double kNowhere = 1e9;      // as in src/sdm: beyond every track
inline constexpr double kNotAllowed = -1e9;  // the place of a speed that is allowed nowhere

/// A curve from its foot to the anchor has at most this many arcs (src/sdm).
inline constexpr std::size_t kMostArcsDownstream = 31;

/// The inputs of a train whose limits `sdm::explain` may have to compute.
struct Whole {
  sdm::Inputs in;
  State state;
};

struct TrainEntry {
  std::int64_t values = 0;                // its index
  std::int64_t segments = 0, TSR = 0;     // of the first segment; for targets due to a TSR
  std::int64_t count = 0, count_TSR = 0;  // segments
  bool vectorised = false;
  bool guidance = false;
  bool Q_NVINHSMICPERM = false;
  train::FixedValues fixed;
  std::unique_ptr<const Whole> whole;  // absent where the kernels always suffice
};

struct Trains::Tables {
  std::vector<double> numbers;
  std::vector<TrainEntry> trains;
  std::unique_ptr<sdm::Decelerations> scratch = std::make_unique<sdm::Decelerations>();
};

}  // namespace evc::batch
