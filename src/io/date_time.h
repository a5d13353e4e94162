#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/json.h"

namespace evc::io {

/// Seconds since 1970 of "2026-11-22T10:15:00Z", from 1970 to 9999; none for another text.
std::optional<std::int64_t> read_utc(std::string_view text);
/// The same at a place of a document, where another text is an error.
std::int64_t read_utc(const JsonPlace& place);

/// Appends seconds since 1970 as "2026-11-22T10:15:00".
void append_date_time(std::string& out, std::int64_t since_1970);

}  // namespace evc::io
