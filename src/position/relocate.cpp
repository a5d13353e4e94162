#include "position/parts.h"

// A group is passed: the position refers to it (3.6.1.4, 3.6.4).
namespace evc::position {
namespace {

Doubts doubts(const State& state, const Reference& reference) {
  const PlaceInterval at = interval(state, reference, state.now.counter);
  return {at.est - at.min, at.max - at.est};
}

Doubts least(const Doubts& a, const Doubts& b) {
  return {a.over < b.over ? a.over : b.over, a.under < b.under ? a.under : b.under};
}

/// 3.6.4.2.5 c of 4.0.0: a place keeps its distance to the safe front ends where that is the safe side.
Relocation travelled(Distance shift, const Doubts& before, const Doubts& after) {
  return {shift, at_least_zero(before.under - after.under), at_least_zero(before.over - after.over)};
}

/// Room for one more reference: the oldest one that was not reported is deleted first, because the RBC does not know
/// it; the last one, the LRBG, is kept.
void make_room(State& state) {
  auto& references = state.references;
  if (!references.full()) return;
  for (std::size_t i = 0; i + 1 < references.size(); ++i) {
    if (references[i].reported) continue;
    references.erase(i);
    return;
  }
  references.erase(0);
}

Reference reference_for(const State& state, const Passage& passage, Place place) {
  Reference reference;
  reference.id = passage.id;
  reference.counter = passage.counter;
  reference.place = place;
  reference.Q_LOCACC = passage.Q_LOCACC;
  reference.single = passage.single;
  reference.orientation = state.sense > 0 ? passage.counter_against_group : opposite(passage.counter_against_group);
  reference.counter_rising = counter_rises(state);
  return reference;
}

/// A group passed before: its data from reports and assignment are kept.
void take_over(Reference& reference, const Reference& earlier) {
  reference.reported = earlier.reported;
  reference.reported_with = earlier.reported_with;
  reference.reported_orientation = earlier.reported_orientation;
  reference.reported_ambiguously = earlier.reported_ambiguously;
  if (reference.orientation == Direction::unknown) reference.orientation = earlier.orientation;
}

/// 3.4.2.3.3: the pair with which a single group without orientation is reported.
void pair_up(const State& state, Reference& reference) {
  if (reference.orientation != Direction::unknown || state.references.empty()) return;
  const Reference& last = state.references.back();
  if (last.id == reference.id) {  // 3.4.2.3.3.5: read again, the pair is kept
    reference.previous = last.previous;
    reference.pair_orientation = last.pair_orientation;
    return;
  }
  if (last.counter_rising != reference.counter_rising) return;  // 3.4.2.3.3.4
  reference.previous = last.id;
  reference.pair_orientation = state.last_motion == Motion::forward ? Direction::nominal : Direction::reverse;
}

}  // namespace

Relocated relocate(State& state, const Passage& passage) {
  const Reference former = reference_of(state);
  const Doubts before = doubts(state, former);
  const Place estimated = in_track(state, passage.counter.nominal) - passage.L_antenna;
  const Place place = passage.link_place ? *passage.link_place : estimated;
  const Distance shift = place - estimated;
  state.offset += shift;
  // 3.6.1.4: neither a distance nor a movement (3.4.2.3.3.2) leads from the groups of an invalid position to this one.
  if (state.status == DataStatus::invalid) state.references.clear();
  Reference reference = reference_for(state, passage, place);
  const std::optional<std::size_t> known = index_of(state, passage.id);
  if (known) take_over(reference, state.references[*known]);
  pair_up(state, reference);
  if (known) state.references.erase(*known);
  make_room(state);
  EVC_REQUIRE(state.references.push_back(reference));
  const Doubts after = doubts(state, reference);
  Relocated out;
  out.by_linking = passage.link_place.has_value();
  const Distance run = magnitude(passage.counter.nominal - former.counter.nominal);
  const Distance explained = kOdometerOffset + kOdometerError * run + former.Q_LOCACC + passage.Q_LOCACC;
  out.out_of_tolerance = out.by_linking && magnitude(shift) > explained;
  out.unlinked = travelled(shift, {before.over - state.surplus.over, before.under - state.surplus.under}, after);
  out.travelled =
      out.by_linking ? Relocation{{}, 2.0 * former.Q_LOCACC, 2.0 * former.Q_LOCACC} : travelled(shift, before, after);
  state.unlinked.reset();
  state.surplus = {};
  state.status = DataStatus::valid;
  return out;
}

Relocated refer_to_unlinked(State& state, const Passage& passage) {
  const Place place = in_track(state, passage.counter.nominal) - passage.L_antenna;
  const Reference reference = reference_for(state, passage, place);
  const Doubts own = doubts(state, reference);
  const Doubts now = doubts(state, reference_of(state));
  Relocated out;
  if (state.references.empty()) {
    out.unlinked = travelled({}, now, own);
  } else {
    const Doubts more{at_least_zero(now.over - own.over), at_least_zero(now.under - own.under)};
    state.surplus = state.unlinked ? least(state.surplus, more) : more;
  }
  state.unlinked = reference;
  return out;
}

Relocation from_unlinked(const State& state) {
  if (!state.unlinked) return {};
  return travelled({}, doubts(state, *state.unlinked), doubts(state, reference_of(state)));
}

}  // namespace evc::position
