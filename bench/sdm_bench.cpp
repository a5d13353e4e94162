// Cost of speed and distance monitoring: curves, limits, a rebuild, a cycle.
#include <benchmark/benchmark.h>

#include <array>
#include <memory>

#include "curves_work.h"

namespace {

using namespace evc;
using namespace evc::sdm;
using bench::busy;
using bench::kmh;
using bench::running;

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

/// A rebuild, and the limits of every target evaluated in a cycle.
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
  in.srs = static_cast<SrsVersion>(state.range(1));
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
  Inputs in = bench::gamma_target();
  auto d = std::make_unique<Derived>();
  for (auto _ : state) benchmark::DoNotOptimize(bench::gamma_from_raw(*d, in));
}
BENCHMARK(gamma_from_raw);

}  // namespace
