#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/output_lines.h"
#include "run/on_board.h"
#include "run/sounds.h"
#include "sim/cycle_inputs.h"

namespace evc::run {

/// Which cycles are printed, and what is added to them.
struct Printed {
  std::int64_t every = 1;  ///< print only every Nth cycle
  bool changes = false;    ///< print a cycle only when something other than position and speed changed
  bool planning = false;   ///< print the advance display (3.15.10)
  bool dmi = false;        ///< print the record of the display (015560), with its sounds
};

/// The lines of a unit's outputs, cycle by cycle: `evc replay` and `evc serve` print the same ones.
class Answers {
 public:
  /// `names`: of national systems, as the configuration has them.
  Answers(OnBoard& on_board, io::NationalSystemNames names, const Printed& printed = {})
      : on_board_(on_board), names_(std::move(names)), printed_(printed) {
    if (printed_.dmi) display_.emplace();
  }

  /// One cycle of the unit; its line, if it is to be printed, is appended to `text`.
  void append(std::string& text, sim::CycleInputs& cycle);

 private:
  bool differs(const kernel::Outputs& outputs, const kernel::Planning* planning, const std::string& dmi) const;

  OnBoard& on_board_;
  io::NationalSystemNames names_;
  Printed printed_;
  std::int64_t cycles_ = 0;
  std::optional<Sounds> display_;
  std::vector<io::NamedSound> sounds_;  ///< since the line before
  // Of the cycle before, for `changes`.
  kernel::Outputs last_;
  std::optional<kernel::Planning> last_planning_;
  std::string last_dmi_;  // io::motionless
};

}  // namespace evc::run
