#include <algorithm>

#include "base/set.h"
#include "track/store_parts.h"
#include "track/withdraw.h"

namespace evc::track {
namespace {

constexpr Clause kIncomplete = "3.7.2.3"_srs;

/// The end section or overlap timer of the new MA continues the running one if its start is already behind the max safe
/// front end; where none runs then, it has run out (3.8.4.1.3-4, 3.8.4.4.4-5). What follows from that (A.3.4) is done
/// with all timers, after the data of the message are stored (advance).
void carry_timer(Timer& fresh, const std::optional<Timer>& old, Place start, const Here& here) {
  if (start >= here.max_safe_front) return;
  if (!old || !old->running) return fresh.run_out(here.now);
  fresh.running = true;
  fresh.started = old->started;
}

/// What of the MA before counts for the new one.
struct Before {
  bool existed = false;
  std::optional<Timer> end_section, overlap;
  std::optional<Place> SvL;
};
Before before_of(const std::optional<MovementAuthority>& old) {
  Before before;
  if (!old) return before;
  before.existed = true;
  if (old->end_section) before.end_section = old->end_section->timer;
  if (old->overlap) before.overlap = old->overlap->timer;
  before.SvL = old->SvL();
  return before;
}

void carry_timers(MovementAuthority& ma, const Before& old, const Here& here) {
  if (ma.end_section) carry_timer(ma.end_section->timer, old.end_section, ma.end_section->start, here);
  if (ma.overlap) carry_timer(ma.overlap->timer, old.overlap, ma.overlap->start, here);
}

/// The group at a signal lies at or in rear of the end that the signal is (3.8.3.7): it seems to lie in advance of it
/// by the accuracy of a location and the resolution of a length at most.
constexpr Distance kSignalGap{22.0};

/// Whether the stored MA authorises the way to the infill reference (3.8.5.1 b). One that was shortened, timed out or
/// given anew in rear of it does not.
bool reaches(const MovementAuthority& ma, Place infill) {
  return !(ma.fixed_SvL && *ma.fixed_SvL < infill) && infill <= ma.far_end() + kSignalGap;
}

/// The old MA up to the infill reference, then the infill one (3.8.5.1 b, 3.8.5.1.2): the section that runs there ends
/// at the reference, and so does the last one when the old authority ends in rear of it. False when there is no room:
/// the old one stays.
bool join(MovementAuthority& stored, const MovementAuthority& ma, Place infill) {
  auto sections = stored.sections;
  sections.erase_if([&](const Section& section) { return section.begin >= infill; });
  if (!sections.empty()) sections.back().end = infill;
  for (const Section& section : ma.sections)
    if (!sections.push_back(section)) return false;
  stored = ma;
  stored.sections = sections;
  return true;
}

/// A new MA is a shortening when its SvL is nearer than the old one, or when it defines an SvL where an LOA was
/// supervised (3.8.5.1.3-4); a new LOA never is.
bool is_shortening(const MovementAuthority& ma, const Before& old) {
  const std::optional<Place> SvL = ma.SvL();
  return old.existed && SvL && (!old.SvL || *SvL < *old.SvL);
}

/// Of the areas of a profile that is replaced: the modes that were entered for one, and those asked for ahead of one.
struct Answered {
  Set<Mode> accepted, asked;
  InplaceVector<ModeArea, 32>
      entered;  ///< those of whose mode the train was inside them: their window is over (A.3.5.1)
};
Answered answered(const ModeProfile& profile) {
  Answered out;
  for (const ModeArea& area : profile) {
    out.accepted.add(area.mode, area.accepted);
    out.asked.add(area.mode, area.asked);
    if (area.accepted && area.ack_from >= area.from) (void)out.entered.push_back(area);  // as many
  }
  return out;
}

/// The area repeats one that was entered: it begins no farther on.
bool repeats_entered(const Answered& before, const ModeArea& area) {
  return std::any_of(before.entered.begin(), before.entered.end(),
                     [&](const ModeArea& entered) { return entered.mode == area.mode && area.from <= entered.from; });
}

/// An area that was accepted needs no new acknowledgement in a new MA (5.9.2.7), and a request is not taken back
/// (5.7.3.3); an area that begins further on is another one. What was entered stays so ahead of its begin too, to which
/// a correction of the position or rolling back has taken the train (A.3.5.1).
void carry(const Answered& before, ModeArea& area, const Here& here) {
  if (repeats_entered(before, area)) {
    area.accepted = true;
    area.ack_from = area.from;
    return;
  }
  const bool further_on = here.est_front < area.ack_from && here.max_safe_front < area.from;
  area.accepted = !further_on && before.accepted.has(area.mode);
  area.asked = !further_on && before.asked.has(area.mode);
}

bool has_shunting(const ModeProfile& profile) {
  for (const ModeArea& area : profile)
    if (area.mode == Mode::SH) return true;
  return false;
}

/// 3.12.4.3.1: whether the profile of an infill MA is used; the one stored then ends at the infill reference.
bool end_mode_profile(ModeProfile& profile, Place infill) {
  for (const ModeArea& area : profile)
    if (area.mode == Mode::SH && area.from < infill) return false;
  profile.erase_if([&](const ModeArea& area) { return area.from >= infill; });
  for (ModeArea& area : profile)
    if (!area.to || *area.to > infill) area.to = infill;
  return true;
}

void store_mode_profile(const Filing& f, const AuthorityContents& c, const std::optional<Place>& infill) {
  Description& d = f.d;
  const Answered before = answered(d.mode_profile);
  if (!infill) {
    d.mode_profile.clear();
  } else if (!end_mode_profile(d.mode_profile, *infill)) {
    if (c.mode_profile) f.note(80, Note::What::refused, "3.12.4.3.1"_srs);
    return;
  }
  // The list of a stored SH area is deleted and replaced together with the area (3.12.4.4).
  if (!has_shunting(d.mode_profile)) d.sh_list.reset();
  if (!c.mode_profile) return;
  if (has_shunting(*c.mode_profile)) d.sh_list = c.sh_list;
  std::optional<Place> lost;
  for (ModeArea area : *c.mode_profile) {
    carry(before, area, f.here);
    if (!d.mode_profile.push_back(area) && !lost) lost = area.from;
  }
  if (lost)
    f.lost(80, *lost, "3.12.4"_srs);
  else
    f.note(80, Note::What::stored, {});
}

/// Without a clause: no room.
void refuse_authority(const Filing& f, const AuthorityContents& c, Clause clause) {
  f.report.ma_refused = true;
  f.report.ma_refused_by = clause;
  f.note(c.V_MAIN ? 12 : 15, Note::What::refused, clause);
  if (c.mode_profile) f.note(80, Note::What::refused, clause);
  if (c.sh_list) f.note(49, Note::What::refused, clause);
}

}  // namespace

bool complete(const Description& d, const Contents& c, const MovementAuthority& ma, const Here& here) {
  const Place from = c.infill ? *c.infill : here.est_front;
  const Place to = ma.far_end();
  const auto covered = [&](const auto& stored, const auto& fresh) {
    // Data that do not fit would be a hole as well.
    return fresh ? stored.has_room_for(*fresh) && covers_together(stored, *fresh, from, to) : stored.covers(from, to);
  };
  return covered(d.ssp, c.ssp) && covered(d.gradient, c.gradient);
}

bool complete(const Description& d, const MovementAuthority& ma, const Here& here) {
  const Place to = ma.far_end();
  return d.ssp.covers(here.est_front, to) && d.gradient.covers(here.est_front, to);
}

bool complete(const Description& d, const Here& here) { return !d.ma || complete(d, *d.ma, here); }

std::optional<Place> undescribed_from(const Description& d, const Here& here) {
  if (!d.ma || d.ma->sections.empty()) return std::nullopt;
  std::optional<Place> from = d.ssp.unknown_from(here.est_front);
  const std::optional<Place> gradient = d.gradient.unknown_from(here.est_front);
  if (gradient && (!from || *gradient < *from)) from = gradient;
  if (from && *from >= d.ma->far_end()) from.reset();
  return from;
}

void carry_acceptance(ModeProfile& fresh, const Description& stored, const Here& here) {
  const Answered before = answered(stored.mode_profile);
  for (ModeArea& area : fresh) carry(before, area, here);
}

bool forget_acceptance_ahead(ModeProfile& profile, Mode mode, const Here& here) {
  bool forgotten = false;
  for (ModeArea& area : profile) {
    if (!area.accepted || area.mode == mode || here.max_safe_front >= area.from) continue;
    area.accepted = false;
    forgotten = true;
  }
  return forgotten;
}

void forget_acceptance_ahead(Description& d, Mode mode, const Here& here) {
  if (forget_acceptance_ahead(d.mode_profile, mode, here)) ++d.revision;
}

void store_authority(const Filing& f, const AuthorityContents& c, const std::optional<Place>& infill, bool described,
                     Clause refuse_ma) {
  Description& d = f.d;
  if (!c.ma || c.ma->sections.empty()) return;
  if (refuse_ma) return refuse_authority(f, c, refuse_ma);
  // Infill extends an authority: without a stored authority it is refused (3.8.5.1 b).
  if (infill && !d.ma) return refuse_authority(f, c, "3.8.5.1"_srs);
  if (infill && !reaches(*d.ma, *infill)) return refuse_authority(f, c, "3.8.5.1"_srs);
  if (!described) return refuse_authority(f, c, kIncomplete);
  const Before before = before_of(d.ma);
  if (!infill)
    d.ma = c.ma;
  else if (!join(*d.ma, *c.ma, *infill))
    return refuse_authority(f, c, {});
  MovementAuthority& ma = *d.ma;
  carry_timers(ma, before, f.here);
  if (c.ma_is_shortening_request || is_shortening(ma, before)) {
    // The deletion applies to data stored before this message (3.8.5.1.5 of 4.0.0; earlier issues do not say).
    f.report.shortened = true;
    f.note(15, Note::What::shortened, c.ma_is_shortening_request ? "3.8.6"_srs : "3.8.5.1.3"_srs);
    (void)shorten(d, c.ma_is_shortening_request ? Situation::f_shortening_granted : Situation::b_shortened_ma,
                  ma.far_end(), f.here);
  }
  f.report.ma_accepted = true;
  f.note(ma.level_1 ? 12 : 15, Note::What::stored, {});
  store_mode_profile(f, c, infill);
  // An MA of level 2/3 deletes the signalling related restriction of level 1 (3.11.6.3.1).
  if (!ma.level_1) d.signalling.clear();
}

void store_signalling_speed(const Filing& f, const Contents& c) {
  if (!c.V_MAIN) return;
  if (*c.V_MAIN == 0) {
    // A trip order, not a speed; in infill it has no effect (3.11.6.2, 3.11.6.5).
    f.report.trip_order = !c.infill;
    return;
  }
  if (!c.infill) {
    f.d.signalling.clear();  // the new one counts from now on (3.11.6.2, 3.11.6.3)
    // It counts after a reverse movement too, as far behind the train as other restrictions are kept (A.3.6.2).
    (void)f.d.signalling.push_back({f.here.min_safe_rear - kKeptBehind, *c.V_MAIN, std::nullopt});
    return;
  }
  // Those in rear of the infill location reference go on up to it (3.8.5.1 b, 3.11.6.2).
  end_signalling_speed(f.d, *c.infill);
  if (!f.d.signalling.push_back({*c.infill, *c.V_MAIN, std::nullopt})) f.lost(12, *c.infill, "3.11.6.2"_srs);
}

namespace {

/// The end data of an MA move with the section in rear of them.
void shift_end(MovementAuthority& ma, Distance shift) {
  if (ma.end_section) ma.end_section->start = ma.end_section->start + shift;
  if (ma.danger_point) ma.danger_point->at = ma.danger_point->at + shift;
  if (ma.overlap) {
    ma.overlap->start = ma.overlap->start + shift;
    ma.overlap->end = ma.overlap->end + shift;
  }
}

/// A place set by a shortening lies on the line and does not move. The authority does not go beyond it again before a
/// new one arrives, and its SvL is no farther than overlap, danger point or end section give it now (3.8.4.5.1).
void keep_shortened(MovementAuthority& ma) {
  if (!ma.fixed_SvL) return;
  const Place limit = *ma.fixed_SvL;
  while (ma.sections.size() > 1 && ma.sections.back().begin >= limit) ma.sections.pop_back();
  Section& last = ma.sections.back();
  last.end = std::min(last.end, limit);
  last.begin = std::min(last.begin, last.end);
  ma.fixed_SvL.reset();
  ma.fixed_SvL = std::min(limit, ma.SvL_without_LOA());
}

}  // namespace

/// Packet 16: a new length for the section in which the front end is, the following ones are moved with it (3.8.5.2).
/// In advance of all sections there is none to be updated (3.8.5.2.2). It is meant for the authority that was announced
/// with the group, not for one that comes with it (3.8.5.2.3).
void reposition(const Filing& f, const Contents& c) {
  if (!c.repositioned_section || !f.d.ma) return;
  if (c.ma) return f.note(16, Note::What::refused, "3.8.5.2.3"_srs);
  MovementAuthority& ma = *f.d.ma;
  if (ma.end() <= f.here.est_front) return f.note(16, Note::What::refused, "3.8.5.2.2"_srs);
  std::size_t k = 0;
  while (ma.sections[k].end <= f.here.est_front) ++k;
  const Distance shift = c.reference + *c.repositioned_section - ma.sections[k].end;
  ma.sections[k].end = ma.sections[k].end + shift;
  if (ma.sections[k].begin > ma.sections[k].end) ma.sections[k].begin = ma.sections[k].end;
  for (std::size_t i = k + 1; i < ma.sections.size(); ++i) {
    ma.sections[i].begin = ma.sections[i].begin + shift;
    ma.sections[i].end = ma.sections[i].end + shift;
    ma.sections[i].stop = ma.sections[i].stop + shift;
  }
  shift_end(ma, shift);
  keep_shortened(ma);
  f.note(16, Note::What::stored, {});
}

}  // namespace evc::track
