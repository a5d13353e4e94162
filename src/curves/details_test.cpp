#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "curves/curves_test.h"
#include "curves/details.h"
#include "curves/explain.h"

// The tables of `query.details`, V_ura as a function of speed, and the state of the service brake feedback.
namespace evc::curves {
namespace {

using nlohmann::json;

json result_of(const json& document) {
  return json::parse(curves_text(curves_result(approached(document)), Format::json));
}

json with_details(json document, const std::vector<std::string>& names) {
  document["query"]["details"] = names;
  return document;
}

TEST(CurvesDetails, OnlyWhatIsAskedForIsComputed) {
  json document = passenger();
  const json plain = result_of(document);
  for (const char* key :
       {"ceilings", "times", "locations", "fixed_locations", "arcs", "targets", "confidence_interval"})
    EXPECT_FALSE(plain.contains(key)) << key;
  const json all = result_of(with_details(document, {"ceilings", "times", "locations", "arcs", "targets"}));
  EXPECT_EQ(all["by_speed"], plain["by_speed"]);
  for (const char* key : {"ceilings", "times", "locations", "fixed_locations", "arcs", "targets"})
    EXPECT_FALSE(all.at(key).empty()) << key;
  for (const auto& [format, text] :
       {std::pair{Format::csv, "v_kmh,dV_warning,dV_sbi,dV_ebi"}, std::pair{Format::table, "arcs of the braking"}})
    EXPECT_NE(curves_text(curves_result(approached(with_details(document, {"ceilings", "arcs"}))), format).find(text),
              std::string::npos);
}

TEST(CurvesDetails, CeilingsOfA31) {
  json document = with_details(passenger(), {"ceilings"});
  document["query"]["speeds_kmh"] = {60, 120, 250};
  const json rows = result_of(document)["ceilings"];
  // dV_ebi: 7.5 km/h up to 110 km/h, 15 from 210 on.
  EXPECT_NEAR(rows[0]["dV_ebi"].get<double>(), 7.5, 1e-9);
  EXPECT_NEAR(rows[1]["dV_ebi"].get<double>(), 8.25, 1e-9);
  EXPECT_NEAR(rows[2]["dV_ebi"].get<double>(), 15.0, 1e-9);
  EXPECT_NEAR(rows[1]["EBI"].get<double>(), 128.25, 1e-9);
  EXPECT_NEAR(rows[0]["SBI"].get<double>(), 65.5, 1e-9);
  EXPECT_NEAR(rows[0]["W"].get<double>(), 64.0, 1e-9);
}

/// The times give the limits: d_SBI2 = d_EBI - V T_bs2, d_I = d_P - V T_indication.
TEST(CurvesDetails, TheTimesAreThoseOfTheLimits) {
  for (const char* srs : {"3.4.0", "3.6.0", "4.0.0"}) {
    json document = with_details(passenger(), {"times"});
    document["srs"] = srs;
    document["query"]["speeds_kmh"] = {30, 90, 150};
    const json r = result_of(document);
    ASSERT_EQ(r["times"].size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      const json &times = r["times"][i], &row = r["by_speed"][i];
      const double v = row["v_kmh"].get<double>() / 3.6;
      const auto difference = [&](const char* far, const char* near) {
        return row[far].get<double>() - row[near].get<double>();
      };
      // The official tool draws the EBI of 3.4.0 from the start of release speed monitoring on.
      if (i > 0) {
        EXPECT_NEAR(difference("SBI2", "EBI"), v * times["T_bs2_s"].get<double>(), 1e-6) << srs;
      }
      EXPECT_NEAR(difference("SBI1", "SBD"), v * times["T_bs1_s"].get<double>(), 1e-6) << srs;
      EXPECT_NEAR(difference("I", "P"), v * times["T_indication_s"].get<double>(), 1e-6) << srs;
      EXPECT_NEAR(times["T_I_to_P_s"].get<double>(), times["T_indication_s"].get<double>(), 1e-6) << srs;
      EXPECT_NEAR(times["T_berem_s"].get<double>(),
                  std::max(0.0, times["T_be_s"].get<double>() - times["T_traction_s"].get<double>()), 1e-9);
      // Slower than the curve alone: P bends by the times too.
      EXPECT_LT(times["A_along_P"].get<double>(), row["A_safe"].get<double>());
      EXPECT_GT(times["A_along_P"].get<double>(), 0.0);
    }
  }
}

/// The arcs are the curve: every distance of by_speed follows from them.
TEST(CurvesDetails, TheArcsAreTheCurve) {
  for (const std::string& file : shipped()) {
    if (file.find("workbook") != std::string::npos) continue;
    SCOPED_TRACE(file);
    const Approached a = approached(with_details(load_json(file), {"arcs"}));
    const json r = json::parse(curves_text(curves_result(a), Format::json));
    std::size_t found = 0;
    for (const json& row : r["by_speed"])
      for (const json& arc : r["arcs"]) {
        if (arc["curve"] != "EBD" || row["EBD"].is_null() || !(arc["A"].get<double>() > 0.0)) continue;
        const double v = row["v_kmh"].get<double>() / 3.6, low = arc["v_to_kmh"].get<double>() / 3.6;
        const bool last = arc["v_from_kmh"].is_null();
        if (!(v > low) || (!last && v > arc["v_from_kmh"].get<double>() / 3.6)) continue;
        const double x = arc["to_m"].get<double>() - (v * v - low * low) / (2.0 * arc["A"].get<double>());
        EXPECT_NEAR(m(a.input().target_location) - x, row["EBD"].get<double>(), 1e-5);
        if (!last) {
          EXPECT_GE(x, arc["from_m"].get<double>() - 1e-6);
        }
        ++found;
      }
    EXPECT_GT(found, 3u);
  }
}

TEST(CurvesDetails, EveryTargetOnTheWayByItsOwnLocation) {
  json document = with_details(passenger(), {"targets", "arcs"});
  document["track"]["mrsp"] = {{0, 160}, {3000, 100}};
  document["query"]["speeds_kmh"] = {60, 120};
  const json r = result_of(document);
  ASSERT_EQ(r["targets"].size(), 3u);  // 60 km/h is no speed above the restriction's
  EXPECT_EQ(r["targets"][0]["type"], "MRSP");
  EXPECT_EQ(r["targets"][0]["V_target_kmh"], 100.0);
  EXPECT_EQ(r["targets"][0]["location_m"], 3000.0);
  EXPECT_EQ(r["targets"][2]["type"], "EOA_SvL");
  EXPECT_EQ(r["targets"][2]["P"], r["by_speed"][1]["P"]);
  // The same restriction as the target of the query.
  document["target"] = {{"type", "MRSP"}, {"location_m", 3000}, {"speed_kmh", 100}};
  EXPECT_EQ(result_of(document)["by_speed"][1]["P"], r["targets"][0]["P"]);
  std::set<double> with_arcs;
  for (const json& arc : r["arcs"]) with_arcs.insert(arc["target"].get<double>());
  EXPECT_EQ(with_arcs, (std::set<double>{1, 2}));
}

TEST(CurvesDetails, WhatTheConfidenceIntervalChanges) {
  json document = with_details(passenger(), {"confidence_interval"});
  EXPECT_EQ(io::read_curves(document.dump(), "case.json").error().text(),
            "case.json: /query/details: found confidence_interval, expected state.est_front_m as well");
  document["state"] = {{"est_front_m", 5800}, {"max_safe_front_m", 5850}, {"min_safe_front_m", 5780}};
  std::map<std::string, json> rows;
  const json result = result_of(document);
  for (const json& row : result["confidence_interval"]) rows[row["value"]] = row;
  EXPECT_EQ(rows.at("EBD")["difference"], 0.0);  // the curve at the place
  EXPECT_LT(rows.at("EBI")["difference"].get<double>(), -1.0);
  EXPECT_EQ(rows.at("target_distance")["with"], 1150.0);
  EXPECT_EQ(rows.at("target_distance")["exact"], 1200.0);
  document["state"] = {{"est_front_m", 5850}};
  document["query"]["positions_m"] = {5850};
  EXPECT_EQ(rows.at("EBI")["with"], result_of(document)["by_position"][0]["EBI"]);
}

TEST(CurvesDetails, F41AsTheSpeedUnderReading) {
  json document = with_details(passenger(), {"times"});
  document["query"] = {{"speeds_kmh", {20, 150}}, {"positions_m", {6500}}, {"details", {"times"}}};
  document["national_values"]["Q_NVINHSMICPERM"] = false;
  document["state"]["V_ura_kmh"] = "f41";
  const json r = result_of(document);
  EXPECT_NEAR(r["times"][0]["V_ura_kmh"].get<double>(), 2.0, 1e-9);
  for (std::size_t i = 0; i < 2; ++i) {
    json constant = document;
    constant["state"]["V_ura_kmh"] = train::f41(Speed{r["by_speed"][i]["v_kmh"].get<double>() / kKmh}).si * kKmh;
    EXPECT_NEAR(result_of(constant)["by_speed"][i]["EBI"].get<double>(), r["by_speed"][i]["EBI"].get<double>(), 1e-6);
  }
  // By place: the speed at which the EBI with its own f41 is there.
  json there = document;
  there["query"] = {{"speeds_kmh", {r["by_position"][0]["EBI"].get<double>()}}};
  EXPECT_NEAR(result_of(there)["by_speed"][0]["EBI"].get<double>(), 500.0, 1e-3);
  EXPECT_NE(explain_text(approached(document), 150).find("V_ura = f41(V)"), std::string::npos);
  document["state"]["V_ura_kmh"] = "f42";
  EXPECT_EQ(io::read_curves(document.dump(), "case.json").error().text().rfind("case.json: /state/V_ura_kmh", 0), 0u);
}

TEST(CurvesDetails, TheStateOfTheServiceBrakeFeedback) {
  for (const char* srs : {"3.6.0", "4.0.0"}) {
    json document = with_details(passenger(), {"times"});
    document["srs"] = srs;
    document["train"]["service_brake_feedback"] = true;
    document["national_values"]["Q_NVSBFBPERM"] = true;
    document["query"]["speeds_kmh"] = {100};
    const json free = result_of(document);
    const double T_bs = free["times"][0]["T_bs_s"];
    document["state"]["service_brake_feedback"] = {{"p0_kpa", 500}, {"p_kpa", 455}};
    const json braking = result_of(document);
    EXPECT_NEAR(braking["times"][0]["T_bs1_s"].get<double>(), T_bs * 0.7, 1e-9);  // (455 - 350) / 150
    EXPECT_LT(braking["by_speed"][0]["SBI1"], free["by_speed"][0]["SBI1"]);
    EXPECT_LT(braking["scalars"]["d_start_RSM_m"], free["scalars"]["d_start_RSM_m"]);
    const std::string page = explain_text(approached(document), 100);
    EXPECT_NE(page.find("(p - p3) / (p0 - p3)"), std::string::npos);
    // 3.13.9.3.6.5 of 4.0.0: the Indication limit ignores it.
    EXPECT_EQ(braking["by_speed"][0]["I"] == free["by_speed"][0]["I"], std::string(srs) == "4.0.0");
    document["state"]["service_brake_feedback"] = "locked";
    const json locked = result_of(document);
    EXPECT_EQ(locked["times"][0]["T_bs1_s"], 0.0);
    EXPECT_EQ(locked["times"][0]["T_bs2_s"], 2.0);
    EXPECT_EQ(locked["by_speed"][0]["SBI1"], locked["by_speed"][0]["SBD"]);
    document["train"]["service_brake_feedback"] = false;
    EXPECT_NE(result_of(document)["notes"][0].get<std::string>().find("feedback has no effect"), std::string::npos);
  }
  json document = passenger();
  document["state"]["service_brake_feedback"] = "released";
  EXPECT_EQ(io::read_curves(document.dump(), "case.json").error().text(),
            "case.json: /state/service_brake_feedback: found \"released\", expected \"locked\", or the pressures "
            "p0_kpa and p_kpa");
}

}  // namespace
}  // namespace evc::curves
