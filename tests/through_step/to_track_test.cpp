#include <gtest/gtest.h>

#include <set>

#include "ways.h"

// Every message to the track (8.6), decoded by the reference data, with the state that caused it.
namespace evc::through_step {
namespace {

constexpr std::uint64_t kEngine = 0xABCDEF, kUnknown = 0xFFFFFF, kGroup = 1u << 14;

/// A unit with an identity, telephone numbers and a train of its own.
std::string with_data(const std::string& statements) {
  return "  given config { NID_ENGINE 11259375 telephone_numbers [ \"0031612345678FFF\" \"004412FFFFFFFFFF\" ] }\n  "
         "and "
         "train { "
         "length_m 400 max_speed_kmh 140 category { cant_deficiency_mm 150 other [ \"FreightP\" \"Passenger\" ] "
         "axle_load "
         "\"D2\" loading_gauge \"GB\" airtight true axles 48 traction_systems [ { M_VOLTAGE 1 NID_CTRACTION 9 } { "
         "M_VOLTAGE "
         "5 NID_CTRACTION 1023 } ] } }\n" +
         statements;
}
const std::string kCalled =
    "  given standing in SB\n  and driver enters { driver_id 1234 }\n  and driver enters { level 2 }\n  and driver "
    "enters { "
    "rbc { NID_C 1, NID_RBC 1, NID_RADIO \"FFFFFFFFFFFFFFFF\" } }\n  and waits 0.2 s\n  and session connected\n";
const std::string kOld =
    kCalled +
    "  and message 32 { M_VERSION 17 }\n  and waits 0.2 s\n  and message 41 version 1.1\n  and driver "
    "enters { train_data {} }\n  and driver enters { train_running_number 4711 }\n  and waits 0.3 s\n";
const std::string kReports = "  and message 24\n    packet 58 { Q_DIR 2, T_CYCLOC 255, D_CYCLOC 32767, M_LOC 1 }\n";

struct Expected {
  unsigned NID_MESSAGE;
  std::string start;
  Codes codes;
  std::vector<std::pair<unsigned, Codes>> packets;
  std::string sv = "2.1";
};

const std::vector<Expected>& expected() {
  const Codes nowhere{{"Q_SCALE", 1}, {"NID_LRBG", kUnknown}, {"D_LRBG", 32767},       {"Q_DIRLRBG", 2},
                      {"Q_DLRBG", 2}, {"L_DOUBTOVER", 32767}, {"L_DOUBTUNDER", 32767}, {"Q_LENGTH", 0},
                      {"V_TRAIN", 0}, {"Q_DIRTRAIN", 2},      {"M_MODE", 6},           {"M_LEVEL", 3}};
  static const std::vector<Expected> rows{
      {155, kCalled, {}, {}},
      {154, kCalled + "  and message 32 { M_VERSION 64 }\n", {}, {}},
      {156, kCalled + "  and message 32 { M_VERSION 64 }\n  and waits 1 s\n", {}, {}},
      {159,
       kCalled + "  and message 32\n",
       {},
       {{2,
         {{"M_VERSION", 33},
          {"N_ITER", 3},
          {"versions/0/M_VERSION", 32},
          {"versions/1/M_VERSION", 17},
          {"versions/2/M_VERSION", 16}}}}},
      {159,
       kCalled + "  and message 32 { M_VERSION 17 }\n",
       {},
       {{3, {{"N_ITER", 2}, {"numbers/0/NID_RADIO", 0x0031612345678FFF}, {"numbers/1/NID_RADIO", 0x004412FFFFFFFFFF}}}},
       "1.1"},
      {159, kCalled + "  and message 32 { M_VERSION 32 }\n", {}, {{3, {{"N_ITER", 2}}}}, "2.0"},  // 6.6.5.3.2
      {157, kCalled + "  and message 32\n", {{"Q_STATUS", 2}}, {{0, nowhere}}},
      {129,
       "  given RBC ready\n",
       {},
       {{11,
         {{"NC_CDTRAIN", 3},
          {"NC_TRAIN", 5},
          {"L_TRAIN", 400},
          {"V_MAXTRAIN", 28},
          {"M_LOADINGGAUGE", 3},
          {"M_AXLELOADCAT", 7},
          {"M_AIRTIGHT", 1},
          {"N_AXLE", 48},
          {"N_ITER_TRACTION", 2},
          {"tractions/0/M_VOLTAGE", 1},
          {"tractions/0/NID_CTRACTION", 9},
          {"tractions/1/M_VOLTAGE", 5},
          {"tractions/1/NID_CTRACTION", 1023},
          {"N_ITER_NTC", 0}}}}},
      {136, "  given RBC ready\n", {}, {{5, {{"NID_OPERATIONAL", 0x4711FFFF}}}}},
      {130, "  given RBC ready\n  and driver selects shunting\n  and waits 0.2 s\n", {}, {{0, nowhere}}},
      {132,
       "  given RBC ready\n  and driver selects start\n  and waits 0.2 s\n",
       {{"Q_MARQSTREASON", 1}},
       {{0, nowhere}}},
      {136,
       "  given FS level 2 with speed = 60 km/h\n" + kReports + "  and passes group 101\n  and waits 0.2 s\n",
       {},
       {{0,
         {{"NID_LRBG", kGroup | 101},
          {"Q_DIRLRBG", 1},
          {"Q_DLRBG", 1},
          {"Q_LENGTH", 0},
          {"V_TRAIN", 12},
          {"Q_DIRTRAIN", 1},
          {"M_MODE", 0},
          {"M_LEVEL", 3}}}}},
      {136,
       "  given FS level 2 with speed = 60 km/h\n" + kReports +
           "  and passes group 101 of 1 balise { Q_LINK 1 }\n  and waits 0.2 s\n",
       {},
       {{1,
         {{"NID_LRBG", kGroup | 101},
          {"NID_PRVLRBG", kGroup | 100},
          {"Q_DIRLRBG", 1},
          {"Q_DLRBG", 1},
          {"V_TRAIN", 12},
          {"M_MODE", 0},
          {"M_LEVEL", 3}}}}},
      {136,
       "  given FS level 2 with speed = 60 km/h\n  and message 24 longer by 1 bytes\n  and waits 0.2 s\n",
       {},
       {{4, {{"M_ERROR", 3}}}}},
      {137,
       "  given FS level 2 with authority = 4000 m\n  and message 9 { T_TRAIN 7000 } packet 15 { L_ENDSECTION 3000 m "
       "}\n",
       {{"T_TRAIN_REF", 7000}},
       {}},
      {138,
       "  given FS level 2 with authority = 4000 m, speed = 100 km/h\n  and message 9 { T_TRAIN 7000 } packet 15 { "
       "L_ENDSECTION 400 m }\n",
       {{"T_TRAIN_REF", 7000}},
       {}},
      {146, "  given FS level 2\n  and message 24 { M_ACK 1, T_TRAIN 7000 }\n", {{"T_TRAIN_REF", 7000}}, {}},
      {147, "  given FS level 2\n  and message 16 { NID_EM 15 }\n", {{"NID_EM", 15}, {"Q_EMERGENCYSTOP", 2}}, {}},
      {147,
       "  given FS level 2\n  and message 15 { NID_EM 0, D_EMERGENCYSTOP 2500 m }\n",
       {{"NID_EM", 0}, {"Q_EMERGENCYSTOP", 0}},
       {}},
      {147,
       "  given FS level 2\n  and message 15 { NID_EM 4, D_EMERGENCYSTOP 5000 m }\n",
       {{"NID_EM", 4}, {"Q_EMERGENCYSTOP", 1}},
       {}},
      {147,
       "  given FS level 2\n  and message 15 { NID_EM 4, D_EMERGENCYSTOP 1 m }\n",
       {{"NID_EM", 4}, {"Q_EMERGENCYSTOP", 3}},
       {}},
      {149,
       "  given SR level 2\n  and drives at 30 km/h\n  and passes group 100\n  and message 34 { D_TAFDISPLAY 0 m, "
       "L_TAFDISPLAY 400 m }\n  and drives for 20 m\n  and driver selects track_ahead_free\n  and waits 0.2 s\n",
       {},
       {{0, {{"NID_LRBG", kGroup | 100}, {"M_MODE", 2}, {"M_LEVEL", 3}}}}},
      {150,
       "  given FS level 2\n  and stops\n  and desk closed\n  and waits 1 s\n",
       {},
       {{0, {{"V_TRAIN", 0}, {"M_MODE", 6}}}}},
      {153,
       kInfillUnit,
       {{"NID_C", 1}, {"NID_BG", 101}, {"Q_INFILL", 0}},
       {{0, {{"M_LEVEL", 2}, {"NID_LRBG", kGroup | 100}}}}},
      {158,
       "  given FS level 2\n  and message 24\n    packet 72 { Q_TEXTCONFIRM 1, T_TEXTDISPLAY 60 s, Q_TEXTREPORT 1, "
       "NID_TEXTMESSAGE 255, NID_C 1, NID_RBC 1, text \"Call\" }\n  and waits 0.5 s\n  and driver acknowledges text\n  "
       "and waits 0.5 s\n",
       {{"NID_TEXTMESSAGE", 255}},
       {}},
      {132,
       "  given FS level 1\n  and passes group 110\n    packet 41 { D_LEVELTR 1500 m, M_LEVELTR 3 }\n    packet 42 { "
       "Q_RBC 1, NID_C 1, NID_RBC 1, NID_RADIO \"0031612345678FFF\" }\n  and session connected\n  and message 32\n  "
       "and waits 1 s\n  and passes group 120\n    packet 90 { NID_BG 200 }\n  and waits 1 s\n",
       {{"Q_MARQSTREASON", 16}},
       {{9, {{"NID_LTRBG", kGroup | 200}}}}},
      // To an RBC of version 1.1 (6.6.3.4.5).
      {129,
       kOld,
       {},
       {{11,
         {{"NC_TRAIN", 1u << 4},
          {"L_TRAIN", 400},
          {"V_MAXTRAIN", 28},
          {"M_LOADINGGAUGE", 0},
          {"M_AXLELOAD", 45},
          {"M_AIRTIGHT", 1},
          {"N_ITER_TRACTION", 0},
          {"N_ITER_NTC", 0}}}},
       "1.1"},
      {132,
       kOld + "  and message 8 version 1.1\n  and waits 0.2 s\n  and driver selects start\n  and waits 0.2 s\n",
       {{"Q_TRACKDEL", 0}},
       {},
       "1.1"},
  };
  return rows;
}

/// Messages that are the same for an RBC or a radio infill unit of X = 1 (6.6.3.4.5, U), with a report of its form.
const std::vector<Expected>& expected_by_older() {
  const Codes there{{"NID_LRBG", kGroup | 100}, {"Q_DIRLRBG", 1}, {"Q_DLRBG", 1}, {"V_TRAIN", 12}, {"M_LEVEL", 3}};
  const std::string FS4 = "  given FS level 2 with authority = 4000 m, speed = 60 km/h\n";
  const std::string order = "  and message 24\n    packet 42 { Q_RBC 0, NID_RADIO \"FFFFFFFFFFFFFFFF\" }\n";
  static const std::vector<Expected> rows{
      {155, kCalled, {}, {}},
      {157, kCalled + "  and message 32\n", {{"Q_STATUS", 2}}, {{0, {{"M_MODE", 6}, {"V_TRAIN", 0}}}}},
      {130, "  given RBC ready\n  and driver selects shunting\n  and waits 0.2 s\n", {}, {{0, {{"M_MODE", 6}}}}},
      {136,
       FS4 + kReports + "  and passes group 101 of 1 balise { Q_LINK 1 }\n  and waits 0.2 s\n",
       {},
       {{1, {{"NID_LRBG", kGroup | 101}, {"NID_PRVLRBG", kGroup | 100}, {"V_TRAIN", 12}, {"M_LEVEL", 3}}}}},
      {136, FS4 + "  and message 24 longer by 1 bytes\n  and waits 0.2 s\n", {}, {{0, there}, {4, {{"M_ERROR", 3}}}}},
      {137,
       FS4 + "  and message 9 { T_TRAIN 7000 } packet 15 { L_ENDSECTION 3000 m }\n",
       {{"T_TRAIN_REF", 7000}},
       {{0, there}}},
      {138,
       FS4 + "  and message 9 { T_TRAIN 7000 } packet 15 { L_ENDSECTION 200 m }\n",
       {{"T_TRAIN_REF", 7000}},
       {{0, there}}},
      {146, FS4 + "  and message 24 { M_ACK 1, T_TRAIN 7000 }\n", {{"T_TRAIN_REF", 7000}}, {}},
      {147, FS4 + "  and message 16 { NID_EM 15 }\n", {{"NID_EM", 15}, {"Q_EMERGENCYSTOP", 2}}, {{0, there}}},
      {149,
       "  given SR level 2\n  and drives at 30 km/h\n  and passes group 100\n  and message 34 { D_TAFDISPLAY 0 m, "
       "L_TAFDISPLAY 400 m }\n  and drives for 20 m\n  and driver selects track_ahead_free\n  and waits 0.2 s\n",
       {},
       {{0, {{"NID_LRBG", kGroup | 100}, {"M_MODE", 2}, {"M_LEVEL", 3}}}}},
      {150, FS4 + "  and stops\n  and desk closed\n  and waits 1 s\n", {}, {{0, {{"V_TRAIN", 0}, {"M_MODE", 6}}}}},
      {153,
       kInfillUnit,
       {{"NID_C", 1}, {"NID_BG", 101}, {"Q_INFILL", 0}},
       {{0, {{"M_LEVEL", 2}, {"NID_LRBG", kGroup | 100}}}}},
      {156, FS4 + order, {}, {}},
  };
  return rows;
}

void expect_codes(const Codes& wanted, const Codes& found) {
  for (const auto& [path, code] : wanted) {
    const auto at = found.find(path);
    ASSERT_NE(at, found.end()) << path;
    EXPECT_EQ(at->second, code) << path;
  }
}

void check_sent(const Expected& e, const std::string& sv) {
  SCOPED_TRACE(std::to_string(e.NID_MESSAGE) + " to " + sv + e.start);
  const OnBoard& unit = OnBoard::after(with_data(e.start));
  const Decoded message = unit.last_sent(e.NID_MESSAGE, sv);
  EXPECT_TRUE(message.complete);
  Codes common = e.codes;
  common["NID_ENGINE"] = kEngine;
  expect_codes(common, message.codes);
  EXPECT_NE(message.codes.at("T_TRAIN"), 0u);
  EXPECT_LE(message.codes.at("T_TRAIN"), static_cast<std::uint64_t>(unit.t_ms() / 10));
  const Json elements = find_message("to_track", e.NID_MESSAGE, sv)->at("elements");
  bool reports = false;
  for (const Json& element : elements)
    reports = reports || (element.contains("packet_one_of") && element.at("packet_one_of")[0] == 0);
  // 8.4.4.7.2: a position in all but 146, 154, 155, 156 and 159, and one only (8.4.1.5).
  EXPECT_EQ((message.packet(0) != nullptr) != (message.packet(1) != nullptr), reports);
  std::set<unsigned> kinds;
  for (const auto& [id, codes] : message.packets) EXPECT_TRUE(kinds.insert(id).second) << id;
  for (const auto& [id, codes] : e.packets) {
    const Codes* packet = message.packet(id);
    ASSERT_NE(packet, nullptr) << "packet " << id;
    expect_codes(codes, *packet);
  }
}

TEST(LanguageThroughStep, MessagesToTrack) {
  for (const Expected& e : expected()) check_sent(e, e.sv);
}

TEST(LanguageThroughStep, MessagesToTrackOfOlderVersions) {  // 6.6.3.4.4
  for (const char* sv : {"1.0", "1.1"})
    for (Expected e : expected_by_older()) {
      e.start = in_version(e.start, sv);
      check_sent(e, sv);
    }
}

/// 7.5.1.82.2: the classes in their order.
TEST(LanguageThroughStep, CantDeficiencyOfTheTrain) {
  std::uint64_t code = 0;
  for (const int cant_mm : {80, 100, 130, 150, 165, 180, 210, 225, 245, 275, 300}) {
    const Decoded message = OnBoard::after("  given train { category { cant_deficiency_mm " + std::to_string(cant_mm) +
                                           " } }\n  and RBC ready\n")
                                .last_sent(129);
    const Codes* data = message.packet(11);
    ASSERT_NE(data, nullptr) << cant_mm;
    EXPECT_EQ(data->at("NC_CDTRAIN"), code++) << cant_mm;
  }
}

/// 6.6.3.4.3.1: valid train data follow the report of start of mission.
TEST(LanguageThroughStep, TrainDataBehindTheReportOfStartOfMission) {
  const OnBoard& unit = OnBoard::after(
      "  given data entered\n  and driver enters { level 2 }\n  and driver enters { rbc { NID_C 1, NID_RBC 1, "
      "NID_RADIO "
      "\"FFFFFFFFFFFFFFFF\" } }\n  and waits 0.2 s\n  and session connected\n  and message 32 { M_VERSION 17 }\n  and "
      "waits 0.2 s\n");
  std::vector<unsigned> sent;
  for (const auto& message : unit.sent_before()) sent.push_back(message.at(0));
  EXPECT_EQ(sent, (std::vector<unsigned>{155, 159, 157, 129}));
}

/// 6.6.3.4.5 [3b], [3d]: train data for an RBC of version 1.1.
TEST(LanguageThroughStep, TrainDataToOlderVersions) {
  const struct {
    int cant_mm;
    unsigned bit;
  } cants[]{{80, 1},   {100, 2}, {130, 3},  {150, 4}, {165, 5}, {180, 6},
            {210, 13}, {225, 7}, {245, 12}, {275, 0}, {300, 8}};
  const struct {
    const char* category;
    std::uint64_t M_AXLELOAD;
  } axles[]{{"A", 32},  {"HS17", 34}, {"B1", 36}, {"B2", 36},   {"C2", 40}, {"C3", 40}, {"C4", 40},
            {"D2", 45}, {"D3", 45},   {"D4", 45}, {"D4XL", 45}, {"E4", 50}, {"E5", 50}};
  const struct {
    const char* other;
    std::uint64_t bits;
  } others[]{{"", 0},
             {"\"FreightP\"", 1u << 9},
             {"\"FreightG\"", 1u << 10},
             {"\"Passenger\"", 1u << 11},
             {"\"FreightG\" \"Passenger\"", 0}};
  for (std::size_t i = 0; i < std::size(axles); ++i) {
    const auto& cant = cants[i % std::size(cants)];
    const auto& other = others[i % std::size(others)];
    const std::string category = "cant_deficiency_mm " + std::to_string(cant.cant_mm) + " axle_load \"" +
                                 axles[i].category + "\" other [ " + other.other + " ]";
    const Decoded message =
        OnBoard::after("  given train { category { " + category + " } }\n" + kOld).last_sent(129, "1.1");
    const Codes* data = message.packet(11);
    ASSERT_NE(data, nullptr) << category;
    EXPECT_EQ(data->at("NC_TRAIN"), (std::uint64_t{1} << cant.bit) | other.bits) << category;
    EXPECT_EQ(data->at("M_AXLELOAD"), axles[i].M_AXLELOAD) << category;
    EXPECT_EQ(data->at("NID_OPERATIONAL"), 0x4711FFFFu);
  }
}

/// The figures of a position report against the outputs (7.4.3.1, 3.6.5.1.1).
TEST(LanguageThroughStep, PositionReport) {
  OnBoard unit(OnBoard::after(kFS2));
  unit.pass(101, {}, "2.1", {{"Q_LINK", 1}});
  unit.run(20);
  BitList now;
  put_packet(now, *find_packet("to_train", 58, "2.1"), {{"T_CYCLOC", 255}, {"D_CYCLOC", 32767}});
  const Answer answer = unit.receive(24, {}, now);
  ASSERT_FALSE(answer.sent.empty());
  const Decoded message = decode_to_track(answer.sent.back(), "2.1");
  const Codes* report = message.packet(0);
  ASSERT_NE(report, nullptr);
  const Json output = unit.output();
  const double step_m = output["v_kmh"].get<double>() / 3.6 * 0.1, est = output["est_front_m"].get<double>();
  const double scale = report->at("Q_SCALE") == 0 ? 0.1 : report->at("Q_SCALE") == 1 ? 1.0 : 10.0;
  const auto metres = [&](const char* name) { return scale * static_cast<double>(report->at(name)); };
  EXPECT_EQ(report->at("NID_LRBG"), kGroup | 101);
  // The antenna is 5 m behind the front end; the report may be one cycle old.
  EXPECT_NEAR(metres("D_LRBG"), est - (unit.group() - 5.0) - step_m / 2, step_m / 2 + scale);
  EXPECT_NEAR(metres("L_DOUBTOVER"), est - output["min_safe_front_m"].get<double>(), scale + 0.1);
  EXPECT_NEAR(metres("L_DOUBTUNDER"), output["max_safe_front_m"].get<double>() - est, scale + 0.1);
  EXPECT_EQ(report->at("V_TRAIN"), 12u);
}

/// The rear end that the driver confirms is that of the min safe front end (7.5.1.57, 3.6.5.2.4); in metres whatever
/// Q_SCALE says.
TEST(LanguageThroughStep, SafeTrainLength) {
  const OnBoard& unit =
      OnBoard::after(with_data("  given FS level 2\n  and stops\n  and waits 1 s\n  and driver selects "
                               "integrity_confirmed\n  and waits 0.2 s\n"));
  const Decoded message = unit.last_sent(136);
  const Codes* report = message.packet(0);
  ASSERT_NE(report, nullptr);
  EXPECT_EQ(report->at("Q_LENGTH"), 2u);
  ASSERT_EQ(report->at("Q_SCALE"), 0u);
  EXPECT_NEAR(static_cast<double>(report->at("L_TRAININT")),
              400.0 + 0.1 * static_cast<double>(report->at("L_DOUBTOVER")), 1.0);
}

TEST(LanguageThroughStep, EveryMessagePacketAndVariableToTheTrack) {
  std::set<unsigned> messages, packets;
  std::set<std::string> variables{"NID_MESSAGE", "L_MESSAGE",   "NID_PACKET",
                                  "L_PACKET",    "T_TRAIN",     "NID_ENGINE",    // of all of them
                                  "D_LRBG",      "L_DOUBTOVER", "L_DOUBTUNDER",  // PositionReport
                                  "L_TRAININT",                                  // SafeTrainLength
                                  "NID_NTC",     // no national system is on board, and a session needs level 2 or 3
                                  "NID_XUSER"};  // packet 44 is never sent (CAVEATS)
  const auto add = [&](const Json& row, const Codes& codes) {
    for (const Field& f : fields_of(row.at("elements")))
      for (const auto& [path, code] : codes)
        if (path == f.path || path.substr(path.rfind('/') + 1) == f.path.substr(f.path.rfind('/') + 1))
          variables.insert(f.variable);
  };
  for (const Expected& e : expected()) {
    if (e.sv == "2.1") messages.insert(e.NID_MESSAGE);
    add(*find_message("to_track", e.NID_MESSAGE, e.sv), e.codes);
    for (const auto& [id, codes] : e.packets) {
      packets.insert(id);
      add(*find_packet("to_track", id, e.sv), codes);
    }
  }
  for (const Json& m : reference("messages_to_track").at("messages")) {
    const unsigned id = m.at("id");
    if (find_message("to_track", id, "2.1") != &m) continue;
    EXPECT_TRUE(messages.contains(id)) << "message " << id;
    for (const Field& f : fields_of(m.at("elements"))) EXPECT_TRUE(variables.contains(f.variable)) << f.variable;
  }
  for (const Json& p : reference("packets_to_track").at("packets")) {
    const unsigned id = p.at("id");
    if (find_packet("to_track", id, "2.1") != &p || id == 44) continue;
    EXPECT_TRUE(packets.contains(id)) << "packet " << id;
    for (const Field& f : fields_of(p.at("elements"))) EXPECT_TRUE(variables.contains(f.variable)) << f.variable;
  }
}

}  // namespace
}  // namespace evc::through_step
