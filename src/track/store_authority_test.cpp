#include "track/store.h"

#include <gtest/gtest.h>

#include "track/testing.h"
#include "track/withdraw.h"

namespace evc::track {
namespace {

using namespace testing;

TEST(Store, AnMaWithSspAndGradientIsAccepted) {
  Description d;
  const Stored s = store(d, whole(1000), front_at(100));
  EXPECT_TRUE(s.ma_accepted);
  EXPECT_FALSE(s.shortened);
  ASSERT_TRUE(d.ma);
  EXPECT_EQ(d.ma->end(), at(1000));
  EXPECT_EQ(d.ma->SvL(), at(1000));
  EXPECT_EQ(d.revision, 1u);
  EXPECT_TRUE(complete(d, front_at(100)));
  EXPECT_TRUE(complete(Description{}, front_at(100)));
}

TEST(Store, AnAuthorityIsJudgedBeforeItIsOneOfTheContents) {  // 4.8.3 [4]
  Contents c = whole(2000);
  c.ma.reset();
  EXPECT_TRUE(complete(Description{}, c, authority_to(2000), front_at(100)));
  EXPECT_FALSE(complete(Description{}, c, authority_to(2001), front_at(100)));
  EXPECT_FALSE(complete(Description{}, authority_to(2000), front_at(100))) << "nothing is stored";
  Description d;
  store(d, whole(1000), front_at(100));
  EXPECT_TRUE(complete(d, authority_to(1000), front_at(100)));
  EXPECT_FALSE(complete(d, authority_to(1001), front_at(100)));
}

TEST(Store, AGrantedShorteningIsStoredAsContentsWithNothingElse) {  // 3.8.6
  Contents c;
  c.ma = authority_to(600);
  c.ma_is_shortening_request = true;
  c.mode_profile = ModeProfile{};
  ModeArea ls;
  ls.mode = Mode::LS;
  ls.from = at(500);
  ASSERT_TRUE(c.mode_profile->push_back(ls));
  Description with_all, alone;
  for (Description* d : {&with_all, &alone}) {
    store(*d, whole(1000), front_at(100));
    d->generic_ls_marker = true;
  }
  const Stored a = store(with_all, c, front_at(100));
  const Stored b = store(alone, static_cast<const AuthorityContents&>(c), front_at(100));
  for (const auto& [stored, d] : {std::pair{&a, &with_all}, std::pair{&b, &alone}}) {
    EXPECT_TRUE(stored->ma_accepted && stored->shortened);
    ASSERT_EQ(stored->notes.size(), 3u);
    EXPECT_EQ(stored->notes[0].clause, "3.8.6"_srs);
    EXPECT_EQ(d->ma, c.ma);
    EXPECT_EQ(d->mode_profile, c.mode_profile);
    EXPECT_EQ(d->ssp.steps.back().from, at(600)) << "A.3.4 f";
    EXPECT_EQ(d->generic_ls_marker, d == &alone) << "4.4.19.1.4.8";
    EXPECT_EQ(d->revision, 3u);
  }
}

TEST(Store, AnInfillAuthorityWithoutRoomIsRefused) {  // 3.8.5.1 b
  Description d;
  Contents first = whole(3200);
  first.ma->sections.clear();
  for (int i = 0; i < 32; ++i) {
    Section section;
    section.begin = at(100.0 * i);
    section.end = at(100.0 * i + 100.0);
    ASSERT_TRUE(first.ma->sections.push_back(section));
  }
  ASSERT_TRUE(store(d, first, front_at(50)).ma_accepted);
  Contents c = whole(4000);
  c.infill = at(3150);
  c.ma = authority_to(4000, 3150);
  const Stored refused = store(d, c, front_at(50));
  EXPECT_TRUE(refused.ma_refused && !refused.ma_accepted);
  EXPECT_EQ(refused.notes[0].what, Note::What::refused);
  EXPECT_FALSE(refused.notes[0].clause) << "no room";
  EXPECT_EQ(d.ma, first.ma) << "the old one stays";
  c.infill = at(3050);
  c.ma = authority_to(4000, 3050);
  EXPECT_TRUE(store(d, c, front_at(50)).ma_accepted);
  EXPECT_EQ(d.ma->sections.size(), 32u);
  EXPECT_EQ(d.ma->end(), at(4000));
}

TEST(Store, RefusesWhatIsNotCovered) {  // 3.7.2.3
  struct Case {
    const char* name;
    NewStaticSpeedProfile ssp;
    NewGradientProfile gradient;
    bool accepted;
  };
  const NewStaticSpeedProfile good_ssp = ssp({{0, 100}, {1000, kEnd}});
  const NewGradientProfile good_gradient = slopes({{0, 0}, {1000, Gradient::kUnknown}});
  const Case cases[] = {
      {"both", good_ssp, good_gradient, true},
      {"no SSP", {}, good_gradient, false},
      {"no gradient", good_ssp, {}, false},
      {"SSP one metre short", ssp({{0, 100}, {999, kEnd}}), good_gradient, false},
      {"gradient one metre short", good_ssp, slopes({{0, 0}, {999, Gradient::kUnknown}}), false},
      {"SSP begins ahead of the front", ssp({{101, 100}}), good_gradient, false},
      {"endless values", ssp({{0, 100}}), slopes({{0, 0}}), true},
  };
  for (const Case& c : cases) {
    Description d;
    Contents contents = whole(1000);
    contents.ssp = c.ssp;
    contents.gradient = c.gradient;
    contents.mode_profile = ModeProfile{};
    contents.sh_list = GroupList{};
    ASSERT_TRUE(contents.tsr.push_back(tsr_of(1, 200, 300, 8)));
    const Stored s = store(d, contents, front_at(100));
    EXPECT_EQ(s.ma_accepted, c.accepted) << c.name;
    EXPECT_EQ(s.ma_refused, !c.accepted) << c.name;
    EXPECT_EQ(d.ma.has_value(), c.accepted) << c.name;
    EXPECT_EQ(clause_of(s, 15), c.accepted ? Clause{} : "3.7.2.3"_srs) << c.name;
    EXPECT_EQ(clause_of(s, 80), c.accepted ? Clause{} : "3.7.2.3"_srs) << c.name;
    EXPECT_EQ(clause_of(s, 49), c.accepted ? Clause{} : "3.7.2.3"_srs) << c.name;
    EXPECT_EQ(d.tsr.size(), 1u) << "the other packets are judged on their own: " << c.name;
    EXPECT_EQ(d.ssp.empty(), contents.ssp->empty()) << c.name;
  }
}

TEST(Store, WithoutRoomForItsProfilesAnMaIsRefused) {
  Description d;
  for (int i = 0; i < 95; ++i) ASSERT_TRUE(d.gradient.append(at(-500 + i), Gradient{1}));
  EXPECT_TRUE(store(d, whole(1000), front_at(100)).ma_refused) << "95 and 2 steps";
  Description e;
  for (int i = 0; i < 94; ++i) ASSERT_TRUE(e.gradient.append(at(-500 + i), Gradient{1}));
  EXPECT_TRUE(store(e, whole(1000), front_at(100)).ma_accepted);
}

TEST(Store, ARefusedMaLeavesTheOldOne) {
  Description d;
  store(d, whole(1000), front_at(100));
  Contents c;
  c.ma = authority_to(2000);
  EXPECT_TRUE(store(d, c, front_at(100)).ma_refused);
  EXPECT_EQ(d.ma->end(), at(1000));
  EXPECT_EQ(clause_of(store(d, whole(3000), front_at(100), "3.10.2.4"_srs), 15), "3.10.2.4"_srs);
  EXPECT_EQ(d.ma->end(), at(1000));
  EXPECT_TRUE(d.ssp.covers(at(0), at(3000))) << "only the MA is refused";
}

TEST(Store, AnMaAloneRestsOnWhatIsStored) {  // 3.7.2.1
  Description d;
  store(d, whole(2000), front_at(100));
  Contents c;
  c.ma = authority_to(1500);
  EXPECT_TRUE(store(d, c, front_at(200)).ma_accepted);
}

TEST(Store, AShorteningDeletesBeyondTheNewSvL) {  // 3.8.5.1.3, A.3.4 b
  Description d;
  Contents first = whole(3000);
  ASSERT_TRUE(first.tsr.push_back(tsr_of(3, 2500, 2600, 8)));
  store(d, first, front_at(100));
  Contents c;
  c.ma = authority_to(1500);
  const Stored s = store(d, c, front_at(200));
  EXPECT_TRUE(s.shortened);
  EXPECT_TRUE(d.ssp.covers(at(0), at(1500)));
  EXPECT_FALSE(d.ssp.at(at(1500)));
  EXPECT_FALSE(d.gradient.at(at(1500)));
  EXPECT_EQ(d.tsr.size(), 1u) << "restrictions stay";
  EXPECT_FALSE(store(d, whole(2500), front_at(200)).shortened);
}

TEST(Store, TheEndOfTheInfillAuthorityIsItsOwn) {  // 3.8.5.1 b
  Description d;
  Contents first = whole(3000);
  first.ma = authority_to(2000);
  first.ma->V_LOA = Speed{20};
  first.ma->loa_timer = {Duration{60}, Duration{}, true};
  first.ma->end_section = EndSectionTimer{at(1900), {Duration{30}, {}, false}};
  first.ma->danger_point = DangerPoint{at(2050), {ReleaseSpeedChoice::value, Speed{5}}};
  ASSERT_TRUE(store(d, first, front_at(100)).ma_accepted);
  Contents c;
  c.infill = at(1500);
  c.ma = authority_to(2500, 1500);
  c.ma->level_1 = true;
  c.ma->anchor = Anchor::unlinked;
  c.ma->overlap = Overlap{at(2400), at(2600), {Duration{20}, {}, false}, {ReleaseSpeedChoice::national, {}}};
  ASSERT_TRUE(store(d, c, front_at(100)).ma_accepted);
  MovementAuthority expected = *c.ma;
  expected.sections.clear();
  ASSERT_TRUE(expected.sections.push_back({at(0), at(1500), false, {}, {}}));
  ASSERT_TRUE(expected.sections.push_back({at(1500), at(2500), false, {}, {}}));
  EXPECT_EQ(d.ma, expected) << "no LOA, end section or danger point of the old one";
  EXPECT_EQ(d.ma->SvL(), at(2600));
}

TEST(Store, AMessageWithoutPacket12SaysNothingOfTheSignallingSpeed) {  // 3.11.6.3: until a new one
  for (const SpeedCode V_MAIN : {SpeedCode{0}, SpeedCode{12}}) {
    Description d;
    (void)d.signalling.push_back({at(0), 20, std::nullopt});
    Contents c;
    c.V_MAIN = V_MAIN;
    c.V_MAIN.reset();
    EXPECT_FALSE(store(d, c, front_at(100)).trip_order);
    ASSERT_EQ(d.signalling.size(), 1u);
    EXPECT_EQ(d.signalling[0].V_MAIN, 20);
  }
}

TEST(Store, AnSvLWhereAnLoaWasIsAShorteningWhereverItLies) {  // 3.8.5.1.4
  Description d;
  Contents c = whole(2000);
  c.ma->V_LOA = Speed{20};
  store(d, c, front_at(100));
  EXPECT_FALSE(d.ma->SvL());
  EXPECT_EQ(authority(d, {}, Mode::FS, kInRear).LOA, at(2000));
  EXPECT_TRUE(store(d, whole(2500), front_at(100)).shortened);
  EXPECT_TRUE(d.ssp.covers(at(0), at(2500))) << "the new packets follow the deletion";
  c.ma->sections[0].end = at(500);
  EXPECT_FALSE(store(d, c, front_at(100)).shortened) << "a new LOA never is one";
}

TEST(Store, GrantedShorteningRequest) {
  Description d;
  store(d, whole(3000), front_at(100));
  Contents c;
  c.ma = authority_to(1000);
  c.ma_is_shortening_request = true;
  const Stored s = store(d, c, front_at(100));
  EXPECT_TRUE(s.shortened);
  EXPECT_EQ(clause_of(s, 15), "3.8.6"_srs);
}

TEST(Store, InfillReplacesBeyondItsGroup) {  // 3.8.5.1 b
  Description d;
  Contents first = whole(2000);
  ModeArea near, far;
  near.from = at(500);
  far.from = at(1800);
  first.mode_profile = ModeProfile{};
  ASSERT_TRUE(first.mode_profile->push_back(near) && first.mode_profile->push_back(far));
  store(d, first, front_at(100));
  Contents c;
  c.infill = at(1500);
  c.ma = authority_to(3000, 1500);
  c.ma->level_1 = true;
  c.V_MAIN = 20;
  c.ssp = ssp({{1500, 80}, {3000, kEnd}});
  c.gradient = slopes({{1500, 0}, {3000, Gradient::kUnknown}});
  EXPECT_TRUE(complete(d, c, *c.ma, front_at(100)));
  EXPECT_TRUE(store(d, c, front_at(100)).ma_accepted);
  ASSERT_EQ(d.ma->sections.size(), 2u);
  EXPECT_EQ(d.ma->sections[0].end, at(1500)) << "the section running there is cut";
  EXPECT_EQ(d.ma->end(), at(3000));
  ASSERT_EQ(d.mode_profile.size(), 1u);
  EXPECT_EQ(d.mode_profile[0].from, at(500));
  EXPECT_EQ(d.signalling.back().from, at(1500));
  c.V_MAIN = 0;
  EXPECT_FALSE(store(d, c, front_at(100)).trip_order) << "3.11.6.5: no trip order from infill";
}

TEST(Store, InfillEndsTheAreaAcrossItsReference) {  // 3.12.4.3.1 a
  Description d;
  Contents first = whole(2000);
  ModeArea across;
  across.from = at(500);
  first.mode_profile = ModeProfile{};
  ASSERT_TRUE(first.mode_profile->push_back(across));
  store(d, first, front_at(100));
  Contents c = whole(3000);
  c.infill = at(1500);
  c.ma = authority_to(3000, 1500);
  EXPECT_TRUE(store(d, c, front_at(100)).ma_accepted);
  ASSERT_EQ(d.mode_profile.size(), 1u);
  EXPECT_EQ(d.mode_profile[0].to, at(1500));
}

TEST(Store, InfillBeyondAShuntingAreaBringsNoProfile) {  // 3.12.4.3.1 b, c
  for (const double SH_from : {500.0, 1500.0}) {
    Description d;
    Contents first = whole(2000);
    ModeArea shunting;
    shunting.mode = Mode::SH;
    shunting.from = at(SH_from);
    first.mode_profile = ModeProfile{};
    ASSERT_TRUE(first.mode_profile->push_back(shunting));
    first.sh_list.emplace();
    store(d, first, front_at(100));
    Contents c = whole(3000);
    c.infill = at(1500);
    c.ma = authority_to(3000, 1500);
    ModeArea area;
    area.from = at(2000);
    c.mode_profile = ModeProfile{};
    ASSERT_TRUE(c.mode_profile->push_back(area));
    const Stored stored = store(d, c, front_at(100));
    EXPECT_TRUE(stored.ma_accepted);
    EXPECT_EQ(clause_of(stored, 80), SH_from < 1500.0 ? "3.12.4.3.1"_srs : Clause{});
    ASSERT_EQ(d.mode_profile.size(), 1u);
    EXPECT_EQ(d.mode_profile[0].mode, SH_from < 1500.0 ? Mode::SH : Mode::OS);
    EXPECT_EQ(d.sh_list.has_value(), SH_from < 1500.0);
    c.mode_profile.reset();
    for (const Note& note : store(d, c, front_at(100)).notes) EXPECT_NE(note.packet, 80) << "it brings none";
  }
}

TEST(Store, InfillSpeedCountsFromItsReference) {  // 3.11.6.2, 3.8.5.1 b
  Description d;
  Contents c = whole(3000);
  c.ma->level_1 = true;
  c.V_MAIN = 12;
  store(d, c, front_at(100));
  const auto infill = [&](double place, SpeedCode V_MAIN) {
    Contents next = whole(3000);
    next.ma->level_1 = true;
    next.infill = at(place);
    next.V_MAIN = V_MAIN;
    return store(d, next, front_at(100));
  };
  infill(2000, 24);
  infill(1500, 16);  // replaces what lies beyond
  ASSERT_EQ(d.signalling.size(), 2u);
  EXPECT_EQ(d.signalling[0].to, at(1500));
  EXPECT_EQ(d.signalling[1].from, at(1500));
  EXPECT_EQ(d.signalling[1].V_MAIN, 16);
  EXPECT_FALSE(d.signalling[1].to);
  infill(1600, 20);
  infill(1700, 18);
  ASSERT_EQ(d.signalling.size(), 4u);
  EXPECT_FALSE(infill(1600, 22).lost_from) << "takes the place of two";
  EXPECT_EQ(d.signalling.size(), 3u);
  infill(1700, 18);
  const Stored no_room = infill(1800, 18);
  EXPECT_EQ(no_room.lost_from, at(1800)) << "data are missing from there on (3.7.2.3)";
  EXPECT_EQ(clause_of(no_room, 12), "3.11.6.2"_srs);
  EXPECT_EQ(d.signalling.back().to, at(1800));
  c.V_MAIN = 6;
  store(d, c, front_at(100));
  ASSERT_EQ(d.signalling.size(), 1u) << "3.11.6.3: until a new one";
  EXPECT_FALSE(d.signalling[0].to);
}

TEST(Store, PassedSignallingSpeedsAreForgotten) {
  Description d;
  (void)d.signalling.push_back({at(0), 12, at(1000)});
  (void)d.signalling.push_back({at(1000), 16, std::nullopt});
  (void)advance(d, front_at(1400));
  EXPECT_EQ(d.signalling.size(), 2u) << "the train is still on it, or within 300 m of it";
  (void)advance(d, front_at(2400));
  ASSERT_EQ(d.signalling.size(), 1u);
  EXPECT_EQ(d.signalling[0].V_MAIN, 16);
}

TEST(Store, InfillWithoutAnMaIsRefused) {
  Description d;
  Contents c = whole(3000);
  c.infill = at(1500);
  EXPECT_EQ(clause_of(store(d, c, front_at(1600)), 15), "3.8.5.1"_srs);
  EXPECT_FALSE(d.ma);
}

TEST(Store, SignallingSpeed) {  // 3.11.6
  Description d;
  Contents c = whole(1000);
  c.ma->level_1 = true;
  c.V_MAIN = 8;
  EXPECT_FALSE(store(d, c, front_at(100)).trip_order);
  EXPECT_EQ(d.signalling.back().V_MAIN, 8);
  c.V_MAIN = 0;
  EXPECT_TRUE(store(d, c, front_at(100)).trip_order);
  EXPECT_EQ(d.signalling.back().V_MAIN, 8) << "a trip order is not stored";
  store(d, whole(1500), front_at(100));
  EXPECT_TRUE(d.signalling.empty()) << "an MA of level 2 ends it";
}

TEST(Store, Repositioning) {  // 3.8.5.2
  Description d;
  Contents c = whole(3000);
  c.ma->sections.clear();
  for (const double end : {1000.0, 2000.0}) {
    Section s;
    s.begin = at(end - 1000);
    s.end = at(end);
    s.stop = at(end - 10);
    ASSERT_TRUE(c.ma->sections.push_back(s));
  }
  c.ma->danger_point = DangerPoint{at(2100), {}};
  c.ma->overlap = Overlap{at(1900), at(2200), {}, {}};
  c.ma->end_section = EndSectionTimer{at(1800), {}};
  store(d, c, front_at(100));
  Contents r;
  r.repositioned_section = Distance{850};
  r.reference = at(200);
  store(d, r, front_at(210));
  EXPECT_EQ(d.ma->sections[0].end, at(1050));
  EXPECT_EQ(d.ma->sections[1].begin, at(1050));
  EXPECT_EQ(d.ma->sections[1].stop, at(2040));
  EXPECT_EQ(d.ma->end(), at(2050));
  EXPECT_EQ(d.ma->danger_point->at, at(2150));
  EXPECT_EQ(d.ma->overlap->end, at(2250));
  EXPECT_EQ(d.ma->overlap->start, at(1950));
  EXPECT_EQ(d.ma->end_section->start, at(1850));
  Description none;
  store(none, r, front_at(210));
  EXPECT_FALSE(none.ma);
}

TEST(Store, TimersOfAReplacedMa) {  // 3.8.4.1.3-4, 3.8.4.4.4-5
  Description d;
  Contents c = whole(3000);
  c.ma->overlap = Overlap{at(50), at(3100), {Duration{30}, {}, false}, {}};
  c.ssp = ssp({{0, 100}});
  c.gradient = slopes({{0, 0}});
  // 3.8.4.4.4: its start is behind and no timer ran. What it takes with it is deleted as when it runs out (A.3.4 d).
  store(d, c, front_at(100));
  const Elapsed at_once = advance(d, front_at(100));
  EXPECT_TRUE(at_once.overlap_timeout);
  EXPECT_TRUE(at_once.track_description_deleted);
  EXPECT_FALSE(d.ma->overlap);
  EXPECT_EQ(d.ma->SvL(), at(3000));
  EXPECT_FALSE(d.ssp.covers(at(100), at(3050)));
  c.ma->overlap->timer.limit.reset();
  store(d, c, front_at(100));
  EXPECT_TRUE(advance(d, front_at(100)).overlap_timeout) << "an infinite one too";
  c.ma->overlap->timer.limit = Duration{30};
  c.ma->overlap->start = at(150);
  store(d, c, front_at(100));
  Here here = front_at(160);
  here.now = Duration{10};
  advance(d, here);
  EXPECT_TRUE(d.ma->overlap->timer.running);
  here.now = Duration{30};
  store(d, c, here);
  ASSERT_TRUE(d.ma->overlap);
  EXPECT_EQ(d.ma->overlap->timer.started, Duration{10}) << "the running timer goes on";
  c.ma->overlap->timer.limit = Duration{15};
  store(d, c, here);
  EXPECT_TRUE(advance(d, here).overlap_timeout) << "under the new limit it is over";
  EXPECT_FALSE(d.ma->overlap);
  c.ma->overlap.reset();
  c.ma->end_section = EndSectionTimer{at(50), {Duration{30}, {}, false}};
  store(d, c, front_at(400));
  const Elapsed end_section = advance(d, front_at(400));
  EXPECT_TRUE(end_section.end_section_timeout);
  EXPECT_TRUE(end_section.track_description_deleted);
  EXPECT_FALSE(d.ssp.covers(at(405), at(410))) << "A.3.4 e";
  EXPECT_EQ(d.ma->end(), at(400));
  EXPECT_EQ(d.ma->SvL(), at(405));
  EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::none);
}

TEST(Store, AnAcceptedAreaStaysAcceptedInTheNextMa) {  // 5.9.2.7
  Description d;
  Contents c = whole(2000);
  ModeArea os;
  os.from = at(300);
  os.to = at(900);
  os.ack_from = at(150);
  c.mode_profile = ModeProfile{};
  ASSERT_TRUE(c.mode_profile->push_back(os));
  store(d, c, front_at(100));
  accept_area(d, Mode::OS, front_at(200));
  store(d, c, front_at(210));
  EXPECT_TRUE(d.mode_profile[0].accepted);
}

TEST(Store, AProfileThatIsJudgedBeforeItIsStoredIsAcceptedAsTheStoredOne) {  // 5.9.2.7
  Description d;
  ModeArea os;
  os.from = at(0);
  os.accepted = true;
  ASSERT_TRUE(d.mode_profile.push_back(os));
  ModeProfile fresh;
  ModeArea ahead = os, other = os;
  os.accepted = false;
  ahead.from = ahead.ack_from = at(500);
  other.mode = Mode::LS;
  ASSERT_TRUE(fresh.push_back(os) && fresh.push_back(ahead) && fresh.push_back(other));
  carry_acceptance(fresh, d, front_at(100));
  EXPECT_TRUE(fresh[0].accepted);
  EXPECT_FALSE(fresh[1].accepted) << "the train is not in it";
  EXPECT_FALSE(fresh[2].accepted) << "another mode";
}

// A.3.5.1: an area that was entered stays so ahead of its begin; one of its mode that begins farther on is another one.
TEST(Store, AnAreaThatWasEnteredIsRepeatedAsEntered) {
  for (const double from : {190.0, 200.0, 200.5, 600.0}) {
    Description d;
    ModeArea entered;
    entered.mode = Mode::OS;
    entered.from = entered.ack_from = at(200);
    entered.accepted = true;
    ASSERT_TRUE(d.mode_profile.push_back(entered));
    ModeArea repeated;
    repeated.mode = Mode::OS;
    repeated.from = at(from);
    repeated.ack_from = at(from - 50);
    ModeProfile fresh;
    ASSERT_TRUE(fresh.push_back(repeated));
    carry_acceptance(fresh, d, front_at(100));
    EXPECT_EQ(fresh[0].accepted, from <= 200.0) << from;
    EXPECT_EQ(fresh[0].ack_from, from <= 200.0 ? at(from) : at(from - 50)) << from;
  }
}

TEST(Store, AheadOfAnAreaItsAcceptanceEndsWithItsMode) {
  const Here here = front_at(100);
  for (const Mode mode : {Mode::OS, Mode::LS, Mode::FS})
    for (const double beyond : {-1.0, 0.0, 1.0}) {
      ModeArea area;
      area.mode = Mode::OS;
      area.from = here.max_safe_front + Distance{beyond};
      area.accepted = true;
      ModeProfile profile;
      ASSERT_TRUE(profile.push_back(area));
      const bool kept = mode == Mode::OS || beyond <= 0.0;
      EXPECT_EQ(forget_acceptance_ahead(profile, mode, here), !kept) << beyond;
      EXPECT_EQ(profile[0].accepted, kept) << beyond;
      EXPECT_FALSE(forget_acceptance_ahead(profile, mode, here)) << "once";
      // The curves are computed anew for it.
      Description d;
      ASSERT_TRUE(d.mode_profile.push_back(area));
      const auto revision = d.revision;
      forget_acceptance_ahead(d, mode, here);
      EXPECT_EQ(d.revision, kept ? revision : revision + 1) << beyond;
    }
}

TEST(Store, ShuntingAreaBringsItsList) {
  Description d;
  Contents c = whole(2000);
  ModeArea sh;
  sh.from = at(300);
  sh.mode = Mode::SH;
  c.mode_profile = ModeProfile{};
  ASSERT_TRUE(c.mode_profile->push_back(sh));
  c.sh_list = GroupList{};
  ASSERT_TRUE(c.sh_list->push_back({1, 2}));
  store(d, c, front_at(100));
  ASSERT_TRUE(d.sh_list);
  c.sh_list.reset();
  store(d, c, front_at(100));
  EXPECT_FALSE(d.sh_list) << "3.12.4.4";
}

}  // namespace
}  // namespace evc::track
