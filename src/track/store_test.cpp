#include "track/store.h"

#include <gtest/gtest.h>

#include <vector>

#include <cstring>

#include "track/relocate.h"
#include "track/testing.h"

namespace evc::track {
namespace {

using namespace testing;

TEST(Store, TemporarySpeedRestrictions) {  // 3.11.5
  Description d;
  Contents c;
  for (const auto& t : {tsr_of(255, 0, 10, 8), tsr_of(255, 20, 30, 8), tsr_of(5, 0, 10, 8), tsr_of(5, 40, 50, 6)})
    ASSERT_TRUE(c.tsr.push_back(t));
  store(d, c, front_at(0));
  ASSERT_EQ(d.tsr.size(), 3u) << "255 is always added, 5 is replaced";
  EXPECT_EQ(d.tsr[2].from, at(40));
  Contents revoke;
  ASSERT_TRUE(revoke.revoked_tsr.push_back(255) && revoke.revoked_tsr.push_back(5) && revoke.revoked_tsr.push_back(9));
  revoke.default_gradient = -8;
  store(d, revoke, front_at(0));
  EXPECT_EQ(d.tsr.size(), 2u);
  EXPECT_EQ(d.default_gradient, -8);
  Contents inhibit;
  inhibit.inhibit_revocable_tsr = true;
  store(d, inhibit, front_at(0));
  Contents more;
  for (const auto& t : {tsr_of(7, 0, 1, 8), tsr_of(200, 0, 1, 8, true), tsr_of(255, 0, 1, 8)})
    ASSERT_TRUE(more.tsr.push_back(t));
  EXPECT_EQ(clause_of(store(d, more, front_at(0)), 65), "3.11.5.12"_srs);
  EXPECT_EQ(d.tsr.size(), 4u);
}

TEST(Store, AFullTsrStoreGrowsItsLastOneToCoverBoth) {
  Description d;
  for (std::size_t i = 0; i < d.tsr.capacity(); ++i)
    ASSERT_TRUE(d.tsr.push_back(tsr_of(static_cast<std::uint8_t>(i), 1000, 1100, 16)));
  Contents c;
  ASSERT_TRUE(c.tsr.push_back(tsr_of(100, 500, 600, 4)) && c.tsr.push_back(tsr_of(101, 2000, 2100, 20)));
  EXPECT_EQ(clause_of(store(d, c, front_at(0)), 65), "3.11.5"_srs);
  EXPECT_EQ(d.tsr.back().from, at(500));
  EXPECT_EQ(d.tsr.back().to, at(2100));
  EXPECT_EQ(d.tsr.back().V_TSR, 4);
}

/// An authority of 5 km with its description; the train's front end is at 0.
Description on_the_way() {
  Description d;
  EXPECT_TRUE(store(d, whole(5000), front_at(0)).ma_accepted);
  return d;
}
/// The restriction from 3000 m on was not stored: authority and description end there, everything before is kept.
void expect_ended(const Description& d, const Stored& stored, double at_metre = 3000.0) {
  ASSERT_TRUE(stored.lost_from);
  EXPECT_EQ(*stored.lost_from, at(at_metre));
  ASSERT_TRUE(d.ma);
  EXPECT_EQ(d.ma->end(), at(at_metre));
  EXPECT_EQ(d.ma->SvL(), at(at_metre));
  EXPECT_TRUE(complete(d, front_at(0)));
  EXPECT_FALSE(d.ssp.at(at(at_metre)));
  EXPECT_FALSE(d.gradient.at(at(at_metre)));
  EXPECT_TRUE(d.ssp.at(at(at_metre - 1.0)));
}
/// `n` elements in sequence from 100 m on, then one at 3000 and one at 3500 m.
template <class T>
Fresh<T> one_behind_the_other(std::size_t n) {
  Fresh<T> fresh;
  fresh.from = at(0);
  for (std::size_t i = 0; i < n; ++i) {
    T element;
    element.from = at(i + 2 < n ? 100.0 + static_cast<double>(i) : i + 2 == n ? 3000.0 : 3500.0);
    element.to = element.from + Distance{1.0};
    EXPECT_TRUE(fresh.elements.push_back(element));
  }
  return fresh;
}
/// Fills a store with elements behind the train, so that 28 of 30 new elements fit.
template <class T, std::size_t N>
void fill(InplaceVector<T, N>& stored, std::size_t fresh) {
  while (stored.size() + fresh - 2 < N) {
    T element;
    element.from = at(-100);
    element.to = at(-90);
    ASSERT_TRUE(stored.push_back(element));
  }
}

TEST(Store, WhatHasNoRoomAndRestrictsEndsTheAuthorityInFrontOfIt) {
  const Here here = front_at(0);
  {
    Description d = on_the_way();
    fill(d.asp, 30);
    Contents c;
    c.asp = one_behind_the_other<AxleLoadRestriction>(30);
    expect_ended(d, store(d, c, here));
  }
  {
    Description d = on_the_way();
    fill(d.pbd, 30);
    Contents c;
    c.pbd = one_behind_the_other<PermittedBrakingDistance>(30);
    expect_ended(d, store(d, c, here));
  }
  {
    Description d = on_the_way();
    fill(d.conditions, 30);
    Contents c;
    c.conditions = one_behind_the_other<TrackCondition>(30);
    expect_ended(d, store(d, c, here));
  }
  {
    Description d = on_the_way();
    while (d.lx.size() < d.lx.capacity())
      ASSERT_TRUE(d.lx.push_back({.from = at(100), .to = at(110), .NID_LX = static_cast<std::uint8_t>(d.lx.size())}));
    Contents c;
    ASSERT_TRUE(c.lx.push_back({.from = at(3000), .to = at(3010), .NID_LX = 100, .unprotected = true}));
    const Stored stored = store(d, c, here);
    EXPECT_EQ(clause_of(stored, 88), "3.12.5"_srs);
    expect_ended(d, stored);
    Description other = on_the_way();
    other.lx = d.lx;
    c.lx[0].unprotected = false;
    const Stored of_protected = store(other, c, here);
    EXPECT_EQ(clause_of(of_protected, 88), "3.12.5"_srs);
    EXPECT_FALSE(of_protected.lost_from) << "a protected one asks for nothing";
  }
  {
    Description d = on_the_way();
    while (!d.suitability.full()) ASSERT_TRUE(d.suitability.push_back({.at = at(100), .kind = Suitability::gauge}));
    Contents c;
    c.suitability.emplace();
    ASSERT_TRUE(c.suitability->elements.push_back({.at = at(3500), .kind = Suitability::traction}));
    ASSERT_TRUE(c.suitability->elements.push_back({.at = at(3000), .kind = Suitability::traction}));
    expect_ended(d, store(d, c, here));
  }
  {
    Description d = on_the_way();
    while (!d.adhesion.full()) ASSERT_TRUE(d.adhesion.push_back({at(-100), at(-90), true}));
    Contents c;
    c.adhesion = AdhesionArea{at(3000), at(3100), true};
    expect_ended(d, store(d, c, here));
  }
  {
    Description d = on_the_way();
    Contents c;
    c.lose(88, at(3000));  // the message itself contained more than fits
    const Stored stored = store(d, c, here);
    EXPECT_EQ(clause_of(stored, 88), "3.7.3.1"_srs);
    expect_ended(d, stored);
  }
}

TEST(Store, WithoutRoomAtTheTrainTheAuthorityEndsAtTheTrain) {
  Description d = on_the_way();
  const Here here = front_at(2000);
  Contents c;
  c.lose(88, at(1990));
  store(d, c, here);
  EXPECT_EQ(d.ma->end(), here.est_front);
  EXPECT_EQ(d.ma->SvL(), here.max_safe_front);
  EXPECT_FALSE(d.ssp.at(here.max_safe_front));
}

TEST(Store, WithoutRoomInTheOverlapTheSvLMoves) {
  Description d;
  Contents c = whole(5000);
  c.ma->overlap = Overlap{};
  c.ma->overlap->start = at(4000);
  c.ma->overlap->end = at(5000);
  c.ma->sections.back().end = at(4500);
  c.lose(88, at(4800));
  store(d, c, front_at(0));
  EXPECT_EQ(d.ma->end(), at(4500));
  EXPECT_EQ(d.ma->SvL(), at(4800));
  Contents further;
  further.lose(88, at(6000));
  store(d, further, front_at(0));
  EXPECT_EQ(d.ma->SvL(), at(4800)) << "beyond the authority nothing is lost";
}

TEST(Store, AProfileWithoutRoomEndsTheAuthority) {
  Description d = on_the_way();
  Contents c;
  c.ssp.emplace();
  for (std::size_t i = 0; i < c.ssp->steps.capacity(); ++i)
    c.ssp->append(at(100.0 + 10.0 * static_cast<double>(i)),
                  StaticSpeed{.V_STATIC = static_cast<SpeedCode>(10 + i % 2)});
  while (d.ssp.steps.size() + 22 < d.ssp.steps.capacity())
    ASSERT_TRUE(d.ssp.steps.insert(0, {at(-3000.0), StaticSpeed{.V_STATIC = 20}}));
  const Stored stored = store(d, c, front_at(0));
  ASSERT_TRUE(stored.lost_from);
  EXPECT_EQ(d.ma->end(), *stored.lost_from);
  EXPECT_TRUE(complete(d, front_at(0)));
}

TEST(Store, WhatDoesNotRestrictIsOnlyTold) {
  Description d = on_the_way();
  fill(d.big_metal, 30);
  fill(d.platforms, 30);
  Contents c;
  c.big_metal = one_behind_the_other<BigMetalMass>(30);
  c.platforms = one_behind_the_other<Platform>(30);
  const Stored stored = store(d, c, front_at(0));
  EXPECT_EQ(clause_of(stored, 67), "3.7.3.1"_srs);
  EXPECT_EQ(clause_of(stored, 69), "3.7.3.1"_srs);
  EXPECT_FALSE(stored.lost_from);
  EXPECT_EQ(d.ma->end(), at(5000));
}

TEST(Store, AnyTrackConditionReplacesTheWholeFamilyFromItsStart) {  // 3.7.3.1 g
  Description d;
  Contents c;
  c.conditions = Fresh<TrackCondition>{at(300), false, {}};
  ASSERT_TRUE(c.conditions->elements.push_back({at(300), at(900), TrackConditionKind::radio_hole}));
  ASSERT_TRUE(c.conditions->elements.push_back({at(800), at(1000), TrackConditionKind::tunnel_stopping_area}));
  store(d, c, front_at(0));
  Contents horn;
  horn.conditions = Fresh<TrackCondition>{at(500), false, {}};
  ASSERT_TRUE(horn.conditions->elements.push_back({at(500), at(510), TrackConditionKind::sound_horn}));
  store(d, horn, front_at(0));
  ASSERT_EQ(d.conditions.size(), 2u);
  EXPECT_EQ(d.conditions[0].to, at(500)) << "what spans the start is cut there";
  EXPECT_EQ(d.conditions[1].kind, TrackConditionKind::sound_horn);
  Contents initial;
  initial.conditions = Fresh<TrackCondition>{at(400), true, {}};
  store(d, initial, front_at(0));
  ASSERT_EQ(d.conditions.size(), 1u);
  EXPECT_EQ(d.conditions[0].to, at(400));
}

TEST(Store, SuitabilityByKind) {  // 3.7.3.1 h-j
  Description d;
  Contents c;
  c.suitability = Fresh<RouteSuitability>{at(100), false, {}};
  RouteSuitability gauge, axle;
  gauge.at = at(100);
  gauge.kind = Suitability::gauge;
  axle.at = at(200);
  axle.kind = Suitability::axle_load;
  ASSERT_TRUE(c.suitability->elements.push_back(gauge) && c.suitability->elements.push_back(axle));
  store(d, c, front_at(0));
  Contents again;
  axle.at = at(900);
  again.suitability = Fresh<RouteSuitability>{at(900), false, {}};
  ASSERT_TRUE(again.suitability->elements.push_back(axle));
  store(d, again, front_at(0));
  ASSERT_EQ(d.suitability.size(), 2u);
  EXPECT_EQ(d.suitability[0].kind, Suitability::gauge);
  EXPECT_EQ(d.suitability[1].at, at(900));
  Contents initial;
  initial.suitability = Fresh<RouteSuitability>{at(500), true, {}};
  store(d, initial, front_at(0));
  EXPECT_EQ(d.suitability.size(), 1u);
}

TEST(Store, EveryOtherKindReplacesFromItsStart) {  // 3.7.3.1 c to f, k, o, p
  Description d;
  const auto message = [](double from, std::uint8_t mark) {
    Contents c;
    c.asp = Fresh<AxleLoadRestriction>{at(from), false, {}};
    c.pbd = Fresh<PermittedBrakingDistance>{at(from), false, {}};
    c.platforms = Fresh<Platform>{at(from), false, {}};
    c.big_metal = Fresh<BigMetalMass>{at(from), false, {}};
    for (const double begin : {from + 10.0, from + 1000.0}) {
      AxleLoadRestriction asp;
      asp.from = at(begin);
      asp.to = at(begin + 100.0);
      EXPECT_TRUE(c.asp->elements.push_back(asp));
      PermittedBrakingDistance pbd;
      pbd.from = at(begin);
      pbd.to = at(begin + 100.0);
      EXPECT_TRUE(c.pbd->elements.push_back(pbd));
      EXPECT_TRUE(c.platforms->elements.push_back({at(begin), at(begin + 100.0), mark, mark}));
      EXPECT_TRUE(c.big_metal->elements.push_back({at(begin), at(begin + 100.0)}));
    }
    c.traction = TractionChange{at(from + 10.0), mark, mark};
    c.current = CurrentChange{at(from + 10.0), std::uint16_t{mark}};
    c.reversing_area = ReversingArea{at(from), at(from + 300.0)};
    c.reversing_supervision = ReversingSupervision{Distance{from}, mark};
    return c;
  };
  store(d, message(0.0, 1), front_at(0));
  store(d, message(500.0, 2), front_at(0));
  const auto begins = [](const auto& areas) {
    std::vector<double> places;
    for (const auto& area : areas) places.push_back(area.from.from_origin.si);
    return places;
  };
  const std::vector<double> replaced{10.0, 510.0,
                                     1500.0};  // that at 1000 m lies beyond the start of the second message
  EXPECT_EQ(begins(d.asp), replaced);
  EXPECT_EQ(begins(d.pbd), replaced);
  EXPECT_EQ(begins(d.platforms), replaced);
  EXPECT_EQ(begins(d.big_metal), replaced);
  EXPECT_EQ(d.traction->at, at(510));
  EXPECT_EQ(d.current->at, at(510));
  EXPECT_EQ(d.reversing_area->from, at(500));
  EXPECT_EQ(d.reversing_supervision->D_REVERSE, Distance{500});
}

TEST(Store, EveryOtherKind) {
  Description d;
  Contents c;
  c.asp = Fresh<AxleLoadRestriction>{at(10), false, {}};
  AxleLoadRestriction asp;
  asp.from = at(10);
  asp.to = at(20);
  ASSERT_TRUE(c.asp->elements.push_back(asp));
  c.pbd = Fresh<PermittedBrakingDistance>{at(10), false, {}};
  PermittedBrakingDistance pbd;
  pbd.from = at(10);
  pbd.to = at(20);
  ASSERT_TRUE(c.pbd->elements.push_back(pbd));
  c.big_metal = Fresh<BigMetalMass>{at(10), false, {}};
  ASSERT_TRUE(c.big_metal->elements.push_back({at(10), at(20)}));
  c.platforms = Fresh<Platform>{at(10), false, {}};
  ASSERT_TRUE(c.platforms->elements.push_back({at(10), at(20), 1, 2}));
  c.traction = TractionChange{at(30), 1, 7};
  c.current = CurrentChange{at(30), std::uint16_t{500}};
  c.adhesion = AdhesionArea{at(40), at(50), true};
  c.rbc_transition = RbcTransition{};
  c.radio_infill = RadioInfillArea{};
  c.reversing_area = ReversingArea{at(60), at(70)};
  c.reversing_supervision = ReversingSupervision{Distance{100}, 8};
  c.sh_list = GroupList{};
  c.stop_shunting_on_desk_opening = true;
  c.generic_ls_marker = true;
  c.geo = InplaceVector<GeoReference, 32>{};
  ASSERT_TRUE(c.geo->push_back(GeoReference{}));
  Text text;
  ASSERT_TRUE(c.texts.push_back(text));
  store(d, c, front_at(0));
  EXPECT_EQ(d.asp.size(), 1u);
  EXPECT_EQ(d.pbd.size(), 1u);
  EXPECT_EQ(d.big_metal.size(), 1u);
  EXPECT_EQ(d.platforms.size(), 1u);
  EXPECT_TRUE(d.traction && d.current && d.rbc_transition && d.radio_infill);
  EXPECT_EQ(d.reversing_reference, at(70));
  EXPECT_TRUE(d.reversing_supervision && d.sh_list);
  EXPECT_TRUE(d.stop_shunting_on_desk_opening && d.generic_ls_marker);
  EXPECT_EQ(d.geo.size(), 1u);
  EXPECT_EQ(d.texts[0].id, 1);
  Contents less;
  less.adhesion = AdhesionArea{at(45), at(50), false};
  less.mode_profile = ModeProfile{};
  ModeArea ls;
  ls.mode = Mode::LS;
  ASSERT_TRUE(less.mode_profile->push_back(ls));
  store(d, less, front_at(0));
  ASSERT_EQ(d.adhesion.size(), 1u);
  EXPECT_EQ(d.adhesion[0].to, at(45)) << "not slippery clears from its start";
  EXPECT_FALSE(d.generic_ls_marker) << "an LS profile without the marker";
}

TEST(Store, LevelCrossings) {
  Description d;
  Contents c;
  LevelCrossing lx;
  lx.NID_LX = 7;
  lx.from = at(500);
  lx.to = at(510);
  lx.unprotected = true;
  ASSERT_TRUE(c.lx.push_back(lx));
  store(d, c, front_at(0));
  substitute_level_crossing(d, 7, at(450));
  store(d, c, front_at(0));
  ASSERT_EQ(d.lx.size(), 1u);
  EXPECT_TRUE(d.lx[0].substituted) << "repeated: the speed goes on";
  EXPECT_FALSE(d.lx[0].informed);
  d.lx[0].informed = true;
  store(d, c, front_at(0));
  EXPECT_TRUE(d.lx[0].informed) << "repeated: the driver was informed (5.16.1.4)";
  c.lx[0].unprotected = false;
  store(d, c, front_at(0));
  EXPECT_FALSE(d.lx[0].unprotected);
  EXPECT_FALSE(d.lx[0].informed) << "a protected one is not shown";
}

TEST(Store, OnlyAnAreaOfLimitedSupervisionEndsTheGenericMarker) {
  const auto marker_after = [](std::optional<Mode> mode) {
    Description d;
    d.generic_ls_marker = true;
    Contents c = whole(1000);
    if (mode) {
      c.mode_profile.emplace();
      ModeArea area;
      area.mode = *mode;
      area.from = at(500);
      EXPECT_TRUE(c.mode_profile->push_back(area));
    }
    EXPECT_TRUE(store(d, c, front_at(0)).ma_accepted);
    Description alone = d;
    alone.generic_ls_marker = true;
    (void)store(alone, static_cast<const AuthorityContents&>(c), front_at(0));
    EXPECT_TRUE(alone.generic_ls_marker) << "an authority alone is of an RBC";
    return d.generic_ls_marker;
  };
  EXPECT_TRUE(marker_after({}));
  EXPECT_TRUE(marker_after(Mode::OS));
  EXPECT_TRUE(marker_after(Mode::SH));
  EXPECT_FALSE(marker_after(Mode::LS));
}

TEST(RelocateData, AnElementWithoutLengthThatDoesNotMoveStays) {  // 3.6.3.2.2 e
  Description d;
  Contents c;
  c.ssp = ssp({{0, 100}, {1000, 40}, {1000, 100}});
  (void)store(d, c, front_at(0));
  ASSERT_EQ(d.ssp.steps.size(), 3u);
  d.ssp.steps[0].anchor = Anchor::unlinked;
  relocate(d, Anchor::unlinked, Anchor::travelled, {Distance{-10}, 20_m, 5_m});
  ASSERT_EQ(d.ssp.steps.size(), 3u);
  EXPECT_EQ(d.ssp.steps[0].from, at(-30)) << "it moves";
  EXPECT_EQ(d.ssp.steps[1].from, at(1000));
  EXPECT_EQ(d.ssp.steps[1].value.V_STATIC, 8) << "40 km/h at this place only";
  EXPECT_EQ(d.ssp.steps[2].from, at(1000));
  EXPECT_EQ(d.ssp.steps[2].value.V_STATIC, 20);
}

TEST(Store, TheSameTextIdentityIsRefusedWhileUnacknowledged) {  // 3.12.3.5.3
  Description d;
  Contents c;
  Text t;
  t.report = true;
  t.NID_TEXTMESSAGE = 4;
  t.Q_TEXTCONFIRM = 1;
  ASSERT_TRUE(c.texts.push_back(t));
  store(d, c, front_at(0));
  EXPECT_EQ(clause_of(store(d, c, front_at(0)), 72), "3.12.3.5.3"_srs);
  EXPECT_EQ(d.texts.size(), 1u);
  Contents plain;
  ASSERT_TRUE(plain.texts.push_back(Text{}));
  for (int i = 0; i < 5; ++i) store(d, plain, front_at(0));
  EXPECT_EQ(clause_of(store(d, plain, front_at(0)), 72), "3.12.3"_srs) << "full";
  d.next_text_id = 255;
  d.texts.clear();
  store(d, plain, front_at(0));
  EXPECT_EQ(d.next_text_id, 1) << "0 means none";
}

}  // namespace
}  // namespace evc::track
