#include "balise/linking.h"

#include <gtest/gtest.h>

#include "balise/train_test.h"

namespace evc::balise {
namespace {

using test::announce;
using test::entry;
using test::Train;
using Verdict = Judgement::Verdict;

PlaceInterval at(double min, double est, double max) {
  return {Place{Distance{min}}, Place{Distance{est}}, Place{Distance{max}}};
}

// LRBG with Q_LOCACC 5 and the worst allowed odometer: the window of a group 1000 m ahead with Q_LOCACC 10 opens at an
// estimated 933.33 m and closes at 1073.68 m.
TEST(Linking, WindowOfTheWorkedExample) {
  const auto inside = [](double a, bool& early) {
    LinkingState linking;
    LinkingList list;
    static_cast<void>(list.entries.push_back(entry(1000, 7, Reaction::trip, 10)));
    store(linking, list, {{426, 1}, Place{}, 426, true, false}, at(0, 0, 0), std::nullopt);
    Outcome outcome;
    const double error = 5 + 5 + 0.05 * a;
    const Judgement j = judge(linking, {426, 7}, true, at(a - error, a, a + error), true, outcome);
    early = !outcome.events.empty() && outcome.events[0].what == What::linking_error_early;
    return j.verdict == Verdict::found;
  };
  bool early = false;
  EXPECT_FALSE(inside(933.3, early));
  EXPECT_TRUE(early);
  EXPECT_TRUE(inside(933.4, early));
  EXPECT_TRUE(inside(1000, early));
  EXPECT_TRUE(inside(1073.6, early));
  EXPECT_FALSE(inside(1073.7, early));
  EXPECT_FALSE(early);
}

TEST(Linking, WindowForDisplays) {
  LinkingState linking;
  EXPECT_FALSE(window(linking, at(0, 0, 0)));
  LinkingList list;
  static_cast<void>(list.entries.push_back(entry(1000, 7, Reaction::trip, 10)));
  store(linking, list, {{426, 1}, Place{}, 426, true, false}, at(0, 0, 0), std::nullopt);
  const auto w = window(linking, at(490, 500, 530));
  ASSERT_TRUE(w);
  EXPECT_EQ(w->min.from_origin.si, 960);
  EXPECT_EQ(w->est.from_origin.si, 1000);
  EXPECT_EQ(w->max.from_origin.si, 1020);
}

TEST(Linking, CountriesAndDistancesAddUp) {
  lang::Packet5 packet;
  packet.Q_SCALE.raw = 0;  // 10 cm
  packet.D_LINK.raw = 1003;
  packet.NID_BG.raw = 1;
  packet.Q_LINKORIENTATION.raw = 1;
  packet.Q_LINKREACTION.raw = 1;
  packet.Q_LOCACC.raw = 7;
  lang::Packet5_links next;
  next.D_LINK.raw = 50;
  next.Q_NEWCOUNTRY.raw = 1;
  next.NID_C.raw = 33;
  next.NID_BG.raw = 2;
  next.Q_LINKREACTION.raw = 0;
  ASSERT_TRUE(packet.links.push_back(next));
  next.Q_NEWCOUNTRY.raw = 0;
  next.NID_BG.raw = 3;
  next.Q_LINKREACTION.raw = 2;
  ASSERT_TRUE(packet.links.push_back(next));
  const LinkingList list = linking_list(packet);
  LinkingState linking;
  const Stored stored = store(linking, list, {{426, 9}, Place{10_m}, 426, true, false}, at(0, 0, 0), std::nullopt);
  EXPECT_TRUE(stored.complete);
  EXPECT_EQ(stored.reference, Place{10_m});
  ASSERT_EQ(linking.links.size(), 3u);
  EXPECT_EQ(linking.links[0], (Link{Place{110.3_m}, 7_m, {426, 1}, Reaction::service_brake, Direction::nominal, true}));
  EXPECT_EQ(linking.links[1], (Link{Place{115.3_m}, 0_m, {33, 2}, Reaction::trip, Direction::reverse, true}));
  EXPECT_EQ(linking.links[2], (Link{Place{120.3_m}, 0_m, {33, 3}, Reaction::none, Direction::reverse, true}));
}

TEST(Linking, GroupsPassedAreLeftOutOfAList) {
  LinkingState linking;
  LinkingList list;
  for (std::uint16_t i = 1; i <= 4; ++i) static_cast<void>(list.entries.push_back(entry(100, i)));
  // Windows of 1 and 2 have ended, that of 3 has not.
  store(linking, list, {{426, 9}, Place{}, 426, true, false}, at(206, 290, 300), std::nullopt);
  ASSERT_EQ(linking.links.size(), 2u);
  EXPECT_EQ(expected(linking)->id.NID_BG, 3);
  // Group 3 was just found; its window is still open.
  linking.found = LinkingState::Found{{426, 3}, Place{297_m}};
  store(linking, list, {{426, 9}, Place{}, 426, true, false}, at(206, 290, 300), std::nullopt);
  ASSERT_EQ(linking.links.size(), 1u);
  EXPECT_EQ(expected(linking)->id.NID_BG, 4);
  EXPECT_EQ(linking.previous, Place{300_m});
}

TEST(Linking, TheLrbgIsExpectedAgainWhereTheTrainHasRunBackBehindIt) {  // 3.4.4.4.5.1
  LinkingList list;
  static_cast<void>(list.entries.push_back(entry(100, 1)));
  static_cast<void>(list.entries.push_back(entry(100, 2)));
  const auto expects = [&](double antenna) {
    LinkingState linking;
    linking.found = LinkingState::Found{{426, 1}, Place{100_m}};
    const Stored stored = store(linking, list, {{426, 9}, Place{}, 426, true, false},
                                at(antenna - 5, antenna, antenna + 5), CurrentLrbg{{426, 1}, Place{103_m}});
    EXPECT_EQ(stored.reference, Place{3_m});
    return expected(linking)->id.NID_BG;
  };
  EXPECT_EQ(expects(110), 2);
  EXPECT_EQ(expects(102), 2) << "still under the antenna";
  EXPECT_EQ(expects(101), 1);
  EXPECT_EQ(expects(60), 1);
}

TEST(Linking, BehindTheLrbgTheGroupsBeforeItAreExpectedOnlyWhereTheyLieAheadToo) {
  LinkingList list;
  for (std::uint16_t i = 1; i <= 3; ++i) static_cast<void>(list.entries.push_back(entry(8, i)));
  const auto expects = [&](double antenna) {
    LinkingState linking;
    linking.found = LinkingState::Found{{426, 2}, Place{16_m}};
    store(linking, list, {{426, 9}, Place{}, 426, true, false}, at(antenna - 5, antenna, antenna + 5),
          CurrentLrbg{{426, 2}, Place{16_m}});
    return expected(linking)->id.NID_BG;
  };
  EXPECT_EQ(expects(16), 3);
  EXPECT_EQ(expects(12), 2) << "the window of group 1 is open still, and the train is beyond that group";
  EXPECT_EQ(expects(7), 2);
  EXPECT_EQ(expects(6), 1);
}

TEST(Linking, AListOverTheCurrentLrbgPlacesItsReferenceByLinking) {
  LinkingState linking;
  LinkingList list;
  static_cast<void>(list.entries.push_back(entry(100, 1)));
  static_cast<void>(list.entries.push_back(entry(100, 2)));
  // By odometer, group 1 is at 103.
  const Stored stored = store(linking, list, {{426, 9}, Place{}, 426, true, false}, at(104, 110, 115),
                              CurrentLrbg{{426, 1}, Place{103_m}});
  EXPECT_EQ(stored.reference, Place{3_m});
  ASSERT_EQ(linking.links.size(), 1u);
  EXPECT_EQ(linking.links[0].place, Place{203_m});
}

TEST(Linking, AGroupThatComesAgainAroundALoopIsStillAhead) {
  LinkingState linking;
  LinkingList list;
  static_cast<void>(list.entries.push_back(entry(100, 1)));
  static_cast<void>(list.entries.push_back(entry(400, 2)));
  static_cast<void>(list.entries.push_back(entry(400, 9)));
  static_cast<void>(list.entries.push_back(entry(100, 1)));
  linking.found = LinkingState::Found{{426, 1}, Place{103_m}};
  const Stored stored = store(linking, list, {{426, 9}, Place{}, 426, true, false}, at(104, 110, 115),
                              CurrentLrbg{{426, 1}, Place{103_m}});
  EXPECT_EQ(stored.reference, Place{3_m});
  ASSERT_EQ(linking.links.size(), 3u);
  EXPECT_EQ(expected(linking)->id.NID_BG, 2);
  // Counted from the LRBG itself.
  linking.found = LinkingState::Found{{426, 9}, Place{}};
  store(linking, list, {{426, 9}, Place{}, 426, true, false}, at(4, 10, 15), CurrentLrbg{{426, 9}, Place{}});
  EXPECT_EQ(linking.links.size(), 4u);
}

TEST(Linking, InfillKeepsWhatIsAnnouncedUpToItsReference) {
  Train t;
  announce(t, {entry(100, 1), entry(100, 2), entry(100, 3)});
  LinkingList list;
  static_cast<void>(list.entries.push_back(entry(40, 7)));
  store(t.state.linking, list, {{426, 2}, Place{200_m}, 426, true, true}, t.antenna(), std::nullopt);
  ASSERT_EQ(t.state.linking.links.size(), 3u);
  EXPECT_EQ(t.state.linking.links[1].id.NID_BG, 2);
  EXPECT_EQ(t.state.linking.links[2].id.NID_BG, 7);
  EXPECT_EQ(t.state.linking.links[2].place, Place{240_m});
}

TEST(Linking, AFullListLosesItsFarEndAndSaysSo) {
  LinkingState linking;
  LinkingList list;
  for (std::uint16_t i = 0; i < 32; ++i) static_cast<void>(list.entries.push_back(entry(10, i)));
  const auto more = [&](double from, std::uint16_t number) {
    for (LinkingList::Entry& e : list.entries) e.NID_BG = static_cast<std::uint16_t>(e.NID_BG + 100);
    return store(linking, list, {{426, number}, Place{Distance{from}}, 426, true, true}, at(0, 0, 0), std::nullopt);
  };
  EXPECT_TRUE(more(0, 1).complete);
  EXPECT_TRUE(more(1000, 2).complete);
  EXPECT_EQ(linking.links.size(), kLinks);
  EXPECT_FALSE(more(2000, 3).complete);
  EXPECT_EQ(linking.links.size(), kLinks);
  EXPECT_EQ(expected(linking)->id.NID_BG, 100);
}

TEST(Linking, IsUsedUntilTheFarthestWindowEnds) {
  Train t;
  EXPECT_FALSE(used(t.state.linking, t.antenna(), true));
  announce(t, {entry(100, 1), entry(100, 2)});
  EXPECT_TRUE(used(t.state.linking, t.antenna(), true));
  EXPECT_FALSE(used(t.state.linking, t.antenna(), false));
  t.pass(100, 1);
  t.pass(200, 2);
  EXPECT_EQ(expected(t.state.linking), nullptr);
  EXPECT_TRUE(used(t.state.linking, at(205, 206, 207), true));
  EXPECT_FALSE(used(t.state.linking, at(205.1, 206, 207), true));
  // A linked group that is not announced is accepted only then.
  t.pass(204, 9);
  EXPECT_FALSE(t.last().accepted);
  t.run_to(230);
  EXPECT_FALSE(t.state.linking.used_until);
  t.pass(240, 9);
  EXPECT_TRUE(t.last().accepted);
  EXPECT_FALSE(t.last().linking_used);
  EXPECT_EQ(t.reaction, Reaction::none);
}

TEST(Linking, ClearedWhollyOrBeyondAPlace) {
  Train t;
  announce(t, {entry(100, 1), entry(100, 2), entry(100, 3)});
  clear_beyond(t.state.linking, Place{400_m});
  EXPECT_EQ(t.state.linking.links.size(), 3u);
  clear_beyond(t.state.linking, Place{250_m});
  EXPECT_EQ(t.state.linking.links.size(), 2u);
  EXPECT_EQ(t.state.linking.used_until, Place{205_m});
  clear_beyond(t.state.linking, Place{50_m});
  EXPECT_TRUE(t.state.linking.links.empty());
  EXPECT_FALSE(t.state.linking.used_until);
  announce(t, {entry(100, 1)});
  clear(t.state.linking);
  EXPECT_TRUE(t.state.linking.links.empty());
}

TEST(Linking, StoredButNotSupervisedItStillTellsThePlace) {
  Train t;
  announce(t, {entry(100, 1), entry(100, 2), entry(100, 3), entry(100, 4)});
  t.situation.linking_checked = false;  // mode PT
  t.pass(197, 2);
  ASSERT_TRUE(t.last().accepted);
  EXPECT_TRUE(t.last().lrbg_compliant);
  EXPECT_FALSE(t.last().announced);
  EXPECT_EQ(t.last().link_place, Place{200_m});
  EXPECT_EQ(t.last().Q_LOCACC, 5_m);
  EXPECT_EQ(expected(t.state.linking)->id.NID_BG, 3);
  t.run_to(330);  // group 3 is not reported missed
  EXPECT_EQ(t.reaction, Reaction::none);
  EXPECT_EQ(expected(t.state.linking)->id.NID_BG, 4);
}

// --- The cases of linking consistency (3.16.2.3.1).

TEST(LinkingFaults, Row15EarlyIsRejectedAndTheNextOneExpected) {
  Train t;
  announce(t, {entry(100, 1, Reaction::trip), entry(100, 2)});
  t.pass(94, 1);
  EXPECT_FALSE(t.last().accepted);
  EXPECT_EQ(t.last().finding, Finding::outside_window);
  EXPECT_EQ(t.reaction, Reaction::trip);
  ASSERT_NE(t.first(What::linking_error_early), nullptr);
  EXPECT_EQ(t.first(What::linking_error_early)->id.NID_BG, 1);
  EXPECT_EQ(t.first(What::linking_error_early)->report, ErrorReport::linking);
  EXPECT_EQ(expected(t.state.linking)->id.NID_BG, 2);
  EXPECT_FALSE(t.shorten);  // only a service brake shortens
}

TEST(LinkingFaults, Row16MissedAtTheEndOfTheWindow) {
  Train t;
  t.over = 10;
  announce(t, {entry(100, 1), entry(100, 2)});
  t.run_to(115 + 1.3);  // min safe antenna 106.3 is not past 105 + 1.3
  EXPECT_EQ(t.reaction, Reaction::none);
  t.run_to(116.4);
  EXPECT_EQ(t.reaction, Reaction::service_brake);
  EXPECT_TRUE(t.shorten);
  ASSERT_NE(t.first(What::linking_error_missed), nullptr);
  EXPECT_EQ(t.first(What::linking_error_missed)->id.NID_BG, 1);
  EXPECT_EQ(expected(t.state.linking)->id.NID_BG, 2);
}

TEST(LinkingFaults, Row17LaterGroupInTheWindowOfTheExpectedOne) {
  Train t;
  t.under = 60;
  announce(t, {entry(100, 1, Reaction::trip), entry(50, 2, Reaction::none)});
  t.pass(149, 2);
  EXPECT_EQ(t.reaction, Reaction::trip);  // of the expected one
  EXPECT_EQ(t.first(What::linking_error_later)->id.NID_BG, 1);
  EXPECT_TRUE(t.last().accepted);  // checked at once in its own window
  EXPECT_EQ(t.last().link_place, Place{150_m});
  EXPECT_EQ(t.count(What::linking_ok), 1);
  EXPECT_EQ(expected(t.state.linking), nullptr);
}

TEST(LinkingFaults, Row17LaterGroupOutsideItsOwnWindowAddsItsReaction) {
  Train t;
  announce(t, {entry(100, 1, Reaction::none), entry(50, 2, Reaction::service_brake)});
  t.pass(98, 2);  // window of 1 is open, that of 2 is not
  EXPECT_EQ(t.count(What::linking_error_later), 1);
  EXPECT_EQ(t.count(What::linking_error_early), 1);
  EXPECT_EQ(t.reaction, Reaction::service_brake);
  EXPECT_FALSE(t.last().accepted);
}

TEST(LinkingFaults, Row17TwoAheadWhenAllWindowsAreOpen) {
  Train t;
  t.under = t.over = 200;
  announce(t, {entry(100, 1, Reaction::none), entry(50, 2, Reaction::service_brake), entry(50, 3, Reaction::trip)});
  t.pass(199, 3);
  EXPECT_EQ(t.count(What::linking_error_later), 2);
  EXPECT_EQ(t.reaction, Reaction::service_brake);
  EXPECT_TRUE(t.last().accepted);
}

TEST(LinkingFaults, Row17aLaterGroupBeforeTheWindowOpens) {
  Train t;
  announce(t, {entry(100, 1, Reaction::trip), entry(50, 2, Reaction::trip)});
  t.pass(50, 2);
  EXPECT_EQ(t.reaction, Reaction::none);
  EXPECT_FALSE(t.last().accepted);
  EXPECT_EQ(t.last().finding, Finding::outside_window);
  EXPECT_EQ(expected(t.state.linking)->id.NID_BG, 1);
}

TEST(LinkingFaults, Row18LateIsRejectedTheReactionWasGiven) {
  Train t;
  announce(t, {entry(100, 1), entry(100, 2)});
  t.run_to(107);
  EXPECT_EQ(t.reaction, Reaction::service_brake);
  t.reaction = Reaction::none;
  t.pass(108, 1);
  EXPECT_FALSE(t.last().accepted);
  EXPECT_EQ(t.last().finding, Finding::not_announced);
  EXPECT_EQ(t.reaction, Reaction::none);
}

TEST(LinkingFaults, LateInTheSameCycle) {
  Train t;
  announce(t, {entry(100, 1), entry(100, 2)});
  t.pass(105.5, 1);
  EXPECT_FALSE(t.last().accepted);
  EXPECT_EQ(t.count(What::linking_error_missed), 1);
  EXPECT_EQ(t.reaction, Reaction::service_brake);
  t.run_to(120);
  EXPECT_EQ(t.count(What::linking_error_missed), 1);
}

TEST(LinkingFaults, Row24TwoInARow) {
  Train t;
  announce(t, {entry(100, 1, Reaction::none), entry(100, 2, Reaction::none), entry(100, 3, Reaction::none)});
  t.run_to(107);
  EXPECT_EQ(t.reaction, Reaction::none);
  t.run_to(207);
  EXPECT_EQ(t.reaction, Reaction::service_brake);
  EXPECT_TRUE(t.shorten);
  ASSERT_NE(t.first(What::double_linking_error), nullptr);
  EXPECT_EQ(t.first(What::double_linking_error)->report, ErrorReport::double_linking);
  t.run_to(307);
  EXPECT_EQ(t.count(What::double_linking_error), 2);
}

TEST(LinkingFaults, AnyBaliseEndsTheRowIn4_0_0) {
  for (const double x : {90.0, 98.0, 150.0, 202.0}) {
    for (const SrsVersion srs : {SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
      Train t;
      t.situation.srs = srs;
      announce(t, {entry(100, 1, Reaction::none), entry(100, 2, Reaction::none)});
      if (x > 107) t.run_to(107);
      t.read_at(x, test::Balise{30, 0, 0, 0});  // unlinked
      if (x < 107) t.run_to(107);
      t.run_to(207);
      const bool between = srs == SrsVersion::v4_0_0 && x > 95;
      EXPECT_EQ(t.count(What::double_linking_error), between ? 0 : 1) << x;
    }
  }
}

TEST(LinkingFaults, Row24AGroupBetweenOrOneReadOutsideItsWindowEndsTheRow) {
  Train t;
  announce(t, {entry(100, 1, Reaction::none), entry(100, 2, Reaction::none), entry(100, 3, Reaction::none),
               entry(100, 4, Reaction::none), entry(100, 5, Reaction::none)});
  t.run_to(107);
  t.pass(200, 2);
  t.run_to(307);
  t.pass(390, 4);  // early, rejected, but detected
  t.run_to(507);
  EXPECT_EQ(t.count(What::double_linking_error), 0);
}

TEST(LinkingFaults, Row24AnAnnouncedGroupThatCallsItselfUnlinkedWasDetected) {
  Train t;
  announce(t, {entry(100, 1, Reaction::none), entry(100, 2, Reaction::none)});
  t.pass(100, 1, true, 0);
  t.run_to(107);
  EXPECT_EQ(t.count(What::linking_error_missed), 1);  // not found as a linked group
  t.run_to(207);
  EXPECT_EQ(t.count(What::linking_error_missed), 2);
  EXPECT_EQ(t.count(What::double_linking_error), 0);
}

TEST(LinkingFaults, Row26NoReactionButReported) {
  Train t;
  announce(t, {entry(100, 1, Reaction::none)});
  t.run_to(107);
  EXPECT_EQ(t.reaction, Reaction::none);
  EXPECT_EQ(t.first(What::linking_error_missed)->report, ErrorReport::linking);
}

TEST(LinkingFaults, Row14NotAnnounced) {
  Train t;
  announce(t, {entry(100, 1)});
  t.pass(50, 77);
  EXPECT_FALSE(t.last().accepted);
  EXPECT_EQ(t.last().finding, Finding::not_announced);
  EXPECT_EQ(t.reaction, Reaction::none);
  EXPECT_EQ(t.events.back().report, ErrorReport::none);
  // Also with reading errors.
  t.read_at(60, test::Balise{78, 0, 1});
  t.run_to(80);
  EXPECT_FALSE(t.last().accepted);
  EXPECT_EQ(t.reaction, Reaction::none);
}

TEST(LinkingFaults, Row19WrongDirectionTripsWhateverTheReaction) {
  Train t;
  announce(t, {entry(100, 1, Reaction::none), entry(100, 2)});
  t.pass(100, 1, false);
  EXPECT_FALSE(t.last().accepted);
  EXPECT_EQ(t.last().finding, Finding::wrong_direction);
  EXPECT_EQ(t.reaction, Reaction::none);
  EXPECT_TRUE(t.wrong_direction);
}

TEST(LinkingFaults, Row19ASingleGroupCannotShowAWrongDirection) {
  Train t;
  announce(t, {entry(100, 1, Reaction::none, 5, false), entry(100, 2)});
  t.read_at(101, test::Balise{1, 0, 0});
  EXPECT_TRUE(t.last().accepted);
  EXPECT_TRUE(t.last().single);
  EXPECT_EQ(t.last().crossing, Direction::reverse);  // the announced one
  EXPECT_EQ(t.last().counter_against_group, Direction::reverse);
  EXPECT_EQ(t.reaction, Reaction::none);
}

TEST(LinkingFaults, ASingleGroupKeepsNoOrientationFromLinkingWithoutOne) {
  Train t;
  LinkingList list;
  static_cast<void>(list.entries.push_back(entry(100, 1)));
  t.situation.linking_checked = true;
  store(t.state.linking, list, {{426, 100}, Place{}, 426, false, false}, t.antenna(), std::nullopt);
  t.read_at(101, test::Balise{1, 0, 0});
  EXPECT_TRUE(t.last().accepted);
  EXPECT_EQ(t.last().crossing, Direction::unknown);
}

TEST(LinkingFaults, ReverseCrossingIsJudgedAtTheReferenceBalise) {
  Train t;
  announce(t, {entry(100, 1, Reaction::trip, 2, false)});
  t.pass(99, 1, false);  // its second balise was read at 96, before the window opened at 98
  EXPECT_TRUE(t.last().accepted);
  EXPECT_EQ(t.last().crossing, Direction::reverse);
  EXPECT_EQ(t.reaction, Reaction::none);
  EXPECT_EQ(t.last().counter.nominal.from_origin.si, 99);
  EXPECT_EQ(t.last().telegrams.front().N_PIG, 1);
}

TEST(LinkingFaults, TheWindowWaitsForAGroupThatIsBeingRead) {
  Train t;
  announce(t, {entry(100, 1, Reaction::trip, 2, false)});
  t.read_at(101, test::Balise{1, 1, 2});
  t.run_to(104);  // past 102 + 1.3
  EXPECT_EQ(t.reaction, Reaction::none);
  t.read_at(105, test::Balise{1, 0, 2});  // its reference balise is too late
  t.run_to(130);
  EXPECT_EQ(t.reaction, Reaction::trip);
  EXPECT_FALSE(t.last().accepted);
  EXPECT_EQ(t.count(What::linking_error_missed), 1);
}

}  // namespace
}  // namespace evc::balise
