#include "track/services.h"

#include <gtest/gtest.h>

#include "track/testing.h"
#include "track/withdraw.h"

namespace evc::track {
namespace {

using namespace testing;

Description with_ma(double end) {
  Description d;
  d.ma = authority_to(end);
  return d;
}
void put_area(Description& d, double from, double to, Mode mode, bool also_SvL = true) {
  ModeArea area;
  area.from = at(from);
  area.to = at(to);
  area.ack_from = at(from - 100);
  area.mode = mode;
  area.also_SvL = also_SvL;
  if (!d.mode_profile.push_back(area)) __builtin_trap();
}
constexpr Mode FS = Mode::FS, OS = Mode::OS, SR = Mode::SR, LS = Mode::LS;

TEST(Authority, OnlyWhereAnMaIsSupervised) {
  const Description d = with_ma(1000);
  EXPECT_EQ(authority(d, {}, FS, kInRear).EOA, at(1000));
  EXPECT_EQ(authority(d, {}, OS, kInRear).EOA, at(1000));
  EXPECT_EQ(authority(d, {}, LS, kInRear).EOA, at(1000));
  EXPECT_FALSE(authority(d, {}, SR, kInRear).EOA);
  EXPECT_FALSE(authority(Description{}, {}, FS, kInRear).EOA);
}

TEST(Authority, AnAreaOfAnotherModeIsATemporaryEnd) {  // 5.9.3.5
  Description d = with_ma(1000);
  d.ma->danger_point = DangerPoint{at(1050), {ReleaseSpeedChoice::value, Speed{4}}};
  put_area(d, 600, 800, Mode::OS);
  Authority a = authority(d, {}, FS, kInRear);
  EXPECT_EQ(a.EOA, at(600));
  EXPECT_EQ(a.SvL, at(600));
  EXPECT_EQ(a.release.kind, ReleaseSpeedChoice::none);
  EXPECT_EQ(authority(d, {}, OS, kInRear).EOA, at(1000)) << "in OS already";
  d.mode_profile[0].also_SvL = false;
  a = authority(d, {}, FS, kInRear);
  EXPECT_EQ(a.EOA, at(600));
  EXPECT_EQ(a.SvL, at(1050));
  EXPECT_EQ(a.release.kind, ReleaseSpeedChoice::none);
  accept_area(d, Mode::OS, front_at(550));
  EXPECT_EQ(authority(d, {}, FS, kInRear).EOA, at(1000));
  put_area(d, 700, 900, Mode::LS);
  EXPECT_EQ(authority(d, {}, OS, kInRear).EOA, at(700));
  EXPECT_EQ(authority(d, {}, LS, kInRear).EOA, at(1000));
}

// 5.7.2.2, 5.9.2.2, 5.19.2.2: an area in which the estimated front end stands is entered at once.
TEST(Authority, AnAreaThatIsReachedIsNoStop) {
  Description d = with_ma(1000);
  put_area(d, 600, 800, Mode::OS);
  EXPECT_EQ(authority(d, {}, FS, at(599.9)).EOA, at(600));
  EXPECT_EQ(authority(d, {}, FS, at(600)).EOA, at(1000));
  EXPECT_EQ(authority(d, {}, FS, at(600.1)).EOA, at(1000));
}

TEST(Authority, WithAnLoa) {
  Description d = with_ma(1000);
  d.ma->V_LOA = Speed{15};
  Authority a = authority(d, {}, FS, kInRear);
  EXPECT_EQ(a.LOA, at(1000));
  EXPECT_EQ(a.V_LOA, Speed{15});
  EXPECT_FALSE(a.EOA || a.SvL);
  put_area(d, 600, 800, Mode::OS, false);
  a = authority(d, {}, FS, kInRear);
  EXPECT_EQ(a.EOA, at(600));
  EXPECT_EQ(a.SvL, at(1000)) << "as if there were no LOA";
  EXPECT_FALSE(a.LOA);
  EXPECT_EQ(a.EOA_or_LOA(), at(600));
  d.mode_profile[0].from = at(1000);
  EXPECT_EQ(authority(d, {}, FS, kInRear).EOA, at(1000)) << "at the LOA";
  d.mode_profile[0].from = at(1200);
  a = authority(d, {}, FS, kInRear);
  EXPECT_FALSE(a.EOA || a.SvL) << "the LOA lies in rear of the area";
  EXPECT_EQ(a.EOA_or_LOA(), at(1000));
}

TEST(Authority, UnsuitableRouteAndLevelCrossing) {  // 3.12.2, 3.12.5
  Description d = with_ma(1000);
  RouteSuitability item;
  item.at = at(700);
  item.kind = Suitability::axle_load;
  item.M_LINEAXLELOADCAT = 0b1111;
  ASSERT_TRUE(d.suitability.push_back(item));
  TrainInterfaces train;
  train.M_AXLELOADCAT = 3;
  EXPECT_EQ(authority(d, train, FS, kInRear).EOA, at(1000));
  train.M_AXLELOADCAT = 4;
  EXPECT_EQ(authority(d, train, FS, kInRear).EOA, at(700));
  EXPECT_EQ(authority(d, train, FS, kInRear).SvL, at(700));
  LevelCrossing lx;
  lx.NID_LX = 3;
  lx.from = at(500);
  lx.to = at(510);
  lx.unprotected = true;
  ASSERT_TRUE(d.lx.push_back(lx));
  EXPECT_EQ(authority(d, train, FS, kInRear).EOA, at(500));
  substitute_level_crossing(d, 4, at(450));
  EXPECT_EQ(authority(d, train, FS, kInRear).EOA, at(500));
  substitute_level_crossing(d, 3, at(450));
  EXPECT_EQ(authority(d, train, FS, kInRear).EOA, at(700));
  EXPECT_EQ(d.lx[0].V_LX_from, at(450));
}

TEST(Suitability, ByKind) {
  TrainInterfaces train;
  RouteSuitability gauge;
  gauge.kind = Suitability::gauge;
  gauge.M_LINEGAUGE = 0b0110;  // GA, GB
  for (const auto& [code, closed] : {std::pair{0, true}, {1, true}, {2, false}, {3, false}, {4, true}}) {
    train.M_LOADINGGAUGE = static_cast<std::uint8_t>(code);
    EXPECT_EQ(unsuitable(gauge, train), closed) << code;
  }
  RouteSuitability traction;
  traction.kind = Suitability::traction;
  traction.M_VOLTAGE = 1;
  traction.NID_CTRACTION = 12;
  EXPECT_TRUE(unsuitable(traction, train));
  ASSERT_TRUE(train.tractions.push_back({1, 13}));
  EXPECT_TRUE(unsuitable(traction, train));
  traction.M_VOLTAGE = 0;
  EXPECT_TRUE(unsuitable(traction, train)) << "not fitted with any";
  traction.M_VOLTAGE = 1;
  ASSERT_TRUE(train.tractions.push_back({1, 12}));
  EXPECT_FALSE(unsuitable(traction, train));
  TrainInterfaces diesel;
  ASSERT_TRUE(diesel.tractions.push_back({0, 0}));
  EXPECT_FALSE(unsuitable(traction, diesel)) << "3.12.2.3.1";
  traction.kind = static_cast<Suitability>(3);
  EXPECT_TRUE(unsuitable(traction, train)) << "what is not understood closes";
}

TEST(Areas, AcceptedFromTheAcknowledgementWindowOn) {
  Description d;
  put_area(d, 600, 800, Mode::OS);
  const std::uint32_t revision = d.revision;
  accept_area(d, Mode::LS, front_at(500));
  accept_area(d, Mode::OS, front_at(499));
  EXPECT_EQ(d.revision, revision);
  accept_area(d, Mode::OS, front_at(500));
  EXPECT_GT(d.revision, revision);
  EXPECT_TRUE(d.mode_profile[0].accepted);
}

TEST(Adhesion, ReducedUntilTheRearHasLeft) {  // 3.13.5.3
  Description d;
  ASSERT_TRUE(d.adhesion.push_back({at(100), at(200), true}));
  EXPECT_FALSE(slippery(d, at(99), Distance{50}));
  EXPECT_TRUE(slippery(d, at(100), Distance{50}));
  EXPECT_TRUE(slippery(d, at(250), Distance{50}));
  EXPECT_FALSE(slippery(d, at(251), Distance{50}));
}

TEST(TrackDescription, FrontInRearOfIt) {  // [69]
  Description d;
  EXPECT_TRUE(before_track_description(d, front_at(0)));
  ASSERT_TRUE(d.ssp.replace_from(ssp({{100, 50}})));
  EXPECT_TRUE(before_track_description(d, front_at(200)));
  ASSERT_TRUE(d.gradient.replace_from(slopes({{150, 0}})));
  EXPECT_TRUE(before_track_description(d, front_at(149)));
  EXPECT_FALSE(before_track_description(d, front_at(150)));
  ASSERT_TRUE(d.gradient.replace_from(slopes({{50, 0}})));
  EXPECT_TRUE(before_track_description(d, front_at(99)));
}

TEST(TrackDescription, UnderTheTrainBothAreKnown) {  // 4.4.9.1.4
  for (const bool speeds : {false, true})
    for (const bool gradients : {false, true}) {
      Description d;
      if (speeds) (void)d.ssp.replace_from(ssp({{-500, 50}}));
      if (gradients) (void)d.gradient.replace_from(slopes({{-500, 0}}));
      EXPECT_EQ(described_under_train(d, front_at(0)), speeds && gradients);
      EXPECT_FALSE(described_under_train(d, front_at(-400))) << "the rear end is in rear of it";
    }
}

TEST(Timeout, NoneWithoutAnMa) { EXPECT_FALSE(time_to_timeout(Description{}, Duration{0})); }

TEST(Suitability, KindsOfWhatIsStored) {  // 3.12.2.3
  Description d;
  EXPECT_TRUE(unsuitability(d, {}).empty());
  RouteSuitability gauge;
  gauge.kind = Suitability::gauge;
  gauge.M_LINEGAUGE = 0b0010;
  RouteSuitability axle_load;
  axle_load.kind = Suitability::axle_load;
  axle_load.M_LINEAXLELOADCAT = 0b1111;
  ASSERT_TRUE(d.suitability.push_back(gauge) && d.suitability.push_back(axle_load));
  TrainInterfaces train;
  train.M_LOADINGGAUGE = 2;
  train.M_AXLELOADCAT = 4;
  EXPECT_EQ(unsuitability(d, train), Set<Suitability>{Suitability::axle_load});
  train.M_LOADINGGAUGE = 4;
  EXPECT_EQ(unsuitability(d, train), (Set<Suitability>{Suitability::axle_load, Suitability::gauge}));
}

TEST(Reversing, WhatIsLeftOfTheDistance) {  // 3.15.4: from the end of the area, backwards
  Description d;
  EXPECT_FALSE(reversing_left(d, front_at(100)));
  d.reversing_reference = at(300);
  EXPECT_FALSE(reversing_left(d, front_at(100)));
  d.reversing_supervision = ReversingSupervision{};
  EXPECT_FALSE(reversing_left(d, front_at(100))) << "infinite";
  d.reversing_supervision->D_REVERSE = Distance{500};
  EXPECT_EQ(reversing_left(d, front_at(300)), Distance{500});
  EXPECT_EQ(reversing_left(d, front_at(-200)), Distance{0});
  EXPECT_EQ(reversing_left(d, front_at(-201)), Distance{-1});
}

TEST(Reversing, OnlyWithAnAreaAndADistance) {  // 3.15.4: packets 138 and 139 may come apart
  for (const bool area : {false, true})
    for (const bool supervision : {false, true})
      for (const bool distance : {false, true}) {
        Description d;
        if (area) d.reversing_reference = at(300);
        if (supervision) d.reversing_supervision.emplace();
        if (supervision && distance) d.reversing_supervision->D_REVERSE = Distance{500};
        EXPECT_EQ(reversing_left(d, front_at(300)).has_value(), area && supervision && distance);
      }
}

TEST(GeographicalPosition, CountsFromTheOffset) {  // 3.6.6
  Description d;
  EXPECT_FALSE(geographical_position(d, front_at(0)));
  GeoReference up;
  up.group = {1, 10};
  up.D_POSOFF = Distance{50};
  up.M_POSITION = 12000;
  GeoReference down = up;
  down.group = {1, 11};
  down.counts_up = false;
  down.M_POSITION = 30;
  GeoReference stop = up;
  stop.group = {1, 12};
  stop.M_POSITION.reset();
  ASSERT_TRUE(d.geo.push_back(up) && d.geo.push_back(down) && d.geo.push_back(stop));
  const auto position = [&d](double est) {
    advance_geographical_position(d, front_at(est));
    return geographical_position(d, front_at(est));
  };
  EXPECT_FALSE(position(500)) << "its group was not passed yet";
  note_group(d, {1, 10}, at(100), Direction::nominal);
  EXPECT_FALSE(position(149));
  EXPECT_EQ(position(150), 12000u);
  EXPECT_EQ(position(250.4), 12100u);
  EXPECT_EQ(position(140), 11990u) << "it remains applicable (3.6.6.9)";
  note_group(d, {1, 11}, at(400), Direction::nominal);
  EXPECT_EQ(position(460), 20u);
  EXPECT_EQ(d.geo.size(), 2u) << "the first one is deleted (3.6.6.9.1)";
  EXPECT_FALSE(position(490)) << "below zero";
  EXPECT_FALSE(position(460)) << "and deleted with that";
  note_group(d, {1, 12}, at(600), Direction::nominal);
  EXPECT_FALSE(position(700)) << "ordered to stop";
  EXPECT_TRUE(d.geo.empty());
}

// 3.6.6.10: the counting direction is that of the reference group, not of the group that sent the packet.
TEST(GeographicalPosition, CountsInTheDirectionOfItsGroup) {
  for (const bool nominal : {true, false}) {
    Description d;
    GeoReference reference;
    reference.group = {1, 10};
    reference.M_POSITION = 12000;
    ASSERT_TRUE(d.geo.push_back(reference));
    note_group(d, {1, 10}, at(100), Direction::unknown);  // a single group (3.6.6.7)
    EXPECT_FALSE(d.geo[0].applies_from);
    note_group(d, {1, 10}, at(100), nominal ? Direction::nominal : Direction::reverse);
    advance_geographical_position(d, front_at(200));
    EXPECT_EQ(geographical_position(d, front_at(200)), nominal ? 12100u : 11900u);
  }
}

// 3.6.6.9 c: it ends below zero, not at zero.
TEST(GeographicalPosition, ZeroIsAPosition) {
  Description d;
  GeoReference down;
  down.group = {1, 10};
  down.counts_up = false;
  down.M_POSITION = 30;
  ASSERT_TRUE(d.geo.push_back(down));
  note_group(d, {1, 10}, at(100), Direction::nominal);
  for (const double front : {129.5, 130.0}) {
    advance_geographical_position(d, front_at(front));
    EXPECT_EQ(d.geo.size(), 1u) << front;
  }
  EXPECT_EQ(geographical_position(d, front_at(130)), 0u);
  advance_geographical_position(d, front_at(130.1));
  EXPECT_TRUE(d.geo.empty());
}

// 3.6.4.7: the place of an unlinked group moves with the position.
TEST(GeographicalPosition, HangsOnTheGroupThatIsPassed) {
  for (const Anchor anchor : {Anchor::lrbg, Anchor::unlinked}) {
    Description d;
    GeoReference reference;
    reference.group = {1, 10};
    reference.M_POSITION = 12000;
    ASSERT_TRUE(d.geo.push_back(reference));
    note_group(d, {1, 10}, at(100), Direction::nominal, anchor);
    EXPECT_EQ(d.geo[0].anchor, anchor);
  }
}

}  // namespace
}  // namespace evc::track
