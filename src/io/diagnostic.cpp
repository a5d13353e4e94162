#include "io/diagnostic.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace evc::io {
namespace {

/// The length of the UTF-8 character that begins the text (RFC 3629), 0 if none does.
std::size_t character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0u) != 0x80u) return 0;
  const unsigned second = byte(1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  const bool too_far = first == 0xF4 && second >= 0x90;
  const bool control = first == 0xC2 && second < 0xA0;  // C1: a terminal obeys it
  return overlong || surrogate || too_far || control ? 0 : length;
}

std::string one_line(const std::string& text) { return printable(text, 200); }
/// What is expected is our own text: a list of names is of use as a whole only.
std::string whole_line(const std::string& text) { return printable(text, 1000); }

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string line;
  while (!text.empty()) {
    if (line.size() >= longest) return line + "...";
    const std::size_t length = character(text);
    const auto first = static_cast<unsigned char>(text.front());
    if (length == 0)
      line += {'\\', 'x', digits[first >> 4], digits[first & 15]};
    else if (first < 0x20 || first == 0x7f)
      line += ' ';
    else
      line += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return line;
}

std::string Diagnostic::text() const {
  std::string line = one_line(file);
  if (!where.empty()) line += ": " + one_line(where);
  if (!found.empty()) line += ": found " + one_line(found);
  if (!expected.empty()) line += (found.empty() ? ": expected " : ", expected ") + whole_line(expected);
  return line;
}

int complain(const Diagnostic& diagnostic) {
  std::fputs((diagnostic.text() + "\n").c_str(), stderr);
  return 2;
}

}  // namespace evc::io
