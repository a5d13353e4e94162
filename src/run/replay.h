#pragma once
#include <string>

#include "run/answers.h"

namespace evc::run {

struct ReplayOptions : Printed {
  std::string input;       ///< JSON Lines; "-": standard input, answered cycle by cycle
  std::string config;      ///< configuration, instead of the stream's first line
  std::string persistent;  ///< what the unit keeps without power: read at the start if it exists, written at power off
                           ///< and at the end
  std::string output = "-";
};
/// `evc replay`: passes a recorded or live stream of inputs to the on-board and prints its outputs. Returns the exit
/// status: 0, or 2 with one line on standard error.
int replay(const ReplayOptions& options);

/// `evc replay --diff`: compares two files of outputs and prints the first line that differs, field by field. Returns
/// the exit status: 0 the same bytes, 1 different, 2 a file cannot be read.
int diff(const std::string& a, const std::string& b);

}  // namespace evc::run
