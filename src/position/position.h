#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/units.h"
#include "terms/data_status.h"

// Where the train is (SUBSET-026-3 3.4.2.3, 3.6.1, 3.6.2, 3.6.4).
//
// Two frames. The odometer counts from power-up and never jumps; its value is the place of the front
// end of the active cab. Track data are stored in the track frame, which is fixed to the balise groups. One offset (and
// one sense, inverted by a change of cab) converts between them. When the train relocates to a group whose distance was
// given by trackside, the offset absorbs the odometer error; the stored track data do not change (3.6.4.3).
// Data of an unlinked group are the exception: linking does not know that group, so that they move with the train.
namespace evc::position {

/// LRBGs remembered: at least the 8 last reported ones must be known (3.6.2.2.2 c).
inline constexpr std::size_t kReferences = 16;
/// PRVLRBGs remembered for a single balise group that waits for its assignment (3.4.2.3.3.7).
inline constexpr std::size_t kPreviousReported = 2;
/// The train is at standstill below this speed, for this time, with less movement than this.
/// SUBSET-026 gives no figures: the supplier chooses them.
inline constexpr Speed kStandstillSpeed{0.05};
inline constexpr Duration kStandstillTime{0.5};
inline constexpr Distance kStandstillDistance{0.05};
/// The counter has to run back by this distance before the train counts as turned.
inline constexpr Distance kTurnDistance{0.1};
/// Relative odometer error over a distance (SUBSET-041 5.3.1.1), used where no reading bounds the
/// distance; with kOdometerOffset the error that the odometer may have between two groups.
inline constexpr double kOdometerError = 0.05;
inline constexpr Distance kOdometerOffset{5.0};

/// One reading of the odometer.
struct Odometry {
  OdometerReading counter;
  Speed V_est, V_min, V_max;
  Acceleration A_est;
};

enum class Motion : std::uint8_t { standstill, forward, backward };  // as seen from the active cab

/// A balise group to which the position can refer.
struct Reference {
  GroupId id;
  OdometerReading counter;                     // when the antenna was over the reference balise
  Place place;                                 // of the reference balise
  Distance Q_LOCACC;                           // frozen when the group was read (3.6.4.2.3)
  Direction orientation = Direction::unknown;  // of the train (active cab) against the group (3.6.1.6)
  bool single = false;                         // gives no orientation of its own (3.4.2.3)
  /// Relative to the movement from `previous` to this group, as a single group without orientation is reported
  /// (3.4.2.3.3.2).
  Direction pair_orientation = Direction::unknown;
  bool counter_rising = true;  // direction of the counter when it was passed (3.4.2.3.3.4)
  bool reported = false;
  /// The groups with which this one was reported as "previous" (packet 1) while its orientation was
  /// unknown, and whether more than one such pair exists (3.4.2.3.3.7, .8).
  std::optional<GroupId> previous;                      // PRVLRBG now, for the next report
  std::optional<GroupId> reported_with;                 // PRVLRBG of the first such report
  Direction reported_orientation = Direction::unknown;  // of the train against that pair
  bool reported_ambiguously = false;
};

/// An interval without its place: from the estimated front end to the min safe one, and to the max safe one.
struct Doubts {
  Distance over{}, under{};
};

/// How far the front end of the train is ahead of the place of the counter: the vehicles in front of the engine
/// (3.6.1.3.4 of 4.0.0). min <= est <= max.
struct Ahead {
  Distance est{}, min{}, max{};
  friend constexpr bool operator==(const Ahead&, const Ahead&) = default;
};

struct State {
  Odometry now, before;  // this cycle and the one before
  Duration time{}, time_before{};
  double sense = 1.0;  // +1: the counter grows when the active cab leads; -1 after a change of cab
  Distance offset{};   // Place of the front end of the engine = sense * counter + offset
  Ahead ahead;         // of it: the front end of the train
  DataStatus status = DataStatus::unknown;
  InplaceVector<Reference, kReferences> references;  // oldest first; the last one is the LRBG
  std::optional<Reference> unlinked;                 // the last unlinked group, until a new LRBG (3.6.4.7)
  /// How much the interval of the LRBG is wider, on either side, than that of each unlinked group passed since.
  Doubts surplus;
  OdometerPlace extreme;                 // farthest counter in the current direction
  Motion last_motion = Motion::forward;  // never `standstill`
  OdometerPlace rest;                    // counter when the train came to rest
  Duration rest_since{};
  OdometerReading origin;  // the first reading: the reference while there is no LRBG
  bool started = false;    // an odometer reading was received
};

/// A group that was read and accepted, with its place as given by trackside.
struct Passage {
  GroupId id;
  OdometerReading counter;                               // when the antenna was over the reference balise
  Distance L_antenna;                                    // of the antenna behind the front end
  std::optional<Place> link_place;                       // by linking (3.6.4.3); absent: the estimated place is used
  Distance Q_LOCACC;                                     // linking, else Q_NVLOCACC, else 12 m (3.6.4.2.3)
  Direction counter_against_group = Direction::unknown;  // nominal: N_PIG rises as the counter grows
  bool single = false;
};

/// A reading that was measured `age` ago, at its present value: increased by the speeds.
Odometry extrapolated(const Odometry& odometry, Duration age);
/// Stores a reading of the odometer; `now` is the time since power-up. Detects direction and standstill; a reading that
/// was not measured (`estimated`) does not show that the train turned.
void update(State& state, const Odometry& odometry, Duration now, bool estimated = false);
/// The nominal counter at a time: between the last two readings interpolated, before them by the speed.
OdometerPlace counter_at(const State& state, Duration time);

/// The three counters when the nominal one was `at`: interpolated between the last two readings; outside them 5 % of
/// the distance to the nearer one is added. Only increments of the bounds are meaningful: here alone `min` <= `nominal`
/// <= `max` need not hold.
OdometerReading reading_at(const State& state, OdometerPlace at);

/// How data that do not refer to an LRBG move when the position refers to another group.
struct Relocated {
  Relocation unlinked;      ///< data of Anchor::unlinked
  Relocation travelled;     ///< data of Anchor::travelled
  bool by_linking = false;  ///< those of Anchor::travelled hang on the LRBG from now on
  /// The distance by linking and the counter differ by more than the odometer may err (SUBSET-041 5.3.1.1) and the
  /// accuracy of both groups explains.
  bool out_of_tolerance = false;
};
/// The group becomes the LRBG (3.6.1.4): the confidence interval restarts there, the offset between the frames is
/// computed again. Data of an unlinked group keep their distance to the train, and the safe side of the interval that
/// they had (3.6.4.3; 3.6.4.2.5 c of 4.0.0); they hang on this LRBG now (Anchor::travelled). When linking leads from it
/// to the next one, twice the accuracy of the former counts besides (3.6.4.2.5 b of 4.0.0).
Relocated relocate(State& state, const Passage& passage);
/// An unlinked group was accepted: data that refer to it have an interval of their own (3.6.4.7). Without an LRBG it is
/// the reference of the position, and data of the unlinked group before it move as returned.
Relocated refer_to_unlinked(State& state, const Passage& passage);
/// How places of the last unlinked group move to be supervised with the interval of the LRBG: the wider one of the two
/// counts for them.
Relocation from_unlinked(const State& state);

/// What is kept of a position without power: its LRBG and where the front end of cab A is against it. The other groups
/// that were passed are forgotten.
struct Kept {
  Reference lrbg;  ///< of it the counter and the place mean nothing
  Distance ahead{};
  Doubts doubts;
};
/// Absent: the position is unknown.
std::optional<Kept> kept(const State& state, Distance L_engine);
/// Before the first reading of the odometer: the position of another unit, to be validated (4.11).
void restore(State& state, const Kept& position);

// --- Where the train is. Defined in every state; without an LRBG the interval starts at the last unlinked group, and
// --- without one at power-up.

/// The LRBG, if any.
const Reference* lrbg(const State& state);
/// Front end now: min safe, estimated, max safe (3.6.4.2, 3.6.4.4).
PlaceInterval front(const State& state);
/// The same of the engine, on the side of the active cab: without the vehicles in front of it.
PlaceInterval engine_front(const State& state);
PlaceInterval engine_front_at(const State& state, const OdometerReading& counter);
/// The nominal counter as it would grow towards the active cab.
OdometerPlace forward_counter(const State& state);
/// Front end when the counters stood at `counter`.
PlaceInterval front_at(const State& state, const OdometerReading& counter);
/// Rear end; `min` is safe only while the integrity of the train is known (3.6.4.4.1). In SL, NL, PS
/// the length is that of the engine.
inline PlaceInterval rear(const State& state, Distance L_TRAIN) { return front(state) - L_TRAIN; }
/// The active antenna, `L_antenna` behind the front end of the engine (3.4.4.4.3); ahead of it if that is below 0.
inline PlaceInterval antenna(const State& state, Distance L_antenna) { return engine_front(state) - L_antenna; }
inline PlaceInterval antenna_at(const State& state, const OdometerReading& counter, Distance L_antenna) {
  return engine_front_at(state, counter) - L_antenna;
}
/// 3.6.7.3 of 4.0.0: the way of a front end that referred to no group since the counters stood at `from`: forward, and
/// what the odometer may have read too much or too little of it.
struct Way {
  Distance est{}, over{}, under{};
};
Way way_since(const State& state, const OdometerReading& from);
/// Distance from the estimated front end back to the min safe one / ahead to the max safe one.
Distance L_DOUBTOVER(const State& state);
Distance L_DOUBTUNDER(const State& state);

/// From one frame to the other, with the current offset. A place ahead of the train has a counter
/// ahead of the train.
Place place_of(const State& state, OdometerPlace counter);
OdometerPlace counter_of(const State& state, Place place);

/// The reference balise of a remembered LRBG (3.6.2.2.2 c): the start of the data of a radio message. Absent: not
/// remembered (the message is not used).
std::optional<Place> place_of(const State& state, GroupId id);
/// The remembered LRBG itself; null when it is not remembered.
const Reference* find(const State& state, GroupId id);
// --- Motion, orientation

Motion motion(const State& state);
/// The last direction in which the train moved; `forward` before its first movement.
Motion last_motion(const State& state);
bool at_standstill(const State& state);
/// The last movement increased the counter.
bool counter_rises(const State& state);
/// Train orientation against the LRBG (Q_DIRLRBG).
Direction orientation(const State& state);
/// Running direction against the LRBG (Q_DIRTRAIN): at standstill that of the last movement.
Direction running_direction(const State& state);
/// The side of the LRBG on which the estimated front end is (Q_DLRBG).
Direction side(const State& state);

/// Radio message 45: assigns a co-ordinate system to the group (3.4.2.3.3.6). `nominal`: the move from PRVLRBG to it,
/// as reported, is its nominal direction. False: rejected (not remembered, not a single group, not reported with one
/// and only one PRVLRBG; 3.4.2.3.3.8).
[[nodiscard]] bool assign_orientation(State& state, GroupId id, Direction q_orientation);

/// The cab at the other end of the engine becomes active: the track frame is mirrored (p -> -p), the
/// front end is that of the other cab (5.12.2.5). The caller mirrors or deletes its own data in the frame.
void change_cab(State& state, Distance L_engine);
/// The train has the other orientation while the cab stays (3.6.1.5.1 of 4.0.0): the track frame is mirrored, the place
/// of the counter stays the front end of the engine on the side of the active cab.
void turn(State& state);

// --- Status (4.10, 4.11, 5.4)

/// Position kept over No Power or entered as invalid: to be confirmed.
void invalidate(State& state);
/// Confirmed by the RBC (message 43) or by cold movement detection. Without a reference the position stays unknown.
void validate(State& state);
/// Position deleted: unknown, no LRBG.
void forget(State& state);

}  // namespace evc::position
