#include "io/latin1.h"

namespace evc::io {

void append_utf8(std::string& out, std::string_view latin1) {
  for (const char character : latin1) {
    const auto c = static_cast<unsigned char>(character);
    if (c < 0x80) {
      out += character;
    } else {
      out += static_cast<char>(0xC0 | (c >> 6));
      out += static_cast<char>(0x80 | (c & 0x3F));
    }
  }
}

std::string latin1_of(std::string_view utf8) {
  std::string out;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto first = static_cast<unsigned char>(utf8[i]);
    const std::size_t bytes = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (bytes == 1)
      out += utf8[i];
    else if (bytes == 2 && first <= 0xC3 && i + 1 < utf8.size())
      out += static_cast<char>(((first & 0x03) << 6) | (static_cast<unsigned char>(utf8[i + 1]) & 0x3F));
    else
      out += '?';
    i += bytes;
  }
  return out;
}

}  // namespace evc::io
