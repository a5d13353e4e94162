#include "track/store_parts.h"
#include "track/withdraw.h"

namespace evc::track {
namespace {

constexpr Clause kIncomplete = "3.7.2.3"_srs;

/// Whether the end section or overlap timer of the new MA continues the running one: yes, if its start is already
/// behind the max safe front end; a timer that does not run then counts as expired (3.8.4.1.3-4, 3.8.4.4.4-5).
void carry_timer(Timer& fresh, const Timer* old, Place start, const Here& here, bool& expired) {
  if (start >= here.max_safe_front) return;
  if (old != nullptr && old->running) {
    fresh.running = true;
    fresh.started = old->started;
    expired = fresh.expired_at(here.now);
  } else {
    expired = true;
  }
}

/// A.3.4 situation e for a new MA whose end section timer counts as expired.
void end_at_front(MovementAuthority& ma, const Here& here) {
  while (ma.sections.size() > 1 && ma.sections.back().begin >= here.est_front) ma.sections.pop_back();
  ma.sections.back().end = here.est_front;
  ma.V_LOA = {};
  ma.end_section.reset();
  ma.overlap.reset();
  ma.danger_point.reset();
  ma.fixed_SvL = here.max_safe_front;
  ma.fixed_release = Release{};
}

void carry_timers(MovementAuthority& ma, const std::optional<MovementAuthority>& old, const Here& here) {
  bool end_section_over = false;
  bool overlap_over = false;
  if (ma.end_section)
    carry_timer(ma.end_section->timer, old && old->end_section ? &old->end_section->timer : nullptr,
                ma.end_section->start, here, end_section_over);
  if (ma.overlap)
    carry_timer(ma.overlap->timer, old && old->overlap ? &old->overlap->timer : nullptr, ma.overlap->start, here,
                overlap_over);
  if (overlap_over) {
    ma.overlap.reset();
    ma.V_LOA = {};
  }
  if (end_section_over) end_at_front(ma, here);
}

/// The old MA up to the infill reference, then the infill one (3.8.5.1 b, 3.8.5.1.2): the section at the reference ends
/// there; so does the last section if the old authority ends in rear of it. False when there is no room.
bool join(MovementAuthority& ma, const MovementAuthority& old, Place infill) {
  MovementAuthority joined = ma;
  joined.sections.clear();
  bool room = true;
  for (const Section& section : old.sections)
    if (section.begin < infill) room = joined.sections.push_back(section) && room;
  if (!joined.sections.empty()) joined.sections.back().end = infill;
  for (const Section& section : ma.sections) room = joined.sections.push_back(section) && room;
  if (room) ma = joined;
  return room;
}

/// A new MA is a shortening when its SvL is nearer than the old one, or when it defines an SvL where an LOA was
/// supervised (3.8.5.1.3-4); a new LOA never is.
bool is_shortening(const MovementAuthority& ma, const std::optional<MovementAuthority>& old) {
  const std::optional<Place> SvL = ma.SvL();
  if (!old || !SvL) return false;
  const std::optional<Place> old_SvL = old->SvL();
  return !old_SvL || *SvL < *old_SvL;
}

/// An area that was accepted needs no new acknowledgement in a new MA (5.9.2.7).
bool accepted_before(const ModeProfile& old, const ModeArea& area, const Here& here) {
  if (here.est_front < area.ack_from && here.max_safe_front < area.from) return false;
  for (const ModeArea& o : old)
    if (o.accepted && o.mode == area.mode) return true;
  return false;
}

void store_mode_profile(const Filing& f) {
  const Contents& c = f.c;
  Description& d = f.d;
  const ModeProfile old = d.mode_profile;
  if (c.infill)
    d.mode_profile.erase_if([&](const ModeArea& area) { return area.from >= *c.infill; });
  else
    d.mode_profile.clear();
  if (!c.mode_profile) return;
  bool shunting = false;
  std::optional<Place> lost;
  for (ModeArea area : *c.mode_profile) {
    area.accepted = accepted_before(old, area, f.here);
    if (!d.mode_profile.push_back(area) && !lost) lost = area.from;
    shunting = shunting || area.mode == Mode::SH;
  }
  if (lost)
    f.lost(80, *lost, "3.12.4"_srs);
  else
    f.note(80, Note::What::stored, {});
  // The list of a stored SH area is replaced together with the area (3.12.4.4).
  if (shunting) d.sh_list = c.sh_list;
}

/// Without a clause: no room.
void refuse_authority(const Filing& f, Clause clause) {
  f.report.ma_refused = true;
  f.note(f.c.V_MAIN ? 12 : 15, Note::What::refused, clause);
  if (f.c.mode_profile) f.note(80, Note::What::refused, clause);
  if (f.c.sh_list) f.note(49, Note::What::refused, clause);
}

}  // namespace

bool complete(const Description& d, const Contents& c, const Here& here) {
  if (!c.ma || c.ma->sections.empty()) return true;
  const Place from = c.infill ? *c.infill : here.est_front;
  const Place to = c.ma->far_end();
  const NewStaticSpeedProfile ssp = c.ssp ? *c.ssp : NewStaticSpeedProfile{};
  const NewGradientProfile gradient = c.gradient ? *c.gradient : NewGradientProfile{};
  // Data that do not fit would be a hole as well.
  return d.ssp.has_room_for(ssp) && d.gradient.has_room_for(gradient) && covers_together(d.ssp, ssp, from, to) &&
         covers_together(d.gradient, gradient, from, to);
}

bool complete(const Description& d, const Here& here) {
  if (!d.ma) return true;
  const Place to = d.ma->far_end();
  return d.ssp.covers(here.est_front, to) && d.gradient.covers(here.est_front, to);
}

void store_authority(const Filing& f, Clause refuse_ma) {
  const Contents& c = f.c;
  Description& d = f.d;
  if (!c.ma || c.ma->sections.empty()) return;
  if (refuse_ma) return refuse_authority(f, refuse_ma);
  // Infill extends an authority: without a stored authority it is refused (3.8.5.1 b).
  if (c.infill && !d.ma) return refuse_authority(f, "3.8.5.1"_srs);
  if (!complete(d, c, f.here)) return refuse_authority(f, kIncomplete);
  MovementAuthority ma = *c.ma;
  if (c.infill && !join(ma, *d.ma, *c.infill)) return refuse_authority(f, {});
  carry_timers(ma, d.ma, f.here);
  if (c.ma_is_shortening_request || is_shortening(ma, d.ma)) {
    // The deletion applies to data stored before this message (3.8.5.1.5 of 4.0.0; earlier issues do not say).
    f.report.shortened = true;
    f.note(15, Note::What::shortened, c.ma_is_shortening_request ? "3.8.6"_srs : "3.8.5.1.3"_srs);
    (void)shorten(d, c.ma_is_shortening_request ? Situation::f_shortening_granted : Situation::b_shortened_ma,
                  ma.far_end(), f.here);
  }
  d.ma = ma;
  f.report.ma_accepted = true;
  f.note(ma.level_1 ? 12 : 15, Note::What::stored, {});
  store_mode_profile(f);
  // An MA of level 2/3 deletes the signalling related restriction of level 1 (3.11.6.3.1).
  if (!ma.level_1) d.signalling.reset();
}

void store_signalling_speed(const Filing& f) {
  if (!f.c.V_MAIN) return;
  if (*f.c.V_MAIN == 0) {
    // A trip order, not a speed; in infill it has no effect (3.11.6.2, 3.11.6.5).
    f.report.trip_order = !f.c.infill;
    return;
  }
  f.d.signalling = SignallingSpeed{f.c.infill ? *f.c.infill : f.here.min_safe_rear, *f.c.V_MAIN, std::nullopt};
}

/// Packet 16: a new length for the section in which the front end is, the following ones are moved with it (3.8.5.2).
void reposition(const Filing& f) {
  if (!f.c.repositioned_section || !f.d.ma) return;
  MovementAuthority& ma = *f.d.ma;
  std::size_t k = 0;
  while (k + 1 < ma.sections.size() && ma.sections[k].end <= f.here.est_front) ++k;
  const Distance shift = f.c.reference + *f.c.repositioned_section - ma.sections[k].end;
  ma.sections[k].end = ma.sections[k].end + shift;
  if (ma.sections[k].begin > ma.sections[k].end) ma.sections[k].begin = ma.sections[k].end;
  for (std::size_t i = k + 1; i < ma.sections.size(); ++i) {
    ma.sections[i].begin = ma.sections[i].begin + shift;
    ma.sections[i].end = ma.sections[i].end + shift;
    ma.sections[i].stop = ma.sections[i].stop + shift;
  }
  if (ma.end_section) ma.end_section->start = ma.end_section->start + shift;
  if (ma.danger_point) ma.danger_point->at = ma.danger_point->at + shift;
  if (ma.overlap) {
    ma.overlap->start = ma.overlap->start + shift;
    ma.overlap->end = ma.overlap->end + shift;
  }
  f.note(16, Note::What::stored, {});
}

}  // namespace evc::track
