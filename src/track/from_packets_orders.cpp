#include "lang/decode.h"
#include "lang/packets/packet_131.h"
#include "lang/packets/packet_132.h"
#include "lang/packets/packet_133.h"
#include "lang/packets/packet_135.h"
#include "lang/packets/packet_137.h"
#include "lang/packets/packet_138.h"
#include "lang/packets/packet_139.h"
#include "lang/packets/packet_181.h"
#include "lang/packets/packet_49.h"
#include "lang/packets/packet_63.h"
#include "lang/packets/packet_79.h"
#include "lang/packets/packet_90.h"
#include "lang/si.h"
#include "terms/packet_numbers.h"
#include "track/from_packets_parts.h"
#include "track/services.h"

namespace evc::track {
namespace {

using lang::Fault;
using lang::metres;

/// Lists of balise groups: "same country" means that of the group before; for the first one, that of the sender.
template <class List>
GroupList groups_of(const List& list, const Reference& r) {
  GroupList groups;
  std::uint16_t NID_C = r.group.NID_C;
  for (const auto& g : list) {
    if (g.Q_NEWCOUNTRY.raw == 1) NID_C = g.NID_C.raw;
    (void)groups.push_back({NID_C, g.NID_BG.raw});
  }
  return groups;
}
void take(AuthorityContents& c, const lang::Packet49& p, const Reference& r) { c.sh_list = groups_of(p.groups, r); }

void take(Contents& c, const lang::Packet79& p, const Reference& r) {
  InplaceVector<GeoReference, 32>& geo = c.geo.emplace();
  std::uint16_t NID_C = r.group.NID_C;
  const auto append = [&](const lang::Packet79_references& e) {
    if (e.Q_NEWCOUNTRY.raw == 1) NID_C = e.NID_C.raw;
    GeoReference reference;
    reference.group = {NID_C, e.NID_BG.raw};
    reference.D_POSOFF = metres(p.Q_SCALE, e.D_POSOFF);
    reference.counts_up = e.Q_MPOSITION.raw == 1;
    if (e.M_POSITION.raw <= lang::var::M_POSITION::max) reference.M_POSITION = e.M_POSITION.raw;
    if (reference.group == r.origin()) place(reference, r.place, r.orientation);
    (void)geo.push_back(reference);
  };
  append(p.first_references());
  for (const auto& e : p.references) append(e);
}

void take(Contents& c, const lang::Packet90& p, const Reference& r) {
  c.track_ahead_free_to = GroupId{p.Q_NEWCOUNTRY.raw == 1 ? p.NID_C.raw : r.group.NID_C, p.NID_BG.raw};
}
void take(Contents& c, const lang::Packet131& p, const Reference& r) {
  c.rbc_transition = RbcTransition{r.place + metres(p.Q_SCALE, p.D_RBCTR), p.NID_C.raw, p.NID_RBC.raw, p.NID_RADIO.raw,
                                   p.Q_SLEEPSESSION.raw == 1};
}
void take(Contents& c, const lang::Packet132& p, const Reference&) { c.danger_for_shunting = p.Q_ASPECT.raw == 0; }
void take(Contents& c, const lang::Packet133& p, const Reference& r) {
  RadioInfillArea area;
  area.at = r.place + metres(p.Q_SCALE, p.D_INFILL);
  area.establish = p.Q_RIU.raw == 1;
  area.NID_C = p.NID_C_RIU.raw;
  area.NID_RIU = p.NID_RIU.raw;
  area.NID_RADIO = p.NID_RADIO.raw;
  area.next_main_signal = {p.NID_C.raw, p.NID_BG.raw};
  c.radio_infill = area;
}
void take(Contents& c, const lang::Packet135&, const Reference&) { c.stop_shunting_on_desk_opening = true; }
void take(Contents& c, const lang::Packet137& p, const Reference&) { c.stop_if_in_sr = p.Q_SRSTOP.raw == 0; }
void take(Contents& c, const lang::Packet138& p, const Reference& r) {
  const Place from = r.place + metres(p.Q_SCALE, p.D_STARTREVERSE);
  c.reversing_area = ReversingArea{from, from + metres(p.Q_SCALE, p.L_REVERSEAREA)};
}
void take(Contents& c, const lang::Packet139& p, const Reference&) {
  c.reversing_supervision = ReversingSupervision{metres(p.Q_SCALE, p.D_REVERSE), p.V_REVERSE.raw};
}
void take(Contents& c, const lang::Packet181&, const Reference&) { c.generic_ls_marker = true; }

template <class P, class C>
Added take_order(C& c, const lang::PacketView& view, const Reference& r) {
  P packet;
  if (lang::decode(view, packet) != Fault::none) return Added::faulty;
  take(c, packet, r);
  return Added::added;
}

}  // namespace

Added add_sh_list(AuthorityContents& contents, const lang::PacketView& view, const Reference& reference) {
  return take_order<lang::Packet49>(contents, view, reference);
}

std::optional<GroupList> sr_list(const lang::PacketView& view, const Reference& reference) {
  lang::Packet63 p;
  if (!valid_direction(view.Q_DIR, reference.orientation) || lang::decode(view, p) != Fault::none) return std::nullopt;
  return groups_of(p.groups, reference);
}

Added add_order(Contents& contents, const lang::PacketView& view, const Reference& reference) {
  switch (view.NID_PACKET) {
    case packet::geographical_position:
      return take_order<lang::Packet79>(contents, view, reference);
    case packet::track_ahead_free_to_level_2_3:
      return take_order<lang::Packet90>(contents, view, reference);
    case packet::rbc_transition_order:
      return take_order<lang::Packet131>(contents, view, reference);
    case packet::danger_for_shunting:
      return take_order<lang::Packet132>(contents, view, reference);
    case packet::radio_infill_area:
      return take_order<lang::Packet133>(contents, view, reference);
    case packet::stop_shunting_on_desk_opening:
      return take_order<lang::Packet135>(contents, view, reference);
    case packet::stop_if_in_sr:
      return take_order<lang::Packet137>(contents, view, reference);
    case packet::reversing_area:
      return take_order<lang::Packet138>(contents, view, reference);
    case packet::reversing_supervision:
      return take_order<lang::Packet139>(contents, view, reference);
    case packet::generic_ls_marker:
      return take_order<lang::Packet181>(contents, view, reference);
    default:
      return Added::not_stored_here;
  }
}

}  // namespace evc::track
