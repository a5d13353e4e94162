#include "procedures/override.h"

namespace evc::procedures::override_ {
namespace {

void forget_former_eoa(State& state) {
  state.former_eoa.reset();
  state.virtual_front.reset();  // 3.6.7.4
}

/// Starts or restarts the supervision of override (5.8.3.1).
void start(State& state, const Inputs& in) {
  state.active = true;
  state.selected_outside_NTC = in.level != Level::NTC;
  state.since = in.now;
  state.start = in.odometer;
  state.sr_distance_end = in.mode == Mode::SR ? in.sr_distance_end : std::nullopt;
  switch (in.mode) {
    case Mode::FS:
    case Mode::AD:
    case Mode::LS:
    case Mode::OS:
      state.virtual_front.reset();
      state.former_eoa = in.eoa_or_loa;
      state.former_eoa_passed = false;
      break;
    case Mode::SB:
    case Mode::PT:
      state.virtual_front = in.counter;
      state.former_eoa = in.est_front;
      state.former_eoa_passed = false;
      break;
    default:  // in SR the former EOA does not change; SH, UN and SN have none
      break;
  }
}

/// 5.8.4.1: the end condition that is met, or none. In UN and SN only a and b are evaluated; in SH there is no SR
/// distance and no former EOA. In the cycle of the selection it is not known what came first: a stop counts as the
/// later one, and ends it; an authority as the earlier one, and does not.
Clause end_condition(const State& state, const Inputs& in, bool eoa_passes, bool started) {
  // By the national values of now: a running supervision goes on from the same start (3.18.2.11).
  if (in.now >= state.since + in.T_NVOVTRP) return "5.8.4.1 a"_srs;
  if (in.D_NVOVTRP.has_value() && in.odometer - state.start > *in.D_NVOVTRP) return "5.8.4.1 b"_srs;
  if (in.D_NVOVTRP.has_value() && state.start - in.odometer > *in.D_NVOVTRP) return "5.8.4.1 b"_srs;
  if (in.mode == Mode::UN || in.mode == Mode::SN) return {};
  if (eoa_passes) return "5.8.4.1 c"_srs;
  if (in.stop_if_in_SR || in.stop_if_in_SH) return "5.8.4.1 d"_srs;
  if (in.balise_proceed && !started) return "5.8.4.1 e"_srs;
  if (in.ma_from_rbc && !started && (in.level == Level::L2 || in.level == Level::L3)) return "5.8.4.1 f"_srs;
  if (in.group_not_in_list) return "5.8.4.1 g"_srs;
  if (state.sr_distance_end.has_value() && in.est_front > *state.sr_distance_end) return "5.8.4.1 h"_srs;
  return {};
}

}  // namespace

Result step(State& state, const Inputs& in) {
  Result out;
  if (in.selected) {
    start(state, in);
    out.started = true;
    // [37] leads from SB, FS, LS, OS and PT to SR; the mode table has it in no other cell.
    out.selected = true;
  }
  out.active = state.active;
  const bool eoa_passes =
      state.former_eoa.has_value() && !state.former_eoa_passed && in.min_safe_antenna > *state.former_eoa;
  if (eoa_passes) state.former_eoa_passed = true;
  // 4.6.3 [43] is the event of passing, with the override status at that time.
  out.former_eoa_passed = eoa_passes;
  if (state.active) {
    out.ended_by = end_condition(state, in, eoa_passes, out.started);
    if (out.ended_by) state.active = false;
  }
  // 5.8.3.1.3: a "stop if in SR" deletes the former EOA.
  if (in.stop_if_in_SR) forget_former_eoa(state);
  return out;
}

void on_mode_change(State& state, Mode to) {
  // 5.8.4.1 i: TR, LS, OS and SH end it. The other modes have no override (4.5.2): entering SB, FS, NL, ... ends it.
  if (to != Mode::SR && to != Mode::UN && to != Mode::SN) state.active = false;
  // It is of the SR that override leads to: not of a later one, where a trip came with the selection.
  if (to != Mode::SR) forget_former_eoa(state);
}

}  // namespace evc::procedures::override_
