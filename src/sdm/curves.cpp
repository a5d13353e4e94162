#include "openevc/curves.h"

#include <algorithm>

#include "sdm/evaluate.h"

namespace evc::sdm {
namespace {

void decelerations(Explanation& e, const Derived& d, const Inputs& in, const Target& t, Speed V) {
  const Decelerations& A = d.decelerations;
  const Segments& track = A.segments_of(t.due_to_TSR);
  const Segment& s = track[segment_upstream_of(track, e.d_EBD)];
  const Bands& safe = A.bands(CurveKind::EBD, s);
  const Band& b = safe[band_below(safe, V * V)];
  e.A_gradient_EBD = s.A_gradient;
  e.A_safe = deceleration(b, s);
  e.A_brake_safe = b.A[0];
  const train::BrakeSet off = brakes_off(in.conditions, in.train, s.from, false);
  e.in_use_emergency = train::in_use_emergency(in.train, in.brakes, off);
  e.A_brake_emergency = train::value_below(train::A_brake_emergency(in.train, e.in_use_emergency), V);
  // The expected deceleration at the place where the SBD has the speed; without an SBD, where the
  // EBD has it.
  const Place where = e.d_SBD.value_or(e.d_EBD);
  const Segment& z = A.segments[segment_upstream_of(A.segments, where)];
  const Bands& expected = A.bands(CurveKind::SBD, z);
  const Band& service = expected[band_below(expected, V * V)];
  e.A_gradient_SBD = z.A_gradient;
  e.A_expected = deceleration(service, z);
  e.A_brake_service = service.A[0];
  e.in_use_service = train::in_use_service(in.train, in.brakes, brakes_off(in.conditions, in.train, z.from, true));
}

/// The speed whose location `place(V)` is `x`: the places decrease with increasing speed.
template <class PlaceOf>
Speed speed_of(PlaceOf place, Place x, Speed V_top) {
  Speed low{0.0};
  Speed high = V_top;
  if (place(low) <= x) return low;
  if (place(high) >= x) return high;
  for (int i = 0; i < 60; ++i) {
    const Speed middle = low + (high - low) / 2.0;
    (place(middle) >= x ? low : high) = middle;
  }
  return low;
}

}  // namespace

std::optional<FeedbackTimes> assumed_feedback(const Derived& d, const Target& t, const Assumed& assumed) {
  if (!assumed.brake_pressure || !d.time_config.feedback_available || !d.time_config.service_brake_available)
    return std::nullopt;
  const BrakePressure& b = *assumed.brake_pressure;
  FeedbackState s;
  s.p0_known = true;
  s.p0 = b.p0;
  s.started = b.started;
  s.locked = b.locked;
  return feedback_times(s, b.p, (t.zero ? d.cm0 : d.cmt).T_bs, d.fixed);
}

Explanation explain(const Derived& d, const Inputs& in, const Target& t, Speed V, Speed V_ura, Acceleration A_est,
                    const Motion* motion, const Assumed& assumed) {
  Explanation e;
  if (assumed.V_ura_of_041) V_ura = train::f41(V);
  e.approach = approach(V, d.Q_NVINHSMICPERM ? Speed{0.0} : V_ura, A_est, d.fixed);
  e.build_up = t.zero ? d.cm0 : d.cmt;
  TimesAsked asked;
  asked.feedback = assumed_feedback(d, t, assumed);
  if (d.rules.reduced_build_up) {
    if (motion != nullptr) {
      e.est_front = motion->est_front;
      e.min_safe_front = motion->min_safe_front;
    } else {
      // With unreduced times: the longest stretch of track ahead is the safe side (A.3.12.2.2-5).
      const TargetLimits earliest = limits_of(d, t, e.approach, asked);
      e.est_front = earliest.EBD.d_I;
      if (earliest.SBD.has_value()) e.est_front = std::min(e.est_front, earliest.SBD->d_I);
      e.min_safe_front = e.est_front;
    }
    asked.reduced_from = Fronts{e.est_front, e.min_safe_front};
  }
  const TargetLimits l = limits_of(d, t, e.approach, asked);
  e.times = l.times.EBD;
  e.EBD = l.EBD;
  e.SBD = l.SBD;
  e.d_EBD = d.view(t.EBD).place_at(V);
  if (t.kind == TargetKind::EOA_SvL) e.d_SBD = d.view(t.SBD).place_at(V);
  if (d.view(t.GUI).exists()) e.d_GUI = d.view(t.GUI).place_at(V);
  // EOA and SvL have a guidance curve each (3.13.8.5.2 a); the more restrictive one is displayed.
  if (d.view(t.GUI_EOA).exists()) e.d_GUI = std::min(*e.d_GUI, d.view(t.GUI_EOA).place_at(V));
  decelerations(e, d, in, t, V);
  e.d_FLOI = e.EBD.d_SBI;
  e.d_W = e.EBD.d_W;
  e.d_P = e.EBD.d_P;
  e.d_I = e.EBD.d_I;
  // The official tool of 3.4.0 draws P not beyond the target; I is not limited in this way.
  if (d.rules.pre_indication) e.d_P = std::min(e.d_P, t.d_target);
  if (e.SBD.has_value()) {
    e.d_FLOI = std::min(e.d_FLOI, e.SBD->d_SBI);
    e.d_W = std::min(e.d_W, e.SBD->d_W);
    e.d_P = std::min(e.d_P, e.SBD->d_P);
    e.d_I = std::min(e.d_I, e.SBD->d_I);
  }
  return e;
}

PositionRow speeds_at(const Derived& d, const Inputs& in, const Target& t, Place x, Speed V_ura, Acceleration A_est,
                      Distance under_reading, Distance over_reading, const Assumed& assumed) {
  PositionRow row{};
  Motion here;
  here.est_front = x;
  here.max_safe_front = x + over_reading;
  here.min_safe_front = x - under_reading;
  const Speed top = in.V_top.value_or(d.V_relevant);
  row.EBD = d.view(t.EBD).speed_at(x);
  if (t.kind == TargetKind::EOA_SvL) row.SBD = d.view(t.SBD).speed_at(x);
  const auto speed = [&](auto pick) {
    return speed_of([&](Speed V) { return pick(explain(d, in, t, V, V_ura, A_est, &here, assumed)); }, x, top);
  };
  // The limits of the EBD against the max safe front end, those of the SBD against the estimated one.
  const auto nearest = [&](const Explanation& e, Place Limits::*limit) {
    const Place EBD = e.EBD.*limit - over_reading;
    return e.SBD.has_value() ? std::min(EBD, (*e.SBD).*limit) : EBD;
  };
  row.EBI = speed([&](const Explanation& e) { return *e.EBD.d_EBI - over_reading; });
  row.SBI = speed([&](const Explanation& e) { return nearest(e, &Limits::d_SBI); });
  row.W = speed([&](const Explanation& e) { return nearest(e, &Limits::d_W); });
  // The official tool of 3.4.0 draws P not beyond the target.
  row.P = speed([&](const Explanation& e) {
    const Place d_P = nearest(e, &Limits::d_P);
    return d.rules.pre_indication ? std::min(d_P, t.d_target) : d_P;
  });
  row.I = speed([&](const Explanation& e) { return nearest(e, &Limits::d_I); });
  return row;
}

Speed ceiling_at(const Derived& d, Place x) {
  Speed V = d.mrsp.at(x);
  for (const Target& t : d.targets)
    if (t.kind == TargetKind::LOA && x >= t.d_target) V = std::min(V, t.V_target);
  return V;
}

PositionRow supervised_speeds_at(const Derived& d, const Inputs& in, const Target& t, Place x, Speed V_ura,
                                 Acceleration A_est, Distance under_reading, Distance over_reading,
                                 const Assumed& assumed) {
  PositionRow row = speeds_at(d, in, t, x, V_ura, A_est, under_reading, over_reading, assumed);
  const Speed M = ceiling_at(d, x);
  const auto within = [&](Speed limit, Speed floor, Speed ceiling) {
    return std::min(std::max(limit, floor), ceiling);
  };
  const auto with_margin = [&](Speed limit, Speed (*margin)(Speed, const train::FixedValues&)) {
    Speed floor{0.0};
    if (!t.zero) floor = t.V_target + margin(t.V_target, d.fixed);
    if (t.kind == TargetKind::EOA_SvL && d.release_speed.exists && x <= t.d_target) floor = d.release_speed.V_release;
    return within(limit, floor, M + margin(M, d.fixed));
  };
  row.EBI = with_margin(row.EBI, dV_ebi);
  row.SBI = with_margin(row.SBI, dV_sbi);
  row.W = with_margin(row.W, dV_warning);
  row.P = within(row.P, t.V_target, M);
  row.I = within(row.I, t.V_target, M);
  return row;
}

}  // namespace evc::sdm
