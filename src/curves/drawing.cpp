#include "curves/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "io/xml.h"

namespace evc::curves {
namespace {

/// The same meaning on white paper.
const char* on_paper(std::string_view dark) {
  constexpr std::pair<const char*, const char*> kPairs[] = {
      {colour::white, "#000000"},     {colour::grey, "#6B7480"},      {colour::medium_grey, "#7A828C"},
      {colour::dark_grey, "#A9B1BB"}, {colour::dark_blue, "#FFFFFF"}, {colour::yellow, "#8A7A00"},
      {colour::orange, "#D07A00"},    {colour::pasp_dark, "#DDE2E9"}, {colour::pasp_light, "#CBD8E8"},
      {colour::EBD, "#2467B8"},       {colour::SBD, "#0C7A55"},       {colour::GUI, "#7A3FB8"}};
  for (const auto& [screen, paper] : kPairs)
    if (dark == screen) return paper;
  return nullptr;
}

void recolour(const char*& colour) {
  if (const char* paper = on_paper(colour)) colour = paper;
}

std::string stroke_of(const Stroke& s) {
  std::string out = fmt::format("stroke=\"{}\" stroke-width=\"{:g}\"", s.colour, s.width);
  if (*s.dash != '\0') out += fmt::format(" stroke-dasharray=\"{}\"", s.dash);
  return out;
}

/// Writes the elements one after the other.
class SvgWriter {
 public:
  explicit SvgWriter(std::string& out) : out_(out) {}
  void operator()(const DrawnRect& r) {
    out_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n", r.x, r.y,
                        r.w, r.h, r.fill);
  }
  void operator()(const DrawnLine& l) {
    std::string path;
    bool pen_up = true;
    for (const auto& [x, y] : l.points) {
      const bool point = std::isfinite(x) && std::isfinite(y);
      if (point) path += fmt::format("{}{:.2f} {:.2f}", pen_up ? "M" : "L", x, y);
      pen_up = !point;
    }
    if (path.empty()) return;
    out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", path, stroke_of(l.stroke));
  }
  void operator()(const DrawnText& t) {
    const std::string at = t.vertical ? fmt::format("transform=\"translate({:.2f} {:.2f}) rotate(-90)\"", t.x, t.y)
                                      : fmt::format("x=\"{:.2f}\" y=\"{:.2f}\"", t.x, t.y);
    out_ += fmt::format("<text {} font-size=\"{:g}\" fill=\"{}\" text-anchor=\"{}\"{}{}>{}</text>\n", at, t.size,
                        t.fill, t.anchor, t.bold ? " font-weight=\"bold\"" : "",
                        t.halo ? " stroke=\"#FFFFFF\" stroke-width=\"4\" paint-order=\"stroke\"" : "",
                        io::escaped_xml(t.text));
  }
  void operator()(const Clip& c) {
    ++clips_;
    out_ += fmt::format(
        "<clipPath id=\"c{0}\"><rect x=\"{1:.2f}\" y=\"{2:.2f}\" width=\"{3:.2f}\" height=\"{4:.2f}\"/></clipPath>\n"
        "<g clip-path=\"url(#c{0})\">\n",
        clips_, c.x, c.y, c.w, c.h);
  }
  void operator()(EndOfClip) { out_ += "</g>\n"; }

 private:
  std::string& out_;
  int clips_ = 0;
};

bool inside_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

void Drawing::for_paper() {
  for (Element& element : elements_) {
    if (auto* rect = std::get_if<DrawnRect>(&element)) recolour(rect->fill);
    if (auto* line = std::get_if<DrawnLine>(&element)) recolour(line->stroke.colour);
    if (auto* text = std::get_if<DrawnText>(&element)) recolour(text->fill);
  }
}

std::string svg_of(const Drawing& drawing) {
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\" "
      "font-family=\"Verdana, 'DejaVu Sans', Helvetica, Arial, sans-serif\" role=\"img\">\n<title>{2}</title>\n",
      drawing.width(), drawing.height(), io::escaped_xml(drawing.title()));
  SvgWriter write(out);
  write(DrawnRect{0.0, 0.0, drawing.width(), drawing.height(), colour::white});
  for (const Element& element : drawing.elements()) std::visit(write, element);
  return out + "</svg>\n";
}

double Axis::step(int count) const {
  const double rough = std::abs(to - from) / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = power;
  for (const double m : {2.0, 5.0, 10.0})
    if (step < rough * 0.999) step = m * power;
  return step;
}

std::vector<double> Axis::ticks(int count) const {
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  const double apart = step(count);
  std::vector<double> out;
  for (double k = std::ceil(low / apart - 1e-9); k * apart <= high + apart * 1e-6; k += 1.0) out.push_back(k * apart);
  return out;
}

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return !inside_character(c); }));
}

std::string shortened(const std::string& text, std::size_t most) {
  std::size_t count = 0;
  std::size_t cut = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (inside_character(text[i])) continue;
    if (++count == most) cut = i;
    if (count > most) return text.substr(0, cut) + "\u2026";
  }
  return text;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t most, std::size_t lines) {
  std::vector<std::string> out;
  std::string rest = text;
  while (out.size() + 1 < lines && characters(rest) > most) {
    // The bytes of the first `most` characters, and the last space in them.
    std::size_t end = 0;
    for (std::size_t count = 0; end < rest.size(); ++end)
      if (!inside_character(rest[end]) && ++count > most) break;
    const std::size_t space = rest.rfind(' ', end);
    const bool at_space = space != std::string::npos && space > 0;
    out.push_back(rest.substr(0, at_space ? space : end));
    rest.erase(0, at_space ? space + 1 : end);
  }
  out.push_back(shortened(rest, most));
  return out;
}

std::string label(double value) { return fmt::format("{:.10g}", std::nearbyint(value * 1e6) / 1e6 + 0.0); }

}  // namespace evc::curves
