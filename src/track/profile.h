#pragma once
#include <cstddef>
#include <optional>

#include "base/inplace_vector.h"
#include "base/location.h"
#include "base/units.h"

namespace evc::track {

/// A continuous profile (3.6.3.2.2): a value is valid from its place to that of the next one; the last one has no end
/// unless it is the end-of-profile code. `Value` has `known()` and `Value::unknown()`; an unknown step is a hole or the
/// end of the profile. Steps are in order of place; two steps at one place are an element of length 0, which still
/// counts (3.6.3.2.2 e).
template <class Value, std::size_t N>
struct Profile {
  struct Step {
    Place from{};
    Value value{};
    Anchor anchor{};
    friend constexpr bool operator==(const Step&, const Step&) = default;
  };
  InplaceVector<Step, N> steps;

  constexpr bool empty() const { return steps.empty(); }

  /// Appends at the far end. When full, the profile ends at its last step: an MA that needs more is
  /// refused (3.7.2.3). False in that case, or when `from` is before the last step.
  constexpr bool append(Place from, const Value& value, Anchor anchor = {}) {
    if (!steps.empty() && from < steps.back().from) return false;
    if (steps.push_back({from, value, anchor})) return true;
    steps.back().value = Value::unknown();
    return false;
  }
  /// New data replace the stored ones from their start on; before it the old ones are kept (3.7.3.1 a, b).
  template <std::size_t M>
  constexpr bool replace_from(const Profile<Value, M>& fresh) {
    if (fresh.empty()) return true;
    const Place start = fresh.steps.front().from;
    while (!steps.empty() && steps.back().from >= start) steps.pop_back();
    bool all = true;
    for (const auto& step : fresh.steps) all = append(step.from, step.value, step.anchor) && all;
    return all;
  }
  /// Whether there is room for replace_from(fresh).
  template <std::size_t M>
  constexpr bool has_room_for(const Profile<Value, M>& fresh) const {
    if (fresh.empty()) return true;
    std::size_t kept = 0;
    while (kept < steps.size() && steps[kept].from < fresh.steps.front().from) ++kept;
    return kept + fresh.steps.size() <= N;
  }
  /// Deletes everything from `at` on (A.3.4): the profile ends there. Returns whether anything known was deleted.
  constexpr bool cut(Place at) {
    bool known_beyond = false;
    bool ended_there = false;  // a step begins exactly at the cut
    while (!steps.empty() && steps.back().from >= at) {
      known_beyond = known_beyond || steps.back().value.known();
      ended_there = steps.back().from == at;
      steps.pop_back();
    }
    if (steps.empty() || !steps.back().value.known()) return known_beyond;
    append(at, Value::unknown());
    return known_beyond || !ended_there;
  }
  /// Deletes the steps that lie completely behind `limit` (A.3.6).
  constexpr void forget_before(Place limit) {
    std::size_t gone = 0;
    while (gone + 1 < steps.size() && steps[gone + 1].from <= limit) ++gone;
    if (gone > 0) steps.erase(0, gone);
  }
  /// Nothing is known in rear of `at` any more.
  constexpr void begin_at(Place at) {
    forget_before(at);
    if (!steps.empty() && steps.front().from < at) steps.front().from = at;
  }
  /// Whether the profile has a known value at every place of [from, to).
  constexpr bool covers(Place from, Place to) const {
    if (steps.empty() || steps.front().from > from) return false;
    for (std::size_t i = 0; i < steps.size() && steps[i].from < to; ++i) {
      const bool behind = i + 1 < steps.size() && steps[i + 1].from <= from;
      if (!steps[i].value.known() && !behind) return false;
    }
    return true;
  }
  /// The first place from `from` on at which a step says that nothing is known.
  constexpr std::optional<Place> unknown_from(Place from) const {
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const bool behind = i + 1 < steps.size() && steps[i + 1].from <= from;
      if (!steps[i].value.known() && !behind) return steps[i].from > from ? steps[i].from : from;
    }
    return std::nullopt;
  }
  /// The value at `x`; absent before the first step and where nothing is known.
  constexpr std::optional<Value> at(Place x) const {
    std::optional<Value> found;
    for (const Step& step : steps) {
      if (step.from > x) break;
      found = step.value;
    }
    if (found && !found->known()) found.reset();
    return found;
  }
  friend constexpr bool operator==(const Profile&, const Profile&) = default;
};

/// Whether `stored`, replaced from the start of `fresh` on, would cover [from, to) (3.7.2.3: stored data and data of
/// the same message count together).
template <class Value, std::size_t N, std::size_t M>
constexpr bool covers_together(const Profile<Value, N>& stored, const Profile<Value, M>& fresh, Place from, Place to) {
  if (fresh.empty()) return stored.covers(from, to);
  const Place start = fresh.steps.front().from;
  if (start <= from) return fresh.covers(from, to);
  if (start >= to) return stored.covers(from, to);
  return stored.covers(from, start) && fresh.covers(start, to);
}

}  // namespace evc::track
