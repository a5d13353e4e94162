#pragma once
#include <string>

#include "curves/drawing.h"
#include "curves/result.h"

namespace evc::curves {

/// A static chart for publication: curves and limits over the line, MRSP, gradients; a legend, or for print names at
/// the curves.
Drawing curves_drawing(const Approached& approached, Theme theme);
/// A self-contained interactive page with the same chart: values, zoom, a train to drag.
std::string curves_html(const Approached& approached);

}  // namespace evc::curves
