#include "script.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "run.h"

// The reader rejects misspelt words with their place; the runner reports the failed statement and
// its place.
namespace evc::scenario {
namespace {

std::string error_of(std::string_view text) {
  const auto file = read(text, "x.scenario");
  return file ? "" : file.error().text();
}

std::string failure_of(std::string_view text) {
  const auto file = read(text, "x.scenario");
  if (!file) return file.error().text();
  return run(file->scenarios.at(0));
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

struct Wrong {
  const char* text;
  const char* error;
};

TEST(Script, refuses_what_is_misspelt_and_says_where) {
  constexpr Wrong cases[] = {
      {"scenario a\n  when desk opend\n", "x.scenario: line 2: found \"opend\", expected one of closed, opened"},
      {"also 3.5.0\nscenario a\n  then mode SB [4.6.3]\n", "line 1: found also 3.5.0, expected also and an issue"},
      {"scenario a\n  then mode SB [4.6.3]\n  also 3.5.0\n", "line 3: found also 3.5.0, expected also and an issue"},
      {"scenario a\n  if desk opened\n", "line 2: found \"if\", expected given, when, then or and"},
      {"scenario a\n  when desk opened\n", "line 1: found a scenario that expects nothing"},
      {"scenario a\n  then mode FX [4.6.3]\n", "line 2: found \"FX\", expected one of NP, SB"},
      {"scenario a\n  then mood FS [4.6.3]\n", "line 2: found \"mood\", expected event, brakes"},
      {"scenario a\n  then mode FS\n", "expected the clause in brackets"},
      {"scenario a\n  then mode FS [later]\n", "found \"later\", expected a clause"},
      {"scenario a\n  when message 15 { D_EMERGENCYSTP 3 }\n",
       "line 2: found \"D_EMERGENCYSTP\", expected a variable of message 15"},
      {"scenario a\n  when message 3\n    packet 15 { L_ENDSECTION 100 km/h }\n",
       "line 3: found 100 km/h, expected a value of L_ENDSECTION in m"},
      {"scenario a\n  when message 3\n    packet 15 { T_SECTIONTIMER 3 }\n",
       "line 3: found \"T_SECTIONTIMER\", expected it only where its condition in packet 15 holds"},
      {"scenario a\n  when message 3\n    packet 27 { V_STATIC 101 km/h }\n",
       "line 3: found 101 km/h, expected a value that V_STATIC can carry"},
      {"scenario a\n  when message 99\n", "line 2: found message 99, expected a message to the train"},
      {"scenario a\n  when message 24 sent 5 s later\n", "line 2: found \"later\", expected ago"},
      {"scenario a\n  when message 24 bits 4 to 3 are 0\n", "expected the last of at most 32 bits"},
      {"scenario a\n  when message 24 bits 4 to 5 are 4\n", "found \"4\", expected their value"},
      {"scenario a\n  when message 24 cut by 0 bytes\n", "expected 1 to 100 bytes"},
      {"scenario a\n  when passes group 100\n    balise 2 spoiled bits 50 to 57 are 99\n",
       "line 3: found bits of a balise that is spoiled, expected bits of one that is read"},
      {"scenario a\n  when passes group 100 balise 2 bits 50 to 57 are 99 balise 2 missing\n",
       "line 2: found bits of a balise that is missing, expected bits of one that is read"},
      {"scenario a\n  when passes group 100 balise 2 spoiled balise 2 missing\n",
       "line 2: found balise 2 both spoiled and missing, expected one of them"},
      {"scenario a\n  when passes group 20000\n", "line 2: found \"20000\", expected NID_BG"},
      {"scenario a\n  when message 3\n    packet 15 {\n", "line 3: found the end of the file, expected the bracket"},
      {"scenario a\n  when driver enters { driver_id 1 driver_id 2 }\n", "\"driver_id\" again"},
      {"scenario a\n  covers messages 3\n", "found \"messages\", expected one of message, procedure, stored, brake"},
      {"scenario a\n  then sends message 3 [8.7.2]\n", "expected the number of a message to the trackside"},
      {"scenario a\n  then event mode [4.6.3]\n", "expected \"the event as it is printed\""},
      {"scenario a\n  when waits 5\n", "expected a unit, as in \"10 s\""},
      {"block b\n  given desk opened\nblock b\n  given desk closed\n", "line 3: found block b again"},
      {"block b with v = 1 km/h\n  given drives at $w\n", "line 2: found $w, expected a parameter of the block"},
      {"block b with v = 1 km/h\n  given drives at $v\nscenario a\n  given b with w = 3 km/h\n",
       "line 4: found \"w\", expected a parameter of b"},
      {"scenario a\n  then mode SB [4.6.3]\nscenario a\n", "line 3: found scenario a again"},
      {"scenario a\n  when waits 1 s\n  and in the same cycle message 6\n",
       "line 3: found the end of the statement, expected a message, a loop message, an input or drives"},
      {"something\n", "line 1: found \"something\", expected scenario, block or also"},
      {"scenario a\n  when input { t \"unclosed }\n", "line 2: found the end of the line, expected \" that closes"},
  };
  for (const Wrong& c : cases) EXPECT_TRUE(contains(error_of(c.text), c.error)) << c.text << error_of(c.text);
}

TEST(Script, the_same_packet_is_written_with_codes_or_units) {
  const auto message = [](const char* text) {
    const auto file = read(std::string("scenario a\n  when ") + text + "\n  then mode SB [4.6.3]\n", "x.scenario");
    return file ? file->scenarios.at(0).statements.at(0).action.json : Json(file.error().text());
  };
  EXPECT_EQ(message("message 3 packet 15 { L_ENDSECTION 2500 m, T_EMA 30 s } packet 27 { V_STATIC 100 km/h }"),
            message("message 3 packet 15 { L_ENDSECTION 2500 T_EMA 30 } packet 27 { V_STATIC 20 }"));
  EXPECT_EQ(message("message 3 packet 15 { Q_SCALE 2 L_ENDSECTION 2500 m }"),
            message("message 3 packet 15 { Q_SCALE 2 L_ENDSECTION 250 }"));
  EXPECT_EQ(message("message 2 { D_SR unknown }")["D_SR"], 32767);
}

TEST(Runner, goes_through_with_what_holds) {
  EXPECT_EQ(failure_of("scenario a\n  when desk opened\n  then mode SB [4.6.3(4)]\n  and brakes none [4.4.7.1]\n"), "");
}

TEST(Runner, messages_of_the_same_cycle_come_in_their_order) {
  const auto file = read(
      "scenario a\n  when message 24 { T_TRAIN 8 }\n  and in the same cycle message 24 { T_TRAIN 7 }\n"
      "  then mode SB [4.6.3]\n",
      "x.scenario");
  ASSERT_TRUE(file);
  const std::string inputs = inputs_of(file->scenarios.at(0));
  const std::size_t first = inputs.find("\"message\"");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(inputs.find("odometer", first), std::string::npos) << "no cycle begins between them: " << inputs;
}

TEST(Runner, a_message_arrives_damaged_as_written) {
  const auto file = read(
      "scenario a\n  when message 24 { T_TRAIN 0 } bits 8 to 17 are 5 longer by 1 byte\n"
      "  then mode SB [4.6.3(4)]\n",
      "x.scenario");
  ASSERT_TRUE(file);
  // NID_MESSAGE 24, L_MESSAGE 5 instead of 10, 11 bytes.
  const std::string inputs = inputs_of(file->scenarios.at(0));
  EXPECT_TRUE(contains(inputs, "\"message\":\"1801400000001FFFFFE000\"")) << inputs;
  EXPECT_TRUE(contains(failure_of("scenario a\n  when message 24 bits 900 to 900 are 1\n  then mode SB [4.6.3(4)]\n"),
                       "beyond its end"));
}

TEST(Runner, the_odometer_counts_and_is_as_accurate_as_said) {
  const std::string begin =
      "scenario a\n  given odometer reads 5 % too_much\n  and odometer error 10 %\n  and drives at 36 km/h with 40 "
      "m/s2\n"
      "  when drives for 100 m\n";
  EXPECT_EQ(
      failure_of(begin + "  then est_front_m is 105 +- 3 [3.6.4.1]\n  and max_safe_front_m is 115 +- 3 [3.6.4.1]\n"),
      "");
}

TEST(Runner, says_what_did_not_hold_and_where) {
  const std::string text = failure_of("scenario a\n  when desk opened\n  then mode FS [4.6.3(31)]\n");
  EXPECT_TRUE(contains(text, "x.scenario:3: scenario a\n  expected: then mode FS [4.6.3(31)]\n")) << text;
  EXPECT_TRUE(contains(text, "found:    mode \"SB\"")) << text;
  EXPECT_TRUE(contains(text, "mode NP->SB [4]")) << text;
  EXPECT_TRUE(contains(text, "\"t_ms\":0")) << "the last outputs: " << text;
}

TEST(Runner, every_kind_of_expectation_can_fail) {
  for (const char* wrong : {"event \"mode SB->FS*\"",
                            "no event \"mode NP->SB*\"",
                            "sends message 155",
                            "calls { NID_RBC 1 }",
                            "hangs_up",
                            "brakes emergency",
                            "brakes service because trip",
                            "symbol MO11",
                            "no symbol MO13",
                            "request SR",
                            "text \"x\"",
                            "cause trip",
                            "V_P is 100 km/h",
                            "V_P above 3",
                            "est_front_m is 5 m",
                            "est_front_m above 1 m",
                            "est_front_m below -1 m",
                            "est_front_m between 1 m and 2 m",
                            "EOA_m is 100 m from group 7",
                            "mode not SB",
                            "level 2",
                            "lrbg.NID_BG is 3",
                            "monitoring is CSM",
                            "driver.symbols lacks MO13",
                            "v_kmh is null",
                            "within 0.3 s mode FS",
                            "for 0.3 s mode not SB"}) {
    const std::string text = failure_of(std::string("scenario a\n  when desk opened\n  then ") + wrong + " [4.6.3]\n");
    EXPECT_TRUE(contains(text, "x.scenario:3")) << wrong << "\n" << text;
  }
}

TEST(Runner, an_empty_list_of_a_message_is_empty) {
  const std::string session =
      "scenario a\n  given desk opened\n  and waits 1 s\n  and driver enters { driver_id 1234 }\n  and driver enters { "
      "level 2 }\n  and driver enters { rbc { NID_C 1, NID_RBC 1, NID_RADIO \"FFFFFFFFFFFFFFFF\" } }\n  and waits 0.2 "
      "s\n  and session connected\n  when message 32\n  then sends message 159 packet 2 { versions ";
  EXPECT_EQ(failure_of(session + "[ { M_VERSION 16 } ] } [3.5.3.7]\n"), "");
  EXPECT_TRUE(contains(failure_of(session + "[ ] } [3.5.3.7]\n"), "found:    only"));
}

TEST(Runner, every_output_of_the_list_is_one) {
  const std::string error = error_of("scenario a\n  when desk opened\n  then nothing is 1 [4.6.3]\n");
  const std::string list = "or an output: ";
  std::istringstream names(error.substr(error.find(list) + list.size()));
  int seen = 0;
  for (std::string name; std::getline(names >> std::ws, name, ','); ++seen) {
    if (name == "mode" || name == "level") continue;  // these have words of their own
    const std::string failure = failure_of("scenario a\n  when desk opened\n  then " + name + " is 12345 [4.6.3]\n");
    EXPECT_FALSE(contains(failure, "no output")) << name;
  }
  EXPECT_GT(seen, 40) << error;
}

TEST(Runner, a_step_that_cannot_be_done_is_an_error) {
  EXPECT_TRUE(contains(failure_of("scenario a\n  when passes group 3\n  then mode SB [4.6.3]\n"), "it stands"));
  EXPECT_TRUE(
      contains(failure_of("scenario a\n  when desk opened\n  and config { srs 3.4.0 }\n  then mode SB [4.6.3]\n"),
               "cycles have run"));
  EXPECT_TRUE(contains(failure_of("scenario a\n  when message 8\n  then mode SB [4.6.3]\n"), "none was sent"));
  EXPECT_TRUE(contains(failure_of("scenario a\n  when driver selects strat\n  then mode SB [4.6.3]\n"), "strat"));
  EXPECT_TRUE(contains(failure_of("scenario a\n  when waits until mode FS within 1 s\n  then mode SB [4.6.3]\n"),
                       "not so within"));
}

TEST(Runner, what_is_open_has_to_fail_at_its_own_expectation) {
  const std::string begin = "block b\n  given desk opened\n  then mode FS [4.6.3]\nscenario a\n  open \"A1\"\n";
  EXPECT_EQ(failure_of(begin + "  when desk opened\n  then mode FS [4.6.3]\n"), "");
  EXPECT_TRUE(contains(failure_of(begin + "  when desk opened\n  then mode SB [4.6.3]\n"), "holds now"));
  EXPECT_TRUE(contains(failure_of(begin + "  given b\n  then mode FS [4.6.3]\n"), "x.scenario:3"));
  EXPECT_TRUE(contains(failure_of(begin + "  when passes group 1\n  then mode FS [4.6.3]\n"), "it stands"));
}

TEST(Script, each_scenario_once_more_in_another_issue) {
  const auto file =
      read("also 4.0.0\nscenario a\n  covers cell NP>SB\n  given config { srs 3.6.0 }\n  then mode SB [4.6.2]\n",
           "x.scenario");
  ASSERT_TRUE(file && file->scenarios.size() == 2);
  const Scenario& again = file->scenarios[1];
  EXPECT_EQ(file->scenarios[0].srs, "");
  EXPECT_EQ(again.name, "a in 4.0.0");
  EXPECT_EQ(again.srs, "4.0.0");
  EXPECT_TRUE(again.covers.empty());
  EXPECT_TRUE(contains(inputs_of(again), "\"srs\":\"4.0.0\"")) << inputs_of(again);
  EXPECT_TRUE(contains(inputs_of(file->scenarios[0]), "\"srs\":\"3.6.0\""));
}

TEST(Script, one_scenario_once_more_in_other_issues) {
  const auto file = read(
      "also 3.6.0\nscenario a\n  also 3.4.0\n  also 4.0.0\n  then mode SB [4.6.2]\nscenario b\n  then mode SB "
      "[4.6.2]\n",
      "x.scenario");
  ASSERT_TRUE(file.has_value());
  std::string names;
  for (const Scenario& s : file->scenarios) names += s.name + " (" + s.srs + "), ";
  EXPECT_EQ(names, "a (), a in 3.4.0 (3.4.0), a in 4.0.0 (4.0.0), b (), a in 3.6.0 (3.6.0), b in 3.6.0 (3.6.0), ");
}

TEST(Script, the_train_starts_in_the_cycle_of_an_input) {
  const auto cycles = [](const std::string& how) {
    const auto file = read("scenario a\n  given desk opened\n  when driver selects start\n  and " + how +
                               "drives at 3.6 km/h with 10 m/s2 for 0.1 s\n  then v_kmh is 3.6 [3.6.1]\n",
                           "x.scenario");
    const std::string inputs = file ? inputs_of(file->scenarios.front()) : "";
    int n = 0;
    for (std::size_t at = inputs.find("odometer"); at != std::string::npos; at = inputs.find("odometer", at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(cycles(""), 3);
  EXPECT_EQ(cycles("in the same cycle "), 2);
}

TEST(Script, a_cell_that_is_covered_has_to_be_seen) {
  const std::string covering = "scenario a\n  covers cell $\n  given desk opened\n  then mode SB [4.6.2]\n";
  const auto with = [&](const std::string& cell) {
    std::string text = covering;
    return failure_of(text.replace(text.find('$'), 1, cell));
  };
  EXPECT_EQ(with("NP>SB"), "");
  EXPECT_TRUE(contains(with("SB>NP"), "covers cell SB>NP, and the transition was not seen")) << with("SB>NP");
}

TEST(Script, a_step_that_is_covered_has_to_be_seen) {
  const std::string start =
      "scenario a\n  covers step \"$\"\n  given desk opened\n  and waits 1 s\n"
      "  when driver enters { driver_id 1234 }\n  then dialogue.step is \"S2\" [5.4.3.2]\n";
  const auto covering = [&](const std::string& step) {
    std::string text = start;
    return failure_of(text.replace(text.find('$'), 1, step));
  };
  EXPECT_EQ(covering("start_of_mission.S1>S2"), "");
  EXPECT_EQ(covering("start_of_mission.D2>S2"), "") << "a decision is not shown";
  EXPECT_TRUE(contains(covering("start_of_mission.S2>S3"), "covers step start_of_mission.S2>S3, and S3 was not seen"));
  EXPECT_TRUE(contains(covering("start_of_mission.S20>S1"), "and S20 was not seen"));
  EXPECT_TRUE(contains(covering("start_of_mission.S2>S1"), "and S1 was not seen after S2"));
  EXPECT_TRUE(contains(covering("train_trip.S060>D080"), "and S060 was not seen")) << "of its own procedure";
}

}  // namespace
}  // namespace evc::scenario
