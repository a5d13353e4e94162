#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/location.h"
#include "base/units.h"
#include "terms/level.h"
#include "terms/mode.h"

namespace evc::track {

/// A text message (packets 72, 76; 3.12.3) with the state of its display.
struct Text {
  std::uint8_t Q_TEXTCLASS = 0;  ///< 0 auxiliary, 1 important
  bool all_parts = false;        ///< Q_TEXTDISPLAY: all start (end) parts have to be fulfilled together
  std::optional<Place> start_at;
  std::optional<Mode> start_mode;    ///< absent: not limited by the mode
  std::optional<Level> start_level;  ///< absent: not limited by the level
  std::optional<Place> end_at;
  std::optional<Duration> T_TEXTDISPLAY;
  std::optional<Mode> end_mode;
  std::optional<Level> end_level;
  std::uint8_t start_NTC = 0, end_NTC = 0;
  std::uint8_t Q_TEXTCONFIRM = 0;  ///< 0 none, 1 acknowledge, 2 and service brake, 3 and emergency brake
  bool ack_and_end = false;        ///< Q_CONFTEXTDISPLAY: the acknowledgement alone does not end it
  bool report = false;             ///< Q_TEXTREPORT
  std::uint8_t NID_TEXTMESSAGE = 0;
  std::uint16_t NID_C = 0, NID_RBC = 0;
  std::optional<std::uint8_t> Q_TEXT;  ///< the fixed text; absent for plain text
  std::uint8_t length = 0;
  std::array<char, 255> characters{};  ///< ISO 8859-1, not terminated

  enum class State : std::uint8_t { waiting, shown, ended };
  State state = State::waiting;
  bool acknowledged = false;
  bool in_end_mode = false, in_end_level = false;  ///< since it was received: leaving them is an end
  bool end_place_passed = false, end_time_over = false, end_mode_left = false, end_level_left = false;  ///< latched
  Duration shown_since{};
  std::uint8_t id = 0;  ///< assigned on board, to identify the text at the driver interface
  Anchor anchor{};
  friend constexpr bool operator==(const Text&, const Text&) = default;
};

}  // namespace evc::track
