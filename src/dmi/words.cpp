#include "dmi/words.h"

namespace evc::dmi {
namespace {

// Advance widths of the printable ASCII characters in thousandths of the em of a usual sans serif face.
constexpr std::array<std::uint16_t, 95> kAdvance{
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr double kOther = 600.0;          // of every other character
constexpr double kCapitalsPerEm = 0.718;  // height of capital letters
constexpr double kBoldPerRegular = 1.08;
constexpr std::size_t kMostOctets = 60;  // of a line: as many as Words holds

}  // namespace

double width_of(std::string_view text, int height, bool bold) {
  double thousandths = 0.0;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x80 && code < 0xC0) continue;  // the rest of a character of more octets
    const bool ascii = code >= 0x20 && code < 0x7F;
    thousandths += ascii ? static_cast<double>(kAdvance[code - 0x20u]) : kOther;
  }
  return thousandths / 1000.0 * height / kCapitalsPerEm * (bold ? kBoldPerRegular : 1.0);
}

std::size_t line_length(std::string_view text, int height, bool bold, double width) {
  std::size_t fits = 0, whole_words = 0;
  while (fits < text.size()) {
    std::size_t next = fits + 1;
    while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0) == 0x80) ++next;
    if (next > kMostOctets || width_of(part_of(text, 0, next), height, bold) > width) break;
    if (text[fits] == ' ') whole_words = fits;
    if (text[fits] == '+') whole_words = next;
    fits = next;
  }
  if (fits == text.size()) return fits;
  if (fits == 0) return 1;
  if (text[fits] == ' ') return fits;
  return whole_words > 0 ? whole_words : fits;
}

}  // namespace evc::dmi
