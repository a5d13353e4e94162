#include "procedures/end_of_mission.h"

namespace evc::procedures::end_of_mission {
namespace {

void report(const State& state, Effects& out) {
  out.send.add(state.reports_mode_only ? Send::position_report : Send::end_of_mission);
}

}  // namespace

bool is_mission(Mode mode) {
  switch (mode) {
    case Mode::FS:
    case Mode::AD:
    case Mode::SM:
    case Mode::LS:
    case Mode::SR:
    case Mode::OS:
    case Mode::NL:
    case Mode::UN:
    case Mode::SN:
    case Mode::RV:
      return true;
    default:
      return false;
  }
}

bool ends_mission(Mode from, Mode to, bool mission) {
  if (!mission) return false;
  if (to == Mode::SB) return is_mission(from) || from == Mode::PT;
  if (to == Mode::SH) return (is_mission(from) && from != Mode::NL && from != Mode::RV) || from == Mode::PT;
  return to == Mode::SL && (from == Mode::SB || from == Mode::PS);
}

Effects step(State& state, const Inputs& in) {
  Effects out;
  if (in.mode != in.previous_mode) {
    const bool ends = ends_mission(in.previous_mode, in.mode, state.mission);
    // A095: shunting entered without a mission in progress also ends the session of level 2/3, with a mode report.
    const bool shunting_only = in.mode == Mode::SH && !state.mission && in.level_2_or_3 && in.previous_mode != Mode::PS;
    if (ends || in.mode == Mode::NP) state.mission = false;
    if (is_mission(in.mode)) {
      state.mission = true;
      state.waits_for_order = false;  // from SH to NL: the mission before is not reported any more
    }
    if (ends && in.session_open && in.mode == Mode::SB && in.report_ends_it) {
      state.waits_for_order = false;
      out.send.add(Send::end_of_mission);
      return out;
    }
    if ((ends || shunting_only) && in.session_open) {
      state.waits_for_order = true;
      state.reports_mode_only = !ends;
      state.repetition.start(in.now);
      report(state, out);
      return out;
    }
    // 5.5.4: no session is opened only to report the end of the mission.
  }
  if (!state.waits_for_order) return out;
  if (!in.session_open) {
    state.waits_for_order = false;
    return out;
  }
  const Repetition::Due due = state.repetition.due(in.now);
  if (in.termination_ordered || due == Repetition::Due::give_up) {
    out.send.add(Send::terminate_session);
    state.waits_for_order = false;
  } else if (due == Repetition::Due::send_again) {
    report(state, out);
  }
  return out;
}

}  // namespace evc::procedures::end_of_mission
