#pragma once
#include <string>

namespace evc::explain {

struct ModesOptions {
  std::string srs = "3.6.0";  ///< or 4.0.0: another table
  bool svg = false;           ///< the graph instead of the matrix
  std::string output = "-";
};
/// `evc describe modes`: the table of mode transitions that the unit uses (4.6.2), as a matrix with its conditions or
/// as a graph. Returns the exit status.
int describe_modes(const ModesOptions& options);

}  // namespace evc::explain
