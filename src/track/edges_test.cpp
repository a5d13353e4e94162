#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "track/store.h"
#include "track/testing.h"
#include "track/withdraw.h"

// What a message reports and what it changes, packet by packet; places and times exactly on a border.
namespace evc::track {
namespace {

using namespace testing;

/// One kind of information: how a message brings it, the packet that its note names, and whether the speed and distance
/// monitoring has to know (3.13.2: what it supervises, and what its inputs are made of).
struct Brought {
  const char* what;
  std::function<void(Contents&)> bring;
  std::uint8_t packet;
  bool supervised;
};

template <class T>
Fresh<T> one(T element) {
  Fresh<T> fresh;
  fresh.from = element.from;
  EXPECT_TRUE(fresh.elements.push_back(element));
  return fresh;
}

std::vector<Brought> all_brought() {
  return {
      {"MA", [](Contents& c) { c = whole(900); }, 15, true},
      {"signalling speed", [](Contents& c) { c.V_MAIN = SpeedCode{10}; }, 0, true},
      {"gradient",
       [](Contents& c) {
         c.gradient = slopes({{0, 1}});
       },
       21, true},
      {"static speed profile",
       [](Contents& c) {
         c.ssp = ssp({{0, 100}});
       },
       27, true},
      {"axle load",
       [](Contents& c) {
         c.asp = one(AxleLoadRestriction{at(1), at(2)});
       },
       51, true},
      {"permitted braking distance",
       [](Contents& c) {
         c.pbd = one(PermittedBrakingDistance{at(1), at(2)});
       },
       52, true},
      {"restriction", [](Contents& c) { EXPECT_TRUE(c.tsr.push_back({})); }, 65, true},
      {"revocation", [](Contents& c) { EXPECT_TRUE(c.revoked_tsr.push_back(3)); }, 66, true},
      {"inhibition", [](Contents& c) { c.inhibit_revocable_tsr = true; }, 64, false},
      {"default gradient", [](Contents& c) { c.default_gradient = std::int16_t{4}; }, 141, true},
      {"level crossing", [](Contents& c) { EXPECT_TRUE(c.lx.push_back({})); }, 88, true},
      {"track condition",
       [](Contents& c) {
         c.conditions = one(TrackCondition{at(1), at(2)});
       },
       68, true},
      {"big metal mass",
       [](Contents& c) {
         c.big_metal = one(BigMetalMass{at(1), at(2)});
       },
       67, false},
      {"platform",
       [](Contents& c) {
         c.platforms = one(Platform{at(1), at(2)});
       },
       69, false},
      {"traction", [](Contents& c) { c.traction = TractionChange{}; }, 39, true},
      {"current", [](Contents& c) { c.current = CurrentChange{}; }, 40, false},
      {"route suitability",
       [](Contents& c) {
         c.suitability.emplace();
         EXPECT_TRUE(c.suitability->elements.push_back({}));
       },
       70, true},
      {"route suitability, initial state",
       [](Contents& c) {
         c.suitability.emplace();
         c.suitability->initial_state = true;
       },
       70, true},
      {"adhesion",
       [](Contents& c) {
         c.adhesion = AdhesionArea{at(1), at(2), true};
       },
       71, true},
      {"plain text", [](Contents& c) { EXPECT_TRUE(c.texts.push_back({})); }, 72, false},
      {"fixed text",
       [](Contents& c) {
         EXPECT_TRUE(c.texts.push_back({}));
         c.texts[0].Q_TEXT = std::uint8_t{1};
       },
       76, false},
      {"RBC transition", [](Contents& c) { c.rbc_transition = RbcTransition{}; }, 131, false},
      {"radio infill", [](Contents& c) { c.radio_infill = RadioInfillArea{}; }, 133, false},
      {"reversing area", [](Contents& c) { c.reversing_area = ReversingArea{}; }, 138, true},
      {"reversing supervision", [](Contents& c) { c.reversing_supervision = ReversingSupervision{}; }, 139, true},
      {"geographical position", [](Contents& c) { c.geo.emplace(); }, 79, false},
      {"generic LS marker", [](Contents& c) { c.generic_ls_marker = true; }, 0, false},
      {"mode profile", [](Contents& c) { c.mode_profile.emplace(); }, 0, true},
      {"repositioning", [](Contents& c) { c.repositioned_section = Distance{100}; }, 0, true},
  };
}

TEST(Store, Each_packet_is_noted_and_the_monitoring_is_told_of_what_it_supervises) {
  for (const Brought& kind : all_brought()) {
    Description d;
    Contents c;
    kind.bring(c);
    const Stored report = store(d, c, front_at(0));
    int noted = 0;
    for (const Note& note : report.notes) {
      if (note.packet != kind.packet) continue;
      ++noted;
      EXPECT_EQ(note.what, Note::What::stored) << kind.what;
      EXPECT_FALSE(note.clause) << kind.what;
    }
    EXPECT_EQ(noted, kind.packet != 0 ? 1 : 0) << kind.what;
    EXPECT_EQ(report.notes.size(), std::size_t(kind.packet == 15 ? 3 : noted)) << kind.what;
    EXPECT_EQ(d.revision != 0, kind.supervised) << kind.what;
  }
}

TEST(Store, Nothing_is_set_in_a_new_description) {
  const Description d;
  EXPECT_FALSE(d.stop_shunting_on_desk_opening || d.generic_ls_marker || d.revocable_tsr_inhibited);
  EXPECT_FALSE(d.watch.shown || d.watch.stopping);
  const Contents c;
  EXPECT_EQ(c.medium, Medium::balise);
  EXPECT_FALSE(c.stop_shunting_on_desk_opening || c.generic_ls_marker);
  EXPECT_EQ(Note{}.packet, 0);
  Description after;
  store(after, c, front_at(0));
  EXPECT_FALSE(after.stop_shunting_on_desk_opening || after.generic_ls_marker);
  EXPECT_EQ(after.revision, 0u);
}

TEST(Store, What_restricts_and_finds_no_room_ends_the_authority_and_the_rest_does_not) {  // 3.7.2.3
  const auto full = [](auto Description::*list, auto Contents::*fresh) {
    Description d;
    store(d, whole(5000), front_at(0));
    auto element = (d.*list)[(d.*list).push_back({}) ? 0 : 0];
    element.from = at(0);
    element.to = at(1);
    (d.*list)[0] = element;
    while ((d.*list).push_back(element)) continue;
    Contents c;
    element.from = at(2000);
    element.to = at(2100);
    c.*fresh = one(element);
    const Stored report = store(d, c, front_at(0));
    EXPECT_EQ(report.lost_from.has_value(), d.ma->end() == at(2000));
    EXPECT_EQ(report.notes.back().what, Note::What::full);
    return report.lost_from.has_value();
  };
  EXPECT_TRUE(full(&Description::asp, &Contents::asp));
  EXPECT_TRUE(full(&Description::pbd, &Contents::pbd));
  EXPECT_TRUE(full(&Description::conditions, &Contents::conditions));
  EXPECT_FALSE(full(&Description::big_metal, &Contents::big_metal));
  EXPECT_FALSE(full(&Description::platforms, &Contents::platforms));
}

TEST(Store, Route_suitability_without_room_ends_the_authority_at_the_nearest_point) {
  Description d;
  store(d, whole(5000), front_at(0));
  RouteSuitability item;
  item.kind = Suitability::axle_load;
  while (d.suitability.push_back(item)) continue;
  Contents c;
  c.suitability.emplace();
  item.kind = Suitability::gauge;
  for (const double place : {2000.0, 1000.0, 3000.0}) {
    item.at = at(place);
    ASSERT_TRUE(c.suitability->elements.push_back(item));
  }
  const Stored report = store(d, c, front_at(0));
  EXPECT_EQ(report.lost_from, at(1000));
  EXPECT_EQ(report.notes.back().packet, 70);
  EXPECT_EQ(d.ma->end(), at(1000));
}

TEST(Store, While_revocable_restrictions_are_inhibited_those_of_balises_with_an_identity_are_refused) {  // 3.11.5.12
  for (const std::uint8_t id : {std::uint8_t{7}, std::uint8_t{255}})
    for (const bool from_rbc : {false, true}) {
      Description d;
      d.revocable_tsr_inhibited = true;
      Contents c;
      TemporarySpeedRestriction tsr;
      tsr.NID_TSR = id;
      tsr.from_rbc = from_rbc;
      ASSERT_TRUE(c.tsr.push_back(tsr));
      store(d, c, front_at(0));
      EXPECT_EQ(d.tsr.size(), id == 7 && !from_rbc ? 0u : 1u);
    }
}

TEST(Store, Areas_from_the_new_start_on_are_replaced) {  // 3.7.3.1 c
  Description d;
  Contents c;
  c.big_metal.emplace();
  for (const double from : {0.0, 100.0, 200.0})
    ASSERT_TRUE(c.big_metal->elements.push_back({at(from), at(from + 100)}));
  store(d, c, front_at(0));
  ASSERT_EQ(d.big_metal.size(), 3u);
  Contents again;
  again.big_metal = one(BigMetalMass{at(100), at(300)});
  store(d, again, front_at(0));
  ASSERT_EQ(d.big_metal.size(), 2u);
  EXPECT_EQ(d.big_metal[0], (BigMetalMass{at(0), at(100)}));
  EXPECT_EQ(d.big_metal[1], (BigMetalMass{at(100), at(300)}));
  // The return of route suitability to its initial state counts from its place on.
  Contents route;
  route.suitability.emplace();
  for (const double from : {100.0, 200.0}) {
    RouteSuitability item;
    item.at = at(from);
    ASSERT_TRUE(route.suitability->elements.push_back(item));
  }
  store(d, route, front_at(0));
  Contents initial;
  initial.suitability.emplace();
  initial.suitability->initial_state = true;
  initial.suitability->from = at(200);
  store(d, initial, front_at(0));
  EXPECT_EQ(d.suitability.size(), 1u);
}

TEST(Store, A_level_crossing_that_is_repeated_keeps_its_speed_only_if_it_is_the_same_and_still_unprotected) {
  const auto stored_again = [](std::uint8_t id, bool unprotected, bool substituted) {
    Description d;
    LevelCrossing lx;
    lx.NID_LX = 1;
    lx.unprotected = true;
    Contents c;
    EXPECT_TRUE(c.lx.push_back(lx));
    store(d, c, front_at(0));
    const std::uint32_t before = d.revision;
    if (substituted) substitute_level_crossing(d, 1, at(50));
    EXPECT_EQ(d.revision, before + (substituted ? 1 : 0));
    c.lx[0].NID_LX = id;
    c.lx[0].unprotected = unprotected;
    store(d, c, front_at(0));
    return d.lx.back();
  };
  EXPECT_TRUE(stored_again(1, true, true).substituted);
  EXPECT_EQ(stored_again(1, true, true).V_LX_from, at(50));
  EXPECT_FALSE(stored_again(1, true, false).substituted);
  EXPECT_FALSE(stored_again(1, false, true).substituted);
  EXPECT_FALSE(stored_again(2, true, true).substituted);
}

TEST(Store, Texts_are_numbered_and_a_report_is_asked_for_once) {  // 3.12.3.5.3
  Description d;
  Contents c;
  Text text;
  text.report = true;
  text.NID_TEXTMESSAGE = 5;
  ASSERT_TRUE(c.texts.push_back(text));
  text.NID_TEXTMESSAGE = 6;
  ASSERT_TRUE(c.texts.push_back(text));
  store(d, c, front_at(0));
  ASSERT_EQ(d.texts.size(), 2u);
  EXPECT_EQ(d.texts[0].id, 1);
  EXPECT_EQ(d.texts[1].id, 2);
  Contents more;
  text.report = false;
  ASSERT_TRUE(more.texts.push_back(text));
  text.report = true;
  ASSERT_TRUE(more.texts.push_back(text));
  store(d, more, front_at(0));
  EXPECT_EQ(d.texts.size(), 3u);
  d.texts[1].acknowledged = true;
  Contents late;
  ASSERT_TRUE(late.texts.push_back(text));
  store(d, late, front_at(0));
  EXPECT_EQ(d.texts.size(), 4u);
  // A stored text without report does not make one with it a repetition.
  Description other;
  text.report = false;
  text.NID_TEXTMESSAGE = 5;
  Contents plain;
  ASSERT_TRUE(plain.texts.push_back(text));
  store(other, plain, front_at(0));
  plain.texts[0].report = true;
  store(other, plain, front_at(0));
  EXPECT_EQ(other.texts.size(), 2u);
}

TEST(Store, Lists_for_SH_come_with_an_MA_by_its_own_way_and_geographical_references_go_on) {
  Description d;
  Contents list;
  list.sh_list.emplace();
  store(d, list, front_at(0));
  EXPECT_TRUE(d.sh_list.has_value());
  // 3.6.6.3: what applies already goes on, what does not apply yet is replaced.
  for (const std::optional<Place> applies : {std::optional<Place>{}, std::optional{at(0)}, std::optional{at(0.1)}}) {
    GeoReference reference;
    reference.applies_from = applies;
    reference.applicable = applies && *applies <= at(0);
    ASSERT_TRUE(d.geo.push_back(reference));
  }
  Contents c;
  c.geo.emplace();
  ASSERT_TRUE(c.geo->push_back({}));
  store(d, c, front_at(0));
  ASSERT_EQ(d.geo.size(), 2u);
  EXPECT_EQ(d.geo[0].applies_from, at(0));
  // More than there is room for is noted.
  while (d.geo.push_back(d.geo[0])) continue;
  ASSERT_TRUE(c.geo->push_back({}));
  EXPECT_EQ(store(d, c, front_at(0)).notes.back().what, Note::What::full);
}

TEST(Store, Two_restrictions_in_one_are_as_wide_and_as_slow_as_both) {
  TemporarySpeedRestriction a, b;
  a.from = at(10);
  a.to = at(20);
  a.V_TSR = 8;
  a.NID_TSR = 3;
  b.from = at(5);
  b.to = at(15);
  b.V_TSR = 6;
  for (const auto& [kept, more] : {std::pair{a, b}, std::pair{b, a}})
    for (const bool one_has : {false, true})
      for (const bool other_has : {false, true}) {
        TemporarySpeedRestriction both = kept, second = more;
        both.Q_FRONT = one_has;
        second.Q_FRONT = other_has;
        cover(both, second);
        EXPECT_EQ(both.Q_FRONT, one_has && other_has) << "without train length delay only if both are";
        EXPECT_EQ(both.from, at(5));
        EXPECT_EQ(both.to, at(20));
        EXPECT_EQ(both.V_TSR, 6);
        EXPECT_EQ(both.NID_TSR, 255);
      }
}

// ---- What others read ---------------------------------------------------------------------------------------------

TEST(Authority, A_temporary_end_at_the_end_itself_takes_the_release_speed_away) {
  Description d;
  store(d, whole(1000), front_at(0));
  d.ma->danger_point = DangerPoint{at(1050), {ReleaseSpeedChoice::value, Speed{5}}};
  EXPECT_EQ(authority(d, {}, Mode::FS, kInRear).release.kind, ReleaseSpeedChoice::value);
  LevelCrossing lx;
  lx.from = at(1000);
  lx.to = at(1100);
  lx.unprotected = true;
  ASSERT_TRUE(d.lx.push_back(lx));
  const Authority at_end = authority(d, {}, Mode::FS, kInRear);
  EXPECT_EQ(at_end.EOA, at(1000));
  EXPECT_EQ(at_end.SvL, at(1000));
  EXPECT_EQ(at_end.release.kind, Release{}.kind);
  d.lx[0].from = at(1050);
  const Authority at_SvL = authority(d, {}, Mode::FS, kInRear);
  EXPECT_EQ(at_SvL.EOA, at(1000));
  EXPECT_EQ(at_SvL.SvL, at(1050));
  EXPECT_EQ(at_SvL.release.kind, Release{}.kind) << "the SvL is that of the level crossing";
  d.lx[0].from = at(1050.1);
  EXPECT_EQ(authority(d, {}, Mode::FS, kInRear).release.kind, ReleaseSpeedChoice::value);
}

TEST(Authority, A_mode_area_at_the_end_takes_the_release_speed_away) {  // 3.12.4.5
  for (const double from : {1000.0, 1000.1}) {
    Description d;
    store(d, whole(1000), front_at(0));
    d.ma->danger_point = DangerPoint{at(1050), {ReleaseSpeedChoice::value, Speed{5}}};
    ModeArea area;
    area.from = at(from);
    area.also_SvL = false;
    ASSERT_TRUE(d.mode_profile.push_back(area));
    EXPECT_EQ(authority(d, {}, Mode::FS, kInRear).release.kind,
              from == 1000.0 ? Release{}.kind : ReleaseSpeedChoice::value);
  }
}

TEST(Texts, One_that_ended_is_marked_as_such) {
  Description d;
  Text text;
  text.state = Text::State::shown;
  text.end_at = at(50);
  ASSERT_TRUE(d.texts.push_back(text));
  TextReports reports;
  EXPECT_TRUE(show_texts(d, front_at(100), Mode::FS, Level::L2, 0, {}, reports).shown.empty());
  EXPECT_EQ(d.texts[0].state, Text::State::ended);
}

TEST(Services, The_highest_speed_of_the_language_is_no_limit) { EXPECT_EQ(kNoLimit, Speed{600 / 3.6}); }

TEST(Services, An_area_is_accepted_from_its_window_or_its_start_on) {
  for (const double start : {100.0, 105.0, 105.1}) {
    Description d;
    ModeArea area;
    area.mode = Mode::OS;
    area.from = at(start);
    area.ack_from = at(1000);
    ASSERT_TRUE(d.mode_profile.push_back(area));
    accept_area(d, Mode::OS, front_at(100));  // max safe front end at 105
    EXPECT_EQ(d.mode_profile[0].accepted, start <= 105.0);
  }
}

TEST(Services, The_description_begins_where_its_first_step_is) {  // 4.6.3 [69]
  Description d;
  EXPECT_TRUE(before_track_description(d, front_at(100)));
  ASSERT_TRUE(d.ssp.replace_from(ssp({{100, 80}})));
  ASSERT_TRUE(d.gradient.replace_from(slopes({{100, 0}})));
  EXPECT_FALSE(before_track_description(d, front_at(100)));
  EXPECT_TRUE(before_track_description(d, front_at(99.9)));
  ASSERT_TRUE(d.gradient.replace_from(slopes({{50, 0}})));
  EXPECT_TRUE(before_track_description(d, front_at(99.9)));
}

TEST(Services, The_time_that_is_left_counts_from_the_start_of_the_timer) {  // 3.8.2.3 c
  Description d;
  EXPECT_FALSE(time_to_timeout(d, Duration{100}));
  store(d, whole(1000), front_at(0));
  EXPECT_FALSE(time_to_timeout(d, Duration{100}));
  d.ma->sections[0].timer = {Duration{60}, Duration{90}, true};
  EXPECT_EQ(time_to_timeout(d, Duration{100}), Duration{50});
  d.ma->V_LOA = Speed{1};
  d.ma->loa_timer = {Duration{30}, Duration{95}, true};
  EXPECT_EQ(time_to_timeout(d, Duration{100}), Duration{25});
}

TEST(Services, A_train_that_fits_no_listed_gauge_fits_no_route_that_asks_for_one) {  // 3.12.2.4
  RouteSuitability item;
  item.kind = Suitability::gauge;
  item.M_LINEGAUGE = 0xff;
  TrainInterfaces train;
  EXPECT_TRUE(unsuitable(item, train));
  for (const std::uint8_t gauge : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}, std::uint8_t{4}}) {
    train.M_LOADINGGAUGE = gauge;
    item.M_LINEGAUGE = static_cast<std::uint8_t>(1u << (gauge - 1));
    EXPECT_FALSE(unsuitable(item, train));
    item.M_LINEGAUGE = static_cast<std::uint8_t>(~item.M_LINEGAUGE);
    EXPECT_TRUE(unsuitable(item, train));
  }
}

TEST(Services, Geographical_position_at_its_limits) {  // 3.6.6, M_POSITION 0..9999999
  const auto position = [](std::uint32_t M_POSITION, double run, bool counts_up = true) {
    Description d;
    GeoReference reference;
    reference.M_POSITION = M_POSITION;
    reference.counts_up_ahead = counts_up;
    reference.applies_from = at(0);
    reference.applicable = true;
    EXPECT_TRUE(d.geo.push_back(reference));
    return geographical_position(d, front_at(run));
  };
  EXPECT_EQ(position(0, 0.0), 0u);
  EXPECT_EQ(position(0, 0.47), 0u);
  EXPECT_EQ(position(0, 0.5), 1u);
  EXPECT_EQ(position(9'999'999, 0.0), 9'999'999u);
  EXPECT_FALSE(position(9'999'999, 1.0));
  EXPECT_EQ(position(5, 5.0, false), 0u);
  EXPECT_FALSE(position(5, 5.1, false));
  // Of two that apply from one place on the later one.
  Description d;
  GeoReference reference;
  reference.M_POSITION = 100;
  reference.applies_from = at(0);
  reference.applicable = true;
  ASSERT_TRUE(d.geo.push_back(reference));
  reference.M_POSITION = 700;
  ASSERT_TRUE(d.geo.push_back(reference));
  EXPECT_EQ(geographical_position(d, front_at(0)), 700u);
}

// ---- Profiles and the MRSP ----------------------------------------------------------------------------------------

TEST(Profile, New_data_replace_a_step_at_their_very_start) {
  GradientProfile p;
  ASSERT_TRUE(p.replace_from(slopes({{0, 1}, {100, 2}})));
  ASSERT_TRUE(p.replace_from(slopes({{100, 3}})));
  ASSERT_EQ(p.steps.size(), 2u);
  EXPECT_EQ(p.steps[1].value.permille, 3);
  GradientProfile many;
  for (int i = 0; i < 96; ++i) ASSERT_TRUE(many.append(at(i), Gradient{1}));
  EXPECT_TRUE(many.has_room_for(slopes({{95, 2}})));
  EXPECT_FALSE(many.has_room_for(slopes({{96, 2}})));
  EXPECT_FALSE(many.has_room_for(slopes({{95, 2}, {96, 2}})));
}

TEST(Profile, A_step_that_ends_at_the_limit_is_forgotten) {  // A.3.6
  GradientProfile p;
  ASSERT_TRUE(p.replace_from(slopes({{0, 1}, {100, 2}, {200, 3}})));
  p.forget_before(at(99.9));
  EXPECT_EQ(p.steps.size(), 3u);
  p.forget_before(at(100));
  EXPECT_EQ(p.steps.size(), 2u);
}

TEST(Mrsp, Permitted_braking_distances_count_as_many_as_have_a_speed) {
  Description d;
  for (const double from : {0.0, 1000.0}) {
    PermittedBrakingDistance pbd;
    pbd.from = at(from);
    pbd.to = at(from + 500);
    ASSERT_TRUE(d.pbd.push_back(pbd));
  }
  MrspQuery q;
  q.from = at(-100);
  const SpeedCode speeds[] = {10, 12};
  for (const std::size_t known : {0u, 1u, 2u}) {
    q.pbd_speeds = std::span(speeds, known);
    const Mrsp f = mrsp(d, q);
    EXPECT_EQ(f.at(at(100)), known > 0 ? speed_of(10) : kNoLimit);
    EXPECT_EQ(f.at(at(1100)), known > 1 ? speed_of(12) : kNoLimit);
  }
  d.pbd.clear();
  q.pbd_speeds = speeds;
  EXPECT_EQ(mrsp(d, q).size(), 1u);
}

TEST(Mrsp, With_more_changes_than_there_is_room_for_it_is_never_too_high) {
  Description d;
  MrspQuery q;
  q.from = at(-100);
  for (int i = 0; i < 40; ++i) {
    AxleLoadRestriction asp;
    asp.from = at(100.0 * i + 10);
    asp.to = at(100.0 * i + 20);
    asp.V_AXLELOAD[0] = static_cast<SpeedCode>(20 + i % 3);
    ASSERT_TRUE(d.asp.push_back(asp));
    PermittedBrakingDistance pbd;
    pbd.from = at(100.0 * i + 30);
    pbd.to = at(100.0 * i + 40);
    ASSERT_TRUE(d.pbd.push_back(pbd));
    TemporarySpeedRestriction tsr;
    tsr.from = at(100.0 * i + 50);
    tsr.to = at(100.0 * i + 60);
    tsr.V_TSR = static_cast<SpeedCode>(10 + i % 5);
    ASSERT_TRUE(d.tsr.push_back(tsr));
  }
  const std::vector<SpeedCode> speeds(d.pbd.size(), SpeedCode{15});
  q.pbd_speeds = speeds;
  const Mrsp f = mrsp(d, q);
  EXPECT_EQ(f.size(), kMrspSteps);
  for (int i = 0; i < 40; ++i) {
    EXPECT_LE(f.at(at(100.0 * i + 15)), speed_of(static_cast<SpeedCode>(20 + i % 3))) << i;
    EXPECT_LE(f.at(at(100.0 * i + 35)), speed_of(15)) << i;
    EXPECT_LE(f.at(at(100.0 * i + 55)), speed_of(static_cast<SpeedCode>(10 + i % 5))) << i;
  }
  EXPECT_EQ(f.at(at(0)), kNoLimit) << "near the train nothing is lost";
  EXPECT_EQ(f.at(at(105)), kNoLimit);
}

TEST(Gradient, From_a_place_on_and_without_room) {
  Description d;
  EXPECT_EQ(gradient(d, at(0), -3.0).size(), 1u);
  ASSERT_TRUE(d.gradient.replace_from(slopes({{0, 1}, {100, 2}, {200, 3}})));
  GradientFunction f = gradient(d, at(100));
  ASSERT_EQ(f.size(), 2u) << "the step that begins there is the first";
  EXPECT_EQ(f.at(at(100)), 2.0);
  f = gradient(d, at(0));
  EXPECT_EQ(f.size(), 3u);
  f = gradient(d, at(-1), -5.0);
  EXPECT_EQ(f.size(), 4u);
  EXPECT_EQ(f.at(at(-1)), -5.0);
  // A full profile that begins ahead: of the last two steps the lower gradient is kept, whichever it is.
  for (const int last : {-7, 7}) {
    Description full;
    for (int i = 0; i < 95; ++i)
      ASSERT_TRUE(full.gradient.append(at(i), Gradient{static_cast<std::int16_t>(i % 2 + 1)}));
    ASSERT_TRUE(full.gradient.append(at(95), Gradient{static_cast<std::int16_t>(last)}));
    EXPECT_EQ(gradient(full, at(-1)).at(at(200)), last < 0 ? -7.0 : 1.0);
  }
}

TEST(SpeedForATrain, The_lowest_of_what_applies_to_it) {  // 3.11.3.2, 3.11.4
  StaticSpeed element;
  element.V_STATIC = 20;
  element.cd[10] = 30;
  element.other[2] = 18;
  EXPECT_EQ(element.speed_for({10, 0, 0}), 30);
  EXPECT_EQ(element.speed_for({9, 0, 0}), 20);
  EXPECT_EQ(element.speed_for({10, 0b100, 0}), 18);
  element.other[0] = 16;
  EXPECT_EQ(element.speed_for({10, 0b101, 0}), 16);
  element.replaces_cd = 0b100;
  element.other[2] = 33;
  EXPECT_EQ(element.speed_for({10, 0b100, 0}), 33);
  element.cd[0] = 12;
  EXPECT_EQ(element.speed_for({0, 0, 0}), 12) << "the lowest class counts for every train";
  AxleLoadRestriction axle;
  axle.V_AXLELOAD[12] = 5;
  EXPECT_EQ(axle.speed_for({0, 0, 12}), 5);
  EXPECT_EQ(axle.speed_for({0, 0, 11}), kNoSpeed);
  EXPECT_FALSE(StaticSpeed{}.Q_FRONT || TemporarySpeedRestriction{}.from_rbc || LevelCrossing{}.unprotected);
}

}  // namespace
}  // namespace evc::track
