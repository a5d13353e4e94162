#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "io/input_stream.h"
#include "io/input_writer.h"
#include "io/output_lines.h"
#include "realtime/clock.h"
#include "realtime/exchange.h"
#include "realtime/timing.h"
#include "run/display_lists.h"
#include "run/journey.h"
#include "run/on_board.h"
#include "run/progress.h"
#include "sim/world.h"

namespace evc::run {

/// The complete files of a run.
struct Records {
  std::string inputs, outputs, trace = io::trace_header();
};

/// Keeps what every cycle of a run had and gave. `inputs.jsonl` begins with the configuration of the on-board.
class Recorder {
 public:
  /// Whether a terminal shows how far the run has come.
  enum class Shows : std::uint8_t { nothing, progress };
  /// `displays`: where the display of each cycle is kept too; none for a run without a report.
  Recorder(const sim::World& world, Journey& journey, const io::Configuration& configuration,
           DisplayLists* displays = nullptr, Shows shows = Shows::progress)
      : world_(world), journey_(journey), writer_(configuration), displays_(displays) {
    if (shows == Shows::progress) progress_.emplace("driving");
  }
  void add(const sim::CycleInputs& inputs, const kernel::Outputs& outputs, const Truth& truth);
  Records& records() { return records_; }

  bool keeps_displays() const { return displays_ != nullptr; }
  /// The record of the display after the cycle of `inputs`.
  void show(const sim::CycleInputs& inputs, const kernel::Display& record) {
    displays_->add(inputs.t_ms, record, inputs.levels.driver);
  }

 private:
  const sim::World& world_;
  Journey& journey_;
  io::InputWriter writer_;
  DisplayLists* displays_;
  Records records_;
  std::optional<Progress> progress_;
};

/// Drives to the end, or until `stopped` says so, which is asked after each cycle: the world waits for the on-board and
/// the on-board for the world.
void drive(sim::World& world, OnBoard& on_board, Recorder& recorder, const std::function<bool()>& stopped = {});

/// Brake orders have to come within 1 s (SUBSET-041 5.2.1.1, 5.2.1.6, 5.2.1.13). A unit that begins a cycle later than
/// that does not supervise any more: it has failed (4.4.5).
inline constexpr realtime::Nanoseconds kLatestCycle = std::chrono::seconds(1);

/// What a run in real time measures in addition.
struct RealTime {
  std::int64_t cycle_ms = 0;
  realtime::Timing timing;
  realtime::Times age;               ///< of the inputs of a cycle at its begin, since they were offered
  std::uint64_t without_inputs = 0;  ///< cycles that began before the world had made their inputs
  std::uint64_t lost = 0;            ///< cycles that are missing in the records
};

/// The hand-over between the world and the on-board.
struct Exchange : realtime::Exchange<sim::CycleInputs, kernel::Outputs> {
  /// More than a second of cycles of 10 ms: an outside that does not take results for so long has failed.
  Exchange() : realtime::Exchange<sim::CycleInputs, kernel::Outputs>(128) {}
};

/// Drives by the clock: the on-board in a thread of its own, once in each period, with what the world has made by then.
/// Until the world has ended, or `stopped` says so, which is asked after each cycle, also when the world never makes
/// its inputs in time. `twin`: a unit as `on_board` at power-up, for a recorder that keeps the display: outside the
/// thread it gets the same inputs, and so has the same record, without a call in the cycles that are by the clock.
RealTime drive_in_real_time(sim::World& world, OnBoard& on_board, Recorder& recorder, std::int64_t cycle_ms,
                            realtime::Clock& clock, Exchange& exchange, const std::function<bool()>& stopped,
                            OnBoard* twin = nullptr);

}  // namespace evc::run
