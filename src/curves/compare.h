#pragma once
#include <span>
#include <string>
#include <vector>

#include "curves/drawing.h"
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
/// Each of the inputs after the first with the first one, at the speeds of all of them or at given ones (km/h).
std::vector<Comparison> compare_all(const std::vector<Approached>& inputs);
std::vector<Comparison> compare_all(const std::vector<Approached>& inputs, const std::vector<double>& speeds_kmh);
/// The differences of two inputs, and warnings where the target or the track before it is not the same (`rows`: of
/// both).
void compare_inputs(Comparison& comparison, const Approached& a, const Approached& b);
/// "they differ in: train, SRS version".
std::string differ_text(const Comparison& comparison);
/// Every km/h from 0 to the highest speed compared, for charts.
std::vector<double> drawn_speeds(const Comparison& comparison);
/// The comparison as `evc-curves-comparison/1`, CSV or a table.
std::string comparison_text(const Comparison& comparison, Format format);
/// Of several inputs, each compared with the first one: `evc-curves-comparisons/1`, CSV or tables.
std::string comparisons_text(const std::vector<Comparison>& all, Format format);
/// A sheet for the scalars and one for the curves and differences of every speed.
std::vector<ResultTable> tables_of(const std::vector<Comparison>& all);
/// "A" for input 0, "B" for 1, ...: the letter of outputs; beyond "Z" a number.
std::string input_letter(std::size_t input);
/// Of one comparison or several with the same A, at the same speeds, close enough to draw lines between them.
Drawing comparison_drawing(const std::vector<Comparison>& all, Theme theme);
/// A self-contained page: A with the one of the others that is chosen there, at least one: both charts with zoom,
/// selection of curves, and the values at a chosen speed.
std::string comparison_html(const Approached& a, std::span<const Approached> others);

}  // namespace evc::curves
