#include "curves/overrides.h"

#include <gtest/gtest.h>

#include "curves/curves_test.h"

namespace evc::curves {
namespace {

using nlohmann::json;

json replaced(const json& document, const std::vector<std::string>& texts) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) overrides.push_back(*read_override(text));
  return *overridden(document.dump(), "case.json", overrides);
}

TEST(CurvesSet, KeysOrAPointerLeadToTheMember) {
  for (const char* text : {"train.brake_percentage=120", "/train/brake_percentage=120"}) {
    json expected = passenger();
    expected["train"]["brake_percentage"] = 120;
    EXPECT_EQ(replaced(passenger(), {text}), expected);
  }
  EXPECT_EQ(replaced(passenger(), {"track.gradient.0.1=-7"})["track"]["gradient"][0][1], -7);
  EXPECT_EQ(replaced(passenger(), {"state.V_ura_kmh=f41"})["state"]["V_ura_kmh"], "f41");
  EXPECT_EQ(replaced(passenger(), {"query.speeds_kmh=[10, 20]"})["query"]["speeds_kmh"], (json{10, 20}));
  EXPECT_EQ(replaced(passenger(), {"name=a=b"})["name"], "a=b");
  EXPECT_EQ(replaced(passenger(), {"/train/a~1b~0=null"})["train"]["a/b~"], nullptr);
  // A key with dots is reached by a pointer; the last of equal ones counts.
  EXPECT_EQ(replaced(passenger(), {"srs=\"3.6.0\"", "srs=4.0.0"})["srs"], "4.0.0");
  // Members that are missing are made.
  EXPECT_EQ(replaced(json::object(), {"state.special_brakes_active.ep=false"}),
            json::parse(R"({"state": {"special_brakes_active": {"ep": false}}})"));
}

/// The same query, whether a member is written in the file or set.
TEST(CurvesSet, IsTheSameAsInTheFile) {
  json document = passenger();
  document["train"]["brake_percentage"] = 120;
  document["national_values"]["Kt_int"] = 1.2;
  const Scratch file("set.json", document.dump());
  const Ended written = run(file.path());
  const Ended set = run(kSource +
                        "/data/curves/passenger_eoa.json --set train.brake_percentage=120 "
                        "--set /national_values/Kt_int=1.2");
  ASSERT_EQ(set.exit_code, 0) << set.errors;
  EXPECT_EQ(set.output, written.output);
}

/// The name of the file's train may say another percentage.
TEST(CurvesSet, ATitleSaysWhatWasSet) {
  const std::string query = kSource + "/data/curves/passenger_eoa.json";
  const Scratch chart("chart.svg", ""), page("page.html", "");
  for (const Scratch* file : {&chart, &page}) {
    const Ended ran = run(query + " --set train.brake_percentage=120 --set /srs=4.0.0 --plot " + file->path());
    ASSERT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_NE(text_of(file->path()).find(", with train.brake_percentage=120, /srs=4.0.0"), std::string::npos)
        << file->path();
  }
  // Of a place that is set twice the last value counts.
  ASSERT_EQ(run(query + " --set srs=3.4.0 --set srs=4.0.0 --plot " + chart.path()).exit_code, 0);
  EXPECT_NE(text_of(chart.path()).find(", with srs=4.0.0"), std::string::npos);
  EXPECT_EQ(text_of(chart.path()).find("srs=3.4.0"), std::string::npos);
  // A name that is set is the name.
  ASSERT_EQ(run(query + " --set name=Mine --plot " + chart.path()).exit_code, 0);
  EXPECT_NE(text_of(chart.path()).find(">Mine<"), std::string::npos);
}

TEST(CurvesSet, ReachesIntoAFileThatTheQueryNames) {
  json document = passenger();
  const Scratch train("train.json", document["train"].dump());
  document["train"] = train.path();
  const Scratch file("named.json", document.dump());
  const Ended set = run(file.path() + " --set train.length_m=200");
  ASSERT_EQ(set.exit_code, 0) << set.errors;
  json expected = passenger();
  expected["train"]["length_m"] = 200;
  const Scratch in_place("in_place.json", expected.dump());
  EXPECT_EQ(set.output, run(in_place.path()).output);
}

TEST(CurvesSet, ErrorsNameThePlace) {
  const auto refused = [](const std::string& set) {
    const Ended ran = run(kSource + "/data/curves/passenger_eoa.json --set '" + set + "'");
    EXPECT_EQ(ran.exit_code, 2) << set;
    EXPECT_EQ(ran.output, "");
    return ran.errors;
  };
  for (const char* text : {"train.brake_percentage", "=3", ".=3", "train..x=3", "/=3"})
    EXPECT_EQ(refused(text),
              "--set: found \"" + std::string(text) + "\", expected PLACE=VALUE, as in train.brake_percentage=120\n");
  EXPECT_EQ(refused("track.gradient.9.0=3"),
            "--set: /track/gradient/9/0: found a place that leads nowhere, expected an index of /track/gradient, which "
            "has 2 elements\n");
  EXPECT_EQ(refused("srs.x=3"),
            "--set: /srs/x: found a place that leads nowhere, expected /srs to be an object or a list\n");
  EXPECT_NE(refused("train.brake_percent=3").find("/train/brake_percent: found an unknown key"), std::string::npos);
  EXPECT_NE(refused("train.brake_percentage=20").find("/train/brake_percentage: found 20, expected 30 to 250 %"),
            std::string::npos);
  EXPECT_NE(refused("train={\"a\":1,\"a\":2}").find("/train"), std::string::npos);
}

}  // namespace
}  // namespace evc::curves
