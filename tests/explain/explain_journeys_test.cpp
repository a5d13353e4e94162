#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "io/input_stream.h"
#include "io/output_lines.h"
#include "io/program_test.h"
#include "io/retained_file.h"
#include "kernel/examine.h"
#include "kernel/state.h"
#include "run.h"
#include "terms/cause.h"

// `evc explain` on the journeys of explain.scenario: each ends under a brake command, and the answer why was compared
// with the clauses by a reader. The answers are tests/data/explain/NAME.txt.
namespace evc::scenario {
namespace {

std::string file_name(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::vector<Scenario> journeys(const std::string& name = "explain.scenario") {
  const std::string folder = evc::test::source_folder() + "/tests/scenarios/";
  const auto library = read(text_of(folder + "library.scenario"), "library.scenario");
  const auto file = read(text_of(folder + name), name, library->blocks);
  return file ? file->scenarios : std::vector<Scenario>();
}

/// The inputs in a file, and the time of the last one.
struct Journey {
  explicit Journey(const Scenario& scenario) : folder(("explain_" + file_name(scenario.name)).c_str()) {
    const std::string inputs = inputs_of(scenario);
    std::ofstream(file()) << inputs;
    const std::size_t last = inputs.rfind('\n', inputs.size() - 2);
    last_ms = nlohmann::json::parse(inputs.substr(last + 1))["t_ms"];
  }
  std::string file() const { return folder / "inputs.jsonl"; }
  Ended explain(const std::string& options) const { return explain_at(last_ms, options); }
  Ended explain_at(std::int64_t t_ms, const std::string& options = "") const {
    return ended("explain '" + file() + "' --at " + std::to_string(t_ms) + " " + options);
  }
  Folder folder;
  std::int64_t last_ms = 0;
};

/// The journeys of a file with their answers why, each replayed once for all tests.
struct Answered {
  Scenario scenario;
  std::unique_ptr<Journey> journey;
  Ended why;
};
const std::vector<Answered>& answered(const std::string& name = "explain.scenario") {
  static std::map<std::string, std::vector<Answered>> files;
  std::vector<Answered>& all = files[name];
  if (all.empty())
    for (Scenario& scenario : journeys(name)) {
      auto journey = std::make_unique<Journey>(scenario);
      Ended why = journey->explain("--why-brake");
      all.push_back({std::move(scenario), std::move(journey), std::move(why)});
    }
  return all;
}

constexpr const char* kFiles[] = {"explain.scenario", "explain_read.scenario"};

void fits_a_screen(const std::string& text) {
  std::istringstream in(text);
  int lines = 0;
  for (std::string line; std::getline(in, line); ++lines) EXPECT_LE(line.size(), 100u) << line;
  EXPECT_LE(lines, 40) << text;
}

TEST(Explain, why_the_brake_of_each_journey) {
  ASSERT_EQ(answered().size(), 66u);
  ASSERT_EQ(answered("explain_read.scenario").size(), 45u);
  for (const char* file : kFiles)
    for (const Answered& each : answered(file)) {
      EXPECT_EQ(each.why.exit_code, 0) << each.why.errors;
      EXPECT_EQ(each.why.output,
                text_of(evc::test::source_folder() + "/tests/data/explain/" + file_name(each.scenario.name) + ".txt"))
          << each.scenario.name;
      fits_a_screen(each.why.output);
    }
}

TEST(Explain, the_situation_of_each_fits_a_screen) {
  for (const char* file : kFiles)
    for (const Answered& each : answered(file)) {
      const Ended e = each.journey->explain("");
      EXPECT_EQ(e.exit_code, 0) << e.errors;
      fits_a_screen(e.output);
    }
}

// 3.6.2: a train that ran back over its LRBG.
TEST(Explain, an_LRBG_that_lies_ahead) {
  for (const Answered& each : answered("explain_read.scenario"))
    if (each.scenario.name == "backwards in post trip") {
      const Ended e = each.journey->explain("");
      EXPECT_NE(e.output.find("LRBG 1/200, 35.6 m ahead"), std::string::npos) << e.output;
      return;
    }
  ADD_FAILURE() << "no such journey";
}

/// The files cover every cause. Of each command there is more to say than the command.
TEST(Explain, no_cause_is_without_a_reason) {
  std::set<std::string> causes;
  for (const char* file : {"brakes.scenario", "explain.scenario", "supervised_manoeuvre.scenario"})
    for (const Answered& each : answered(file)) {
      const std::string& output = each.why.output;
      ASSERT_LE(each.why.exit_code, 1) << each.scenario.name << each.why.errors;
      std::istringstream in(output);
      int steps = 2;
      for (std::string line; std::getline(in, line);) {
        if (line.rfind("why the ", 0) == 0) {
          EXPECT_GE(steps, 2) << each.scenario.name << "\n" << output;
          causes.insert(line.substr(line.find('(') + 1, line.rfind(')') - line.find('(') - 1));
          steps = 0;
        }
        if (line.rfind("  ", 0) == 0 && line[2] >= '1' && line[2] <= '9') ++steps;
      }
      EXPECT_GE(steps, 2) << each.scenario.name << "\n" << output;
    }
  for (const auto& row : kCauseRows)
    EXPECT_TRUE(causes.contains(row.name) || row.value == Cause::overspeed_traction) << row.name;
}

const Journey& journey_of(const std::string& name) {
  for (const Answered& each : answered())
    if (each.scenario.name == name) return *each.journey;
  ADD_FAILURE() << "no scenario " << name;
  return *answered().front().journey;
}

TEST(Explain, the_situation_of_a_train_that_passed_its_end_of_authority) {
  const Ended e = journey_of("the end of authority is passed").explain("");
  EXPECT_EQ(e.output, text_of(evc::test::source_folder() + "/tests/data/explain/situation.txt"));
}

// 4.4.11.1.5: not by what else the driver enters later, and not by what is refused.
TEST(Explain, the_SR_speed_is_the_one_that_the_driver_entered) {
  const Ended e = journey_of("the distance entered by the driver is passed").explain_at(10000);
  EXPECT_NE(e.output.find("2.3 s: driver enters the SR speed 30 km/h"), std::string::npos) << e.output;
}

// 4.5.2: an authority that was there before counts in SR no more; it is not an answer there.
TEST(Explain, no_authority_in_staff_responsible) {
  const Journey& journey = journey_of("the former end of authority is passed after override");
  const Ended in_FS = journey.explain_at(50000), in_SR = journey.explain_at(100000);
  EXPECT_NE(in_FS.output.find("EOA and SvL at 631.3 m"), std::string::npos) << in_FS.output;
  EXPECT_EQ(in_SR.output.rfind("100.0 s: SR", 0), 0u) << in_SR.output;
  EXPECT_EQ(in_SR.output.find("MA accepted"), std::string::npos) << in_SR.output;
  EXPECT_EQ(in_SR.output.find("EOA and SvL"), std::string::npos) << in_SR.output;
}

// 5.4.3.2: for whom the start of mission waits.
TEST(Explain, what_is_waited_for) {
  const Ended e = journey_of("the distance of staff responsible is passed").explain_at(3300);
  EXPECT_NE(e.output.find("\nwaits      for acknowledgement of SR (start of mission S24)\n"), std::string::npos)
      << e.output;
}

/// A unit that steps or is examined.
struct Driven {
  kernel::State state;
  kernel::Derived derived;
  kernel::Outputs outputs;
  std::string line(std::int64_t t_ms) const {
    std::string text;
    io::append_output(text, t_ms, outputs);
    return text;
  }
};

/// The two units take turns: what a cycle of either kind leaves behind counts for the next one of the other kind.
void examine_as_step(const Scenario& scenario) {
  std::istringstream lines(inputs_of(scenario));
  auto stream =
      io::InputStream::open(scenario.name, [&lines](std::string& line) { return !!std::getline(lines, line); });
  ASSERT_TRUE(stream) << scenario.name;
  const auto stepped = std::make_unique<Driven>(), mixed = std::make_unique<Driven>();
  for (Driven* unit : {stepped.get(), mixed.get()})
    kernel::power_up(unit->state, unit->derived, stream->configuration().for_kernel());
  const auto seen = std::make_unique<kernel::Examined>();
  sim::CycleInputs cycle;
  for (bool examines = false;; examines = !examines) {
    const auto more = stream->next(cycle);
    ASSERT_TRUE(more) << scenario.name;
    if (!*more) break;
    const port::Inputs& in = cycle.view();
    kernel::step(stepped->state, stepped->derived, in, stepped->outputs);
    if (examines)
      kernel::examine(mixed->state, mixed->derived, in, mixed->outputs, *seen);
    else
      kernel::step(mixed->state, mixed->derived, in, mixed->outputs);
    ASSERT_EQ(mixed->line(cycle.t_ms), stepped->line(cycle.t_ms)) << scenario.name;
  }
  EXPECT_EQ(io::retained_text(kernel::retained(mixed->state)), io::retained_text(kernel::retained(stepped->state)));
}

TEST(Explain, an_examined_cycle_answers_as_any_other) {
  for (const char* file : {"explain.scenario", "no_power.scenario"})
    for (const Scenario& scenario : journeys(file)) examine_as_step(scenario);
}

}  // namespace
}  // namespace evc::scenario
