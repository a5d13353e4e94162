#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "curves/compare.h"
#include "curves/curves_test.h"
#include "curves/drawing.h"
#include "curves/plot.h"
#include "curves/workbook.h"

namespace evc::curves {
namespace {

using nlohmann::json;

TEST(CurvesCharts, EveryWorkbookColumnThroughTheCommand) {
  const json sheet = load_json(kSource + "/tests/reference/workbook_example.json")["case"];
  const Ended ran = run("--model workbook");
  ASSERT_EQ(ran.exit_code, 0) << ran.errors;
  const json result = json::parse(ran.output);
  EXPECT_EQ(result["columns"], sheet["columns"]);
  ASSERT_EQ(result["rows"].size(), sheet["rows"].size());
  for (std::size_t i = 0; i < sheet["rows"].size(); ++i)
    for (std::size_t k = 0; k < sheet["columns"].size(); ++k)
      EXPECT_NEAR(result["rows"][i][k].get<double>(), sheet["rows"][i][k].get<double>(), 1e-9);
  // The EBD of the sheet is that of the standard; its EBI is never above it (seed_excel_model: anchor and hold).
  for (std::size_t i = 1; i < sheet["rows"].size(); ++i) {
    EXPECT_NEAR(result["srs_rows"][i][1].get<double>(), sheet["rows"][i][2].get<double>(), 1e-6);
    EXPECT_LE(sheet["rows"][i][18].get<double>(), result["srs_rows"][i][2].get<double>() + 1e-6);
  }
}

TEST(CurvesCharts, TheWorkbookModelStopsAtAnEndOfAuthority) {
  const Approached a = approached(kSource + "/data/curves/passenger_eoa.json");
  const Workbook w = workbook_of(a);
  EXPECT_EQ(w.rows.front().distance, 7000.0);
  EXPECT_EQ(w.rows.front().MRSP, 0.0);
  EXPECT_EQ(w.SRS_EBD.front(), 0.0);
  EXPECT_NEAR(w.rows[1].MRSP * 3.6, 160.0, 1e-9);
  // Its EBD uses one A_safe; it intervenes before the standard does.
  const std::size_t far = 100;  // 1000 m in rear of the stop
  EXPECT_NEAR(w.rows[far].Vc_EBD, std::sqrt(2.0 * w.inputs.A_safe.si * 1000.0), 1e-9);
  EXPECT_LE(w.rows[far].V0_EBI, w.SRS_EBI[far]);
  EXPECT_GT(w.rows[far].V0_EBI, 20.0);
  const Workbook LOA = workbook_of(approached(kSource + "/data/curves/push_pull_loa.json"));
  EXPECT_NEAR(LOA.rows.front().MRSP * 3.6, 40.0, 1e-9);
}

TEST(CurvesCharts, ThePageOfAComparisonHoldsBothSides) {
  const Approached p = approached(kSource + "/data/curves/freight_P.json");
  const Approached g = approached(kSource + "/data/curves/freight_G.json");
  const std::string page = comparison_html(p, {&g, 1});
  const std::size_t from = page.find("const ALL = ") + 12;
  const json all = json::parse(page.substr(from, page.find(", chosen = ", from) - from));
  ASSERT_EQ(all["others"].size(), 1u);
  const json &a = all["a"], &b = all["others"][0];
  EXPECT_EQ(a["name"], p.input().name);
  EXPECT_EQ(b["name"], g.input().name);
  EXPECT_EQ(all["step"], 1);
  for (const json* side : {&a, &b}) {
    std::set<std::string> keys;
    for (const auto& [key, rows] : (*side)["curves"].items()) {
      keys.insert(key);
      EXPECT_EQ(rows.size(), b["rows"]) << key;
    }
    EXPECT_EQ(keys, (std::set<std::string>{"EBD", "SBD", "EBI", "SBI", "W", "P", "I"}));
  }
  EXPECT_NEAR(a["curves"]["EBI"][50].get<double>(), *speed_row(p, 50).EBI, 0.005);
  EXPECT_NEAR(b["curves"]["EBI"][50].get<double>(), *speed_row(g, 50).EBI, 0.005);
  EXPECT_NEAR(b["scalars"]["T_be_s"].get<double>(), *scalars_of(g).T_be_s, 0.005);
  EXPECT_EQ(page.find("http"), std::string::npos);  // nothing is loaded from other files
}

TEST(CurvesCharts, ComparesTwoInputs) {
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

TEST(CurvesCharts, AComparisonSaysWhatDiffersAndWarnsOfOtherTargets) {
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
  // The same query at another place of the line.
  b = a;
  b["target"]["location_m"] = b["target"]["svl_location_m"] = 8000;
  b["track"]["gradient"] = {{0, 0}, {5000, -5}};
  EXPECT_EQ(compared(a, b).differ, Strings{});
  EXPECT_EQ(compared(a, b).warnings, (Strings{"the targets are at different places: A 7000 m, B 8000 m; the distances "
                                              "of each are from its own target"}));
  b["track"]["gradient"] = {{0, 0}, {4000, -5}};
  EXPECT_EQ(compared(a, b).differ, Strings{"gradients"});
  EXPECT_EQ(compared(a, b).warnings.back(),
            "the gradients on the way to the target differ: the tracks contribute to the difference");
  // A gradient beyond the curves makes no difference; a gradient that ends does.
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
                     "authority at 40 km/h; the distances of each are from its own target"}));
  // In every format of the output.
  const json shown = json::parse(comparison_text(other, Format::json));
  EXPECT_EQ(shown["warnings"][0], other.warnings[0]);
  EXPECT_EQ(shown["differ"], json(other.differ));
  EXPECT_NE(comparison_text(other, Format::table).find("warning: the targets differ"), std::string::npos);
  EXPECT_NE(svg_of(comparison_drawing({other}, Theme::screen)).find("Warning: the targets differ"), std::string::npos);
  const Scratch file_a("a.json", a.dump()), file_b("b.json", b.dump());
  const Ended csv = run("compare " + file_a.path() + " " + file_b.path() + " --format csv");
  EXPECT_EQ(csv.exit_code, 0);
  EXPECT_EQ(csv.errors, "warning: " + other.warnings[0] + "\n");
  EXPECT_EQ(run("compare " + file_a.path() + " " + file_b.path()).errors, "");
}

TEST(CurvesCharts, ChartsAreWholeAndSelfContained) {
  for (const std::string& file : shipped()) {
    SCOPED_TRACE(file);
    const Approached a = approached(file);
    const std::string svg = svg_of(curves_drawing(a, Theme::screen));
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
    // The status of a train at standstill in rear of all limits, and of one far too fast at the
    // target.
    const auto state = [&](std::size_t column, bool top) {
      const json& runs = data["map"]["columns"][column];
      return data["map"]["states"][runs[top ? runs.size() - 2 : 0].get<std::size_t>()];
    };
    EXPECT_EQ(state(0, false)["status"], 1);
    EXPECT_EQ(state(300, true)["status"], 5);
    EXPECT_EQ(state(300, true)["eb"], true);
  }
  const Approached sheet = approached(kSource + "/data/curves/workbook.json");
  EXPECT_NE(svg_of(workbook_drawing(workbook_of(sheet), sheet, Theme::screen)).find("V0 = EBI, sheet"),
            std::string::npos);
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

TEST(CurvesCharts, BeyondALimitOfAuthorityItsSpeedIsTheCeiling) {
  const json data = page_data(approached(kSource + "/data/curves/push_pull_loa.json"));
  EXPECT_EQ(drawn(data, "P", 5010), 40.0);
  EXPECT_EQ(drawn(data, "W", 5010), 44.0);
  EXPECT_EQ(drawn(data, "SBI", 5010), 45.5);
  EXPECT_EQ(drawn(data, "EBI", 5010), 47.5);
  EXPECT_GT(drawn(data, "EBI", 3000), 160.0);
}

TEST(CurvesCharts, ChartsShowWhereAdhesionIsReducedAndBrakesDoNotCount) {
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
  EXPECT_NE(svg_of(curves_drawing(gamma, Theme::screen)).find(">no magnetic shoe brake<"), std::string::npos);
  // The adhesion zone counts until the rear end has left it; the conversion model has no special brakes.
  document["track"]["adhesion"] = {{2500, 3000}};
  document["train"] = {{"length_m", 75}};
  document["state"]["slippery_rail"] = true;
  const json others = page_data(Approached{*io::read_curves(document.dump(), at)})["zones"];
  ASSERT_EQ(others.size(), 2u);
  EXPECT_EQ(others[0][1], 3075.0);
  EXPECT_EQ(others[1][3], "slippery rail");
}

TEST(CurvesCharts, LongNamesAreShortenedInCharts) {
  EXPECT_EQ(shortened("abcd", 4), "abcd");
  EXPECT_EQ(shortened("abcde", 4), "abc\u2026");
  EXPECT_EQ(shortened("\u00e4\u00f6\u00fc\u00df", 4), "\u00e4\u00f6\u00fc\u00df");
  EXPECT_EQ(shortened("\u00e4\u00f6\u00fc\u00df!", 4), "\u00e4\u00f6\u00fc\u2026");
}

// A once, with as many rows as the longest of the others has.
TEST(CurvesCharts, ThePageOfAComparisonHoldsAOnce) {
  const Approached p = approached(kSource + "/data/curves/freight_P.json");
  std::vector<Approached> others;
  for (const char* name : {"freight_G", "passenger_eoa", "freight_P"})
    others.push_back(approached(kSource + "/data/curves/" + name + ".json"));
  const std::string one = comparison_html(p, {&others[1], 1}), three = comparison_html(p, others);
  const std::size_t from = three.find("const ALL = ") + 12;
  const json all = json::parse(three.substr(from, three.find(", chosen = ", from) - from));
  ASSERT_EQ(all["others"].size(), 3u);
  std::size_t longest = 0, data = 0;
  for (const json& other : all["others"]) {
    longest = std::max(longest, other["rows"].get<std::size_t>());
    data += other.dump().size() + 1;
  }
  EXPECT_EQ(all["a"]["curves"]["EBI"].size(), longest);
  EXPECT_GT(longest, all["others"][0]["rows"].get<std::size_t>());  // the passenger train is faster
  EXPECT_EQ(three.size() - one.size(), data - (all["others"][1].dump().size() + 1));
}

TEST(CurvesCharts, PagesHaveTheSharedStyleAndScript) {
  const Approached p = approached(kSource + "/data/curves/freight_P.json");
  for (const std::string& page : {curves_html(p), comparison_html(p, {&p, 1})}) {
    EXPECT_EQ(page.find("/* include"), std::string::npos);
    EXPECT_NE(page.find("--pasp-light:#294A6B"), std::string::npos);
    EXPECT_NE(page.find("function ticks("), std::string::npos);
    EXPECT_EQ(page.find("function ticks("), page.rfind("function ticks("));
  }
}
}  // namespace
}  // namespace evc::curves
