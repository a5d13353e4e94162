#pragma once
#include <cstdint>
#include <string>

namespace evc::explain {

struct Options {
  std::string input;       ///< a stream of inputs; - for standard input
  std::string config;      ///< instead of that of the stream
  std::string persistent;  ///< what the unit kept without power, read at the start
  std::int64_t at_ms = 0;  ///< the cycle explained: the last one not after it
  bool why_brake = false;
  std::string output = "-";
};
/// `evc explain`. Returns the exit status: 0; 1 where the stream ends before, or no brake was commanded; 2 for wrong
/// input, with one line on standard error.
int explain(const Options& options);

}  // namespace evc::explain
