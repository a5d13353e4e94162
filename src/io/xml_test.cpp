#include "io/xml.h"

#include <gtest/gtest.h>

namespace evc::io {
namespace {

TEST(Xml, CharactersOfTheMarkUpAreEscapedAndControlCharactersAreSpaces) {
  EXPECT_EQ(escaped_xml("a < b & c > \"d\""), "a &lt; b &amp; c &gt; &quot;d&quot;");
  EXPECT_EQ(escaped_xml(std::string("\0\t\n\x1F|", 5)), "    |");
  EXPECT_EQ(escaped_xml("Z\u00FCrich"), "Z\u00FCrich");
}

}  // namespace
}  // namespace evc::io
