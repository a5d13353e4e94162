#include <gtest/gtest.h>

#include "balise/linking.h"
#include "balise/train_test.h"

// A group announced with unknown identity (3.4.4.4.2.1, 3.4.4.4.4), and the supervision against a second one
// (3.16.2.7.2).
namespace evc::balise {
namespace {

using test::announce;
using test::entry;
using test::Train;

constexpr std::uint16_t kUnknownId = kIdentityUnknown;

void pass_with(Train& t, double x, std::uint16_t NID_BG, const test::Bits& packet, bool nominal = true) {
  for (unsigned i = 0; i < 2; ++i) {
    test::Balise b{NID_BG, nominal ? i : 1 - i, 1};
    if (b.N_PIG == 0) b.packets = {packet};
    t.read_at(x + 3 * i, b);
  }
}

TEST(Repositioning, AGroupThatQualifiesIsTaken) {
  Train t;
  announce(t, {entry(100, 1), entry(1500, kUnknownId, Reaction::trip, 10)});
  t.pass(100, 1);
  EXPECT_EQ(first_possible(t.state.linking, *expected(t.state.linking)), Place{100_m});
  EXPECT_EQ(last_possible(*expected(t.state.linking)), Place{1610_m});
  pass_with(t, 700, 50, test::repositioning(1));
  EXPECT_TRUE(t.last().accepted);
  EXPECT_TRUE(t.last().repositioning);
  EXPECT_TRUE(t.last().lrbg_compliant);
  EXPECT_FALSE(t.last().link_place);  // measured
  EXPECT_EQ(t.last().Q_LOCACC, 10_m);
  EXPECT_EQ(expected(t.state.linking), nullptr);
  t.run_to(1700);
  EXPECT_EQ(t.reaction, Reaction::none);
}

TEST(Repositioning, Rows20To22OthersAreNot) {
  Train t;
  announce(t, {entry(1500, kUnknownId, Reaction::trip, 10)});
  pass_with(t, 100, 50, test::repositioning(0));  // not for this direction
  EXPECT_EQ(t.last().finding, Finding::not_repositioning);
  pass_with(t, 200, 51, test::directional(2));  // row 22
  EXPECT_EQ(t.last().finding, Finding::not_repositioning);
  pass_with(t, 300, 52, test::repositioning(0), false);  // row 20
  EXPECT_EQ(t.last().finding, Finding::not_repositioning);
  test::Balise single{53, 0, 0};  // row 21
  single.packets = {test::repositioning(1)};
  t.read_at(400, single);
  EXPECT_EQ(t.last().finding, Finding::not_repositioning);
  EXPECT_EQ(t.reaction, Reaction::none);
  for (const Group& g : t.groups) EXPECT_FALSE(g.accepted);
  ASSERT_NE(expected(t.state.linking), nullptr);
  t.run_to(1512);
  EXPECT_EQ(t.reaction, Reaction::trip);
}

TEST(Repositioning, BehindTheWindowNothingQualifies) {
  Train t;
  announce(t, {entry(1500, kUnknownId, Reaction::none, 10), entry(100, 5)});
  pass_with(t, 1511, 50, test::repositioning(1));
  EXPECT_EQ(t.last().finding, Finding::not_announced);
}

TEST(Repositioning, ALaterKnownGroupMeansTheRepositioningOneWasMissed) {
  Train t;
  announce(t, {entry(500, kUnknownId, Reaction::service_brake, 300), entry(100, 5)});
  t.pass(600, 5);
  EXPECT_EQ(t.count(What::linking_error_later), 1);
  EXPECT_EQ(t.reaction, Reaction::service_brake);
  EXPECT_TRUE(t.last().accepted);
}

TEST(Repositioning, Row25ASecondOneBrakes) {
  Train t;
  announce(t, {entry(1500, kUnknownId, Reaction::trip, 10)});
  pass_with(t, 700, 50, test::repositioning(1));
  pass_with(t, 800, 50, test::repositioning(1));  // the same again is not a second one
  EXPECT_EQ(t.reaction, Reaction::none);
  pass_with(t, 900, 51, test::directional(1));
  EXPECT_EQ(t.reaction, Reaction::none);
  pass_with(t, 1000, 51, test::repositioning(1));
  EXPECT_EQ(t.reaction, Reaction::service_brake);
  EXPECT_TRUE(t.shorten);
  EXPECT_EQ(t.first(What::double_repositioning)->report, ErrorReport::double_repositioning);
}

TEST(Repositioning, Row25EndsWithTheWindowOrAKnownGroup) {
  Train t;
  announce(t, {entry(1500, kUnknownId, Reaction::trip, 10)});
  pass_with(t, 700, 50, test::repositioning(1));
  t.run_to(1511);
  pass_with(t, 1520, 51, test::repositioning(1));
  EXPECT_EQ(t.reaction, Reaction::none);

  Train u;
  announce(u, {entry(1500, kUnknownId, Reaction::trip, 10)});
  pass_with(u, 700, 50, test::repositioning(1));
  announce(u, {entry(800, 5)});
  u.pass(800, 5);
  pass_with(u, 900, 51, test::repositioning(1));
  EXPECT_EQ(u.count(What::double_repositioning), 0);
}

/// Of three balises the first is missed; the others show direction and repositioning.
void pass_without_reference(Train& t, const test::Bits& packet) {
  test::Balise b{50, 1, 2};
  b.packets = {packet};
  t.read_at(700, b);
  b = {50, 2, 2};
  t.read_at(703, b);
}

TEST(Repositioning, WithAMissedReferenceBaliseItsMessageIsInconsistent) {
  Train t;
  announce(t, {entry(1500, kUnknownId, Reaction::trip, 10)});
  pass_without_reference(t, test::repositioning(1));
  EXPECT_FALSE(t.last().accepted);
  EXPECT_EQ(t.last().finding, Finding::balise_missed);
  EXPECT_EQ(t.reaction, Reaction::trip);
  EXPECT_EQ(t.first(What::group_inconsistent)->report, ErrorReport::linked_message);
  EXPECT_EQ(expected(t.state.linking), nullptr);  // no second reaction at the end of the window
}

TEST(Repositioning, AnotherGroupWithAMissedBaliseMayBeTheOneIn4_0_0) {
  for (const SrsVersion srs : {SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Train t;
    t.situation.srs = srs;
    announce(t, {entry(1500, kUnknownId, Reaction::trip, 10)});
    pass_without_reference(t, test::directional(1));
    EXPECT_FALSE(t.last().accepted);
    EXPECT_EQ(t.reaction, srs == SrsVersion::v4_0_0 ? Reaction::trip : Reaction::none);
    EXPECT_NE(expected(t.state.linking), nullptr);
  }
}

}  // namespace
}  // namespace evc::balise
