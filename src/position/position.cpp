#include "position/position.h"

#include "position/parts.h"

namespace evc::position {
namespace {

/// The bounds at `at`, at a distance from a reading: the increments may be wrong by kOdometerError.
OdometerReading away_from(const OdometerReading& reading, OdometerPlace at) {
  const Distance d = at - reading.nominal;
  const Distance error = kOdometerError * magnitude(d);
  return {at, reading.min + d + error, reading.max + d - error};
}

/// The reference of a position without LRBG.
Reference since_power_up(const State& state) {
  Reference origin;
  origin.counter = state.origin;
  return origin;
}

void mirror(Reference& reference) {
  reference.place = Place{-reference.place.from_origin};
  reference.orientation = opposite(reference.orientation);
  reference.pair_orientation = opposite(reference.pair_orientation);
  reference.reported_orientation = opposite(reference.reported_orientation);
}

constexpr Motion turned(Motion m) { return m == Motion::forward ? Motion::backward : Motion::forward; }

}  // namespace

PlaceInterval interval(const State& state, const Reference& reference, const OdometerReading& counter) {
  const bool grows = state.sense > 0;
  const OdometerReading& from = reference.counter;
  const Distance run = state.sense * (counter.nominal - from.nominal);
  const Distance least = grows ? counter.min - from.min : from.max - counter.max;
  const Distance most = grows ? counter.max - from.max : from.min - counter.min;
  // 3.6.4.2: over-reading lies behind, under-reading ahead of the estimated front end.
  const Distance over = reference.Q_LOCACC + at_least_zero(run - least);
  const Distance under = reference.Q_LOCACC + at_least_zero(most - run);
  const Place est = in_track(state, counter.nominal);
  return {est - over, est, est + under};
}

Reference reference_of(const State& state) {
  if (!state.references.empty()) return state.references.back();
  return state.unlinked ? *state.unlinked : since_power_up(state);
}

std::optional<std::size_t> index_of(const State& state, GroupId id) {
  for (std::size_t i = state.references.size(); i-- > 0;)
    if (state.references[i].id == id) return i;
  return std::nullopt;
}

Odometry extrapolated(const Odometry& odometry, Duration age) {
  Odometry out = odometry;
  out.counter.nominal = out.counter.nominal + odometry.V_est * age;
  out.counter.min = out.counter.min + odometry.V_min * age;
  out.counter.max = out.counter.max + odometry.V_max * age;
  return out;
}

void update(State& state, const Odometry& odometry, Duration now, bool estimated) {
  const OdometerPlace at = odometry.counter.nominal;
  if (!state.started) {
    state.started = true;
    state.before = odometry;
    state.origin = odometry.counter;
    state.extreme = at;
    state.rest = at;
    state.rest_since = now;
    count_from(state, odometry.counter);
  } else {
    state.before = state.now;
  }
  state.now = odometry;
  state.time_before = state.time;
  state.time = now;
  if (estimated) {  // it shows movement: one that shows standstill is not extrapolated
    state.rest_since = now;
    return;
  }

  const double ahead = state.last_motion == Motion::forward ? state.sense : -state.sense;
  const Distance gained = ahead * (at - state.extreme);
  if (gained.si > 0) state.extreme = at;
  if (gained < -kTurnDistance) {
    state.last_motion = turned(state.last_motion);
    state.extreme = at;
  }
  const bool fast = odometry.V_est > kStandstillSpeed || odometry.V_est < -kStandstillSpeed;
  if (fast || magnitude(at - state.rest) > kStandstillDistance) {
    state.rest = at;
    state.rest_since = now;
  }
}

OdometerPlace counter_at(const State& state, Duration time) {
  const Duration cycle = state.time - state.time_before;
  const Duration since = time - state.time_before;
  if (since.si < 0.0 || !(cycle.si > 0.0)) return state.before.counter.nominal + state.before.V_est * since;
  const Distance run = state.now.counter.nominal - state.before.counter.nominal;
  return state.before.counter.nominal + (since.si / cycle.si) * run;
}

OdometerReading reading_at(const State& state, OdometerPlace at) {
  const OdometerReading& a = state.before.counter;
  const OdometerReading& b = state.now.counter;
  const Distance whole = b.nominal - a.nominal;
  const Distance part = at - a.nominal;
  if (at == b.nominal) return b;
  if (part.si * whole.si >= 0 && magnitude(part) <= magnitude(whole)) {
    if (part.si == 0) return a;
    const double f = part.si / whole.si;
    return {at, a.min + f * (b.min - a.min), a.max + f * (b.max - a.max)};
  }
  return away_from(magnitude(at - b.nominal) < magnitude(part) ? b : a, at);
}

const Reference* lrbg(const State& state) { return state.references.empty() ? nullptr : &state.references.back(); }

PlaceInterval front(const State& state) { return front_at(state, state.now.counter); }

OdometerPlace forward_counter(const State& state) {
  return OdometerPlace{state.sense * state.now.counter.nominal.from_origin};
}

PlaceInterval front_at(const State& state, const OdometerReading& counter) {
  const PlaceInterval engine = engine_front_at(state, counter);
  return {engine.min + state.ahead.min, engine.est + state.ahead.est, engine.max + state.ahead.max};
}

PlaceInterval engine_front(const State& state) { return engine_front_at(state, state.now.counter); }

PlaceInterval engine_front_at(const State& state, const OdometerReading& counter) {
  const Reference* reference = lrbg(state);
  return reference ? interval(state, *reference, counter) : interval(state, reference_of(state), counter);
}

Way way_since(const State& state, const OdometerReading& from) {
  Reference start;  // known exactly
  start.counter = from;
  const PlaceInterval now = interval(state, start, state.now.counter);
  return {now.est - in_track(state, from.nominal), now.est - now.min, now.max - now.est};
}

Distance L_DOUBTOVER(const State& state) {
  const PlaceInterval at = front(state);
  return at.est - at.min;
}

Distance L_DOUBTUNDER(const State& state) {
  const PlaceInterval at = front(state);
  return at.max - at.est;
}

Place place_of(const State& state, OdometerPlace counter) { return in_track(state, counter); }

OdometerPlace counter_of(const State& state, Place place) {
  return OdometerPlace{state.sense * (place.from_origin - state.offset)};
}

std::optional<Place> place_of(const State& state, GroupId id) {
  const Reference* reference = find(state, id);
  if (reference == nullptr) return std::nullopt;
  return reference->place;
}

const Reference* find(const State& state, GroupId id) {
  const std::optional<std::size_t> i = index_of(state, id);
  return i ? &state.references[*i] : nullptr;
}

Motion motion(const State& state) { return at_standstill(state) ? Motion::standstill : state.last_motion; }
Motion last_motion(const State& state) { return state.last_motion; }

bool at_standstill(const State& state) { return state.started && state.time - state.rest_since >= kStandstillTime; }

bool counter_rises(const State& state) { return (state.last_motion == Motion::forward) == (state.sense > 0); }

Direction orientation(const State& state) {
  const Reference* reference = lrbg(state);
  return reference ? reference->orientation : Direction::unknown;
}

Direction running_direction(const State& state) {
  const Direction cab = orientation(state);
  return state.last_motion == Motion::forward ? cab : opposite(cab);
}

Direction side(const State& state) {
  const Reference* reference = lrbg(state);
  if (reference == nullptr) return Direction::unknown;
  const Distance ahead = front(state).est - reference->place;
  return ahead.si >= 0 ? reference->orientation : opposite(reference->orientation);
}

bool assign_orientation(State& state, GroupId id, Direction q_orientation) {
  const std::optional<std::size_t> i = index_of(state, id);
  if (!i || q_orientation == Direction::unknown) return false;
  Reference& reference = state.references[*i];
  if (!reference.single || !reference.reported_with || reference.reported_ambiguously) return false;
  const Direction pair = reference.reported_orientation;
  reference.orientation = q_orientation == Direction::nominal ? pair : opposite(pair);
  return true;
}

void change_cab(State& state, Distance L_engine) {
  turn(state);
  state.offset = state.offset + L_engine;
}

void turn(State& state) {
  state.sense = -state.sense;
  state.offset = -state.offset;
  for (Reference& reference : state.references) mirror(reference);
  if (state.unlinked) mirror(*state.unlinked);
  state.surplus = {state.surplus.under, state.surplus.over};
  state.last_motion = turned(state.last_motion);
}

void invalidate(State& state) {
  if (state.status == DataStatus::valid) state.status = DataStatus::invalid;
}

void validate(State& state) {
  if (!state.references.empty()) state.status = DataStatus::valid;
}

void forget(State& state) {
  state.references.clear();
  state.unlinked.reset();
  state.surplus = {};
  state.status = DataStatus::unknown;
}

}  // namespace evc::position
