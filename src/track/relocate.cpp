#include "track/relocate.h"

#include "track/areas.h"

namespace evc::track {
namespace {

/// Each overload moves the places of one kind of data, as Table 2a of 4.0.0 has them.
class Mover {
 public:
  Mover(Anchor of, Anchor then, const Relocation& by) : of_(of), then_(then), by_(by) {}

  bool moved() const { return moved_; }

  template <class T>
  void item(T& data) {
    if (data.anchor != of_) return;
    data.anchor = then_;
    moved_ = true;
    move(data);
  }
  template <class T>
  void item(std::optional<T>& data) {
    if (data) item(*data);
  }
  template <class T, std::size_t N>
  void items(InplaceVector<T, N>& list) {
    for (T& data : list) item(data);
  }
  template <class Value, std::size_t N>
  void profile(Profile<Value, N>& stored);

 private:
  Place start(Place at) const { return at + (by_.shift - by_.nearer); }
  Place end(Place at) const { return at + (by_.shift + by_.farther); }
  Place estimated(Place at) const { return at + by_.shift; }
  Place nearest(Place at) const { return at + (by_.shift - (by_.nearer > by_.farther ? by_.nearer : by_.farther)); }
  void estimated(std::optional<Place>& at) const {
    if (at) at = estimated(*at);
  }

  template <class Area>
  void move(Area& area) const {
    area.from = start(area.from);
    area.to = end(area.to);
  }
  void move(TrackCondition& condition) const;
  void move(LevelCrossing& lx) const {
    lx.from = nearest(lx.from);
    lx.to = end(lx.to);
    lx.V_LX_from = nearest(lx.V_LX_from);
  }
  void move(ModeArea& area) const {
    area.from = nearest(area.from);
    area.ack_from = nearest(area.ack_from);
    if (area.to) area.to = end(*area.to);
  }
  void move(TractionChange& change) const { change.at = nearest(change.at); }
  void move(CurrentChange& change) const { change.at = nearest(change.at); }
  void move(RouteSuitability& item) const { item.at = nearest(item.at); }
  void move(RbcTransition& order) const { order.at = estimated(order.at); }
  void move(RadioInfillArea& area) const { area.at = estimated(area.at); }
  void move(ReversingArea& area) const {
    area.from = estimated(area.from);
    area.to = estimated(area.to);
  }
  void move(GeoReference& reference) const { estimated(reference.applies_from); }
  void move(Text& text) const {
    estimated(text.start_at);
    estimated(text.end_at);
  }
  void move(MovementAuthority& ma) const;

  template <class P, class Step>
  void append(P& profile, const Step& step) const;

  Anchor of_, then_;
  Relocation by_;
  bool moves_ = by_.shift != Distance{} || by_.nearer != Distance{} || by_.farther != Distance{};
  bool moved_ = false;
};

void Mover::move(TrackCondition& condition) const {
  using enum TrackConditionKind;
  const bool by_estimate =
      condition.kind == radio_hole || condition.kind == tunnel_stopping_area || condition.kind == sound_horn;
  condition.from = by_estimate ? estimated(condition.from) : start(condition.from);
  condition.to = by_estimate ? estimated(condition.to) : end(condition.to);
}

void Mover::move(MovementAuthority& ma) const {
  for (Section& section : ma.sections) {
    section.begin = nearest(section.begin);
    section.end = nearest(section.end);
    section.stop = end(section.stop);  // compared with the min safe front end (3.8.4.2.3)
  }
  if (ma.end_section) ma.end_section->start = nearest(ma.end_section->start);
  if (ma.danger_point) ma.danger_point->at = nearest(ma.danger_point->at);
  if (ma.overlap) {
    ma.overlap->start = nearest(ma.overlap->start);
    ma.overlap->end = nearest(ma.overlap->end);
  }
  if (ma.fixed_SvL) ma.fixed_SvL = nearest(*ma.fixed_SvL);
}

// --- Continuous profiles

enum class Change : std::uint8_t { none, lower, higher, mixed };

/// The speeds of an element for all trains.
struct Range {
  SpeedCode lowest, highest;
};
Range range_of(const StaticSpeed& element) {
  Range range{element.V_STATIC, element.V_STATIC};
  const auto widen = [&range](SpeedCode V) {
    if (V == kNoSpeed) return;
    range.lowest = V < range.lowest ? V : range.lowest;
    range.highest = V > range.highest ? V : range.highest;
  };
  for (const SpeedCode V : element.cd) widen(V);
  for (const SpeedCode V : element.other) widen(V);
  return range;
}

Change change(const StaticSpeed& from, const StaticSpeed& to) {
  if (from == to) return Change::none;
  const Range a = range_of(from), b = range_of(to);
  if (b.highest <= a.lowest) return Change::lower;
  return b.lowest >= a.highest ? Change::higher : Change::mixed;
}
Change change(const Gradient& from, const Gradient& to) {
  if (from == to) return Change::none;
  return to.permille < from.permille ? Change::lower : Change::higher;
}

/// Not above either of two elements, for any train.
StaticSpeed below(const StaticSpeed& a, const StaticSpeed& b) {
  StaticSpeed element;
  const SpeedCode of_a = range_of(a).lowest, of_b = range_of(b).lowest;
  element.V_STATIC = of_a < of_b ? of_a : of_b;
  return element;
}
Gradient below(const Gradient& a, const Gradient& b) { return a.permille < b.permille ? a : b; }

/// A step at `from`, or at the one before it where that is farther.
template <class P, class Value>
void append_not_before(P& profile, Place from, const Value& value, Anchor anchor) {
  if (!profile.empty() && profile.steps.back().from > from) from = profile.steps.back().from;
  (void)profile.append(from, value, anchor);  // without room the profile ends there: never less restrictive
}

template <class P, class Step>
void Mover::append(P& profile, const Step& step) const {
  const Place nearer = start(step.from);
  Change how = Change::lower;  // after an unknown part
  while (!profile.empty()) {
    const auto& before = profile.steps.back();
    how = before.value.known() && step.value.known() ? change(before.value, step.value) : Change::lower;
    // Higher parts that the lower one overtakes are dropped (3.6.4.2.6 of 4.0.0).
    const bool overtaken = how == Change::lower && before.from > nearer && before.value.known() && step.value.known();
    if (!overtaken) break;
    profile.steps.pop_back();
  }
  if (profile.empty()) return append_not_before(profile, nearer, step.value, then_);
  if (!step.value.known()) return append_not_before(profile, estimated(step.from), step.value, then_);
  if (how == Change::mixed) append_not_before(profile, nearer, below(profile.steps.back().value, step.value), then_);
  const bool farther = how == Change::higher || how == Change::mixed;
  append_not_before(profile, farther ? end(step.from) : nearer, step.value, then_);
}

template <class Value, std::size_t N>
void Mover::profile(Profile<Value, N>& stored) {
  bool any = false;
  for (const auto& step : stored.steps) any = any || step.anchor == of_;
  if (!any) return;
  moved_ = true;
  if (!moves_) {
    for (auto& step : stored.steps)
      if (step.anchor == of_) step.anchor = then_;
    return;
  }
  const Profile<Value, N> old = stored;
  stored.steps.clear();
  for (const auto& step : old.steps) {
    if (step.anchor == of_) {
      append(stored, step);
      continue;
    }
    // What does not move replaces from its place on what moved beyond it (3.7.3.1 a, b).
    while (!stored.empty() && stored.steps.back().from > step.from) stored.steps.pop_back();
    (void)stored.append(step.from, step.value, step.anchor);
  }
}

// --- New profiles that overlap with the stored ones (3.7.3.1.1 to 3.7.3.1.4 of 4.0.0)

/// Whether both give speeds for the same categories: then the speeds of each category are compared alone.
bool alike(const StaticSpeed& a, const StaticSpeed& b) {
  bool same = a.replaces_cd == b.replaces_cd && a.replaces_below == b.replaces_below;
  for (std::size_t k = 0; k < a.cd.size(); ++k) same = same && (a.cd[k] == kNoSpeed) == (b.cd[k] == kNoSpeed);
  for (std::size_t k = 0; k < a.other.size(); ++k) same = same && (a.other[k] == kNoSpeed) == (b.other[k] == kNoSpeed);
  return same;
}

/// The lower part of two elements; for elements with different categories not above either of them for any train.
StaticSpeed lower_part(const StaticSpeed& a, const StaticSpeed& b) {
  const Change how = change(a, b);
  if (how != Change::mixed) return how == Change::lower ? b : a;
  if (!alike(a, b)) return below(a, b);
  const auto lower = [](SpeedCode& V, SpeedCode other) { V = other < V ? other : V; };
  StaticSpeed element = a;
  element.Q_FRONT = a.Q_FRONT && b.Q_FRONT;
  lower(element.V_STATIC, b.V_STATIC);
  for (std::size_t k = 0; k < a.cd.size(); ++k) lower(element.cd[k], b.cd[k]);
  for (std::size_t k = 0; k < a.other.size(); ++k) lower(element.other[k], b.other[k]);
  return element;
}
Gradient lower_part(const Gradient& a, const Gradient& b) { return below(a, b); }

template <class P>
using ValueOf = decltype(P::Step::value);

/// The steps of a profile, place by place.
template <class P>
class Walk {
 public:
  explicit Walk(const P& profile) : steps_(profile.steps) {}
  bool over() const { return next_ == steps_.size(); }
  Place place() const { return steps_[next_].from; }
  const auto& step() const { return steps_[next_]; }
  /// The value behind the steps taken.
  std::optional<ValueOf<P>> value() const {
    if (next_ == 0 || !steps_[next_ - 1].value.known()) return std::nullopt;
    return steps_[next_ - 1].value;
  }
  void take() { ++next_; }
  /// Whether another step at its place follows this one: its element has no length.
  bool without_length() const { return next_ + 1 < steps_.size() && steps_[next_ + 1].from == steps_[next_].from; }

 private:
  const decltype(P::steps)& steps_;
  std::size_t next_ = 0;
};

/// From its start up to `to` the lower parts of `fresh` and of the stored profile, beyond it `fresh` alone.
template <class Stored, class Fresh>
class Overlapping {
 public:
  Overlapping(const Stored& stored, const Fresh& fresh, Place to, Anchor anchor)
      : old_(stored), new_(fresh), from_(fresh.steps.front().from), to_(to), anchor_(anchor) {}

  Fresh result() {
    while (!old_.over() && old_.place() < from_) old_.take();
    std::optional<Place> at = from_;
    for (; at && *at < to_; at = next()) at_place(*at);
    if (new_.over() || new_.place() > to_) append(to_, new_.value(), anchor_);
    for (; !new_.over(); new_.take()) (void)out_.append(new_.place(), new_.step().value, new_.step().anchor);
    return out_;
  }

 private:
  using Value = ValueOf<Fresh>;

  /// The nearer of the next steps.
  std::optional<Place> next() const {
    std::optional<Place> at;
    if (!old_.over()) at = old_.place();
    if (!new_.over() && (!at || new_.place() < *at)) at = new_.place();
    return at;
  }
  /// Takes the steps of one profile at a place; what has no length there counts for itself (3.6.3.2.2 e).
  template <class P, class Other>
  void take(Walk<P>& walk, const Walk<Other>& other, Place at, Anchor& anchor) {
    while (!walk.over() && walk.place() == at) {
      const bool without_length = walk.without_length();
      anchor = walk.step().anchor;
      walk.take();
      if (without_length) append(at, lowest(walk.value(), other.value()), anchor);
    }
  }
  void at_place(Place at) {
    Anchor anchor = anchor_;
    take(old_, new_, at, anchor);
    take(new_, old_, at, anchor);
    append(at, lowest(old_.value(), new_.value()), anchor);
  }
  /// Where one of them has no value the other counts.
  static std::optional<Value> lowest(const std::optional<Value>& a, const std::optional<Value>& b) {
    return a && b ? lower_part(*a, *b) : a ? a : b;
  }
  void append(Place at, const std::optional<Value>& value, Anchor anchor) {
    const Value known = value ? *value : Value::unknown();
    if (!out_.empty() && out_.steps.back().value == known) return;
    (void)out_.append(at, known, anchor);  // without room the profile ends there: never less restrictive
  }

  Walk<Stored> old_;
  Walk<Fresh> new_;
  Place from_, to_;
  Anchor anchor_;
  Fresh out_;
};

// --- What is marked

struct Marker {
  template <class T>
  void item(T& data) const {
    data.anchor = Anchor::received;
  }
  template <class T>
  void item(std::optional<T>& data) const {
    if (data) item(*data);
  }
  template <class T, std::size_t N>
  void items(InplaceVector<T, N>& list) const {
    for (T& data : list) item(data);
  }
  template <class T>
  void items(std::optional<Fresh<T>>& fresh) const {
    if (fresh) items(fresh->elements);
  }
  template <class Value, std::size_t N>
  void profile(std::optional<Profile<Value, N>>& fresh) const {
    if (fresh) items(fresh->steps);
  }
};

}  // namespace

void hang_on_unlinked(Contents& c) {
  const Marker mark;
  mark.item(c.ma);
  if (c.mode_profile) mark.items(*c.mode_profile);
  mark.profile(c.ssp);
  mark.profile(c.gradient);
  each_list([&](const auto& list) { mark.items(c.*list.fresh); });
  mark.items(c.tsr);
  mark.items(c.lx);
  mark.items(c.suitability);
  mark.item(c.adhesion);
  mark.item(c.traction);
  mark.item(c.current);
  mark.items(c.texts);
  mark.item(c.rbc_transition);
  mark.item(c.radio_infill);
  mark.item(c.reversing_area);
  if (!c.geo) return;
  for (GeoReference& reference : *c.geo)
    if (reference.applies_from) mark.item(reference);  // those of groups not yet passed have no place
}

void overlap(const Description& d, Contents& c, Anchor then, const Relocation& by) {
  if (!by.any()) return;
  Mover mover(Anchor::received, then, by);
  const auto profile = [&](const auto& stored, auto& fresh) {
    if (!fresh || fresh->empty()) return;
    const Place to = fresh->steps.front().from + (by.shift + by.farther);
    mover.profile(*fresh);
    fresh = Overlapping(stored, *fresh, to, then).result();
  };
  profile(d.ssp, c.ssp);
  profile(d.gradient, c.gradient);
  const auto areas = [&](auto& fresh) {
    if (fresh) fresh->from = fresh->from + (by.shift + by.farther);
  };
  areas(c.asp);
  areas(c.pbd);
}

void relocate(Description& d, Anchor of, Anchor then, const Relocation& by) {
  Mover mover(of, then, by);
  const bool reversing = d.reversing_area && d.reversing_area->anchor == of;
  if (reversing && d.reversing_reference) d.reversing_reference = *d.reversing_reference + by.shift;
  mover.item(d.ma);
  mover.items(d.mode_profile);
  mover.profile(d.ssp);
  mover.profile(d.gradient);
  each_list([&](const auto& list) { mover.items(d.*list.kept); });
  mover.items(d.tsr);
  mover.items(d.lx);
  mover.items(d.suitability);
  mover.items(d.adhesion);
  mover.item(d.traction);
  mover.item(d.current);
  mover.items(d.texts);
  mover.item(d.rbc_transition);
  mover.item(d.radio_infill);
  mover.item(d.reversing_area);
  mover.items(d.geo);
  if (!mover.moved()) return;
  ++d.revision;
  d.watch.changed = true;
}

}  // namespace evc::track
