#pragma once
#include <string>

#include "app/curves_result.h"

namespace evc::app {

/// The computation of all limits for one speed, step by step: symbol, formula, values, unit, paragraph.
std::string explain_text(const Approached& approached, double v_kmh);

}  // namespace evc::app
