// Curves and limits of many trains and targets at once, with each set of instructions, beside one at a time and beside
// two limits: `arithmetic`, the time of the arithmetic of the arcs alone, its operands in registers, and `divider`,
// that of their divisions alone, one each. There are no square roots.
#include <array>
#include <cstddef>
#include <cstdint>

// This file is compiled once for each set of instructions, as batch/kernel.cpp is.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "../bench/batch_bench.cpp"
#include <hwy/foreach_target.h>
// It must come after it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace evc::bench {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Divisions that do not wait for one another; returns their number.
std::size_t divide(double* numbers, std::size_t times) {
  const hn::ScalableTag<double> d;
  const std::size_t N = hn::Lanes(d);
  const auto by = hn::Set(d, 1.0000001);
  auto a0 = hn::LoadU(d, numbers);
  auto a1 = hn::Add(a0, by);
  auto a2 = hn::Add(a1, by);
  auto a3 = hn::Add(a2, by);
  auto a4 = hn::Add(a3, by);
  auto a5 = hn::Add(a4, by);
  auto a6 = hn::Add(a5, by);
  auto a7 = hn::Add(a6, by);
  for (std::size_t i = 0; i < times; ++i) {
    a0 = hn::Div(a0, by);
    a1 = hn::Div(a1, by);
    a2 = hn::Div(a2, by);
    a3 = hn::Div(a3, by);
    a4 = hn::Div(a4, by);
    a5 = hn::Div(a5, by);
    a6 = hn::Div(a6, by);
    a7 = hn::Div(a7, by);
  }
  hn::StoreU(hn::Add(hn::Add(hn::Add(a0, a1), hn::Add(a2, a3)), hn::Add(hn::Add(a4, a5), hn::Add(a6, a7))), d, numbers);
  return times * 8 * N;
}

/// The arithmetic of arcs as in batch/kernel.cpp, eight that do not wait for one another, without looking anything up;
/// returns the number of arcs.
std::size_t follow(double* numbers, std::size_t times) {
  const hn::ScalableTag<double> d;
  constexpr std::size_t kBeside = 8;
  const auto twice_A = hn::Set(d, 1.0000001);
  const auto begin = hn::Set(d, -1000.0);
  const auto upper = hn::Set(d, 1e12);
  hn::Vec<decltype(d)> x[kBeside];
  hn::Vec<decltype(d)> w[kBeside];
  for (std::size_t u = 0; u < kBeside; ++u) {
    x[u] = hn::LoadU(d, numbers);
    w[u] = hn::Add(x[u], hn::Set(d, static_cast<double>(u)));
  }
  for (std::size_t i = 0; i < times; ++i)
    for (std::size_t u = 0; u < kBeside; ++u) {
      const auto at_border = hn::Add(w[u], hn::Mul(twice_A, hn::Sub(x[u], begin)));
      const auto there = hn::Sub(x[u], hn::Div(hn::Sub(upper, w[u]), twice_A));
      x[u] = hn::IfThenElse(hn::Lt(at_border, upper), begin, hn::Max(begin, there));
      w[u] = hn::Min(at_border, upper);
    }
  auto sum = hn::Add(x[0], w[0]);
  for (std::size_t u = 1; u < kBeside; ++u) sum = hn::Add(sum, hn::Add(x[u], w[u]));
  hn::StoreU(sum, d, numbers);
  return times * kBeside * hn::Lanes(d);
}

}  // namespace HWY_NAMESPACE
}  // namespace evc::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "batch/kernel.h"
#include "batch/limits.h"
#include "curves_work.h"

namespace evc::bench {
namespace {

HWY_EXPORT(divide);
HWY_EXPORT(follow);

constexpr std::size_t kCases = 16384;
constexpr double kFastest_kmh = 195.0;

/// Train `number` of those that differ a little: constant deceleration in 8 bands of speed (of A_basic and of Kv_int),
/// on a track of 20 gradients in rear of the target at 2 000 m. The train is short, so that each gradient counts.
sdm::Inputs stepped(int number) {
  sdm::Inputs in;
  in.revision = 1;
  for (int i = 0; i < 20; ++i) append(in.gradient.permille, 100.0 * i + number % 7, (i * 7 + number % 3) % 25 - 12.0);
  append(in.mrsp, -5000.0, 160.0);
  in.train.brake_percentage = 180.0 + number % 41;
  in.train.L_TRAIN = {20.0};
  in.train.V_MAXTRAIN = kmh(200.0);
  auto& Kv = in.national_values.Kv_int_passenger;
  for (const double from : {40.0, 70.0}) {
    auto value = Kv.steps.front().value;
    value.a -= 0.0005 * from;
    value.b -= 0.0005 * from;
    if (!Kv.append(kmh(from), value)) std::abort();
  }
  in.V_top = kmh(kFastest_kmh) + kmh(30.0);
  return in;
}

/// Trains, targets at 2 000 m and around, speeds up to 195 km/h.
struct Work {
  batch::Trains trains;
  std::vector<batch::Target> targets;
  std::vector<std::uint32_t> train, target;
  std::vector<double> speed;
  std::array<std::vector<double>, 7> out;

  Work(int different_trains, double least_kmh, double most_kmh = kFastest_kmh) {
    for (int i = 0; i < different_trains; ++i) {
      const std::uint32_t n = trains.add(stepped(i));
      if (!trains.vectorised(n)) std::abort();
    }
    for (int i = 0; i < 50; ++i) {
      batch::Target t;
      t.location = t.SvL = {{2000.0 + i}};
      targets.push_back(t);
    }
    for (std::size_t i = 0; i < kCases; ++i) {
      train.push_back(static_cast<std::uint32_t>(i * 7 % static_cast<std::size_t>(different_trains)));
      target.push_back(static_cast<std::uint32_t>(i % targets.size()));
      speed.push_back(kmh(least_kmh + (most_kmh - least_kmh) * static_cast<double>(i * 37 % 1000) / 1000.0).si);
    }
    for (auto& column : out) column.resize(kCases);
  }
  batch::Cases cases() const { return {train, target, speed}; }
  batch::LimitsOut all_limits() {
    batch::LimitsOut limits;
    limits.EBI = out[0];
    limits.SBI1 = out[1];
    limits.SBI2 = out[2];
    limits.FLOI = out[3];
    limits.W = out[4];
    limits.P = out[5];
    limits.I = out[6];
    return limits;
  }
  batch::LimitsOut curve() {
    batch::LimitsOut limits;
    limits.EBD = out[0];
    return limits;
  }
};

/// Arcs of the EBD from the target to the speed of the first cases.
double arcs_of_a_curve(const Work& w) {
  const sdm::Inputs in = stepped(0);
  auto d = std::make_unique<sdm::Decelerations>();
  sdm::determine(*d, in.train, in.national_values, in.fixed, in.brakes, in.gradient, in.conditions);
  double arcs = 0.0;
  constexpr std::size_t kSome = 1000;
  for (std::size_t i = 0; i < kSome; ++i) {
    const Place at = w.targets[w.target[i]].location;
    arcs += static_cast<double>(sdm::trace(*d, sdm::CurveKind::EBD, false, at, {}, {}, Speed{w.speed[i]}).knots.size());
  }
  return arcs / kSome;
}

/// Nanoseconds of one of those that `work(numbers, times)` does, where none waits for another one.
template <class Do>
double one_ns(Do work) {
  std::array<double, 64> numbers{};
  numbers.fill(1.5);
  double best = 1e9;
  for (int i = 0; i < 20; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const std::size_t n = work(numbers.data(), std::size_t{4000});
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    benchmark::DoNotOptimize(numbers);
    best = std::min(best, took.count() / static_cast<double>(n));
  }
  return best;
}

/// `arcs` of a case.
void report(benchmark::State& state, double arcs) {
  const auto cases = static_cast<double>(state.iterations()) * static_cast<double>(kCases);
  state.counters["cases/s"] = benchmark::Counter(cases, benchmark::Counter::kIsRate);
  state.counters["case"] = benchmark::Counter(cases, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  if (arcs == 0.0) return;
  state.counters["arcs"] = arcs;
  state.counters["arithmetic"] = arcs * one_ns(HWY_DYNAMIC_DISPATCH(follow)) * 1e-9;
  state.counters["divider"] = arcs * one_ns(HWY_DYNAMIC_DISPATCH(divide)) * 1e-9;
}

/// The place of the EBD at a speed of 185 to 195 km/h: all 8 bands, up to 20 gradients.
void curve(benchmark::State& state, std::int64_t set, int trains) {
  batch::use_only(set);
  Work work(trains, 185.0);
  const double arcs = arcs_of_a_curve(work);
  for (auto _ : state) {
    batch::limits(work.trains, work.targets, work.cases(), work.curve());
    benchmark::ClobberMemory();
  }
  report(state, arcs);
  batch::use_only(0);
}

/// The same at a standstill: what a case costs without an arc.
void no_arc(benchmark::State& state, std::int64_t set) {
  batch::use_only(set);
  Work work(1, 0.0, 0.0);
  for (auto _ : state) {
    batch::limits(work.trains, work.targets, work.cases(), work.curve());
    benchmark::ClobberMemory();
  }
  report(state, 0.0);
  batch::use_only(0);
}

/// EBI, SBI1, SBI2, FLOI, W, P, I at a speed up to 195 km/h: an EBD and an SBD.
void limits(benchmark::State& state, std::int64_t set, int trains) {
  batch::use_only(set);
  Work work(trains, 20.0);
  for (auto _ : state) {
    batch::limits(work.trains, work.targets, work.cases(), work.all_limits());
    benchmark::ClobberMemory();
  }
  report(state, 0.0);
  batch::use_only(0);
}

/// The same curve by src/sdm.
void curve_one_at_a_time(benchmark::State& state) {
  const Work work(1, 185.0);
  const sdm::Inputs in = stepped(0);
  auto d = std::make_unique<sdm::Decelerations>();
  sdm::determine(*d, in.train, in.national_values, in.fixed, in.brakes, in.gradient, in.conditions);
  std::array<sdm::Knot, sdm::kMaxKnots> room{};
  for (auto _ : state)
    for (std::size_t i = 0; i < kCases; ++i) {
      std::size_t used = 0;
      const Speed V{work.speed[i]};
      (void)sdm::trace(room, used, *d, sdm::CurveKind::EBD, false, work.targets[work.target[i]].location, {}, {}, V);
      benchmark::DoNotOptimize(sdm::CurveView{{room.data(), used}}.place_at(V));
    }
  report(state, 0.0);
}

const bool kRegistered = [] {
  benchmark::RegisterBenchmark("curve/one_at_a_time", curve_one_at_a_time);
  std::array<batch::Instructions, 8> found{};
  const std::size_t n = batch::instructions(found);
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t set = found[i].target;
    benchmark::RegisterBenchmark((std::string("no_arc/") + found[i].name).c_str(),
                                 [=](benchmark::State& s) { no_arc(s, set); });
    for (const int trains : {1, 100}) {
      const std::string of = std::string(found[i].name) + "/trains:" + std::to_string(trains);
      benchmark::RegisterBenchmark(("curve/" + of).c_str(), [=](benchmark::State& s) { curve(s, set, trains); });
      benchmark::RegisterBenchmark(("limits/" + of).c_str(), [=](benchmark::State& s) { limits(s, set, trains); });
    }
  }
  return true;
}();

}  // namespace
}  // namespace evc::bench
#endif
