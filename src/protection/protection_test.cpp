#include <gtest/gtest.h>

#include "protection/authority.h"
#include "protection/emergency_stops.h"
#include "protection/movement.h"
#include "track/testing.h"
#include "track/withdraw.h"

namespace evc::protection {
namespace {

using namespace track::testing;
using track::Description;

// Codes of M_MODE.
using enum Mode;

Description with_ma() {
  Description d;
  store(d, whole(2000), front_at(100));
  return d;
}

// --- emergency stops (3.10)

TEST(EmergencyStops, APlaceAlreadyPassedIsRefusedAndChangesNothing) {
  Description d = with_ma();
  EmergencyStops stops;
  const Answer a = accept_conditional(stops, d, 1, at(500), at(500.1), front_at(600));
  EXPECT_FALSE(a.accepted);
  EXPECT_EQ(a.Q_EMERGENCYSTOP, 3);
  EXPECT_EQ(a.clause, "3.10.2.2"_srs);
  EXPECT_FALSE(stops.any());
  EXPECT_EQ(d.ma->end(), at(2000));
  EXPECT_TRUE(accept_conditional(stops, d, 1, at(500), at(500), front_at(505)).accepted)
      << "exactly there is not passed";
}

TEST(EmergencyStops, AcceptedOnesShortenAndArePending) {
  Description d = with_ma();
  EmergencyStops stops;
  Answer a = accept_conditional(stops, d, 1, at(1500), at(95), front_at(100));
  EXPECT_TRUE(a.accepted);
  EXPECT_EQ(a.Q_EMERGENCYSTOP, 0);
  EXPECT_EQ(d.ma->end(), at(1500));
  a = accept_conditional(stops, d, 1, at(1800), at(95), front_at(100));
  EXPECT_EQ(a.Q_EMERGENCYSTOP, 1) << "beyond the new EOA: nothing changes";
  EXPECT_EQ(d.ma->end(), at(1500));
  ASSERT_EQ(stops.pending.size(), 1u) << "the same identity replaces";
  EXPECT_EQ(stops.pending[0].at, at(1800));
  EXPECT_FALSE(stops.unconditional_pending());
  EXPECT_EQ(accept_unconditional(stops, 2).Q_EMERGENCYSTOP, 2);
  EXPECT_TRUE(stops.unconditional_pending());
  EXPECT_FALSE(revoke(stops, 9));
  EXPECT_TRUE(revoke(stops, 1));
  EXPECT_EQ(d.ma->end(), at(1500)) << "revocation restores nothing";
  EXPECT_TRUE(revoke(stops, 2));
  EXPECT_FALSE(stops.any());
}

TEST(EmergencyStops, AllSixteenIdentities) {
  EmergencyStops stops;
  for (int round = 0; round < 2; ++round)
    for (std::uint8_t i = 0; i < 16; ++i) EXPECT_TRUE(accept_unconditional(stops, i).accepted);
  EXPECT_EQ(stops.pending.size(), 16u);
}

TEST(EmergencyStops, ValuesForVersion1) {  // 6.6.3.4.5 [5]
  const int expected[] = {0, 0, 2, 1};
  for (std::uint8_t q = 0; q < 4; ++q) EXPECT_EQ(Q_EMERGENCYSTOP_for_version_1(q), expected[q]);
}

// --- movement (3.14.2-4)

TEST(Guards, ByMode) {  // 4.5.2
  struct Row {
    Mode mode;
    bool roll_away, reverse, standstill, post_trip, reversing;
  };
  const Row rows[] = {{SB, false, false, true, false, false},  {SH, true, false, false, false, false},
                      {FS, true, true, false, false, false},   {LS, true, true, false, false, false},
                      {SR, true, true, false, false, false},   {OS, true, true, false, false, false},
                      {SL, false, false, false, false, false}, {NL, false, false, false, false, false},
                      {UN, true, false, false, false, false},  {TR, false, false, false, false, false},
                      {PT, true, true, false, true, false},    {SN, false, false, false, false, false},
                      {RV, true, true, false, false, true},    {NP, false, false, false, false, false},
                      {SF, false, false, false, false, false}, {IS, false, false, false, false, false},
                      {PS, false, false, false, false, false}};
  for (const Row& r : rows) {
    const GuardSelection s = guards_of(r.mode);
    EXPECT_EQ(s.roll_away, r.roll_away) << name(r.mode);
    EXPECT_EQ(s.reverse_movement, r.reverse) << name(r.mode);
    EXPECT_EQ(s.standstill, r.standstill) << name(r.mode);
    EXPECT_EQ(s.post_trip, r.post_trip) << name(r.mode);
    EXPECT_EQ(s.reversing, r.reversing) << name(r.mode);
  }
}

struct Train {
  static constexpr Set<Cause> all{Cause::roll_away, Cause::reverse_movement, Cause::standstill,
                                  Cause::post_trip_distance, Cause::reversing_distance};
  MovementGuards guards;
  GuardSelection selection;
  Movement m;
  explicit Train(Mode mode) : selection(guards_of(mode)) {
    m.D_NVROLL = Distance{2};
    m.permitted = mode == PT || mode == RV ? Way::backward : Way::forward;
    enter_mode(guards, selection, m.nominal);
    guard(guards, selection, m);
  }
  Commands to(double x) {
    m.nominal = OdometerPlace{Distance{x}};
    return guard(guards, selection, m);
  }
  Commands stop(bool acknowledged) {
    m.standstill = true;
    if (acknowledged) m.acknowledged = all;
    const Commands c = guard(guards, selection, m);
    m.standstill = false;
    m.acknowledged = {};
    return c;
  }
};

TEST(ReverseMovement, BeyondTheNationalDistance) {
  Train t(FS);
  EXPECT_FALSE(t.to(100).any());
  EXPECT_FALSE(t.to(98).any()) << "exactly the distance";
  EXPECT_TRUE(t.to(97.9).reverse_movement);
  EXPECT_TRUE(t.to(120).reverse_movement) << "kept";
  EXPECT_TRUE(t.stop(false).reverse_movement) << "standstill alone does not release";
  t.m.acknowledged = Train::all;
  EXPECT_TRUE(t.to(120).reverse_movement) << "nor does the acknowledgement alone";
  EXPECT_FALSE(t.stop(true).any());
  EXPECT_FALSE(t.to(118.1).any()) << "counted from the place of release";
  EXPECT_TRUE(t.to(117).reverse_movement);
}

TEST(ReverseMovement, ComingBackTakesTheDistanceBack) {
  Train t(FS);
  t.to(100);
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(t.to(98.5).any());
    EXPECT_FALSE(t.to(99.9).any());
  }
}

TEST(ReverseMovement, ForwardIsTheForbiddenWayInPostTrip) {
  Train t(PT);
  t.m.D_NVPOTRP = Distance{200};
  EXPECT_FALSE(t.to(-50).any());
  EXPECT_TRUE(t.to(-47.9).reverse_movement);
}

TEST(RollAway, AgainstTheController) {
  Train t(SH);
  EXPECT_FALSE(t.to(-50).any()) << "without the interface the function is absent";
  t.m.controller = Way::forward;
  EXPECT_FALSE(t.to(-49).any());
  EXPECT_FALSE(t.to(-51).any());
  EXPECT_TRUE(t.to(-51.1).roll_away);
  EXPECT_FALSE(t.stop(true).any());
  t.m.controller = Way::none;
  EXPECT_FALSE(t.to(-50).any());
  EXPECT_TRUE(t.to(-49).roll_away) << "neutral: neither way";
  EXPECT_FALSE(t.stop(true).any());
  EXPECT_TRUE(t.to(-52).roll_away);
  t.m.D_NVROLL.reset();
  EXPECT_FALSE(t.stop(true).any());
  EXPECT_FALSE(t.to(500).any()) << "infinite";
}

TEST(Reversing, AnAcknowledgementIsForItsCommand) {  // 3.14.1.10
  Train t(RV);
  t.m.controller = Way::forward;
  t.m.reversing_left = Distance{-0.1};
  EXPECT_TRUE(t.to(-17).reversing);
  EXPECT_TRUE(t.to(-20).roll_away);
  t.m.standstill = true;
  t.m.acknowledged = {Cause::roll_away};
  const Commands c = guard(t.guards, t.selection, t.m);
  EXPECT_TRUE(c.reversing);
  EXPECT_FALSE(c.roll_away);
  t.m.acknowledged = {Cause::reversing_distance};
  EXPECT_FALSE(guard(t.guards, t.selection, t.m).any());
}

TEST(Standstill, AnyMovementInStandBy) {
  Train t(SB);
  EXPECT_FALSE(t.to(2).any());
  EXPECT_TRUE(t.to(2.1).standstill);
  EXPECT_FALSE(t.stop(true).any());
  EXPECT_FALSE(t.to(0.5).any());
  EXPECT_TRUE(t.to(0).standstill);
}

TEST(PostTrip, DistanceThenEveryFurtherMove) {  // 4.4.14.1.3
  Train t(PT);
  t.m.D_NVPOTRP = Distance{200};
  EXPECT_FALSE(t.to(-200).any());
  EXPECT_TRUE(t.to(-200.1).post_trip);
  EXPECT_FALSE(t.stop(true).any());
  EXPECT_FALSE(t.to(-200.1).any());
  EXPECT_TRUE(t.to(-200.2).post_trip);
  EXPECT_FALSE(t.stop(true).any());
  t.m.D_NVPOTRP = Distance{300};
  EXPECT_FALSE(t.to(-250).any());
  EXPECT_TRUE(t.to(-300.5).post_trip);
  enter_mode(t.guards, guards_of(SR), t.m.nominal);
  t.selection = guards_of(SR);
  t.m.permitted = Way::forward;
  EXPECT_FALSE(t.to(-300.5).any()) << "left post trip";
}

TEST(PostTrip, AMovementForwardAllowsNoneBack) {  // 4.4.14.1.3.2: any further movement
  Train t(PT);
  t.m.D_NVPOTRP = Distance{200};
  EXPECT_TRUE(t.to(-205).post_trip);
  EXPECT_FALSE(t.stop(true).any());
  EXPECT_FALSE(t.to(-203).post_trip);
  EXPECT_FALSE(t.to(-203).post_trip);
  EXPECT_TRUE(t.to(-203.1).post_trip) << "in front of where it was released";
}

TEST(Reversing, BeyondItsDistance) {  // 3.15.4.8
  Train t(RV);
  EXPECT_FALSE(t.to(-10).any()) << "endless";
  t.m.reversing_left = Distance{5};
  EXPECT_FALSE(t.to(-11).any());
  t.m.reversing_left = Distance{-0.1};
  EXPECT_TRUE(t.to(-17).reversing);
  EXPECT_FALSE(t.stop(true).any());
  EXPECT_TRUE(t.to(-17.5).reversing);
  EXPECT_FALSE(t.stop(true).any());
  EXPECT_FALSE(t.to(-15.6).reversing);
  EXPECT_TRUE(t.to(-15.7).reversing) << "back after a movement forward";
  t.m.reversing_left = Distance{50};
  EXPECT_FALSE(t.to(-18).any()) << "a longer distance ends it";
}

TEST(EnterMode, RollAwayGoesOnReverseMovementIsTurned) {  // 4.12
  Train t(FS);
  t.m.controller = Way::forward;
  t.to(100);
  EXPECT_TRUE(t.to(97).roll_away);
  enter_mode(t.guards, guards_of(SR), t.m.nominal);
  EXPECT_TRUE(t.guards.roll_away.braking);
  EXPECT_TRUE(t.guards.reverse_movement.braking);
  enter_mode(t.guards, guards_of(PT), t.m.nominal);
  EXPECT_FALSE(t.guards.reverse_movement.braking);
  enter_mode(t.guards, guards_of(SB), t.m.nominal);
  EXPECT_FALSE(t.guards.roll_away.braking);
}

// --- end of authority, override, SR

TEST(EndOfAuthority, Conditions12And16) {
  track::Authority a;
  const track::Here here = front_at(1000);  // min front 995, min antenna 990
  EXPECT_FALSE(passes_end_level_1(a, here) || passes_end_level_2(a, here));
  a.EOA = at(995);
  EXPECT_FALSE(passes_end_level_2(a, here));
  a.EOA = at(994.9);
  EXPECT_TRUE(passes_end_level_2(a, here));
  EXPECT_FALSE(passes_end_level_1(a, here));
  a.EOA = at(989.9);
  EXPECT_TRUE(passes_end_level_1(a, here));
  a.EOA.reset();
  a.LOA = at(989);
  EXPECT_TRUE(passes_end_level_1(a, here) && passes_end_level_2(a, here));
}

TEST(Authority, AGroupAtTheEndTripsFromTheAntennaOn) {
  track::Authority a;
  EXPECT_FALSE(group_trips(a, {{2000.0}}, {4.0}));
  a.EOA = Place{{1000.0}};
  EXPECT_FALSE(group_trips(a, {{996.0}}, {4.0})) << "the front end stands at the EOA when the antenna is there";
  EXPECT_TRUE(group_trips(a, {{996.1}}, {4.0}));
  EXPECT_TRUE(group_trips(a, {{1000.0}}, {4.0}));
  EXPECT_TRUE(group_trips(a, {{1000.0}}, {0.0})) << "at the EOA, with the antenna at the front end";
  EXPECT_FALSE(group_trips(a, {{999.9}}, {0.0}));
}

TEST(TrackAheadFree, AskedOnceGrantedOnce) {  // 3.15.5
  TrackAheadFree taf;
  EXPECT_FALSE(ask(taf, at(0), true));
  request(taf, at(100), at(200));
  EXPECT_FALSE(ask(taf, at(99), true));
  EXPECT_FALSE(ask(taf, at(100), false));
  EXPECT_TRUE(taf.asking);
  EXPECT_FALSE(ask(taf, at(90), false));
  EXPECT_TRUE(taf.asking) << "rolling back does not undo it";
  EXPECT_TRUE(ask(taf, at(110), true));
  EXPECT_FALSE(ask(taf, at(110), true));
  request(taf, at(100), at(200));
  EXPECT_FALSE(ask(taf, at(201), true));
  EXPECT_FALSE(ask(taf, at(150), false));
  EXPECT_FALSE(taf.asking) << "its length is over";
}

TEST(TrackAheadFree, TheAnswerIsToTheRequestThatWasShown) {  // 3.15.5
  TrackAheadFree taf;
  request(taf, at(100), at(200));
  EXPECT_FALSE(ask(taf, at(110), true)) << "not shown yet";
  request(taf, at(100), at(300));
  EXPECT_FALSE(ask(taf, at(111), true)) << "another one";
  request(taf, at(100), at(300));
  EXPECT_TRUE(ask(taf, at(112), true)) << "the same again";
}

}  // namespace
}  // namespace evc::protection
