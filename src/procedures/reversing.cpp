#include "procedures/reversing.h"

namespace evc::procedures::reversing {

Result step(const Inputs& in) {
  Result out;
  if (!in.stored.has_value()) return out;
  const Area& r = *in.stored;
  const bool mode = full_supervision(in.mode) || in.mode == Mode::LS || in.mode == Mode::OS;
  out.possible = mode && in.standstill && in.est_front >= r.start && in.est_front <= r.end;
  out.effects.requests.add(Ack::RV, out.possible && in.controller_backward);
  return out;
}

}  // namespace evc::procedures::reversing
