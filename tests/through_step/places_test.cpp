#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "ways.h"

// Places and times that the outputs show by what begins or ends there: the distance run, the time gone.
namespace evc::through_step {
namespace {

/// Whether it has happened; `said` are the events and messages of the cycle.
using Happened = std::function<bool(const Answer& said, OnBoard& unit)>;

Happened event(const std::string& text) {
  return [text](const Answer& said, OnBoard&) { return !said.event({text}).empty(); };
}
Happened sends(unsigned NID_MESSAGE) {
  return [NID_MESSAGE](const Answer& said, OnBoard&) {
    return std::any_of(said.sent.begin(), said.sent.end(), [&](const auto& m) { return m[0] == NID_MESSAGE; });
  };
}
Happened shows(const std::string& pointer, const std::string& text, bool shown = true) {
  return [=](const Answer&, OnBoard& unit) {
    const Json list = unit.output(false)[Json::json_pointer(pointer)];
    return (std::find(list.begin(), list.end(), text) != list.end()) == shown;
  };
}
Happened calls() {
  return [](const Answer&, OnBoard& unit) { return !unit.output(false)["radio_connect"].is_null(); };
}

struct Place {
  const char* path;
  Happened until;
  unsigned NID_PACKET = 0;
  Codes codes = {};
  const char* start = kFS1;
  unsigned NID_MESSAGE = 0;
  double sign = 1.0;  ///< -1: the greater the code the earlier
};

/// Metres and seconds from the packet on.
std::pair<double, double> run(const Place& p, std::uint64_t code, std::uint64_t Q_SCALE) {
  OnBoard unit(OnBoard::after(p.start));
  const Json& row = p.NID_PACKET != 0 ? *find_packet("to_train", p.NID_PACKET, "2.1")
                                      : *find_message("to_train", p.NID_MESSAGE, "2.1");
  Codes codes;
  for (const Field& f : fields_of(row.at("elements"))) {
    if (f.path == "Q_SCALE") codes["Q_SCALE"] = Q_SCALE;
    const auto given = p.codes.find(f.path);
    if (given == p.codes.end() && variable(f.variable).at("resolution") != "Q_SCALE") continue;
    const std::uint64_t value = given != p.codes.end() ? given->second : usual(f.variable, f.path);
    codes[f.path] =
        variable(f.variable).at("resolution") == "Q_SCALE" && value != 32767 ? in_scale(value, Q_SCALE) : value;
  }
  for (const auto& [path, value] : p.codes) codes.try_emplace(path, value);
  codes[p.path] = code;
  BitList bits;
  if (p.NID_PACKET == 80) put_packet(bits, *find_packet("to_train", 12, "2.1"), {});
  if (p.NID_PACKET != 0) put_packet(bits, row, codes);
  const double from = unit.front();
  const std::int64_t t = unit.t_ms();
  Answer said = p.NID_MESSAGE == 0 ? unit.pass(200, bits)
                                   : unit.receive(p.NID_MESSAGE, p.NID_PACKET == 0 ? codes : Codes{}, bits);
  for (int cycle = 0; cycle < 400; ++cycle) {
    said = unit.run(1);
    if (p.until(said, unit)) return {unit.front() - from, static_cast<double>(unit.t_ms() - t) / 1000.0};
  }
  return {-1.0, -1.0};
}

TEST(LanguageThroughStep, PlacesThatAreReached) {
  const std::vector<Place> places{
      {"D_LEVELTR", event("level 1->0"), 41, {{"M_LEVELTR", 0}}},
      {"L_ACKLEVELTR", shows("/driver/requests", "level"), 41, {{"M_LEVELTR", 0}, {"D_LEVELTR", 300}}, kFS1, 0, -1.0},
      {"D_ADHESION", shows("/driver/symbols", "ST02"), 71, {{"L_ADHESION", 300}, {"M_ADHESION", 0}}},
      {"L_ADHESION", shows("/driver/symbols", "ST02", false), 71, {{"D_ADHESION", 0}, {"M_ADHESION", 0}}},
      {"D_TEXTDISPLAY", shows("/driver/texts", "Acknowledgement"), 76, {{"Q_TEXT", 1}}},
      {"L_TEXTDISPLAY", shows("/driver/texts", "Acknowledgement", false), 76, {{"Q_TEXT", 1}, {"D_TEXTDISPLAY", 0}}},
      {"D_VALIDNV", event("national values in force"), 3, {}},
      {"D_INFILL", calls(), 133, {{"Q_RIU", 1}, {"NID_RIU", 7}, {"NID_BG", 101}}},
      {"D_CYCLOC", sends(136), 58, {{"T_CYCLOC", 255}, {"M_LOC", 2}}, kFS2, 24},
      {"locations/D_LOC",
       sends(136),
       58,
       {{"T_CYCLOC", 255}, {"D_CYCLOC", 32767}, {"M_LOC", 2}, {"N_ITER", 1}},
       kFS2,
       24},
      {"D_TAFDISPLAY", shows("/driver/symbols", "DR02"), 0, {{"L_TAFDISPLAY", 300}}, kSR2, 34},
      {"L_TAFDISPLAY", shows("/driver/symbols", "DR02", false), 0, {{"D_TAFDISPLAY", 0}}, kSR2, 34},
      {"L_ACKMAMODE",
       shows("/driver/requests", "OS"),
       80,
       {{"D_MAMODE", 350}, {"L_MAMODE", 200}, {"V_MAMODE", 20}},
       kFS1,
       0,
       -1.0},
  };
  for (const Place& p : places) {
    std::optional<double> offset;
    for (const auto& [metres, Q_SCALE] :
         std::vector<std::pair<std::uint64_t, std::uint64_t>>{{200, 0}, {230, 1}, {200, 2}}) {
      const double found = run(p, in_scale(metres, Q_SCALE), Q_SCALE).first;
      ASSERT_GT(found, 0.0) << p.path << " " << metres << " m, Q_SCALE " << Q_SCALE;
      const double from = found - p.sign * static_cast<double>(metres);
      if (!offset) offset = from;
      EXPECT_NEAR(from, *offset, 1.7) << p.path << " " << metres << " m, Q_SCALE " << Q_SCALE;  // one cycle
    }
  }
}

constexpr const char* kFar = "  given FS level 2 with authority = 5200 m, speed = 140 km/h\n";
/// A section timer of 30 s has begun.
constexpr const char* kTimer =
    "  given FS level 2\n  and message 3\n    packet 15 { L_ENDSECTION 3000 m, Q_SECTIONTIMER 1, T_SECTIONTIMER 30 s, "
    "D_SECTIONTIMERSTOPLOC 2900 m }\n  and waits 0.2 s\n";

TEST(LanguageThroughStep, TimesInSeconds) {
  const std::vector<Place> times{
      {"T_TEXTDISPLAY", shows("/driver/texts", "Acknowledgement", false), 76, {{"Q_TEXT", 1}}},
      {"T_TEXTDISPLAY", shows("/driver/texts", "A", false), 72, {{"L_TEXT", 1}, {"text/X_TEXT", 65}}},
      {"T_SECTIONTIMER", event("MA timer elapsed"), 12, {{"Q_SECTIONTIMER", 1}, {"D_SECTIONTIMERSTOPLOC", 2900}}},
      {"T_ENDTIMER", event("MA timer elapsed"), 12, {{"Q_ENDTIMER", 1}, {"D_ENDTIMERSTARTLOC", 2900}}},
      {"T_OL", event("MA timer elapsed"), 12, {{"Q_OVERLAP", 1}, {"D_STARTOL", 2900}, {"D_OL", 100}}},
      {"T_EMA", event("MA timer elapsed"), 12, {{"V_EMA", 10}}},
      {"T_CYCLOC", sends(136), 58, {{"D_CYCLOC", 32767}, {"M_LOC", 2}}, kFS2, 24},
      {"T_NVCONTACT", shows("/brake_reasons", "T_NVCONTACT"), 3, {{"M_NVCONTACT", 1}}, kFS2, 24},
      {"T_TIMEOUTRQST", sends(132), 57, {{"T_MAR", 255}, {"T_CYCRQST", 255}}, kTimer, 24, -1.0},
  };
  for (const Place& p : times) {
    std::optional<double> offset;
    for (const std::uint64_t seconds : {5u, 8u, 20u}) {
      const double found = run(p, seconds, 1).second;
      EXPECT_GT(found, 0.0) << p.path << " " << seconds;
      const double from = found - p.sign * static_cast<double>(seconds);
      if (!offset) offset = from;
      EXPECT_NEAR(from, *offset, 0.11) << p.path << " " << seconds;
      if (p.sign < 0) continue;
      EXPECT_NEAR(from, 0.0, 10.0) << p.path << " " << seconds;  // some begin where the train passes a place
    }
  }
}

/// The perturbation location lies T_MAR at the warning speed, 140 km/h and 5 km/h, in rear (3.13.11.3).
TEST(LanguageThroughStep, TimeBeforeThePerturbationLocation) {
  const Place request{"T_MAR", sends(132), 57, {{"T_TIMEOUTRQST", 1023}, {"T_CYCRQST", 255}}, kFar, 24, -1.0};
  std::optional<double> offset;
  for (const std::uint64_t seconds : {30u, 25u, 20u}) {
    const double found = run(request, seconds, 1).first + 145.0 / 3.6 * static_cast<double>(seconds);
    if (!offset) offset = found;
    EXPECT_NEAR(found, *offset, 4.0) << seconds;  // one cycle
  }
}

/// T_TRAIN in steps of 10 ms, of the clock on board: that of the messages sent, and of those received what counts for
/// T_NVCONTACT.
TEST(LanguageThroughStep, TrainborneClock) {
  BitList now;
  put_packet(now, *find_packet("to_train", 58, "2.1"), {{"T_CYCLOC", 255}, {"D_CYCLOC", 32767}});
  OnBoard unit(OnBoard::after(kFS2));
  const auto stamp = [&] {
    const Answer answer = unit.receive(24, {}, now);
    return answer.sent.empty() ? 0 : decode_to_track(answer.sent.back(), "2.1").codes.at("T_TRAIN");
  };
  const auto t = static_cast<std::uint64_t>(unit.t_ms() / 10);
  const std::uint64_t first = stamp();
  EXPECT_GE(first, t);
  EXPECT_LE(first, t + 20);  // in the second cycle of 100 ms at the latest
  unit.run(37);
  EXPECT_EQ(stamp(), first + 390);
  std::optional<double> whole;
  for (const std::uint64_t late_cs : {0u, 130u, 500u}) {
    OnBoard waiting(OnBoard::after("  given config { national_values { M_NVCONTACT 1, T_NVCONTACT 20 } }\n" +
                                   std::string(kFS2) + "  and waits 10 s\n"));
    waiting.receive(24, {{"T_TRAIN", static_cast<std::uint64_t>(waiting.t_ms() / 10) - late_cs}}, {});
    int cycles = 0;
    const Happened brakes = shows("/brake_reasons", "T_NVCONTACT");
    while (cycles < 300 && !brakes(waiting.run(1), waiting)) ++cycles;
    const double seconds = 0.1 * cycles + 0.01 * static_cast<double>(late_cs);
    if (!whole) whole = seconds;
    EXPECT_NEAR(seconds, *whole, 0.11) << late_cs;
    EXPECT_NEAR(seconds, 20.0, 0.5) << late_cs;
  }
}

/// The slope of a default gradient (packet 141) is that of a profile (packet 21): the same Indication limit.
TEST(LanguageThroughStep, DefaultGradient) {
  double level = 0.0;
  for (const std::uint64_t code : {0u, 10u, 60u}) {
    const auto V_I = [&](const std::string& start, const std::vector<std::pair<unsigned, Codes>>& packets) {
      OnBoard unit(OnBoard::after(start));
      BitList bits;
      for (const auto& [id, codes] : packets) put_packet(bits, *find_packet("to_train", id, "2.1"), codes);
      unit.pass(200, bits, "2.1", {{"Q_LINK", 1}});
      unit.run(30);
      return unit.output(false)["V_I"].get<double>();
    };
    const std::pair<unsigned, Codes> tsr{65, {{"D_TSR", 900}, {"L_TSR", 500}, {"V_TSR", 4}}};
    const double by_default = V_I("  given SR level 1\n  and driver enters { V_sr_kmh 100 }\n  and drives at 60 km/h\n",
                                  {tsr, {141, {{"Q_GDIR", 0}, {"G_TSR", code}}}});
    const double by_profile =
        V_I(kFS1, {{12, {{"V_MAIN", 20}}}, {21, {{"Q_GDIR", 0}, {"G_A", code}}}, {27, {{"V_STATIC", 20}}}, tsr});
    EXPECT_NEAR(by_default, by_profile, 0.01) << code;
    if (code == 0) level = by_default;
    EXPECT_EQ(by_default<level - 1.0, code> 0) << code;
  }
}

TEST(LanguageThroughStep, LinkingDistances) {
  for (const std::uint64_t Q_SCALE : {0u, 1u, 2u}) {
    OnBoard unit(OnBoard::after(kFS1));
    BitList bits;
    put_packet(bits, *find_packet("to_train", 5, "2.1"),
               {{"Q_SCALE", Q_SCALE}, {"D_LINK", in_scale(150, Q_SCALE)}, {"NID_BG", 101}, {"Q_LOCACC", 5}});
    unit.pass(200, bits, "2.1", {{"Q_LINK", 1}});
    const double from = unit.group();
    for (int cycle = 0; cycle < 400 && unit.front() < from + 148.0; ++cycle) unit.run(1);
    ASSERT_GE(unit.front(), from + 148.0) << Q_SCALE;
    EXPECT_NE(unit.pass(101, {}, "2.1", {{"Q_LINK", 1}}).event({"linking BG 101 ok"}), "") << Q_SCALE;
  }
}

}  // namespace
}  // namespace evc::through_step
