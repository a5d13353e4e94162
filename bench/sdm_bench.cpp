// Cost of speed and distance monitoring: curves, limits, a rebuild, a cycle.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdlib>
#include <memory>

#include "sdm/curves.h"
#include "sdm/evaluate.h"

namespace {

using namespace evc;
using namespace evc::sdm;

Speed kmh(double v) { return {v / 3.6}; }

void append(GradientFunction& g, double from, double permille) {
  if (!g.append({{from}}, permille)) std::abort();
}
void append(Mrsp& m, double from, double v) {
  if (!m.append({{from}}, kmh(v))) std::abort();
}

/// Busy full supervision: 10 km of authority, 20 gradient steps, 10 speed steps, 2 of them TSRs, and
/// `targets` targets in all.
Inputs busy(int targets, int gradients = 20) {
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

Motion running(double x, double v) {
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

train::TrainData gamma_train() {
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

/// One braking curve over 24 arcs.
void curve(benchmark::State& state) {
  Inputs in = busy(2, static_cast<int>(state.range(0)));
  Decelerations d;
  determine(d, in.train, in.national_values, in.fixed, in.brakes, in.gradient, in.conditions);
  std::array<Knot, kMaxKnots> room{};
  std::size_t arcs = 0;
  for (auto _ : state) {
    std::size_t used = 0;
    trace(room, used, d, CurveKind::EBD, false, {{10000.0}}, {}, {}, kmh(500.0));
    benchmark::DoNotOptimize(room);
    arcs = used - 1;
  }
  state.counters["arcs"] = static_cast<double>(arcs);
}
BENCHMARK(curve)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Arg(80);

/// All limits of one target for one speed.
void limits_of_one_target(benchmark::State& state) {
  const Inputs in = busy(2);
  auto d = std::make_unique<Derived>();
  rebuild(*d, in);
  const Target& t = d->targets.back();
  double v = 20.0;
  for (auto _ : state) {
    const Approach a = approach({v}, {0.5}, {0.2}, d->fixed);
    benchmark::DoNotOptimize(limits_of(*d, t, a, {}));
    v = v > 40.0 ? 20.0 : v + 0.1;
  }
}
BENCHMARK(limits_of_one_target);

void rebuild_all(benchmark::State& state) {
  Inputs in = busy(static_cast<int>(state.range(0)));
  auto d = std::make_unique<Derived>();
  for (auto _ : state) {
    ++in.revision;
    rebuild(*d, in);
    benchmark::DoNotOptimize(*d);
  }
  state.counters["targets"] = static_cast<double>(d->targets.size());
  state.counters["knots"] = d->knots_used;
}
BENCHMARK(rebuild_all)->Arg(2)->Arg(8)->Arg(16)->Arg(32)->Arg(48);

/// Rebuilt, and every target's limits evaluated in a cycle.
void rebuild_and_supervise(benchmark::State& state) {
  Inputs in = busy(static_cast<int>(state.range(0)));
  auto d = std::make_unique<Derived>();
  Supervision s;
  const Motion m = running(800.0, 150.0);
  for (auto _ : state) {
    ++in.revision;
    rebuild(*d, in);
    benchmark::DoNotOptimize(supervise(s, *d, m));
  }
}
BENCHMARK(rebuild_and_supervise)->Arg(8)->Arg(48);

void supervise_cached(benchmark::State& state) {
  Inputs in = busy(static_cast<int>(state.range(0)));
  in.srs = static_cast<train::SrsVersion>(state.range(1));
  auto d = std::make_unique<Derived>();
  rebuild(*d, in);
  Supervision s;
  double x = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(supervise(s, *d, running(x, 140.0)));
    x = x > 9000.0 ? 0.0 : x + 4.0;
  }
}
BENCHMARK(supervise_cached)->ArgsProduct({{8, 16, 32, 48}, {0, 1, 2}});

/// From raw track and train data to all curves and limits of one target of a gamma train.
void gamma_from_raw(benchmark::State& state) {
  Inputs in = busy(1);
  in.mrsp = {};
  append(in.mrsp, -500.0, 160.0);
  in.train = gamma_train();
  auto d = std::make_unique<Derived>();
  for (auto _ : state) {
    ++in.revision;
    rebuild(*d, in);
    const Approach a = approach(kmh(140.0), {0.5}, {0.2}, d->fixed);
    benchmark::DoNotOptimize(limits_of(*d, d->targets.back(), a, {}));
  }
}
BENCHMARK(gamma_from_raw);

}  // namespace
