#include "kernel/intake/filter.h"

#include "kernel/here.h"
#include "kernel/intake/authority.h"
#include "kernel/intake/infill.h"
#include "kernel/intake/levels.h"
#include "kernel/intake/lssma.h"
#include "kernel/intake/message_events.h"
#include "kernel/intake/messages.h"
#include "kernel/intake/routes.h"
#include "kernel/intake/session_packets.h"
#include "kernel/intake/shortening.h"
#include "kernel/intake/system_version.h"
#include "lang/decode.h"
#include "lang/packets/packet_131.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_5.h"

namespace evc::kernel {
namespace {

using modes::Acceptance;
using modes::Verdict;

bool accepted(Evaluation& e, std::size_t i) { return judge_packet(e, i).verdict == Verdict::accepted; }

// --- Level transition orders first (4.8.1.3)

bool names_level_1(const modes::LevelTable& table) {
  for (const modes::OrderedLevel& entry : table)
    if (entry.level == Level::L1) return true;
  return false;
}

void evaluate_level_orders(Evaluation& e) {
  e.level_order.reset();
  bool along = false;
  for (std::size_t i = 0; i < e.information.packets.size(); ++i)
    along = along || e.information.packets[i].NID_PACKET == packet::level_transition_order;
  e.context.level_order_along_or_announced = along || (ordered_level(e.r) && !executes_order(e.r));
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    if (route_of(view).turn != Turn::level_order || !judged(e, i)) continue;
    const auto order = order_of(view, e.r.state.srs);
    if (!order) continue;
    e.context.order = order->kind;
    e.context.unlinked_with_level_1 = e.information.marked_unlinked && names_level_1(order->table);
    const Verdict verdict = judge_packet(e, i).verdict;
    if (verdict != Verdict::accepted && verdict != Verdict::order_stored) continue;
    const modes::OrderDecision decision = give_order(e.r, *order);
    if (order->kind == modes::OrderKind::announcement || decision.effect == modes::OrderEffect::execute)
      e.level_order = i;
    const std::optional<modes::OrderedLevel> to = ordered_level(e.r);
    e.context.announced = to ? std::optional(to->level) : std::nullopt;
    // In SH the order that comes with "danger for shunting" is kept (4.4.8.1.5); what counts is that it came.
    e.context.immediate_order_to_1_2_3 = (decision.effect == modes::OrderEffect::execute ||
                                          decision.effect == modes::OrderEffect::keep_until_mode_left) &&
                                         level_1_2_3(decision.to.level);
  }
}

// --- Linking before other location data (4.8.1.6)

void evaluate_linking(Evaluation& e, bool infill) {
  State& s = e.r.state;
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    if (route_of(view).turn != Turn::linking || !judged(e, i)) continue;
    lang::Packet5 p;
    if (!accepted(e, i) || lang::decode(view, p) != lang::Fault::none) continue;
    balise::LinkingReference reference;
    reference.id = e.reference.origin();
    reference.place = e.reference.place;
    reference.NID_C = e.information.group.NID_C;
    reference.orientation_known = e.information.orientation != Direction::unknown;
    reference.infill = infill;
    std::optional<balise::CurrentLrbg> current;
    if (const position::Reference* lrbg = position::lrbg(s.position))
      current = balise::CurrentLrbg{lrbg->id, lrbg->place};
    const balise::Stored stored = balise::store(s.balise.linking, balise::linking_list(p), reference,
                                                position::antenna(s.position, L_antenna(s)), current);
    // The list holds the LRBG: its distance by linking is used, for all data of the message (3.6.4.3).
    e.reference.place = stored.reference;
    e.brought.linking = true;
    if (!stored.complete) e.r.log.note({.what = What::linking_capacity});
  }
}

// --- Everything else

/// 4.8.3 [14]: the RBC of packet 42 is that of an RBC transition order, stored or in this message.
bool names_rbc_of_transition(const Evaluation& e, const lang::Packet42& p) {
  const State& s = e.r.state;
  radio::Rbc named{p.NID_C.raw, p.NID_RBC.raw, 0};
  if (named.NID_RBC == radio::kLastKnownRbc && s.radio.contact) named = *s.radio.contact;
  const std::optional<track::RbcTransition>& stored = s.track.rbc_transition;
  if (stored && named.same_id({stored->NID_C, stored->NID_RBC})) return true;
  for (const lang::PacketView& view : e.information.packets) {
    lang::Packet131 order;
    if (view.NID_PACKET == packet::rbc_transition_order && lang::decode(view, order) == lang::Fault::none &&
        named.same_id({order.NID_C.raw, order.NID_RBC.raw}))
      return true;
  }
  return false;
}

/// Of orders to call or to change the RBC.
void add_order_facts(Evaluation& e, const lang::PacketView& view) {
  if (view.NID_PACKET == packet::session_management) {
    lang::Packet42 p;
    const bool read = lang::decode(view, p) == lang::Fault::none;
    e.context.orders_establishment = read && p.Q_RBC.raw == 1;
    e.context.names_rbc_of_transition = e.context.orders_establishment && names_rbc_of_transition(e, p);
  } else if (view.NID_PACKET == packet::rbc_transition_order) {
    lang::Packet131 p;
    e.context.null_distance = lang::decode(view, p) == lang::Fault::none && p.D_RBCTR.raw == 0;
  }
}

/// The facts of the packet itself for the exceptions of the tables.
void add_facts(Evaluation& e, const lang::PacketView& view) {
  add_order_facts(e, view);
  add_facts_of_stores(e.context, e.r.state, view);
  e.context.network_missing = e.context.srs == SrsVersion::v4_0_0 && calls_without_network(e, view);
}

void evaluate_rest(Evaluation& e) {
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    const PacketRoute& route = route_of(view);
    if (route.turn != Turn::rest || !judged(e, i)) continue;
    add_facts(e, view);
    if (route.number == packet::lssma_display) e.context.front_in_ls_area_of_message = front_in_LS_area(e);
    const Verdict verdict = judge_packet(e, i).verdict;
    if (route.take != nullptr && (verdict == Verdict::accepted || verdict == Verdict::only_contact_stored))
      route.take(e, view, verdict);
  }
}

/// The information of the radio message itself, without its packets.
void evaluate_message(Evaluation& e) {
  const lang::MessageToTrainView& message = *e.information.message;
  if (!e.information.judge_message) return;
  if (message.NID_MESSAGE == message::request_to_shorten_ma)
    e.context.described_over_whole_ma = proposal_is_described(e);
  const std::optional<evc::Information> row = row_of_message(message.NID_MESSAGE);
  if (!row) return;
  const Acceptance a = modes::accept(*row, e.context);
  if (a.verdict == Verdict::buffered) e.waiting.message = true;
  if (a.verdict == Verdict::rejected) refuse(e, a.clause);
  Acceptance of_packets = a;
  if (a.verdict == Verdict::accepted)
    if (const Clause clause = take_message(e, message)) {
      refuse(e, clause);
      of_packets = {Verdict::rejected, clause};
    }
  tell_belonging(e, of_packets);
}

void evaluate_part(Evaluation& e) {
  evaluate_level_orders(e);
  if (!e.contents.infill) determine_version(e);
  evaluate_linking(e, e.contents.infill.has_value());
  // The order is judged first (4.8.1.3); its border is a location, placed after linking (4.8.1.6).
  if (e.level_order) place_border(e.r, e.information.packets[*e.level_order], e.reference, anchor_of(e));
  evaluate_rest(e);
  evaluate_authority(e);
}

/// Linking names the place of the group, that of the same message too.
std::optional<Place> place_by_linking(const State& s, GroupId group) {
  std::optional<Place> place;
  for (const balise::Link& link : s.balise.linking.links)
    if (link.id == group) place = link.place;
  return place;
}

/// The row of packet 136 counts for all that follows it: infill waits for level 1 as a whole, and where the linking
/// that names its group waits with it, the group is looked for then.
Acceptance accept_infill(const Evaluation& e, const std::optional<Place>& place) {
  const Acceptance a = modes::accept_by_level(evc::Information::infill_location_reference, e.context);
  return a.verdict == Verdict::accepted && !place ? Acceptance{Verdict::rejected, "3.6.2.3.1"_srs} : a;
}

/// Packet 136 of each telegram; a system version is not ordered by infill (3.17.2.5).
void tell_accepted_infill(Evaluation& e) {
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const auto number = e.information.packets[i].NID_PACKET;
    const bool version = number == packet::system_version_order;
    if (judged(e, i) && (version || number == packet::infill_location_reference))
      e.r.log.note({.what = version ? What::packet_not_used : What::packet_accepted, .id = number});
  }
}

/// An infill part, after the rest of the message (4.8.1.5).
void evaluate_infill(Evaluation& e, const Infill& infill) {
  e.judge = e.information.judge_packets & infill.packets;
  if (e.judge == 0) return;
  const std::optional<Place> place = place_by_linking(e.r.state, infill.group);
  const Acceptance a = accept_infill(e, place);
  if (a.verdict == Verdict::rejected)
    e.r.log.note({.what = What::infill_refused, .id = infill.group.NID_BG, .clause = a.clause});
  if (a.verdict != Verdict::accepted) return tell_infill(e, a);
  tell_accepted_infill(e);
  e.context.infill = true;
  e.reference.place = *place;
  e.reference.infill = infill.group;
  track::begin(e.contents, e.reference, e.information.time, *place);
  evaluate_part(e);
  store_contents(e);
}

/// 4.4.19.1.4.8: a profile that waited comes with the marker of its message, which counted at once (4.8.3).
void keep_LS_marker(Evaluation& e) {
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const bool before = ((e.information.judge_packets >> i) & 1u) == 0;
    if (before && e.information.packets[i].NID_PACKET == packet::generic_ls_marker) e.contents.generic_ls_marker = true;
  }
}

/// Why a message that names no place cannot give one.
Clause clause_of_reference(Medium medium) { return medium == Medium::loop ? "3.6.2.3.1"_srs : "3.6.2.2.2"_srs; }

}  // namespace

Acceptance judge_packet(Evaluation& e, std::size_t i) {
  const lang::PacketView& view = e.information.packets[i];
  const PacketRoute& route = route_of(view);
  Acceptance worst{Verdict::accepted, {}};
  InformationRows rows = rows_of(route, view);
  if (authorises_manoeuvre(e.information) && view.NID_PACKET == packet::level_2_3_movement_authority)
    rows[0] = evc::Information::movement_authority_sm;
  for (const evc::Information row : rows) {
    const Acceptance a = modes::accept(row, e.context);
    if (a.verdict != Verdict::accepted) worst = a;
  }
  const bool no_reference = !e.information.located && !e.contents.infill;
  if (no_reference && has_place(route, view)) worst = {Verdict::rejected, clause_of_reference(e.information.medium)};
  tell_packet(e, view.NID_PACKET, worst, passed_over(e.information, view));
  if (worst.verdict == Verdict::buffered) e.waiting.packets |= std::uint64_t{1} << i;
  return worst;
}

Waiting evaluate(Reception& r, const Information& information) {
  const track::Reference reference{
      information.reference, information.orientation, information.group, information.medium, r.state.now, {}};
  Evaluation e{r, information, context_of(r, information), r.scratch.contents, reference, 0, {}, {}, 0, {}};
  track::begin(e.contents, e.reference, information.time);
  const Infills infills = find_infills(information);
  e.judge = information.judge_packets;
  tell_evaluated_before(e);
  keep_LS_marker(e);
  for (const Infill& infill : infills) e.judge &= ~infill.packets;
  evaluate_part(e);
  if (information.message != nullptr) evaluate_message(e);
  store_contents(e);
  for (const Infill& infill : infills) evaluate_infill(e, infill);
  if (information.message != nullptr) tell_message(e);
  return e.waiting;
}

}  // namespace evc::kernel
