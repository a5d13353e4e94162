#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "curves/result.h"

// `evc curves --batch`: the limits of many queries, or of a table of trains and targets, one row for each speed.
namespace evc::curves {

struct BatchOptions {
  std::string input;                                 ///< - for standard input
  std::string columns = "EBI,SBI1,SBI2,FLOI,W,P,I";  ///< of `by_speed`, separated by commas
  std::string output = "-";                          ///< FILE.npy: an array for NumPy; else CSV
  unsigned threads = 0;                              ///< 0: one for each processor
};
/// Exit status: 0, or 2 when an input cannot be read or the output not written, which is reported in one line.
int limits_of_many(const BatchOptions& options);

/// A row of the result: numbers of query, train and target from 1, the speed, the columns; NaN where there is none.
struct BatchRows {
  std::vector<std::int64_t> query, train, target;
  std::vector<double> v_kmh;
  std::vector<std::vector<double>> values;  // by column
};

/// The columns that a list of names asks for; the error names the option.
io::Result<std::vector<Column<SpeedRow>>> batch_columns(const std::string& names);

/// Computes the queries in `text` with this number of threads. `take` gets the rows in the order of queries, trains,
/// targets and speeds, in blocks. The error is the first one in that order; what was taken before is not valid then.
io::Result<bool> compute_batch(std::string_view text, const std::string& file,
                               const std::vector<Column<SpeedRow>>& columns, unsigned threads,
                               const std::function<void(const BatchRows&)>& take);

}  // namespace evc::curves
