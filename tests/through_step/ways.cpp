#include "ways.h"

#include <algorithm>
#include <regex>

namespace evc::through_step {
namespace {

constexpr const char* kSH1 = "  given SH level 1\n  and drives at 20 km/h\n";
/// Group 101 is announced: its infill is accepted.
constexpr const char* kLinked = "  given FS level 1 linked with link = 1000 m, reaction = 2\n";
/// Loop 0 is announced.
constexpr const char* kLoop =
    "  given SR level 1\n  and drives at 20 km/h\n  and passes group 100 { Q_LINK 0 }\n    packet 134 { D_LOOP 0 m, "
    "L_LOOP "
    "5000 m, Q_LOOPDIR 1 }\n  and drives for 10 m\n";
/// In an area of LS with the border to level 2 ahead.
constexpr const char* kLS1 =
    "  given FS level 1 with speed = 60 km/h\n  and passes group 110\n    packet 12 { L_ENDSECTION 3000 m }\n    "
    "packet 21 "
    "{ G_A 0 }\n    packet 27 { V_STATIC 140 km/h }\n    packet 80 { D_MAMODE 0 m, M_MAMODE 2, V_MAMODE 100 km/h, "
    "L_MAMODE "
    "2500 m, L_ACKMAMODE 0 m }\n  and waits 1 s\n  and driver acknowledges LS\n  and waits 1 s\n  then mode LS "
    "[5.9.3.1]\n";
constexpr const char* kBorder =
    "  given FS level 1 with speed = 60 km/h\n  and passes group 110\n    packet 41 { D_LEVELTR 2000 m, M_LEVELTR 3, "
    "L_ACKLEVELTR 0 m }\n  and waits 1 s\n";

/// In passive shunting (135 counts there only).
constexpr const char* kPS1 =
    "  given SH level 1\n  and signal { passive_shunting true }\n  and driver selects maintain_shunting\n  and waits "
    "0.2 "
    "s\n  and desk closed\n  and waits 0.5 s\n  and drives at 20 km/h\n  then mode PS [4.6.3(26)]\n";
/// Start of mission: the session is open, nothing else.
constexpr const char* kMission =
    "  given standing in SB\n  and driver enters { driver_id 1234 }\n  and driver enters { level 2 }\n  and driver "
    "enters { "
    "rbc { NID_C 1, NID_RBC 1, NID_RADIO \"FFFFFFFFFFFFFFFF\" } }\n  and waits 0.2 s\n  and session connected\n  and "
    "message "
    "32\n  and waits 0.2 s\n";
/// The driver has asked for shunting.
constexpr const char* kShunting =
    "  given RBC ready\n  and driver selects shunting\n  and waits 0.2 s\n  then sends message 130 [5.6.2.2]\n";
constexpr const char* kStops =
    "  given FS level 2\n  and message 15 { NID_EM 0, D_EMERGENCYSTOP 2500 m }\n  and message 15 { NID_EM 15, "
    "D_EMERGENCYSTOP 2500 m }\n  and waits 0.2 s\n";

/// Codes with a meaning that are answered otherwise than by acceptance.
struct Exception {
  char of;          ///< 'P'acket or 'M'essage
  unsigned number;  ///< 0: of each
  const char* path;
  std::vector<std::uint64_t> codes;  ///< none: each
  const char* says;
  bool version_1 = false;  ///< of system versions 1.0 and 1.1 only
};
constexpr const char* kWithoutTranslation = "not used [6.6.3.2.3]";  // [10], [12], [13]
const std::vector<Exception>& exceptions() {
  static const std::vector<Exception> rows{
      {'P', 0, "Q_DIR", {0}, "ignored: for the other direction [3.6.3.1.3]"},
      {'M', 0, "T_TRAIN", {}, "rejected [3.16.3.3.3]"},  // neither is later than that of the message before
      {'M', 27, "T_TRAIN_REF", {}, "refused [4.6.3]"},   // not the request that waits
      {'M', 28, "T_TRAIN_REF", {}, "refused [4.6.3]"},
      {'M', 15, "Q_DIR", {0}, "refused [3.6.3.1.3]"},
      {'M', 34, "Q_DIR", {0}, "refused [3.6.3.1.3]"},
      // The RBC does not initiate a session (3.5.3.1), in an open one still less.
      {'M', 38, "M_ACK", {}, "refused [4.8.3]"},
      {'M', 38, "NID_LRBG", {}, "refused [4.8.3]"},
      // Places need a group that the unit has reported (3.6.2.2.2).
      {'M', 3, "NID_LRBG", {}, "refused [3.6.2.2.2]"},
      {'M', 9, "NID_LRBG", {}, "refused [3.6.2.2.2]"},
      {'M', 15, "NID_LRBG", {}, "refused [3.6.2.2.2]"},
      {'M', 33, "NID_LRBG", {}, "refused [3.6.2.2.2]"},
      {'M', 34, "NID_LRBG", {}, "refused [3.6.2.2.2]"},
      {'M', 37, "NID_LRBG", {}, "refused [3.6.2.2.2]"},
      {'M', 45, "NID_LRBG", {}, "refused [3.4.2.3.3.8]"},
      // In rear of the train.
      {'M', 15, "D_REF", {0x8000}, "refused [3.10.2.2]"},
      {'M', 15, "D_EMERGENCYSTOP", {0}, "refused [3.10.2.2]"},
      // Only the group that linking announces (3.6.2.3.1).
      {'P', 136, "NID_BG", {}, "refused [3.6.2.3.1]"},
      {'P', 136, "NID_C", {}, "refused [3.6.2.3.1]"},
      {'P', 39, "M_TRACTION", {255}, kWithoutTranslation, true},
      {'P', 70, "Q_SUITABILITY", {0, 1}, kWithoutTranslation, true},
      {'P', 70, "M_AXLELOAD", {}, kWithoutTranslation, true},
      {'P', 70, "M_LOADINGGAUGE", {}, kWithoutTranslation, true},
      {'P', 70, "M_TRACTION", {255}, kWithoutTranslation, true},
      {'P', 140, "NID_OPERATIONAL", {0xFFFFFFFF}, kWithoutTranslation, true},
  };
  return rows;
}
}  // namespace

std::vector<std::uint8_t> loop_message(const BitList& packets) {
  BitList bits;
  for (const auto& [name, code] : std::vector<std::pair<const char*, std::uint64_t>>{
           {"Q_UPDOWN", 1}, {"M_VERSION", 33}, {"Q_MEDIA", 1}, {"NID_C", 1}, {"NID_LOOP", 0}})
    bits.put(code, variable(name).at("bits"));
  append(bits, packets);
  bits.put(255, 8);
  while (bits.size() % 8 != 0) bits.put(1, 1);
  return bits.bytes();
}

std::string in_version(const std::string& start, const std::string& sv) {
  if (sv == "2.1") return start;
  const std::string M_VERSION = sv == "1.0" ? "16" : sv == "1.1" ? "17" : "32";
  const std::string with = "version = " + sv + ", M_VERSION = " + M_VERSION;
  std::string text =
      std::regex_replace(start, std::regex("(given|and|when) message (\\d+)"), "$1 message $2 version " + sv);
  text = std::regex_replace(text, std::regex("message 32 version [.0-9]+( from RIU 7)?"),
                            "message 32$1 { M_VERSION " + M_VERSION + " }");
  text = std::regex_replace(text, std::regex("((given RBC ready)|([A-Z][A-Z] level 2))(?= with)"), "$1 with " + with);
  text = std::regex_replace(text, std::regex("((given RBC ready)|([A-Z][A-Z] level 2))\n"), "$1 with " + with + "\n");
  return std::regex_replace(text, std::regex(M_VERSION + " with "), M_VERSION + ", ");
}

Way way_of_packet(unsigned NID_PACKET) {
  switch (NID_PACKET) {
    case 0:    // a marker that no cover names: the group counts (3.15.9.3)
    case 200:  // is 0 (6.6.3.2.3 [15])
      return {.says = "packet 0 not used"};
    case 206:  // takes the place of 68 (6.6.3.2.3 [9]), 207 of 70 ([18]), 239 of 39 ([19])
      return {.says = "packet 68 accepted"};
    case 207:
      return {.says = "packet 70 accepted"};
    case 239:
      return {.says = "packet 39 accepted"};
    case 203:  // without the packet 3 that it is appended to (6.6.3.2.3 [16])
      return {.says = "packet 203 not used [6.6.3.2.3]"};
    case 13:
      return {.by = By::loop, .start = kLoop};
    case 15:
      return {.by = By::RBC, .start = kFS2, .NID_MESSAGE = 3};
    case 49:
    case 80:  // belongs to the authority (3.12.4.1, 3.8.4)
      return {.before = {12}};
    case 57:
    case 58:
    case 64:
    case 131:
    case 140:
      return {.by = By::RBC, .start = kFS2};
    case 63:
      return {.by = By::RBC, .start = kSR2, .NID_MESSAGE = 2};
    case 90:
      return {.start = kBorder};
    case 132:
      return {.start = kSH1};
    case 135:
      return {.start = kPS1};
    case 136:
      return {.start = kLinked, .behind = {12}, .codes = {{"NID_BG", 101}}};
    case 137:
      return {.start = kSR1};
    case 143:
      return {.by = By::RIU, .start = kInfillUnit};
    case 180:
      return {.start = kLS1};
    default:
      return {};
  }
}
Way way_of_message(unsigned NID_MESSAGE) {
  switch (NID_MESSAGE) {
    case 2:
    case 34:
      return {.start = kSR2};
    case 6:
      return {.start = "  given PT level 2\n"};
    case 15:
      return {.start = kFS2, .codes = {{"D_EMERGENCYSTOP", 2500}}};
    case 18:
      return {.start = kStops};
    case 27:
    case 28:
      return {.start = kShunting};
    case 33:
      return {.start = kFS2, .codes = {{"D_REF", 0}}};
    case 37:
      return {.by = By::RIU, .start = kInfillUnit};
    case 40:
    case 41:
    case 43:
      return {.start = kMission};
    case 45:  // the single balise has no direction (3.4.2.3.3.2)
      return {.start =
                  "  given SR level 2\n  and drives at 20 km/h\n  and passes group 90\n  and drives for 100 m\n  and "
                  "passes group 100 of 1 balise\n  and waits 1 s\n"};
    default:
      return {.start = kFS2};
  }
}

std::string said_instead(char of, unsigned number, const std::string& path, std::uint64_t code, const std::string& sv) {
  for (const Exception& e : exceptions())
    if (e.of == of && (!e.version_1 || sv[0] == '1') && (e.number == 0 || e.number == number) && e.path == path &&
        (e.codes.empty() || std::find(e.codes.begin(), e.codes.end(), code) != e.codes.end()))
      return e.says;
  return "";
}

std::optional<Answer> send_packet(unsigned NID_PACKET, const std::string& sv, const Codes& given, int wrong_length) {
  const Way way = way_of_packet(NID_PACKET);
  Codes codes = way.codes;
  if (NID_PACKET == 70 && sv[0] == '1') codes = {{"Q_SUITABILITY", 2}, {"M_TRACTION", 1}};  // 6.6.3.2.3 [12]
  for (const auto& [path, code] : given) codes[path] = code;
  BitList bits;
  for (const unsigned id : way.before) put_packet(bits, *find_packet("to_train", id, sv), {});
  put_packet(bits, *find_packet("to_train", NID_PACKET, sv), codes, wrong_length);
  for (const unsigned id : way.behind) put_packet(bits, *find_packet("to_train", id, sv), {});
  OnBoard unit(OnBoard::after(way.by == By::group ? way.start : in_version(way.start, sv)));
  if (way.by == By::group) {
    if (bits.size() > 830 - 50 - 8) return std::nullopt;
    return unit.pass(200, bits, sv);
  }
  if (way.by == By::loop) return unit.receive_loop(loop_message(bits));
  return unit.receive(way.NID_MESSAGE, {}, bits, sv, way.by == By::RIU);
}

Answer send_message(unsigned NID_MESSAGE, const Codes& given, int wrong_length, const std::string& sv) {
  const Way way = way_of_message(NID_MESSAGE);
  OnBoard unit(OnBoard::after(in_version(way.start, sv)));
  const Json& message = *find_message("to_train", NID_MESSAGE, sv);
  Codes codes = way.codes;
  if (NID_MESSAGE == 27 || NID_MESSAGE == 28) codes["T_TRAIN_REF"] = unit.last_sent(130, sv).codes.at("T_TRAIN");
  for (const auto& [path, code] : given) codes[path] = code;
  BitList bits;
  for (const Json& e : message.at("elements"))
    if (e.contains("packet")) {
      const unsigned id = e.at("packet");
      put_packet(bits, *find_packet("to_train", id, sv), id == 136 ? Codes{{"NID_BG", 101}} : Codes{});
    }
  codes.try_emplace("T_TRAIN", static_cast<std::uint64_t>(unit.t_ms() / 10));
  BitList whole = message_bits(message, codes, bits);
  whole.replace(8, static_cast<std::uint64_t>(static_cast<int>(whole.size() / 8) + wrong_length), 10);
  return unit.receive(whole.bytes(), way.by == By::RIU);
}

}  // namespace evc::through_step
