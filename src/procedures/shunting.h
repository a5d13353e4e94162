#pragma once
#include <cstdint>

#include "procedures/effects.h"
#include "terms/level.h"
#include "terms/mode.h"

// Shunting on the driver's request, SUBSET-026-5 5.6, and continuing it when the desk is closed (5.12.4).
namespace evc::procedures::shunting {

struct State {
  bool waits_for_answer = false;  // S050: 130 is sent
  bool continues = false;         // "continue shunting on desk closure" is on
  Repetition repetition;
};

struct Inputs {
  Duration now{};
  Mode mode = Mode::SB;
  Level level = Level::L0;
  bool standstill = false;
  bool session_open = false;
  bool selects_SH = false;        // the driver, while the choice is enabled
  bool selects_continue = false;  // "maintain shunting"
  bool authorised = false;        // 28, in this cycle
  bool refused = false;           // 27, in this cycle
};

struct Result {
  Effects effects;
  bool granted = false;     // Facts::SH_granted: message 28 answers the open request
  bool selects_SH = false;  // Facts::selects_SH: in levels 0, NTC and 1 the selection takes effect at once
};

/// One cycle. A grant or refusal without an open request has no effect (4.6.3 [6]).
Result step(State& state, const Inputs& inputs);

}  // namespace evc::procedures::shunting
