#include <charconv>
#include <nlohmann/json.hpp>

#include "io/telegram_json.h"

namespace evc::io {
namespace {

/// The number of a hexadecimal digit, 16 for a blank, 17 for anything else.
struct Digits {
  unsigned char value[256];
  constexpr Digits() : value{} {
    for (unsigned char& v : value) v = 17;
    for (unsigned char i = 0; i < 10; ++i) value['0' + i] = i;
    for (unsigned char i = 0; i < 6; ++i) value['A' + i] = value['a' + i] = static_cast<unsigned char>(10 + i);
    for (const int blank : {' ', '\t', '\r'}) value[blank] = 16;
  }
};
constexpr Digits digits;

}  // namespace

tl::expected<Bits, TelegramError> bits_of_hex(std::string_view hex) {
  Bits bits;
  bits.bytes.reserve(hex.size() / 2 + 1);
  for (const char c : hex) {
    const unsigned char digit = digits.value[static_cast<unsigned char>(c)];
    if (digit == 16) continue;
    if (digit == 17)
      return tl::unexpected(TelegramError{bits.bits, -1, "", {}, std::string("not a hexadecimal digit: ") + c});
    if (bits.bits % 8 == 0)
      bits.bytes.push_back(static_cast<std::uint8_t>(digit << 4));
    else
      bits.bytes.back() = static_cast<std::uint8_t>(bits.bytes.back() | digit);
    bits.bits += 4;
  }
  if (bits.bits == 0) return tl::unexpected(TelegramError{0, -1, "", {}, "no bits"});
  return bits;
}

std::string hex_of_bits(std::span<const std::uint8_t> bytes, std::size_t bits) {
  constexpr char digit[] = "0123456789ABCDEF";
  std::string hex;
  for (std::size_t i = 0; i < bits; i += 4) hex += digit[(bytes[i / 8] >> (i % 8 == 0 ? 4 : 0)) & 15];
  return hex;
}

std::string error_json(const TelegramError& error, std::uint64_t line) {
  std::string out = "{\"error\":{";
  if (line > 0) out += "\"line\":" + std::to_string(line) + ",";
  out += "\"bit\":" + std::to_string(error.bit);
  if (error.packet >= 0) out += ",\"packet\":" + std::to_string(error.packet);
  if (!error.variable.empty())
    out +=
        ",\"variable\":" + nlohmann::json(error.variable).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (error.value) out += ",\"value\":" + std::to_string(*error.value);
  out += ",\"why\":" + nlohmann::json(error.why).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return out + "}}";
}

std::optional<lang::SystemVersion> parse_version(std::string_view text) {
  const std::size_t dot = text.find('.');
  if (dot == std::string_view::npos) return {};
  lang::SystemVersion sv;
  const auto number = [](std::string_view part, std::uint8_t& n) {
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), n);
    return !part.empty() && error == std::errc{} && end == part.data() + part.size();
  };
  if (!number(text.substr(0, dot), sv.x) || !number(text.substr(dot + 1), sv.y)) return {};
  if (sv.x > 7 || sv.y > 15) return {};
  return sv;
}

}  // namespace evc::io
