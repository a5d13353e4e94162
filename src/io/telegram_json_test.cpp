#include "io/telegram_json.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/test_paths.h"

namespace evc::io {
namespace {

using Json = nlohmann::json;
using lang::Direction;

Json reference(const std::string& name) {
  std::ifstream file(evc::test::source_folder() + "/tests/reference/" + name);
  return Json::parse(file);
}

/// A file of the shared material; null if it does not exist.
Json shared(const std::string& name) {
  std::ifstream file(evc::test::shared_folder() + "/" + name);
  return file ? Json::parse(file) : Json();
}

/// The vectors in the documented form: without counters, wide numbers as hexadecimal digits.
Json without_counters(const Json& j) {
  if (j.is_array()) {
    Json out = Json::array();
    for (const Json& e : j) out.push_back(without_counters(e));
    return out;
  }
  if (!j.is_object()) return j;
  Json out = Json::object();
  for (const auto& [key, value] : j.items()) {
    if (key.starts_with("N_ITER") || key == "bits_used") continue;
    if (key == "NID_RADIO") {
      char text[17];
      std::snprintf(text, sizeof text, "%016llX", static_cast<unsigned long long>(value.get<std::uint64_t>()));
      out[key] = text;
    } else {
      out[key] = without_counters(value);
    }
  }
  return out;
}

Direction direction_of(const Json& vector) {
  return vector.at("direction") == "track_to_train" ? Direction::to_train : Direction::to_track;
}

TEST(TelegramVectors, Telegrams) {
  const Json vectors = reference("telegram_vectors.json");
  ASSERT_EQ(vectors.at("telegrams").size(), 41u);
  for (const Json& v : vectors.at("telegrams")) {
    SCOPED_TRACE(v.at("name").get<std::string>());
    const std::string hex = v.at("hex");
    const auto bits = bits_of_hex(hex);
    ASSERT_TRUE(bits);
    std::string text;
    const auto done = append_balise_json(text, bits->bytes, bits->bits);
    ASSERT_TRUE(done) << error_json(done.error());
    Json decoded = Json::parse(text);
    Json expected = without_counters(v.at("decoded"));
    expected["schema"] = "evc-telegram/1";
    EXPECT_EQ(decoded, expected);
    const auto encoded = encode_balise_json(decoded);
    ASSERT_TRUE(encoded) << error_json(encoded.error());
    EXPECT_EQ(encoded->bits, v.at("bits"));
    EXPECT_EQ(hex_of_bits(encoded->bytes, encoded->bits), hex);
    // Also from the values of the vector.
    expected["packets"] = v.at("decoded").at("packets");
    const auto from_vector = encode_balise_json(expected);
    ASSERT_TRUE(from_vector) << error_json(from_vector.error());
    EXPECT_EQ(hex_of_bits(from_vector->bytes, from_vector->bits), hex);
  }
}

TEST(TelegramVectors, Packets) {
  const Json vectors = reference("telegram_vectors.json");
  ASSERT_EQ(vectors.at("packets").size(), 140u);
  for (const Json& v : vectors.at("packets")) {
    const std::string hex = v.at("hex");
    SCOPED_TRACE(v.at("name").get<std::string>() + " " + hex);
    const auto bits = bits_of_hex(hex);
    ASSERT_TRUE(bits);
    const auto sv = parse_version(v.at("system_version").get<std::string>());
    ASSERT_TRUE(sv);
    std::string text;
    const auto done = append_packet_json(text, bits->bytes, bits->bits, direction_of(v), *sv);
    ASSERT_TRUE(done) << error_json(done.error());
    const Json decoded = Json::parse(text);
    EXPECT_EQ(decoded, without_counters(v.at("decoded")));
    const auto encoded = encode_packet_json(decoded, {direction_of(v), sv});
    ASSERT_TRUE(encoded) << error_json(encoded.error());
    EXPECT_EQ(encoded->bits, v.at("bits"));
    EXPECT_EQ(hex_of_bits(encoded->bytes, encoded->bits), hex);
    // Direction and version deduced from the members.
    const auto guessed = encode_packet_json(v.at("decoded"));
    ASSERT_TRUE(guessed) << error_json(guessed.error());
    EXPECT_EQ(hex_of_bits(guessed->bytes, guessed->bits), hex);
    // Spare codes are reported only when they are not accepted.
    text.clear();
    const auto strict = append_packet_json(text, bits->bytes, bits->bits, direction_of(v), *sv, Spare::refuse);
    EXPECT_EQ(!strict, v.contains("warnings")) << (strict ? "" : error_json(strict.error()));
  }
}

TEST(TelegramVectors, Messages) {
  const Json vectors = reference("telegram_vectors.json");
  ASSERT_EQ(vectors.at("messages").size(), 8u);
  for (const Json& v : vectors.at("messages")) {
    SCOPED_TRACE(v.at("name").get<std::string>());
    const std::string hex = v.at("hex");
    const auto bits = bits_of_hex(hex);
    ASSERT_TRUE(bits);
    const auto sv = parse_version(v.at("system_version").get<std::string>());
    std::string text;
    const auto done = append_radio_json(text, bits->bytes, direction_of(v), *sv);
    ASSERT_TRUE(done) << error_json(done.error());
    const Json decoded = Json::parse(text);
    EXPECT_EQ(decoded, without_counters(v.at("decoded")));
    const auto encoded = encode_radio_json(decoded);
    ASSERT_TRUE(encoded) << error_json(encoded.error());
    EXPECT_EQ(hex_of_bits(encoded->bytes, encoded->bits), hex);
  }
}

/// Everything recorded on a real line is decoded, and encoded to the same digits.
TEST(TelegramJson, RecordedLine) {
  const Json line = shared("lines/amsterdam_utrecht.json");
  if (line.is_null()) GTEST_SKIP() << "no shared material";
  std::size_t telegrams = 0;
  for (const Json& group : line.at("balise_groups"))
    for (const Json& balise : group.at("balises")) {
      const std::string hex = balise.at("telegram_hex");
      const auto bits = bits_of_hex(hex);
      std::string text;
      ASSERT_TRUE(append_balise_json(text, bits->bytes, bits->bits)) << hex;
      const Json decoded = Json::parse(text);
      EXPECT_EQ(decoded.at("header"), balise.at("header"));
      const auto encoded = encode_balise_json(decoded);
      ASSERT_TRUE(encoded);
      EXPECT_EQ(hex_of_bits(encoded->bytes, encoded->bits), hex);
      ++telegrams;
    }
  EXPECT_EQ(telegrams, 206u);
  std::size_t messages = 0;
  for (const Json& message : line.at("rbc_messages")) {
    if (!message.contains("message_hex")) continue;
    const std::string hex = message.at("message_hex");
    const auto bits = bits_of_hex(hex);
    std::string text;
    const auto done = append_radio_json(text, bits->bytes, Direction::to_train, {1, 0});
    ASSERT_TRUE(done) << error_json(done.error());
    const auto encoded = encode_radio_json(Json::parse(text));
    ASSERT_TRUE(encoded) << error_json(encoded.error());
    EXPECT_EQ(hex_of_bits(encoded->bytes, encoded->bits), hex);
    ++messages;
  }
  EXPECT_EQ(messages, 57u);
}

std::string balise_error(const std::string& hex) {
  const auto bits = bits_of_hex(hex);
  if (!bits) return error_json(bits.error());
  std::string text = "before";
  const auto done = append_balise_json(text, bits->bytes, bits->bits);
  if (done) return text;
  EXPECT_EQ(text, "before");
  return error_json(done.error());
}

TEST(TelegramJson, SaysWhatIsWrong) {
  EXPECT_EQ(balise_error("9002G"), R"({"error":{"bit":16,"why":"not a hexadecimal digit: G"}})");
  EXPECT_EQ(balise_error(""), R"({"error":{"bit":0,"why":"no bits"}})");
  EXPECT_EQ(balise_error("9002FF"), R"({"error":{"bit":17,"variable":"M_MCOUNT","why":"ends inside a variable"}})");
  // No packet 255.
  EXPECT_EQ(balise_error("9002FFB540B00"), R"({"error":{"bit":52,"variable":"NID_PACKET","why":"no packet 255"}})");
}

TEST(TelegramJson, KeepsALaterYThatIsReadAsTheNewestKnownOne) {
  for (const unsigned M_VERSION : {0x30u, 0x31u, 0x35u, 0x3Fu}) {
    Json telegram = Json::parse(R"({"schema":"evc-telegram/1","header":{"Q_UPDOWN":1,"M_VERSION":0,"Q_MEDIA":0,
      "N_PIG":0,"N_TOTAL":0,"M_DUP":0,"M_MCOUNT":255,"NID_C":1,"NID_BG":2,"Q_LINK":1},
      "packets":[{"NID_PACKET":254,"Q_DIR":1,"L_PACKET":23}]})");
    telegram["header"]["M_VERSION"] = M_VERSION;
    telegram["system_version"] = std::to_string(M_VERSION >> 4) + "." + std::to_string(M_VERSION & 15);
    const auto encoded = encode_balise_json(telegram);
    ASSERT_TRUE(encoded) << error_json(encoded.error());
    std::string text;
    ASSERT_TRUE(append_balise_json(text, encoded->bytes, encoded->bits, Spare::accept));
    EXPECT_EQ(Json::parse(text), telegram);
  }
}

TEST(TelegramJson, KeepsTheFilling) {
  // The same telegram without filling, filled with ones to 830, and with other bits after packet 255.
  Json short_form = Json::parse(R"({"schema":"evc-telegram/1","system_version":"2.1","header":{"Q_UPDOWN":1,
    "M_VERSION":33,"Q_MEDIA":0,"N_PIG":0,"N_TOTAL":0,"M_DUP":0,"M_MCOUNT":255,"NID_C":1,"NID_BG":2,"Q_LINK":1},
    "packets":[{"NID_PACKET":254,"Q_DIR":1,"L_PACKET":23},{"NID_PACKET":99,"Q_DIR":0,"L_PACKET":30,"raw":"AA"}]})");
  for (const std::size_t bits : {0u, 210u, 830u}) {
    Json telegram = short_form;
    if (bits != 0) telegram["bits"] = bits;
    const auto encoded = encode_balise_json(telegram);
    ASSERT_TRUE(encoded) << error_json(encoded.error());
    EXPECT_EQ(encoded->bits, bits != 0 ? bits : 111u);
    const auto again = bits_of_hex(hex_of_bits(encoded->bytes, encoded->bits));
    std::string text;
    ASSERT_TRUE(append_balise_json(text, again->bytes, again->bits));
    EXPECT_EQ(Json::parse(text), telegram);
  }
  Json odd = short_form;
  odd["bits"] = 128;
  odd["padding"] = "12340";
  const auto encoded = encode_balise_json(odd);
  ASSERT_TRUE(encoded);
  std::string text;
  ASSERT_TRUE(append_balise_json(text, encoded->bytes, encoded->bits));
  EXPECT_EQ(Json::parse(text), odd);
}

/// Found by the fuzzer: with 27 bytes that end in zeros the form said `bits`, with its 210 bits it did not.
TEST(TelegramJson, ZerosAfterPacket255GiveTheSameFormAgain) {
  for (std::size_t data = 96; data <= 126; ++data) {  // packet 255 ends before, at and after bit 210
    Json telegram = Json::parse(R"({"schema":"evc-telegram/1","system_version":"2.1","header":{"Q_UPDOWN":1,
      "M_VERSION":33,"Q_MEDIA":0,"N_PIG":0,"N_TOTAL":0,"M_DUP":0,"M_MCOUNT":255,"NID_C":1,"NID_BG":2,"Q_LINK":1},
      "packets":[{"NID_PACKET":44,"Q_DIR":2,"NID_XUSER":0}]})");
    telegram["packets"][0]["L_PACKET"] = 32 + data;
    telegram["packets"][0]["OTHER_DATA"] = std::string(data, '0');
    const auto shortest = encode_balise_json(telegram);
    ASSERT_TRUE(shortest) << error_json(shortest.error());
    std::vector<std::uint8_t> bytes(shortest->bytes.begin(), shortest->bytes.end());
    bytes.resize(28);
    for (std::size_t bits = shortest->bits; bits <= 8 * bytes.size(); ++bits) {
      std::string form, again;
      ASSERT_TRUE(append_balise_json(form, bytes, bits));
      const auto encoded = encode_balise_json(Json::parse(form));
      ASSERT_TRUE(encoded) << error_json(encoded.error());
      ASSERT_TRUE(append_balise_json(again, encoded->bytes, encoded->bits));
      EXPECT_EQ(again, form) << shortest->bits << " of " << bits;
    }
  }
}

/// Found by the fuzzer: a header only.
TEST(TelegramJson, UnknownPacketWithoutContent) {
  const std::array<std::uint8_t, 3> bytes{0x5B, 0x00, 0x2E};
  std::string text;
  ASSERT_TRUE(append_packet_json(text, bytes, 24, Direction::to_train, {2, 0}));
  EXPECT_EQ(text, R"({"NID_PACKET":91,"Q_DIR":0,"L_PACKET":23,"raw":""})");
  const auto encoded = encode_packet_json(Json::parse(text));
  ASSERT_TRUE(encoded) << error_json(encoded.error());
  EXPECT_EQ(hex_of_bits(encoded->bytes, encoded->bits), "5B002E");
}

TEST(TelegramJson, RefusesWrongMembers) {
  const auto why = [](const char* text) {
    const auto encoded = encode_packet_json(Json::parse(text));
    return encoded ? "taken: " + hex_of_bits(encoded->bytes, encoded->bits) : error_json(encoded.error());
  };
  EXPECT_EQ(why(R"({"NID_PACKET":66,"Q_DIR":1,"NID_TSR":9})"), "taken: 42403E12");
  EXPECT_EQ(why(R"({"NID_PACKET":66,"Q_DIR":1})"),
            R"({"error":{"bit":0,"packet":66,"variable":"NID_TSR","why":"missing"}})");
  EXPECT_EQ(why(R"({"NID_PACKET":66,"Q_DIR":1,"NID_TSR":256})"),
            R"({"error":{"bit":0,"packet":66,"variable":"NID_TSR","value":256,"why":"needs more than its 8 bits"}})");
  EXPECT_EQ(why(R"({"NID_PACKET":66,"Q_DIR":1,"NID_TSR":-1})"),
            R"({"error":{"bit":0,"packet":66,"variable":"NID_TSR","why":"less than 0"}})");
  EXPECT_EQ(why(R"({"NID_PACKET":66,"Q_DIR":1,"NID_TSR":1,"D_TSR":2})"),
            R"({"error":{"bit":0,"packet":66,"variable":"D_TSR","why":"unknown member"}})");
  EXPECT_EQ(why(R"({"NID_PACKET":180,"Q_DIR":1,"Q_LSSMA":0,"T_LSSMA":2})"),
            R"({"error":{"bit":0,"packet":180,"variable":"T_LSSMA","why":"a member whose condition does not hold"}})");
  EXPECT_EQ(why(R"({"NID_PACKET":66.5})"), R"({"error":{"bit":0,"variable":"NID_PACKET","why":"expected a number"}})");
  EXPECT_EQ(why(R"([])"), R"({"error":{"bit":0,"variable":"packets","why":"expected objects"}})");
}

std::string packet_answer(const char* text, const EncodeOptions& options = {}) {
  const auto encoded = encode_packet_json(Json::parse(text), options);
  return encoded ? hex_of_bits(encoded->bytes, encoded->bits) : error_json(encoded.error());
}

/// "16" could be read as sixteen or as hexadecimal 22: only values that a JSON number cannot hold are strings.
/// What the bits cannot show must not contradict them.
TEST(TelegramJson, RefusesWhatItWouldIgnore) {
  const std::string header =
      R"("header":{"Q_UPDOWN":1,"M_VERSION":33,"Q_MEDIA":0,"N_PIG":0,"N_TOTAL":1,"M_DUP":0,"M_MCOUNT":255,"NID_C":1,)"
      R"("NID_BG":42,"Q_LINK":1},"packets":[])";
  const auto telegram = [&](const std::string& more) {
    const auto bits = encode_balise_json(nlohmann::json::parse("{" + more + header + "}"));
    return bits ? "" : bits.error().variable + ": " + bits.error().why;
  };
  EXPECT_EQ(telegram(R"("schema":"evc-telegram/1","system_version":"2.1",)"), "");
  EXPECT_EQ(telegram(R"("system_version":"1.0",)"), "system_version: not that of M_VERSION");
  EXPECT_EQ(telegram(R"("system_version":21,)"), "system_version: expected X.Y");
  EXPECT_EQ(telegram(R"("padding":"FF",)"), "padding: without \"bits\"");
  const auto message = [](const std::string& more, const EncodeOptions& options = {}) {
    const auto bits = encode_radio_json(
        nlohmann::json::parse("{" + more + R"("NID_MESSAGE":24,"T_TRAIN":1,"M_ACK":0,"NID_LRBG":1,"packets":[]})"),
        options);
    return bits ? "" : bits.error().variable + ": " + bits.error().why;
  };
  EXPECT_EQ(message(R"("schema":"evc-telegram/1","system_version":"2.1",)"), "");
  EXPECT_EQ(message(R"("schema":"x/1",)"), "schema: expected evc-telegram/1");
  EXPECT_EQ(message(R"("system_version":[1],)", {lang::Direction::to_train, lang::SystemVersion{2, 1}}),
            "system_version: expected X.Y");
}

TEST(TelegramJson, HexadecimalOnlyWhereNumbersEnd) {
  EXPECT_EQ(packet_answer(R"({"NID_PACKET":66,"Q_DIR":1,"NID_TSR":"16"})"),
            R"({"error":{"bit":0,"packet":66,"variable":"NID_TSR","why":"expected a number"}})");
  EXPECT_EQ(packet_answer(R"({"NID_PACKET":"42","Q_DIR":1,"NID_TSR":9})"),
            R"({"error":{"bit":0,"variable":"NID_PACKET","why":"expected a number"}})");
  const char* const session = R"({"NID_PACKET":42,"Q_DIR":1,"Q_RBC":1,"NID_C":1,"NID_RBC":2,
    "NID_RADIO":"0123456789ABCDEF","Q_SLEEPSESSION":0})";
  const std::string hex = packet_answer(session, {Direction::to_train, {}});
  const auto bits = bits_of_hex(hex);
  ASSERT_TRUE(bits) << hex;
  std::string text;
  ASSERT_TRUE(append_packet_json(text, bits->bytes, bits->bits, Direction::to_train, {2, 1}));
  EXPECT_EQ(Json::parse(text).at("NID_RADIO"), "0123456789ABCDEF");
  EXPECT_EQ(packet_answer(text.c_str()), hex);
}

TEST(TelegramJson, GivenLengthsAndCountersAreChecked) {
  EXPECT_EQ(packet_answer(R"({"NID_PACKET":66,"Q_DIR":1,"L_PACKET":31,"NID_TSR":9})"), "42403E12");
  EXPECT_EQ(packet_answer(R"({"NID_PACKET":66,"Q_DIR":1,"L_PACKET":32,"NID_TSR":9})"),
            R"({"error":{"bit":0,"packet":66,"variable":"L_PACKET","value":32,"why":"found 32, expected 31"}})");
  EXPECT_EQ(packet_answer(R"({"NID_PACKET":66,"Q_DIR":1,"L_PACKET":"1F","NID_TSR":9})"),
            R"({"error":{"bit":0,"packet":66,"variable":"L_PACKET","why":"expected a number"}})");
  Json linking = Json::parse(R"({"NID_PACKET":5,"Q_DIR":1,"Q_SCALE":1,"D_LINK":1162,"Q_NEWCOUNTRY":0,"NID_BG":353,
    "Q_LINKORIENTATION":1,"Q_LINKREACTION":2,"Q_LOCACC":5,"N_ITER":0,"links":[]})");
  EXPECT_TRUE(encode_packet_json(linking));
  linking["N_ITER"] = 1;
  EXPECT_EQ(packet_answer(linking.dump().c_str()),
            R"({"error":{"bit":0,"packet":5,"variable":"N_ITER","value":1,"why":"found 1, expected 0"}})");
  Json telegram = Json::parse(R"({"header":{"Q_UPDOWN":1,"M_VERSION":33,"Q_MEDIA":0,"N_PIG":0,"N_TOTAL":0,"M_DUP":0,
    "M_MCOUNT":255,"NID_C":1,"NID_BG":2,"Q_LINK":1},"packets":[{"NID_PACKET":254,"Q_DIR":1,"L_PACKET":23}]})");
  EXPECT_TRUE(encode_balise_json(telegram));
  telegram["packets"][0]["L_PACKET"] = 24;
  const auto in_telegram = encode_balise_json(telegram);
  ASSERT_FALSE(in_telegram);
  EXPECT_EQ(error_json(in_telegram.error()),
            R"({"error":{"bit":0,"packet":254,"variable":"L_PACKET","value":24,"why":"found 24, expected 23"}})");
  Json message = Json::parse(R"({"NID_MESSAGE":24,"L_MESSAGE":10,"T_TRAIN":1,"M_ACK":0,"NID_LRBG":16777215,
    "packets":[]})");
  EXPECT_TRUE(encode_radio_json(message));
  message["L_MESSAGE"] = 11;
  const auto in_message = encode_radio_json(message);
  ASSERT_FALSE(in_message);
  EXPECT_EQ(error_json(in_message.error()),
            R"({"error":{"bit":0,"variable":"L_MESSAGE","value":11,"why":"found 11, expected 10"}})");
}

TEST(TelegramJson, NamesTheMisspeltMember) {
  EXPECT_EQ(packet_answer(R"({"NID_PACKET":66,"Q_DIR":1,"NID_TSRX":9})"),
            R"({"error":{"bit":0,"packet":66,"variable":"NID_TSRX","why":"unknown member"}})");
  const auto header = encode_balise_json(Json::parse(R"({"header":{"Q_UPDOWNX":1}})"));
  ASSERT_FALSE(header);
  EXPECT_EQ(header.error().variable, "Q_UPDOWNX");
  const auto message = encode_radio_json(Json::parse(R"({"NID_MESSAGE":24,"T_TRAINX":1})"));
  ASSERT_FALSE(message);
  EXPECT_EQ(message.error().variable, "T_TRAINX");
  EXPECT_EQ(message.error().why, "unknown member");
}

TEST(TelegramJson, SignedReference) {
  const Json message =
      Json::parse(R"({"NID_MESSAGE":15,"L_MESSAGE":15,"T_TRAIN":1,"M_ACK":0,"NID_LRBG":16777215,"NID_EM":3,
    "Q_SCALE":1,"D_REF":-7,"Q_DIR":1,"D_EMERGENCYSTOP":200,"packets":[]})");
  const auto encoded = encode_radio_json(message);
  ASSERT_TRUE(encoded) << error_json(encoded.error());
  std::string text;
  const auto done = append_radio_json(text, encoded->bytes, Direction::to_train, {2, 1});
  ASSERT_TRUE(done) << error_json(done.error());
  EXPECT_EQ(Json::parse(text), message);
}

}  // namespace
}  // namespace evc::io
