#include <gtest/gtest.h>

#include <map>

#include "ways.h"

// What packets of system versions 1.0 and 1.1 are to the unit (6.6.3.2.3), in the outputs.
namespace evc::through_step {
namespace {

struct Sent {
  unsigned id;
  Codes codes;
  std::string sv = "1.0";
};
/// After groups with one packet each; `with` are packets of 1.0 in the last one.
Json after_groups(const std::vector<Sent>& groups, const std::string& start = kFS1,
                  const std::vector<Sent>& with = {}) {
  OnBoard unit(OnBoard::after(start));
  unsigned NID_BG = 200;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    BitList bits;
    if (i + 1 == groups.size())
      for (const Sent& w : with) put_packet(bits, *find_packet("to_train", w.id, w.sv), w.codes);
    put_packet(bits, *find_packet("to_train", groups[i].id, groups[i].sv), groups[i].codes);
    unit.pass(NID_BG++, bits, groups[i].sv);
  }
  return unit.output();
}

std::string train_with(const std::string& category) {
  return "  given train { category { " + category + " } }\n  and FS level 1 with speed = 60 km/h\n";
}

TEST(LanguageThroughStep, AxleLoadsOfOlderVersions) {  // 6.6.3.2.3 [5]
  const struct {
    std::uint64_t M_AXLELOAD;
    int category;
  } rows[]{{32, 0}, {33, 1}, {34, 1}, {35, 2},  {36, 2},  {37, 4},
           {40, 4}, {41, 7}, {45, 7}, {46, 11}, {80, 11}, {126, 11}};
  const Json& names = variable("M_AXLELOADCAT").at("enum");
  for (const auto& row : rows) {
    const Codes codes{{"D_AXLELOAD", 800},
                      {"N_ITER_CAT", 1},
                      {"categories/V_AXLELOAD", 12},
                      {"categories/M_AXLELOAD", row.M_AXLELOAD}};
    for (const int train : {row.category - 1, row.category, 12}) {
      if (train < 0) continue;
      const Json out = after_groups(
          {{51, codes}}, train_with("axle_load \"" + names.at(std::to_string(train)).get<std::string>() + "\""));
      EXPECT_EQ(out["planning"]["mrsp"].size() > 1, train >= row.category) << row.M_AXLELOAD << " train " << train;
    }
  }
}

TEST(LanguageThroughStep, ResetsOfOlderVersions) {  // [4]: from the group on
  const Codes restriction{{"D_AXLELOAD", 800}, {"N_ITER_CAT", 1}, {"categories/M_AXLELOADCAT", 0}};
  EXPECT_GT(after_groups({{51, restriction, "2.1"}})["planning"]["mrsp"].size(), 1u);
  EXPECT_EQ(after_groups({{51, restriction, "2.1"}, {51, {{"Q_TRACKINIT", 1}}}})["planning"]["mrsp"].size(), 1u);
}

TEST(LanguageThroughStep, ModeProfilesOfOlderVersions) {  // [7]: the start is a supervised location
  const Codes area{{"D_MAMODE", 800}, {"L_MAMODE", 500}, {"V_MAMODE", 8}};
  const Json older = after_groups({{80, area}}, kFS1, {{12, {}}});
  EXPECT_EQ(older["EOA_m"], older["SvL_m"]);
  const Json newer = after_groups({{80, area, "2.1"}}, kFS1, {{12, {}, "2.1"}});
  EXPECT_EQ(newer["EOA_m"], older["EOA_m"]);
  EXPECT_GT(newer["SvL_m"].get<double>(), newer["EOA_m"].get<double>() + 1000.0);
}

TEST(LanguageThroughStep, TrackConditionsOfOlderVersions) {  // [8]
  const auto kind = [](std::uint64_t code) {
    return after_groups(
        {{68, {{"D_TRACKCOND", 200}, {"L_TRACKCOND", 300}, {"M_TRACKCOND", code}}}})["track_conditions"];
  };
  ASSERT_EQ(kind(0).size(), 1u);
  EXPECT_EQ(kind(0)[0]["kind"], "non stopping area");
  EXPECT_EQ(kind(1), kind(0));
  EXPECT_EQ(kind(2), kind(0));
  EXPECT_NE(kind(3), kind(0));
}

/// M_TRACTION to M_VOLTAGE and NID_CTRACTION (6.6.3.2.3 [13]).
const std::map<std::uint64_t, std::pair<int, int>>& tractions() {
  static const std::map<std::uint64_t, std::pair<int, int>> rows{
      {0, {0, 0}},   {1, {3, 10}},  {2, {1, 12}},  {3, {1, 13}},  {5, {4, 14}},  {6, {4, 1}},
      {7, {1, 2}},   {8, {1, 3}},   {11, {2, 19}}, {12, {2, 20}}, {13, {2, 21}}, {15, {2, 22}},
      {26, {1, 11}}, {31, {1, 18}}, {32, {3, 15}}, {33, {3, 16}}, {34, {1, 17}}, {41, {2, 4}},
      {42, {2, 5}},  {43, {2, 6}},  {44, {2, 7}},  {45, {2, 8}},  {46, {2, 9}}};
  return rows;
}

TEST(LanguageThroughStep, TractionOfOlderVersions) {  // [13], [19]
  for (std::uint64_t code = 0; code < 256; ++code) {
    const Json orders = after_groups({{39, {{"D_TRACTION", 100}, {"M_TRACTION", code}}}})["train_orders"];
    const Json& system = orders["traction_system"];
    const auto row = tractions().find(code);
    ASSERT_EQ(system.is_object(), row != tractions().end()) << code;
    if (row == tractions().end()) continue;
    EXPECT_EQ(system["M_VOLTAGE"], row->second.first) << code;
    EXPECT_EQ(system["NID_CTRACTION"], row->second.second) << code;
  }
  const Json newer = after_groups({{239, {{"D_TRACTION", 100}, {"M_VOLTAGE", 2}, {"NID_CTRACTION", 5}}, "1.1"}});
  EXPECT_EQ(newer["train_orders"]["traction_system"]["NID_CTRACTION"], 5);
}

TEST(LanguageThroughStep, RouteSuitabilityOfOlderVersions) {  // [11], [12], [18]
  const double far = after_groups({{254, {}}})["EOA_m"];
  const auto EOA = [&](const Codes& codes) { return after_groups({{70, codes}})["EOA_m"].get<double>(); };
  for (std::uint64_t code = 0; code < 256; ++code) {  // the train has none of them
    const double end = EOA({{"D_SUITABILITY", 900}, {"Q_SUITABILITY", 2}, {"M_TRACTION", code}});
    EXPECT_EQ(end < far - 1000.0, tractions().contains(code)) << code;
  }
  EXPECT_EQ(EOA({{"D_SUITABILITY", 900}, {"Q_SUITABILITY", 1}, {"M_AXLELOAD", 1}}), far);
  EXPECT_EQ(EOA({{"D_SUITABILITY", 900}, {"Q_SUITABILITY", 0}}), far);
  const Json later = after_groups({{207, {{"D_SUITABILITY", 900}, {"Q_SUITABILITY", 2}, {"M_VOLTAGE", 3}}, "1.1"}});
  EXPECT_LT(later["EOA_m"].get<double>(), far - 1000.0);
}

TEST(LanguageThroughStep, PositionsOfOlderVersions) {  // [14]
  const auto geo = [](std::uint64_t M_POSITION) {
    return after_groups({{79, {{"NID_BG", 200}, {"Q_MPOSITION", 1}, {"M_POSITION", M_POSITION}}}})["geo_m"];
  };
  EXPECT_TRUE(geo(1048575).is_null());
  EXPECT_NEAR(geo(1048574).get<double>() - geo(1000).get<double>(), 1047574.0, 1.01);
}

TEST(LanguageThroughStep, ApplicationsOfOlderVersions) {  // [20]
  for (const auto& [user, system] : std::vector<std::pair<int, int>>{{13, 28}, {39, 11}, {40, -1}}) {
    OnBoard unit(OnBoard::after(kFS1));
    BitList bits;
    put_packet(bits, *find_packet("to_train", 44, "1.0"), {{"NID_XUSER", static_cast<std::uint64_t>(user)}});
    const Answer answer = unit.pass(200, bits, "1.0");
    ASSERT_EQ(answer.forwarded.size(), 1u) << user;
    EXPECT_EQ(answer.forwarded[0], std::pair(system < 0 ? user : 102, system));
  }
}

TEST(LanguageThroughStep, CategoriesOfOlderVersions) {  // [3]
  for (const auto& [code, name] : variable("NC_DIFF_V1").at("enum").items()) {
    const std::string category = name.get<std::string>();
    const bool cant = category.rfind("CD ", 0) == 0;
    const std::string own = cant ? "cant_deficiency_mm " + category.substr(3, category.size() - 6)
                            : category.find("in P") != std::string::npos ? "other [ \"FreightP\" ]"
                            : category.find("in G") != std::string::npos ? "other [ \"FreightG\" ]"
                                                                         : "other [ \"Passenger\" ]";
    const Codes profile{{"D_STATIC", 900},
                        {"V_STATIC", 23},
                        {"N_ITER_DIFF", 1},
                        {"diffs/V_DIFF", 14},
                        {"diffs/NC_DIFF", std::stoull(code)}};
    EXPECT_EQ(after_groups({{27, profile}}, train_with(own))["planning"]["mrsp"][1]["v_kmh"], 70) << category;
    if (category == "CD 80 mm") continue;  // each train has this one at least
    const std::string other = cant ? "cant_deficiency_mm 0" : "other [ ]";
    EXPECT_EQ(after_groups({{27, profile}}, train_with(other))["planning"]["mrsp"][1]["v_kmh"], 115) << category;
  }
}

TEST(LanguageThroughStep, RunningNumbersOfOlderVersions) {  // [10]
  const std::string RBC =
      "  given standing in SB\n  and driver enters { driver_id 1234 }\n  and driver enters { level 2 }\n  and driver "
      "enters { rbc { NID_C 1, NID_RBC 1, NID_RADIO \"FFFFFFFFFFFFFFFF\" } }\n  and waits 0.2 s\n  and session "
      "connected\n  and message 32 { M_VERSION 17 }\n  and waits 0.2 s\n  and message 41 version 1.1\n  and driver "
      "enters "
      "{ train_data {} }\n  and driver enters { train_running_number 4711 }\n  and waits 0.3 s\n  and message 8 "
      "version "
      "1.1\n  and waits 0.2 s\n  and driver selects start\n  and waits 0.2 s\n  and message 2 version 1.1 { D_SR "
      "unknown "
      "}\n  and waits 0.2 s\n  and driver acknowledges SR\n  and waits 0.2 s\n  and drives at 20 km/h\n  and passes "
      "group "
      "100\n";
  const auto number = [&](std::uint64_t code) {
    OnBoard unit(OnBoard::after(RBC));
    BitList bits;
    put_packet(bits, *find_packet("to_train", 140, "1.1"), {{"NID_OPERATIONAL", code}});
    unit.receive(24, {}, bits, "1.1");
    return unit.output()["data"]["train_running_number"]["value"];
  };
  EXPECT_EQ(number(0x1F2FF345), "12345");
  EXPECT_EQ(number(0x12345FFF), "12345");
  EXPECT_EQ(number(0xFFFFFFFF), "4711");  // unknown
}

}  // namespace
}  // namespace evc::through_step
