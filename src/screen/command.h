#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dmi/dmi.h"
#include "io/diagnostic.h"

namespace evc::screen {

/// The driver touches a place, for as long as a button there needs to act (015560 5.3.2.6).
struct Press {
  dmi::Cell at;
  std::int64_t ms = 0;
};

/// "194,165@12.5": cells and seconds. None: it is not of this form, or not on the screen.
std::optional<Press> press_of(const std::string& text);

struct Options {
  std::string input;                  ///< inputs of a replay, "-" for standard input; empty: the shipped line
  std::string config;                 ///< configuration, instead of the stream's first line
  std::optional<std::int64_t> at_ms;  ///< the moment; absent: the last cycle
  std::vector<Press> presses;
  std::string cases;         ///< a file of cases instead of a replay
  std::string output = "-";  ///< .svg, .png or .json; "-": JSON on standard output
};

/// `evc dmi`: the screen at a moment of a replay, or the answers to described cases. Returns the exit status: 0, 1 when
/// a press hits nothing, or 2 with one line on standard error.
int show(const Options& options);

}  // namespace evc::screen
