#include "procedures/reversing.h"

namespace evc::procedures::reversing {

Result step(const Inputs& in) {
  Result out;
  if (!in.stored.has_value()) return out;
  const Reversing& r = *in.stored;
  if (in.mode == Mode::RV) {
    out.distance_passed = r.D_REVERSE.has_value() && in.est_front < r.reference - *r.D_REVERSE;
    return out;
  }
  const bool mode = in.mode == Mode::FS || in.mode == Mode::LS || in.mode == Mode::OS;
  out.possible = mode && in.standstill && in.est_front >= r.start && in.est_front <= r.end;
  out.effects.requests.add(Ack::RV, out.possible && in.controller_backward);
  return out;
}

}  // namespace evc::procedures::reversing
