#pragma once
#include <string>

#include "check/finding.h"
#include "io/diagnostic.h"
#include "io/train_file.h"

namespace evc::check {

struct Options {
  std::string line;              ///< etcs-line/1; empty: the shipped line
  std::string train;             ///< etcs-train/1; empty: the braking of a train is not checked
  std::string format = "table";  ///< table or json
  std::string output = "-";
};
/// `evc check`: prints the findings of a review of a line. Returns the exit status: 1 with an error among them, else 0;
/// 2 for wrong input, with one line on standard error.
int check(const Options& options);

/// The review of a line with this text; with the braking of `train` where there is one.
struct Review {
  std::string line;  ///< its name
  Findings findings;
};
io::Result<Review> review(const std::string& text, const std::string& file, const io::Train* train);

/// The findings as a table with a line of totals, or as `evc-check/1`.
std::string table_of(const Review& review);
std::string json_of(const Review& review);

}  // namespace evc::check
