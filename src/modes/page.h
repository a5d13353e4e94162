#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "terms/mode.h"

// Tables of the standard are written as rows of text that look like the page and are read at
// compile time: an error in a row does not compile, and the program contains no text.
namespace evc::modes::page {

/// Called for a row that cannot be read: not constexpr, so the compiler reports an error at that
/// row.
inline void row_cannot_be_read() { __builtin_trap(); }

/// The words of a row between blanks; exactly N of them.
template <std::size_t N>
constexpr std::array<std::string_view, N> words(std::string_view row) {
  std::array<std::string_view, N> out{};
  std::size_t n = 0;
  std::size_t i = 0;
  while (i < row.size()) {
    while (i < row.size() && row[i] == ' ') ++i;
    std::size_t end = i;
    while (end < row.size() && row[end] != ' ') ++end;
    if (end > i) {
      if (n == N) row_cannot_be_read();
      out[n++] = row.substr(i, end - i);
    }
    i = end;
  }
  if (n != N) row_cannot_be_read();
  return out;
}

/// The footnotes of a cell, "A[3][14]" -> bits 3 and 14.
constexpr std::uint32_t notes(std::string_view word) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (word[i] != '[') continue;
    unsigned number = 0;
    for (++i; i < word.size() && word[i] != ']'; ++i) number = number * 10 + static_cast<unsigned>(word[i] - '0');
    if (i == word.size() || number == 0 || number > 31) row_cannot_be_read();
    bits |= std::uint32_t{1} << number;
  }
  return bits;
}

/// The cell without its footnotes.
constexpr std::string_view mark(std::string_view word) { return word.substr(0, word.find('[')); }

}  // namespace evc::modes::page
