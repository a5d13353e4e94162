#include "protection/antenna.h"

namespace evc::protection {
namespace {

/// The longest way that the train can have run since, in either direction.
Distance run_since(const OdometerReading& then, const OdometerReading& now) {
  const Distance forward = now.max - then.max;
  const Distance backward = then.min - now.min;
  return forward > backward ? forward : backward;
}

bool over_metal(const track::Description& d, const AntennaSituation& s) {
  for (const track::BigMetalMass& mass : d.big_metal)
    if (s.max_safe_antenna >= mass.from && s.min_safe_antenna <= mass.to) return true;
  return false;
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

}  // namespace

bool asks_for_brake(AntennaAlarm& state, const AntennaSituation& s, const track::Description& d) {
  if (!s.alarm) {
    state.since.reset();
    return false;
  }
  if (!state.since) state.since = s.counter;
  if (ignored_by_mode(s) || over_metal(d, s)) return false;
  return level_1_2_3(s.level) || run_since(*state.since, s.counter) > D_METAL;
}

}  // namespace evc::protection
