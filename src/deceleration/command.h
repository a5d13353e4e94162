#pragma once
#include <cstdint>
#include <string>

namespace evc::deceleration {

struct Options {
  std::string spec;              ///< evc-brakes/1; "-": standard input
  unsigned threads = 0;          ///< 0: as many as there are processors
  std::string format = "table";  ///< of what is printed: table or json
  std::uint64_t plain = 0;       ///< samples of a plain run to compare with; 0: none
  std::string plot;              ///< FILE.svg; empty: none
  std::string output;            ///< train file; empty: none
};
/// `evc brakes`. Returns the exit status: 0; 2 for a wrong description, before anything is computed, or a file that
/// cannot be written, with one line on standard error.
int brakes(const Options& options);

}  // namespace evc::deceleration
