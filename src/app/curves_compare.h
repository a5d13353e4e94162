#pragma once
#include <string>
#include <vector>

#include "app/curves_result.h"

namespace evc::app {

/// Two results at the same speeds; differences are B - A: positive means that B brakes earlier.
struct Comparison {
  std::string name_a, name_b;
  Scalars a, b;
  std::vector<SpeedRow> rows_a, rows_b, difference;
};
Comparison compare_curves(const Approached& a, const Approached& b);
/// `evc-curves-comparison/1` and its two readable forms.
std::string comparison_text(const Comparison& comparison, Format format);
std::string comparison_svg(const Comparison& comparison);

}  // namespace evc::app
