#include "openevc/language.h"

#include <gtest/gtest.h>

#include <thread>

namespace evc::language {
namespace {

constexpr const char* kTelegram = "A1027F802015505023A0E0D480C8087F8";
constexpr const char* kPacket65 =
    R"({"NID_PACKET":65,"Q_DIR":1,"L_PACKET":71,"Q_SCALE":1,"NID_TSR":7,"D_TSR":850,"L_TSR":400,"Q_FRONT":0,"V_TSR":16})";

TEST(Language, TelegramThereAndBack) {
  const Bits bits = bits_of_hex(kTelegram);
  ASSERT_FALSE(bits.error);
  const Text text = decode(bits.bytes, bits.size, {});
  ASSERT_FALSE(text.error) << text.error->why;
  EXPECT_NE(text.json.find("\"NID_PACKET\":65"), std::string::npos) << text.json;
  const Bits again = encode(text.json, {});
  ASSERT_FALSE(again.error);
  EXPECT_EQ(hex_of_bits(again.bytes, again.size), kTelegram);
}

TEST(Language, PacketWithItsDirection) {
  const Bits bits = encode(kPacket65, {Form::packet, Direction::to_train, Version{2, 1}});
  ASSERT_FALSE(bits.error) << bits.error->why;
  EXPECT_EQ(bits.size, 71u);
  EXPECT_EQ(hex_of_bits(bits.bytes, bits.size), "41408E838352032020");
  const Text text = decode(bits.bytes, bits.size, {Form::packet, Direction::to_train, {2, 1}, true});
  ASSERT_FALSE(text.error) << text.error->why;
  EXPECT_EQ(text.json, kPacket65);
}

TEST(Language, RadioMessageBothWays) {
  // Message 24 with its time only: a general message has no other variables.
  const Writing writing{Form::radio, Direction::to_train, Version{2, 1}};
  const Bits bits = encode(R"({"NID_MESSAGE":24,"T_TRAIN":100,"M_ACK":0,"NID_LRBG":5,"packets":[]})", writing);
  ASSERT_FALSE(bits.error) << bits.error->why;
  const Text text = decode(bits.bytes, bits.size, {Form::radio, Direction::to_train, {2, 1}});
  ASSERT_FALSE(text.error) << text.error->why;
  const Bits again = encode(text.json, writing);
  EXPECT_EQ(again.bytes, bits.bytes);
}

TEST(Language, ErrorSaysWhere) {
  const Bits bits = bits_of_hex("41409E838352032020");  // L_PACKET 79
  const Text text = decode(bits.bytes, bits.size, {Form::packet});
  ASSERT_TRUE(text.error);
  EXPECT_TRUE(text.json.empty());
  EXPECT_EQ(text.error->bit, 10u);
  EXPECT_EQ(text.error->packet, 65);
  EXPECT_EQ(text.error->variable, "L_PACKET");
  EXPECT_EQ(text.error->value, 79u);
  EXPECT_EQ(bits_of_hex("4G").error->bit, 4u);
}

TEST(Language, WhatCannotBeIsRefused) {
  const std::uint8_t byte = 0;
  EXPECT_EQ(decode({&byte, 1}, 9, {}).error->why, "more bits than the bytes hold");
  EXPECT_TRUE(decode({&byte, 1}, 8, {Form::radio, Direction::to_train, {7, 0}}).error);
  EXPECT_TRUE(decode({}, 0, {}).error);
  EXPECT_EQ(encode("{", {}).error->why, "JSON: line 1 column 2: found the end of the text, expected JSON");
  EXPECT_EQ(encode(R"({"NID_PACKET":1,"NID_PACKET":2})", {}).error->why,
            "JSON: /NID_PACKET: found a key given twice, expected each key once");
  EXPECT_TRUE(encode("[]", {}).error);
  EXPECT_TRUE(encode("{}", {Form::packet}).error);
  EXPECT_TRUE(encode("{}", {Form::packet, {}, Version{9, 9}}).error);
}

TEST(Language, ManyThreadsAtOnce) {
  std::vector<std::string> texts(4);
  std::vector<std::thread> threads;
  for (std::string& text : texts)
    threads.emplace_back([&text] {
      for (int i = 0; i < 200; ++i) {
        const Bits bits = bits_of_hex(kTelegram);
        text = decode(bits.bytes, bits.size, {}).json;
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& text : texts) EXPECT_EQ(text, texts.front());
  EXPECT_FALSE(texts.front().empty());
}

}  // namespace
}  // namespace evc::language
