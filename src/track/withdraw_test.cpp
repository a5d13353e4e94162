#include "track/withdraw.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "track/testing.h"

namespace evc::track {
namespace {

using namespace testing;

/// Two sections to 2000 m, the description known to 4000 m, and one element of every kind at 500, 1500 and 3000 m.
Description full() {
  Description d;
  Contents c = whole(2000);
  c.ma->sections.clear();
  for (const double begin : {0.0, 1000.0}) {
    Section s;
    s.begin = at(begin);
    s.end = at(begin + 1000);
    if (!c.ma->sections.push_back(s)) __builtin_trap();
  }
  c.ma->danger_point = DangerPoint{at(2100), {ReleaseSpeedChoice::value, Speed{5}}};
  c.ma->overlap = Overlap{at(1500), at(2200), {Duration{30}, {}, false}, {ReleaseSpeedChoice::national, {}}};
  c.ssp = ssp({{0, 100}, {4000, kEnd}});
  c.gradient = slopes({{0, 0}, {4000, Gradient::kUnknown}});
  c.mode_profile = ModeProfile{};
  c.asp = Fresh<AxleLoadRestriction>{at(0), false, {}};
  c.pbd = Fresh<PermittedBrakingDistance>{at(0), false, {}};
  c.conditions = Fresh<TrackCondition>{at(0), false, {}};
  c.big_metal = Fresh<BigMetalMass>{at(0), false, {}};
  c.platforms = Fresh<Platform>{at(0), false, {}};
  c.suitability = Fresh<RouteSuitability>{at(0), false, {}};
  bool room = true;
  for (const double x : {500.0, 1500.0, 3000.0}) {
    ModeArea area;
    area.from = at(x);
    area.to = at(x + 100);
    room = c.mode_profile->push_back(area) && room;
    AxleLoadRestriction asp;
    asp.from = at(x);
    asp.to = at(x + 1000);
    room = c.asp->elements.push_back(asp) && room;
    PermittedBrakingDistance pbd;
    pbd.from = at(x);
    pbd.to = at(x + 100);
    room = c.pbd->elements.push_back(pbd) && room;
    room = c.conditions->elements.push_back({at(x), at(x + 100), TrackConditionKind::sound_horn}) && room;
    room = c.conditions->elements.push_back({at(x), at(x + 100), TrackConditionKind::radio_hole}) && room;
    room = c.big_metal->elements.push_back({at(x), at(x + 100)}) && room;
    room = c.platforms->elements.push_back({at(x), at(x + 100), 0, 0}) && room;
    RouteSuitability item;
    item.at = at(x);
    room = c.suitability->elements.push_back(item) && room;
  }
  TemporarySpeedRestriction tsr;
  tsr.from = at(3000);
  tsr.to = at(3100);
  room = c.tsr.push_back(tsr) && room;
  LevelCrossing lx;
  lx.from = at(3000);
  lx.to = at(3010);
  room = c.lx.push_back(lx) && room;
  Text text;
  text.start_at = at(3000);
  room = c.texts.push_back(text) && room;
  Text fixed;
  fixed.Q_TEXT = std::uint8_t{0};
  room = c.texts.push_back(fixed) && room;
  c.traction = TractionChange{at(3000), 0, 0};
  c.current = CurrentChange{at(3000), std::nullopt};
  c.rbc_transition = RbcTransition{at(3000), 0, 0, 0, false};
  c.radio_infill = RadioInfillArea{};
  c.radio_infill->at = at(3000);
  c.reversing_area = ReversingArea{at(1000), at(2500)};
  c.reversing_supervision = ReversingSupervision{};
  c.adhesion = AdhesionArea{at(3000), at(3100), true};
  c.sh_list = GroupList{};
  c.default_gradient = -5;
  c.generic_ls_marker = true;
  c.stop_shunting_on_desk_opening = true;
  c.geo = InplaceVector<GeoReference, 32>{};
  room = c.geo->push_back(GeoReference{}) && room;
  const Stored stored = store(d, c, front_at(100));
  if (!room || !stored.ma_accepted) __builtin_trap();
  d.sh_list = GroupList{};
  (void)d.signalling.push_back({at(0), 20, std::nullopt});
  return d;
}

TEST(Shorten, AheadOfThePointEverythingOfTheTrackDescriptionGoes) {
  Description d = full();
  const std::uint32_t revision = d.revision;
  EXPECT_TRUE(shorten(d, Situation::d_overlap_timeout, at(2000), front_at(100)));
  EXPECT_GT(d.revision, revision);
  EXPECT_TRUE(d.ssp.covers(at(0), at(2000)));
  EXPECT_FALSE(d.ssp.at(at(2000)) || d.gradient.at(at(2000)));
  EXPECT_EQ(d.asp.size(), 2u);
  EXPECT_EQ(d.asp[1].to, at(2000));
  EXPECT_EQ(d.pbd.size(), 2u);
  EXPECT_EQ(d.conditions.size(), 4u);
  EXPECT_EQ(d.big_metal.size(), 2u);
  EXPECT_EQ(d.platforms.size(), 2u);
  EXPECT_EQ(d.suitability.size(), 2u);
  EXPECT_EQ(d.mode_profile.size(), 2u);
  EXPECT_FALSE(d.traction || d.current || d.rbc_transition || d.radio_infill || d.sh_list);
  EXPECT_EQ(d.reversing_area->to, at(2000));
  EXPECT_EQ(d.reversing_reference, at(2500)) << "cutting does not move the reference";
  EXPECT_EQ(d.signalling.back().to, at(2000));
  EXPECT_EQ(d.texts.size(), 1u) << "only texts that start beyond";
  EXPECT_EQ(d.tsr.size(), 1u);
  EXPECT_EQ(d.lx.size(), 1u);
  EXPECT_EQ(d.adhesion.size(), 1u);
  EXPECT_TRUE(d.reversing_supervision && d.default_gradient);
  EXPECT_FALSE(shorten(d, Situation::d_overlap_timeout, at(2500), front_at(100))) << "nothing was left there";
}

TEST(Shorten, NoMaRequestAfterSituationsThatTracksideCaused) {  // 3.8.2.7.3
  for (const Situation s : {Situation::a_conditional_emergency_stop, Situation::b_shortened_ma,
                            Situation::f_shortening_granted, Situation::k_desk_closed_during_start}) {
    Description d = full();
    EXPECT_FALSE(shorten(d, s, at(1000), front_at(100)));
  }
}

TEST(Shorten, AtTheTrain) {  // A.3.4 [10], [11]
  for (const Situation s :
       {Situation::e_end_section_timeout, Situation::g_unlinked_group_inconsistent, Situation::h_linking_reaction,
        Situation::i_radio_contact_lost, Situation::j_train_data_changed, Situation::l_rams_supervision,
        Situation::m_linked_group_inconsistent}) {
    Description d = full();
    EXPECT_TRUE(shorten(d, s, at(9999), front_at(1200)));
    EXPECT_EQ(d.ma->end(), at(1200));
    EXPECT_EQ(d.ma->SvL(), at(1205));
    EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::none);
    EXPECT_FALSE(d.ssp.at(at(1205)));
    EXPECT_TRUE(d.ssp.at(at(1204)));
    EXPECT_FALSE(d.sh_list);
    ASSERT_EQ(d.mode_profile.size(), 1u);
  }
  Description d = full();
  EXPECT_TRUE(shorten(d, Situation::h_linking_reaction, at(0), front_at(1200), true));
  EXPECT_TRUE(d.sh_list) << "in SH its list stays";
  // No place beyond the end that was there: the train has passed the EOA, its max safe front end the SvL.
  const Place EOA = full().ma->end(), SvL = *full().ma->SvL();
  d = full();
  EXPECT_TRUE(shorten(d, Situation::h_linking_reaction, at(0), front_at((SvL - at(0)).si + 1.0)));
  EXPECT_EQ(d.ma->end(), EOA);
  EXPECT_EQ(d.ma->SvL(), SvL);
  Description without_ma;
  EXPECT_FALSE(shorten(without_ma, Situation::h_linking_reaction, at(0), front_at(1200)));
}

TEST(Shorten, DeskClosedDuringStart) {
  Description d = full();
  const std::uint32_t revision = d.revision;
  shorten(d, Situation::k_desk_closed_during_start, at(0), front_at(100));
  EXPECT_FALSE(d.ma || !d.signalling.empty() || d.default_gradient);
  EXPECT_TRUE(d.ssp.empty() && d.tsr.empty() && d.lx.empty() && d.texts.empty() && d.adhesion.empty());
  EXPECT_TRUE(d.generic_ls_marker && d.stop_shunting_on_desk_opening);
  EXPECT_EQ(d.geo.size(), 1u);
  EXPECT_GT(d.revision, revision);
}

TEST(ConditionalStop, WhereItLiesDecides) {  // 3.10.2.2
  struct Case {
    const char* name;
    double stop;
    bool loa;
    std::uint8_t answer;
    std::optional<double> EOA, SvL;
    bool release;
  };
  const Case cases[] = {
      {"before the EOA", 1500, false, 0, 1500, 1500, false},      {"at the EOA", 2000, false, 0, 2000, 2000, false},
      {"between EOA and SvL", 2150, false, 1, 2000, 2150, false}, {"beyond the SvL", 2300, false, 1, 2000, 2200, true},
      {"before the LOA", 1500, true, 0, 1500, 1500, false},       {"beyond the LOA", 2300, true, 0, 2000, 2000, false},
  };
  for (const Case& c : cases) {
    Description d = full();
    d.mode_profile.clear();
    if (c.loa) d.ma->V_LOA = Speed{20};
    d.suitability.clear();
    EXPECT_EQ(stop_at(d, at(c.stop), front_at(100)), c.answer) << c.name;
    const Authority a = authority(d, {}, Mode::FS, kInRear);
    EXPECT_EQ(a.EOA, at(*c.EOA)) << c.name;
    EXPECT_EQ(a.SvL, at(*c.SvL)) << c.name;
    EXPECT_FALSE(a.LOA) << c.name;
    EXPECT_EQ(a.release.kind != ReleaseSpeedChoice::none, c.release) << c.name;
    EXPECT_FALSE(d.ssp.at(at(c.stop))) << c.name;
  }
  Description none;
  EXPECT_EQ(stop_at(none, at(10), front_at(0)), 1);
}

Here clock(double front, double now) {
  Here here = front_at(front);
  here.now = Duration{now};
  return here;
}

TEST(Timers, SectionTimeout) {  // 3.8.4.2
  Description d = full();
  for (Section& s : d.ma->sections) {
    s.timed = true;
    s.timer = {Duration{60}, Duration{0}, true};
    s.stop = s.begin + Distance{500};
  }
  EXPECT_FALSE(advance(d, clock(600, 30)).any());
  EXPECT_FALSE(d.ma->sections[0].timer.running) << "the min safe front end passed its stop";
  EXPECT_EQ(time_to_timeout(d, Duration{30}), Duration{30});
  EXPECT_FALSE(advance(d, clock(700, 60)).any()) << "greater than the limit, not equal";
  const Elapsed e = advance(d, clock(700, 60.1));
  EXPECT_TRUE(e.section_timeout && e.track_description_deleted);
  EXPECT_EQ(d.ma->end(), at(1000));
  EXPECT_EQ(d.ma->SvL(), at(1000));
  EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::national);
  EXPECT_FALSE(d.ssp.at(at(1000)));
  EXPECT_FALSE(advance(d, clock(700, 61)).any());
  EXPECT_FALSE(time_to_timeout(d, Duration{61}));
}

TEST(Timers, AStoppedSectionTimerEndsAtStandstillBehindItsStop) {  // 3.8.4.2.4
  Description d = full();
  d.ma->sections[1].timed = true;
  d.ma->sections[1].stop = at(1500);
  Here here = clock(1499, 30);
  here.standstill = true;
  EXPECT_FALSE(advance(d, here).section_timeout) << "it did not run back: another position of the same place";
  here.standstill = false;
  here.ran_back = true;
  here.min_safe_front = at(1500);
  EXPECT_FALSE(advance(d, here).section_timeout);
  here.standstill = true;
  EXPECT_FALSE(advance(d, here).section_timeout) << "not in rear of its stop";
  here.standstill = false;
  here.min_safe_front = at(1499.9);
  EXPECT_FALSE(advance(d, here).section_timeout) << "not at standstill";
  here.min_safe_front = at(1501);
  here.ran_back = false;
  EXPECT_FALSE(advance(d, here).section_timeout);
  here.standstill = true;
  EXPECT_TRUE(advance(d, here).section_timeout) << "it was in rear of it";
  EXPECT_EQ(d.ma->end(), at(1000));
  EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::national);
  EXPECT_FALSE(advance(d, here).section_timeout) << "once";
}

TEST(Timers, ASectionWithoutATimerDoesNotEnd) {
  Description d = full();
  Here here = clock(200, 30);
  here.standstill = here.ran_back = true;
  EXPECT_FALSE(advance(d, here).section_timeout);
}

TEST(Timers, NoSectionEndsAfterTheAuthorityEndedAtTheTrain) {  // 3.8.4.2.2, A.3.4 [11]
  Description d = full();
  d.ma->sections[0].timed = true;
  d.ma->sections[0].timer = {Duration{10}, Duration{0}, true};
  d.ma->sections[0].stop = at(900);
  (void)shorten(d, Situation::h_linking_reaction, {}, clock(300, 5));
  const Place end = d.ma->end();
  EXPECT_FALSE(advance(d, clock(300, 11)).section_timeout);
  EXPECT_EQ(d.ma->end(), end);
}

TEST(Timers, TheFirstSectionEndsBehindTheFront) {
  Description d = full();
  d.ma->sections[0].timed = true;
  d.ma->sections[0].timer = {Duration{10}, Duration{0}, true};
  d.ma->sections[0].stop = at(900);
  EXPECT_TRUE(advance(d, clock(300, 11)).section_timeout);
  EXPECT_EQ(d.ma->end(), at(0));
}

TEST(Timers, AnEndlessSectionTimerNeverEnds) {
  Description d = full();
  d.ma->sections[0].timer = {std::nullopt, Duration{0}, true};
  d.ma->sections[0].stop = at(900);
  EXPECT_FALSE(advance(d, clock(300, 1e6)).any());
}

TEST(Timers, Overlap) {  // 3.8.4.4
  Description d = full();
  EXPECT_EQ(d.ma->SvL(), at(2200));
  EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::national);
  EXPECT_FALSE(advance(d, clock(1494, 0)).any());
  EXPECT_FALSE(d.ma->overlap->timer.running);
  EXPECT_FALSE(advance(d, clock(1496, 1)).any());
  EXPECT_TRUE(d.ma->overlap->timer.running);
  EXPECT_FALSE(advance(d, clock(1500, 31)).any());
  EXPECT_TRUE(advance(d, clock(1500, 31.1)).overlap_timeout);
  EXPECT_EQ(d.ma->SvL(), at(2100)) << "the danger point is next";
  EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::value);
}

TEST(Timers, StandstillEndsTheOverlapAlsoAnEndlessOne) {  // 3.8.4.4.3
  Description d = full();
  d.ma->overlap->timer.limit.reset();
  d.ma->danger_point.reset();
  Here here = clock(1400, 0);
  here.standstill = true;
  EXPECT_FALSE(advance(d, here).any()) << "not before its start";
  here = clock(1600, 1);
  here.standstill = true;
  EXPECT_TRUE(advance(d, here).overlap_timeout);
  EXPECT_EQ(d.ma->SvL(), at(2000));
  EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::none);
}

TEST(Timers, EndSection) {  // 3.8.4.1
  Description d = full();
  d.ma->end_section = EndSectionTimer{at(1000), {Duration{20}, {}, false}};
  EXPECT_FALSE(advance(d, clock(1000, 0)).any());
  EXPECT_TRUE(d.ma->end_section->timer.running);
  const Elapsed e = advance(d, clock(1300, 21));
  EXPECT_TRUE(e.end_section_timeout && e.track_description_deleted);
  EXPECT_EQ(d.ma->end(), at(1300));
  EXPECT_EQ(d.ma->SvL(), at(1305));
  EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::none);
}

TEST(Timers, LoaSpeed) {  // 3.8.4.3
  Description d = full();
  d.mode_profile.clear();
  d.suitability.clear();
  d.ma->V_LOA = Speed{10};
  d.ma->loa_timer = {Duration{40}, Duration{0}, true};
  EXPECT_EQ(time_to_timeout(d, Duration{10}), Duration{30});
  EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::none);
  EXPECT_FALSE(advance(d, clock(300, 40)).any());
  EXPECT_TRUE(advance(d, clock(300, 41)).loa_timeout);
  EXPECT_FALSE(d.ma->limited());
  EXPECT_EQ(d.ma->SvL(), at(2200));
  EXPECT_EQ(d.ma->release().kind, ReleaseSpeedChoice::national) << "that of the overlap";
}

TEST(Passed, IsForgotten300MetresBehind) {  // A.3.6
  Description d = full();
  TemporarySpeedRestriction tsr;
  tsr.from = at(0);
  tsr.to = at(50);
  ASSERT_TRUE(d.tsr.push_back(tsr));
  ASSERT_TRUE(d.ssp.replace_from(ssp({{0, 100}, {40, 80}, {60, 90}})));
  Here here = front_at(600);  // the limit lies at 95 m
  here.min_safe_rear = at(390);
  advance(d, here);
  EXPECT_EQ(d.tsr.size(), 1u);
  EXPECT_EQ(d.ssp.steps.front().from, at(60));
  EXPECT_EQ(d.mode_profile.size(), 3u);
  const std::uint32_t revision = d.revision;
  advance(d, front_at(606));
  EXPECT_EQ(d.mode_profile.size(), 2u) << "the min safe front end passed its end";
  EXPECT_GT(d.revision, revision);
  Here far = front_at(1900);
  advance(d, far);
  EXPECT_EQ(d.ma->sections.size(), 1u);
}

TEST(Passed, AGeographicalReferenceAppliesWhereItWasReached) {  // 3.6.6.4.2
  Description d;
  GeoReference reference;
  reference.M_POSITION = 5000;
  reference.applies_from = at(1000);
  ASSERT_TRUE(d.geo.push_back(reference));
  advance(d, front_at(999));
  EXPECT_FALSE(geographical_position(d, front_at(999)));
  advance(d, front_at(1000));
  EXPECT_EQ(geographical_position(d, front_at(1010)), 5010u);
}

TEST(Forget, EachRow) {  // 4.10.1.3
  using enum evc::Stored;
  const auto gone = [](const Description& d) {
    return std::vector<std::pair<evc::Stored, bool>>{
        {movement_authority, !d.ma},
        {gradient, d.gradient.empty()},
        {ssp, d.ssp.empty()},
        {asp, d.asp.empty()},
        {tsr, d.tsr.empty()},
        {inhibit_revocable_tsr, !d.revocable_tsr_inhibited},
        {default_gradient_tsr, !d.default_gradient},
        {signalling_speed, d.signalling.empty()},
        {route_suitability, d.suitability.empty()},
        {adhesion_trackside, d.adhesion.empty()},
        {plain_text, d.texts.size() == 1 && d.texts[0].Q_TEXT},
        {fixed_text, d.texts.size() == 1 && !d.texts[0].Q_TEXT},
        {geo_position, d.geo.empty()},
        {mode_profile, d.mode_profile.empty()},
        {rbc_transition_order, !d.rbc_transition},
        {radio_infill_area, !d.radio_infill},
        {track_conditions_general,
         d.conditions.size() == 3 && d.conditions[0].kind == TrackConditionKind::sound_horn && !d.traction},
        {track_conditions_horn_stopping,
         d.conditions.size() == 3 && d.conditions[0].kind == TrackConditionKind::radio_hole},
        {track_condition_bmm, d.big_metal.empty()},
        {reversing_area, !d.reversing_area && !d.reversing_reference},
        {reversing_supervision, !d.reversing_supervision},
        {permitted_braking_distance, d.pbd.empty()},
        {level_crossing, d.lx.empty()},
        {stop_sh_on_desk_opening, !d.stop_shunting_on_desk_opening},
        {sh_bg_list, !d.sh_list},
        {sr_bg_list_speed_distance, !d.sr_list},
        {generic_ls_marker, !d.generic_ls_marker},
    };
  };
  std::size_t stored_here = 0;
  for (const auto& row : kStoredRows) {
    Description d = full();
    d.sr_list = GroupList{};
    d.revocable_tsr_inhibited = true;
    const std::uint32_t revision = d.revision;
    const bool forgotten = forget(d, row.value);
    EXPECT_EQ(d.revision != revision, forgotten) << row.name;
    bool listed = false;
    for (const auto& [what, is_gone] : gone(d)) {
      EXPECT_EQ(is_gone, what == row.value) << "forget " << row.name << " touched " << name(what);
      listed = listed || what == row.value;
    }
    EXPECT_EQ(forgotten, listed) << row.name;
    stored_here += forgotten ? 1 : 0;
  }
  EXPECT_EQ(stored_here, 27u);
}

/// 4.10 and 4.12 of the entry of SM: the driver acknowledges a text in the other orientation too.
TEST(Turn, TextsThatAreShownStay) {
  Description d = full();
  d.texts.clear();
  Text shown, waiting;
  shown.state = Text::State::shown;
  shown.id = 7;
  shown.start_at = at(100.0);
  shown.end_at = at(900.0);
  waiting.start_at = at(500.0);
  ASSERT_TRUE(d.texts.push_back(shown));
  ASSERT_TRUE(d.texts.push_back(waiting));
  const std::uint32_t revision = d.revision;
  turn(d);
  ASSERT_EQ(d.texts.size(), 1u);
  EXPECT_EQ(d.texts[0].id, 7);
  EXPECT_EQ(d.texts[0].end_at, at(-900.0));
  EXPECT_NE(d.revision, revision);
  EXPECT_FALSE(d.ma);
}

TEST(Turn, ATextThatWaitsForAModeStays) {
  Description d;
  Text text;
  text.start_mode = Mode::OS;
  ASSERT_TRUE(d.texts.push_back(text));
  turn(d);
  EXPECT_EQ(d.texts.size(), 1u);
}

}  // namespace
}  // namespace evc::track
