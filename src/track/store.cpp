#include "track/store.h"

#include "track/areas.h"
#include "track/indication.h"
#include "track/store_parts.h"
#include "track/withdraw.h"

namespace evc::track {
namespace {

/// The kinds that are shown to driver or train.
template <class T>
constexpr bool kShown = requires(const T& element) {
  element.progress;
};

/// A condition that begins where the new data begin, and lies there already, is one with it.
template <std::size_t N>
bool joins(InplaceVector<TrackCondition, N>& stored, const TrackCondition& fresh, Place from) {
  for (TrackCondition& old : stored)
    if (old.to == from && fresh.from == from && old.kind == fresh.kind && old.anchor == fresh.anchor) {
      old.to = fresh.to;
      old.progress = sent_again(old.progress);
      return true;
    }
  return false;
}
template <class T, std::size_t N>
bool joins(InplaceVector<T, N>&, const T&, Place) {
  return false;
}

/// New data of a non-continuous profile: elements that start at or beyond the new start are deleted, one across it is
/// cut there (3.7.3.1 c, d, f, g; 3.7.3.2), then the new elements are appended. Returns the place of the first one for
/// which there is no room.
template <class T, std::size_t N, std::size_t M>
std::optional<Place> replace(InplaceVector<T, N>& stored, const Fresh<T, M>& fresh) {
  [[maybe_unused]] std::array<Progress, M> told{};
  if constexpr (kShown<T>)
    for (std::size_t i = 0; i < fresh.elements.size(); ++i)
      for (const T& old : stored)
        if (same(old, fresh.elements[i])) told[i] = sent_again(old.progress);
  stored.erase_if([&](const T& old) { return old.from >= fresh.from; });
  for (T& old : stored)
    if (old.to > fresh.from) old.to = fresh.from;
  std::optional<Place> lost;
  for (std::size_t i = 0; i < fresh.elements.size(); ++i) {
    const T& element = fresh.elements[i];
    if (joins(stored, element, fresh.from)) continue;
    if (!stored.push_back(element)) {
      if (!lost || element.from < *lost) lost = element.from;
      continue;
    }
    if constexpr (kShown<T>) stored.back().progress = told[i];
  }
  return lost;
}
/// A change at a place replaces the one stored (3.7.3.1 e, p).
template <class Change>
void replace(std::optional<Change>& stored, const Change& fresh) {
  const Progress told = stored && same(*stored, fresh) ? sent_again(stored->progress) : Progress{};
  stored = fresh;
  stored->progress = told;
}
template <class T, std::size_t N, std::size_t M>
void replace(const Filing& f, std::uint8_t packet, InplaceVector<T, N>& stored, const Fresh<T, M>& fresh) {
  if (const std::optional<Place> from = replace(stored, fresh))
    f.lost(packet, *from, "3.7.3.1"_srs);
  else
    f.note(packet, Note::What::stored, {});
}

/// A continuous profile: if it does not fit, it ends at the last step that does.
template <class Value, std::size_t N, std::size_t M>
void replace(const Filing& f, std::uint8_t packet, Profile<Value, N>& stored, const Profile<Value, M>& fresh) {
  if (stored.replace_from(fresh))
    f.note(packet, Note::What::stored, {});
  else
    f.lost(packet, stored.steps.back().from, "3.7.3.1"_srs);
}

/// Data that restrict and do not fit end the authority at their place; other data are only noted.
template <class Lists>
void store_areas(const Filing& f, const Contents& c, const Lists& lists) {
  each_list(lists, [&](const auto& list) {
    const auto& fresh = c.*list.fresh;
    if (!fresh) return;
    if (list.restricts)
      replace(f, list.packet, f.d.*list.kept, *fresh);
    else
      f.stored(list.packet, !replace(f.d.*list.kept, *fresh), "3.7.3.1"_srs);
  });
}

// --- speed restrictions

void store_tsr(const Filing& f, const Contents& c) {
  Description& d = f.d;
  for (const std::uint8_t id : c.revoked_tsr) {
    // 255 is the identity of every restriction that cannot be revoked (3.11.5.9).
    if (id != 255) d.tsr.erase_if([&](const TemporarySpeedRestriction& t) { return t.NID_TSR == id; });
    f.note(66, Note::What::stored, {});
  }
  if (c.inhibit_revocable_tsr) {
    d.revocable_tsr_inhibited = true;
    f.note(64, Note::What::stored, {});
  }
  for (const TemporarySpeedRestriction& tsr : c.tsr) {
    if (tsr.NID_TSR != 255 && !tsr.from_rbc && d.revocable_tsr_inhibited) {
      f.note(65, Note::What::refused, "3.11.5.12"_srs);
      continue;
    }
    if (tsr.NID_TSR != 255)
      d.tsr.erase_if([&](const TemporarySpeedRestriction& t) { return t.NID_TSR == tsr.NID_TSR; });
    const bool room = d.tsr.push_back(tsr);
    if (!room) cover(d.tsr.back(), tsr);
    f.stored(65, room, "3.11.5"_srs);
  }
  if (c.default_gradient) {
    d.default_gradient = c.default_gradient;
    f.note(141, Note::What::stored, {});
  }
}

/// The stop that is asked for now only, of a train in rear of it: the speed that applies already does not replace it.
bool asks_to_stop(const LevelCrossing& fresh, const LevelCrossing& old, const Here& here) {
  return fresh.stop_required && !old.stop_required && here.est_front <= fresh.from;
}

void store_level_crossings(const Filing& f, const Contents& c) {
  Description& d = f.d;
  for (LevelCrossing lx : c.lx) {
    for (const LevelCrossing& old : d.lx)
      if (old.NID_LX == lx.NID_LX && lx.unprotected && f.here.min_safe_front <= old.to) {
        // Received again while its speed already applies: it continues to apply (A.3.5.1). One that was passed is
        // another crossing.
        lx.substituted = old.substituted && !asks_to_stop(lx, old, f.here);
        lx.V_LX_from = old.V_LX_from;
        lx.informed = old.informed;
      }
    d.lx.erase_if([&](const LevelCrossing& old) { return old.NID_LX == lx.NID_LX; });
    const bool room = d.lx.push_back(lx);
    if (!room && lx.unprotected)
      f.lost(88, lx.from, "3.12.5"_srs);
    else
      f.stored(88, room, "3.12.5"_srs);
  }
}

void store_profiles(const Filing& f, const Contents& c) {
  Description& d = f.d;
  if (c.ssp) replace(f, 27, d.ssp, *c.ssp);
  if (c.gradient) replace(f, 21, d.gradient, *c.gradient);
  store_areas(f, c, kSpeedAreas);
  store_tsr(f, c);
  store_level_crossings(f, c);
}

// --- conditions, suitability, adhesion

void store_suitability(const Filing& f, const Contents& c) {
  if (!c.suitability) return;
  Description& d = f.d;
  const Fresh<RouteSuitability>& fresh = *c.suitability;
  if (fresh.initial_state) {
    d.suitability.erase_if([&](const RouteSuitability& old) { return old.at >= fresh.from; });
    return f.note(70, Note::What::stored, {});
  }
  // Each kind in the packet is replaced completely, at all places (3.7.3.1 h-j).
  d.suitability.erase_if([&](const RouteSuitability& old) {
    for (const RouteSuitability& item : fresh.elements)
      if (item.kind == old.kind) return true;
    return false;
  });
  std::optional<Place> lost;
  for (const RouteSuitability& item : fresh.elements)
    if (!d.suitability.push_back(item) && (!lost || item.at < *lost)) lost = item.at;
  if (lost) return f.lost(70, *lost, "3.12.2"_srs);
  f.note(70, Note::What::stored, {});
}

void store_adhesion(const Filing& f, const Contents& c) {
  if (!c.adhesion) return;
  Fresh<AdhesionArea> fresh;
  fresh.from = c.adhesion->from;
  // An area that is not slippery only deletes (3.7.3.1 l).
  if (c.adhesion->slippery) (void)fresh.elements.push_back(*c.adhesion);
  replace(f, 71, f.d.adhesion, fresh);
}

void store_conditions(const Filing& f, const Contents& c) {
  Description& d = f.d;
  d.watch.changed = true;
  store_areas(f, c, kConditionAreas);
  if (c.traction) {
    replace(d.traction, *c.traction);
    f.note(39, Note::What::stored, {});
  }
  if (c.current) {
    replace(d.current, *c.current);
    f.note(40, Note::What::stored, {});
  }
  store_suitability(f, c);
  store_adhesion(f, c);
}

void store_texts(const Filing& f, const Contents& c) {
  Description& d = f.d;
  for (Text text : c.texts) {
    const std::uint8_t packet = text.Q_TEXT ? 76 : 72;
    bool repeated = false;
    for (const Text& old : d.texts)
      if (text.report && old.report && !old.acknowledged && old.NID_TEXTMESSAGE == text.NID_TEXTMESSAGE)
        repeated = true;
    if (repeated) {
      f.note(packet, Note::What::refused, "3.12.3.5.3"_srs);
      continue;
    }
    text.id = d.next_text_id;
    d.next_text_id = d.next_text_id == 255 ? std::uint8_t{1} : static_cast<std::uint8_t>(d.next_text_id + 1);
    f.stored(packet, d.texts.push_back(text), "3.12.3"_srs);
  }
}

bool holds_limited_supervision(const AuthorityContents& c) {
  if (c.mode_profile)
    for (const ModeArea& area : *c.mode_profile)
      if (area.mode == Mode::LS) return true;
  return false;
}

void store_orders(const Filing& f, const Contents& c) {
  Description& d = f.d;
  if (c.rbc_transition) {
    d.rbc_transition = c.rbc_transition;
    f.note(131, Note::What::stored, {});
  }
  if (c.radio_infill) {
    d.radio_infill = c.radio_infill;
    f.note(133, Note::What::stored, {});
  }
  if (c.reversing_area) {
    d.reversing_area = c.reversing_area;
    d.reversing_reference = c.reversing_area->to;
    f.note(138, Note::What::stored, {});
  }
  if (c.reversing_supervision) {
    d.reversing_supervision = c.reversing_supervision;
    f.note(139, Note::What::stored, {});
  }
  if (c.sh_list && !c.ma) d.sh_list = c.sh_list;
  if (c.geo) {
    // A reference that already applies continues until another becomes applicable (3.6.6.3).
    d.geo.erase_if([](const GeoReference& old) { return !old.applicable; });
    bool room = true;
    for (const GeoReference& reference : *c.geo) room = d.geo.push_back(reference) && room;
    f.stored(79, room, "3.6.6"_srs);
  }
  d.stop_shunting_on_desk_opening = d.stop_shunting_on_desk_opening || c.stop_shunting_on_desk_opening;
  if (c.generic_ls_marker)
    d.generic_ls_marker = true;
  else if (holds_limited_supervision(c))
    d.generic_ls_marker = false;
}

bool has_authority(const AuthorityContents& c) { return c.ma && !c.ma->sections.empty(); }

bool matters_to_monitoring(const AuthorityContents& c) { return c.ma || c.V_MAIN || c.mode_profile; }
bool matters_to_monitoring(const Contents& c) {
  bool areas = false;
  each_list([&](const auto& list) { areas = areas || (list.restricts && (c.*list.fresh).has_value()); });
  return areas || matters_to_monitoring(static_cast<const AuthorityContents&>(c)) || c.repositioned_section || c.ssp ||
         c.gradient || !c.tsr.empty() || !c.revoked_tsr.empty() || c.default_gradient || !c.lx.empty() ||
         c.suitability || c.adhesion || c.traction || c.reversing_area || c.reversing_supervision;
}

}  // namespace

Stored store(Description& d, const Contents& c, const Here& here, Clause refuse_ma) {
  Stored report;
  const Filing f{d, here, report};
  for (const std::uint8_t packet : c.lost) f.note(packet, Note::What::full, "3.7.3.1"_srs);
  report.lost_from = c.lost_from;
  store_authority(f, c, c.infill, !has_authority(c) || complete(d, c, *c.ma, here), refuse_ma);
  store_signalling_speed(f, c);
  reposition(f, c);
  store_profiles(f, c);
  store_conditions(f, c);
  store_texts(f, c);
  store_orders(f, c);
  if (report.lost_from) report.track_description_deleted = end_before(d, *report.lost_from, here);
  if (matters_to_monitoring(c)) ++d.revision;
  return report;
}

Stored store(Description& d, const AuthorityContents& c, const Here& here) {
  Stored report;
  const Filing f{d, here, report};
  // All of it replaces what is stored: there is room for it.
  store_authority(f, c, std::nullopt, !has_authority(c) || complete(d, *c.ma, here), {});
  if (matters_to_monitoring(c)) ++d.revision;
  return report;
}

}  // namespace evc::track
