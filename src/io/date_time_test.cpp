#include "io/date_time.h"

#include <gtest/gtest.h>

namespace evc::io {
namespace {

std::string text_of(std::int64_t seconds) {
  std::string text;
  append_date_time(text, seconds);
  return text;
}

TEST(DateTime, ReadAndWritten) {
  struct Row {
    const char* text;
    std::int64_t seconds;
  };
  for (const Row& row : {Row{"1970-01-01T00:00:00", 0}, Row{"2000-02-29T23:59:59", 951868799},
                         Row{"2000-03-01T00:00:00", 951868800}, Row{"2026-11-22T10:15:00", 1795342500},
                         Row{"2100-02-28T12:00:00", 4107499200}, Row{"9999-12-31T23:59:59", 253402300799}}) {
    EXPECT_EQ(read_utc(std::string(row.text) + "Z"), row.seconds) << row.text;
    EXPECT_EQ(text_of(row.seconds), row.text);
  }
  EXPECT_EQ(text_of(-1), "1969-12-31T23:59:59") << "local time in the west";
}

TEST(DateTime, EachDayHasItsOwnDate) {
  for (std::int64_t day = 0; day < 366 * 140; ++day) EXPECT_EQ(read_utc(text_of(day * 86400) + "Z"), day * 86400);
}

TEST(DateTime, WhatIsNone) {
  for (const char* text :
       {"", "2026-11-22", "2026-11-22T10:15:00", "2026-11-22 10:15:00Z", "2026-13-22T10:15:00Z", "2026-00-22T10:15:00Z",
        "2026-11-31T10:15:00Z", "2026-11-00T10:15:00Z", "2025-02-29T10:15:00Z", "2026-11-22T24:00:00Z",
        "2026-11-22T10:60:00Z", "2026-11-22T10:15:60Z", "1969-12-31T23:59:59Z", "2026-11-2xT10:15:00Z",
        "2026-11-22T10:15:00+"})
    EXPECT_FALSE(read_utc(text).has_value()) << text;
}

}  // namespace
}  // namespace evc::io
