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
/// At the speeds that either of them asks for, or at given ones (km/h).
Comparison compare_curves(const Approached& a, const Approached& b);
Comparison compare_curves(const Approached& a, const Approached& b, const std::vector<double>& speeds_kmh);
/// `evc-curves-comparison/1` and its two readable forms.
std::string comparison_text(const Comparison& comparison, Format format);
std::string comparison_svg(const Comparison& comparison);
/// A self-contained page: both charts with zoom, curves on and off, the values at a chosen speed.
std::string comparison_html(const Approached& a, const Approached& b);

}  // namespace evc::app
