#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "io/program_test.h"

// `evc explain` and `evc describe modes` as commands. Journeys with their answers: tests/explain/.
namespace evc::explain {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A stream of inputs of a desk that is opened, 1 s long, with a fault at 0.5 s.
struct Stream {
  explicit Stream(const std::string& more = "") : folder("explain_inputs") {
    std::ofstream out(file());
    out << R"({"t_ms":0,"train":{"desk_open":true}})"
        << "\n"
        << more << R"({"t_ms":1000,"train":{"desk_open":true}})"
        << "\n";
  }
  std::string file() const { return folder / "inputs.jsonl"; }
  Ended explain(const std::string& options) const { return ended("explain '" + file() + "' " + options); }
  Folder folder;
};

constexpr const char* kFault = "{\"t_ms\":500,\"fault\":{\"safety\":true}}\n";

TEST(ExplainCommand, mode_level_brake_speed_and_position) {
  const Ended e = Stream().explain("--at 300");
  EXPECT_EQ(e.exit_code, 0) << e.errors;
  EXPECT_TRUE(has(e.output, "0.3 s: SB, level 0, 0 km/h\n")) << e.output;
  EXPECT_TRUE(has(e.output, "0.0 s: mode NP->SB: the unit is supplied [4.6.3(4)]\n")) << e.output;
  EXPECT_TRUE(has(e.output, "brake      no command\n")) << e.output;
  EXPECT_TRUE(has(e.output, "no LRBG\n")) << e.output;
}

TEST(ExplainCommand, every_transition_out_of_the_mode_with_what_hinders_it) {
  const Ended e = Stream().explain("--at 900");
  for (const char* line : {"  NP p2  [29] the unit is supplied\n", "  FS p7  [10] train data not valid; MA, SSP and",
                           "  SL p5  [14] no sleeping signal; a desk is open\n", "  SF p3  [13] no fault\n",
                           "  IS p1  [1] isolation device not operated\n"})
    EXPECT_TRUE(has(e.output, line)) << line << e.output;
}

TEST(ExplainCommand, the_cycle_of_a_transition_has_the_conditions_of_the_mode_left) {
  const Ended e = Stream(kFault).explain("--at 500");
  EXPECT_TRUE(has(e.output, "0.5 s: SF, ")) << e.output;
  EXPECT_TRUE(has(e.output, "SB is left for SF in this cycle (4.6.2, 4.6.3; any [condition]; ")) << e.output;
  EXPECT_TRUE(has(e.output, "  SF p3  [13] holds: a fault that affects safety\n")) << e.output;
  EXPECT_FALSE(has(e.output, "is not left")) << e.output;
}

TEST(ExplainCommand, the_cycle_is_the_last_one_not_after_the_time) {
  const Ended e = Stream().explain("--at 399");
  EXPECT_TRUE(has(e.output, "0.3 s: SB")) << e.output;
}

TEST(ExplainCommand, why_the_brake_of_a_failure) {
  const Ended e = Stream(kFault).explain("--at 900 --why-brake");
  EXPECT_EQ(e.exit_code, 0) << e.errors;
  EXPECT_TRUE(has(e.output, "1     0.5 s  a fault that affects safety is reported\n")) << e.output;
  EXPECT_TRUE(has(e.output, "2     0.5 s  mode SB->SF: a fault that affects safety [4.6.3(13)]\n")) << e.output;
  EXPECT_TRUE(has(e.output, "emergency brake at 0 km/h")) << e.output;
}

// A reading that shows movement holds for 1 s.
TEST(ExplainCommand, why_the_brake_of_an_odometer_that_stops) {
  const std::string moving =
      R"({"t_ms":200,"odometer":{"accel_mps2":0,"min_m":0,"nominal_m":0,"max_m":0,"speed_mps":1}})";
  const Stream stream(moving + "\n");
  std::ofstream(stream.file(), std::ios::app) << R"({"t_ms":2000})"
                                              << "\n";
  const Ended e = stream.explain("--at 1500 --why-brake");
  EXPECT_TRUE(has(e.output, "the odometer is silent: its last reading, of 0.2 s, is 1.1 s old, more than 1 s"))
      << e.output;
  EXPECT_TRUE(has(e.output, "emergency brake at")) << e.output;
  EXPECT_TRUE(has(e.output, "[4.4.5.1.2]\n    will not be released: it is permanent")) << e.output;
}

TEST(ExplainCommand, no_brake_is_an_answer_too) {
  const Ended e = Stream(kFault).explain("--at 400 --why-brake");
  EXPECT_EQ(e.exit_code, 1);
  EXPECT_EQ(e.output, "0.4 s: no brake has been commanded\n");
}

TEST(ExplainCommand, a_time_behind_the_end) {
  const Ended e = Stream().explain("--at 5000");
  EXPECT_EQ(e.exit_code, 1);
  EXPECT_TRUE(has(e.errors, "found a journey that ends at 1000 ms, expected a cycle at 5000 ms\n")) << e.errors;
  EXPECT_TRUE(e.output.empty());
}

TEST(ExplainCommand, what_is_wrong_is_one_line) {
  const Stream stream;
  for (const std::string& arguments :
       {"explain '" + stream.file() + "'", "explain '" + stream.file() + "' --at x",
        "explain '" + stream.file() + "' --at -1", std::string("explain no_such_file --at 0"),
        "explain '" + stream.file() + "' --at 0 --config no_such_file",
        "explain '" + stream.file() + "' --at 0 --persistent no_such_file",
        "explain '" + stream.file() + "' --at 0 -o '" + stream.file() + "'",
        "explain '" + evc::test::source_folder() + "/data/lines/brunnental.json' --at 0"}) {
    const Ended e = ended(arguments);
    EXPECT_EQ(e.exit_code, 2) << arguments;
    EXPECT_TRUE(e.output.empty()) << arguments;
    EXPECT_EQ(std::count(e.errors.begin(), e.errors.end(), '\n'), 1) << arguments << e.errors;
  }
}

TEST(ExplainCommand, what_else_a_run_writes_is_named_and_what_to_give_instead) {
  const Stream stream;
  const std::string expected = ", expected a stream of inputs, as inputs.jsonl of evc run\n";
  const std::string outputs = stream.folder / "outputs.jsonl", summary = stream.folder / "summary.json";
  ASSERT_EQ(ended("replay '" + stream.file() + "' -o '" + outputs + "'").exit_code, 0);
  EXPECT_EQ(ended("explain '" + outputs + "' --at 0").errors, outputs + ": line 1: found a line of outputs" + expected);
  std::ofstream(summary) << "{\n  \"schema\": \"evc-summary/1\",\n  \"line\": \"Brunnental\"\n}\n";
  const Ended e = ended("explain '" + summary + "' --at 0");
  EXPECT_EQ(e.exit_code, 2);
  EXPECT_EQ(e.errors, summary + ": /schema: found \"evc-summary/1\" (the summary of a run)" + expected);
}

TEST(ExplainCommand, an_error_in_a_line_before_the_cycle) {
  const Ended e = Stream("{\"t_ms\":200,\"trian\":{}}\n").explain("--at 900");
  EXPECT_EQ(e.exit_code, 2);
  EXPECT_TRUE(has(e.errors, "line 2")) << e.errors;
}

// The packet occurs twice in one telegram, which make-line encodes as it is described.
TEST(ExplainCommand, why_a_telegram_was_not_decoded) {
  const Folder folder("explain_telegram");
  const std::string order = R"({"level_transition":{"at_m":1000,"level":"0","acknowledge_m":100}})";
  std::ofstream(folder / "twice.json")
      << R"({"schema":"evc-line-description/1","name":"twice","NID_C":1000,"length_m":900,)"
      << R"("start":{"front_m":-40,"level":"0"},"gradient":[[-500,2000,0]],"ssp":[[-500,2000,60]],)"
      << R"("groups":[{"NID_BG":101,"at_m":300,"orders":[)" << order << "," << order << R"(]}],"radio":[]})";
  ASSERT_EQ(ended("make-line '" + (folder / "twice.json") + "' -o '" + (folder / "line.json") + "'").exit_code, 0);
  ASSERT_EQ(ended("run '" + (folder / "line.json") + "' -o '" + (folder / "out") + "'").exit_code, 0);
  const std::string inputs = folder / "out/inputs.jsonl";
  const std::string answer = ended("explain '" + inputs + "' --at 45000 --why-brake").output;
  EXPECT_TRUE(has(answer, "message inconsistent: balise 1 of 2 was not decoded: packet occurs twice")) << answer;
  EXPECT_TRUE(has(answer, "(packet 41, bit 113) [3.16.2.4.4]\n")) << answer;
}

TEST(DescribeModes, the_matrix_and_its_conditions) {
  const Ended e = ended("describe modes");
  EXPECT_EQ(e.exit_code, 0) << e.errors;
  EXPECT_TRUE(has(e.output, "     NP  SB  PS  SH  FS  LS  SR  OS  SL  NL  UN  TR  PT  SF  IS  SN  RV\n")) << e.output;
  EXPECT_TRUE(has(e.output, "PS            .  26\n                 p5\n")) << e.output;
  EXPECT_TRUE(has(e.output, "  59  standstill and the driver acknowledges reversing\n")) << e.output;
}

TEST(DescribeModes, the_table_of_4_0_0) {
  const Ended e = ended("describe modes --srs 4.0.0");
  EXPECT_TRUE(has(e.output, "  SM  FS  AD  LS")) << e.output;
  EXPECT_TRUE(has(e.output, "  84  the accumulated error of the odometer is beyond the safety threshold\n"))
      << e.output;
}

TEST(DescribeModes, the_graph_has_an_arrow_for_each_transition_but_those_of_every_mode) {
  const Ended e = ended("describe modes --svg");
  EXPECT_EQ(e.exit_code, 0) << e.errors;
  std::size_t arrows = 0;
  for (std::size_t at = 0; (at = e.output.find("marker-end", at)) != std::string::npos; ++at) ++arrows;
  EXPECT_EQ(arrows, 129u - 15u - 12u - 16u);  // into NP, SF, IS
  EXPECT_TRUE(has(e.output, "<title>FS to TR: [12, 16, 17, 18, 20, 41, 65, 66, 69], priority 4</title>")) << e.output;
  EXPECT_EQ(e.output.rfind("</svg>\n"), e.output.size() - 7);
  EXPECT_TRUE(has(e.output, ">Not drawn: into NP by [29], SF by [13], IS by [1].</text>")) << e.output;
  EXPECT_TRUE(has(ended("describe modes --svg --srs 4.0.0").output,
                  ">Not drawn: into NP by [29], SF by [13, 84], IS by [1].</text>"));
}

/// The labels of a graph: middle and half width, of digits in font size 10.
struct Label {
  double x, y, width;
};
std::vector<Label> labels_of(const std::string& svg) {
  std::vector<Label> labels;
  const std::regex label("<text class=\"label\" x=\"([0-9.]+)\" y=\"([0-9.]+)\"[^>]*>([^<]*)</text>");
  for (std::sregex_iterator at(svg.begin(), svg.end(), label), end; at != end; ++at)
    labels.push_back({std::stod((*at)[1]), std::stod((*at)[2]), 2.8 * static_cast<double>((*at)[3].length())});
  return labels;
}

TEST(DescribeModes, no_label_of_the_graph_covers_another) {
  for (const char* options : {"describe modes --svg", "describe modes --svg --srs 4.0.0"}) {
    const std::vector<Label> labels = labels_of(ended(options).output);
    EXPECT_GE(labels.size(), 86u) << options;
    for (std::size_t i = 0; i < labels.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const Label &a = labels[i], &b = labels[k];
        EXPECT_FALSE(std::abs(a.x - b.x) < a.width + b.width && std::abs(a.y - b.y) < 10.0)
            << options << ": labels at " << a.x << ", " << a.y << " and " << b.x << ", " << b.y;
      }
  }
}

TEST(DescribeModes, each_edition_of_a_unit_has_its_table) {
  EXPECT_EQ(ended("describe modes --srs 3.4.0").output, ended("describe modes").output);
}

TEST(DescribeModes, another_edition_is_refused) { EXPECT_EQ(ended("describe modes --srs 3.7.0").exit_code, 2); }

}  // namespace
}  // namespace evc::explain
