#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace evc::io {

/// Appends the shortest decimal that reads back to the same double; `null` for a value that JSON cannot represent.
void append_number(std::string& out, double value);
void append_number(std::string& out, std::int64_t value);
/// The value rounded to a millionth first: a speed of 140/3.6 m/s shows as 140 km/h.
void append_micro(std::string& out, double value);
/// A JSON string with its quotes and escapes.
void append_string(std::string& out, std::string_view text);
/// The digits of a BCD number, without those that only fill it and without quotes.
void append_packed(std::string& out, std::uint32_t packed);
/// Hexadecimal digits, two a byte, without quotes.
void append_hex(std::string& out, std::span<const std::uint8_t> bytes);

}  // namespace evc::io
