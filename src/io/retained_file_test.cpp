#include "io/retained_file.h"

#include <gtest/gtest.h>

#include "io/json.h"

namespace evc::io {
namespace {

/// Other than a default in every member.
kernel::Retained everything() {
  kernel::Retained r;
  train::NationalValues& nv = r.national_values;
  nv.V_NVSTFF = Speed{35.0 / 3.6};
  nv.D_NVROLL = train::kUnlimited;
  nv.D_NVOVTRP = 327670_m;
  nv.D_NVSTFF = 1500_m;
  nv.T_NVCONTACT = 30_s;
  nv.M_NVCONTACT = Reaction::service_brake;
  nv.A_NVMAXREDADH1 =
      train::MaxReducedAdhesion::without_maximum(train::MaxReducedAdhesion::Display::time_to_indication);
  nv.A_NVMAXREDADH2 =
      train::MaxReducedAdhesion::without_maximum(train::MaxReducedAdhesion::Display::target_information);
  nv.A_NVMAXREDADH3 = train::MaxReducedAdhesion::without_maximum(train::MaxReducedAdhesion::Display::none);
  nv.Kv_int_passenger.steps.clear();
  EXPECT_TRUE(nv.Kv_int_passenger.append({}, {0.6, 0.65}));
  EXPECT_TRUE(nv.Kv_int_passenger.append(Speed{100.0 / 3.6}, {0.5, 0.55}));
  EXPECT_TRUE(r.national_areas.push_back(1) && r.national_areas.push_back(1023));
  EXPECT_TRUE(r.national_areas_of_X_2.push_back(2) && r.national_areas_of_braking.push_back(3));
  r.operated_X = 1;
  r.generic_ls_marker = true;
  EXPECT_TRUE(r.covers.push_back({1, 63, 86400_s}));
  r.network = 0x26210F;
  r.level = kernel::Retained::StoredLevel{Level::NTC, 7};
  EXPECT_TRUE(r.level_table.push_back({Level::L2, 0}) && r.level_table.push_back({Level::NTC, 7}));
  r.contact = kernel::RbcAddress{1, 16383, 0x0123456789FFFFFF};
  r.position.emplace();
  r.position->lrbg = {1, 16383};
  r.position->orientation = 0;
  r.position->single = true;
  r.position->previous = kernel::NidLrbg{1, 99};
  r.position->pair_orientation = 1;
  r.position->counter_rising = false;
  r.position->cab_B = true;
  r.position->ahead = Distance{-12.25};
  r.position->over = 20_m;
  r.position->under = Distance{1.0 / 3.0 + 12.0};
  r.position->Q_LOCACC = 12_m;
  return r;
}

std::string error_of(std::string text, const std::string& part, const std::string& other) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  if (at == std::string::npos) return "";
  const auto read = read_retained(text.replace(at, part.size(), other), "kept.json");
  EXPECT_FALSE(read) << other;
  return read ? "" : read.error().text();
}

TEST(RetainedFile, WhatIsWrittenIsRead) {  // 3.18.2.7, 4.10
  for (const kernel::Retained& r : {kernel::Retained{}, everything()}) {
    const auto read = read_retained(retained_text(r), "kept.json");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(*read == r) << retained_text(r) << retained_text(*read);
  }
}

TEST(RetainedFile, EveryKeyIsRequired) {
  const Json whole = Json::parse(retained_text(everything()));
  for (const auto& [key, value] : whole.items()) {
    Json without = whole;
    without.erase(key);
    const auto read = read_retained(without.dump(), "kept.json");
    ASSERT_FALSE(read) << key;
    EXPECT_EQ(read.error().file, "kept.json");
  }
}

TEST(RetainedFile, ErrorsNameTheirPlace) {
  const std::string text = retained_text(everything());
  EXPECT_EQ(error_of(text, "evc-persistent/1", "evc-persistent/2"),
            "kept.json: /schema: found \"evc-persistent/2\", expected \"evc-persistent/1\"");
  EXPECT_NE(error_of(text, "\"left_s\": 86400.0", "\"left_s\": 1e9").find("kept.json: /vbc/0/left_s: found "),
            std::string::npos);
  EXPECT_NE(error_of(text, "\"over_m\": 20.0", "\"over_m\": 11.0").find("/position/over_m: found 11"),
            std::string::npos);
  EXPECT_NE(error_of(text, "\"version_X\": 1", "\"version_X\": 3").find("/version_X: found 3, expected "),
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
