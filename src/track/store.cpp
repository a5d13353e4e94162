#include "track/store.h"

#include "track/withdraw.h"

namespace evc::track {
namespace {

constexpr const char* kIncomplete = "3.7.2.3";

/// Where SSP and gradient have to reach: to the SvL, for an LOA to the LOA.
Place far_end(const MovementAuthority& ma) {
  const std::optional<Place> SvL = ma.SvL();
  return SvL ? *SvL : ma.end();
}

struct Filing {
  Description& d;
  const Contents& c;
  const Here& here;
  Stored& report;

  void note(std::uint8_t packet, Note::What what, const char* clause) const {
    // The report holds one note per packet kind; a full one loses notes, never data.
    if (!report.notes.full()) (void)report.notes.push_back({packet, what, clause});
  }
  void stored(std::uint8_t packet, bool room, const char* clause) const {
    if (room)
      note(packet, Note::What::stored, nullptr);
    else
      note(packet, Note::What::full, clause);
  }
};

/// New data of a non-continuous profile: what starts at or beyond the new start goes, what spans it is cut there
/// (3.7.3.1 c, d, f, g; 3.7.3.2), then the new elements follow. False when not all find room.
template <class T, std::size_t N, std::size_t M>
bool replace(InplaceVector<T, N>& stored, const Fresh<T, M>& fresh) {
  stored.erase_if([&](const T& old) { return old.from >= fresh.from; });
  for (T& old : stored)
    if (old.to > fresh.from) old.to = fresh.from;
  bool room = true;
  for (const T& element : fresh.elements) room = stored.push_back(element) && room;
  return room;
}

// --- movement authority

/// Whether the end-section or overlap timer of the new MA takes over the running one: it does where the new start is
/// already behind the max safe front end; a timer that does not run counts as expired then (3.8.4.1.3-4, 3.8.4.4.4-5).
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

/// A.3.4 situation e on a new MA whose end section counts as timed out.
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

/// The old MA up to the infill reference, then the infill one (3.8.5.1 b, 3.8.5.1.2). False when there is no room.
bool join(MovementAuthority& ma, const MovementAuthority& old, Place infill) {
  MovementAuthority joined = ma;
  joined.sections.clear();
  bool room = true;
  for (Section section : old.sections) {
    if (section.begin >= infill) break;
    if (section.end > infill) section.end = infill;
    room = joined.sections.push_back(section) && room;
  }
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

/// In an area that was accepted, the same area in a new MA asks for no new acknowledgement (5.9.2.7).
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
  bool room = true;
  bool shunting = false;
  for (ModeArea area : *c.mode_profile) {
    area.accepted = accepted_before(old, area, f.here);
    room = d.mode_profile.push_back(area) && room;
    shunting = shunting || area.mode == AreaMode::SH;
  }
  f.stored(80, room, "3.12.4");
  // The list of a stored SH area goes with it and comes with the new one (3.12.4.4).
  if (shunting) d.sh_list = c.sh_list;
}

void refuse_authority(const Filing& f, const char* clause) {
  f.report.ma_refused = true;
  f.note(f.c.V_MAIN ? 12 : 15, Note::What::refused, clause);
  if (f.c.mode_profile) f.note(80, Note::What::refused, clause);
  if (f.c.sh_list) f.note(49, Note::What::refused, clause);
}

void store_authority(const Filing& f, const char* refuse_ma) {
  const Contents& c = f.c;
  Description& d = f.d;
  if (!c.ma || c.ma->sections.empty()) return;
  if (refuse_ma != nullptr) return refuse_authority(f, refuse_ma);
  if (!complete(d, c, f.here)) return refuse_authority(f, kIncomplete);
  MovementAuthority ma = *c.ma;
  if (c.infill && d.ma && !join(ma, *d.ma, *c.infill)) return refuse_authority(f, "capacity");
  carry_timers(ma, d.ma, f.here);
  if (c.ma_is_shortening_request || is_shortening(ma, d.ma)) {
    // The deletion concerns what was stored before this message (3.8.5.1.5 of 4.0.0; silent before).
    f.report.shortened = true;
    f.note(15, Note::What::shortened, c.ma_is_shortening_request ? "3.8.6" : "3.8.5.1.3");
    (void)shorten(d, c.ma_is_shortening_request ? Situation::f_shortening_granted : Situation::b_shortened_ma,
                  far_end(ma), f.here);
  }
  d.ma = ma;
  f.report.ma_accepted = true;
  f.note(ma.level_1 ? 12 : 15, Note::What::stored, nullptr);
  store_mode_profile(f);
  // An MA of level 2/3 ends the signalling related restriction of level 1 (3.11.6.3.1).
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

/// Packet 16: a new length for the section in which the front end is, the following ones move along (3.8.5.2).
void reposition(const Filing& f) {
  if (!f.c.repositioned_section || !f.d.ma) return;
  MovementAuthority& ma = *f.d.ma;
  std::size_t k = 0;
  while (k + 1 < ma.sections.size() && ma.sections[k].end <= f.here.est_front) ++k;
  const Distance shift = f.c.reference + *f.c.repositioned_section - ma.sections[k].end;
  ma.sections[k].end = ma.sections[k].end + shift;
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
  f.note(16, Note::What::stored, nullptr);
}

// --- speed restrictions

void store_tsr(const Filing& f) {
  Description& d = f.d;
  for (const std::uint8_t id : f.c.revoked_tsr) {
    // 255 names every restriction that cannot be revoked (3.11.5.9).
    if (id != 255) d.tsr.erase_if([&](const TemporarySpeedRestriction& t) { return t.NID_TSR == id; });
    f.note(66, Note::What::stored, nullptr);
  }
  if (f.c.inhibit_revocable_tsr) {
    d.revocable_tsr_inhibited = true;
    f.note(64, Note::What::stored, nullptr);
  }
  for (const TemporarySpeedRestriction& tsr : f.c.tsr) {
    if (tsr.NID_TSR != 255 && !tsr.from_rbc && d.revocable_tsr_inhibited) {
      f.note(65, Note::What::refused, "3.11.5.12");
      continue;
    }
    if (tsr.NID_TSR != 255)
      d.tsr.erase_if([&](const TemporarySpeedRestriction& t) { return t.NID_TSR == tsr.NID_TSR; });
    bool room = d.tsr.push_back(tsr);
    if (!room) {
      // No room: the last one grows to cover both at the lower speed, never less than asked.
      TemporarySpeedRestriction& last = d.tsr.back();
      last.NID_TSR = 255;
      last.Q_FRONT = last.Q_FRONT && tsr.Q_FRONT;
      if (tsr.V_TSR < last.V_TSR) last.V_TSR = tsr.V_TSR;
      if (tsr.from < last.from) last.from = tsr.from;
      if (tsr.to > last.to) last.to = tsr.to;
    }
    f.stored(65, room, "3.11.5");
  }
  if (f.c.default_gradient) {
    d.default_gradient = f.c.default_gradient;
    f.note(141, Note::What::stored, nullptr);
  }
}

void store_level_crossings(const Filing& f) {
  Description& d = f.d;
  for (LevelCrossing lx : f.c.lx) {
    for (const LevelCrossing& old : d.lx)
      if (old.NID_LX == lx.NID_LX && old.substituted && lx.unprotected) {
        // Repeated while its speed already holds: it goes on holding.
        lx.substituted = true;
        lx.V_LX_from = old.V_LX_from;
      }
    d.lx.erase_if([&](const LevelCrossing& old) { return old.NID_LX == lx.NID_LX; });
    bool room = d.lx.push_back(lx);
    if (!room && lx.unprotected) {
      // No room: a stop at the nearer of the two, which only an own message can lift.
      LevelCrossing& last = d.lx.back();
      if (lx.from < last.from || !last.unprotected) last = lx;
    }
    f.stored(88, room, "3.12.5");
  }
}

void store_profiles(const Filing& f) {
  const Contents& c = f.c;
  Description& d = f.d;
  if (c.ssp) f.stored(27, d.ssp.replace_from(*c.ssp), "3.7.3.1");
  if (c.gradient) f.stored(21, d.gradient.replace_from(*c.gradient), "3.7.3.1");
  if (c.asp) f.stored(51, replace(d.asp, *c.asp), "3.7.3.1");
  if (c.pbd) f.stored(52, replace(d.pbd, *c.pbd), "3.7.3.1");
  store_tsr(f);
  store_level_crossings(f);
}

// --- conditions, suitability, adhesion

void store_suitability(const Filing& f) {
  if (!f.c.suitability) return;
  Description& d = f.d;
  const Fresh<RouteSuitability>& fresh = *f.c.suitability;
  if (fresh.initial_state) {
    d.suitability.erase_if([&](const RouteSuitability& old) { return old.at >= fresh.from; });
    return f.note(70, Note::What::stored, nullptr);
  }
  // Each kind that the packet names is replaced as a whole, wherever it lies (3.7.3.1 h-j).
  d.suitability.erase_if([&](const RouteSuitability& old) {
    for (const RouteSuitability& item : fresh.elements)
      if (item.kind == old.kind) return true;
    return false;
  });
  bool room = true;
  for (const RouteSuitability& item : fresh.elements) room = d.suitability.push_back(item) && room;
  f.stored(70, room, "3.12.2");
}

void store_adhesion(const Filing& f) {
  if (!f.c.adhesion) return;
  Fresh<AdhesionArea> fresh;
  fresh.from = f.c.adhesion->from;
  // An area that is not slippery only clears (3.7.3.1 l).
  if (f.c.adhesion->slippery) (void)fresh.elements.push_back(*f.c.adhesion);
  f.stored(71, replace(f.d.adhesion, fresh), "3.7.3.1");
}

void store_conditions(const Filing& f) {
  const Contents& c = f.c;
  Description& d = f.d;
  if (c.conditions) f.stored(68, replace(d.conditions, *c.conditions), "3.7.3.1");
  if (c.big_metal) f.stored(67, replace(d.big_metal, *c.big_metal), "3.7.3.1");
  if (c.platforms) f.stored(69, replace(d.platforms, *c.platforms), "3.7.3.1");
  if (c.traction) {
    d.traction = c.traction;
    f.note(39, Note::What::stored, nullptr);
  }
  if (c.current) {
    d.current = c.current;
    f.note(40, Note::What::stored, nullptr);
  }
  store_suitability(f);
  store_adhesion(f);
}

void store_texts(const Filing& f) {
  Description& d = f.d;
  for (Text text : f.c.texts) {
    const std::uint8_t packet = text.Q_TEXT ? 76 : 72;
    bool repeated = false;
    for (const Text& old : d.texts)
      if (text.report && old.report && !old.acknowledged && old.NID_TEXTMESSAGE == text.NID_TEXTMESSAGE)
        repeated = true;
    if (repeated) {
      f.note(packet, Note::What::refused, "3.12.3.5.3");
      continue;
    }
    text.id = d.next_text_id;
    d.next_text_id = d.next_text_id == 255 ? std::uint8_t{1} : static_cast<std::uint8_t>(d.next_text_id + 1);
    f.stored(packet, d.texts.push_back(text), "3.12.3");
  }
}

void store_orders(const Filing& f) {
  const Contents& c = f.c;
  Description& d = f.d;
  if (c.level_order && c.level_order->conditional && d.level_order && !d.level_order->immediate) {
    f.note(46, Note::What::refused, "4.8.3");  // [11]: an announced transition is pending
  } else if (c.level_order) {
    d.level_order = c.level_order;
    f.note(c.level_order->conditional ? 46 : 41, Note::What::stored, nullptr);
  }
  if (c.rbc_transition) {
    d.rbc_transition = c.rbc_transition;
    f.note(131, Note::What::stored, nullptr);
  }
  if (c.radio_infill) {
    d.radio_infill = c.radio_infill;
    f.note(133, Note::What::stored, nullptr);
  }
  if (c.reversing_area) {
    d.reversing_area = c.reversing_area;
    d.reversing_reference = c.reversing_area->to;
    f.note(138, Note::What::stored, nullptr);
  }
  if (c.reversing_supervision) {
    d.reversing_supervision = c.reversing_supervision;
    f.note(139, Note::What::stored, nullptr);
  }
  if (c.sh_list && !c.ma) d.sh_list = c.sh_list;
  if (c.sr_authorisation) d.sr_list = c.sr_list;
  if (c.geo) {
    // What applies already goes on until another becomes applicable (3.6.6.3).
    d.geo.erase_if([&](const GeoReference& old) { return !old.applies_from || *old.applies_from > f.here.est_front; });
    for (const GeoReference& reference : *c.geo)
      if (!d.geo.push_back(reference)) break;
    f.note(79, Note::What::stored, nullptr);
  }
  d.stop_shunting_on_desk_opening = d.stop_shunting_on_desk_opening || c.stop_shunting_on_desk_opening;
  bool limited_supervision = false;
  if (c.mode_profile)
    for (const ModeArea& area : *c.mode_profile) limited_supervision = limited_supervision || area.mode == AreaMode::LS;
  if (c.generic_ls_marker)
    d.generic_ls_marker = true;
  else if (limited_supervision)
    d.generic_ls_marker = false;
}

void store_covers(const Filing& f) {
  Description& d = f.d;
  for (const Contents::CoverOrder& order : f.c.covers) {
    d.covers.erase_if([&](const VirtualBaliseCover& old) {
      return old.NID_VBCMK == order.cover.NID_VBCMK && old.NID_C == order.cover.NID_C;
    });
    f.stored(6, !order.set || d.covers.push_back(order.cover), "3.15.9");
  }
}

bool matters_to_monitoring(const Contents& c) {
  return c.ma || c.V_MAIN || c.mode_profile || c.repositioned_section || c.ssp || c.gradient || c.asp || c.pbd ||
         !c.tsr.empty() || !c.revoked_tsr.empty() || c.default_gradient || !c.lx.empty() || c.conditions ||
         c.suitability || c.adhesion || c.traction || c.reversing_area || c.reversing_supervision;
}

}  // namespace

bool complete(const Description& d, const Contents& c, const Here& here) {
  if (!c.ma || c.ma->sections.empty()) return true;
  const Place from = c.infill ? *c.infill : here.est_front;
  const Place to = far_end(*c.ma);
  const NewStaticSpeedProfile ssp = c.ssp ? *c.ssp : NewStaticSpeedProfile{};
  const NewGradientProfile gradient = c.gradient ? *c.gradient : NewGradientProfile{};
  // What there is no room for would be a hole as well.
  return d.ssp.has_room_for(ssp) && d.gradient.has_room_for(gradient) && covers_together(d.ssp, ssp, from, to) &&
         covers_together(d.gradient, gradient, from, to);
}

bool complete(const Description& d, const Here& here) {
  if (!d.ma) return true;
  const Place to = far_end(*d.ma);
  return d.ssp.covers(here.est_front, to) && d.gradient.covers(here.est_front, to);
}

Stored store(Description& d, const Contents& c, const Here& here, const char* refuse_ma) {
  Stored report;
  const Filing f{d, c, here, report};
  store_authority(f, refuse_ma);
  store_signalling_speed(f);
  reposition(f);
  store_profiles(f);
  store_conditions(f);
  store_texts(f);
  store_orders(f);
  store_covers(f);
  if (matters_to_monitoring(c)) ++d.revision;
  return report;
}

}  // namespace evc::track
