#include "io/retained_file.h"

#include <gtest/gtest.h>

#include "io/json.h"
#include "kernel/test_retained.h"

namespace evc::io {
namespace {

std::string error_of(std::string text, const std::string& part, const std::string& other) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  if (at == std::string::npos) return "";
  const auto read = read_retained(text.replace(at, part.size(), other), "kept.json");
  EXPECT_FALSE(read) << other;
  return read ? "" : read.error().text();
}

TEST(RetainedFile, WhatIsWrittenIsRead) {  // 3.18.2.7, 4.10
  for (const kernel::Retained& r : {kernel::Retained{}, kernel::everything_retained()}) {
    const auto read = read_retained(retained_text(r), "kept.json");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(*read == r) << retained_text(r) << retained_text(*read);
  }
}

/// A unit reads its own file, wherever the number that trackside has sent has F.
TEST(RetainedFile, TheNumberOfTheRbcMayBeOneOfTrackside) {  // 7.5.1.95
  kernel::Retained r = kernel::everything_retained();
  r.contact->NID_RADIO = 0x12F4F6FFFFFFFFFFu;
  const auto read = read_retained(retained_text(r), "kept.json");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_TRUE(*read == r);
}

TEST(RetainedFile, ALevelOrderThatWaitsIsWrittenAndRead) {  // 4.10 of 4.0.0
  kernel::Retained r;
  r.level_order.emplace();
  r.level_order->conditional = true;
  EXPECT_TRUE(r.level_order->table.push_back({Level::NTC, 7}) && r.level_order->table.push_back({Level::L0, 0}));
  const std::string text = retained_text(r);
  const auto read = read_retained(text, "kept.json");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_TRUE(*read == r);
  EXPECT_NE(error_of(text, "\"conditional\": true", "\"conditional\": 1").find("/level_order/conditional: found 1"),
            std::string::npos);
  r.level_order->table.clear();
  const auto empty = read_retained(retained_text(r), "kept.json");
  ASSERT_FALSE(empty);
  EXPECT_NE(empty.error().text().find("/level_order/levels: "), std::string::npos);
}

/// 3.15.9.5: the date of a cover is there where the unit had a clock.
TEST(RetainedFile, ACoverMayHaveADate) {
  kernel::Retained r;
  EXPECT_TRUE(r.covers.push_back({1, 63, Duration{3600.0}, 1, 1'795'000'000}) &&
              r.covers.push_back({1, 62, Duration{3600.0}, 1, std::nullopt}));
  const std::string text = retained_text(r);
  const Json covers = Json::parse(text)["vbc"];
  EXPECT_EQ(covers[0]["utc"], "2026-11-18T11:06:40Z");
  EXPECT_FALSE(covers[1].contains("utc"));
  const auto read = read_retained(text, "kept.json");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_TRUE(*read == r);
  EXPECT_EQ(error_of(text, "2026-11-18T11:06:40Z", "yesterday"),
            "kept.json: /vbc/0/utc: found \"yesterday\", expected date and time as 2026-11-22T10:15:00Z, from 1970 on");
}

TEST(RetainedFile, EveryKeyIsRequired) {
  const Json whole = Json::parse(retained_text(kernel::everything_retained()));
  for (const auto& [key, value] : whole.items()) {
    if (key == "level_order") continue;  // files of before do not have it
    Json without = whole;
    without.erase(key);
    const auto read = read_retained(without.dump(), "kept.json");
    ASSERT_FALSE(read) << key;
    EXPECT_EQ(read.error().file, "kept.json");
  }
}

TEST(RetainedFile, ErrorsNameTheirPlace) {
  const std::string text = retained_text(kernel::everything_retained());
  EXPECT_EQ(error_of(text, "evc-persistent/1", "evc-persistent/2"),
            "kept.json: /schema: found \"evc-persistent/2\", expected \"evc-persistent/1\"");
  EXPECT_NE(error_of(text, "\"left_s\": 86400.0", "\"left_s\": 1e9").find("kept.json: /vbc/0/left_s: found "),
            std::string::npos);
  EXPECT_NE(error_of(text, "\"over_m\": 20.0", "\"over_m\": 11.0").find("/position/over_m: found 11"),
            std::string::npos);
  EXPECT_NE(error_of(text, "\"version_X\": 1", "\"version_X\": 4").find("/version_X: found 4, expected "),
            std::string::npos);
  EXPECT_NE(error_of(text, "\"level\": \"2\"", "\"level\": \"4\"").find("/level_table/0/level: found "),
            std::string::npos);
  EXPECT_NE(error_of(text, "\"vbc\"", "\"covers\"").find("kept.json: "), std::string::npos);
  EXPECT_NE(error_of(text, "}", "").find("kept.json: line "), std::string::npos);
  const auto long_list = error_of(
      text, "1023", "1023" + [] {
        std::string more;
        for (int i = 0; i < 31; ++i) more += ",5";
        return more;
      }());
  EXPECT_NE(long_list.find("/national_areas: "), std::string::npos) << long_list;
}

}  // namespace
}  // namespace evc::io
