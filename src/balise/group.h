#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/units.h"
#include "terms/clause.h"
#include "terms/error_report.h"
#include "terms/reaction.h"
#include "terms/what.h"

// The results of this room: checked balise groups with their orientation (SUBSET-026-3 3.4,
// 3.16.2).
namespace evc::balise {

/// The most balises a group has (3.4.1.1), the longest telegram in bytes (830 user bits).
inline constexpr std::size_t kBalises = 8;
inline constexpr std::size_t kTelegramBytes = 104;

/// One telegram of a group, with its bits as received.
struct Telegram {
  std::array<std::uint8_t, kTelegramBytes> bytes{};
  std::uint16_t bits = 0;
  std::uint8_t N_PIG = 0;
  std::uint8_t M_DUP = 0;
  std::uint8_t M_MCOUNT = 0;
  std::uint8_t M_VERSION = 0;
  bool used = true;                  // false: its duplicate is used instead (3.16.2.4.8)
  bool default_information = false;  // packet 254
  bool inhibits_reaction = false;    // packet 145
  std::uint8_t repositioning = 0;    // packet 16: bit n is set for Q_DIR n
  bool one_direction = false;        // a packet other than 44 is for one direction only
  bool faulty = false;               // spare value or broken packet (3.16.1.1)
  OdometerReading counter;           // when the antenna was over it
  PlaceInterval antenna;             // where the antenna was then
  std::span<const std::uint8_t> span() const { return {bytes.data(), (bits + 7u) / 8u}; }
};

/// An error of a group, or its absence. The clause gives the reaction.
enum class Finding : std::uint8_t {
  none,
  balise_missed,       // a: 3.16.2.1.3
  balise_not_decoded,  // b
  invalid_value,       // c: 3.16.1.1
  counters_differ,     // d: 3.16.2.4.7
  not_announced,       // linking is used, the group is marked linked but not announced: 3.4.4.4.2, 3.16.2.4.3
  outside_window,      // 3.16.2.3.1.1
  wrong_direction,     // 3.16.2.3.2
  not_repositioning,   // identity unknown expected, this one does not qualify: 3.4.4.4.2.1
};

/// A group as passed by the train.
struct Group {
  GroupId id;
  bool accepted = false;      // its information may be used
  bool identified = true;     // false: no telegram could be read (3.16.2.2.1)
  bool linked = false;        // Q_LINK
  bool announced = false;     // by linking that is checked
  bool linking_used = false;  // when the group was judged
  /// May become the LRBG (3.6.2.2.2 a): accepted and marked linked, and announced where linking is used.
  bool lrbg_compliant = false;
  /// Gives no orientation of its own: one balise, or one of a pair of duplicates (3.4.2.3, 3.4.2.4).
  bool single = false;
  bool repositioning = false;        // used for the entry with unknown identity
  bool default_information = false;  // packet 254 in use: shown to the driver (3.16.2.4.9)
  std::uint8_t X = 0;                // highest system version number X among its telegrams
  Finding finding = Finding::none;
  /// The direction in which it was crossed, from the order of reading; for a single group the announced one.
  Direction crossing = Direction::unknown;
  /// nominal: N_PIG rises as the odometer counter grows. Unknown when the group does not show it.
  Direction counter_against_group = Direction::unknown;
  /// Where the reference balise (N_PIG 0, or its duplicate when only that one was read) is.
  OdometerReading counter;
  PlaceInterval antenna;
  Duration first_passed{};           // when its first balise was encountered (3.8.4.2.1 b)
  std::optional<Place> link_place;   // by linking (3.6.4.3)
  std::optional<Distance> Q_LOCACC;  // by linking (3.6.4.2.3)
  /// In the order of reading. Only those with `used` count.
  InplaceVector<Telegram, kBalises> telegrams;
};

/// Does information with this Q_DIR count for `direction` (3.6.3.1.3)? `direction` is the train
/// orientation against the group or, in SL, PS, SH, the direction in which it was crossed; unknown: only
/// "both" counts (3.6.3.1.4).
constexpr bool valid_for(std::uint64_t Q_DIR, Direction direction) {
  if (Q_DIR == 2) return true;
  return direction != Direction::unknown && Q_DIR == static_cast<std::uint64_t>(direction);
}

/// An event of a group, or of a missing group.
struct Event {
  What what{};
  GroupId id;  // the expected group for linking errors, else the one read
  Finding finding = Finding::none;
  Reaction reaction = Reaction::none;
  ErrorReport report = ErrorReport::none;
  Clause clause;
};

/// The result of one call.
struct Outcome {
  InplaceVector<Group, 2> groups;  // finished ones, in the order of passage
  InplaceVector<Event, 24> events;
  /// The most severe reaction asked for in this call; a group passed the wrong way asks for none, but is [66].
  Reaction reaction = Reaction::none;
  bool wrong_direction = false;   // condition [66]
  bool version_too_high = false;  // condition [65], where the level requires it
  /// The service brake of this call is due to linking or message consistency: at standstill the
  /// location data are shortened to the current position (A.3.4).
  bool shorten_at_standstill = false;
};

/// Adds an event and its reaction. If the list is full, the reaction is kept and the last entry becomes `capacity`.
void note(Outcome& outcome, const Event& event);

}  // namespace evc::balise
