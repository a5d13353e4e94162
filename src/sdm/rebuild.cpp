#include <algorithm>

#include "sdm/evaluate.h"
#include "sdm/supervision.h"

// Results of track, train and national values alone: targets with their curves, release speed, pre-indication and
// perturbation locations.
namespace evc::sdm {
namespace {

constexpr Speed kMargin{100.0 / 3.6};
/// Room kept for the curves of the end of authority and of the SR distance.
constexpr std::size_t kReserved = 6 * kMaxKnots;

/// The highest speed from step `n` on.
Speed highest(const Mrsp& mrsp, std::size_t n = 0) {
  Speed V{};
  for (; n < mrsp.size(); ++n) V = std::max(V, mrsp.steps[n].value);
  return V;
}

class Builder {
 public:
  Builder(Derived& out, const Inputs& in) : d_(out), in_(in) {}

  void config() {
    d_.rules = rules_of(in_.srs);
    d_.fixed = in_.fixed;
    d_.cm0 = train::build_up_times(in_.train, in_.national_values, in_.brakes, true);
    d_.cmt = train::build_up_times(in_.train, in_.national_values, in_.brakes, false);
    d_.time_config = time_config(in_.train, in_.national_values);
    d_.service_brake_interface = in_.train.service_brake_interface;
    d_.traction_cut_off_interface = in_.train.traction_cut_off_interface;
    d_.Q_NVEMRRLS = in_.national_values.Q_NVEMRRLS;
    d_.Q_NVINHSMICPERM = in_.national_values.Q_NVINHSMICPERM;
    d_.csm_display = d_.rules.first_indication ? train::A_MAXREDADH(in_.train, in_.national_values, in_.brakes).display
                                               : train::MaxReducedAdhesion::Display::none;
    d_.mrsp = in_.mrsp;
    d_.targets.clear();
    d_.knots_used = 0;
    d_.release_speed = {};
    d_.perturbation = {};
    d_.no_deceleration = false;
    determine(d_.decelerations, in_.train, in_.national_values, in_.fixed, in_.brakes, in_.gradient, in_.conditions);
    d_.truncated = false;
    d_.guidance = in_.national_values.Q_NVGUIPERM && !d_.decelerations.normal_service[0].empty();
    const Speed top = std::max(in_.train.V_MAXTRAIN, highest(in_.mrsp));
    V_top_ = in_.V_top.value_or(top + kMargin);
    d_.V_relevant = std::min(top + dV_ebi(top, in_.fixed) + 0.5 * kMargin, V_top_);
  }

  void MRSP_targets() {
    if (!in_.supervise_targets) return;
    Speed before{};
    for (std::size_t i = 0; i < in_.mrsp.size(); ++i) {
      const auto& step = in_.mrsp.steps[i];
      if (step.value < before) {
        if (!room_for_MRSP_target()) {
          squeeze(i);
          return;
        }
        Target t;
        t.V_target = step.value;
        t.d_target = step.from;
        t.due_to_TSR = in_.mrsp_due_to_TSR[i];
        add(t);
      }
      // 4.0.0: every element lower than one before it; else decreases only.
      before = d_.rules.all_lower_elements_are_targets ? std::max(before, step.value) : step.value;
    }
  }

  void authority() {
    const Authority& a = in_.authority;
    const bool alone = a.kind == Authority::Kind::LOA;
    if (alone || (a.kind == Authority::Kind::EOA_SvL && a.LOA_besides.has_value())) {
      Target t;
      t.kind = TargetKind::LOA;
      t.V_target = a.V_LOA;
      t.d_target = alone ? a.EOA : *a.LOA_besides;
      add(t);
    }
    if (a.kind == Authority::Kind::EOA_SvL) {
      Target t;
      t.kind = TargetKind::EOA_SvL;
      t.d_target = a.SvL;
      t.d_EOA = a.EOA;
      add(t);
    }
    if (in_.SR_end.has_value()) {
      Target t;
      t.kind = TargetKind::SR_end;
      t.d_target = *in_.SR_end;
      add(t);
    }
  }

  void release_speed();
  void perturbation();
  void pre_indications();

 private:
  CurveRef curve(CurveKind kind, bool due_to_TSR, Place anchor, Speed V_anchor, Speed V_foot, CurveWarnings& w) {
    std::size_t used = d_.knots_used;
    const std::size_t first = used;
    EVC_REQUIRE(first + kMaxKnots <= kKnotPool);
    // There is room for every curve: kReserved, and the room checked by room_for_MRSP_target.
    const CurveWarnings met = trace({d_.knots.data(), first + kMaxKnots}, used, d_.decelerations, kind, due_to_TSR,
                                    anchor, V_anchor, V_foot, V_top_);
    d_.knots_used = static_cast<std::uint16_t>(used);
    w.no_deceleration = w.no_deceleration || met.no_deceleration;
    w.truncated = w.truncated || met.truncated;
    return {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(used - first)};
  }

  /// Room for two curves, plus that for the ends of authority and of the SR distance: two targets and their curves.
  bool room_for_MRSP_target() const {
    return d_.targets.size() + 2 < kTargets && kKnotPool - d_.knots_used >= kReserved + 2 * kMaxKnots;
  }

  /// Traces the target's curves.
  void add(Target& t) {
    trace_curves(t);
    const bool room = d_.targets.push_back(t);
    EVC_REQUIRE(room);
  }

  void trace_curves(Target& t) {
    t.zero = t.V_target.si <= 0.0;
    const bool at_speed = t.kind == TargetKind::MRSP || t.kind == TargetKind::LOA;
    const Speed V_anchor = at_speed ? t.V_target + dV_ebi(t.V_target, in_.fixed) : Speed{0.0};
    t.EBD = curve(CurveKind::EBD, t.due_to_TSR, t.d_target, V_anchor, t.V_target, t.warnings);
    if (t.kind == TargetKind::EOA_SvL) t.SBD = curve(CurveKind::SBD, false, t.d_EOA, {}, {}, t.warnings);
    const CurveView EBD = d_.view(t.EBD);
    t.foot = EBD.place_at(t.V_target);
    const train::BuildUpTimes& build_up = t.zero ? d_.cm0 : d_.cmt;
    t.d_P_target = d_P_at_target_speed(EBD, t.V_target, t.d_target,
                                       times(d_.time_config, build_up, std::nullopt, d_.rules, d_.fixed), build_up,
                                       d_.time_config, V_delta0_41(d_, t.V_target), d_.rules, d_.fixed);
    if (d_.guidance) {
      // 3.13.8.5.2: foot at EOA and SvL, else where P has the target speed.
      const Place foot = t.kind == TargetKind::EOA_SvL ? t.d_target : t.d_P_target;
      t.GUI = curve(CurveKind::GUI, t.due_to_TSR, foot, t.V_target, t.V_target, t.warnings);
      if (t.kind == TargetKind::EOA_SvL) t.GUI_EOA = curve(CurveKind::GUI, false, t.d_EOA, {}, {}, t.warnings);
    }
    d_.no_deceleration = d_.no_deceleration || t.warnings.no_deceleration;
    d_.truncated = d_.truncated || t.warnings.truncated;
  }

  /// No room for the MRSP targets from step `i` on: the last target gets the lowest of their speeds.
  void squeeze(std::size_t i) {
    d_.truncated = true;
    Target& last = d_.targets.back();
    // The default gradient of a TSR applies to all of them if it is a fall, else to none.
    const bool falling = in_.gradient.default_for_TSR.value_or(0.0) < 0.0;
    for (; i < in_.mrsp.size(); ++i) {
      last.V_target = std::min(last.V_target, in_.mrsp.steps[i].value);
      last.due_to_TSR = falling ? last.due_to_TSR || in_.mrsp_due_to_TSR[i] : last.due_to_TSR && in_.mrsp_due_to_TSR[i];
    }
    d_.knots_used = last.EBD.first;
    trace_curves(last);
  }

  struct Reference {
    std::optional<Place> d;  // d_ref of 3.13.11.5-6
    Speed V{};               // V_n of its element
  };
  /// First element n that contains the Indication limit for its speed, or whose limit is beyond its end while that of
  /// the next element is before it. `skip_below`: elements slower than the LOA's speed (3.13.11.7.1).
  Reference reference(const Target& t, bool SBD, Speed skip_below) const;

  /// Where the first element of the MRSP begins.
  Place start_of_MRSP() const {
    const Place first = in_.mrsp.steps.front().from;
    return std::max(first, in_.track_description_from.value_or(first));
  }

  bool below_MRSP_at_start(const Target& t, bool SBD) const {
    const Place start = start_of_MRSP();
    const Speed V = in_.mrsp.at(start);
    const CurveView c = d_.view(SBD ? t.SBD : t.EBD);
    const CurveView g = d_.view(SBD ? t.GUI_EOA : t.GUI);
    return c.speed_at(start) < V || (g.exists() && g.speed_at(start) < V);
  }

  void search_release_speed(const Target& EOA_SvL);
  Speed on_board_release_speed(const Target& t, Place d_trip) const;

  Derived& d_;
  const Inputs& in_;
  Speed V_top_{};
};

Builder::Reference Builder::reference(const Target& t, bool SBD, Speed skip_below) const {
  // Without acceleration, with f41 of the element's speed, without feedback (3.13.11.3); no d_target cap
  // (3.13.11.4).
  const Times T = times(d_.time_config, t.zero ? d_.cm0 : d_.cmt, std::nullopt, d_.rules, d_.fixed);
  const CurveView curve = d_.view(SBD ? t.SBD : t.EBD);
  const CurveView GUI = d_.view(SBD ? t.GUI_EOA : t.GUI);
  const auto d_I = [&](Speed V) {
    const Approach a{.V = V, .V_delta0 = V_delta0_41(d_, V), .A_est1 = {}, .A_est2 = {}};
    return SBD ? limits_of_SBD(curve, GUI, a, T, d_.fixed).d_I
               : limits_of_EBD(curve, GUI, a, T, t.V_target, std::nullopt, d_.fixed).d_I;
  };
  const auto& steps = in_.mrsp.steps;
  std::optional<Place> known;  // d_I of element n, from the step before
  for (std::size_t n = in_.mrsp.index_at(start_of_MRSP()); n < steps.size() && steps[n].from < t.d_target; ++n) {
    const Speed V = steps[n].value;
    const std::optional<Place> of_this = known;
    known.reset();
    if (V < skip_below) continue;
    const Place a = std::max(steps[n].from, start_of_MRSP());
    const Place here = of_this.has_value() ? *of_this : d_I(V);
    const bool last = n + 1 == steps.size();
    if (a < here && (last || here <= steps[n + 1].from)) return {here, V};
    if (last || here <= a || steps[n + 1].value < skip_below) continue;
    known = d_I(steps[n + 1].value);
    if (*known < steps[n + 1].from) return {steps[n + 1].from, V};
  }
  return {};
}

void Builder::pre_indications() {
  if (!d_.rules.pre_indication || in_.mrsp.empty()) return;
  const Place start = start_of_MRSP();
  for (Target& t : d_.targets) {
    const auto place = [&](bool SBD) -> std::optional<Place> {
      const Reference r = reference(t, SBD, t.kind == TargetKind::LOA ? t.V_target : Speed{0.0});
      if (!r.d.has_value()) return std::nullopt;
      return *r.d - r.V * in_.fixed.T_preindication;
    };
    t.d_preindication_EBD = place(false);
    if (t.kind == TargetKind::EOA_SvL) t.d_preindication_SBD = place(true);
    const auto before = [start](const std::optional<Place>& d) { return !d.has_value() || *d < start; };
    t.preindication_passed_at_once = before(t.d_preindication_EBD) || below_MRSP_at_start(t, false);
    if (t.kind == TargetKind::EOA_SvL)
      t.preindication_passed_at_once =
          t.preindication_passed_at_once || before(t.d_preindication_SBD) || below_MRSP_at_start(t, true);
    // 3.4.0: no braking for an LOA faster than all elements before it.
    if (t.kind == TargetKind::LOA && !t.d_preindication_EBD.has_value() &&
        t.V_target >= highest(in_.mrsp, in_.mrsp.index_at(start)))
      t.preindication_passed_at_once = false;
  }
}

void Builder::perturbation() {
  if (in_.mrsp.empty()) return;
  for (const Target& t : d_.targets) {
    if (t.kind == TargetKind::LOA) {
      const Reference r = reference(t, false, t.V_target);
      // 3.13.11.7.1.1-2: at the LOA at the latest.
      d_.perturbation.from_EBD = std::min(r.d.value_or(t.d_target), t.d_target);
      d_.perturbation.passed_at_once = below_MRSP_at_start(t, false);
    }
    if (t.kind == TargetKind::EOA_SvL) {
      // After an LOA, where there is one too: the first of both asks. A place that is not found is passed.
      const std::optional<Place> of_SvL = reference(t, false, Speed{0.0}).d;
      if (of_SvL && in_.authority.LOA_besides)
        d_.perturbation.from_EBD = std::min(*of_SvL, *d_.perturbation.from_EBD);
      else
        d_.perturbation.from_EBD = of_SvL;
      d_.perturbation.from_SBD = reference(t, true, Speed{0.0}).d;
      d_.perturbation.passed_at_once =
          d_.perturbation.passed_at_once || below_MRSP_at_start(t, false) || below_MRSP_at_start(t, true);
    }
  }
}

/// 3.13.9.4.8.2 for one target: the lowest speed above V_target that satisfies both conditions, else
/// V_target. V - (V_EBD(x(V)) - V_d0(V)) grows with V, so bisection finds the speed where it is -1 km/h.
Speed Builder::on_board_release_speed(const Target& t, Place d_trip) const {
  const Authority& a = in_.authority;
  const train::BuildUpTimes& build_up = t.zero ? d_.cm0 : d_.cmt;
  TimeConfig config = d_.time_config;
  const bool with_D41 = d_.rules.release_speed_with_D41;
  if (with_D41) config.traction_cut_off_interface = false;
  const Times T = times(config, build_up, std::nullopt, d_.rules, d_.fixed);
  const CurveView EBD = d_.view(t.EBD);
  const auto V_delta0 = [&](Speed V) { return d_.Q_NVINHSMICPERM ? Speed{0.0} : std::max(train::f41(V), a.V_ura); };
  const auto place = [&](Speed V) {
    const Speed v = V + V_delta0(V);
    Place x = d_trip + v * (T.T_traction + T.T_berem);
    if (with_D41 && a.level_1_at_EOA) x = x + v * d_.fixed.T41_eoa;
    return x;
  };
  const auto excess = [&](Speed V) { return V - (EBD.speed_at(place(V)) - V_delta0(V)); };
  Speed low = t.V_target;
  if (excess(low) >= -d_.fixed.search_tolerance) return t.V_target;
  Speed high = V_top_;
  if (excess(high) < -d_.fixed.search_tolerance) return t.V_target;
  for (int i = 0; i < 60; ++i) {
    const Speed middle = low + (high - low) / 2.0;
    (excess(middle) >= -d_.fixed.search_tolerance ? high : low) = middle;
  }
  // The excess grows continuously, so it is not above the tolerance either.
  return place(high) <= t.foot ? high : t.V_target;
}

void Builder::search_release_speed(const Target& EOA_SvL) {
  ReleaseSpeed& r = d_.release_speed;
  r.V_release = on_board_release_speed(EOA_SvL, r.d_trip);
  for (const Target& t : d_.targets)
    if (t.kind == TargetKind::MRSP && t.d_target >= r.d_trip && t.d_target <= EOA_SvL.d_target)
      r.V_release = std::min(r.V_release, on_board_release_speed(t, r.d_trip));
}

void Builder::release_speed() {
  const Authority& a = in_.authority;
  ReleaseSpeed& r = d_.release_speed;
  const Target* found = nullptr;
  for (const Target& t : d_.targets)
    if (t.kind == TargetKind::EOA_SvL) found = &t;
  if (found == nullptr || a.temporary || a.release_speed == ReleaseSpeedChoice::none) return;
  const Target& EOA_SvL = *found;
  const Distance alpha = a.level_1_at_EOA ? in_.train.L_antenna_front : Distance{0.0};
  Distance predicted =
      2.0 * a.Q_LOCACC_reference + d_.fixed.d_trip_constant + d_.fixed.d_trip_relative * (a.EOA - a.reference);
  if (d_.rules.release_speed_with_D41) predicted += a.L_train_doubt;
  r.d_trip = a.EOA + alpha + std::max(predicted, a.confidence_interval);
  r.on_board = a.release_speed == ReleaseSpeedChoice::on_board;
  if (r.on_board)
    search_release_speed(EOA_SvL);
  else
    r.V_release = a.release_speed == ReleaseSpeedChoice::national ? in_.national_values.V_NVREL : a.V_release;
  // 3.13.9.4.9: not above the MRSP between the presumed start and the trip location.
  RsmStart start = rsm_start(d_, EOA_SvL, r.V_release, r.d_trip, r.on_board, {});
  Place from = std::min(start.d_SBI1, start.d_SBI2);
  if (d_.rules.release_speed_with_D41) from = from - a.confidence_interval;
  Speed lowest = r.V_release;
  for (std::size_t i = 0; i < in_.mrsp.size(); ++i) {
    const bool ends_before = i + 1 < in_.mrsp.size() && in_.mrsp.steps[i + 1].from <= from;
    if (ends_before || in_.mrsp.steps[i].from > r.d_trip) continue;
    lowest = std::min(lowest, in_.mrsp.steps[i].value);
  }
  r.V_release = lowest;
  start = rsm_start(d_, EOA_SvL, r.V_release, r.d_trip, r.on_board, {});
  r.d_SBI1 = start.d_SBI1;
  r.d_SBI2 = start.d_SBI2;
  // A release speed of 0 would brake every movement before the EOA: it counts as none, and the
  // curves are supervised to their feet.
  r.exists = r.V_release.si > 0.0;
}

}  // namespace

bool rebuild(Derived& out, const Inputs& in) {
  if (out.valid && out.revision == in.revision) return false;
  Builder builder(out, in);
  builder.config();
  builder.MRSP_targets();
  builder.authority();
  builder.pre_indications();
  builder.release_speed();
  builder.perturbation();
  out.revision = in.revision;
  out.valid = true;
  return true;
}

}  // namespace evc::sdm
