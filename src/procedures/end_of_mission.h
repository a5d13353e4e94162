#pragma once
#include <cstdint>

#include "procedures/effects.h"
#include "terms/mode.h"

// End of mission, SUBSET-026-5 5.5, and the end of the session after entry to SH without a mission (5.6, A095 to A115).
namespace evc::procedures::end_of_mission {

struct State {
  bool mission = false;            // a mission is in progress (5.4.7: entered FS, LS, SR, OS, NL, UN or SN)
  bool waits_for_order = false;    // for the RBC's order to terminate the session
  bool reports_mode_only = false;  // message 136 is repeated instead of 150
  Repetition repetition;
};

struct Inputs {
  Duration now{};
  Mode mode = Mode::NP;              // now
  Mode previous_mode = Mode::NP;     // in the cycle before
  bool session_open = false;         // with an RBC; a session with a radio infill unit ends at once (kernel)
  bool termination_ordered = false;  // packet 42, in this cycle
  bool level_2_or_3 = false;
  /// The desk is closed, and the RBC is of version 2.3 or later (5.5.3.1.3 of 4.0.0).
  bool report_ends_it = false;
};

/// One cycle, after the mode transition. Sends 150; in SB with `report_ends_it` that is all. Else sends 150 (136 for SH
/// without a mission), repeats it three times, terminates the session when the RBC orders it or at the end of the last
/// wait.
Effects step(State& state, const Inputs& inputs);

/// 5.4.7: a mode in which a mission is in progress.
bool is_mission(Mode mode);
/// 5.5.2: whether the transition ends a mission in progress.
bool ends_mission(Mode from, Mode to, bool mission);

}  // namespace evc::procedures::end_of_mission
