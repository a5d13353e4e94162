#pragma once
#include <cstdint>
#include <optional>

#include "base/set.h"
#include "base/units.h"
#include "terms/cause.h"
#include "terms/mode.h"

// Roll away, reverse movement, standstill supervision (3.14.2-4) and post trip distance (4.4.14).
namespace evc::protection {

/// A direction of movement, as seen from the active cab.
enum class Way : std::int8_t { backward = -1, none = 0, forward = 1 };

/// One protection by distance: a forbidden movement beyond its limit commands the brake until standstill and the
/// driver's acknowledgement; afterwards it starts again from there.
struct DistanceGuard {
  std::optional<OdometerPlace> reference;
  bool braking = false;
};
struct MovementGuards {
  DistanceGuard roll_away, reverse_movement, standstill;
  std::optional<OdometerPlace> post_trip_from;  ///< front end when PT was entered
  bool post_trip_braking = false;
  /// Released while still beyond, and the front end moved forward since: any movement back from there brakes again.
  std::optional<OdometerPlace> post_trip_released_at, reversing_released_at;
  bool reversing_braking = false;
};

/// The supervision in the current mode (4.5.2).
struct GuardSelection {
  bool roll_away = false;         ///< SH FS LS SR OS UN PT RV, with a direction controller
  bool reverse_movement = false;  ///< FS LS SR OS PT RV
  bool standstill = false;        ///< SB
  bool post_trip = false;         ///< PT
  bool reversing = false;         ///< RV
};
GuardSelection guards_of(Mode mode);

struct Movement {
  OdometerPlace nominal{};  ///< increases in running direction of the active cab
  bool standstill = false;
  std::optional<Way> controller;     ///< position of the direction controller; absent: no interface
  Way permitted = Way::forward;      ///< backward in PT and RV
  std::optional<Distance> D_NVROLL;  ///< absent: infinite
  std::optional<Distance> D_NVPOTRP;
  std::optional<Distance>
      reversing_left;       ///< RV: distance to the end of the reversing distance, negative beyond; absent: unlimited
  Set<Cause> acknowledged;  ///< the brake commands that the driver acknowledged
};
/// Brakes asked for. For roll away, reverse movement and standstill the kind of brake is open (3.14.1.1): the emergency
/// brake is used.
struct Commands {
  bool roll_away = false, reverse_movement = false, standstill = false;  ///< emergency brake
  bool post_trip = false;                                                ///< service brake (4.4.14.1.3)
  bool reversing = false;                                                ///< emergency brake (3.15.4.8)
  bool any() const { return roll_away || reverse_movement || standstill || post_trip || reversing; }
};
Commands guard(MovementGuards& guards, const GuardSelection& selection, const Movement& movement);
/// A mode was entered: supervision that is not active in the mode ends, roll away protection continues (4.12).
void enter_mode(MovementGuards& guards, const GuardSelection& selection, OdometerPlace nominal);

/// The cab at the other end became active: the counter, as it grows in its direction, has the other sign (5.12).
void turn(MovementGuards& guards);

}  // namespace evc::protection
