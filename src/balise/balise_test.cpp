#include "balise/balise.h"

#include <gtest/gtest.h>

#include <random>
#include <type_traits>

#include "balise/train_test.h"

namespace evc::balise {
namespace {

using test::Balise;
using test::Bits;
using test::Train;

static_assert(std::is_trivially_copyable_v<State>);
static_assert(sizeof(State) < 5 * 1024);

TEST(Balise, BitsAreKeptAsTheyCame) {
  Train t;
  Balise b{5, 0, 0};
  b.packets = {test::directional(1)};
  const Bits bits = b.telegram(830);
  t.read_at(10, bits);
  ASSERT_EQ(t.last().telegrams.size(), 1u);
  const Telegram& telegram = t.last().telegrams[0];
  EXPECT_EQ(telegram.bits, 830);
  const std::vector<std::uint8_t> bytes = bits.bytes();
  ASSERT_EQ(telegram.span().size(), bytes.size());
  EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), telegram.span().begin()));
  EXPECT_EQ(t.last().id, (GroupId{426, 5}));
  EXPECT_EQ(t.last().X, 2);
}

TEST(Balise, MoreBitsThanATelegramHasAreAFault) {
  Train t;
  t.read_at(10, Balise{5, 0, 0}.telegram(840));
  EXPECT_EQ(t.last().finding, Finding::invalid_value);
  // A count larger than the bytes hold is reduced to them.
  Train u;
  const Bits bits = Balise{5, 0, 0}.telegram(216);
  const std::vector<std::uint8_t> bytes = bits.bytes();
  Outcome outcome;
  read(u.state, {bytes, 5000, u.counter(), u.antenna()}, u.situation, outcome);
  ASSERT_EQ(outcome.groups.size(), 1u);
  EXPECT_EQ(outcome.groups[0].telegrams[0].bits, 216);
  EXPECT_TRUE(outcome.groups[0].accepted);
}

TEST(Balise, AGroupWithoutAnIdentityIsAFault) {
  Train t;
  t.read_at(10, Balise{16383, 0, 0});
  EXPECT_EQ(t.last().finding, Finding::invalid_value);
  EXPECT_FALSE(announced(t.state.linking, {426, 16383}));
}

TEST(Balise, AGroupIsCompleteWithItsLastBalise) {
  Train t;
  t.read_at(10, Balise{5, 0, 2});
  t.read_at(13, Balise{5, 1, 2});
  EXPECT_TRUE(t.groups.empty());
  t.read_at(16, Balise{5, 2, 2});
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_TRUE(t.last().accepted);
  EXPECT_FALSE(t.state.open);
  EXPECT_EQ(t.last().crossing, Direction::nominal);
  EXPECT_EQ(t.last().counter.nominal.from_origin.si, 10);
  EXPECT_EQ(t.count(What::group_accepted), 1);
}

TEST(Balise, MissingOnesAreMissedAfterTheLargestSpacing) {
  Train t;
  t.read_at(10, Balise{5, 0, 1});
  t.run_to(24.5);
  EXPECT_TRUE(t.groups.empty());
  t.run_to(24.7);
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_EQ(t.last().finding, Finding::balise_missed);
}

TEST(Balise, TheSpacingCountsAtTheNextTelegramToo) {
  Train t;
  t.read_at(10, Balise{5, 0, 1});
  t.read_at(40, Balise{5, 1, 1});
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_EQ(t.last().finding, Finding::balise_missed);
  EXPECT_TRUE(t.state.open);
  t.undecodable_at(80);
  EXPECT_EQ(t.groups.size(), 2u);
}

TEST(Balise, TheLastBaliseInTheDirectionOfPassageEndsTheGroup) {
  Train t;
  t.read_at(10, Balise{5, 0, 2});
  t.read_at(16, Balise{5, 2, 2});
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_EQ(t.last().finding, Finding::balise_missed);
  t.read_at(40, Balise{6, 2, 2});
  t.read_at(46, Balise{6, 0, 2});
  ASSERT_EQ(t.groups.size(), 2u);
  EXPECT_EQ(t.last().finding, Finding::balise_missed);
  // One alone may be the first or the last.
  t.read_at(70, Balise{7, 2, 2});
  EXPECT_EQ(t.groups.size(), 2u);
}

TEST(Balise, AnotherGroupEndsTheOneBefore) {
  Train t;
  t.read_at(10, Balise{5, 0, 1});
  t.read_at(12, Balise{6, 0, 0});
  ASSERT_EQ(t.groups.size(), 2u);
  EXPECT_EQ(t.groups[0].id.NID_BG, 5);
  EXPECT_FALSE(t.groups[0].accepted);
  EXPECT_EQ(t.groups[1].id.NID_BG, 6);
  EXPECT_TRUE(t.groups[1].accepted);
}

TEST(Balise, EqualNumbersOfTwoCountriesAreTwoGroups) {
  Train t;
  Balise a{5, 0, 1};
  Balise b{5, 1, 1};
  b.NID_C = 33;
  t.read_at(10, a);
  t.read_at(12, b);
  EXPECT_EQ(t.groups.size(), 1u);
  EXPECT_EQ(t.state.open->id.NID_C, 33);
}

TEST(Balise, OneBaliseReadTwiceInAPassageIsOneTelegram) {
  Train t;
  t.read_at(10, Balise{5, 0, 1});
  t.read_at(10.5, Balise{5, 0, 1});
  t.read_at(13, Balise{5, 1, 1});
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_EQ(t.last().telegrams.size(), 2u);
  EXPECT_TRUE(t.last().accepted);
}

TEST(Balise, TurningWithinAGroupBeginsANewPassage) {
  Train t;
  t.read_at(10, Balise{5, 0, 2});
  t.read_at(13, Balise{5, 1, 2});
  t.read_at(10, Balise{5, 0, 2});  // backwards over the first one
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_FALSE(t.groups[0].accepted);
  EXPECT_EQ(t.state.open->telegrams.size(), 1u);
  Train u;
  u.read_at(10, Balise{5, 0, 3});
  u.read_at(13, Balise{5, 2, 3});
  u.read_at(11.5, Balise{5, 1, 3});  // against the order so far
  EXPECT_EQ(u.groups.size(), 1u);
}

TEST(Balise, TheLastBaliseReadAgainIsNoPassageOfItsOwn) {  // 3.16.2.2.2: none is missed
  for (const bool nominal : {true, false}) {
    Train t;
    t.pass(13, 5, nominal);
    const double last = nominal ? 16 : 13;
    const Balise again{5, nominal ? 1u : 0u, 1};
    t.read_at(last - 0.4, again);  // after it rolled back over it
    t.run_to(last + 30);
    EXPECT_EQ(t.groups.size(), 1u);
    EXPECT_EQ(t.reaction, Reaction::none);
    // Another group follows at once.
    t.pass(60, 6, nominal);
    t.read_at(nominal ? 63 : 60, Balise{6, again.N_PIG, 1});
    t.pass(70, 7, nominal);
    ASSERT_EQ(t.groups.size(), 3u);
    EXPECT_TRUE(t.last().accepted);
    EXPECT_EQ(t.reaction, Reaction::none);
  }
}

TEST(Balise, AnotherMessageOfTheLastBaliseReadAgainIsJudged) {  // 3.16.2.4.5
  for (const bool faulty : {true, false}) {
    Train t;
    t.pass(13, 5);
    Balise again{5, 1, 1};
    if (faulty)
      again.packets = {test::spare()};
    else
      again.M_MCOUNT = 7;
    t.read_at(15.6, again);
    t.run_to(46);
    ASSERT_EQ(t.groups.size(), 2u);
    EXPECT_FALSE(t.last().accepted);
    EXPECT_EQ(t.reaction, Reaction::service_brake);
  }
}

TEST(Balise, LinkingThatCameBehindTheLastBaliseFindsItsGroupAgain) {  // 3.4.4.4.5.1, 3.4.4.4.6 a
  Train t;
  t.situation.linking_checked = true;
  t.pass(13, 5, false);
  t.read_at(12.6, Balise{5, 0, 1});  // on the way back
  t.run_to(11);
  LinkingList list;
  static_cast<void>(list.entries.push_back(test::entry(13, 5, Reaction::trip, 5, false)));
  static_cast<void>(list.entries.push_back(test::entry(87, 6)));
  store(t.state.linking, list, {{426, 100}, Place{}, 426, true, false}, t.antenna(),
        CurrentLrbg{{426, 5}, Place{Distance{13}}});
  ASSERT_EQ(expected(t.state.linking)->id.NID_BG, 5);
  t.read_at(12.6, Balise{5, 0, 1});
  t.run_to(40);
  EXPECT_EQ(t.reaction, Reaction::none);
  EXPECT_EQ(t.groups.size(), 1u);
  ASSERT_NE(expected(t.state.linking), nullptr);
  EXPECT_EQ(expected(t.state.linking)->id.NID_BG, 6);
  t.pass(100, 6);
  EXPECT_TRUE(t.last().accepted);
  EXPECT_EQ(t.reaction, Reaction::none);
}

TEST(Balise, BackOverTheLastBaliseTheOtherOnesFollowOrAreMissed) {
  Train t;
  t.pass(13, 5);
  t.read_at(15.8, Balise{5, 1, 1});
  t.read_at(13, Balise{5, 0, 1});
  ASSERT_EQ(t.groups.size(), 2u);
  EXPECT_TRUE(t.last().accepted);
  EXPECT_EQ(t.last().crossing, Direction::reverse);
  Train u;
  u.pass(13, 5);
  u.read_at(15.8, Balise{5, 1, 1});
  u.run_to(-10);
  ASSERT_EQ(u.groups.size(), 2u);
  EXPECT_EQ(u.last().finding, Finding::balise_missed);
  // Far from where it was read it is another one.
  Train v;
  v.pass(13, 5);
  v.read_at(18, Balise{5, 1, 1});
  v.run_to(60);
  ASSERT_EQ(v.groups.size(), 2u);
  EXPECT_EQ(v.last().finding, Finding::balise_missed);
}

TEST(Balise, OrientationAgainstTheCounter) {
  Train t;
  t.counter_sense = -1;
  t.situation.counter_rises = false;
  t.pass(10, 5);
  EXPECT_EQ(t.last().crossing, Direction::nominal);
  EXPECT_EQ(t.last().counter_against_group, Direction::reverse);
  // Two telegrams with the same counter: the movement decides.
  t.read_at(50, Balise{6, 0, 1});
  t.read_at(50, Balise{6, 1, 1});
  EXPECT_EQ(t.last().counter_against_group, Direction::reverse);
  t.read_at(60, Balise{7, 0, 0});
  EXPECT_EQ(t.last().counter_against_group, Direction::unknown);
}

TEST(Balise, AbandonedGroupsSayNothing) {
  Train t;
  t.read_at(10, Balise{5, 0, 1});
  abandon(t.state);
  t.run_to(100);
  EXPECT_TRUE(t.groups.empty());
}

TEST(Balise, ValidityDirection) {
  EXPECT_TRUE(valid_for(2, Direction::unknown));
  EXPECT_FALSE(valid_for(1, Direction::unknown));  // rows 43, 44
  EXPECT_FALSE(valid_for(0, Direction::unknown));
  EXPECT_TRUE(valid_for(1, Direction::nominal));
  EXPECT_FALSE(valid_for(0, Direction::nominal));
  EXPECT_TRUE(valid_for(0, Direction::reverse));
  EXPECT_FALSE(valid_for(1, Direction::reverse));
  EXPECT_FALSE(valid_for(3, Direction::reverse));
}

// --- Version, covers, reverse movement: the checks of single telegrams in their order.

TEST(Telegrams, Row34VersionZeroIsIgnored) {
  Train t;
  t.situation.level_1_2_3 = true;
  Balise b{5, 0, 0};
  b.M_VERSION = 0x0F;
  t.read_at(10, b);
  t.run_to(100);
  EXPECT_TRUE(t.groups.empty());
  EXPECT_EQ(t.count(What::telegram_version_old), 1);
  EXPECT_FALSE(t.version_too_high);
}

TEST(Telegrams, Row35And36TooNewAVersion) {
  for (const bool level_1_2_3 : {true, false}) {
    Train t;
    t.situation.level_1_2_3 = level_1_2_3;
    Balise b{5, 0, 1};
    b.M_VERSION = 0x30;
    t.read_at(10, b);
    b.N_PIG = 1;
    t.read_at(13, b);
    EXPECT_EQ(t.version_too_high, level_1_2_3);
    EXPECT_TRUE(t.groups.empty());
    EXPECT_EQ(t.reaction, Reaction::none);
    // Only one telegram is of a new version, the other is supported: ignored is not missed.
    b.NID_BG = 6;
    t.read_at(40, b);
    t.read_at(43, Balise{6, 0, 1});
    ASSERT_EQ(t.groups.size(), 1u);
    EXPECT_TRUE(t.last().accepted);
  }
}

TEST(Telegrams, AReferenceBaliseThatIsIgnoredIsTheOriginAllTheSame) {  // 3.4.2.2.1
  Train t;
  Balise b{6, 0, 2};
  b.M_VERSION = 0x30;
  t.read_at(40, b);
  t.read_at(43, Balise{6, 1, 2});
  t.read_at(46, Balise{6, 2, 2});
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_TRUE(t.last().accepted);
  EXPECT_EQ(t.last().counter.nominal.from_origin.si, 40);
  EXPECT_EQ(t.last().antenna.est.from_origin.si, 40);
  // Of duplicates the one that was received is it (3.4.2.2.1.1).
  b = Balise{7, 0, 2, 1, 1};
  b.M_VERSION = 0x30;
  t.read_at(80, b);
  t.read_at(83, Balise{7, 1, 2, 1, 2});
  t.read_at(86, Balise{7, 2, 2});
  ASSERT_EQ(t.groups.size(), 2u);
  EXPECT_EQ(t.last().counter.nominal.from_origin.si, 83);
}

TEST(Telegrams, Row39UnknownPacketOfALaterYIsSkipped) {
  Train t;
  Balise b{5, 0, 0};
  b.M_VERSION = 0x29;
  b.packets = {test::packet(99, 1, Bits{}.put(5, 10))};
  t.read_at(10, b);
  EXPECT_TRUE(t.last().accepted);
  // Row 40: in a supported version it is a fault.
  Balise c{6, 0, 0};
  c.packets = b.packets;
  t.read_at(40, c);
  EXPECT_EQ(t.last().finding, Finding::invalid_value);
}

TEST(Telegrams, Row33CoversHideTelegramsFaultyOrNot) {
  Train t;
  ASSERT_TRUE(set_cover(t.state, {17, 426, 100_s}));
  Balise b{5, 0, 1};
  b.packets = {test::marker(17), test::spare()};
  t.read_at(10, b);
  t.run_to(60);
  EXPECT_TRUE(t.groups.empty());
  EXPECT_EQ(t.count(What::telegram_covered), 1);
  EXPECT_EQ(t.reaction, Reaction::none);
  // Another marker, another country, no marker, or the time has elapsed.
  b.packets = {test::marker(18)};
  b.N_TOTAL = 0;
  t.read_at(100, b);
  EXPECT_TRUE(t.last().accepted);
  b.packets = {test::marker(17)};
  b.NID_C = 33;
  t.read_at(200, b);
  EXPECT_TRUE(t.last().accepted);
  b.NID_C = 426;
  t.situation.now = 101_s;
  t.read_at(300, b);
  EXPECT_TRUE(t.last().accepted);
  t.situation.now = 100_s;
  t.read_at(400, b);
  EXPECT_EQ(t.groups.size(), 3u);
}

TEST(Telegrams, CoversInVersionOneUseAnotherPacket) {
  // 8.4.2.4: 1.1 has packet 200, 1.0 has none, all others packet 0.
  for (unsigned M_VERSION = 0x10; M_VERSION < 0x80; ++M_VERSION)
    for (const bool old : {false, true}) {
      Train t;
      ASSERT_TRUE(set_cover(t.state, {17, 426, 100_s}));
      Balise b{5, 0, 0};
      b.M_VERSION = M_VERSION;
      b.packets = {old ? test::old_marker(17) : test::marker(17)};
      t.read_at(10, b);
      const bool covers = M_VERSION == 0x11 ? old : M_VERSION != 0x10 && !old;
      EXPECT_EQ(t.count(What::telegram_covered), covers ? 1 : 0) << M_VERSION << old;
    }
  Train t;
  ASSERT_TRUE(set_cover(t.state, {17, 426, 100_s}));
  Balise b{5, 0, 0};
  b.M_VERSION = 0x11;
  b.packets = {test::old_marker(17)};
  t.read_at(10, b);
  EXPECT_EQ(t.count(What::telegram_covered), 1);
  b.packets = {};  // packet 255 alone
  t.read_at(50, b.telegram(58));
  EXPECT_EQ(t.count(What::telegram_covered), 1);
  // Telegrams that end before or within the marker.
  b.M_VERSION = 0x21;
  for (const std::size_t bits : {54u, 60u}) {
    const std::vector<std::uint8_t> bytes = [&] {
      Balise c = b;
      c.packets = {test::marker(17)};
      return c.telegram().bytes();
    }();
    Outcome outcome;
    read(t.state, {bytes, bits, t.counter(), t.antenna()}, t.situation, outcome);
    for (const Event& e : outcome.events) EXPECT_NE(e.what, What::telegram_covered);
    abandon(t.state);
  }
}

TEST(Telegrams, CoversAreReplacedRemovedAndKeptByCountry) {
  State s;
  ASSERT_TRUE(set_cover(s, {1, 426, 10_s}));
  ASSERT_TRUE(set_cover(s, {1, 426, 20_s}));
  EXPECT_EQ(s.covers.size(), 1u);
  EXPECT_EQ(s.covers[0].until, 20_s);
  ASSERT_TRUE(set_cover(s, {1, 33, 20_s}));
  ASSERT_TRUE(set_cover(s, {2, 426, 20_s}));
  remove_cover(s, 2, 426);
  EXPECT_EQ(s.covers.size(), 2u);
  keep_covers_of(s, 33);
  ASSERT_EQ(s.covers.size(), 1u);
  EXPECT_EQ(s.covers[0].NID_C, 33);
  for (std::uint8_t i = 0; i < kCovers - 1; ++i) ASSERT_TRUE(set_cover(s, {i, 500, 20_s}));
  EXPECT_FALSE(set_cover(s, {60, 500, 20_s}));
}

TEST(Telegrams, Row46AgainstThePermittedMovement) {
  Train t;
  t.situation.against_permitted_movement = true;
  t.situation.level_1_2_3 = true;
  Balise b{5, 0, 1};
  t.read_at(10, b);
  b.M_VERSION = 0x30;  // tested before the version: no trip
  t.read_at(8, b);
  t.undecodable_at(6);
  t.run_to(-100);
  EXPECT_TRUE(t.groups.empty());
  EXPECT_EQ(t.count(What::telegram_against_movement), 2);
  EXPECT_FALSE(t.version_too_high);
}

TEST(Events, AFullListKeepsTheReaction) {
  Outcome outcome;
  for (std::size_t i = 0; i < outcome.events.capacity(); ++i) note(outcome, {});
  note(outcome, {What::linking_error_missed, {}, Finding::none, Reaction::trip, ErrorReport::linking, {}});
  EXPECT_EQ(outcome.reaction, Reaction::trip);
  EXPECT_EQ(outcome.events.back().what, What::group_capacity);
}

// With any bits from the antenna: no crash, no group without a balise, the state stays bounded and
// consistent.
TEST(Balise, NoiseIsAnswered) {
  std::mt19937 random(11);
  Train t;
  std::vector<Balise> some;
  for (int i = 0; i < 20; ++i) {
    Balise b;
    b.NID_BG = static_cast<std::uint16_t>(random() % 6);
    b.N_PIG = random() % 8;
    b.N_TOTAL = random() % 8;
    b.Q_LINK = random() % 2;
    b.M_DUP = random() % 4;
    b.M_VERSION = random() % 0x40;
    some.push_back(b);
  }
  double x = 0;
  for (int i = 0; i < 20000; ++i) {
    x += static_cast<double>(random() % 100) / 10.0 - 2.0;
    t.situation.linking_checked = random() % 4 != 0;
    switch (random() % 6) {
      case 0:
        t.undecodable_at(x);
        break;
      case 1: {
        Bits noise;
        for (int n = 0; n < 7; ++n) noise.put(random(), 30);
        t.read_at(x, noise);
        break;
      }
      case 2:
        t.run_to(x);
        break;
      case 3:
        t.at = x;
        test::announce(t, {test::entry(x > 0 ? x + 20 : 20, static_cast<std::uint16_t>(random() % 6)),
                           test::entry(50, random() % 3 ? std::uint16_t{3} : kIdentityUnknown)});
        break;
      default:
        t.read_at(x, some[random() % some.size()]);
    }
    for (const Group& g : t.groups) {
      ASSERT_LE(g.telegrams.size(), kBalises);
      ASSERT_FALSE(g.accepted && g.finding != Finding::none);
      ASSERT_FALSE(g.lrbg_compliant && !g.accepted);
    }
    t.groups.clear();
    t.events.clear();
  }
}

}  // namespace
}  // namespace evc::balise
