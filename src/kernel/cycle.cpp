#include "kernel/cycle.h"

namespace evc::kernel {

void note(Cycle& cycle, const Event& event) {
  if (cycle.out.events.push_back(event)) return;
  cycle.out.events.back() = Event{.subject = "events", .what = "lost: too many in one cycle"};
}

std::uint8_t M_MODE(modes::Mode mode) {
  using enum modes::Mode;
  switch (mode) {
    case FS:
      return 0;
    case OS:
      return 1;
    case SR:
      return 2;
    case SH:
      return 3;
    case UN:
      return 4;
    case SL:
      return 5;
    case SB:
      return 6;
    case TR:
      return 7;
    case PT:
      return 8;
    case SF:
      return 9;
    case IS:
      return 10;
    case NL:
      return 11;
    case LS:
      return 12;
    case SN:
      return 13;
    case RV:
      return 14;
    case PS:
      return 15;
    case NP:
      return 6;  // never reported: the unit has no power
  }
  return 9;
}

track::Here here(const State& state) {
  // Data may refer to the LRBG or to an unlinked group: the wider interval holds for both (3.6.4.7).
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

modes::Edition edition(train::SrsVersion srs) {
  return srs == train::SrsVersion::v4_0_0   ? modes::Edition::v4_0_0
         : srs == train::SrsVersion::v3_4_0 ? modes::Edition::v3_4_0
                                            : modes::Edition::v3_6_0;
}

}  // namespace evc::kernel
