#pragma once
#include <string>
#include <utility>
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

struct Stroke {
  const char* colour = colour::ink;
  double width = 1.0;
  const char* dash = "";
};

/// Writes one drawing; lengths in pixels of the drawing.
class Svg {
 public:
  Svg(double width, double height, const std::string& title);
  void rect(double x, double y, double w, double h, const char* fill);
  void line(double x1, double y1, double x2, double y2, const Stroke& stroke);
  /// Points that are not numbers interrupt the line.
  void polyline(const std::vector<std::pair<double, double>>& points, const Stroke& stroke);
  /// `anchor`: start, middle or end.
  void text(double x, double y, const std::string& text, double size, const char* fill, const char* anchor = "start",
            bool bold = false);
  void vertical_text(double x, double y, const std::string& text, double size, const char* fill);
  /// Clips the following elements at this rectangle, until `end_clip`.
  void clip(double x, double y, double w, double h);
  void end_clip() { out_ += "</g>\n"; }
  std::string finish() { return std::move(out_) + "</svg>\n"; }

 private:
  std::string out_;
  int clips_ = 0;
};

/// A linear axis from values to pixels.
struct Axis {
  double from = 0.0, to = 1.0;    // values
  double start = 0.0, end = 1.0;  // pixels
  double at(double value) const { return start + (value - from) / (to - from) * (end - start); }
  /// Round values, about `count` of them.
  std::vector<double> ticks(int count) const;
};
/// At most `most` characters, with an ellipsis at the end of a longer text (UTF-8).
std::string shortened(const std::string& text, std::size_t most);
/// Without trailing zeros.
std::string label(double value);

}  // namespace evc::curves
