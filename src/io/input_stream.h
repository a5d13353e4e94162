#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "io/json.h"
#include "io/output_lines.h"
#include "io/train_file.h"
#include "kernel/evc.h"
#include "sim/cycle_inputs.h"

namespace evc::io {

/// The `config` of a stream of inputs.
struct Configuration {
  std::int64_t cycle_ms = 100;
  SrsVersion srs = SrsVersion::v3_6_0;
  Train train;
  train::NationalValues national_values;
  std::array<bool, kLevels> levels{true, true, true, true, true};
  Distance L_engine = kernel::Config{}.L_engine;
  int cabs = 2;                         ///< with one there is no cab B
  bool cold_movement_detection = true;  ///< fitted; if not, nobody knows whether the engine was moved (3.15.8)
  port::Identity identity;
  std::optional<kernel::RbcAddress> contact = std::nullopt;
  InplaceVector<std::uint32_t, 16> networks;
  ByTrain by_train;
  Speed dial = kernel::Config{}.dial;
  NationalSystemNames ntc_names = {};
  std::optional<std::uint8_t> terminals = std::nullopt;  // as given
  std::int16_t local_time_offset_min = 0;
  std::string document = "{}";  // as read, on one line

  kernel::Config for_kernel() const;
};

/// Reads the object of `config`, from a separate file or from the first line of a stream.
Result<Configuration> read_configuration(std::string_view text, const std::string& file);

/// Reads a stream of inputs cycle by cycle. A cycle consumes every input with `t_ms` up to its own time; there is a
/// cycle every `cycle_ms` from 0 until the last input is consumed. If one cycle has two reports of the radio session,
/// the second one and the radio messages after it are delivered in the next cycle: none is lost.
class InputStream {
 public:
  /// Stores the next line, without its end, in the argument; false at the end.
  using NextLine = std::function<bool(std::string&)>;
  /// Radio inputs in order: messages and reports of the bearer.
  struct Report {
    RadioLink link = RadioLink::unchanged;
    std::optional<kernel::RbcIdentity> with;
    bool infill_unit = false;
  };
  using Radio = std::deque<std::variant<sim::CycleInputs::RadioMessage, Report>>;

  /// `given` replaces a `config` in the stream.
  static Result<InputStream> open(std::string file, NextLine next_line, std::optional<Configuration> given = {});

  /// Cycles by a clock: the time of a line is that of its arrival, and its `t_ms`, which may be absent, is not looked
  /// at; nor is `end`. No line means none yet. Every call of `next` gives a cycle, with the lines that are there and
  /// arrived until its time.
  struct ByClock {
    std::function<std::int64_t()> arrived_ms;  ///< of the line that came last, ms since power-up; never falls
    std::optional<std::int64_t> cycle_ms;      ///< instead of that of the configuration
  };
  static Result<InputStream> open_by_clock(std::string file, NextLine next_line, ByClock by_clock);

  const Configuration& configuration() const { return configuration_; }
  /// Nothing is left to deliver.
  bool empty() const { return !pending_ && radio_.empty(); }
  /// Fills `cycle` with the inputs of the next cycle and keeps the signals; false when there is none. An error names
  /// the line; the cycles before it are complete.
  Result<bool> next(sim::CycleInputs& cycle);

 private:
  struct Pending {
    Json object;
    std::int64_t t_ms = 0;
  };
  InputStream(std::string file, NextLine next_line) : file_(std::move(file)), next_line_(std::move(next_line)) {}
  /// Reads the first line, and its configuration if it has one.
  void begin(std::optional<Configuration> given);
  void read_ahead();
  std::int64_t time_of(const JsonPlace& line) const;
  /// The line that is pending becomes inputs of the cycle.
  void consume(sim::CycleInputs& cycle);
  std::string place_of_line() const { return "line " + std::to_string(line_); }

  std::string file_;
  NextLine next_line_;
  std::optional<ByClock> by_clock_;
  Configuration configuration_;
  std::optional<Pending> pending_;
  Radio radio_;  // not delivered yet
  std::optional<Train> entered_;
  std::size_t line_ = 0;
  std::int64_t last_ms_ = 0;
  std::int64_t ended_ms_ = -1;  // `end`: no input of this time follows
  bool cycle_ended_ = false;    // by `end`: the line behind it is not read yet
  std::int64_t next_cycle_ms_ = 0;
};

/// Lines of a text in memory.
InputStream::NextLine lines_of(std::string text);

}  // namespace evc::io
