#pragma once
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace evc::curves {

/// The colours of the driver machine interface (ERA_ERTMS_015560 5.2.1.3), and those for curves it does not show.
namespace colour {
inline constexpr const char* white = "#FFFFFF";
inline constexpr const char* grey = "#C3C3C3";
inline constexpr const char* medium_grey = "#969696";
inline constexpr const char* dark_grey = "#555555";
inline constexpr const char* dark_blue = "#031122";
inline constexpr const char* yellow = "#DFDF00";
inline constexpr const char* orange = "#EA9100";
inline constexpr const char* red = "#BF0002";
inline constexpr const char* pasp_dark = "#21314A";
inline constexpr const char* pasp_light = "#294A6B";
// Not in the driver machine interface.
inline constexpr const char* EBD = "#7FB4F0";
inline constexpr const char* SBD = "#63CDA6";
inline constexpr const char* GUI = "#C79BF2";
inline constexpr const char* ink = "#0B1B2E";
inline constexpr const char* soft = "#51607A";
}  // namespace colour

/// Dark as the driver's display, or light, for paper: no dark areas, names at the curves instead of a legend.
enum class Theme { screen, print };

struct Stroke {
  const char* colour = colour::ink;
  double width = 1.0;
  const char* dash = "";  ///< lengths of line and gap, with spaces; empty: solid
};

/// What a drawing consists of, in the order of painting; lengths in pixels of the drawing.
struct DrawnRect {
  double x, y, w, h;
  const char* fill;
};
/// Points that are not numbers interrupt the line.
struct DrawnLine {
  std::vector<std::pair<double, double>> points;
  Stroke stroke;
};
struct DrawnText {
  double x, y;
  std::string text;
  double size;
  const char* fill;
  const char* anchor;  ///< start, middle or end
  bool bold, vertical, halo;
};
/// Clips the elements up to EndOfClip at a rectangle.
struct Clip {
  double x, y, w, h;
};
struct EndOfClip {};
using Element = std::variant<DrawnRect, DrawnLine, DrawnText, Clip, EndOfClip>;

/// One drawing on a white page; `svg_of`, `png_of` and `pdf_of` make a file of it.
class Drawing {
 public:
  Drawing(double width, double height, std::string title) : width_(width), height_(height), title_(std::move(title)) {}
  void rect(double x, double y, double w, double h, const char* fill) {
    elements_.emplace_back(DrawnRect{x, y, w, h, fill});
  }
  void line(double x1, double y1, double x2, double y2, const Stroke& stroke) {
    elements_.emplace_back(DrawnLine{{{x1, y1}, {x2, y2}}, stroke});
  }
  void polyline(std::vector<std::pair<double, double>> points, const Stroke& stroke) {
    elements_.emplace_back(DrawnLine{std::move(points), stroke});
  }
  void text(double x, double y, const std::string& text, double size, const char* fill, const char* anchor = "start",
            bool bold = false) {
    elements_.emplace_back(DrawnText{x, y, text, size, fill, anchor, bold, false, false});
  }
  /// A name on a curve: with the page's white around it.
  void name(double x, double y, const std::string& text, double size, const char* fill) {
    elements_.emplace_back(DrawnText{x, y, text, size, fill, "middle", true, false, true});
  }
  void vertical_text(double x, double y, const std::string& text, double size, const char* fill) {
    elements_.emplace_back(DrawnText{x, y, text, size, fill, "middle", false, true, false});
  }
  void clip(double x, double y, double w, double h) { elements_.emplace_back(Clip{x, y, w, h}); }
  void end_clip() { elements_.emplace_back(EndOfClip{}); }

  /// Replaces the colours by those of the theme for paper.
  void for_paper();

  double width() const { return width_; }
  double height() const { return height_; }
  const std::string& title() const { return title_; }
  const std::vector<Element>& elements() const { return elements_; }

 private:
  double width_, height_;
  std::string title_;
  std::vector<Element> elements_;
};

std::string svg_of(const Drawing& drawing);
/// By Cairo, two pixels for each of the drawing. Throws std::bad_alloc when Cairo has no memory for it,
/// std::runtime_error for any other failure of Cairo.
std::string png_of(const Drawing& drawing);
/// By Cairo, one page; text stays text.
std::string pdf_of(const Drawing& drawing);

/// A linear axis from values to pixels.
struct Axis {
  double from = 0.0, to = 1.0;    // values
  double start = 0.0, end = 1.0;  // pixels
  double at(double value) const { return start + (value - from) / (to - from) * (end - start); }
  /// The distance of round values, about `count` of them.
  double step(int count) const;
  /// Round values, about `count` of them.
  std::vector<double> ticks(int count) const;
};
/// At most `most` characters, with an ellipsis at the end of a longer text (UTF-8).
std::string shortened(const std::string& text, std::size_t most);
/// Lines of at most `most` characters, broken at spaces where there are any; at most `lines`, the last one shortened.
std::vector<std::string> wrapped(const std::string& text, std::size_t most, std::size_t lines);
/// How many characters a text has (UTF-8).
std::size_t characters(const std::string& text);
/// Without trailing zeros.
std::string label(double value);

}  // namespace evc::curves
