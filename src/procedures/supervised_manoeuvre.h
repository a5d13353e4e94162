#pragma once
#include "procedures/effects.h"
#include "terms/level.h"
#include "terms/mode.h"

// The request for a supervised manoeuvre, SUBSET-026-5 5.21 of 4.0.0.
namespace evc::procedures::supervised_manoeuvre {

struct State {
  bool waits_for_answer = false;  // S050: 131 is sent
  Repetition repetition;
};

struct Inputs {
  Duration now{};
  Mode mode = Mode::SB;
  Level level = Level::L0;
  bool session_open = false;  // with an RBC that knows the manoeuvre
  bool selects = false;       // the driver, while the choice is enabled (S0)
  bool authorised = false;    // 4, in this cycle: it answers the request
  bool refused = false;       // 5, the same
};

struct Result {
  Effects effects;
  bool requested = false;  // 131 is sent for a selection of the driver
  bool granted = false;    // Facts::SM_authorised
};

/// One cycle. An authorisation or refusal without an open request has no effect (4.8.4 [14]).
Result step(State& state, const Inputs& inputs);

}  // namespace evc::procedures::supervised_manoeuvre
