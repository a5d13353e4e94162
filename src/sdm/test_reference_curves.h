#pragma once
// An independent model of 3.13.4-3.13.8 for comparison: it evaluates every place and proceeds border by border. It uses
// no code under test; brake models and rotating mass are those of the room `train`.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

#include "sdm/test_cases.h"

namespace evc::sdm::test {

/// So small that no border is between a place and this distance in rear of it; exact for places on a grid.
inline constexpr double kTiny = 1.0 / (1 << 20);

struct Reference {
  const Inputs& in;
  bool due_to_TSR = false;
  explicit Reference(const Inputs& inputs, bool TSR = false) : in(inputs), due_to_TSR(TSR) {
    for (unsigned set = 0; set < 16; ++set) {
      safe.push_back(train::A_brake_safe(in.train, in.national_values, static_cast<train::BrakeSet>(set)));
      full_service.push_back(train::A_brake_service(in.train, static_cast<train::BrakeSet>(set)));
    }
    const std::vector<double> changes = received_borders();
    std::set<double> at(changes.begin(), changes.end());
    at.insert(-1e9);
    for (const double b : at) pieces.push_back({b, received(b), known(b)});
  }
  std::vector<train::MergedSteps> safe;                // by the special brakes in use
  std::vector<train::DecelerationSteps> full_service;  // the same
  struct Piece {
    double from, value;
    bool known;
  };
  std::vector<Piece> pieces;  // of the gradient profile

  // ---- Gradient (3.13.4) -------------------------------------------------------------------------------------
  bool known(double p) const {
    const GradientProfile& g = in.gradient;
    if (g.permille.empty() || p < g.permille.steps[0].from.from_origin.si) return false;
    if (g.known_from.has_value() && p < g.known_from->from_origin.si) return false;
    return !g.known_to.has_value() || p < g.known_to->from_origin.si;
  }
  double received(double p) const {
    double value = 0.0;
    for (const auto& s : in.gradient.permille.steps)
      if (s.from.from_origin.si <= p) value = s.value;
    return value;
  }
  /// The change points of the received profile.
  std::vector<double> received_borders() const {
    std::vector<double> all;
    for (const auto& s : in.gradient.permille.steps) all.push_back(s.from.from_origin.si);
    for (const auto& p : {in.gradient.known_from, in.gradient.known_to})
      if (p.has_value()) all.push_back(p->from_origin.si);
    return all;
  }
  /// Per mille, for a train whose front is at x: every place under it counts with its received gradient, with 0
  /// elsewhere.
  double grad(double x) const {
    double lowest = 1e9;
    double lowest_known = 1e9;
    const double rear = x - in.train.L_TRAIN.si;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const bool under = pieces[i].from <= x && (i + 1 == pieces.size() || pieces[i + 1].from > rear);
      if (!under) continue;
      lowest = std::min(lowest, pieces[i].known ? pieces[i].value : 0.0);
      if (pieces[i].known) lowest_known = std::min(lowest_known, pieces[i].value);
    }
    if (!due_to_TSR || !in.gradient.default_for_TSR.has_value()) return lowest;
    // A default that falls counts under a rear that the profile does not cover yet.
    if (known(x)) return known(rear) ? lowest : std::min(lowest, *in.gradient.default_for_TSR);
    // Beyond the profile a known fall under the rest of the train is kept.
    const double unknown = *in.gradient.default_for_TSR;
    return lowest_known < 0.0 ? std::min(unknown, lowest_known) : unknown;
  }

  // ---- Brakes (3.13.5) ---------------------------------------------------------------------------------------
  train::BrakeSet inhibited(double x, bool by_service) const {
    unsigned off = 0;
    if (in.train.brake_model == train::BrakeModel::lambda) return 0;
    const TrackConditions& c = in.conditions;
    const auto from = [x](const std::optional<Place>& start) {
      return start.has_value() && start->from_origin.si <= x;
    };
    if (from(c.regenerative_off) || (in.train.regenerative_needs_line_voltage && from(c.powerless)))
      off += train::kRegenerative;
    if (from(by_service ? c.eddy_current_service_off : c.eddy_current_emergency_off)) off += train::kEddyCurrent;
    if (from(c.magnetic_shoe_off)) off += train::kMagneticShoe;
    return static_cast<train::BrakeSet>(off);
  }
  bool reduced_adhesion(double x) const {
    bool reduced = in.conditions.slippery_rail;
    for (const Zone& z : in.conditions.reduced_adhesion)
      if (z.from.from_origin.si <= x && x < z.to.from_origin.si + in.train.L_TRAIN.si) reduced = true;
    return reduced;
  }

  // ---- Decelerations (3.13.6) --------------------------------------------------------------------------------
  double A_gradient(double x) const { return train::A_gradient(grad(x), in.train, in.fixed).si; }
  /// The brakes alone at speed V (a step includes its upper limit).
  double A_brake(CurveKind kind, double V, double x) const {
    const train::TrainData& t = in.train;
    if (kind == CurveKind::EBD) {
      const auto used = train::in_use_emergency(t, in.brakes, inhibited(x, false));
      const double A = train::value_below(safe[used], Speed{V}).si;
      const auto cap = train::A_MAXREDADH(t, in.national_values, in.brakes);
      return reduced_adhesion(x) && !cap.no_maximum ? std::min(A, cap.A.si) : A;
    }
    const auto used = train::in_use_service(t, in.brakes, inhibited(x, true));
    const auto& full = full_service[used];
    if (kind == CurveKind::SBD) return train::value_below(full, Speed{V}).si;
    return train::value_below(train::A_brake_normal_service(t, full.steps[0].value), Speed{V}).si;
  }
  double A(CurveKind kind, double V, double x) const {
    double sum = A_brake(kind, V, x) + A_gradient(x);
    const double g = grad(x);
    const auto& Kn = g > 0.0 ? in.train.Kn_plus : in.train.Kn_minus;
    if (kind == CurveKind::GUI && g != 0.0 && !Kn.empty()) sum -= train::value_below(Kn, Speed{V}).si * g / 1000.0;
    return sum;
  }

  // ---- Change points -------------------------------------------------------------------------------
  std::vector<double> borders() const {
    std::set<double> all;
    const double L = in.train.L_TRAIN.si;
    for (const double b : received_borders()) {
      all.insert(b);
      all.insert(b + L);
    }
    for (const Zone& z : in.conditions.reduced_adhesion) {
      all.insert(z.from.from_origin.si);
      all.insert(z.to.from_origin.si + L);
    }
    const TrackConditions& c = in.conditions;
    for (const auto& start : {c.regenerative_off, c.eddy_current_emergency_off, c.eddy_current_service_off,
                              c.magnetic_shoe_off, c.powerless})
      if (start.has_value()) all.insert(start->from_origin.si);
    return {all.begin(), all.end()};
  }
  std::vector<double> speed_steps(CurveKind kind) const {
    std::set<double> all;
    const auto add = [&all](const auto& f) {
      for (const auto& s : f.steps)
        if (s.from.si > 0.0) all.insert(s.from.si);
    };
    for (unsigned set = 0; set < 16; ++set) {
      if (kind == CurveKind::EBD) add(safe[set]);
      if (kind == CurveKind::SBD) add(full_service[set]);
    }
    if (kind == CurveKind::GUI) {
      for (const auto& model : in.train.normal_service.A_brake_normal_service) add(model);
      add(in.train.Kn_plus);
      add(in.train.Kn_minus);
    }
    return {all.begin(), all.end()};
  }
};

/// Trains, tracks and national values with every feature of 3.13.4-3.13.6, on a grid of 50 m and 2.5 m/s so that
/// borders coincide.
inline train::TrainData rich_train(Dice& dice) {
  train::TrainData t = random_train(dice);
  t.L_TRAIN = {50.0 * dice.integer(1, 18)};
  t.Kn_plus = {};
  const auto interface = [&dice] { return static_cast<train::SpecialBrakeInterface>(dice.integer(0, 3)); };
  t.regenerative = interface();
  t.eddy_current = interface();
  t.magnetic_shoe =
      dice.chance(0.5) ? train::SpecialBrakeInterface::emergency_only : train::SpecialBrakeInterface::none;
  t.regenerative_needs_line_voltage = dice.chance(0.5);
  t.adhesion_independent_brake = dice.chance(0.5);
  t.emergency.clear();
  t.service.clear();
  for (int m = 0; m < 4; ++m) {
    train::EmergencyModel e;
    train::ServiceModel s;
    double from = 0.0;
    const int steps = dice.integer(1, 7);
    for (int i = 0; i < steps; ++i) {
      train::EmergencyStep step;
      step.A_brake_emergency = {dice.real(0.4, 1.4)};
      step.Kwet_rst = train::Factor::of(dice.real(0.7, 1.0));
      step.Kdry_rst.fill(train::Factor::of(dice.real(0.6, 1.0)));
      (void)e.steps.append({from}, step);
      (void)s.A_brake_service.append({from}, {dice.real(0.3, 1.1)});
      from += 2.5 * dice.integer(1, 4);
    }
    e.with = static_cast<train::BrakeSet>(m == 0 ? 0 : dice.integer(1, 7));
    s.with = static_cast<train::BrakeSet>(m == 0 ? 0 : dice.integer(1, 3));
    (void)t.emergency.push_back(e);
    (void)t.service.push_back(s);
  }
  t.normal_service.A_SB01 = {dice.real(0.3, 0.7)};
  t.normal_service.A_SB12 = t.normal_service.A_SB01 + Acceleration{dice.real(0.0, 0.4)};
  for (auto& model : t.normal_service.A_brake_normal_service)
    for (int i = 0; i < 4; ++i) (void)model.append({i * 2.5 * dice.integer(1, 5)}, {dice.real(0.2, 0.7)});
  for (int i = 0; i < 4; ++i) {
    if (dice.chance(0.5)) (void)t.Kn_plus.append({t.Kn_plus.empty() ? 0.0 : i * 10.0}, {dice.real(0.0, 9.0)});
    if (dice.chance(0.5)) (void)t.Kn_minus.append({t.Kn_minus.empty() ? 0.0 : i * 12.5}, {dice.real(0.0, 9.0)});
  }
  if (dice.chance(0.1)) {
    t.Kn_plus = {};
    (void)t.Kn_plus.append({0.0}, {8.0});
    (void)t.Kn_plus.append({0.5}, {1.0});
  }
  (void)t.T_emergency.push_back({{4.0}, {2.0}, 0});
  (void)t.T_service.push_back({{5.0}, {2.0}, 0});
  return t;
}

inline Inputs rich_inputs(Dice& dice) {
  Inputs in;
  in.train = rich_train(dice);
  in.V_top = Speed{100.0};
  in.brakes.regenerative = dice.chance(0.8);
  in.brakes.eddy_current = dice.chance(0.8);
  in.brakes.magnetic_shoe = dice.chance(0.8);
  in.brakes.adhesion_independent = dice.chance(0.5);
  train::NationalValues& n = in.national_values;
  n.Q_NVGUIPERM = true;
  n.M_NVAVADH = dice.chance(0.5) ? dice.real(0.0, 1.0) : 0.0;
  for (auto* cap : {&n.A_NVMAXREDADH1, &n.A_NVMAXREDADH2, &n.A_NVMAXREDADH3})
    *cap = dice.chance(0.2) ? train::MaxReducedAdhesion::without_maximum({})
                            : train::MaxReducedAdhesion::at_most({dice.real(0.3, 0.9)});
  const auto place = [&dice] { return Place{{50.0 * dice.integer(0, 120)}}; };
  const auto maybe = [&dice, &place](double p) {
    return dice.chance(p) ? std::optional<Place>(place()) : std::nullopt;
  };
  double x = dice.chance(0.5) ? -2000.0 : 50.0 * dice.integer(0, 40);
  const int gradients = dice.chance(0.02) ? 0 : dice.chance(0.1) ? 96 : dice.integer(1, 40);
  for (int i = 0; i < gradients; ++i) {
    const bool steep = dice.chance(0.03);
    (void)in.gradient.permille.append({{x}}, steep ? -dice.integer(30, 150) : dice.integer(-18, 18));
    x += 50.0 * dice.integer(1, 8);
  }
  in.gradient.known_from = maybe(0.2);
  in.gradient.known_to = maybe(0.3);
  if (dice.chance(0.5)) in.gradient.default_for_TSR = dice.integer(-12, 12);
  TrackConditions& c = in.conditions;
  c.slippery_rail = dice.chance(0.1);
  const int zones = dice.chance(0.1) ? 16 : dice.integer(0, 4);
  for (int i = 0; i < zones; ++i) {
    const Place from = place();
    (void)c.reduced_adhesion.push_back({from, from + Distance{50.0 * dice.integer(1, 10)}});
  }
  c.regenerative_off = maybe(0.4);
  c.eddy_current_emergency_off = maybe(0.4);
  c.eddy_current_service_off = maybe(0.4);
  c.magnetic_shoe_off = maybe(0.4);
  c.powerless = maybe(0.4);
  return in;
}

/// A braking curve as a list of places and squared speeds from the foot upstream, linear between them: the trace of
/// 3.13.8.3. It may fall upstream where the train cannot brake; the allowed speed is the lowest one from a place on
/// upstream.
struct ReferenceCurve {
  struct Vertex {
    double x, w;
  };
  std::vector<Vertex> walk;
  double A_beyond = 0.0;  // of the arc beyond the last vertex
  bool no_deceleration = false;

  ReferenceCurve(const Reference& r, CurveKind kind, double anchor, double V_anchor, double V_foot, double V_top)
      : steps_(r.speed_steps(kind)), borders_(r.borders()) {
    if (!down(r, kind, anchor, V_anchor, V_foot)) {
      no_deceleration = true;
      walk = {{anchor, V_foot * V_foot}};
    }
    std::reverse(walk.begin(), walk.end());
    up(r, kind, V_top * V_top);
  }

  double walked(double x) const {
    if (x >= walk.front().x) return walk.front().w;
    for (std::size_t i = 1; i < walk.size(); ++i)
      if (x >= walk[i].x) {
        const Vertex& a = walk[i - 1];
        const Vertex& b = walk[i];
        return x == b.x ? b.w : b.w + (a.w - b.w) * ((x - b.x) / (a.x - b.x));
      }
    return walk.back().w + 2.0 * A_beyond * (walk.back().x - x);
  }
  /// V_X(d)^2.
  double w_at(double x) const {
    double lowest = walked(x);
    for (const Vertex& v : walk)
      if (v.x <= x) lowest = std::min(lowest, v.w);
    return lowest;
  }
  double foot_w() const { return w_at(walk.front().x); }
  /// d_X(V): the last place at which the train may run at this speed.
  double place_of(double w) const {
    if (walk.back().w < w) return A_beyond > 0.0 ? walk.back().x - (w - walk.back().w) / (2.0 * A_beyond) : -1e9;
    for (std::size_t i = walk.size() - 1; i-- > 0;)
      if (walk[i].w < w) {
        const Vertex& up = walk[i + 1];
        return up.x + (up.w - w) / (up.w - walk[i].w) * (walk[i].x - up.x);
      }
    return walk.front().x;
  }

 private:
  double step_above(double w) const {
    for (const double V : steps_)
      if (V * V > w) return V * V;
    return 1e18;
  }
  double step_below(double w) const {
    double below = 0.0;
    for (const double V : steps_)
      if (V * V < w) below = V * V;
    return below;
  }
  double border_below(double x) const {
    double below = -1e9;
    for (const double b : borders_)
      if (b < x) below = b;
    return below;
  }
  double border_above(double x) const {
    for (const double b : borders_)
      if (b > x) return b;
    return 1e9;
  }
  /// The deceleration at squared speed `w` with the step that includes it, or with the one above it.
  static double at(const Reference& r, CurveKind kind, double w, double x, bool above) {
    const double V = std::sqrt(w);
    return r.A(kind, above ? V * (1.0 + 1e-11) + 1e-11 : std::max(0.0, V * (1.0 - 1e-13)), x);
  }

  bool down(const Reference& r, CurveKind kind, double x, double V, double V_foot) {
    double w = V * V;
    walk.push_back({x, w});
    while (w > V_foot * V_foot) {
      const double A = at(r, kind, w, x, false);
      if (A <= 0.0) return false;
      const double lower = std::max(V_foot * V_foot, step_below(w));
      const double border = border_above(x);
      const double to_lower = (w - lower) / (2.0 * A);
      if (x + to_lower <= border) {
        x += to_lower;
        w = lower;
      } else {
        w -= 2.0 * A * (border - x);
        x = border;
      }
      walk.push_back({x, w});
    }
    return true;
  }
  void up(const Reference& r, CurveKind kind, double w_top) {
    // From the anchor, which is the last vertex now.
    double x = walk.back().x;
    double w = walk.back().w;
    while (x > -1e9) {
      const double border = border_below(x);
      const double A_above = at(r, kind, w, border, true);
      const double A_below = at(r, kind, w, border, false);
      if (A_above > 0.0) {
        A_beyond = A_above;
        if (w >= w_top) return;
        const double upper = std::min(w_top, step_above(w));
        const double to_upper = (upper - w) / (2.0 * A_above);
        if (x - to_upper >= border) {
          x -= to_upper;
          w = upper;
        } else {
          w += 2.0 * A_above * (x - border);
          x = border;
        }
      } else {
        no_deceleration = true;
        A_beyond = 0.0;
        if (A_below < 0.0 && w > 0.0) {
          const double lower = step_below(w);
          const double to_lower = (lower - w) / (2.0 * A_below);
          if (x - to_lower >= border) {
            x -= to_lower;
            w = lower;
          } else {
            w = std::max(0.0, w + 2.0 * A_below * (x - border));
            x = border;
          }
        } else {
          x = border;
        }
      }
      walk.push_back({x, w});
    }
  }

  std::vector<double> steps_;
  std::vector<double> borders_;
};

}  // namespace evc::sdm::test
