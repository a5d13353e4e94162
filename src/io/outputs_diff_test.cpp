#include "io/outputs_diff.h"

#include <gtest/gtest.h>

namespace evc::io {
namespace {

std::string shown(std::string_view a, std::string_view b) {
  const auto found = difference(a, "a", b, "b");
  if (!found) return found.error().text();
  return *found ? text_of(**found, "a", "b") : "same";
}

TEST(OutputsDiff, NothingWhereTheBytesAreTheSame) {
  EXPECT_EQ(shown("", ""), "same");
  EXPECT_EQ(shown("{\"t_ms\":0}\nno JSON\n", "{\"t_ms\":0}\nno JSON\n"), "same");
}

TEST(OutputsDiff, FirstDifferingLineFieldByField) {
  const char* a =
      "{\"t_ms\":0,\"mode\":\"SB\"}\n"
      "{\"t_ms\":100,\"mode\":\"SB\",\"V_P\":null,\"events\":[\"x\",\"y\"],\"driver\":{\"symbols\":[\"MO13\"]},\"old\":"
      "1}\n"
      "{\"t_ms\":200}\n";
  const char* b =
      "{\"t_ms\":0,\"mode\":\"SB\"}\n"
      "{\"t_ms\":100,\"mode\":\"FS\",\"V_P\":12.5,\"events\":[\"x\"],\"driver\":{\"symbols\":[\"MO11\"]},\"a/"
      "b\":true}\n"
      "{\"t_ms\":300}\n";
  EXPECT_EQ(shown(a, b),
            "a and b differ first in line 2, t_ms 100\n"
            "  /V_P: null | 12.5\n"
            "  /driver/symbols/0: \"MO13\" | \"MO11\"\n"
            "  /events/1: \"y\" | nothing\n"
            "  /mode: \"SB\" | \"FS\"\n"
            "  /old: 1 | nothing\n"
            "  /a~1b: nothing | true\n"
            "2 lines differ of 3 | 3\n");
}

TEST(OutputsDiff, OneStreamEnds) {
  EXPECT_EQ(shown("{}\n", "{}\n{}\n{}\n"),
            "a and b differ first in line 2\n  a ends before it\n2 lines differ of 1 | 3\n");
  EXPECT_EQ(shown("{}\n", ""), "a and b differ first in line 1\n  b ends before it\n1 lines differ of 1 | 0\n");
}

TEST(OutputsDiff, ASpellingIsADifferenceToo) {
  EXPECT_EQ(shown("{\"a\":1}\n", "{\"a\": 1}\n"),
            "a and b differ first in line 1\n  the values are the same, only their notation differs\n"
            "1 lines differ of 1 | 1\n");
}

TEST(OutputsDiff, ADifferingLineThatIsNoJsonIsRefused) {
  EXPECT_EQ(shown("{}\n{\"a\":}\n", "{}\n{}\n").rfind("a: line 2", 0), 0U);
  EXPECT_EQ(shown("{}\n", "what\n").rfind("b: line 1", 0), 0U);
}

}  // namespace
}  // namespace evc::io
