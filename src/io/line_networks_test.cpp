#include "io/line_networks.h"

#include <gtest/gtest.h>

namespace evc::io {
namespace {

TEST(LineNetworks, AreReadWithTheirDigits) {
  const auto networks =
      read_networks(R"({"radio_networks":{"offered":["26202","26201"],"along_line":"26201"}})", "l.json");
  ASSERT_TRUE(networks) << networks.error().text();
  ASSERT_EQ(networks->offered.size(), 2u);
  EXPECT_EQ(networks->offered[0], 0x26202Fu);
  EXPECT_EQ(networks->offered[1], 0x26201Fu);
  EXPECT_EQ(networks->along_line, 0x26201Fu);
}

TEST(LineNetworks, AreNoneWithoutTheKey) {
  const auto networks = read_networks("{}", "l.json");
  ASSERT_TRUE(networks) << networks.error().text();
  EXPECT_TRUE(networks->offered.empty());
  EXPECT_FALSE(networks->along_line);
}

TEST(LineNetworks, AFaultNamesItsPlace) {
  const auto said = [](const std::string& networks) {
    const auto read = read_networks(R"({"radio_networks":)" + networks + "}", "l.json");
    return read ? "nothing" : read.error().text();
  };
  EXPECT_EQ(said(R"({"offered":["x"]})"),
            "l.json: /radio_networks/offered/0: found \"x\", expected 1 to 6 decimal digits");
  EXPECT_EQ(said(R"({"along_line":"1234567"})"),
            "l.json: /radio_networks/along_line: found \"1234567\", expected 1 to 6 decimal digits");
  EXPECT_NE(said(R"({"other":1})").find("/radio_networks"), std::string::npos);
  std::string many = "[\"1\"";
  for (int n = 0; n < 16; ++n) many += ",\"1\"";
  EXPECT_NE(said("{\"offered\":" + many + "]}").find("at most 16 networks"), std::string::npos);
}

}  // namespace
}  // namespace evc::io
