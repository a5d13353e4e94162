#pragma once
#include <string>

#include "dmi/screen.h"

namespace evc::paint {

/// The screen as a PNG file, drawn by Cairo from the shapes of the SVG. `scale`: pixels of a cell, 1 to 16.
/// Throws std::bad_alloc when Cairo has no memory for it, std::runtime_error for any other failure of Cairo.
std::string png_of(const dmi::Screen& screen, int scale = 1);

}  // namespace evc::paint
