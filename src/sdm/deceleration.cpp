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

/// The profile with `unknown` where the gradient is not known: it starts far behind and has no end.
struct Extended {
  StepFunction<Place, double, kGradientSteps + 2> f;
};
Extended extended(const GradientProfile& p, double unknown) {
  Extended e;
  const KnownPart c = known_part(p);
  // Room for two more steps than the profile can have is enough.
  EVC_REQUIRE(e.f.append({{-kNowhere}}, unknown));
  for (const auto& step : p.permille.steps) {
    // A step that begins before the known part replaces the one before it.
    const Place from = std::max(step.from, c.from);
    if (from < c.to) EVC_REQUIRE(e.f.append(from, step.value));
  }
  if (c.to.from_origin.si < kNowhere) EVC_REQUIRE(e.f.append(c.to, unknown));
  return e;
}

/// Lowest value under the train: a window of the train's length slides over the steps. A value holds
/// from its start until the train's rear has left it, so the change points are the starts (going down)
/// and the ends plus the train length (going up).
template <class Steps>
CompensatedGradient lowest_under_train(const Steps& f, Distance L) {
  CompensatedGradient c;
  // A queue of steps with increasing values: its head is the minimum in the window.
  std::array<std::uint16_t, kGradientSteps + 2> queue{};
  std::size_t head = 0;
  std::size_t tail = 0;
  std::size_t next = 0;
  Place front = f.steps[0].from;
  for (;;) {
    while (next < f.size() && f.steps[next].from <= front) {
      while (tail > head && f.steps[queue[tail - 1]].value >= f.steps[next].value) --tail;
      queue[tail++] = static_cast<std::uint16_t>(next++);
    }
    // A step has left when its end plus the train length is reached by the front.
    while (head + 1 < tail && f.steps[queue[head] + 1u].from + L <= front) ++head;
    const bool room = c.permille.append(front, f.steps[queue[head]].value);
    EVC_REQUIRE(room);
    const bool more = next < f.size();
    const bool leaves = head + 1 < tail;
    if (!more && !leaves) return c;
    const Place entry = more ? f.steps[next].from : Place{{kNowhere}};
    const Place leave = leaves ? f.steps[queue[head] + 1u].from + L : Place{{kNowhere}};
    front = std::min(entry, leave);
  }
}

/// Change points of everything that separates segments, sorted and without duplicates.
struct Borders {
  InplaceVector<Place, kSegments> at;

  void add(Place p) {
    std::size_t i = at.size();
    while (i > 0 && at[i - 1] > p) --i;
    if (i > 0 && at[i - 1] == p) return;
    const bool room = at.insert(i, p);
    EVC_REQUIRE(room);
  }
};

template <class Steps>
Bands bands_of(const Steps& steps, const train::MaxReducedAdhesion& cap) {
  Bands bands;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Band b;
    const Acceleration A = steps.steps[i].value;
    b.A = {A, cap.no_maximum ? A : std::min(A, cap.A)};
    b.w_upto = {i + 1 < steps.size() ? steps.steps[i + 1].from.si * steps.steps[i + 1].from.si : kNoEnd};
    const bool room = bands.push_back(b);
    EVC_REQUIRE(room);
  }
  return bands;
}

/// A_brake_normal_service and Kn+-, merged by speed (3.13.6.4.3).
Bands guidance_bands(const train::TrainData& t, Acceleration a0) {
  const train::DecelerationSteps A = train::A_brake_normal_service(t, a0);
  Bands bands;
  if (A.empty()) return bands;
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
    const bool room = bands.push_back(b);
    EVC_REQUIRE(room);
    if (upto == kNoEnd) return bands;
    from = upto;
  }
}

constexpr train::MaxReducedAdhesion kNoCap{{}, true, {}};

}  // namespace

CompensatedGradient compensated_gradient(const GradientProfile& profile, Distance L_TRAIN, bool target_due_to_TSR) {
  CompensatedGradient c = lowest_under_train(extended(profile, 0.0).f, L_TRAIN);
  if (!target_due_to_TSR || !profile.default_for_TSR.has_value()) return c;
  // 3.13.4.1.2-3: the default gradient applies at places that are not covered, without length compensation; a known
  // fall under the rest of the train is kept (safe side): where the front is not covered, only such a fall is below 0.
  const double unknown = *profile.default_for_TSR;
  const KnownPart cover = known_part(profile);
  Borders borders;
  for (const auto& step : c.permille.steps) borders.add(step.from);
  borders.add(cover.from);
  borders.add(cover.to);
  CompensatedGradient tsr;
  for (const Place from : borders.at) {
    const double value = c.permille.at(from);
    const bool inside = from >= cover.from && from < cover.to;
    EVC_REQUIRE(tsr.permille.append(from, inside ? value : value < 0.0 ? std::min(value, unknown) : unknown));
  }
  return tsr;
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

/// Segments for one of the gradients (with or without the default for TSR).
void build_segments(Segments& out, const CompensatedGradient& gradient, const TrackConditions& c,
                    const train::TrainData& t, const train::FixedValues& fixed,
                    const InplaceVector<train::BrakeSet, Decelerations::kStages>& emergency,
                    const InplaceVector<train::BrakeSet, Decelerations::kStages>& service) {
  Borders borders;
  for (const auto& s : gradient.permille.steps) borders.add(s.from);
  for (const Zone& z : c.reduced_adhesion) {
    borders.add(z.from);
    borders.add(z.to + t.L_TRAIN);  // 3.13.5.3
  }
  for (const auto& from :
       {c.regenerative_off, c.eddy_current_emergency_off, c.eddy_current_service_off, c.magnetic_shoe_off, c.powerless})
    if (from.has_value()) borders.add(*from);
  out.clear();
  const auto index_of = [](const auto& stages, train::BrakeSet off) {
    std::uint8_t i = 0;
    while (stages[i] != off) ++i;
    return i;
  };
  std::size_t g = 0;
  for (const Place from : borders.at) {
    while (g + 1 < gradient.permille.size() && gradient.permille.steps[g + 1].from <= from) ++g;
    Segment s;
    s.from = from;
    s.grad = gradient.permille.steps[g].value;
    s.A_gradient = train::A_gradient(s.grad, t, fixed);
    s.emergency = index_of(emergency, brakes_off(c, t, from, false));
    s.service = index_of(service, brakes_off(c, t, from, true));
    s.reduced_adhesion = c.slippery_rail;
    for (const Zone& z : c.reduced_adhesion)
      if (z.from <= from && from < z.to + t.L_TRAIN) s.reduced_adhesion = true;
    const bool room = out.push_back(s);
    EVC_REQUIRE(room);
  }
}

Acceleration highest(const std::array<Bands, Decelerations::kStages>& stages, std::size_t count) {
  Acceleration A{};
  for (std::size_t i = 0; i < count; ++i)
    for (const Band& b : stages[i]) A = std::max(A, b.A[0]);
  return A;
}

}  // namespace

void determine(Decelerations& out, const train::TrainData& t, const train::NationalValues& values,
               const train::FixedValues& fixed, const train::BrakeStatus& status, const GradientProfile& gradient,
               const TrackConditions& conditions) {
  // Stages: the brakes that are off at the start of each zone. Along the track the set only grows, so there is at most
  // one stage per zone start; the conversion model has none (3.13.2.2.6.3).
  InplaceVector<train::BrakeSet, Decelerations::kStages> emergency, service;
  TrackConditions c = conditions;
  if (t.brake_model == train::BrakeModel::lambda) {
    c = {};
    c.reduced_adhesion = conditions.reduced_adhesion;
    c.slippery_rail = conditions.slippery_rail;
  }
  Borders starts;
  starts.add({{-kNowhere}});
  for (const auto& from :
       {c.regenerative_off, c.eddy_current_emergency_off, c.eddy_current_service_off, c.magnetic_shoe_off, c.powerless})
    if (from.has_value()) starts.add(*from);
  for (const Place from : starts.at) {
    const train::BrakeSet e = brakes_off(c, t, from, false);
    const train::BrakeSet s = brakes_off(c, t, from, true);
    // Regenerative, eddy current, magnetic shoe: at most four different sets on the way from none to all.
    if (emergency.empty() || emergency.back() != e) EVC_REQUIRE(emergency.push_back(e));
    if (service.empty() || service.back() != s) EVC_REQUIRE(service.push_back(s));
  }
  const train::MaxReducedAdhesion cap = train::A_MAXREDADH(t, values, status);
  for (std::size_t i = 0; i < emergency.size(); ++i)
    out.safe[i] = bands_of(train::A_brake_safe(t, values, train::in_use_emergency(t, status, emergency[i])), cap);
  for (std::size_t i = 0; i < service.size(); ++i) {
    const auto A = train::A_brake_service(t, train::in_use_service(t, status, service[i]));
    out.expected[i] = bands_of(A, kNoCap);
    out.normal_service[i] = values.Q_NVGUIPERM ? guidance_bands(t, A.steps.front().value) : Bands{};
  }
  out.highest_safe = highest(out.safe, emergency.size());
  out.highest_expected = highest(out.expected, service.size());
  build_segments(out.segments, compensated_gradient(gradient, t.L_TRAIN, false), c, t, fixed, emergency, service);
  out.segments_for_TSR.clear();
  if (gradient.default_for_TSR.has_value())
    build_segments(out.segments_for_TSR, compensated_gradient(gradient, t.L_TRAIN, true), c, t, fixed, emergency,
                   service);
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
