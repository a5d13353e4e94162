#pragma once
#include <memory>
#include <string>
#include <vector>

#include "kernel/evc.h"
#include "kernel/state.h"
#include "reference.h"
#include "sim/cycle_inputs.h"

// An on-board that is driven through `step` only.
namespace evc::through_step {

/// What a unit said since the last action.
struct Answer {
  std::vector<std::string> events;
  std::vector<std::vector<std::uint8_t>> sent;
  std::vector<std::pair<int, int>> forwarded;  ///< NID_XUSER and NID_NTC of packet 44; -1: none
  /// The first event that contains all of `parts`, or nothing.
  std::string event(std::initializer_list<std::string> parts) const;
  std::string text() const;
};

class OnBoard {
 public:
  /// After the statements of a scenario (docs/scenarios.md), without its name.
  static const OnBoard& after(const std::string& statements);
  OnBoard(const OnBoard& other);

  /// Passes a group of two balises at its speed; packets are in the first one. `header` are codes of both headers, or
  /// of one with "0/" or "1/" before the name.
  Answer pass(unsigned NID_BG, const BitList& packets, const std::string& sv = "2.1", const Codes& header = {});
  /// Receives a message of the RBC, or of the radio infill unit called last.
  Answer receive(unsigned NID_MESSAGE, Codes codes, const BitList& packets, const std::string& sv = "2.1",
                 bool infill_unit = false);
  Answer receive(const std::vector<std::uint8_t>& message, bool infill_unit = false);
  Answer receive_loop(const std::vector<std::uint8_t>& message);
  /// Goes on for some cycles.
  Answer run(int cycles);
  /// The true place of the first balise of the last group passed, and the counter now.
  double group() const { return group_; }
  double front() const { return in_.levels.odometry.nominal.from_origin.si; }
  std::int64_t t_ms() const { return in_.t_ms; }
  sim::CycleInputs& inputs() { return in_; }
  /// The line of `evc replay` of the last cycle, with the advance display if it is asked for.
  std::string line(bool planning = true);
  Json output(bool planning = true);
  /// The file of `evc replay --persistent`.
  Json retained() const;
  /// The last message of that number that the unit sent before this state.
  Decoded last_sent(unsigned NID_MESSAGE, const std::string& sv = "2.1") const;
  const std::vector<std::vector<std::uint8_t>>& sent_before() const { return sent_before_; }

 private:
  struct Unit {
    kernel::State state;
    kernel::Derived derived;
    kernel::Outputs outputs;
    kernel::Planning planning;
  };
  OnBoard();
  void advance();
  void cycle(Answer& answer);
  std::unique_ptr<Unit> unit_;
  sim::CycleInputs in_;
  double group_ = 0.0;
  std::vector<std::vector<std::uint8_t>> sent_before_;
};

}  // namespace evc::through_step
