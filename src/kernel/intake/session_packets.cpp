#include "kernel/intake/session_packets.h"

#include "lang/decode.h"
#include "lang/packets/packet_133.h"
#include "lang/packets/packet_143.h"
#include "lang/packets/packet_245.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_45.h"
#include "lang/translate.h"
#include "radio/from_packets.h"
#include "terms/packet_numbers.h"

namespace evc::kernel {
namespace {

/// NID_MN of X = 1 that stands for FRMCS (6.6.3.2.3 [23] of 4.0.0).
bool names_frmcs(const lang::PacketView& view, const lang::Packet45_v3_0& p, SrsVersion srs) {
  constexpr std::uint32_t kFrmcs = 0x901999;
  return srs == SrsVersion::v4_0_0 && view.sv.x == 1 && p.NID_MN.raw == kFrmcs;
}
/// 6.6.3.2.3 [23].
bool expects_level_2(const State& s) {
  if (!s.level_table) return level_2_or_3(s.level.level);
  for (const modes::OrderedLevel& entry : *s.level_table)
    if (level_2_or_3(entry.level)) return true;
  return false;
}

/// 4.8.3 [15] of 4.0.0, of a unit with GSM-R: an order for a network in this message names another one than that of the
/// terminals, or FRMCS.
bool network_missing(const Evaluation& e) {
  const RadioNetwork& own = e.r.state.network;
  for (const lang::PacketView& view : e.information.packets) {
    lang::Packet45_v3_0 order;
    lang::Packet245 type;
    if (view.NID_PACKET == packet::radio_network_type && lang::decode(view, type) == lang::Fault::none &&
        type.Q_NETWORKTYPE.raw == lang::kFrmcs_only)
      return true;
    if (view.NID_PACKET != packet::radio_network_registration || lang::decode(view, order) != lang::Fault::none)
      continue;
    // [23] of 6.6.3.2.3: FRMCS beside the GSM-R network stored, or FRMCS alone
    const bool frmcs_of_version_1 = names_frmcs(view, order, e.r.state.srs);
    if (frmcs_of_version_1 && !expects_level_2(e.r.state)) return true;
    const bool same = frmcs_of_version_1 || own.NID_MN == order.NID_MN.raw;
    const bool of_terminals = own.registered && !own.changed && same;
    if (order.Q_NETWORKTYPE.raw == lang::kFrmcs_only || !of_terminals) return true;
  }
  return false;
}

/// Whether the packet orders to establish a session; of packet 42 the context says so already.
bool calls(const Evaluation& e, const lang::PacketView& view) {
  lang::Packet133 area;
  lang::Packet143 neighbour;
  switch (view.NID_PACKET) {
    case packet::session_management:
      return e.context.orders_establishment;
    case packet::rbc_transition_order:
      return true;
    case packet::radio_infill_area:
      return lang::decode(view, area) == lang::Fault::none && area.Q_RIU.raw == 1;
    case packet::session_management_riu:
      return lang::decode(view, neighbour) == lang::Fault::none && neighbour.Q_RIU.raw == 1;
    default:
      return false;
  }
}

}  // namespace

void take_session_order(Evaluation& e, const lang::PacketView& view, modes::Verdict verdict) {
  State& s = e.r.state;
  lang::Packet42 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  radio::SessionOrder order = radio::session_order_of(p);
  const bool supervising = e.information.sender == SessionRole::supervising;
  // An RBC that ends "the last known" session means its own: in a handover the stored contact may be the other one.
  if (e.information.medium == Medium::rbc && !order.establish && order.rbc.NID_RBC == radio::kLastKnownRbc)
    order.rbc = (supervising ? s.radio.supervising : s.radio.other).session.rbc;
  if (order.establish && order.rbc.NID_RADIO == radio::kNoNumber && order.rbc.NID_RBC != radio::kLastKnownRbc) {
    e.r.log.note({.what = What::network_missing, .clause = "3.5.6.7"_srs});
    return;
  }
  bool store_only = verdict == modes::Verdict::only_contact_stored;
  if (order.establish && !store_only && !callable(s.network)) {
    store_only = true;
    e.r.log.note({.what = What::network_missing, .clause = "3.5.6.7"_srs});
  }
  if (radio::order(s.radio, order, s.mode == Mode::SL, store_only, s.now, e.r.outbox)) {
    if (order.establish) s.contact_status = DataStatus::valid;
    e.r.log.note(
        {.what = order.establish ? What::session_ordered : What::session_termination_ordered, .clause = "3.5.3.5"_srs});
  }
  if (!order.establish && supervising) e.r.out.termination_ordered = true;
}

void take_network_type(Evaluation& e, const lang::PacketView& view, modes::Verdict) {
  lang::Packet245 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  // Types 1 and 2 come with packet 45, and GSM-R is used then in either case.
  if (p.Q_NETWORKTYPE.raw == lang::kFrmcs_only) e.r.state.network.frmcs_only = true;
}

/// 3.5.6.5: another network is stored; the registration is ordered with the sessions of this cycle.
void take_network(Evaluation& e, const lang::PacketView& view, modes::Verdict) {
  lang::Packet45_v3_0 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  RadioNetwork& network = e.r.state.network;
  if (names_frmcs(view, p, e.r.state.srs)) {
    network.frmcs_only = !expects_level_2(e.r.state);  // [23]: with level 2 the GSM-R network stays the one stored
    return;
  }
  network.frmcs_only = p.Q_NETWORKTYPE.raw == lang::kFrmcs_only;
  if (network.frmcs_only) return;
  if (network.NID_MN == p.NID_MN.raw || p.NID_MN.raw >= port::kDefaultNetwork) return;
  network.NID_MN = p.NID_MN.raw;
  network.changed = true;
  network.by_driver = false;
}

bool calls_without_network(const Evaluation& e, const lang::PacketView& view) {
  return calls(e, view) && network_missing(e);
}

}  // namespace evc::kernel
