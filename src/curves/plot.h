#pragma once
#include <string>

#include "curves/result.h"

namespace evc::curves {

/// A static chart for publication: curves and limits over the line, MRSP, gradients, legend.
std::string curves_svg(const Approached& approached);
/// A self-contained interactive page with the same chart: values, zoom, a train to drag.
std::string curves_html(const Approached& approached);

}  // namespace evc::curves
