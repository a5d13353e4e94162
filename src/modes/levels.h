#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/set.h"
#include "base/units.h"
#include "modes/acceptance.h"
#include "terms/level.h"
#include "terms/mode.h"

namespace evc::modes {

/// One entry of a table of levels (packets 41 and 46): the level, the national system with level NTC, and the length
/// in rear of the border in which the transition may be acknowledged.
struct OrderedLevel {
  Level level = Level::L0;
  std::uint8_t nid_ntc = 0;         // 0 unless level is NTC
  bool ordered_as_level_3 = false;  // 4.0.0: level 2, of an order for level 3
  Distance L_ack{};
  friend constexpr bool operator==(const OrderedLevel&, const OrderedLevel&) = default;
  /// Same level, and in level NTC the same national system.
  constexpr bool same_level(const OrderedLevel& b) const {
    return level == b.level && (level != Level::NTC || nid_ntc == b.nid_ntc);
  }
};

/// 4.0.0 has no level 3: where an older trackside names it, level 2 is meant (6.6.3.2.3 [21], [22], 6.6.5.2).
constexpr Level level_in(SrsVersion srs, Level level) {
  return srs == SrsVersion::v4_0_0 && level == Level::L3 ? Level::L2 : level;
}

/// A table of priority of levels, the highest first; 1 + N_ITER entries, N_ITER is a 5-bit number.
using LevelTable = InplaceVector<OrderedLevel, 32>;

/// The levels available to this unit (5.10.2.4): levels 0 and 1 always where fitted; 2 and 3 with a working mobile
/// terminal; NTC with that national system (bit n: NID_NTC n).
struct AvailableLevels {
  std::array<bool, kLevels> fitted{true, true, true, true, true};
  bool mobile_terminal = true;
  std::array<std::uint64_t, 4> national_systems{};

  constexpr bool has(const OrderedLevel& entry) const {
    switch (entry.level) {
      case Level::NTC:
        return fitted[static_cast<std::size_t>(Level::NTC)] &&
               ((national_systems[entry.nid_ntc / 64u] >> (entry.nid_ntc % 64u)) & 1u) != 0;
      case Level::L2:
      case Level::L3:
        return mobile_terminal && fitted[static_cast<std::size_t>(entry.level)];
      case Level::L0:
        return true;
      default:
        return fitted[static_cast<std::size_t>(entry.level)];
    }
  }
};

/// 5.10.2.4: the first entry that is available, otherwise the last one. The table must not be empty.
OrderedLevel select_level(const LevelTable& table, const AvailableLevels& available);

// clang-format off
/// 5.10.4: whether a transition ordered by trackside from the level of the row to that of the column has to be
/// acknowledged. (NTC, NTC) is one national system to another. A level selected by the driver needs none.
inline constexpr std::array<std::array<bool, kLevels>, kLevels> srs_5_10_4{{
    //          to 0     NTC   1      2      3
    /* 0   */ {{false, true, false, false, false}},
    /* NTC */ {{true,  true, true,  true,  true }},
    /* 1   */ {{true,  true, false, false, false}},
    /* 2   */ {{true,  true, false, false, false}},
    /* 3   */ {{true,  true, false, false, false}},
}};
// clang-format on

/// 5.10.4; none in NL (4.4.15), and none where the level does not change. 4.0.0 requires none from NTC to 1 or 2.
bool acknowledgement_needed(const OrderedLevel& from, const OrderedLevel& to, Mode mode,
                            SrsVersion srs = SrsVersion::v3_6_0);

/// A pending level transition: announced for a place ahead.
struct PendingTransition {
  OrderedLevel to;
  Place border;
  Anchor anchor{};  ///< of the border
  friend constexpr bool operator==(const PendingTransition&, const PendingTransition&) = default;
};

/// 5.10.1.5: a pending transition is executed when the estimated front end passes its place, also when the group at
/// the border is missed.
constexpr bool border_reached(const PendingTransition& pending, Place est_front) { return est_front >= pending.border; }

/// 5.10.4.1: the acknowledgement is asked for as soon as the max safe front end enters the length L_ack in rear of the
/// border.
constexpr bool in_acknowledgement_length(const PendingTransition& pending, Place max_safe_front) {
  return max_safe_front >= pending.border - pending.to.L_ack;
}

/// The effect of a received order.
enum class OrderEffect : std::uint8_t {
  none,                  // the level does not change; the table is stored
  execute,               // change the level in this cycle
  announce,              // store it until its place; replaces the pending one (5.10.1.6)
  keep_until_mode_left,  // SH, PS: judged when another mode is entered (4.4.8.1.5)
  rejected,
};
struct OrderDecision {
  OrderEffect effect = OrderEffect::rejected;
  OrderedLevel to;               // the selected level
  bool cancels_pending = false;  // the pending transition is deleted
};

/// 5.10.1, 5.10.2: what to do with an order that passed the filters of 4.8. A conditional order whose table holds the
/// current level changes nothing; another one is an immediate order (5.10.2.5). An announcement of the current level
/// deletes a pending transition and has no other effect. RV handles no transition (3.15.4.6).
OrderDecision judge(OrderKind kind, const LevelTable& table, const OrderedLevel& current, Mode mode,
                    const AvailableLevels& available);

/// Levels that the driver may choose at standstill (5.10.1.7): those of the stored trackside table, otherwise those of
/// the unit.
bool driver_may_select(const OrderedLevel& level, const LevelTable* trackside_table, const AvailableLevels& available);

/// The levels among these (NTC: with one of its national systems).
Set<Level> levels_allowed(const LevelTable* trackside_table, const AvailableLevels& available);

/// What the driver is shown of a pending transition (4.7.2, symbols LE06 ..): nothing when the level will not change.
constexpr bool announced_to_driver(const PendingTransition& pending, const OrderedLevel& current) {
  return !pending.to.same_level(current);
}

}  // namespace evc::modes
