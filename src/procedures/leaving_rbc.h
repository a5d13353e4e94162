#pragma once
#include "procedures/effects.h"

// The end of the session after the train has left the RBC's area over a level border: SUBSET-026-3 3.5.5.1 e,
// SUBSET-026-5 5.10.3.3.5, 5.10.3.6.5. (At an RBC border it belongs to the handover, 5.15.)
namespace evc::procedures::leaving_rbc {

struct State {
  Repetition repetition;
};

struct Inputs {
  Duration now{};
  bool exit_reported = false;  // in this cycle: the position report "min safe rear end beyond the border" is sent,
                               // or (4.0.0) the report that the driver left level 2
  bool level_2_or_3 = false;   // now
  bool session_open = false;
  bool termination_ordered = false;  // packet 42, in this cycle
};

/// One cycle. The report is repeated three times, 15 s apart; without an order the session is terminated at the end of
/// the last wait. An order, the end of the session, or a new entry to level 2/3 ends the wait.
Effects step(State& state, const Inputs& inputs);

}  // namespace evc::procedures::leaving_rbc
