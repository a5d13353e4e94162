#pragma once
#include <optional>
#include <string>
#include <vector>

#include "on_board.h"
#include "reference.h"

// How each packet and message reaches the on-board in a state in which it is accepted.
namespace evc::through_step {

inline constexpr const char* kFS1 = "  given FS level 1 with speed = 60 km/h\n";
inline constexpr const char* kSR1 = "  given SR level 1\n  and drives at 20 km/h\n";
inline constexpr const char* kSR2 = "  given SR level 2\n  and drives at 20 km/h\n  and passes group 100\n";
inline constexpr const char* kFS2 = "  given FS level 2 with speed = 60 km/h\n";

/// With a session with radio infill unit 7 in level 1.
inline constexpr const char* kInfillUnit =
    "  given SR level 1\n  and drives at 30 km/h\n  and passes group 100\n    packet 5 { D_LINK 2000 m, NID_BG 101, "
    "Q_LINKREACTION 2, Q_LOCACC 5 m }\n    packet 12 { L_ENDSECTION 2000 m }\n    packet 21 { G_A 0 }\n    packet 27 { "
    "V_STATIC 140 km/h }\n    packet 133 { Q_RIU 1, NID_C_RIU 1, NID_RIU 7, NID_RADIO \"0123456789FFFFFF\", D_INFILL "
    "50 m, "
    "NID_BG 101 }\n  and drives for 60 m\n  and session connected with RIU 7\n  and message 32 from RIU 7\n  and waits "
    "0.2 "
    "s\n";

enum class By : std::uint8_t { group, RBC, loop, RIU };
/// The start and the event that shows that it was accepted; nothing: "packet N
/// accepted", "message N accepted".
struct Way {
  By by = By::group;
  const char* start = kFS1;
  unsigned NID_MESSAGE = 24;
  std::vector<unsigned> before = {}, behind = {};  ///< packets that it needs beside it
  std::string says = {};
  Codes codes = {};  ///< usual ones
};
/// The same start with an RBC or radio infill unit of another system version.
std::string in_version(const std::string& start, const std::string& sv);
Way way_of_packet(unsigned NID_PACKET);
Way way_of_message(unsigned NID_MESSAGE);

/// What is said instead of the acceptance of a code with a meaning, of a packet ('P') or message ('M'); or nothing.
std::string said_instead(char of, unsigned number, const std::string& path, std::uint64_t code, const std::string& sv);

/// A message of the loop that is announced where packet 13 is accepted (8.4.3).
std::vector<std::uint8_t> loop_message(const BitList& packets);

/// Nothing where the telegram has no room for it.
std::optional<Answer> send_packet(unsigned NID_PACKET, const std::string& sv, const Codes& given, int wrong_length = 0);
Answer send_message(unsigned NID_MESSAGE, const Codes& given, int wrong_length = 0, const std::string& sv = "2.1");

}  // namespace evc::through_step
