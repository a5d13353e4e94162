#pragma once
#include <functional>
#include <string>
#include <vector>

#include "world.h"

namespace evc::exploration {

/// One abstract input: what the driver, the train or the trackside does, and the cycles in which the unit answers.
struct Action {
  std::string name;
  std::function<void(Runner&)> act;
};
/// Those of an edition: 4.0.0 has those of a supervised manoeuvre too.
const std::vector<Action>& actions(SrsVersion srs);

/// What a driver does to go on from any state but isolation: stops, switches a unit that is off or failed off and on,
/// has no consist and no alarm any more, closes and opens the desk, answers what the unit asks, and starts in the
/// lowest level that is allowed. The RBC answers calls and ends a session that has to end before a start (5.4.3.2 S0).
/// True: the train may move.
bool goes_on(Runner& runner);

}  // namespace evc::exploration
