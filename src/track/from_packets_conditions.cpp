#include "lang/decode.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_40.h"
#include "lang/packets/packet_67.h"
#include "lang/packets/packet_68.h"
#include "lang/packets/packet_69.h"
#include "lang/packets/packet_70.h"
#include "lang/packets/packet_71.h"
#include "lang/packets/packet_72.h"
#include "lang/packets/packet_76.h"
#include "lang/si.h"
#include "terms/packet_numbers.h"
#include "track/from_packets_parts.h"

namespace evc::track {
namespace {

using lang::Fault;
using lang::metres;

/// Profiles of areas: increments from start to start, each with its length (3.6.3.2.4).
template <class T, class P, class E, class List, class Make>
void take_areas(Fresh<T>& fresh, const P& p, const E& first, const List& further, Place reference, Make make) {
  Place at = reference;
  const auto append = [&](const E& e) {
    at = at + metres(p.Q_SCALE, e.D_TRACKCOND);
    T element = make(e);
    element.from = at;
    element.to = at + metres(p.Q_SCALE, e.L_TRACKCOND);
    (void)fresh.elements.push_back(element);  // one and 31 further ones fit
  };
  append(first);
  fresh.from = at;
  for (const E& e : further) append(e);
}
template <class T, class P>
void take_initial_state(Fresh<T>& fresh, const P& p, Place reference) {
  fresh.initial_state = true;
  fresh.from = reference + metres(p.Q_SCALE, p.D_TRACKINIT);
}

void take(Contents& c, const lang::Packet68& p, const Reference& r) {
  Fresh<TrackCondition>& fresh = c.conditions.emplace();
  if (p.Q_TRACKINIT.raw == 1) return take_initial_state(fresh, p, r.place);
  take_areas(fresh, p, p.first_conditions(), p.conditions, r.place, [](const auto& e) {
    TrackCondition condition;
    // A spare code cannot occur here: the message was rejected (chapter 7). The same applies to Q_SUITABILITY.
    condition.kind = track_condition_of(e.M_TRACKCOND.raw).value_or(TrackConditionKind::non_stopping_area);
    return condition;
  });
}
void take(Contents& c, const lang::Packet67& p, const Reference& r) {
  take_areas(c.big_metal.emplace(), p, p.first_areas(), p.areas, r.place, [](const auto&) { return BigMetalMass{}; });
}
void take(Contents& c, const lang::Packet69& p, const Reference& r) {
  Fresh<Platform>& fresh = c.platforms.emplace();
  if (p.Q_TRACKINIT.raw == 1) return take_initial_state(fresh, p, r.place);
  take_areas(fresh, p, p.first_platforms(), p.platforms, r.place, [](const auto& e) {
    Platform platform;
    platform.M_PLATFORM = e.M_PLATFORM.raw;
    platform.Q_PLATFORM = e.Q_PLATFORM.raw;
    return platform;
  });
}
void take(Contents& c, const lang::Packet39& p, const Reference& r) {
  c.traction = TractionChange{r.place + metres(p.Q_SCALE, p.D_TRACTION), p.M_VOLTAGE.raw, p.NID_CTRACTION.raw};
}
void take(Contents& c, const lang::Packet40& p, const Reference& r) {
  CurrentChange change{r.place + metres(p.Q_SCALE, p.D_CURRENT), std::nullopt};
  if (p.M_CURRENT.raw <= lang::var::M_CURRENT::max) change.amperes = static_cast<std::uint16_t>(p.M_CURRENT.raw * 10u);
  c.current = change;
}

void take(Contents& c, const lang::Packet70_v3_0& p, const Reference& r) {
  Fresh<RouteSuitability>& fresh = c.suitability.emplace();
  if (p.Q_TRACKINIT.raw == 1) return take_initial_state(fresh, p, r.place);
  Place at = r.place;
  const auto append = [&](const lang::Packet70_v3_0_points& e) {
    at = at + metres(p.Q_SCALE, e.D_SUITABILITY);
    RouteSuitability item;
    item.at = at;
    item.kind = suitability_of(e.Q_SUITABILITY.raw).value_or(Suitability::gauge);
    item.M_LINEGAUGE = e.M_LINEGAUGE.raw;
    item.M_LINEAXLELOADCAT = e.M_LINEAXLELOADCAT.raw;
    item.M_VOLTAGE = e.M_VOLTAGE.raw;
    item.NID_CTRACTION = e.NID_CTRACTION.raw;
    (void)fresh.elements.push_back(item);
  };
  append(p.first_points());
  fresh.from = at;
  for (const auto& e : p.points) append(e);
}

void take(Contents& c, const lang::Packet71& p, const Reference& r) {
  AdhesionArea area;
  area.from = r.place + metres(p.Q_SCALE, p.D_ADHESION);
  area.to = area.from + metres(p.Q_SCALE, p.L_ADHESION);
  area.slippery = p.M_ADHESION.raw == 0;
  c.adhesion = area;
}

/// The mode that limits the display of a text; absent: the display is not limited by the mode (7.5.1.73).
std::optional<Mode> mode_limit(std::uint8_t M_MODETEXTDISPLAY) {
  constexpr std::uint8_t kNotLimited = 15;
  if (M_MODETEXTDISPLAY == kNotLimited) return std::nullopt;
  if (M_MODETEXTDISPLAY == 3) return Mode::AD;  // from 2.2 on, before spare
  if (M_MODETEXTDISPLAY == 5) return Mode::SM;  // from 2.3 on
  return mode_of(M_MODETEXTDISPLAY);
}

/// What packets 72 and 76 share (3.12.3.2-4).
template <class P>
Text text_of(const P& p, const Reference& r) {
  Text t;
  t.Q_TEXTCLASS = p.Q_TEXTCLASS.raw;
  t.all_parts = p.Q_TEXTDISPLAY.raw == 1;
  if (const std::optional<Distance> d = metres(p.Q_SCALE, p.D_TEXTDISPLAY)) t.start_at = r.place + *d;
  t.start_mode = mode_limit(p.M_MODETEXTDISPLAY_START.raw);
  t.start_level = level_of(p.M_LEVELTEXTDISPLAY_START.raw);
  t.start_NTC = p.NID_NTC_START.raw;
  // The length is measured from the start place; without one, from the reference.
  if (const std::optional<Distance> l = metres(p.Q_SCALE, p.L_TEXTDISPLAY))
    t.end_at = (t.start_at ? *t.start_at : r.place) + *l;
  t.T_TEXTDISPLAY = lang::seconds(p.T_TEXTDISPLAY);
  t.end_mode = mode_limit(p.M_MODETEXTDISPLAY_END.raw);
  t.end_level = level_of(p.M_LEVELTEXTDISPLAY_END.raw);
  t.end_NTC = p.NID_NTC_END.raw;
  t.Q_TEXTCONFIRM = p.Q_TEXTCONFIRM.raw;
  if (t.Q_TEXTCONFIRM != 0) {
    t.ack_and_end = p.Q_CONFTEXTDISPLAY.raw == 1;
    t.report = p.Q_TEXTREPORT.raw == 1;
    t.NID_TEXTMESSAGE = p.NID_TEXTMESSAGE.raw;
    t.NID_C = p.NID_C.raw;
    t.NID_RBC = p.NID_RBC.raw;
  }
  return t;
}
void take(Contents& c, const lang::Packet72& p, const Reference& r) {
  Text t = text_of(p, r);
  for (const auto& x : p.text) {
    t.characters[t.length] = static_cast<char>(x.X_TEXT.raw);
    ++t.length;
  }
  if (!c.texts.push_back(t)) c.lose(packet::plain_text);
}
void take(Contents& c, const lang::Packet76& p, const Reference& r) {
  Text t = text_of(p, r);
  t.Q_TEXT = p.Q_TEXT.raw;
  if (!c.texts.push_back(t)) c.lose(packet::fixed_text);
}

template <class P>
Added take_condition(Contents& c, const lang::PacketView& view, const Reference& r) {
  P packet;
  if (const Fault fault = lang::decode(view, packet); fault != Fault::none)
    return fault == Fault::not_applicable ? Added::not_stored_here : Added::faulty;
  take(c, packet, r);
  return Added::added;
}

}  // namespace

Added add_condition(Contents& contents, const lang::PacketView& view, const Reference& reference) {
  switch (view.NID_PACKET) {
    case packet::traction_system_change:
      return take_condition<lang::Packet39>(contents, view, reference);
    case packet::permitted_current_change:
      return take_condition<lang::Packet40>(contents, view, reference);
    case packet::big_metal_masses:
      return take_condition<lang::Packet67>(contents, view, reference);
    case packet::track_condition:
      return take_condition<lang::Packet68>(contents, view, reference);
    case packet::station_platforms:
      return take_condition<lang::Packet69>(contents, view, reference);
    case packet::route_suitability:
      return take_condition<lang::Packet70_v3_0>(contents, view, reference);
    case packet::adhesion_factor:
      return take_condition<lang::Packet71>(contents, view, reference);
    case packet::plain_text:
      return take_condition<lang::Packet72>(contents, view, reference);
    case packet::fixed_text:
      return take_condition<lang::Packet76>(contents, view, reference);
    default:
      return Added::not_stored_here;
  }
}

}  // namespace evc::track
