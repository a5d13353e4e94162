#include "kernel/here.h"

namespace evc::kernel {

Distance length_of(const State& s) {
  const bool engine = s.mode == Mode::SH || s.mode == Mode::SL || s.mode == Mode::NL || s.mode == Mode::PS ||
                      (s.mode == Mode::SB && !valid(s.data.train_data_status));
  return engine ? s.L_engine : s.train.L_TRAIN;
}

track::Here here(const State& state) {
  const PlaceInterval front = position::front(state.position);
  const PlaceInterval rear = front - length_of(state);
  const PlaceInterval antenna = front - L_antenna(state);
  track::Here h;
  h.est_front = front.est;
  h.min_safe_front = front.min;
  h.max_safe_front = front.max;
  h.min_safe_rear = rear.min;
  h.min_safe_antenna = antenna.min;
  // 3.12.1.2.1.5: 3.x names no ends of the engine; the front end reaches the hole as every area, and leaves it.
  const bool v4 = state.srs == SrsVersion::v4_0_0;
  h.hole_front = v4 ? front.est : front.max;
  h.hole_rear = v4 ? front.est - state.L_engine : front.est;
  h.now = state.now;
  h.ran_back = v4 && position::last_motion(state.position) == position::Motion::backward;
  h.standstill = position::at_standstill(state.position);
  return h;
}

}  // namespace evc::kernel
