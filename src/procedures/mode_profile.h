#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/units.h"
#include "procedures/effects.h"
#include "terms/mode.h"
#include "terms/srs_version.h"

// On sight, limited supervision and shunting ordered by trackside: SUBSET-026-5 5.7, 5.9, 5.19 and 3.12.4.
namespace evc::procedures::mode_profile {

/// One area of the mode profile (packet 80).
struct Area {
  Mode mode = Mode::OS;  // OS, LS or SH
  Place start{};
  std::optional<Place> end;  // none: to the end of the MA; not read for SH (3.12.4.2)
  Speed V{};                 // the limit in the area
  Distance L_ack{};          // length in rear of the start in which it may be acknowledged
  bool asked = false;        // the acknowledgement was asked for ahead of it, in an earlier cycle
};

struct State {
  bool unacknowledged = false;  // the mode was entered without acknowledgement
  Mode asked = Mode::OS;
  Duration deadline{};  // T_ACK after the entry
};

struct Inputs {
  Duration now{};
  Mode mode = Mode::SB;
  std::span<const Area> areas;  // in use; in levels 0 and NTC kept for the level transition
  Place min_safe_front{}, est_front{}, max_safe_front{};
  Speed V_est{};
  Set<Ack> acknowledged;  // in this cycle
  SrsVersion srs = SrsVersion::v3_6_0;
};

struct Result {
  Effects effects;
  bool demands_OS = false, demands_LS = false, demands_SH = false;  // by the area in which the train is
  bool in_force = false;                                            // Facts::profile_in_force
  bool front_in_OS_ack_area = false, front_in_LS_ack_area = false;  // by the estimated front end
  std::optional<Mode> overdue;                                      // entered and not acknowledged for T_ACK: it brakes
  std::optional<Mode> at_front;         // the mode of the area in which the train is; for S25 and S170
  std::optional<std::size_t> asks_for;  // the area of Inputs::areas for which the acknowledgement is asked ahead of it
};

/// One cycle, before the mode transition.
Result step(State& state, const Inputs& inputs);

/// To be called at every mode transition with its condition: OS, LS or SH entered because of its area ([34], [40],
/// [73]; [71], [72], [74]; [51], [61]) has to be acknowledged within T_ACK; any other transition ends this supervision.
void on_mode_change(State& state, Mode to, int condition, Duration now);

}  // namespace evc::procedures::mode_profile
