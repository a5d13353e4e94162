#include "deceleration/spec.h"

#include <gtest/gtest.h>

#include <limits>

#include "deceleration/train_document.h"

namespace evc::deceleration {
namespace {

using io::Json;

Json right() {
  return Json::parse(R"({"schema": "evc-brakes/1", "vehicles": [
    {"count": 2, "mass_t": 50, "rotating_mass_pct": 10, "brake_units": [
      {"count": 3, "force_kN": [[0, 20], [80, 15]], "friction": {"normal": [1, 0.05]}, "response_s": 1.5, "failure": 0.001},
      {"deceleration_mps2": [[0, 0.1], [120, 0.05]], "pressure": {"uniform": [0.9, 1]}, "response_s": {"uniform": [1, 2]}}]},
    {"mass_t": 30}],
    "train": {"A_brake_service": [[0, 0.7]], "T_brake_service_s": 3, "Kwet_rst": [[0, 0.9], [60, 0.85]]}})");
}

/// The error of the description with this value at a place; "" where there is none.
std::string refused(const char* place, const char* value) {
  Json document = right();
  document[Json::json_pointer(place)] = Json::parse(value);
  const auto spec = read_spec(document.dump(), "a.json");
  if (!spec) return spec.error().text();
  const auto train = check_train(*spec);
  return train ? "" : train.error().text();
}

TEST(Spec, units_masses_and_steps) {
  const auto spec = read_spec(right().dump(), "a.json");
  ASSERT_TRUE(spec) << spec.error().text();
  EXPECT_EQ(spec->units(), 8U);
  EXPECT_DOUBLE_EQ(spec->mass_t, 130.0);
  EXPECT_DOUBLE_EQ(spec->dynamic_mass_t, 140.0);
  EXPECT_EQ(spec->speeds_kmh, (std::vector<double>{0.0, 80.0, 120.0}));
  EXPECT_DOUBLE_EQ(spec->groups[0].nominal[1].second, 15.0 / 140.0);
  EXPECT_DOUBLE_EQ(at_speed(spec->groups[1].nominal, 80.0), 0.1);
  EXPECT_DOUBLE_EQ(at_speed(spec->groups[1].nominal, 120.0), 0.05);
}

TEST(Spec, what_is_wrong_is_told_with_its_place) {
  const std::string unit = "/vehicles/0/brake_units/0";
  struct Wrong {
    std::string place;
    const char* value;
    std::string error;
  };
  const Wrong all[] = {
      {"/schema", "\"evc-sweep/1\"",
       "/schema: found \"evc-sweep/1\" (a sweep: evc sweep computes its cases), expected \"evc-brakes/1\""},
      {"/samples", "10", "/samples: found 10, expected"},
      {"/vehicle", "1", "/vehicle: found an unknown key, expected"},
      {"/vehicles", "[]", "/vehicles: found an empty list, expected at least one vehicle"},
      {"/vehicles", "[{\"mass_t\": 4}]", "/vehicles: found no brake unit, expected at least one"},
      {"/vehicles/0/mass_t", "0", "/vehicles/0/mass_t: found 0, expected"},
      {"/vehicles/0/count", "300", "/vehicles/0/brake_units/0: found 900 brake units, expected at most 512"},
      {unit + "/force_kN", "[]", unit + "/force_kN: found an empty list, expected at least one [from km/h, kN]"},
      {unit + "/force_kN", "[[10, 3]]", unit + "/force_kN/0/0: found 10, expected 0: the first step begins at 0"},
      {unit + "/force_kN", "[[0, 3], [0, 2]]", unit + "/force_kN/1/0: found 0, expected a step further"},
      {unit + "/force_kN/0/1", "-1", unit + "/force_kN/0/1: found -1, expected"},
      {unit + "/deceleration_mps2", "[[0, 1]]", unit + ": found both, expected one of force_kN, deceleration_mps2"},
      {unit + "/failure", "1", unit + "/failure: found 1, expected"},
      {unit + "/friction", "\"normal\"", unit + "/friction: found \"normal\", expected a number, or one of"},
      {unit + "/friction", "{}", unit + "/friction: found 0 kinds, expected"},
      {unit + "/friction", "{\"normal\": [1, 0]}", unit + "/friction/normal/1: found 0, expected a deviation"},
      {unit + "/friction", "{\"normal\": [1, 0.2]}",
       unit +
           "/friction/normal: found a normal variable that is negative in more than 1 of 1e9 cases, expected a mean of "
           "at least 6 deviations, or {\"truncated\": [mean, deviation, 0, to]}"},
      {unit + "/response_s", "{\"normal\": [1, 0.5]}", unit + "/response_s/normal: found a normal variable"},
      {unit + "/friction", "0", unit + "/friction: found 0, expected a mean above 0"},
      {unit + "/friction", "{\"truncated\": [1, 0.1, 1.2, 1.1]}", unit + "/friction/truncated/3: found 1.1, expected"},
      {unit + "/friction", "{\"truncated\": [1, 0.1, 3, 4]}", unit + "/friction/truncated: found"},
      {unit + "/friction", "{\"discrete\": [[1, 0.5], [2, 0.4]]}",
       unit + "/friction/discrete: found probabilities of 0.9"},
      {unit + "/friction", "{\"tabulated\": [[1, 0], [2, 0.4]]}",
       unit + "/friction/tabulated/1/1: found 0.4, expected 1"},
      {unit + "/response_s", "{\"uniform\": [1, 100]}", unit + "/response_s/uniform/1: found 100, expected"},
      {"/response_level", "10", "/response_level: found 10, expected"},
      {"/train/Kdry_rst", "[[0, 1]]", "/train/Kdry_rst: found the key Kdry_rst, expected no such key"},
      {"/train/T_brake_emergency_s", "2", "/train/T_brake_emergency_s: found the key"},
      {"/train/length_m", "0", "/train/length_m: found 0, expected"},
      {"/train/A_brake_service", "[[5, 1]]", "/train/A_brake_service/0/0: found 5, expected 0"},
  };
  for (const Wrong& wrong : all)
    EXPECT_EQ(refused(wrong.place.c_str(), wrong.value).substr(0, 8 + wrong.error.size()), "a.json: " + wrong.error);
  EXPECT_EQ(refused("/seed", "7"), "");
}

TEST(Spec, response_times_are_those_of_all_units) {
  Json document = right();
  document["vehicles"][0]["brake_units"][1].erase("response_s");
  const auto spec = read_spec(document.dump(), "a.json");
  ASSERT_FALSE(spec);
  EXPECT_EQ(spec.error().where, "/vehicles/0/brake_units/1");
}

TEST(Spec, a_train_that_misses_what_is_not_computed_is_refused) {
  Json document = right();
  document["train"].erase("T_brake_service_s");
  auto spec = read_spec(document.dump(), "a.json");
  ASSERT_TRUE(spec);
  const auto train = check_train(*spec);
  ASSERT_FALSE(train);
  EXPECT_EQ(train.error().found, "no key \"T_brake_service_s\"");
}

// The key that was written is named: T_brake_emergency_s is computed.
TEST(TrainDocument, a_build_up_time_without_a_bound_is_told_at_the_response_of_the_unit) {
  Json document = right();
  document["vehicles"][0]["brake_units"][1]["response_s"] = Json::parse(R"({"normal": [2, 0.2]})");
  const auto spec = read_spec(document.dump(), "a.json");
  ASSERT_TRUE(spec);
  Step step;
  step.A_brake_emergency = 1.0;
  step.Kdry_rst.fill(0.9);
  const auto train = train_document(*spec, {&step, 1}, std::numeric_limits<double>::infinity());
  ASSERT_FALSE(train);
  EXPECT_EQ(
      train.error().text(),
      "a.json: /vehicles/0/brake_units/1/response_s: found no upper bound of the build-up time at level 9, expected at "
      "most 120 s: a truncated variable, more samples, or a lower response_level");
  EXPECT_TRUE(train_document(*spec, {&step, 1}, 2.5));
}

// Those of Kwet_rst are in the same steps: at most 7 together.
TEST(TrainSteps, leave_room_for_the_steps_of_Kwet_rst) {
  const auto spec = read_spec(right().dump(), "a.json");
  ASSERT_TRUE(spec);
  std::vector<Step> steps(8);
  for (std::size_t s = 0; s < steps.size(); ++s) {
    steps[s].from_kmh = 21.0 * static_cast<double>(s);
    steps[s].A_brake_emergency = 1.2 - 0.07 * static_cast<double>(s);
    steps[s].Kdry_rst.fill(0.9);
  }
  const auto joint = train_steps(*spec, steps);
  EXPECT_EQ(joint.size(), 6U);  // one of Kwet_rst begins elsewhere
  EXPECT_TRUE(train_document(*spec, joint, 1.5));
  EXPECT_FALSE(train_document(*spec, steps, 1.5));
}

}  // namespace
}  // namespace evc::deceleration
