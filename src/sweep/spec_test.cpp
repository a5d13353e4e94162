#include "sweep/spec.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "base/test_paths.h"
#include "sweep/cases.h"
#include "sweep/plan.h"

namespace evc::sweep {
namespace {

using io::Json;

std::string spec_of(const std::string& vary, const std::string& rest = "") {
  return R"({"schema":"evc-sweep/1","kind":"run","vary":[)" + vary + "]" + rest + "}";
}

/// The error of a text, in one line.
std::string error_of(const std::string& text) {
  const auto plan = Plan::make(text, "spec.json");
  return plan ? "none" : plan.error().text();
}

Spec read(const std::string& text) {
  auto spec = read_spec(text, "spec.json");
  EXPECT_TRUE(spec) << spec.error().text();
  return spec ? *spec : Spec();
}

TEST(Spec, a_grid_has_all_combinations_once) {
  const Spec spec = read(spec_of(R"({"at":"/train/length_m","list":[50,75]},
      {"at":"/driver","list":["late","reckless"]}, {"at":"/odometer/error","uniform":[-0.01,0.01]},
      {"at":"/seed","count":3})"));
  ASSERT_EQ(spec.cases, 12U);
  const Cases cases(spec);
  std::set<std::string> combinations;
  for (std::uint64_t n = 0; n < spec.cases; ++n) {
    auto values = cases.values(n);
    EXPECT_TRUE(values[2].get<double>() >= -0.01 && values[2].get<double>() < 0.01);
    values.erase(values.begin() + 2);
    combinations.insert(Json(values).dump());
  }
  EXPECT_EQ(combinations.size(), 12U);
  EXPECT_EQ(cases.values(0)[3], 1);
  EXPECT_EQ(cases.values(1)[3], 2);  // the last entry changes first
}

TEST(Spec, a_range_has_both_ends) {
  const Spec whole = read(spec_of(R"({"at":"/train/length_m","range":[50,200,50]})"));
  EXPECT_EQ(Json(whole.vary[0].list).dump(), "[50,100,150,200]");
  const Spec tenths = read(spec_of(R"({"at":"/odometer/error","range":[0,0.3,0.1]})"));
  ASSERT_EQ(tenths.cases, 4U);
  EXPECT_NEAR(tenths.vary[0].list[3].get<double>(), 0.3, 1e-12);
}

TEST(Spec, draws_of_random_and_sobol_follow_the_distributions) {
  for (const char* sample : {"random", "sobol"}) {
    const Spec spec = read(spec_of(R"({"at":"/odometer/error","normal":[0.1,0.02]},{"at":"/seed","count":4},
        {"at":"/driver","list":["late","perfect"]})",
                                   std::string(R"(,"cases":4000,"sample":")") + sample + '"'));
    const Cases cases(spec);
    double sum = 0.0, squares = 0.0;
    std::map<std::string, int> seeds, drivers;
    for (std::uint64_t n = 0; n < spec.cases; ++n) {
      const auto values = cases.values(n);
      const double z = (values[0].get<double>() - 0.1) / 0.02;
      sum += z;
      squares += z * z;
      ++seeds[values[1].dump()];
      ++drivers[values[2].dump()];
    }
    EXPECT_NEAR(sum / 4000.0, 0.0, 0.05) << sample;
    EXPECT_NEAR(squares / 4000.0, 1.0, 0.08) << sample;
    ASSERT_EQ(seeds.size(), 4U);
    for (const auto& [seed, count] : seeds) EXPECT_NEAR(count, 1000, 110) << sample << seed;
    EXPECT_NEAR(drivers["\"late\""], 2000, 140) << sample;
  }
}

struct Wrong {
  const char* text;
  const char* error;  // its begin
};

TEST(Spec, errors_name_the_place) {
  const Wrong all[] = {
      {"{", "spec.json: line 1 column 2: found the end of the text"},
      {"[]", "spec.json: /: found an array of 0, expected an object"},
      {R"({"schema":"etcs-train/1"})", "spec.json: /schema: found \"etcs-train/1\" (a train"},
      {R"({"schema":"evc-sweep/1","kind":"rum","vary":[]})",
       "spec.json: /kind: found \"rum\", expected one of \"run\""},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[]})", "spec.json: /vary: found an empty list"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"seed","count":3}]})",
       "spec.json: /vary/0/at: found \"seed\", expected a JSON pointer"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed","list":[]}]})",
       "spec.json: /vary/0/list: found an empty list, expected at least one value"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed"}]})", "spec.json: /vary/0: found no values"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed","count":2,"list":[1]}]})",
       "spec.json: /vary/0: found 2 kinds of values"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed","count":0}]})",
       "spec.json: /vary/0/count: found 0, expected an integer from 1"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed","range":[3,1,1]}]})",
       "spec.json: /vary/0/range/1: found 1, expected a number from 3.0"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed","range":[1,3,0]}]})",
       "spec.json: /vary/0/range/2: found 0, expected a step above 0"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed","count":2},{"at":"/seed","count":2}]})",
       "spec.json: /vary/1/at: found \"/seed\", expected a place that no other entry replaces"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/train","list":[{}]},{"at":"/train/length_m","list":[9]}]})",
       "spec.json: /vary/1/at: found \"/train/length_m\", expected a place that no other entry replaces"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed","count":1000000},{"at":"/last_ma","range":[1,5000,1]}]})",
       "spec.json: /vary: found more than 1000000000 combinations"},
      {R"({"schema":"evc-sweep/1","kind":"run","sample":"sobol","vary":[{"at":"/seed","count":2}]})",
       "spec.json: /: found no key \"cases\""},
      {R"({"schema":"evc-sweep/1","kind":"run","cases":9,"vary":[{"at":"/seed","count":2}]})",
       "spec.json: /cases: found 9, expected no \"cases\""},
      {R"({"schema":"evc-sweep/1","kind":"run","measure":[],"vary":[{"at":"/seed","count":2}]})",
       "spec.json: /measure: found an array of 0"},
      // What needs the files.
      {R"({"schema":"evc-sweep/1","kind":"run","base":{"lane":1},"vary":[{"at":"/seed","count":2}]})",
       "spec.json: /base/lane: found an unknown key"},
      {R"({"schema":"evc-sweep/1","kind":"run","base":{"train":"no_such"},"vary":[{"at":"/seed","count":2}]})",
       "spec.json: /base/train: found \"no_such\" ("},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/train","list":["push_pull","no_such"]}]})",
       "spec.json: /vary/0/list/1: found \"no_such\" ("},
      {R"({"schema":"evc-sweep/1","kind":"run","base":{"driver":"asleep"},"vary":[{"at":"/seed","count":2}]})",
       "spec.json: /base/driver: found \"asleep\""},
      {R"({"schema":"evc-sweep/1","kind":"run","base":{"train":{"length_m":-3}},"vary":[{"at":"/seed","count":2}]})",
       "spec.json: /base/train/length_m: found -3"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/sed","count":2}]})",
       "spec.json: /vary/0/at: found /sed, which leads nowhere, expected one of "},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/train/brake_precentage","list":[100]}]})",
       "spec.json: /vary/0/at: found /train/brake_precentage, which leads nowhere, expected one of schema, name, "},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/train/length_m/x/y","list":[100]}]})",
       "spec.json: /vary/0/at: found /train/length_m/x/y, which leads nowhere, expected a place: /train/length_m has "
       "no members"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/train/dynamics/mass","list":[100]}]})",
       "spec.json: /vary/0/at: found /train/dynamics/mass, which leads nowhere, expected one of mass_t"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/line/lenght_m","list":[100]}]})",
       "spec.json: /vary/0/at: found /line/lenght_m, which leads nowhere"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/line/balise_groups/999/balises","list":[[]]}]})",
       "spec.json: /vary/0/at: found /line/balise_groups/999/balises, which leads nowhere, expected an index"},
      {R"({"schema":"evc-sweep/1","kind":"curves","base":{"query":"passenger_eoa"},"vary":[{"at":"/schema","list":["x"]}]})",
       "spec.json: /vary/0/at: found \"/schema\", expected a place other than a schema"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/train/schema/x","list":["x"]}]})",
       "spec.json: /vary/0/at: found \"/train/schema/x\", expected a place other than a schema"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/train/schema","list":["x"]}]})",
       "spec.json: /vary/0/at: found \"/train/schema\", expected a place other than a schema"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed","list":[1,1.5]}]})",
       "spec.json: /vary/0/list/1: found 1.5, expected an integer from 0 to 9223372036854775807"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed","range":[1,2,0.5]}]})",
       "spec.json: /vary/0/range: found [1,2,0.5], numbers with a fraction, expected an integer from 0 to "
       "9223372036854775807"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed","uniform":[1,9]}]})",
       "spec.json: /vary/0/uniform: found [1,9], numbers with a fraction, expected an integer from 0 to "
       "9223372036854775807"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/driver","list":["late"]},{"at":"/last_ma","normal":[9,1]}]})",
       "spec.json: /vary/1/normal: found [9,1], numbers with a fraction, expected an integer from 0 to 1000000"},
      {R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/seed/x","list":[100]}]})",
       "spec.json: /vary/0/at: found /seed/x, which leads nowhere, expected a place: /seed has no members"},
      {R"({"schema":"evc-sweep/1","kind":"run","measure":["duration"],"vary":[{"at":"/seed","count":2}]})",
       "spec.json: /measure/0: found \"duration\", expected one of distance_m, duration_s"},
      {R"({"schema":"evc-sweep/1","kind":"run","measure":["cycle_us.max"],"vary":[{"at":"/seed","count":2}]})",
       "spec.json: /measure/0: found \"cycle_us.max\""},
      {R"({"schema":"evc-sweep/1","kind":"curves","base":{"query":"passenger_eoa"},"vary":[{"at":"/target/location","list":[1]}]})",
       "spec.json: /vary/0/at: found /target/location, which leads nowhere"},
      {R"({"schema":"evc-sweep/1","kind":"curves","vary":[{"at":"/target/location_m","list":[1]}]})",
       "spec.json: /base: found no key \"query\""},
      {R"({"schema":"evc-sweep/1","kind":"curves","base":{"query":"passenger_eoa"},
           "vary":[{"at":"/query/train/brake_percentage","list":[50]},{"at":"/train/brake_percentage","list":[90]}]})",
       "spec.json: /vary/1/at: found \"/train/brake_percentage\", expected a place that no other entry replaces"},
      {R"({"schema":"evc-sweep/1","kind":"replay","base":{"inputs":"none.jsonl"},"vary":[{"at":"/config/srs","list":["3.6.0"]}]})",
       "spec.json: /base/inputs: found \"none.jsonl\""},
  };
  for (const Wrong& wrong : all) {
    const std::string error = error_of(wrong.text);
    EXPECT_EQ(error.substr(0, std::string(wrong.error).size()), wrong.error) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

/// A spec of a kind that varies one place.
std::string varied(const std::string& kind, const std::string& base, const std::string& at, const std::string& values) {
  return R"({"schema":"evc-sweep/1","kind":")" + kind + R"(","base":)" + base + R"(,"vary":[{"at":")" + at + R"(",)" +
         values + "}]}";
}

// Where a name, a document, a flag or a list stands no number can be, drawn or not: all cases would fail.
TEST(Spec, values_of_another_kind_are_refused) {
  const std::string query = R"({"query":"passenger_eoa"})";
  const std::string inputs =
      R"({"inputs":")" + evc::test::source_folder() + R"(/tests/replays/repositioning_without_unknown_group.jsonl"})";
  const struct {
    const char* kind;
    std::string base;
    const char* at;
    std::vector<std::string> other_kinds;  // elements of a list
    const char* expected;
  } places[] = {
      {"run", "{}", "/driver", {"1", "null", "true", "[]", "{}"}, "one of \"perfect\", "},
      {"run", "{}", "/srs", {"3.6", "null", "[]"}, "one of \"3.4.0\", "},
      {"run", "{}", "/line", {"1", "null", "[1]"}, "an object"},
      {"run", "{}", "/train", {"1.5", "null", "true", "[1]"}, "an object"},
      {"run", "{}", "/national_values", {"1", "null", "[1]"}, "an object"},
      {"run", "{}", "/odometer", {"1", "\"x\"", "null"}, "an object"},
      {"run", "{}", "/train/brake_model", {"1", "null"}, "one of \"lambda\""},
      {"run", "{}", "/train/traction_cut_off_interface", {"1", "\"x\""}, "true or false"},
      {"run", "{}", "/train/dynamics", {"1", "\"x\"", "[]"}, "an object"},
      {"run", "{}", "/line/physical_track/ssp", {"1", "\"x\"", "{}"}, "an array"},
      {"curves", query, "/train", {"1", "null", "[1]"}, "an object"},
      {"curves", query, "/query/national_values", {"1", "null"}, "an object"},
      {"curves", query, "/srs", {"3.6", "null"}, "one of \"3.4.0\""},
      {"curves", query, "/target", {"1", "\"x\""}, "an object"},
      {"curves", query, "/target/type", {"1", "null"}, "one of \"EOA_SvL\""},
      {"curves", query, "/track/gradient", {"1", "\"x\""}, "an array"},
      {"replay", inputs, "/config", {"1", "\"x\"", "null"}, "an object"},
      {"replay", inputs, "/config/srs", {"3.6", "null"}, "one of \"3.4.0\""},
      {"replay", inputs, "/config/train", {"1", "\"x\""}, "an object"},
  };
  for (const auto& place : places) {
    const auto refused = [&](const std::string& values, const std::string& where, const std::string& found) {
      const std::string error = error_of(varied(place.kind, place.base, place.at, values));
      const std::string begin = "spec.json: /vary/0/" + where + ": found " + found + ", expected " + place.expected;
      EXPECT_EQ(error.substr(0, begin.size()), begin) << place.kind << place.at << ' ' << values;
    };
    refused(R"("uniform":[1,9])", "uniform", "[1,9], numbers with a fraction");
    refused(R"("normal":[5,0.5])", "normal", "[5,0.5], numbers with a fraction");
    refused(R"("range":[2,3,0.25])", "range", "[2,3,0.25], numbers with a fraction");
    refused(R"("range":[2,3,1])", "range", "[2,3,1], numbers");
    refused(R"("count":4)", "count", "4, the numbers from 1 on");
    for (const std::string& element : place.other_kinds) {
      const std::string error = error_of(varied(place.kind, place.base, place.at, "\"list\":[" + element + "]"));
      EXPECT_EQ(error.substr(0, 28), "spec.json: /vary/0/list/0: f") << place.at << ' ' << element << ": " << error;
    }
  }
}

// Wherever the value is in the list and whatever the other entries are.
TEST(Spec, a_value_of_another_kind_is_found_among_others) {
  EXPECT_EQ(error_of(varied("run", "{}", "/driver", R"("list":["late","reckless",7])")),
            "spec.json: /vary/0/list/2: found 7, expected one of \"perfect\", \"late\", \"reckless\"");
  EXPECT_EQ(error_of(varied("run", "{}", "/train", R"("list":["push_pull",{"length_m":100},{"lenght_m":100}])"))
                .substr(0, 66),
            "spec.json: /vary/0/list/2/lenght_m: found an unknown key, expected");
  EXPECT_EQ(error_of(varied("run", "{}", "/train/brake_percentage", R"("list":[100,120.5,"high"])")),
            "spec.json: /vary/0/list/2: found \"high\", expected a number");
  // With what `base` has instead of the first entry the reader does not come to the second.
  EXPECT_EQ(error_of(R"({"schema":"evc-sweep/1","kind":"run","base":{"train":{"brake_percentage":5}},"vary":[
                         {"at":"/train/brake_percentage","list":[110]},
                         {"at":"/train/traction_cut_off_interface","uniform":[0,1]}]})"),
            "spec.json: /vary/1/uniform: found [0,1], numbers with a fraction, expected true or false");
}

// What `base` has beside the places that vary is the same in all cases.
TEST(Spec, a_base_of_which_no_case_can_be_is_refused) {
  EXPECT_EQ(error_of(varied("run", R"({"odometer":{"x":5}})", "/odometer/error", R"("list":[0])")),
            "spec.json: /base/odometer/x: found an unknown key, expected one of error");
  EXPECT_EQ(error_of(varied("run", R"({"train":{"length_m":"long"}})", "/train/brake_percentage", R"("list":[110])")),
            "spec.json: /base/train/length_m: found \"long\", expected a number");
  // Out of range: one case after the other says it, as the place may depend on what varies.
  EXPECT_EQ(error_of(varied("run", R"({"train":{"length_m":-1}})", "/train/brake_percentage", R"("list":[110])")),
            "none");
}

// A case that cannot be is a row: a number out of range, a name that there is not.
TEST(Spec, values_out_of_range_are_cases) {
  for (const char* values : {R"("list":[5,110])", R"("uniform":[1,300])", R"("normal":[100,80])", R"("count":40)"})
    EXPECT_EQ(error_of(varied("run", "{}", "/train/brake_percentage", values)), "none") << values;
  EXPECT_EQ(error_of(varied("run", "{}", "/driver", R"("list":["late","asleep"])")), "none");
  EXPECT_EQ(error_of(varied("run", "{}", "/train", R"("list":[{"length_m":-3},"push_pull"])")), "none");
  EXPECT_EQ(error_of(varied("run", "{}", "/last_ma", R"("list":[null,3])")), "none");
  EXPECT_EQ(error_of(varied("run", "{}", "/last_ma", R"("count":1000001)")).substr(0, 62),
            "spec.json: /vary/0/count: found 1000001, the numbers from 1 on");
}

// A file that a list names has an error of its own.
TEST(Spec, a_file_of_a_list_is_read_as_its_reader_does) {
  for (const char* kind : {"run", "curves"}) {
    const std::string base = kind == std::string("run") ? "{}" : R"({"query":"passenger_eoa"})";
    const std::string values = R"("list":["push_pull","../../data/lines/brunnental.json"])";
    const std::string spec = varied(kind, base, "/train", values);
    const auto plan = Plan::make(spec, evc::test::source_folder() + "/examples/sweep/spec.json");
    ASSERT_FALSE(plan) << kind;
    EXPECT_NE(plan.error().text().find("brunnental.json: /"), std::string::npos) << plan.error().text();
    EXPECT_NE(plan.error().text().find("found "), std::string::npos) << plan.error().text();
  }
}

// The document of a case is made as deep as a place is.
TEST(Spec, a_place_is_not_deeper_than_a_document) {
  std::string deep = "/config";
  for (int i = 0; i < 500'000; ++i) deep += "/a";
  const std::string error = error_of(spec_of(R"({"at":")" + deep + R"(","list":[1]})"));
  EXPECT_EQ(error.substr(0, 37), "spec.json: /vary/0/at: found \"/config");
  EXPECT_NE(error.find("expected a place of at most 64 levels"), std::string::npos);
}

TEST(Spec, keys_that_may_be_absent_can_vary) {
  // The standard train is an empty document: its keys are known all the same.
  for (const char* at : {"/train/brake_percentage", "/train/dynamics/mass_t", "/national_values/V_NVREL", "/last_ma"})
    EXPECT_EQ(error_of(spec_of(std::string(R"({"at":")") + at + R"(","list":[40]})")), "none") << at;
}

TEST(Spec, the_identity_is_that_of_spec_and_files) {
  const auto identity = [](const std::string& text) { return (*Plan::make(text, "spec.json"))->identity(); };
  const std::string a = spec_of(R"({"at":"/seed","count":2})");
  EXPECT_EQ(identity(a), identity(spec_of(R"({"count":2,   "at":"/seed"})")));
  EXPECT_NE(identity(a), identity(spec_of(R"({"at":"/seed","count":3})")));
  EXPECT_NE(identity(a), identity(spec_of(R"({"at":"/seed","count":2})", R"(,"base":{"train":"push_pull"})")));
}

}  // namespace
}  // namespace evc::sweep
