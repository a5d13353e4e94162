#pragma once
#include <string>

#include "dmi/screen.h"

namespace evc::paint {

/// The screen as a document of SVG 1.1, 640 x 480 cells. Texts are outlines; each item is a group that says in words
/// what it is. The same display list gives the same bytes everywhere.
std::string svg_of(const dmi::Screen& screen);

}  // namespace evc::paint
