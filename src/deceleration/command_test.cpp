#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "io/program_test.h"
#include "io/train_file.h"

// The program as a user has it.
namespace evc::deceleration {
namespace {

using nlohmann::json;

std::string example(const char* name) { return "'" + evc::test::source_folder() + "/examples/brakes/" + name + "' "; }

/// The example of a locomotive with fewer samples.
std::string quick(const Folder& folder) {
  json spec = json::parse(text_of(evc::test::source_folder() + "/examples/brakes/locomotive_and_wagons.json"));
  spec["samples"] = 1000;
  const std::string file = folder / "quick.json";
  std::ofstream(file) << spec.dump();
  return file;
}

TEST(Brakes, the_train_file_is_read_by_curves_and_run) {
  const Folder folder("brakes");
  const std::string train = folder / "train.json";
  const Ended made = ended("brakes '" + quick(folder) + "' -o '" + train + "' --plot '" + (folder / "a.svg") + "'");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_NE(made.output.find("26 brake units, 3 steps of speed, 1540 t"), std::string::npos) << made.output;
  const auto read = io::read_train(text_of(train), train);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->name, "locomotive with 24 wagons, 100 km/h");
  EXPECT_EQ(read->data.emergency[0].steps.steps.size(), 3U);
  EXPECT_EQ(read->dynamics.mass_t, 1540.0);
  EXPECT_GT(read->data.T_emergency[0].T_brake.si, 4.0);
  EXPECT_EQ(text_of(folder / "a.svg").substr(0, 4), "<svg");

  json query = json::parse(text_of(evc::test::source_folder() + "/data/curves/passenger_eoa.json"));
  query["train"] = "train.json";
  std::ofstream(folder / "query.json") << query.dump();
  const Ended curves = ended("curves '" + (folder / "query.json") + "'");
  EXPECT_EQ(curves.exit_code, 0) << curves.errors;
  const Ended run = ended("run --train '" + train + "' -o '" + (folder / "run") + "'");
  EXPECT_NE(run.exit_code, 2) << run.errors;
  EXPECT_EQ(json::parse(text_of(folder / "run/summary.json"))["schema"], "evc-summary/1");
}

TEST(Brakes, threads_make_no_difference) {
  const Folder folder("brakes_threads");
  const std::string spec = quick(folder);
  const std::string one = ended("brakes '" + spec + "' -j 1 --format json --plain 20000").output;
  EXPECT_EQ(one, ended("brakes '" + spec + "' -j 3 --format json --plain 20000").output);
  const json result = json::parse(one);
  EXPECT_EQ(result["schema"], "evc-brakes-result/1");
  EXPECT_EQ(result["steps"].size(), 3U);
  EXPECT_EQ(result["steps"][0]["Kdry_rst"].size(), 10U);
  EXPECT_EQ(result["plain_run"]["compared"], 12);  // three steps of speed, down to 1e-3
  EXPECT_LT(result["plain_run"]["largest_difference"].get<double>(), 0.02);
}

TEST(Brakes, what_is_wrong_is_told_and_no_file_stays) {
  const Folder folder("brakes_wrong");
  const std::string train = folder / "train.json";
  std::ofstream(folder / "wrong.json")
      << R"({"schema": "evc-brakes/1", "vehicles": [{"mass_t": 40, "brake_units": []}]})";
  const Ended wrong = ended("brakes '" + (folder / "wrong.json") + "' -o '" + train + "'");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(wrong.errors, (folder / "wrong.json") + ": /vehicles: found no brake unit, expected at least one\n");
  const Ended without = ended("brakes " + example("normal_units.json") + "-o '" + train + "'");
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_NE(without.errors.find("found no key \"train\", expected"), std::string::npos) << without.errors;
  EXPECT_EQ(ended("brakes " + example("normal_units.json") + "--plot a.png").errors,
            "evc brakes: --plot: found a.png, expected FILE.svg\n");
  EXPECT_EQ(ended("brakes").exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(train));
}

TEST(Brakes, the_train_file_on_standard_output_is_alone_there) {
  const Folder folder("brakes_output");
  const Ended made = ended("brakes '" + quick(folder) + "' -o -");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_TRUE(io::read_train(made.output, "-"));
  EXPECT_NE(made.errors.find("Kdry_rst by M_NVEBCL"), std::string::npos);
}

}  // namespace
}  // namespace evc::deceleration
