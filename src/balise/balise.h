#pragma once
#include <optional>
#include <span>

#include "balise/group.h"
#include "balise/linking.h"
#include "base/inplace_vector.h"
#include "terms/srs_version.h"

// From telegrams to balise groups (3.4.1, 3.4.2, 3.16.2).
namespace evc::balise {

/// Farthest distance of two neighbours in one group (SUBSET-040 4.1.1.2), and the tolerance of
/// odometer and detection: 1 m at each of the two balises (SUBSET-036 4.2.10.2), 5 % of 12 m.
inline constexpr Distance kBaliseSpacing{12.0};
inline constexpr Distance kSpacingMargin{2.6};
/// Two readings of the same balise closer than this are one passage.
inline constexpr Distance kSameBalise{1.3};
/// Virtual balise covers kept (3.15.9).
inline constexpr std::size_t kCovers = 16;

/// The facts about level and mode that these rules need, at the time the telegram is read.
struct Situation {
  Duration now{};                        // since power-up
  bool linking_checked = false;          // the mode supervises linking: FS, LS, OS (4.5.2)
  bool braking_on_message_error = true;  // SB SH FS LS SR OS UN SN TR; not in SL PT NL RV PS (4.4.6.1.12 ...)
  /// Reverse movement protection is active and the train moves against it (3.14.3.6).
  bool against_permitted_movement = false;
  bool counter_rises = true;   // direction of movement, as the odometer counts
  bool level_1_2_3 = false;    // else level 0 or NTC (3.17.3.5 d, e)
  std::uint8_t highest_X = 2;  // highest supported system version number
  SrsVersion srs = SrsVersion::v3_6_0;
};

/// A balise as read by the antenna.
struct Reading {
  std::span<const std::uint8_t> bytes;  // user bits, left aligned
  std::size_t bits = 0;
  OdometerReading counter;  // when the antenna was over it
  PlaceInterval antenna;    // where the antenna was then: position::antenna_at
};

/// A virtual balise cover (packet 6).
struct Cover {
  std::uint8_t NID_VBCMK = 0;
  std::uint16_t NID_C = 0;
  Duration until{};        // since power-up
  std::uint8_t T_VBC = 0;  // the validity period as it was set, days
  /// When the power went off, seconds since 1970 (UTC): the time without power is not yet counted in `until`.
  std::optional<std::int64_t> power_off = {};
  friend constexpr bool operator==(const Cover&, const Cover&) = default;
};

/// The group that is being read.
struct OpenGroup {
  GroupId id;
  std::uint8_t N_TOTAL = 0;
  bool Q_LINK = false;
  bool identified = false;       // false: only unreadable balises so far
  bool undecoded = false;        // a balise was detected but not decoded
  bool header_mismatch = false;  // N_TOTAL or Q_LINK differ within the group
  Judgement judgement;           // of its reference balise by linking
  /// Its reference balise was encountered, but its telegram is ignored (3.17.3.5): where that was.
  struct Encounter {
    OdometerReading counter;
    PlaceInterval antenna;
  };
  std::optional<Encounter> ignored_reference;
  Duration first_passed{};  // when its first balise was encountered
  OdometerReading last;     // its last balise
  PlaceInterval last_antenna;
  std::uint8_t seen = 0;  // bit n: N_PIG n was read, used or not
  InplaceVector<Telegram, kBalises> telegrams;
};

/// The last balise of the group that was read last, of more than one.
struct LastBalise {
  GroupId id;
  std::uint8_t N_PIG = 0;
  std::uint8_t M_MCOUNT = 0;
  OdometerReading counter;
  bool counter_rose = true;  // while the group was read
};

struct State {
  std::optional<OpenGroup> open;
  std::optional<LastBalise> last;
  LinkingState linking;
  InplaceVector<Cover, kCovers> covers;
};

// Each call clears `outcome` first.

/// A telegram was read. May finish the open group, and this one.
void read(State& state, const Reading& reading, const Situation& situation, Outcome& outcome);
/// Each cycle: finishes the open group when no further balise of the group can follow (3.16.2.1.3).
void close_overdue(State& state, const OdometerReading& counter, const Situation& situation, Outcome& outcome);
/// Each cycle, after the telegrams: has the window of the expected group ended without it (3.16.2.3.1 b)? Covers whose
/// time is over are deleted.
void expect(State& state, const PlaceInterval& antenna, const Situation& situation, Outcome& outcome);
/// Drops a group that is only partly read (change of cab, power off).
void abandon(State& state);

/// Stores a cover; one with the same identity is replaced (3.15.9.4). False: no room, the cover is not in force.
[[nodiscard]] bool set_cover(State& state, const Cover& cover);
void remove_cover(State& state, std::uint8_t NID_VBCMK, std::uint16_t NID_C);
/// A consistent message with another NID_C was received (3.15.9.5 d).
void keep_covers_of(State& state, std::uint16_t NID_C);

}  // namespace evc::balise
