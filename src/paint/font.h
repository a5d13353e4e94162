#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "paint/drawing.h"

// Text as outlines, so that it looks the same wherever it is drawn. Sizes are heights of capital letters
// (ERA_ERTMS_015560 5.1.2).
namespace evc::paint {

/// A character of the font, in units of which a capital letter is kCapital high.
struct Glyph {
  std::int16_t advance = 0;
  const char* outline = "";  ///< M x y, L x y, Q x y x y and Z; y upwards from the baseline
};

inline constexpr double kCapital = 1409.0;
inline constexpr std::size_t kGlyphs = 384;  ///< U+0020 to U+007E, U+00A0 to U+017F, U+0410 to U+044F, U+2013
extern const Glyph kRegular[kGlyphs];
extern const Glyph kBold[kGlyphs];

/// The outline of a character; of those without one it is that of '?'.
const Glyph& glyph_of(char32_t character, bool bold);

/// Takes the first character from a text in UTF-8 that is not empty. Bytes that are not UTF-8, and characters without
/// an outline, are '?'.
char32_t take_character(std::string_view& text);

/// How wide a text in UTF-8 is, in cells. `height` of its capital letters in cells.
double width_of(std::string_view text, double height, bool bold);

/// Adds the outline of a text in UTF-8: `left` end of its baseline.
void add_text(Path& path, std::string_view text, Point left, double height, bool bold);

/// A text as it is drawn, in UTF-8: with '?' for what has no outline.
std::string readable(std::string_view text);

}  // namespace evc::paint
