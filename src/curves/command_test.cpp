#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "curves/curves_test.h"

namespace evc::curves {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

std::string refusal(const json& document) {
  const auto read = io::read_curves(document.dump(), "case.json");
  return read ? "accepted" : read.error().text();
}

/// A case of the official tool as an input of the command, with all speeds for which it has values.
json as_input(const json& c) {
  json train = c["train"];
  train["brake_model"] = train["model"];
  train["service_brake_interface"] = train["service_brake_command"];
  for (const char* key : {"model", "service_brake_command", "second_brake_combination_not_used"}) train.erase(key);
  json values = c["national_values"];
  values.erase("M_NVEBCL_pct");  // 99.9999999 %: level 9, the default
  for (const char* key : {"Kv_int_passenger", "Kv_int_freight"})
    if (values.contains(key) && values[key].is_null()) values.erase(key);
  json track = {{"gradient", c["track"]["gradient"]}, {"mrsp", {{0, c["V_MRSP_kmh"]}}}};
  if (c["track"].contains("gradient_end_m")) track["gradient"].back().push_back(c["track"]["gradient_end_m"]);
  json target = c["target"];
  if (target["type"] == "LOA_or_MRSP") {
    target["type"] = "LOA";
    target.erase("release_speed_kmh");
  }
  json fixed = c["fixed_values"];
  json speeds = json::array();
  for (const auto& e : c["expected"])
    if (std::find(speeds.begin(), speeds.end(), e["v_kmh"]) == speeds.end()) speeds.push_back(e["v_kmh"]);
  return {{"schema", "evc-curves/1"}, {"srs", "3.4.0"}, {"train", train},   {"national_values", values},
          {"fixed_values", fixed},    {"track", track}, {"target", target}, {"query", {{"speeds_kmh", speeds}}}};
}

TEST(CommandCurves, AgreesWithTheOfficialToolThroughTheCommand) {
  const json reference = load_json(kSource + "/tests/reference/era_examples.json");
  for (const json& c : reference["cases"]) {
    SCOPED_TRACE(c["id"].get<std::string>());
    const Scratch input("era.json", as_input(c).dump());
    const Ended ran = run(input.path());
    ASSERT_EQ(ran.exit_code, 0) << ran.errors;
    const json result = json::parse(ran.output);
    EXPECT_EQ(result["schema"], "evc-curves-result/1");
    std::map<double, json> rows;
    for (const json& row : result["by_speed"]) rows[row["v_kmh"]] = row;
    int checked = 0;
    for (const json& e : c["expected"]) {
      // The decelerations at a given distance are tested in the library.
      if (e.contains("skip") || e.contains("at_distance_m")) continue;
      const json& value = rows.at(e["v_kmh"])[e["q"].get<std::string>()];
      ASSERT_TRUE(value.is_number()) << e.dump();
      EXPECT_NEAR(value.get<double>(), e["value"].get<double>(), e["kind"] == "accel" ? 2e-4 : 0.25) << e.dump();
      ++checked;
    }
    EXPECT_GT(checked, 200);
    for (const json& s : c["scalars"]) {
      const json& scalars = result["scalars"];
      if (s[0] == "T_be") {
        EXPECT_NEAR(scalars["T_be_s"].get<double>(), s[1].get<double>(), 1e-9);
      }
      if (s[0] == "T_bs") {
        EXPECT_NEAR(scalars["T_bs_s"].get<double>(), s[1].get<double>(), 1e-9);
      }
      if (s[0] == "d_startRSM") {
        EXPECT_NEAR(scalars["d_start_RSM_m"].get<double>(), s[1].get<double>(), 0.25);
      }
      if (s[0] == "d_preindication") {
        EXPECT_NEAR(scalars["d_preindication_m"].get<double>(), s[1].get<double>(), 0.25);
      }
    }
  }
}

TEST(CommandCurves, OutputsKeepApartFromInputsAndFromEachOther) {
  const Scratch own("own.json");
  const std::string shipped = kSource + "/data/curves/passenger_eoa.json";
  fs::copy_file(shipped, own.path(), fs::copy_options::overwrite_existing);
  EXPECT_EQ(run(own.path() + " -o " + own.path()).exit_code, 2);
  EXPECT_EQ(run("compare " + shipped + " " + own.path() + " -o " + own.path()).exit_code, 2);
  EXPECT_EQ(text_of(own.path()), text_of(shipped)) << "the input is as it was";
  const Scratch both("both.svg");
  const Ended ran = run(own.path() + " --plot " + both.path() + " -o " + both.path());
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_NE(ran.errors.find("expected another file than that of -o"), std::string::npos) << ran.errors;
  EXPECT_FALSE(fs::exists(both.path()));
}

TEST(CommandCurves, ASpeedThatIsNowhereAllowedHasNoPlace) {
  json document = passenger();
  document["national_values"]["Kv_int_passenger"] = {{0, 0, 0}};  // no safe deceleration
  document["track"]["gradient"] = {{0, 0}};
  for (const char* srs : {"3.4.0", "3.6.0", "4.0.0"}) {
    document["srs"] = srs;
    const Approached a{*io::read_curves(document.dump(), "a")};
    const CurvesResult r = curves_result(a);
    const SpeedRow& row = r.by_speed[10];
    EXPECT_EQ(row.A_safe, Value(0.0));
    for (const Value& v : {row.EBD, row.EBI, row.SBI2, row.FLOI, row.W, row.P, row.I}) EXPECT_FALSE(v) << *v;
    EXPECT_TRUE(row.SBD && row.SBI1);
    for (const Value& v : {r.scalars.d_start_RSM_m, r.scalars.d_preindication_m, r.scalars.d_perturbation_m})
      EXPECT_LT(std::abs(v.value_or(0.0)), 1e5);
    EXPECT_EQ(r.by_speed[0].EBD, Value(0.0));
    EXPECT_EQ(r.notes.size(), 1u);
  }
}

TEST(CommandCurves, ANoteSaysThatNoReleaseSpeedCanBeCalculated) {
  json document = passenger();
  document["target"]["release_speed_kmh"] = "on_board";
  const CurvesResult none = curves_result(Approached(*io::read_curves(document.dump(), "a")));
  EXPECT_FALSE(none.scalars.V_release_kmh);
  ASSERT_EQ(none.notes.size(), 1u);
  EXPECT_EQ(none.notes[0].rfind("no release speed can be calculated on board", 0), 0u);
  document["target"]["svl_location_m"] = 7400;
  document["target"]["reference_m"] =
      6800;  // the trip location is beyond the EOA by 10 m and 10 % of the distance from here
  const CurvesResult some = curves_result(Approached(*io::read_curves(document.dump(), "a")));
  EXPECT_TRUE(some.scalars.V_release_kmh);
  EXPECT_EQ(some.notes.size(), 0u);
}

TEST(CommandCurves, EveryShippedInputInEveryFormat) {
  ASSERT_GE(shipped().size(), 6u);
  for (const std::string& file : shipped()) {
    SCOPED_TRACE(file);
    const Approached a = approached(file);
    const CurvesResult result = curves_result(a);
    const json as_json = json::parse(curves_text(result, Format::json));
    ASSERT_EQ(as_json["by_speed"].size(), result.by_speed.size());
    for (std::size_t i = 0; i < result.by_speed.size(); ++i)
      for (const auto& column : speed_columns(result.separate_EOA)) {
        const Value& value = result.by_speed[i].*column.value;
        const json& shown = as_json["by_speed"][i][column.name];
        ASSERT_EQ(shown.is_null(), !value.has_value());
        if (value) {
          EXPECT_EQ(shown.get<double>(), *value);  // shortest round trip: the same bits
        }
      }
    const std::string csv = curves_text(result, Format::csv);
    EXPECT_GT(std::count(csv.begin(), csv.end(), '\n'), static_cast<long>(result.by_speed.size()));
    EXPECT_NE(curves_text(result, Format::table).find("T_be_s"), std::string::npos);
    EXPECT_FALSE(a.derived().truncated);
  }
}

TEST(CommandCurves, OrderOfTheLimits) {
  for (const std::string& file : shipped())
    for (const SpeedRow& r : curves_result(approached(file)).by_speed) {
      EXPECT_GE(*r.EBI + 1e-9, *r.EBD) << file;
      EXPECT_GE(*r.FLOI + 1e-9, *r.EBI) << file;
      EXPECT_GE(*r.W + 1e-9, *r.FLOI) << file;
      EXPECT_GE(*r.P + 1e-9, *r.W) << file;
      EXPECT_GE(*r.I + 1e-9, *r.P) << file;
    }
}

TEST(CommandCurves, PlaceAndSpeedAreInverse) {
  json document = passenger();
  document["query"] = {{"speeds_kmh", {60, 90, 120, 150}}};
  const Approached a{*io::read_curves(document.dump(), "a")};
  for (const SpeedRow& row : curves_result(a).by_speed) {
    const auto speed_at = [&](double before) {
      return sdm::speeds_at(a.derived(), a.input().inputs, a.target(), Place{{7000.0 - before}}, {}, {});
    };
    EXPECT_NEAR(speed_at(*row.EBD).EBD.si * 3.6, row.v_kmh, 1e-6);
    EXPECT_NEAR(speed_at(*row.EBI).EBI.si * 3.6, row.v_kmh, 1e-6);
    EXPECT_NEAR(speed_at(*row.FLOI).SBI.si * 3.6, row.v_kmh, 1e-6);
    EXPECT_NEAR(speed_at(*row.P).P.si * 3.6, row.v_kmh, 1e-6);
    EXPECT_NEAR(speed_at(*row.I).I.si * 3.6, row.v_kmh, 1e-6);
  }
}

TEST(CommandCurves, SeparateLimitsOfEOAAndSvL) {
  json document = passenger();
  document["target"]["svl_location_m"] = 7100;
  const CurvesResult r = curves_result(Approached(*io::read_curves(document.dump(), "a")));
  const CurvesResult same = curves_result(Approached(*io::read_curves(passenger().dump(), "a")));
  ASSERT_TRUE(r.separate_EOA);
  EXPECT_FALSE(same.separate_EOA);
  const json row = json::parse(curves_text(r, Format::json))["by_speed"][10];
  // The limits of the SvL move by 100 m, those of the EOA do not.
  EXPECT_NEAR(row["P_SvL"].get<double>(), *same.by_speed[10].P_SvL - 100.0, 1e-6);
  EXPECT_NEAR(row["P_EOA"].get<double>(), *same.by_speed[10].P_EOA, 1e-6);
  EXPECT_EQ(row["P"].get<double>(), std::max(row["P_EOA"].get<double>(), row["P_SvL"].get<double>()));
}

TEST(CommandCurves, ARestrictionIsTheSameFromTheProfileOrFromTheTarget) {
  json document = passenger();
  document["target"] = {{"type", "MRSP"}, {"location_m", 5000}, {"speed_kmh", 80}};
  const CurvesResult inserted = curves_result(Approached(*io::read_curves(document.dump(), "a")));
  document["track"]["mrsp"] = {{0, 160}, {5000, 80}};
  const CurvesResult given = curves_result(Approached(*io::read_curves(document.dump(), "a")));
  EXPECT_EQ(curves_text(inserted, Format::json), curves_text(given, Format::json));
  EXPECT_FALSE(given.scalars.V_release_kmh);
  document["target"]["speed_kmh"] = 170;
  document["track"]["mrsp"] = {{0, 160}};
  EXPECT_EQ(refusal(document),
            "case.json: /target/speed_kmh: found 170, expected a speed below the MRSP before the target");
}

TEST(CommandCurves, PermittedBrakingDistancesAndLevelCrossings) {
  json document = passenger();
  document["query"] = {{"speeds_kmh", {100}},
                       {"PBD", {{{"D_PBD", 800}, {"G_PBDSR", 0}}, {{"D_PBD", 800}, {"G_PBDSR", -20}, {"Q_PBDSR", 1}}}},
                       {"LX", {{{"D_LX", 5000}, {"V_LX", 40}}}}};
  const Approached a{*io::read_curves(document.dump(), "a")};
  const CurvesResult r = curves_result(a);
  const json result = json::parse(curves_text(r, Format::json));
  ASSERT_EQ(result["PBD"].size(), 2u);
  const double EB = result["PBD"][0]["V_PBD_kmh"];
  const double SB = result["PBD"][1]["V_PBD_kmh"];
  const auto scratch = std::make_unique<sdm::Derived>();
  EXPECT_EQ(EB, sdm::permitted_braking_distance_speed(a.input().inputs, {800.0}, 0.0, true, *scratch).si * 3.6);
  EXPECT_EQ(std::fmod(EB, 5.0), 0.0);
  EXPECT_GT(EB, SB);
  EXPECT_GT(SB, 0.0);
  const json& lx = result["LX"][0];
  EXPECT_EQ(lx["D_LX"], 5000.0);
  EXPECT_EQ(lx["V_LX_kmh"], 40.0);
  EXPECT_EQ(lx["P"], std::max(lx["P_EOA"].get<double>(), lx["P_SvL"].get<double>()));
  EXPECT_EQ(lx["from_EOA"], lx["P_EOA"] >= lx["P_SvL"] ? 1.0 : 0.0);
  EXPECT_NE(curves_text(r, Format::csv).find("\nD_PBD,G_PBDSR,Q_PBDSR,V_PBD_kmh\n800,0,0,"), std::string::npos);
  EXPECT_NE(curves_text(r, Format::table).find("permitted braking distances\nD_PBD"), std::string::npos);
  document["query"]["PBD"][0]["Q_PBDSR"] = 0.5;
  EXPECT_EQ(refusal(document),
            "case.json: /query/PBD/0/Q_PBDSR: found 0.5, expected 0 (emergency brake) or 1 (service brake)");
}

TEST(CommandCurves, BadInputNamesThePlaceAndTheClause) {
  const auto with = [](const char* pointer, const json& value) {
    json document = passenger();
    document[json::json_pointer(pointer)] = value;
    return refusal(document);
  };
  EXPECT_EQ(with("/train/brake_percentage", 20),
            "case.json: /train/brake_percentage: found 20, expected 30 to 250 % (SUBSET-026 3.13.3.2.1 b)");
  EXPECT_EQ(with("/train/max_speed_kmh", 230),
            "case.json: /train/max_speed_kmh: found 230, expected at most 200 km/h with a brake percentage (SUBSET-026 "
            "3.13.3.2.1 a)");
  EXPECT_NE(with("/national_values/Kt_int", 1.7).find("/national_values/Kt_int: found 1.7"), std::string::npos);
  EXPECT_NE(with("/national_values/Kt_int", 1.7).find("3.13.2.3.7.14"), std::string::npos);
  EXPECT_NE(with("/target/svl_location_m", 6900).find("/target/svl_location_m"), std::string::npos);
  EXPECT_NE(with("/target/speed_kmh", 40).find("/target/speed_kmh"), std::string::npos);
  EXPECT_NE(with("/target/type", "STOP").find("EOA_SvL"), std::string::npos);
  EXPECT_NE(with("/track/slope", 3).find("/track/slope: found an unknown key"), std::string::npos);
  EXPECT_NE(with("/track/gradient", {{100, 1}, {50, 2}}).find("/track/gradient/1/0"), std::string::npos);
  EXPECT_NE(with("/fixed_values/dV_ebi_min", 20).find("A.3.1"), std::string::npos);
  EXPECT_NE(with("/query/speeds_kmh/step", 0).find("/query/speeds_kmh/step"), std::string::npos);
  EXPECT_NE(with("/state/max_safe_front_m", 5).find("est_front_m"), std::string::npos);
  EXPECT_NE(with("/srs", "2.3.0").find("3.4.0"), std::string::npos);
  EXPECT_NE(with("/train", "no_such.json").find("/train: found \"no_such.json\""), std::string::npos);
  EXPECT_EQ(with("/srs", "4.0.0"), "accepted");
}

TEST(CommandCurves, OneLineAndExitStatusTwo) {
  json document = passenger();
  document["train"]["length_m"] = "long";
  const Scratch input("bad.json", document.dump());
  for (const std::string& arguments :
       {input.path(), std::string("/nowhere.json"), std::string("--plot picture.gif"),
        "compare " + input.path() + " " + input.path(), std::string("--model workbook --plot a.html")}) {
    const Ended ran = run(arguments);
    EXPECT_EQ(ran.exit_code, 2) << arguments;
    EXPECT_EQ(ran.output, "");
    EXPECT_EQ(std::count(ran.errors.begin(), ran.errors.end(), '\n'), 1) << ran.errors;
  }
  EXPECT_NE(run(input.path()).errors.find("/train/length_m: found \"long\", expected a number"), std::string::npos);
}

TEST(CommandCurves, TrainsAndNationalValuesThatShip) {
  int trains = 0;
  for (const auto& file : fs::directory_iterator(kSource + "/data/trains")) {
    const auto train = io::read_train(text_of(file.path().string()), file.path().string());
    ASSERT_TRUE(train) << train.error().text();
    EXPECT_EQ(train::check(train->data), train::Fault::none) << file.path();
    ++trains;
  }
  EXPECT_GE(trains, 8);
  for (const auto& file : fs::directory_iterator(kSource + "/data/national_values")) {
    json document = passenger();
    document["national_values"] = file.path().string();
    EXPECT_EQ(refusal(document), "accepted");
  }
}
/// A table by position for a restriction to 60 km/h in an MRSP of 120 km/h.
json by_position(std::vector<int> places, json state = json::object()) {
  const json document = {{"schema", "evc-curves/1"},
                         {"train", {{"length_m", 100}}},
                         {"track", {{"gradient", {{0, 0}}}, {"mrsp", {{0, 120}}}}},
                         {"target", {{"type", "MRSP"}, {"location_m", 5000}, {"speed_kmh", 60}}},
                         {"state", state},
                         {"query", {{"positions_m", places}}}};
  return json::parse(
      curves_text(curves_result(Approached(*io::read_curves(document.dump(), "a"))), Format::json))["by_position"];
}

TEST(CommandCurves, ByPositionTheLimitsHaveTheirCeilingsAndFloors) {
  // 3.13.9.2 at 120 and 60 km/h: dV_ebi 8.25 and 7.5, dV_sbi 6.0 and 5.5, dV_warning 4.33 and 4 km/h.
  const json rows = by_position({1000, 4999, 5000, 5001});
  EXPECT_NEAR(rows[0]["EBI"].get<double>(), 120 + 7.5 * 1.1, 1e-9);
  EXPECT_NEAR(rows[0]["P"].get<double>(), 120.0, 1e-9);
  EXPECT_NEAR(rows[0]["I"].get<double>(), 120.0, 1e-9);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_NEAR(rows[i]["EBI"].get<double>(), 67.5, 1e-9) << i;
    EXPECT_NEAR(rows[i]["SBI"].get<double>(), 65.5, 1e-9) << i;
    EXPECT_NEAR(rows[i]["W"].get<double>(), 64.0, 1e-9) << i;
    EXPECT_NEAR(rows[i]["P"].get<double>(), 60.0, 1e-9) << i;
    EXPECT_NEAR(rows[i]["I"].get<double>(), 60.0, 1e-9) << i;
  }
}

TEST(CommandCurves, ByPositionTheLimitsOfTheEBDCountForTheMaxSafeFrontEnd) {
  // All limits of a restriction are those of an EBD: 300 m of the confidence interval are 300 m along the line.
  const json exact = by_position({4300, 4600});
  const json uncertain =
      by_position({4300}, {{"est_front_m", 4000}, {"max_safe_front_m", 4300}, {"min_safe_front_m", 3700}});
  for (const char* limit : {"EBI", "SBI", "W", "P", "I"}) {
    EXPECT_EQ(uncertain[0][limit], exact[1][limit]) << limit;
    EXPECT_LT(exact[1][limit], exact[0][limit]) << limit;
  }
  EXPECT_EQ(uncertain[0]["EBD"], exact[0]["EBD"]);  // the curve at the place
}

TEST(CommandCurves, UpToTheSvLNoLimitIsBelowTheReleaseSpeed) {
  json document = passenger();
  document["target"]["svl_location_m"] = 7100;
  document["query"] = {{"positions_m", {7030, 7090, 7101}}};
  const json rows = json::parse(
      curves_text(curves_result(Approached(*io::read_curves(document.dump(), "a"))), Format::json))["by_position"];
  for (std::size_t i = 0; i < 2; ++i)
    for (const char* limit : {"EBI", "SBI", "W"}) EXPECT_NEAR(rows[i][limit].get<double>(), 30.0, 1e-9) << i << limit;
  for (const char* limit : {"EBI", "SBI", "W", "P", "I"}) EXPECT_EQ(rows[2][limit], 0.0) << limit;
}

TEST(CommandCurves, APermittedBrakingDistanceIsNotCutByTheSpeedOfTheTrain) {
  json document = {{"schema", "evc-curves/1"},
                   {"train", {{"max_speed_kmh", 100}, {"length_m", 100}}},
                   {"track", {{"gradient", {{0, 0}}}}},
                   {"target", {{"type", "EOA_SvL"}, {"location_m", 9000}}},
                   {"query", {{"speeds_kmh", {50}}, {"PBD", {{{"D_PBD", 3500}, {"G_PBDSR", 0}, {"Q_PBDSR", 0}}}}}}};
  document["query"]["PBD"].push_back({{"D_PBD", 6000}, {"G_PBDSR", 0}, {"Q_PBDSR", 0}});
  const auto slow = PBD_rows(Approached(*io::read_curves(document.dump(), "a")));
  EXPECT_EQ(*slow[0].back().second, 190.0);
  EXPECT_EQ(*slow[1].back().second, 250.0);
}

TEST(CommandCurves, ATrainWithoutANameIsCalledByItsBrakes) {
  const auto name = [](json train) {
    json document = passenger();
    document["train"] = std::move(train);
    return Approached(*io::read_curves(document.dump(), "a")).input().train_name;
  };
  EXPECT_EQ(name({{"length_m", 100}}), "passenger, 135 %");
  EXPECT_EQ(name({{"brake_position", "FreightG"}, {"brake_percentage", 65}}), "freight in G, 65 %");
  EXPECT_EQ(name({{"brake_position", "FreightP"}, {"brake_percentage", 72.5}}), "freight in P, 72.5 %");
  EXPECT_EQ(name({{"name", "x"}, {"brake_position", "FreightG"}}), "x");
}

}  // namespace
}  // namespace evc::curves
