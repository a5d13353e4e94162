#include <gtest/gtest.h>

#include <algorithm>

#include "curves/compare.h"
#include "curves/curves_test.h"
#include "curves/plot.h"
#include "curves/xlsx.h"

// Files by the end of their name: SVG, PNG, PDF, xlsx; the theme for print; more than two inputs compared.
namespace evc::curves {
namespace {

using nlohmann::json;

const std::string kPassenger = kSource + "/data/curves/passenger_eoa.json";

std::string written(const std::string& arguments, const std::string& name) {
  const Scratch file(name);
  const Ended ran = run(arguments + " " + file.path());
  EXPECT_EQ(ran.exit_code, 0) << ran.errors;
  EXPECT_EQ(ran.output, "");
  return text_of(file.path());
}

TEST(CurvesFiles, TheNameSaysTheFormat) {
  for (const std::string option : {"--plot", "-o"}) {
    EXPECT_EQ(written(kPassenger + " " + option, "a.svg").rfind("<svg", 0), 0u);
    EXPECT_EQ(written(kPassenger + " " + option, "a.html").rfind("<!DOCTYPE html>", 0), 0u);
    const std::string png = written(kPassenger + " " + option, "a.png");
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    // 1280 pixels of the drawing, two for each.
    EXPECT_EQ(png.substr(16, 4), std::string("\0\0\x0a\0", 4));
    const std::string pdf = written(kPassenger + " " + option, "a.pdf");
    EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
    EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
    EXPECT_EQ(pdf, written(kPassenger + " " + option, "a.pdf")) << "the same drawing is the same file";
  }
  EXPECT_EQ(written("--model workbook -o", "w.png").substr(1, 3), "PNG");
  EXPECT_EQ(written("compare " + kPassenger + " " + kPassenger + " -o", "c.pdf").substr(0, 5), "%PDF-");
  const Ended ran = run(kPassenger + " --plot chart.gif");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.errors, "--plot: found chart.gif, expected a file name that ends in .svg, .png, .pdf or .html\n");
  EXPECT_EQ(run(kPassenger + " --explain 100 -o e.xlsx").exit_code, 2);
}

TEST(CurvesFiles, AWorkbookHasASheetForEachTable) {
  const std::string file = written(kPassenger + " -o", "a.xlsx");
  EXPECT_EQ(file.substr(0, 4), "PK\x03\x04");
  EXPECT_EQ(file, written(kPassenger + " -o", "a.xlsx")) << "the same tables are the same file";
  json document = passenger();
  document["query"]["details"] = {"arcs", "times"};
  const CurvesResult result = curves_result(approached(document));
  const std::vector<ResultTable> tables = tables_of(result);
  std::vector<std::string> names;
  for (const ResultTable& table : tables) {
    names.push_back(table.key);
    EXPECT_FALSE(table.rows.empty()) << table.key;
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.key;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"scalars", "by_speed", "by_position", "times", "arcs"}));
  EXPECT_STREQ(tables[1].columns[1].unit, "m/s2");
  EXPECT_STREQ(tables[1].columns[5].unit, "m");
  EXPECT_EQ(std::get<Value>(tables[1].rows[10][5]), result.by_speed[10].EBD);
  const std::string bytes = xlsx_of(tables);
  for (std::size_t i = 1; i <= tables.size(); ++i)
    EXPECT_NE(bytes.find("xl/worksheets/sheet" + std::to_string(i) + ".xml"), std::string::npos);
  EXPECT_EQ(bytes.find("xl/worksheets/sheet" + std::to_string(tables.size() + 1) + ".xml"), std::string::npos);
  // Beside the tables by speed and by position.
  EXPECT_NE(bytes.find("xl/charts/chart2.xml"), std::string::npos);
  EXPECT_EQ(bytes.find("xl/charts/chart3.xml"), std::string::npos);
  ResultTable bare = tables[1];
  for (auto& row : bare.rows)
    for (std::size_t k = 1; k < row.size(); ++k) row[k] = Value();
  EXPECT_EQ(xlsx_of({bare}).find("xl/charts/"), std::string::npos) << "no curve, no chart";
}

TEST(CurvesFiles, ForPrintTheChartIsLightWithNamesAtTheCurves) {
  for (const std::string& file : shipped()) {
    SCOPED_TRACE(file);
    const Drawing drawing = curves_drawing(approached(file), Theme::print);
    const std::string svg = svg_of(drawing);
    for (const char* dark : {colour::dark_blue, colour::yellow, colour::pasp_dark, colour::EBD})
      EXPECT_EQ(svg.find(dark), std::string::npos) << dark;
    for (const char* name : {">EBD<", ">EBI<", ">P<", ">MRSP<"}) EXPECT_NE(svg.find(name), std::string::npos) << name;
    EXPECT_EQ(svg.find(">lowest under train<"), std::string::npos) << "no legend";
    for (const Element& element : drawing.elements())
      if (const auto* text = std::get_if<DrawnText>(&element)) {
        EXPECT_GE(text->x, 0.0) << text->text;
        EXPECT_LE(text->x, drawing.width()) << text->text;
      }
  }
  const std::string plain = written(kPassenger + " --theme print -o", "p.svg");
  EXPECT_EQ(plain, svg_of(curves_drawing(approached(kPassenger), Theme::print)));
}

/// Release speed monitoring replaces the EBI (3.13.9.4.6), and ends at the SvL.
TEST(CurvesFiles, InReleaseSpeedMonitoringItsSpeedIsDrawnAlone) {
  const std::string page = curves_html(approached(kPassenger));
  const std::size_t from = page.find("const D = ") + 10;
  const json data = json::parse(page.substr(from, page.find(";\n", from) - from));
  ASSERT_EQ(data["release"].size(), 3u);
  EXPECT_EQ(data["release"][2], 7000.0);
  for (const json& curve : data["curves"])
    for (std::size_t i = 0; i < data["x"].size(); ++i)
      if (data["x"][i] > data["release"][0] && (curve["key"] == "EBI" || curve["key"] == "SBI")) {
        EXPECT_TRUE(curve["v"][i].is_null()) << curve["key"] << data["x"][i];
      }
  EXPECT_NE(page.find("start of RSM"), std::string::npos);
}

TEST(CurvesFiles, MoreThanTwoInputsAreComparedWithTheFirst) {
  const std::string p = kSource + "/data/curves/freight_P.json", g = kSource + "/data/curves/freight_G.json",
                    d = kSource + "/data/curves/freight_downhill.json";
  const Ended three = run("compare " + p + " " + g + " " + d + " --format json");
  ASSERT_EQ(three.exit_code, 0) << three.errors;
  const json all = json::parse(three.output);
  EXPECT_EQ(all["schema"], "evc-curves-comparisons/1");
  ASSERT_EQ(all["comparisons"].size(), 2u);
  json two = json::parse(run("compare " + p + " " + g + " --format json").output);
  EXPECT_EQ(two["schema"], "evc-curves-comparison/1");
  two.erase("schema");
  EXPECT_EQ(all["comparisons"][0]["differ"], two["differ"]);
  EXPECT_EQ(all["comparisons"][0]["scalars"], two["scalars"]);
  EXPECT_EQ(all["comparisons"][1]["a"], two["a"]);
  EXPECT_NE(all["comparisons"][1]["warnings"][0].get<std::string>().find(", C an end of authority"), std::string::npos);
  const std::string csv = run("compare " + p + " " + g + " " + d + " --format csv").output;
  EXPECT_NE(csv.find("EBI_a,EBI_b,EBI_b_difference,EBI_c,EBI_c_difference"), std::string::npos);
  const std::string table = run("compare " + p + " " + g + " " + d).output;
  EXPECT_NE(table.find("C - A in metres before the target"), std::string::npos);
  const std::string svg = written("compare " + p + " " + g + " " + d + " 2>/dev/null -o", "three.svg");
  EXPECT_NE(svg.find("stroke-dasharray=\"2 3\""), std::string::npos);
  // The page has each of them with A; one is chosen there.
  const std::string page = written("compare " + p + " " + g + " " + d + " 2>/dev/null -o", "three.html");
  const std::size_t from = page.find("const ALL = ") + 12;
  const json shown = json::parse(page.substr(from, page.find(", chosen = ", from) - from));
  ASSERT_EQ(shown["others"].size(), 2u);
  EXPECT_EQ(shown["a"]["name"], all["comparisons"][1]["a"]);
  EXPECT_EQ(shown["others"][1]["name"], all["comparisons"][1]["b"]);
}

TEST(CurvesFiles, LongTitlesAreWrapped) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(wrapped("one two three", 7, 3), (Lines{"one two", "three"}));
  EXPECT_EQ(wrapped("one", 7, 3), Lines{"one"});
  EXPECT_EQ(wrapped("\u00e4\u00f6\u00fc\u00df", 2, 3), (Lines{"\u00e4\u00f6", "\u00fc\u00df"}));
  EXPECT_EQ(wrapped("one two three four", 7, 2), (Lines{"one two", "three \u2026"}));
}

}  // namespace
}  // namespace evc::curves
