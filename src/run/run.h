#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "openevc/terms/srs_version.h"

namespace evc::run {

struct RunOptions {
  std::string line;                 ///< etcs-line/1; empty: the shipped line
  std::string train;                ///< etcs-train/1; empty: the standard train
  std::string driver = "perfect";   ///< perfect, late or reckless
  std::string odometer = "random";  ///< random, or at the limit that it declares: over (too much), under (too little)
  std::string output;               ///< folder for the report and the records; empty: none are written
  std::uint64_t seed = 1;           ///< of odometer errors and delays
  bool real_time = false;           ///< cycles by the clock, until the end of the run, SIGINT or SIGTERM
  int cycle_ms = 100;               ///< length of a cycle
  SrsVersion srs = SrsVersion::v3_6_0;   ///< the edition of the on-board and of its display
  std::optional<std::int64_t> utc = {};  ///< the on-board's clock at the begin, in seconds since 1970; none: no clock
  int last_ma = -1;                      ///< movement authorities with a higher seq are withheld; below 0: none are
};
/// `evc run`: drives a simulated train along a line, supervised by the on-board. Returns the exit status: 0, or 2 with
/// one line on standard error.
int run(const RunOptions& options);

}  // namespace evc::run
