#include "balise/group.h"

namespace evc::balise {

void note(Outcome& outcome, const Event& event) {
  // A condition of its own ([66]), whatever the linking reaction is (3.16.2.3.2).
  if (event.what == What::group_wrong_direction)
    outcome.wrong_direction = true;
  else if (stronger(event.reaction, outcome.reaction))
    outcome.reaction = event.reaction;
  if (event.reaction == Reaction::service_brake) outcome.shorten_at_standstill = true;
  if (!outcome.events.push_back(event)) outcome.events.back().what = What::group_capacity;
}

}  // namespace evc::balise
