#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "ways.h"

// Each distance and length to the train has the same effect in each scale (7.5.1.129), and another one another effect:
// all outputs of the run that follows are compared.
namespace evc::through_step {
namespace {

/// A way to go on: what is said by it, in a cycle counted from the packet on.
using Act = std::function<std::string(OnBoard& unit, int cycle)>;

struct Case {
  unsigned number;                  ///< of the packet, or of the message
  Codes codes;                      ///< distances in metres
  std::vector<std::string> fields;  ///< the distances that are seen
  By by = By::group;
  std::string start = kFS1;
  int cycles = 300;
  std::vector<std::pair<unsigned, Codes>> beside = {};
  unsigned NID_MESSAGE = 24;  ///< that has the packet; 0: the distances are those of the message
  Act act = {};
};

Act stops_after(double metres) {
  return [=, from = 0.0](OnBoard& unit, int cycle) mutable {
    if (cycle == 0) from = unit.front();
    auto& o = unit.inputs().levels.odometry;
    if (unit.front() >= from + metres) o.V_est = o.V_min = o.V_max = {};
    return std::string();
  };
}
/// The alarm of the antenna comes and goes: where it begins outside metal there is a reaction (3.15.7).
std::string alarms(OnBoard& unit, int cycle) {
  unit.inputs().levels.train.antenna_alarm = cycle % 2 == 0;
  return "";
}
/// What is said to loop messages.
std::string loops(OnBoard& unit, int cycle) {
  if (cycle % 10 != 0) return "";
  BitList bits;
  put_packet(bits, *find_packet("to_train", 254, "2.1"), {});
  return unit.receive_loop(loop_message(bits)).text();
}

const std::string kFast = "  given SR level 2\n  and driver enters { V_sr_kmh 60 }\n  and drives at 50 km/h\n";
const std::string kReverse =
    "  given FS level 2\n  and message 24\n    packet 138 { D_STARTREVERSE 0 m, L_REVERSEAREA 800 m }\n    packet 139 "
    "{ "
    "D_REVERSE 700 m, V_REVERSE 30 km/h }\n  and stops\n  and waits 1 s\n  and signal { direction_controller backward "
    "}\n  and waits 0.5 s\n  and driver acknowledges RV\n  and waits 0.2 s\n";
const std::string kRepositioning =
    "  given SR level 1\n  and drives at 30 km/h\n  and passes group 100\n    packet 5 { D_LINK 100 m, NID_BG 16383, "
    "Q_LOCACC 20 m }\n    packet 12 { L_ENDSECTION 1500 m }\n    packet 21 { G_A 0 }\n    packet 27 { V_STATIC 140 "
    "km/h "
    "}\n  and drives for 60 m\n";
std::string with(const char* packet) {
  return std::string(kFS1) + "  and passes group 190\n    packet " + packet + "\n  and waits 0.2 s\n";
}

const Codes kAuthority{{"N_ITER", 1},
                       {"sections/L_SECTION", 400},
                       {"sections/Q_SECTIONTIMER", 1},
                       {"sections/T_SECTIONTIMER", 18},
                       {"sections/D_SECTIONTIMERSTOPLOC", 200},
                       {"L_ENDSECTION", 600},
                       {"Q_SECTIONTIMER", 1},
                       {"T_SECTIONTIMER", 32},
                       {"D_SECTIONTIMERSTOPLOC", 50}};
const std::vector<std::string> kOfSections{"sections/L_SECTION", "sections/D_SECTIONTIMERSTOPLOC", "L_ENDSECTION",
                                           "D_SECTIONTIMERSTOPLOC"};
const Codes kEnd{{"L_ENDSECTION", 700}, {"Q_ENDTIMER", 1}, {"T_ENDTIMER", 10}, {"D_ENDTIMERSTARTLOC", 300},
                 {"Q_DANGERPOINT", 1},  {"D_DP", 50},      {"V_RELEASEDP", 4}, {"Q_OVERLAP", 1},
                 {"D_STARTOL", 500},    {"T_OL", 5},       {"D_OL", 100},      {"V_RELEASEOL", 4}};
const std::vector<std::string> kOfEnd{"D_ENDTIMERSTARTLOC", "D_DP", "D_STARTOL", "D_OL"};

std::vector<Case> cases_of_authority() {
  Codes sections_behind = kAuthority;  // from the last group on, about 90 m in rear of the train
  sections_behind["sections/T_SECTIONTIMER"] = 9;
  sections_behind["T_SECTIONTIMER"] = 24;
  return {
      {12, kAuthority, kOfSections, By::group, kFS1, 450},
      {12, kEnd, kOfEnd, By::group, kFS1, 450},
      {15, sections_behind, kOfSections, By::RBC, kFS2, 450, {}, 3},
      {15, kEnd, kOfEnd, By::RBC, kFS2, 450, {}, 3},
      {16, {{"L_SECTION", 900}}, {"L_SECTION"}, By::group, kRepositioning},
      {80,
       {{"D_MAMODE", 200},
        {"V_MAMODE", 20},
        {"L_MAMODE", 150},
        {"L_ACKMAMODE", 50},
        {"N_ITER", 1},
        {"modes/D_MAMODE", 600},
        {"modes/M_MAMODE", 2},
        {"modes/V_MAMODE", 20},
        {"modes/L_MAMODE", 300},
        {"modes/L_ACKMAMODE", 50}},
       {"D_MAMODE", "L_MAMODE", "L_ACKMAMODE", "modes/D_MAMODE", "modes/L_MAMODE", "modes/L_ACKMAMODE"},
       By::group,
       kFS1,
       900,
       {{12, {}}}},
      {88, {{"D_LX", 600}, {"L_LX", 50}, {"Q_LXSTATUS", 1}, {"V_LX", 4}}, {"D_LX", "L_LX"}, By::group, kFS1, 450},
      {88,
       {{"D_LX", 400}, {"L_LX", 50}, {"Q_LXSTATUS", 1}, {"V_LX", 4}, {"Q_STOPLX", 1}, {"L_STOPLX", 20}},
       {"L_STOPLX"},
       By::group,
       kFS1,
       300,
       {},
       24,
       stops_after(350)},
      {138,
       {{"D_STARTREVERSE", 200}, {"L_REVERSEAREA", 200}},
       {"D_STARTREVERSE"},
       By::group,
       kFS1,
       200,
       {{139, {{"D_REVERSE", 500}, {"V_REVERSE", 4}}}},
       24,
       stops_after(250)},
      {138,
       {{"D_STARTREVERSE", 100}, {"L_REVERSEAREA", 100}},
       {"L_REVERSEAREA"},
       By::group,
       kFS1,
       200,
       {{139, {{"D_REVERSE", 500}, {"V_REVERSE", 4}}}},
       24,
       stops_after(250)},
      {139, {{"D_REVERSE", 900}, {"V_REVERSE", 4}}, {"D_REVERSE"}, By::RBC, kReverse, 5},
      {2, {{"D_SR", 300}}, {"D_SR"}, By::RBC, kSR2, 5, {}, 0},
      {15, {{"D_REF", 50}, {"D_EMERGENCYSTOP", 700}}, {"D_REF", "D_EMERGENCYSTOP"}, By::RBC, kFS2, 5, {}, 0},
      {33, {{"D_REF", 50}}, {"D_REF"}, By::RBC, kFS2, 5, {{15, {{"L_ENDSECTION", 2000}}}}, 0},
      {34,
       {{"D_REF", 50}, {"D_TAFDISPLAY", 100}, {"L_TAFDISPLAY", 100}},
       {"D_REF", "D_TAFDISPLAY", "L_TAFDISPLAY"},
       By::RBC,
       kFast + "  and passes group 100\n",
       400,
       {},
       0},
  };
}

std::vector<Case> cases_of_speeds() {
  const Codes axle{{"D_AXLELOAD", 300},
                   {"L_AXLELOAD", 200},
                   {"N_ITER_CAT", 1},
                   {"N_ITER", 1},
                   {"restrictions/D_AXLELOAD", 500},
                   {"restrictions/L_AXLELOAD", 200},
                   {"restrictions/N_ITER_CAT", 1}};
  const Codes brakes{{"D_PBD", 300},
                     {"D_PBDSR", 300},
                     {"L_PBDSR", 200},
                     {"Q_PBDSR", 1},
                     {"N_ITER", 1},
                     {"restrictions/D_PBD", 200},
                     {"restrictions/D_PBDSR", 500},
                     {"restrictions/L_PBDSR", 200},
                     {"restrictions/Q_PBDSR", 1}};
  return {
      {3,
       {{"D_VALIDNV", 100}, {"D_NVROLL", 20}, {"D_NVOVTRP", 30}, {"D_NVPOTRP", 40}, {"D_NVSTFF", 50}},
       {"D_VALIDNV", "D_NVROLL", "D_NVOVTRP", "D_NVPOTRP", "D_NVSTFF"}},
      {21,
       {{"D_GRADIENT", 300}, {"G_A", 5}, {"N_ITER", 1}, {"steps/D_GRADIENT", 200}, {"steps/G_A", 9}},
       {"D_GRADIENT", "steps/D_GRADIENT"},
       By::group,
       kFS1,
       5},
      {27,
       {{"D_STATIC", 300}, {"N_ITER", 1}, {"steps/D_STATIC", 200}, {"steps/V_STATIC", 20}},
       {"D_STATIC", "steps/D_STATIC"},
       By::group,
       kFS1,
       5},
      {51,
       axle,
       {"D_AXLELOAD", "L_AXLELOAD", "restrictions/D_AXLELOAD", "restrictions/L_AXLELOAD"},
       By::group,
       kFS1,
       5},
      {51,
       {{"Q_TRACKINIT", 1}, {"D_TRACKINIT", 500}},
       {"D_TRACKINIT"},
       By::group,
       with("51 { D_AXLELOAD 0 m, L_AXLELOAD 2000 m, categories [ { M_AXLELOADCAT 0 V_AXLELOAD 80 km/h } ] }"),
       5},
      {52,
       brakes,
       {"D_PBD", "D_PBDSR", "L_PBDSR", "restrictions/D_PBD", "restrictions/D_PBDSR", "restrictions/L_PBDSR"},
       By::group,
       kFS1,
       5},
      {52,
       {{"Q_TRACKINIT", 1}, {"D_TRACKINIT", 500}},
       {"D_TRACKINIT"},
       By::group,
       with("52 { D_PBD 300 m, D_PBDSR 0 m, L_PBDSR 2000 m, Q_PBDSR 1 }"),
       5},
      {65, {{"D_TSR", 300}, {"L_TSR", 200}}, {"D_TSR", "L_TSR"}, By::group, kFS1, 5},
      {71, {{"D_ADHESION", 100}, {"L_ADHESION", 200}}, {"D_ADHESION", "L_ADHESION"}, By::group, kFS1, 500},
  };
}

std::vector<Case> cases_of_conditions() {
  const Codes condition{{"D_TRACKCOND", 100}, {"L_TRACKCOND", 100}, {"M_TRACKCOND", 3}, {"N_ITER", 1}};
  const auto more = [](Codes codes, const Codes& others) {
    codes.insert(others.begin(), others.end());
    return codes;
  };
  return {
      {39, {{"D_TRACTION", 300}, {"M_VOLTAGE", 1}, {"NID_CTRACTION", 9}}, {"D_TRACTION"}, By::group, kFS1, 5},
      {40, {{"D_CURRENT", 300}, {"M_CURRENT", 20}}, {"D_CURRENT"}},
      {67,
       {{"D_TRACKCOND", 100},
        {"L_TRACKCOND", 50},
        {"N_ITER", 1},
        {"areas/D_TRACKCOND", 200},
        {"areas/L_TRACKCOND", 50}},
       {"D_TRACKCOND", "L_TRACKCOND", "areas/D_TRACKCOND", "areas/L_TRACKCOND"},
       By::group,
       kFS1,
       300,
       {},
       24,
       alarms},
      {68,
       more(condition,
            {{"conditions/D_TRACKCOND", 300}, {"conditions/L_TRACKCOND", 100}, {"conditions/M_TRACKCOND", 3}}),
       {"D_TRACKCOND", "L_TRACKCOND", "conditions/D_TRACKCOND", "conditions/L_TRACKCOND"},
       By::group,
       kFS1,
       600},
      {68,
       {{"Q_TRACKINIT", 1}, {"D_TRACKINIT", 200}, {"M_TRACKCOND", 3}},
       {"D_TRACKINIT"},
       By::group,
       with("68 { D_TRACKCOND 0 m, L_TRACKCOND 2000 m, M_TRACKCOND 3 }"),
       5},
      {69,
       {{"D_TRACKCOND", 100},
        {"L_TRACKCOND", 100},
        {"N_ITER", 1},
        {"platforms/D_TRACKCOND", 300},
        {"platforms/L_TRACKCOND", 100}},
       {"D_TRACKCOND", "L_TRACKCOND", "platforms/D_TRACKCOND", "platforms/L_TRACKCOND"},
       By::group,
       kFS1,
       600},
      {69,
       {{"Q_TRACKINIT", 1}, {"D_TRACKINIT", 200}},
       {"D_TRACKINIT"},
       By::group,
       with("69 { D_TRACKCOND 0 m, L_TRACKCOND 2000 m }"),
       5},
      {70, {{"D_SUITABILITY", 600}, {"Q_SUITABILITY", 2}, {"M_VOLTAGE", 3}}, {"D_SUITABILITY"}, By::group, kFS1, 5},
      {70,
       {{"D_SUITABILITY", 600},
        {"N_ITER", 1},
        {"points/D_SUITABILITY", 200},
        {"points/Q_SUITABILITY", 2},
        {"points/M_VOLTAGE", 3}},
       {"points/D_SUITABILITY"},
       By::group,
       kFS1,
       5},
      {70,
       {{"Q_TRACKINIT", 1}, {"D_TRACKINIT", 800}},
       {"D_TRACKINIT"},
       By::group,
       with("70 { D_SUITABILITY 900 m, Q_SUITABILITY 2, M_VOLTAGE 3 }"),
       5},
      {72,
       {{"D_TEXTDISPLAY", 100}, {"L_TEXTDISPLAY", 100}, {"L_TEXT", 1}, {"text/X_TEXT", 65}},
       {"D_TEXTDISPLAY", "L_TEXTDISPLAY"}},
      {76, {{"D_TEXTDISPLAY", 100}, {"L_TEXTDISPLAY", 100}}, {"D_TEXTDISPLAY", "L_TEXTDISPLAY"}},
      {79,
       {{"NID_BG", 200},
        {"D_POSOFF", 50},
        {"Q_MPOSITION", 1},
        {"M_POSITION", 1000},
        {"N_ITER", 1},
        {"references/NID_BG", 200},
        {"references/D_POSOFF", 250},
        {"references/Q_MPOSITION", 1},
        {"references/M_POSITION", 5000}},
       {"D_POSOFF", "references/D_POSOFF"}},
  };
}

std::vector<Case> cases_of_places() {
  const std::string loop_ahead =
      "  given SR level 1\n  and drives at 20 km/h\n  and passes group 100\n    packet 134 { D_LOOP 0 m, L_LOOP 5000 "
      "m, "
      "Q_LOOPDIR 1 }\n  and drives for 10 m\n";
  const std::string loop4 =
      "  given config { srs 4.0.0 }\n  and SR level 1\n  and driver enters { V_sr_kmh 60 }\n  and drives at 50 km/h\n";
  return {
      {5,
       {{"D_LINK", 150},
        {"NID_BG", 101},
        {"Q_LINKREACTION", 1},
        {"Q_LOCACC", 5},
        {"N_ITER", 1},
        {"links/D_LINK", 150},
        {"links/NID_BG", 102},
        {"links/Q_LINKREACTION", 1},
        {"links/Q_LOCACC", 5}},
       {"D_LINK", "links/D_LINK"}},
      {13, {{"NID_BG", 100}, {"D_SR", 100}}, {"D_SR"}, By::loop, loop_ahead},
      {13,
       {{"NID_BG", 99}, {"D_SR", 50}, {"N_ITER", 1}, {"groups/NID_BG", 100}, {"groups/D_SR", 100}},
       {"groups/D_SR"},
       By::loop,
       loop_ahead},
      {41, {{"D_LEVELTR", 300}, {"M_LEVELTR", 0}, {"L_ACKLEVELTR", 100}}, {"D_LEVELTR", "L_ACKLEVELTR"}},
      {41,
       {{"D_LEVELTR", 300},
        {"M_LEVELTR", 1},
        {"NID_NTC", 9},
        {"N_ITER", 1},
        {"levels/M_LEVELTR", 0},
        {"levels/L_ACKLEVELTR", 100}},
       {"levels/L_ACKLEVELTR"}},
      {58,
       {{"T_CYCLOC", 255},
        {"D_CYCLOC", 150},
        {"M_LOC", 2},
        {"N_ITER", 1},
        {"locations/D_LOC", 120},
        {"locations/Q_LGTLOC", 1}},
       {"D_CYCLOC", "locations/D_LOC"},
       By::RBC,
       kFS2},
      {131, {{"D_RBCTR", 200}, {"NID_RBC", 2}, {"NID_RADIO", 0x0123456789FFFFFF}}, {"D_RBCTR"}, By::RBC, kFS2},
      {133, {{"Q_RIU", 1}, {"NID_RIU", 7}, {"D_INFILL", 100}, {"NID_BG", 101}}, {"D_INFILL"}},
      {134,
       {{"D_LOOP", 50}, {"L_LOOP", 50}, {"Q_LOOPDIR", 1}},
       {"D_LOOP", "L_LOOP"},
       By::group,
       loop4,
       300,
       {},
       24,
       loops},
  };
}

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const auto& part : {cases_of_authority(), cases_of_speeds(), cases_of_conditions(), cases_of_places()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

bool is_distance(const Field& f) { return variable(f.variable).at("resolution") == "Q_SCALE"; }

const Json& layout_of(const Case& c) {
  return c.NID_MESSAGE == 0 ? *find_message("to_train", c.number, "2.1") : *find_packet("to_train", c.number, "2.1");
}

Codes in_codes(const Case& c, std::uint64_t Q_SCALE) {
  Codes codes = c.codes;
  for (const Field& f : fields_of(layout_of(c).at("elements"))) {
    if (!is_distance(f)) continue;
    const auto given = codes.find(f.path);
    const std::uint64_t metres = given != codes.end() ? given->second : usual(f.variable, f.variable);
    if (metres != 32767) codes[f.path] = in_scale(metres, Q_SCALE);
  }
  codes["Q_SCALE"] = Q_SCALE;
  return codes;
}

/// All that is said and output, and in the end what is kept without power.
std::string journey(const Case& c, std::uint64_t Q_SCALE) {
  OnBoard unit(OnBoard::after(c.start));
  BitList bits;
  for (const auto& [id, codes] : c.beside) put_packet(bits, *find_packet("to_train", id, "2.1"), codes);
  const Codes codes = in_codes(c, Q_SCALE);
  Answer said;
  if (c.NID_MESSAGE == 0) {
    said = unit.receive(c.number, codes, bits);
  } else {
    put_packet(bits, layout_of(c), codes);
    said = c.by == By::RBC    ? unit.receive(c.NID_MESSAGE, {}, bits)
           : c.by == By::loop ? unit.receive_loop(loop_message(bits))
                              : unit.pass(200, bits, "2.1", {{"Q_LINK", 1}});
  }
  EXPECT_EQ(said.event({"not decoded"}), "") << c.number;
  EXPECT_EQ(said.event({"rejected"}), "") << c.number;
  std::string all = said.text();
  for (int cycle = 0; cycle < c.cycles; ++cycle) {
    if (c.act) all += c.act(unit, cycle);
    all += unit.run(1).text() + unit.line();
  }
  return all + unit.retained().dump();
}

TEST(LanguageThroughStep, DistancesInEachScale) {
  for (const Case& c : all_cases()) {
    const std::string in_metres = journey(c, 1);
    EXPECT_TRUE(journey(c, 0) == in_metres) << c.number << " in 0.1 m";
    EXPECT_TRUE(journey(c, 2) == in_metres) << c.number << " in 10 m";
    for (const std::string& field : c.fields) {
      Case longer = c;
      longer.codes.at(field) += 100;
      EXPECT_TRUE(journey(longer, 1) != in_metres) << c.number << " " << field << " is not seen";
    }
  }
}

TEST(LanguageThroughStep, EveryDistanceInEachScale) {
  std::set<std::string> seen;
  for (const Case& c : all_cases())
    for (const std::string& field : c.fields)
      seen.insert((c.NID_MESSAGE == 0 ? "message " : "packet ") + std::to_string(c.number) + " " + field);
  for (const char* list : {"packets", "messages"})
    for (const Json& row : reference(std::string(list) + "_to_train").at(list)) {
      const unsigned id = row.at("id");
      const bool packet = list[0] == 'p';
      if ((packet ? find_packet("to_train", id, "2.1") : find_message("to_train", id, "2.1")) != &row) continue;
      for (const Field& f : fields_of(row.at("elements")))
        if (is_distance(f)) {
          const std::string name = (packet ? "packet " : "message ") + std::to_string(id) + " " + f.path;
          EXPECT_TRUE(seen.contains(name)) << name;
        }
    }
}

}  // namespace
}  // namespace evc::through_step
