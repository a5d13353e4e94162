#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "io/diagnostic.h"
#include "realtime/clock.h"
#include "realtime/timing.h"
#include "run/answers.h"
#include "serve/conversation.h"

namespace evc::serve {

/// How the cycles of a session come, and what is added to their lines.
struct Manner {
  bool by_clock = false;                 ///< else by the times of the lines, as `evc replay`
  std::optional<std::int64_t> cycle_ms;  ///< with the clock: instead of `cycle_ms` of the configuration
  run::Printed printed = {};             ///< each cycle; with the advance display or the record of the display
  /// Gets the times of a session with the clock when it ends, in the thread of its unit; may be empty.
  std::function<void(const realtime::Timing&)> measured = {};
};

/// `{"error":"line 12 /odometer: found X, expected Y"}` with its end: what a session says last.
std::string error_line(io::Diagnostic error);

/// One session: a unit of its own answers the lines of a partner, cycle by cycle, until they end or one of them is
/// wrong, which is the last line that the partner gets; until the partner has gone, takes nothing, or a stop is
/// requested. Then the conversation is finished, whatever happened. Lines that have arrived later than a cycle of the
/// clock is due belong to a later one; the clock is that of their `arrived`.
void answer(Conversation& partner, const Manner& manner, realtime::Clock& clock, const std::stop_token& stop);

}  // namespace evc::serve
