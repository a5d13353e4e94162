#include "curves/workbook.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/number.h"

namespace evc::curves {
namespace {

/// The constants of the workbook from the train, at the highest speed on the way.
io::WorkbookInputs inputs_from(const Approached& a) {
  const io::CurvesInput& c = a.input();
  io::WorkbookInputs w;
  Speed V{0.0};
  // The sheet has targets as steps of its MRSP only: a stop or a limit of authority ends it.
  const sdm::Target& t = a.target();
  const bool authority = t.kind != sdm::TargetKind::MRSP;
  for (const auto& step : c.inputs.mrsp.steps) {
    if (authority && step.from >= t.d_target) break;
    if (!w.mrsp.append(step.from.from_origin, step.value)) break;
    V = std::max(V, step.value);
  }
  if (authority) (void)w.mrsp.append(t.d_target.from_origin, t.V_target);  // the input has room for one more step
  const sdm::Explanation e = a.explain(V);
  const sdm::BuildUpLoss& l = e.EBD.loss;
  w.DT = e.times.T_traction + e.times.T_berem;
  w.DV = e.approach.V_delta0 + l.V_delta1 + l.V_delta2;
  w.DX = l.D_bec - V * w.DT;
  w.dV = sdm::dV_ebi(V, a.derived().fixed);
  w.A_safe = std::max(e.A_safe, Acceleration{0.01});
  w.length = std::max(t.d_target.from_origin, w.quantum);
  return w;
}

/// The speed that a target allows at a place: that of its limit, not below that of the target.
Speed allowed(Speed limit, Speed V_target, Speed margin) { return std::max(limit, V_target + margin); }

void beside(Workbook& w, const Approached& a) {
  const io::CurvesInput& c = a.input();
  const sdm::Derived& d = a.derived();
  for (const WorkbookRow& row : w.rows) {
    const Place x{{row.distance}};
    const Speed ceiling = c.inputs.mrsp.at(x);
    const Speed top = ceiling + sdm::dV_ebi(ceiling, d.fixed);
    Speed EBD = top;
    Speed EBI = top;
    for (const sdm::Target& t : d.targets) {
      if (t.d_target < x) continue;
      const sdm::PositionRow p = sdm::speeds_at(d, c.inputs, t, x, c.V_ura, c.A_est, {}, {}, c.assumed);
      const Speed margin = t.zero ? Speed{0.0} : sdm::dV_ebi(t.V_target, d.fixed);
      EBD = std::min(EBD, allowed(p.EBD, t.V_target, margin));
      EBI = std::min(EBI, allowed(p.EBI, t.V_target, margin));
    }
    w.SRS_EBD.push_back(EBD.si);
    w.SRS_EBI.push_back(EBI.si);
  }
}

std::string as_json(const Workbook& w) {
  std::string out = "{\n  \"schema\": \"evc-workbook-result/1\",\n  \"units\": \"m, m/s, m/s2, s\",\n  \"columns\": [";
  for (std::size_t k = 0; k < kWorkbookColumns; ++k)
    out += fmt::format("{}\"{}\"", k == 0 ? "" : ", ", kWorkbookColumnNames[k]);
  out += "],\n  \"rows\": [";
  for (std::size_t i = 0; i < w.rows.size(); ++i) {
    out += i == 0 ? "\n    [" : ",\n    [";
    for (std::size_t k = 0; k < kWorkbookColumns; ++k)
      out += (k == 0 ? "" : ", ") + shortest(column(w.rows[i], k), "null");
    out += ']';
  }
  out += "\n  ],\n  \"srs_columns\": [\"distance\", \"EBD\", \"EBI\"],\n  \"srs_rows\": [";
  for (std::size_t i = 0; i < w.rows.size(); ++i)
    out += fmt::format("{}    [{}, {}, {}]", i == 0 ? "\n" : ",\n", shortest(w.rows[i].distance, "null"),
                       shortest(w.SRS_EBD[i], "null"), shortest(w.SRS_EBI[i], "null"));
  return out + "\n  ]\n}\n";
}

std::string as_csv(const Workbook& w) {
  std::string out;
  for (std::size_t k = 0; k < kWorkbookColumns; ++k) out += std::string(k == 0 ? "" : ",") + kWorkbookColumnNames[k];
  out += ",SRS_EBD,SRS_EBI\n";
  for (std::size_t i = 0; i < w.rows.size(); ++i) {
    for (std::size_t k = 0; k < kWorkbookColumns; ++k) out += (k == 0 ? "" : ",") + shortest(column(w.rows[i], k), "");
    out += "," + shortest(w.SRS_EBD[i], "") + "," + shortest(w.SRS_EBI[i], "") + "\n";
  }
  return out;
}

std::string as_table(const Workbook& w) {
  std::vector<std::string> names(kWorkbookColumnNames, kWorkbookColumnNames + kWorkbookColumns);
  names.insert(names.end(), {"SRS_EBD", "SRS_EBI"});
  TextTable table(names);
  for (std::size_t i = 0; i < w.rows.size(); ++i) {
    std::vector<std::string> cells;
    for (std::size_t k = 0; k < kWorkbookColumns; ++k)
      cells.push_back(fmt::format("{:.6g}", column(w.rows[i], k) + 0.0));
    cells.push_back(fmt::format("{:.6g}", w.SRS_EBD[i]));
    cells.push_back(fmt::format("{:.6g}", w.SRS_EBI[i]));
    table.add(cells);
  }
  return table.text();
}

}  // namespace

Workbook workbook_of(const Approached& a) {
  Workbook w;
  w.name = a.input().name;
  w.inputs = a.input().workbook ? *a.input().workbook : inputs_from(a);
  // A grid of readable size: the quantum is larger for a long line.
  while (workbook_rows(w.inputs) > 10000) w.inputs.quantum = 2.0 * w.inputs.quantum;
  for (std::size_t i = 0; i < workbook_rows(w.inputs); ++i) {
    const WorkbookRow* before = w.rows.empty() ? nullptr : &w.rows.back();
    w.rows.push_back(workbook_row(w.inputs, i, before));
  }
  beside(w, a);
  return w;
}

ResultTable table_of(const Workbook& w) {
  ResultTable table{"workbook", "workbook", {}, {}};
  // m, m/s, m/s2, s as in the sheet; b is a speed, c and D are squares.
  constexpr const char* kUnits[kWorkbookColumns] = {"m",   "m",   "m/s",   "m/s",   "m/s2", "m/s", "",
                                                    "m/s", "m/s", "m/s",   "m",     "",     "s",   "m",
                                                    "m/s", "m/s", "m2/s2", "m2/s2", "m/s",  "m/s"};
  for (std::size_t k = 0; k < kWorkbookColumns; ++k) table.columns.push_back({kWorkbookColumnNames[k], kUnits[k]});
  table.columns.push_back({"SRS_EBD", "m/s"});
  table.columns.push_back({"SRS_EBI", "m/s"});
  for (std::size_t i = 0; i < w.rows.size(); ++i) {
    std::vector<Cell> cells;
    for (std::size_t k = 0; k < kWorkbookColumns; ++k) cells.emplace_back(Value(column(w.rows[i], k)));
    cells.emplace_back(Value(w.SRS_EBD[i]));
    cells.emplace_back(Value(w.SRS_EBI[i]));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string workbook_text(const Workbook& workbook, Format format) {
  if (format == Format::csv) return as_csv(workbook);
  return format == Format::table ? as_table(workbook) : as_json(workbook);
}

}  // namespace evc::curves
