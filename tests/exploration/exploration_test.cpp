// From power-up, whatever driver, train and trackside do: every change of mode is a cell of 4.6.2, the brakes that a
// mode needs are there, every mode is reached, and from every state the driver finds a way on (docs/exploration.md).
// EVC_STATES=N expands N states of each edition instead of the usual ones, EVC_DEPTH=N every way of N actions before.
// EVC_WAY="input; input; ...", as a fault has it, prints the unit's output after each instead.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "search.h"

namespace evc::exploration {
namespace {

/// What a search of the usual size has to reach; every mode of the edition besides.
struct Floor {
  SrsVersion srs{};
  std::size_t expanded = 0;  ///< the usual size
  std::size_t states = 0, cells = 0;
};
constexpr std::array kFloors{
    Floor{SrsVersion::v3_4_0, 1200, 14800, 121},
    Floor{SrsVersion::v3_6_0, 1200, 14800, 121},
    Floor{SrsVersion::v4_0_0, 900, 12900, 143},
};

/// How often each rule is applied at least, in cycles, in the order of `Rule`.
constexpr std::array<std::uint64_t, terms::index(Rule::count)> kApplied{
    20'000,  2,       20,     5,         1'500'000, 300'000, 300'000, 50,   3'000'000,
    250'000, 500'000, 25'000, 1'500'000, 1'500'000, 300'000, 120'000, 1'000};

std::size_t of_environment(const char* name, std::size_t usual) {
  const char* text = std::getenv(name);
  return text == nullptr ? usual : static_cast<std::size_t>(std::atoll(text));
}

std::size_t seen(const std::map<std::pair<std::string, std::string>, std::uint64_t>& cells) {
  return static_cast<std::size_t>(
      std::count_if(cells.begin(), cells.end(), [](const auto& cell) { return cell.second > 0; }));
}

void print(SrsVersion srs, const Found& found) {
  std::printf(
      "%s: %zu states, %zu expanded, %zu inputs, ways of up to %d, %zu ways on, %zu of %zu modes, %zu of %zu cells\n",
      name(srs), found.states, found.expanded, found.inputs, found.depth, found.ways_on, found.cycles.size(),
      found.modes.size(), seen(found.cells), found.cells.size());
  for (std::size_t rule = 0; rule < found.applied.size(); ++rule)
    std::printf("  %s: %llu\n", name(static_cast<Rule>(rule)), static_cast<unsigned long long>(found.applied[rule]));
  for (const auto& [cell, times] : found.cells)
    if (times == 0) std::printf("  not seen: %s to %s\n", cell.first.c_str(), cell.second.c_str());
}

class Exploration : public ::testing::TestWithParam<Floor> {};

TEST_P(Exploration, NoFaultAndEveryMode) {
  const Floor& floor = GetParam();
  if (const char* way = std::getenv("EVC_WAY")) return print_way(floor.srs, way);
  const Bounds bounds{static_cast<int>(of_environment("EVC_DEPTH", 1)), of_environment("EVC_STATES", floor.expanded)};
  const Found found = search(floor.srs, bounds);
  print(floor.srs, found);
  for (const std::string& fault : found.faults) ADD_FAILURE() << fault;
  if (found.expanded < floor.expanded) return;  // a shorter search was ordered
  for (const std::string& mode : found.modes) EXPECT_TRUE(found.cycles.contains(mode)) << mode << " is not visited";
  EXPECT_GE(found.states, floor.states);
  for (std::size_t rule = 0; rule < found.applied.size(); ++rule)
    EXPECT_GE(found.applied[rule], kApplied[rule]) << name(static_cast<Rule>(rule));
  EXPECT_GE(seen(found.cells), floor.cells);
}

TEST(Watch, TellsEachFault) {
  Watch watch(SrsVersion::v3_6_0);
  port::TrainSignals train;
  train.desk_open = true;
  port::Outputs out;
  const auto faults = [&](Mode before, Mode now) {
    watch.faults.clear();
    out.mode = now;
    watch.look(before, out, train);
    return watch.faults.size();
  };
  EXPECT_EQ(faults(Mode::SB, Mode::FS), 0u);
  EXPECT_EQ(faults(Mode::SL, Mode::FS), 1u) << "no cell";
  for (const Mode braked : {Mode::TR, Mode::SF, Mode::NP}) {
    out.eb = false;
    EXPECT_EQ(faults(braked, braked), 1u);
    out.eb = true;
    EXPECT_EQ(faults(braked, braked), 0u);
  }
  EXPECT_EQ(faults(Mode::IS, Mode::IS), 1u) << "braked";
  out = {};
  train.desk_open = false;
  out.requests.add(Ack::SR);
  out.entries.add(Entry::level);
  out.start_offered = true;
  EXPECT_EQ(faults(Mode::SB, Mode::SB), 3u);
}

INSTANTIATE_TEST_SUITE_P(Editions, Exploration, ::testing::ValuesIn(kFloors));

}  // namespace
}  // namespace evc::exploration
