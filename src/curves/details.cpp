#include "curves/details.h"

#include <algorithm>
#include <cmath>

#include "sdm/evaluate.h"

// What the official tool shows beside the curves: ceilings, times, locations, the arcs, several targets.
namespace evc::curves {
namespace {

Value kmh(Speed V) { return rounded_kmh(V); }

const char* kind_name(sdm::TargetKind kind) {
  switch (kind) {
    case sdm::TargetKind::MRSP:
      return "MRSP";
    case sdm::TargetKind::LOA:
      return "LOA";
    case sdm::TargetKind::EOA_SvL:
      return "EOA_SvL";
    case sdm::TargetKind::SR_end:
      return "SR";
  }
  return "";
}

/// Where distances of a target are measured from: the EOA, not its SvL.
Place location_of(const sdm::Target& t) { return t.kind == sdm::TargetKind::EOA_SvL ? t.d_EOA : t.d_target; }

/// 3.13.9.2: the margins above a speed that is the ceiling, and the ceilings with them.
ResultTable ceilings(const Approached& a) {
  ResultTable table{"ceilings",
                    "ceilings above a speed of the MRSP, in km/h",
                    {{"v_kmh", "km/h"},
                     {"dV_warning", "km/h", 3},
                     {"dV_sbi", "km/h", 3},
                     {"dV_ebi", "km/h", 3},
                     {"W", "km/h", 3},
                     {"SBI", "km/h", 3},
                     {"EBI", "km/h", 3}},
                    {}};
  const train::FixedValues& f = a.derived().fixed;
  for (const double v : a.input().speeds_kmh) {
    const Speed V{v / kKmh};
    const Speed warning = sdm::dV_warning(V, f), sbi = sdm::dV_sbi(V, f), ebi = sdm::dV_ebi(V, f);
    table.rows.push_back({v, kmh(warning), kmh(sbi), kmh(ebi), kmh(V + warning), kmh(V + sbi), kmh(V + ebi)});
  }
  return table;
}

/// The deceleration of a train that follows the Permitted speed at this speed: v dv/dx of P.
Value A_along_P(const Approached& a, double v_kmh) {
  constexpr double kHalf_kmh = 0.05;
  const double low = std::max(v_kmh - kHalf_kmh, 0.0), high = v_kmh + kHalf_kmh;
  const Value nearer = speed_row(a, low).P, farther = speed_row(a, high).P;
  if (!nearer || !farther || !(*farther > *nearer)) return std::nullopt;
  return (high * high - low * low) / (kKmh * kKmh) / (2.0 * (*farther - *nearer));
}

ResultTable times(const Approached& a) {
  ResultTable table{"times",
                    "times, and what the train does until its emergency brake has its full effort, by speed",
                    {{"v_kmh", "km/h"},
                     {"V_ura_kmh", "km/h", 2},
                     {"T_be_s", "s", 2},
                     {"T_bs_s", "s", 2},
                     {"T_bs1_s", "s", 2},
                     {"T_bs2_s", "s", 2},
                     {"T_traction_s", "s", 2},
                     {"T_berem_s", "s", 2},
                     {"T_indication_s", "s", 2},
                     {"V_bec_kmh", "km/h", 2},
                     {"D_bec_m", "m"},
                     {"T_I_to_P_s", "s", 2},
                     {"A_along_P", "m/s2", 3}},
                    {}};
  for (const double v : a.input().speeds_kmh) {
    const sdm::Explanation e = a.explain(Speed{v / kKmh});
    const sdm::TargetTimes both = a.times_of(e);
    const SpeedRow row = speed_row(a, v);
    Value I_to_P;
    if (row.I && row.P && v > 0.0) I_to_P = (*row.I - *row.P) / (v / kKmh);
    table.rows.push_back({v, kmh(a.V_ura_at(Speed{v / kKmh})), both.EBD.T_be.si, both.EBD.T_bs.si,
                          (e.SBD ? both.SBD : both.EBD).T_bs1.si, both.EBD.T_bs2.si, both.EBD.T_traction.si,
                          both.EBD.T_berem.si, both.EBD.T_indication.si, kmh(e.EBD.loss.V_bec), e.EBD.loss.D_bec.si,
                          I_to_P, A_along_P(a, v)});
  }
  return table;
}

/// Curves and limits as places of the line.
ResultTable locations(const Approached& a) {
  ResultTable table{"locations", "places along the line in m, by speed", {{"v_kmh", "km/h"}}, {}};
  for (const auto& c : curve_columns()) table.columns.push_back({c.name, "m"});
  const double target = m(a.input().target_location);
  for (const double v : a.input().speeds_kmh) {
    const SpeedRow row = speed_row(a, v);
    std::vector<Cell> cells{v};
    for (const auto& c : curve_columns()) {
      const Value& before = row.*c.value;
      cells.emplace_back(before ? Value(target - *before) : std::nullopt);
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Places that do not depend on a speed.
ResultTable fixed_locations(const Approached& a) {
  ResultTable table{"fixed_locations",
                    "places along the line that depend on no speed, in m",
                    {{"location", ""}, {"at_m", "m", 2}, {"before_target_m", "m", 2}},
                    {}};
  const sdm::Target& t = a.target();
  const auto add = [&](const char* name, Place place) {
    if (is_somewhere(place)) table.rows.push_back({name, Value(m(place)), Value(a.before_target(place))});
  };
  const bool EOA = t.kind == sdm::TargetKind::EOA_SvL;
  add(EOA ? "EOA" : "d_target", location_of(t));
  if (EOA) add("SvL", t.d_target);
  add("d_EBD(V_target)", t.foot);
  add("d_P(V_target)", t.d_P_target);
  if (EOA && a.derived().release_speed.exists) add("d_trip_EOA", a.derived().release_speed.d_trip);
  if (const auto start = a.start_of_RSM()) add("start of RSM", *start);
  return table;
}

/// Every arc of every curve, from its foot upstream: v^2 = v_to^2 + 2 A (to - x).
ResultTable arcs(const Approached& a) {
  ResultTable table{"arcs",
                    "arcs of the braking curves, from the foot upstream (A 0: level)",
                    {{"target", "", 0},
                     {"curve", ""},
                     {"from_m", "m", 3},
                     {"to_m", "m", 3},
                     {"v_from_kmh", "km/h", 3},
                     {"v_to_kmh", "km/h", 3},
                     {"A", "m/s2", 5}},
                    {}};
  const sdm::Derived& d = a.derived();
  for (std::size_t i = 0; i < d.targets.size(); ++i) {
    const sdm::Target& t = d.targets[i];
    if (!a.input().details.targets && &t != &a.target()) continue;
    const auto add = [&](const char* name, sdm::CurveRef ref) {
      const sdm::CurveView curve = d.view(ref);
      for (std::size_t k = 0; k < curve.knots.size(); ++k) {
        const sdm::Knot& knot = curve.knots[k];
        if (!is_somewhere(knot.x)) break;
        // The last arc goes on without end.
        const sdm::Knot* up = k + 1 < curve.knots.size() ? &curve.knots[k + 1] : nullptr;
        const bool ends = up != nullptr && is_somewhere(up->x);
        table.rows.push_back({static_cast<double>(i + 1), name, ends ? Value(m(up->x)) : std::nullopt, Value(m(knot.x)),
                              ends ? Value(std::sqrt(up->w.si) * kKmh) : std::nullopt,
                              Value(std::sqrt(knot.w.si) * kKmh), Value(knot.A.si)});
      }
    };
    add("EBD", t.EBD);
    add("SBD", t.SBD);
    add("GUI", t.GUI);
    add("GUI_EOA", t.GUI_EOA);
  }
  return table;
}

/// The limits towards every target on the way, metres before the location of each.
ResultTable targets(const Approached& a) {
  ResultTable table{"targets",
                    "every target: metres before its own location, by speed",
                    {{"target", "", 0},
                     {"type", ""},
                     {"location_m", "m"},
                     {"V_target_kmh", "km/h"},
                     {"due_to_TSR", "", 0},
                     {"v_kmh", "km/h"}},
                    {}};
  for (const auto& c : curve_columns()) table.columns.push_back({c.name, "m"});
  const sdm::Derived& d = a.derived();
  for (std::size_t i = 0; i < d.targets.size(); ++i) {
    const sdm::Target& t = d.targets[i];
    for (const double v : a.input().speeds_kmh) {
      // Below its speed a target supervises nothing (3.13.10.4, Table 8).
      if (Speed{v / kKmh} < t.V_target) continue;
      const SpeedRow row = speed_row(a, v, t, location_of(t));
      std::vector<Cell> cells{static_cast<double>(i + 1), kind_name(t.kind),
                              Value(m(location_of(t))),   kmh(t.V_target),
                              t.due_to_TSR ? 1.0 : 0.0,   v};
      for (const auto& c : curve_columns()) cells.emplace_back(row.*c.value);
      table.rows.push_back(std::move(cells));
    }
  }
  return table;
}

/// The target distance as displayed at the train's place (3.13.10.4.2, 3.13.9.3.5.9).
double target_distance(const Approached& a, Place est_front, Place max_safe_front) {
  const sdm::Target& t = a.target();
  const Distance to_target = (t.kind == sdm::TargetKind::EOA_SvL ? t.d_target : t.d_P_target) - max_safe_front;
  const Distance nearest = t.kind == sdm::TargetKind::EOA_SvL ? std::min(t.d_EOA - est_front, to_target) : to_target;
  return std::max(nearest.si, 0.0);
}

/// What a train at `state.est_front_m` is shown with its confidence interval, and with an exactly known position.
ResultTable confidence_interval(const Approached& a) {
  ResultTable table{"confidence_interval",
                    "at the train's place: with its confidence interval, and with an exactly known position",
                    {{"value", ""}, {"unit", ""}, {"with", ""}, {"exact", ""}, {"difference", ""}},
                    {}};
  const auto add = [&](const char* name, const char* unit, double with, double exact) {
    table.rows.push_back({name, unit, with, exact, with - exact});
  };
  const sdm::Motion& motion = *a.input().motion;
  const double here = m(motion.est_front);
  const PositionRow with = position_row(a, here, true);
  const PositionRow exact = position_row(a, here, false);
  for (const auto& c : position_columns())
    if (with.*c.value && exact.*c.value) add(c.name, "km/h", *(with.*c.value), *(exact.*c.value));
  add("target_distance", "m", target_distance(a, motion.est_front, motion.max_safe_front),
      target_distance(a, motion.est_front, motion.est_front));
  const auto start = a.start_of_RSM();
  const auto start_exact = a.start_of_RSM_at(Distance{0.0});
  if (start && start_exact && is_somewhere(*start))
    add("d_start_RSM", "m", a.before_target(*start), a.before_target(*start_exact));
  return table;
}

}  // namespace

std::vector<ResultTable> detail_tables(const Approached& a) {
  const io::CurvesDetails& asked = a.input().details;
  std::vector<ResultTable> tables;
  if (asked.ceilings) tables.push_back(ceilings(a));
  if (asked.times) tables.push_back(times(a));
  if (asked.locations) {
    tables.push_back(locations(a));
    tables.push_back(fixed_locations(a));
  }
  if (asked.arcs) tables.push_back(arcs(a));
  if (asked.targets) tables.push_back(targets(a));
  if (asked.confidence_interval) tables.push_back(confidence_interval(a));
  return tables;
}

}  // namespace evc::curves
