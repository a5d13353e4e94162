#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

#include "track/store.h"
#include "track/testing.h"
#include "track/withdraw.h"

// A.3.4, A.3.6 and the timers of 3.8.4, kind by kind, with places and times exactly on the border.
namespace evc::track {
namespace {

using namespace testing;

/// Something of one kind that begins at `from` (and ends at `from` + 100 m where it has a length).
struct Stretched {
  const char* what;
  std::function<void(Description&, double from)> put;
  std::function<bool(const Description&)> there;
  bool track_description;  ///< its deletion is a reason for an MA request (3.8.2.7.3)
  bool endless = false;
};

template <class List>
void append(List& list, double from) {
  auto element = typename std::decay_t<decltype(list[0])>{};
  element.from = at(from);
  element.to = at(from + 100);
  EXPECT_TRUE(list.push_back(element));
}

std::vector<Stretched> all_stretched() {
  using D = Description;
  return {
      {"asp", [](D& d, double x) { append(d.asp, x); }, [](const D& d) { return !d.asp.empty(); }, true},
      {"pbd", [](D& d, double x) { append(d.pbd, x); }, [](const D& d) { return !d.pbd.empty(); }, true},
      {"conditions", [](D& d, double x) { append(d.conditions, x); }, [](const D& d) { return !d.conditions.empty(); },
       true},
      {"big metal", [](D& d, double x) { append(d.big_metal, x); }, [](const D& d) { return !d.big_metal.empty(); },
       true},
      {"platforms", [](D& d, double x) { append(d.platforms, x); }, [](const D& d) { return !d.platforms.empty(); },
       false},
      {"suitability",
       [](D& d, double x) {
         RouteSuitability item;
         item.at = at(x);
         EXPECT_TRUE(d.suitability.push_back(item));
       },
       [](const D& d) { return !d.suitability.empty(); }, true},
      {"gradient",
       [](D& d, double x) {
         EXPECT_TRUE(d.gradient.replace_from(slopes({{x, 3}})));
       },
       [](const D& d) { return !d.gradient.empty(); }, true, true},
      {"ssp",
       [](D& d, double x) {
         EXPECT_TRUE(d.ssp.replace_from(ssp({{x, 80}})));
       },
       [](const D& d) { return !d.ssp.empty(); }, true, true},
      {"traction",
       [](D& d, double x) {
         d.traction = TractionChange{at(x), 1, 1};
       },
       [](const D& d) { return d.traction.has_value(); }, false},
      {"current",
       [](D& d, double x) {
         d.current = CurrentChange{at(x), {}};
       },
       [](const D& d) { return d.current.has_value(); }, false},
      {"RBC transition",
       [](D& d, double x) {
         d.rbc_transition = RbcTransition{at(x), 1, 1, 1, false};
       },
       [](const D& d) { return d.rbc_transition.has_value(); }, false},
      {"radio infill", [](D& d, double x) { d.radio_infill = RadioInfillArea{at(x), true, 1, 1, 1, {}}; },
       [](const D& d) { return d.radio_infill.has_value(); }, false},
      {"reversing area",
       [](D& d, double x) {
         d.reversing_area = ReversingArea{at(x), at(x + 100)};
       },
       [](const D& d) { return d.reversing_area.has_value(); }, false},
      {"signalling speed",
       [](D& d, double x) {
         (void)d.signalling.push_back({at(x), 10, std::nullopt});
       },
       [](const D& d) { return !d.signalling.empty(); }, false},
      {"mode profile",
       [](D& d, double x) {
         ModeArea area;
         area.from = at(x);
         EXPECT_TRUE(d.mode_profile.push_back(area));
       },
       [](const D& d) { return !d.mode_profile.empty(); }, false},
  };
}

TEST(Shorten, What_begins_at_the_place_goes_and_what_begins_before_it_stays) {  // A.3.4
  for (const Stretched& kind : all_stretched())
    for (const double from : {999.9, 1000.0, 1000.1}) {
      Description d;
      kind.put(d, from);
      const bool asks = shorten(d, Situation::c_section_timeout, at(1000), front_at(0));
      EXPECT_EQ(kind.there(d), from < 1000.0) << kind.what << " " << from;
      EXPECT_EQ(asks && from >= 1000.0, kind.track_description && from >= 1000.0) << kind.what << " " << from;
      // Nothing of it there, nothing deleted.
      Description other;
      kind.put(other, 100.0);
      const bool asks_anyway = shorten(other, Situation::c_section_timeout, at(1000), front_at(0));
      // A profile has no end: what it says beyond the place is deleted.
      EXPECT_EQ(asks_anyway, kind.endless) << kind.what;
      EXPECT_TRUE(kind.there(other)) << kind.what;
    }
}

TEST(Shorten, What_lies_across_the_place_ends_there_and_counts_as_deleted) {
  Description d;
  append(d.asp, 950.0);
  EXPECT_TRUE(shorten(d, Situation::c_section_timeout, at(1000), front_at(0)));
  EXPECT_EQ(d.asp[0].to, at(1000));
  EXPECT_FALSE(shorten(d, Situation::c_section_timeout, at(1000), front_at(0))) << "it ends there already";
  d.reversing_area = ReversingArea{at(950), at(1050)};
  (void)d.signalling.push_back({at(0), 10, at(1050)});
  (void)shorten(d, Situation::c_section_timeout, at(1000), front_at(0));
  EXPECT_EQ(d.reversing_area->to, at(1000));
  EXPECT_EQ(d.signalling.back().to, at(1000));
  (void)shorten(d, Situation::c_section_timeout, at(1500), front_at(0));
  EXPECT_EQ(d.reversing_area->to, at(1000));
  EXPECT_EQ(d.signalling.back().to, at(1000));
  // More than one kind at a time: one that counts is enough, whatever its order.
  Description two;
  EXPECT_TRUE(two.ssp.replace_from(ssp({{1200, 80}})));
  append(two.platforms, 1200);
  EXPECT_TRUE(shorten(two, Situation::c_section_timeout, at(1000), front_at(0)));
  append(two.asp, 1200);
  append(two.platforms, 1200);
  EXPECT_TRUE(shorten(two, Situation::c_section_timeout, at(1000), front_at(0)));
}

TEST(Shorten, In_which_situations_an_MA_is_requested) {  // 3.8.2.7.3
  using enum Situation;
  for (const Situation s : {a_conditional_emergency_stop, b_shortened_ma, c_section_timeout, d_overlap_timeout,
                            e_end_section_timeout, f_shortening_granted, g_unlinked_group_inconsistent,
                            h_linking_reaction, i_radio_contact_lost, j_train_data_changed, k_desk_closed_during_start,
                            l_rams_supervision, m_linked_group_inconsistent, n_loa_became_eoa}) {
    Description d;
    append(d.asp, 1200);
    const bool without = s == a_conditional_emergency_stop || s == b_shortened_ma || s == f_shortening_granted ||
                         s == k_desk_closed_during_start;
    EXPECT_EQ(shorten(d, s, at(1000), front_at(0)), !without) << int(s);
    EXPECT_TRUE(d.asp.empty());
  }
}

TEST(Shorten, Texts_that_wait_for_a_place_beyond_go) {
  for (const Text::State state : {Text::State::waiting, Text::State::shown})
    for (const double start : {1000.0, 1000.1}) {
      Description d;
      Text text;
      text.state = state;
      text.start_at = at(start);
      ASSERT_TRUE(d.texts.push_back(text));
      text.start_at.reset();
      ASSERT_TRUE(d.texts.push_back(text));
      (void)shorten(d, Situation::c_section_timeout, at(1000), front_at(0));
      EXPECT_EQ(d.texts.size(), state == Text::State::waiting && start > 1000.0 ? 1u : 2u);
    }
}

TEST(Shorten, The_numbers_of_texts_go_on) {
  Description d;
  d.next_text_id = 7;
  (void)shorten(d, Situation::k_desk_closed_during_start, at(0), front_at(0));
  EXPECT_EQ(d.next_text_id, 7);
}

/// An MA of three sections of 1000 m with everything that it can have.
Description with_everything() {
  Description d;
  store(d, whole(3000), front_at(0));
  d.ma->sections.clear();
  for (const double begin : {0.0, 1000.0, 2000.0}) {
    Section s;
    s.begin = at(begin);
    s.end = at(begin + 1000);
    EXPECT_TRUE(d.ma->sections.push_back(s));
  }
  d.ma->loa_timer = {Duration{60}, Duration{}, true};
  d.ma->end_section = EndSectionTimer{at(2500), {Duration{30}, {}, false}};
  d.ma->danger_point = DangerPoint{at(3050), {ReleaseSpeedChoice::value, Speed{5}}};
  d.ma->overlap = Overlap{at(2000), at(3100), {Duration{20}, {}, false}, {ReleaseSpeedChoice::value, Speed{4}}};
  return d;
}

TEST(Withdraw, Where_the_MA_ends_anew_nothing_of_its_old_end_is_left) {
  Description d = with_everything();
  d.ma->V_LOA = Speed{3};
  d.ma->fixed_SvL = at(2900);
  d.ma->fixed_release = Release{ReleaseSpeedChoice::national, {}};
  EXPECT_EQ(stop_at(d, at(1500), front_at(0)), 0);
  const MovementAuthority& ma = *d.ma;
  EXPECT_EQ(ma.sections.size(), 2u);
  EXPECT_EQ(ma.end(), at(1500));
  EXPECT_EQ(ma.SvL(), at(1500));
  EXPECT_FALSE(ma.limited() || ma.end_section || ma.danger_point || ma.overlap);
  EXPECT_EQ(ma.fixed_SvL, at(1500)) << "a repositioning does not move it";
  EXPECT_EQ(ma.loa_timer, Timer{});
  EXPECT_EQ(ma.release().kind, Release{}.kind);
  // At the beginning of a section that section goes; in rear of the MA its section has no length.
  Description border = with_everything();
  EXPECT_EQ(stop_at(border, at(1000), front_at(0)), 0);
  EXPECT_EQ(border.ma->sections.size(), 1u);
  Description behind = with_everything();
  EXPECT_EQ(stop_at(behind, at(-10), front_at(-100)), 0);
  EXPECT_EQ(behind.ma->sections[0].begin, at(-10));
  EXPECT_EQ(behind.ma->end(), at(-10));
}

TEST(Withdraw, A_stop_between_EOA_and_SvL_moves_the_SvL) {  // 3.10.2.2
  for (const auto& [stop, SvL] : {std::pair{3050.0, 3050.0}, {3100.0, 3100.0}, {3100.1, 3100.0}}) {
    Description d = with_everything();
    EXPECT_EQ(stop_at(d, at(stop), front_at(0)), 1);
    EXPECT_EQ(d.ma->SvL(), at(SvL));
    EXPECT_EQ(d.ma->release().kind, stop <= 3100.0 ? Release{}.kind : ReleaseSpeedChoice::value) << stop;
  }
  Description d = with_everything();
  append(d.asp, 3500);
  (void)stop_at(d, at(3000), front_at(0));
  EXPECT_TRUE(d.asp.empty());
}

TEST(Withdraw, What_is_not_known_ends_the_authority_or_stops_the_train) {  // 3.7.2.3
  const auto ended = [](double place) {
    Description d = with_everything();
    (void)end_before(d, at(place), front_at(0));  // max safe front end at 5
    return d;
  };
  EXPECT_EQ(ended(5.0).ma->SvL(), at(5)) << "at the train: EOA at the estimated, SvL at the max safe front end";
  EXPECT_EQ(ended(5.0).ma->end(), at(0));
  EXPECT_EQ(ended(5.1).ma->end(), at(5.1));
  EXPECT_EQ(ended(3000.0).ma->end(), at(3000));
  EXPECT_EQ(ended(3000.0).ma->SvL(), at(3000));
  EXPECT_EQ(ended(3050.0).ma->end(), at(3000));
  EXPECT_EQ(ended(3050.0).ma->SvL(), at(3050));
  EXPECT_EQ(ended(3050.0).ma->release().kind, Release{}.kind);
  EXPECT_EQ(ended(3100.0).ma->release().kind, ReleaseSpeedChoice::value) << "the SvL is known";
}

TEST(Withdraw, A_section_timer_runs_until_the_min_safe_front_end_is_beyond_its_stop) {
  for (const double min_safe_front : {500.0, 500.1}) {
    Description d = with_everything();
    d.ma->overlap.reset();
    d.ma->sections[1].timer = {Duration{60}, Duration{}, true};
    d.ma->sections[1].stop = at(500);
    append(d.asp, 1500);
    Here here = front_at(min_safe_front + 5.0);
    here.now = Duration{61};
    const Elapsed e = advance(d, here);
    EXPECT_EQ(e.section_timeout, min_safe_front == 500.0);
    EXPECT_EQ(e.any(), e.section_timeout);
    EXPECT_EQ(e.track_description_deleted, e.section_timeout);
    EXPECT_EQ(d.ma->end(), e.section_timeout ? at(1000) : at(3000));
    EXPECT_EQ(d.ma->sections.size() > 1 && d.ma->sections[1].timer.running, false);
  }
  // The first of two that run out; one that does not run, or has time, does not hide the next.
  Description d = with_everything();
  d.ma->overlap.reset();
  d.ma->sections[0].timer = {Duration{100}, Duration{}, true};
  d.ma->sections[0].stop = at(900);
  d.ma->sections[2].timer = {Duration{60}, Duration{}, true};
  d.ma->sections[2].stop = at(900);
  Here here = front_at(0);
  here.now = Duration{61};
  EXPECT_TRUE(advance(d, here).section_timeout);
  EXPECT_EQ(d.ma->end(), at(2000));
}

TEST(Withdraw, Overlap_and_end_section_timers_start_when_the_max_safe_front_end_is_beyond_their_start) {  // 3.8.4
  const auto at_start = [](double max_safe_front) {
    Description d = with_everything();
    d.ma->end_section->start = at(2000);
    Here here = front_at(max_safe_front - 5.0);
    here.now = Duration{10};
    EXPECT_FALSE(advance(d, here).any());
    return d;
  };
  for (const double front : {2000.0, 2000.1}) {
    const Description d = at_start(front);
    EXPECT_EQ(d.ma->overlap->timer.running, front > 2000.0);
    EXPECT_EQ(d.ma->end_section->timer.running, front > 2000.0);
  }
  Description d = at_start(2000.1);
  EXPECT_EQ(d.ma->overlap->timer.started, Duration{10});
  EXPECT_EQ(d.ma->end_section->timer.started, Duration{10});
  Here here = front_at(2100);
  append(d.asp, 3200);
  here.now = Duration{30.5};
  Elapsed e = advance(d, here);
  EXPECT_TRUE(e.overlap_timeout && !e.end_section_timeout && e.any());
  EXPECT_TRUE(e.track_description_deleted);
  EXPECT_FALSE(d.ma->overlap || d.ma->limited());
  here.now = Duration{40.5};
  e = advance(d, here);
  EXPECT_TRUE(e.end_section_timeout && !e.overlap_timeout && e.any());
  EXPECT_EQ(d.ma->end(), at(2100));
}

TEST(Withdraw, The_timer_of_an_LOA_runs_out_once) {
  Description d = with_everything();
  d.ma->V_LOA = Speed{3};
  Here here = front_at(0);
  here.now = Duration{61};
  append(d.asp, 3200);
  const Elapsed e = advance(d, here);
  EXPECT_TRUE(e.loa_timeout && e.any());
  EXPECT_TRUE(e.track_description_deleted) << "beyond the SvL";
  EXPECT_FALSE(d.ma->limited() || d.ma->loa_timer.running);
  EXPECT_FALSE(advance(d, here).any());
  EXPECT_FALSE(Elapsed{}.any() || Elapsed{}.track_description_deleted);
}

TEST(Withdraw, What_was_passed_is_kept_for_300_m_behind_the_min_safe_rear_end) {  // A.3.6
  for (const double behind : {-0.1, 0.0}) {  // its end, counted from 300 m in rear of the min safe rear end
    Description d;
    Here here = front_at(1000);  // min safe rear end at 795
    const double begin = 495.0 + behind - 100.0;
    append(d.asp, begin);
    append(d.big_metal, begin);
    append(d.tsr, begin);
    append(d.lx, begin);
    append(d.adhesion, begin);
    append(d.tsr, 900);
    (void)d.signalling.push_back({at(begin), 12, at(begin + 100)});
    EXPECT_TRUE(d.gradient.replace_from(slopes({{begin, 1}, {begin + 100, 2}})));
    EXPECT_TRUE(d.ssp.replace_from(ssp({{begin, 100}, {begin + 100, 80}})));
    (void)advance(d, here);
    const std::size_t kept = behind < 0.0 ? 0 : 1;
    EXPECT_EQ(d.asp.size(), kept);
    EXPECT_EQ(d.big_metal.size(), kept);
    EXPECT_EQ(d.tsr.size(), kept + 1);
    EXPECT_EQ(d.lx.size(), kept);
    EXPECT_EQ(d.adhesion.size(), kept);
    EXPECT_EQ(d.signalling.size(), kept);
    EXPECT_EQ(d.gradient.steps.size(), 1u);
    EXPECT_EQ(d.ssp.steps.size(), 1u);
  }
}

TEST(Withdraw, Sections_areas_and_texts_that_are_over_are_forgotten) {
  Description d = with_everything();
  ModeArea area;
  area.from = at(0);
  for (const double end : {994.9, 995.0, 2000.0}) {
    area.to = at(end);
    ASSERT_TRUE(d.mode_profile.push_back(area));
  }
  for (const Text::State state : {Text::State::waiting, Text::State::ended, Text::State::shown}) {
    Text text;
    text.state = state;
    ASSERT_TRUE(d.texts.push_back(text));
  }
  const std::uint32_t before = d.revision;
  (void)advance(d, front_at(1000));  // min safe front end at 995
  ASSERT_EQ(d.mode_profile.size(), 2u);
  EXPECT_EQ(d.mode_profile[0].to, at(995));
  EXPECT_EQ(d.revision, before + 1);
  ASSERT_EQ(d.texts.size(), 2u);
  EXPECT_EQ(d.texts[0].state, Text::State::waiting);
  EXPECT_EQ(d.texts[1].state, Text::State::shown);
  (void)advance(d, front_at(1000));
  EXPECT_EQ(d.revision, before + 1);
  // The first section ends at 1000: kept while that is not 300 m behind the train.
  (void)advance(d, front_at(1505.0));
  EXPECT_EQ(d.ma->sections.size(), 3u);
  (void)advance(d, front_at(1505.1));
  EXPECT_EQ(d.ma->sections.size(), 2u);
}

// ---- Storing an MA ------------------------------------------------------------------------------------------------

TEST(StoreAuthority, Running_timers_are_taken_over_behind_their_start_only) {  // 3.8.4.1.3, 3.8.4.4.4
  for (const double max_safe_front : {2000.0, 2000.1})
    for (const bool running : {false, true}) {
      Description d = with_everything();
      d.ma->overlap->timer = {Duration{20}, Duration{95}, running};
      Contents c = whole(3100);
      c.ma = authority_to(3000);
      c.ma->overlap = Overlap{at(2000), at(3100), {Duration{20}, {}, false}, {}};
      Here here = front_at(max_safe_front - 5.0);
      here.now = Duration{100};
      store(d, c, here);
      advance(d, here);
      const bool behind = max_safe_front > 2000.0;
      ASSERT_EQ(d.ma->overlap.has_value(), !behind || running) << "one that does not run counts as expired";
      if (d.ma->overlap) {
        EXPECT_EQ(d.ma->overlap->timer.running, behind);
        EXPECT_EQ(d.ma->overlap->timer.started, behind ? Duration{95} : Duration{});
      }
    }
}

TEST(StoreAuthority, A_running_end_section_timer_goes_on_in_the_next_MA) {  // 3.8.4.1.3-4
  const auto next = [](bool old_end_section, bool running) {
    Description d = with_everything();
    d.ma->overlap.reset();
    if (old_end_section)
      d.ma->end_section = EndSectionTimer{at(2000), {Duration{30}, Duration{95}, running}};
    else
      d.ma->end_section.reset();
    Contents c = whole(3000);
    c.ma->end_section = EndSectionTimer{at(2000), {Duration{20}, {}, false}};
    Here here = front_at(2100);
    here.now = Duration{100};
    store(d, c, here);
    return std::pair{d.ma->end_section->timer, advance(d, here).end_section_timeout};
  };
  const auto [timer, timeout] = next(true, true);
  EXPECT_EQ(timer, (Timer{Duration{20}, Duration{95}, true})) << "started by the old one, up to the new limit";
  EXPECT_FALSE(timeout);
  EXPECT_TRUE(next(true, false).second) << "none ran: it has run out";
  EXPECT_TRUE(next(false, false).second) << "there was none";
}

TEST(StoreAuthority, An_end_section_that_counts_as_timed_out_ends_the_MA_at_the_train) {  // A.3.4 e
  Description d;
  Contents c = whole(3000);
  c.ma->V_LOA = Speed{3};
  c.ma->end_section = EndSectionTimer{at(1000), {Duration{30}, {}, false}};
  c.ma->danger_point = DangerPoint{at(3050), {ReleaseSpeedChoice::value, Speed{5}}};
  c.ma->overlap = Overlap{at(2900), at(3100), {Duration{20}, {}, false}, {ReleaseSpeedChoice::value, Speed{4}}};
  store(d, c, front_at(1500));
  advance(d, front_at(1500));
  const MovementAuthority& ma = *d.ma;
  EXPECT_EQ(ma.end(), at(1500));
  EXPECT_EQ(ma.SvL(), at(1505));
  EXPECT_FALSE(ma.limited() || ma.end_section || ma.overlap || ma.danger_point);
  EXPECT_EQ(ma.release().kind, Release{}.kind);
}

TEST(StoreAuthority, Areas_accepted_before_stay_accepted_where_the_train_is_in_them) {  // 5.9.2.7
  const auto accepted = [](double start, Mode mode, bool before) {
    Description d;
    store(d, whole(3000), front_at(100));
    ModeArea area;
    area.mode = Mode::OS;
    area.from = at(0);
    area.accepted = before;
    EXPECT_TRUE(d.mode_profile.push_back(area));
    Contents c = whole(3000);
    c.mode_profile.emplace();
    area.mode = mode;
    area.from = at(start);
    area.ack_from = at(start);
    area.accepted = false;
    EXPECT_TRUE(c.mode_profile->push_back(area));
    const Stored report = store(d, c, front_at(100));  // max safe front end at 105
    int noted = 0;
    for (const Note& n : report.notes) noted += n.packet == 80 && n.what == Note::What::stored;
    EXPECT_EQ(noted, 1);
    EXPECT_EQ(d.mode_profile.size(), 1u) << "the old profile is deleted with the old MA";
    return d.mode_profile[0].accepted;
  };
  EXPECT_TRUE(accepted(0.0, Mode::OS, true));
  EXPECT_TRUE(accepted(105.0, Mode::OS, true));
  EXPECT_FALSE(accepted(105.1, Mode::OS, true));
  // With the window at the estimated front end the train is in it.
  Description window;
  store(window, whole(3000), front_at(100));
  ModeArea area;
  area.accepted = true;
  ASSERT_TRUE(window.mode_profile.push_back(area));
  Contents c = whole(3000);
  c.mode_profile.emplace();
  area.accepted = false;
  area.from = at(500);
  area.ack_from = at(100);
  ASSERT_TRUE(c.mode_profile->push_back(area));
  store(window, c, front_at(100));
  EXPECT_TRUE(window.mode_profile[0].accepted);
  EXPECT_FALSE(accepted(0.0, Mode::LS, true));
  EXPECT_FALSE(accepted(0.0, Mode::OS, false));
}

TEST(StoreAuthority, Packets_of_level_1_are_named_as_such) {
  Description d;
  Contents c = whole(3000);
  c.ma->level_1 = true;
  c.V_MAIN = SpeedCode{20};
  c.mode_profile.emplace();
  const auto what = [](const Stored& report, std::uint8_t packet) {
    for (const Note& n : report.notes)
      if (n.packet == packet) return int(n.what);
    return -1;
  };
  Stored report = store(d, c, front_at(0));
  EXPECT_EQ(what(report, 12), int(Note::What::stored));
  EXPECT_EQ(what(report, 15), -1);
  EXPECT_FALSE(d.signalling.empty()) << "only an MA of level 2/3 ends it (3.11.6.3.1)";
  report = store(d, c, front_at(0), "3.10.2.4"_srs);
  EXPECT_EQ(what(report, 12), int(Note::What::refused));
  EXPECT_EQ(what(report, 80), int(Note::What::refused));
  store(d, whole(3000), front_at(0));
  EXPECT_TRUE(d.signalling.empty());
  EXPECT_TRUE(complete(Description{}, front_at(0)));
}

TEST(StoreAuthority, Repositioning_moves_the_section_of_the_train_and_all_behind_it) {  // 3.8.5.2
  Description d = with_everything();
  Contents c;
  c.repositioned_section = Distance{900};
  c.reference = at(1050);
  const Stored report = store(d, c, front_at(1000));  // the second section begins here
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_EQ(report.notes[0].packet, 16);
  EXPECT_EQ(d.ma->sections[0].end, at(1000));
  EXPECT_EQ(d.ma->sections[1].end, at(1950));
  EXPECT_EQ(d.ma->sections[2].begin, at(1950));
  EXPECT_EQ(d.ma->end(), at(2950));
  EXPECT_EQ(d.ma->SvL(), at(3050));
  // A section that would end before its begin has no length.
  Description short_one = with_everything();
  c.repositioned_section = Distance{-100};
  store(short_one, c, front_at(1000));
  EXPECT_EQ(short_one.ma->sections[1].begin, at(950));
  EXPECT_EQ(short_one.ma->sections[1].end, at(950));
}

TEST(StoreAuthority, A_list_for_SH_comes_with_the_SH_area_of_its_MA) {  // 3.12.4.4
  for (const Mode mode : {Mode::SH, Mode::OS}) {
    Description d;
    Contents c = whole(3000);
    c.sh_list.emplace();
    c.mode_profile.emplace();
    ModeArea area;
    area.mode = mode;
    area.from = at(1000);
    ASSERT_TRUE(c.mode_profile->push_back(area));
    store(d, c, front_at(0));
    EXPECT_EQ(d.sh_list.has_value(), mode == Mode::SH);
  }
}

TEST(StoreAuthority, An_overlap_that_is_over_takes_the_LOA_along) {  // 3.8.4.4.3
  Description d;
  Contents c = whole(3100);
  c.ma = authority_to(3000);
  c.ma->V_LOA = Speed{3};
  c.ma->overlap = Overlap{at(1000), at(3100), {Duration{20}, {}, false}, {}};
  store(d, c, front_at(1500));
  advance(d, front_at(1500));
  EXPECT_FALSE(d.ma->overlap || d.ma->limited());
  Description running = with_everything();
  running.ma->V_LOA = Speed{3};
  running.ma->loa_timer = {};
  running.ma->overlap->timer = {Duration{20}, Duration{}, true};
  Here here = front_at(2500);
  here.now = Duration{21};
  EXPECT_TRUE(advance(running, here).overlap_timeout);
  EXPECT_FALSE(running.ma->limited());
}

TEST(StoreAuthority, An_MA_to_the_same_place_is_no_shortening_and_an_empty_one_is_none) {  // 3.8.5.1.3
  Description d;
  store(d, whole(3000), front_at(0));
  EXPECT_FALSE(store(d, whole(3000), front_at(0)).shortened);
  EXPECT_TRUE(store(d, whole(2999), front_at(0)).shortened);
  Contents empty;
  empty.ma.emplace();
  const Stored report = store(d, empty, front_at(0));
  EXPECT_FALSE(report.ma_accepted || report.ma_refused);
  d.gradient.steps.clear();
  EXPECT_FALSE(complete(d, front_at(0))) << "the SSP alone does not cover it";
}

TEST(StoreAuthority, Infill_replaces_areas_from_its_reference_on_and_needs_room) {  // 3.8.5.1 b
  const auto infill = [](std::size_t sections) {
    Contents c = whole(5000);
    c.infill = at(2000);
    c.ma->sections.clear();
    for (std::size_t i = 0; i < sections; ++i) {
      Section s;
      s.begin = at(2000.0 + 10.0 * static_cast<double>(i));
      s.end = at(2010.0 + 10.0 * static_cast<double>(i));
      EXPECT_TRUE(c.ma->sections.push_back(s));
    }
    c.ma->sections.back().end = at(5000);
    return c;
  };
  const auto before = [] {
    Description d = with_everything();
    d.ma->end_section.reset();
    d.ma->danger_point.reset();
    d.ma->overlap.reset();
    ModeArea area;
    for (const double from : {1999.9, 2000.0, 2500.0}) {
      area.from = at(from);
      EXPECT_TRUE(d.mode_profile.push_back(area));
    }
    return d;
  };
  Description d = before();
  EXPECT_TRUE(store(d, infill(1), front_at(0)).ma_accepted);
  EXPECT_EQ(d.mode_profile.size(), 1u);
  EXPECT_EQ(d.ma->sections.size(), 3u) << "two of the old one up to the reference, and the new one";
  EXPECT_EQ(d.ma->sections[1].end, at(2000));
  EXPECT_EQ(d.ma->end(), at(5000));
  Description room = before();
  EXPECT_TRUE(store(room, infill(30), front_at(0)).ma_accepted);
  Description no_room = before();
  EXPECT_TRUE(store(no_room, infill(31), front_at(0)).ma_refused);
  EXPECT_EQ(no_room.ma->end(), at(3000));
}

TEST(StoreAuthority, A_mode_profile_without_room_ends_the_authority) {
  Description d;
  store(d, whole(5000), front_at(0));
  ModeArea area;
  area.from = at(10);
  while (d.mode_profile.push_back(area)) continue;
  Contents c = whole(5000);
  c.infill = at(100);
  c.mode_profile.emplace();
  area.from = at(1000);
  ASSERT_TRUE(c.mode_profile->push_back(area));
  area.from = at(2000);
  ASSERT_TRUE(c.mode_profile->push_back(area));
  const Stored report = store(d, c, front_at(0));
  EXPECT_EQ(report.lost_from, at(1000));
  int full = 0;
  for (const Note& note : report.notes) full += note.packet == 80 && note.what == Note::What::full;
  EXPECT_EQ(full, 1);
  EXPECT_EQ(d.ma->end(), at(1000));
}

TEST(Withdraw, Two_areas_left_in_one_cycle_are_one_change_and_a_text_that_ended_is_forgotten_also_alone) {
  Description d;
  ModeArea area;
  area.to = at(100);
  ASSERT_TRUE(d.mode_profile.push_back(area) && d.mode_profile.push_back(area));
  Text text;
  text.state = Text::State::ended;
  ASSERT_TRUE(d.texts.push_back(text));
  (void)advance(d, front_at(1000));
  EXPECT_TRUE(d.mode_profile.empty() && d.texts.empty());
  EXPECT_EQ(d.revision, 1u);
}

TEST(StoreAuthority, A_granted_shortening_leaves_the_description_up_to_the_new_end) {  // 3.8.6, A.3.4 f
  Description d;
  store(d, whole(3000), front_at(0));
  Contents c;
  c.ma = authority_to(2000);
  c.ma_is_shortening_request = true;
  EXPECT_TRUE(store(d, c, front_at(0)).ma_accepted);
  EXPECT_TRUE(complete(d, front_at(0)));
  EXPECT_FALSE(d.ssp.covers(at(0), at(2000.1)));
}

TEST(Forget, Track_conditions_take_traction_and_current_along) {
  Description d;
  d.traction = TractionChange{};
  d.current = CurrentChange{};
  EXPECT_TRUE(forget(d, evc::Stored::track_conditions_general));
  EXPECT_FALSE(d.traction || d.current);
}

}  // namespace
}  // namespace evc::track
