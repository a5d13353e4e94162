#include "io/json.h"

#include <gtest/gtest.h>

namespace evc::io {
namespace {

std::string parse_error(const std::string& text, const std::string& where = "") {
  const auto read = guarded([&] { return parse_json(text, "f.json", where); });
  return read ? "" : read.error().text();
}

TEST(Json, AKeyGivenTwiceIsAnErrorWithItsPlace) {
  EXPECT_EQ(parse_error(R"({"a":1,"a":1})"), "f.json: /a: found a key given twice, expected each key once");
  EXPECT_EQ(parse_error(R"({"a":[0,{"b/c":{"d":1,"e":[],"d":2}}]})"),
            "f.json: /a/1/b~1c/d: found a key given twice, expected each key once");
  EXPECT_EQ(parse_error(R"({"t_ms":1,"t_ms":2})", "line 7"),
            "f.json: line 7 /t_ms: found a key given twice, expected each key once");
  // The same key in different objects is none.
  EXPECT_EQ(parse_error(R"({"a":{"a":1},"b":{"a":1},"c":[{"a":1},{"a":1}]})"), "");
}

TEST(Json, IsAsDeepAsTheLimitAndNotDeeper) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(parse_error(nested(kDeepestJson)), "");
  const std::string refused = parse_error(nested(kDeepestJson + 1));
  EXPECT_NE(refused.find("found more than 64 arrays and objects in one another, expected at most 64"),
            std::string::npos)
      << refused;
  std::string objects;
  for (std::size_t i = 0; i <= kDeepestJson; ++i) objects += "{\"a\":";
  EXPECT_NE(parse_error(objects).find("expected at most 64"), std::string::npos)
      << "reported before the end of the text";
}

TEST(Json, ReadsEveryKindOfValue) {
  const auto read = guarded([] {
    return parse_json(R"({"n":null,"t":true,"i":-5,"u":18446744073709551615,"f":0.5,"s":"x\u00e9","a":[1,[2],{}]})",
                      "f.json");
  });
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->dump(),
            "{\"a\":[1,[2],{}],\"f\":0.5,\"i\":-5,\"n\":null,\"s\":\"x\xc3\xa9\",\"t\":true,"
            "\"u\":18446744073709551615}");
}

TEST(Json, ErrorsNameLineAndColumn) {
  EXPECT_EQ(parse_error("{\n \"a\": x}"), "f.json: line 2 column 7: found \"x}\", expected JSON");
  EXPECT_EQ(parse_error("[1"), "f.json: line 1 column 3: found the end of the text, expected JSON");
  EXPECT_EQ(parse_error("[1,1e999]"), "f.json: line 1 column 4: found a number out of range, expected JSON");
}

/// Standard error is UTF-8 whatever the input is, and a terminal gets no control characters.
TEST(Diagnostic, BytesThatAreNoTextAreEscaped) {
  EXPECT_EQ(parse_error("{\"a\":\xff\xfe}"), "f.json: line 1 column 6: found \"\\xFF\\xFE}\", expected JSON");
  const auto shown = [](const std::string& found) { return Diagnostic{"f", "", found, ""}.text(); };
  EXPECT_EQ(shown("Z\xc3\xbcrich \xe2\x82\xac \xf0\x9f\x9a\x86"),
            "f: found Z\xc3\xbcrich \xe2\x82\xac \xf0\x9f\x9a\x86");
  EXPECT_EQ(shown("cut \xc3"), "f: found cut \\xC3");
  EXPECT_EQ(shown("overlong \xc0\xaf, surrogate \xed\xa0\x80, too far \xf4\x90\x80\x80"),
            "f: found overlong \\xC0\\xAF, surrogate \\xED\\xA0\\x80, too far \\xF4\\x90\\x80\\x80");
  EXPECT_EQ(shown("escape \x1b[2J, C1 \xc2\x9b"), "f: found escape  [2J, C1 \\xC2\\x9B");
  EXPECT_EQ(Diagnostic({"\xfe.json", "", "x", ""}).text(), "\\xFE.json: found x");
  // Cut between characters, not inside one.
  std::string accents;
  for (int i = 0; i < 300; ++i) accents += "\xc3\xa9";
  EXPECT_EQ(shown("a" + accents), "f: found a" + accents.substr(0, 200) + "...");
  EXPECT_EQ(parse_error("[x1234567890123456\xc3\xa9\xc3\xa9"),
            "f.json: line 1 column 2: found \"x1234567890123456\xc3\xa9\", expected JSON");
}

}  // namespace
}  // namespace evc::io
