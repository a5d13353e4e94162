// A whole journey of the shipped line, checked from outside the kernel: the files of `evc run`, and properties of
// State, Derived and replays in every cycle.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "base/test_paths.h"
#include "io/input_stream.h"
#include "io/output_lines.h"
#include "kernel/state.h"

namespace {

using evc::kernel::Derived;
using evc::kernel::Outputs;
using evc::kernel::State;

static_assert(std::is_trivially_copyable_v<State>);
static_assert(sizeof(State) <= 64 * 1024);

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

int command(const std::string& arguments) {
  const int status = std::system((evc::test::evc_command() + " " + arguments).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

class Journey : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder() = std::filesystem::temp_directory_path() / ("evc-journey-" + std::to_string(::getpid()));
    ran() = command("run -o " + folder().string() + " >/dev/null") == 0;
    if (!ran()) return;
    inputs() = read(folder() / "inputs.jsonl");
    outputs() = read(folder() / "outputs.jsonl");
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder()); }
  void SetUp() override { ASSERT_TRUE(ran()) << "evc run failed"; }

  static std::filesystem::path& folder() {
    static std::filesystem::path value;
    return value;
  }
  static bool& ran() {
    static bool value = false;
    return value;
  }
  static std::string& inputs() {
    static std::string value;
    return value;
  }
  static std::string& outputs() {
    static std::string value;
    return value;
  }
};

/// The unit with its state, driven by a stream.
struct Unit {
  std::unique_ptr<State> state = std::make_unique<State>();
  std::unique_ptr<Derived> derived = std::make_unique<Derived>();
  std::unique_ptr<Outputs> outputs = std::make_unique<Outputs>();

  std::string step(evc::sim::CycleInputs& cycle) {
    evc::kernel::step(*state, *derived, cycle.view(), *outputs);
    std::string line;
    evc::io::append_output(line, cycle.t_ms, *outputs);
    return line;
  }
};

TEST_F(Journey, GivesTheSameOutputsWhenReplayed) {
  auto stream = evc::io::InputStream::open("inputs.jsonl", evc::io::lines_of(inputs()));
  ASSERT_TRUE(stream) << stream.error().text();
  Unit unit;
  evc::kernel::power_up(*unit.state, *unit.derived, stream->configuration().for_kernel());
  evc::sim::CycleInputs cycle;
  std::string replayed;
  while (stream->next(cycle).value()) replayed += unit.step(cycle);
  EXPECT_EQ(replayed.size(), outputs().size());
  EXPECT_TRUE(replayed == outputs());
}

// Derived contains nothing that is not in State: discarding it before every step changes no output.
TEST_F(Journey, NeedsNoDerivedFromTheCycleBefore) {
  auto stream = evc::io::InputStream::open("inputs.jsonl", evc::io::lines_of(inputs()));
  ASSERT_TRUE(stream);
  Unit unit;
  evc::kernel::power_up(*unit.state, *unit.derived, stream->configuration().for_kernel());
  evc::sim::CycleInputs cycle;
  std::istringstream expected(outputs());
  std::string line;
  while (stream->next(cycle).value()) {
    unit.derived = std::make_unique<Derived>();
    ASSERT_TRUE(std::getline(expected, line));
    ASSERT_EQ(unit.step(cycle), line + "\n") << "at t_ms " << cycle.t_ms;
  }
}

// A snapshot is a memcpy: a unit restored from the bytes of another one behaves like it.
TEST_F(Journey, GoesOnFromASnapshot) {
  auto stream = evc::io::InputStream::open("inputs.jsonl", evc::io::lines_of(inputs()));
  ASSERT_TRUE(stream);
  Unit first;
  evc::kernel::power_up(*first.state, *first.derived, stream->configuration().for_kernel());
  evc::sim::CycleInputs cycle;
  std::vector<Unit> woken;
  for (std::size_t n = 0; stream->next(cycle).value(); ++n) {
    if (n % 2000 == 700) {
      Unit copy;
      std::memcpy(static_cast<void*>(copy.state.get()), first.state.get(), sizeof(State));
      woken.push_back(std::move(copy));
    }
    const std::string expected = first.step(cycle);
    for (std::size_t i = 0; i < woken.size(); ++i)
      ASSERT_EQ(woken[i].step(cycle), expected) << "snapshot " << i << " at t_ms " << cycle.t_ms;
  }
  EXPECT_GE(woken.size(), 2u);
}

/// As std::count, which is slow without optimisation.
std::size_t lines_of(const std::string& text) {
  std::size_t lines = 0;
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) ++lines;
  return lines;
}

/// The stream with some bits of every `every`-th telegram or message flipped.
std::string damaged(const std::string& inputs, unsigned seed, unsigned every) {
  std::mt19937 random(seed);
  std::istringstream in(inputs);
  std::string out, line;
  while (std::getline(in, line)) {
    for (const char* key : {"\"telegram\":\"", "\"message\":\""}) {
      const std::size_t at = line.find(key);
      if (at == std::string::npos || random() % every != 0) continue;
      const std::size_t first = at + std::strlen(key);
      const std::size_t end = line.find('"', first);
      for (unsigned flips = 1 + random() % 4; flips > 0; --flips)
        line[first + random() % (end - first)] = "0123456789ABCDEF"[random() % 16];
    }
    out += line;
    out += '\n';
  }
  return out;
}

// Wrong bits from trackside never stop the unit: every cycle is answered, and information that cannot be decoded is
// logged.
TEST_F(Journey, AnswersEveryCycleWhateverTheTrackSends) {
  const std::size_t cycles = lines_of(outputs());
  std::size_t different = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    auto stream = evc::io::InputStream::open("damaged", evc::io::lines_of(damaged(inputs(), seed, 1 + seed % 4)));
    ASSERT_TRUE(stream);
    Unit unit;
    evc::kernel::power_up(*unit.state, *unit.derived, stream->configuration().for_kernel());
    evc::sim::CycleInputs cycle;
    std::string all;
    for (auto more = stream->next(cycle); more.value(); more = stream->next(cycle)) all += unit.step(cycle);
    EXPECT_EQ(lines_of(all), cycles) << "seed " << seed;
    if (all != outputs()) ++different;
  }
  EXPECT_GE(different, 6u) << "the damage does not reach the unit";
}

// The same journey from the other cab (3.6.1.5, 5.12): the counters fall, everything else is as it was.

constexpr double kEngine = 20.0;  // m, of the configuration
constexpr double kTolerance = 1e-6;

evc::train::TrainData seen_from_cab_A(evc::train::TrainData train) {
  train.L_antenna_front = {kEngine - train.L_antenna_front.si};
  return train;
}
evc::sim::CycleInputs mirrored(const evc::sim::CycleInputs& cycle) {
  evc::sim::CycleInputs out = cycle;
  const auto turned = [](evc::OdometerPlace place) { return evc::OdometerPlace{-place.from_origin}; };
  evc::port::Odometry& odometry = out.levels.odometry;
  odometry.nominal = turned(odometry.nominal);
  odometry.min = turned(cycle.levels.odometry.max);
  odometry.max = turned(cycle.levels.odometry.min);
  odometry.V_est = {-odometry.V_est.si};
  odometry.V_min = {-cycle.levels.odometry.V_max.si};
  odometry.V_max = {-cycle.levels.odometry.V_min.si};
  odometry.A_est = {-odometry.A_est.si};
  for (auto& telegram : out.balises) telegram.at = turned(telegram.at);
  out.levels.train.cab = evc::port::Cab::B;
  if (out.train_data) out.train_data = seen_from_cab_A(*out.train_data);
  return out;
}

/// Equal, places on the odometer mirrored.
void expect_mirrored(const nlohmann::json& from_A, const nlohmann::json& from_B, const std::string& where) {
  static const std::set<std::string> counters{
      "est_front_m", "min_safe_front_m", "max_safe_front_m", "EOA_m", "SvL_m", "from_m", "to_m"};
  ASSERT_EQ(from_A.type() == nlohmann::json::value_t::null, from_B.type() == nlohmann::json::value_t::null) << where;
  if (from_A.is_object()) {
    for (const auto& [key, value] : from_A.items()) expect_mirrored(value, from_B.at(key), where + "/" + key);
  } else if (from_A.is_array()) {
    ASSERT_EQ(from_A.size(), from_B.size()) << where;
    for (std::size_t i = 0; i < from_A.size(); ++i) expect_mirrored(from_A[i], from_B[i], where + "/-");
  } else if (from_A.is_number()) {
    const double value = from_A.get<double>();
    const bool place = counters.contains(where.substr(where.rfind('/') + 1));
    ASSERT_NEAR(from_B.get<double>(), place ? -value : value, kTolerance) << where;
  } else {
    ASSERT_EQ(from_A, from_B) << where;
  }
}

TEST_F(Journey, IsTheSameFromTheOtherCab) {
  auto stream = evc::io::InputStream::open("inputs.jsonl", evc::io::lines_of(inputs()));
  ASSERT_TRUE(stream);
  Unit A, B;
  evc::kernel::Config config = stream->configuration().for_kernel();
  ASSERT_EQ(config.L_engine.si, kEngine);
  evc::kernel::power_up(*A.state, *A.derived, config);
  config.train = seen_from_cab_A(config.train);
  evc::kernel::power_up(*B.state, *B.derived, config);
  evc::sim::CycleInputs cycle;
  std::size_t supervised = 0;
  for (std::size_t n = 0; stream->next(cycle).value(); ++n) {
    evc::sim::CycleInputs turned = mirrored(cycle);
    const std::string from_A = A.step(cycle), from_B = B.step(turned);
    if (n == 0 || (n % 10 != 0 && from_A.find("\"events\":[]") != std::string::npos)) continue;
    expect_mirrored(nlohmann::json::parse(from_A), nlohmann::json::parse(from_B), "");
    if (HasFatalFailure()) FAIL() << "at t_ms " << cycle.t_ms << "\n" << from_A << from_B;
    supervised += from_A.find("\"V_P\":null") == std::string::npos;
  }
  EXPECT_GT(supervised, 500u);
}

TEST_F(Journey, LeavesWholeRecords) {
  for (const char* name : {"summary.json", "trace.csv", "inputs.jsonl", "outputs.jsonl", "report.html"})
    EXPECT_GT(std::filesystem::file_size(folder() / name), 100u) << name;
  const std::string page = read(folder() / "report.html");
  EXPECT_NE(page.find("</html>"), std::string::npos);
  // Self-contained: nothing is loaded from other files.
  for (const char* outside : {"src=\"http", "href=\"http", "@import", "fetch(", "XMLHttpRequest"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
}

TEST_F(Journey, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const auto other = folder() / "other", same = folder() / "same";
  ASSERT_EQ(command("run --seed 1 -o " + same.string() + " >/dev/null"), 0);
  ASSERT_EQ(command("run --seed 2 -o " + other.string() + " >/dev/null"), 0);
  EXPECT_TRUE(read(same / "inputs.jsonl") == inputs());
  EXPECT_FALSE(read(other / "inputs.jsonl") == inputs());
}

// The stream of docs/replay.md: a line with an earlier time or one that does not parse ends the replay with exit 2 and
// the line number.
TEST_F(Journey, ReplayEndsAtABrokenLine) {
  std::istringstream in(inputs());
  std::string line, head;
  for (int n = 0; n < 500 && std::getline(in, line); ++n) head += line + "\n";
  for (const char* broken :
       {"{\"t_ms\":0,\"odometer\":{}}\n", "{\"t_ms\":\n", "{\"t_ms\":999999999,\"baliise\":{}}\n"}) {
    const auto file = folder() / "broken.jsonl", out = folder() / "broken.out", errors = folder() / "broken.err";
    std::ofstream(file, std::ios::binary) << head << broken;
    EXPECT_EQ(command("replay " + file.string() + " -o " + out.string() + " 2>" + errors.string()), 2) << broken;
    const std::string printed = read(errors);
    EXPECT_NE(printed.find("501"), std::string::npos) << printed;
    EXPECT_EQ(std::count(printed.begin(), printed.end(), '\n'), 1) << printed;
    const std::string whole = read(out);
    EXPECT_FALSE(whole.empty());
    EXPECT_EQ(outputs().compare(0, whole.size(), whole), 0) << "outputs up to the broken line are those of the journey";
  }
}

}  // namespace
