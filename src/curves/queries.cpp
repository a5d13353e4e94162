#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "curves/result.h"

// Permitted braking distances and level crossings: the queries of `evc curves` that have no curve to the target.
namespace evc::curves {
namespace {

/// Beyond every speed of a train (V_MAXTRAIN: 600 km/h), so that the distance alone decides.
constexpr Speed kHighestPBD{700.0 / kKmh};

}  // namespace

std::vector<QueryRow> PBD_rows(const Approached& a) {
  std::vector<QueryRow> rows;
  if (a.input().PBD.empty()) return rows;  // the memory alone costs more than a curve
  const auto scratch = std::make_unique<sdm::Derived>();
  sdm::Inputs in = a.input().inputs;
  in.V_top = kHighestPBD;
  for (const io::PbdQuery& q : a.input().PBD) {
    const Speed V = sdm::permitted_braking_distance_speed(in, q.D_PBD, q.G_PBDSR, !q.service_brake, *scratch);
    rows.push_back({{"D_PBD", q.D_PBD.si},
                    {"G_PBDSR", q.G_PBDSR},
                    {"Q_PBDSR", q.service_brake ? 1.0 : 0.0},
                    {"V_PBD_kmh", rounded_kmh(V)}});
  }
  return rows;
}

std::vector<QueryRow> LX_rows(const Approached& a) {
  const io::CurvesInput& c = a.input();
  if (c.LX.empty()) return {};
  sdm::Motion motion;  // of a train whose position is exactly known
  motion.A_est = c.A_est;
  motion.V_ura = c.V_ura;
  if (c.motion) motion = *c.motion;
  std::vector<QueryRow> rows;
  const auto scratch = std::make_unique<sdm::Derived>();
  for (const io::LxQuery& q : c.LX) {
    if (c.assumed.V_ura_of_041) motion.V_ura = train::f41(q.V_LX);
    const sdm::LxSubstitution lx = sdm::lx_substitution(c.inputs, a.derived(), q.D_LX, q.V_LX, motion, *scratch);
    rows.push_back({{"D_LX", q.D_LX.from_origin.si},
                    {"V_LX_kmh", rounded_kmh(q.V_LX)},
                    {"P", (q.D_LX - lx.d_P).si},
                    {"P_EOA", (q.D_LX - lx.SBD.d_P).si},
                    {"P_SvL", (q.D_LX - lx.EBD.d_P).si},
                    {"from_EOA", lx.from_SBD ? 1.0 : 0.0}});
  }
  return rows;
}

void append_queries_json(std::string& out, const char* key, const std::vector<QueryRow>& rows) {
  if (rows.empty()) return;
  out += fmt::format(",\n  \"{}\": [", key);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out += i == 0 ? "\n    {" : ",\n    {";
    for (const auto& [name, value] : rows[i])
      out += fmt::format("{}\"{}\": {}", out.back() == '{' ? "" : ", ", name, shortest(value, "null"));
    out += '}';
  }
  out += "\n  ]";
}

void append_queries_csv(std::string& out, const std::vector<QueryRow>& rows) {
  if (rows.empty()) return;
  if (!out.empty()) out += '\n';
  for (const auto& [name, value] : rows.front())
    out += (out.empty() || out.back() == '\n' ? "" : ",") + std::string(name);
  out += '\n';
  for (const QueryRow& row : rows) {
    for (const auto& [name, value] : row) out += (out.back() == '\n' ? "" : ",") + shortest(value, "");
    out += '\n';
  }
}

void append_queries_table(std::string& out, const char* title, const std::vector<QueryRow>& rows) {
  if (rows.empty()) return;
  std::vector<std::string> names;
  for (const auto& [name, value] : rows.front()) names.emplace_back(name);
  TextTable table(names);
  for (const QueryRow& row : rows) {
    std::vector<std::string> cells;
    for (const auto& [name, value] : row) cells.push_back(fixed(value, std::string(name)[0] == 'P' ? 1 : 0));
    table.add(cells);
  }
  out += fmt::format("\n{}\n{}", title, table.text());
}

}  // namespace evc::curves
