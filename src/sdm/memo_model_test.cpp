#include "sdm/memo_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sdm/test_cases.h"

namespace {

using namespace evc;
using sdm::test::Dice;

nlohmann::json sheet() {
  std::ifstream file(EVC_SOURCE_DIR "/tests/reference/workbook_example.json");
  return nlohmann::json::parse(file).at("case");
}

sdm::WorkbookInputs inputs_of(const nlohmann::json& s) {
  const auto& p = s.at("params");
  sdm::WorkbookInputs in;
  in.quantum = {p.at("quantum")};
  in.length = {p.at("track_length")};
  in.DT = {p.at("DT")};
  in.DX = {p.at("DX")};
  in.DV = {p.at("DV")};
  in.dV = {p.at("dV")};
  in.A_safe = {p.at("Asafe")};
  for (const auto& step : s.at("mrsp_steps_by_distance")) EXPECT_TRUE(in.mrsp.append({step[0]}, {step[1]}));
  return in;
}

TEST(MemoModel, EveryColumnOfTheSheet) {
  const auto s = sheet();
  const auto in = inputs_of(s);
  const auto& rows = s.at("rows");
  ASSERT_EQ(rows.size(), sdm::workbook_rows(in));
  for (std::size_t k = 0; k < sdm::kWorkbookColumns; ++k)
    EXPECT_EQ(s.at("columns")[k].get<std::string>(), sdm::kWorkbookColumnNames[k]);
  sdm::WorkbookRow row{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const sdm::WorkbookRow before = row;
    row = sdm::workbook_row(in, i, i == 0 ? nullptr : &before);
    for (std::size_t k = 0; k < sdm::kWorkbookColumns; ++k)
      EXPECT_NEAR(sdm::column(row, k), rows[i][k].get<double>(), 1e-9)
          << "row " << i << " " << sdm::kWorkbookColumnNames[k];
  }
}

TEST(MemoModel, TheMemosTestExample) {
  // From 20 m/s on (0, 26)(510, 17)(660, 11): the EBI is met 330 m along the line.
  const auto in = inputs_of(sheet());
  sdm::WorkbookRow row{};
  double met_at = -1.0;
  for (std::size_t i = 0; i < sdm::workbook_rows(in); ++i) {
    const sdm::WorkbookRow before = row;
    row = sdm::workbook_row(in, i, i == 0 ? nullptr : &before);
    if (met_at < 0.0 && row.V0_EBI >= 20.0) met_at = row.position;
  }
  EXPECT_EQ(in.length.si - met_at, 330.0);
}

TEST(MemoModel, HandComputedLoss) {
  const auto loss = sdm::memo_loss({1.0}, {1.0}, {0.4}, {0.3});
  EXPECT_DOUBLE_EQ(loss.DT.si, 2.0);
  EXPECT_DOUBLE_EQ(loss.DV.si, 0.7);
  EXPECT_DOUBLE_EQ(loss.DX.si, 0.35 + 0.4);  // the cross term is 0.4 m
}

TEST(MemoModel, HandComputedEquation) {
  // A_safe 1, DT 2, DX 1, DV 1; target at 100 m with 0; train at 40 m: V0^2 + 6 V0 - 117 = 0.
  const auto s = sdm::memo_V0({{40.0}}, {{{100.0}}, {0.0}}, {1.0}, {{2.0}, {1.0}, {1.0}});
  EXPECT_DOUBLE_EQ(s.b.si, 6.0);
  EXPECT_DOUBLE_EQ(s.c.si, -117.0);
  EXPECT_DOUBLE_EQ(s.D.si, 504.0);
  EXPECT_DOUBLE_EQ(s.V0.si, std::sqrt(504.0) / 2.0 - 3.0);
}

TEST(MemoModel, BeyondTheTargetNothingIsAllowed) {
  const auto s = sdm::memo_V0({{200.0}}, {{{100.0}}, {0.0}}, {1.0}, {{2.0}, {1.0}, {1.0}});
  EXPECT_EQ(s.V0.si, 0.0);
  EXPECT_EQ(sdm::memo_Vc({{200.0}}, {{{100.0}}, {0.0}}, {1.0}).si, 0.0);
}

TEST(MemoModel, WithoutDelayTheLimitIsTheCurve) {
  Dice dice(1);
  for (int i = 0; i < 10000; ++i) {
    const sdm::MemoTarget target{{{dice.real(0.0, 5000.0)}}, {dice.real(0.0, 40.0)}};
    const Acceleration A_safe{dice.real(0.1, 1.5)};
    const Place X0 = target.X1 - Distance{dice.real(0.0, 4000.0)};
    const auto loss = sdm::memo_loss({0.0}, {0.0}, {dice.real(0.0, 1.0)}, {dice.real(0.0, 0.4)});
    EXPECT_NEAR(sdm::memo_V0(X0, target, A_safe, loss).V0.si, sdm::memo_Vc(X0, target, A_safe).si, 1e-12);
  }
}

TEST(MemoModel, ResidualAndRoundTrip) {
  Dice dice(2);
  for (int i = 0; i < 10000; ++i) {
    const sdm::MemoTarget target{{{dice.real(0.0, 5000.0)}}, {dice.real(0.0, 40.0)}};
    const Acceleration A_safe{dice.real(0.1, 1.5)};
    const auto loss =
        sdm::memo_loss({dice.real(0.0, 5.0)}, {dice.real(0.0, 10.0)}, {dice.real(0.0, 1.0)}, {dice.real(0.0, 0.4)});
    const Speed V0{target.V1.si + dice.real(0.0, 40.0)};
    const Place X0 = sdm::memo_X0(V0, target, A_safe, loss);
    const Speed again = sdm::memo_V0(X0, target, A_safe, loss).V0;
    EXPECT_NEAR(again.si, V0.si, 1e-10);
    const Speed V_bec = again + loss.DV;
    const SpeedSquared there = target.V1 * target.V1 + 2.0 * A_safe * ((target.X1 - X0) - loss.DX - again * loss.DT);
    EXPECT_NEAR((V_bec * V_bec).si, there.si, 1e-9 * (1.0 + there.si));
  }
}

}  // namespace
