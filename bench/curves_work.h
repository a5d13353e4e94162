#pragma once
#include <cstdlib>

#include "openevc/curves.h"
#include "sdm/evaluate.h"

// The data of the benchmarks of speed and distance monitoring.
namespace evc::bench {

using namespace evc::sdm;

inline Speed kmh(double v) { return {v / 3.6}; }

inline void append(GradientFunction& g, double from, double permille) {
  if (!g.append({{from}}, permille)) std::abort();
}
inline void append(Mrsp& m, double from, double v) {
  if (!m.append({{from}}, kmh(v))) std::abort();
}

/// Busy full supervision: 10 km of authority, 20 gradient steps, 10 speed steps, 2 of them TSRs, and
/// `targets` targets in all.
inline Inputs busy(int targets, int gradients = 20) {
  Inputs in;
  in.revision = 1;
  for (int i = 0; i < gradients; ++i)
    append(in.gradient.permille, -500.0 + i * 10500.0 / gradients, (i * 7 % 25) - 12.0);
  append(in.mrsp, -500.0, 160.0);
  // Decreases make the targets; a few increases between them.
  const int decreases = targets - 1;
  for (int i = 0; i < decreases; ++i) {
    const double from = 1200.0 + i * 8500.0 / decreases;
    if (i % 4 == 1 && decreases < 20) append(in.mrsp, from - 300.0, 150.0);
    append(in.mrsp, from, decreases < 20 ? 140.0 - 10.0 * (i % 9) - 2.0 * i : 160.0 - 2.0 * i - 1.0);
  }
  in.mrsp_due_to_TSR[3] = in.mrsp_due_to_TSR[5] = true;
  in.authority.kind = Authority::Kind::EOA_SvL;
  in.authority.EOA = {{10000.0}};
  in.authority.SvL = {{10050.0}};
  in.authority.release_speed = ReleaseSpeedChoice::value;
  in.authority.V_release = kmh(30.0);
  return in;
}

inline Motion running(double x, double v) {
  Motion m;
  m.est_front = {{x}};
  m.max_safe_front = {{x + 20.0}};
  m.min_safe_front = {{x - 20.0}};
  m.V_est = kmh(v);
  m.V_ura = kmh(2.0);
  m.A_est = {0.2};
  m.T_MAR = Duration{20.0};
  return m;
}

inline train::TrainData gamma_train() {
  train::TrainData t;
  t.brake_model = train::BrakeModel::gamma;
  train::EmergencyModel e;
  train::ServiceModel s;
  for (int i = 0; i < 5; ++i) {
    train::EmergencyStep step;
    step.A_brake_emergency = {1.1 - 0.08 * i};
    step.Kwet_rst = train::Factor::of(0.95);
    step.Kdry_rst.fill(train::Factor::of(0.85));
    if (!e.steps.append(kmh(40.0 * i), step)) std::abort();
    if (!s.A_brake_service.append(kmh(40.0 * i), {0.9 - 0.08 * i})) std::abort();
  }
  if (!t.emergency.push_back(e) || !t.service.push_back(s)) std::abort();
  if (!t.T_emergency.push_back({{2.5}, {1.0}, 0}) || !t.T_service.push_back({{3.0}, {1.2}, 0})) std::abort();
  return t;
}

/// Raw track and train data of one gamma target over 20 gradient steps.
inline Inputs gamma_target() {
  Inputs in = busy(1);
  in.mrsp = {};
  append(in.mrsp, -500.0, 160.0);
  in.train = gamma_train();
  return in;
}
/// Computes all curves and the limits of one speed from them.
inline auto gamma_from_raw(Derived& d, Inputs& in) {
  ++in.revision;
  rebuild(d, in);
  return limits_of(d, d.targets.back(), approach(kmh(140.0), {0.5}, {0.2}, d.fixed), {});
}

}  // namespace evc::bench
