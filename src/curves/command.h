#pragma once
#include <string>
#include <vector>

// `evc curves` and `evc curves compare`. Both return the exit status: 0, or 2 when the input cannot be read or the
// output not written, which is reported in one line.
namespace evc::curves {

struct Options {
  std::string input;                  ///< evc-curves/1; empty: a shipped example
  std::string format = "json";        ///< json, csv or table
  std::string model = "srs";          ///< srs or workbook
  std::string plot;                   ///< FILE.svg, .png, .pdf or .html; empty: no chart
  std::string theme = "screen";       ///< of pictures: screen or print
  std::string output = "-";           ///< FILE.xlsx is a workbook, a name of a chart is one
  double explain_kmh = -1.0;          ///< below 0: no explanation
  std::vector<std::string> replaced;  ///< PLACE=VALUE: members of the query that are replaced, in this order
};
/// Braking curves and supervision limits of one train and one target.
int show(const Options& options);

struct CompareOptions {
  std::string a, b;
  std::vector<std::string> more;  ///< further inputs, compared with A as B is
  std::string format = "table";
  std::string plot;
  std::string theme = "screen";
  std::string output = "-";
  std::vector<std::string> replaced;  ///< as above, in every input
};
/// Difference between trains, sets of national values or SRS versions.
int compare(const CompareOptions& options);

}  // namespace evc::curves
