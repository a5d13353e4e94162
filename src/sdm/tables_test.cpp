// The tables of 3.13.10 equal the reference facts, row by row.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "sdm/tables.h"

namespace {

using namespace evc::sdm;
using nlohmann::json;

const json& reference() {
  static const json all = [] {
    std::ifstream file(EVC_SOURCE_DIR "/tests/reference/sdm_tables.json");
    return json::parse(file);
  }();
  return all;
}

std::string text(Bound b) {
  static const std::map<Bound, std::string> names = {
      {Bound::Vt, "Vt"}, {Bound::Vt_w, "Vt+dVw(Vt)"}, {Bound::Vt_sbi, "Vt+dVsbi(Vt)"}, {Bound::Vt_ebi, "Vt+dVebi(Vt)"},
      {Bound::M, "M"},   {Bound::M_w, "M+dVw(M)"},    {Bound::M_sbi, "M+dVsbi(M)"},    {Bound::M_ebi, "M+dVebi(M)"},
  };
  return names.at(b);
}
std::string speed(const TriggerRow& r) {
  if (r.equal) return "V=" + text(r.above);
  if (r.above == Bound::none) return "V<=" + text(r.upto);
  if (r.upto == Bound::none) return "V>" + text(r.above);
  return text(r.above) + "<V<=" + text(r.upto);
}
std::string speed(const RevocationRow& r) {
  if (r.standstill) return "standstill";
  if (r.above == Bound::none) return "V<=" + text(r.upto);
  return text(r.above) + "<V<=" + text(r.upto);
}
std::string command(Command c) {
  switch (c) {
    case Command::none:
      return "";
    case Command::TCO:
      return "TCO";
    case Command::SB:
      return "SB";
    case Command::EB:
      return "EB";
  }
  return "?";
}
std::string status(Status s) {
  static const std::map<Status, std::string> names = {{Status::Normal, "NoS"},
                                                      {Status::Indication, "IndS"},
                                                      {Status::Overspeed, "OvS"},
                                                      {Status::Warning, "WaS"},
                                                      {Status::Intervention, "IntS"}};
  return names.at(s);
}

/// The limits of a location text, as "d>X" and "d<=X": which are beyond, which not.
struct Location {
  std::set<std::string> beyond, not_beyond;
  friend bool operator==(const Location&, const Location&) = default;
};
Location parse_MRSP(std::string t) {
  Location l;
  // "dI(M)<d<=dW(V)"
  std::smatch m;
  if (std::regex_match(t, m, std::regex(R"((d\w+\([VM]\))<d<=(d\w+\([VM]\)))"))) return {{m[1].str()}, {m[2].str()}};
  if (std::regex_match(t, m, std::regex(R"(d>(d\w+\([VM]\)))"))) l.beyond.insert(m[1].str());
  if (std::regex_match(t, m, std::regex(R"(d<=(d\w+\([VM]\)))"))) l.not_beyond.insert(m[1].str());
  return l;
}
/// "(S:d>dI(M) OR E:d>dI(M)) AND S:d<=dEBI(V)": what S and E say is one limit; SBI1, SBI2 are SBI.
Location parse_EOA(const std::string& t) {
  Location l;
  static const std::regex part(R"(([SE]):d(>|<=)(d[A-Za-z]+)[12]?(\([VM]\)))");
  for (auto i = std::sregex_iterator(t.begin(), t.end(), part); i != std::sregex_iterator(); ++i) {
    const std::string limit = (*i)[3].str() + (*i)[4].str();
    ((*i)[2] == ">" ? l.beyond : l.not_beyond).insert(limit);
  }
  return l;
}
std::string limit(Limit l) {
  switch (l) {
    case Limit::none:
      return "";
    case Limit::I:
      return "dI(V)";
    case Limit::P:
      return "dP(V)";
    case Limit::W:
      return "dW(V)";
    case Limit::SBI:
      return "dSBI(V)";
    case Limit::EBI:
      return "dEBI(V)";
    case Limit::I_M:
      return "dI(M)";
  }
  return "?";
}
Location location(Limit beyond, Limit not_beyond) {
  Location l;
  if (beyond != Limit::none) l.beyond.insert(limit(beyond));
  if (not_beyond != Limit::none) l.not_beyond.insert(limit(not_beyond));
  return l;
}
std::string without_star(std::string s) {
  if (!s.empty() && s.back() == '*') s.pop_back();
  return s;
}
std::string SBI2_is_SBI(std::string s) { return std::regex_replace(s, std::regex("dSBI[12]"), "dSBI"); }
std::string with_Vt(std::string s) { return std::regex_replace(s, std::regex("Vr"), "Vt"); }

void expect_rows(std::span<const TriggerRow> rows, const json& wanted, bool EOA) {
  ASSERT_EQ(rows.size(), wanted.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const json& w = wanted[i];
    const std::string id = "t" + std::to_string(rows[i].id);
    SCOPED_TRACE(id);
    EXPECT_EQ(id, w[0].get<std::string>());
    EXPECT_EQ(speed(rows[i]), with_Vt(w[1].get<std::string>()));
    const std::string where = w[2].get<std::string>();
    EXPECT_EQ(location(rows[i].beyond, rows[i].not_beyond), EOA ? parse_EOA(where) : parse_MRSP(SBI2_is_SBI(where)));
    EXPECT_EQ(command(rows[i].command), w[3].is_null() ? "" : w[3].get<std::string>());
    EXPECT_EQ(status(rows[i].status), without_star(w[4].get<std::string>()));
  }
}

/// 3.6.0 after the correction of the facts: 4.0.0 without t0-t2, Indication needed in t6, t9, t12, t15.
json with_indication(const json& v400, bool EOA) {
  json rows = json::array();
  for (json row : v400) {
    const std::string id = row[0];
    if (id == "t0" || id == "t1" || id == "t2") continue;
    if (id == "t6" || id == "t9" || id == "t12" || id == "t15") {
      const std::string old = row[2];
      if (EOA)
        row[2] = "(S:d>dI(V) OR E:d>dI(V)) AND " + old;
      else
        row[2] = old == "-" ? "d>dI(V)" : "dI(V)<" + old;
    }
    rows.push_back(row);
  }
  return rows;
}

TEST(Tables, CeilingSpeedMonitoring) {
  const json& wanted = reference()["CSM"]["trigger"];
  ASSERT_EQ(std::size(kCSM), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ("t" + std::to_string(kCSM[i].id), wanted[i][0].get<std::string>());
    std::string v = wanted[i][1];
    v = std::regex_replace(v, std::regex("V_MRSP"), "M");
    v = std::regex_replace(v, std::regex(R"(dV_(\w+))"), "dV$1(M)");
    v = std::regex_replace(v, std::regex("dVwarning"), "dVw");
    EXPECT_EQ(speed(kCSM[i]), v);
    EXPECT_EQ(command(kCSM[i].command), wanted[i][2].is_null() ? "" : wanted[i][2].get<std::string>());
    EXPECT_EQ(status(kCSM[i].status), wanted[i][3].get<std::string>());
  }
}
TEST(Tables, ReleaseSpeedMonitoring) {
  const json& wanted = reference()["RSM"]["trigger"];
  ASSERT_EQ(std::size(kRSM), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ("t" + std::to_string(kRSM[i].id), wanted[i][0].get<std::string>());
    EXPECT_EQ(speed(kRSM[i]), with_Vt(wanted[i][1]));
    EXPECT_EQ(command(kRSM[i].command), wanted[i][2].is_null() ? "" : wanted[i][2].get<std::string>());
    EXPECT_EQ(status(kRSM[i].status), wanted[i][3].get<std::string>());
  }
}
TEST(Tables, TargetSpeedMonitoring340) {
  expect_rows(kTSM_MRSP_LOA_3_4_0, reference()["TSM_MRSP_LOA"]["trigger"], false);
  expect_rows(kTSM_EOA_SvL_3_4_0, reference()["TSM_EOA_SvL"]["trigger"], true);
}
TEST(Tables, TargetSpeedMonitoring400) {
  expect_rows(kTSM_MRSP_LOA_4_0_0, reference()["TSM_v4_0_0"]["MRSP_LOA"], false);
  expect_rows(kTSM_EOA_SvL_4_0_0, reference()["TSM_v4_0_0"]["EOA_SvL"], true);
}
TEST(Tables, TargetSpeedMonitoring360) {
  expect_rows(kTSM_MRSP_LOA_3_6_0, with_indication(reference()["TSM_v4_0_0"]["MRSP_LOA"], false), false);
  expect_rows(kTSM_EOA_SvL_3_6_0, with_indication(reference()["TSM_v4_0_0"]["EOA_SvL"], true), true);
}

void expect_revocations(std::span<const RevocationRow> rows, const json& wanted) {
  ASSERT_EQ(rows.size(), wanted.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const json& w = wanted[i];
    SCOPED_TRACE(w[0].get<std::string>());
    EXPECT_EQ("r" + std::to_string(rows[i].id), w[0].get<std::string>());
    std::string v = w[1];
    v = std::regex_replace(v, std::regex("V_MRSP"), "M");
    EXPECT_EQ(speed(rows[i]), with_Vt(v));
    const json& commands = w[w.size() - 2];
    std::set<std::string> named;
    std::string EB = "never";
    for (const std::string c : commands) {
      if (c.substr(0, 2) != "EB") {
        named.insert(c);
        continue;
      }
      EB = "always";
      if (c.find("Vt!=0") != std::string::npos)
        EB = "or_zero";
      else if (c.find("Q_NVEMRRLS") != std::string::npos)
        EB = "if_permitted";
    }
    EXPECT_EQ(rows[i].TCO, named.count("TCO") == 1);
    EXPECT_EQ(rows[i].SB, named.count("SB") == 1);
    static const std::map<EbRelease, std::string> names = {{EbRelease::never, "never"},
                                                           {EbRelease::always, "always"},
                                                           {EbRelease::if_permitted, "if_permitted"},
                                                           {EbRelease::or_zero, "or_zero"}};
    EXPECT_EQ(names.at(rows[i].EB), EB);
    if (w.size() == 5) {
      EXPECT_EQ(location(Limit::none, rows[i].not_beyond), parse_MRSP(w[2].get<std::string>()));
    }
  }
}
TEST(Tables, Revocations) {
  expect_revocations(kCSM_revocation, reference()["CSM"]["revoke"]);
  expect_revocations(kRSM_revocation, reference()["RSM"]["revoke"]);
  expect_revocations(kTSM_revocation_3_4_0, reference()["TSM_MRSP_LOA"]["revoke"]);
  expect_revocations(kTSM_revocation_4_0_0, reference()["TSM_v4_0_0"]["revoke_MRSP_LOA"]);
}
/// Where a revocation leads is said by the transition tables ("IntS", "NoS", ["r0", "r1"]).
TEST(Tables, RevocationsLeadWhereTheTransitionTablesSay) {
  const auto expect = [](std::span<const RevocationRow> rows, const json& transitions) {
    for (const RevocationRow& row : rows) {
      const std::string id = "r" + std::to_string(row.id);
      bool found = false;
      for (const json& t : transitions)
        if (t[0] == "IntS" && t[2].dump().find(id) != std::string::npos) {
          EXPECT_EQ(status(row.to), t[1].get<std::string>()) << id;
          found = true;
          break;
        }
      EXPECT_TRUE(found || (row.id == 1 && row.EB == EbRelease::never)) << id;
    }
  };
  expect(kCSM_revocation, reference()["CSM"]["transitions"]);
  expect(kTSM_revocation_4_0_0, reference()["TSM_v4_0_0"]["transitions"]);
  expect(kRSM_revocation, reference()["RSM"]["transitions"]);
}

void expect_transitions(std::span<const TransitionRow> rows, const json& wanted) {
  static const std::map<Monitoring, std::string> names = {
      {Monitoring::CSM, "CSM"}, {Monitoring::TSM, "TSM"}, {Monitoring::RSM, "RSM"}};
  std::map<std::pair<std::string, std::string>, int> ours;
  std::map<std::pair<std::string, std::string>, int> theirs;
  for (const TransitionRow& r : rows) ours[{names.at(r.from), names.at(r.to)}] = r.conditions;
  for (const json& w : wanted) {
    int bits = 0;
    for (const std::string c : w[2]) bits |= 1 << std::stoi(c);
    theirs[{w[0], w[1]}] = bits;
  }
  EXPECT_EQ(ours, theirs);
}
TEST(Tables, TransitionsBetweenTypesOfMonitoring) {
  expect_transitions(kTransitions_3_4_0, reference()["monitoring_transitions"]["table"]);
  expect_transitions(kTransitions_4_0_0, reference()["monitoring_transitions_v4_0_0"]["table"]);
}

}  // namespace
