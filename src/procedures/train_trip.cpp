#include "procedures/train_trip.h"

namespace evc::procedures::train_trip {
namespace {

/// S120: the report of PT is repeated until the RBC recognises it, as long as there is a session.
Step wait_for_recognition(State& state, const Inputs& in, Effects& out) {
  if (!level_2_or_3(in.level)) return in.level == Level::L1 ? Step::S140 : Step::S120;
  if (in.exit_recognised && in.session_open) {
    state.repetition.stop();
    return Step::S130;
  }
  if (!in.session_open) {
    state.repetition.stop();
    return Step::S120;
  }
  if (!state.repetition.waiting) {  // A115
    state.repetition.start(in.now);
    out.send.add(Send::position_report);
    return Step::S120;
  }
  switch (state.repetition.due(in.now)) {
    case Repetition::Due::send_again:
      out.send.add(Send::position_report);
      return Step::S120;
    case Repetition::Due::give_up:
      out.send.add(Send::terminate_session);
      return Step::S121;
    default:
      return Step::S120;
  }
}

/// S150: the RBC answers the request. In another level it does not.
Step after_ma_request(State& state, const Inputs& in) {
  if (!in.session_open || !level_2_or_3(in.level)) return Step::S140;
  if (in.SR_authorised) return Step::S160;
  if (in.profile_at_front.has_value()) {
    state.profile = *in.profile_at_front;
    return Step::S170;
  }
  return Step::S150;
}

Step next(State& state, const Inputs& in, Effects& out) {
  switch (state.step) {
    case Step::S120:
      return wait_for_recognition(state, in, out);
    case Step::S121:
      return in.session_open && level_2_or_3(in.level) ? Step::S121 : Step::S120;
    case Step::S130:
      return in.emergency_stop_pending ? Step::S130 : Step::S140;
    case Step::S140:
      if (!in.selects_start || !in.train_data_valid) return Step::S140;
      if (in.level == Level::L1) return Step::S160;
      return level_2_or_3(in.level) && in.session_open ? Step::S150 : Step::S140;
    case Step::S150:
      return after_ma_request(state, in);
    default:  // S160, S170: an answer of the RBC is valid as long as the session, the newest one of S170 counts
      if (state.step == Step::S170 && in.profile_at_front.has_value()) state.profile = *in.profile_at_front;
      return level_2_or_3(in.level) && !in.session_open ? Step::S140 : state.step;
  }
}

Effects in_trip(State& state, const Inputs& in) {
  Effects out;
  if (state.step != Step::S050 && state.step != Step::S060) {
    out.send.add(Send::position_report, level_2_or_3(in.level));  // A030
  }
  state.step = in.standstill ? Step::S060 : Step::S050;
  out.requests.add(Ack::trip, state.step == Step::S060 && in.desk_open);
  return out;
}

void ask(const State& state, const Inputs& in, Effects& out) {
  switch (state.step) {
    case Step::S140:
      out.offers.add(Offer::shunting);
      out.offers.add(Offer::start, in.train_data_valid && (!level_2_or_3(in.level) || in.session_open));
      break;
    case Step::S160:
      out.requests.add(Ack::SR);
      break;
    case Step::S170:
      out.requests.add(state.profile == Mode::OS ? Ack::OS : state.profile == Mode::LS ? Ack::LS : Ack::SH);
      break;
    default:
      break;
  }
}

}  // namespace

Effects step(State& state, const Inputs& in) {
  if (in.mode == Mode::TR) return in_trip(state, in);
  if (in.mode != Mode::PT) {
    state = State{};
    return {};
  }
  Effects out;
  if (state.step == Step::S010 || state.step == Step::S050 || state.step == Step::S060) {  // A105, D110
    state = State{};
    state.step = Step::S120;
  }
  for (int k = 0; k < 8; ++k) {
    const Step before = state.step;
    state.step = next(state, in, out);
    if (state.step == before || state.step == Step::S121 || state.step == Step::S150) break;
  }
  ask(state, in, out);
  return out;
}

}  // namespace evc::procedures::train_trip
