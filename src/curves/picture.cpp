#include "curves/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evc::curves {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep_kmh = 0.5;
constexpr std::size_t kPlaces = 900;
constexpr double kBeside_m = 1e-3;  // from a place where a line ends to the next point
constexpr double kRounding = 1e-9;  // km/h

/// The limits of one target by speed, for drawing: places in metres.
struct LimitTable {
  const sdm::Target* target;
  std::vector<double> EBI, SBI, W, P, I;  // by kStep_kmh

  /// km/h of the limit at `x`, interpolated: places decrease with increasing speed.
  static double speed_at(const std::vector<double>& places, double x) {
    const auto beyond = std::partition_point(places.begin(), places.end(), [x](double place) { return place > x; });
    if (beyond == places.begin()) return 0.0;
    if (beyond == places.end()) return static_cast<double>(places.size() - 1) * kStep_kmh;
    const double a = *(beyond - 1);
    const double b = *beyond;
    return (static_cast<double>(beyond - places.begin() - 1) + (a - x) / (a - b)) * kStep_kmh;
  }
  /// Where `speed_at` is `kmh`; none above the speeds of the table.
  static std::optional<double> place_at(const std::vector<double>& places, double kmh) {
    const double at = kmh / kStep_kmh;
    const auto below = static_cast<std::size_t>(at);
    if (below + 1 >= places.size()) return std::nullopt;
    return places[below] + (at - static_cast<double>(below)) * (places[below + 1] - places[below]);
  }

  bool of_EOA() const { return target->kind == sdm::TargetKind::EOA_SvL; }
  /// Where a limit ends: the limits of an SBD at the EOA, those of an EBD at its target.
  double end_of(std::vector<double> LimitTable::*places) const {
    return m(of_EOA() && places != &LimitTable::EBI ? target->d_EOA : target->d_target);
  }
};

LimitTable table_of(const Approached& a, const sdm::Target& t, double top_kmh) {
  LimitTable table{&t, {}, {}, {}, {}, {}};
  const auto add = [](std::vector<double>& places, Place place) {
    places.push_back(places.empty() ? m(place) : std::min(places.back(), m(place)));
  };
  for (double v = 0.0; v <= top_kmh; v += kStep_kmh) {
    const sdm::Explanation e = a.explain(Speed{v / kKmh}, t);
    add(table.EBI, *e.EBD.d_EBI);
    add(table.SBI, e.d_FLOI);
    add(table.W, e.d_W);
    add(table.P, e.d_P);
    add(table.I, e.d_I);
  }
  return table;
}

/// One limit over all targets and the ceiling above the MRSP.
struct LimitKind {
  const char* key;
  const char* name;
  std::vector<double> LimitTable::*places;
  Speed (*margin)(Speed, const train::FixedValues&);  // above MRSP and target speed; null: none
  Stroke stroke;
  bool ceiling;
};

const LimitKind kLimits[] = {
    {"EBI", "EBI  emergency brake", &LimitTable::EBI, sdm::dV_ebi, {colour::red, 3.4, ""}, true},
    {"SBI", "SBI  service brake", &LimitTable::SBI, sdm::dV_sbi, {colour::orange, 2.0, ""}, true},
    {"W", "W  warning", &LimitTable::W, sdm::dV_warning, {colour::orange, 1.5, "3 3"}, true},
    {"P", "P  permitted speed", &LimitTable::P, nullptr, {colour::yellow, 2.2, ""}, true},
    {"I", "I  indication", &LimitTable::I, nullptr, {colour::white, 1.4, "7 4"}, false},
};

double margin_of(const LimitKind& kind, Speed V, const sdm::Derived& d) {
  return kind.margin != nullptr ? kind.margin(V, d.fixed).si * kKmh : 0.0;
}
/// The limit above the MRSP (3.13.9.2) at a place, km/h; of the Indication, the MRSP.
double ceiling_of(const LimitKind& kind, double x, const sdm::Derived& d) {
  const Speed V = sdm::ceiling_at(d, Place{{x}});
  return V.si * kKmh + margin_of(kind, V, d);
}

/// The braking curve of a target, from where it is drawn.
struct DrawnCurve {
  sdm::CurveView view;
  double start;
};

/// One kind of braking curve: its names, and those of all targets that have one.
struct CurveKind {
  const char* key;
  const char* name;
  const char* colour;
  std::vector<DrawnCurve> curves;
};

/// Of several targets, none has a curve that begins in mid-air: each is drawn from where it is at last below the
/// ceiling.
double start_of(const sdm::Derived& d, const sdm::CurveView& view) {
  double start = -std::numeric_limits<double>::infinity();
  if (d.targets.size() < 2) return start;
  // Of each stretch with the same ceiling: where the curve has it, or the end of a stretch with a curve above it.
  std::vector<double> steps;
  for (const auto& step : d.mrsp.steps) steps.push_back(m(step.from));
  for (const sdm::Target& t : d.targets)
    if (t.kind == sdm::TargetKind::LOA) steps.push_back(m(t.d_target));
  std::sort(steps.begin(), steps.end());
  for (std::size_t i = 0; i < steps.size() && steps[i] <= m(view.foot()); ++i) {
    const Speed M = sdm::ceiling_at(d, Place{{steps[i]}});
    const double above_until = m(view.place_at(M + sdm::dV_ebi(M, d.fixed)));
    if (above_until <= steps[i]) continue;
    start = i + 1 < steps.size() ? std::min(above_until, steps[i + 1]) : above_until;
  }
  return start;
}

std::vector<CurveKind> curve_kinds(const sdm::Derived& d) {
  const auto kind = [&](const char* key, const char* name, const char* colour, auto ref_of) {
    CurveKind all{key, name, colour, {}};
    for (const sdm::Target& t : d.targets)
      if (const sdm::CurveView view = d.view(ref_of(t)); view.exists()) all.curves.push_back({view, start_of(d, view)});
    return all;
  };
  return {kind("EBD", "EBD  emergency deceleration", colour::EBD, [](const sdm::Target& t) { return t.EBD; }),
          kind("SBD", "SBD  service deceleration", colour::SBD, [](const sdm::Target& t) { return t.SBD; }),
          kind("GUI", "GUI  guidance", colour::GUI, [](const sdm::Target& t) { return t.GUI; })};
}

/// The highest speed at which curves are drawn, outside of the frame.
double highest_drawn(const Picture& p) { return p.top_kmh * 1.2; }

/// Places of a grid, and those where a line begins, ends, has a step or leaves the ceiling, so that it has a point
/// exactly there.
std::vector<double> places_of(const Picture& p, const Approached& a, const std::vector<CurveKind>& curves,
                              const std::vector<LimitTable>& tables) {
  const sdm::Derived& d = a.derived();
  std::vector<double> x;
  for (std::size_t i = 0; i <= kPlaces; ++i)
    x.push_back(p.from_m + (p.to_m - p.from_m) * static_cast<double>(i) / static_cast<double>(kPlaces));
  const auto point = [&](double place) {
    if (place > p.from_m && place < p.to_m) x.push_back(place);
  };
  // One line may end there and another one begin, with a gap between them.
  const auto border = [&](double place) {
    for (const double beside : {-1.0, 0.0, 1.0, 2.0}) point(place + beside * kBeside_m);
  };
  for (const auto& step : d.mrsp.steps) border(m(step.from));
  if (p.start_of_RSM_m) border(*p.start_of_RSM_m);
  for (const CurveKind& kind : curves)
    for (const DrawnCurve& c : kind.curves) {
      border(m(c.view.foot()));
      border(c.start);
      border(m(c.view.place_at(Speed{highest_drawn(p) / kKmh})));
    }
  std::vector<Speed> ceilings;
  for (const auto& step : d.mrsp.steps) ceilings.push_back(step.value);
  for (const LimitTable& t : tables) {
    if (t.target->kind == sdm::TargetKind::LOA) ceilings.push_back(t.target->V_target);
    for (const LimitKind& kind : kLimits) border(t.end_of(kind.places));
  }
  std::sort(ceilings.begin(), ceilings.end());
  ceilings.erase(std::unique(ceilings.begin(), ceilings.end()), ceilings.end());
  for (const LimitTable& t : tables)
    for (const LimitKind& kind : kLimits)
      for (const Speed V : ceilings) {
        const double kmh = V.si * kKmh + margin_of(kind, V, d);
        const auto place = LimitTable::place_at(t.*kind.places, kmh);
        if (place && std::abs(ceiling_of(kind, *place, d) - kmh) < kRounding) point(*place);
      }
  std::sort(x.begin(), x.end());
  x.erase(std::unique(x.begin(), x.end()), x.end());
  return x;
}

/// The lowest of several lines, place by place. A line that follows on another one without crossing it is a new one: a
/// place without a value is between them.
class Lowest {
 public:
  /// `values` of all lines at the next place; not a number where a line is not.
  double next(std::vector<double> values) {
    std::size_t lowest = kNone;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isnan(values[i]) && (lowest == kNone || values[i] < values[lowest])) lowest = i;
    const bool follows = lowest != kNone && before_ != kNone && lowest != before_;
    const bool crosses = follows && !std::isnan(values[before_]) && !std::isnan(last_[lowest]);
    const double value = lowest == kNone || (follows && !crosses) ? kNaN : values[lowest];
    before_ = lowest;
    last_ = std::move(values);
    return value;
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::size_t before_ = kNone;
  std::vector<double> last_;
};

void add_braking_curves(Picture& p, const std::vector<CurveKind>& kinds) {
  for (const CurveKind& kind : kinds) {
    if (kind.curves.empty()) continue;
    PictureCurve c{kind.key, kind.name, {kind.colour, 1.6, ""}, {}};
    Lowest lowest;
    for (const double x : p.x_m) {
      std::vector<double> values;
      for (const DrawnCurve& curve : kind.curves) {
        const bool here = x >= curve.start && x <= m(curve.view.foot());
        const double v = here ? curve.view.speed_at(Place{{x}}).si * kKmh : kNaN;
        values.push_back(v > highest_drawn(p) + kRounding ? kNaN : v);
      }
      c.v.push_back(lowest.next(std::move(values)));
    }
    p.curves.push_back(std::move(c));
  }
}

void add_limits(Picture& p, const Approached& a, const std::vector<LimitTable>& tables) {
  const sdm::Derived& d = a.derived();
  for (const LimitKind& kind : kLimits) {
    PictureCurve c{kind.key, kind.name, kind.stroke, {}};
    Lowest of_targets;
    for (const double x : p.x_m) {
      const double ceiling = ceiling_of(kind, x, d);
      bool beyond_stop = false;
      std::vector<double> values;
      for (const LimitTable& t : tables) {
        values.push_back(kNaN);
        if (x > t.end_of(kind.places)) {
          beyond_stop = beyond_stop || t.of_EOA() || t.target->kind == sdm::TargetKind::SR_end;
          continue;
        }
        const double floor =
            t.target->zero ? 0.0 : t.target->V_target.si * kKmh + margin_of(kind, t.target->V_target, d);
        const double v = std::max(LimitTable::speed_at(t.*kind.places, x), floor);
        if (v <= ceiling + kRounding) values.back() = std::min(v, ceiling);
      }
      double lowest = of_targets.next(values);
      if (kind.ceiling) {  // it joins the lines of all targets
        lowest = ceiling;
        for (const double v : values)
          if (v < lowest) lowest = v;
      }
      if (beyond_stop) lowest = kNaN;
      // 3.13.9.4.6: from its start on, release speed monitoring has its own EBI, and no SBI, W and I.
      const bool replaced = p.start_of_RSM_m && x > *p.start_of_RSM_m && kind.places != &LimitTable::P;
      c.v.push_back(replaced ? kNaN : lowest);
    }
    p.curves.push_back(std::move(c));
  }
}

void add_marks(Picture& p, const Approached& a) {
  const sdm::Target& t = a.target();
  const double location = m(a.input().target_location);
  const char* name = t.kind == sdm::TargetKind::EOA_SvL  ? "EOA"
                     : t.kind == sdm::TargetKind::LOA    ? "LOA"
                     : t.kind == sdm::TargetKind::SR_end ? "end of the SR distance"
                                                         : "target";
  const bool separate = t.kind == sdm::TargetKind::EOA_SvL && t.d_EOA != t.d_target;
  p.marks.push_back({location, t.kind == sdm::TargetKind::EOA_SvL && !separate ? "EOA = SvL" : name});
  if (separate) p.marks.push_back({m(t.d_target), "SvL"});
  const Scalars s = scalars_of(a);
  if (s.d_perturbation_m) p.marks.push_back({location - *s.d_perturbation_m, "perturbation"});
  if (s.d_preindication_m) p.marks.push_back({location - *s.d_preindication_m, "pre-indication"});
  p.V_release_kmh = s.V_release_kmh;
  if (!s.d_start_RSM_m) return;
  p.start_of_RSM_m = location - *s.d_start_RSM_m;
  p.end_of_RSM_m = m(t.d_target);
  p.marks.push_back({*p.start_of_RSM_m, "start of RSM"});
}

void add_zones(Picture& p, const sdm::Inputs& in) {
  const sdm::TrackConditions& c = in.conditions;
  const auto row = [&p](const char* name, auto add) {
    const std::size_t before = p.zones.size();
    add([&p, name](double from, double to) {
      if (to > p.from_m && from < p.to_m)
        p.zones.push_back({std::max(from, p.from_m), std::min(to, p.to_m), p.zone_rows, name});
    });
    if (p.zones.size() > before) ++p.zone_rows;
  };
  row("reduced adhesion", [&](auto put) {
    // It counts until the rear end has left it (3.13.5.3).
    for (const sdm::Zone& z : c.reduced_adhesion) put(m(z.from), m(z.to + in.train.L_TRAIN));
  });
  row("slippery rail", [&](auto put) {
    if (c.slippery_rail) put(p.from_m, p.to_m);
  });
  // The conversion model has no special brakes (3.13.2.2.6.3); an inhibition applies up to the foot (3.13.5.1).
  if (in.train.brake_model == train::BrakeModel::lambda) return;
  const auto from_on = [&](const char* name, const std::optional<Place>& from) {
    row(name, [&](auto put) {
      if (from) put(m(*from), p.to_m);
    });
  };
  from_on("no regenerative brake", c.regenerative_off);
  from_on("no eddy current brake (EB)", c.eddy_current_emergency_off);
  from_on("no eddy current brake (SB)", c.eddy_current_service_off);
  from_on("no magnetic shoe brake", c.magnetic_shoe_off);
  from_on("powerless", c.powerless);
}

template <class Function>
std::vector<Picture::Step> steps_of(const Function& f) {
  std::vector<Picture::Step> steps;
  for (const auto& s : f.steps) steps.push_back({m(s.from), s.value});
  return steps;
}

/// The start of the chart, earlier where the Indication limit of a target in it would be left of it.
double with_targets_on_the_way(const Approached& a, double start) {
  const sdm::Derived& d = a.derived();
  const double farthest = start - 20000.0;
  for (std::size_t i = d.targets.size(); i-- > 0;) {
    const sdm::Target& t = d.targets[i];
    if (t.kind != sdm::TargetKind::MRSP || m(t.d_target) < start) continue;
    const Speed before = sdm::ceiling_at(d, t.d_target - Distance{1e-3});
    if (!(t.V_target < before)) continue;
    const Place d_I = a.explain(before, t).d_I;
    if (is_somewhere(d_I) && m(d_I) > farthest) start = std::min(start, m(d_I));
  }
  return start;
}

/// Nothing of the chart is below this speed: a restriction does not need the empty part of the axis.
double lowest_drawn(const Picture& p) {
  double lowest = p.V_release_kmh.value_or(p.top_kmh);
  for (const PictureCurve& c : p.curves)
    for (const double v : c.v)
      if (v < lowest) lowest = v;
  return std::max(std::floor((lowest - 10.0) / 20.0) * 20.0, 0.0);
}

}  // namespace

Picture picture_of(const Approached& a) {
  const io::CurvesInput& c = a.input();
  const sdm::Derived& d = a.derived();
  Picture p;
  double V_max = 0.0;
  for (const auto& step : d.mrsp.steps) {
    V_max = std::max(V_max, step.value.si);
    p.mrsp.push_back({m(step.from), step.value.si * kKmh});
  }
  const double top = V_max * kKmh + sdm::dV_ebi({V_max}, d.fixed).si * kKmh;
  p.top_kmh = std::ceil((top * 1.07 + 4.0) / 10.0) * 10.0;  // with room for the names of places
  std::vector<LimitTable> tables;
  for (const sdm::Target& t : d.targets) tables.push_back(table_of(a, t, p.top_kmh + 10.0));
  const double end = m(std::max(a.target().d_target, c.target_location));
  const Place d_I = a.explain({V_max}).d_I;
  const double own = is_somewhere(d_I) ? std::min(m(d_I), m(c.target_location) - 100.0) : end - 5000.0;
  const double start = with_targets_on_the_way(a, own);
  p.from_m = start - 0.10 * (end - start);
  p.to_m = end + 0.05 * (end - start);
  // A profile that begins at 0 is not drawn far in rear of it.
  if (!d.mrsp.empty() && m(d.mrsp.steps[0].from) > p.from_m && m(d.mrsp.steps[0].from) < start)
    p.from_m = m(d.mrsp.steps[0].from);
  add_marks(p, a);
  const std::vector<CurveKind> curves = curve_kinds(d);
  p.x_m = places_of(p, a, curves, tables);
  // Wide: the Permitted speed covers its middle.
  PictureCurve mrsp{"MRSP", "MRSP", {colour::grey, 5.0, ""}, {}};
  for (const double x : p.x_m) mrsp.v.push_back(d.mrsp.at(Place{{x}}).si * kKmh);
  p.curves.push_back(std::move(mrsp));
  add_braking_curves(p, curves);
  add_limits(p, a, tables);
  p.bottom_kmh = lowest_drawn(p);
  add_zones(p, c.inputs);
  p.gradient = steps_of(c.inputs.gradient.permille);
  if (c.inputs.gradient.known_to) p.gradient.push_back({m(*c.inputs.gradient.known_to), 0.0});
  p.under_train =
      steps_of(sdm::compensated_gradient(c.inputs.gradient, c.inputs.train.L_TRAIN, a.target().due_to_TSR).permille);
  return p;
}

}  // namespace evc::curves
