#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "dmi/screen.h"

// Texts of the screen: numbers, characters of ISO 8859-1 as UTF-8, and the room that a text takes.
namespace evc::dmi {

/// A whole number, with zeros in front up to `digits`.
template <std::size_t Capacity>
constexpr void append_number(Text<Capacity>& text, std::int64_t value, int digits = 1) {
  if (value < 0) {
    text.append('-');
    value = -value;
  }
  std::array<char, 20> reversed{};
  std::size_t size = 0;
  while ((value > 0 || static_cast<int>(size) < digits) && size < reversed.size()) {
    reversed[size++] = static_cast<char>('0' + value % 10);
    value /= 10;
  }
  while (size > 0) text.append(reversed[--size]);
}
constexpr Words number_words(std::int64_t value) {
  Words words;
  append_number(words, value);
  return words;
}

/// A character of ISO 8859-1; control characters are blanks. A character that does not fit whole is left out.
template <std::size_t Capacity>
constexpr void append_latin(Text<Capacity>& text, char c) {
  const auto code = static_cast<unsigned char>(c);
  if (code < 0x20 || (code >= 0x7F && code < 0xA0)) return text.append(' ');
  if (code < 0x80) return text.append(c);
  if (text.length + 2u > Capacity) return;
  text.append(static_cast<char>(0xC0 | (code >> 6)));
  text.append(static_cast<char>(0x80 | (code & 0x3F)));
}
template <std::size_t Capacity>
constexpr void append_latin(Text<Capacity>& text, std::string_view latin) {
  for (const char c : latin) append_latin(text, c);
}
/// The part of a character field before its first zero.
template <std::size_t N>
constexpr std::string_view until_zero(const std::array<char, N>& characters) {
  std::size_t size = 0;
  while (size < N && characters[size] != '\0') ++size;
  return {characters.data(), size};
}

/// A part of a text, at most to its end: `substr` could throw.
constexpr std::string_view part_of(std::string_view text, std::size_t from, std::size_t count = ~std::size_t{0}) {
  if (from > text.size()) from = text.size();
  text.remove_prefix(from);
  if (count < text.size()) text.remove_suffix(text.size() - count);
  return text;
}

/// The width of a UTF-8 text in cells at a height of capital letters: that of a sans serif face of usual width, which a
/// painter's face must not exceed by much.
double width_of(std::string_view text, int height, bool bold);

/// The octets of the first line of a UTF-8 text that is broken into lines of a width: at blanks, behind a plus, or
/// within a word that is longer than a line. Of a blank at the break the next line begins.
std::size_t line_length(std::string_view text, int height, bool bold, double width);

}  // namespace evc::dmi
