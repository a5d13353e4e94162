#pragma once
#include <string>

namespace evc::matrix {

struct Options {
  std::string line;              ///< etcs-line/1
  std::string train;             ///< etcs-train/1; empty: the standard train
  double at_m = 0.0;             ///< of the front end, along the run
  std::string quantum = "auto";  ///< auto, 0.5, 5 or 50 (m)
  std::string format = "table";  ///< table, csv or json
  std::string output = "-";
};
/// `evc track`: drives the train to a place and prints what the unit has stored about the track ahead. Returns the exit
/// status: 0; 1 where the run ends before the place; 2 for wrong input, with one line on standard error.
int track(const Options& options);

}  // namespace evc::matrix
