#include "procedures/supervised_manoeuvre.h"

namespace evc::procedures::supervised_manoeuvre {
namespace {

/// S0: a request can be made in these modes, and be answered in them (4.8.4).
bool possible_in(Mode mode) {
  constexpr Set<Mode> kModesOfRequest{Mode::SB, Mode::FS, Mode::AD, Mode::LS, Mode::OS, Mode::SR, Mode::PT, Mode::SM};
  return kModesOfRequest.has(mode);
}

void stop(State& state) {
  state.waits_for_answer = false;
  state.repetition.stop();
}

}  // namespace

Result step(State& state, const Inputs& in) {
  Result out;
  if (!possible_in(in.mode) || in.level != Level::L2 || !in.session_open) {
    stop(state);
    return out;
  }
  if (state.waits_for_answer && (in.authorised || in.refused)) {  // E115, E215
    stop(state);
    out.granted = in.authorised;
    // A095; with the mode it is reported all the same.
    out.effects.send.add(Send::position_report, in.authorised);
    out.effects.inform.add(Inform::SM_refused, !in.authorised);  // A220
    return out;
  }
  if (in.selects && !state.waits_for_answer) {  // E015, A045
    state.waits_for_answer = true;
    state.repetition.start(in.now);
    out.requested = true;
    out.effects.send.add(Send::manoeuvre_request);
    return out;
  }
  if (!state.waits_for_answer) return out;
  switch (state.repetition.due(in.now)) {
    case Repetition::Due::send_again:
      out.effects.send.add(Send::manoeuvre_request);
      break;
    case Repetition::Due::give_up:  // 5.21.4.1
      state.waits_for_answer = false;
      out.effects.inform.add(Inform::SM_request_failed);
      break;
    case Repetition::Due::nothing:
      break;
  }
  return out;
}

}  // namespace evc::procedures::supervised_manoeuvre
