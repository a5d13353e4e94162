#include "kernel/intake/message_events.h"
#include "kernel/intake/routes.h"
#include "lang/decode.h"
#include "lang/packets/packet_140.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_70.h"
#include "terms/message_numbers.h"

namespace evc::kernel {
namespace {

using modes::Acceptance;
using modes::Verdict;

What what_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::buffered:
      return What::packet_buffered;
    case Verdict::order_stored:
      return What::packet_kept;
    case Verdict::rejected:
      return What::packet_refused;
    case Verdict::only_contact_stored:
      return What::packet_contact_stored;
    case Verdict::accepted:
      break;
  }
  return What::packet_accepted;
}

bool evaluated_before(int NID_PACKET) {
  return NID_PACKET == packet::inhibition_of_consistency_reaction || NID_PACKET == packet::virtual_balise_cover_marker;
}

void wait_if_buffered(Evaluation& e, std::size_t i, const Acceptance& a) {
  if (a.verdict == Verdict::buffered) e.waiting.packets |= std::uint64_t{1} << i;
}

template <class P>
bool is_not_applicable(const lang::PacketView& view) {
  P p;
  return lang::decode(view, p) == lang::Fault::not_applicable;
}
/// The set to which packet 203 is appended (6.6.3.2.3 [16]).
bool has_packet_3_of_version_1(const Information& information) {
  for (const lang::PacketView& view : information.packets)
    if (view.NID_PACKET == packet::national_values && view.sv.x == 1) return true;
  return false;
}
/// 6.6.3.2.3 [10], [12], [13].
bool is_without_translation(const lang::PacketView& view) {
  const auto number = view.NID_PACKET;
  return (number == packet::traction_system_change && is_not_applicable<lang::Packet39>(view)) ||
         (number == packet::route_suitability && is_not_applicable<lang::Packet70_v3_0>(view)) ||
         (number == packet::train_running_number_from_rbc && is_not_applicable<lang::Packet140>(view));
}

}  // namespace

std::optional<Clause> passed_over(const Information& information, const lang::PacketView& view) {
  const PacketRoute& route = route_of(view);
  if (route.turn == Turn::rest && route.take == nullptr)
    return view.NID_PACKET == packet::fixed_text ? "6.6.3.1.1.1"_srs : "3.17.3.11"_srs;
  const bool alone = view.NID_PACKET == packet::national_values_v1 && !has_packet_3_of_version_1(information);
  if (alone || (view.sv.x == 1 && is_without_translation(view))) return "6.6.3.2.3"_srs;
  return std::nullopt;
}

void tell_packet(Evaluation& e, int NID_PACKET, const Acceptance& a, const std::optional<Clause>& passed_over) {
  const bool not_used = passed_over && a.verdict == Verdict::accepted;
  e.r.log.note({.what = not_used ? What::packet_not_used : what_of(a.verdict),
                .id = NID_PACKET,
                .clause = not_used ? *passed_over : a.clause});
  if (a.verdict == Verdict::rejected) refuse(e, a.clause);
}

void tell_belonging(Evaluation& e, const Acceptance& a) {
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    const Turn turn = route_of(view).turn;
    const bool of_proposal = turn == Turn::authority && e.information.message != nullptr &&
                             e.information.message->NID_MESSAGE == message::request_to_shorten_ma;
    if (!judged(e, i) || (turn != Turn::with_authority && !of_proposal)) continue;
    e.r.log.note({.what = what_of(a.verdict), .id = view.NID_PACKET, .clause = a.clause});
    wait_if_buffered(e, i, a);
  }
}

void tell_evaluated_before(Evaluation& e) {
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const auto number = e.information.packets[i].NID_PACKET;
    if (!judged(e, i) || !evaluated_before(number)) continue;
    // Of a cover that is stored the telegram would not have come here.
    const bool cover = number == packet::virtual_balise_cover_marker;
    e.r.log.note({.what = cover ? What::packet_not_used : What::packet_accepted, .id = number});
  }
}

void tell_infill(Evaluation& e, const Acceptance& a) {
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const auto number = e.information.packets[i].NID_PACKET;
    if (!judged(e, i) || evaluated_before(number)) continue;
    tell_packet(e, number, a, std::nullopt);
    wait_if_buffered(e, i, a);
  }
}

void tell_message(Evaluation& e) {
  const bool refused = e.refused != 0;
  e.r.log.note({.what = refused && e.refused_because ? What::message_refused
                        : refused                    ? What::message_refused_no_room
                        : e.waiting.any()            ? What::message_buffered
                                                     : What::message_accepted,
                .id = e.information.message->NID_MESSAGE,
                .clause = refused ? e.refused_because : Clause{}});
}

}  // namespace evc::kernel
