#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "dmi/screen.h"

// What a painter draws: paths in cells of the screen, filled or stroked. The painters of SVG and of PNG draw the same
// shapes.
namespace evc::paint {

/// A place in cells: x to the right, y down.
struct Point {
  double x = 0.0, y = 0.0;
};

/// A path of straight lines and cubic Bezier curves.
class Path {
 public:
  enum class Kind : unsigned char { move, line, curve, close };
  /// `end` is where a move, line or curve ends; `a` and `b` are the control points of a curve.
  struct Step {
    Kind kind{};
    Point a, b, end;
  };

  void move_to(Point p) { add({Kind::move, {}, {}, p}); }
  void line_to(Point p) { add({Kind::line, {}, {}, p}); }
  void curve_to(Point a, Point b, Point end) { add({Kind::curve, a, b, end}); }
  /// A curve with one control point.
  void quadratic_to(Point control, Point end);
  /// The arc of a circle, from where the angle is `from_deg` (0: up, clockwise positive); `first` is how it begins.
  void arc(Point centre, double radius, double from_deg, double to_deg, Kind first = Kind::line);
  void circle(Point centre, double radius);
  void rectangle(double x, double y, double w, double h);
  void close() { steps_.push_back({Kind::close, {}, {}, {}}); }
  const std::vector<Step>& steps() const { return steps_; }

 private:
  void add(const Step& step) { steps_.push_back(step); }
  Point here() const;
  std::vector<Step> steps_;
};

/// The place on a circle; the angle as in Path::arc.
Point on_circle(Point centre, double radius, double deg);

struct Shape {
  Path path;
  dmi::Colour colour{};
  double stroke = 0.0;  ///< width of the line; 0: the path is filled, what it surrounds in one direction (nonzero rule)
};

/// Shapes that belong together, with what they say in words (UTF-8) for those who cannot see them; it may be empty.
struct Group {
  std::string label;
  std::vector<Shape> shapes;
};

/// The whole screen, 640 x 480 cells, in drawing order, on the background of 015560 5.2.1.3.
using Drawing = std::vector<Group>;

/// The smallest rectangle round the shapes: with their strokes, and with the control points of curves, so that it may
/// be larger than what is drawn. `least` above `most`: nothing is drawn.
struct Bounds {
  Point least{1e9, 1e9}, most{-1e9, -1e9};
};
Bounds bounds_of(const std::vector<Shape>& shapes);

/// What an item of a display list looks like; nothing for one that only reacts to touch.
std::vector<Shape> shapes_of(const dmi::Item& item);

/// The surface on which everything stands.
Shape background();

/// The shapes of a display list, without that surface.
Drawing draw(const dmi::Screen& screen);

}  // namespace evc::paint
