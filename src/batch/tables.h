#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "batch/limits.h"

// What the kernels read: one array of numbers for all trains. A place in it is an index; indices in it are kept as the
// bits of a number.
namespace evc::batch {

inline double as_number(std::int64_t index) { return std::bit_cast<double>(index); }
inline std::int64_t as_index(double number) { return std::bit_cast<std::int64_t>(number); }

/// The values of a train and a class of its targets, from the index of both on. A train has them four times: for
/// V_target = 0 and V_target > 0, and both again for targets due to a TSR.
enum TrainValue : std::int64_t {
  kVDelta0,
  kTopSquared,  // of V_top
  kTWarning,
  kTDriver,
  kCapPAtTarget,  // where d_P is not beyond the target: 1 when it is drawn (3.4.0), 2 in itself (4.0.0), 0 nowhere
  kGuided,        // 1 where there is a guidance curve
  kLookedUp,      // 1 where there are look-up tables
  kStrideEBD,     // bits: from a segment's cells to those of the next one
  kStrideSBD,
  kStrideGUI,
  kFirstSegment,  // bits: its index
  kSegments,      // bits: their number
  // The times and what follows from them.
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
  kTrainValues,
};
/// What is added to a train's index.
constexpr std::int64_t class_of_targets(bool above_zero, bool due_to_TSR) {
  return ((above_zero ? 1 : 0) + (due_to_TSR ? 2 : 0)) * std::int64_t{kTrainValues};
}

/// One segment: where it begins, and its first cells (bits).
enum SegmentValue : std::int64_t { kFrom, kCellEBD, kCellSBD, kCellGUI, kSegmentValues };
/// One cell of constant deceleration: a speed band of a segment. Those of a segment follow one another as the bands do,
/// the segments as on the track. Before those of the first segment, which begins at -1e9 m (src/sdm), is a row with the
/// same decelerations and no border: what is upstream of it is nowhere. Behind those of the last segment is a row that
/// is never reached.
enum CellValue : std::int64_t {
  kTwiceA,  // twice the deceleration, as the arcs need it; a factor of 2 changes no bit of what is computed
  kUpto,    // the square of the band's upper speed
  kBegin,   // of the segment
  kAbove,   // the square of the band's lower speed; of the lowest band minus infinity
  kCellValues
};

/// The same of one kind of curve in the form of two tables, if they suffice: those of the segments, from the one before
/// the first on, and those of the bands. The deceleration is the sum of both. The three of a list of segments, in the
/// order of SegmentValue, are just before it.
inline constexpr std::int64_t kLookUpBands = 8;
inline constexpr std::int64_t kLookUpSegments = 32;
enum LookUpValue : std::int64_t {
  kLookUpUpto,
  kLookUpTwiceA = kLookUpUpto + kLookUpBands,  // of the brakes
  kLookUpBegin = kLookUpTwiceA + kLookUpBands,
  kLookUpTwiceGradient = kLookUpBegin + kLookUpSegments,  // twice the deceleration due to gradient
  kLookUpValues = kLookUpTwiceGradient + kLookUpSegments
};

inline constexpr double kNowhere = 1e9;  // as in src/sdm: beyond every track

/// A curve from its foot to the anchor has at most this many arcs (src/sdm).
inline constexpr std::size_t kMostArcsDownstream = 31;

/// The inputs of a train whose limits `sdm::explain` may have to compute.
struct Whole {
  sdm::Inputs in;
  State state;
};

struct TrainEntry {
  std::int64_t values = 0;  // their index
  bool vectorised = false;
  bool guidance = false;
  bool Q_NVINHSMICPERM = false;
  train::FixedValues fixed;
  /// No build-up time is reduced (A.3.12 of 4.0.0) at speeds above the target speed by more than this many m/s: of a
  /// stop, and of other targets.
  std::array<double, 2> full_above{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  std::unique_ptr<const Whole> whole;  // absent where the kernels always suffice
};

struct Trains::Tables {
  std::vector<double> numbers;
  std::vector<TrainEntry> trains;
  std::size_t most_segments = 1;                                             // of all vectorised trains
  std::unique_ptr<sdm::Derived> scratch = std::make_unique<sdm::Derived>();  // of the train that is added
};

}  // namespace evc::batch
