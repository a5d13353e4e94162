#include "protection/movement.h"

namespace evc::protection {
namespace {

Distance moved(const Movement& m, OdometerPlace from, Way way) {
  return way == Way::backward ? from - m.nominal : m.nominal - from;
}

/// The forbidden directions: none, one or both.
struct Forbidden {
  bool forward = false, backward = false;
};

Forbidden against_controller(const Movement& m) {
  if (!m.controller) return {};  // without the interface there is no roll away protection (3.14.2.3)
  return {*m.controller != Way::forward, *m.controller != Way::backward};
}

/// The reference follows the train while its movement is allowed; forbidden movement is measured from its start.
/// Movement back towards the reference reduces the distance.
void supervise(DistanceGuard& g, Cause cause, const Forbidden& forbidden, const Movement& m) {
  if (g.braking) {
    if (m.standstill && m.acknowledged.has(cause)) g = {m.nominal, false};
    return;
  }
  if (!g.reference) g.reference = m.nominal;
  Distance forward = moved(m, *g.reference, Way::forward);
  if ((forward > Distance{} && !forbidden.forward) || (forward < Distance{} && !forbidden.backward)) {
    g.reference = m.nominal;
    forward = {};
  }
  const Distance away = forward < Distance{} ? -forward : forward;
  g.braking = m.D_NVROLL && away > *m.D_NVROLL;
}

/// PT distance and reversing distance: beyond it the brake is commanded; after standstill and acknowledgement any
/// further movement backwards beyond it brakes again, also one that follows a movement forward (4.4.14.1.3.2,
/// 4.4.18.1.4): the place it is measured from follows the train forward.
void supervise_end(bool beyond, Cause cause, bool& braking, std::optional<OdometerPlace>& released_at,
                   const Movement& m) {
  if (braking) {
    if (m.standstill && m.acknowledged.has(cause)) {
      braking = false;
      released_at = m.nominal;
    }
    return;
  }
  if (!beyond) {
    released_at.reset();
    return;
  }
  if (!released_at || m.nominal < *released_at) {
    braking = true;
    return;
  }
  released_at = m.nominal;
}

}  // namespace

GuardSelection guards_of(Mode mode) {
  GuardSelection s;
  s.standstill = mode == Mode::SB;
  s.post_trip = mode == Mode::PT;
  s.reversing = mode == Mode::RV;
  s.reverse_movement = supervises_authority(mode) || mode == Mode::SR || mode == Mode::PT || mode == Mode::RV;
  s.roll_away = s.reverse_movement || mode == Mode::SH || mode == Mode::UN;
  return s;
}

Commands guard(MovementGuards& g, const GuardSelection& selection, const Movement& m) {
  Commands c;
  const Forbidden against_permitted{m.permitted == Way::backward, m.permitted == Way::forward};
  if (selection.roll_away) supervise(g.roll_away, Cause::roll_away, against_controller(m), m);
  if (selection.reverse_movement) {
    supervise(g.reverse_movement, Cause::reverse_movement, against_permitted, m);
  }
  if (selection.standstill) supervise(g.standstill, Cause::standstill, {true, true}, m);
  if (selection.post_trip) {
    if (!g.post_trip_from) g.post_trip_from = m.nominal;
    const bool beyond = m.D_NVPOTRP && moved(m, *g.post_trip_from, Way::backward) > *m.D_NVPOTRP;
    supervise_end(beyond, Cause::post_trip_distance, g.post_trip_braking, g.post_trip_released_at, m);
  }
  if (selection.reversing) {
    const bool beyond = m.reversing_left && *m.reversing_left < Distance{};
    // A longer distance ends the cause at once (3.14.1.7.1).
    if (!beyond) g.reversing_braking = false;
    supervise_end(beyond, Cause::reversing_distance, g.reversing_braking, g.reversing_released_at, m);
  }
  c.roll_away = g.roll_away.braking;
  c.reverse_movement = g.reverse_movement.braking;
  c.standstill = g.standstill.braking;
  c.post_trip = g.post_trip_braking;
  c.reversing = g.reversing_braking;
  return c;
}

void turn(MovementGuards& g) {
  for (std::optional<OdometerPlace>* place :
       {&g.roll_away.reference, &g.reverse_movement.reference, &g.standstill.reference, &g.post_trip_from,
        &g.post_trip_released_at, &g.reversing_released_at})
    if (*place) **place = OdometerPlace{-(**place).from_origin};
}

void enter_mode(MovementGuards& g, const GuardSelection& selection, OdometerPlace nominal) {
  if (!selection.roll_away) g.roll_away = {};
  if (!selection.reverse_movement) g.reverse_movement = {};
  if (!selection.standstill) g.standstill = {};
  // The permitted direction changes on entry and exit of PT and RV (4.12).
  const bool turned = selection.post_trip || selection.reversing || g.post_trip_from.has_value();
  if (turned) g.reverse_movement = {};
  g.post_trip_braking = false;
  g.post_trip_released_at.reset();
  g.post_trip_from.reset();
  if (selection.post_trip) g.post_trip_from = nominal;
  g.reversing_braking = false;
  g.reversing_released_at.reset();
}

}  // namespace evc::protection
