#pragma once
#include <span>
#include <vector>

#include "openevc/terms/picture.h"
#include "paint/drawing.h"

// The symbols of ERA_ERTMS_015560 13, drawn as lines, surfaces and letters.
namespace evc::paint {

/// One stroke of a symbol.
struct Mark {
  enum class Kind : unsigned char { surface, line, letters };
  Kind kind{};
  dmi::Colour colour{};  ///< none: the colour of the symbol
  double width = 0.0;    ///< of a line; with letters their height
  /// M x y, L x y: straight lines; C x y x y x y: a Bezier curve; Z: back to the begin. O x y r: a circle;
  /// A x y r d e: on a circle clockwise from d to e degrees (0: up). With letters: the text.
  const char* path = "";
  Point base;  ///< of letters: middle of their baseline
};

/// A symbol: `marks` in a box of `box` cells, which is stretched to the size of the symbol (terms/picture.h).
struct Drawn {
  Picture picture{};
  dmi::Colour colour{};
  Point box;
  std::span<const Mark> marks;
};

/// One row for each picture, in their order.
extern const std::span<const Drawn> kSymbols;

/// The shapes of a symbol whose left upper corner is `at`.
std::vector<Shape> shapes_of(Picture picture, Point at);

}  // namespace evc::paint
