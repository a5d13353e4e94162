#include "kernel/here.h"

namespace evc::kernel {

track::Here here(const State& state) {
  const PlaceInterval front = position::front(state.position);
  const PlaceInterval rear = front - state.train.L_TRAIN;
  const PlaceInterval antenna = front - state.train.L_antenna_front;
  track::Here h;
  h.est_front = front.est;
  h.min_safe_front = front.min;
  h.max_safe_front = front.max;
  h.min_safe_rear = rear.min;
  h.min_safe_antenna = antenna.min;
  h.now = state.now;
  h.standstill = position::at_standstill(state.position);
  return h;
}

}  // namespace evc::kernel
