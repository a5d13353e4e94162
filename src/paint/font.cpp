#include "paint/font.h"

#include <array>

namespace evc::paint {
namespace {

/// The next whole number of an outline, and what is behind it.
double take_whole(const char*& text) {
  while (*text == ' ') ++text;
  const bool negative = *text == '-';
  if (negative) ++text;
  double number = 0.0;
  for (; *text >= '0' && *text <= '9'; ++text) number = 10.0 * number + (*text - '0');
  return negative ? -number : number;
}

/// Characters with an outline: the first, the last, and the place of the first in the table.
struct Range {
  char32_t first, last;
  std::size_t place;
};
constexpr std::array<Range, 4> kRanges{
    {{0x20, 0x7E, 0}, {0xA0, 0x17F, 95}, {0x410, 0x44F, 319}, {0x2013, 0x2013, 383}}};
static_assert(kRanges.back().place + 1 == kGlyphs);

const Range* range_of(char32_t character) {
  for (const Range& range : kRanges)
    if (character >= range.first && character <= range.last) return &range;
  return nullptr;
}

}  // namespace

const Glyph& glyph_of(char32_t character, bool bold) {
  const Range* range = range_of(character);
  if (range == nullptr) return glyph_of(U'?', bold);
  const std::size_t place = range->place + (character - range->first);
  return bold ? kBold[place] : kRegular[place];
}

char32_t take_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  char32_t character = byte(0);
  std::size_t length = 1;
  if (byte(0) >= 0xC2 && byte(0) < 0xE0 && follows(1)) {
    character = ((byte(0) & 0x1FU) << 6U) | (byte(1) & 0x3FU);
    length = 2;
  } else if ((byte(0) & 0xF0U) == 0xE0U && follows(1) && follows(2)) {
    character = ((byte(0) & 0x0FU) << 12U) | ((byte(1) & 0x3FU) << 6U) | (byte(2) & 0x3FU);
    if (character < 0x800) character = U'?';  // longer than needed
    length = 3;
  } else if (byte(0) >= 0x80) {
    character = U'?';
  }
  text.remove_prefix(length);
  return range_of(character) == nullptr ? U'?' : character;
}

double width_of(std::string_view text, double height, bool bold) {
  double width = 0.0;
  while (!text.empty()) width += glyph_of(take_character(text), bold).advance;
  return width * height / kCapital;
}

void add_text(Path& path, std::string_view text, Point left, double height, bool bold) {
  const double scale = height / kCapital;
  while (!text.empty()) {
    const Glyph& glyph = glyph_of(take_character(text), bold);
    const auto take_point = [&](const char*& at) {
      const double x = take_whole(at);
      const double y = take_whole(at);
      return Point{left.x + scale * x, left.y - scale * y};
    };
    for (const char* at = glyph.outline; *at != '\0';) {
      const char letter = *at++;
      if (letter == 'Z') path.close();
      if (letter == 'M') path.move_to(take_point(at));
      if (letter == 'L') path.line_to(take_point(at));
      if (letter == 'Q') {
        const Point control = take_point(at);
        path.quadratic_to(control, take_point(at));
      }
    }
    left.x += scale * glyph.advance;
  }
}

std::string readable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::string_view before = text;
    const char32_t character = take_character(text);
    if (character == U'?')
      out += '?';
    else
      out += before.substr(0, before.size() - text.size());
  }
  return out;
}

}  // namespace evc::paint
