#include "io/number.h"

#include <charconv>
#include <cmath>

namespace evc::io {

void append_number(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  if (value == 0.0) {
    // JSON readers read "-0" as an integer and lose the sign.
    out += std::signbit(value) ? "-0.0" : "0";
    return;
  }
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  out.append(buffer, end.ptr);
}

void append_number(std::string& out, std::int64_t value) {
  char buffer[24];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  out.append(buffer, end.ptr);
}

void append_micro(std::string& out, double value) {
  const double scaled = std::nearbyint(value * 1e6);
  // + 0.0 turns a rounded -0 into 0.
  append_number(out, std::isfinite(scaled) ? scaled / 1e6 + 0.0 : value);
}

void append_string(std::string& out, std::string_view text) {
  constexpr char digits[] = "0123456789abcdef";
  out += '"';
  for (const char c : text) {
    const auto u = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (u < 0x20) {
      out += "\\u00";
      out += digits[u >> 4];
      out += digits[u & 15];
    } else {
      out += c;
    }
  }
  out += '"';
}

void append_packed(std::string& out, std::uint32_t packed) {
  for (int shift = 28; shift >= 0; shift -= 4) {
    const std::uint32_t digit = (packed >> shift) & 15u;
    if (digit < 10) out += static_cast<char>('0' + digit);
  }
}

void append_hex(std::string& out, std::span<const std::uint8_t> bytes) {
  constexpr char digits[] = "0123456789ABCDEF";
  for (const std::uint8_t b : bytes) {
    out += digits[b >> 4];
    out += digits[b & 15];
  }
}

}  // namespace evc::io
