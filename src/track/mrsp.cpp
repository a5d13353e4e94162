#include <algorithm>

#include "track/services.h"

namespace evc::track {
namespace {

/// The end of a restriction without an end: farther than any stored place.
constexpr Place kFar{Distance{1.0e9}};

/// An element without length counts where it is (3.6.3.2.2 e).
constexpr Distance kLeast{0.1};
Place end_of(Place from, Place to) { return to > from ? to : from + kLeast; }

/// Makes room for one step: merges the two steps at the far end at their lower speed.
void merge_last(Mrsp& f) {
  const Speed last = f.steps.back().value;
  f.steps.pop_back();
  if (last < f.steps.back().value) f.steps.back().value = last;
}

/// Splits the function at `x` and returns the index of the step that starts there.
std::size_t split(Mrsp& f, Place x) {
  std::size_t i = f.index_at(x);
  if (f.steps[i].from >= x) return i;
  if (f.steps.full()) merge_last(f);
  if (i >= f.size()) i = f.size() - 1;
  const Mrsp::Step step{x, f.steps[i].value};
  return f.steps.insert(i + 1, step) ? i + 1 : i;
}

/// Lowers the function to at most `v` in [from, to).
void lower(Mrsp& f, Place from, Place to, Speed v) {
  if (to <= f.steps.front().from || to <= from) return;
  if (from < f.steps.front().from) from = f.steps.front().from;
  bool needed = false;
  for (std::size_t i = f.index_at(from); i < f.size() && f.steps[i].from < to; ++i)
    needed = needed || f.steps[i].value > v;
  if (!needed) return;
  if (to < kFar) (void)split(f, to);
  const std::size_t first = split(f, from);
  for (std::size_t i = first; i < f.size() && f.steps[i].from < to; ++i)
    if (f.steps[i].value > v) f.steps[i].value = v;
}

/// Merges neighbours of equal speed.
void join_equal(Mrsp& f) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (kept > 0 && f.steps[kept - 1].value == f.steps[i].value) continue;
    f.steps[kept] = f.steps[i];
    ++kept;
  }
  while (f.size() > kept) f.steps.pop_back();
}

void lower_by_ssp(Mrsp& f, const Description& d, const MrspQuery& q) {
  const auto& steps = d.ssp.steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!steps[i].value.known()) continue;
    const bool last = i + 1 == steps.size();
    const Speed v = speed_of(steps[i].value.speed_for(q.category));
    Place to = last ? kFar : steps[i + 1].from;
    // Up to the place where the rear end has left the element; before a lower speed this makes no difference
    // (3.11.3.1.3).
    if (!last && !steps[i].value.Q_FRONT) to = to + q.train_length;
    lower(f, steps[i].from, end_of(steps[i].from, to), v);
  }
}

template <class Areas, class SpeedOf>
void lower_by_areas(Mrsp& f, const Areas& areas, Distance delay, SpeedOf speed) {
  for (const auto& area : areas) {
    const SpeedCode code = speed(area);
    const Place to = area.Q_FRONT ? area.to : area.to + delay;
    if (code != kNoSpeed) lower(f, area.from, end_of(area.from, to), speed_of(code));
  }
}

}  // namespace

void mrsp(Mrsp& f, const Description& d, const MrspQuery& query) {
  f.steps.clear();
  (void)f.append(query.from, kNoLimit);
  for (const Limit& limit : query.limits)
    lower(f, limit.from ? *limit.from : query.from, limit.to ? *limit.to : kFar, limit.V);
  const MrspElements& counts = query.elements;
  if (counts.ssp) lower_by_ssp(f, d, query);
  if (counts.asp)
    lower_by_areas(f, d.asp, query.train_length,
                   [&](const AxleLoadRestriction& a) { return a.speed_for(query.category); });
  if (counts.tsr)
    lower_by_areas(f, d.tsr, query.train_length, [](const TemporarySpeedRestriction& t) { return t.V_TSR; });
  if (counts.pbd)
    for (std::size_t i = 0; i < d.pbd.size() && i < query.pbd_speeds.size(); ++i)
      if (query.pbd_speeds[i] != kNoSpeed)
        lower(f, d.pbd[i].from, end_of(d.pbd[i].from, d.pbd[i].to), speed_of(query.pbd_speeds[i]));
  if (counts.lx)
    for (const LevelCrossing& lx : d.lx)
      if (lx.unprotected && lx.substituted) lower(f, lx.V_LX_from, lx.to, speed_of(lx.V_LX));
  if (counts.signalling)
    for (const SignallingSpeed& s : d.signalling) lower(f, s.from, s.to ? *s.to : kFar, speed_of(s.V_MAIN));
  join_equal(f);
}

void gradient(GradientFunction& f, const Description& d, Place from, double unknown) {
  f.steps.clear();
  const auto& steps = d.gradient.steps;
  const auto value_of = [&](std::size_t k) {
    return steps[k].value.known() ? static_cast<double>(steps[k].value.permille) : unknown;
  };
  const auto add = [&](Place at, double value) {
    // There is one step too many only if the profile begins beyond `from`: keep the lower one.
    if (!f.append(at, value) && value < f.steps.back().value) f.steps.back().value = value;
  };
  std::size_t i = 0;
  while (i + 1 < steps.size() && steps[i + 1].from <= from) ++i;
  if (steps.empty() || steps[i].from > from) (void)f.append(from, unknown);
  for (; i < steps.size(); ++i) {
    const Place at = steps[i].from;
    double lowest = value_of(i);
    for (; i + 1 < steps.size() && steps[i + 1].from <= at; ++i) lowest = std::min(lowest, value_of(i + 1));
    add(at, lowest);
    if (lowest == value_of(i)) continue;
    const Place after = at + kLeast;
    add(i + 1 < steps.size() && steps[i + 1].from < after ? steps[i + 1].from : after, value_of(i));
  }
}

}  // namespace evc::track
