#include "curves/workbook_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/test_paths.h"
#include "sdm/test_cases.h"

namespace {

using namespace evc;
using sdm::test::Dice;

nlohmann::json sheet() {
  std::ifstream file(evc::test::source_folder() + "/tests/reference/workbook_example.json");
  return nlohmann::json::parse(file).at("case");
}

io::WorkbookInputs inputs_of(const nlohmann::json& s) {
  const auto& p = s.at("params");
  io::WorkbookInputs in;
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

TEST(WorkbookModel, EveryColumnOfTheSheet) {
  const auto s = sheet();
  const auto in = inputs_of(s);
  const auto& rows = s.at("rows");
  ASSERT_EQ(rows.size(), curves::workbook_rows(in));
  for (std::size_t k = 0; k < curves::kWorkbookColumns; ++k)
    EXPECT_EQ(s.at("columns")[k].get<std::string>(), curves::kWorkbookColumnNames[k]);
  curves::WorkbookRow row{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const curves::WorkbookRow before = row;
    row = curves::workbook_row(in, i, i == 0 ? nullptr : &before);
    for (std::size_t k = 0; k < curves::kWorkbookColumns; ++k)
      EXPECT_NEAR(curves::column(row, k), rows[i][k].get<double>(), 1e-9)
          << "row " << i << " " << curves::kWorkbookColumnNames[k];
  }
}

TEST(WorkbookModel, TheExampleOfTheSheet) {
  // From 20 m/s on (0, 26)(510, 17)(660, 11): the EBI is met 330 m along the line.
  const auto in = inputs_of(sheet());
  curves::WorkbookRow row{};
  double met_at = -1.0;
  for (std::size_t i = 0; i < curves::workbook_rows(in); ++i) {
    const curves::WorkbookRow before = row;
    row = curves::workbook_row(in, i, i == 0 ? nullptr : &before);
    if (met_at < 0.0 && row.V0_EBI >= 20.0) met_at = row.position;
  }
  EXPECT_EQ(in.length.si - met_at, 330.0);
}

/// The formulas of the sheet with its column letters: a cell from the row above it.
struct SheetRow {
  double A, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T;
};
std::vector<SheetRow> sheet_of(const io::WorkbookInputs& in) {
  std::vector<SheetRow> rows;
  for (double position = 0.0; position <= in.length.si; position += in.quantum.si) {
    const SheetRow* up = rows.empty() ? nullptr : &rows.back();
    const bool first_two = rows.size() < 2;
    SheetRow r{};
    r.B = position;
    r.A = in.length.si - r.B;
    for (const auto& step : in.mrsp.steps)
      if (&step == in.mrsp.steps.begin() || step.from.si <= r.A) r.F = step.value.si;
    r.E = in.A_safe.si;
    r.G = up == nullptr && in.danger_point_in_first_row ? 1.0 : 0.0;
    r.H = in.dV.si;
    r.I = r.F + r.H;
    r.C = r.D = r.J = r.F;
    if (up != nullptr) {
      r.C = std::min(std::sqrt(up->C * up->C + 2 * in.quantum.si * up->E), r.I);
      r.D = up->S < up->I ? std::sqrt(up->D * up->D + 2 * in.quantum.si * up->E) : up->I;
      r.J = r.F > up->F ? up->F : up->J;
      if (!first_two) r.K = r.F > up->F ? r.B : up->K;
    }
    r.L = r.C < r.I ? 1.0 : 0.0;
    r.M = in.DT.si;
    r.N = in.DX.si;
    r.O = in.DV.si;
    r.P = 2 * (r.O + r.E * r.M);
    r.Q = r.O * r.O + 2 * r.E * (first_two ? r.N + r.B - r.K : r.N - r.B + r.K) - r.J * r.J;
    r.R = std::max(r.P * r.P - 4 * r.Q, 0.0);
    double body = std::sqrt(r.R) / 2 - r.O - r.E * r.M;
    if (up != nullptr) body = std::max(body, up->S);
    // (G = 1) ^ (F <> 0), with 0 ^ 0 as 1.
    r.S = first_two && std::pow(r.G == 1.0, r.F != 0.0) == 1.0 ? r.I : std::min(body, r.I);
    r.T = r.S + r.O;
    rows.push_back(r);
  }
  return rows;
}

TEST(WorkbookModel, AnySheetCellByCell) {
  Dice dice(3);
  for (int i = 0; i < 400; ++i) {
    io::WorkbookInputs in;
    in.quantum = {2.5 * dice.integer(1, 4)};
    in.length = {in.quantum.si * dice.integer(1, 60)};
    in.DT = {0.5 * dice.integer(0, 12)};
    in.DX = {dice.chance(0.2) ? 200.0 : 0.5 * dice.integer(0, 20)};
    in.DV = {0.25 * dice.integer(0, 8)};
    in.dV = {0.5 * dice.integer(0, 6)};
    in.A_safe = {0.125 * dice.integer(1, 12)};
    in.danger_point_in_first_row = dice.chance(0.5);
    double from = 0.0;
    for (int n = dice.integer(1, 6); n > 0; --n) {
      ASSERT_TRUE(in.mrsp.append({from}, {1.0 * dice.integer(0, dice.chance(0.3) ? 2 : 40)}));
      from += in.quantum.si * dice.integer(1, 20);
    }
    if (i % 4 == 0) {
      // Speed 0 from the third row on, a low speed in the first two: the rule of these two applies only to them.
      in.mrsp = {};
      ASSERT_TRUE(in.mrsp.append({0.0}, {0.0}));
      ASSERT_TRUE(in.mrsp.append(in.length - in.quantum, {1.0 * dice.integer(1, 3)}));
      in.DX = {100.0 * dice.integer(0, 2)};
    }
    const std::vector<SheetRow> rows = sheet_of(in);
    ASSERT_EQ(curves::workbook_rows(in), rows.size());
    curves::WorkbookRow row{};
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const curves::WorkbookRow before = row;
      row = curves::workbook_row(in, k, k == 0 ? nullptr : &before);
      const SheetRow& r = rows[k];
      const double cells[] = {r.A, r.B, r.C, r.D, r.E, r.F, r.G, r.H, r.I, r.J,
                              r.K, r.L, r.M, r.N, r.O, r.P, r.Q, r.R, r.S, r.T};
      static_assert(std::size(cells) == curves::kWorkbookColumns);
      for (std::size_t c = 0; c < curves::kWorkbookColumns; ++c)
        ASSERT_NEAR(curves::column(row, c), cells[c], 1e-9)
            << "sheet " << i << " row " << k << " " << curves::kWorkbookColumnNames[c];
    }
  }
  // Distances that are multiples of the quantum in decimals only.
  io::WorkbookInputs in;
  in.quantum = {0.1};
  in.length = {0.3};
  EXPECT_EQ(curves::workbook_rows(in), 4u);
}

TEST(WorkbookModel, ASheetThatSaysNothingIsTheWorkbooks) {
  const io::WorkbookInputs w;
  EXPECT_EQ(w.quantum, 10_m);
  EXPECT_EQ(w.length, 700_m);
  EXPECT_EQ(w.DT, 5_s);
  EXPECT_EQ(w.DX, 5_m);
  EXPECT_EQ(w.DV.si, 1.0);
  EXPECT_EQ(w.dV.si, 1.0);
  EXPECT_EQ(w.A_safe.si, 1.2);
  EXPECT_TRUE(w.danger_point_in_first_row);
}

}  // namespace
