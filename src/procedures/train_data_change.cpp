#include "procedures/train_data_change.h"

namespace evc::procedures::train_data_change {
namespace {

/// S0: the modes of the procedure.
bool applies(Mode mode) {
  switch (mode) {
    case Mode::FS:
    case Mode::AD:
    case Mode::LS:
    case Mode::OS:
    case Mode::SR:
    case Mode::SB:
    case Mode::SN:
    case Mode::UN:
    case Mode::TR:
    case Mode::PT:
      return true;
    default:
      return false;
  }
}

bool in_trip(Mode mode) { return mode == Mode::TR || mode == Mode::PT; }

/// D3, D5: the change concerns an authority, in force or waiting.
bool concerns_authority(const Inputs& in) {
  switch (in.mode) {
    case Mode::FS:
    case Mode::AD:
    case Mode::LS:
    case Mode::OS:
      return true;
    case Mode::SB:
    case Mode::PT:
      return false;
    default:  // UN, SN, SR, TR
      return in.authority_waits;
  }
}

/// A1 and A7.
Step inform(Result& out) {
  out.effects.inform.add(Inform::train_data_changed);
  out.data = Fate::in_force;
  return Step::S0;
}

/// D0 to D9, when the change is noticed (E0).
Step begin(const Inputs& in, Result& out) {
  if (in.driver_validates) {  // D2, D9
    if (in_trip(in.mode)) return Step::S1;
    return in.standstill ? Step::S6 : Step::S4;
  }
  const bool brakes = in.route_matters && concerns_authority(in) && !in.standstill;  // D1, D3, D5, D7
  return brakes ? Step::S2 : inform(out);
}

Step next(Step step, const Inputs& in, Result& out) {
  switch (step) {
    case Step::S0:
      return in.pending && applies(in.mode) ? begin(in, out) : Step::S0;
    case Step::S1:  // D4; in SH the data are no longer valid (4.10)
      return in_trip(in.mode) ? Step::S1 : Step::S6;
    case Step::S2:
      if (in.driver_validates) return Step::S4;
      return in.standstill ? Step::S3 : Step::S2;
    case Step::S3:
      if (in.driver_validates) return Step::S5;
      if (in.brake_commanded) return Step::S3;
      out.data = Fate::in_force;  // A5, A7
      return Step::S0;
    case Step::S4:
      return in.standstill ? Step::S5 : Step::S4;
    case Step::S5:
      return in.brake_commanded ? Step::S5 : Step::S6;  // A6
    case Step::S6:
      break;
  }
  return Step::S6;
}

}  // namespace

Result step(State& state, const Inputs& in) {
  Result out;
  if (!in.pending) return out;
  if (in.driver_validated && state.step != Step::S0) {
    out.data = Fate::by_the_driver;
    state.step = Step::S0;
    return out;
  }
  if (!in.train_data_valid || (state.step == Step::S1 && in.mode == Mode::SH)) {
    out.data = Fate::to_validate;
    state.step = Step::S0;
    return out;
  }
  state.step = next(state.step, in, out);
  out.brake = state.step == Step::S2 || state.step == Step::S4;
  out.effects.entries.add(Entry::train_data, state.step == Step::S6 && applies(in.mode) && !in_trip(in.mode));
  return out;
}

}  // namespace evc::procedures::train_data_change
