#include "curves/svg.h"

#include <fmt/format.h>

#include <cmath>

#include "io/xml.h"

namespace evc::curves {
namespace {

std::string stroke_of(const Stroke& s) {
  std::string out = fmt::format("stroke=\"{}\" stroke-width=\"{:g}\"", s.colour, s.width);
  if (*s.dash != '\0') out += fmt::format(" stroke-dasharray=\"{}\"", s.dash);
  return out;
}

}  // namespace

Svg::Svg(double width, double height, const std::string& title) {
  out_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\" "
      "font-family=\"Verdana, 'DejaVu Sans', Helvetica, Arial, sans-serif\" role=\"img\">\n<title>{2}</title>\n",
      width, height, io::escaped_xml(title));
  rect(0, 0, width, height, colour::white);
}

void Svg::rect(double x, double y, double w, double h, const char* fill) {
  out_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n", x, y, w, h,
                      fill);
}

void Svg::line(double x1, double y1, double x2, double y2, const Stroke& s) {
  out_ +=
      fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", x1, y1, x2, y2, stroke_of(s));
}

void Svg::polyline(const std::vector<std::pair<double, double>>& points, const Stroke& s) {
  std::string path;
  bool pen_up = true;
  for (const auto& [x, y] : points) {
    if (!std::isfinite(x) || !std::isfinite(y)) {
      pen_up = true;
      continue;
    }
    path += fmt::format("{}{:.2f} {:.2f}", pen_up ? "M" : "L", x, y);
    pen_up = false;
  }
  if (path.empty()) return;
  out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", path, stroke_of(s));
}

void Svg::text(double x, double y, const std::string& text, double size, const char* fill, const char* anchor,
               bool bold) {
  out_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:g}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
                      x, y, size, fill, anchor, bold ? " font-weight=\"bold\"" : "", io::escaped_xml(text));
}

void Svg::vertical_text(double x, double y, const std::string& text, double size, const char* fill) {
  out_ += fmt::format(
      "<text transform=\"translate({:.2f} {:.2f}) rotate(-90)\" font-size=\"{:g}\" fill=\"{}\" "
      "text-anchor=\"middle\">{}</text>\n",
      x, y, size, fill, io::escaped_xml(text));
}

void Svg::clip(double x, double y, double w, double h) {
  ++clips_;
  out_ += fmt::format(
      "<clipPath id=\"c{0}\"><rect x=\"{1:.2f}\" y=\"{2:.2f}\" width=\"{3:.2f}\" height=\"{4:.2f}\"/></clipPath>\n"
      "<g clip-path=\"url(#c{0})\">\n",
      clips_, x, y, w, h);
}

std::vector<double> Axis::ticks(int count) const {
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  const double rough = (high - low) / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = power;
  for (const double m : {2.0, 5.0, 10.0})
    if (step < rough * 0.999) step = m * power;
  std::vector<double> out;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + step * 1e-6; k += 1.0) out.push_back(k * step);
  return out;
}

std::string shortened(const std::string& text, std::size_t most) {
  std::size_t characters = 0;
  std::size_t cut = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U) continue;  // inside a character
    if (++characters == most) cut = i;
    if (characters > most) return text.substr(0, cut) + "\u2026";
  }
  return text;
}

std::string label(double value) { return fmt::format("{:.10g}", std::nearbyint(value * 1e6) / 1e6 + 0.0); }

}  // namespace evc::curves
