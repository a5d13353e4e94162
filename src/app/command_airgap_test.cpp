#include "app/command_airgap.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

namespace evc::app {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}
nlohmann::json vectors() {
  std::ifstream in(std::string(EVC_SOURCE_DIR) + "/tests/reference/eurobalise_vectors.json");
  return nlohmann::json::parse(in);
}
std::size_t user_bits(const nlohmann::json& vector) { return vector.at("format") == 1023 ? 830 : 210; }

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
        const auto hex = encode_airgap(user, user_bits(vector), wish);
        ASSERT_TRUE(hex) << hex.error();
        if (rotation == 0 && !inverted) {
          EXPECT_EQ(*hex, vector.at("telegram_hex").get<std::string>());
        }

        const auto telegram = read_airgap(bytes_of(*hex), 4 * hex->size());
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
        EXPECT_EQ(encode_airgap(user, user_bits(vector), *again), hex);
      }
}

TEST(CommandAirgap, FillsUpWithOnes) {
  const Bytes user = {0x12, 0x34, 0x56, 0x00};
  const auto hex = encode_airgap(user, 24, {});
  ASSERT_TRUE(hex);
  EXPECT_EQ(hex->size(), 86u);
  const auto telegram = read_airgap(bytes_of(*hex), 344);
  ASSERT_TRUE(telegram);
  EXPECT_EQ(telegram->received.format, airgap::Format::short_);
  for (std::size_t i = 0; i < 210; ++i)
    EXPECT_EQ(airgap::bit(telegram->received.user, i), i >= 24 || airgap::bit(user, i));
  EXPECT_EQ(encode_airgap(Bytes(27), 211, {})->size(), 256u);
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
      // As many bits as a long telegram has, of a short one.
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
      EXPECT_EQ(telegram.error().why, "alphabet");
      continue;
    }
    ASSERT_TRUE(telegram);
    EXPECT_EQ(airgap::name(telegram->fails).substr(0, test.size()), test);
    EXPECT_NE(airgap_json(*telegram).find("\"fails\":\"" + test), std::string::npos);
    EXPECT_NE(explain_airgap(*telegram).find("fails the encoder's test: " + test), std::string::npos);
    // Coded again it is a telegram that passes.
    const auto wish = airgap_wish(nlohmann::json::parse(airgap_json(*telegram)));
    ASSERT_TRUE(wish);
    const auto hex = encode_airgap(telegram->received.user_bytes(), 830, *wish);
    ASSERT_TRUE(hex);
    EXPECT_EQ(read_airgap(bytes_of(*hex), 1024)->fails, airgap::Fault::none);
  }
}

TEST(CommandAirgap, SaysWhyNot) {
  EXPECT_EQ(read_airgap(Bytes(128, 0xA5), 1024).error().why, "check bits");
  EXPECT_EQ(read_airgap(Bytes(43, 0xA5), 344).error().why, "check bits");
  EXPECT_EQ(read_airgap(Bytes(300, 0xA5), 2400).error().why, "check bits");
  EXPECT_EQ(read_airgap(Bytes(10), 80).error().why, "too few bits: a period has 1023 or 341, a stream at least 462");
}

TEST(CommandAirgap, RefusesAWishOutOfRange) {
  for (const char* wrong : {R"([])", R"({"format":"medium"})", R"({"sb":4096})", R"({"esb":-1})", R"({"esb":"a"})",
                            R"({"format":"short","rotation":341})", R"({"rotation":1023})", R"({"inverted":1})"})
    EXPECT_FALSE(airgap_wish(nlohmann::json::parse(wrong))) << wrong;
  const auto wish = airgap_wish(nlohmann::json::parse(R"({"format":"long","sb":4095,"esb":1023,"rotation":1022})"));
  ASSERT_TRUE(wish);
  // No pair from there on: one from the start.
  const auto hex = encode_airgap(Bytes(104), 830, *wish);
  ASSERT_TRUE(hex);
  EXPECT_EQ(read_airgap(bytes_of(*hex), 1024)->received.rotation, 1022);
}

}  // namespace
}  // namespace evc::app
