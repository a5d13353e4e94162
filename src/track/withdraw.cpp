#include "track/withdraw.h"

#include <algorithm>

#include "track/areas.h"
#include "track/indication.h"
#include "track/services.h"

namespace evc::track {
namespace {

bool cuts_at_train(Situation situation) {
  switch (situation) {
    case Situation::e_end_section_timeout:
    case Situation::g_unlinked_group_inconsistent:
    case Situation::h_linking_reaction:
    case Situation::i_radio_contact_lost:
    case Situation::j_train_data_changed:
    case Situation::l_rams_supervision:
    case Situation::m_linked_group_inconsistent:
      return true;
    default:
      return false;
  }
}

/// 3.8.2.7.3: no MA is requested after these situations.
bool without_request(Situation situation) {
  return situation == Situation::a_conditional_emergency_stop || situation == Situation::b_shortened_ma ||
         situation == Situation::f_shortening_granted || situation == Situation::k_desk_closed_during_start;
}

/// Deletes elements beyond `at`; the one across it ends there. Returns whether there was any.
template <class T, std::size_t N>
bool cut_areas(InplaceVector<T, N>& areas, Place at) {
  bool changed = false;
  const std::size_t before = areas.size();
  areas.erase_if([&](const T& area) { return area.from >= at; });
  changed = areas.size() != before;
  for (T& area : areas)
    if (area.to > at) {
      area.to = at;
      changed = true;
    }
  return changed;
}

/// Deletes the track description beyond `at`, the data that belong to an MA (3.7.1.1). Returns
/// whether there was any.
bool cut_description(Description& d, Place at) {
  d.watch.changed = true;
  bool deleted = d.ssp.cut(at);
  deleted = d.gradient.cut(at) || deleted;
  each_list([&](const auto& list) {
    const bool any = cut_areas(d.*list.kept, at);
    deleted = deleted || (any && list.track_description);
  });
  const std::size_t points = d.suitability.size();
  d.suitability.erase_if([&](const RouteSuitability& item) { return item.at >= at; });
  deleted = deleted || d.suitability.size() != points;
  if (d.traction && d.traction->at >= at) d.traction.reset();
  if (d.current && d.current->at >= at) d.current.reset();
  if (d.rbc_transition && d.rbc_transition->at >= at) d.rbc_transition.reset();
  if (d.radio_infill && d.radio_infill->at >= at) d.radio_infill.reset();
  if (d.reversing_area && d.reversing_area->from >= at) d.reversing_area.reset();
  if (d.reversing_area && d.reversing_area->to > at) d.reversing_area->to = at;
  end_signalling_speed(d, at);
  return deleted;
}

/// Deletes the mode areas that begin beyond `at` with their windows; one that begins in rear of it is not changed
/// (A.3.4 [7], [12]).
void cut_mode_profile(Description& d, Place at) {
  d.mode_profile.erase_if([&](const ModeArea& area) { return area.from >= at; });
}

void cut_texts(Description& d, Place at) {
  d.texts.erase_if(
      [&](const Text& text) { return text.state == Text::State::waiting && text.start_at && *text.start_at > at; });
}

/// Deletes the data of A.3.4 k.
void delete_all(Description& d) {
  const auto geo = d.geo;
  const bool stop_shunting = d.stop_shunting_on_desk_opening;
  const bool marker = d.generic_ls_marker;
  const std::uint32_t revision = d.revision;
  const std::uint8_t text_id = d.next_text_id;
  d = Description{};
  d.geo = geo;
  d.stop_shunting_on_desk_opening = stop_shunting;
  d.generic_ls_marker = marker;
  d.revision = revision;
  d.next_text_id = text_id;
}

/// The MA ends at `end` from now on; its own end data are deleted.
void end_at(MovementAuthority& ma, Place end) {
  while (ma.sections.size() > 1 && ma.sections.back().begin >= end) ma.sections.pop_back();
  ma.sections.back().end = end;
  if (ma.sections.back().begin > end) ma.sections.back().begin = end;
  ma.V_LOA = {};
  ma.loa_timer = {};
  ma.end_section.reset();
  ma.danger_point.reset();
  ma.overlap.reset();
  ma.fixed_SvL.reset();
  ma.fixed_release = Release{};
}

/// The MA ends at a place that lies on the line, whatever length its sections are given later (3.8.5.2).
void end_on_line(MovementAuthority& ma, Place end) {
  end_at(ma, end);
  ma.fixed_SvL = end;
}

/// The MA ends at the train (A.3.4 e, g-j, l, m): EOA at the estimated, SvL at the max safe front end, without release
/// speed. An end that is nearer stays: a shortening gives no more than there was.
void end_at_train(MovementAuthority& ma, const Here& here) {
  const Place SvL = std::min(ma.far_end(), here.max_safe_front);
  end_at(ma, std::min(ma.end(), here.est_front));
  ma.fixed_SvL = SvL;
  ma.ended_at_train = true;
}

// --- timers of the MA

/// Whether the section counts as timed out: by its timer, or because the train ran back behind the place where the
/// timer was stopped, once it stands still (3.8.4.2.3, 3.8.4.2.4).
bool timed_out(Section& section, const Here& here) {
  if (section.timer.running) {
    if (here.min_safe_front > section.stop) section.timer.running = false;
    return section.timer.expired_at(here.now);
  }
  if (section.timed && here.ran_back && here.min_safe_front < section.stop) section.ran_back_behind_stop = true;
  return section.ran_back_behind_stop && here.standstill;
}

/// Whether the authority already is what the time-out of this section would make of it.
bool ends_before(const MovementAuthority& ma, const Section& section) {
  return ma.fixed_release && ma.fixed_release->kind == ReleaseSpeedChoice::national && ma.far_end() <= section.begin;
}

void run_section_timers(Description& d, const Here& here, Elapsed& elapsed) {
  MovementAuthority& ma = *d.ma;
  if (ma.ended_at_train) return;
  for (std::size_t k = 0; k < ma.sections.size(); ++k) {
    Section& section = ma.sections[k];
    if (!timed_out(section, here) || ends_before(ma, section)) continue;
    // The nearest expired section decides (3.8.4.2.2): its start becomes EOA and SvL, with the national release speed.
    end_at(ma, section.begin);
    ma.fixed_release = Release{ReleaseSpeedChoice::national, {}};
    elapsed.section_timeout = true;
    elapsed.track_description_deleted =
        shorten(d, Situation::c_section_timeout, ma.end(), here) || elapsed.track_description_deleted;
    return;
  }
}

void run_loa_timer(Description& d, const Here& here, Elapsed& elapsed) {
  MovementAuthority& ma = *d.ma;
  if (!ma.limited() || !ma.loa_timer.expired_at(here.now)) return;
  ma.V_LOA = {};
  ma.loa_timer.running = false;
  elapsed.loa_timeout = true;
  elapsed.track_description_deleted =
      shorten(d, Situation::n_loa_became_eoa, ma.far_end(), here) || elapsed.track_description_deleted;
}

void run_overlap_timer(Description& d, const Here& here, Elapsed& elapsed) {
  MovementAuthority& ma = *d.ma;
  if (!ma.overlap) return;
  Timer& timer = ma.overlap->timer;
  if (!timer.running && here.max_safe_front > ma.overlap->start) {
    timer.running = true;
    timer.started = here.now;
  }
  // Standstill after the timer start also ends the overlap, even with an infinite timer
  // (3.8.4.4.3).
  if (!timer.running || !(timer.expired_at(here.now) || here.standstill)) return;
  ma.overlap.reset();
  ma.V_LOA = {};
  // The SvL of a conditional stop in the overlap (3.10.2.2) lies no farther than what holds without it (3.8.4.5.1).
  if (ma.fixed_SvL) ma.fixed_SvL = std::min(*ma.fixed_SvL, ma.danger_point ? ma.danger_point->at : ma.end());
  elapsed.overlap_timeout = true;
  elapsed.track_description_deleted =
      shorten(d, Situation::d_overlap_timeout, ma.far_end(), here) || elapsed.track_description_deleted;
}

void run_end_section_timer(Description& d, const Here& here, Elapsed& elapsed) {
  MovementAuthority& ma = *d.ma;
  if (!ma.end_section) return;
  Timer& timer = ma.end_section->timer;
  if (!timer.running && here.max_safe_front > ma.end_section->start) {
    timer.running = true;
    timer.started = here.now;
  }
  if (!timer.expired_at(here.now)) return;
  elapsed.end_section_timeout = true;
  elapsed.track_description_deleted =
      shorten(d, Situation::e_end_section_timeout, here.max_safe_front, here) || elapsed.track_description_deleted;
}

template <class T>
constexpr bool still_shown(const T&) {
  return false;  // track conditions alone are shown afterwards
}

template <class T, std::size_t N>
void forget_areas(InplaceVector<T, N>& areas, Place limit) {
  const auto over = [&](const T& a) { return a.to < limit && !still_shown(a); };
  for (const T& area : areas)
    if (over(area)) return areas.erase_if(over);
}

void forget_passed(Description& d, const Here& here) {
  const Place limit = here.min_safe_rear - kKeptBehind;
  d.ssp.forget_before(limit);
  d.gradient.forget_before(limit);
  each_list([&](const auto& list) { forget_areas(d.*list.kept, limit); });
  forget_areas(d.tsr, limit);
  d.signalling.erase_if([&](const SignallingSpeed& s) { return s.to && *s.to < limit; });
  forget_areas(d.lx, limit);
  forget_areas(d.adhesion, limit);
  if (d.ma)
    while (d.ma->sections.size() > 1 && d.ma->sections.front().end < limit) d.ma->sections.erase(0);
  // An area is left when the min safe front end passes its end (3.12.4.6).
  const auto left = [&](const ModeArea& area) { return area.to && here.min_safe_front > *area.to; };
  for (const ModeArea& area : d.mode_profile)
    if (left(area)) {
      d.mode_profile.erase_if(left);
      ++d.revision;
      break;
    }
  if (!d.geo.empty()) advance_geographical_position(d, here);
  const auto ended = [](const Text& text) { return text.state == Text::State::ended; };
  for (const Text& text : d.texts)
    if (ended(text)) {
      d.texts.erase_if(ended);
      break;
    }
}

}  // namespace

void end_signalling_speed(Description& d, Place at) {
  d.signalling.erase_if([&](const SignallingSpeed& s) { return s.from >= at; });
  for (SignallingSpeed& s : d.signalling)
    if (!s.to || *s.to > at) s.to = at;
}

bool shorten(Description& d, Situation situation, Place cut, const Here& here, bool shunting) {
  ++d.revision;
  if (situation == Situation::k_desk_closed_during_start) {
    delete_all(d);
    return false;
  }
  const bool at_train = cuts_at_train(situation);
  if (at_train) {
    cut = here.max_safe_front;
    if (d.ma) end_at_train(*d.ma, here);
  }
  const bool deleted = cut_description(d, cut);
  cut_mode_profile(d, cut);
  cut_texts(d, cut);
  if (!at_train || !shunting) d.sh_list.reset();
  return deleted && !without_request(situation);
}

std::uint8_t stop_at(Description& d, Place stop, const Here& here) {
  std::uint8_t answer = 1;
  if (d.ma) {
    MovementAuthority& ma = *d.ma;
    const std::optional<Place> SvL = ma.SvL();
    if (stop <= ma.end()) {
      end_on_line(ma, stop);
      answer = 0;
    } else if (!SvL) {
      end_on_line(ma, ma.end());
      answer = 0;
    } else if (stop <= *SvL) {
      ma.fixed_SvL = stop;
      ma.fixed_release = Release{};
    }
  }
  (void)shorten(d, Situation::a_conditional_emergency_stop, stop, here);
  return answer;
}

bool end_before(Description& d, Place place, const Here& here) {
  if (place <= here.max_safe_front) return shorten(d, Situation::l_rams_supervision, place, here);
  if (d.ma && place < d.ma->far_end()) {
    if (place <= d.ma->end()) {
      end_on_line(*d.ma, place);
    } else {
      d.ma->fixed_SvL = place;
      d.ma->fixed_release = Release{};
    }
  }
  return shorten(d, Situation::b_shortened_ma, place, here);
}

void turn(Description& d) {
  auto texts = d.texts;
  // A text that waits for a place is ahead of the former front end.
  texts.erase_if([](const Text& text) { return text.state == Text::State::waiting && text.start_at; });
  for (Text& text : texts)
    if (text.end_at) text.end_at = Place{-text.end_at->from_origin};
  const std::optional<GroupList> sh_list = d.sh_list;
  delete_all(d);
  d.texts = texts;
  d.sh_list = sh_list;
  d.geo.erase_if([](const GeoReference& reference) { return !reference.applicable; });
  for (GeoReference& reference : d.geo) {
    reference.applies_from = Place{-reference.applies_from->from_origin};
    reference.counts_up_ahead = !reference.counts_up_ahead;
  }
  ++d.revision;
}

Elapsed advance(Description& d, const Here& here) {
  Elapsed elapsed;
  if (d.ma) {
    run_section_timers(d, here, elapsed);
    run_loa_timer(d, here, elapsed);
    run_overlap_timer(d, here, elapsed);
    run_end_section_timer(d, here, elapsed);
  }
  forget_passed(d, here);
  return elapsed;
}

}  // namespace evc::track
