// Searches the slowest cycle: streams as in worst_cycle.h, by the time of their last step, the least of several
// repetitions from the same state. Usage: worst_cycle SEED SECONDS; prints the numbers of the slowest, for kWorst of
// instructions.cpp, which counts its instructions.
#include "worst_cycle.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace evc::bench {
namespace {

using Clock = std::chrono::steady_clock;

double cost_us(const Genome& genome) {
  const auto ride = hostile_ride(genome);
  kernel::State state;
  kernel::Outputs outputs;
  static kernel::Derived derived;
  double least = 1e9;
  for (int i = 0; i < 5; ++i) {
    state = ride->state();
    derived = ride->derived();
    const auto before = Clock::now();
    kernel::step(state, derived, ride->inputs(), outputs);
    least = std::min(least, std::chrono::duration<double, std::micro>(Clock::now() - before).count());
  }
  return least;
}

void search(std::uint32_t seed, double seconds) {
  std::mt19937 random(seed);
  Genome best{};
  double slowest = 0.0;
  int tried = 0;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  for (; Clock::now() < end; ++tried) {
    Genome genome = best;
    if (tried < 50)
      for (auto& number : genome) number = static_cast<std::uint32_t>(random());
    else
      for (int i = 0; i < 2; ++i) genome[random() % genome.size()] = static_cast<std::uint32_t>(random());
    const double cost = cost_us(genome);
    // Again: a disturbance of the machine is no slow cycle.
    if (cost <= slowest || std::min(cost, cost_us(genome)) <= slowest) continue;
    slowest = std::min(cost, cost_us(genome));
    best = genome;
  }
  std::printf("slowest of %d: %.1f us\n", tried, slowest);
  for (std::size_t i = 0; i < best.size(); ++i) std::printf("%uu%s", best[i], i + 1 < best.size() ? ", " : "\n");
}

}  // namespace
}  // namespace evc::bench

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  evc::bench::search(static_cast<std::uint32_t>(std::atoi(argv[1])), std::atof(argv[2]));
  return 0;
}
