#include "procedures/mode_profile.h"

namespace evc::procedures::mode_profile {
namespace {

Ack acknowledgement(Mode mode) { return mode == Mode::OS ? Ack::OS : mode == Mode::LS ? Ack::LS : Ack::SH; }

/// A shunting area has a start and no end (3.12.4.2).
bool ends_before(const Area& area, Place p) { return area.mode != Mode::SH && area.end.has_value() && p >= *area.end; }

bool holds(const Area& area, Place max_safe_front) {
  return max_safe_front >= area.start && !ends_before(area, max_safe_front);
}

bool overlaps(const Area& area, Place min_safe_front, Place max_safe_front) {
  return max_safe_front >= area.start && !ends_before(area, min_safe_front);
}

bool in_ack_length(const Area& area, Place est_front) {
  return est_front >= area.start - area.L_ack && est_front < area.start;
}

/// 3.x uses the max safe front end, 4.0.0 the furthest area that the confidence interval overlaps. From FS, LS and OS
/// the rule of 3.x is used. From SR, UN, SN, SB and PT it would give neither this mode nor FS to a train whose min safe
/// front end is still in the area; there the rule of 4.0.0 is used.
bool overlap_demands(const Inputs& in) {
  return in.srs == SrsVersion::v4_0_0 || (in.mode != Mode::FS && in.mode != Mode::LS && in.mode != Mode::OS);
}

/// From these modes the driver may acknowledge ahead of the area (4.6.2: [15], [50], [70]); from SR, UN, SN the train
/// enters FS or LS first.
bool may_acknowledge_ahead(Mode mode, Mode area) {
  return mode != area && (full_supervision(mode) || mode == Mode::LS || mode == Mode::OS);
}

/// The nearest area ahead that requires another mode.
const Area* next_area(const Inputs& in) {
  const Area* nearest = nullptr;
  for (const Area& area : in.areas) {
    if (in.max_safe_front >= area.start || !may_acknowledge_ahead(in.mode, area.mode)) continue;
    if (nearest == nullptr || area.start < nearest->start) nearest = &area;
  }
  return nearest;
}

/// 5.7.3, 5.9.3, 5.19.3: the request ahead of the area. Once shown, it stays even when the train leaves the window
/// again (5.7.3.3); it is for this area alone, and ends with it.
void ask_ahead(State& state, const Inputs& in, Result& out) {
  const Area* area = next_area(in);
  if (area == nullptr) return;
  const bool slow = in.srs == SrsVersion::v4_0_0 ? in.V_est <= area->V : in.V_est < area->V;
  if (!area->asked && !(slow && in_ack_length(*area, in.est_front))) return;
  state.asked = area->mode;
  out.asks_for = static_cast<std::size_t>(area - in.areas.data());
}

}  // namespace

Result step(State& state, const Inputs& in) {
  Result out;
  const Area* furthest = nullptr;
  for (const Area& area : in.areas) {
    out.front_in_OS_ack_area = out.front_in_OS_ack_area || (area.mode == Mode::OS && in_ack_length(area, in.est_front));
    out.front_in_LS_ack_area = out.front_in_LS_ack_area || (area.mode == Mode::LS && in_ack_length(area, in.est_front));
    if (!overlaps(area, in.min_safe_front, in.max_safe_front)) continue;
    out.in_force = true;
    if (furthest == nullptr || area.start > furthest->start) furthest = &area;
  }
  if (furthest != nullptr && (holds(*furthest, in.max_safe_front) || overlap_demands(in))) {
    out.demands_OS = furthest->mode == Mode::OS;
    out.demands_LS = furthest->mode == Mode::LS;
    out.demands_SH = furthest->mode == Mode::SH;
    out.at_front = furthest->mode;
  }
  if (state.unacknowledged) {
    if (in.acknowledged.has(acknowledgement(state.asked))) state.unacknowledged = false;
  } else {
    ask_ahead(state, in, out);
  }
  if (state.unacknowledged || out.asks_for) out.effects.requests.add(acknowledgement(state.asked));
  if (state.unacknowledged && in.now >= state.deadline) {
    out.overdue = state.asked;
  }
  return out;
}

void on_mode_change(State& state, Mode to, int condition, Duration now) {
  state = State{};
  switch (condition) {
    case 34:
    case 40:
    case 73:
    case 71:
    case 72:
    case 74:
    case 51:
    case 61:
      state.unacknowledged = true;
      state.asked = to;
      state.deadline = now + T_ACK;
      break;
    default:
      break;
  }
}

}  // namespace evc::procedures::mode_profile
