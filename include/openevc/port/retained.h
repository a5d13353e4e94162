#pragma once
#include <cstdint>
#include <optional>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/units.h"
#include "openevc/port/outputs.h"
#include "openevc/terms/level.h"
#include "openevc/train/national_values.h"

// What the unit keeps without power. The host takes it when the power goes off, stores it, and gives it to the next
// unit at power-up.
namespace evc::port {

struct RetainedLevel {
  Level level = Level::L0;
  std::uint8_t nid_ntc = 0;  ///< with level NTC
  friend constexpr bool operator==(const RetainedLevel&, const RetainedLevel&) = default;
};

struct Retained {
  /// The countries or regions (NID_C) in which national values are applicable.
  using Areas = InplaceVector<std::uint16_t, 32>;
  /// A virtual balise cover and the rest of its validity period when the power went off (3.15.9.5).
  struct Cover {
    std::uint16_t NID_C = 0;
    std::uint8_t NID_VBCMK = 0;
    Duration left{};
    std::uint8_t T_VBC = 0;  ///< the validity period as it was set, days
    /// When `left` was left, seconds since 1970 (UTC), where the unit knew it: against the first reading of the clock
    /// after power-up it gives the time without power, which counts for the validity period.
    std::optional<std::int64_t> utc = {};
    friend constexpr bool operator==(const Cover&, const Cover&) = default;
  };
  using StoredLevel = RetainedLevel;
  /// A level transition order that waited until SH, PS, PT or RV is left (4.10, 4.11.1.4 of 4.0.0).
  struct LevelOrder {
    bool conditional = false;
    InplaceVector<StoredLevel, 32> table;
    friend constexpr bool operator==(const LevelOrder&, const LevelOrder&) = default;
  };
  /// The LRBG and the front end of cab A against it. Directions are codes of Q_DIRLRBG.
  struct Position {
    NidLrbg lrbg;
    std::uint8_t orientation = 2;       ///< of the train against the group
    bool single = false;                ///< a single balise, which gives no orientation of its own (3.4.2.3)
    std::optional<NidLrbg> previous;    ///< PRVLRBG of such a group
    std::uint8_t pair_orientation = 2;  ///< of the train against the movement from there to this group
    bool counter_rising = true;         ///< the odometer counted up when the group was passed
    bool cab_B = false;                 ///< the cab that was active last: it defines the orientation (3.6.1.5)
    Distance ahead{};                   ///< from the group to the estimated front end
    Distance over{}, under{};           ///< from there to the min safe and to the max safe front end
    Distance Q_LOCACC{};                ///< of the group, part of both
    friend constexpr bool operator==(const Position&, const Position&) = default;
  };

  /// The greatest T_VBC, 255 days, and a distance from the LRBG at which no train is: more is not accepted.
  static constexpr Duration kLongestCover{255.0 * 86400.0};
  static constexpr Distance kFarthest{1e7};
  /// The highest number X of a system version that a unit can operate: one of SRS 4.0.0; one of Baseline 3 operates 2.
  static constexpr std::uint8_t kHighestX = 3;

  // National values in force (3.18.2.7). Values that a set of X = 1 left as they were have areas of their own.
  train::NationalValues national_values;
  Areas national_areas, national_areas_of_X_2, national_areas_of_braking;
  std::uint8_t operated_X = 2;     ///< operated system version, number X (3.17.2.9)
  bool generic_ls_marker = false;  ///< generic LS function marker (4.10)
  InplaceVector<Cover, 16> covers;
  std::optional<std::uint32_t> network;  ///< the last one of trackside or driver, NID_MN (3.5.6.2)
  // Valid again at power-up only where the engine was not moved (4.11). Absent: unknown.
  std::optional<StoredLevel> level;
  InplaceVector<StoredLevel, 32> level_table;  ///< of trackside; empty: none
  std::optional<LevelOrder> level_order;       ///< judged at power-up
  std::optional<RbcAddress> contact;           ///< of the RBC (3.18.4.3.1)
  std::optional<Position> position;
  friend constexpr bool operator==(const Retained&, const Retained&) = default;
};

}  // namespace evc::port
