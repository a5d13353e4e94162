#include "io/line_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/test_paths.h"
#include "io/file.h"

namespace evc::io {
namespace {

const char* kSmall = R"({"schema":"etcs-line/1","name":"small","length_m":100,"anything":1,
  "balise_groups":[{"seq":0,"balises":[{"position_m":50,"telegram_hex":"9002FFB540B0","telegram_bits":45},
                                       {"position_m":20,"telegram_hex":"90"}]}],
  "rbc_messages":[{"seq":2,"trigger":{"position_m":30,"delay_s":4},"message_hex":"180014"},
                  {"seq":1,"trigger":{"position_m":10},"missing_raw":true}],
  "physical_track":{"gradient":[{"start_m":0,"end_m":100,"gradient_permille":-5}],
                    "ssp":[{"start_m":0,"end_m":100,"v_kmh":80}],
                    "level_transitions":[{"position_m":-60,"levels":[2]},{"position_m":50,"levels":[3]}]}})";

std::string line_error(const char* text) {
  const auto line = read_line(text, "l.json");
  return line ? "" : line.error().text();
}

TEST(LineFile, ReadsWhatTheContractNames) {
  const auto line = read_line(kSmall, "l.json");
  ASSERT_TRUE(line) << line.error().text();
  EXPECT_EQ(line->groups, 1u);
  ASSERT_EQ(line->balises.size(), 2u);
  EXPECT_EQ(line->balises[0].position_m, 20.0);
  EXPECT_EQ(line->balises[1].telegram.size, 45u);
  EXPECT_EQ(line->balises[1].telegram.number(1, 7), 16u);
  ASSERT_EQ(line->radio.size(), 1u);
  EXPECT_EQ(line->radio[0].delay_s, 4.0);
  EXPECT_EQ(line->absent_messages, 1u);
  EXPECT_EQ(line->start_front_m, -50.0);
  EXPECT_EQ(line->start_level, Level::L1);  // the transition in rear of the start: M_LEVELTR 2 is level 1
  EXPECT_EQ(line->ssp[0].kmh, 80.0);
}

TEST(LineFile, ErrorsNameTheJsonPointer) {
  EXPECT_EQ(line_error(R"({"schema":"etcs-line/1","name":"x","length_m":1,"balise_groups":[{"balises":[
    {"position_m":0,"telegram_hex":"90G2"}]}]})"),
            "l.json: /balise_groups/0/balises/0/telegram_hex: found \"G\" at digit 3, expected hexadecimal digits");
  EXPECT_EQ(line_error(R"({"schema":"etcs-line/1","name":"x","length_m":1,"balise_groups":[{"balises":[
    {"telegram_hex":"90"}]}]})"),
            "l.json: /balise_groups/0/balises/0: found no key \"position_m\", expected one");
  EXPECT_NE(line_error(R"({"schema":"etcs-line/1","name":"x","length_m":1,"balise_groups":[{"balises":[
    {"position_m":0,"telegram_hex":"90","telegram_bits":9}]}]})")
                .find("telegram_bits"),
            std::string::npos);
}

TEST(LineFile, EveryKeyHasItsType) {
  const auto with = [](const std::string& more) {
    return line_error((R"({"schema":"etcs-line/1","name":"x","length_m":1,
      "balise_groups":[{"balises":[{"position_m":0,"telegram_hex":"90"}]}],)" +
                       more + "}")
                          .c_str());
  };
  EXPECT_EQ(with(R"("physical_track":{})"), "");
  for (const std::string wrong : {"\"gradient -30\"", "1", "true", "[]", "null"}) {
    EXPECT_NE(with("\"physical_track\":" + wrong).find("/physical_track: found "), std::string::npos) << wrong;
    EXPECT_NE(with("\"start\":" + wrong).find("/start: found "), std::string::npos) << wrong;
    EXPECT_NE(with("\"rbc\":" + wrong).find("/rbc: found "), std::string::npos) << wrong;
    const bool list = wrong == "[]";
    EXPECT_EQ(with("\"rbc_messages\":" + wrong).find("/rbc_messages: found ") == std::string::npos, list) << wrong;
    EXPECT_NE(with("\"rbc_messages\":[" + wrong + "]").find("/rbc_messages/0: found "), std::string::npos) << wrong;
    for (const std::string key : {"gradient", "ssp", "level_transitions"}) {
      EXPECT_EQ(with("\"physical_track\":{\"" + key + "\":" + wrong + "}").find("/" + key) == std::string::npos, list)
          << key << wrong;
      EXPECT_NE(with("\"physical_track\":{\"" + key + "\":[" + wrong + "]}").find("/physical_track/" + key + "/0"),
                std::string::npos);
    }
  }
}

/// The contact that the driver enters and what the RBC answers to a request for shunting (contract line.md).
TEST(LineFile, TheRbc) {
  const auto line = [](const std::string& more) {
    return read_line(R"({"schema":"etcs-line/1","name":"x","length_m":1,"start":{"level":"2"},)" + more +
                         R"("balise_groups":[{"balises":[{"position_m":0,"telegram_hex":"A10000802015"}]}]})",
                     "l.json");
  };
  const auto given = line(R"("rbc":{"NID_C":3,"NID_RBC":4,"NID_RADIO":"0041790000000001","shunting":"grant"},)");
  ASSERT_TRUE(given) << given.error().text();
  EXPECT_EQ(given->rbc.contact.NID_C, 3);
  EXPECT_EQ(given->rbc.contact.NID_RBC, 4);
  EXPECT_EQ(given->rbc.contact.NID_RADIO, 0x0041790000000001u);
  EXPECT_TRUE(given->rbc.grants_shunting);
  // Without one the country is that of the first balise.
  const auto absent = line("");
  ASSERT_TRUE(absent) << absent.error().text();
  EXPECT_EQ(absent->rbc.contact.NID_C, absent->balises[0].telegram.number(25, 10));
  EXPECT_FALSE(absent->rbc.grants_shunting);
  EXPECT_NE(line(R"("rbc":{"NID_C":3,"NID_RBC":4,"NID_RADIO":"1"},)").error().text().find("16 digits"),
            std::string::npos);
  // 7.5.1.95: decimal digits, then F.
  for (const char* wrong : {"004179000000000A", "E041790000000001", "00417900F0000001", "FFFFFFFFFFFFFFF0"}) {
    const auto refused = line(R"("rbc":{"NID_C":3,"NID_RBC":4,"NID_RADIO":")" + std::string(wrong) + R"("},)");
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().text(), "l.json: /rbc/NID_RADIO: found \"" + std::string(wrong) +
                                          "\", expected 16 digits: decimal ones, filled up with F");
  }
  for (const char* right : {"0041790000000001", "0041790FFFFFFFFF", "FFFFFFFFFFFFFFFF"})
    EXPECT_TRUE(line(R"("rbc":{"NID_C":3,"NID_RBC":4,"NID_RADIO":")" + std::string(right) + R"("},)")) << right;
}

TEST(LineFile, WithoutBitsIsRefused) {
  const std::string error = line_error(R"({"schema":"etcs-line/1","name":"x","length_m":1,
    "balise_groups":[{"balises":[{"position_m":0}]},{"balises":[]}]})");
  EXPECT_EQ(error,
            "l.json: /balise_groups: found 2 groups, 1 balises without bits, expected telegram_hex in at least one: "
            "the on-board reads bits");
}

TEST(LineFile, TheRecordedLine) {
  const std::string file = evc::test::shared_folder() + "/lines/amsterdam_utrecht.json";
  const auto text = read_text(file);
  if (!text) GTEST_SKIP() << "needs " << file;
  const auto line = read_line(*text, file);
  ASSERT_TRUE(line) << line.error().text();
  EXPECT_EQ(line->groups, 103u);
  EXPECT_EQ(line->balises.size(), 206u);
  EXPECT_EQ(line->radio.size(), 57u);
  EXPECT_EQ(line->absent_messages, 1u);
  EXPECT_EQ(line->start_level, Level::NTC);
}

TEST(LineFile, SyntheticLinesWithoutBitsAreRefused) {
  const std::string folder = evc::test::shared_folder() + "/lines";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "needs " << folder;
  for (const char* name : {"envsim_us13.json", "envsim_us14.json", "envsim_test.json"}) {
    const auto text = read_text(folder + "/" + name);
    ASSERT_TRUE(text);
    const auto line = read_line(*text, name);
    ASSERT_FALSE(line) << name;
    EXPECT_NE(line.error().text().find("without bits"), std::string::npos);
  }
}

}  // namespace
}  // namespace evc::io
