#include "lang/si.h"

#include <gtest/gtest.h>

#include "lang/layouts.h"
#include "lang/variable_table.h"
#include "lang/walk.h"

namespace evc::lang {
namespace {

TEST(Si, Distances) {
  EXPECT_EQ(metres(var::Q_SCALE{0}, var::D_LINK{1234}).si, 123.4);
  EXPECT_EQ(metres(var::Q_SCALE{1}, var::D_LINK{1234}).si, 1234.0);
  EXPECT_EQ(metres(var::Q_SCALE{2}, var::D_LINK{1234}).si, 12340.0);
  EXPECT_EQ(metres(var::Q_SCALE{1}, var::D_NVROLL{5})->si, 5.0);
  EXPECT_FALSE(metres(var::Q_SCALE{1}, var::D_NVROLL{32767}).has_value());
  EXPECT_EQ(metres(var::Q_SCALE{0}, var::D_REF{0xFFF9}).si, -0.7);
  EXPECT_EQ(metres(var::Q_SCALE{1}, var::D_REF{0xFFF9}).si, -7.0);
  EXPECT_EQ(metres(var::Q_SCALE{2}, var::D_REF{3}).si, 30.0);
  EXPECT_EQ(metres(var::Q_LOCACC{63}).si, 63.0);
  EXPECT_EQ(metres(var::L_TRAIN{4095}).si, 4095.0);
}

TEST(Si, SpeedsTimesAndOthers) {
  EXPECT_EQ(speed(var::V_STATIC{28})->si, 140 / 3.6);
  EXPECT_FALSE(speed(var::V_STATIC{127}).has_value());
  EXPECT_FALSE(speed(var::V_RELEASEDP{126}).has_value());
  EXPECT_EQ(seconds(var::T_NVOVTRP{60}).si, 60.0);
  EXPECT_EQ(seconds(var::T_NVCONTACT{35})->si, 35.0);
  EXPECT_FALSE(seconds(var::T_NVCONTACT{255}).has_value());
  EXPECT_EQ(seconds(var::T_TRAIN{2432323})->si, 24323.23);
  EXPECT_FALSE(seconds(var::T_TRAIN{0xFFFFFFFF}).has_value());
  EXPECT_EQ(acceleration(var::A_NVP12{63}).si, 3.15);
  EXPECT_EQ(acceleration(var::A_NVMAXREDADH1{20})->si, 1.0);
  EXPECT_FALSE(acceleration(var::A_NVMAXREDADH1{61}).has_value());
  EXPECT_EQ(slope(var::Q_GDIR{0}, var::G_A{15}), -0.015);
  EXPECT_EQ(slope(var::Q_GDIR{1}, var::G_A{15}), 0.015);
  EXPECT_FALSE(slope(var::Q_GDIR{1}, var::G_A{255}).has_value());
  EXPECT_EQ(slope(var::Q_GDIR{0}, var::G_TSR{4}), -0.004);
  EXPECT_EQ(factor(var::M_NVKVINT{35}), 0.7);
  EXPECT_EQ(factor(var::M_NVKRINT{18}), 0.9);
  EXPECT_EQ(factor(var::M_NVKTINT{22}), 1.1);
  EXPECT_EQ(factor(var::M_NVAVADH{20}), 1.0);
  EXPECT_EQ(group(var::NID_LRBG{(426u << 14) | 352}), (GroupIdentity{426, 352}));
  EXPECT_FALSE(group(var::NID_LRBG{0xFFFFFF}).has_value());
  EXPECT_EQ(nid_lrbg({426, 352}), (426u << 14) | 352);
}

/// The formula of L_NVKRINT compared with its table, code by code.
TEST(Si, TrainLengthSteps) {
  const VariableInfo* info = find_variable("L_NVKRINT");
  ASSERT_EQ(info->numbers.size(), 32u);
  for (const CodeNumber& n : info->numbers)
    EXPECT_EQ(metres(var::L_NVKRINT{static_cast<std::uint8_t>(n.code)}).si, n.number) << n.code;
}

TEST(Tables, UnknownNames) {
  EXPECT_EQ(find_variable("V_NOTHING"), nullptr);
  ASSERT_NE(find_variable("NC_DIFF"), nullptr);
  EXPECT_STREQ(find_variable("NC_DIFF_V1")->name, "NC_DIFF");
}

TEST(Tables, WhatIsNotThere) {
  EXPECT_EQ(find_message_layout(Direction::to_train, {2, 1}, 200), nullptr);
  EXPECT_EQ(find_message_layout(Direction::to_train, {2, 1}, 38), nullptr);  // in 2.0 only
  EXPECT_NE(find_message_layout(Direction::to_train, {2, 0}, 38), nullptr);
  // A condition on a variable that no structure around has.
  EXPECT_EQ((WalkScope{{}, nullptr, nullptr}.around("Q_DIFF")), 0u);
}

}  // namespace
}  // namespace evc::lang
