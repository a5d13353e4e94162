#include <gtest/gtest.h>

#include "balise/balise.h"
#include "balise/train_test.h"

// Balise group message consistency (3.16.2.4, 3.16.2.5): every error of a group, for a group announced by linking,
// marked linked without linking, and marked unlinked.
namespace evc::balise {
namespace {

using test::announce;
using test::Balise;
using test::Bits;
using test::entry;
using test::Train;

/// How the group is announced or marked.
enum class Met : std::uint8_t { announced, linked, unlinked };

/// How a balise of the group is read.
enum class Is : std::uint8_t { read, missed, undecodable };

struct One {
  Is is = Is::read;
  unsigned M_DUP = 0;
  unsigned M_MCOUNT = 255;
  std::vector<Bits> packets{};
};

struct Case {
  const char* name;
  std::vector<One> balises;  // N_PIG 0, 1, ..., 3 m apart, crossed nominal
  // Expected: accepted or not, and the reaction.
  bool announced_accepted;
  bool other_accepted;
  bool other_brakes;
  Finding finding = Finding::none;
  bool shortened_by_reverse = false;
};

const One ok{};
const One missed{Is::missed};
const One undecodable{Is::undecodable};
One holding(Bits packet, unsigned M_DUP = 0) { return {Is::read, M_DUP, 255, {std::move(packet)}}; }
One counted(unsigned M_MCOUNT, unsigned M_DUP = 0) { return {Is::read, M_DUP, M_MCOUNT, {}}; }

std::vector<Case> cases() {
  using test::default_information, test::directional, test::inhibition, test::outside_etcs, test::restriction,
      test::spare;
  const auto F = [](Finding f) { return f; };
  const Finding a = F(Finding::balise_missed), b = F(Finding::balise_not_decoded), c = F(Finding::invalid_value),
                d = F(Finding::counters_differ);
  return {
      // name, balises, announced accepted, otherwise accepted, otherwise brakes, finding
      {"all read", {ok, ok}, true, true, false},
      {"eight balises", {ok, ok, ok, ok, ok, ok, ok, ok}, true, true, false},
      {"single", {ok}, true, true, false},
      // 1, 6, 11
      {"one missed at the end", {ok, missed}, false, false, true, a},
      {"one missed at the start", {missed, ok, ok}, false, false, true, a},
      {"one missed in the middle", {ok, missed, ok}, false, false, true, a},
      // 2
      {"one not decoded", {ok, undecodable}, false, false, true, b},
      {"one not decoded in the middle", {ok, undecodable, ok}, false, false, true, b},
      // 3
      {"spare value", {ok, holding(spare())}, false, false, true, c},
      {"spare duplicate flag", {ok, {Is::read, 3}}, false, false, true, c},
      // 8.4.1.4: instances of a packet in the telegrams that make up the message
      {"a packet in two telegrams", {holding(directional(1)), holding(directional(2))}, false, false, true, c},
      {"a packet in two telegrams, each for one direction",
       {holding(directional(0)), holding(directional(1))},
       true,
       true,
       false},
      {"a packet in both telegrams of a pair",
       {holding(directional(1), 1), holding(directional(1), 2), ok},
       true,
       true,
       false},
      {"data for others in two telegrams", {holding(outside_etcs(1)), holding(outside_etcs(1))}, true, true, false},
      {"default information in two telegrams",
       {holding(default_information()), holding(default_information())},
       true,
       true,
       false},
      {"two restrictions", {holding(restriction(1)), ok, holding(restriction(2))}, true, true, false},
      {"two restrictions of one identity",
       {holding(restriction(2)), ok, holding(restriction(2))},
       false,
       false,
       true,
       c},
      {"two restrictions that cannot be revoked",
       {holding(restriction(255)), holding(restriction(255))},
       true,
       true,
       false},
      // 4, 59
      {"counters equal", {counted(7), counted(7)}, true, true, false},
      {"counters differ", {counted(7), counted(8)}, false, false, true, d},
      {"counter fits all", {counted(7), counted(255), counted(7)}, true, true, false},
      {"counter fits none", {counted(254), counted(255)}, false, false, true, d},
      {"single with a counter that fits none", {counted(254)}, false, false, true, d},
      {"single with a counter", {counted(17)}, true, true, false},
      // 5, 7: the duplicate is there
      {"duplicate for the next, orientation known", {ok, holding(directional(1), 1), missed}, true, true, false},
      {"duplicate for the previous, orientation known", {ok, missed, holding(directional(1), 2)}, true, true, false},
      {"duplicate for a balise not decoded", {ok, undecodable, holding(directional(0), 2)}, true, true, false},
      {"pair, one missed, both directions", {holding(directional(2), 1), missed}, true, true, false},
      {"pair, one missed, no packets", {{Is::read, 1}, missed}, true, true, false},
      {"pair, one missed, data for others only", {holding(outside_etcs(0), 1), missed}, true, true, false},
      {"pair, one missed, data for others and both",
       {{Is::read, 1, 255, {outside_etcs(1), directional(2)}}, missed},
       true,
       true,
       false},
      // 29
      {"pair, the reference balise missed", {missed, {Is::read, 2}}, true, true, false},
      // 8: the orientation is unknown; only linking would give it
      {"pair, one missed, directional", {holding(directional(1), 1), missed}, true, false, true, a},
      {"pair, one missed, directional and data for others",
       {{Is::read, 1, 255, {outside_etcs(1), directional(1)}}, missed},
       true,
       false,
       true,
       a},
      {"duplicate is no duplicate of this one", {{Is::read, 2}, missed, ok}, false, false, true, a},
      {"duplicate is faulty", {ok, holding(spare(), 1), missed}, false, false, true, a},
      {"duplicate good, another missed", {missed, {Is::read, 2}, missed}, false, false, true, a},
      // 9
      {"one missed, reaction inhibited", {holding(inhibition()), missed}, false, false, false, a},
      {"one not decoded, reaction inhibited", {holding(inhibition()), undecodable}, false, false, false, b},
      // 10
      {"spare value, inhibition", {holding(inhibition()), holding(spare())}, false, false, true, c},
      {"counters differ, inhibition", {{Is::read, 0, 7, {inhibition()}}, counted(8)}, false, false, true, d},
      {"one missed, counters differ, inhibition",
       {{Is::read, 0, 7, {inhibition()}}, counted(8), missed},
       false,
       false,
       true,
       a},
      // 30, 31: which telegram of a pair is used
      {"first of a pair by default",
       {{Is::read, 1, 254, {default_information()}}, {Is::read, 2, 9}},
       true,
       true,
       false},
      {"second of a pair by default",
       {{Is::read, 1, 9}, {Is::read, 2, 254, {default_information()}}},
       true,
       true,
       false},
      {"counters of an unused duplicate", {{Is::read, 1, 8}, {Is::read, 2, 9}}, true, true, false},
      {"spare value in an unused duplicate", {{Is::read, 1, 255, {spare()}}, {Is::read, 2}}, true, true, false},
      {"spare value in the used duplicate", {{Is::read, 1}, {Is::read, 2, 255, {spare()}}}, false, false, true, c},
      {"half a pair is no pair", {{Is::read, 1, 8}, {Is::read, 0, 9}}, false, false, true, d},
      // 32
      {"default information", {holding(default_information()), ok}, true, true, false},
  };
}

constexpr std::uint16_t kGroup = 5;
constexpr double kAt = 100;

void drive(Train& t, const Case& c, Met met) {
  for (std::size_t n = 0; n < c.balises.size(); ++n) {
    const One& one = c.balises[n];
    Balise b{kGroup, static_cast<unsigned>(n), static_cast<unsigned>(c.balises.size() - 1), met != Met::unlinked};
    b.M_DUP = one.M_DUP;
    b.M_MCOUNT = one.M_MCOUNT;
    b.packets = one.packets;
    const double x = kAt + 3.0 * static_cast<double>(n);
    if (one.is == Is::read) t.read_at(x, b);
    if (one.is == Is::undecodable) t.undecodable_at(x);
    if (one.is == Is::missed) t.run_to(x);
  }
  t.run_to(kAt + 60);
}

Train meeting(Met met) {
  Train t;
  if (met == Met::announced) announce(t, {entry(kAt, kGroup, Reaction::trip, 5), entry(900, 6)});
  return t;
}

TEST(MessageConsistency, AnnouncedGroupsGiveTheLinkingReaction) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    Train t = meeting(Met::announced);
    drive(t, c, Met::announced);
    ASSERT_EQ(t.groups.size(), 1u);
    EXPECT_EQ(t.last().accepted, c.announced_accepted);
    EXPECT_EQ(t.reaction, c.announced_accepted ? Reaction::none : Reaction::trip);
    EXPECT_EQ(t.last().lrbg_compliant, c.announced_accepted);
    EXPECT_EQ(t.count(What::linking_ok), c.announced_accepted ? 1 : 0);
    if (!c.announced_accepted) {
      EXPECT_EQ(t.last().finding, c.finding);
      EXPECT_EQ(t.first(What::group_inconsistent)->report, ErrorReport::linked_message);
    }
    EXPECT_EQ(t.count(What::linking_error_missed), 0);  // never twice for one group
    EXPECT_EQ(t.count(What::group_accepted), 0);
    EXPECT_EQ(t.events.size(), 1u + static_cast<std::size_t>(t.count(What::telegram_not_decoded)));
  }
}

TEST(MessageConsistency, LinkedGroupsWithoutLinkingAndUnlinkedOnesBrake) {
  for (const Met met : {Met::linked, Met::unlinked}) {
    for (const Case& c : cases()) {
      SCOPED_TRACE(c.name);
      Train t = meeting(met);
      drive(t, c, met);
      ASSERT_EQ(t.groups.size(), 1u);
      EXPECT_EQ(t.last().accepted, c.other_accepted);
      EXPECT_EQ(t.reaction, c.other_brakes ? Reaction::service_brake : Reaction::none);
      EXPECT_EQ(t.shorten, c.other_brakes);
      EXPECT_EQ(t.count(What::group_accepted), c.other_accepted ? 1 : 0);
      EXPECT_EQ(t.last().lrbg_compliant, c.other_accepted && met == Met::linked);
      if (c.other_accepted) continue;
      EXPECT_EQ(t.last().finding, c.finding);
      EXPECT_EQ(t.first(What::group_inconsistent)->report,
                met == Met::linked ? ErrorReport::linked_message : ErrorReport::unlinked_message);
    }
  }
}

TEST(MessageConsistency, UnlinkedGroupsBrakeWhileLinkingIsUsed) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    Train t = meeting(Met::unlinked);
    announce(t, {entry(900, 6, Reaction::trip)});
    drive(t, c, Met::unlinked);
    EXPECT_EQ(t.last().accepted, c.other_accepted);
    EXPECT_EQ(t.reaction, c.other_brakes ? Reaction::service_brake : Reaction::none);
    EXPECT_FALSE(t.last().linking_used);
  }
}

// 13: modes SL, PT, NL, RV, PS.
TEST(MessageConsistency, SomeModesDoNotBrakeButReject) {
  for (const Met met : {Met::linked, Met::unlinked}) {
    for (const Case& c : cases()) {
      SCOPED_TRACE(c.name);
      Train t = meeting(met);
      t.situation.braking_on_message_error = false;
      drive(t, c, met);
      EXPECT_EQ(t.last().accepted, c.other_accepted);
      EXPECT_EQ(t.reaction, Reaction::none);
      EXPECT_FALSE(t.shorten);
    }
  }
}

// 14: linking is used, the group is not announced: no error has a reaction.
TEST(MessageConsistency, GroupsNotAnnouncedAreRejectedSilently) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    Train t = meeting(Met::announced);
    announce(t, {entry(900, 6, Reaction::trip)});
    drive(t, c, Met::announced);
    EXPECT_FALSE(t.last().accepted);
    EXPECT_EQ(t.reaction, Reaction::none);
    EXPECT_EQ(t.count(What::group_inconsistent), 0);
  }
}

// The same, crossed in the other direction: acceptance and reactions do not depend on the direction, except for the
// choice within a pair.
TEST(MessageConsistency, ReverseCrossingIsNoError) {
  for (unsigned n = 2; n <= 8; ++n) {
    Train t;
    for (unsigned i = n; i-- > 0;) t.read_at(kAt + 3 * (n - i), Balise{kGroup, i, n - 1});
    ASSERT_EQ(t.groups.size(), 1u);
    EXPECT_TRUE(t.last().accepted);
    EXPECT_EQ(t.last().crossing, Direction::reverse);
    EXPECT_EQ(t.last().counter_against_group, Direction::reverse);
    EXPECT_EQ(t.last().counter.nominal.from_origin.si, kAt + 3 * n);
    EXPECT_EQ(t.reaction, Reaction::none);
  }
}

// 12
TEST(MessageConsistency, NothingReadableCountsAsUnlinked) {
  Train t;
  t.undecodable_at(100);
  t.undecodable_at(103);
  EXPECT_TRUE(t.groups.empty());
  t.run_to(120);
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_FALSE(t.last().identified);
  EXPECT_FALSE(t.last().accepted);
  EXPECT_EQ(t.reaction, Reaction::service_brake);
  EXPECT_EQ(t.first(What::group_inconsistent)->report, ErrorReport::unlinked_message);
}

TEST(MessageConsistency, ATelegramThatBelongsToNoBaliseIsNotDecoded) {
  for (const Bits& bits :
       {Bits{}, Bits{}.put(0x5555, 49), Balise{.Q_UPDOWN = 0}.telegram(), Balise{.Q_MEDIA = 1}.telegram()}) {
    Train t;
    t.read_at(100, bits);
    t.run_to(120);
    EXPECT_EQ(t.reaction, Reaction::service_brake);
  }
}

TEST(MessageConsistency, AnUnreadableBaliseBeforeTheFirstReadableOneIsOfThatGroup) {
  Train t;
  t.undecodable_at(100);
  t.read_at(103, Balise{kGroup, 1, 1});
  EXPECT_TRUE(t.groups.empty());
  t.run_to(130);
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_EQ(t.last().id.NID_BG, kGroup);
  EXPECT_EQ(t.last().finding, Finding::balise_not_decoded);
}

TEST(MessageConsistency, AnAlienUnreadableBaliseIsNotMadeGood) {
  Train t;
  t.read_at(100, Balise{kGroup, 0, 1});
  t.undecodable_at(101);
  t.read_at(103, Balise{kGroup, 1, 1});
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_EQ(t.last().finding, Finding::balise_not_decoded);
  EXPECT_EQ(t.reaction, Reaction::service_brake);
}

TEST(MessageConsistency, HeadersOfOneGroupMustAgree) {
  Train t;
  t.read_at(100, Balise{kGroup, 0, 2});
  t.read_at(103, Balise{kGroup, 1, 1});
  t.run_to(130);
  EXPECT_FALSE(t.last().accepted);
  Train u;
  u.read_at(100, Balise{kGroup, 0, 1, 1});
  u.read_at(103, Balise{kGroup, 1, 1, 0});
  EXPECT_EQ(u.last().finding, Finding::invalid_value);
  Train v;
  v.read_at(100, Balise{kGroup, 3, 1});
  v.run_to(130);
  EXPECT_FALSE(v.last().accepted);
  EXPECT_EQ(v.reaction, Reaction::service_brake);
}

TEST(MessageConsistency, WhichTelegramOfAPairIsUsed) {
  const auto used = [](bool first_default, bool second_default, bool nominal) {
    Train t;
    Balise first{kGroup, 0, 1};
    first.M_DUP = 1;
    if (first_default) first.packets = {test::default_information()};
    Balise second{kGroup, 1, 1};
    second.M_DUP = 2;
    if (second_default) second.packets = {test::default_information()};
    t.read_at(100, nominal ? first : second);
    t.read_at(103, nominal ? second : first);
    int which = -1;
    for (const Telegram& telegram : t.last().telegrams)
      if (telegram.used) which = which == -1 ? telegram.N_PIG : 99;
    EXPECT_EQ(t.last().default_information, first_default && second_default);
    return which;
  };
  EXPECT_EQ(used(false, false, true), 1);  // the last one received
  EXPECT_EQ(used(false, false, false), 0);
  EXPECT_EQ(used(true, true, true), 1);
  EXPECT_EQ(used(true, true, false), 0);
  EXPECT_EQ(used(true, false, true), 1);  // the one without
  EXPECT_EQ(used(true, false, false), 1);
  EXPECT_EQ(used(false, true, true), 0);
  EXPECT_EQ(used(false, true, false), 0);
}

TEST(MessageConsistency, TheDuplicateOfTheReferenceBaliseIsTheLocationReference) {
  Train t;
  announce(t, {entry(100, kGroup, Reaction::trip, 2)});
  Balise second{kGroup, 1, 1};
  second.M_DUP = 2;
  t.read_at(101.5, second);
  t.run_to(104);  // window over, but the group is still being read
  EXPECT_EQ(t.reaction, Reaction::none);
  t.run_to(120);
  ASSERT_EQ(t.groups.size(), 1u);
  EXPECT_TRUE(t.last().accepted);
  EXPECT_TRUE(t.last().single);
  EXPECT_EQ(t.last().counter.nominal.from_origin.si, 101.5);
  EXPECT_EQ(t.last().link_place, Place{100_m});
  EXPECT_EQ(t.reaction, Reaction::none);

  Train u;  // outside the window it has no effect
  announce(u, {entry(100, kGroup, Reaction::trip, 2)});
  u.read_at(103.5, second);
  u.run_to(120);
  EXPECT_FALSE(u.last().accepted);
  EXPECT_EQ(u.reaction, Reaction::trip);
}

TEST(MessageConsistency, MissedReferenceBaliseOfALaterGroupIsNotCheckedAgainstTheExpectedOne) {
  Train t;
  announce(t, {entry(500, 6, Reaction::trip), entry(100, kGroup, Reaction::trip)});
  t.read_at(100, Balise{kGroup, 1, 2});
  t.run_to(130);
  EXPECT_EQ(t.last().finding, Finding::outside_window);
  EXPECT_EQ(t.reaction, Reaction::none);
  EXPECT_EQ(expected(t.state.linking)->id.NID_BG, 6);
}

TEST(MessageConsistency, MissedReferenceBaliseWithoutUsedLinkingTakesTheOrdinaryRule) {
  Train t;
  announce(t, {entry(100, kGroup, Reaction::trip)});
  t.situation.linking_checked = false;
  t.read_at(103, Balise{kGroup, 1, 1});
  t.run_to(130);
  EXPECT_EQ(t.reaction, Reaction::service_brake);
  EXPECT_FALSE(t.last().link_place);
}

}  // namespace
}  // namespace evc::balise
