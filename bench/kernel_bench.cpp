// The cost of a cycle: on whole journeys (the inputs that `evc run` recorded, named by EVC_BENCH_INPUTS), in a
// busy FS cycle, and in the cycle in which a balise group replaces all track data.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "io/input_stream.h"
#include "ride.h"

namespace {

using evc::bench::Ride;
using Clock = std::chrono::steady_clock;

/// Microseconds of single cycles, and their statistics.
class Costs {
 public:
  template <class F>
  void measure(F&& step) {
    const auto before = Clock::now();
    step();
    microseconds_.push_back(std::chrono::duration<double, std::micro>(Clock::now() - before).count());
  }
  void report(benchmark::State& state) {
    if (microseconds_.empty()) return state.SkipWithError("no cycle was measured");
    std::sort(microseconds_.begin(), microseconds_.end());
    const auto at = [&](double share) {
      return microseconds_[static_cast<std::size_t>(share * static_cast<double>(microseconds_.size() - 1) + 0.5)];
    };
    state.counters["cycles"] = static_cast<double>(microseconds_.size());
    state.counters["median_us"] = at(0.5);
    state.counters["p99_9_us"] = at(0.999);
    state.counters["max_us"] = at(1.0);
  }

 private:
  std::vector<double> microseconds_;
};

void journey(benchmark::State& state, const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  Costs costs;
  for ([[maybe_unused]] auto _ : state) {
    auto stream = evc::io::InputStream::open(file, evc::io::lines_of(text.str()));
    if (!stream) return state.SkipWithError(stream.error().text().c_str());
    auto memory = std::make_unique<evc::kernel::State>();
    auto derived = std::make_unique<evc::kernel::Derived>();
    auto outputs = std::make_unique<evc::kernel::Outputs>();
    evc::kernel::power_up(*memory, *derived, stream->configuration().for_kernel());
    evc::sim::CycleInputs cycle;
    for (auto more = stream->next(cycle); more && *more; more = stream->next(cycle)) {
      const evc::kernel::Inputs& inputs = cycle.view();
      costs.measure([&] { evc::kernel::step(*memory, *derived, inputs, *outputs); });
    }
  }
  costs.report(state);
}

void busy_fs_cycle(benchmark::State& state) {
  Costs costs;
  for ([[maybe_unused]] auto _ : state) {
    Ride ride;
    ride.into_full_supervision(35.0);
    if (ride.outputs().mode != evc::Mode::FS) return state.SkipWithError("the ride is not in FS");
    for (int i = 0; i < 600; ++i) {
      ride.prepare(35.0);
      costs.measure([&] { ride.step(); });
      ride.finish();
    }
  }
  costs.report(state);
}

void group_with_all_track_data(benchmark::State& state) {
  Costs costs;
  for ([[maybe_unused]] auto _ : state) {
    Ride ride;
    ride.into_full_supervision(35.0);
    for (std::uint16_t n = 2; n < 200; ++n) {
      for (int i = 0; i < 10; ++i) ride.cycle(35.0);
      const auto telegrams = evc::bench::group(n);
      ride.read(telegrams);
      ride.prepare(35.0);
      costs.measure([&] { ride.step(); });
      ride.finish();
      if (ride.outputs().mode != evc::Mode::FS) return state.SkipWithError("the ride left FS");
    }
  }
  costs.report(state);
}

BENCHMARK(busy_fs_cycle)->Unit(benchmark::kMillisecond);
BENCHMARK(group_with_all_track_data)->Unit(benchmark::kMillisecond);

/// Every file of EVC_BENCH_INPUTS (separated by blanks) is one benchmark.
[[maybe_unused]] const bool registered = [] {
  const char* files = std::getenv("EVC_BENCH_INPUTS");
  std::istringstream names(files != nullptr ? files : "");
  for (std::string file; names >> file;)
    benchmark::RegisterBenchmark(("journey " + file).c_str(), [file](benchmark::State& s) {
      journey(s, file);
    })->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
