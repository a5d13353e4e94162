#include "terms/clause.h"

#include <gtest/gtest.h>

namespace evc {
namespace {

TEST(Clause, NamesAParagraphOfTheRegister) {
  constexpr Clause c = "3.8.6"_srs;
  EXPECT_TRUE(static_cast<bool>(c));
  EXPECT_EQ(kSrsClauses[c.place_in_register()], "3.8.6");
  EXPECT_EQ(c.bullet(), '\0');
  EXPECT_EQ(c.exception(), 0u);
}

TEST(Clause, NamesTheInfillColumnOfItsTable) {
  const Clause c = "4.8.4 infill"_srs;
  EXPECT_TRUE(c.infill());
  EXPECT_FALSE("4.8.4"_srs.infill());
  EXPECT_EQ(c.bullet(), '\0');
  EXPECT_EQ(c.exception(), 0u);
  EXPECT_EQ(kSrsClauses[c.place_in_register()], "4.8.4");
}

TEST(Clause, NamesABulletOfIt) {
  constexpr Clause c = "5.8.4.1 h"_srs;
  EXPECT_EQ(kSrsClauses[c.place_in_register()], "5.8.4.1");
  EXPECT_EQ(c.bullet(), 'h');
  EXPECT_EQ(c.exception(), 0u);
  EXPECT_NE(c, "5.8.4.1 a"_srs);
  EXPECT_NE(c, "5.8.4.1"_srs);
}

TEST(Clause, NamesAnExceptionOfATable) {
  constexpr Clause c = "4.8.3 [14]"_srs;
  EXPECT_EQ(kSrsClauses[c.place_in_register()], "4.8.3");
  EXPECT_EQ(c.exception(), 14u);
  EXPECT_EQ(c.bullet(), '\0');
  EXPECT_EQ(c, "4.8.3"_srs.exception(14));
  EXPECT_EQ("4.8.3"_srs.exception(0), "4.8.3"_srs);
}

TEST(Clause, NoneIsNone) {
  EXPECT_FALSE(static_cast<bool>(Clause{}));
  EXPECT_NE(Clause{}, "3.10.2.2"_srs);  // the first of the register
}

TEST(Clause, IsFourBytes) { static_assert(sizeof(Clause) == 4); }

}  // namespace
}  // namespace evc
