#include "kernel/intake/session_packets.h"

#include "lang/decode.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_45.h"
#include "radio/from_packets.h"

namespace evc::kernel {

void take_session_order(Evaluation& e, const lang::PacketView& view, modes::Verdict verdict) {
  State& s = e.r.state;
  lang::Packet42 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  radio::SessionOrder order = radio::session_order_of(p);
  const bool supervising = e.information.sender == SessionRole::supervising;
  // An RBC that ends "the last known" session means its own: in a handover the stored contact may be the other one.
  if (e.information.medium == Medium::rbc && !order.establish && order.rbc.NID_RBC == radio::kLastKnownRbc)
    order.rbc = (supervising ? s.radio.supervising : s.radio.other).session.rbc;
  bool store_only = verdict == modes::Verdict::only_contact_stored;
  if (order.establish && !store_only && !s.network.registered) {
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

/// 3.5.6.5: another network is stored; the registration is ordered with the sessions of this cycle.
void take_network(Evaluation& e, const lang::PacketView& view, modes::Verdict) {
  lang::Packet45 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  RadioNetwork& network = e.r.state.network;
  if (network.NID_MN == p.NID_MN.raw || p.NID_MN.raw >= port::kDefaultNetwork) return;
  network.NID_MN = p.NID_MN.raw;
  network.changed = true;
  network.by_driver = false;
}

}  // namespace evc::kernel
