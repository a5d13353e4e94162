#include "procedures/rbc_handover.h"

namespace evc::procedures::rbc_handover {
namespace {

/// 3.15.1.3.1 c, 3.15.1.3.9: the rear end leaves the area of the handing over RBC.
void leave(State& state, const Inputs& in, Result& out) {
  if (in.min_safe_rear && !state.rear_passed) {
    state.rear_passed = out.rear_passed_now = true;
    if (!in.established || !in.reports) return;
    out.report = true;
    state.repetition.start(in.now);
    return;
  }
  if (!in.established) {
    state.repetition.stop();
    return;
  }
  const Repetition::Due due = state.repetition.due(in.now);
  out.report = out.report || due == Repetition::Due::send_again;
  out.terminate = due == Repetition::Due::give_up;
}

}  // namespace

Result step(State& state, const Inputs& in) {
  Result out;
  if (in.ordered) {
    state = {};
    state.step = Step::announced;
  }
  if (!in.stored && (state.step == Step::announced || in.alone)) state = {};
  if (state.step == Step::none) return out;
  if (in.est_front && !state.contact_changed) state.contact_changed = out.change_contact = true;
  if (state.step == Step::announced && in.max_safe_front) {
    state.step = Step::at_border;
    out.report = in.reports;
  }
  if (state.step == Step::announced) return out;
  // The first report beyond the border that reaches the accepting RBC makes it the supervising one (3.15.1.3.5).
  if (state.step == Step::at_border && in.accepting_connected) out.report = in.reports;
  leave(state, in, out);
  if (in.one_session && state.step == Step::at_border && in.ended) {
    state.step = Step::handed_over;
    out.call_accepting = true;
  }
  if (state.step == Step::handed_over && state.contact_changed && state.rear_passed && in.ended) {
    out.over = true;
    state = {};
  }
  return out;
}

bool reported_to_accepting(State& state) {
  if (state.step != Step::at_border) return false;
  state.step = Step::handed_over;
  return true;
}

}  // namespace evc::procedures::rbc_handover
