// Reads the reference facts for tables_test.cpp. A file of its own, so that a changed table does not compile the parser
// again.
#include "base/test_paths.h"
#include "sdm/test_tables.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

namespace evc::sdm::test {
namespace {

using nlohmann::json;

const json& reference() {
  static const json all = [] {
    std::ifstream file(evc::test::source_folder() + "/tests/reference/sdm_tables.json");
    return json::parse(file);
  }();
  return all;
}

/// The limits of a location text, as "d>X" and "d<=X": those passed, and those not passed.
struct Location {
  std::set<std::string> beyond, not_beyond;
};
Location parse_MRSP(const std::string& t) {
  Location l;
  // "dI(M)<d<=dW(V)"
  std::smatch m;
  if (std::regex_match(t, m, std::regex(R"((d\w+\([VM]\))<d<=(d\w+\([VM]\)))"))) return {{m[1].str()}, {m[2].str()}};
  if (std::regex_match(t, m, std::regex(R"(d>(d\w+\([VM]\)))"))) l.beyond.insert(m[1].str());
  if (std::regex_match(t, m, std::regex(R"(d<=(d\w+\([VM]\)))"))) l.not_beyond.insert(m[1].str());
  return l;
}
/// "(S:d>dI(M) OR E:d>dI(M)) AND S:d<=dEBI(V)": S and E give one limit; SBI1, SBI2 are SBI.
Location parse_EOA(const std::string& t) {
  Location l;
  static const std::regex part(R"(([SE]):d(>|<=)(d[A-Za-z]+)[12]?(\([VM]\)))");
  for (auto i = std::sregex_iterator(t.begin(), t.end(), part); i != std::sregex_iterator(); ++i) {
    const std::string limit = (*i)[3].str() + (*i)[4].str();
    ((*i)[2] == ">" ? l.beyond : l.not_beyond).insert(limit);
  }
  return l;
}
std::string without_star(std::string s) {
  if (!s.empty() && s.back() == '*') s.pop_back();
  return s;
}
/// A uniform notation of speeds: Vt for V_release too, M for V_MRSP, dVw(M) for dV_warning.
std::string speed_words(std::string s) {
  s = std::regex_replace(s, std::regex("Vr"), "Vt");
  s = std::regex_replace(s, std::regex("V_MRSP"), "M");
  s = std::regex_replace(s, std::regex(R"(dV_(\w+))"), "dV$1(M)");
  return std::regex_replace(s, std::regex("dVwarning"), "dVw");
}
std::string word(const json& j) { return j.is_null() ? "-" : j.get<std::string>(); }

using Facts = std::vector<std::string>;

std::string joined(const std::set<std::string>& words) {
  std::string all;
  for (const std::string& w : words) all += (all.empty() ? "" : "+") + w;
  return all.empty() ? "-" : all;
}
std::string trigger(const std::string& id, const std::string& speed, const Location& l, const std::string& command,
                    const std::string& status) {
  return id + ": " + speed_words(speed) + ", beyond " + joined(l.beyond) + ", not beyond " + joined(l.not_beyond) +
         ": " + command + ", " + status;
}

/// Rows of [id, speed, command, status]: no location.
Facts by_speed(const json& rows) {
  Facts facts;
  for (const json& w : rows) facts.push_back(trigger(w[0], w[1], {}, word(w[2]), w[3]));
  return facts;
}
Facts by_place(const json& rows, bool EOA) {
  Facts facts;
  for (const json& w : rows) {
    const std::string where = w[2];
    const Location l = EOA ? parse_EOA(where) : parse_MRSP(std::regex_replace(where, std::regex("dSBI[12]"), "dSBI"));
    facts.push_back(trigger(w[0], w[1], l, word(w[3]), without_star(w[4])));
  }
  return facts;
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

/// `to`: the status of each row after Intervention.
Facts revocations(const json& rows, const std::map<std::string, std::string>& to) {
  Facts facts;
  for (const json& w : rows) {
    const std::string id = w[0];
    const std::set<std::string> not_beyond = w.size() == 5 ? parse_MRSP(w[2]).not_beyond : std::set<std::string>{};
    bool TCO = false;
    bool SB = false;
    std::string EB = "never";
    for (const std::string c : w[w.size() - 2]) {
      TCO = TCO || c == "TCO";
      SB = SB || c == "SB";
      if (c.substr(0, 2) != "EB") continue;
      EB = c.find("Vt!=0") != std::string::npos        ? "or_zero"
           : c.find("Q_NVEMRRLS") != std::string::npos ? "if_permitted"
                                                       : "always";
    }
    facts.push_back(id + ": " + speed_words(w[1]) + ", not beyond " + joined(not_beyond) + ": TCO " +
                    (TCO ? "1" : "0") + ", SB " + (SB ? "1" : "0") + ", EB " + EB + ", to " + to.at(id));
  }
  return facts;
}
/// Status transitions that start in `from`: condition -> status.
std::map<std::string, std::string> leads(const json& transitions, const std::string& from) {
  std::map<std::string, std::string> to;
  for (const json& t : transitions)
    if (t[0] == from)
      for (const std::string condition : t[2])
        if (condition[0] == 'r') to[condition] = t[1];
  return to;
}

Facts transitions(const json& table) {
  Facts facts;
  for (const json& w : table) {
    int bits = 0;
    for (const std::string c : w[2]) bits |= 1 << std::stoi(c);
    facts.push_back(w[0].get<std::string>() + " to " + w[1].get<std::string>() + " by " + std::to_string(bits));
  }
  std::sort(facts.begin(), facts.end());
  return facts;
}

}  // namespace

Facts ceiling_triggers() { return by_speed(reference()["CSM"]["trigger"]); }
Facts release_triggers() { return by_speed(reference()["RSM"]["trigger"]); }
Facts triggers_3_4_0(bool EOA) { return by_place(reference()[EOA ? "TSM_EOA_SvL" : "TSM_MRSP_LOA"]["trigger"], EOA); }
Facts triggers_3_6_0(bool EOA) {
  return by_place(with_indication(reference()["TSM_v4_0_0"][EOA ? "EOA_SvL" : "MRSP_LOA"], EOA), EOA);
}
Facts triggers_4_0_0(bool EOA) { return by_place(reference()["TSM_v4_0_0"][EOA ? "EOA_SvL" : "MRSP_LOA"], EOA); }
Facts ceiling_revocations() {
  return revocations(reference()["CSM"]["revoke"], leads(reference()["CSM"]["transitions"], "IntS"));
}
Facts release_revocations() {
  auto to = leads(reference()["RSM"]["transitions"], "WaS");  // r1 does not end Intervention
  to.merge(leads(reference()["RSM"]["transitions"], "IntS"));
  return revocations(reference()["RSM"]["revoke"], to);
}
Facts revocations_3_4_0() {
  // Table 12 of 3.4.0: all except r3 (not beyond the Permitted limit) lead to Normal status.
  return revocations(reference()["TSM_MRSP_LOA"]["revoke"],
                     {{"r0", "NoS"}, {"r1", "NoS"}, {"r2", "NoS"}, {"r3", "IndS"}});
}
Facts revocations_4_0_0() {
  return revocations(reference()["TSM_v4_0_0"]["revoke_MRSP_LOA"],
                     leads(reference()["TSM_v4_0_0"]["transitions"], "IntS"));
}
Facts transitions_3_4_0() { return transitions(reference()["monitoring_transitions"]["table"]); }
Facts transitions_4_0_0() { return transitions(reference()["monitoring_transitions_v4_0_0"]["table"]); }

}  // namespace evc::sdm::test
