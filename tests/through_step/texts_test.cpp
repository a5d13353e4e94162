#include <gtest/gtest.h>

#include "ways.h"

// The conditions of plain and fixed texts by mode and level (packets 72 and 76, 3.12.3.4): each code in each state.
namespace evc::through_step {
namespace {

constexpr std::uint64_t kModes[] = {0, 1, 2, 4, 6, 7, 8, 12, 14, 15};  // 15: no condition
constexpr std::uint64_t kLevels[] = {0, 1, 2, 3, 4, 5};                // 5: no condition

std::string in_area(unsigned M_MAMODE, const char* name) {
  return std::string(kFS2) +
         "  and message 3\n    packet 15 { L_ENDSECTION 4000 m }\n    packet 80 { D_MAMODE 0 m, M_MAMODE " +
         std::to_string(M_MAMODE) +
         ", V_MAMODE 80 km/h, L_MAMODE 3000 m, L_ACKMAMODE 0 m }\n  and waits 0.5 s\n  and driver acknowledges " +
         name + "\n  and waits 0.5 s\n  then mode " + name + " [4.6.3]\n";
}
const std::string kRV2 =
    "  given FS level 2\n  and message 24\n    packet 138 { D_STARTREVERSE 0 m, L_REVERSEAREA 800 m }\n    packet 139 "
    "{ "
    "D_REVERSE 700 m, V_REVERSE 30 km/h }\n  and stops\n  and waits 1 s\n  and signal { direction_controller backward "
    "}\n  and waits 0.5 s\n  and driver acknowledges RV\n  and waits 0.2 s\n  then mode RV [4.6.3(59)]\n";
const std::string kUN = "  given UN level 0\n  and drives at 20 km/h\n";
std::string in_level(const char* order, const char* level) {
  return std::string(kFS1) + "  and passes group 110\n    packet 41 { D_LEVELTR 32767, M_LEVELTR " + order +
         " }\n  and waits 0.2 s\n  then level " + level + " [5.10.1.5]\n";
}
const std::string kTrip = "  given message 16 { NID_EM 3 }\n  and waits 0.3 s\n  then mode TR [4.6.3(20)]\n";
const std::string kToSR =
    "  given driver selects start\n  and waits 0.2 s\n  and message 2 { D_SR unknown }\n  and waits 0.2 s\n  and "
    "driver "
    "acknowledges SR\n  and waits 0.2 s\n  then mode SR [4.6.3]\n";
std::string to_level(const char* M_LEVELTR) {
  return std::string("  given passes group 320\n    packet 41 { D_LEVELTR 32767, M_LEVELTR ") + M_LEVELTR +
         " }\n  and waits 0.3 s\n  then level not NTC [5.10.1.5]\n";
}

struct State {
  std::uint64_t code;
  std::string start;
  bool by_RBC = true;
  std::string leave = {};  ///< nothing: no text outlives the end of it
};
std::vector<State> modes() {
  return {{0, kFS2, true, kTrip},
          {1, in_area(0, "OS"), true, kTrip},
          {2, kSR2, true, kTrip},
          {4, kUN, false, to_level("2")},
          {6, "  given RBC ready\n", true, kToSR},
          {7, "  given TR level 2\n", true, "  given waits 1 s\n  and driver acknowledges trip\n  and waits 0.2 s\n"},
          {8, "  given PT level 2\n  and message 6\n  and message 18 { NID_EM 3 }\n  and waits 0.2 s\n", true, kToSR},
          {12, in_area(2, "LS"), true, kTrip},
          {14, kRV2}};
}
std::vector<State> levels() {
  return {{0, kUN, false, to_level("2")},
          {2, kFS1, false, to_level("0")},
          {3, kFS2, true, to_level("2")},
          {4, in_level("4", "3"), false, to_level("2")}};
}

Codes text_of(unsigned NID_PACKET) {
  Codes codes{{"Q_DIR", 2}, {"D_TEXTDISPLAY", 32767}};
  if (NID_PACKET == 72)
    codes.insert({{"L_TEXT", 1}, {"text/X_TEXT", 65}});
  else
    codes.insert({"Q_TEXT", 1});
  return codes;
}
/// Whether the text of that packet is shown.
bool shows(OnBoard& unit, unsigned NID_PACKET) {
  const Json texts = unit.output(false)["driver"]["texts"];
  const char* text = NID_PACKET == 72 ? "A" : "Acknowledgement";
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}
bool shown_in(const State& state, unsigned NID_PACKET, const Codes& start) {
  OnBoard unit(OnBoard::after(state.start));
  Codes codes = text_of(NID_PACKET);
  for (const auto& [path, code] : start) codes[path] = code;
  BitList bits;
  put_packet(bits, *find_packet("to_train", NID_PACKET, "2.1"), codes);
  const Answer said = state.by_RBC ? unit.receive(24, {}, bits) : unit.pass(310, bits);
  EXPECT_NE(said.event({"packet " + std::to_string(NID_PACKET) + " accepted"}), "") << state.start << said.text();
  unit.run(1);
  return shows(unit, NID_PACKET);
}

TEST(LanguageThroughStep, StartOfATextByMode) {
  for (const unsigned id : {72u, 76u})
    for (const State& state : modes())
      for (const std::uint64_t code : kModes)
        EXPECT_EQ(shown_in(state, id, {{"M_MODETEXTDISPLAY_START", code}}), code == state.code || code == 15)
            << id << " mode " << state.code << " start " << code;
}

TEST(LanguageThroughStep, StartOfATextByLevel) {
  for (const unsigned id : {72u, 76u})
    for (const State& state : levels())
      for (const std::uint64_t code : kLevels) {
        Codes start{{"M_LEVELTEXTDISPLAY_START", code}};
        if (code == 1) start["NID_NTC_START"] = 7;
        EXPECT_EQ(shown_in(state, id, start), code == state.code || code == 5)
            << id << " level " << state.code << " start " << code;
      }
}

/// Shown until the state is left, or beyond.
void check_end(const State& state, const std::string& end, bool ends) {
  for (const unsigned id : {72u, 76u}) {
    if (id == 76 && !ends) continue;  // each is a whole journey
    const std::string packet = "    packet " + std::to_string(id) + " { Q_DIR 2, D_TEXTDISPLAY 32767, " + end +
                               (id == 72 ? ", text \"A\" }\n" : ", Q_TEXT 1 }\n");
    const std::string with_text = state.start + (state.by_RBC ? "  given message 24\n" : "  given passes group 310\n") +
                                  packet + "  and waits 0.2 s\n";
    OnBoard before(OnBoard::after(with_text));
    before.run(1);
    EXPECT_TRUE(shows(before, id)) << id << " " << end << "\n" << state.start;
    OnBoard after(OnBoard::after(with_text + state.leave));
    after.run(1);
    EXPECT_EQ(shows(after, id), !ends) << id << " " << end << "\n" << state.start;
  }
}

/// The code of the state, another one, and that of no condition.
TEST(LanguageThroughStep, EndOfATextByMode) {
  for (const State& state : modes()) {
    if (state.leave.empty()) continue;
    for (const std::uint64_t code : {state.code, std::uint64_t{state.code == 2 ? 0u : 2u}, std::uint64_t{15}})
      check_end(state, "M_MODETEXTDISPLAY_END " + std::to_string(code), code == state.code);
  }
}

TEST(LanguageThroughStep, EndOfATextByLevel) {
  for (const State& state : levels())
    for (const std::uint64_t code : {state.code, std::uint64_t{state.code == 2 ? 3u : 2u}, std::uint64_t{5}})
      check_end(state, "M_LEVELTEXTDISPLAY_END " + std::to_string(code), code == state.code);
}

/// Level NTC is that of one national system. Texts are refused there (4.8.3) and deleted in SN (4.10): they come
/// before, in TR.
TEST(LanguageThroughStep, TextsInLevelNTC) {
  const std::string into =
      "  given passes group 320\n    packet 41 { D_LEVELTR 32767, M_LEVELTR 1, NID_NTC 7 }\n"
      "  and waits 0.2 s\n  then level NTC [5.10.1.5]\n";
  for (const unsigned id : {72u, 76u})
    for (const unsigned NID_NTC : {7u, 8u}) {
      const auto start = [&](const char* condition) {
        return "  given national_system { available [ 7 ] }\n  and TR level 1\n  and drives at 5 km/h\n" +
               std::string("  and passes group 310\n    packet ") + std::to_string(id) +
               " { Q_DIR 2, D_TEXTDISPLAY 32767, M_LEVELTEXTDISPLAY_" + condition + " " + std::to_string(NID_NTC) +
               (id == 72 ? ", text \"A\" }\n" : ", Q_TEXT 1 }\n") + "  and waits 0.2 s\n";
      };
      const auto shown_after = [&](const std::string& statements) {
        OnBoard unit(OnBoard::after(statements));
        unit.run(1);
        return shows(unit, id);
      };
      EXPECT_FALSE(shown_after(start("START 1, NID_NTC_START"))) << id << " " << NID_NTC;
      EXPECT_EQ(shown_after(start("START 1, NID_NTC_START") + into), NID_NTC == 7) << id << " " << NID_NTC;
      EXPECT_TRUE(shown_after(start("END 1, NID_NTC_END") + into)) << id << " " << NID_NTC;
      EXPECT_EQ(shown_after(start("END 1, NID_NTC_END") + into + to_level("2")), NID_NTC == 8) << id << " " << NID_NTC;
    }
}

}  // namespace
}  // namespace evc::through_step
