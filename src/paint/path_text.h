#pragma once
#include <cstdint>
#include <string>

#include "paint/drawing.h"

// Shapes as text: one writer for pictures in SVG and for painters in a script (web/src/painter.js).
namespace evc::paint {

/// A place in hundredths of a cell: finer than any screen, and above what sine and cosine of two libraries of
/// mathematics differ.
struct Hundredths {
  std::int32_t x = 0, y = 0;
  friend constexpr auto operator<=>(const Hundredths&, const Hundredths&) = default;
};

/// Cells with at most two decimals; a value that is no number is 0.
void append_cells(std::string& out, double cells);
void append_hundredths(std::string& out, std::int32_t hundredths);

/// "#C3C3C3".
std::string hex_of(dmi::Colour colour);

/// The path in SVG: M, L, C with absolute places, counted from `origin`, and Z.
void append_path(std::string& out, const Path& path, Hundredths origin = {});

/// Where the path of a shape begins.
Hundredths begin_of(const Shape& shape);

/// The elements of a JSON list for a painter in a script, `"#C3C3C3",0,"M0 0L3 4Z"`: colour, width of the line (0: the
/// path is filled) and path, counted from its begin. Shapes that look the same have the same text, wherever they are.
void append_form(std::string& out, const Shape& shape);

}  // namespace evc::paint
