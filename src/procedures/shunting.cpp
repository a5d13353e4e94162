#include "procedures/shunting.h"

namespace evc::procedures::shunting {
Result step(State& state, const Inputs& in) {
  Result out;
  const bool rbc = in.level == Level::L2 || in.level == Level::L3;
  const bool in_shunting = in.mode == Mode::SH || in.mode == Mode::PS;
  // 4.4.20.1.7: the function allows one transition to PS; it is off once SH is left.
  if (in.mode != Mode::SH) state.continues = false;
  if (in.mode == Mode::SH && in.selects_continue) state.continues = true;

  // E015: in levels 0, NTC and 1 the selection takes effect by [5]; with a national trip in level NTC by [35].
  out.selects_SH = in.selects_SH && in.standstill && !rbc;
  if (in_shunting || !rbc || !in.session_open) {
    state.waits_for_answer = false;
    state.repetition.stop();
    return out;
  }
  if (in.selects_SH && in.standstill && !state.waits_for_answer) {  // A045
    state.waits_for_answer = true;
    state.repetition.start(in.now);
    out.effects.send.add(Send::shunting_request);
    return out;
  }
  if (!state.waits_for_answer) {
    out.granted = in.mode == Mode::SM && in.authorised && in.standstill;  // 4.8.4: it needs no request there
    return out;
  }
  if (in.authorised || in.refused) {  // E090, E215; a grant received while moving has no effect (4.6.3 [6])
    state.waits_for_answer = false;
    state.repetition.stop();
    out.granted = in.authorised && in.standstill;
    out.effects.inform.add(Inform::SH_refused, in.refused && !in.authorised);
    return out;
  }
  switch (state.repetition.due(in.now)) {
    case Repetition::Due::send_again:
      out.effects.send.add(Send::shunting_request);
      break;
    case Repetition::Due::give_up:  // 5.6.4.1.2
      state.waits_for_answer = false;
      out.effects.inform.add(Inform::SH_request_failed);
      out.effects.send.add(Send::terminate_session);
      break;
    case Repetition::Due::nothing:
      break;
  }
  return out;
}

}  // namespace evc::procedures::shunting
