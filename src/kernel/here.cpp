#include "kernel/here.h"

#include "kernel/manoeuvre.h"

namespace evc::kernel {

Distance length_of(const State& s) {
  // From the min safe front end to the min safe rear end (3.6.1.7 of 4.0.0).
  if (const auto consist = consist_of_train(s)) return consist->ahead.min + consist->behind.max;
  const bool engine = s.mode == Mode::SH || s.mode == Mode::SL || s.mode == Mode::NL || s.mode == Mode::PS ||
                      (s.mode == Mode::SB && !valid(s.data.train_data_status));
  return engine ? s.L_engine : s.train.L_TRAIN;
}

track::Here here(const State& state) {
  const PlaceInterval front = position::front(state.position);
  const PlaceInterval rear = front - length_of(state);
  const PlaceInterval antenna = position::antenna(state.position, L_antenna(state));
  track::Here h;
  h.est_front = front.est;
  h.min_safe_front = front.min;
  h.max_safe_front = front.max;
  h.min_safe_rear = rear.min;
  h.min_safe_antenna = antenna.min;
  h.max_safe_antenna = antenna.max;
  // 3.12.1.2.1.5: 3.x names no ends of the engine; the front end reaches the hole as every area, and leaves it.
  const bool v4 = state.srs == SrsVersion::v4_0_0;
  const Place engine =
      position::engine_front(state.position).est + (state.manoeuvre.opposite ? state.L_engine : Distance{});
  h.hole_front = v4 ? engine : front.max;
  h.hole_rear = v4 ? engine - state.L_engine : front.est;
  h.now = state.now;
  h.ran_back = v4 && position::last_motion(state.position) == position::Motion::backward;
  h.standstill = position::at_standstill(state.position);
  return h;
}

}  // namespace evc::kernel
