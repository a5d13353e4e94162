#include "procedures/leaving_rbc.h"

namespace evc::procedures::leaving_rbc {

Effects step(State& state, const Inputs& in) {
  Effects out;
  if (!in.session_open || in.level_2_or_3 || in.termination_ordered) {
    state.repetition.stop();
    return out;
  }
  if (in.exit_reported) {
    state.repetition.start(in.now);
    return out;
  }
  const Repetition::Due due = state.repetition.due(in.now);
  out.send.add(Send::position_report, due == Repetition::Due::send_again);
  out.send.add(Send::terminate_session, due == Repetition::Due::give_up);
  return out;
}

}  // namespace evc::procedures::leaving_rbc
