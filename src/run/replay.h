#pragma once
#include <cstdint>
#include <string>

namespace evc::run {

struct ReplayOptions {
  std::string input;       ///< JSON Lines; "-": standard input, answered cycle by cycle
  std::string config;      ///< configuration, instead of the stream's first line
  std::string persistent;  ///< what the unit keeps without power: read at the start if it exists, written at power off
                           ///< and at the end
  std::string output = "-";
  std::int64_t every = 1;  ///< print only every Nth cycle
  bool changes = false;    ///< print a cycle only when something other than position and speed changed
  bool planning = false;   ///< print the advance display (3.15.10)
  bool dmi = false;        ///< print the record of the display (015560)
};
/// `evc replay`: passes a recorded or live stream of inputs to the on-board and prints its outputs. Returns the exit
/// status: 0, or 2 with one line on standard error.
int replay(const ReplayOptions& options);

/// `evc replay --diff`: compares two files of outputs and prints the first line that differs, field by field. Returns
/// the exit status: 0 the same bytes, 1 different, 2 a file cannot be read.
int diff(const std::string& a, const std::string& b);

}  // namespace evc::run
