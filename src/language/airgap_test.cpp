#include "language/airgap.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "base/test_paths.h"

namespace evc::language {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}
nlohmann::json vectors() {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/eurobalise_vectors.json");
  return nlohmann::json::parse(in);
}
std::size_t user_bits(const nlohmann::json& vector) { return vector.at("format") == 1023 ? 830 : 210; }

/// A telegram with its header only.
nlohmann::json described() {
  return nlohmann::json::parse(R"({"header":{"Q_UPDOWN":1,"M_VERSION":33,"Q_MEDIA":0,"N_PIG":0,"N_TOTAL":1,"M_DUP":0,
      "M_MCOUNT":255,"NID_C":426,"NID_BG":352,"Q_LINK":1},"packets":[]})");
}

TEST(CommandAirgap, ReadsAPeriodAndCodesTheSameBitsAgain) {
  const auto reference = vectors();
  for (const auto& vector : reference.at("vectors"))
    for (const std::size_t rotation : {0u, 1u, 200u, 340u})
      for (const bool inverted : {false, true}) {
        const Bytes user = bytes_of(vector.at("user_hex").get<std::string>());
        AirgapWish wish;
        wish.long_format = vector.at("format") == 1023;
        wish.rotation = rotation;
        wish.inverted = inverted;
        const auto coded = encode_airgap(user, user_bits(vector), wish);
        ASSERT_TRUE(coded) << coded.error();
        if (rotation == 0 && !inverted) {
          EXPECT_EQ(coded->bytes, bytes_of(vector.at("telegram_hex").get<std::string>()));
        }

        const auto telegram = read_airgap(coded->bytes, coded->bits);
        ASSERT_TRUE(telegram) << telegram.error().why;
        EXPECT_EQ(Bytes(telegram->received.user_bytes().begin(), telegram->received.user_bytes().end()), user);
        EXPECT_EQ(telegram->received.rotation, rotation);
        EXPECT_EQ(telegram->received.inverted, inverted);
        EXPECT_FALSE(telegram->stream);
        EXPECT_EQ(telegram->fails, airgap::Fault::none);

        const auto json = nlohmann::json::parse(airgap_json(*telegram));
        EXPECT_EQ(json.at("sb"), vector.at("sb"));
        const auto again = airgap_wish(json);
        ASSERT_TRUE(again) << again.error();
        EXPECT_EQ(encode_airgap(user, user_bits(vector), *again)->bytes, coded->bytes);
      }
}

TEST(CommandAirgap, FillsUpWithOnes) {
  const Bytes user = {0x12, 0x34, 0x56, 0x00};
  const auto coded = encode_airgap(user, 24, {});
  ASSERT_TRUE(coded);
  EXPECT_EQ(coded->bits, 341u);
  const auto telegram = read_airgap(coded->bytes, 344);
  ASSERT_TRUE(telegram);
  EXPECT_EQ(telegram->received.format, airgap::Format::short_);
  for (std::size_t i = 0; i < 210; ++i)
    EXPECT_EQ(airgap::bit(telegram->received.user, i), i >= 24 || airgap::bit(user, i));
  EXPECT_EQ(encode_airgap(Bytes(27), 211, {})->bits, 1023u);
  EXPECT_FALSE(encode_airgap(Bytes(104), 831, {}));
}

TEST(CommandAirgap, FindsATelegramInAStream) {
  const auto reference = vectors();
  for (const auto& vector : reference.at("vectors")) {
    const Bytes coded = bytes_of(vector.at("telegram_hex").get<std::string>());
    const std::size_t n = vector.at("format");
    Bytes stream(300);
    for (std::size_t i = 0; i < 2400; ++i)
      if (i < 50 ? i % 3 == 0 : airgap::bit(coded, (i + 9) % n))
        stream[i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
    const auto telegram = read_airgap(stream, 2400);
    ASSERT_TRUE(telegram) << telegram.error().why;
    EXPECT_TRUE(telegram->stream);
    EXPECT_LE(telegram->received.start, 50u);
    EXPECT_NE(airgap_json(*telegram).find("\"start\":"), std::string::npos);
    EXPECT_NE(explain_airgap(*telegram).find("of the stream"), std::string::npos);
    if (n == 341) {
      // A short telegram, in as many bits as a long one has.
      const auto three = read_airgap(std::span(stream).subspan(16), 1024);
      ASSERT_TRUE(three) << three.error().why;
      EXPECT_EQ(three->received.format, airgap::Format::short_);
      EXPECT_TRUE(three->stream);
    }
  }
}

TEST(CommandAirgap, NamesTheTestOfAWrongEncoder) {
  const auto reference = vectors();
  for (const auto& vector : reference.at("must_be_rejected_by_encoder")) {
    const auto telegram = read_airgap(bytes_of(vector.at("telegram_hex").get<std::string>()), 1024);
    const std::string test = vector.at("fails").at(0);
    if (test == "alphabet") {
      ASSERT_FALSE(telegram);
      EXPECT_EQ(telegram.error().why, "air gap: alphabet");
      continue;
    }
    ASSERT_TRUE(telegram);
    EXPECT_EQ(airgap::name(telegram->fails).substr(0, test.size()), test);
    EXPECT_NE(airgap_json(*telegram).find("\"fails\":\"" + test), std::string::npos);
    EXPECT_NE(explain_airgap(*telegram).find("fails the encoder's test: " + test), std::string::npos);
    // Coded again, the telegram passes.
    const auto wish = airgap_wish(nlohmann::json::parse(airgap_json(*telegram)));
    ASSERT_TRUE(wish);
    const auto coded = encode_airgap(telegram->received.user_bytes(), 830, *wish);
    ASSERT_TRUE(coded);
    EXPECT_EQ(read_airgap(coded->bytes, 1024)->fails, airgap::Fault::none);
  }
}

TEST(CommandAirgap, SaysWhyNot) {
  EXPECT_EQ(read_airgap(Bytes(128, 0xA5), 1024).error().why, "air gap: check bits");
  EXPECT_EQ(read_airgap(Bytes(43, 0xA5), 344).error().why, "air gap: check bits");
  EXPECT_EQ(read_airgap(Bytes(300, 0xA5), 2400).error().why, "air gap: check bits");
  EXPECT_EQ(read_airgap(Bytes(10), 80).error().why,
            "air gap: too few bits: a period has 1023 or 341, a stream at least 462");
}

TEST(CommandAirgap, RefusesAWishOutOfRange) {
  for (const char* wrong :
       {R"([])", R"({"format":"medium"})", R"({"sb":4096})", R"({"esb":-1})", R"({"esb":"a"})",
        R"({"format":"short","rotation":341})", R"({"rotation":1023})", R"({"inverted":1})", R"({"fill":2})",
        R"({"rotationn":5})", R"({"start":"x"})", R"({"fails":1})", R"({"user_bits":"FF"})"})
    EXPECT_FALSE(airgap_wish(nlohmann::json::parse(wrong))) << wrong;
  const auto wish = airgap_wish(nlohmann::json::parse(R"({"format":"long","sb":4095,"esb":1023,"rotation":1022})"));
  ASSERT_TRUE(wish);
  // No pair from there on: one from the beginning.
  const auto coded = encode_airgap(Bytes(104), 830, *wish);
  ASSERT_TRUE(coded);
  EXPECT_EQ(read_airgap(coded->bytes, 1024)->received.rotation, 1022);
}

TEST(CommandAirgap, JsonAndBackGivesTheSameBits) {
  for (const char* airgap : {R"({})", R"({"format":"long"})", R"({"format":"long","rotation":1022,"inverted":true})",
                             R"({"format":"short","rotation":17,"sb":100,"esb":5})", R"({"inverted":true})"}) {
    auto telegram = described();
    telegram["airgap"] = nlohmann::json::parse(airgap);
    const auto coded = encode_airgap_json(telegram);
    ASSERT_TRUE(coded) << coded.error().why;
    std::string json = "kept";
    ASSERT_TRUE(append_airgap_json(json, coded->bytes, coded->bits));
    ASSERT_EQ(json.substr(0, 4), "kept");
    const auto again = nlohmann::json::parse(json.substr(4));
    EXPECT_EQ(again.at("header"), described().at("header"));
    EXPECT_EQ(again.at("airgap").at("rotation"), telegram["airgap"].value("rotation", 0));
    EXPECT_EQ(encode_airgap_json(again)->bytes, coded->bytes);
    // The member is optional: without it the same telegram is coded with default options.
    auto plain = again;
    plain.erase("airgap");
    EXPECT_TRUE(encode_airgap_json(plain));
  }
}

TEST(CommandAirgap, FewZerosBehindPacket255ComeBack) {
  // 210 user bits of which the last five are not in a packet: header (50), packet 44 up to packet 255, 00000.
  Bytes user(27);
  const auto put = [&](std::size_t at, std::size_t length, unsigned value) {
    for (std::size_t i = 0; i < length; ++i)
      if ((value >> (length - 1 - i) & 1u) != 0) user[(at + i) / 8] |= static_cast<std::uint8_t>(0x80u >> (at + i) % 8);
  };
  const auto start = io::encode_balise_json(described());
  ASSERT_TRUE(start);
  for (std::size_t i = 0; i < 50; ++i) put(i, 1, airgap::bit(start->bytes, i) ? 1 : 0);
  put(50, 8, 44);    // NID_PACKET: data used by applications outside ERTMS
  put(58, 2, 1);     // Q_DIR
  put(60, 13, 147);  // L_PACKET
  put(73, 9, 7);     // NID_XUSER
  put(197, 8, 255);
  for (const bool fill : {false, true}) {
    if (fill) put(205, 5, 31);
    const auto coded = encode_airgap(user, 210, {});
    ASSERT_TRUE(coded);
    std::string json;
    const auto done = append_airgap_json(json, coded->bytes, coded->bits);
    ASSERT_TRUE(done) << done.error().why;
    const auto again = encode_airgap_json(nlohmann::json::parse(json));
    ASSERT_TRUE(again) << again.error().why;
    EXPECT_EQ(again->bytes, coded->bytes) << json;
    EXPECT_EQ(json.find("\"fill\":0") != std::string::npos, !fill);
  }
}

TEST(CommandAirgap, JsonErrorsLeaveTheTextAlone) {
  std::string json = "kept";
  EXPECT_FALSE(append_airgap_json(json, Bytes(128, 0xA5), 1024));
  const auto coded = encode_airgap(Bytes(104, 0), 830, {});  // valid coding, but not a telegram of the language
  const auto refused = append_airgap_json(json, coded->bytes, coded->bits);
  ASSERT_FALSE(refused);
  EXPECT_EQ(json, "kept");
  EXPECT_FALSE(encode_airgap_json(nlohmann::json::parse(R"({"packets":[]})")));
  auto telegram = described();
  telegram["airgap"]["sb"] = 5000;
  EXPECT_EQ(encode_airgap_json(telegram).error().why, "airgap/sb: expected a number from 0 to 4095");
}

TEST(CommandAirgap, RecordedTelegramsThroughTheAir) {
  std::ifstream in(evc::test::source_folder() + "/tests/reference/telegram_vectors.json");
  int through = 0;
  const auto reference = nlohmann::json::parse(in);
  for (const auto& vector : reference.at("telegrams")) {
    SCOPED_TRACE(vector.at("name").get<std::string>());
    std::string hex = vector.at("hex");
    if (hex.size() % 2 != 0) hex += '0';
    const auto coded = encode_airgap(bytes_of(hex), vector.at("bits"), {});
    ASSERT_TRUE(coded) << coded.error();
    std::string json, user_json;
    const bool sound = io::append_balise_json(user_json, bytes_of(hex), vector.at("bits")).has_value();
    ASSERT_EQ(append_airgap_json(json, coded->bytes, coded->bits).has_value(), sound);
    if (!sound) continue;
    auto telegram = nlohmann::json::parse(json);
    const auto again = encode_airgap_json(telegram);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->bytes, coded->bytes);
    EXPECT_EQ(telegram.at("packets"), nlohmann::json::parse(user_json).at("packets"));
    ++through;
  }
  EXPECT_GT(through, 20);
}

}  // namespace
}  // namespace evc::language
