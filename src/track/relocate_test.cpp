#include "track/relocate.h"

#include <gtest/gtest.h>

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
  c.rbc_transition.emplace().at = at(750);
  c.radio_infill.emplace().at = at(760);
  store_unlinked(d, c);
  relocate(d, Anchor::unlinked, Anchor::travelled, kBack);

  ASSERT_TRUE(d.ma);
  EXPECT_EQ(d.rbc_transition->at, at(740));
  EXPECT_EQ(d.radio_infill->at, at(750));
  EXPECT_EQ(d.ma->end(), at(910));  // EOA: estimated and min; SvL: max
  EXPECT_EQ(d.ma->overlap->start, at(820));
  EXPECT_EQ(d.ma->overlap->end, at(930));
  EXPECT_EQ(d.ma->danger_point->at, at(920));
  EXPECT_EQ(d.ma->end_section->start, at(770));
  EXPECT_EQ(d.mode_profile[0].from, at(570));
  EXPECT_EQ(d.mode_profile[0].ack_from, at(520));
  EXPECT_EQ(*d.mode_profile[0].to, at(645));
  EXPECT_EQ(d.lx[0].from, at(370));
  EXPECT_EQ(d.lx[0].to, at(405));
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

}  // namespace
}  // namespace evc::track
