#include "io/date_time.h"

#include <chrono>

namespace evc::io {
namespace {

/// The number of `digits` digits at `from`; -1 for anything else.
int number_at(std::string_view text, std::size_t from, std::size_t digits) {
  int n = 0;
  for (std::size_t i = from; i < from + digits; ++i) {
    if (text[i] < '0' || text[i] > '9') return -1;
    n = 10 * n + (text[i] - '0');
  }
  return n;
}

void append_padded(std::string& out, std::int64_t n, std::size_t digits, char before) {
  const std::string text = std::to_string(n);
  if (before != '\0') out += before;
  if (text.size() < digits) out.append(digits - text.size(), '0');
  out += text;
}

}  // namespace

std::optional<std::int64_t> read_utc(std::string_view text) {
  using namespace std::chrono;
  constexpr std::string_view kForm = "0000-00-00T00:00:00Z";
  if (text.size() != kForm.size()) return std::nullopt;
  for (std::size_t i = 0; i < kForm.size(); ++i)
    if (kForm[i] != '0' && text[i] != kForm[i]) return std::nullopt;
  const int y = number_at(text, 0, 4), m = number_at(text, 5, 2), d = number_at(text, 8, 2);
  const int hour = number_at(text, 11, 2), minute = number_at(text, 14, 2), second = number_at(text, 17, 2);
  if (y < 1970 || m < 0 || d < 0) return std::nullopt;
  const year_month_day date{year{y}, month{static_cast<unsigned>(m)}, day{static_cast<unsigned>(d)}};
  if (!date.ok() || hour < 0 || hour > 23 || minute < 0 || minute > 59 || second < 0 || second > 59)
    return std::nullopt;
  const sys_seconds time = sys_days{date} + hours{hour} + minutes{minute} + seconds{second};
  return time.time_since_epoch().count();
}

std::int64_t read_utc(const JsonPlace& place) {
  const auto utc = read_utc(place.string());
  if (!utc) place.fail("date and time as 2026-11-22T10:15:00Z, from 1970 on");
  return *utc;
}

void append_date_time(std::string& out, std::int64_t since_1970) {
  using namespace std::chrono;
  const sys_seconds time{seconds{since_1970}};
  const sys_days midnight = floor<days>(time);
  const year_month_day date{midnight};
  const hh_mm_ss clock{time - midnight};
  append_padded(out, int{date.year()}, 4, '\0');
  append_padded(out, unsigned{date.month()}, 2, '-');
  append_padded(out, unsigned{date.day()}, 2, '-');
  append_padded(out, clock.hours().count(), 2, 'T');
  append_padded(out, clock.minutes().count(), 2, ':');
  append_padded(out, clock.seconds().count(), 2, ':');
}

}  // namespace evc::io
