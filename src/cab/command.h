#pragma once
#include <string>
#include <string_view>

namespace evc::cab {

struct Options {
  std::string line;                 ///< etcs-line/1; empty: the shipped line
  std::string train;                ///< etcs-train/1; empty: the standard train
  std::string output = "cab.html";  ///< the page; "-" is standard output
};
/// `evc cab`: writes the page, which is what `make cab` has compiled, with the line and the train. Returns the exit
/// status: 0, or 2 with one line on standard error.
int cab(const Options& options);

/// In Base64 (RFC 4648 4).
std::string base64(std::string_view bytes);

}  // namespace evc::cab
