#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "base/test_paths.h"
#include "io/telegram_explain.h"
#include "io/telegram_json.h"
#include "lang/layouts.h"
#include "lang/message_table.h"

namespace evc::io {
namespace {

using lang::Direction;

std::string text_of_file(const std::string& path) {
  std::ifstream file(evc::test::source_folder() + "/" + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// After a change of a layout: tools/make_packet_pages.
TEST(LanguagePages, AreUpToDate) {
  std::set<std::string> names{"README.md"};
  EXPECT_EQ(text_of_file("docs/packets/README.md"), packet_index_page());
  for (const lang::PacketLayout& l : lang::packet_layouts()) {
    const std::string name = packet_page_name(l.info->NID_PACKET, l.info->direction);
    names.insert(name);
    EXPECT_EQ(text_of_file("docs/packets/" + name), describe_packet(l.info->NID_PACKET, l.info->direction, true))
        << name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(evc::test::source_folder() + "/docs/packets"))
    EXPECT_EQ(names.count(entry.path().filename().string()), 1u) << entry.path();
  EXPECT_EQ(text_of_file("data/schema/evc-telegram.json"), telegram_schema());
}

TEST(LanguagePages, SchemaIsJson) {
  const auto schema = nlohmann::json::parse(telegram_schema());
  EXPECT_EQ(schema.at("$defs").at("packet").at("anyOf").size(), lang::packet_layouts().size() + 1);
  EXPECT_EQ(schema.at("$defs").at("message").at("anyOf").size(), lang::message_layouts().size());
}

TEST(LanguagePages, EveryVariableAndMessageHasText) {
  for (const lang::VariableInfo& v : lang::variables()) {
    EXPECT_NE(describe_variable(v.key, false).find(v.about), std::string::npos) << v.key;
    EXPECT_FALSE(describe_variable(v.name, true).empty());
  }
  for (const lang::MessageRules& m : lang::message_rules()) {
    EXPECT_NE(describe_message(m.NID_MESSAGE, false).find(m.name), std::string::npos);
    EXPECT_NE(describe_message(m.NID_MESSAGE, true).find(m.ref), std::string::npos);
  }
  EXPECT_EQ(describe_packet(1, Direction::to_train, false), "");
  EXPECT_EQ(describe_message(1, false), "");
  EXPECT_EQ(describe_variable("V_NOTHING", false), "");
  EXPECT_NE(list_packets().find("Linking"), std::string::npos);
  EXPECT_NE(list_messages().find("SR authorisation"), std::string::npos);
  EXPECT_NE(list_variables().find("V_STATIC"), std::string::npos);
}

std::string meaning(const char* variable, std::uint64_t code, std::uint64_t scale = 1) {
  return meaning_of(*lang::find_variable(variable), code, scale);
}

TEST(Meaning, OfCodes) {
  EXPECT_EQ(meaning("D_LINK", 1234, 0), "123.4 m");
  EXPECT_EQ(meaning("D_LINK", 1234, 1), "1234 m");
  EXPECT_EQ(meaning("D_LINK", 1234, 2), "12340 m");
  EXPECT_EQ(meaning("D_LINK", 1234, 3), "scale unknown");
  EXPECT_EQ(meaning("D_REF", 0xFFF9), "-7 m");
  EXPECT_EQ(meaning("V_STATIC", 28), "140 km/h");
  EXPECT_EQ(meaning("V_STATIC", 127), "end of profile");
  EXPECT_EQ(meaning("V_STATIC", 121), "SPARE");
  EXPECT_EQ(meaning("T_TRAIN", 12345), "123.45 s");
  EXPECT_EQ(meaning("A_NVP12", 63), "3.15 m/s\xC2\xB2");
  EXPECT_EQ(meaning("G_A", 7), "7 \xE2\x80\xB0");
  EXPECT_EQ(meaning("M_NVKVINT", 35), "0.7");
  EXPECT_EQ(meaning("M_AXLELOAD", 45), "22.5 t");
  EXPECT_EQ(meaning("L_NVKRINT", 7), "300 m");
  EXPECT_EQ(meaning("Q_SCALE", 0), "0.1 m");
  EXPECT_EQ(meaning("Q_DIR", 1), "nominal");
  EXPECT_EQ(meaning("M_VERSION", 33), "2.1");
  EXPECT_EQ(meaning("M_VERSION", 35), "2.3");
  EXPECT_EQ(meaning("NID_OPERATIONAL", 0x1234FFFF), "1234");
  EXPECT_EQ(meaning("NID_OPERATIONAL", 0x12A4FFFF), "SPARE");
  EXPECT_EQ(meaning("NID_MN", 0xFFFFFF), "no digits");
  EXPECT_EQ(meaning("NID_LRBG", (426u << 14) | 352), "NID_C 426, NID_BG 352");
  EXPECT_EQ(meaning("M_LINEGAUGE", 5), "G1 + GB");
  EXPECT_EQ(meaning("NC_TRAIN", 8), "bit 3");
  EXPECT_EQ(meaning("Q_MARQSTREASON", 0), "none");
  EXPECT_EQ(meaning("X_TEXT", 65), "'A'");
  EXPECT_EQ(meaning("X_TEXT", 0xE9), "'\xC3\xA9'");
  EXPECT_EQ(meaning("X_TEXT", 10), "control character");
  EXPECT_EQ(meaning("M_TRACTION", 200), "no meaning given");
  EXPECT_EQ(meaning("NID_BG", 12), "");
}

TEST(Explain, Tables) {
  const auto bits = bits_of_hex("9002FFB540B00B501790210FFF8");
  const std::string text = explain_balise(bits->bytes, bits->bits);
  EXPECT_NE(text.find("balise telegram, system version 1.0\n"), std::string::npos);
  EXPECT_NE(text.find("   73  NID_MN                              2114079  20421\n"), std::string::npos) << text;
  EXPECT_NE(text.find("packet 255  End of information"), std::string::npos);
  // A truncated telegram.
  EXPECT_NE(explain_balise(bits->bytes, 90).find("! not consistent"), std::string::npos);
  // An unknown packet, a text, a group, bits of an application.
  const auto packet = [](const char* json) {
    const auto encoded = encode_packet_json(nlohmann::json::parse(json));
    if (!encoded) return error_json(encoded.error());
    return explain_packet(encoded->bytes, encoded->bits, Direction::to_train, {2, 1});
  };
  EXPECT_NE(packet(R"({"NID_PACKET":99,"Q_DIR":1,"L_PACKET":24,"raw":"8"})").find("unknown in this version"),
            std::string::npos);
  const std::string text_packet =
      packet(R"({"NID_PACKET":72,"Q_DIR":1,"Q_SCALE":1,"Q_TEXTCLASS":0,"Q_TEXTDISPLAY":0,"D_TEXTDISPLAY":0,
        "M_MODETEXTDISPLAY_START":15,"M_LEVELTEXTDISPLAY_START":5,"L_TEXTDISPLAY":1,"T_TEXTDISPLAY":1,
        "M_MODETEXTDISPLAY_END":15,"M_LEVELTEXTDISPLAY_END":5,"Q_TEXTCONFIRM":0,"text":[{"X_TEXT":72},{"X_TEXT":105}]})");
  EXPECT_NE(text_packet.find("\"Hi\""), std::string::npos) << text_packet;
  EXPECT_NE(packet(R"({"NID_PACKET":44,"Q_DIR":1,"NID_XUSER":1,"OTHER_DATA":"10101"})").find("A8"), std::string::npos);
  EXPECT_NE(packet(R"({"NID_PACKET":63,"Q_DIR":1,"groups":[{"Q_NEWCOUNTRY":0,"NID_BG":7}]})").find("groups 1"),
            std::string::npos);
  // Messages.
  const auto message =
      encode_radio_json(nlohmann::json::parse(R"({"NID_MESSAGE":156,"T_TRAIN":1,"NID_ENGINE":2,"packets":[]})"));
  ASSERT_TRUE(message);
  EXPECT_NE(explain_radio(message->bytes, Direction::to_track, {2, 1}).find("Termination of a session"),
            std::string::npos);
  EXPECT_NE(explain_radio(message->bytes, Direction::to_train, {2, 1}).find("! unknown message"), std::string::npos);
}

}  // namespace
}  // namespace evc::io
