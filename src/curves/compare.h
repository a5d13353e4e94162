#pragma once
#include <string>
#include <vector>

#include "curves/result.h"

namespace evc::curves {

/// Two results at the same speeds; differences are B - A: positive means that B brakes earlier.
struct Comparison {
  std::string name_a, name_b;
  std::vector<std::string> differ;  // the differences of the inputs: "train", "national values", "SRS version", ...
  std::vector<std::string>
      warnings;  // targets or tracks are not the same: the differences are not due to the trains alone
  Scalars a, b;
  std::vector<SpeedRow> rows_a, rows_b, difference;
};
/// At the speeds of either input, or at given ones (km/h).
Comparison compare_curves(const Approached& a, const Approached& b);
Comparison compare_curves(const Approached& a, const Approached& b, const std::vector<double>& speeds_kmh);
/// The differences of two inputs, and warnings where the target or the track before it is not the same (`rows`: of
/// both).
void compare_inputs(Comparison& comparison, const Approached& a, const Approached& b);
/// "they differ in: train, SRS version".
std::string differ_text(const Comparison& comparison);
/// Every km/h from 0 to the highest speed compared, for charts.
std::vector<double> drawn_speeds(const Comparison& comparison);
/// The comparison as `evc-curves-comparison/1`, CSV or a table.
std::string comparison_text(const Comparison& comparison, Format format);
/// The comparison must be at speeds close enough to draw lines between them.
std::string comparison_svg(const Comparison& comparison);
/// A self-contained page: both charts with zoom, selection of curves, and the values at a chosen
/// speed.
std::string comparison_html(const Approached& a, const Approached& b);

}  // namespace evc::curves
