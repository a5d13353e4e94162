#include "kernel/intake/session_packets.h"

#include "lang/decode.h"
#include "lang/packets/packet_245.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_45.h"
#include "lang/translate.h"
#include "radio/from_packets.h"

namespace evc::kernel {
namespace {

/// NID_MN of X = 1 that stands for FRMCS (6.5.1.5.34.2 of 4.0.0).
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
}

}  // namespace evc::kernel
