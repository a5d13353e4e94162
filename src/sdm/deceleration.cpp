#include "sdm/deceleration.h"

#include <algorithm>
#include <limits>

namespace evc::sdm {
namespace {

constexpr double kNowhere = 1e9;
constexpr double kNoEnd = std::numeric_limits<double>::infinity();  // of the highest speed band

}  // namespace

KnownPart known_part(const GradientProfile& p) {
  const KnownPart none{{{kNowhere}}, {{kNowhere}}};
  if (p.permille.empty()) return none;
  KnownPart c = none;
  c.from = p.permille.steps.front().from;
  if (p.known_from.has_value()) c.from = std::max(c.from, *p.known_from);
  if (p.known_to.has_value()) c.to = *p.known_to;
  return c.from < c.to ? c : none;
}

train::BrakeSet brakes_off(const TrackConditions& c, const train::TrainData& t, Place x, bool service) {
  const auto gone = [x](const std::optional<Place>& from) { return from.has_value() && *from <= x; };
  unsigned set = 0;
  if (gone(c.regenerative_off)) set |= train::kRegenerative;
  if (t.regenerative_needs_line_voltage && gone(c.powerless)) set |= train::kRegenerative;
  if (gone(service ? c.eddy_current_service_off : c.eddy_current_emergency_off)) set |= train::kEddyCurrent;
  if (gone(c.magnetic_shoe_off)) set |= train::kMagneticShoe;
  return static_cast<train::BrakeSet>(set);
}

namespace {

/// The profile with 0 where nothing is known: it starts far behind and never ends. Its steps are read where they are
/// stored.
class Extended {
 public:
  explicit Extended(const GradientProfile& p) : steps_(p.permille.steps), known_(known_part(p)) {
    // A step that begins before the known part replaces the one before it.
    while (first_ + 1 < steps_.size() && steps_[first_ + 1].from <= known_.from) ++first_;
    std::size_t end = first_;
    while (end < steps_.size() && std::max(steps_[end].from, known_.from) < known_.to) ++end;
    count_ = end - first_;
    before_ = count_ == 0 || known_.from.from_origin.si > -kNowhere ? 1 : 0;
    after_ = known_.to.from_origin.si < kNowhere ? 1 : 0;
  }
  std::size_t size() const { return before_ + count_ + after_; }
  Place from(std::size_t i) const {
    if (i < before_) return {{-kNowhere}};
    return i - before_ < count_ ? std::max(steps_[first_ + i - before_].from, known_.from) : known_.to;
  }
  double value(std::size_t i) const {
    return i >= before_ && i - before_ < count_ ? steps_[first_ + i - before_].value : 0.0;
  }

 private:
  const InplaceVector<GradientFunction::Step, kGradientSteps>& steps_;
  KnownPart known_;
  std::size_t first_ = 0, count_ = 0, before_ = 0, after_ = 0;
};

/// A segment to the right of all others; none where the gradient does not change.
void append(Segments& segments, Place from, double grad) {
  if (!segments.empty() && segments.back().grad == grad) return;
  Segment* next = segments.grow();
  EVC_REQUIRE(next != nullptr);
  *next = {};
  next->from = from;
  next->grad = grad;
}

/// A segment begins at `from`, with the gradient that holds there.
void split(Segments& segments, Place from) {
  std::size_t i = segments.size();
  while (i > 0 && segments[i - 1].from > from) --i;
  if (i > 0 && segments[i - 1].from == from) return;
  Segment next = segments[i > 0 ? i - 1 : 0];
  next.from = from;
  const bool room = segments.insert(i, next);
  EVC_REQUIRE(room);
}

/// Lowest value under the train: a window of the train's length slides over the steps. A value holds
/// from its start until the train's rear has left it, so the change points are the starts (going down)
/// and the ends plus the train length (going up).
void lowest_under_train(Segments& out, const Extended& f, Distance L) {
  // A queue of steps with increasing values: its head is the minimum in the window.
  std::array<std::uint16_t, kGradientSteps + 2> queue{};
  std::size_t head = 0;
  std::size_t tail = 0;
  std::size_t next = 0;
  Place front = f.from(0);
  for (;;) {
    while (next < f.size() && f.from(next) <= front) {
      while (tail > head && f.value(queue[tail - 1]) >= f.value(next)) --tail;
      queue[tail++] = static_cast<std::uint16_t>(next++);
    }
    // A step has left when its end plus the train length is reached by the front.
    while (head + 1 < tail && f.from(queue[head] + 1u) + L <= front) ++head;
    append(out, front, f.value(queue[head]));
    const bool more = next < f.size();
    const bool leaves = head + 1 < tail;
    if (!more && !leaves) return;
    const Place entry = more ? f.from(next) : Place{{kNowhere}};
    const Place leave = leaves ? f.from(queue[head] + 1u) + L : Place{{kNowhere}};
    front = std::min(entry, leave);
  }
}

/// 3.13.4.1.2-3: the default gradient applies at places that are not covered, without length compensation. Two falls
/// count on the safe side: a known one under the rest of the train where the front is not covered (only such a fall is
/// below 0 there), and the default under the rear that is not covered yet.
void put_default_gradient(Segments& segments, const GradientProfile& profile, double unknown, Distance L_TRAIN) {
  const KnownPart cover = known_part(profile);
  const Place rear_covered = cover.from + L_TRAIN;
  split(segments, cover.from);
  split(segments, cover.to);
  if (unknown < 0.0) split(segments, rear_covered);
  std::size_t kept = 0;
  for (Segment& s : segments) {
    if (s.from < cover.from || s.from >= cover.to)
      s.grad = s.grad < 0.0 ? std::min(s.grad, unknown) : unknown;
    else if (unknown < 0.0 && s.from < rear_covered)
      s.grad = std::min(s.grad, unknown);
    if (kept == 0 || segments[kept - 1].grad != s.grad) segments[kept++] = s;
  }
  segments.erase(kept, segments.size());
}

/// Segments of the compensated gradient alone (3.13.4.2).
void gradient_segments(Segments& out, const GradientProfile& profile, Distance L_TRAIN, bool target_due_to_TSR) {
  out.clear();
  lowest_under_train(out, Extended(profile), L_TRAIN);
  if (target_due_to_TSR && profile.default_for_TSR.has_value())
    put_default_gradient(out, profile, *profile.default_for_TSR, L_TRAIN);
}

template <class Steps>
void bands_of(Bands& out, const Steps& steps, const train::MaxReducedAdhesion& cap) {
  out.clear();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Band b;
    const Acceleration A = steps.steps[i].value;
    b.A = {A, cap.no_maximum ? A : std::min(A, cap.A)};
    b.w_upto = {i + 1 < steps.size() ? steps.steps[i + 1].from.si * steps.steps[i + 1].from.si : kNoEnd};
    const bool room = out.push_back(b);
    EVC_REQUIRE(room);
  }
}

/// A_brake_normal_service and Kn+-, merged by speed (3.13.6.4.3).
void guidance_bands(Bands& out, const train::TrainData& t, Acceleration a0) {
  out.clear();
  const train::DecelerationSteps A = train::A_brake_normal_service(t, a0);
  if (A.empty()) return;
  double from = 0.0;
  for (;;) {
    double upto = kNoEnd;
    const auto next_step = [&upto, from](const auto& f) {
      for (const auto& s : f.steps)
        if (s.from.si > from) upto = std::min(upto, s.from.si);
    };
    next_step(A);
    next_step(t.Kn_plus);
    next_step(t.Kn_minus);
    // Any speed inside the band reads its values: steps include their upper limit.
    const Speed inside{upto};
    Band b;
    const Acceleration value = train::value_below(A, inside);
    b.A = {value, value};
    if (!t.Kn_plus.empty()) b.Kn_plus = train::value_below(t.Kn_plus, inside);
    if (!t.Kn_minus.empty()) b.Kn_minus = train::value_below(t.Kn_minus, inside);
    b.w_upto = {upto * upto};
    const bool room = out.push_back(b);
    EVC_REQUIRE(room);
    if (upto == kNoEnd) return;
    from = upto;
  }
}

constexpr train::MaxReducedAdhesion kNoCap{{}, true, {}};

}  // namespace

CompensatedGradient compensated_gradient(const GradientProfile& profile, Distance L_TRAIN, bool target_due_to_TSR) {
  Segments segments;
  gradient_segments(segments, profile, L_TRAIN, target_due_to_TSR);
  CompensatedGradient c;
  for (const Segment& s : segments) EVC_REQUIRE(c.permille.append(s.from, s.grad));
  return c;
}

const Bands& Decelerations::bands(CurveKind kind, const Segment& s) const {
  if (kind == CurveKind::SBD) return expected[s.service];
  if (kind == CurveKind::GUI) return normal_service[s.service];
  return safe[s.emergency];
}

namespace {

std::size_t segment_index(const Segments& segments, Place x) {
  std::size_t low = 0;
  std::size_t high = segments.size();
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    if (segments[middle].from <= x)
      low = middle;
    else
      high = middle;
  }
  return low;
}
}  // namespace

std::size_t band_below(const Bands& bands, SpeedSquared w) {
  std::size_t i = 0;
  while (bands[i].w_upto < w) ++i;  // the last one has no end
  return i;
}

std::size_t segment_upstream_of(const Segments& segments, Place x) {
  std::size_t i = segment_index(segments, x);
  if (i > 0 && segments[i].from == x) --i;
  return i;
}

Acceleration Decelerations::at(CurveKind kind, Speed V, Place x, bool due_to_TSR) const {
  const Segments& s = segments_of(due_to_TSR);
  const Segment& here = s[segment_index(s, x)];
  const Bands& b = bands(kind, here);
  return deceleration(b[band_below(b, V * V)], here);
}

namespace {

/// The special brakes that do not count along the track (3.13.5.1), and the stages of brakes that follow from it.
struct Inhibitions {
  InplaceVector<Place, 5> starts;  // in order
  InplaceVector<train::BrakeSet, Decelerations::kStages> emergency, service;
};

/// One stage for each set of brakes that are off; the sets only grow along the track, so one per start at most, and
/// the conversion model knows none (3.13.2.2.6.3).
Inhibitions inhibitions_of(const TrackConditions& c, const train::TrainData& t) {
  Inhibitions off;
  EVC_REQUIRE(off.emergency.push_back({}) && off.service.push_back({}));
  if (t.brake_model == train::BrakeModel::lambda) return off;
  for (const auto& from :
       {c.regenerative_off, c.eddy_current_emergency_off, c.eddy_current_service_off, c.magnetic_shoe_off, c.powerless})
    if (from.has_value()) {
      std::size_t i = off.starts.size();
      while (i > 0 && off.starts[i - 1] > *from) --i;
      EVC_REQUIRE(off.starts.insert(i, *from));
    }
  for (const Place from : off.starts) {
    const train::BrakeSet e = brakes_off(c, t, from, false);
    const train::BrakeSet s = brakes_off(c, t, from, true);
    // Regenerative, eddy current, magnetic shoe: at most four different sets on the way from none to all.
    if (off.emergency.back() != e) EVC_REQUIRE(off.emergency.push_back(e));
    if (off.service.back() != s) EVC_REQUIRE(off.service.push_back(s));
  }
  return off;
}

/// Segments of the compensated gradient become those of brakes and adhesion, too.
void add_conditions(Segments& out, const TrackConditions& c, const Inhibitions& off, const train::TrainData& t,
                    const train::FixedValues& fixed) {
  for (const Zone& z : c.reduced_adhesion) {
    split(out, z.from);
    split(out, z.to + t.L_TRAIN);  // 3.13.5.3
  }
  for (const Place from : off.starts) split(out, from);
  const auto index_of = [](const auto& stages, train::BrakeSet set) {
    std::uint8_t i = 0;
    while (stages[i] != set) ++i;
    return i;
  };
  for (Segment& s : out) {
    s.A_gradient = train::A_gradient(s.grad, t, fixed);
    if (!off.starts.empty()) {
      s.emergency = index_of(off.emergency, brakes_off(c, t, s.from, false));
      s.service = index_of(off.service, brakes_off(c, t, s.from, true));
    }
    s.reduced_adhesion = c.slippery_rail;
    for (const Zone& z : c.reduced_adhesion)
      if (z.from <= s.from && s.from < z.to + t.L_TRAIN) s.reduced_adhesion = true;
  }
}

Acceleration highest(const std::array<Bands, Decelerations::kStages>& stages, std::size_t count) {
  Acceleration A{};
  for (std::size_t i = 0; i < count; ++i)
    for (const Band& b : stages[i]) A = std::max(A, b.A[0]);
  return A;
}

/// Speed bands of every stage.
void determine_bands(Decelerations& out, const Inhibitions& off, const train::TrainData& t,
                     const train::NationalValues& values, const train::BrakeStatus& status) {
  const train::MaxReducedAdhesion cap = train::A_MAXREDADH(t, values, status);
  for (std::size_t i = 0; i < off.emergency.size(); ++i)
    bands_of(out.safe[i], train::A_brake_safe(t, values, train::in_use_emergency(t, status, off.emergency[i])), cap);
  for (std::size_t i = 0; i < off.service.size(); ++i) {
    const auto A = train::A_brake_service(t, train::in_use_service(t, status, off.service[i]));
    bands_of(out.expected[i], A, kNoCap);
    out.normal_service[i].clear();
    if (values.Q_NVGUIPERM) guidance_bands(out.normal_service[i], t, A.steps.front().value);
  }
  out.highest_safe = highest(out.safe, off.emergency.size());
  out.highest_expected = highest(out.expected, off.service.size());
}

}  // namespace

void determine(Decelerations& out, const train::TrainData& t, const train::NationalValues& values,
               const train::FixedValues& fixed, const train::BrakeStatus& status, const GradientProfile& gradient,
               const TrackConditions& conditions) {
  const Inhibitions off = inhibitions_of(conditions, t);
  determine_bands(out, off, t, values, status);
  gradient_segments(out.segments, gradient, t.L_TRAIN, false);
  add_conditions(out.segments, conditions, off, t, fixed);
  out.segments_for_TSR.clear();
  if (!gradient.default_for_TSR.has_value()) return;
  gradient_segments(out.segments_for_TSR, gradient, t.L_TRAIN, true);
  add_conditions(out.segments_for_TSR, conditions, off, t, fixed);
}

void determine(Decelerations& out, const train::TrainData& t, const train::NationalValues& values,
               const train::FixedValues& fixed, const train::BrakeStatus& status, double permille,
               const TrackConditions& conditions) {
  const Inhibitions off = inhibitions_of(conditions, t);
  determine_bands(out, off, t, values, status);
  out.segments.clear();
  append(out.segments, {{-kNowhere}}, permille);
  add_conditions(out.segments, conditions, off, t, fixed);
  out.segments_for_TSR.clear();
}

namespace {

/// Writes knots in upstream order and keeps them monotonic.
class Pen {
 public:
  Pen(std::span<Knot> room, std::size_t& used) : room_(room), used_(used), first_(used) {}

  void put(Place x, SpeedSquared w) {
    // If the curve fell: the part above the new point is replaced by a level stretch.
    bool fell = false;
    while (used_ > first_ && room_[used_ - 1].w > w) {
      --used_;
      fell = true;
    }
    if (fell && used_ > first_) {
      // The cut arc crosses w: the level stretch begins there.
      Knot& below = room_[used_ - 1];
      if (below.w < w) {  // so its arc rises
        const Place crossing = below.x - Distance{(w - below.w).si / (2.0 * below.A.si)};
        push({crossing, w, {0.0}});
      } else {
        below.A = {0.0};
      }
    }
    push({x, w, {}});
  }
  void arc(Acceleration A) {
    if (used_ > first_) room_[used_ - 1].A = A;
  }
  bool truncated() const { return truncated_; }

 private:
  void push(const Knot& k) {
    if (used_ >= room_.size()) {
      truncated_ = true;
      if (used_ > first_) room_[used_ - 1].A = {0.0};
      return;
    }
    room_[used_++] = k;
  }

  std::span<Knot> room_;
  std::size_t& used_;
  std::size_t first_;
  bool truncated_ = false;
};

struct Downstream {
  InplaceVector<Knot, 32> knots;  // from the anchor to the foot; A of the arc that leads to the next
  bool reached = false;
};

/// From the anchor down to the foot, which is not reached if the train cannot brake.
Downstream to_foot(const Decelerations& d, CurveKind kind, const Segments& segments, Place x, SpeedSquared w,
                   SpeedSquared w_foot) {
  Downstream down;
  std::size_t s = segment_index(segments, x);
  while (w > w_foot) {
    const Bands& bands = d.bands(kind, segments[s]);
    const std::size_t b = band_below(bands, w);
    const Acceleration A = deceleration(bands[b], segments[s]);
    if (A.si <= 0.0) return down;
    if (!down.knots.push_back({x, w, A})) return down;
    const SpeedSquared lower = b > 0 ? std::max(w_foot, bands[b - 1].w_upto) : w_foot;
    const Place to_band = x + Distance{(w - lower).si / (2.0 * A.si)};
    const Place border = s + 1 < segments.size() ? segments[s + 1].from : Place{{kNowhere}};
    if (to_band < border) {
      x = to_band;
      w = lower;
    } else {
      // Where both lie at the same place the next segment and the lower band begin together.
      w = std::max(lower, w - 2.0 * (A * (border - x)));
      x = border;
      ++s;
    }
  }
  down.reached = down.knots.push_back({x, w, {}});
  return down;
}

/// From a point upstream until `w_top`; where A <= 0 the speed falls upstream.
void upstream(Pen& pen, CurveWarnings& warnings, const Decelerations& d, CurveKind kind, const Segments& segments,
              Place x, SpeedSquared w, SpeedSquared w_top) {
  std::size_t s = segment_upstream_of(segments, x);
  std::size_t b = 0;
  const Bands* last = nullptr;
  for (;;) {
    const Place border = segments[s].from;
    const Bands& bands = d.bands(kind, segments[s]);
    if (&bands != last || (b > 0 && bands[b - 1].w_upto > w)) b = 0;
    last = &bands;
    while (bands[b].w_upto <= w) ++b;
    const Acceleration A = deceleration(bands[b], segments[s]);
    if (A.si > 0.0) {
      pen.arc(A);
      if (w >= w_top) return;
      const SpeedSquared upper = std::min(w_top, bands[b].w_upto);
      const SpeedSquared at_border = w + 2.0 * (A * (x - border));
      if (at_border < upper) {
        x = border;
        w = at_border;
      } else {
        x = std::max(border, x - Distance{(upper - w).si / (2.0 * A.si)});
        w = upper;
      }
    } else {
      warnings.no_deceleration = true;
      const std::size_t under = band_below(bands, w);
      const Acceleration A_under = deceleration(bands[under], segments[s]);
      const SpeedSquared lower = under > 0 ? bands[under - 1].w_upto : SpeedSquared{0.0};
      if (A_under.si >= 0.0 || w.si <= 0.0) {
        // Below this speed the train can brake, above it cannot: the curve cannot rise here.
        pen.arc({0.0});
        x = border;
      } else if (const Distance to_band{(w - lower).si / (-2.0 * A_under.si)}; x - to_band >= border) {
        x = x - to_band;
        w = lower;
      } else {
        w = {std::max(0.0, (w + 2.0 * (A_under * (x - border))).si)};
        x = border;
      }
    }
    pen.put(x, w);
    if (pen.truncated() || (s == 0 && x <= border)) return;
    if (x <= border) --s;
  }
}

}  // namespace

CurveWarnings trace(std::span<Knot> room, std::size_t& used, const Decelerations& d, CurveKind kind, bool due_to_TSR,
                    Place anchor, Speed V_anchor, Speed V_foot, Speed V_top) {
  CurveWarnings warnings;
  const Segments& segments = d.segments_of(due_to_TSR);
  const SpeedSquared w_foot = V_foot * V_foot;
  SpeedSquared w = V_anchor * V_anchor;
  Pen pen(room, used);
  const std::size_t first = used;
  if (w > w_foot) {
    const Downstream down = to_foot(d, kind, segments, anchor, w, w_foot);
    if (down.reached) {
      for (std::size_t i = down.knots.size(); i-- > 0;) {
        if (i + 1 < down.knots.size()) pen.arc(down.knots[i].A);
        pen.put(down.knots[i].x, down.knots[i].w);
      }
    } else {
      // The train cannot lose the margin of the EBI beyond the target: the target speed is required at the target.
      warnings.no_deceleration = true;
      w = w_foot;
    }
  }
  if (used == first) pen.put(anchor, w);
  upstream(pen, warnings, d, kind, segments, anchor, w, V_top * V_top);
  warnings.truncated = pen.truncated();
  return warnings;
}

BrakingCurve trace(const Decelerations& d, CurveKind kind, bool due_to_TSR, Place anchor, Speed V_anchor, Speed V_foot,
                   Speed V_top) {
  std::array<Knot, kMaxKnots> room{};
  std::size_t used = 0;
  BrakingCurve curve;
  curve.warnings = trace(room, used, d, kind, due_to_TSR, anchor, V_anchor, V_foot, V_top);
  for (std::size_t i = 0; i < used; ++i) EVC_REQUIRE(curve.knots.push_back(room[i]));
  return curve;
}

}  // namespace evc::sdm
