#include "protection/antenna.h"

namespace evc::protection {
namespace {

/// The longest way that the train can have run since, in either direction.
Distance run_since(const OdometerReading& then, const OdometerReading& now) {
  const Distance forward = now.max - then.max;
  const Distance backward = then.min - now.min;
  return forward > backward ? forward : backward;
}

bool ignored_by_mode(const AntennaSituation& s) {
  switch (s.mode) {
    case Mode::NP:
    case Mode::IS:
    case Mode::RV:
      return true;
    case Mode::SB:
      return s.srs == SrsVersion::v4_0_0 && level_1_2_3(s.level);
    default:
      return false;
  }
}

bool over(const track::BigMetalMass& mass, Place min_safe_antenna, Place max_safe_antenna) {
  return max_safe_antenna >= mass.from && min_safe_antenna <= mass.to;
}

/// 5.22.5.2.1: an area has begun on the way `run` since the inhibition began, which may have been over another one.
bool metal_begins(const track::Description& d, const AntennaSituation& s, Distance run) {
  for (const track::BigMetalMass& mass : d.big_metal) {
    const bool there = over(mass, s.min_safe_antenna, s.max_safe_antenna);
    if (there && s.max_safe_antenna - mass.from <= run) return true;
  }
  return false;
}

/// 5.22.5.1, 5.22.5.2.1: whether the inhibition is over.
bool inhibition_ends(const OdometerReading& from, const AntennaSituation& s, const track::Description& d) {
  const bool of_mode = s.mode == Mode::SB || s.mode == Mode::SH || s.mode == Mode::SR;
  const Distance run = run_since(from, s.counter);
  return !of_mode || run > D_METAL || metal_begins(d, s, run);
}

}  // namespace

bool over_metal(const track::Description& d, Place min_safe_antenna, Place max_safe_antenna) {
  for (const track::BigMetalMass& mass : d.big_metal)
    if (over(mass, min_safe_antenna, max_safe_antenna)) return true;
  return false;
}

bool asks_for_brake(AntennaAlarm& state, const AntennaSituation& s, const track::Description& d) {
  const bool in_metal = over_metal(d, s.min_safe_antenna, s.max_safe_antenna);
  if (state.inhibited && inhibition_ends(*state.inhibited, s, d)) state.inhibited.reset();
  const bool reacted = state.reacts;
  state.reacts = false;
  if (!s.alarm) {
    state.since.reset();
    return false;
  }
  if (!state.since) state.since = s.counter;
  if (ignored_by_mode(s) || state.inhibited || (in_metal && !reacted)) return false;
  state.reacts = level_1_2_3(s.level) || run_since(*state.since, s.counter) > D_METAL;
  return state.reacts;
}

}  // namespace evc::protection
