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
#include <random>
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
  const auto cycles = std::count(outputs().begin(), outputs().end(), '\n');
  std::size_t different = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    auto stream = evc::io::InputStream::open("damaged", evc::io::lines_of(damaged(inputs(), seed, 1 + seed % 4)));
    ASSERT_TRUE(stream);
    Unit unit;
    evc::kernel::power_up(*unit.state, *unit.derived, stream->configuration().for_kernel());
    evc::sim::CycleInputs cycle;
    std::string all;
    for (auto more = stream->next(cycle); more.value(); more = stream->next(cycle)) all += unit.step(cycle);
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), cycles) << "seed " << seed;
    if (all != outputs()) ++different;
  }
  EXPECT_GE(different, 6u) << "the damage does not reach the unit";
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
