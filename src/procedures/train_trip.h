#pragma once
#include <cstdint>
#include <optional>

#include "procedures/effects.h"
#include "terms/level.h"
#include "terms/mode.h"

// Train trip, SUBSET-026-5 5.11, from the entry to TR until PT is left.
namespace evc::procedures::train_trip {

enum class Step : std::uint8_t {
  S010,  // no trip
  S050,  // TR: waits for standstill
  S060,  // TR: asks for the acknowledgement
  S120,  // PT: waits until the RBC recognises the exit from trip
  S121,  // PT: the RBC did not, the session is terminated; left only by override, a new session or another level (C36)
  S130,  // PT: waits until emergency stops are revoked
  S140,  // PT: offers start and shunting
  S150,  // PT: waits for the RBC's answer to the MA request
  S160,  // PT: SR is acknowledged
  S170,  // PT: waits for the acknowledgement of OS, LS or SH
};

struct State {
  Step step = Step::S010;
  Mode profile = Mode::OS;  // S170: the mode to acknowledge
  Repetition repetition;
};

struct Inputs {
  Duration now{};
  Mode mode = Mode::SB;
  Level level = Level::L0;
  bool desk_open = false;
  bool standstill = false;
  bool session_open = false;
  bool train_data_valid = false;
  bool exit_recognised = false;         // 6, in this cycle
  bool emergency_stop_pending = false;  // accepted, neither revoked nor deleted
  bool selects_start = false;
  bool SR_authorised = false;            // 2, in this cycle
  std::optional<Mode> profile_at_front;  // as in start_of_mission
};

/// One cycle, after the mode transition. The acknowledgement asked for in S060 becomes [7], [62], [63] or [68] in
/// observe(); the table 4.10 deletes data on entry to TR and PT. With the desk closed the driver is asked for nothing,
/// and the train stays in TR (4.4.13.1.6).
Effects step(State& state, const Inputs& inputs);

/// 4.8.4 [1], level 2/3 in PT: the RBC has recognised the exit from trip.
constexpr bool exit_recognised(const State& state) {
  return state.step == Step::S130 || state.step == Step::S140 || state.step == Step::S150 || state.step == Step::S160 ||
         state.step == Step::S170;
}

}  // namespace evc::procedures::train_trip
