#pragma once
#include <string>

#include "curves/result.h"

namespace evc::curves {

/// The computation of all limits for one speed, step by step: symbol, formula, values, unit, paragraph.
std::string explain_text(const Approached& approached, double v_kmh);

}  // namespace evc::curves
