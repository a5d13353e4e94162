#include "track/store.h"

#include "track/store_parts.h"

namespace evc::track {
namespace {

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

bool matters_to_monitoring(const Contents& c) {
  return c.ma || c.V_MAIN || c.mode_profile || c.repositioned_section || c.ssp || c.gradient || c.asp || c.pbd ||
         !c.tsr.empty() || !c.revoked_tsr.empty() || c.default_gradient || !c.lx.empty() || c.conditions ||
         c.suitability || c.adhesion || c.traction || c.reversing_area || c.reversing_supervision;
}

}  // namespace

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
  if (matters_to_monitoring(c)) ++d.revision;
  return report;
}

}  // namespace evc::track
