#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include "base/test_paths.h"
#include "brakes/brakes.h"
#include "brakes_page.h"
#include "coverage.h"
#include "display.h"
#include "mode_coverage.h"
#include "openevc/terms/dialogue.h"
#include "run.h"
#include "through_c.h"

// Every scenario of tests/scenarios/*.scenario and tests/scenarios/open/*.scenario is a test case of its own:
// `scenarios_test --gtest_filter='Scenario/radio.*'`. `scenarios_test --run FILE` runs the scenarios of any file;
// `scenarios_test --inputs FILE.NAME` prints the inputs of one as `evc replay` reads them; `scenarios_test --through-c
// FILE...` compares the scenarios of our files through the C interface.
namespace evc::scenario {
namespace {

namespace fs = std::filesystem;

/// The list of missing.txt can only become shorter.
constexpr std::size_t kMissingAtMost = 2;
/// Rows of brakes_missing.txt, one of each cause: the list can only become shorter.
constexpr std::size_t kBrakesMissingAtMost = 4;
/// Rows of modes_missing.txt, one of each edition: the list can only become shorter.
constexpr std::size_t kModesMissingAtMost = 17;
/// Cells of display_missing.txt: the list can only become shorter.
constexpr std::size_t kDisplayMissingAtMost = 306;
/// The rows of tests/reference/procedure_steps.txt.
constexpr std::size_t kSteps = 355;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;  // no finding is open
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".scenario") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string case_name(const std::string& name) {
  std::string out;
  for (const char c : name) out += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return out;
}

/// The failure of a scenario, which is run once.
const std::string& result_of(const Scenario& scenario) {
  static std::map<std::string, std::string> results;
  const std::string key = scenario.at.text() + scenario.name;
  const auto known = results.find(key);
  return known != results.end() ? known->second : results.emplace(key, run(scenario)).first->second;
}

class OneScenario : public ::testing::Test {
 public:
  explicit OneScenario(Scenario scenario) : scenario_(std::move(scenario)) {}
  void TestBody() override {
    const std::string& failure = result_of(scenario_);
    if (!failure.empty()) ADD_FAILURE() << failure;
  }

 private:
  Scenario scenario_;
};

class Unreadable : public ::testing::Test {
 public:
  explicit Unreadable(std::string why) : why_(std::move(why)) {}
  void TestBody() override { ADD_FAILURE() << why_; }

 private:
  std::string why_;
};

struct Collection {
  std::vector<std::pair<std::string, Scenario>> scenarios;  // file's stem, scenario
  std::vector<std::pair<std::string, std::string>> errors;
};

Collection collect() {
  const fs::path root = fs::path(evc::test::source_folder()) / "tests/scenarios";
  Collection all;
  const auto take = [&](const fs::path& path, const std::vector<Block>& library, bool open) -> std::vector<Block> {
    const std::string name = fs::relative(path, fs::path(evc::test::source_folder())).string();
    auto file = read(text_of(path), name, library);
    if (!file) {
      all.errors.emplace_back(path.stem().string(), file.error().text());
      return {};
    }
    for (Scenario& s : file->scenarios) {
      if (open == s.open.empty())
        all.errors.emplace_back(path.stem().string(), s.at.text() + ": scenario " + s.name +
                                                          (open ? ": in open/, without a line `open \"finding\"`"
                                                                : ": open, and not in open/"));
      all.scenarios.emplace_back((open ? "open_" : "") + path.stem().string(), std::move(s));
    }
    return std::move(file->blocks);
  };
  const std::vector<Block> library = take(root / "library.scenario", {}, false);
  for (const fs::path& path : files_in(root))
    if (path.stem() != "library") (void)take(path, library, false);
  for (const fs::path& path : files_in(root / "open")) (void)take(path, library, true);
  return all;
}

/// The scenarios of files anywhere, with the blocks of library.scenario. 0: all passed; 1: one failed; 2: a file cannot
/// be read.
int run_files(const std::vector<std::string>& files) {
  const fs::path root = fs::path(evc::test::source_folder()) / "tests/scenarios";
  const auto library = read(text_of(root / "library.scenario"), "library.scenario");
  int status = library ? 0 : 2;
  for (const std::string& name : files) {
    if (status == 2) break;
    const auto file = read(text_of(name), name, library->blocks);
    if (!fs::is_regular_file(name) || !file) {
      std::cerr << (file ? name + ": cannot be read" : file.error().text()) << "\n";
      status = 2;
      break;
    }
    for (const Scenario& scenario : file->scenarios) {
      const std::string failure = run(scenario);
      std::cout << (failure.empty() ? "passed: " : "failed: ") << scenario.name << "\n" << failure;
      if (!failure.empty()) status = 1;
    }
  }
  return status;
}

Coverage coverage_of(const Collection& all) {
  Coverage coverage;
  for (const auto& [file, scenario] : all.scenarios)
    for (const Cover& c : scenario.covers)
      coverage[c.kind + " " + c.name].push_back({file, scenario.name, !scenario.open.empty()});
  return coverage;
}

const Collection& collection() {
  static const Collection all = collect();
  return all;
}

TEST(ScenarioCoverage, everything_required_is_shown_or_known_to_be_missing) {
  const Coverage coverage = coverage_of(collection());
  const auto absent = missing();
  std::set<std::string> known;
  for (const Required& r : required()) {
    const std::string key = r.kind + " " + r.name;
    known.insert(key);
    EXPECT_TRUE(coverage.contains(key) || absent.contains(key)) << key << " (" << r.about << ") is in no scenario";
    EXPECT_FALSE(coverage.contains(key) && absent.contains(key)) << key << " is shown now: delete it from missing.txt";
  }
  for (const auto& [key, shown] : coverage)
    EXPECT_TRUE(known.contains(key)) << shown.front().file << ": " << shown.front().name << " covers " << key
                                     << ", which nobody requires";
  for (const auto& [key, why] : absent) {
    EXPECT_TRUE(known.contains(key)) << "missing.txt: " << key;
    EXPECT_FALSE(why.empty()) << "missing.txt: " << key << " without a reason";
  }
}

TEST(ScenarioCoverage, nothing_joins_what_is_missing) { EXPECT_LE(missing().size(), kMissingAtMost); }

TEST(ScenarioCoverage, no_step_of_the_procedures_is_lost) {
  std::string names;
  std::size_t n = 0;
  for (const Required& r : required()) {
    if (r.kind != "step") continue;
    ++n;
    names += " " + r.name + ">";
  }
  EXPECT_EQ(n, kSteps);
  for (const DialogueRow& row : kDialogueRows)
    EXPECT_NE(names.find(" " + std::string(row.procedure) + "." + row.step + ">"), std::string::npos)
        << "tests/reference/procedure_steps.txt: no branch from " << row.procedure << " " << row.step;
}

TEST(ScenarioCoverage, every_brake_cause_is_required) {
  std::size_t n = 0;
  for (const Required& r : required()) n += r.kind == "brake" ? 1u : 0u;
  EXPECT_EQ(n, brakes::kCauses);
}

TEST(ScenarioCoverage, the_page_is_up_to_date) {
  for (const auto& [file, scenario] : collection().scenarios) (void)result_of(scenario);
  EXPECT_EQ(text_of(fs::path(evc::test::source_folder()) / "docs/scenario-coverage.md"),
            coverage_page(coverage_of(collection())))
      << "scenarios_test --coverage > docs/scenario-coverage.md";
}

std::string lines_of(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& line : all) text += "\n  " + line;
  return text;
}

/// 4.7.2, cell by cell and issue by issue: what is shown, masked and enabled in all scenarios.
TEST(Display, every_cell_of_4_7_2) {
  for (const auto& [file, scenario] : collection().scenarios) (void)result_of(scenario);
  EXPECT_TRUE(wrong_on_display().empty()) << "not in the table:" << lines_of(wrong_on_display());
  EXPECT_TRUE(missing_on_display().empty()) << "in no scenario:" << lines_of(missing_on_display());
  EXPECT_TRUE(not_missing_on_display().empty())
      << "delete from display_missing.txt:" << lines_of(not_missing_on_display());
  EXPECT_LE(known_missing_on_display(), kDisplayMissingAtMost);
  EXPECT_EQ(text_of(fs::path(evc::test::source_folder()) / "docs/display-coverage.md"), display_page())
      << "scenarios_test --display > docs/display-coverage.md";
}

/// 4.6.2 and 4.6.3 of every edition: every cell, every term of every condition, in all scenarios.
TEST(Modes, every_cell_and_every_term_of_every_condition) {
  for (const auto& [file, scenario] : collection().scenarios) (void)result_of(scenario);
  EXPECT_TRUE(wrong_of_modes().empty()) << "table and unit differ:" << lines_of(wrong_of_modes());
  EXPECT_TRUE(missing_of_modes().empty()) << "in no scenario:" << lines_of(missing_of_modes());
  EXPECT_TRUE(not_missing_of_modes().empty()) << "delete from modes_missing.txt:" << lines_of(not_missing_of_modes());
  EXPECT_LE(known_missing_of_modes(), kModesMissingAtMost);
}

/// 3.14.1 and 4.12: every cause of a brake command, in all scenarios.
TEST(Brakes, every_cause_commanded_held_and_released) {
  for (const auto& [file, scenario] : collection().scenarios) (void)result_of(scenario);
  EXPECT_TRUE(missing_of_brakes().empty()) << "in no scenario:" << lines_of(missing_of_brakes());
  EXPECT_TRUE(not_missing_of_brakes().empty())
      << "delete from brakes_missing.txt:" << lines_of(not_missing_of_brakes());
  EXPECT_LE(known_missing_of_brakes(), kBrakesMissingAtMost);
  EXPECT_EQ(text_of(fs::path(evc::test::source_folder()) / "docs/brake-coverage.md"), brakes_page())
      << "scenarios_test --brakes > docs/brake-coverage.md";
}

/// Compares the scenarios of some files through the C interface; the exit code.
int through_c(const Collection& all, const std::vector<std::string_view>& files) {
  std::size_t compared = 0, different = 0;
  for (const auto& [file, scenario] : all.scenarios) {
    if (std::find(files.begin(), files.end(), file) == files.end()) continue;
    ++compared;
    const std::string difference = compare_through_c(inputs_of(scenario));
    if (difference.empty()) continue;
    ++different;
    std::cout << file << "." << case_name(scenario.name) << ": " << difference << "\n";
  }
  std::cout << compared << " scenarios through the C interface, " << different << " with other outputs\n";
  return compared > 0 && different == 0 ? 0 : 1;
}

}  // namespace
}  // namespace evc::scenario

int main(int argc, char** argv) {
  using namespace evc::scenario;
  const Collection& all = collection();
  if (argc == 2 && std::string_view(argv[1]) == "--coverage") {
    for (const auto& [file, scenario] : all.scenarios) (void)run(scenario);
    std::cout << coverage_page(coverage_of(all));
    return 0;
  }
  for (const auto& [option, page] : {std::pair{"--display", &display_page}, std::pair{"--brakes", &brakes_page}}) {
    if (argc < 2 || std::string_view(argv[1]) != option) continue;
    if (argc == 2)
      for (const auto& [file, scenario] : all.scenarios) (void)run(scenario);
    const int status = argc == 2 ? 0 : run_files({argv + 2, argv + argc});
    std::cout << page();
    return status;
  }
  if (argc > 2 && std::string_view(argv[1]) == "--run") return run_files({argv + 2, argv + argc});
  if (argc > 2 && std::string_view(argv[1]) == "--through-c") return through_c(all, {argv + 2, argv + argc});
  if (argc == 3 && std::string_view(argv[1]) == "--inputs") {
    for (const auto& [file, scenario] : all.scenarios)
      if (file + "." + case_name(scenario.name) == argv[2]) {
        std::cout << inputs_of(scenario);
        return 0;
      }
    std::cerr << "no scenario " << argv[2] << "\n";
    for (const auto& [file, why] : all.errors) std::cerr << why << "\n";
    return 2;
  }
  ::testing::InitGoogleTest(&argc, argv);
  for (const auto& [file, scenario] : all.scenarios)
    ::testing::RegisterTest(("Scenario/" + file).c_str(), case_name(scenario.name).c_str(), nullptr, nullptr,
                            scenario.at.file.c_str(), scenario.at.line,
                            [scenario = scenario]() -> ::testing::Test* { return new OneScenario(scenario); });
  for (std::size_t i = 0; i < all.errors.size(); ++i)
    ::testing::RegisterTest(("Scenario/" + all.errors[i].first).c_str(), ("unreadable_" + std::to_string(i)).c_str(),
                            nullptr, nullptr, __FILE__, __LINE__,
                            [why = all.errors[i].second]() -> ::testing::Test* { return new Unreadable(why); });
  return RUN_ALL_TESTS();
}
