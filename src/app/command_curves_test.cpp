#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/curves_compare.h"
#include "app/curves_explain.h"
#include "app/curves_plot.h"
#include "app/curves_result.h"
#include "app/curves_workbook.h"
#include "app/svg.h"
#include "io/file.h"

namespace evc::app {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const std::string kSource = EVC_SOURCE_DIR;

json load_json(const std::string& path) {
  std::ifstream in(path);
  return json::parse(in);
}
std::string text_of(const std::string& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Ran {
  int status;
  std::string out, err;
};
/// Runs the program itself.
Ran run(const std::string& arguments) {
  const fs::path folder = fs::temp_directory_path() / ("evc_curves_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::string out = (folder / "out").string();
  const std::string err = (folder / "err").string();
  const int status =
      std::system((std::string(EVC_PROGRAM) + " curves " + arguments + " >" + out + " 2>" + err).c_str());
  Ran ran{WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
  fs::remove_all(folder);
  return ran;
}
class Scratch {
 public:
  explicit Scratch(const std::string& name)
      : path_((fs::temp_directory_path() / (std::to_string(::getpid()) + "_" + name)).string()) {}
  Scratch(const std::string& name, const std::string& text) : Scratch(name) { std::ofstream(path_) << text; }
  ~Scratch() { fs::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

json passenger() { return load_json(kSource + "/data/curves/passenger_eoa.json"); }
std::vector<std::string> shipped() {
  std::vector<std::string> files;
  for (const auto& file : fs::directory_iterator(kSource + "/data/curves")) files.push_back(file.path().string());
  return files;
}
Approached approached(const std::string& file) { return Approached(*io::read_curves(text_of(file), file)); }
std::string refusal(const json& document) {
  const auto read = io::read_curves(document.dump(), "case.json");
  return read ? "accepted" : read.error().text();
}

/// A case of the official tool as an input of the command, with all speeds that it has values for.
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
    const Ran ran = run(input.path());
    ASSERT_EQ(ran.status, 0) << ran.err;
    const json result = json::parse(ran.out);
    EXPECT_EQ(result["schema"], "evc-curves-result/1");
    std::map<double, json> rows;
    for (const json& row : result["by_speed"]) rows[row["v_kmh"]] = row;
    int checked = 0;
    for (const json& e : c["expected"]) {
      // The decelerations at a given distance are the library's test.
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
  EXPECT_EQ(run(own.path() + " -o " + own.path()).status, 2);
  EXPECT_EQ(run("compare " + shipped + " " + own.path() + " -o " + own.path()).status, 2);
  EXPECT_EQ(text_of(own.path()), text_of(shipped)) << "the input is as it was";
  const Scratch both("both.svg");
  const Ran ran = run(own.path() + " --plot " + both.path() + " -o " + both.path());
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("expected another file than that of -o"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(both.path()));
}

TEST(CommandCurves, APlotBesideAnExplanation) {
  const Scratch plot("explained.svg");
  const Ran ran = run(kSource + "/data/curves/passenger_eoa.json --explain 140 --plot " + plot.path());
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("3.13"), std::string::npos);
  EXPECT_NE(text_of(plot.path()).find("<svg"), std::string::npos);
  EXPECT_EQ(run("--model workbook --explain 100").status, 2);
}

TEST(CommandCurves, EveryWorkbookColumnThroughTheCommand) {
  const json sheet = load_json(kSource + "/tests/reference/workbook_example.json")["case"];
  const Ran ran = run("--model workbook");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json result = json::parse(ran.out);
  EXPECT_EQ(result["columns"], sheet["columns"]);
  ASSERT_EQ(result["rows"].size(), sheet["rows"].size());
  for (std::size_t i = 0; i < sheet["rows"].size(); ++i)
    for (std::size_t k = 0; k < sheet["columns"].size(); ++k)
      EXPECT_NEAR(result["rows"][i][k].get<double>(), sheet["rows"][i][k].get<double>(), 1e-9);
  // The sheet's EBD is the standard's; its EBI is never above it (seed_excel_model: anchor and hold).
  for (std::size_t i = 1; i < sheet["rows"].size(); ++i) {
    EXPECT_NEAR(result["srs_rows"][i][1].get<double>(), sheet["rows"][i][2].get<double>(), 1e-6);
    EXPECT_LE(sheet["rows"][i][18].get<double>(), result["srs_rows"][i][2].get<double>() + 1e-6);
  }
}

TEST(CommandCurves, TheWorkbookModelStopsAtAnEndOfAuthority) {
  const Approached a = approached(kSource + "/data/curves/passenger_eoa.json");
  const Workbook w = workbook_of(a);
  EXPECT_EQ(w.rows.front().distance, 7000.0);
  EXPECT_EQ(w.rows.front().MRSP, 0.0);
  EXPECT_EQ(w.SRS_EBD.front(), 0.0);
  EXPECT_NEAR(w.rows[1].MRSP * 3.6, 160.0, 1e-9);
  // Its EBD is that of its one A_safe; it intervenes before the standard does.
  const std::size_t far = 100;  // 1000 m in rear of the stop
  EXPECT_NEAR(w.rows[far].Vc_EBD, std::sqrt(2.0 * w.inputs.A_safe.si * 1000.0), 1e-9);
  EXPECT_LE(w.rows[far].V0_EBI, w.SRS_EBI[far]);
  EXPECT_GT(w.rows[far].V0_EBI, 20.0);
  const Workbook LOA = workbook_of(approached(kSource + "/data/curves/push_pull_loa.json"));
  EXPECT_NEAR(LOA.rows.front().MRSP * 3.6, 40.0, 1e-9);
}

TEST(CommandCurves, ANoteSaysThatNoReleaseSpeedCanBeCalculated) {
  json document = passenger();
  document["target"]["release_speed_kmh"] = "on_board";
  const CurvesResult none = curves_result(Approached(*io::read_curves(document.dump(), "a")));
  EXPECT_FALSE(none.scalars.V_release_kmh);
  ASSERT_EQ(none.notes.size(), 1u);
  EXPECT_EQ(none.notes[0].rfind("no release speed can be calculated on board", 0), 0u);
  document["target"]["svl_location_m"] = 7400;
  document["target"]["reference_m"] = 6800;  // the trip location lies 10 m and 10 % of the way from it beyond the EOA
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
  // The SvL's limits move by 100 m, the EOA's stay.
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

TEST(CommandCurves, ExplainsWhatItComputed) {
  const Approached a = approached(kSource + "/data/curves/passenger_eoa.json");
  const std::string text = explain_text(a, 140);
  const SpeedRow row = speed_row(a, 140);
  for (const char* expected : {"V_bec", "D_bec", "T_traction", "T_indication", "d_EBI", "d_SBI1", "d_SBI2", "d_W",
                               "d_P", "d_I", "3.13.9.3.2.10", "3.13.9.3.6.1", "A_safe", "A_expected"})
    EXPECT_NE(text.find(expected), std::string::npos) << expected;
  for (const Value& v : {row.EBD, row.EBI, row.FLOI, row.W, row.P, row.I})
    EXPECT_NE(text.find(fixed(v, 3) + " m before"), std::string::npos) << *v;
}

/// The clause that stands at the end of the first step of a symbol.
std::string clause_of(const std::string& text, const std::string& symbol) {
  const std::size_t line = text.find("\n   " + symbol + " ");
  if (line == std::string::npos) return "no " + symbol;
  const std::size_t from = text.find('[', line);
  return text.substr(from + 1, text.find(']', from) - from - 1);
}
TEST(CommandCurves, ExplainsByTheClauseOfEveryStep) {
  const std::string text = explain_text(approached(kSource + "/data/curves/passenger_eoa.json"), 140);
  for (const auto& [symbol, clause] : std::map<std::string, std::string>{{"A_brake_emergency", "A.3.7.2"},
                                                                         {"A_brake_safe", "3.13.6.2.1.4"},
                                                                         {"A_gradient", "3.13.4.3.2"},
                                                                         {"A_safe", "3.13.6.2.1.3"},
                                                                         {"A_brake_service", "A.3.7.2"},
                                                                         {"A_expected", "3.13.6.3.1.3"},
                                                                         {"T_be", "3.13.6.2.2.3"},
                                                                         {"T_bs", "3.13.6.3.2.4"},
                                                                         {"T_bs1", "3.13.9.3.3.3"},
                                                                         {"T_traction", "3.13.9.3.2.3"},
                                                                         {"T_berem", "3.13.9.3.2.6"},
                                                                         {"T_indication", "3.13.9.3.6.2"},
                                                                         {"V_delta0", "3.13.9.3.2.1"},
                                                                         {"A_est1", "3.13.9.3.2.8"},
                                                                         {"A_est2", "3.13.9.3.2.9"},
                                                                         {"V_bec", "3.13.9.3.2.10"},
                                                                         {"D_bec", "3.13.9.3.2.10"},
                                                                         {"d_EBD(V_bec)", "3.13.8.3.2"},
                                                                         {"d_EBI", "3.13.9.3.2.12"},
                                                                         {"d_SBI2", "3.13.9.3.3.2"},
                                                                         {"d_W", "3.13.9.3.4.1"},
                                                                         {"d_P", "3.13.9.3.5.1"},
                                                                         {"d_I", "3.13.9.3.6.1"},
                                                                         {"d_SBD(V)", "3.13.8.4.1"},
                                                                         {"d_SBI1", "3.13.9.3.3.1"},
                                                                         {"lambda_0", "A.3.7.1"},
                                                                         {"V_lim", "A.3.7.3"},
                                                                         {"AD_0", "A.3.7.4"},
                                                                         {"AD_3", "A.3.7.5"},
                                                                         {"A_ebmax", "3.13.6.2.1.8.2"},
                                                                         {"Kv_int(V)", "3.13.6.2.1.8.1"},
                                                                         {"Kr_int(L_TRAIN)", "3.13.2.3.7.12"},
                                                                         {"grad", "3.13.4.2.1"},
                                                                         {"M_rotating", "A.3.1"},
                                                                         {"L", "A.3.8.1"},
                                                                         {"T_brake_basic_eb", "A.3.8.1"},
                                                                         {"T_brake_emergency", "A.3.8.4"},
                                                                         {"T_brake_basic_sb", "A.3.9.1"},
                                                                         {"T_brake_service", "A.3.9.4"}})
    EXPECT_EQ(clause_of(text, symbol), clause) << symbol;
  // Without the service brake command, on slippery rail, towards a restriction.
  json document = passenger();
  document["national_values"]["Q_NVSBTSMPERM"] = false;
  document["state"]["slippery_rail"] = true;
  document["target"] = {{"type", "MRSP"}, {"location_m", 5000}, {"speed_kmh", 80}};
  const std::string other = explain_text(Approached(*io::read_curves(document.dump(), "a")), 20);
  EXPECT_EQ(clause_of(other, "T_bs1"), "3.13.9.3.3.5");
  EXPECT_EQ(clause_of(other, "d_EBD(V_bec)"), "3.13.8.3.1");
  EXPECT_NE(other.find("min(A_brake_safe, A_MAXREDADH) + A_gradient"), std::string::npos);
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
  EXPECT_EQ(EB, sdm::permitted_braking_distance_speed(a.input().inputs, {800.0}, 0.0, true).si * 3.6);
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

TEST(CommandCurves, ThePageOfAComparisonHoldsBothSides) {
  const Approached p = approached(kSource + "/data/curves/freight_P.json");
  const Approached g = approached(kSource + "/data/curves/freight_G.json");
  const std::string page = comparison_html(p, g);
  const std::size_t from = page.find("const D = ") + 10;
  const json data = json::parse(page.substr(from, page.find(";\n", from) - from));
  EXPECT_EQ(data["name_a"], p.input().name);
  EXPECT_EQ(data["name_b"], g.input().name);
  ASSERT_EQ(data["v"][50], 50);
  std::set<std::string> keys;
  for (const json& curve : data["curves"]) {
    keys.insert(curve["key"]);
    ASSERT_EQ(curve["a"].size(), data["v"].size());
    ASSERT_EQ(curve["b"].size(), data["v"].size());
    if (curve["key"] == "EBI") {
      EXPECT_NEAR(curve["a"][50].get<double>(), *speed_row(p, 50).EBI, 0.005);
      EXPECT_NEAR(curve["b"][50].get<double>(), *speed_row(g, 50).EBI, 0.005);
    }
  }
  EXPECT_EQ(keys, (std::set<std::string>{"EBD", "SBD", "EBI", "SBI", "W", "P", "I"}));
  EXPECT_EQ(page.find("http"), std::string::npos);  // nothing is loaded from elsewhere
}

TEST(CommandCurves, ComparesTwoInputs) {
  const Approached p = approached(kSource + "/data/curves/freight_P.json");
  const Approached g = approached(kSource + "/data/curves/freight_G.json");
  const Comparison c = compare_curves(p, g);
  const json result = json::parse(comparison_text(c, Format::json));
  EXPECT_EQ(result["schema"], "evc-curves-comparison/1");
  for (std::size_t i = 0; i < c.difference.size(); ++i) {
    EXPECT_EQ(*c.difference[i].EBI, *c.rows_b[i].EBI - *c.rows_a[i].EBI);
    if (c.difference[i].v_kmh > 0.0) {
      EXPECT_GT(*c.difference[i].EBI, 0.0);  // position G brakes later
    }
  }
  EXPECT_NE(comparison_text(c, Format::csv).find("EBI_a,EBI_b,EBI_difference"), std::string::npos);
  EXPECT_NE(comparison_text(c, Format::table).find("B - A"), std::string::npos);
  for (const SpeedRow& row : compare_curves(p, p).difference)
    for (const auto& curve : curve_columns()) EXPECT_EQ((row.*curve.value).value_or(0.0), 0.0);
}

TEST(CommandCurves, AComparisonSaysWhatDiffersAndWarnsOfOtherTargets) {
  const auto compared = [](const json& a, const json& b) {
    return compare_curves(Approached(*io::read_curves(a.dump(), "a")), Approached(*io::read_curves(b.dump(), "b")));
  };
  using Strings = std::vector<std::string>;
  const json a = passenger();
  EXPECT_EQ(compared(a, a).differ, Strings{});
  EXPECT_EQ(differ_text(compared(a, a)), "they do not differ");
  json b = a;
  b["srs"] = "4.0.0";
  b["train"]["length_m"] = 300;
  b["national_values"]["Kt_int"] = 1.0;
  b["fixed_values"]["T_driver"] = 3;
  b["state"]["V_ura_kmh"] = 2;
  b["target"]["release_speed_kmh"] = nullptr;
  EXPECT_EQ(compared(a, b).differ,
            (Strings{"SRS version", "train", "national values", "fixed values", "state", "release speed"}));
  EXPECT_EQ(compared(a, b).warnings, Strings{});
  // The same question elsewhere on the line.
  b = a;
  b["target"]["location_m"] = b["target"]["svl_location_m"] = 8000;
  b["track"]["gradient"] = {{0, 0}, {5000, -5}};
  EXPECT_EQ(compared(a, b).differ, Strings{});
  EXPECT_EQ(compared(a, b).warnings, (Strings{"the targets lie at different places: A 7000 m, B 8000 m; each one's "
                                              "distances count from its own target"}));
  b["track"]["gradient"] = {{0, 0}, {4000, -5}};
  EXPECT_EQ(compared(a, b).differ, Strings{"gradients"});
  EXPECT_EQ(compared(a, b).warnings.back(),
            "the gradients on the way to the target differ: the difference is also that of the tracks");
  // A gradient that no curve reaches is no difference; one that ends is.
  b = a;
  b["track"]["gradient"] = {{0, 3}, {100, 0}, {4000, -5}};
  EXPECT_EQ(compared(a, b).differ, Strings{});
  b["track"]["gradient"] = {{0, 0}, {4000, -5, 6500}};
  EXPECT_EQ(compared(a, b).differ, Strings{"gradients"});
  b = a;
  b["track"]["adhesion"] = {{5000, 6000}};
  b["track"]["mrsp"] = {{0, 160}, {6000, 100}};
  EXPECT_EQ(compared(a, b).differ, (Strings{"track conditions", "MRSP"}));
  b = a;
  b["target"] = {{"type", "LOA"}, {"location_m", 7000}, {"speed_kmh", 40}};
  b["target"]["release_speed_kmh"] = 30;
  const Comparison other = compared(a, b);
  EXPECT_EQ(other.warnings,
            (Strings{"the targets differ: A an end of authority with the SvL at its place, B a limit of "
                     "authority at 40 km/h; each one's distances count from its own target"}));
  // In every form of the output.
  const json shown = json::parse(comparison_text(other, Format::json));
  EXPECT_EQ(shown["warnings"][0], other.warnings[0]);
  EXPECT_EQ(shown["differ"], json(other.differ));
  EXPECT_NE(comparison_text(other, Format::table).find("warning: the targets differ"), std::string::npos);
  EXPECT_NE(comparison_svg(other).find("Warning: the targets differ"), std::string::npos);
  const Scratch file_a("a.json", a.dump()), file_b("b.json", b.dump());
  const Ran csv = run("compare " + file_a.path() + " " + file_b.path() + " --format csv");
  EXPECT_EQ(csv.status, 0);
  EXPECT_EQ(csv.err, "warning: " + other.warnings[0] + "\n");
  EXPECT_EQ(run("compare " + file_a.path() + " " + file_b.path()).err, "");
}

TEST(CommandCurves, ChartsAreWholeAndSelfContained) {
  for (const std::string& file : shipped()) {
    SCOPED_TRACE(file);
    const Approached a = approached(file);
    const std::string svg = curves_svg(a);
    EXPECT_EQ(svg.rfind("<svg", 0), 0u);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    for (const char* drawn :
         {">EBD<", ">EBI<", ">SBI<", ">W<", ">P<", ">I<", ">MRSP<", "[km/h]", "[m]", "#BF0002", "#EA9100", "#DFDF00"})
      EXPECT_NE(svg.find(drawn), std::string::npos) << drawn;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    const std::string page = curves_html(a);
    EXPECT_EQ(page.find("/*DATA*/null"), std::string::npos);
    EXPECT_EQ(page.find("src="), std::string::npos);
    const std::size_t from = page.find("const D = ") + 10;
    const json data = json::parse(page.substr(from, page.find(";\n", from) - from));
    EXPECT_EQ(data["curves"][0]["v"].size(), data["x"].size());
    // The status of a standing train in rear of everything, and of one far too fast at the target.
    const auto state = [&](std::size_t column, bool top) {
      const json& runs = data["map"]["columns"][column];
      return data["map"]["states"][runs[top ? runs.size() - 2 : 0].get<std::size_t>()];
    };
    EXPECT_EQ(state(0, false)["status"], 0);
    EXPECT_EQ(state(300, true)["status"], 4);
    EXPECT_EQ(state(300, true)["eb"], true);
  }
  const Approached sheet = approached(kSource + "/data/curves/workbook.json");
  EXPECT_NE(workbook_svg(workbook_of(sheet), sheet).find("V0 = EBI, sheet"), std::string::npos);
}

/// Values of a curve of the interactive page at a place, km/h; NaN where there is none.
double drawn(const json& data, const std::string& key, double x) {
  for (const json& curve : data["curves"]) {
    if (curve["key"] != key) continue;
    for (std::size_t i = 0; i < data["x"].size(); ++i)
      if (data["x"][i].get<double>() >= x) return curve["v"][i].is_null() ? std::nan("") : curve["v"][i].get<double>();
  }
  return std::nan("");
}
json page_data(const Approached& a) {
  const std::string page = curves_html(a);
  const std::size_t from = page.find("const D = ") + 10;
  return json::parse(page.substr(from, page.find(";\n", from) - from));
}

TEST(CommandCurves, BeyondALimitOfAuthorityItsSpeedIsTheCeiling) {
  const json data = page_data(approached(kSource + "/data/curves/push_pull_loa.json"));
  EXPECT_EQ(drawn(data, "P", 5010), 40.0);
  EXPECT_EQ(drawn(data, "W", 5010), 44.0);
  EXPECT_EQ(drawn(data, "SBI", 5010), 45.5);
  EXPECT_EQ(drawn(data, "EBI", 5010), 47.5);
  EXPECT_GT(drawn(data, "EBI", 3000), 160.0);
}

TEST(CommandCurves, ChartsShowWhereAdhesionIsReducedAndBrakesDoNotCount) {
  json document = json::parse(text_of(kSource + "/data/curves/regional_restriction.json"));
  document["track"]["brake_inhibition"] = {{3500, 3600, "magnetic shoe"}};
  document["track"]["powerless"] = {{9000, 9100}};  // beyond the chart
  const std::string at = kSource + "/data/curves/a.json";
  const Approached gamma{*io::read_curves(document.dump(), at)};
  const json zones = page_data(gamma)["zones"];
  ASSERT_EQ(zones.size(), 2u);
  EXPECT_EQ(zones[0][0], 3000.0);
  EXPECT_EQ(zones[0][3], "reduced adhesion");
  EXPECT_EQ(zones[1][0], 3500.0);
  EXPECT_EQ(zones[1][2], 1);
  EXPECT_EQ(zones[1][3], "no magnetic shoe brake");
  EXPECT_NE(curves_svg(gamma).find(">no magnetic shoe brake<"), std::string::npos);
  // The adhesion zone counts until the rear end has left it; the conversion model knows no special brakes.
  document["track"]["adhesion"] = {{2500, 3000}};
  document["train"] = {{"length_m", 75}};
  document["state"]["slippery_rail"] = true;
  const json others = page_data(Approached{*io::read_curves(document.dump(), at)})["zones"];
  ASSERT_EQ(others.size(), 2u);
  EXPECT_EQ(others[0][1], 3075.0);
  EXPECT_EQ(others[1][3], "slippery rail");
}

TEST(CommandCurves, LongNamesAreShortenedInCharts) {
  EXPECT_EQ(shortened("abcd", 4), "abcd");
  EXPECT_EQ(shortened("abcde", 4), "abc\u2026");
  EXPECT_EQ(shortened("\u00e4\u00f6\u00fc\u00df", 4), "\u00e4\u00f6\u00fc\u00df");
  EXPECT_EQ(shortened("\u00e4\u00f6\u00fc\u00df!", 4), "\u00e4\u00f6\u00fc\u2026");
}

TEST(CommandCurves, PagesHaveTheSharedStyleAndScript) {
  const Approached p = approached(kSource + "/data/curves/freight_P.json");
  for (const std::string& page : {curves_html(p), comparison_html(p, p)}) {
    EXPECT_EQ(page.find("/* include"), std::string::npos);
    EXPECT_NE(page.find("--pasp-light:#294A6B"), std::string::npos);
    EXPECT_NE(page.find("function ticks("), std::string::npos);
    EXPECT_EQ(page.find("function ticks("), page.rfind("function ticks("));
  }
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
       {input.path(), std::string("/nowhere.json"), std::string("--plot picture.png"),
        "compare " + input.path() + " " + input.path(), std::string("--model workbook --plot a.html")}) {
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.status, 2) << arguments;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  }
  EXPECT_NE(run(input.path()).err.find("/train/length_m: found \"long\", expected a number"), std::string::npos);
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

}  // namespace
}  // namespace evc::app
