#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace evc::io {

/// Seconds since 1970 of "2026-11-22T10:15:00Z", from 1970 to 9999; none for another text.
std::optional<std::int64_t> read_utc(std::string_view text);

/// Appends seconds since 1970 as "2026-11-22T10:15:00".
void append_date_time(std::string& out, std::int64_t since_1970);

}  // namespace evc::io
