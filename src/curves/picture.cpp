#include "curves/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evc::curves {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep_kmh = 0.5;
constexpr std::size_t kPlaces = 900;

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

/// Places of a grid, with both sides of every step.
std::vector<double> places_of(const Approached& a, double from, double to) {
  std::vector<double> x;
  for (std::size_t i = 0; i <= kPlaces; ++i)
    x.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(kPlaces));
  const auto both_sides = [&](Place place) {
    if (m(place) > from && m(place) < to) x.insert(x.end(), {m(place) - 1e-3, m(place)});
  };
  for (const auto& step : a.input().inputs.mrsp.steps) both_sides(step.from);
  for (const sdm::Target& t : a.derived().targets) both_sides(t.d_target);
  std::sort(x.begin(), x.end());
  return x;
}

void add_braking_curves(Picture& p, const Approached& a) {
  const sdm::Derived& d = a.derived();
  // Of several targets, none has a curve that begins in mid-air: each is drawn from where it is at last below the
  // ceiling.
  const auto start_of = [&](const sdm::CurveView& view) {
    double start = -std::numeric_limits<double>::infinity();
    if (d.targets.size() < 2) return start;
    for (const double x : p.x_m) {
      const Speed M = sdm::ceiling_at(d, Place{{x}});
      if (x <= m(view.foot()) && view.speed_at(Place{{x}}) > M + sdm::dV_ebi(M, d.fixed)) start = x;
    }
    return start;
  };
  const auto curve = [&](const char* key, const char* name, const char* colour, auto ref_of) {
    PictureCurve c{key, name, {colour, 1.6, ""}, {}};
    struct Drawn {
      sdm::CurveView view;
      double start;
    };
    std::vector<Drawn> all;
    for (const sdm::Target& t : d.targets)
      if (const sdm::CurveView view = d.view(ref_of(t)); view.exists()) all.push_back({view, start_of(view)});
    if (all.empty()) return;
    std::size_t before = all.size();
    for (const double x : p.x_m) {
      double lowest = kNaN;
      std::size_t governing = all.size();
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (x > m(all[i].view.foot()) || !(x > all[i].start)) continue;
        const double v = all[i].view.speed_at(Place{{x}}).si * kKmh;
        if (v >= lowest) continue;
        lowest = v;
        governing = i;
      }
      // Where the curve of another target becomes the lowest, a new line begins.
      if (before != all.size() && governing != before) lowest = kNaN;
      before = governing;
      c.v.push_back(lowest > p.top_kmh * 1.2 ? kNaN : lowest);
    }
    p.curves.push_back(std::move(c));
  };
  curve("EBD", "EBD  emergency deceleration", colour::EBD, [](const sdm::Target& t) { return t.EBD; });
  curve("SBD", "SBD  service deceleration", colour::SBD, [](const sdm::Target& t) { return t.SBD; });
  curve("GUI", "GUI  guidance", colour::GUI, [](const sdm::Target& t) { return t.GUI; });
}

void add_limits(Picture& p, const Approached& a, const std::vector<LimitTable>& tables) {
  const sdm::Derived& d = a.derived();
  for (const LimitKind& kind : kLimits) {
    PictureCurve c{kind.key, kind.name, kind.stroke, {}};
    const auto margin = [&](Speed V) { return kind.margin != nullptr ? kind.margin(V, d.fixed).si * kKmh : 0.0; };
    for (const double x : p.x_m) {
      const Speed V_MRSP = sdm::ceiling_at(d, Place{{x}});
      const double ceiling = V_MRSP.si * kKmh + margin(V_MRSP);
      double lowest = kind.ceiling ? ceiling : kNaN;
      for (const LimitTable& t : tables) {
        // The limits of an SBD end at the EOA, those of an EBD at its target.
        const bool EOA = t.target->kind == sdm::TargetKind::EOA_SvL && kind.places != &LimitTable::EBI;
        const double end = m(EOA ? t.target->d_EOA : t.target->d_target);
        if (x > end) {
          if (t.target->kind == sdm::TargetKind::EOA_SvL || t.target->kind == sdm::TargetKind::SR_end) lowest = kNaN;
          continue;
        }
        const double floor = t.target->zero ? 0.0 : t.target->V_target.si * kKmh + margin(t.target->V_target);
        const double v = std::max(LimitTable::speed_at(t.*kind.places, x), floor);
        if (v <= ceiling && !(v >= lowest)) lowest = v;
      }
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
  p.x_m = places_of(a, p.from_m, p.to_m);
  // Wide: the Permitted speed covers its middle.
  PictureCurve mrsp{"MRSP", "MRSP", {colour::grey, 5.0, ""}, {}};
  for (const double x : p.x_m) mrsp.v.push_back(d.mrsp.at(Place{{x}}).si * kKmh);
  p.curves.push_back(std::move(mrsp));
  add_marks(p, a);
  add_braking_curves(p, a);
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
