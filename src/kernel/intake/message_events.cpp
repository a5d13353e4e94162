#include "kernel/intake/message_events.h"
#include "kernel/intake/routes.h"
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

}  // namespace

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
