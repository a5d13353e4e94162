#include "io/date_time.h"

namespace evc::io {
namespace {

constexpr std::int64_t kDay = 86400;
constexpr std::int64_t kDaysOf400Years = 146097;

constexpr bool leap(std::int64_t year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }

constexpr std::int64_t days_in(std::int64_t year, std::int64_t month) {
  constexpr std::int64_t kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return kDays[month - 1] + (month == 2 && leap(year) ? 1 : 0);
}

/// Days from 1970-01-01 to the first of January of a year.
constexpr std::int64_t days_before(std::int64_t year) {
  const std::int64_t y = year - 1;
  return 365 * (year - 1970) + (y / 4 - y / 100 + y / 400) - 477;
}
static_assert(days_before(1970) == 0 && days_before(1973) == 3 * 365 + 1);
static_assert(days_before(2370) == kDaysOf400Years);

/// The number of `digits` digits at `from`; -1 for anything else.
std::int64_t number_at(std::string_view text, std::size_t from, std::size_t digits) {
  std::int64_t n = 0;
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
  constexpr std::string_view kForm = "0000-00-00T00:00:00Z";
  if (text.size() != kForm.size()) return std::nullopt;
  for (std::size_t i = 0; i < kForm.size(); ++i)
    if (kForm[i] != '0' && text[i] != kForm[i]) return std::nullopt;
  const std::int64_t year = number_at(text, 0, 4), month = number_at(text, 5, 2), day = number_at(text, 8, 2);
  const std::int64_t hour = number_at(text, 11, 2), minute = number_at(text, 14, 2), second = number_at(text, 17, 2);
  if (year < 1970 || month < 1 || month > 12 || day < 1 || day > days_in(year, month)) return std::nullopt;
  if (hour < 0 || hour > 23 || minute < 0 || minute > 59 || second < 0 || second > 59) return std::nullopt;
  std::int64_t days = days_before(year) + day - 1;
  for (std::int64_t m = 1; m < month; ++m) days += days_in(year, m);
  return days * kDay + hour * 3600 + minute * 60 + second;
}

void append_date_time(std::string& out, std::int64_t seconds) {
  std::int64_t days = seconds / kDay;
  std::int64_t rest = seconds % kDay;
  if (rest < 0) {
    rest += kDay;
    --days;
  }
  // A year that is not too late, then one after the other.
  std::int64_t year = 1970 + days / 366 - (days < 0 ? 1 : 0);
  while (days_before(year + 1) <= days) ++year;
  days -= days_before(year);
  std::int64_t month = 1;
  for (; days >= days_in(year, month); ++month) days -= days_in(year, month);
  append_padded(out, year, 4, '\0');
  append_padded(out, month, 2, '-');
  append_padded(out, days + 1, 2, '-');
  append_padded(out, rest / 3600, 2, 'T');
  append_padded(out, rest / 60 % 60, 2, ':');
  append_padded(out, rest % 60, 2, ':');
}

}  // namespace evc::io
