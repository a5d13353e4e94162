#include "track/relocate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "track/testing.h"

namespace evc::track {
namespace {

using testing::at;
using testing::front_at;
using testing::kEnd;
using testing::slopes;
using testing::ssp;

/// The train is 10 m less far than it was believed; what restricts begins 20 m nearer and ends 5 m farther.
constexpr Relocation kBack{Distance{-10}, 20_m, 5_m};

/// Stored as the message of an unlinked group.
void store_unlinked(Description& d, Contents& c) {
  hang_on_unlinked(c);
  (void)store(d, c, front_at(0));
  relocate(d, Anchor::received, Anchor::unlinked, {});
}

template <class P>
std::vector<std::pair<double, int>> steps_of(const P& profile) {
  std::vector<std::pair<double, int>> steps;
  for (const auto& step : profile.steps) {
    int value = 0;
    if constexpr (requires { step.value.V_STATIC; })
      value = step.value.V_STATIC * 5;
    else
      value = step.value.permille;
    steps.push_back({step.from.from_origin.si, value});
  }
  return steps;
}
using Steps = std::vector<std::pair<double, int>>;

TEST(RelocateData, OnlyWhatHangsOnTheGroupMoves) {
  Description d;
  Contents linked;
  ASSERT_TRUE(linked.tsr.push_back({at(500), at(700), 1, false, 8, false, {}}));
  (void)store(d, linked, front_at(0));
  Contents unlinked;
  ASSERT_TRUE(unlinked.tsr.push_back({at(500), at(700), 2, false, 8, false, {}}));
  store_unlinked(d, unlinked);
  const std::uint32_t before = d.revision;
  relocate(d, Anchor::travelled, Anchor::lrbg, kBack);
  EXPECT_EQ(d.revision, before);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
  EXPECT_NE(d.revision, before);
  EXPECT_EQ(d.tsr[0].from, at(500));
  EXPECT_EQ(d.tsr[0].to, at(700));
  EXPECT_EQ(d.tsr[1].from, at(470));  // compared with the max safe front end
  EXPECT_EQ(d.tsr[1].to, at(695));    // compared with the min safe front end
  EXPECT_EQ(d.tsr[1].anchor, Anchor::travelled);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);  // once
  EXPECT_EQ(d.tsr[1].from, at(470));
}

// Table 2a of 4.0.0 (3.6.4.2.4).
TEST(RelocateData, EachKindByWhatItIsComparedWith) {
  Description d;
  Contents c = testing::whole(1000);
  c.ma = testing::authority_to(940);
  c.ma->overlap = Overlap{at(850), at(960), {}, {}};
  c.ma->danger_point = DangerPoint{at(950), {}};
  c.ma->end_section = EndSectionTimer{at(800), {}};
  ModeArea area;
  area.from = at(600);
  area.to = at(650);
  area.ack_from = at(550);
  ASSERT_TRUE(c.mode_profile.emplace().push_back(area));
  LevelCrossing lx;
  lx.from = at(400);
  lx.to = at(410);
  ASSERT_TRUE(c.lx.push_back(lx));
  c.conditions.emplace();
  ASSERT_TRUE(c.conditions->elements.push_back({at(100), at(200), TrackConditionKind::powerless_main_switch_off, {}}));
  ASSERT_TRUE(c.conditions->elements.push_back({at(100), at(200), TrackConditionKind::radio_hole, {}}));
  c.adhesion = AdhesionArea{at(300), at(350), true, {}};
  c.traction = TractionChange{at(700), 1, 2, {}};
  c.current = CurrentChange{at(710), {}, {}};
  c.suitability.emplace();
  RouteSuitability item;
  item.at = at(750);
  ASSERT_TRUE(c.suitability->elements.push_back(item));
  c.reversing_area = ReversingArea{at(50), at(60), {}};
  Text text;
  text.start_at = at(5);
  text.end_at = at(15);
  ASSERT_TRUE(c.texts.push_back(text));
  GeoReference geo;
  geo.applies_from = at(20);
  ASSERT_TRUE(c.geo.emplace().push_back(geo));
  c.asp.emplace();
  ASSERT_TRUE(c.asp->elements.push_back({at(110), at(120), false, {}, {}}));
  c.pbd.emplace();
  ASSERT_TRUE(c.pbd->elements.push_back({at(130), at(140), 300_m, 0, false, {}}));
  c.big_metal.emplace();
  ASSERT_TRUE(c.big_metal->elements.push_back({at(150), at(160), {}}));
  c.platforms.emplace();
  ASSERT_TRUE(c.platforms->elements.push_back({at(170), at(180), 0, 0, {}, {}}));
  c.rbc_transition.emplace().at = at(750);
  c.radio_infill.emplace().at = at(760);
  store_unlinked(d, c);
  ASSERT_TRUE(d.ma);
  d.ma->fixed_SvL = at(955);
  d.lx[0].V_LX_from = at(390);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);

  EXPECT_EQ(d.rbc_transition->at, at(740));
  EXPECT_EQ(d.radio_infill->at, at(750));
  EXPECT_EQ(d.ma->end(), at(910));  // EOA: estimated and min; SvL: max
  EXPECT_EQ(d.ma->start(), at(-30));
  EXPECT_EQ(d.ma->fixed_SvL, at(925));
  EXPECT_EQ(d.ma->overlap->start, at(820));
  EXPECT_EQ(d.ma->overlap->end, at(930));
  EXPECT_EQ(d.ma->danger_point->at, at(920));
  EXPECT_EQ(d.ma->end_section->start, at(770));
  EXPECT_EQ(d.mode_profile[0].from, at(570));
  EXPECT_EQ(d.mode_profile[0].ack_from, at(520));
  EXPECT_EQ(*d.mode_profile[0].to, at(645));
  EXPECT_EQ(d.lx[0].from, at(370));
  EXPECT_EQ(d.lx[0].to, at(405));
  EXPECT_EQ(d.lx[0].V_LX_from, at(360));  // the start of a speed
  EXPECT_EQ(d.asp[0].from, at(80));
  EXPECT_EQ(d.asp[0].to, at(115));
  EXPECT_EQ(d.pbd[0].from, at(100));
  EXPECT_EQ(d.pbd[0].to, at(135));
  EXPECT_EQ(d.big_metal[0].from, at(120));
  EXPECT_EQ(d.big_metal[0].to, at(155));
  EXPECT_EQ(d.platforms[0].from, at(140));
  EXPECT_EQ(d.platforms[0].to, at(175));
  EXPECT_EQ(d.conditions[0].from, at(70));
  EXPECT_EQ(d.conditions[0].to, at(195));
  EXPECT_EQ(d.conditions[1].from, at(90));  // the estimated front end counts for a radio hole
  EXPECT_EQ(d.conditions[1].to, at(190));
  EXPECT_EQ(d.adhesion[0].from, at(270));
  EXPECT_EQ(d.adhesion[0].to, at(345));
  EXPECT_EQ(d.traction->at, at(670));
  EXPECT_EQ(d.current->at, at(680));
  EXPECT_EQ(d.suitability[0].at, at(720));
  EXPECT_EQ(d.reversing_area->from, at(40));
  EXPECT_EQ(d.reversing_area->to, at(50));
  EXPECT_EQ(*d.reversing_reference, at(50));
  EXPECT_EQ(*d.texts[0].start_at, at(-5));
  EXPECT_EQ(*d.texts[0].end_at, at(5));
  EXPECT_EQ(*d.geo[0].applies_from, at(10));
}

// The estimated front end counts for a radio hole, a tunnel stopping area and the horn (Table 2a of 4.0.0).
TEST(RelocateData, EachKindOfTrackCondition) {
  using enum TrackConditionKind;
  for (const auto& row : kTrackConditionRows) {
    const bool by_estimate = row.value == radio_hole || row.value == tunnel_stopping_area || row.value == sound_horn;
    Description d;
    Contents c;
    c.conditions.emplace();
    ASSERT_TRUE(c.conditions->elements.push_back({at(100), at(200), row.value, {}, {}}));
    store_unlinked(d, c);
    relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
    EXPECT_EQ(d.conditions[0].from, by_estimate ? at(90) : at(70)) << row.name;
    EXPECT_EQ(d.conditions[0].to, by_estimate ? at(190) : at(195)) << row.name;
  }
}

// What moves may be the estimate alone or one doubt alone, for areas, the authority and profiles alike.
TEST(RelocateData, EachPartOfARelocationCountsAlone) {
  struct Case {
    Relocation by;
    double from, to, estimated, EOA;  // of what stands at 500, 700, 800, 900
  };
  for (const Case& k : {Case{{Distance{-10}, {}, {}}, 490, 690, 790, 890}, Case{{{}, 20_m, {}}, 480, 700, 800, 880},
                        Case{{{}, {}, 5_m}, 500, 705, 800, 895}, Case{{{}, 5_m, 20_m}, 495, 720, 800, 880},
                        Case{{Distance{10}, 7_m, 7_m}, 503, 717, 810, 903}}) {
    Description d;
    Contents c = testing::whole(900);
    c.ssp = ssp({{0, 100}, {500, 60}, {700, 120}, {2000, kEnd}});
    c.gradient = slopes({{0, 0}, {500, -10}, {700, 5}, {2000, Gradient::kUnknown}});
    ASSERT_TRUE(c.tsr.push_back({at(500), at(700), 2, false, 8, false, {}}));
    c.rbc_transition.emplace().at = at(800);
    store_unlinked(d, c);
    relocate(d, Anchor::unlinked, Anchor::travelled, k.by);
    EXPECT_EQ(d.ma->end(), at(k.EOA));
    EXPECT_EQ(d.tsr[0].from, at(k.from));
    EXPECT_EQ(d.tsr[0].to, at(k.to));
    EXPECT_EQ(d.rbc_transition->at, at(k.estimated));
    const double first = k.from - 500, end = k.estimated - 800 + 2000;
    EXPECT_EQ(steps_of(d.ssp), (Steps{{first, 100}, {k.from, 60}, {k.to, 120}, {end, 635}}));
    EXPECT_EQ(steps_of(d.gradient), (Steps{{first, 0}, {k.from, -10}, {k.to, 5}, {end, Gradient::kUnknown}}));
  }
}

// 3.8.4.2.3: a section timer stops with the min safe front end (Table 2a of 4.0.0): not earlier than by that one.
TEST(RelocateData, TheStopOfASectionTimerMovesFarther) {
  Description d;
  d.ma = testing::authority_to(900);
  d.ma->sections[0].stop = at(400);
  d.ma->anchor = Anchor::unlinked;
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
  EXPECT_EQ(d.ma->sections[0].stop, at(395));
}

// What a message brings is distinguished from what an unlinked group sent before, until it is stored.
TEST(RelocateData, WhatIsReceivedDoesNotMoveWithWhatIsStored) {
  Contents c = testing::whole(1000);
  ASSERT_TRUE(c.tsr.push_back({at(500), at(700), 2, false, 8, false, {}}));
  hang_on_unlinked(c);
  Description d;
  (void)store(d, c, front_at(0));
  const Description before = d;
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
  EXPECT_EQ(d.ma, before.ma);
  EXPECT_EQ(d.ssp, before.ssp);
  EXPECT_EQ(d.gradient, before.gradient);
  EXPECT_EQ(d.tsr, before.tsr);
  EXPECT_EQ(d.revision, before.revision);
  relocate(d, Anchor::received, Anchor::unlinked, kBack);
  EXPECT_EQ(d.ma->end(), at(970));
  EXPECT_EQ(d.tsr[0].from, at(470));
}

// Curves and track conditions are computed again when anything has moved, and only then.
TEST(RelocateData, AnyDatumThatMovesIsReported) {
  const auto reported = [](const Contents& contents, Anchor of) {
    Description d;
    Contents c = contents;
    store_unlinked(d, c);
    d.watch.changed = false;
    const std::uint32_t before = d.revision;
    relocate(d, of, Anchor::travelled, kBack);
    EXPECT_EQ(d.watch.changed, d.revision != before);
    return d.watch.changed;
  };
  Contents speeds, gradient, horn;
  speeds.ssp = ssp({{0, 100}});
  gradient.gradient = slopes({{0, 0}});
  horn.conditions.emplace();
  ASSERT_TRUE(horn.conditions->elements.push_back({at(100), at(200), TrackConditionKind::sound_horn, {}, {}}));
  for (const Contents& c : {speeds, gradient, horn}) {
    EXPECT_TRUE(reported(c, Anchor::unlinked));
    EXPECT_FALSE(reported(c, Anchor::lrbg));
  }
}

// 3.15.4: the distance for reversing counts from the end of the area as received.
TEST(RelocateData, TheReferenceForReversingMovesWithItsArea) {
  for (const Anchor anchor : {Anchor::lrbg, Anchor::unlinked}) {
    Description d;
    d.reversing_area = ReversingArea{at(50), at(60), anchor};
    d.reversing_reference = at(80);  // the area was shortened
    relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
    EXPECT_EQ(d.reversing_reference, anchor == Anchor::unlinked ? at(70) : at(80));
    EXPECT_EQ(d.reversing_area->to, anchor == Anchor::unlinked ? at(50) : at(60));
  }
}

TEST(RelocateData, AProfileIsLowerEarlierAndHigherLater) {
  Description d;
  Contents c;
  c.ssp = ssp({{0, 100}, {500, 60}, {700, 120}, {2000, kEnd}});
  c.gradient = slopes({{0, 0}, {500, -10}, {700, 5}});
  store_unlinked(d, c);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
  EXPECT_EQ(steps_of(d.ssp), (Steps{{-30, 100}, {470, 60}, {695, 120}, {1990, 635}}));
  EXPECT_EQ(steps_of(d.gradient), (Steps{{-30, 0}, {470, -10}, {695, 5}}));
}

// 3.6.4.2.6 of 4.0.0: the lowest parts remain.
TEST(RelocateData, AHighPartThatIsOvertakenVanishes) {
  Description d;
  Contents c;
  c.ssp = ssp({{0, 80}, {500, 100}, {505, 120}, {515, 60}, {900, 100}, {910, 160}, {920, 120}});
  store_unlinked(d, c);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
  // 900..920: 160 vanishes; 120 is higher than 60 and than 100.
  EXPECT_EQ(steps_of(d.ssp), (Steps{{-30, 80}, {485, 60}, {895, 100}, {915, 120}}));
}

// Where one category of trains may go faster and another one must go slower, neither is faster in between.
TEST(RelocateData, AChangeThatIsBothLeavesTheLowerOfBoth) {
  Description d;
  Contents c;
  c.ssp = ssp({{0, 100}, {500, 120}});
  c.ssp->steps[0].value.cd[10] = 26;  // 130 km/h
  store_unlinked(d, c);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
  EXPECT_EQ(steps_of(d.ssp), (Steps{{-30, 100}, {470, 100}, {495, 120}}));
  EXPECT_EQ(d.ssp.steps[1].value.cd[10], kNoSpeed);
}

/// The speeds of an element: for all trains, for those of the highest cant deficiency, for passenger trains; 0: not
/// given.
StaticSpeed speeds_of(int all, int cant_deficiency, int passenger) {
  const auto code = [](int kmh) { return kmh > 0 ? static_cast<SpeedCode>(kmh / 5) : kNoSpeed; };
  StaticSpeed element;
  element.V_STATIC = code(all);
  element.cd[10] = code(cant_deficiency);
  element.other[2] = code(passenger);
  return element;
}
/// The profile of `first` from 0 and `second` from 500 on, after kBack.
StaticSpeedProfile after_kBack(const StaticSpeed& first, const StaticSpeed& second) {
  Description d;
  Contents c;
  c.ssp.emplace();
  EXPECT_TRUE(c.ssp->append(at(0), first) && c.ssp->append(at(500), second));
  store_unlinked(d, c);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
  return d.ssp;
}

// A change is to a lower (higher) value if no train may go faster (slower) beyond it. Otherwise nobody may go faster
// than the lowest speed of both between its two places.
TEST(RelocateData, AChangeCountsForTheTrainsOfEveryCategory) {
  struct Case {
    const char* what;
    StaticSpeed first, second;
    int between;  // 470..495, lowest speed there; 0: `first` as it was, 1: `second` from 470 on
  };
  for (const Case& k : {
           Case{"lower for all", speeds_of(100, 0, 0), speeds_of(60, 0, 0), 1},
           Case{"higher for all", speeds_of(60, 0, 0), speeds_of(100, 0, 0), 0},
           Case{"nobody goes faster", speeds_of(80, 100, 0), speeds_of(60, 80, 0), 1},
           Case{"nobody goes faster, another category", speeds_of(80, 0, 100), speeds_of(60, 0, 80), 1},
           Case{"nobody goes slower", speeds_of(60, 80, 0), speeds_of(80, 100, 0), 0},
           Case{"nobody goes slower, another category", speeds_of(60, 0, 80), speeds_of(80, 0, 100), 0},
           Case{"some faster, since they were slower before", speeds_of(100, 60, 0), speeds_of(80, 0, 0), 60},
           Case{"the same for another category", speeds_of(100, 0, 60), speeds_of(80, 0, 0), 60},
           Case{"some slower, since they were faster before", speeds_of(80, 120, 0), speeds_of(100, 0, 0), 80},
           Case{"some slower beyond it", speeds_of(80, 0, 0), speeds_of(100, 70, 0), 70},
           Case{"the same for another category", speeds_of(80, 0, 0), speeds_of(100, 0, 70), 70},
       }) {
    const StaticSpeedProfile p = after_kBack(k.first, k.second);
    ASSERT_TRUE(p.at(at(480))) << k.what;
    if (k.between > 1)
      EXPECT_EQ(p.at(at(480)), speeds_of(k.between, 0, 0)) << k.what;
    else
      EXPECT_EQ(p.at(at(480)), k.between == 1 ? k.second : k.first) << k.what;
    EXPECT_EQ(p.at(at(469)), k.first) << k.what;
    EXPECT_EQ(p.at(at(495)), k.second) << k.what;
  }
}

TEST(RelocateData, AnElementThatIsRepeatedIsNoChange) {
  const StaticSpeed element = speeds_of(100, 60, 120);
  const StaticSpeedProfile repeated = after_kBack(element, element);
  for (const double x : {0.0, 469.0, 480.0, 495.0, 1000.0}) EXPECT_EQ(repeated.at(at(x)), element) << x;
  Description d;
  Contents c;
  c.ssp = ssp({{0, 60}, {500, 100}, {505, 100}});
  c.gradient = slopes({{0, 5}, {500, 5}, {503, Gradient::kUnknown}});
  store_unlinked(d, c);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
  EXPECT_EQ(d.ssp.at(at(494))->V_STATIC, 12);
  EXPECT_EQ(d.ssp.at(at(495))->V_STATIC, 20);
  EXPECT_EQ(d.gradient.at(at(492)), Gradient{5});
  EXPECT_FALSE(d.gradient.at(at(493))) << "the end is where it is";
}

// Without doubt nothing is lowered and nothing falls together: only what the data hang on is another.
TEST(RelocateData, WithoutAWayOnlyTheAnchorChanges) {
  Description d;
  Contents c;
  c.ssp.emplace();
  ASSERT_TRUE(c.ssp->append(at(0), speeds_of(100, 130, 0)) && c.ssp->append(at(500), speeds_of(120, 0, 0)));
  store_unlinked(d, c);
  const StaticSpeedProfile before = d.ssp;
  relocate(d, Anchor::unlinked, Anchor::travelled, {});
  EXPECT_EQ(steps_of(d.ssp), steps_of(before));
  for (const auto& step : d.ssp.steps) EXPECT_EQ(step.anchor, Anchor::travelled);
}

// 3.6.4.2.6 of 4.0.0 concerns changes that lie in rear of the one before; an element that shrinks to no length is still
// one (3.6.3.2.2 e).
TEST(RelocateData, AHighPartThatIsOnlyReachedStays) {
  Description d;
  Contents c;
  c.ssp = ssp({{0, 60}, {500, 100}, {525, 80}});
  store_unlinked(d, c);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
  EXPECT_EQ(steps_of(d.ssp), (Steps{{-30, 60}, {495, 100}, {495, 80}}));
}

// A rise moves farther than what follows it: that stays behind it, and is never lost.
TEST(RelocateData, WhatFollowsARiseIsNotBeforeIt) {
  Description d;
  Contents c;
  c.ssp = ssp({{0, 60}, {500, 100}, {503, kEnd}});
  c.gradient = slopes({{0, -5}, {500, 5}, {503, Gradient::kUnknown}});
  store_unlinked(d, c);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
  EXPECT_EQ(d.ssp.at(at(490))->V_STATIC, 12);
  EXPECT_FALSE(d.ssp.at(at(495))) << "the profile ends";
  EXPECT_FALSE(d.gradient.at(at(495)));

  Description both;
  Contents m;
  m.ssp.emplace();
  ASSERT_TRUE(m.ssp->append(at(0), speeds_of(60, 0, 0)) && m.ssp->append(at(500), speeds_of(100, 0, 0)) &&
              m.ssp->append(at(505), speeds_of(80, 120, 0)));
  store_unlinked(both, m);
  relocate(both, Anchor::unlinked, Anchor::travelled, kBack);
  EXPECT_EQ(both.ssp.at(at(494)), speeds_of(60, 0, 0));
  EXPECT_EQ(both.ssp.at(at(497)), speeds_of(80, 0, 0)) << "nobody faster than both allow";
  EXPECT_EQ(both.ssp.at(at(500)), speeds_of(80, 120, 0));
}

// Behind a part without speeds the first speed begins with the max safe front end, however near the part began.
TEST(RelocateData, SpeedsBehindAnUnknownPartBeginNearer) {
  for (const SpeedCode of_a_category : {kNoSpeed, SpeedCode{16}}) {  // beside the end of the profile: no speed either
    Description d;
    Contents c;
    c.ssp = ssp({{500, kEnd}, {505, 100}, {700, kEnd}});
    c.ssp->steps[0].value.cd[10] = of_a_category;
    store_unlinked(d, c);
    relocate(d, Anchor::unlinked, Anchor::travelled, kBack);
    EXPECT_FALSE(d.ssp.at(at(474)));
    ASSERT_TRUE(d.ssp.at(at(475)));
    EXPECT_EQ(d.ssp.at(at(475))->V_STATIC, 20);
    EXPECT_TRUE(d.ssp.at(at(689)));
    EXPECT_FALSE(d.ssp.at(at(690)));
  }
}

TEST(RelocateData, LaterDataOfLinkedGroupsStayInPlace) {
  Description d;
  Contents c;
  c.ssp = ssp({{0, 100}, {500, 60}, {700, 120}});
  store_unlinked(d, c);
  Contents linked;
  linked.ssp = ssp({{600, 80}, {900, kEnd}});
  (void)store(d, linked, front_at(0));
  relocate(d, Anchor::unlinked, Anchor::travelled, {Distance{150}, {}, {}});
  EXPECT_EQ(steps_of(d.ssp), (Steps{{150, 100}, {600, 80}, {900, 635}}));
}

// --- 3.7.3.1.1 to 3.7.3.1.4 of 4.0.0

/// The distance to the group was measured: its data begin 20 m nearer at most, and 10 m farther.
constexpr Relocation kMeasured{{}, 20_m, 10_m};

/// Stored as the message of an unlinked group that was passed before the LRBG.
void store_measured(Description& d, Contents& c, const Relocation& by = kMeasured) {
  hang_on_unlinked(c);
  overlap(d, c, Anchor::travelled, by);
  (void)store(d, c, front_at(0));
  relocate(d, Anchor::received, Anchor::travelled, by);
}
Description with_speeds(std::initializer_list<testing::SpeedAt> steps) {
  Description d;
  Contents c;
  c.ssp = ssp(steps);
  (void)store(d, c, front_at(0));
  return d;
}

TEST(Overlap, TheLowerSpeedCountsWhereTheNewProfileMayBegin) {  // 3.7.3.1.1
  Description d = with_speeds({{0, 140}, {505, 40}, {600, 160}, {2000, kEnd}});
  Contents c;
  c.ssp = ssp({{500, 100}, {900, 120}, {2000, kEnd}});
  store_measured(d, c);
  EXPECT_EQ(steps_of(d.ssp), (Steps{{0, 140}, {480, 100}, {505, 40}, {510, 100}, {910, 120}, {2000, 635}}));
  EXPECT_EQ(d.ssp.steps[1].anchor, Anchor::travelled);
  EXPECT_EQ(d.ssp.steps[2].anchor, Anchor::lrbg) << "a step of the stored profile";
  EXPECT_EQ(d.ssp.steps[3].anchor, Anchor::travelled);

  d = with_speeds({{0, 100}, {495, 40}, {2000, kEnd}});
  c.ssp = ssp({{500, 60}, {2000, kEnd}});
  store_measured(d, c);
  EXPECT_EQ(steps_of(d.ssp), (Steps{{0, 100}, {480, 60}, {495, 40}, {510, 60}, {2000, 635}}));

  d = with_speeds({{0, 100}, {495, kEnd}});
  c.ssp = ssp({{500, 60}, {505, 120}, {2000, kEnd}});
  store_measured(d, c);
  EXPECT_EQ(steps_of(d.ssp), (Steps{{0, 100}, {480, 60}, {515, 120}, {2000, 635}})) << "no stored speed from 495 on";
}

TEST(Overlap, OfDifferentCategoriesTheLowerSpeedOfEachCounts) {  // 3.7.3.1.1
  const auto result_of = [](const StaticSpeed& first, const StaticSpeed& second) {
    Description d;
    Contents c;
    c.ssp.emplace();
    EXPECT_TRUE(c.ssp->append(at(0), first));
    (void)store(d, c, front_at(0));
    c.ssp.emplace();
    EXPECT_TRUE(c.ssp->append(at(500), second));
    store_measured(d, c);
    EXPECT_EQ(d.ssp.at(at(479)), first);
    EXPECT_EQ(d.ssp.at(at(510)), second);
    return *d.ssp.at(at(500));
  };
  EXPECT_EQ(result_of(speeds_of(80, 120, 100), speeds_of(100, 110, 90)), speeds_of(80, 110, 90));
  EXPECT_EQ(result_of(speeds_of(80, 120, 0), speeds_of(100, 0, 0)), speeds_of(80, 0, 0)) << "not above either";
  EXPECT_EQ(result_of(speeds_of(80, 0, 0), speeds_of(60, 0, 0)), speeds_of(60, 0, 0));
  StaticSpeed whole = speeds_of(80, 120, 0), front = speeds_of(100, 110, 0);
  front.Q_FRONT = true;
  EXPECT_FALSE(result_of(whole, front).Q_FRONT) << "with the delay of the train length";
  whole.Q_FRONT = true;
  EXPECT_TRUE(result_of(whole, front).Q_FRONT);
}

TEST(Overlap, TheLowerGradientCountsWhereTheNewProfileMayBegin) {  // 3.7.3.1.2
  Description d;
  Contents c;
  c.gradient = slopes({{0, 0}, {505, -10}, {2000, Gradient::kUnknown}});
  (void)store(d, c, front_at(0));
  c.gradient = slopes({{500, 5}, {2000, Gradient::kUnknown}});
  store_measured(d, c);
  EXPECT_EQ(steps_of(d.gradient), (Steps{{0, 0}, {480, 0}, {505, -10}, {510, 5}, {2000, Gradient::kUnknown}}));
}

TEST(Overlap, AnElementWithoutLengthCounts) {  // 3.6.3.2.2 e
  Description d = with_speeds({{0, 100}, {505, 40}, {505, 120}, {2000, kEnd}});
  Contents c;
  c.ssp = ssp({{500, 110}, {2000, kEnd}});
  store_measured(d, c);
  EXPECT_EQ(steps_of(d.ssp), (Steps{{0, 100}, {480, 100}, {505, 40}, {505, 110}, {2000, 635}}));
}

TEST(Overlap, StoredAreasCountUpToTheFarthestBegin) {  // 3.7.3.1.3, 3.7.3.1.4
  Description d;
  Contents c;
  AxleLoadRestriction slow;
  slow.from = at(400);
  slow.to = at(700);
  slow.V_AXLELOAD[0] = 8;
  PermittedBrakingDistance braking;
  braking.from = at(400);
  braking.to = at(700);
  braking.D_PBD = 300_m;
  const auto offer = [&] {
    c.asp.emplace().from = slow.from;
    c.pbd.emplace().from = braking.from;
    return c.asp->elements.push_back(slow) && c.pbd->elements.push_back(braking);
  };
  ASSERT_TRUE(offer());
  (void)store(d, c, front_at(0));
  slow.from = braking.from = at(500);
  slow.to = braking.to = at(900);
  ASSERT_TRUE(offer());
  store_measured(d, c);
  const auto check = [](const auto& areas) {
    ASSERT_EQ(areas.size(), 2u);
    EXPECT_EQ(areas[0].from, at(400));
    EXPECT_EQ(areas[0].to, at(510));
    EXPECT_EQ(areas[1].from, at(480));
    EXPECT_EQ(areas[1].to, at(910));
  };
  check(d.asp);
  check(d.pbd);
}

TEST(Overlap, WithoutAMeasuredDistanceTheNewDataReplace) {  // 3.7.3.1
  Description d = with_speeds({{0, 140}, {505, 40}, {2000, kEnd}});
  Contents c;
  c.ssp = ssp({{500, 100}, {2000, kEnd}});
  store_measured(d, c, {});
  EXPECT_EQ(steps_of(d.ssp), (Steps{{0, 140}, {500, 100}, {2000, 635}}));
}

/// A random profile from `begin` on, of steps of 1 to 40 m.
template <class Rng>
NewStaticSpeedProfile random_speeds(Rng& random, double begin) {
  NewStaticSpeedProfile profile;
  for (int i = 0; i < 12; ++i, begin += 1.0 + static_cast<double>(random() % 40)) {
    StaticSpeed element;
    element.V_STATIC = static_cast<SpeedCode>(4 + random() % 28);
    profile.append(at(begin), element);
  }
  return profile;
}

TEST(Overlap, IsTheLowestAtEveryPlaceForRandomProfiles) {
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i) {
    Description d;
    Contents c;
    c.ssp = random_speeds(random, 0);
    (void)store(d, c, front_at(0));
    const StaticSpeedProfile old = d.ssp;
    const double begin = 20.0 + static_cast<double>(random() % 150);
    const Relocation by{{}, {static_cast<double>(random() % 20)}, {1.0 + static_cast<double>(random() % 60)}};
    c.ssp = random_speeds(random, begin);
    // Alone, it is where the stored one begins behind its start.
    Description alone;
    Contents same;
    same.ssp = c.ssp;
    hang_on_unlinked(same);
    (void)store(alone, same, front_at(0));
    relocate(alone, Anchor::received, Anchor::travelled, by);
    store_measured(d, c, by);
    for (double x = 0.25; x < 700.0; x += 0.5) {
      const auto before = old.at(at(x)), fresh = alone.ssp.at(at(x)), found = d.ssp.at(at(x));
      ASSERT_TRUE(found);
      const int lowest = std::min(before->V_STATIC, fresh ? fresh->V_STATIC : before->V_STATIC);
      const bool beyond = x >= begin + by.farther.si;
      EXPECT_EQ(found->V_STATIC, beyond ? fresh->V_STATIC : lowest) << i << ": " << x;
    }
  }
}

}  // namespace
}  // namespace evc::track
