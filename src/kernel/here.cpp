#include "kernel/here.h"

namespace evc::kernel {

track::Here here(const State& state) {
  // Data may refer to the LRBG or to an unlinked group: the wider interval is valid for both (3.6.4.7).
  const PlaceInterval front = position::widest_front(state.position);
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
